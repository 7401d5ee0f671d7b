//! A layer of finite thickness against a half-plane: compliance factors and mean displacement (thesis Sec 2.2.2).
//!
//! ```text
//!   confined                        free
//!   ////////////// rigid, glued     p p p p p p   uniform pressure, no shear
//!   ┌────────────┐                  ┌────────────┐
//!   │ d   E, ν   │                  │ d   E, ν   │
//!   └─\_/──\_/───┘                  └─\_/──\_/───┘
//!     Λ cos kx                        Λ cos kx      no shear on this face in either
//! ```
//! | symbol | meaning | range |
//! |---|---|---|
//! | q = mkd | wave number of a harmonic times the thickness | > 0 |
//! | S(q) = 1 − A(q) | displacement of the layer over that of a half-plane, for one harmonic of the pressure | > 0 |
//! | t = 2q, e = e^{−t} | | |
//! | κ = 3 − 4ν, C = 5 − 12ν + 8ν² | | ≥ 1, ≥ 1 |
//!
//! # What it does
//! ```text
//! confined  S = (κ sinh t − t)/(C + t²/2 + κ cosh t)     A → 2e^{−2q}(C + 2q + 2q²)/κ,  S → (1−2ν)q/(2(1−ν)²),  ν = ½: (2/3)q³
//! free      S = (sinh t + t)/(cosh t − 1 − t²/2)         A → −4q²e^{−2q},                S → 6/q³ (a plate in bending), any ν
//! ```
//! As printed both overflow at q = 356 and lose all digits of A from q = 18; the confined S loses them as q → 0 at ν = ½, the free one below 1e-4. Here
//! every sum is of terms of one sign, or a series.
//!
//! Accuracy: relative 1e-15 for A and S separately, for every q (4.4e-16 over the 238 rows of `layer_factors.csv`); A of the confined layer has no zero.
//!
//! # Mean displacement (2.16)
//! The mean of the pressure is carried by uniaxial compression, d(1+ν)(1−2ν)/((1−ν)E): the periodic cell keeps its width. It is finite for
//! both layers, measured from the rigid plate (confined) or from the mean of the loaded back face (free), zero for ν = ½, and infinite for a
//! half-plane unless ν = ½. For the confined layer it is the limit m → 0 of the harmonics; for the free one it is not (that limit is a plate that bends).
//!
//! Sources: thesis Sec 2.2.2 for the hyperbolic forms; thin limits: plate theory (stiffness E*d³/12), the lubrication film, the oedometer, each derived in
//! `tests/sliding/layer_factors.rs`.

use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::{Refusal, require_finite, require_poisson_ratio, require_positive};
use nalgebra::Complex;
use serde::{Deserialize, Serialize};

/// Series below this t = 2q, exponentials above it.
const SERIES_BELOW: f64 = 2.0;

/// What holds the far face of the layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Backing {
    /// Glued to a rigid plate.
    Confined,
    /// Pressed by a uniform pressure, free to bend.
    Free,
}

/// A layer in reduced groups.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    backing: Backing,
    poisson_ratio: f64,
    thickness: f64,
}

impl Layer {
    /// A layer by the product kd of wave number and thickness.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless kd is positive and finite and −1 < ν ≤ 0.5.
    pub fn new(backing: Backing, poisson_ratio: f64, thickness_times_wave_number: f64) -> Result<Self, Refusal> {
        require_poisson_ratio(poisson_ratio)?;
        require_positive("thickness_times_wave_number", thickness_times_wave_number)?;
        Ok(Self { backing, poisson_ratio, thickness: thickness_times_wave_number })
    }

    /// What holds the far face.
    #[must_use]
    pub const fn backing(&self) -> Backing {
        self.backing
    }

    /// ν.
    #[must_use]
    pub const fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// kd.
    #[must_use]
    pub const fn thickness_times_wave_number(&self) -> f64 {
        self.thickness
    }

    /// A_m = 1 − S_m of the harmonic m ≥ 1: what the layer takes from (> 0) or adds to (< 0) a half-plane's compliance.
    ///
    /// Infinite only where a free layer with mkd < 1e-102 bends without limit.
    #[must_use]
    pub fn correction(&self, harmonic: f64) -> f64 {
        let t = 2.0 * harmonic * self.thickness;
        let e = (-t).exp();
        match self.backing {
            Backing::Confined => {
                let (kappa, constant) = self.constants();
                // e(C + t²/2 + t) without e·∞ = NaN for the thickest layers.
                let polynomial = decaying(constant + t + 0.5 * t * t, e);
                let even = decaying(constant + 0.5 * t * t, e);
                2.0 * (polynomial + kappa * e * e) / (kappa * (1.0 + e * e) + 2.0 * even)
            }
            Backing::Free if t < SERIES_BELOW => 1.0 - free_series(t),
            Backing::Free => {
                let polynomial = decaying(1.0 + t + 0.5 * t * t, e);
                let even = decaying(1.0 + 0.5 * t * t, e);
                -2.0 * (polynomial - e * e) / (1.0 + e * e - 2.0 * even)
            }
        }
    }

    /// S_m of the harmonic m ≥ 1: the layer's compliance over the half-plane's.
    #[must_use]
    pub fn compliance_factor(&self, harmonic: f64) -> f64 {
        let t = 2.0 * harmonic * self.thickness;
        let e = (-t).exp();
        match self.backing {
            Backing::Confined => {
                let (kappa, constant) = self.constants();
                // κ(1 − e²) − 2te = (κ − 1)(1 − e²) + 2e(sinh t − t), with 1 − e² = −expm1(−2t).
                let sine_beyond_line = if t < SERIES_BELOW { 2.0 * e * odd_series(t) } else { 1.0 - e * e - 2.0 * decaying(t, e) };
                let numerator = 2.0 * (1.0 - 2.0 * self.poisson_ratio) * -(-2.0 * t).exp_m1() + sine_beyond_line;
                numerator / (kappa * (1.0 + e * e) + 2.0 * decaying(constant + 0.5 * t * t, e))
            }
            Backing::Free if t < SERIES_BELOW => free_series(t),
            Backing::Free => (1.0 - e * e + 2.0 * decaying(t, e)) / (1.0 + e * e - 2.0 * decaying(1.0 + 0.5 * t * t, e)),
        }
    }

    /// A at a complex product q = mkd with a positive real part.
    pub(super) fn complex_correction(&self, product: Complex<f64>) -> Complex<f64> {
        let t = 2.0 * product;
        if self.backing == Backing::Free && t.norm() < SERIES_BELOW {
            return 1.0 - complex_free_series(t);
        }
        let e = (-t).exp();
        let square = 0.5 * t * t;
        match self.backing {
            Backing::Confined => {
                let (kappa, constant) = self.constants();
                2.0 * e * (constant + t + square + kappa * e) / (kappa * (1.0 + e * e) + 2.0 * e * (constant + square))
            }
            Backing::Free => -2.0 * e * (1.0 + t + square - e) / (1.0 + e * e - 2.0 * e * (1.0 + square)),
        }
    }

    /// S at a complex product q = mkd with a positive real part.
    pub(super) fn complex_compliance_factor(&self, product: Complex<f64>) -> Complex<f64> {
        let t = 2.0 * product;
        if t.norm() >= SERIES_BELOW {
            return 1.0 - self.complex_correction(product);
        }
        match self.backing {
            Backing::Free => complex_free_series(t),
            Backing::Confined => {
                // (κ sinh t − t)/(C + t²/2 + κ cosh t) with κ sinh t − t = (κ − 1) sinh t + (sinh t − t).
                let (kappa, constant) = self.constants();
                let beyond_line = complex_odd_series(t);
                let sine = t + beyond_line;
                (2.0 * (1.0 - 2.0 * self.poisson_ratio) * sine + beyond_line) / (constant + 0.5 * t * t + kappa * t.cosh())
            }
        }
    }

    /// κ and C.
    fn constants(&self) -> (f64, f64) {
        let nu = self.poisson_ratio;
        (3.0 - 4.0 * nu, 5.0 - nu * (12.0 - 8.0 * nu))
    }
}

/// The mean displacement into the body (m) of a layer of `thickness` (m) that has carried a mean pressure (Pa, compression) for ever.
///
/// `youngs` holds Young's moduli.
///
/// # Errors
/// [`Refusal::OutOfRange`] unless the thickness is positive (an infinite one is the half-plane: its mean displacement exists only at ν = 0.5 and is zero),
/// the pressure finite and −1 < ν ≤ 0.5; [`Refusal::Undefined`] for a viscous material with ν < 0.5.
pub fn mean_displacement(youngs: &Material, poisson_ratio: f64, thickness: f64, mean_pressure: f64) -> Result<Estimate, Refusal> {
    let nu = require_poisson_ratio(poisson_ratio)?;
    let pressure = require_finite("mean_pressure", mean_pressure)?;
    if nu >= 0.5 && thickness > 0.0 {
        return Ok(Estimate::exact(0.0));
    }
    require_positive("thickness", thickness)?;
    let modulus = youngs.solid_modulus("the mean displacement under a steady pressure")?;
    let uniaxial = (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
    Ok(Estimate::relative(uniaxial * thickness * pressure / modulus, 8.0 * f64::EPSILON + youngs.modulus_rounding()))
}

/// polynomial·e^{−t}, zero where the exponential has underflowed.
fn decaying(polynomial: f64, e: f64) -> f64 {
    if e == 0.0 { 0.0 } else { polynomial * e }
}

/// sinh t − t = Σ_{n≥1} t^{2n+1}/(2n+1)!; at t = 2 the 12th term is 1e-17 of the sum.
fn odd_series(t: f64) -> f64 {
    let square = t * t;
    let mut term = t * square / 6.0;
    let mut sum = term;
    for n in 2..14 {
        let order = f64::from(2 * n);
        term *= square / (order * (order + 1.0));
        sum += term;
    }
    sum
}

/// As [`odd_series`].
fn complex_odd_series(t: Complex<f64>) -> Complex<f64> {
    let square = t * t;
    let mut term = t * square / 6.0;
    let mut sum = term;
    for n in 2..14 {
        let order = f64::from(2 * n);
        term *= square / (order * (order + 1.0));
        sum += term;
    }
    sum
}

/// As [`free_series`].
fn complex_free_series(t: Complex<f64>) -> Complex<f64> {
    let square = t * t;
    let mut term = Complex::new(1.0 / 24.0, 0.0);
    let mut sum = term;
    for n in 3..15 {
        let order = f64::from(2 * n);
        term *= square / (order * (order - 1.0));
        sum += term;
    }
    (2.0 * t + complex_odd_series(t)) / t / t / t / t / sum
}

/// S of a free layer: (sinh t/t + 1)/(t³ Σ_{n≥2} t^{2n−4}/(2n)!).
fn free_series(t: f64) -> f64 {
    let square = t * t;
    let mut term = 1.0 / 24.0;
    let mut sum = term;
    for n in 3..15 {
        let order = f64::from(2 * n);
        term *= square / (order * (order - 1.0));
        sum += term;
    }
    let mean = if t < 1e-9 { 1.0 } else { t.sinh() / t };
    (mean + 1.0) / t / t / t / sum
}
