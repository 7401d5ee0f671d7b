//! A history of contact from a problem to numbers with errors: marches, each tighter than the one before, until the errors meet the accuracy.

use super::checkpoint::{Checkpoint, Observer, Watch};
use super::cycle::Cycle;
use super::marcher::{Guide, march_to};
use super::problem::IndentationProblem;
use super::solution::{Energies, Event, IndentationSolution, IndentationWork, Instant, PathPoint, Trace};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// Bound over the change between two marches, of which the finer is ten times tighter: changes may agree by chance, or fall slowly past a corner.
const SAFETY: f64 = 3.0;
/// A change that passes through zero is no accuracy: this part of the largest so far, of any quantity over its scale, stays in the bound.
const MEMORY: f64 = 0.5;
/// Part of the accuracy that every bar keeps: far inside it, two marches may agree by chance.
const FLOOR: f64 = 3e-4;
/// What the tolerance of the edge condition leaves.
const ROUNDING: f64 = 1e-10;
/// Tolerance of the first march, over the accuracy.
const FIRST: f64 = 30.0;
/// Each march is tighter than the one before by this.
const TIGHTER: f64 = 0.1;
/// Marches at most.
const MOST_MARCHES: u32 = 6;
/// Evaluations of the edge condition after which no tighter march is begun.
const MOST_EVALUATIONS: u64 = 200_000;
/// The same for each cycle of an oscillation.
const EVALUATIONS_OF_A_CYCLE: u64 = 2_000;
/// No march is tighter than this: rounding of the edge condition takes over.
const TIGHTEST: f64 = 1e-9;

/// Solves a history to its accuracy: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// Every refusal of [`march`](crate::indentation::march).
pub fn run(material: &Material, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    run_watched(material, problem, None, None)
}

/// The same, watched, and from a checkpoint of the same material and problem: the numbers are the same, to the last bit.
///
/// # Errors
/// Every refusal of [`march`](super::march); [`Refusal::Undefined`] for a checkpoint of something else.
pub fn run_watched(
    material: &Material,
    problem: &IndentationProblem,
    from: Option<Checkpoint>,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    problem.checked()?;
    let mut finished = 0;
    let mut tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST, 0.03);
    let mut coarse: Option<Trace> = None;
    let mut work = IndentationWork::default();
    let mut under_way = None;
    if let Some(checkpoint) = from {
        let march;
        Checkpoint { finished, tolerance, coarse, work, march } = checkpoint;
        under_way = Some(march);
    }
    loop {
        let observer = watch.map(|watch| Observer { watch, finished, coarse: coarse.as_ref(), work });
        // Stretches that were stationary early are as long for every tighter march.
        let stops = coarse.as_ref().map_or(&[][..], |coarse| &coarse.shortened);
        let fine = march_to(material, problem, tolerance, stops, Guide { from: under_way.take(), observer })?;
        finished += 1;
        work.add(&fine.work);
        if let Some(coarse) = &coarse {
            let most = MOST_EVALUATIONS + EVALUATIONS_OF_A_CYCLE * fine.cycles.last().map_or(0, |cycle| cycle.number);
            let last = finished > MOST_MARCHES || tolerance <= TIGHTEST || work.closure_evaluations > most;
            let judged = judged(problem, coarse, fine.clone(), work);
            if judged.reached || last {
                return Ok(judged);
            }
        }
        coarse = Some(fine);
        tolerance = (TIGHTER * tolerance).max(TIGHTEST);
    }
}

impl IndentationWork {
    fn add(&mut self, other: &Self) {
        self.steps += other.steps;
        self.closure_evaluations += other.closure_evaluations;
        self.history_updates += other.history_updates;
        self.most_panels = self.most_panels.max(other.most_panels);
    }
}

fn judged(problem: &IndentationProblem, coarse: &Trace, fine: Trace, work: IndentationWork) -> IndentationSolution {
    let mut instants = Vec::with_capacity(fine.kept.len());
    // The largest change so far: of the state over its scales, and of each energy.
    let (mut worst, mut largest) = (0.0_f64, [0.0_f64; 8]);
    let mut scales = fine.summary.scales;
    let [_, force, a, _] = scales;
    if problem.adhesion.is_none() {
        // Without adhesion K is rounding; it is seen against the one that the force would have at the rim of a punch.
        scales[3] = if a > 0.0 { force / (2.0 * a * (PI * a).sqrt()) } else { 0.0 };
    }
    let mut reached = true;
    for (index, place) in fine.kept.iter().enumerate() {
        let Some(point) = fine.path.get(*place) else { continue };
        let other = coarse.kept.get(index).and_then(|place| coarse.path.get(*place));
        let mut estimate = |quantity: usize, of: &dyn Fn(&PathPoint) -> f64| {
            let value = of(point);
            let change = other.map_or(f64::INFINITY, |other| (value - of(other)).abs());
            let memory = match scales.get(quantity) {
                Some(scale) => {
                    worst = worst.max(if *scale > 0.0 { change / scale } else { 0.0 });
                    MEMORY * worst * scale
                }
                None => largest.get_mut(quantity).map_or(change, |most| {
                    *most = most.max(change);
                    MEMORY * *most
                }),
            };
            let floor = FLOOR * problem.accuracy * scales.get(quantity).unwrap_or(&0.0);
            let error = (SAFETY * change).max(memory).max(floor) + ROUNDING * value.abs();
            if let Some(scale) = scales.get(quantity) {
                reached &= error <= problem.accuracy * scale;
            }
            Estimate::new(value, error)
        };
        let energy = |which: usize| {
            move |point: &PathPoint| {
                point.energies.map_or(0.0, |energies| match which {
                    0 => energies.stored,
                    1 => energies.dissipated_power,
                    2 => energies.external_work,
                    _ => energies.dissipated,
                })
            }
        };
        instants.push(Instant {
            time: point.time,
            penetration: estimate(0, &|point| point.penetration),
            force: estimate(1, &|point| point.force),
            contact_radius: estimate(2, &|point| point.contact_radius),
            stress_intensity_factor: estimate(3, &|point| point.stress_intensity_factor),
            energies: point
                .energies
                .is_some()
                .then(|| [estimate(4, &energy(0)), estimate(5, &energy(1)), estimate(6, &energy(2)), estimate(7, &energy(3))]),
            tip_release_rate: release(point, other, |energies| Some(energies.tip_release_rate)),
            energy_release_rate: release(point, other, |energies| energies.energy_release_rate),
            residual: point.residual,
        });
    }
    let events = fine.events.iter().enumerate().map(|(index, event)| {
        let other = coarse.events.get(index).filter(|other| other.kind == event.kind);
        let estimate = |of: fn(&Event<f64>) -> f64| {
            let error = other.map_or(f64::INFINITY, |other| SAFETY * (of(event) - of(other)).abs());
            Estimate::new(of(event), error + ROUNDING * of(event).abs())
        };
        Event {
            kind: event.kind,
            time: estimate(|event| event.time),
            penetration: estimate(|event| event.penetration),
            force: estimate(|event| event.force),
            contact_radius: estimate(|event| event.contact_radius),
        }
    });
    let events: Vec<Event<Estimate>> = events.collect();
    let largest_tension = fine.largest_tension().map(|value| {
        let change = coarse.largest_tension().map_or(value, |other| (value - other).abs());
        Estimate::new(value, SAFETY * change + ROUNDING * value)
    });
    if let Some(tension) = largest_tension {
        reached &= tension.error <= problem.accuracy * scales[1];
    }
    for event in &events {
        reached &= event.force.error <= problem.accuracy * scales[1].max(f64::MIN_POSITIVE) * 10.0;
    }
    let cycles = judged_cycles(problem, coarse, &fine, &mut reached);
    let residual = fine.summary.residual;
    IndentationSolution {
        instants,
        events,
        cycles,
        largest_tension,
        balance_defect: fine.balance_defect(),
        smallest_stress_intensity_factor: fine.smallest_stress_intensity_factor,
        smallest_gap_factor: fine.smallest_gap_factor,
        reached,
        residual,
        fine,
        work,
    }
}

/// A release rate with its error; none where nothing of it is known.
fn release(fine: &PathPoint, coarse: Option<&PathPoint>, of: impl Fn(&Energies) -> Option<f64>) -> Option<Estimate> {
    let value = of(&fine.energies?)?;
    let other = of(&coarse?.energies?)?;
    let error = SAFETY * (value - other).abs() + ROUNDING * value.abs();
    (error <= value.abs()).then(|| Estimate::new(value, error))
}

/// Cycles with errors: the change between marches, over the scales of all cycles.
fn judged_cycles(problem: &IndentationProblem, coarse: &Trace, fine: &Trace, reached: &mut bool) -> Vec<Cycle<Estimate>> {
    let largest = |of: fn(&Cycle<f64>) -> f64| fine.cycles.iter().fold(0.0, |most: f64, cycle| most.max(of(cycle).abs()));
    let stiffness = largest(|cycle| cycle.storage_stiffness.hypot(cycle.loss_stiffness));
    let scales = [
        largest(|cycle| cycle.work.abs().max(0.25 * (cycle.force[1] - cycle.force[0]) * (cycle.penetration[1] - cycle.penetration[0]))),
        stiffness,
        stiffness,
        1.0,
        fine.summary.scales[0],
        fine.summary.scales[0],
        fine.summary.scales[1],
        fine.summary.scales[1],
        fine.summary.scales[2],
        fine.summary.scales[2],
    ];
    let mut cycles = Vec::with_capacity(fine.cycles.len());
    for (index, cycle) in fine.cycles.iter().enumerate() {
        let other = coarse.cycles.get(index).filter(|other| (other.segment, other.number) == (cycle.segment, cycle.number));
        cycles.push(cycle.judged(other, |place, value, other| {
            let scale = scales.get(place).copied().unwrap_or(0.0);
            let change = other.map_or(f64::INFINITY, |other| (value - other).abs());
            let error = (SAFETY * change).max(FLOOR * problem.accuracy * scale) + ROUNDING * value.abs();
            *reached &= error <= problem.accuracy * scale;
            Estimate::new(value, error)
        }));
    }
    cycles
}
