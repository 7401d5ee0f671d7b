//! A history of contact from a problem to numbers with errors: three integrations, each tighter than the one before, of which the last two assess the first; one more
//! until the errors meet the accuracy.

use super::assessment::{WithErrors, with_errors};
use super::by_panels;
use super::checkpoint::{Checkpoint, Observer, RunState, StepsState, Watch};
use super::convergence::{BEHIND, COMPARED, TIGHTER};
use super::fields::SurfaceFields;
use super::integrator::{Guide, integrate_to};
use super::problem::IndentationProblem;
use super::profile::Profile;
use super::solution::{IndentationSolution, IndentationWork, PathPoint, Trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// Tolerance of the first integration, over the accuracy: nearly all integrations err by less than a hundredth of their tolerance, and bounds are some four times the
/// error.
const FIRST: f64 = 1.0;
/// The loosest first integration: looser ones take no longer steps.
const LOOSEST: f64 = 1e-2;
/// The tightest first integration leaves room for those behind it.
const TIGHTEST_FIRST: f64 = 1e-7;
/// Evaluations of the edge condition after which no tighter integration is begun.
const MOST_EVALUATIONS: u64 = 200_000;
/// The same for each cycle of an oscillation.
const EVALUATIONS_OF_A_CYCLE: u64 = 3_000;
/// No integration is tighter than this: rounding of the edge condition takes over.
const TIGHTEST: f64 = 1e-9;

/// Solves a history to its accuracy: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// Every refusal of [`integrate`](crate::indentation::integrate).
pub fn run(material: &PlaneMaterial, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    run_watched(material, problem, None, None)
}

/// The same, watched, and from a checkpoint of the same material and problem: the numbers are the same, to the last bit.
///
/// # Errors
/// Every refusal of [`integrate`](super::integrate); [`Refusal::Undefined`] for a checkpoint of something else.
pub fn run_watched(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    from: Option<Checkpoint>,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    problem.checked()?;
    if problem.is_without_steps() {
        if from.is_some() {
            return Err(Refusal::Undefined {
                quantity: "a checkpoint of a contact without adhesion",
                reason: "it takes seconds and is solved from its start: run it without the checkpoint".into(),
            });
        }
        return super::adhesiveless::solve(material, problem, watch);
    }
    // On these shapes time steps left an elastic contact up to 1e-5 from its equilibrium by quadrature, with a bound of 1e-10; why is not known.
    let curved = matches!(problem.profile, Profile::PowerLaw { .. } | Profile::Table(_));
    let oscillates = problem.history.segments.iter().any(|segment| segment.oscillation.is_some());
    let (steps, panels) = match from.map(|checkpoint| checkpoint.run) {
        Some(RunState::Steps(state)) => (Some(*state), None),
        Some(RunState::Panels(state)) => (None, Some(state)),
        None => (None, None),
    };
    let is_for_panels = material.relaxation_terms().is_empty() && curved && !oscillates;
    if steps.is_none() && (is_for_panels || panels.is_some()) {
        match by_panels::solve_from(material, problem, panels, watch) {
            // What panels do not solve: edge laws, surfaces that touch again in a ring.
            Err(Refusal::Undefined { .. } | Refusal::NotConverged { .. }) => {}
            solution => return solution,
        }
    }
    let mut finished = 0;
    let mut tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST_FIRST, LOOSEST);
    // The last ones, the finest first.
    let mut integrations: Vec<Trace> = Vec::new();
    let mut work = IndentationWork::default();
    let mut under_way = None;
    if let Some(state) = steps {
        let integration;
        StepsState { finished, tolerance, integrations, work, integration } = state;
        under_way = Some(integration);
    }
    loop {
        let observer = watch.map(|watch| Observer { watch, finished, integrations: &integrations, work });
        // Segments that were stationary early are as long for every tighter integration.
        let stops = integrations.first().map_or(&[][..], |integration| &integration.shortened);
        let integration = match integrate_to(material, problem, tolerance, stops, Guide { from: under_way.take(), observer }) {
            // An integration that gives up leaves those before it: they are assessed as far as they go.
            Err(Refusal::NotConverged { .. }) if integrations.len() > 1 => {
                let reported = reported(problem, &integrations, true).map(|assessed| assessed.solution(work));
                return reported.ok_or(Refusal::NotConverged { what: "history of contact", detail: "no integration is left".into() });
            }
            integration => integration?,
        };
        finished += 1;
        work.add(&integration.work);
        let most = MOST_EVALUATIONS + EVALUATIONS_OF_A_CYCLE * integration.cycles.last().map_or(0, |cycle| cycle.number);
        integrations.insert(0, integration);
        integrations.truncate(COMPARED);
        let last = finished > 1 && (tolerance <= TIGHTEST || work.closure_evaluations > most);
        if let Some(assessed) = reported(problem, &integrations, last) {
            return Ok(assessed.solution(work));
        }
        tolerance = (TIGHTER * tolerance).max(TIGHTEST);
    }
}

/// The contact at a time (s) of a history that has been solved without steps, or by panels: time, Δ, F and a, and its surface twice.
/// The second surface is less fine, and their difference gives the error. None after a time integration: its surface follows from its path.
///
/// # Errors
/// Every refusal of [`run`].
pub fn surface_of(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    solved: &IndentationSolution,
    time: f64,
) -> Result<Option<(PathPoint, [SurfaceFields; 2])>, Refusal> {
    problem.checked()?;
    if problem.is_without_steps() {
        return super::adhesiveless::surface_at(material, problem, &solved.integration, time).map(Some);
    }
    if solved.by_panels { by_panels::surface_at(material, problem, &solved.integration, time).map(Some) } else { Ok(None) }
}

/// The loosest integration that two behind it find within the accuracy. Where no integration is to follow, those behind are asked too, and the best is reported.
fn reported(problem: &IndentationProblem, integrations: &[Trace], last: bool) -> Option<WithErrors> {
    let mut best: Option<WithErrors> = None;
    let loosest = if last { BEHIND.min(integrations.len().checked_sub(1)?) } else { BEHIND };
    let tightest = if last { 0 } else { BEHIND };
    for reported in (tightest..=loosest).rev() {
        let assessed = with_errors(problem, integrations, reported)?;
        if assessed.excess <= 1.0 {
            return Some(assessed);
        }
        if best.as_ref().is_none_or(|best| assessed.excess < best.excess) {
            best = Some(assessed);
        }
    }
    best.filter(|_| last)
}

impl IndentationWork {
    pub(super) fn add(&mut self, other: &Self) {
        self.steps += other.steps;
        self.closure_evaluations += other.closure_evaluations;
        self.history_updates += other.history_updates;
        self.most_panels = self.most_panels.max(other.most_panels);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::{History, Profile};
    use super::*;

    const ACCURACY: f64 = 1e-3;

    /// Integrations at 1e-5, 1e-4 and 1e-3 of an indenter at rest, with these forces.
    fn integrations(forces: [f64; 3]) -> (IndentationProblem, Vec<Trace>) {
        let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, None, History::penetration(0.01).hold(1.0));
        let integration = |(tolerance, force)| {
            let point = PathPoint {
                time: 0.0,
                penetration: 0.01,
                force,
                contact_radius: 0.1,
                stress_intensity_factor: 0.0,
                unresolved_intensity: 0.0,
                residual: 0.0,
                piece: 0,
                energies: None,
            };
            let mut integration = Trace { tolerance, path: vec![point], kept: vec![0], ..Trace::default() };
            integration.summary.add(&point, None);
            integration
        };
        (IndentationProblem { accuracy: ACCURACY, ..problem }, [1e-5, 1e-4, 1e-3].into_iter().zip(forces).map(integration).collect())
    }

    fn reported_of(forces: [f64; 3], last: bool) -> Option<(f64, bool)> {
        let (problem, integrations) = integrations(forces);
        let solution = reported(&problem, &integrations, last)?.solution(IndentationWork::default());
        Some((solution.integration.tolerance, solution.reached))
    }

    #[test]
    fn the_loosest_integration_within_the_accuracy_is_reported() {
        assert_eq!(reported_of([1.0, 1.0, 1.0 + 1e-5], false), Some((1e-3, true)));
        assert_eq!(reported_of([1.0, 1.0, 1.0 + 1e-5], true), Some((1e-3, true)));
        // Without an integration to follow, one behind it; with one, none yet.
        assert_eq!(reported_of([1.0, 1.0 + 1e-6, 1.0 + 3e-4], false), None);
        assert_eq!(reported_of([1.0, 1.0 + 1e-6, 1.0 + 3e-4], true), Some((1e-4, true)));
    }

    #[test]
    fn where_no_integration_is_to_follow_the_best_is_reported() {
        // Of bounds of 0.04, 0.031 and 0.03.
        assert_eq!(reported_of([1.0, 1.0 + 1e-3, 1.0 + 1e-2], true), Some((1e-5, false)));
        assert_eq!(reported_of([1.0, 1.0 + 1e-3, 1.0 + 1e-2], false), None);
    }
}
