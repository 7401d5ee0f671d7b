//! A rigid flat-ended cylinder stuck to an elastic half-space: it comes off at once, and at one force.
//!
//! ```text
//!            ^ F < 0 (pull)
//!          +-|-+
//!          |   |
//!          |   |          flat face, radius a
//!      ____|___|____
//!     ´    |   |    `     surface drawn up by −Δ
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | a | `punch_radius` = contact radius until it comes off | m |
//! | E* | `contact_modulus` | Pa |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | Δ | `penetration`, negative when pulled | m |
//! | F | `force` = 2E*aΔ, negative when pulled | N |
//! | K | `stress_intensity_factor` at the rim = −E*Δ/√(πa) | Pa√m |
//!
//! Equations: G = K²/(2E*) = E*Δ²/(2πa); pull-off at G = Δγ: |F| = √(8πE*Δγa³), |Δ| = √(2πaΔγ/E*).
//! Source: Kendall, J. Phys. D 4 (1971) 1186, [10.1088/0022-3727/4/8/320](https://doi.org/10.1088/0022-3727/4/8/320);
//! pressure and compliance: Johnson, *Contact Mechanics* (1985), Sec 3.8.
//!
//! G grows as the contact shrinks, at fixed force (as a⁻³) and at fixed penetration (as a⁻¹): pull-off is the same event under both
//! controls, and below it the rim does not move at all.
//!
//! Range: frictionless (for an incompressible body also full stick), a far below the size of the body. Relative error below 1e-15.

use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use std::f64::consts::PI;

/// A rigid flat-ended cylinder adhering to an elastic half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KendallPunch {
    punch_radius: f64,
    contact_modulus: f64,
    work_of_adhesion: f64,
}

impl KendallPunch {
    /// A cylinder of radius `punch_radius` (m) on a body of contact modulus E* (Pa), with a work of adhesion (J/m²). A zero `work_of_adhesion` is allowed and gives a
    /// zero pull-off force.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a radius or modulus that is not finite and positive, or a negative work of adhesion.
    pub fn new(punch_radius: f64, contact_modulus: f64, work_of_adhesion: f64) -> Result<Self, Refusal> {
        Ok(Self {
            punch_radius: require_positive("punch_radius", punch_radius)?,
            contact_modulus: require_positive("contact_modulus", contact_modulus)?,
            work_of_adhesion: require_non_negative("work_of_adhesion", work_of_adhesion)?,
        })
    }

    /// The pull-off force as a positive number: the punch comes off at `force = -pull_off_force`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] when the force leaves the range of doubles.
    pub fn pull_off_force(&self) -> Result<f64, Refusal> {
        // 2E*a|Δ|: the product under one root would overflow earlier.
        require_finite("pull_off_force", -2.0 * self.contact_modulus * self.punch_radius * self.pull_off_penetration())
    }

    /// The (negative) penetration at which the punch comes off.
    #[must_use]
    pub fn pull_off_penetration(&self) -> f64 {
        -(2.0 * PI * self.punch_radius).sqrt() * (self.work_of_adhesion / self.contact_modulus).sqrt()
    }

    /// The compressive force at a given penetration while the whole face is in contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a penetration that is not finite.
    pub fn force(&self, penetration: f64) -> Result<f64, Refusal> {
        require_finite("force", 2.0 * self.contact_modulus * self.punch_radius * require_finite("penetration", penetration)?)
    }

    /// The stress intensity factor at the rim: positive under a pull, negative (no crack opens) under compression.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a penetration that is not finite.
    pub fn stress_intensity_factor(&self, penetration: f64) -> Result<f64, Refusal> {
        let depth = require_finite("penetration", penetration)?;
        require_finite("stress_intensity_factor", -self.contact_modulus * depth / (PI * self.punch_radius).sqrt())
    }

    /// The energy released per area if the rim recedes at fixed penetration, K²/(2E*); zero under compression.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a penetration that is not finite.
    pub fn energy_release_rate(&self, penetration: f64) -> Result<f64, Refusal> {
        let opening = (-require_finite("penetration", penetration)?).max(0.0);
        require_finite("energy_release_rate", self.contact_modulus * opening / (2.0 * PI * self.punch_radius) * opening)
    }

    /// The pressure (Pa) under the face at a penetration (m) and a distance `radius` (m) from the axis (negative under a pull); zero beyond the rim.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] at the rim itself, where it is infinite, and for a negative distance.
    pub fn pressure(&self, penetration: f64, radius: f64) -> Result<f64, Refusal> {
        let r = require_non_negative("radius", radius)?;
        let a = self.punch_radius;
        let depth = require_finite("penetration", penetration)?;
        if r < a {
            require_finite("pressure", self.contact_modulus * depth / (PI * (a - r).sqrt() * (a + r).sqrt()))
        } else if r > a {
            Ok(0.0)
        } else {
            Err(Refusal::out_of_range("radius", r, "other than the punch radius, where the pressure is infinite"))
        }
    }
}
