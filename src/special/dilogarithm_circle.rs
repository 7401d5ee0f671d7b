//! The dilogarithm on the unit circle.
//!
//! ```text
//! Li₂(e^{ix}) = Σ_{m≥1} e^{imx}/m² = [π²/6 − x(2π − x)/4] + i Cl₂(x),     0 ≤ x ≤ 2π
//! ```
//! The real part is π² B₂(x/2π), Bernoulli's polynomial; away from x = 0 it is formed from the distance y = π − |x| to the half turn, as
//! (y² − π²/3)/4. Absolute error at most 5e-16 (the part vanishes at y = π/√3, so no relative bound exists); the
//! imaginary part is relative, see [`clausen`].
//! Higher orders are not offered: the expansions of [`super::memory_clausen`] about x = 0 replace the series in Li_{3+k} that the large
//! sliding speeds would otherwise need, with fewer operations.
//! Source: DLMF 25.12.8 (real part), 25.12.9 (imaginary part as an integral).

use super::angle::Angle;
use super::clausen::clausen;
use std::f64::consts::PI;

/// Li₂(e^{ix}) by its two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircleDilogarithm {
    /// Σ cos(mx)/m².
    pub real: f64,
    /// Σ sin(mx)/m² = Cl₂(x).
    pub imaginary: f64,
}

/// Li₂ of the point of the unit circle at an angle.
#[must_use]
pub fn dilogarithm_on_circle(angle: Angle) -> CircleDilogarithm {
    let (size, y) = (angle.signed().abs(), angle.to_half_turn());
    let real = if size < 1.0 { PI * PI / 6.0 - 0.25 * size * (2.0 * PI - size) } else { 0.25 * (y * y - PI * PI / 3.0) };
    CircleDilogarithm { real, imaginary: clausen(angle) }
}
