//! A history with error bounds, from three paths: the one that is given, one of ten times its tolerance, and one of two degrees more and a hundredth of it. The
//! distance of the given one to the finest is its error but for that of the finest. The finest errs by no more than the distances, by what they fall when a tolerance
//! falls to a tenth, make one expect. Errors swing through zero along a path, so that neighbouring instants count as well. Paths are followed at tolerances that fall
//! until the bounds meet the accuracy.

use super::checkpoint::{IntegrationState, PanelObserver, PanelsState, PathsState};
use super::energies::{Energies as Stored, TurnedOver};
use super::problem::{End, Outcome, Step};
use super::solve::{PanelOptions, integrated, integrated_from};
use crate::indentation::assessment;
use crate::indentation::checkpoint::{Checkpoint, RunState, Watch, foreign};
use crate::indentation::summary::Summary;
use crate::indentation::{Energies, Event, IndentationProblem, IndentationSolution, IndentationWork, PathPoint, SurfaceFields, Trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// Tolerance of the first path that is given, over the accuracy, and the loosest.
pub(super) const FIRST: f64 = 0.3;
pub(super) const LOOSEST: f64 = 3e-4;
/// Each tolerance over the one before, and the last.
pub(super) const TIGHTER: f64 = 0.1;
pub(super) const TIGHTEST: f64 = 1e-8;
/// Tolerance of the finest path at least: below it rounding decides.
const FINEST: f64 = 1e-9;
/// Why a path that touches again may not go on.
const TOUCHES_AGAIN: &str =
    "the surfaces touch again away from the axis, under a given radius, or with no contact wider than a process zone";
/// Tolerance below which degrees 7 and 9 take fewer panels than 5 and 7.
const HIGH_DEGREE: f64 = 1e-7;

/// Solves a history to its accuracy.
///
/// # Errors
/// [`Refusal::Undefined`] for what is not solved here; [`Refusal::NoSuchState`] without a first contact; [`Refusal::NotConverged`] where the paths of every tolerance
/// differ in kind.
pub fn solve_by_panels(material: &PlaneMaterial, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    solve_by_panels_watched(material, problem, None, None)
}

/// The same, watched, and from a checkpoint of the same material and problem: the numbers are the same, to the last bit.
///
/// # Errors
/// Those of [`solve_by_panels`]; [`Refusal::Undefined`] for a checkpoint of something else, or of time steps.
pub fn solve_by_panels_watched(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    from: Option<Checkpoint>,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    let from = match from.map(|checkpoint| checkpoint.run) {
        None => None,
        Some(RunState::Panels(state)) => Some(state),
        Some(RunState::Steps(_)) => return Err(foreign("it was left by time steps")),
    };
    solve_from(material, problem, from, watch)
}

pub(in crate::indentation) fn solve_from(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    from: Option<Box<PanelsState>>,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    problem.checked()?;
    if problem.adhesion.is_none() {
        return Err(Refusal::Undefined { quantity: "the path of the edge by panels", reason: "without adhesion no path is needed".into() });
    }
    let instants = kept_instants(problem);
    let tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST, LOOSEST);
    let (mut run, mut integration) = match from {
        Some(state) => (state.run, Some(state.integration)),
        None => (PathsState { tolerance, ..PathsState::default() }, None),
    };
    loop {
        let failed = match round(material, problem, &instants, (&mut run, integration.take()), watch) {
            Ok(()) => {
                let solution = solution_of(problem, &run.traces, run.work)?;
                if solution.reached {
                    return Ok(solution);
                }
                run.best = Some(std::mem::take(&mut run.traces));
                None
            }
            Err(refusal @ Refusal::NotConverged { .. }) => Some(refusal),
            Err(refusal) => return Err(refusal),
        };
        if run.tolerance <= TIGHTEST {
            // The last one, whose bounds say how far it is known.
            let none = failed.unwrap_or_else(|| not_converged("no path".into()));
            return run.best.map_or(Err(none), |traces| solution_of(problem, &traces, run.work));
        }
        run.tolerance = (TIGHTER * run.tolerance).max(TIGHTEST);
        (run.traces, run.ends) = (Vec::new(), Vec::new());
    }
}

/// One path at the instants that a problem keeps, without bounds.
///
/// # Errors
/// Those of [`solve_by_panels`].
pub fn path_by_panels(material: &PlaneMaterial, problem: &IndentationProblem, options: PanelOptions) -> Result<Trace, Refusal> {
    let instants = kept_instants(problem);
    let outcome = integrated(material, problem, options, (&instants, false), &[])?;
    trace(&outcome, instants.len(), (options.tolerance, material.glassy_modulus()))
}

fn not_converged(detail: String) -> Refusal {
    Refusal::NotConverged { what: "the path of the edge by panels", detail }
}

/// Of the finest path, the one that is given and the loosest; `closer`: tolerance of the finest over that of the one given.
pub(super) fn options(tolerance: f64, closer: f64) -> [PanelOptions; 3] {
    let degree = if tolerance < HIGH_DEGREE { 7 } else { 5 };
    let option = |degree, tolerance| PanelOptions { degree, tolerance };
    [option(degree + 2, (closer * tolerance).max(FINEST)), option(degree, tolerance), option(degree, tolerance / TIGHTER)]
}

/// The paths of one tolerance: the finest, the given one, the loosest.
fn round(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    instants: &[f64],
    (run, mut integration): (&mut PathsState, Option<IntegrationState>),
    watch: Option<&dyn Watch>,
) -> Result<(), Refusal> {
    // The given one first: what it is refused for, all are.
    let [finest, given, loosest] = options(run.tolerance, TIGHTER * TIGHTER);
    for options in [given, finest, loosest].into_iter().skip(run.traces.len()) {
        let observer = watch.map(|watch| PanelObserver { watch, run });
        let outcome = integrated_from(material, problem, options, (instants, false), &run.stops, (integration.take(), observer))?;
        if run.stops.is_empty() {
            // Segments that were stationary early are as long for every other path.
            run.stops.clone_from(&outcome.shortened);
        }
        if outcome.end == End::TouchesAgain {
            return Err(Refusal::Undefined { quantity: "the path of the edge by panels", reason: TOUCHES_AGAIN.into() });
        }
        run.finished += 1;
        run.work.add(&work_of(&outcome));
        run.ends.push((outcome.events.iter().map(|event| event.kind).collect::<Vec<_>>(), outcome.end));
        run.traces.push(trace(&outcome, instants.len(), (options.tolerance, material.glassy_modulus()))?);
    }
    if run.ends.windows(2).any(|pair| pair[0] != pair[1]) {
        return Err(not_converged(format!("paths at {:e} and beside it end or jump differently", run.tolerance)));
    }
    run.traces.swap(0, 1);
    Ok(())
}

/// The middle of three paths with its bounds.
fn solution_of(problem: &IndentationProblem, traces: &[Trace], work: IndentationWork) -> Result<IndentationSolution, Refusal> {
    let compared = assessment::compared(problem, traces, 1, Some(reduction(traces))).ok_or_else(|| not_converged("no path".into()))?;
    Ok(IndentationSolution { by_panels: true, ..compared.solution(work) })
}

/// What the distance of the middle path to the finest is over that of the loosest: the geometric mean over all numbers of all instants kept.
fn reduction(traces: &[Trace]) -> f64 {
    let numbers = |trace: &Trace| -> Vec<[f64; 8]> {
        let points = trace.kept.iter().filter_map(|place| trace.path.get(*place));
        let energies = |point: &PathPoint| point.energies.unwrap_or_default();
        let all = |point: &PathPoint| {
            let Energies { stored, dissipated_power, external_work, dissipated, .. } = energies(point);
            let PathPoint { penetration, force, contact_radius, stress_intensity_factor, .. } = *point;
            [penetration, force, contact_radius, stress_intensity_factor, stored, dissipated_power, external_work, dissipated]
        };
        points.map(all).collect()
    };
    let numbers: Vec<_> = traces.iter().map(numbers).collect();
    let [finest, given, loosest] = numbers.as_slice() else { return 1.0 };
    // Of each number alike, by its logarithm: a few that a loose path has missed by far do not tell how far the others are off.
    let (mut sum, mut count) = (0.0_f64, 0_u32);
    for ((fine, row), loose) in finest.iter().zip(given).zip(loosest) {
        for ((fine, value), loose) in fine.iter().zip(row).zip(loose) {
            let (near, far) = ((value - fine).abs(), (loose - fine).abs());
            if near > 0.0 && far > 0.0 {
                (sum, count) = (sum + (near / far).ln(), count + 1);
            }
        }
    }
    // No path is closer than its tolerance promises.
    if count == 0 { 1.0 } else { (sum / f64::from(count)).exp().clamp(TIGHTER, 1.0) }
}

/// The contact at a time of a history that has been solved here, and its surface by both paths, the better one first.
pub(in crate::indentation) fn surface_at(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    solved: &Trace,
    time: f64,
) -> Result<(PathPoint, [SurfaceFields; 2]), Refusal> {
    let [high, low, _] = options(solved.tolerance, TIGHTER * TIGHTER);
    let asked = as_planned(problem, &solved.shortened, time);
    let mut found = Vec::new();
    for options in [high, low] {
        let outcome = integrated(material, problem, options, (&[asked], true), &solved.shortened)?;
        let step = outcome.path.iter().find(|step| step.wanted).copied().ok_or_else(|| not_converged("no state there".into()))?;
        let surface = outcome.surface.ok_or_else(|| not_converged("no surface there".into()))?;
        found.push((step, surface));
    }
    let mut found = found.into_iter();
    match (found.next(), found.next()) {
        (Some((step, fine)), Some((_, coarse))) => Ok((point(&step, None, material.glassy_modulus()), [fine, coarse])),
        _ => Err(not_converged("no surface there".into())),
    }
}

/// A time as it would be if no segment had ended early.
fn as_planned(problem: &IndentationProblem, shortened: &[(usize, f64)], time: f64) -> f64 {
    let (mut start, mut planned) = (0.0, time);
    for (number, segment) in problem.history.segments.iter().enumerate() {
        let took = shortened.iter().find(|stop| stop.0 == number).map_or(segment.duration, |stop| stop.1);
        if time > start {
            planned += segment.duration - took;
        }
        start += took;
    }
    planned
}

/// Instants to keep: the start, and equally spaced ones of every segment.
fn kept_instants(problem: &IndentationProblem) -> Vec<f64> {
    let each = problem.instants_per_segment.max(1);
    let (mut instants, mut start) = (vec![0.0], 0.0);
    for segment in &problem.history.segments {
        // Of a segment whose end is not known the end alone.
        let open_ended = segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
        let each = if segment.duration > 0.0 && !open_ended { each } else { 1 };
        instants.extend((1..=each).map(|k| start + segment.duration * if k == each { 1.0 } else { f64::from(k) / f64::from(each) }));
        start += segment.duration;
    }
    instants
}

fn work_of(outcome: &Outcome) -> IndentationWork {
    IndentationWork {
        steps: outcome.panels + outcome.refused,
        closure_evaluations: outcome.closures,
        history_updates: outcome.kernel_nodes,
        most_panels: outcome.most_segments as u64,
    }
}

/// The path as a trace that can be compared, which keeps every instant wanted.
fn trace(outcome: &Outcome, wanted: usize, (tolerance, glassy): (f64, f64)) -> Result<Trace, Refusal> {
    let mut trace = Trace { tolerance, events: outcome.events.clone(), work: work_of(outcome), ..Trace::default() };
    trace.cycles.clone_from(&outcome.cycles);
    trace.spreads.clone_from(&outcome.spreads);
    trace.shortened.clone_from(&outcome.shortened);
    trace.unknown_of_events = trace.events.iter().map(Event::unknown).collect();
    let mut summary = Summary::default();
    for step in &outcome.path {
        let point = point(step, trace.path.last(), glassy);
        summary.add(&point, trace.path.last());
        if step.wanted {
            trace.kept.push(trace.path.len());
        }
        if point.contact_radius > 0.0 {
            trace.smallest_stress_intensity_factor = trace.smallest_stress_intensity_factor.min(point.stress_intensity_factor);
        }
        trace.path.push(point);
    }
    trace.summary = summary;
    trace.smallest_gap_factor = outcome.smallest_gap;
    if trace.kept.len() != wanted {
        return Err(not_converged("not every instant was met".into()));
    }
    Ok(trace)
}

pub(super) fn point(step: &Step, before: Option<&PathPoint>, glassy: f64) -> PathPoint {
    let row = step.row;
    let intensity = row.stress_intensity;
    let energies = step.account.map(|(Stored { stored, dissipated_power }, TurnedOver { external, tip, dissipated })| {
        let tip_release_rate = intensity * intensity / (2.0 * glassy);
        let release = tip_release_rate - dissipated_power / step.area_rate;
        let last = before.and_then(|before| before.energies);
        let balance_defect = last.map_or(0.0, |last| {
            (external - last.external_work) + (tip - last.tip_work) - (stored - last.stored) - (dissipated - last.dissipated)
        });
        Energies {
            stored,
            dissipated_power,
            external_work: external,
            tip_work: tip,
            dissipated,
            balance_defect,
            tip_release_rate,
            energy_release_rate: (step.area_rate != 0.0 && release.is_finite()).then_some(release),
        }
    });
    PathPoint {
        time: row.time,
        penetration: row.penetration,
        force: row.force,
        contact_radius: row.contact_radius,
        stress_intensity_factor: intensity,
        unresolved_intensity: 0.0,
        residual: step.residual,
        piece: step.piece,
        energies,
    }
}
