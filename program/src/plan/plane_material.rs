//! The plane material of a contact: that of the viscoelastic body, or of it and an elastic one that press each other.

use crate::scene::typed::{ElasticBody, Scene};
use viscotack::elastic::PlaneState;
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;

/// The material in moduli E* = E/(1 − ν²); with a second body its creep function is larger by the compliance of that body at every time.
///
/// Under one pressure the displacements of both surfaces add, so this is exact for half-spaces: 1/E* sums.
pub(super) fn plane_material(scene: &Scene, second: Option<ElasticBody>) -> Result<PlaneMaterial, Refusal> {
    let plane = scene.material.plane_series(scene.units, PlaneState::Strain)?;
    let Some(body) = second else { return Ok(plane) };
    let compliance = 1.0 / PlaneState::Strain.modulus(body.modulus, body.poisson_ratio)?;
    PlaneMaterial::from_creep(1.0 / (1.0 / plane.glassy_modulus() + compliance), plane.creep_terms(), plane.steady_viscosity())
}

/// A liquid whose flow t/η is that of an element of a long retardation time: (T/η)(1 − e^{−t/T}), less by a part t/2T. A solid is returned as it is.
///
/// # Errors
/// What making a material refuses.
pub(super) fn flow_as_element(material: &PlaneMaterial, time: f64) -> Result<PlaneMaterial, Refusal> {
    let Some(viscosity) = material.steady_viscosity() else { return Ok(material.clone()) };
    let mut terms = material.creep_terms().to_vec();
    terms.push(CreepTerm { compliance: time / viscosity, retardation_time: time });
    PlaneMaterial::from_creep(material.glassy_modulus(), &terms, None)
}
