//! When a crack under a constant load starts, and how fast (thesis Eq 5.66).
//!
//! ```text
//! ½cK²J(t_d) = Δγ          ẋ₀(t_d⁺) = δ J′(t_d)/[J(t_d) − J(0)]
//! ```
//! Near the glassy limit ΣJ_j(1 − e^{−t/τ_j}) + t/η = 2Δγ/(cK²) − 1/E∞ is solved, near the relaxed limit ΣJ_je^{−t/τ_j} = 1/E0 − 2Δγ/(cK²):
//! whichever right-hand side is smaller. Both sides are then sums of positive terms. The first speed is that of the work at rest:
//! it grows at the rate ½cK²J′ and falls by ½cK²(J − J(0))/δ per length (our derivation from the collapsed closure).

use super::problem::GrowthProblem;
use super::regime::{Regime, creep_needed, regime};
use crate::Estimate;
use crate::continuation::root::{LogSlope, increasing_root};
use crate::material::GivenSeries;
use crate::refusal::Refusal;

/// What a constant load does first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Onset {
    /// The crack never grows.
    Never,
    /// It starts after a delay.
    After {
        /// t_d (s).
        delay: Estimate,
        /// ẋ₀ just after the start (m/s): finite.
        initial_speed: Estimate,
        /// How often the creep series was evaluated.
        evaluations: u32,
    },
    /// It grows at once, and in this theory without bound.
    AtOnce,
}

/// Both sums of the equation at a time: the creep that has come, the creep of the terms that is left, and t·dJ/dt.
fn creep_sums(problem: &GrowthProblem<'_>, time: f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for term in problem.material.creep_terms().iter().rev() {
        let z = time / term.retardation_time;
        let left = (-z).exp();
        sums[0] -= term.compliance * (-z).exp_m1();
        sums[1] += term.compliance * left;
        sums[2] += term.compliance * if z < 745.0 { z * left } else { 0.0 };
    }
    if let Some(viscosity) = problem.material.steady_viscosity() {
        sums[0] += time / viscosity;
        sums[2] += time / viscosity;
    }
    sums
}

/// The onset under a constant load K ≥ 0 (Pa √m), to rounding.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative or non-finite load; [`Refusal::NotConverged`] for numbers near the ends of the doubles.
pub fn onset(problem: &GrowthProblem<'_>, intensity: f64) -> Result<Onset, Refusal> {
    match regime(problem, intensity)?.regime {
        Regime::NoGrowth => return Ok(Onset::Never),
        Regime::Immediate => return Ok(Onset::AtOnce),
        Regime::Delayed => {}
    }
    let material = problem.material;
    let needed = creep_needed(problem, intensity);
    let from_below = needed.to_come <= needed.left;
    let wanted = if from_below { needed.to_come } else { needed.left };
    let function = |time: f64| {
        let [come, left, slope] = creep_sums(problem, time);
        if from_below {
            LogSlope { value: (come / wanted).ln(), slope: slope / come }
        } else {
            LogSlope { value: -(left / wanted).ln(), slope: slope / left }
        }
    };
    // J(t) − J(0) ≤ J′(0⁺)t, so t_d is above to_come/J′(0⁺); above, grow until the sign changes.
    let lower = 0.5 * (needed.to_come / material.creep_rate(0.0)).max(f64::MIN_POSITIVE);
    let mut upper = 4.0 * lower;
    let mut evaluations = 0;
    while function(upper).value <= 0.0 {
        evaluations += 1;
        upper *= if evaluations < 40 { 4.0 } else { 1e6 };
        if !upper.is_finite() || evaluations > 200 {
            return Err(Refusal::NotConverged {
                what: "the bracket of the delay",
                detail: "the load is within rounding of the relaxed limit".into(),
            });
        }
    }
    let root = increasing_root("the delay of growth", function, [lower, upper], (lower * upper).sqrt(), f64::EPSILON)?;
    let time = root.argument;
    let [come, left, slope] = creep_sums(problem, time);
    // Rounding of the sums, of the exponents (near the relaxed limit z·ulp of e^{−z}), of the right-hand side, and of a converted series.
    let count = 4.0 + 0.5 * material.creep_terms().len() as f64;
    let sum = if from_below { come } else { left };
    let mut error = f64::EPSILON * (count * sum + slope);
    let mut come_error = f64::EPSILON * (count * come);
    if material.given() == GivenSeries::Relaxation {
        for (term, converted) in material.creep_terms().iter().zip(material.conversion_errors()) {
            error += term.compliance * (converted.strength + converted.time);
            come_error += term.compliance * (converted.strength + converted.time);
        }
    }
    error += material.modulus_rounding() * needed.to_come.max(1.0 / material.glassy_modulus());
    let relative = error / slope + root.relative_error;
    let speed = problem.process_zone_at(intensity) * (slope / come) / time;
    let speed_relative = 2.0 * relative + come_error / come + 4.0 * f64::EPSILON + exponent_rounding(problem, time);
    Ok(Onset::After {
        delay: Estimate::relative(time, relative),
        initial_speed: Estimate::relative(speed, speed_relative),
        evaluations: evaluations + root.evaluations,
    })
}

/// How much the relative error of the delay is magnified in J′: |d ln J′/d ln t| in ulp, at most t/τ of the term that carries J′.
fn exponent_rounding(problem: &GrowthProblem<'_>, time: f64) -> f64 {
    let (mut rate, mut curvature) = (0.0, 0.0);
    for term in problem.material.creep_terms() {
        let z = time / term.retardation_time;
        let part = term.compliance / term.retardation_time * (-z).exp();
        rate += part;
        curvature += part * z.min(745.0);
    }
    rate += problem.material.steady_viscosity().map_or(0.0, |viscosity| 1.0 / viscosity);
    if rate > 0.0 { 4.0 * f64::EPSILON * curvature / rate } else { 0.0 }
}
