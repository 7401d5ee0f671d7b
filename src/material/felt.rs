//! Terms that a problem cannot feel, put together into one at each end of the spectrum.
//!
//! A problem that visits times from t₁ to t₂ sees of the terms far slower than t₂ only their sum, a spring, and to first order their rate;
//! of those far faster than t₁ only their sum, which never bears, and to first order their viscosity. One term keeps both:
//! ```text
//! slow   E = Σ E_i,  E/ρ = Σ E_i/ρ_i          fast   E = Σ E_i,  Eρ = Σ E_iρ_i          (creep terms likewise)
//! ```
//! so that E0 and E∞ stay exactly, and what is left is of second order in the ratio of the times. The bound is not that order but a
//! measurement: the largest relative change of E(ω), J, R and of their running means over the visited range and a decade beyond on both
//! sides, times ten. Every problem of this crate is determined by these functions over the times it visits.

use super::{CreepTerm, GivenSeries, Material, RelaxationTerm};
use crate::refusal::Refusal;

/// Results may follow the material by more than its own change: fields and edges by powers of it, folds not counted.
const GRANTED: f64 = 10.0;
/// Samples a decade.
const PER_DECADE: f64 = 6.0;
/// Most samples: over more decades than these take, nothing is put together.
const MOST_SAMPLES: f64 = 1000.0;

/// A material with fewer terms that a problem cannot tell from the full one.
#[derive(Debug, Clone, PartialEq)]
pub struct Felt {
    /// The material.
    pub material: Material,
    /// Terms left out at the slow end.
    pub slow: usize,
    /// Terms left out at the fast end.
    pub fast: usize,
    /// Bound on the relative change of a result.
    pub bound: f64,
}

/// Puts terms together that times from the first to the second (s, either open: 0 or ∞) cannot feel, as long as the bound stays below
/// the one granted; none if no two terms can be.
///
/// # Errors
/// Only those of making a material.
pub fn felt(material: &Material, visited: [f64; 2], granted: f64) -> Result<Option<Felt>, Refusal> {
    let terms = pairs(material);
    if material.steady_viscosity.is_some() || terms.len() < 3 || granted.is_nan() || granted <= 0.0 {
        return Ok(None);
    }
    let total: f64 = terms.iter().map(|term| term.0).sum();
    // A first guess by the second order, relative to the least that stands against it; then fewer until the measured change is granted.
    let floor = match material.given {
        GivenSeries::Relaxation => material.relaxed_modulus,
        GivenSeries::Creep => 1.0 / material.glassy_modulus,
    }
    .max(1e-6 * total);
    let allowed = granted / GRANTED * floor;
    let count = |ordered: &mut dyn Iterator<Item = &(f64, f64)>, ratio: &dyn Fn(f64) -> f64| {
        let mut sum = 0.0;
        ordered
            .take_while(|term| {
                sum += term.0 * ratio(term.1).powi(2);
                sum <= allowed
            })
            .count()
    };
    let mut slow = if visited[1].is_finite() { count(&mut terms.iter(), &|time| visited[1] / time) } else { 0 };
    let mut fast = if visited[0] > 0.0 { count(&mut terms.iter().rev(), &|time| time / visited[0]) } else { 0 };
    fast = fast.min(terms.len() - slow);
    while slow > 1 || fast > 1 {
        let candidate = joined(material, &terms, slow, fast)?;
        let bound = GRANTED * change(material, &candidate, visited, [slow > 1, fast > 1]);
        if bound <= granted {
            return Ok(Some(Felt { material: candidate, slow: slow.saturating_sub(1), fast: fast.saturating_sub(1), bound }));
        }
        if slow >= fast {
            slow -= 1;
        } else {
            fast -= 1;
        }
    }
    Ok(None)
}

/// (strength, time) of the given series, longest time first.
fn pairs(material: &Material) -> Vec<(f64, f64)> {
    match material.given {
        GivenSeries::Relaxation => material.relaxation_terms.iter().map(|term| (term.modulus, term.relaxation_time)).collect(),
        GivenSeries::Creep => material.creep_terms.iter().map(|term| (term.compliance, term.retardation_time)).collect(),
    }
}

/// The material with so many of its slowest and of its fastest terms put together.
fn joined(material: &Material, terms: &[(f64, f64)], slow: usize, fast: usize) -> Result<Material, Refusal> {
    let end = terms.len() - fast;
    let sum = |part: &[(f64, f64)]| part.iter().map(|term| term.0).sum::<f64>();
    let mut kept: Vec<(f64, f64)> = Vec::with_capacity(terms.len());
    if let Some(part) = terms.get(..slow).filter(|part| !part.is_empty()) {
        kept.push((sum(part), sum(part) / part.iter().map(|term| term.0 / term.1).sum::<f64>()));
    }
    kept.extend(terms.get(slow..end).unwrap_or(&[]));
    if let Some(part) = terms.get(end..).filter(|part| !part.is_empty()) {
        kept.push((sum(part), part.iter().map(|term| term.0 * term.1).sum::<f64>() / sum(part)));
    }
    match material.given {
        GivenSeries::Relaxation => {
            let terms: Vec<RelaxationTerm> =
                kept.into_iter().map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
            Material::from_relaxation(material.relaxed_modulus, &terms)
        }
        GivenSeries::Creep => {
            let terms: Vec<CreepTerm> =
                kept.into_iter().map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect();
            Material::from_creep(material.glassy_modulus, &terms, None)
        }
    }
}

/// The largest relative change of the functions of a material over the visited times and a decade beyond; an open end reaches as far as the
/// terms do, where nothing was put together.
fn change(full: &Material, fewer: &Material, visited: [f64; 2], [slow, fast]: [bool; 2]) -> f64 {
    let slowest = full.longest_retardation_time().unwrap_or(1.0);
    let fastest = full.relaxation_terms.last().map_or(1.0, |term| term.relaxation_time);
    let low = if visited[0] > 0.0 && fast {
        0.1 * visited[0]
    } else {
        (0.1 * fastest).min(if visited[0] > 0.0 { visited[0] } else { f64::INFINITY })
    };
    let high = if visited[1].is_finite() && slow {
        10.0 * visited[1]
    } else {
        (10.0 * slowest).max(if visited[1].is_finite() { visited[1] } else { 0.0 })
    };
    let steps = ((high / low).log10() * PER_DECADE).ceil().max(1.0);
    // Numbers so far apart that they overflow: nothing is granted then.
    if !steps.is_finite() || steps > MOST_SAMPLES {
        return f64::INFINITY;
    }
    let relative = |new: f64, old: f64| (new / old - 1.0).abs();
    let mut largest = 0.0_f64;
    for index in 0..=steps as usize {
        let time = low * (high / low).powf(index as f64 / steps);
        for (new, old) in [
            (fewer.creep(time), full.creep(time)),
            (fewer.relaxation(time), full.relaxation(time)),
            (fewer.mean_creep(time).value, full.mean_creep(time).value),
            (fewer.mean_relaxation(time).value, full.mean_relaxation(time).value),
        ] {
            largest = largest.max(relative(new, old));
        }
        if let (Ok(new), Ok(old)) = (fewer.complex_modulus(1.0 / time), full.complex_modulus(1.0 / time)) {
            largest = largest.max((new.storage - old.storage).hypot(new.loss - old.loss) / old.magnitude());
        }
    }
    // A NaN must not pass for no change.
    if largest.is_finite() { largest } else { f64::INFINITY }
}
