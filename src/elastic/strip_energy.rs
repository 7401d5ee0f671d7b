//! Energy of a linear viscoelastic strip that creeps under a suddenly applied, then constant stress.
//!
//! ```text
//!    σ0 ^                        Voigt chain: one spring, then spring ∥ dashpot
//!   +---|---+
//!   |       |   ε(t)              --/\/\/--[ /\/\/ ]--[ /\/\/ ]-- … σ0
//!   |       |                       1/E∞   [ ==|   ]  [ ==|   ]
//!   +---|---+                               J_1,τ_1    J_2,τ_2
//!    σ0 v
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | σ0 | `stress`, applied at time zero and held | Pa |
//! | t | `time` since then | s |
//! | E∞ | `glassy_modulus` | Pa |
//! | J_j | compliance of a creep term (the thesis writes 1/E_j) | 1/Pa |
//! | τ_j | RETARDATION time of that term | s |
//! | W | `stored_energy_density` | J/m³ |
//!
//! Equations: W = ½σ0²{1/E∞ + ΣJ_j[1 − exp(−t/τ_j)]²} (thesis Eq 5.48); every term creeps to e_j = σ0J_j(1 − exp(−t/τ_j)) and has by
//! then dissipated ½σ0²J_j[1 − exp(−2t/τ_j)] (its dashpot has viscosity τ_j/J_j; integrate (τ_j/J_j)ė_j²). Stored and dissipated
//! energy of a term add up to σ0e_j, the work done on it. The step itself is taken slow against inertia and fast against τ_j:
//! the glassy spring takes ½σ0²/E∞ and nothing is lost in it.
//!
//! **Width.** Compliances above are uniaxial. Under a stress normal to the strip's faces with the width free, they hold in plane stress and
//! carry (1 − ν²) in plane strain; with the width held see [`crate::elastic::pure_shear_strip`]. The Poisson ratio is a constant.
//!
//! Range: linear viscoelasticity, homogeneous strip. Relative error below 1e-15 times (3 + number of terms): all summands are positive,
//! and 1 − exp is taken as −expm1, so that the first instants keep their digits.

use super::plane_modulus::PlaneState;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};

/// A strip of linear viscoelastic material under a stress step.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepingStrip {
    glassy_compliance: f64,
    /// (compliance, retardation time), the compliances already carrying the factor of the plane state.
    creep_terms: Vec<(f64, f64)>,
}

impl CreepingStrip {
    /// A strip with Young's glassy modulus `glassy_modulus` and creep terms (compliance, retardation time), width free to contract.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus, compliance or time that is not finite and positive, or a Poisson ratio outside
    /// −1 < ν ≤ 0.5.
    pub fn new(glassy_modulus: f64, creep_terms: &[(f64, f64)], plane_state: PlaneState, poisson_ratio: f64) -> Result<Self, Refusal> {
        let stiffening = plane_state.stiffening(poisson_ratio)?;
        let glassy_compliance = 1.0 / (require_positive("glassy_modulus", glassy_modulus)? * stiffening);
        let mut terms = Vec::with_capacity(creep_terms.len());
        for &(compliance, retardation_time) in creep_terms {
            let compliance = require_positive("compliance", compliance)? / stiffening;
            terms.push((compliance, require_positive("retardation_time", retardation_time)?));
        }
        Ok(Self { glassy_compliance: require_positive("glassy_compliance", glassy_compliance)?, creep_terms: terms })
    }

    /// The strain at `time` (s) after a stress step of height `stress` (Pa).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative time, or a stress that is not finite.
    pub fn strain(&self, stress: f64, time: f64) -> Result<f64, Refusal> {
        let creep = self.sum(time, |reach| reach)?;
        require_finite("strain", require_finite("stress", stress)? * (self.glassy_compliance + creep))
    }

    /// The elastic energy per volume (J/m³) stored at `time` (s) after a stress step of height `stress` (Pa) (thesis Eq 5.48).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative time, or a stress that is not finite.
    pub fn stored_energy_density(&self, stress: f64, time: f64) -> Result<f64, Refusal> {
        let stored = self.sum(time, |reach| reach * reach)?;
        let stress = require_finite("stress", stress)?;
        require_finite("stored_energy_density", 0.5 * stress * (stress * (self.glassy_compliance + stored)))
    }

    /// The energy per volume (J/m³) dissipated between the stress step (Pa) and `time` (s).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative time, or a stress that is not finite.
    pub fn dissipated_energy_density(&self, stress: f64, time: f64) -> Result<f64, Refusal> {
        // 1 − e^{−2x} = (1 − e^{−x})(1 + e^{−x}) = reach·(2 − reach), with nothing to cancel: 0 ≤ reach ≤ 1.
        let lost = self.sum(time, |reach| reach * (2.0 - reach))?;
        let stress = require_finite("stress", stress)?;
        require_finite("dissipated_energy_density", 0.5 * stress * (stress * lost))
    }

    /// Σ J_j·weight(1 − exp(−t/τ_j)). An infinite time is allowed: it is the relaxed limit.
    fn sum(&self, time: f64, weight: impl Fn(f64) -> f64) -> Result<f64, Refusal> {
        if time.is_nan() || time < 0.0 {
            return Err(Refusal::out_of_range("time", time, "zero or more"));
        }
        Ok(self.creep_terms.iter().map(|&(compliance, retardation_time)| compliance * weight(-(-time / retardation_time).exp_m1())).sum())
    }
}

/// The elastic counterpart: energy per volume of an elastic strip under `stress`, width free, ½σ²/E* with E* of the plane state.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a modulus that is not positive, a stress that is not finite, or a Poisson ratio outside −1 < ν ≤ 0.5.
pub fn elastic_energy_density(stress: f64, youngs_modulus: f64, plane_state: PlaneState, poisson_ratio: f64) -> Result<f64, Refusal> {
    let modulus = plane_state.modulus(youngs_modulus, poisson_ratio)?;
    require_non_negative("elastic_energy_density", 0.5 * stress * (require_finite("stress", stress)? / modulus))
}
