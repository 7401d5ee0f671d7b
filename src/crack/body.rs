//! Which faces of the crack deform.

use serde::{Deserialize, Serialize};

/// One deformable half-body against a rigid one, or two equal deformable halves.
///
/// Two halves release twice the energy at the same stress intensity: G = K²/E* instead of K²/(2E*), and the gap between the faces is
/// twice the displacement of one. The work of adhesion is that of the whole interface in both cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CrackBody {
    /// A deformable half-body on a rigid one: an interface crack, a contact edge. G = K²/(2E*).
    AgainstRigid,
    /// A crack inside one material, a sheet torn apart. G = K²/E*.
    TwoHalves,
}

impl CrackBody {
    /// How many halves deform: 1 or 2.
    #[must_use]
    pub const fn deformable_halves(self) -> f64 {
        match self {
            Self::AgainstRigid => 1.0,
            Self::TwoHalves => 2.0,
        }
    }

    /// The square of the intensity that belongs to a drive D: K² = 2Δγ D/halves of an opening crack (D in Pa), (K₁/E0)² of a closing
    /// one (D in 1/Pa).
    #[must_use]
    pub fn intensity_squared(self, work_of_adhesion: f64, drive: f64) -> f64 {
        2.0 * work_of_adhesion * drive / self.deformable_halves()
    }

    /// The drive D (a number) that belongs to a squared intensity (Pa² m) and a work of adhesion (J/m²): the inverse of [`CrackBody::intensity_squared`].
    #[must_use]
    pub fn drive(self, work_of_adhesion: f64, intensity: f64) -> f64 {
        0.5 * self.deformable_halves() * intensity * (intensity / work_of_adhesion)
    }
}
