//! What is imposed: a chain of segments of the penetration, or of a force or frame, each a straight way with an oscillation upon it. A segment becomes a branch
//! when it begins, from the value that its quantity has by then.
//!
//! | symbol | name |
//! |---|---|
//! | Δ(t) = level + rate·u + amplitude·[sin(ωu + φ) − sin φ] | u = t − start |
//! | P_i(t) = E_i∫₀ᵗ e^{−(t−t′)/ρ_i} dΔ(t′) | memory of Maxwell branch i of a point that has always been bonded |
//!
//! Both are analytic on a branch, and are continued analytically beyond its ends: a panel of the path may reach over a corner of the
//! history and is cut there.

use super::chain::Chain;
use super::followed::Control;
use crate::indentation::Oscillation;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Rounding of a value that a straight way has led to, over it.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// One branch.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Branch {
    /// What it is the value of, if not Δ.
    pub(super) control: Option<Control>,
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) level: f64,
    pub(super) rate: f64,
    pub(super) amplitude: f64,
    pub(super) omega: f64,
    pub(super) phase: f64,
    /// P_i at its start.
    pub(super) memory: Vec<f64>,
}

/// What the drive does at an instant.
#[derive(Debug, Clone, Default)]
pub(super) struct Instant {
    /// Time since the origin of the line.
    pub(super) time: f64,
    /// Δ and its rate.
    pub(super) depth: f64,
    pub(super) rate: f64,
    /// P_i.
    pub(super) memory: Vec<f64>,
    /// E0Δ + ΣP_i and its rate.
    pub(super) base: f64,
    pub(super) base_rate: f64,
}

impl Branch {
    pub(super) fn oscillation(&self, u: f64) -> (f64, f64) {
        let angle = self.omega * u + self.phase;
        (self.amplitude * (angle.sin() - self.phase.sin()), self.amplitude * self.omega * angle.cos())
    }

    /// Whether it takes no time: nothing is left of it.
    pub(super) fn is_over(&self) -> bool {
        self.end <= self.start
    }

    /// Whether Δ does not change.
    pub(super) fn is_held(&self) -> bool {
        self.rate == 0.0 && self.amplitude == 0.0
    }

    /// The value and its rate, `u` after its start.
    pub(super) fn value(&self, u: f64) -> (f64, f64) {
        let (deviation, speed) = self.oscillation(u);
        (self.level + self.rate * u + deviation, self.rate + speed)
    }

    /// The instant `u` after its start; the time is left to the caller.
    pub(super) fn at(&self, chain: &Chain, u: f64, instant: &mut Instant) {
        let (deviation, speed) = self.oscillation(u);
        instant.depth = self.level + self.rate * u + deviation;
        instant.rate = self.rate + speed;
        instant.memory.clear();
        (instant.base, instant.base_rate) = (chain.relaxed * instant.depth, chain.relaxed * instant.rate);
        let angle = self.omega * u + self.phase;
        let (sin, cos, sin0, cos0) =
            if self.amplitude == 0.0 { (0.0, 0.0, 0.0, 0.0) } else { (angle.sin(), angle.cos(), self.phase.sin(), self.phase.cos()) };
        for (&(modulus, rate), &before) in chain.relaxation.iter().zip(&self.memory) {
            let fallen = (-u * rate).exp_m1();
            let mut value = before * (1.0 + fallen) - modulus * self.rate / rate * fallen;
            if self.amplitude != 0.0 {
                let x = self.omega / rate;
                let response = (cos + x * sin) - (1.0 + fallen) * (cos0 + x * sin0);
                value += modulus * self.amplitude * x / (1.0 + x * x) * response;
            }
            instant.memory.push(value);
            instant.base += value;
            instant.base_rate += modulus * instant.rate - value * rate;
        }
    }
}

/// What is asked of a segment of the history.
#[derive(Debug, Clone)]
pub(super) struct DriveSegment {
    /// What is given, if not Δ.
    pub(super) control: Option<Control>,
    /// Its value at the end, reached along a straight way from the present one; at once if there is no duration.
    pub(super) end: f64,
    pub(super) duration: f64,
    /// An oscillation of one frequency upon the straight way.
    pub(super) oscillation: Option<Oscillation>,
    /// Which segment of the problem it is, or begins with.
    pub(super) segment: usize,
}

/// The whole history.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    /// What is given at first, and its value.
    pub(super) start: (Option<Control>, f64),
    pub(super) segments: Vec<DriveSegment>,
}

impl DriveSegment {
    /// Whether it takes no time.
    pub(super) fn is_sudden(&self) -> bool {
        self.duration <= 0.0
    }

    /// As a branch from an instant and a value on.
    pub(super) fn branch(&self, start: f64, value: f64, memory: Vec<f64>) -> Branch {
        let (amplitude, omega, phase) = self.oscillation.map_or((0.0, 0.0, 0.0), |o| (o.amplitude, TAU * o.frequency, o.phase));
        let control = self.control;
        // What is held is held, but for the rounding of how it came there.
        let value = if (self.end - value).abs() <= ROUNDING * value.abs() { self.end } else { value };
        if self.duration <= 0.0 {
            return Branch { control, start, end: start, level: self.end, rate: 0.0, amplitude: 0.0, omega: 0.0, phase: 0.0, memory };
        }
        let rate = (self.end - value) / self.duration;
        Branch { control, start, end: start + self.duration, level: value, rate, amplitude, omega, phase, memory }
    }
}
