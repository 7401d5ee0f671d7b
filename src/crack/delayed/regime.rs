//! Under a constant load a crack never grows, grows after a delay, or at once (thesis Eq 5.68).
//!
//! ```text
//! cK²/(2E0) ≤ Δγ   no growth      cK²/(2E∞) ≥ Δγ   immediate      between   delayed
//! ```
//! The two differences are formed in double-double numbers, so that a load within rounding of a limit is on its own side of it.

use super::problem::GrowthProblem;
use crate::refusal::{Refusal, require_non_negative};
use serde::{Deserialize, Serialize};
use twofloat::TwoFloat;

/// What a constant load does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Regime {
    /// Even the relaxed solid releases too little.
    NoGrowth,
    /// The glassy solid releases too little, the relaxed one enough.
    Delayed,
    /// Even the glassy solid releases enough.
    Immediate,
}

/// The regime, the inequality that decides it, and its two sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegimeReport {
    /// Which of the three.
    pub regime: Regime,
    /// cK²/(2E∞) (J/m²), the release of the first instant (thesis Eq 5.49).
    pub glassy_release: f64,
    /// cK²/(2E0) (J/m²), the release of a rested solid; infinite for a viscous one under load.
    pub relaxed_release: f64,
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// √(2ΔγE0/c) (Pa √m), the left side of Eq 5.68.
    pub relaxed_limit: f64,
    /// √(2ΔγE∞/c) (Pa √m), the right side of Eq 5.68.
    pub glassy_limit: f64,
}

impl RegimeReport {
    /// The inequality that decides, in words, then its left and its right side (J/m²).
    #[must_use]
    pub const fn decision(&self) -> (&'static str, f64, f64) {
        match self.regime {
            Regime::NoGrowth => ("halves*K^2/(2 E_relaxed) <= work_of_adhesion", self.relaxed_release, self.work_of_adhesion),
            Regime::Delayed => ("halves*K^2/(2 E_glassy) < work_of_adhesion", self.glassy_release, self.work_of_adhesion),
            Regime::Immediate => ("halves*K^2/(2 E_glassy) >= work_of_adhesion", self.glassy_release, self.work_of_adhesion),
        }
    }
}

/// What is missing of the work of adhesion, divided by ½cK²: the creep 2Δγ/(cK²) − 1/E∞ that must come (1/Pa), and the creep
/// 1/E0 − 2Δγ/(cK²) that is left when the crack starts. Both in double-double numbers of the given doubles.
pub(crate) struct CreepNeeded {
    pub(crate) to_come: f64,
    pub(crate) left: f64,
}

pub(crate) fn creep_needed(problem: &GrowthProblem<'_>, intensity: f64) -> CreepNeeded {
    let exact = TwoFloat::from;
    // 2Δγ/(cK²): the crate's quotients have only 53 good bits, so differences are formed over a common denominator.
    let work = exact(2.0 * problem.interface.work_of_adhesion);
    let square = exact(problem.interface.body.deformable_halves()) * exact(intensity) * exact(intensity);
    let glassy = problem.material.glassy_modulus();
    let to_come = f64::from(work * exact(glassy) - square) / f64::from(square) / glassy;
    let mut gained = exact(0.0);
    for term in problem.material.creep_terms() {
        gained += exact(term.compliance);
    }
    let left = if problem.material.relaxed_modulus() > 0.0 {
        // (1/E∞ + ΣJ) − 2Δγ/(cK²) = [cK²(1 + E∞ΣJ) − 2ΔγE∞]/(cK²E∞)
        f64::from(square + square * (gained * exact(glassy)) - work * exact(glassy)) / f64::from(square) / glassy
    } else {
        f64::INFINITY
    };
    CreepNeeded { to_come, left }
}

/// The regime under a constant load K ≥ 0 (Pa √m).
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative or non-finite load.
pub fn regime(problem: &GrowthProblem<'_>, intensity: f64) -> Result<RegimeReport, Refusal> {
    require_non_negative("intensity", intensity)?;
    let work = problem.interface.work_of_adhesion;
    let release = |modulus: f64| {
        if intensity == 0.0 { 0.0 } else { problem.interface.body.drive(work, intensity) * (work / modulus) }
    };
    let regime = if intensity * intensity == 0.0 {
        Regime::NoGrowth
    } else if !(intensity * intensity * problem.interface.body.deformable_halves()).is_finite() {
        // No work of adhesion that is a double balances a release that is none.
        Regime::Immediate
    } else {
        let needed = creep_needed(problem, intensity);
        if needed.to_come <= 0.0 {
            Regime::Immediate
        } else if needed.left <= 0.0 {
            Regime::NoGrowth
        } else {
            Regime::Delayed
        }
    };
    Ok(RegimeReport {
        regime,
        glassy_release: release(problem.material.glassy_modulus()),
        relaxed_release: release(problem.material.relaxed_modulus()),
        work_of_adhesion: work,
        relaxed_limit: problem.relaxed_limit(),
        glassy_limit: problem.glassy_limit(),
    })
}
