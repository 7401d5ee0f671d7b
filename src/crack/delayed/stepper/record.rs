//! What a run writes: the tip at the output times, events, and the work done.

use super::{Ahead, Stepper};

/// What the tip does, as counted by one run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RawKind {
    Begins,
    Restarts,
    Arrests,
    Jumps,
    Kinks,
    Unbounded,
}

/// An event: time (s), place (process zones), speeds before and after (process zones/s), places jumped over.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RawEvent {
    pub(crate) kind: RawKind,
    pub(crate) time: f64,
    pub(crate) place: f64,
    pub(crate) speeds: [f64; 2],
    pub(crate) jump: f64,
    /// What is not known of the place, beyond the error of stepping.
    pub(crate) doubt: f64,
}

/// The tip at an output time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RawSample {
    pub(crate) place: f64,
    pub(crate) speed: f64,
    pub(crate) moving: bool,
    pub(crate) bounded: bool,
    /// What is not known of place and speed, beyond the error of stepping.
    pub(crate) doubts: [f64; 2],
}

/// Work done by a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct GrowthWork {
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the closure.
    pub closure_evaluations: u64,
    /// Integrals of one term over one piece.
    pub kernel_evaluations: u64,
    /// The most pieces of history held at a time.
    pub most_pieces: u64,
}

impl GrowthWork {
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            closure_evaluations: self.closure_evaluations + other.closure_evaluations,
            kernel_evaluations: self.kernel_evaluations + other.kernel_evaluations,
            most_pieces: self.most_pieces.max(other.most_pieces),
        }
    }
}

/// What a run returns.
pub(crate) struct Run {
    pub(crate) samples: Vec<RawSample>,
    pub(crate) events: Vec<RawEvent>,
    /// The greatest |w/Δγ − 1| after a step of growth.
    pub(crate) residual: f64,
    pub(crate) work: GrowthWork,
}

impl Stepper<'_> {
    pub(super) fn event(&mut self, kind: RawKind, speeds: [f64; 2], jump: f64) {
        let event = RawEvent { kind, time: self.time(), place: self.place(), speeds, jump, doubt: self.doubts[0] };
        self.run.events.push(event);
    }

    /// Writes the outputs that lie in a step; between its ends x is the cubic with both speeds.
    pub(super) fn write_outputs(&mut self, ahead: &Ahead, duration: f64, advance: f64, speeds: [f64; 2]) {
        let (start, from) = (self.time(), self.place());
        // A sum of steps may be an ulp away from the end of a stretch, where the speed may jump: an output there belongs to this side.
        let end = if ahead.left <= duration { ahead.end } else { start + duration };
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= end && !(ahead.left <= duration && output <= end) {
                break;
            }
            let sample = if advance > 0.0 && duration > 0.0 {
                let u = ((output - start) / duration).clamp(0.0, 1.0);
                // Hermite's cubic; slopes up to three times the mean one keep it monotone (Fritsch and Carlson, 1980).
                let [a, b] = speeds.map(|speed| (speed * duration).clamp(0.0, 3.0 * advance));
                let place = u * u * (3.0 - 2.0 * u) * advance + u * (1.0 - u) * ((1.0 - u) * a - u * b);
                let slope = 6.0 * u * (1.0 - u) * advance + (1.0 - u) * (1.0 - 3.0 * u) * a + u * (3.0 * u - 2.0) * b;
                RawSample {
                    place: from + place.clamp(0.0, advance),
                    speed: slope.max(0.0) / duration,
                    moving: true,
                    bounded: true,
                    doubts: self.doubts,
                }
            } else {
                RawSample { place: from, speed: 0.0, moving: false, bounded: true, doubts: self.doubts }
            };
            self.run.samples.push(sample);
        }
    }

    pub(super) fn unbounded(&mut self, time: f64) {
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= time {
                break;
            }
            let sample =
                RawSample { place: self.place(), speed: self.speed.max(0.0), moving: self.moving, bounded: true, doubts: self.doubts };
            self.run.samples.push(sample);
        }
        let event = RawEvent {
            kind: RawKind::Unbounded,
            time,
            place: self.place(),
            speeds: [self.speed.max(0.0), 0.0],
            jump: 0.0,
            doubt: self.doubts[0],
        };
        self.run.events.push(event);
        let gone = RawSample { place: self.place(), speed: 0.0, moving: true, bounded: false, doubts: [0.0; 2] };
        self.run.samples.resize(self.outputs.len(), gone);
    }

    pub(super) fn finished(mut self) -> Run {
        let last = RawSample { place: self.place(), speed: self.speed.max(0.0), moving: self.moving, bounded: true, doubts: self.doubts };
        self.run.samples.resize(self.outputs.len(), last);
        let until = self.until * (1.0 + 4.0 * f64::EPSILON);
        self.run.events.retain(|event| event.time <= until);
        self.run.work.kernel_evaluations += self.memory.kernel_evaluations;
        self.run.work.most_pieces = self.memory.most_pieces as u64;
        self.run
    }
}
