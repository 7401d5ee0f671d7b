//! A crack whose way x₀(t) is chosen; a Volterra equation gives the load K(t).
//!
//! ```text
//! ½cK(t) { K(t)/E∞ + ∫₀ᵗ J′(t − t₁) K(t₁) [1 − (x₀(t) − x₀(t₁))/δ]₊ dt₁ } = Δγ        a quadratic for K at each step, J exact between steps
//! ```
//! Until the delay t_d the load is constant and the tip rests. The steps are far finer than the table that the solver gets, so that what is left
//! is the table: straight between its points, second order in their number.

use crate::studies::convergence::crack::decades;
use crate::studies::order::{Convergence, Expectation, FINEST};
use crate::studies::section::{Cell, Check, Column, Effort, Section, Table};
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, LoadSegment, Onset, Resolution, onset, trajectory};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

const ZONE: f64 = 2.3e-6;
const WORK: f64 = 0.31;
/// Steps of the Volterra equation for each interval of the finest table.
const FINER: usize = 16;
/// The way goes on for so many crossings u of one zone.
const CROSSINGS: usize = 2;

/// x₀/δ at u crossings after the start: speeds up, and is one at u = 1, a point of every table.
fn way(crossings: f64) -> f64 {
    crossings.max(0.0) * (1.0 + 0.15 * crossings.max(0.0)) / 1.15
}

/// K at equal steps after the start.
fn loads(material: &PlaneMaterial, halves: f64, first: f64, delay: f64, crossing: f64, steps: usize) -> Vec<f64> {
    let step = crossing * CROSSINGS as f64 / steps as f64;
    let elapsed: Vec<f64> = (0..=steps).map(|index| material.creep(index as f64 * step)).collect();
    let places: Vec<f64> = (0..=steps).map(|index| way(index as f64 * step / crossing)).collect();
    let mut loads = vec![first];
    for now in 1..=steps {
        let open = |then: usize| (1.0 - (places[now] - places[then])).max(0.0);
        // While it rested, K was constant: J(t) − J(t − t_d), exactly.
        let time = now as f64 * step;
        let mut past = first * open(0) * (material.creep(delay + time) - material.creep(time));
        for then in 0..now {
            let increment = 0.5 * (elapsed[now - then] - elapsed[now - then - 1]);
            past += increment * loads[then] * open(then);
            if then + 1 < now {
                past += increment * loads[then + 1] * open(then + 1);
            }
        }
        // The last half increment goes with the present load, whose part is wholly open.
        let instant = elapsed[0] + 0.5 * (elapsed[1] - elapsed[0]);
        let goal = 2.0 * WORK / halves;
        loads.push(2.0 * goal / (past + (past * past + 4.0 * instant * goal).sqrt()));
    }
    loads
}

pub(super) fn cases(effort: Effort, section: &mut Section) -> Result<(), Refusal> {
    let tables = effort.choose(vec![8_usize, 16, 32, 64], vec![8, 16, 32, 64, 128, 256]);
    let columns = vec![
        Column::words("case"),
        Column::new("points of the table", "1"),
        Column::new("largest error of the place", "δ"),
        Column::new("largest bound of the place", "δ"),
    ];
    let mut table = Table::new(
        "crack",
        "The tip under the load that its chosen way needs, against the number of points that load is given by.",
        columns,
    );
    let mut worst = 0.0_f64;
    for (name, body, terms) in
        [("one time, against a rigid body", CrackBody::AgainstRigid, 1), ("three times, two halves", CrackBody::TwoHalves, 3)]
    {
        let material = decades(1.1e6, 20.0, 0.37, terms)?;
        let interface = Interface { work_of_adhesion: WORK, process_zone: ProcessZone::Constant { length: ZONE }, body };
        let problem = GrowthProblem::new(&material, interface, 0.0)?;
        let first = problem.relaxed_limit() * (problem.glassy_limit() / problem.relaxed_limit()).powf(0.35);
        let Onset::After { delay, initial_speed, .. } = onset(&problem, first)? else {
            return Err(Refusal::Undefined { quantity: "the chosen way", reason: "the first load has no delay".into() });
        };
        // As fast as it would start by itself, within a fifth: neither a jump nor an arrest.
        let crossing = 1.2 * ZONE / initial_speed.value;
        let finest = CROSSINGS * tables.last().copied().unwrap_or(8) * FINER;
        let needed = loads(&material, body.deformable_halves(), first, delay.value, crossing, finest);
        let mut points = Vec::new();
        for &intervals in &tables {
            let count = CROSSINGS * intervals;
            let step = crossing * CROSSINGS as f64 / count as f64;
            let mut given = vec![(0.0, first)];
            given.extend((0..=count).filter_map(|index| Some((delay.value + index as f64 * step, *needed.get(index * finest / count)?))));
            let history = LoadHistory::from_segments(&[LoadSegment::Table { points: given }])?;
            let outputs: Vec<f64> = (1..=4 * CROSSINGS).map(|quarter| delay.value + 0.25 * quarter as f64 * crossing).collect();
            let found = trajectory(&problem, &history, &outputs, Resolution { lines_per_zone: 8, ..Resolution::default() })?;
            let (mut error, mut bar) = (0.0_f64, 0.0_f64);
            for (sample, quarter) in found.samples.iter().zip(1_u32..) {
                let Some(growth) = sample.growth else { continue };
                error = error.max((growth.value / ZONE - way(0.25 * f64::from(quarter))).abs());
                bar = bar.max(growth.error / ZONE);
            }
            points.push((count as f64, error));
            let numbers = [count as f64, error, bar].map(|number| Cell::Number(Some(number)));
            table.rows.push(std::iter::once(Cell::Word(name.to_owned())).chain(numbers).collect());
        }
        worst = worst.max(points.last().map_or(f64::INFINITY, |point| point.1));
        let expected = Expectation::Order {
            order: 2.0,
            least: 1.7,
            most: 2.4,
            reason: "the load is straight between the points of its table; the kink at x₀ = δ is one of them",
        };
        section
            .checks
            .push(Convergence { name: format!("chosen way of a tip, {name}"), points, floor: 1e-9, fitted: FINEST, expected }.check());
    }
    section.tables.push(table);
    let tolerance = effort.choose(1e-4, 1e-5);
    section.checks.push(Check::new(
        "a chosen way of the tip is found again",
        format!("within {tolerance:.0e} of the process zone with the finest table: what its straight segments leave"),
        format!("{worst:.1e} at worst"),
        worst <= tolerance,
    ));
    Ok(())
}
