//! Materials with a continuous spectrum, and their expansion into the fewest terms for a wanted accuracy.
//!
//! Four numbers each: E0, E∞, a time τ and an exponent. With g the fall from 1 to 0 of the normalised relaxation and h its spectrum,
//! ```text
//! R(t) = E0 + (E∞ − E0) ∫ h(ln ρ) e^{−t/ρ} d ln ρ          E(ω) = E0 + (E∞ − E0) ∫ h(ln ρ) iωρ/(1 + iωρ) d ln ρ
//! modified power law (Williams, 1964)  R = E0 + (E∞ − E0)(1 + t/τ)^{−n}      h = s^n e^{−s}/Γ(n),  s = τ/ρ,  n > 0
//! fractional Zener (Cole–Cole form)    E = E0 + (E∞ − E0)(iωτ)^α/(1 + (iωτ)^α)   h = sin(πα)/(2π[cosh(α ln s) + cos πα]),  0 < α < 1
//! ```
//! The integral over ln ρ converges exponentially by equal steps: the error of a step d is e^{−π²/d} on the axis of frequencies. That
//! is also the rate e^{−nπ²/L} of the best n-term series over frequencies in the ratio e^L (Gonchar's rate for Markov functions: twice
//! the reciprocal capacity of the condenser that the imaginary frequencies form with the negative axis), so what is left to gain lies at the two ends.

mod expand;
mod gamma;

pub use expand::{Expansion, expand};

use super::ComplexModulus;
use crate::refusal::{Refusal, require_non_negative, require_positive};

/// Which law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BroadKind {
    /// Williams's modified power law with its exponent n > 0.
    ModifiedPowerLaw(f64),
    /// The fractional Zener solid with its exponent 0 < α < 1.
    FractionalZener(f64),
}

/// A material with a continuous spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BroadLaw {
    kind: BroadKind,
    relaxed_modulus: f64,
    glassy_modulus: f64,
    time: f64,
}

/// Step of the reference quadrature in ln ρ: e^{−π²/0.2} is far below rounding.
const REFERENCE_STEP: f64 = 0.2;

impl BroadLaw {
    /// A law by its four numbers (Pa, Pa, s, 1).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless 0 ≤ E0 < E∞, τ > 0, n > 0 (and at most 10) or 0 < α < 1.
    pub fn new(kind: BroadKind, relaxed_modulus: f64, glassy_modulus: f64, time: f64) -> Result<Self, Refusal> {
        require_non_negative("relaxed_modulus", relaxed_modulus)?;
        require_positive("glassy_modulus", glassy_modulus)?;
        require_positive("time", time)?;
        if relaxed_modulus >= glassy_modulus {
            return Err(Refusal::out_of_range("relaxed_modulus", relaxed_modulus, "below the glassy modulus"));
        }
        match kind {
            BroadKind::ModifiedPowerLaw(exponent) if !(exponent > 0.01 && exponent <= 10.0) => {
                Err(Refusal::out_of_range("exponent", exponent, "above 0.01 and at most 10"))
            }
            BroadKind::FractionalZener(exponent) if !(exponent > 0.01 && exponent < 1.0) => {
                Err(Refusal::out_of_range("exponent", exponent, "above 0.01 and below 1"))
            }
            _ => Ok(Self { kind, relaxed_modulus, glassy_modulus, time }),
        }
    }

    /// E0 (Pa).
    #[must_use]
    pub const fn relaxed_modulus(&self) -> f64 {
        self.relaxed_modulus
    }

    /// E∞ (Pa).
    #[must_use]
    pub const fn glassy_modulus(&self) -> f64 {
        self.glassy_modulus
    }

    /// h(ln ρ) of the normalised relaxation: integral 1 over ln ρ.
    #[must_use]
    pub fn spectrum(&self, relaxation_time: f64) -> f64 {
        let s = self.time / relaxation_time;
        match self.kind {
            BroadKind::ModifiedPowerLaw(exponent) => (exponent * s.ln() - s - gamma::ln_gamma(exponent)).exp(),
            BroadKind::FractionalZener(exponent) => {
                let angle = std::f64::consts::PI * exponent;
                angle.sin() / (std::f64::consts::TAU * ((exponent * s.ln()).cosh() + angle.cos()))
            }
        }
    }

    /// How far from the axis of ln ρ, at ρ = τ, the nearest pole of the spectrum lies; infinite if it has none.
    fn pole_distance(&self) -> f64 {
        match self.kind {
            BroadKind::FractionalZener(exponent) => std::f64::consts::PI * (1.0 - exponent) / exponent,
            BroadKind::ModifiedPowerLaw(_) => f64::INFINITY,
        }
    }

    /// The complex modulus at an angular frequency > 0 (rad/s).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the frequency is positive and finite.
    pub fn complex_modulus(&self, angular_frequency: f64) -> Result<ComplexModulus, Refusal> {
        let x = require_positive("angular_frequency", angular_frequency)? * self.time;
        let gained = self.glassy_modulus - self.relaxed_modulus;
        let (storage, loss) = match self.kind {
            // z^α/(1 + z^α) at z = ix, with y = x^α and the angle πα/2, divided by y above 1.
            BroadKind::FractionalZener(exponent) => {
                let (sine, cosine) = (0.5 * std::f64::consts::PI * exponent).sin_cos();
                let y = x.powf(exponent);
                let (a, b) = if y <= 1.0 { (1.0, y) } else { (1.0 / y, 1.0) };
                let denominator = a * a + 2.0 * a * b * cosine + b * b;
                (b * (a * cosine + b) / denominator, a * b * sine / denominator)
            }
            BroadKind::ModifiedPowerLaw(exponent) => power_law(exponent, x),
        };
        Ok(ComplexModulus { storage: self.relaxed_modulus + gained * storage, loss: gained * loss })
    }
}

/// ∫ h(s) ix/(s + ix) d ln s of the modified power law, by equal steps of ln s.
fn power_law(exponent: f64, x: f64) -> (f64, f64) {
    let norm = -gamma::ln_gamma(exponent);
    // Above s = 750 nothing is left of e^{−s}; below, s^n is summed until it is under rounding.
    let (mut storage, mut loss) = (0.0, 0.0);
    let mut place = 750.0_f64.ln();
    let last = (-40.0 / exponent).min(x.ln() - 40.0 / exponent);
    while place > last {
        let s = place.exp();
        let weight = (exponent * place - s + norm).exp() * REFERENCE_STEP;
        let (a, b) = if s <= x { (s / x, 1.0) } else { (1.0, x / s) };
        let denominator = a * a + b * b;
        storage += weight * b * b / denominator;
        loss += weight * a * b / denominator;
        place -= REFERENCE_STEP;
    }
    (storage, loss)
}
