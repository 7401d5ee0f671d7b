//! The periodic logarithm: the shape of a half-plane's surface under equal line loads one period apart.
//!
//! ```text
//! L(x) = log|2 sin(x/2)| = −Σ_{m≥1} cos(mx)/m = −Cl₂′(x)       even, period 2π, mean zero; −∞ at x = 0, log 2 at x = π
//! ```
//! Absolute error at most 2e-16·(1 + |L|); L vanishes at ±π/3, where the relative error of any double is unbounded.
//! Source: the real part of log(1 − e^{ix}); its Fourier series is DLMF 4.6.1 on the unit circle.

use super::angle::Angle;

/// L of an angle; −∞ (never a NaN) at a multiple of 2π.
#[must_use]
pub fn log_sine(angle: Angle) -> f64 {
    (2.0 * (0.5 * angle.signed()).sin().abs()).ln()
}
