//! The elastic reference contact of a sliding wave: the contact of an elastic solid as stiff as the viscoelastic one is at the frequency of the wave.
//!
//! ```text
//! modulus |E*(ω)|, ω = kv         the frequency at which the first harmonic of the wave shakes the solid (thesis Sec 3.7 and Fig 3.14c, ω = ζ/τ)
//! ```
//! The same works of adhesion and process zones, and the same load, penetration or half-width. In units of its own modulus m = |E*(kv)|/E0* its groups are Γ/m and
//! p̄/m; everything is given back in those of E0. It has all of the stiffening of the bulk and none of the losses at the edges: what the viscoelastic contact carries
//! more than it is due to these. A single parabola has no wave number, and no such reference.

use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::branch::{BranchPath, BranchProblem, Strength, strength};
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use crate::sliding::steady::{SlidingOutcome, SlidingProblem, steady_sliding};

/// The elastic reference of a contact or of its strength, with its modulus.
#[derive(Debug, Clone)]
pub struct ElasticReference<T> {
    /// m = |E*(kv)|/E0.
    pub modulus: Estimate,
    /// What it is, in units of its own modulus: pressures and energies times m are those of E0.
    pub found: T,
}

/// m = |E*(kv)|/E0 of a wave.
///
/// # Errors
/// [`Refusal::Undefined`] for a parabola and for a viscous solid; [`Refusal::OutOfRange`] for a negative rate.
pub fn elastic_reference_modulus(material: &PlaneMaterial, indenter: Indenter, rate: f64) -> Result<Estimate, Refusal> {
    if indenter == Indenter::Parabola {
        return Err(Refusal::Undefined {
            quantity: "the elastic reference contact of a cylinder",
            reason: "its modulus is |E(ω)| at ω = kv, and a single cylinder has no wave number".into(),
        });
    }
    let relaxed = material.solid_modulus("an elastic reference contact")?;
    let terms = material.relaxation_terms().len() as f64;
    Ok(Estimate::relative(material.complex_modulus(rate)?.magnitude() / relaxed, (6.0 + terms) * f64::EPSILON))
}

/// The same adhesion in units of a stiffer solid.
fn softened(adhesion: WaveAdhesion, modulus: f64) -> WaveAdhesion {
    adhesion.with_works_times([1.0 / modulus; 2])
}

/// The elastic reference contact of a steady contact.
///
/// # Errors
/// Those of [`elastic_reference_modulus`] and of [`steady_sliding`]; limits are in units of E0 again.
pub fn elastic_reference_contact(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
) -> Result<ElasticReference<SlidingOutcome>, Refusal> {
    let modulus = elastic_reference_modulus(material, problem.indenter, problem.rate)?;
    let control = match problem.control {
        SlidingControl::MeanPressure(pressure) => SlidingControl::MeanPressure(pressure / modulus.value),
        other => other,
    };
    let reference = SlidingProblem {
        adhesion: problem.adhesion.map(|adhesion| softened(adhesion, modulus.value)),
        work_by_speed: None,
        control,
        ..*problem
    };
    Ok(ElasticReference { modulus, found: steady_sliding(&PlaneMaterial::elastic(1.0)?, &reference)? })
}

/// What the elastic reference contact carries.
///
/// # Errors
/// [`Refusal::Undefined`] if the branch is not one of loads; those of [`elastic_reference_modulus`] and of the branch.
pub fn elastic_reference_strength(material: &PlaneMaterial, problem: &BranchProblem<'_>) -> Result<ElasticReference<Strength>, Refusal> {
    if problem.path != BranchPath::Loads {
        return Err(Refusal::Undefined {
            quantity: "the strength of an elastic reference contact",
            reason: "the branch is not one of loads".into(),
        });
    }
    let modulus = elastic_reference_modulus(material, problem.indenter, problem.rate)?;
    let reference = BranchProblem { adhesion: softened(problem.adhesion, modulus.value), work_by_speed: None, ..*problem };
    Ok(ElasticReference { modulus, found: strength(&PlaneMaterial::elastic(1.0)?, &reference)? })
}
