//! The periodic state with bounds: of two paths, the better one by two degrees and a tenth of the tolerance, at tolerances that fall until the bounds meet the
//! accuracy. A bound is ten times the distance of both, and what two cycles integrated from the state still change, carried on as slowly as the paths settled.

use super::super::energies::TurnedOver;
use super::super::problem::Row;
use super::super::solution::{FIRST, LOOSEST, TIGHTER, TIGHTEST, options};
use super::super::solve::{Begun, PanelOptions, begun};
use super::closed_path::ClosedPath;
use super::cycle_map::{CycleMap, not_converged};
use super::integrals::{Measured, Pieces};
use super::settled::{Settled, add, settled};
use super::sinus::Sinus;
use crate::estimate::Estimate;
use crate::indentation::{Controlled, Cycle, IndentationProblem, IndentationSolution, IndentationWork, Instant, Segment, Start, Trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Bound over the distance of both paths.
const SAFETY: f64 = 10.0;
/// Cycles integrated from the state that was found.
const CYCLES: usize = 2;
/// Part of an unknown that a tighter path must leave to be worth it.
const NO_BETTER: f64 = 0.9;
/// Part of a cycle that ends of panels and instants of turns differ by.
const ROUNDING: f64 = 1e-12;

/// The periodic state of a contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicState {
    /// The cycle: from the passage of the penetration through its mean, upwards, to the next one. Its number is that of the cycles integrated to find it, its
    /// drift what the second of two cycles integrated from it changes against the first, over the scales.
    pub cycle: Cycle<Estimate>,
    /// Mean force (N) and contact radius (m) in time.
    pub mean_force: Estimate,
    /// The same of the radius (m).
    pub mean_contact_radius: Estimate,
    /// Equally spaced instants of the cycle, its start and end included.
    pub instants: Vec<Instant>,
    /// Largest change of the contact radius from the start of a cycle to its end, and at any phase (m).
    pub change_of_radius: f64,
    /// What is turned over in the cycle, if the problem asks for energies: ∮F dΔ + ∮G_tip dA = ∮P_d dt.
    pub turned_over: Option<TurnedOver>,
    /// Smallest D outside the contact (m).
    pub smallest_gap: f64,
    /// Whether every bound of the cycle, and of forces and radii at its instants, meets the accuracy.
    pub reached: bool,
    /// Largest bound of the stress intensity over what the accuracy allows. Beside a turn it has two values: there tighter paths need not help.
    pub unknown_intensity: f64,
    /// Counters of everything that was integrated.
    pub work: IndentationWork,
}

impl PeriodicState {
    /// The same as a history of one cycle.
    #[must_use]
    pub fn solution(self) -> IndentationSolution {
        let least = |of: fn(&Instant) -> f64| self.instants.iter().map(of).fold(f64::INFINITY, f64::min);
        IndentationSolution {
            smallest_stress_intensity_factor: least(|instant| instant.stress_intensity_factor.value),
            residual: self.instants.iter().fold(0.0, |most: f64, instant| most.max(instant.residual)),
            instants: self.instants,
            events: Vec::new(),
            cycles: vec![self.cycle],
            largest_tension: None,
            balance_defect: None,
            smallest_gap_factor: self.smallest_gap,
            reached: self.reached,
            integration: Trace { work: self.work, ..Trace::default() },
            path_errors: Vec::new(),
            by_panels: true,
            work: self.work,
        }
    }
}

/// The periodic state of a problem whose history is one steady oscillation of the penetration about its start; its duration and what a contact was before do
/// not matter. `instants`: equal parts of the cycle.
///
/// # Errors
/// [`Refusal::Undefined`] for another history, for what panels do not solve, and for an edge that jumps or turns more than twice a cycle; [`Refusal::NoSuchState`]
/// where the contact lets go within a cycle; [`Refusal::NotConverged`].
pub fn solve_periodic(material: &PlaneMaterial, problem: &IndentationProblem, instants: u32) -> Result<PeriodicState, Refusal> {
    problem.checked()?;
    let (sinus, period) = sinus(problem)?;
    let history = problem.history.segments.iter().map(|segment| Segment { duration: period, ..*segment }).collect();
    let mut asked = problem.clone();
    (asked.start, asked.history.segments) = (Start::Relaxed, history);
    let mut tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST, LOOSEST);
    let mut work = IndentationWork::default();
    let mut best: Option<PeriodicState> = None;
    let mut near: Option<ClosedPath> = None;
    let mut cycles = 0;
    loop {
        let failed = match compared(material, &asked, (sinus, period), (tolerance, instants), &mut near, &mut work) {
            Ok(mut state) => {
                cycles += state.cycle.number;
                state.cycle.number = cycles;
                let before = best.as_ref().filter(|best| best.reached).map_or(f64::INFINITY, |best| best.unknown_intensity);
                if state.reached && (state.unknown_intensity <= 1.0 || state.unknown_intensity > NO_BETTER * before) {
                    return Ok(state);
                }
                // One that is known less well takes the place of none that is known well.
                if state.reached || before.is_infinite() {
                    best = Some(state);
                }
                None
            }
            Err(refusal @ Refusal::NotConverged { .. }) => Some(refusal),
            Err(refusal) => return Err(refusal),
        };
        if tolerance <= TIGHTEST {
            let none = failed.unwrap_or_else(|| not_converged("no path".into()));
            return best.map(|best| PeriodicState { work, ..best }).ok_or(none);
        }
        tolerance = (TIGHTER * tolerance).max(TIGHTEST);
    }
}

/// The oscillation that is asked for, and its period.
fn sinus(problem: &IndentationProblem) -> Result<(Sinus, f64), Refusal> {
    let refused = |reason: &str| Refusal::Undefined { quantity: "the periodic state", reason: reason.to_owned() };
    let history = &problem.history;
    let [segment] = history.segments.as_slice() else { return Err(refused("the history is not one oscillation")) };
    let Some(oscillation) = segment.oscillation else { return Err(refused("nothing oscillates")) };
    if segment.controlled != Controlled::Penetration || history.controlled != Controlled::Penetration {
        return Err(refused("only a penetration oscillates without end here"));
    }
    if oscillation.frequency.to_bits() != oscillation.end_frequency.to_bits() || segment.end.to_bits() != history.start.to_bits() {
        return Err(refused("the frequency or the mean goes elsewhere"));
    }
    if oscillation.phase != 0.0 {
        return Err(refused("what goes on for ever begins at its mean here"));
    }
    if oscillation.amplitude <= 0.0 {
        return Err(Refusal::out_of_range("amplitude", oscillation.amplitude, "greater than zero"));
    }
    let sinus = Sinus { mean: history.start, amplitude: oscillation.amplitude, omega: TAU * oscillation.frequency };
    Ok((sinus, oscillation.frequency.recip()))
}

/// What one path gives: the values of both cycles, the rows wanted of the second one.
struct Found {
    settled: Settled,
    cycles: [Measured; CYCLES],
    rows: Vec<Row>,
    change: f64,
    residual: f64,
    smallest_gap: f64,
    turned_over: Option<TurnedOver>,
}

fn found(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    (sinus, period): (Sinus, f64),
    (options, instants): (PanelOptions, u32),
    near: Option<&ClosedPath>,
    work: &mut IndentationWork,
) -> Result<Found, Refusal> {
    let Begun { problem: mut own, edge, .. } = begun(material, problem, options, (&[], false), &[])?;
    own.cycles = None;
    // Energies of the last cycles alone.
    let energies = std::mem::take(&mut own.energies);
    let settled = settled(&CycleMap { problem: &own, sinus, period, edge }, near, work)?;
    // Two cycles from it, with rows where integrals ask for them.
    let path = &settled.path;
    let mut cuts: Vec<f64> = path.cuts().chain([path.narrowest, path.widest, period]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|next, before| *next - *before < ROUNDING * period);
    let pieces = Pieces(cuts.windows(2).map(|pair| (pair[0], pair[1])).collect());
    let each: Vec<f64> = pieces.instants().collect();
    let shown = (0..=instants).map(|k| period * (1.0 + f64::from(k) / f64::from(instants.max(1))));
    let mut asked: Vec<(f64, usize)> = (0..CYCLES).flat_map(|k| each.iter().map(move |time| (k as f64 * period + time, k))).collect();
    asked.extend(shown.map(|time| (time, CYCLES)));
    asked.sort_by(|one, other| one.0.total_cmp(&other.0));
    own.energies = energies;
    own.instants = asked.iter().map(|(time, _)| *time).collect();
    own.drive.segments.iter_mut().for_each(|drive_segment| drive_segment.duration *= CYCLES as f64);
    let map = CycleMap { problem: &own, sinus, period, edge };
    let integrated = map.integrated(Some(path))?;
    add(work, &integrated.outcome);
    let outcome = &integrated.outcome;
    if outcome.wanted.len() != asked.len() {
        return Err(not_converged("not every instant was met".into()));
    }
    let of = |which: usize| -> Vec<Row> {
        outcome.wanted.iter().zip(&asked).filter(|(_, (_, kind))| *kind == which).map(|(row, _)| *row).collect()
    };
    let cycles = [0, 1].map(|k| pieces.measured(&sinus, &of(k)));
    let way = |time: f64| integrated.trail.at(time);
    let times = (0..=64).map(|k| period * f64::from(k) / 64.0);
    let change =
        times.map(|time| (way(time + period) - way(time)).abs().max((way(time) - path.way(time)).abs())).fold(settled.change, f64::max);
    let accounts: Vec<TurnedOver> = outcome
        .path
        .iter()
        .filter(|step| step.wanted)
        .zip(&asked)
        .filter(|(_, (_, kind))| *kind == CYCLES)
        .filter_map(|(step, _)| step.account.map(|account| account.1))
        .collect();
    let turned_over = accounts.first().zip(accounts.last()).map(|(from, to)| TurnedOver {
        external: to.external - from.external,
        tip: to.tip - from.tip,
        dissipated: to.dissipated - from.dissipated,
    });
    let residual = outcome.path.iter().fold(0.0, |most: f64, step| most.max(step.residual));
    Ok(Found { cycles, turned_over, rows: of(CYCLES), change, residual, smallest_gap: outcome.smallest_gap, settled })
}

fn compared(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    (sinus, period): (Sinus, f64),
    (tolerance, instants): (f64, u32),
    near: &mut Option<ClosedPath>,
    work: &mut IndentationWork,
) -> Result<PeriodicState, Refusal> {
    let [high, low, _] = options(tolerance, TIGHTER);
    let coarse = found(material, problem, (sinus, period), (low, instants), near.as_ref(), work)?;
    let fine = found(material, problem, (sinus, period), (high, instants), Some(&coarse.settled.path), work)?;
    *near = Some(fine.settled.path.clone());
    let carried = fine.settled.amplification;
    let [before, now] = fine.cycles.map(|cycle| cycle.numbers(&sinus));
    let other = coarse.cycles[CYCLES - 1].numbers(&sinus);
    let scales = now.map(|number| number.1);
    let mut drift = 0.0_f64;
    let values: Vec<Estimate> = now
        .iter()
        .zip(before)
        .zip(other)
        .map(|((&(value, scale), (before, _)), (other, _))| {
            drift = drift.max((value - before).abs() / scale);
            Estimate::new(value, SAFETY * (value - other).abs() + carried * (value - before).abs() + f64::EPSILON * scale)
        })
        .collect();
    let number = |k: usize| values.get(k).copied().unwrap_or(Estimate::new(f64::NAN, f64::INFINITY));
    let of_cycle = values.iter().zip(scales).all(|(value, scale)| value.error <= problem.accuracy * scale);
    let first = fine.rows.first().map_or(0.0, |row| row.time);
    // What the cycle still changes acts on every instant.
    let left = |k: usize| number(k).error.max(number(k + 1).error);
    let shown = fine.rows.iter().zip(&coarse.rows).map(|(row, other)| Instant {
        time: row.time - first,
        penetration: Estimate::relative(row.penetration, 4.0 * f64::EPSILON),
        force: Estimate::new(row.force, SAFETY * (row.force - other.force).abs() + left(4)),
        contact_radius: Estimate::new(row.contact_radius, SAFETY * (row.contact_radius - other.contact_radius).abs() + left(6)),
        stress_intensity_factor: Estimate::new(row.stress_intensity, SAFETY * (row.stress_intensity - other.stress_intensity).abs()),
        energies: None,
        tip_release_rate: None,
        energy_release_rate: None,
        residual: fine.residual,
    });
    let shown: Vec<Instant> = shown.collect();
    let within = |of: fn(&Instant) -> Estimate| {
        let largest = shown.iter().map(|at| of(at).value.abs()).fold(0.0, f64::max);
        shown.iter().map(|at| of(at).error).fold(0.0, f64::max) / (problem.accuracy * largest).max(f64::MIN_POSITIVE)
    };
    let reached = of_cycle && within(|at| at.force) <= 1.0 && within(|at| at.contact_radius) <= 1.0;
    let unknown_intensity = within(|at| at.stress_intensity_factor);
    let exact = |value: f64| Estimate::relative(value, f64::EPSILON);
    Ok(PeriodicState {
        cycle: Cycle {
            segment: 0,
            number: u64::from(coarse.settled.cycles + fine.settled.cycles),
            start: 0.0,
            end: period,
            work: number(0),
            storage_stiffness: number(1),
            loss_stiffness: number(2),
            phase: number(3),
            penetration: [exact(sinus.mean - sinus.amplitude), exact(sinus.mean + sinus.amplitude)],
            force: [number(4), number(5)],
            contact_radius: [number(6), number(7)],
            drift,
            // Of the exact periodic state it is zero.
            drift_error: drift,
        },
        mean_force: number(8),
        mean_contact_radius: number(9),
        instants: shown,
        change_of_radius: fine.change,
        smallest_gap: fine.smallest_gap,
        turned_over: fine.turned_over,
        reached,
        unknown_intensity,
        work: *work,
    })
}
