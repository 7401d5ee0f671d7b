//! What grows: material, interface, and one length of the process zone for the whole history.

use crate::crack::process_zone::{Interface, ProcessZone};
use crate::material::Material;
use crate::refusal::{Refusal, require_non_negative, require_positive};

/// A crack that can grow under a load history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthProblem<'a> {
    pub(crate) material: &'a Material,
    pub(crate) interface: Interface,
    pub(crate) process_zone: f64,
}

impl<'a> GrowthProblem<'a> {
    /// A crack in a plane material. A growing zone gets the length α(K/(√(2π)σ_c))² at `reference_intensity` (thesis Eq 5.69: the
    /// constant load; [`super::LoadHistory::peak`] is the safe choice for others); a constant length needs none and ignores it.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not positive and finite; [`Refusal::Undefined`] for a law of closing cracks.
    pub fn new(material: &'a Material, interface: Interface, reference_intensity: f64) -> Result<Self, Refusal> {
        let interface = interface.checked()?;
        let length = match interface.process_zone {
            ProcessZone::Constant { length } => length,
            ProcessZone::Growing { cohesive_stress, factor } => {
                growing_zone(require_non_negative("reference_intensity", reference_intensity)?, cohesive_stress, factor)
            }
            ProcessZone::Schapery { .. } => {
                return Err(Refusal::Undefined {
                    quantity: "Schapery's closing zone length (5.43) of an opening crack",
                    reason: "it is the length of a healing zone; name a length or a growing zone instead".into(),
                });
            }
        };
        Ok(Self { material, interface, process_zone: require_positive("process_zone", length)? })
    }

    /// The material of the deformable halves.
    #[must_use]
    pub const fn material(&self) -> &Material {
        self.material
    }

    /// δ (m).
    #[must_use]
    pub const fn process_zone(&self) -> f64 {
        self.process_zone
    }

    /// The interface, with the constant process zone of the history: what the steady theory at the same load takes.
    #[must_use]
    pub const fn interface(&self) -> Interface {
        Interface { process_zone: ProcessZone::Constant { length: self.process_zone }, ..self.interface }
    }

    /// √(2ΔγE∞/c) (Pa √m): from this load on the crack grows at once and without bound.
    #[must_use]
    pub fn glassy_limit(&self) -> f64 {
        self.limit(self.material.glassy_modulus())
    }

    /// √(2ΔγE0/c) (Pa √m): up to this constant load the crack never grows. Zero for a viscous material.
    #[must_use]
    pub fn relaxed_limit(&self) -> f64 {
        self.limit(self.material.relaxed_modulus())
    }

    fn limit(&self, modulus: f64) -> f64 {
        (2.0 * self.interface.work_of_adhesion / self.interface.body.deformable_halves()).sqrt() * modulus.sqrt()
    }
}

/// α(K/(√(2π)σ_c))² (m).
#[must_use]
pub fn growing_zone(intensity: f64, cohesive_stress: f64, factor: f64) -> f64 {
    let ratio = intensity / cohesive_stress;
    factor * ratio * ratio / std::f64::consts::TAU
}
