//! The modulus that a two-dimensional or half-space problem sees.
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | E | Young's modulus | Pa |
//! | ν | Poisson ratio, −1 < ν ≤ 0.5 | – |
//! | E* | plane modulus: E/(1 − ν²) in plane strain and on a half-space, E in plane stress | Pa |
//!
//! Source: Johnson, *Contact Mechanics* (1985), Sec 3.1 and Eq (4.3) [the contact modulus of two bodies].

use crate::refusal::{Refusal, require_poisson_ratio, require_positive};
use serde::{Deserialize, Serialize};

/// The state of deformation out of the plane of a two-dimensional problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PlaneState {
    /// No stress out of the plane: a thin sheet. E* = E.
    Stress,
    /// No strain out of the plane: a thick body, and every half-space. E* = E/(1 − ν²).
    Strain,
}

impl PlaneState {
    /// E*/E of this state at a given Poisson ratio: 1 in plane stress, 1/(1 − ν²) in plane strain.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside −1 < ν ≤ 0.5.
    pub fn stiffening(self, poisson_ratio: f64) -> Result<f64, Refusal> {
        let nu = require_poisson_ratio(poisson_ratio)?;
        Ok(match self {
            Self::Stress => 1.0,
            Self::Strain => 1.0 / ((1.0 - nu) * (1.0 + nu)),
        })
    }

    /// The plane modulus E* of a body with Young's modulus `youngs_modulus`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus that is not positive, or a Poisson ratio outside −1 < ν ≤ 0.5.
    pub fn modulus(self, youngs_modulus: f64, poisson_ratio: f64) -> Result<f64, Refusal> {
        Ok(require_positive("youngs_modulus", youngs_modulus)? * self.stiffening(poisson_ratio)?)
    }
}

/// The contact modulus of two half-spaces: 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a modulus that is not positive, or a Poisson ratio outside −1 < ν ≤ 0.5.
pub fn contact_modulus(bodies: [(f64, f64); 2]) -> Result<f64, Refusal> {
    let mut compliance = 0.0;
    for (youngs_modulus, poisson_ratio) in bodies {
        compliance += 1.0 / PlaneState::Strain.modulus(youngs_modulus, poisson_ratio)?;
    }
    Ok(1.0 / compliance)
}
