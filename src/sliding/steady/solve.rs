//! Solving a [`SlidingProblem`].
//!
//! A contact that grows continuously out of the slow one is taken where there is one; else the one that comes from the fast side; else, for a pull,
//! the one that an unloaded contact at this speed becomes; else, under a load above snap-in or past a fold where the contact was widening, full contact, in closed form;
//! else, where paths lead to no contact that can exist, the one without adhesion if that is too faint to be felt ([`super::faint`]), or what [`super::elsewhere`] finds.

use super::accuracy::solved;
use super::elsewhere::elsewhere;
use super::faint::without_faint_adhesion;
use super::path::{From, NoStart, PathEnd, Start, start_at_rate, start_by_pulling};
use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{FullContact, PartialContact, SlidingOutcome, SlidingWork};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::SlidingControl;

/// The steady contact of a material on a sliding indenter.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NoSuchState`] below pull-off, past a fold where the contact
/// was narrowing, and where an edge would be pressed or the faces would meet; [`Refusal::NotConverged`] is a defect.
pub fn steady_sliding(material: &Material, problem: &SlidingProblem<'_>) -> Result<SlidingOutcome, Refusal> {
    problem.checked()?;
    let prepared = Prepared::new(material, problem.rate, problem.indenter, problem.adhesion)?;
    let mut work = SlidingWork::default();
    let by_paths = by_paths(material, problem, &prepared, &mut work);
    let told = match &by_paths {
        Ok(SlidingOutcome::Partial(contact)) => contact.certificate.accuracy <= problem.accuracy,
        Err(Refusal::NotConverged { .. }) => false,
        _ => true,
    };
    if told {
        return by_paths;
    }
    if let Some(outcome) = without_faint_adhesion(material, problem, &mut work) {
        return Ok(outcome);
    }
    by_paths.or_else(|refusal| elsewhere(material, problem, &prepared, &mut work).unwrap_or(Err(refusal)))
}

/// The same by paths alone, for the starts of branches: a contact that cannot exist at the end of a path is [`Refusal::NotConverged`].
///
/// # Errors
/// As [`steady_sliding`].
pub(in crate::sliding) fn steady_by_paths(material: &Material, problem: &SlidingProblem<'_>) -> Result<SlidingOutcome, Refusal> {
    problem.checked()?;
    let prepared = Prepared::new(material, problem.rate, problem.indenter, problem.adhesion)?;
    by_paths(material, problem, &prepared, &mut SlidingWork::default())
}

pub(super) fn by_paths(
    material: &Material,
    problem: &SlidingProblem<'_>,
    prepared: &Prepared,
    work: &mut SlidingWork,
) -> Result<SlidingOutcome, Refusal> {
    let mut not_converged = None;
    let mut finish = |start: &Start, work: &mut SlidingWork| match solved(prepared, problem, start, work) {
        Ok(contact) => Some(SlidingOutcome::Partial(Box::new(contact))),
        Err(refusal) => {
            not_converged = Some(refusal);
            None
        }
    };
    let slow = match start_at_rate(material, problem, From::Slow, work) {
        Ok(start) => {
            if let Some(outcome) = finish(&start, work) {
                return Ok(outcome);
            }
            None
        }
        Err(NoStart::Elastic(refusal @ (Refusal::OutOfRange { .. } | Refusal::Undefined { .. }))) => return Err(refusal),
        Err(none) => Some(none),
    };
    let remembers = !material.is_elastic() && problem.rate > 0.0;
    if remembers
        && let Ok(start) = start_at_rate(material, problem, From::Fast, work)
        && let Some(outcome) = finish(&start, work)
    {
        return Ok(outcome);
    }
    if remembers
        && problem.adhesion.is_some()
        && let SlidingControl::MeanPressure(pressure) = problem.control
        && pressure < 0.0
    {
        match start_by_pulling(material, problem, work) {
            Ok(start) => {
                if let Some(outcome) = finish(&start, work) {
                    return Ok(outcome);
                }
            }
            Err(NoStart::Fold(PathEnd { last, .. })) if last < 0.0 => {
                return Err(Refusal::NoSuchState {
                    reason: "the load pulls harder than a contact at this speed can hold".into(),
                    limit_name: "last mean pressure held",
                    limit: last,
                });
            }
            Err(_) => {}
        }
    }
    match (slow, not_converged) {
        (Some(NoStart::Elastic(Refusal::NoSuchState { limit_name, limit, .. })), _) if may_fill(problem, limit) => {
            full_contact(material, problem, limit_name, limit, *work)
        }
        (Some(NoStart::Fold(PathEnd { last, widening: true })), _)
            if problem.indenter == Indenter::Wave && matches!(problem.control, SlidingControl::MeanPressure(_)) =>
        {
            full_contact(material, problem, "fold: rate kv (1/s) up to which the contact grows out of the slow one", last, *work)
        }
        (Some(NoStart::Elastic(refusal)), _) => Err(refusal),
        (Some(NoStart::Fold(PathEnd { last, .. })), _) => Err(Refusal::NoSuchState {
            reason: "the contact that grows out of the slow one ends at a fold before this speed, and none comes from the fast side".into(),
            limit_name: "rate kv (1/s)",
            limit: last,
        }),
        (None, Some(refusal)) => Err(refusal),
        (None, None) => Err(Refusal::NotConverged { what: "a sliding contact", detail: "no path was followed".into() }),
    }
}

/// The steady contact near another one of the same control, without a path.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NotConverged`] if no admissible contact is near.
pub fn steady_sliding_near(material: &Material, problem: &SlidingProblem<'_>, start: &Start) -> Result<PartialContact, Refusal> {
    let prepared = Prepared::new(material, problem.rate, problem.indenter, problem.adhesion)?;
    near_counted(&prepared, problem, start, &mut SlidingWork::default())
}

/// The same from conditions that are prepared, adding to `work` whether there is a contact or not.
pub(in crate::sliding) fn near_counted(
    prepared: &Prepared,
    problem: &SlidingProblem<'_>,
    start: &Start,
    work: &mut SlidingWork,
) -> Result<PartialContact, Refusal> {
    problem.checked()?;
    solved(prepared, problem, start, work)
}

/// Whether the limit that an elastic contact has passed is snap-in or full contact.
fn may_fill(problem: &SlidingProblem<'_>, limit: f64) -> bool {
    let asked = match problem.control {
        SlidingControl::MeanPressure(pressure) => pressure,
        SlidingControl::Penetration(penetration) => penetration,
        SlidingControl::HalfWidth(_) => return false,
    };
    problem.indenter == Indenter::Wave && asked >= limit
}

pub(super) fn full_contact(
    material: &Material,
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
    Ok(SlidingOutcome::Full(FullContact {
        mean_pressure,
        friction_stress,
        friction_coefficient: mean_pressure.filter(|&pressure| pressure > 0.0).map(|pressure| friction_stress.scaled(1.0 / pressure)),
        limit_name,
        limit,
        work,
    }))
}

/// The friction stress of full contact, ½ Im E(kv)/E0, in E0*k²Λ²/2: half the loss of the first harmonic, whatever the adhesion.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative rate; [`Refusal::Undefined`] for a viscous material.
pub fn full_contact_friction(material: &Material, rate: f64) -> Result<Estimate, Refusal> {
    let relaxed = material.solid_modulus("the friction of a full contact in units of E0")?;
    if rate == 0.0 {
        return Ok(Estimate::exact(0.0));
    }
    // A sum of positive terms, each good to a few ulp.
    let terms = material.relaxation_terms().len() as f64;
    Ok(Estimate::relative(0.5 * material.complex_modulus(rate)?.loss / relaxed, (4.0 + terms) * f64::EPSILON))
}
