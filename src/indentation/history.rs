//! What is imposed in time: a number that goes from value to value, linearly, or at once.

use crate::refusal::{Refusal, require_finite, require_non_negative};

/// A stretch of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// How long (s); zero is a step.
    pub duration: f64,
    /// The value at its end, reached linearly; a hold repeats the value before.
    pub end: f64,
}

/// A piecewise linear history.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// The value at time zero.
    pub start: f64,
    /// The stretches in order.
    pub segments: Vec<Segment>,
}

impl History {
    /// From a start value.
    #[must_use]
    pub const fn from(start: f64) -> Self {
        Self { start, segments: Vec::new() }
    }

    /// Followed by a ramp to `end` in `duration`.
    #[must_use]
    pub fn ramp(mut self, end: f64, duration: f64) -> Self {
        self.segments.push(Segment { duration, end });
        self
    }

    /// Followed by a ramp to `end` at a speed given as a positive number.
    #[must_use]
    pub fn at_speed(self, end: f64, speed: f64) -> Self {
        let duration = ((end - self.end()) / speed).abs();
        self.ramp(end, duration)
    }

    /// Followed by a hold.
    #[must_use]
    pub fn hold(self, duration: f64) -> Self {
        let end = self.end();
        self.ramp(end, duration)
    }

    /// Followed by a step.
    #[must_use]
    pub fn step(self, end: f64) -> Self {
        self.ramp(end, 0.0)
    }

    /// The value at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.segments.last().map_or(self.start, |segment| segment.end)
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a value that is not finite or a negative duration.
    pub fn checked(&self) -> Result<(), Refusal> {
        require_finite("start", self.start)?;
        for segment in &self.segments {
            require_non_negative("duration", segment.duration)?;
            require_finite("end", segment.end)?;
        }
        Ok(())
    }
}
