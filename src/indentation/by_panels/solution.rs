//! A history with error bounds: two paths, the better one by two degrees and a tenth of the tolerance, at tolerances that fall until the bounds meet the
//! accuracy. The better path is given, each number with ten times how far the other one is off: paths of one tolerance have in common what a rest beside a
//! turn leaves.

use super::energies::{Energies as Stored, TurnedOver};
use super::problem::{End, Outcome, Row, Step};
use super::solve::{PanelOptions, marched};
use crate::estimate::Estimate;
use crate::indentation::judgement;
use crate::indentation::summary::Summary;
use crate::indentation::{Energies, IndentationProblem, IndentationSolution, IndentationWork, PathPoint, SurfaceFields, Trace};
use crate::material::Material;
use crate::refusal::Refusal;

/// Tolerance of the first path over the accuracy, and the loosest.
pub(super) const FIRST: f64 = 0.3;
pub(super) const LOOSEST: f64 = 1e-3;
/// Each tolerance over the one before, and the last.
pub(super) const TIGHTER: f64 = 0.1;
pub(super) const TIGHTEST: f64 = 1e-8;
/// Tolerance below which degrees 7 and 9 take fewer panels than 5 and 7.
const HIGH_DEGREE: f64 = 1e-7;
/// Tolerance of the better path over that of the other one.
const BETTER: f64 = 0.1;
/// Ratio of tolerances with which the comparison of two traces gives a bound of ten times their distance.
const OF_DISTANCE: f64 = 30.0;
pub(super) const SAFETY: f64 = 10.0;

/// Solves a history to its accuracy; cycles of an oscillation are not added up.
///
/// # Errors
/// [`Refusal::Undefined`] for what is not solved here, surfaces that touch again among it; [`Refusal::NoSuchState`] without a first contact;
/// [`Refusal::NotConverged`] where the paths of every tolerance differ in kind.
pub fn solve_by_panels(material: &Material, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    problem.checked()?;
    if problem.adhesion.is_none() {
        return Err(Refusal::Undefined { quantity: "the path of the edge by panels", reason: "without adhesion no path is needed".into() });
    }
    let instants = kept_instants(problem);
    let mut tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST, LOOSEST);
    let mut work = IndentationWork::default();
    let mut best: Option<IndentationSolution> = None;
    loop {
        let failed = match compared_paths(material, problem, &instants, tolerance, &mut work) {
            Ok(solution) if solution.reached => return Ok(solution),
            Ok(solution) => {
                best = Some(solution);
                None
            }
            Err(refusal @ Refusal::NotConverged { .. }) => Some(refusal),
            Err(refusal) => return Err(refusal),
        };
        if tolerance <= TIGHTEST {
            // The last one, whose bounds say how far it is known.
            let none = failed.unwrap_or_else(|| not_converged("no path".into()));
            return best.map(|best| IndentationSolution { work, ..best }).ok_or(none);
        }
        tolerance = (TIGHTER * tolerance).max(TIGHTEST);
    }
}

fn not_converged(detail: String) -> Refusal {
    Refusal::NotConverged { what: "the path of the edge by panels", detail }
}

pub(super) fn options(tolerance: f64) -> [PanelOptions; 2] {
    let degree = if tolerance < HIGH_DEGREE { 7 } else { 5 };
    [(degree, tolerance), (degree + 2, BETTER * tolerance)].map(|(degree, tolerance)| PanelOptions { degree, tolerance })
}

fn compared_paths(
    material: &Material,
    problem: &IndentationProblem,
    instants: &[f64],
    tolerance: f64,
    work: &mut IndentationWork,
) -> Result<IndentationSolution, Refusal> {
    let [low, high] = options(tolerance);
    let coarse = marched(material, problem, low, (instants, false))?;
    // The better path is asked at the panel ends of the other one too; where two of them have one time, a jump or a sudden step is between.
    let times: Vec<u64> = coarse.ends.iter().map(|row| row.time.to_bits()).collect();
    let single = |row: &&Row| times.iter().filter(|time| **time == row.time.to_bits()).count() == 1;
    let ends: Vec<Row> = coarse.ends.iter().filter(single).copied().collect();
    let mut asked: Vec<(f64, bool)> = instants.iter().map(|&time| (time, true)).chain(ends.iter().map(|row| (row.time, false))).collect();
    asked.sort_by(|one, other| one.0.total_cmp(&other.0));
    let times: Vec<f64> = asked.iter().map(|(time, _)| *time).collect();
    let fine = marched(material, problem, high, (&times, false))?;
    for outcome in [&coarse, &fine] {
        if outcome.end == End::TouchesAgain {
            return Err(Refusal::Undefined { quantity: "the path of the edge by panels", reason: "the surfaces touch again".into() });
        }
        work.add(&work_of(outcome));
    }
    let kinds = |outcome: &Outcome| outcome.events.iter().map(|event| event.kind).collect::<Vec<_>>();
    if kinds(&coarse) != kinds(&fine) || coarse.end != fine.end {
        return Err(not_converged(format!("degrees {} and {} end or jump differently", low.degree, high.degree)));
    }
    let glassy = material.glassy_modulus();
    let fine_trace = trace(&fine, &asked.iter().map(|(_, kept)| *kept).collect::<Vec<_>>(), (tolerance, glassy))?;
    let coarse_trace = trace(&coarse, &vec![true; instants.len()], (tolerance * OF_DISTANCE, glassy))?;
    let distances = distances(&ends, &fine, &asked);
    let compared = judgement::judged(problem, &[fine_trace, coarse_trace], 0).ok_or_else(|| not_converged("no path".into()))?;
    let mut solution = compared.solution(*work);
    widen(&mut solution, problem, &distances);
    solution.by_panels = true;
    Ok(solution)
}

/// The contact at a time of a history that has been solved here, and its surface by both paths, the better one first.
pub(in crate::indentation) fn surface_at(
    material: &Material,
    problem: &IndentationProblem,
    solved: &Trace,
    time: f64,
) -> Result<(PathPoint, [SurfaceFields; 2]), Refusal> {
    let [low, high] = options(solved.tolerance);
    let mut found = Vec::new();
    for options in [high, low] {
        let outcome = marched(material, problem, options, (&[time], true))?;
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

/// Instants to keep: the start, and equally spaced ones of every segment.
fn kept_instants(problem: &IndentationProblem) -> Vec<f64> {
    let each = problem.instants_per_segment.max(1);
    let (mut instants, mut start) = (vec![0.0], 0.0);
    for segment in &problem.history.segments {
        let each = if segment.duration > 0.0 { each } else { 1 };
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

/// The path as a trace that can be compared: `kept` says which of the instants wanted it keeps.
fn trace(outcome: &Outcome, kept: &[bool], (tolerance, glassy): (f64, f64)) -> Result<Trace, Refusal> {
    let mut trace = Trace { tolerance, events: outcome.events.clone(), work: work_of(outcome), ..Trace::default() };
    trace.unknown_of_events = vec![[0.0; 4]; trace.events.len()];
    let mut summary = Summary::default();
    let mut wanted = kept.iter();
    for step in &outcome.path {
        let point = point(step, trace.path.last(), glassy);
        summary.add(&point, trace.path.last());
        if step.wanted && wanted.next() == Some(&true) {
            trace.kept.push(trace.path.len());
        }
        if point.contact_radius > 0.0 {
            trace.smallest_stress_intensity_factor = trace.smallest_stress_intensity_factor.min(point.stress_intensity_factor);
        }
        trace.path.push(point);
    }
    trace.summary = summary;
    trace.smallest_gap_factor = outcome.smallest_gap;
    if trace.kept.len() != kept.iter().filter(|kept| **kept).count() {
        return Err(not_converged("not every instant was met".into()));
    }
    Ok(trace)
}

fn point(step: &Step, before: Option<&PathPoint>, glassy: f64) -> PathPoint {
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

/// Largest distance of both paths in Δ, F and a up to each of the instants kept.
fn distances(ends: &[Row], fine: &Outcome, asked: &[(f64, bool)]) -> Vec<[f64; 3]> {
    let mut ends = ends.iter();
    let mut most = [0.0_f64; 3];
    let mut found = Vec::new();
    for (step, (_, kept)) in fine.path.iter().filter(|step| step.wanted).zip(asked) {
        if *kept {
            found.push(most);
            continue;
        }
        let Some(end) = ends.next() else { continue };
        let row = step.row;
        // At a jump two states have one time.
        if row.contact_radius > 0.0 && (row.contact_radius - end.contact_radius).abs() < 0.1 * end.contact_radius {
            let now = [row.penetration - end.penetration, row.force - end.force, row.contact_radius - end.contact_radius];
            most.iter_mut().zip(now).for_each(|(most, now)| *most = most.max(now.abs()));
        }
    }
    found
}

/// Bounds are no less than the distance of the paths before.
fn widen(solution: &mut IndentationSolution, problem: &IndentationProblem, distances: &[[f64; 3]]) {
    let scales = solution.march.summary.scales;
    let mut reached = solution.reached;
    for (instant, &[depth, force, radius]) in solution.instants.iter_mut().zip(distances) {
        if instant.contact_radius.value <= 0.0 {
            continue;
        }
        // K has two values where an edge turns, and is compared at the instants alone.
        let numbers = [(&mut instant.penetration, depth), (&mut instant.force, force), (&mut instant.contact_radius, radius)];
        for ((number, distance), scale) in numbers.into_iter().zip(scales) {
            *number = Estimate::new(number.value, number.error.max(SAFETY * distance));
            reached = reached && number.error <= problem.accuracy * scale;
        }
    }
    solution.reached = reached;
}
