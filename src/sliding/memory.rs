//! What a steadily sliding surface sees of its material: relative compliances and sliding ratios.
//!
//! | symbol | name | range |
//! |---|---|---|
//! | 1/β | `glassy_compliance` | 0 < 1/β ≤ 1 |
//! | j_j = J_jE0 | `MemoryTerm::compliance` | ≥ 0 |
//! | ζ_j = kvτ_j | `MemoryTerm::ratio` | any finite number, the sign of the velocity |
//! | m | harmonic of the wave | ≥ 1 |
//!
//! A load at rest in the moving frame meets the complex compliance Ĉ_m = 1/β + Σ j_j/(1 − imζ_j) in its harmonic e^{imx}. The sign of the
//! imaginary unit is that of a surface that remembers what lies AHEAD of it at x + ζz; thesis (2.9) and (2.19) combined give the mirror image.

use crate::material::{GivenSeries, PlaneMaterial};
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};

/// How far 1/β + Σj_j may be from one in terms that are given directly.
const SUM_TOLERANCE: f64 = 1e-12;

/// One creep term in the groups of steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MemoryTerm {
    /// j_j = J_jE0, a number.
    pub compliance: f64,
    /// ζ_j = kvτ_j, a number.
    pub ratio: f64,
}

/// A solid in the groups of steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingMemory {
    glassy_compliance: f64,
    terms: Vec<MemoryTerm>,
    /// Relative errors of the terms where a relaxation series was converted: (strength, time).
    conversion: Vec<(f64, f64)>,
}

impl SlidingMemory {
    /// Terms given directly; equal and vanishing ones are allowed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless 1/β > 0, every j_j ≥ 0, every ζ_j is finite and all share a sign, and 1/β + Σj_j = 1 to 1e-12.
    pub fn new(glassy_compliance: f64, terms: &[MemoryTerm]) -> Result<Self, Refusal> {
        require_positive("glassy_compliance", glassy_compliance)?;
        let mut sum = glassy_compliance;
        for term in terms {
            sum += require_non_negative("compliance", term.compliance)?;
            require_finite("ratio", term.ratio)?;
        }
        if (sum - 1.0).abs() > SUM_TOLERANCE {
            return Err(Refusal::out_of_range("glassy_compliance + sum of compliances", sum, "one: compliances are relative to 1/E0"));
        }
        if terms.iter().any(|term| term.ratio > 0.0)
            && let Some(backward) = terms.iter().find(|term| term.ratio < 0.0)
        {
            return Err(Refusal::out_of_range("ratio", backward.ratio, "of the sign of the other ratios: all terms slide one way"));
        }
        Ok(Self { glassy_compliance, terms: terms.to_vec(), conversion: vec![(0.0, 0.0); terms.len()] })
    }

    /// The standard solid of the thesis by β = E∞/E0 and ζ = kvτ (Eq 3.24).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless β ≥ 1 and both are finite.
    pub fn standard_solid(stiffening_ratio: f64, ratio: f64) -> Result<Self, Refusal> {
        if !(stiffening_ratio.is_finite() && stiffening_ratio >= 1.0) {
            return Err(Refusal::out_of_range("stiffening_ratio", stiffening_ratio, "finite and at least one"));
        }
        let compliance = (stiffening_ratio - 1.0) / stiffening_ratio;
        Self::new(1.0 / stiffening_ratio, &[MemoryTerm { compliance, ratio }])
    }

    /// A material that slides with `speed` (m/s, either sign) over a wave of wave number `wave_number` = 2π/λ (1/m).
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material, which no steady load at rest is carried by; [`Refusal::OutOfRange`] unless the wave number is
    /// positive and the speed finite.
    pub fn of_material(material: &PlaneMaterial, wave_number: f64, speed: f64) -> Result<Self, Refusal> {
        let relaxed = material.solid_modulus("a steady sliding response")?;
        let rate = require_positive("wave_number", wave_number)? * require_finite("speed", speed)?;
        let mut terms = Vec::with_capacity(material.creep_terms().len());
        for term in material.creep_terms() {
            let ratio = require_finite("wave_number * speed * retardation_time", rate * term.retardation_time)?;
            terms.push(MemoryTerm { compliance: term.compliance * relaxed, ratio });
        }
        let conversion = match material.given() {
            GivenSeries::Creep => vec![(0.0, 0.0); terms.len()],
            GivenSeries::Relaxation => material.conversion_errors().iter().map(|error| (error.strength, error.time)).collect(),
        };
        Ok(Self { glassy_compliance: relaxed / material.glassy_modulus(), terms, conversion })
    }

    /// 1/β.
    #[must_use]
    pub const fn glassy_compliance(&self) -> f64 {
        self.glassy_compliance
    }

    /// The terms, in the order given.
    #[must_use]
    pub fn terms(&self) -> &[MemoryTerm] {
        &self.terms
    }

    /// Each term with its relative errors of (strength, time).
    pub(crate) fn terms_with_errors(&self) -> impl Iterator<Item = (MemoryTerm, (f64, f64))> {
        self.terms.iter().copied().zip(self.conversion.iter().copied().chain(std::iter::repeat((0.0, 0.0))))
    }

    /// The same solid sliding the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut reversed = self.clone();
        for term in &mut reversed.terms {
            term.ratio = -term.ratio;
        }
        reversed
    }

    /// Ĉ_m as (real, imaginary) part; relative error of each a few ulp (sums of terms of one sign). |Ĉ_m| ≤ 1.
    #[must_use]
    pub fn harmonic_compliance(&self, harmonic: f64) -> (f64, f64) {
        let mut real = self.glassy_compliance;
        let mut imaginary = 0.0;
        for term in &self.terms {
            let y = harmonic * term.ratio;
            // 1/(1 − iy) = (1 + iy)/(1 + y²) by the smaller of y and 1/y: nothing overflows.
            let (in_phase, out_of_phase) = if y.abs() <= 1.0 {
                let denominator = 1.0 + y * y;
                (1.0 / denominator, y / denominator)
            } else {
                let inverse = 1.0 / y;
                let denominator = 1.0 + inverse * inverse;
                (inverse * inverse / denominator, inverse / denominator)
            };
            real += term.compliance * in_phase;
            imaginary += term.compliance * out_of_phase;
        }
        (real, imaginary)
    }
}
