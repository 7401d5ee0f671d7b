//! An oscillation about what a segment of a history goes through: a sinus of one frequency, or of one that goes up or down.

use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Frequencies nearer than this, relative, are the same: the formulas of a sweep divide by their difference.
const SAME_FREQUENCY: f64 = 1e-9;

/// How a frequency goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum FrequencySweep {
    /// f linear in time.
    Linear,
    /// ln f linear in time.
    Logarithmic,
}

/// amplitude·sin 2πN(t), N the cycles since the start of the segment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Oscillation {
    /// Of the controlled quantity, in its unit; ≥ 0.
    pub amplitude: f64,
    /// Cycles per time (1/s) at the start of the segment.
    pub frequency: f64,
    /// The same at its end (1/s).
    pub end_frequency: f64,
    /// How it goes from one to the other.
    pub sweep: FrequencySweep,
    /// Where in its cycle it begins (rad): 0 at the mean and going up, π/2 at the greatest value.
    #[serde(default)]
    pub phase: f64,
    /// Whether the segment ends with the first cycle that is stationary, to the accuracy of the problem.
    pub until_stationary: bool,
}

impl Oscillation {
    /// One frequency (1/s).
    #[must_use]
    pub const fn steady(amplitude: f64, frequency: f64) -> Self {
        Self { amplitude, frequency, end_frequency: frequency, sweep: FrequencySweep::Linear, phase: 0.0, until_stationary: false }
    }

    /// A frequency (1/s) that goes to another.
    #[must_use]
    pub const fn swept(amplitude: f64, frequency: f64, end_frequency: f64, sweep: FrequencySweep) -> Self {
        Self { amplitude, frequency, end_frequency, sweep, phase: 0.0, until_stationary: false }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative amplitude or a frequency that is not positive.
    pub fn checked(&self) -> Result<(), Refusal> {
        require_non_negative("amplitude", self.amplitude)?;
        require_positive("frequency", self.frequency)?;
        require_positive("end_frequency", self.end_frequency)?;
        require_finite("phase", self.phase)?;
        Ok(())
    }

    /// The frequency (1/s) at a time of a segment.
    #[must_use]
    pub fn frequency_at(&self, time: f64, duration: f64) -> f64 {
        if duration <= 0.0 {
            return self.frequency;
        }
        let part = time / duration;
        match self.sweep {
            FrequencySweep::Linear => self.frequency + (self.end_frequency - self.frequency) * part,
            FrequencySweep::Logarithmic => self.frequency * (self.end_frequency / self.frequency).powf(part),
        }
    }

    /// N, cycles gone by at a time (s) of a segment.
    #[must_use]
    pub fn cycles_at(&self, time: f64, duration: f64) -> f64 {
        if duration <= 0.0 {
            return 0.0;
        }
        let ratio = self.end_frequency / self.frequency;
        match self.sweep {
            FrequencySweep::Linear => time * (self.frequency + 0.5 * (self.end_frequency - self.frequency) * time / duration),
            FrequencySweep::Logarithmic if (ratio - 1.0).abs() > SAME_FREQUENCY => {
                self.frequency * duration * (ratio.ln() * time / duration).exp_m1() / ratio.ln()
            }
            FrequencySweep::Logarithmic => self.frequency * time,
        }
    }

    /// The time of a segment at which so many cycles have gone by; none if the segment has not so many.
    #[must_use]
    pub fn time_of(&self, cycles: f64, duration: f64) -> Option<f64> {
        let last = self.cycles_at(duration, duration);
        if cycles > last * (1.0 + 1e-12) {
            return None;
        }
        let ratio = self.end_frequency / self.frequency;
        let time = match self.sweep {
            FrequencySweep::Linear => {
                // The root of a quadratic that keeps its digits for either sign of the slope.
                let slope = (self.end_frequency - self.frequency) / duration;
                let root = (self.frequency * self.frequency + 2.0 * slope * cycles).max(0.0).sqrt();
                2.0 * cycles / (self.frequency + root)
            }
            FrequencySweep::Logarithmic if (ratio - 1.0).abs() > SAME_FREQUENCY => {
                duration * (cycles * ratio.ln() / (self.frequency * duration)).ln_1p() / ratio.ln()
            }
            FrequencySweep::Logarithmic => cycles / self.frequency,
        };
        Some(time.min(duration))
    }

    /// Where in its cycle it is at a time of a segment (rad), up to whole cycles: sin keeps its digits after a million of them.
    #[must_use]
    pub fn angle(&self, time: f64, duration: f64) -> f64 {
        let cycles = self.cycles_at(time, duration);
        TAU * (cycles - cycles.round()) + self.phase
    }

    /// How far it is at a time of a segment from where it began, in the unit of the controlled quantity.
    #[must_use]
    pub fn deviation(&self, time: f64, duration: f64) -> f64 {
        self.amplitude * self.angle(time, duration).sin() - self.offset()
    }

    /// How far above its mean it begins, in the unit of the controlled quantity.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.amplitude * self.phase.sin()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn times_and_cycles_are_inverse() {
        for sweep in [FrequencySweep::Linear, FrequencySweep::Logarithmic] {
            for end in [3.0, 0.03, 300.0, 3.0 * (1.0 + 1e-12)] {
                let oscillation = Oscillation::swept(1.0, 3.0, end, sweep);
                let duration = 7.0;
                // N is the integral of f: Simpson on fine parts.
                let parts = 4000;
                let step = duration / f64::from(parts);
                let integral: f64 = (0..parts)
                    .map(|k| {
                        let at = |x: f64| oscillation.frequency_at((f64::from(k) + x) * step, duration);
                        step * (at(0.0) + 4.0 * at(0.5) + at(1.0)) / 6.0
                    })
                    .sum();
                let cycles = oscillation.cycles_at(duration, duration);
                assert!((integral / cycles - 1.0).abs() < 1e-10, "{sweep:?} {end}");
                for part in [0.1, 0.5, 0.9] {
                    let time = oscillation.time_of(part * cycles, duration).unwrap();
                    assert!((oscillation.cycles_at(time, duration) / (part * cycles) - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}
