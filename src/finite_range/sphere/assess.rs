//! A result with error bounds: two runs, the second with every tolerance tightened.

use super::integration::run;
use super::mesh::Mesher;
use super::problem::{Accuracy, Problem};
use super::result::{LegSummary, Run};
use crate::finite_range::law::Attraction;
use crate::refusal::Refusal;

/// What bounds are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Times the change from the looser run to the tighter one, whose values are returned.
    pub of_change: f64,
    /// And at least this part of the tighter one's tolerance of a step: two runs may agree by chance.
    pub by_chance: f64,
}

impl Margins {
    /// Where the law has a kink or a hard wall runs do not converge by an order, and may share what a front does that is held by the nodes.
    #[must_use]
    pub fn of_law(law: &Attraction) -> Self {
        if law.is_kinked() { Self { of_change: 3.0, by_chance: 1.0 } } else { Self { of_change: 1.0, by_chance: 0.5 } }
    }
}

/// Error bounds of a leg: absolute, in the units of [`Problem`], zero or more.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Of the force at the largest tension (RΔγ).
    pub largest_tension: f64,
    /// Of the time of the largest tension; wide where the maximum is flat.
    pub time_of_largest_tension: f64,
    /// Of [`LegSummary::work_of_separation`].
    pub work_of_separation: f64,
    /// Of [`LegSummary::work_to_pull_off`].
    pub work_to_pull_off: f64,
    /// Of the penetration at the last zero of the force, or at the beginning.
    pub penetration_at_zero_force: f64,
    /// Of the force (RΔγ) and the penetration (h₀) at the end.
    pub end: [f64; 2],
}

/// Error bounds at an instant that was asked for, absolute.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InstantBounds {
    /// The instant.
    pub time: f64,
    /// Of the force (RΔγ).
    pub force: f64,
    /// Of the penetration (h₀).
    pub penetration: f64,
}

/// The tighter run with its bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessed {
    /// The tighter run.
    pub run: Run,
    /// One for each leg.
    pub legs: Vec<Bounds>,
    /// One for each instant that was reached.
    pub instants: Vec<InstantBounds>,
    /// Of the time at which contact ends under force control.
    pub detachment_time: Option<f64>,
    /// Whether both runs have the same jumps and the same end: without that the bounds mean nothing.
    pub consistent: bool,
}

/// Runs a problem twice, the second time with every tolerance tightened ([`Accuracy::tightened`]), and bounds the errors by the change.
///
/// # Errors
/// [`Refusal`] of either run.
pub fn assessed(problem: &Problem, accuracy: Accuracy, mesher: &mut Mesher) -> Result<Assessed, Refusal> {
    let loose = run(problem, accuracy, mesher)?;
    let tight = run(problem, accuracy.tightened(), mesher)?;
    let margins = Margins::of_law(&Attraction::new(problem.law.clone(), 1.0, 1.0)?);
    let change = |a: f64, b: f64| margins.of_change * (a - b).abs() + margins.by_chance * tight.certificate.accuracy.step * b.abs();
    let legs = loose.legs.iter().zip(&tight.legs).map(|(a, b)| bounds(a, b, change)).collect();
    let instants = problem.instants.iter().filter_map(|&time| {
        let (a, b) = (loose.at(time)?, tight.at(time)?);
        Some(InstantBounds { time, force: change(a.force, b.force), penetration: change(a.penetration, b.penetration) })
    });
    let instants = instants.collect();
    let detachment_time = loose.detachment.zip(tight.detachment).map(|(a, b)| change(a.time, b.time));
    let consistent = loose.jumps.len() == tight.jumps.len() && loose.detachment.is_some() == tight.detachment.is_some();
    Ok(Assessed { run: tight, legs, instants, detachment_time, consistent })
}

fn bounds(a: &LegSummary, b: &LegSummary, change: impl Fn(f64, f64) -> f64) -> Bounds {
    let zero = |leg: &LegSummary| leg.zero_of_force.map_or(leg.begin.penetration, |row| row.penetration);
    Bounds {
        largest_tension: change(a.largest_tension.force, b.largest_tension.force),
        time_of_largest_tension: change(a.largest_tension.time, b.largest_tension.time),
        work_of_separation: change(a.work_of_separation(), b.work_of_separation()),
        work_to_pull_off: change(a.work_to_pull_off(), b.work_to_pull_off()),
        penetration_at_zero_force: change(zero(a), zero(b)),
        end: [change(a.end.force, b.end.force), change(a.end.penetration, b.end.penetration)],
    }
}
