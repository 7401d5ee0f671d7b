//! A series together with a factor that a fault of the measurement puts on the loss alone: e^{p(ln ω)}, p a polynomial of low degree.
//!
//! No passive solid has such a factor beside its series, so data that are followed significantly better with it than without break Kramers and Kronig's
//! relations. Few numbers describe it: a scale, a slope over the measured range, and two more for a shift along the frequency.

use super::best::best_fit;
use super::observation::Quantity;
use super::sample::{Place, Sample};
use super::series::{Ends, Series};
use crate::fit::{Descent, descended};

/// Steps of a common descent.
const STEPS: usize = 60;
/// How often the number of terms is found anew.
const AGAIN: usize = 2;

/// A series with the coefficients of its factor, on its way.
struct Moving<'a> {
    series: Series,
    coefficients: Vec<f64>,
    sample: &'a Sample,
    scaled: Sample,
    span: [f64; 2],
    window: [f64; 2],
}

/// Legendre's polynomials of the place of ln ω in the measured range.
fn shape(degree: usize, span: [f64; 2], at: f64) -> f64 {
    let x = if span[1] > span[0] { (2.0 * at.ln() - span[0] - span[1]) / (span[1] - span[0]) } else { 0.0 };
    match degree {
        0 => 1.0,
        1 => x,
        2 => 1.5 * x * x - 0.5,
        _ => (2.5 * x * x - 1.5) * x,
    }
}

fn factor(coefficients: &[f64], span: [f64; 2], place: &Place) -> f64 {
    if place.quantity != Quantity::Loss {
        return 1.0;
    }
    coefficients.iter().enumerate().map(|(degree, coefficient)| coefficient * shape(degree, span, place.at)).sum::<f64>().exp()
}

impl Descent for Moving<'_> {
    fn residuals(&self) -> Vec<f64> {
        self.series.residuals(&self.scaled)
    }

    fn rest(&self) -> f64 {
        self.sample.rest
    }

    fn jacobian(&self) -> Vec<Vec<f64>> {
        let mut columns: Vec<Vec<f64>> = (0..self.coefficients.len())
            .map(|degree| {
                let values = self.scaled.places.iter().map(|place| {
                    let of_loss = if place.quantity == Quantity::Loss { shape(degree, self.span, place.at) } else { 0.0 };
                    of_loss * self.series.value(place.quantity, place.at)
                });
                self.scaled.rows(values.collect())
            })
            .collect();
        columns.extend(self.series.columns(&self.scaled, self.window));
        columns
    }

    fn moved(&self, step: &[f64]) -> Self {
        let (own, rest) = step.split_at(self.coefficients.len().min(step.len()));
        let coefficients: Vec<f64> = self.coefficients.iter().zip(own).map(|(one, step)| one + step.clamp(-1.0, 1.0)).collect();
        let scaled = self.sample.weighted(|place| factor(&coefficients, self.span, place));
        Self { series: self.series.moved(rest, self.window), coefficients, scaled, ..*self }
    }
}

/// A fit with a factor on the loss.
#[derive(Debug, Clone)]
pub(super) struct Distorted {
    pub(super) series: Series,
    /// The sum of squares.
    pub(super) misfit: f64,
    /// The smallest and the largest value of the factor.
    pub(super) range: [f64; 2],
}

/// The best fit with a factor of so many coefficients on the loss.
pub(super) fn distorted(start: &Series, coefficients: usize, sample: &Sample, window: [f64; 2]) -> Distorted {
    let ends = sample.places.iter().fold([f64::INFINITY, 0.0_f64], |[low, high], place| [low.min(place.at), high.max(place.at)]);
    let span = ends.map(f64::ln);
    let scaled = |coefficients: &[f64]| sample.weighted(|place| factor(coefficients, span, place));
    let of = |series: Series, coefficients: Vec<f64>| {
        let end = descended(Moving { series, scaled: scaled(&coefficients), coefficients, sample, span, window }, STEPS);
        let misfit = end.series.misfit(&end.scaled);
        (misfit, end.series, end.coefficients)
    };
    let mut best = of(start.clone(), vec![0.0; coefficients]);
    for _ in 0..AGAIN {
        // The number of terms and their places follow the factor.
        let again = of(best_fit(&scaled(&best.2), window, Ends { constant: true, flow: false }), best.2.clone());
        if again.0 < best.0 {
            best = again;
        }
    }
    let (misfit, mut series, coefficients) = best;
    series.terms.sort_by(|left, right| left.1.total_cmp(&right.1));
    let of_loss = sample.places.iter().filter(|place| place.quantity == Quantity::Loss);
    let factors = of_loss.map(|place| factor(&coefficients, span, place));
    let range = factors.fold([f64::INFINITY, 0.0_f64], |[low, high], factor| [low.min(factor), high.max(factor)]);
    Distorted { series, misfit, range }
}
