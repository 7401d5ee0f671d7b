//! A penetration that has oscillated for ever, and what it leaves in a chain.
//!
//! ```text
//! Δ(t) = mean + amplitude sin ωt,      P_i(t) = E_i amplitude x/(1 + x²)·[cos ωt + x sin ωt],      x = ωρ_i
//! ```

use super::super::chain::Chain;

/// Δ(t).
#[derive(Debug, Clone, Copy)]
pub(super) struct Sinus {
    pub(super) mean: f64,
    pub(super) amplitude: f64,
    pub(super) omega: f64,
}

impl Sinus {
    pub(super) fn depth(&self, time: f64) -> f64 {
        self.mean + self.amplitude * (self.omega * time).sin()
    }

    pub(super) fn rate(&self, time: f64) -> f64 {
        self.amplitude * self.omega * (self.omega * time).cos()
    }

    /// P_i of a point that has always been bonded.
    pub(super) fn memory(&self, chain: &Chain, time: f64) -> Vec<f64> {
        let (sin, cos) = (self.omega * time).sin_cos();
        let of = |&(modulus, rate): &(f64, f64)| {
            let x = self.omega / rate;
            modulus * self.amplitude * (x / (1.0 + x * x)) * (cos + x * sin)
        };
        chain.relaxation.iter().map(of).collect()
    }

    /// ∫ e^{−r(to − t)} (Δ − height) r dt between two instants: what it adds to a dashpot of rate r. Each term keeps its digits however slow the dashpot is.
    pub(super) fn creep(&self, rate: f64, height: f64, from: f64, to: f64) -> f64 {
        let x = self.omega / rate;
        let fallen = (-(to - from) * rate).exp_m1();
        let (sin, cos) = (self.omega * from).sin_cos();
        let (middle, half) = (0.5 * self.omega * (from + to), (0.5 * self.omega * (to - from)).sin());
        let (by_sin, by_cos) = (2.0 * middle.cos() * half, -2.0 * middle.sin() * half);
        let swing = by_sin - x * by_cos - fallen * (sin - x * cos);
        (height - self.mean) * fallen + self.amplitude / (1.0 + x * x) * swing
    }
}
