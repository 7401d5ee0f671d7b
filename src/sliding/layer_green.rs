//! The periodic Green's function of a viscoelastic layer in steady sliding.
//!
//! ```text
//! 𝒢_layer(x) = 𝒢(x) + (1/π) Re Σ_{m=1}^{M} (A_m/m) Ĉ_m e^{imx}          w without its mean (2.16)
//! ```
//! A constant Poisson ratio lets every harmonic keep its elastic factor S_m = 1 − A_m and take its own complex compliance Ĉ_m. Notation: [`super`],
//! factors and their limits: [`super::layer`].
//!
//! # How
//! A_m falls as (mkd)² e^{−2mkd}: the sum ends at M = 25/kd, where |A| < 1e-18, and what is left out is bounded by the geometric series from its first
//! term (the ratio of neighbours is below e^{−1.8kd} from mkd = 20 on). It is summed by Horner's rule in e^{ix}, whose rounding is bounded by
//! ε Σ m|A_m|/m: the same as one ulp of x would do. A thin free layer bends by A_1 ≈ −6/(kd)³, and the bound is relative to that.
//!
//! Cost: M complex products a value, 5 to 7 ns each (12 µs at kd = 0.01), ten times that to prepare. Layers thinner than kd = 1e-3 are summed by
//! an integral over the harmonics (`thin_layer.rs`), at 0.1 to 1 ms a value whatever kd; far from the load then with S instead of A, so that the
//! small displacement of a thin confined layer keeps its digits.

use super::green::HalfPlaneGreen;
use super::layer::Layer;
use super::thin_layer::{FAR, Factor, HarmonicSum};
use crate::estimate::Estimate;
use crate::refusal::{Refusal, require_positive};
use crate::special::angle::Angle;
use std::f64::consts::PI;

/// mkd of the last harmonic: A = 4·25²·e^{−50} = 5e-19.
const LAST_PRODUCT: f64 = 25.0;
/// Layers thinner than this, in kd, are not summed harmonic by harmonic.
const THIN: f64 = 1e-3;
/// Error of an integral over the harmonics, relative to the integral of magnitudes (measured: 1e-15).
const INTEGRAL_ERROR: f64 = 2e-14;
/// Relative error of one amplitude A_mĈ_m/m.
const AMPLITUDE_ERROR: f64 = 4e-15;

/// The kernel of a layer: prepared once per speed and thickness.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerGreen {
    half_plane: HalfPlaneGreen,
    layer: Layer,
    /// A_mĈ_m/m for m = 1 … M, as (real, imaginary).
    amplitudes: Vec<(f64, f64)>,
    /// Σ_{m>M} |A_m|/m at most.
    truncation: f64,
    /// Rounding of the sum, and of its antiderivative.
    rounding: (f64, f64),
}

impl LayerGreen {
    /// Prepares the kernel of a layer made of the solid of `half_plane`.
    #[must_use]
    pub fn new(half_plane: HalfPlaneGreen, layer: Layer) -> Self {
        let thickness = layer.thickness_times_wave_number();
        if thickness < THIN {
            return Self { half_plane, layer, amplitudes: Vec::new(), truncation: 0.0, rounding: (0.0, 0.0) };
        }
        let count = (LAST_PRODUCT / thickness).ceil().max(1.0) as usize;
        let mut amplitudes = Vec::with_capacity(count);
        let (mut of_value, mut of_antiderivative) = (0.0, 0.0);
        for index in 1..=count {
            let m = index as f64;
            let (real, imaginary) = half_plane.memory().harmonic_compliance(m);
            let factor = layer.correction(m) / m;
            amplitudes.push((factor * real, factor * imaginary));
            let size = factor.abs() * real.hypot(imaginary);
            of_value += size * (AMPLITUDE_ERROR + 2.0 * f64::EPSILON * m);
            of_antiderivative += size / m * (AMPLITUDE_ERROR + 2.0 * f64::EPSILON * m);
        }
        let next = (count + 1) as f64;
        let truncation = layer.correction(next).abs() / next / -(-1.8 * thickness).exp_m1();
        Self { half_plane, layer, amplitudes, truncation, rounding: (of_value, of_antiderivative) }
    }

    /// The half-plane's kernel of the same solid.
    #[must_use]
    pub const fn half_plane(&self) -> &HalfPlaneGreen {
        &self.half_plane
    }

    /// The layer.
    #[must_use]
    pub const fn layer(&self) -> &Layer {
        &self.layer
    }

    /// The sum of a thin layer; none where harmonics are summed one by one.
    fn thin(&self, factor: Factor, power: i32) -> Option<HarmonicSum<'_>> {
        self.amplitudes.is_empty().then(|| HarmonicSum { layer: &self.layer, memory: self.half_plane.memory(), factor, power })
    }

    /// How many harmonics are summed one by one; none of a thin layer.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.amplitudes.len()
    }

    /// 𝒢_layer at a position x (in 1/k).
    ///
    /// # Errors
    /// As [`HalfPlaneGreen::value`].
    pub fn value(&self, position: f64) -> Result<Estimate, Refusal> {
        let angle = Angle::new(position)?.signed();
        if angle.abs() > FAR * self.layer.thickness_times_wave_number()
            && let Some(sum) = self.thin(Factor::Compliance, 1)
        {
            let (sum, size) = sum.at(angle);
            return Ok(Estimate::new(-sum.re / PI, INTEGRAL_ERROR * size / PI));
        }
        let half_plane = self.half_plane.value(position)?;
        let correction = self.correction(position)?;
        let value = half_plane.value + correction.value;
        Ok(Estimate::new(value, half_plane.error + correction.error + f64::EPSILON * value.abs()))
    }

    /// 𝒢_layer − 𝒢: smooth, finite at the load too.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an infinity or a NaN.
    pub fn correction(&self, position: f64) -> Result<Estimate, Refusal> {
        let angle = Angle::new(position)?.signed();
        if let Some(sum) = self.thin(Factor::Correction, 1) {
            let (sum, size) = sum.at(angle);
            return Ok(Estimate::new(sum.re / PI, INTEGRAL_ERROR * size / PI));
        }
        let (sine, cosine) = angle.sin_cos();
        let (mut real, mut imaginary) = (0.0, 0.0);
        for (a, b) in self.amplitudes.iter().rev() {
            let (x, y) = (real + a, imaginary + b);
            (real, imaginary) = (x * cosine - y * sine, x * sine + y * cosine);
        }
        Ok(Estimate::new(real / PI, (self.rounding.0 + self.truncation) / PI))
    }

    /// ∫₀^x 𝒢_layer, periodic.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an infinity or a NaN.
    pub fn antiderivative(&self, position: f64) -> Result<Estimate, Refusal> {
        let half_plane = self.half_plane.antiderivative(position)?;
        let angle = Angle::new(position)?.signed();
        if let Some(sum) = self.thin(Factor::Correction, 2) {
            let ((here, size), (at_load, size_at_load)) = (sum.at(angle), sum.at(0.0));
            let value = half_plane.value + (here.im - at_load.im) / PI;
            return Ok(Estimate::new(value, half_plane.error + INTEGRAL_ERROR * (size + size_at_load) / PI));
        }
        let (sine, cosine) = angle.sin_cos();
        // Im Σ (c_m/m)(e^{imx} − 1).
        let (mut real, mut imaginary, mut at_load) = (0.0, 0.0, 0.0);
        for (index, (a, b)) in self.amplitudes.iter().enumerate().rev() {
            let m = (index + 1) as f64;
            at_load += b / m;
            let (x, y) = (real + a / m, imaginary + b / m);
            (real, imaginary) = (x * cosine - y * sine, x * sine + y * cosine);
        }
        let value = half_plane.value + (imaginary - at_load) / PI;
        Ok(Estimate::new(value, half_plane.error + (2.0 * self.rounding.1 + 2.0 * self.truncation) / PI + f64::EPSILON * value.abs()))
    }

    /// The displacement into the body (m) per line load (N/m, compression), without its mean: −(2/E0*)𝒢_layer.
    ///
    /// # Errors
    /// As [`HalfPlaneGreen::displacement_per_line_load`].
    pub fn displacement_per_line_load(&self, position: f64, relaxed_plane_modulus: f64) -> Result<Estimate, Refusal> {
        Ok(self.value(position)?.scaled(-2.0 / require_positive("relaxed_plane_modulus", relaxed_plane_modulus)?))
    }
}
