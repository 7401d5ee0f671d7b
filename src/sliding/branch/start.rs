//! Where a branch begins.

use super::conditions::{BranchPath, BranchProblem, BranchStart};
use super::trace::BranchWork;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{From, PartialValues, SlidingOutcome, SlidingProblem, SlidingWork, Start, start_at_rate, steady_sliding};

/// The half-widths at which the loads of one speed are begun, in this order.
const HALF_WIDTHS: [f64; 10] = [1.2, 0.6, 1.8, 0.3, 2.4, 0.15, 0.08, 0.04, 0.02, 0.01];
/// Accuracy of the contact at which a branch begins.
const START_ACCURACY: f64 = 1e-4;

/// The unknown that stands for a half-width.
pub(super) fn place_of(problem: &BranchProblem, half_width: f64) -> f64 {
    ContactEdges::new(problem.indenter, WaveContact { half_width, eccentricity: 0.0 }).place()
}

/// The unknowns at which a branch begins.
pub(super) fn start(material: &Material, problem: &BranchProblem, work: &mut BranchWork) -> Result<[f64; 3], Refusal> {
    let mut steady = |rate: f64, control: SlidingControl| -> Result<(PartialValues, f64), Refusal> {
        let problem =
            SlidingProblem { rate, indenter: problem.indenter, adhesion: Some(problem.adhesion), control, accuracy: START_ACCURACY };
        match steady_sliding(material, &problem)? {
            SlidingOutcome::Partial(contact) => {
                work.closure_evaluations += contact.work.closure_evaluations;
                Ok((contact.values, contact.values.half_width.value))
            }
            SlidingOutcome::Full(full) => Err(Refusal::NoSuchState {
                reason: "there is full contact where the branch begins".into(),
                limit_name: full.limit_name,
                limit: full.limit,
            }),
        }
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
            // Which half-widths are reached from the slow or the fast contact at that half-width depends on where the branch turns back.
            let [narrowest, widest] = problem.half_widths;
            let mut widths: Vec<f64> = HALF_WIDTHS.into_iter().filter(|&width| width > narrowest && width < widest).collect();
            if widths.is_empty() {
                widths.push(0.5 * (narrowest + widest));
            }
            let mut first = None;
            let controls = widths.into_iter().map(SlidingControl::HalfWidth).chain([SlidingControl::MeanPressure(0.0)]);
            for control in controls {
                match steady(problem.rate, control) {
                    Ok((values, half_width)) if half_width > narrowest && half_width < widest => {
                        return Ok([place_of(problem, half_width), values.eccentricity.value, values.mean_pressure.value]);
                    }
                    Ok(_) => {}
                    Err(refusal) => first = first.or(Some(refusal)),
                }
            }
            Err(first
                .unwrap_or(Refusal::NotConverged { what: "the start of a branch", detail: "no contact within the half-widths".into() }))
        }
        (BranchPath::Speeds(control), from) => {
            let (from, rate) = match from {
                BranchStart::Fast => (From::Fast, problem.parameters[1]),
                _ => (From::Slow, problem.parameters[0]),
            };
            let mut counters = SlidingWork::default();
            let steady =
                SlidingProblem { rate, indenter: problem.indenter, adhesion: Some(problem.adhesion), control, accuracy: START_ACCURACY };
            let start = start_at_rate(material, &steady, from, &mut counters).map_err(|none| none.refusal());
            work.closure_evaluations += counters.closure_evaluations;
            let Start { unknowns: [first, eccentricity], .. } = start?;
            let first = if matches!(control, SlidingControl::HalfWidth(_)) { first } else { place_of(problem, first) };
            Ok([first, eccentricity, rate.ln()])
        }
        (BranchPath::Adhesions(control), _) => {
            let (values, _) = steady(problem.rate, control)?;
            Ok(placed(control, &values, problem.adhesion.reduced_work.ln()))
        }
        (BranchPath::Zones(control), _) => {
            let (values, _) = steady(problem.rate, control)?;
            Ok(placed(control, &values, 0.0))
        }
    }
}
