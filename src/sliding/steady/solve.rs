//! A steady sliding contact: the one that what is held leads to, full contact, or the reason why there is neither.
//!
//! The equilibrium curve of the speed ([`crate::sliding::equilibrium`]) knows every contact of a load or penetration and which of them are stable. Of several stable
//! ones the narrowest is reached by a load that is raised from nothing, the widest by one that is lowered ([`ReachedBy`]). Where there is none, [`super::limits`] tells
//! what was passed. Of a given half-width the contact of the smallest eccentricity is the one.

use super::accuracy::solved;
use super::full::full_contact;
use super::limits::{closing_pressure, size_of};
use super::negligible::{may_be_negligible, without_negligible_adhesion};
use super::nothing::Nothing;
use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{ContactStability, PartialContact, SlidingOutcome, SlidingWork};
use super::start::Start;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::branch::{SecondVariations, Stability};
use crate::sliding::contact::{Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::equilibrium::{Crossing, HeldQuantity, half_widths};
use std::f64::consts::PI;

/// The resolution of second variations: signs are known to five digits.
const VARIATIONS: Resolution = Resolution::Medium;
/// Half gaps below this need every digit for the signs of second variations.
const NARROW: f64 = 0.2;
/// Largest distance of a contact from where the curve crosses what is held, over the contact or gap.
const FARTHEST: f64 = 0.05;

/// How what is held was reached, at the speed of the problem: which one of several stable contacts is meant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum ReachedBy {
    /// Raised from nothing: the narrowest.
    #[default]
    Loading,
    /// Lowered from the widest partial contact: the widest.
    Unloading,
}

/// The steady contact of a material on a sliding indenter, reached by loading.
///
/// # Errors
/// As [`steady_sliding_reached_by`].
pub fn steady_sliding(material: &PlaneMaterial, problem: &SlidingProblem<'_>) -> Result<SlidingOutcome, Refusal> {
    steady_sliding_reached_by(material, problem, ReachedBy::Loading)
}

/// The steady contact of a material on a sliding indenter.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NoSuchState`] below pull-off, and where an edge would be pressed or the faces would
/// meet; [`Refusal::NotConverged`] is a defect.
pub fn steady_sliding_reached_by(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    reached_by: ReachedBy,
) -> Result<SlidingOutcome, Refusal> {
    problem.checked()?;
    let prepared = Prepared::shared(material, problem.rate, problem.indenter, problem.adhesion)?;
    let mut work = SlidingWork::default();
    let found = searched(material, problem, &prepared, reached_by, &mut work).and_then(|searched| match searched {
        Searched::Outcome(outcome) => Ok(outcome),
        Searched::Nothing(nothing) => nothing.explained(material, problem, &prepared, &mut work),
    });
    let settled = match &found {
        Ok(SlidingOutcome::Partial(contact)) => contact.certificate.accuracy <= problem.accuracy,
        Ok(SlidingOutcome::Full(_)) => problem.adhesion.is_none_or(|adhesion| !may_be_negligible(material, adhesion)),
        Err(Refusal::OutOfRange { .. } | Refusal::Undefined { .. }) => true,
        Err(_) => false,
    };
    if settled {
        return found;
    }
    let has_edges = matches!(found, Ok(SlidingOutcome::Partial(_)));
    without_negligible_adhesion(has_edges, material, problem, &mut work).map_or(found, Ok)
}

/// What the equilibrium curve has of what is held.
enum Searched {
    /// A contact, or full contact without adhesion.
    Outcome(SlidingOutcome),
    /// No contact.
    Nothing(Nothing),
}

/// The contact of a problem, without a word on why there is none: that would follow branches, which begin here.
///
/// # Errors
/// [`Refusal::NoSuchState`] if there is none; as [`steady_sliding`].
pub(in crate::sliding) fn contact_on_the_curve(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    work: &mut SlidingWork,
) -> Result<PartialContact, Refusal> {
    problem.checked()?;
    let prepared = Prepared::shared(material, problem.rate, problem.indenter, problem.adhesion)?;
    match searched(material, problem, &prepared, ReachedBy::Loading, work)? {
        Searched::Outcome(SlidingOutcome::Partial(contact)) => Ok(*contact),
        Searched::Outcome(SlidingOutcome::Full(full)) => {
            Err(Refusal::NoSuchState { reason: "the contact is full".into(), limit_name: full.limit_name, limit: full.limit })
        }
        Searched::Nothing(_) => Err(Refusal::NoSuchState {
            reason: "no stable contact of what is held exists at this speed".into(),
            limit_name: "stable contacts",
            limit: 0.0,
        }),
    }
}

/// The contact on the equilibrium curve.
fn searched(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    prepared: &Prepared,
    reached_by: ReachedBy,
    work: &mut SlidingWork,
) -> Result<Searched, Refusal> {
    let held = match problem.control {
        SlidingControl::HalfWidth(half_width) => return of_width(problem, prepared, half_width, work),
        SlidingControl::MeanPressure(pressure) => (HeldQuantity::MeanPressure, pressure),
        // 1 − Δ keeps its digits near full contact.
        SlidingControl::Penetration(penetration) => (HeldQuantity::Penetration, penetration - 1.0),
    };
    if problem.adhesion.is_none() && problem.indenter == Indenter::Wave {
        let full = |limit_name, limit| full_contact(material, problem, limit_name, limit, SlidingWork::default()).map(Searched::Outcome);
        let closing = closing_pressure(material, prepared)?;
        match problem.control {
            SlidingControl::MeanPressure(pressure) if pressure >= closing => {
                return full("mean pressure of full contact at this speed", closing);
            }
            SlidingControl::Penetration(penetration) if penetration >= 1.0 => return full("penetration of full contact", 1.0),
            _ => {}
        }
    }
    if problem.adhesion.is_none()
        && let Some(contact) = without_adhesion(problem, prepared, held, work)
    {
        return Ok(Searched::Outcome(SlidingOutcome::Partial(Box::new(contact))));
    }
    let curve = prepared.curve(size_of(problem));
    let found = curve.held(held.0, held.1);
    let mut candidates: Vec<Crossing> = found.iter().copied().filter(|crossing| crossing.stable).collect();
    if reached_by == ReachedBy::Unloading {
        candidates.reverse();
    }
    let mut refused = Vec::new();
    let mut not_converged = None;
    let mut outcome = None;
    for (index, crossing) in candidates.iter().enumerate() {
        match accepted(prepared, problem, crossing, held.0, work) {
            Ok(mut contact) => {
                let others = candidates.iter().enumerate().filter(|&(other, _)| other != index);
                let found = WaveContact { half_width: contact.values.half_width.value, eccentricity: contact.values.eccentricity.value };
                contact.others = curve.others(held, found, others.map(|(_, crossing)| crossing));
                outcome = Some(contact);
                break;
            }
            Err(refusal) if curve.exists(crossing) => not_converged = Some(refusal),
            Err(_) => refused.push(*crossing),
        }
    }
    work.half_widths += curve.rows();
    let evaluations = curve.evaluations();
    work.closure_evaluations += evaluations;
    work.contacts += if problem.adhesion.is_some() { 3 } else { 1 } * evaluations;
    match (outcome, not_converged) {
        (Some(contact), _) => Ok(Searched::Outcome(SlidingOutcome::Partial(Box::new(PartialContact { work: *work, ..contact })))),
        (None, Some(refusal)) => Err(refusal),
        (None, None) => Ok(Searched::Nothing(Nothing::Held { held, found, refused, reached_by })),
    }
}

/// The contact without adhesion, of which there is one; none where it is not found, which the curve then explains.
fn without_adhesion(
    problem: &SlidingProblem<'_>,
    prepared: &Prepared,
    (quantity, value): (HeldQuantity, f64),
    work: &mut SlidingWork,
) -> Option<PartialContact> {
    let every = prepared.contacts_of_width();
    let crossing = every.only_contact(quantity, value, half_widths(&prepared.curve_balance(), size_of(problem)));
    let evaluations = every.evaluations();
    work.half_widths += evaluations.div_ceil(2);
    work.closure_evaluations += evaluations;
    work.contacts += evaluations;
    let contact = accepted(prepared, problem, &crossing?, quantity, work).ok()?;
    Some(PartialContact { work: *work, ..contact })
}

/// The contact near a crossing, with its stability.
fn accepted(
    prepared: &Prepared,
    problem: &SlidingProblem<'_>,
    crossing: &Crossing,
    quantity: HeldQuantity,
    work: &mut SlidingWork,
) -> Result<PartialContact, Refusal> {
    let mut contact = solved(prepared, problem, &Start::at(crossing.half_width, crossing.eccentricity), work)?;
    let half_width = contact.values.half_width.value;
    let room = FARTHEST * half_width.min(problem.indenter.widest() - half_width);
    let another =
        || Refusal::NotConverged { what: "a sliding contact", detail: "only another contact than the stable one was found".into() };
    if half_width < crossing.between[0] - room || half_width > crossing.between[1] + room {
        return Err(another());
    }
    contact.stability = stability(prepared, problem, &contact, work);
    let held = contact.stability.as_ref().map(|stability| match quantity {
        HeldQuantity::MeanPressure => stability.under_load(),
        HeldQuantity::Penetration => stability.under_penetration(),
    });
    if held == Some(Stability::Unstable) { Err(another()) } else { Ok(contact) }
}

/// The second variations of a contact.
fn stability(
    prepared: &Prepared,
    problem: &SlidingProblem<'_>,
    contact: &PartialContact,
    work: &mut SlidingWork,
) -> Option<ContactStability> {
    let values = &contact.values;
    let pressure = values.mean_pressure.value;
    let edges = WaveContact { half_width: values.half_width.value, eccentricity: values.eccentricity.value };
    let narrow = problem.indenter == Indenter::Wave && PI - edges.half_width < NARROW;
    let balance = prepared.balance(SlidingControl::MeanPressure(pressure), if narrow { Resolution::Finest } else { VARIATIONS });
    let variations = SecondVariations::new(&balance, edges, pressure, problem.indenter).ok();
    let evaluations = balance.take_evaluations();
    work.closure_evaluations += evaluations;
    work.contacts += balance.contacts_per_evaluation() * evaluations;
    variations.map(|variations| ContactStability { variations })
}

/// The contact of a given half-width.
fn of_width(problem: &SlidingProblem<'_>, prepared: &Prepared, half_width: f64, work: &mut SlidingWork) -> Result<Searched, Refusal> {
    let every = prepared.contacts_of_width();
    let mut contacts = every.at(half_width)?;
    contacts.sort_by(|first, second| first.eccentricity.abs().total_cmp(&second.eccentricity.abs()));
    work.half_widths += 1;
    let evaluations = every.evaluations();
    work.closure_evaluations += evaluations;
    work.contacts += if problem.adhesion.is_some() { 3 } else { 1 } * evaluations;
    let mut last = None;
    for contact in &contacts {
        match solved(prepared, problem, &Start::at(contact.mean_pressure, contact.eccentricity), work) {
            Ok(mut found) => {
                found.stability = stability(prepared, problem, &found, work);
                found.others = contacts.len() - 1;
                found.work = *work;
                return Ok(Searched::Outcome(SlidingOutcome::Partial(Box::new(found))));
            }
            Err(refusal) => last = Some(refusal),
        }
    }
    last.map_or(Ok(Searched::Nothing(Nothing::HalfWidth(half_width))), Err)
}

/// The steady contact near another one of the same control, without a curve.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem; [`Refusal::NotConverged`] if no admissible contact is near.
pub fn steady_sliding_near(material: &PlaneMaterial, problem: &SlidingProblem<'_>, start: &Start) -> Result<PartialContact, Refusal> {
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
