//! What grows: material, interface, and the process zone: one length for the whole history, or one that follows the load.

use crate::crack::process_zone::{Interface, ProcessZone};
use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_non_negative, require_positive};

/// How the process zone of a history is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ZoneRule {
    /// One length (m) throughout.
    Constant(f64),
    /// α(K(t)/(√(2π)σ_c))² at the current load.
    Following { cohesive_stress: f64, factor: f64 },
}

/// A crack that can grow under a load history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthProblem<'a> {
    pub(crate) material: &'a PlaneMaterial,
    pub(crate) interface: Interface,
    pub(crate) zone: ZoneRule,
}

impl<'a> GrowthProblem<'a> {
    /// A crack in a plane material, with one length of the process zone for the whole history. A growing zone gets the length
    /// α(K/(√(2π)σ_c))² at `reference_intensity` (thesis Eq 5.69: the constant load); a constant length needs none and ignores it.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not positive and finite; [`Refusal::Undefined`] for a law of closing cracks.
    pub fn new(material: &'a PlaneMaterial, interface: Interface, reference_intensity: f64) -> Result<Self, Refusal> {
        let interface = interface.checked()?;
        let length = match interface.process_zone {
            ProcessZone::Constant { length } => length,
            ProcessZone::Growing { cohesive_stress, factor } => {
                growing_zone(require_non_negative("reference_intensity", reference_intensity)?, cohesive_stress, factor)
            }
            ProcessZone::Schapery { .. } => return Err(closes()),
        };
        Ok(Self { material, interface, zone: ZoneRule::Constant(require_positive("process_zone", length)?) })
    }

    /// A crack in a plane material whose process zone follows the load: δ(t) = α(K(t)/(√(2π)σ_c))². A constant length stays constant.
    ///
    /// # Errors
    /// As [`GrowthProblem::new`].
    pub fn following(material: &'a PlaneMaterial, interface: Interface) -> Result<Self, Refusal> {
        let interface = interface.checked()?;
        let zone = match interface.process_zone {
            ProcessZone::Constant { length } => ZoneRule::Constant(require_positive("process_zone", length)?),
            ProcessZone::Growing { cohesive_stress, factor } => ZoneRule::Following { cohesive_stress, factor },
            ProcessZone::Schapery { .. } => return Err(closes()),
        };
        Ok(Self { material, interface, zone })
    }

    /// The material of the deformable halves.
    #[must_use]
    pub const fn material(&self) -> &PlaneMaterial {
        self.material
    }

    /// δ (m) under a load K (Pa √m).
    #[must_use]
    pub fn process_zone_at(&self, intensity: f64) -> f64 {
        match self.zone {
            ZoneRule::Constant(length) => length,
            ZoneRule::Following { cohesive_stress, factor } => growing_zone(intensity, cohesive_stress, factor),
        }
    }

    /// Whether δ changes with the load.
    #[must_use]
    pub(crate) const fn follows_the_load(&self) -> bool {
        matches!(self.zone, ZoneRule::Following { .. })
    }

    /// The interface with the zone that it has under a constant load K: what the steady theory at the same load takes.
    #[must_use]
    pub(crate) fn interface_at(&self, intensity: f64) -> Interface {
        Interface { process_zone: ProcessZone::Constant { length: self.process_zone_at(intensity) }, ..self.interface }
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

fn closes() -> Refusal {
    Refusal::Undefined {
        quantity: "Schapery's closing zone length (5.43) of an opening crack",
        reason: "it is the length of a healing zone; name a length or a growing zone instead".into(),
    }
}

/// α(K/(√(2π)σ_c))² (m).
#[must_use]
pub fn growing_zone(intensity: f64, cohesive_stress: f64, factor: f64) -> f64 {
    let ratio = intensity / cohesive_stress;
    factor * ratio * ratio / std::f64::consts::TAU
}
