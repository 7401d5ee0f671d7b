//! Solving a [`SlidingProblem`].

use super::problem::{SlidingControl, SlidingProblem};
use super::solution::{AdhesiveValues, FullContact, PartialContact, PartialValues, SlidingCertificate, SlidingOutcome, SlidingWork};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactState, Indenter, Prescribed};
use crate::sliding::speed_path::{adhesive_contact, adhesiveless_contact, full_contact_friction};

/// The steady contact of a material on a sliding indenter.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NoSuchState`] below pull-off.
pub fn steady_sliding(material: &Material, problem: &SlidingProblem) -> Result<SlidingOutcome, Refusal> {
    problem.checked()?;
    let prescribed = match problem.control {
        SlidingControl::MeanPressure(pressure) => Prescribed::MeanPressure(pressure),
        SlidingControl::Penetration(penetration) => Prescribed::Penetration(penetration),
        SlidingControl::HalfWidth(_) => {
            return Err(Refusal::NotConverged { what: "half-width control", detail: "not built yet".into() });
        }
    };
    if problem.indenter == Indenter::Parabola {
        return Err(Refusal::NotConverged { what: "a parabola", detail: "not built yet".into() });
    }
    let estimate = |value: f64| Estimate::new(value, 1e-8 * value.abs().max(1.0));
    let found = match problem.adhesion {
        Some(adhesion) => adhesive_contact(material, problem.rate, &adhesion, prescribed, 1e-8).map(|path| {
            let values = AdhesiveValues {
                trailing_release: estimate(path.contact.trailing_release),
                leading_release: estimate(path.contact.leading_release),
                trailing_nonconservative: estimate(1.0 - path.contact.trailing_release),
                leading_nonconservative: estimate(1.0 - path.contact.leading_release),
                adhesive_friction_stress: estimate(adhesion.reduced_work * (path.contact.trailing_release - path.contact.leading_release)),
            };
            (path.contact.state, Some(values), path.steps, path.evaluations)
        }),
        None => adhesiveless_contact(material, problem.rate, prescribed, 1e-8)
            .map(|path| (path.contact.state, None, path.steps, path.evaluations)),
    };
    match (found, problem.control) {
        (Ok((state, adhesion, steps, evaluations)), _) => {
            Ok(SlidingOutcome::Partial(Box::new(partial(state, adhesion, steps, evaluations, estimate))))
        }
        (Err(Refusal::NoSuchState { limit_name, limit, .. }), SlidingControl::MeanPressure(pressure)) if pressure > limit => {
            let friction = Estimate::relative(full_contact_friction(material, problem.rate)?, 1e-14);
            Ok(SlidingOutcome::Full(FullContact {
                mean_pressure: Some(pressure),
                friction_stress: friction,
                friction_coefficient: (pressure > 0.0).then(|| friction.scaled(1.0 / pressure)),
                limit_name,
                limit,
            }))
        }
        (Err(refusal), _) => Err(refusal),
    }
}

fn partial(
    state: ContactState,
    adhesion: Option<AdhesiveValues>,
    steps: u32,
    evaluations: u32,
    estimate: impl Fn(f64) -> Estimate,
) -> PartialContact {
    let contact = state.contact();
    PartialContact {
        values: PartialValues {
            half_width: estimate(contact.half_width),
            eccentricity: estimate(contact.eccentricity),
            trailing_edge: estimate(contact.eccentricity - contact.half_width),
            leading_edge: estimate(contact.eccentricity + contact.half_width),
            penetration: estimate(state.penetration()),
            mean_pressure: estimate(state.mean_pressure()),
            friction_stress: estimate(state.friction_stress()),
            friction_coefficient: (state.mean_pressure() > 0.0).then(|| estimate(state.friction_stress() / state.mean_pressure())),
            interface_work: estimate(state.interface_work()),
            adhesion,
        },
        certificate: SlidingCertificate { residual: 1e-8, condition: state.condition(), admissible: true, accuracy: 1e-8 },
        work: SlidingWork {
            contacts: 3 * u64::from(evaluations),
            closure_evaluations: u64::from(evaluations),
            path_steps: u64::from(steps),
        },
        state,
    }
}
