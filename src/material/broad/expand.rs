//! The fewest terms for a wanted accuracy over a range of frequencies.
//!
//! Start: the spectrum by equal steps. Then for a number of terms n, strengths and times are refined together from the start spread over n
//! places, until the largest relative error of E(ω) is as small as n terms make it (weights raised where the error is largest: Lawson's
//! iteration); n is the least one that meets the accuracy. Both ends of the relaxation, E0 and E∞, are kept.

use super::BroadLaw;
use crate::material::fit::{Observation, Quantity, SeriesShape};
use crate::material::{Material, RelaxationTerm};
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// A material made of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct Expansion {
    /// The series.
    pub material: Material,
    /// Largest |ΔE(ω)|/|E(ω)| over the range, on frequencies four times as dense as those of the fit.
    pub error: f64,
    /// L ln(1/accuracy)/π²: terms that the best rational approximations need over the range, apart from a constant.
    pub terms_by_rate: f64,
    /// Whether the accuracy was met.
    pub met: bool,
}

/// Part of the accuracy below which a term does not count.
const WEAK: f64 = 0.01;
/// Frequencies a decade in the fit.
const PER_DECADE: f64 = 7.0;
/// Longest range: 40 decades.
const MOST_LENGTH: f64 = 92.2;
/// Most terms.
const MOST_TERMS: usize = 200;
/// Most steps of a refinement, how many are taken between two looks at its largest error, and how often weights are raised.
const STEPS: usize = 60;
const BETWEEN_LOOKS: usize = 5;
const RAISED: usize = 3;
/// Part of the accuracy at which a refinement ends, as nothing is gained by more; and looks without a smaller largest error after which it ends.
const ENOUGH: f64 = 0.95;
const PATIENCE: u32 = 4;
/// Cells beyond each end of the range, and how they grow.
const END_CELLS: usize = 8;
const END_GROWTH: f64 = 1.4;
/// Beyond this in ln ρ nothing is left of a spectrum with an exponent of 0.1 and more.
const FAR: f64 = 400.0;
/// The limits E0 and E∞ are held this much more tightly than the rest.
const LIMITS: f64 = 0.01;

/// Expands a law into the fewest terms over angular frequencies from the first to the second (rad/s).
///
/// # Errors
/// [`Refusal::OutOfRange`] for a range or an accuracy (1e-10 to 0.5) that is none.
pub fn expand(law: &BroadLaw, range: [f64; 2], accuracy: f64) -> Result<Expansion, Refusal> {
    let [low, high] = [require_positive("the lowest frequency", range[0])?, require_positive("the highest frequency", range[1])?];
    if high <= low || (high / low).ln() > MOST_LENGTH {
        return Err(Refusal::out_of_range("the highest frequency", high, "above the lowest frequency, by at most 40 decades"));
    }
    if !(1e-10..=0.5).contains(&accuracy) {
        return Err(Refusal::out_of_range("the accuracy of an expansion", accuracy, "from 1e-10 to 0.5"));
    }
    let length = (high / low).ln();
    let by_rate = length * (1.0 / accuracy).ln() / (PI * PI);
    let data = observations(law, range, PER_DECADE)?;
    let test = observations(law, range, 4.0 * PER_DECADE)?;
    let window = [1e-8 / high, 1e12 / low];
    let start = graded_steps(law, range, (PI * PI / (10.0 / accuracy).ln()).min(1.0));
    let attempt = |count: usize, from: &SeriesShape| {
        let shape = minimax(&from.spread_over(count), &data, window, accuracy);
        let error = largest_error(&shape, &test);
        (shape, error)
    };
    let (mut best, mut error) = attempt(start.count().min(MOST_TERMS), &start);
    let mut count = best.count();
    if error <= accuracy {
        // Down in halving strides.
        let mut stride = (count / 8).max(1);
        while count > 1 {
            let fewer = count.saturating_sub(stride).max(1);
            let (shape, reached) = attempt(fewer, &best);
            if reached <= accuracy {
                (best, error, count) = (shape, reached, fewer);
            } else if stride == 1 {
                break;
            } else {
                stride = (stride / 2).max(1);
            }
        }
    } else {
        let stride = (count / 16).max(2);
        while error > accuracy && count < MOST_TERMS {
            count += stride;
            let (shape, reached) = attempt(count, &start);
            if reached < error {
                (best, error) = (shape, reached);
            }
        }
    }
    // Where the spectrum is weak, two neighbours may be one: many pairs at once while that goes well, then fewer.
    let magnitude = |time: f64| law.complex_modulus(1.0 / time).map_or(f64::INFINITY, |modulus| modulus.magnitude());
    let mut stride = best.count() / 8;
    while error <= accuracy && best.count() > 1 {
        let fewer = (0..stride.max(1)).fold(best.clone(), |shape, _| shape.weakest_joined(magnitude));
        let shape = minimax(&fewer, &data, window, accuracy);
        let reached = largest_error(&shape, &test);
        if reached <= accuracy {
            (best, error) = (shape, reached);
        } else if stride <= 1 {
            break;
        } else {
            stride /= 2;
        }
    }
    // Terms far weaker than the accuracy at their own frequency are nothing but work.
    let stronger = best
        .without(|strength, time| law.complex_modulus(1.0 / time).is_ok_and(|modulus| strength < WEAK * accuracy * modulus.magnitude()));
    let reached = largest_error(&stronger, &test);
    if reached <= error.max(accuracy) {
        (best, error) = (stronger, reached);
    }
    let terms: Vec<RelaxationTerm> =
        best.terms().iter().map(|&(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
    Ok(Expansion {
        material: Material::from_relaxation(law.relaxed_modulus, &terms)?,
        error,
        terms_by_rate: by_rate,
        met: error <= accuracy,
    })
}

/// E(ω) at log-spaced frequencies, and both limits.
fn observations(law: &BroadLaw, range: [f64; 2], per_decade: f64) -> Result<Vec<Observation>, Refusal> {
    let decades = (range[1] / range[0]).log10();
    let steps = (decades * per_decade).ceil().max(4.0) as usize;
    let mut data = Vec::with_capacity(2 * steps + 4);
    for index in 0..=steps {
        let at = range[0] * 10f64.powf(decades * index as f64 / steps as f64);
        let modulus = law.complex_modulus(at)?;
        let scale = modulus.magnitude();
        data.push(Observation { quantity: Quantity::Storage, at, value: modulus.storage, scale });
        data.push(Observation { quantity: Quantity::Loss, at, value: modulus.loss, scale });
    }
    // R at a time of nothing and for ever: every kernel is 1 or 0 there.
    for (at, value) in [(f64::MIN_POSITIVE, law.glassy_modulus), (f64::MAX, law.relaxed_modulus)] {
        if value > 0.0 {
            data.push(Observation { quantity: Quantity::Relaxation, at, value, scale: LIMITS * value });
        }
    }
    Ok(data)
}

/// The spectrum by equal steps of ln ρ over the range, by growing steps beyond it, where a term shows less and less of its time.
fn graded_steps(law: &BroadLaw, [low, high]: [f64; 2], step: f64) -> SeriesShape {
    let gained = law.glassy_modulus - law.relaxed_modulus;
    let (inner, outer) = (1.0 / high, 1.0 / low);
    let count = ((outer / inner).ln() / step).ceil().max(1.0) as usize;
    let width = (outer / inner).ln() / count as f64;
    // Borders of the cells, in ln ρ, from the inside out on both sides.
    let mut borders: Vec<f64> = (0..=count).map(|index| inner.ln() + width * index as f64).collect();
    for direction in [-1.0, 1.0] {
        let (mut growing, mut border) = (width, if direction < 0.0 { inner.ln() } else { outer.ln() });
        for _ in 0..END_CELLS {
            growing *= END_GROWTH;
            border += direction * growing;
            borders.push(border);
        }
    }
    borders.sort_by(f64::total_cmp);
    let mass = |from: f64, to: f64| {
        // Fine enough for any spectrum with an exponent in the range allowed.
        let parts = ((to - from) / 0.05).ceil().max(1.0);
        let part = (to - from) / parts;
        (0..parts as usize).map(|k| law.spectrum((from + (k as f64 + 0.5) * part).exp()) * part).sum::<f64>() * gained
    };
    let mut terms: Vec<(f64, f64)> = borders
        .windows(2)
        .filter_map(|pair| <[f64; 2]>::try_from(pair).ok())
        .map(|[from, to]| (mass(from, to), (0.5 * (from + to)).exp()))
        .collect();
    // What lies still further out goes to the ends.
    let (first, last) = (borders.first().copied().unwrap_or(0.0), borders.last().copied().unwrap_or(0.0));
    if let Some(term) = terms.first_mut() {
        term.0 += mass(first - FAR, first);
    }
    if let Some(term) = terms.last_mut() {
        term.0 += mass(last, last + FAR);
    }
    terms.retain(|&(strength, _)| strength > 1e-16 * gained);
    SeriesShape::new(law.relaxed_modulus, terms)
}

/// Refined until the largest error is as small as it gets, or small enough.
fn minimax(start: &SeriesShape, data: &[Observation], window: [f64; 2], accuracy: f64) -> SeriesShape {
    let mut weighted = data.to_vec();
    let descended = |from: &SeriesShape, weighted: &[Observation]| {
        let (mut shape, mut least, mut stale) = (from.clone(), f64::INFINITY, 0);
        for _ in 0..STEPS / BETWEEN_LOOKS {
            shape = shape.refined(weighted, window, BETWEEN_LOOKS);
            let error = largest_error(&shape, data);
            stale = if error < least { 0 } else { stale + 1 };
            least = least.min(error);
            if error <= ENOUGH * accuracy || stale == PATIENCE {
                break;
            }
        }
        let error = largest_error(&shape, data);
        (shape, error)
    };
    let (mut best, mut reached) = descended(start, &weighted);
    let mut current = best.clone();
    for _ in 0..RAISED {
        // Far off, weights do not help; near enough, they are not needed.
        if reached <= accuracy || reached > 3.0 * accuracy {
            break;
        }
        let errors = current.complex_errors(data);
        let mean = errors.iter().sum::<f64>() / errors.len().max(1) as f64;
        for (observation, error) in weighted.iter_mut().zip(&errors) {
            observation.scale /= (error / mean).clamp(0.1, 10.0).sqrt();
        }
        let now;
        (current, now) = descended(&current, &weighted);
        if now < reached {
            (best, reached) = (current.clone(), now);
        }
    }
    best
}

/// The largest |ΔE|/|E|.
fn largest_error(shape: &SeriesShape, data: &[Observation]) -> f64 {
    shape.complex_errors(data).into_iter().fold(0.0, f64::max)
}
