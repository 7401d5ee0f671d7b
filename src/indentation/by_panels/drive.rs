//! What is imposed: the penetration as a chain of branches, each a straight way with an oscillation upon it.
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

/// One branch.
#[derive(Debug, Clone)]
pub(super) struct Branch {
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

/// The whole history.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    /// What the branches give, if not Δ.
    pub(super) control: Option<Control>,
    pub(super) branches: Vec<Branch>,
    /// The value after a step that no branch follows yet.
    stepped: Option<f64>,
}

impl Drive {
    /// From a penetration; relaxed (P = 0 for ever before) or untouched alike.
    pub(super) fn from(level: f64) -> Self {
        Self {
            control: None,
            stepped: None,
            branches: vec![Branch { start: 0.0, end: 0.0, level, rate: 0.0, amplitude: 0.0, omega: 0.0, phase: 0.0, memory: Vec::new() }],
        }
    }

    pub(super) fn push(mut self, chain: &Chain, duration: f64, rate: f64, (amplitude, omega, phase): (f64, f64, f64)) -> Self {
        let mut instant = Instant::default();
        let (start, level, memory) = match self.branches.last() {
            Some(last) if last.end > last.start => {
                last.at(chain, last.end - last.start, &mut instant);
                (last.end, instant.depth, instant.memory)
            }
            Some(last) => (last.end, last.level, vec![0.0; chain.terms()]),
            None => (0.0, 0.0, vec![0.0; chain.terms()]),
        };
        let level = self.stepped.take().unwrap_or(level);
        if self.branches.len() == 1 && self.branches[0].end <= self.branches[0].start {
            self.branches.clear();
        }
        self.branches.push(Branch { start, end: start + duration, level, rate, amplitude, omega, phase, memory });
        self
    }

    /// Followed by a sudden step of a value that is no penetration.
    pub(super) fn step(mut self, value: f64) -> Self {
        self.stepped = Some(value);
        self
    }

    /// Followed by a ramp at a rate for a duration.
    pub(super) fn ramp(self, chain: &Chain, rate: f64, duration: f64) -> Self {
        self.push(chain, duration, rate, (0.0, 0.0, 0.0))
    }

    /// Followed by a ramp with an oscillation upon it, rate·u + amplitude·sin(ωu).
    pub(super) fn oscillate(self, chain: &Chain, rate: f64, amplitude: f64, omega: f64, duration: f64) -> Self {
        self.push(chain, duration, rate, (amplitude, omega, 0.0))
    }
}
