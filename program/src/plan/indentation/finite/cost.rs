//! What an indenter that attracts at a distance is expected to cost: the one place to tune when the solver changes.

use super::super::cycles::MOST_ROWS;
use super::super::timeline::Leg;
use super::FiniteRangePlan;
use super::history::Piece;
use crate::outcome::Work;
use viscotack::finite_range::sphere::{Accuracy, Motion};

/// Steps of a segment at an accuracy of 1e-3: at least so many; where the surface peels so many at a Tabor number of 3, with the power of that number.
const LEAST: f64 = 40.0;
const PEELING: f64 = 200.0;
const SHORT_RANGE: f64 = 2.6;
/// The Tabor number that counts has the modulus at this part of the segment's duration.
const EARLY: f64 = 1e-3;
/// Steps of a cycle.
const CYCLE: f64 = 22.0;
/// Power of the accuracy that they grow with.
const ORDER: f64 = 0.18;
/// Linear systems of a step of both runs.
const SYSTEMS: f64 = 60.0;
/// Times as many for a law with kinks, which takes shorter steps, and for one with a hard wall, where nodes change sides one by one.
const KINKED: f64 = 6.0;
const WALL: f64 = 17.0;
/// Seconds of a system (nodes are many where the law has a hard wall, and more with the inverse of the accuracy, from 1e-3).
const SECONDS: f64 = 1.4e-5;
const SECONDS_AT_A_WALL: f64 = 1.6e-4;
/// Rows of events besides instants.
const EVENTS: u64 = 64;
/// Matrices of the nodes alive at a time: of a state, its finer mesh, two earlier states, the Jacobian and its factors.
const MATRICES: u64 = 7;
/// The blocks of which matrices are made, and what else does not grow (bytes).
const BLOCKS: u64 = 30 << 20;
/// Memory of a step of both runs (bytes).
const STEP: u64 = 450;
/// Linear systems of a step.
const SYSTEMS_A_STEP: u64 = 20;
/// No prediction is larger.
const MOST: f64 = 1e10;

impl FiniteRangePlan {
    /// Rows of a state, at most.
    pub(super) fn most_rows(&self) -> u64 {
        let instants: u64 = self.course.pieces.iter().map(|piece| piece.instants.len() as u64 + 1).sum();
        let cycles: f64 = self.timeline.legs.iter().map(Leg::cycles).sum();
        instants + (cycles.ceil() as u64).min(MOST_ROWS as u64) + self.course.surfaces.len() as u64 + EVENTS + 1
    }

    /// Memory of a state besides its rows (bytes), at most.
    pub(super) fn most_memory(&self) -> u64 {
        let nodes = Accuracy::of_law(self.solver_accuracy, &self.reduced.law).most_nodes as u64;
        8 * MATRICES * nodes * nodes + BLOCKS + STEP * self.work_of_a_state().linear_solves / SYSTEMS_A_STEP
    }

    /// Expected seconds of a linear system.
    pub(super) fn seconds_of_a_system(&self) -> f64 {
        if self.reduced.law.wall().is_some() { SECONDS_AT_A_WALL * (1e-3 / self.solver_accuracy).max(1.0) } else { SECONDS }
    }

    /// Expected work of one state.
    pub(super) fn work_of_a_state(&self) -> Work {
        let finer = (1e-3 / self.solver_accuracy).powf(ORDER);
        let mut begin = 0.0;
        let steps = |piece: &Piece| {
            let duration = piece.end - std::mem::replace(&mut begin, piece.end);
            let modulus = self.material.relaxation(EARLY * duration);
            let tabor = self.reduced.scales.tabor * (self.material.relaxed_modulus() / modulus).powf(2.0 / 3.0);
            let peeling = PEELING * (tabor / 3.0).powf(SHORT_RANGE);
            let own = match piece.leg.motion {
                Motion::Swing { duration, oscillation, .. } => CYCLE * oscillation.cycles_at(duration, duration),
                _ => LEAST + if piece.moves() { peeling } else { 0.0 },
            };
            (own * finer).max(piece.instants.len() as f64)
        };
        let law = match (self.reduced.law.wall(), self.reduced.law.is_kinked()) {
            (Some(_), _) => WALL,
            (None, true) => KINKED,
            (None, false) => 1.0,
        };
        let systems = law * SYSTEMS * self.course.pieces.iter().map(steps).sum::<f64>();
        let fields = self.indentation.fields.as_ref().map_or(0, |fields| u64::from(fields.points) * fields.times.len() as u64);
        Work { linear_solves: systems.min(MOST).ceil() as u64, field_evaluations: fields, ..Work::default() }
    }
}
