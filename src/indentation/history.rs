//! What is imposed in time: a quantity that goes from value to value, linearly, oscillating, or at once; each segment names its quantity.

use super::oscillation::Oscillation;
use crate::refusal::{Refusal, require_finite, require_non_negative};
use serde::{Deserialize, Serialize};

/// What a segment of a history controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Controlled {
    /// Δ (m).
    Penetration,
    /// F (N), compression positive.
    Force,
    /// a (m): Δ follows from the edge condition.
    ContactRadius,
    /// The far end of the frame, Δ + F/k_f (m): a real rig is neither stiff nor soft.
    Frame,
}

/// A segment of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// How long (s); zero is a step.
    pub duration: f64,
    /// The value at its end (m or N), reached linearly from the present one.
    pub end: f64,
    /// Of what.
    pub controlled: Controlled,
    /// An oscillation upon the straight way; without a phase it starts at its mean.
    pub oscillation: Option<Oscillation>,
}

impl Segment {
    /// The way from a value (m or N), at a time (s) since its start.
    #[must_use]
    pub fn value(&self, from: f64, time: f64) -> f64 {
        let part = time / self.duration;
        let mean = if part >= 1.0 || self.duration == 0.0 { self.end } else { from + (self.end - from) * part };
        mean + self.oscillation.map_or(0.0, |oscillation| oscillation.deviation(time.min(self.duration), self.duration))
    }
}

/// A history of segments, straight or with an oscillation.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// The value at time zero.
    pub start: f64,
    /// Of what.
    pub controlled: Controlled,
    /// The segments in order.
    pub segments: Vec<Segment>,
}

impl History {
    /// From a start value (m or N) of a quantity.
    #[must_use]
    pub const fn from(controlled: Controlled, start: f64) -> Self {
        Self { start, controlled, segments: Vec::new() }
    }

    /// From a penetration (m).
    #[must_use]
    pub const fn penetration(start: f64) -> Self {
        Self::from(Controlled::Penetration, start)
    }

    /// From a force (N).
    #[must_use]
    pub const fn force(start: f64) -> Self {
        Self::from(Controlled::Force, start)
    }

    /// From a contact radius (m).
    #[must_use]
    pub const fn contact_radius(start: f64) -> Self {
        Self::from(Controlled::ContactRadius, start)
    }

    /// From a place of the far end of the frame (m).
    #[must_use]
    pub const fn frame(start: f64) -> Self {
        Self::from(Controlled::Frame, start)
    }

    /// Followed by a ramp of a quantity, from its value by then, to `end` in `duration`.
    #[must_use]
    pub fn then(mut self, controlled: Controlled, end: f64, duration: f64) -> Self {
        self.segments.push(Segment { duration, end, controlled, oscillation: None });
        self
    }

    /// Followed by an oscillation about the present value of the same quantity, for a duration.
    #[must_use]
    pub fn oscillate(self, oscillation: Oscillation, duration: f64) -> Self {
        let end = self.end();
        self.ramp_oscillating(end, oscillation, duration)
    }

    /// Followed by a ramp of the same quantity to `end` in `duration` with an oscillation upon it.
    #[must_use]
    pub fn ramp_oscillating(mut self, end: f64, oscillation: Oscillation, duration: f64) -> Self {
        let controlled = self.controlled();
        self.segments.push(Segment { duration, end, controlled, oscillation: Some(oscillation) });
        self
    }

    /// Followed by a ramp of the same quantity to `end` in `duration`.
    #[must_use]
    pub fn ramp(self, end: f64, duration: f64) -> Self {
        let controlled = self.controlled();
        self.then(controlled, end, duration)
    }

    /// Followed by a ramp of the same quantity to `end` at a speed given as a positive number.
    #[must_use]
    pub fn at_speed(self, end: f64, speed: f64) -> Self {
        let duration = ((end - self.end()) / speed).abs();
        self.ramp(end, duration)
    }

    /// Followed by a hold of the same quantity (s).
    #[must_use]
    pub fn hold(self, duration: f64) -> Self {
        let end = self.end();
        self.ramp(end, duration)
    }

    /// Followed by a step of the same quantity (to m or N).
    #[must_use]
    pub fn step(self, end: f64) -> Self {
        self.ramp(end, 0.0)
    }

    /// The value at the end; after an oscillation, what it has reached.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.segments.last().map_or(self.start, |segment| segment.value(segment.end, segment.duration))
    }

    /// What is controlled at the end.
    #[must_use]
    pub fn controlled(&self) -> Controlled {
        self.segments.last().map_or(self.controlled, |segment| segment.controlled)
    }

    /// Whether any segment controls a quantity.
    #[must_use]
    pub fn controls(&self, controlled: Controlled) -> bool {
        self.controlled == controlled || self.segments.iter().any(|segment| segment.controlled == controlled)
    }

    /// Whether one quantity is controlled throughout, and never rises.
    #[must_use]
    pub(crate) fn only_withdraws(&self) -> bool {
        let mut last = self.start;
        self.segments.iter().all(|segment| {
            let falls = segment.controlled == self.controlled && segment.oscillation.is_none() && segment.end <= last;
            last = segment.end;
            falls
        })
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a value that is not finite or a negative duration; [`Refusal::Undefined`] for a contact radius that oscillates.
    pub fn checked(&self) -> Result<(), Refusal> {
        require_finite("start", self.start)?;
        for segment in &self.segments {
            require_non_negative("duration", segment.duration)?;
            require_finite("end", segment.end)?;
            if let Some(oscillation) = segment.oscillation {
                oscillation.checked()?;
                if segment.controlled == Controlled::ContactRadius {
                    return Err(Refusal::Undefined {
                        quantity: "an oscillating contact radius",
                        reason: "oscillations are of the penetration, the force or the frame".into(),
                    });
                }
            }
        }
        Ok(())
    }
}
