//! What a leg of the history imposes at an instant, and the work that follows from it.

use super::chain::{STAGES, TIMES, WEIGHTS, error_weights};
use super::newton::Row;
use super::problem::{Control, Leg, Motion};
use super::state::State;

/// A leg of the history with its beginning.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drive {
    pub(super) control: Control,
    pub(super) motion: Motion,
    pub(super) begin: f64,
    /// The imposed quantity at the beginning.
    pub(super) from: f64,
}

impl Drive {
    /// A leg that begins at a state.
    pub(super) fn new(leg: Leg, state: &State) -> Self {
        let from = match leg.control {
            Control::Penetration => state.penetration,
            Control::Force => state.force,
            Control::Frame(stiffness) => state.penetration + state.force / stiffness,
        };
        Self { control: leg.control, motion: leg.motion, begin: state.time, from }
    }

    /// The control equation at a time.
    pub(super) fn row(&self, time: f64) -> Row {
        let value = self.motion.at(time - self.begin, self.from).0;
        let (penetration, force) = match self.control {
            Control::Penetration => (1.0, 0.0),
            Control::Force => (0.0, 1.0),
            Control::Frame(stiffness) => (1.0, 1.0 / stiffness),
        };
        Row { penetration, force, value }
    }

    pub(super) fn rate(&self, time: f64) -> f64 {
        self.motion.at(time - self.begin, self.from).1
    }
}

/// ∫ F dΔ over a step by the weights of the method, and its error estimate. The control says which of the two rates is known.
pub(super) fn work(drive: &Drive, from: &State, depths: &[f64; STAGES], forces: &[f64; STAGES], h: f64) -> (f64, f64) {
    let row = drive.row(from.time);
    let last = STAGES - 1;
    let sum = |weights: &[f64; STAGES], values: &[f64; STAGES]| {
        (0..STAGES).map(|i| weights[i] * values[i] * drive.rate(from.time + TIMES[i] * h)).sum::<f64>() * h
    };
    if row.penetration == 0.0 {
        let whole = forces[last] * depths[last] - forces[0] * depths[0] - sum(&WEIGHTS, depths) / row.force;
        (whole, sum(&error_weights(), depths).abs() / row.force)
    } else {
        let spring = 0.5 * row.force * (forces[last].powi(2) - forces[0].powi(2));
        ((sum(&WEIGHTS, forces) - spring) / row.penetration, sum(&error_weights(), forces).abs() / row.penetration)
    }
}
