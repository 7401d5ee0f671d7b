//! Full contact.

use super::problem::SlidingProblem;
use super::solution::{FullContact, SlidingOutcome, SlidingWork};
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::edge_balance::SlidingControl;

pub(super) fn full_contact(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    limit_name: &'static str,
    limit: f64,
    work: SlidingWork,
) -> Result<SlidingOutcome, Refusal> {
    let mean_pressure = match problem.control {
        SlidingControl::MeanPressure(pressure) => Some(pressure),
        _ => None,
    };
    let friction_stress = full_contact_friction(material, problem.rate)?;
    let relaxed = material.solid_modulus("the pressure of a full contact in units of E0")?;
    let rounding = (4.0 + material.relaxation_terms().len() as f64) * f64::EPSILON;
    let storage = Estimate::relative(material.complex_modulus(problem.rate)?.storage / relaxed, rounding);
    Ok(SlidingOutcome::Full(FullContact {
        mean_pressure,
        friction_stress,
        friction_coefficient: mean_pressure.filter(|&pressure| pressure > 0.0).map(|pressure| friction_stress.scaled(1.0 / pressure)),
        pressure_waves: [storage, friction_stress.scaled(2.0)],
        limit_name,
        limit,
        work,
    }))
}

/// The friction stress of full contact, ½ Im E(kv)/E0, in E0*k²Λ²/2: half the loss of the first harmonic, whatever the adhesion.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative rate; [`Refusal::Undefined`] for a viscous material.
pub fn full_contact_friction(material: &PlaneMaterial, rate: f64) -> Result<Estimate, Refusal> {
    let relaxed = material.solid_modulus("the friction of a full contact in units of E0")?;
    if rate == 0.0 {
        return Ok(Estimate::exact(0.0));
    }
    // A sum of positive terms, each good to a few ulp.
    let terms = material.relaxation_terms().len() as f64;
    Ok(Estimate::relative(0.5 * material.complex_modulus(rate)?.loss / relaxed, (4.0 + terms) * f64::EPSILON))
}
