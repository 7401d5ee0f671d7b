//! Growth under a constant load in a solid of one term, in closed form: the truth of the growth studies.
//!
//! With q = x₀/δ, w = e^{t/τ} and c = (1 − 1/k)/(1 − 1/β), k = K²/(2ΔγE0) (one deformable half):
//! ```text
//! dw/dq = (w(q) − w(q − 1))/c,   w = 1 for q < 0,  w(0⁺) = 1/c          (thesis Eqs 5.56–5.60, mended)
//! q = n + s:   w = 1 + e^{s/c}P_n(s),   P_0 = 1/c − 1,   P_n′ = −P_{n−1}/c,   P_n(0) = e^{1/c}P_{n−1}(1)
//! ```
//! Polynomials of degree n: exact, and shared with no solver.

/// One solid under one load.
pub(in crate::studies) struct KnownGrowth {
    retardation_time: f64,
    part: f64,
    /// Coefficients of P_n, lowest power first.
    polynomials: Vec<Vec<f64>>,
}

impl KnownGrowth {
    /// τ, β and k, for growth over as many zones.
    pub(in crate::studies) fn new(retardation_time: f64, stiffening_ratio: f64, load_ratio: f64, zones: usize) -> Self {
        let part = (1.0 - 1.0 / load_ratio) / (1.0 - 1.0 / stiffening_ratio);
        let mut polynomials = vec![vec![1.0 / part - 1.0]];
        for zone in 1..zones {
            let before: &[f64] = polynomials.get(zone - 1).map_or(&[], Vec::as_slice);
            let start = (1.0 / part).exp() * value(before, 1.0);
            let mut next = vec![start];
            next.extend(before.iter().enumerate().map(|(power, factor)| -factor / (part * (power + 1) as f64)));
            polynomials.push(next);
        }
        Self { retardation_time, part, polynomials }
    }

    /// t_d (s).
    pub(in crate::studies) fn delay(&self) -> f64 {
        -self.retardation_time * self.part.ln()
    }

    /// When the tip has run q zones (s); NaN beyond the zones asked for.
    pub(in crate::studies) fn time(&self, zones: f64) -> f64 {
        let number = zones.floor();
        let place = zones - number;
        let polynomial = self.polynomials.get(number as usize);
        polynomial.map_or(f64::NAN, |factors| self.retardation_time * ((place / self.part).exp() * value(factors, place)).ln_1p())
    }

    /// x₀/δ at a time (s) after the delay, by halving.
    pub(in crate::studies) fn place(&self, time: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.polynomials.len() as f64 - 1e-12);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if self.time(middle) < time { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

fn value(factors: &[f64], place: f64) -> f64 {
    factors.iter().rev().fold(0.0, |sum, factor| sum * place + factor)
}
