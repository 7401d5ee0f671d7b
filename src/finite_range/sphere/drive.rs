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
    /// A leg that begins at a state. A step at once runs through a time of its own, from 0 to 1.
    pub(super) fn new(leg: Leg, state: &State) -> Self {
        let motion = match leg.motion {
            Motion::Ramp { to, duration: 0.0 } => Motion::Ramp { to, duration: 1.0 },
            motion => motion,
        };
        let from = match leg.control {
            Control::Penetration => state.penetration,
            Control::Force => state.force,
            Control::Frame(stiffness) => state.penetration + state.force / stiffness,
        };
        Self { control: leg.control, motion, begin: state.time, from }
    }

    /// The control equation at a time.
    pub(super) fn row(&self, time: f64) -> Row {
        let value = self.motion.at(time - self.begin, self.from).0;
        let (penetration, force) = self.control.factors();
        Row { penetration, force, value }
    }

    pub(super) fn rate(&self, time: f64) -> f64 {
        self.motion.at(time - self.begin, self.from).1
    }
}

/// ∫ F dΔ over a step by the weights of the method, and its error estimate. The rate of the imposed quantity is known: it stands for that of
/// the penetration or, where a frame takes up most of the travel, for that of the force.
pub(super) fn work(drive: &Drive, from: &State, depths: &[f64; STAGES], forces: &[f64; STAGES], h: f64) -> (f64, f64) {
    let row = drive.row(from.time);
    let [moved, loaded] = [depths, forces].map(|values| values.map(|value| value - values[0]));
    let (travel, load) = (moved[STAGES - 1], loaded[STAGES - 1]);
    let sum = |weights: &[f64; STAGES], values: &[f64; STAGES]| {
        (0..STAGES).map(|i| weights[i] * values[i] * drive.rate(from.time + TIMES[i] * h)).sum::<f64>() * h
    };
    if row.force * load.abs() > row.penetration * travel.abs() {
        let complement = (sum(&WEIGHTS, &moved) - 0.5 * row.penetration * travel * travel) / row.force;
        (forces[STAGES - 1] * travel - complement, sum(&error_weights(), &moved).abs() / row.force)
    } else if row.penetration > 0.0 {
        let rise = (sum(&WEIGHTS, &loaded) - 0.5 * row.force * load * load) / row.penetration;
        (forces[0] * travel + rise, sum(&error_weights(), &loaded).abs() / row.penetration)
    } else {
        (forces[0] * travel, 0.0)
    }
}
