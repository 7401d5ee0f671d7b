//! The segment of a history that an integration goes through.

use super::history::Segment;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Most that an oscillation goes on within a step (rad), at the loosest tolerance: the work of a cycle is taken through the last six points.
const ANGLE: f64 = 0.4;

/// The segment of history under way; times count from its start.
pub(super) struct CurrentSegment {
    pub(super) from: f64,
    pub(super) segment: Segment,
}

/// Where an integration is within a segment, besides the time.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub(super) struct Place {
    /// Which segment of the history, from 0.
    pub(super) segment: usize,
    /// What its controlled quantity began from.
    pub(super) from: f64,
    /// How long it takes: one that oscillates may end early (s).
    pub(super) duration: f64,
    /// The next instant to keep and the next cycle to end, from 1.
    pub(super) instant: u32,
    pub(super) cycle: u64,
    /// Steps of the integration at which it gives up.
    pub(super) budget: u64,
}

impl CurrentSegment {
    pub(super) fn value(&self, time: f64) -> f64 {
        self.segment.value(self.from, time)
    }

    /// Mean rate of the controlled quantity (its unit/s).
    pub(super) fn rate(&self) -> f64 {
        (self.segment.end - self.from) / self.segment.duration
    }

    /// Where the next whole cycle ends after so many, if the segment oscillates and holds another.
    pub(super) fn end_of_cycle(&self, number: u64) -> Option<f64> {
        self.segment.oscillation.and_then(|oscillation| oscillation.time_of(number as f64, self.segment.duration))
    }

    /// Longest step that an oscillation allows at a time.
    pub(super) fn longest_step(&self, time: f64) -> f64 {
        self.segment.oscillation.map_or(f64::INFINITY, |oscillation| {
            let duration = self.segment.duration;
            let now = oscillation.frequency_at(time, duration);
            let soon = oscillation.frequency_at((time + 1.0 / now).min(duration), duration);
            ANGLE / (TAU * now.max(soon))
        })
    }
}

/// What a segment weighs against others in the work that they are: cycles cost each about as much as a ramp.
pub(super) fn weight(segment: &Segment) -> f64 {
    1.0 + segment.oscillation.map_or(0.0, |oscillation| oscillation.cycles_at(segment.duration, segment.duration))
}

/// Part (0…1) of that work which is done at a time since its start.
pub(super) fn part(segment: &Segment, time: f64) -> f64 {
    let done = match segment.oscillation {
        Some(oscillation) => oscillation.cycles_at(time, segment.duration) / oscillation.cycles_at(segment.duration, segment.duration),
        None => time / segment.duration,
    };
    if done.is_finite() { done.clamp(0.0, 1.0) } else { 1.0 }
}
