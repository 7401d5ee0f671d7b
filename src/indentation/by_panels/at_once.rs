//! A sudden step of what is imposed: the limit of an ever faster ramp, for which nothing relaxes.
//!
//! The edge goes along equilibria of the state that is there, which the panels follow as any other ramp, on a clock of its own: it starts at zero, so that times of
//! [`SHORT`] of the shortest relaxation time keep their digits. At the end the edge is put where the step leads: in frozen time the contact depends on where the edge
//! and the indenter are and not on the way.

use super::drive::{Branch, DriveSegment, Instant};
use super::followed::State;
use super::integration::Integration;
use super::path::{Chart, passed};
use serde::{Deserialize, Serialize};

/// Duration of the ramp over the shortest time of the solid: what relaxes on the way is rounding.
const SHORT: f64 = 1e-15;
/// The edge is sought within so many tolerances of where the ramp has left it.
const REACH: f64 = 10.0;
/// Iterations of its place.
const MOST_ITERATIONS: u32 = 60;
/// C over Δγ, and way over the radius, that rounding leaves.
const ROUNDING: f64 = 2e-15;

/// What the clock of the line showed before a sudden step, with what rounding left of it; the value that the step leads to.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct AtOnce {
    pub(super) time: f64,
    pub(super) rest: f64,
    value: f64,
}

impl Integration<'_> {
    /// t a time after the origin: a sudden step takes none.
    pub(super) fn time_after(&self, time: f64) -> f64 {
        self.at_once.map_or(self.line.time + time, |step| step.time)
    }

    /// A sudden segment begins from a value, at which Δ and its memory are as given.
    pub(super) fn begins_at_once(&mut self, drive_segment: &DriveSegment, value: f64, now: Instant) {
        self.at_once = Some(AtOnce { time: self.line.time, rest: self.line.rest.1, value: drive_segment.end });
        (self.line.time, self.line.rest.1) = (0.0, 0.0);
        let [shortest, _] = self.problem.chain.times(true);
        let ramp = DriveSegment { duration: SHORT * shortest, ..drive_segment.clone() };
        self.branch = ramp.branch(0.0, value, now.memory.clone());
        self.state = drive_segment.control.map(|_| State { depth: now.depth, rate: 0.0, memory: now.memory });
    }

    /// The step is over, or has led to no contact: the clock of the history goes on.
    pub(super) fn ends_at_once(&mut self, in_contact: bool) {
        if self.at_once.is_none() {
            return;
        }
        if in_contact {
            self.settles();
        }
        let Some(step) = self.at_once.take() else { return };
        let mut now = Instant::default();
        self.setting(false).still(&mut now);
        (self.line.time, self.line.rest.1) = (step.time, step.rest);
        let control = self.branch.control;
        let still = DriveSegment { control, end: step.value, duration: 0.0, oscillation: None, segment: 0 };
        self.branch = still.branch(step.time, step.value, now.memory);
        if in_contact {
            let row = self.row(None, 0.0);
            self.outcome.jumps.push(row);
            self.step_settled(row);
            self.record_rest(0.0);
        }
    }

    /// The edge goes to where the closure holds to rounding.
    fn settles(&mut self) {
        if self.is_prescribed() {
            return;
        }
        self.balance();
        let here = self.sudden(0.0);
        let (scale, sign) = (self.scale(), if here > 0.0 { -1.0 } else { 1.0 });
        let reach = REACH * self.problem.tolerance * self.length();
        let mut far = (sign * reach, self.sudden(sign * reach));
        if here.abs() <= ROUNDING * scale || here * far.1 > 0.0 {
            self.start_residual = here;
            return;
        }
        // Secants within a bracket, of which every third halves it.
        let (mut near, mut place) = ((0.0, here), 0.0);
        for count in 0..MOST_ITERATIONS {
            let chord = near.0 - near.1 * (far.0 - near.0) / (far.1 - near.1);
            place = if count % 3 == 2 { 0.5 * (near.0 + far.0) } else { chord };
            let value = self.sudden(place);
            if value * near.1 > 0.0 {
                near = (place, value)
            } else {
                far = (place, value)
            }
            if value.abs() <= ROUNDING * scale || (far.0 - near.0).abs() <= ROUNDING * self.line.edge {
                break;
            }
        }
        if place != 0.0 {
            self.goes_at_once(place);
            self.balance();
        }
        self.start_residual = self.sudden(0.0);
    }

    /// The edge goes a way in no time, within one segment of the path history.
    pub(super) fn goes_at_once(&mut self, way: f64) {
        let values = vec![0.0; self.points.p + 1];
        let segment = passed(&self.points, &self.setting(way > 0.0), Chart::TimeOfPlace, way, &values, &[]);
        self.line.swept(segment, 1.0);
        self.marks.iter_mut().for_each(|mark| mark.place -= way);
    }
}

impl Branch {
    /// The same from a later instant on, for points that bond from then on only.
    pub(super) fn from(&self, time: f64) -> Self {
        let u = time - self.start;
        // Whole cycles taken off: sin keeps its digits.
        let phase = (self.omega * u + self.phase) % std::f64::consts::TAU;
        let memory = vec![0.0; self.memory.len()];
        Self { start: time, level: self.value(u).0, phase, memory, ..self.clone() }
    }
}
