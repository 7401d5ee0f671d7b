//! Where a branch begins.

use super::conditions::{BranchPath, BranchProblem, BranchStart};
use super::scan::contacts_of;
use super::stability::{SecondVariations, Stability};
use super::trace::BranchWork;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, Resolution, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::equilibrium::ContactAt;
use crate::sliding::steady::{
    PartialValues, SlidingOutcome, SlidingProblem, SlidingWork, adhesion_at, contact_on_the_curve, steady_sliding,
};

/// The half-width at which the loads of one speed are begun, if it is asked for.
const MIDDLE: f64 = 1.2;
/// Half-widths of a scan for a contact where the slow and the fast one lead to none.
const SCANNED: usize = 48;
/// Accuracy of the contact at which a branch begins.
const START_ACCURACY: f64 = 1e-4;

/// The unknown that stands for a half-width.
pub(super) fn place_of(problem: &BranchProblem, half_width: f64) -> f64 {
    ContactEdges::new(problem.indenter, WaveContact { half_width, eccentricity: 0.0 }).place()
}

/// The unknowns at which a branch begins.
pub(super) fn start(material: &PlaneMaterial, problem: &BranchProblem, work: &mut BranchWork) -> Result<[f64; 3], Refusal> {
    // What there is where no contact is found is shown by these very branches.
    let known_from_branches = !matches!(problem.path, BranchPath::Adhesions(_));
    let mut steady = |rate: f64, control: SlidingControl| -> Result<(PartialValues, f64), Refusal> {
        let problem = at_start(problem, rate, control);
        let mut counters = SlidingWork::default();
        let found = if known_from_branches {
            contact_on_the_curve(material, &problem, &mut counters)
        } else {
            match steady_sliding(material, &problem)? {
                SlidingOutcome::Partial(contact) => {
                    counters = contact.work;
                    Ok(*contact)
                }
                SlidingOutcome::Full(full) => Err(Refusal::NoSuchState {
                    reason: "there is full contact where the branch begins".into(),
                    limit_name: full.limit_name,
                    limit: full.limit,
                }),
            }
        };
        work.closure_evaluations += counters.closure_evaluations;
        let contact = found?;
        Ok((contact.values, contact.values.half_width.value))
    };
    let placed = |control: SlidingControl, values: &PartialValues, third: f64| match control {
        SlidingControl::HalfWidth(_) => [values.mean_pressure.value, values.eccentricity.value, third],
        _ => [place_of(problem, values.half_width.value), values.eccentricity.value, third],
    };
    match (problem.path, problem.start) {
        (BranchPath::Loads, BranchStart::Near { half_width, eccentricity, mean_pressure, .. }) => {
            Ok([place_of(problem, half_width), eccentricity, mean_pressure])
        }
        (_, BranchStart::Near { half_width, eccentricity, mean_pressure, parameter }) => Ok(match problem.held() {
            Some(SlidingControl::HalfWidth(_)) => [mean_pressure, eccentricity, parameter.ln()],
            _ => [place_of(problem, half_width), eccentricity, parameter.ln()],
        }),
        (BranchPath::Loads, _) => {
            let [narrowest, widest] = problem.half_widths;
            let half_width = if narrowest < MIDDLE && widest > MIDDLE { MIDDLE } else { 0.5 * (narrowest + widest) };
            match steady(problem.rate, SlidingControl::HalfWidth(half_width)) {
                Ok((values, _)) => Ok(placed(SlidingControl::MeanPressure(0.0), &values, values.mean_pressure.value)),
                Err(refusal) => by_scan(material, problem, refusal, work),
            }
        }
        (BranchPath::Speeds(control), from) => {
            let rate = if from == BranchStart::Fast { problem.parameters[1] } else { problem.parameters[0] };
            steady(rate, control).map(|(values, _)| placed(control, &values, rate.ln()))
        }
        (BranchPath::Adhesions(control) | BranchPath::Zones(control), _) => {
            let third = if matches!(problem.path, BranchPath::Zones(_)) { 0.0 } else { problem.adhesion.trailing_work.ln() };
            match steady(problem.rate, control) {
                Ok((values, _)) => Ok(placed(control, &values, third)),
                Err(refusal) => by_scan(material, problem, refusal, work),
            }
        }
    }
}

/// The contact at which a branch begins, roughly.
fn at_start<'a>(problem: &BranchProblem<'a>, rate: f64, control: SlidingControl) -> SlidingProblem<'a> {
    let &BranchProblem { indenter, work_by_speed, .. } = problem;
    let adhesion = Some(adhesion_at(problem.adhesion, work_by_speed, problem.rate, rate));
    SlidingProblem { rate, indenter, adhesion, work_by_speed, control, accuracy: START_ACCURACY }
}

/// A contact among all of a row of half-widths (along loads), or among all of the control that is held: a stable one if there is one, else that of the smallest
/// eccentricity.
fn by_scan(material: &PlaneMaterial, problem: &BranchProblem, refusal: Refusal, work: &mut BranchWork) -> Result<[f64; 3], Refusal> {
    if matches!(refusal, Refusal::OutOfRange { .. } | Refusal::Undefined { .. }) {
        return Err(refusal);
    }
    let third = if matches!(problem.path, BranchPath::Adhesions(_)) { problem.adhesion.trailing_work.ln() } else { 0.0 };
    let (found, evaluations) = contacts_of(material, problem, problem.held(), third, SCANNED)?;
    work.closure_evaluations += evaluations;
    let prepared = problem.prepared(material, third)?;
    let frame = if matches!(problem.held(), Some(SlidingControl::Penetration(_))) { f64::INFINITY } else { 0.0 };
    let mut stable = |contact: &ContactAt| {
        let balance = prepared.balance(SlidingControl::MeanPressure(contact.mean_pressure), Resolution::Coarse);
        let edges = WaveContact { half_width: contact.half_width, eccentricity: contact.eccentricity };
        let variations = SecondVariations::new(&balance, edges, contact.mean_pressure, problem.indenter);
        work.closure_evaluations += balance.take_evaluations();
        variations.is_ok_and(|variations| variations.in_frame(frame) == Stability::Stable)
    };
    let smallest = |first: &ContactAt, second: &ContactAt| first.eccentricity.abs().total_cmp(&second.eccentricity.abs());
    let best = found.iter().filter(|contact| stable(contact)).copied().min_by(smallest).or_else(|| found.iter().copied().min_by(smallest));
    match (best, problem.path) {
        (Some(contact), BranchPath::Loads) => Ok([place_of(problem, contact.half_width), contact.eccentricity, contact.mean_pressure]),
        (Some(contact), _) => {
            let half_width_held = matches!(problem.held(), Some(SlidingControl::HalfWidth(_)));
            let first = if half_width_held { contact.mean_pressure } else { place_of(problem, contact.half_width) };
            Ok([first, contact.eccentricity, third])
        }
        (None, BranchPath::Loads) => Err(Refusal::NoSuchState {
            reason: format!("no steady partial contact exists at this speed: none at any of {SCANNED} half-widths, whatever the load"),
            limit_name: "half-widths looked at",
            limit: SCANNED as f64,
        }),
        (None, _) => Err(refusal),
    }
}
