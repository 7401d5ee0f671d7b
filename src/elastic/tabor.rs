//! The Tabor number of a sphere: may the range of adhesion be taken as zero?
//!
//! ```text
//!     DMT                     transition                    JKR
//!     hard, small, long range                soft, large, short range
//!   ------------------|--------------------------|----------------> μ
//!                    0.1                         3
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | R | `sphere_radius` | m |
//! | E* | `contact_modulus` | Pa |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | ε | `interaction_range`: equilibrium distance of the interface potential | m |
//! | μ | the Tabor number | – |
//!
//! Equation: μ = (RΔγ²/(E*²ε³))^{1/3}: the height of the neck at pull-off in units of ε, but for a factor near one.
//! Source: Tabor, J. Colloid Interface Sci. 58 (1977) 2; with E* in Greenwood, Proc. R. Soc. A 453 (1997) 1277,
//! [10.1098/rspa.1997.0070](https://doi.org/10.1098/rspa.1997.0070). Thesis Sec 1.3.1 prints E for E*.
//!
//! Bounds: the thesis gives μ ≫ 1 for JKR, μ ≪ 1 for DMT, and quotes Greenwood that JKR is exact for μ ≫ 3. There is no sharp line:
//! [`JKR_ABOVE`] is that 3, [`DMT_BELOW`] = 0.1 is this crate's reading of "μ ≪ 1" (one decade). Both are labels for a report,
//! nothing is switched by them.
//!
//! Range: elastic sphere. For a viscoelastic one E* lies between its relaxed and glassy value, and so does μ: ask at both ends.
//! Relative error below 1e-15.

use crate::refusal::{Refusal, require_finite, require_positive};
use std::f64::consts::PI;

/// Above this Tabor number a zero range of adhesion (JKR) is called fair: the 3 that the thesis quotes from Greenwood.
pub const JKR_ABOVE: f64 = 3.0;

/// Below this Tabor number the deformation by adhesion is called negligible (DMT): our reading of the source's "much less than one".
pub const DMT_BELOW: f64 = 0.1;

/// The Tabor number of a sphere of given material and size.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct TaborNumber {
    value: f64,
}

/// Which limit theory a Tabor number speaks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AdhesionRegime {
    /// Stiff and small: adhesion acts outside an undisturbed Hertz contact; pull-off force 2πRΔγ.
    DerjaguinMullerToporov,
    /// Between the two: the pull-off force lies between (3/2)πRΔγ and 2πRΔγ and needs the law of interaction.
    Transition,
    /// Soft and large: adhesion acts at the edge of the contact; pull-off force (3/2)πRΔγ.
    JohnsonKendallRoberts,
}

impl TaborNumber {
    /// The Tabor number from the sphere, the material and the range of the interaction.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an argument that is not finite and positive, or a number outside the range of doubles.
    pub fn new(sphere_radius: f64, contact_modulus: f64, work_of_adhesion: f64, interaction_range: f64) -> Result<Self, Refusal> {
        let radius = require_positive("sphere_radius", sphere_radius)?;
        let modulus = require_positive("contact_modulus", contact_modulus)?;
        let work = require_positive("work_of_adhesion", work_of_adhesion)?;
        let range = require_positive("interaction_range", interaction_range)?;
        // Grouped as pure numbers, so that no factor overflows in any sane unit system.
        let strain = work / (modulus * range);
        Ok(Self { value: require_positive("tabor_number", (strain * strain * (radius / range)).cbrt())? })
    }

    /// The number itself.
    #[must_use]
    pub const fn value(self) -> f64 {
        self.value
    }

    /// The limit theory that applies, by [`DMT_BELOW`] and [`JKR_ABOVE`].
    #[must_use]
    pub fn regime(self) -> AdhesionRegime {
        if self.value > JKR_ABOVE {
            AdhesionRegime::JohnsonKendallRoberts
        } else if self.value < DMT_BELOW {
            AdhesionRegime::DerjaguinMullerToporov
        } else {
            AdhesionRegime::Transition
        }
    }
}

/// The pull-off force of a rigid sphere, 2πRΔγ (Bradley, DMT): the other end of the transition from [`crate::elastic::JkrSphere`].
///
/// # Errors
/// [`Refusal::OutOfRange`] for an argument that is not finite and positive.
pub fn rigid_pull_off_force(sphere_radius: f64, work_of_adhesion: f64) -> Result<f64, Refusal> {
    let radius = require_positive("sphere_radius", sphere_radius)?;
    require_finite("pull_off_force", 2.0 * PI * radius * require_positive("work_of_adhesion", work_of_adhesion)?)
}
