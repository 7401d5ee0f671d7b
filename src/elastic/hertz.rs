//! A rigid sphere pressed into an elastic half-space without adhesion.
//!
//! ```text
//!                 | F
//!             ,---v---.
//!            /    R    \
//!      _____ \_       _/ _____     surface
//!            \ `--.--' /      Δ
//!             `---+---'  <-- rises to meet the sphere at r = a
//!              |<-a->|
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | R | `sphere_radius` | m |
//! | E* | `contact_modulus` of the half-space, E/(1 − ν²) | Pa |
//! | a | `contact_radius` | m |
//! | Δ | `penetration` of the sphere's lowest point below the undeformed surface | m |
//! | F | `force`, compression positive | N |
//! | p | `pressure` | Pa |
//!
//! Equations: Δ = a²/R, F = (4/3)E*a³/R, p(r) = (2E*/πR)√(a² − r²), stored energy (2/5)FΔ.
//! Source: Johnson, *Contact Mechanics* (1985), Sec 4.2; thesis Sec 1.3 (the case p₀ = 0 of its Eq 1.28).
//!
//! Range: a ≪ R (the sphere is replaced by its parabola; the profile is wrong by a²/(4R²) of itself at the edge), small strains,
//! frictionless contact. Relative error of every member: below 1e-15, no delicate limit.

use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use std::f64::consts::PI;

/// A rigid sphere on an elastic half-space, no adhesion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzSphere {
    sphere_radius: f64,
    contact_modulus: f64,
}

/// One equilibrium of [`HertzSphere`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzState {
    /// Radius of the contact circle (m).
    pub contact_radius: f64,
    /// Displacement of the sphere into the half-space (m).
    pub penetration: f64,
    /// Compressive force (N).
    pub force: f64,
}

impl HertzSphere {
    /// A sphere of radius `sphere_radius` (m) on a half-space of contact modulus `contact_modulus` (E* in Pa).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an argument that is not finite and positive.
    pub fn new(sphere_radius: f64, contact_modulus: f64) -> Result<Self, Refusal> {
        Ok(Self {
            sphere_radius: require_positive("sphere_radius", sphere_radius)?,
            contact_modulus: require_positive("contact_modulus", contact_modulus)?,
        })
    }

    /// The state with a given contact radius (m).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius, or one so large that the force leaves the range of doubles.
    pub fn state_by_contact_radius(&self, contact_radius: f64) -> Result<HertzState, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let penetration = require_finite("penetration", a / self.sphere_radius * a)?;
        let force = require_finite("force", 4.0 / 3.0 * self.contact_modulus * a * penetration)?;
        Ok(HertzState { contact_radius: a, penetration, force })
    }

    /// The state under a given compressive force (N).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative force: without adhesion nothing pulls back.
    pub fn state_by_force(&self, force: f64) -> Result<HertzState, Refusal> {
        let force = require_non_negative("force", force)?;
        let a = (0.75 * force / self.contact_modulus * self.sphere_radius).cbrt();
        Ok(HertzState { force, ..self.state_by_contact_radius(a)? })
    }

    /// The state at a given penetration.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative penetration: the sphere is then out of contact.
    pub fn state_by_penetration(&self, penetration: f64) -> Result<HertzState, Refusal> {
        let penetration = require_non_negative("penetration", penetration)?;
        let a = self.sphere_radius.sqrt() * penetration.sqrt();
        Ok(HertzState { penetration, ..self.state_by_contact_radius(a)? })
    }

    /// The pressure (Pa) at a distance `radius` (m) from the axis; zero outside the contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative contact radius or distance.
    pub fn pressure(&self, contact_radius: f64, radius: f64) -> Result<f64, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let r = require_non_negative("radius", radius)?;
        if r >= a {
            return Ok(0.0);
        }
        require_finite("pressure", 2.0 / PI * self.contact_modulus * ((a - r).sqrt() * (a + r).sqrt() / self.sphere_radius))
    }

    /// The elastic energy stored in the half-space (J), (2/5)FΔ.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative contact radius.
    pub fn strain_energy(&self, contact_radius: f64) -> Result<f64, Refusal> {
        let state = self.state_by_contact_radius(contact_radius)?;
        require_finite("strain_energy", 0.4 * state.force * state.penetration)
    }
}
