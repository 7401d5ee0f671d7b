//! What is left where no path leads to a contact that can exist: a contact that lies apart, full contact, or a witness that there is none.
//!
//! | looked at | held | told |
//! |---|---|---|
//! | the branch of all loads at the speed of the problem | load | pull-off; full contact beyond snap-in |
//! | every contact of what is held, by a scan ([`crate::sliding::branch`]) | anything | a contact apart from the paths |
//! | where that branch ends, as an edge is pressed or the faces meet | load, half-width | the smallest load, the narrowest or widest contact |
//! | the branch of growing process zones | anything | the longest zones |
//!
//! At one half-width the scan knows every contact, so that none stays unseen; of a load or a penetration it may miss one that fits between two of its half-widths.

use super::accuracy::solved;
use super::path::Start;
use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{SlidingOutcome, SlidingWork};
use super::solve::full_contact;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::branch::{
    Branch, BranchEnd, BranchPath, BranchProblem, ContactAt, FoldQuantity, Impossible, SecondVariations, Stability, Turn, contacts_of,
    trace,
};
use crate::sliding::contact::{Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};

/// Folds are located this well, or to the accuracy of the problem if that is less.
const FOLD_ACCURACY: f64 = 1e-9;
/// Half-widths of a scan.
const SCANNED: usize = 48;
/// Half-widths of a cylinder that are looked at, under and over its size.
const RANGE: [f64; 2] = [1e-2, 1e2];
/// Zones so much shorter are those of nearly sharp edges.
const SHORT: f64 = 1e-3;

/// What there is instead of a contact at the end of a path; none if nothing was found out.
pub(super) fn elsewhere(
    material: &Material,
    problem: &SlidingProblem<'_>,
    prepared: &Prepared,
    work: &mut SlidingWork,
) -> Option<Result<SlidingOutcome, Refusal>> {
    let loads = loads(problem, problem.adhesion?);
    let branch = trace(material, &loads).ok();
    if let (Some(branch), SlidingControl::MeanPressure(pressure)) = (&branch, problem.control)
        && let Some(found) = beyond_a_fold(material, problem, (&loads, branch), pressure, *work)
    {
        return Some(found);
    }
    apart(material, problem, &loads, prepared, work)
        .or_else(|| branch.and_then(|branch| beyond_an_end(problem, &branch)).map(Err))
        .or_else(|| beyond_a_zone(material, problem, &loads).map(Err))
}

/// The branch of all loads at the speed of a problem.
fn loads<'a>(problem: &SlidingProblem<'a>, adhesion: WaveAdhesion) -> BranchProblem<'a> {
    let of_wave = BranchProblem::loads(problem.rate, adhesion, problem.accuracy.max(FOLD_ACCURACY));
    let size = match problem.control {
        SlidingControl::HalfWidth(half_width) => half_width,
        // Of an elastic cylinder a³ = 2Γ at pull-off, a² = 4p̄ without adhesion.
        SlidingControl::MeanPressure(held) | SlidingControl::Penetration(held) => {
            (2.0 * adhesion.larger_work()).cbrt() + 2.0 * held.abs().sqrt()
        }
    };
    let half_widths = match problem.indenter {
        Indenter::Wave => of_wave.half_widths,
        // No narrower than the zones, as of the wave.
        Indenter::Parabola => [of_wave.half_widths[0].max(RANGE[0] * size), RANGE[1] * (size + of_wave.half_widths[0])],
    };
    BranchProblem { indenter: problem.indenter, work_by_speed: problem.work_by_speed, half_widths, ..of_wave }
}

/// What a load is that no contact was found for although the elastic one of a short zone bears it: within a process zone of a fold the branch tells on which side.
fn beyond_a_fold(
    material: &Material,
    problem: &SlidingProblem<'_>,
    (loads, branch): (&BranchProblem<'_>, &Branch),
    pressure: f64,
    work: SlidingWork,
) -> Option<Result<SlidingOutcome, Refusal>> {
    if let Some(fold) = branch.pull_off(loads)
        && pressure <= fold.value.value + fold.value.error
    {
        return Some(Err(Refusal::NoSuchState {
            reason: "the load pulls harder than a contact at this speed can hold".into(),
            limit_name: "mean pressure of pull-off",
            limit: fold.value.value,
        }));
    }
    let snap_in = branch.snap_in().map(|fold| fold.value).filter(|limit| pressure >= limit.value - limit.error)?;
    (problem.indenter == Indenter::Wave).then(|| full_contact(material, problem, "mean pressure of snap-in", snap_in.value, work))
}

/// A contact that neither the slow nor the fast one leads to: the one of the smallest eccentricity that stays under what is held.
fn apart(
    material: &Material,
    problem: &SlidingProblem<'_>,
    loads: &BranchProblem<'_>,
    prepared: &Prepared,
    work: &mut SlidingWork,
) -> Option<Result<SlidingOutcome, Refusal>> {
    let (mut found, evaluations) = contacts_of(material, loads, Some(problem.control), 0.0, SCANNED).ok()?;
    let balance = prepared.balance(problem.control, Resolution::Medium);
    found.sort_by(|first, second| first.eccentricity.abs().total_cmp(&second.eccentricity.abs()));
    let stays = |contact: &ContactAt| {
        let frame = match problem.control {
            SlidingControl::HalfWidth(_) => return true,
            SlidingControl::MeanPressure(_) => 0.0,
            SlidingControl::Penetration(_) => f64::INFINITY,
        };
        let edges = WaveContact { half_width: contact.half_width, eccentricity: contact.eccentricity };
        SecondVariations::new(&balance, edges, contact.mean_pressure, problem.indenter)
            .is_ok_and(|variations| variations.in_frame(frame) == Stability::Stable)
    };
    let best = found.iter().find(|contact| stays(contact));
    let evaluations = evaluations + balance.take_evaluations();
    work.closure_evaluations += evaluations;
    work.contacts += balance.contacts_per_evaluation() * evaluations;
    let best = best?;
    let first = if matches!(problem.control, SlidingControl::HalfWidth(_)) { best.mean_pressure } else { best.half_width };
    let contact = solved(prepared, problem, &Start::at(first, best.eccentricity), work).ok()?;
    Some(Ok(SlidingOutcome::Partial(Box::new(contact))))
}

/// What forbids the contacts beyond an end of a branch.
const fn forbids(witness: Impossible) -> &'static str {
    match witness {
        Impossible::TrailingPressed(_) => "the trailing edge would be pressed",
        Impossible::LeadingPressed(_) => "the leading edge would be pressed",
        Impossible::FacesMeet(_) => "the faces would meet outside the contact",
    }
}

/// The end of the branch of loads that what is held lies beyond.
fn beyond_an_end(problem: &SlidingProblem<'_>, branch: &Branch) -> Option<Refusal> {
    let smallest_load = branch.outline().iter().map(|point| point[2]).fold(f64::INFINITY, f64::min);
    [(&branch.begins, true), (&branch.ends, false)].into_iter().find_map(|(end, narrow)| {
        let &BranchEnd::Impossible { half_width, parameter: load, witness } = end else { return None };
        let (limit_name, limit) = match problem.control {
            SlidingControl::HalfWidth(asked) if narrow && asked < half_width => {
                ("narrowest half-width of a contact at this speed", half_width)
            }
            SlidingControl::HalfWidth(asked) if !narrow && asked > half_width => {
                ("widest half-width of a contact at this speed", half_width)
            }
            SlidingControl::MeanPressure(asked) if asked < load && load <= smallest_load => {
                ("smallest mean pressure of a contact at this speed", load)
            }
            _ => return None,
        };
        let what = if matches!(problem.control, SlidingControl::HalfWidth(_)) {
            "no contact has this half-width"
        } else {
            "no contact bears this load"
        };
        Some(Refusal::NoSuchState { reason: format!("{what}: {}", forbids(witness)), limit_name, limit })
    })
}

/// The longest process zones with which there is a contact, if those asked for are longer.
fn beyond_a_zone(material: &Material, problem: &SlidingProblem<'_>, loads: &BranchProblem<'_>) -> Option<Refusal> {
    let half_widths = match problem.indenter {
        Indenter::Wave => [1e-3 * loads.half_widths[0], std::f64::consts::PI * (1.0 - 1e-6)],
        Indenter::Parabola => [1e-3 * loads.half_widths[0], loads.half_widths[1]],
    };
    let zones = BranchProblem {
        path: BranchPath::Zones(problem.control),
        adhesion: loads.adhesion.with_zones_times(SHORT),
        parameters: [1.0, 1.0 / SHORT],
        half_widths,
        ..*loads
    };
    let branch = trace(material, &zones).ok()?;
    let longest = branch.outline_parameters(&zones).into_iter().fold(0.0, f64::max);
    let why = match branch.ends {
        BranchEnd::Impossible { parameter, witness, .. } if parameter >= longest * (1.0 - 1e-6) => forbids(witness),
        _ if branch.folds_of(FoldQuantity::LogZone).any(|fold| fold.turn == Turn::Maximum) => "their branch turns back",
        _ => return None,
    };
    let limit = longest * SHORT;
    (limit < 1.0).then(|| Refusal::NoSuchState {
        reason: format!("the process zones are too long for the works of adhesion: with longer ones {why}"),
        limit_name: "longest process zones over those asked for",
        limit,
    })
}
