//! A long crack along the middle of a strip: the stress intensity factor from the remote stress.
//!
//! ```text
//!    //////////////// rigid grip ////////////////      ^ σ
//!    |                                          |   h
//!    |_________________                         |  ---  crack at mid-height, strip of height 2h
//!    |      crack      `- - - - - - - - - - - - |
//!    |                                          |   h
//!    //////////////// rigid grip ////////////////      v σ
//!      relaxed behind          uniform ahead: W
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | h | `half_height` of the strip | m |
//! | σ | `stress` far ahead of the tip, across the crack plane | Pa |
//! | E, ν | Young's modulus, Poisson ratio | Pa, – |
//! | W | energy density far ahead, ½σ²c_W/E | J/m³ |
//! | c_W | 1D compliance far ahead in units of 1/E (table below) | – |
//! | E* | plane modulus E/c_K: c_K = 1 in plane stress, 1 − ν² in plane strain | Pa |
//! | G | `energy_release_rate` of the whole strip, both halves | J/m² |
//! | K | `stress_intensity_factor` | Pa√m |
//!
//! # Derivation
//! Let the crack grow by one length with the grips fixed. Far behind the tip the two halves are stress-free, far ahead the strip is uniform; growth
//! turns one length of the second into one of the first and does no work at the grips. So G = 2h·W, both halves together. A crack in a
//! sheet releases G = K²/E* (each half, as one body against a rigid one, gives K²/(2E*), which is the thesis's h·W of Eq 5.49). Hence
//! K = σ√(h·c_W/c_K), without E.
//!
//! | far ahead | c_W | K |
//! |---|---|---|
//! | sideways free, plane stress | 1 | σ√h (thesis Eq 5.46) |
//! | sideways free, plane strain | 1 − ν² | σ√h |
//! | sideways held, plane stress | 1 − ν² | σ√(h(1 − ν²)) |
//! | sideways held, plane strain | (1 + ν)(1 − 2ν)/(1 − ν) | σ√(h(1 − ν′²)), ν′ = ν/(1 − ν), that is σ√(h(1 − 2ν))/(1 − ν) |
//!
//! "Sideways" is the direction of the crack. Grips that are rigid and long hold the strip sideways: that is the pure-shear test. The thesis speaks of a
//! uniaxial stress in this geometry, the first row, which is a strip of many ligaments, or ν = 0. The form in (1 − 2ν) is the one computed: 1 − ν′² would cancel.
//! At ν = 0.5 a strip held in plane strain can't change its volume, so it can't be stretched: σ stores no energy, no crack is driven, and the ratio K/σ
//! is refused as undefined. Just below, the strip is so stiff that Poisson's ratio must be known to a fraction of 1 − 2ν.
//!
//! Source: Rivlin & Thomas, J. Polym. Sci. 10 (1953) 291 for G = 2hW; the plane-strain held row: Rice, J. Appl. Mech. 34 (1967) 248.
//! Range: crack and uncracked ligament both longer than about 2h (the error decays exponentially with their length over h).
//! Relative error below 1e-15 for a given ν; the error of ν itself is amplified by ν/(1 − 2ν) in the held plane-strain row.

use super::plane_modulus::PlaneState;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_poisson_ratio, require_positive};

/// What happens along the crack far ahead of its tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SidewaysStrain {
    /// Free to contract: the thesis's uniaxial stress.
    Free,
    /// Held at zero by long rigid grips: the pure-shear test.
    Held,
}

/// A strip between rigid grips with a long crack at mid-height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PureShearStrip {
    half_height: f64,
    /// c_W of the module's table.
    remote_compliance: f64,
    /// c_W/c_K of the module's table.
    ratio: f64,
}

impl PureShearStrip {
    /// A strip of height 2·`half_height`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a height that is not positive or a Poisson ratio outside −1 < ν ≤ 0.5; [`Refusal::Undefined`] for an
    /// incompressible strip held sideways in plane strain.
    pub fn new(half_height: f64, sideways: SidewaysStrain, plane_state: PlaneState, poisson_ratio: f64) -> Result<Self, Refusal> {
        let half_height = require_positive("half_height", half_height)?;
        let nu = require_poisson_ratio(poisson_ratio)?;
        let plane = (1.0 - nu) * (1.0 + nu);
        let (remote_compliance, ratio) = match (sideways, plane_state) {
            (SidewaysStrain::Free, PlaneState::Stress) => (1.0, 1.0),
            (SidewaysStrain::Free, PlaneState::Strain) => (plane, 1.0),
            (SidewaysStrain::Held, PlaneState::Stress) => (plane, plane),
            (SidewaysStrain::Held, PlaneState::Strain) => {
                let volume = 1.0 - 2.0 * nu;
                if volume <= 0.0 {
                    return Err(Refusal::Undefined {
                        quantity: "the stress intensity factor of a held strip",
                        reason: "an incompressible strip held sideways in plane strain can't be stretched and stores no energy".to_owned(),
                    });
                }
                (((1.0 + nu) * volume) / (1.0 - nu), volume / ((1.0 - nu) * (1.0 - nu)))
            }
        };
        Ok(Self { half_height, remote_compliance, ratio })
    }

    /// The stress intensity factor under the remote stress `stress` (negative stress closes the crack and gives a negative factor).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a stress that is not finite.
    pub fn stress_intensity_factor(&self, stress: f64) -> Result<f64, Refusal> {
        require_finite("stress_intensity_factor", require_finite("stress", stress)? * (self.half_height * self.ratio).sqrt())
    }

    /// The remote stress that gives a stress intensity factor.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a factor that is not finite.
    pub fn stress(&self, stress_intensity_factor: f64) -> Result<f64, Refusal> {
        let factor = require_finite("stress_intensity_factor", stress_intensity_factor)?;
        require_finite("stress", factor / (self.half_height * self.ratio).sqrt())
    }

    /// The remote stress of an elastic strip whose grips move apart by 2·`grip_displacement`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus that is not positive or a displacement that is not finite.
    pub fn stress_by_grip_displacement(&self, grip_displacement: f64, youngs_modulus: f64) -> Result<f64, Refusal> {
        let modulus = require_positive("youngs_modulus", youngs_modulus)? / self.remote_compliance;
        require_finite("stress", modulus * (require_finite("grip_displacement", grip_displacement)? / self.half_height))
    }

    /// The energy release rate (J/m²) of an elastic strip under a stress (Pa), both halves together: 2h·W = K²/E*. Half of it belongs to one half-strip against a
    /// rigid base.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus that is not positive, or a stress that is not finite and tensile (or zero).
    pub fn energy_release_rate(&self, stress: f64, youngs_modulus: f64) -> Result<f64, Refusal> {
        let stress = require_non_negative("stress", stress)?;
        let modulus = require_positive("youngs_modulus", youngs_modulus)?;
        require_finite("energy_release_rate", self.half_height * stress * (stress / modulus) * self.remote_compliance)
    }
}
