//! What is observed of a material, and how one term of a series answers it.
//!
//! Every observation is a constant plus a sum over the terms, linear in the strengths, with a kernel of x = ωρ or t/ρ alone:
//! ```text
//! storage      E′(ω) = E0 + Σ E_i x²/(1+x²)          relaxation    R(t) = E0 + Σ E_i e^{−x}
//! loss         E″(ω) =      Σ E_i x/(1+x²)           creep         J(t) = 1/E∞ + t/η + Σ J_j (1 − e^{−x})
//! ```

/// What is observed; a set of observations is of moduli (the first three) or of creep, never of both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// E′(ω) (Pa).
    Storage,
    /// E″(ω) (Pa).
    Loss,
    /// R(t) (Pa).
    Relaxation,
    /// J(t) (1/Pa).
    Creep,
}

impl Quantity {
    /// What the constant of the series adds: nothing to a loss.
    pub(super) const fn constant(self) -> f64 {
        match self {
            Self::Loss => 0.0,
            _ => 1.0,
        }
    }

    /// What a unit of flow 1/η adds: t to a creep compliance. The moduli of a liquid need no flow, they are without a constant.
    pub(super) const fn flow(self, at: f64) -> f64 {
        match self {
            Self::Creep => at,
            _ => 0.0,
        }
    }

    /// x = ωρ or t/ρ.
    pub(super) fn argument(self, at: f64, time: f64) -> f64 {
        if self.by_frequency() { at * time } else { at / time }
    }

    /// The kernel at x = ωρ (or t/ρ), and its derivative by ln ρ.
    pub(super) fn kernel(self, x: f64) -> (f64, f64) {
        match self {
            Self::Storage => {
                // x²/(1+x²) and 2x²/(1+x²)² by the smaller of x and 1/x: no overflow at either end.
                let (part, inverse) = if x <= 1.0 {
                    let square = x * x;
                    (square / (1.0 + square), 1.0 / (1.0 + square))
                } else {
                    let square = 1.0 / x / x;
                    (1.0 / (1.0 + square), square / (1.0 + square))
                };
                (part, 2.0 * part * inverse)
            }
            Self::Loss => {
                let small = if x <= 1.0 { x } else { 1.0 / x };
                let value = small / (1.0 + small * small);
                let slope = value * (1.0 - small * small) / (1.0 + small * small);
                (value, if x <= 1.0 { slope } else { -slope })
            }
            Self::Relaxation => {
                let value = (-x).exp();
                (value, if value > 0.0 { x * value } else { 0.0 })
            }
            Self::Creep => {
                let value = (-x).exp();
                (-(-x).exp_m1(), if value > 0.0 { -x * value } else { 0.0 })
            }
        }
    }

    /// Whether `at` is an angular frequency.
    pub(super) const fn by_frequency(self) -> bool {
        matches!(self, Self::Storage | Self::Loss)
    }
}

/// One observed number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// Of what.
    pub quantity: Quantity,
    /// ω (rad/s) or t (s), > 0.
    pub at: f64,
    /// The number (Pa or 1/Pa).
    pub value: f64,
    /// What residuals are divided by, > 0: a value and its scale in the same unit make relative residuals.
    pub scale: f64,
}

/// A loss below this part of |E| is measured no better than this part of |E| (phase angles are read to about 1e-3 rad).
const LEAST_LOSS_ANGLE: f64 = 1e-3;

/// E′ and E″ at one frequency as two observations, each relative to itself.
#[must_use]
pub fn complex_modulus(angular_frequency: f64, storage: f64, loss: f64) -> [Observation; 2] {
    let least = LEAST_LOSS_ANGLE * storage.hypot(loss);
    [
        Observation { quantity: Quantity::Storage, at: angular_frequency, value: storage, scale: storage.abs().max(least) },
        Observation { quantity: Quantity::Loss, at: angular_frequency, value: loss, scale: loss.abs().max(least) },
    ]
}
