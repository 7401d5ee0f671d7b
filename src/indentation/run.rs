//! A history of contact from a problem to numbers with errors: two marches, the finer one judged by the coarser.

use super::marcher::march;
use super::problem::IndentationProblem;
use super::solution::{Event, IndentationSolution, IndentationWork, Instant, PathPoint};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;

/// Bound over the change between the two marches: 1 for errors of first order, 1/3 for second; the rest is prudence.
const SAFETY: f64 = 1.5;
/// A change that passes through zero is no accuracy: half of the largest so far stays in the bound.
const MEMORY: f64 = 0.5;
/// What the tolerance of the edge condition leaves.
const ROUNDING: f64 = 1e-11;

/// Solves a history on two resolutions: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// Every refusal of [`march`].
pub fn run(material: &Material, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    let coarse = march(material, problem, problem.resolution)?;
    let fine = march(material, problem, problem.resolution.halved())?;
    let mut instants = Vec::with_capacity(fine.kept.len());
    let mut largest = [0.0_f64; 8];
    for (index, place) in fine.kept.iter().enumerate() {
        let Some(point) = fine.path.get(*place) else { continue };
        let other = coarse.kept.get(index).and_then(|place| coarse.path.get(*place));
        let mut estimate = |quantity: usize, of: fn(&PathPoint) -> f64| {
            let value = of(point);
            let change = other.map_or(f64::INFINITY, |other| (value - of(other)).abs());
            let so_far = largest.get_mut(quantity).map_or(change, |most| {
                *most = most.max(change);
                *most
            });
            Estimate::new(value, (SAFETY * change).max(MEMORY * so_far) + ROUNDING * value.abs())
        };
        instants.push(Instant {
            time: point.time,
            penetration: estimate(0, |point| point.penetration),
            force: estimate(1, |point| point.force),
            contact_radius: estimate(2, |point| point.contact_radius),
            stress_intensity_factor: estimate(3, |point| point.stress_intensity_factor),
            stored_energy: estimate(4, |point| point.stored_energy),
            dissipated_power: estimate(5, |point| point.dissipated_power),
            external_work: estimate(6, |point| point.external_work),
            dissipated_energy: estimate(7, |point| point.dissipated_energy),
            residual: point.residual,
        });
    }
    let events = fine.events.iter().enumerate().map(|(index, event)| {
        let other = coarse.events.get(index).filter(|other| other.kind == event.kind);
        let estimate = |of: fn(&Event<f64>) -> f64| {
            Estimate::new(of(event), other.map_or(f64::INFINITY, |other| SAFETY * (of(event) - of(other)).abs()))
        };
        Event {
            kind: event.kind,
            time: estimate(|event| event.time),
            penetration: estimate(|event| event.penetration),
            force: estimate(|event| event.force),
            contact_radius: estimate(|event| event.contact_radius),
        }
    });
    let events = events.collect();
    let largest_tension = fine.largest_tension().map(|value| {
        Estimate::new(value, coarse.largest_tension().map_or(value, |other| SAFETY * (value - other).abs() + ROUNDING * value))
    });
    let work = IndentationWork {
        steps: coarse.work.steps + fine.work.steps,
        closure_evaluations: coarse.work.closure_evaluations + fine.work.closure_evaluations,
        history_updates: coarse.work.history_updates + fine.work.history_updates,
        most_panels: coarse.work.most_panels.max(fine.work.most_panels),
    };
    let residual = fine.path.iter().fold(0.0, |most: f64, point| most.max(point.residual.abs()));
    Ok(IndentationSolution { instants, events, largest_tension, balance_defect: fine.balance_defect(), residual, fine, work })
}
