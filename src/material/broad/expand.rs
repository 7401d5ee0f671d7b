//! Few terms for a wanted accuracy over a range of frequencies.
//!
//! The trapezoidal rule of the spectrum over ln ρ converges exponentially, at the rate of the best series (see the module above), so its places are
//! kept: equal steps inside the range, growing ones beyond its ends, and shorter ones where a pole of the spectrum comes near to the axis. At these
//! places the strengths are those of a linear least-squares problem; places with a negative strength are left out. The steps are the longest of a list at which the
//! error against the closed modulus, at four times as many frequencies, meets the accuracy. Nothing is iterated, so the work is known.
//! Both ends of the relaxation, E0 and E∞, are kept.

use super::BroadLaw;
use crate::material::fit::{Observation, Quantity, SeriesShape};
use crate::material::{Material, RelaxationTerm};
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::{FRAC_2_PI, LN_10, PI};

/// A material made of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct Expansion {
    /// The series.
    pub material: Material,
    /// Largest |ΔE(ω)|/|E(ω)| over the range, on frequencies four times as dense as those of the fit.
    pub error: f64,
    /// L ln(1/accuracy)/π²: terms that the best rational approximations need over the range, besides a constant.
    pub terms_by_rate: f64,
    /// Whether the accuracy was met.
    pub met: bool,
    /// Linear systems that it took.
    pub solves: usize,
}

/// Part of the accuracy below which a term does not count.
const WEAK: f64 = 0.01;
/// Part of the accuracy below which the spectrum at a place does not.
const NEGLIGIBLE: f64 = 1e-3;
/// Frequencies a decade in the fit, at least, and for each place.
const PER_DECADE: f64 = 7.0;
const PER_PLACE: f64 = 2.5;
/// Longest range: 40 decades.
const MOST_LENGTH: f64 = 92.2;
/// The limits E0 and E∞ are held this much more tightly than the rest.
const LIMITS: f64 = 0.01;
/// How far places reach beyond each end of the range in ln ρ, and how their steps grow: what is best depends on how much of the spectrum lies there.
const BEYOND: [f64; 2] = [8.0, 20.0];
const GROWTHS: [f64; 3] = [1.1, 1.25, 1.4];
/// Steps over that of the rate: from the first down by the second, so many. The longest that meets the accuracy is taken.
const LONGEST: f64 = 1.1;
const SHORTER: f64 = 0.05;
const TRIES: u32 = 16;
const STRIDE: u32 = 3;
/// The longest step: of half a decade the rule is no longer one of a smooth function.
const MOST_STEP: f64 = 2.0;
/// Points at which the density of places is summed.
const DENSITY_POINTS: usize = 2000;

/// A series and its largest error.
type Found = (SeriesShape, f64);

/// Expands a law into few terms over angular frequencies from the first to the second (rad/s).
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
    let ideal = (PI * PI / (1.0 / accuracy).ln()).min(MOST_STEP);
    let per_decade = PER_DECADE.max(PER_PLACE * LN_10 / ideal);
    let data = observations(law, range, per_decade)?;
    let test = observations(law, range, 4.0 * per_decade)?;
    let mut solves = 0;
    // The fewest terms that meet the accuracy; without any, those that come closest.
    let (mut best, mut closest): (Option<Found>, Option<Found>) = (None, None);
    let mut meets = |index: u32, growth: f64, beyond: f64| {
        let step = ideal * (LONGEST - SHORTER * f64::from(index));
        let (shape, taken) = SeriesShape::positive(law.relaxed_modulus, &places(law, range, (step, growth, beyond), accuracy), &data);
        solves += taken;
        let error = largest_error(&shape, &test);
        let met = error <= accuracy;
        let better = |kept: &Option<Found>| {
            kept.as_ref().is_none_or(|(other, least)| if met { shape.count() < other.count() } else { error < *least })
        };
        let kept = if met { &mut best } else { &mut closest };
        if better(kept) {
            *kept = Some((shape, error));
        }
        met
    };
    let mut any = false;
    for (beyond, growth) in BEYOND.into_iter().flat_map(|beyond| GROWTHS.map(|growth| (beyond, growth))) {
        // Further beyond the range only where nothing else helps.
        if any && beyond > BEYOND[0] {
            break;
        }
        // In strides down to a step that meets the accuracy, then the longer steps that were left out.
        if let Some(first) = (STRIDE..TRIES).step_by(STRIDE as usize).find(|&index| meets(index, growth, beyond)) {
            any = true;
            let _ = (first + 1 - STRIDE..first).rev().find(|&index| !meets(index, growth, beyond));
        }
    }
    let (mut shape, mut error) = best.or(closest).ok_or_else(|| Refusal::Undefined {
        quantity: "the expansion of a law",
        reason: "its numbers are so far from each other that they overflow".into(),
    })?;
    // Terms far weaker than the accuracy at their own frequency are nothing but work.
    let stronger = shape
        .without(|strength, time| law.complex_modulus(1.0 / time).is_ok_and(|modulus| strength < WEAK * accuracy * modulus.magnitude()));
    let reached = largest_error(&stronger, &test);
    if reached <= error.max(accuracy) {
        (shape, error) = (stronger, reached);
    }
    let terms: Vec<RelaxationTerm> =
        shape.terms().iter().map(|&(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
    Ok(Expansion {
        material: Material::from_relaxation(law.relaxed_modulus, &terms)?,
        error,
        terms_by_rate: (high / low).ln() * (1.0 / accuracy).ln() / (PI * PI),
        met: error <= accuracy,
        solves,
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

/// Relaxation times: inside the range at equal steps of ln ρ, shorter ones near a pole of the spectrum, beyond both ends at growing ones.
fn places(law: &BroadLaw, [low, high]: [f64; 2], (step, growth, beyond): (f64, f64, f64), accuracy: f64) -> Vec<f64> {
    let (inner, outer) = (-high.ln(), -low.ln());
    // The kernel's own poles lie π/2 from the axis: where one of the spectrum is nearer, steps are shorter in proportion.
    let (centre, distance) = (law.time.ln(), law.pole_distance());
    let density = |place: f64| 1.0 / (step * (FRAC_2_PI * (place - centre).hypot(distance)).min(1.0));
    let width = (outer - inner) / DENSITY_POINTS as f64;
    let mut sums = Vec::with_capacity(DENSITY_POINTS + 1);
    let mut sum = 0.0;
    sums.push(sum);
    for index in 0..DENSITY_POINTS {
        sum += width * density(inner + (index as f64 + 0.5) * width);
        sums.push(sum);
    }
    let count = sum.ceil().max(1.0);
    let mut logarithms = Vec::new();
    let (mut cell, mut wanted) = (0, 0.5 / count * sum);
    for window in sums.windows(2) {
        let (from, to) = (window.first().copied().unwrap_or(0.0), window.last().copied().unwrap_or(0.0));
        while wanted <= to && logarithms.len() < count as usize {
            logarithms.push(inner + width * (f64::from(cell) + (wanted - from) / (to - from)));
            wanted += sum / count;
        }
        cell += 1;
    }
    let (mut growing, mut border) = (step, 0.0);
    while border < beyond {
        growing *= growth;
        logarithms.extend([inner - border - 0.5 * growing, outer + border + 0.5 * growing]);
        border += growing;
    }
    // Where the spectrum is far below the accuracy, a strength would be one of rounding.
    let counts = |time: &f64| {
        let modulus = law.complex_modulus((1.0 / time).clamp(low, high)).map_or(0.0, |modulus| modulus.magnitude());
        step * law.spectrum(*time) * (law.glassy_modulus - law.relaxed_modulus) > NEGLIGIBLE * accuracy * modulus
    };
    logarithms.into_iter().map(f64::exp).filter(counts).collect()
}

/// The largest |ΔE|/|E|.
fn largest_error(shape: &SeriesShape, data: &[Observation]) -> f64 {
    shape.complex_errors(data).into_iter().fold(0.0, f64::max)
}
