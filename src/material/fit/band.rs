//! How well data fix a curve: from the covariance of the fitted numbers, for every number of terms that the data leave possible.
//!
//! The number of terms is found from the data, too. Each candidate weighs e^{−(criterion − lowest)/2} with Akaike's criterion (Buckland, Burnham and Augustin,
//! 1997, *Biometrics* 53, 603), and
//! ```text
//! error² = 4 Σ_m w_m (variance_m + (curve_m − curve)²)
//! ```

use super::choose::{Candidate, material};
use super::joint::{self, Free};
use super::observation::{Observation, Quantity};
use super::sample::Sample;
use crate::fit::least_squares::matrix;
use crate::special::normal::Normal;

use crate::material::Material;
use faer::Mat;

/// Errors of curves that a fitted series gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The chosen series first; weights sum to 1.
    models: Vec<Model>,
    free: Free,
    window: [f64; 2],
    creep: bool,
    /// Where draws are held to what the linearised fit says of them.
    places: Vec<(Quantity, f64)>,
}

/// One series that may be the right one.
#[derive(Debug, Clone, PartialEq)]
struct Model {
    weight: f64,
    candidate: Candidate,
    /// Inverse triangular factor of the scaled derivatives by shifts and numbers, times the scatter: its rows' lengths are standard deviations.
    spread: Option<Mat<f64>>,
    /// The material, and after a small step of each number: how the other series follows.
    material: Option<Material>,
    stepped: Vec<Option<Material>>,
}

/// Standard deviations of the stated error: 95 of 100 for a normal error.
const DEVIATIONS: f64 = 2.0;
/// Places a decade at which draws are held to the linearised fit, and steps that they take.
const PER_DECADE: f64 = 8.0;
const DRAW_STEPS: usize = 15;
/// Step of a logarithm for derivatives of the other series.
const STEP: f64 = 1e-5;
/// Lighter candidates are left out.
const LEAST_WEIGHT: f64 = 1e-3;
/// A logarithm that the data leave free has this standard deviation: a number of the series, a shift.
const OPEN: [f64; 2] = [1.0, 10.0];

impl Band {
    pub(super) fn new(chosen: Candidate, candidates: Vec<Candidate>, sample: &Sample, free: Free, window: [f64; 2]) -> Self {
        // Schwarz's criterion with Akaike's price of a number.
        let price = 2.0 - (sample.count as f64).ln();
        let criterion = |one: &Candidate| one.criterion + price * one.series.freedom() as f64;
        let lowest = candidates.iter().map(criterion).fold(criterion(&chosen), f64::min);
        let weight = |one: &Candidate| (-0.5 * (criterion(one) - lowest)).exp();
        let others = candidates.into_iter().filter(|one| *one != chosen && weight(one) >= LEAST_WEIGHT);
        let creep = sample.is_creep();
        let mut models: Vec<Model> =
            std::iter::once(chosen.clone()).chain(others).map(|one| Model::new(weight(&one), one, sample, free, window, creep)).collect();
        let total: f64 = models.iter().map(|model| model.weight).sum();
        if total > 0.0 {
            models.iter_mut().for_each(|model| model.weight /= total);
        }
        let shifted = models.first().map_or_else(|| sample.clone(), |model| sample.shifted(&model.candidate.shifts));
        Self { models, free, window, creep, places: places(&shifted) }
    }

    /// The stated error of a curve at a frequency or time (Pa or 1/Pa): about 95 of 100 fits to data with this scatter lie within it.
    #[must_use]
    pub fn error(&self, quantity: Quantity, at: f64) -> f64 {
        let Some(chosen) = self.models.first() else { return f64::INFINITY };
        let value = chosen.value(quantity, at, self.creep);
        let variance: f64 = self
            .models
            .iter()
            .map(|model| {
                let off = model.value(quantity, at, self.creep) - value;
                // The chosen one counts even where a wanted error made it light.
                model.weight * (model.variance(quantity, at, self.free, self.window, self.creep) + off * off)
            })
            .sum();
        let error = DEVIATIONS * variance.sqrt();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// ln a and ln b of an isotherm of the chosen series, each with its stated error.
    pub(super) fn shift(&self, isotherm: usize) -> [(f64, f64); 2] {
        let Some(chosen) = self.models.first() else { return [(0.0, f64::INFINITY); 2] };
        let of = |vertical: usize| {
            let pick = |model: &Model| {
                let (a, b) = model.candidate.shifts.get(isotherm).copied().unwrap_or((0.0, 0.0));
                if vertical == 0 { a } else { b }
            };
            let value = pick(chosen);
            let Some(place) = self.free.place(isotherm).filter(|_| vertical == 0 || self.free.vertical) else { return (value, 0.0) };
            let variance: f64 = self
                .models
                .iter()
                .map(|model| model.weight * (model.covariance(place + vertical, place + vertical) + (pick(model) - value).powi(2)))
                .sum();
            (value, DEVIATIONS * variance.sqrt())
        };
        [of(0), of(1)]
    }

    /// Number of free numbers of the chosen series, shifts included.
    pub(super) fn freedom(&self) -> usize {
        self.free.count() + self.models.first().map_or(0, |model| model.candidate.series.freedom())
    }

    /// Covariance of ln a of two isotherms of the chosen series.
    pub(super) fn shift_covariance(&self, one: usize, other: usize) -> f64 {
        let (Some(chosen), Some(one), Some(other)) = (self.models.first(), self.free.place(one), self.free.place(other)) else {
            return 0.0;
        };
        chosen.covariance(one, other)
    }

    /// A series and shifts that the data leave possible: one of the candidates by its weight, moved by normal numbers with its covariance; none where that is unknown.
    pub(super) fn draw(&self, stream: &mut Normal) -> Option<(Material, Vec<(f64, f64)>)> {
        let mut place = stream.unit();
        let model = self.models.iter().find(|model| {
            place -= model.weight;
            place <= 0.0
        });
        let model = model.or(self.models.first())?;
        let spread = model.spread.as_ref()?;
        let normal: Vec<f64> = (0..spread.ncols()).map(|_| stream.sample()).collect();
        let step: Vec<f64> = (0..spread.nrows()).map(|k| (k..spread.ncols()).map(|j| spread[(k, j)] * normal[j]).sum()).collect();
        let (own, rest) = step.split_at(self.free.count().min(step.len()));
        // A step along which two terms exchange their strengths changes no curve while it is small: along a long one the curves would leave the linear picture,
        // so the numbers follow the curves of that picture.
        let fitted = &model.candidate.series;
        let linear: Vec<Observation> = self
            .places
            .iter()
            .map(|&(quantity, at)| {
                let value = fitted.value(quantity, at);
                let change: f64 = fitted.gradient(quantity, at, self.window).iter().zip(rest).map(|(slope, step)| slope * step).sum();
                Observation { quantity, at, value: value + change, scale: value }
            })
            .filter(|one| one.scale > 0.0)
            .collect();
        let series = fitted.moved(rest, self.window).refined(&Sample::plain(&linear), self.window, DRAW_STEPS);
        Some((material(&series, self.creep).ok()?, self.free.moved(&model.candidate.shifts, own)))
    }
}

/// Places of each quantity over its range, some a decade.
fn places(shifted: &Sample) -> Vec<(Quantity, f64)> {
    [Quantity::Storage, Quantity::Loss, Quantity::Relaxation, Quantity::Creep]
        .into_iter()
        .flat_map(|quantity| {
            let ends = shifted.places.iter().filter(|place| place.quantity == quantity).map(|place| place.at);
            let [low, high] = ends.fold([f64::INFINITY, 0.0_f64], |[low, high], at| [low.min(at), high.max(at)]);
            let count = if high >= low { ((high / low).log10() * PER_DECADE).ceil() as usize + 1 } else { 0 };
            (0..count).map(move |index| (quantity, low * (high / low).powf(index as f64 / (count - 1).max(1) as f64)))
        })
        .collect()
}

impl Model {
    fn new(weight: f64, candidate: Candidate, sample: &Sample, free: Free, window: [f64; 2], creep: bool) -> Self {
        let shifted = sample.shifted(&candidate.shifts);
        let columns = joint::columns(&candidate.series, &shifted, free, window);
        let jacobian = matrix(columns.iter().map(Vec::as_slice), shifted.places.len());
        let freedom = jacobian.ncols();
        let scatter = (candidate.misfit / (sample.count.saturating_sub(freedom).max(1)) as f64).sqrt();
        let count = candidate.series.freedom();
        let stepped = (0..count)
            .map(|index| {
                let step: Vec<f64> = (0..count).map(|other| if other == index { STEP } else { 0.0 }).collect();
                let moved = candidate.series.moved(&step, window);
                if moved == candidate.series { None } else { material(&moved, creep).ok() }
            })
            .collect();
        Self {
            weight,
            spread: spread(&jacobian, scatter, free.count()),
            material: material(&candidate.series, creep).ok(),
            stepped,
            candidate,
        }
    }

    fn value(&self, quantity: Quantity, at: f64, creep: bool) -> f64 {
        if own(quantity, creep) {
            self.candidate.series.value(quantity, at)
        } else {
            self.material.as_ref().map_or(f64::NAN, |material| response(material, quantity, at))
        }
    }

    fn variance(&self, quantity: Quantity, at: f64, free: Free, window: [f64; 2], creep: bool) -> f64 {
        let Some(spread) = &self.spread else { return f64::INFINITY };
        let gradient: Vec<f64> = if own(quantity, creep) {
            self.candidate.series.gradient(quantity, at, window)
        } else {
            let value = self.value(quantity, at, creep);
            self.stepped.iter().map(|moved| moved.as_ref().map_or(0.0, |moved| (response(moved, quantity, at) - value) / STEP)).collect()
        };
        let first = free.count();
        (first..spread.ncols())
            .map(|j| gradient.iter().enumerate().map(|(k, slope)| slope * spread[(first + k, j)]).sum::<f64>().powi(2))
            .sum()
    }

    fn covariance(&self, one: usize, other: usize) -> f64 {
        let Some(spread) = &self.spread else { return f64::INFINITY };
        (0..spread.ncols()).map(|j| spread[(one, j)] * spread[(other, j)]).sum()
    }
}

/// Whether a quantity is linear in the series that is fitted.
fn own(quantity: Quantity, creep: bool) -> bool {
    (quantity == Quantity::Creep) == creep
}

fn response(material: &Material, quantity: Quantity, at: f64) -> f64 {
    match quantity {
        Quantity::Storage => material.complex_modulus(at).map_or(f64::NAN, |modulus| modulus.storage),
        Quantity::Loss => material.complex_modulus(at).map_or(f64::NAN, |modulus| modulus.loss),
        Quantity::Relaxation => material.relaxation(at),
        Quantity::Creep => material.creep(at),
    }
}

/// σ·R⁻¹ of J = QR, with a little damping of directions that the data do not fix; the first columns are shifts.
fn spread(jacobian: &Mat<f64>, scatter: f64, shifts: usize) -> Option<Mat<f64>> {
    let (rows, columns) = (jacobian.nrows(), jacobian.ncols());
    if columns == 0 {
        return Some(Mat::zeros(0, 0));
    }
    let [number, shift] = OPEN;
    let damped = Mat::from_fn(rows + columns, columns, |i, j| {
        if i < rows {
            jacobian[(i, j)]
        } else if i - rows == j {
            scatter.max(f64::MIN_POSITIVE) / if j < shifts { shift } else { number }
        } else {
            0.0
        }
    });
    let factor = damped.qr();
    let triangle = factor.thin_R();
    let mut inverse = Mat::<f64>::zeros(columns, columns);
    for j in 0..columns {
        for i in (0..=j).rev() {
            let unit = if i == j { 1.0 } else { 0.0 };
            let sum: f64 = ((i + 1)..=j).map(|k| triangle[(i, k)] * inverse[(k, j)]).sum();
            inverse[(i, j)] = (unit - sum) / triangle[(i, i)];
        }
    }
    let spread = Mat::from_fn(columns, columns, |i, j| scatter * inverse[(i, j)]);
    (0..columns).all(|j| (0..columns).all(|i| spread[(i, j)].is_finite())).then_some(spread)
}
