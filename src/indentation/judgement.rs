//! Numbers with errors from three marches, of which the finest is told.

use super::convergence::left;
use super::cycle::Cycle;
use super::problem::IndentationProblem;
use super::solution::{Energies, Event, EventKind, IndentationSolution, IndentationWork, Instant, PathPoint, Trace};
use crate::estimate::Estimate;
use std::f64::consts::PI;

/// Bound over what is left of an error: single numbers scatter about it.
const SAFETY: f64 = 3.0;
/// The largest that was left so far, of any quantity over its scale, stays in every later bound by this part: errors of a march hand on.
const MEMORY: f64 = 0.3;
/// Part of the accuracy, of the value itself, that every bar keeps: far inside it, marches may agree by chance.
const FLOOR: f64 = 0.03;
/// Bound over what is left of the numbers of an event in which an edge is lost: at a fold force and radius go with the root of the way left, which scatters most;
/// time and depth, which hardly scatter, are widened with them.
const AT_FOLDS: f64 = 12.0;
/// What the tolerance of the edge condition leaves.
const ROUNDING: f64 = 1e-10;
/// Change, over the value, of what is imposed: rounding.
const SAME: f64 = 1e-12;
/// Part of the largest force below which a tension is rounding of none.
const NO_FORCE: f64 = 1e-12;

/// Judges the finest march by those before it, the newest first: two, or one.
pub(super) fn judged(
    problem: &IndentationProblem,
    coarser: &[Trace],
    (tolerance, fine): (f64, Trace),
    work: IndentationWork,
) -> IndentationSolution {
    let others = [coarser.first(), coarser.get(1)];
    let mut instants = Vec::with_capacity(fine.kept.len());
    // The largest that was left so far: of the state over its scales, and of each energy.
    let (mut worst, mut largest) = (0.0_f64, [0.0_f64; 8]);
    let mut scales = fine.summary.scales;
    let [_, force, a, _] = scales;
    if problem.adhesion.is_none() {
        // Without adhesion K is rounding; it is seen against the one that the force would have at the rim of a punch.
        scales[3] = if a > 0.0 { force / (2.0 * a * (PI * a).sqrt()) } else { 0.0 };
    }
    let mut reached = true;
    for (index, &place) in fine.kept.iter().enumerate() {
        let Some(point) = fine.path.get(place) else { continue };
        let others = others.map(|other| other.and_then(|other| other.path.get(*other.kept.get(index)?)));
        let mut estimate = |quantity: usize, of: &dyn Fn(&PathPoint) -> f64| {
            let value = of(point);
            let left = left(value, others.map(|other| other.map(of)));
            let scale = scales.get(quantity);
            let memory = match scale {
                Some(scale) => {
                    worst = worst.max(if *scale > 0.0 { left / scale } else { 0.0 });
                    worst * scale
                }
                None => largest.get_mut(quantity).map_or(left, |most| {
                    *most = most.max(left);
                    *most
                }),
            };
            let floor = if scale.is_some() { floor(problem, left, value) } else { 0.0 };
            let error = (SAFETY * left).max(MEMORY * memory).max(floor) + ROUNDING * value.abs();
            if let Some(scale) = scale {
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
        let (penetration, force) = (estimate(0, &|point| point.penetration), estimate(1, &|point| point.force));
        let contact_radius = estimate(2, &|point| point.contact_radius);
        instants.push(Instant {
            time: point.time,
            penetration,
            force,
            contact_radius,
            stress_intensity_factor: estimate(3, &|point| point.stress_intensity_factor),
            energies: point
                .energies
                .is_some()
                .then(|| [estimate(4, &energy(0)), estimate(5, &energy(1)), estimate(6, &energy(2)), estimate(7, &energy(3))]),
            tip_release_rate: release(point, others, |energies| Some(energies.tip_release_rate)),
            energy_release_rate: release(point, others, |energies| energies.energy_release_rate),
            residual: point.residual,
        });
    }
    let events: Vec<Event<Estimate>> = fine
        .events
        .iter()
        .enumerate()
        .map(|(index, event)| {
            let others = others.map(|other| other.and_then(|other| other.events.get(index)).filter(|other| other.kind == event.kind));
            let safety = if matches!(event.kind, EventKind::JumpIn | EventKind::ZoneReached) { SAFETY } else { AT_FOLDS };
            let estimate = |of: fn(&Event<f64>) -> f64, scale: f64| {
                let left = left(of(event), others.map(|other| other.map(of)));
                let least = if scale > 0.0 && left > 0.0 { (MEMORY * worst * scale).max(floor(problem, left, of(event))) } else { 0.0 };
                Estimate::new(of(event), (safety * left).max(least) + ROUNDING * of(event).abs())
            };
            Event {
                kind: event.kind,
                // What the march knows of time it knows from the penetration.
                time: estimate(|event| event.time, 0.0),
                penetration: estimate(|event| event.penetration, 0.0),
                force: estimate(|event| event.force, scales[1]),
                contact_radius: estimate(|event| event.contact_radius, scales[2]),
            }
        })
        .collect();
    let largest_tension = fine.largest_tension().filter(|tension| *tension > NO_FORCE * scales[1]).map(|value| {
        let left = left(value, others.map(|other| other.map(|other| other.largest_tension().unwrap_or(0.0))));
        let floor = floor(problem, left, value);
        Estimate::new(value, (SAFETY * left).max(MEMORY * worst * scales[1]).max(floor) + ROUNDING * value)
    });
    if let Some(tension) = largest_tension {
        reached &= tension.error <= problem.accuracy * scales[1];
    }
    for event in &events {
        // The radius at a fold goes with the root of what is not known of the load.
        let radius_scale = AT_FOLDS * scales[2];
        for (estimate, scale) in [(event.penetration, scales[0]), (event.force, scales[1]), (event.contact_radius, radius_scale)] {
            reached &= estimate.error <= problem.accuracy * scale.max(f64::MIN_POSITIVE);
        }
    }
    let cycles = judged_cycles(problem, others, &fine, &mut reached);
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
        tolerance,
        fine,
        work,
    }
}

/// The least bar of a value that marches may agree on by chance; of one that is imposed, and the same in all of them, none.
fn floor(problem: &IndentationProblem, left: f64, value: f64) -> f64 {
    if left > SAME * value.abs() { FLOOR * problem.accuracy * value.abs() } else { 0.0 }
}

/// A release rate with its error; none where nothing of it is known.
fn release(fine: &PathPoint, others: [Option<&PathPoint>; 2], of: impl Fn(&Energies) -> Option<f64>) -> Option<Estimate> {
    let value = of(&fine.energies?)?;
    let others = others.map(|other| other.and_then(|other| of(&other.energies?)));
    let error = SAFETY * left(value, others) + ROUNDING * value.abs();
    (error <= value.abs()).then(|| Estimate::new(value, error))
}

/// Cycles with errors, over the scales of all cycles.
fn judged_cycles(problem: &IndentationProblem, others: [Option<&Trace>; 2], fine: &Trace, reached: &mut bool) -> Vec<Cycle<Estimate>> {
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
        let others = others.map(|other| {
            let other = other.and_then(|other| other.cycles.get(index));
            other.filter(|other| (other.segment, other.number) == (cycle.segment, cycle.number))
        });
        cycles.push(cycle.judged(others, |place, value, others| {
            let scale = scales.get(place).copied().unwrap_or(0.0);
            let left = left(value, others);
            let error = (SAFETY * left).max(floor(problem, left, value)) + ROUNDING * value.abs();
            *reached &= error <= problem.accuracy * scale;
            Estimate::new(value, error)
        }));
    }
    cycles
}
