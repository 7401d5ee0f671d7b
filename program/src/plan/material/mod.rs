//! A material by itself: its numbers, curves, plots, and the file that scenes include; and what a scene's plan says of its material.

mod effects;
mod figures;
mod file;
mod reach;
mod screen;
mod shifts;
mod tables;

pub use file::material_file;
pub use screen::{screen, summary};
pub use tables::tables;

use crate::outcome::plot::Figure;
use crate::scene::typed::{MaterialOrigin, MeasuredSort, SceneMaterial, Units};
use viscotack::estimate::Estimate;
use viscotack::material::fit::Quantity;

pub(super) use effects::{effects, validity};
pub(super) use reach::widened;

/// A material to report on.
#[derive(Debug, Clone)]
pub struct MaterialReport {
    /// The material, at its temperature.
    pub material: SceneMaterial,
    /// What its numbers are measured in.
    pub units: Units,
    /// What it is called.
    pub title: String,
}

/// Points a decade of the curves.
const PER_DECADE: f64 = 20.0;
/// Most points of a curve.
const MOST_POINTS: f64 = 2000.0;

impl MaterialReport {
    /// Frequencies at the reference temperature per frequency at the temperature: a_T.
    fn factor(&self) -> f64 {
        self.material.climate.as_ref().map_or(1.0, |climate| climate.factor)
    }

    /// The angular frequencies that curves are drawn over: those of the data or of the expansion and a decade beyond, or of the terms.
    fn frequencies(&self) -> Vec<f64> {
        let [low, high] = match &self.material.origin {
            MaterialOrigin::Data(fitted) => {
                let frequency = |at: f64| if fitted.data.sort == MeasuredSort::Moduli { at } else { 1.0 / at };
                let ends = fitted.data.rows.iter().map(|row| frequency(row.at));
                let [low, high] = ends.fold([f64::INFINITY, 0.0_f64], |[low, high], at| [low.min(at), high.max(at)]);
                [0.1 * low / self.factor(), 10.0 * high / self.factor()]
            }
            MaterialOrigin::Law(law) => law.range.map(|end| end / self.factor()),
            MaterialOrigin::Terms | MaterialOrigin::Deck(_) => {
                let series = &self.material.series;
                let longest = series.longest_retardation_time().or(series.longest_relaxation_time()).unwrap_or(1.0);
                let shortest = series.relaxation_terms().last().map_or(longest, |term| term.relaxation_time);
                [0.01 / longest, 100.0 / shortest]
            }
        };
        let decades = (high / low).log10();
        let steps = (decades * PER_DECADE).ceil().clamp(1.0, MOST_POINTS);
        (0..=steps as usize).map(|index| low * 10f64.powf(decades * index as f64 / steps)).collect()
    }

    /// Times over the same range.
    fn times(&self) -> Vec<f64> {
        self.frequencies().into_iter().rev().map(|frequency| 1.0 / frequency).collect()
    }

    /// A curve's value with what is known of its error: of a fit the scatter of the data, of a law the accuracy of its expansion.
    fn value(&self, quantity: Quantity, at: f64) -> Option<Estimate> {
        let series = &self.material.series;
        let modulus = || series.complex_modulus(at).ok();
        let (value, scale) = match quantity {
            Quantity::Storage => modulus().map(|modulus| (modulus.storage, modulus.magnitude()))?,
            Quantity::Loss => modulus().map(|modulus| (modulus.loss, modulus.magnitude()))?,
            Quantity::Relaxation => (series.relaxation(at), series.relaxation(at)),
            Quantity::Creep => (series.creep(at), series.creep(at)),
        };
        let by_frequency = matches!(quantity, Quantity::Storage | Quantity::Loss);
        let error = match &self.material.origin {
            MaterialOrigin::Data(fitted) => {
                let reduced = if by_frequency { at * self.factor() } else { at / self.factor() };
                fitted.fit.band.error(quantity, reduced)
            }
            MaterialOrigin::Law(law) => law.expansion.error * scale,
            MaterialOrigin::Terms | MaterialOrigin::Deck(_) => (8.0 * f64::EPSILON + series.modulus_rounding()) * scale,
        };
        value.is_finite().then(|| Estimate::new(value, if error.is_finite() { error } else { value.abs().max(scale) }))
    }

    /// Plots, by file stem.
    #[must_use]
    pub fn figures(&self) -> Vec<(String, Figure)> {
        figures::figures(self)
    }

    /// Whether a wanted error was reached.
    #[must_use]
    pub fn met(&self) -> bool {
        match &self.material.origin {
            MaterialOrigin::Data(fitted) => fitted.fit.met,
            MaterialOrigin::Law(law) => law.expansion.met,
            MaterialOrigin::Terms | MaterialOrigin::Deck(_) => true,
        }
    }
}
