//! What a run writes: the tip at the output times, events, and the work done.

use super::{Ahead, Stepper};
use serde::{Deserialize, Serialize};

/// What the tip does, as counted by one run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum RawKind {
    Begins,
    Restarts,
    Arrests,
    Jumps,
    Kinks,
    Unbounded,
}

/// An event: time (s), place (process zones), speeds before and after (process zones/s), places jumped over.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct RawEvent {
    pub(crate) kind: RawKind,
    pub(crate) time: f64,
    pub(crate) place: f64,
    pub(crate) speeds: [f64; 2],
    pub(crate) jump: f64,
    /// What is not known of the place, beyond the error of stepping.
    pub(crate) uncertainty: f64,
    /// The same of the speeds.
    pub(crate) speed_uncertainty: f64,
}

/// The tip at an output time.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct RawSample {
    pub(crate) place: f64,
    pub(crate) speed: f64,
    pub(crate) moving: bool,
    pub(crate) bounded: bool,
    /// What is not known of place and speed, beyond the error of stepping.
    pub(crate) uncertainties: [f64; 2],
}

/// Work done by a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Run {
    pub(crate) samples: Vec<RawSample>,
    pub(crate) events: Vec<RawEvent>,
    /// The greatest |w/Δγ − 1| after a step of growth.
    pub(crate) residual: f64,
    pub(crate) work: GrowthWork,
}

/// How places and speeds at outputs within a step are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Between {
    /// The closure is solved there.
    Solved,
    /// Read from the cubic with the places and speeds of both ends: motion that is uniform, or known in closed form; and a first step, of which a part would be the same
    /// in every run and show no error.
    Read,
}

/// What is not known of a speed within a step, over its difference to the slope of the cubic.
const WITHIN_PART: f64 = 0.03;

/// Both agree at the middle of a step and at its end, whatever they err by. There the error is that of the parabola: its way lacks the third power of the time, which
/// is known from the speed at its end, and so is by how much the closure then errs in the place. So many times that much: what follows is a step smaller (30 246 known
/// places and speeds: no error beyond half of its bound, which is this part).
const PARABOLA_PART: f64 = 2.0;

/// Secants of an output within a step; the cubic of the step is eight digits there, each secant adds as many as the ones before.
const MOST_SECANTS: u32 = 12;

impl Stepper {
    pub(super) fn event(&mut self, kind: RawKind, speeds: [f64; 2], jump: f64) {
        let event = RawEvent {
            kind,
            time: self.time(),
            place: self.place(),
            speeds,
            jump,
            uncertainty: self.uncertainties[0],
            speed_uncertainty: self.uncertainties[1],
        };
        self.run.events.push(event);
    }

    /// Writes the outputs that lie in a step.
    pub(super) fn write_outputs(&mut self, ahead: &Ahead, duration: f64, advance: f64, speeds: [f64; 2], between: Between) {
        let (start, from) = (self.time(), self.place());
        // A sum of steps may be an ulp away from the end of a segment, where the speed may jump: an output there belongs to this side.
        let end = if ahead.left() <= duration { ahead.end } else { start + duration };
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= end && !(ahead.left() <= duration && output <= end) {
                break;
            }
            let sample = if advance > 0.0 && duration > 0.0 {
                let u = ((output - start) / duration).clamp(0.0, 1.0);
                // Hermite's cubic; slopes up to three times the mean one keep it monotone (Fritsch and Carlson, 1980).
                let [a, b] = speeds.map(|speed| (speed * duration).clamp(0.0, 3.0 * advance));
                let place = u * u * (3.0 - 2.0 * u) * advance + u * (1.0 - u) * ((1.0 - u) * a - u * b);
                let slope = 6.0 * u * (1.0 - u) * advance + (1.0 - u) * (1.0 - 3.0 * u) * a + u * (3.0 * u - 2.0) * b;
                let read = [place.clamp(0.0, advance), slope.max(0.0) / duration];
                let within = match between {
                    Between::Solved if u > 0.0 => self.solved_within(ahead, u * duration, read[0], advance),
                    Between::Solved | Between::Read => None,
                };
                let [[place, speed], by_parabola] = within.unwrap_or([read, [0.0; 2]]);
                // A part of a step from a line that all runs have in common may be the same in all of them.
                let own = [0.0, WITHIN_PART * (speed - read[1]).abs()];
                let uncertainties = [0, 1].map(|of| self.uncertainties[of] + own[of] + PARABOLA_PART * by_parabola[of]);
                RawSample { place: from + place, speed, moving: true, bounded: true, uncertainties }
            } else {
                RawSample { place: from, speed: 0.0, moving: false, bounded: true, uncertainties: self.uncertainties }
            };
            self.run.samples.push(sample);
        }
    }

    /// Place and speed at a time within a step, from the closure of a step that ends there (a cubic's slope would carry the step's own error over
    /// the step, differently at every part of it); and what both err by because the way was a parabola.
    fn solved_within(&mut self, ahead: &Ahead, duration: f64, guess: f64, advance: f64) -> Option<[[f64; 2]; 2]> {
        let mut place = guess;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_SECANTS {
            let step = ahead.step(duration, place);
            let sums = self.sums(&step);
            let load = step.loads[1];
            let excess: f64 = load * (load + sums.memory) - 1.0;
            let slope = match before {
                Some((earlier, earlier_excess)) if (excess - earlier_excess).abs() > 0.0 && (place - earlier).abs() > 0.0 => {
                    (excess - earlier_excess) / (place - earlier)
                }
                _ => -load * sums.exposure / step.zone,
            };
            let next = (place - excess / slope).clamp(0.0, advance);
            if (next - place).abs() <= 4.0 * f64::EPSILON * (1.0 + place) || excess.abs() <= 2.0 * f64::EPSILON {
                let speed = self.speed_of(&sums, &step, ahead.slope);
                if !(speed > 0.0 && speed.is_finite()) {
                    return None;
                }
                let missing = speed - (step.advance - step.bend) / duration;
                let off = (missing * self.memory.place_by_last_slope(&step) / sums.exposure).abs();
                let moved = ahead.step(duration, place + off);
                let moved_sums = self.sums(&moved);
                let slower = self.speed_of(&moved_sums, &moved, ahead.slope);
                return Some([[next, speed], [off, (slower - speed).abs()]]);
            }
            before = Some((place, excess));
            place = next;
        }
        None
    }

    pub(super) fn unbounded(&mut self, time: f64) {
        while let Some(&output) = self.outputs.get(self.run.samples.len()) {
            if output >= time {
                break;
            }
            let sample = RawSample {
                place: self.place(),
                speed: self.speed.max(0.0),
                moving: self.moving,
                bounded: true,
                uncertainties: self.uncertainties,
            };
            self.run.samples.push(sample);
        }
        let event = RawEvent {
            kind: RawKind::Unbounded,
            time,
            place: self.place(),
            speeds: [self.speed.max(0.0), 0.0],
            jump: 0.0,
            uncertainty: self.uncertainties[0],
            speed_uncertainty: self.uncertainties[1],
        };
        self.run.events.push(event);
        let gone = RawSample { place: self.place(), speed: 0.0, moving: true, bounded: false, uncertainties: [0.0; 2] };
        self.run.samples.resize(self.outputs.len(), gone);
    }

    pub(super) fn finished(mut self) -> Run {
        let last = RawSample {
            place: self.place(),
            speed: self.speed.max(0.0),
            moving: self.moving,
            bounded: true,
            uncertainties: self.uncertainties,
        };
        self.run.samples.resize(self.outputs.len(), last);
        let until = self.until * (1.0 + 4.0 * f64::EPSILON);
        self.run.events.retain(|event| event.time <= until);
        self.run.work.kernel_evaluations += self.memory.kernel_evaluations;
        self.run.work.most_pieces = self.memory.most_pieces as u64;
        self.run
    }
}
