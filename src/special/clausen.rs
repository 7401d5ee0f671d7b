//! Clausen's integral, the antiderivative of the periodic logarithm of a line load.
//!
//! ```text
//! Cl₂(x) = −∫₀^x log|2 sin(t/2)| dt = Σ_{m≥1} sin(mx)/m²        odd, period 2π, zero at 0 and π
//! Cl₂(x) ≈ x − x log|x| as x → 0 (infinite slope),   (π − x) log 2 as x → π,   1.014941606 at π/3 (its maximum)
//! ```
//! | range | series | terms |
//! |---|---|---|
//! | \|x\| ≤ 1.8 | x − x log\|x\| + x Σ ζ(2k)/(k(2k+1)) (x/2π)^{2k} | 17, 1.09 digits each at 1.8 |
//! | else, y = π − \|x\| | y log 2 − y Σ (1 − 4^{−k})ζ(2k)/(k(2k+1)) (y/π)^{2k} | 24, 0.74 digits each at y = 1.34 |
//!
//! Accuracy: relative, for every double, because the argument is an [`Angle`]; the largest relative error over the 58 rows of `clausen.csv` is
//! 2.2e-16.
//! Sources: Lewin, *Polylogarithms and Associated Functions* (1981), Ch 4; DLMF 25.12.9 (the integral). Both series are the twice
//! integrated product forms of the sine and cosine, DLMF 4.22.1 and 4.22.2.

use super::angle::Angle;
use super::even_zeta::EVEN_ZETA;
use std::f64::consts::{LN_2, PI};
use std::sync::LazyLock;

/// The two series need about equally many terms on either side of this angle.
const NEAR_BELOW: f64 = 1.8;
const NEAR_TERMS: usize = 17;
const FAR_TERMS: usize = 24;

/// ζ(2k)/(k(2k+1)), k = 1, 2, …
static NEAR: LazyLock<[f64; NEAR_TERMS]> = LazyLock::new(|| {
    std::array::from_fn(|index| {
        let k = (index + 1) as f64;
        EVEN_ZETA[index] / (k * (2.0 * k + 1.0))
    })
});

/// (1 − 4^{−k}) ζ(2k)/(k(2k+1)), k = 1, 2, …
static FAR: LazyLock<[f64; FAR_TERMS]> = LazyLock::new(|| {
    std::array::from_fn(|index| {
        let k = (index + 1) as f64;
        (1.0 - 0.25_f64.powf(k)) * EVEN_ZETA[index] / (k * (2.0 * k + 1.0))
    })
});

/// Σ_k c_k t^k, k = 1, 2, … by Horner's rule.
fn series(coefficients: &[f64], t: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| (sum + coefficient) * t)
}

/// Cl₂ of an angle.
#[must_use]
pub fn clausen(angle: Angle) -> f64 {
    let x = angle.signed();
    let size = x.abs();
    if size == 0.0 {
        return x;
    }
    if size <= NEAR_BELOW {
        let scaled = x / (2.0 * PI);
        return x * ((1.0 - size.ln()) + series(NEAR.as_slice(), scaled * scaled));
    }
    let y = angle.to_half_turn();
    let scaled = y / PI;
    (y * (LN_2 - series(FAR.as_slice(), scaled * scaled))).copysign(x)
}
