//! What an indenter that attracts at a distance is expected to cost: the one place to tune when the solver changes.

use super::FiniteRangePlan;
use crate::finite_range::sphere::Motion;
use crate::outcome::Work;

/// Linear systems of a leg of the history at an accuracy of 1e-3, of an instant to land on, and of a cycle.
const LEG: f64 = 4500.0;
const INSTANT: f64 = 60.0;
const CYCLE: f64 = 2500.0;
/// Power of the accuracy that they grow with.
const ORDER: f64 = 0.2;
/// Elastic surfaces jump ahead of a zone that is short at large Tabor numbers: growth with the glassy Tabor number.
const SHORT_RANGE: f64 = 0.5;
/// Powers of the terms: each is carried on at every place.
const TERMS: f64 = 0.05;
/// Rows of events besides instants.
const EVENTS: u64 = 64;
/// Influence matrices, their blocks, and the states of a step (bytes).
const MESHES: u64 = 40 << 20;
/// Memory of a step of both runs (bytes).
const STEP: u64 = 450;
/// Linear systems of a step.
const SYSTEMS_A_STEP: u64 = 35;
/// No prediction is larger.
const MOST: f64 = 1e10;

impl FiniteRangePlan {
    /// Rows of a state, at most.
    pub(super) fn most_rows(&self) -> u64 {
        let instants: u64 = self.course.pieces.iter().map(|piece| piece.instants.len() as u64 + 1).sum();
        instants + self.course.surfaces.len() as u64 + EVENTS + 1
    }

    /// Memory of a state besides its rows (bytes), at most.
    pub(super) fn most_memory(&self) -> u64 {
        MESHES + STEP * self.work_of_a_state().linear_solves / SYSTEMS_A_STEP
    }

    /// Expected work of one state.
    pub(super) fn work_of_a_state(&self) -> Work {
        let pieces = &self.course.pieces;
        let instants: f64 = pieces.iter().map(|piece| piece.instants.len() as f64).sum();
        let cycles: f64 = pieces
            .iter()
            .map(|piece| match piece.leg.motion {
                Motion::Swing { duration, oscillation, .. } => oscillation.cycles_at(duration, duration),
                _ => 0.0,
            })
            .sum();
        let short = 1.0 + SHORT_RANGE * self.tabor_numbers()[1].powi(2);
        let terms = 1.0 + TERMS * self.reduced.creep.times.len() as f64;
        let each = (LEG * pieces.len() as f64 + CYCLE * cycles) * short * terms * (1e-3 / self.accuracy).powf(ORDER);
        let systems = each + INSTANT * instants;
        let fields = self.indentation.fields.as_ref().map_or(0, |fields| u64::from(fields.points) * fields.times.len() as u64);
        Work { linear_solves: systems.min(MOST).ceil() as u64, field_evaluations: fields, ..Work::default() }
    }
}
