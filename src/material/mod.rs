//! Linear viscoelastic materials: creep and relaxation series of any length as one type.
//!
//! ```text
//! creep       J(t) = 1/E∞ + Σ_j J_j (1 − e^{−t/τ_j}) + t/η        relaxation   R(t) = E0 + Σ_i E_i e^{−t/ρ_i}
//! ```
//! | symbol | name here | unit | range |
//! |---|---|---|---|
//! | E∞ = R(0) | `glassy_modulus`: of an instantaneous load | Pa | > 0 |
//! | E0 = R(∞) | `relaxed_modulus`: of a load held for ever | Pa | ≥ 0; 0 is a viscous material |
//! | J_j, τ_j | `compliance`, `retardation_time` of a [`CreepTerm`] | 1/Pa, s | > 0 |
//! | E_i, ρ_i | `modulus`, `relaxation_time` of a [`RelaxationTerm`] | Pa, s | > 0 |
//! | η | `steady_viscosity`: present if and only if E0 = 0 | Pa s | > 0 |
//!
//! A material is given by either series and holds both; the other one is made by [`conversion`] when the material is made. Terms are
//! sorted from the longest time to the shortest, terms of exactly equal times are merged, and terms of zero strength are dropped, so
//! equal materials are equal values. An elastic material has no term. The moduli are whatever modulus the problem is stated in
//! (Young's, shear or bulk); contacts and cracks take a [`PlaneMaterial`]. A constant Poisson ratio belongs to the body, not to the material.
//!
//! The rates interlace, 0 < 1/τ_1 < 1/ρ_1 < 1/τ_2 < … (thesis Sec 2.1; Gross, 1953), so a relaxation time is always shorter than the
//! retardation time it belongs to: for one term ρ = τ E0/E∞.

pub mod broad;
mod complex_modulus;
pub mod conversion;
pub mod fit;
pub mod isotropic;
mod plane;
mod running_mean;
pub mod shift;
mod time_functions;

pub use complex_modulus::ComplexModulus;
pub use plane::PlaneMaterial;
pub use running_mean::WeightedMean;

use crate::refusal::{Refusal, require_non_negative, require_positive};
use conversion::ConversionError;

/// One term of a creep series: J_j (1 − e^{−t/τ_j}).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepTerm {
    /// J_j, the compliance gained when the term has run its course (1/Pa).
    pub compliance: f64,
    /// τ_j, the time of a creep test (s).
    pub retardation_time: f64,
}

/// One term of a relaxation series: E_i e^{−t/ρ_i}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelaxationTerm {
    /// E_i, the modulus lost when the term has run its course (Pa).
    pub modulus: f64,
    /// ρ_i, the time of a relaxation test (s).
    pub relaxation_time: f64,
}

/// Which of the two series was given; the other was computed from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenSeries {
    /// The creep series is exact, the relaxation series carries conversion errors.
    Creep,
    /// The relaxation series is exact, the creep series carries conversion errors.
    Relaxation,
}

/// A linear viscoelastic material with both of its series.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    glassy_modulus: f64,
    relaxed_modulus: f64,
    creep_terms: Vec<CreepTerm>,
    relaxation_terms: Vec<RelaxationTerm>,
    steady_viscosity: Option<f64>,
    given: GivenSeries,
    conversion_errors: Vec<ConversionError>,
    modulus_rounding: f64,
}

impl Material {
    /// An elastic material: one modulus (Pa), no memory.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the modulus is positive and finite.
    pub fn elastic(modulus: f64) -> Result<Self, Refusal> {
        Self::from_relaxation(require_positive("modulus", modulus)?, &[])
    }

    /// A material from its creep series: the glassy modulus (Pa), terms in any order, and a steady viscosity (Pa s) if it flows (E0 = 0).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus, compliance, time or viscosity that is not positive and finite (a zero compliance is
    /// dropped); [`Refusal::NotConverged`] if the conversion fails.
    pub fn from_creep(glassy_modulus: f64, terms: &[CreepTerm], steady_viscosity: Option<f64>) -> Result<Self, Refusal> {
        let glassy_modulus = require_positive("glassy_modulus", glassy_modulus)?;
        if let Some(viscosity) = steady_viscosity {
            require_positive("steady_viscosity", viscosity)?;
        }
        for term in terms {
            require_non_negative("compliance", term.compliance)?;
            require_positive("retardation_time", term.retardation_time)?;
        }
        let creep_terms: Vec<CreepTerm> = merged(terms.iter().map(|term| (term.retardation_time, term.compliance)))
            .into_iter()
            .map(|(retardation_time, compliance)| CreepTerm { compliance, retardation_time })
            .collect();
        let relaxed_modulus = match steady_viscosity {
            Some(_) => 0.0,
            None => 1.0 / (1.0 / glassy_modulus + creep_terms.iter().rev().map(|term| term.compliance).sum::<f64>()),
        };
        let (relaxation_terms, conversion_errors) = conversion::relaxation_from_creep(glassy_modulus, &creep_terms, steady_viscosity)?;
        Self {
            glassy_modulus,
            relaxed_modulus,
            creep_terms,
            relaxation_terms,
            steady_viscosity,
            given: GivenSeries::Creep,
            conversion_errors,
            modulus_rounding: 0.0,
        }
        .representable()
    }

    /// A material from its relaxation series: the relaxed modulus (Pa; 0 for a viscous material) and terms in any order.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a modulus that is negative, infinite or a NaN, a time that is not positive and finite (a zero
    /// modulus is dropped), or a relaxed modulus of zero without any term; [`Refusal::NotConverged`] if the conversion fails.
    pub fn from_relaxation(relaxed_modulus: f64, terms: &[RelaxationTerm]) -> Result<Self, Refusal> {
        let relaxed_modulus = require_non_negative("relaxed_modulus", relaxed_modulus)?;
        for term in terms {
            require_non_negative("modulus", term.modulus)?;
            require_positive("relaxation_time", term.relaxation_time)?;
        }
        let relaxation_terms: Vec<RelaxationTerm> = merged(terms.iter().map(|term| (term.relaxation_time, term.modulus)))
            .into_iter()
            .map(|(relaxation_time, modulus)| RelaxationTerm { modulus, relaxation_time })
            .collect();
        let glassy_modulus = relaxed_modulus + relaxation_terms.iter().map(|term| term.modulus).sum::<f64>();
        require_positive("glassy_modulus", glassy_modulus)?;
        let (creep_terms, conversion_errors) = conversion::creep_from_relaxation(relaxed_modulus, &relaxation_terms)?;
        let steady_viscosity =
            (relaxed_modulus == 0.0).then(|| relaxation_terms.iter().map(|term| term.modulus * term.relaxation_time).sum());
        Self {
            glassy_modulus,
            relaxed_modulus,
            creep_terms,
            relaxation_terms,
            steady_viscosity,
            given: GivenSeries::Relaxation,
            conversion_errors,
            modulus_rounding: 0.0,
        }
        .representable()
    }

    /// The material, unless a number of it, given or converted, overflowed or underflowed.
    fn representable(self) -> Result<Self, Refusal> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let solid = self.steady_viscosity.is_none();
        let whole = positive(self.glassy_modulus)
            && (if solid { positive(self.relaxed_modulus) } else { self.relaxed_modulus == 0.0 })
            && self.steady_viscosity.is_none_or(positive)
            && self.creep_terms.iter().all(|term| positive(term.compliance) && positive(term.retardation_time))
            && self.relaxation_terms.iter().all(|term| positive(term.modulus) && positive(term.relaxation_time))
            && self
                .conversion_errors
                .iter()
                .all(|error| [error.time, error.strength, error.time_input, error.strength_input].iter().all(|value| value.is_finite()));
        if whole {
            Ok(self)
        } else {
            Err(Refusal::Undefined {
                quantity: "the other series of the material",
                reason: "the moduli and times are so large, so small or so far apart that numbers overflow".into(),
            })
        }
    }

    /// The standard linear solid of the thesis, by its two moduli (Pa) and its RETARDATION time (s; thesis chapters 3 and 5).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless 0 < relaxed modulus ≤ glassy modulus and the time is positive.
    pub fn standard_solid(relaxed_modulus: f64, glassy_modulus: f64, retardation_time: f64) -> Result<Self, Refusal> {
        require_positive("relaxed_modulus", relaxed_modulus)?;
        require_positive("glassy_modulus", glassy_modulus)?;
        if relaxed_modulus > glassy_modulus {
            return Err(Refusal::out_of_range("relaxed_modulus", relaxed_modulus, "at most the glassy modulus"));
        }
        // 1/E0 − 1/E∞ with the difference taken first: exact to rounding for nearly equal moduli.
        let compliance = (glassy_modulus - relaxed_modulus) / glassy_modulus / relaxed_modulus;
        Self::from_creep(glassy_modulus, &[CreepTerm { compliance, retardation_time }], None)
    }

    /// E∞ (Pa).
    #[must_use]
    pub const fn glassy_modulus(&self) -> f64 {
        self.glassy_modulus
    }

    /// E0 (Pa); zero for a viscous material.
    #[must_use]
    pub const fn relaxed_modulus(&self) -> f64 {
        self.relaxed_modulus
    }

    /// E0, or the reason why a viscous material has none that a result could be divided by.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] if E0 = 0.
    pub fn solid_modulus(&self, quantity: &'static str) -> Result<f64, Refusal> {
        if self.relaxed_modulus > 0.0 {
            Ok(self.relaxed_modulus)
        } else {
            Err(Refusal::Undefined {
                quantity,
                reason: "the material is viscous (relaxed modulus 0), so it never carries a load at rest".into(),
            })
        }
    }

    /// β = E∞/E0 ≥ 1; infinite for a viscous material.
    #[must_use]
    pub fn stiffening_ratio(&self) -> f64 {
        if self.creep_terms.is_empty() && self.steady_viscosity.is_none() { 1.0 } else { self.glassy_modulus / self.relaxed_modulus }
    }

    /// The creep terms, longest retardation time first.
    #[must_use]
    pub fn creep_terms(&self) -> &[CreepTerm] {
        &self.creep_terms
    }

    /// The relaxation terms, longest relaxation time first.
    #[must_use]
    pub fn relaxation_terms(&self) -> &[RelaxationTerm] {
        &self.relaxation_terms
    }

    /// η (Pa s), the viscosity of steady flow; only a viscous material has one.
    #[must_use]
    pub const fn steady_viscosity(&self) -> Option<f64> {
        self.steady_viscosity
    }

    /// Whether the material has no memory.
    #[must_use]
    pub fn is_elastic(&self) -> bool {
        self.relaxation_terms.is_empty()
    }

    /// Which series is exact.
    #[must_use]
    pub const fn given(&self) -> GivenSeries {
        self.given
    }

    /// The error of each term of the series that was computed, in the order of that series.
    #[must_use]
    pub fn conversion_errors(&self) -> &[ConversionError] {
        &self.conversion_errors
    }

    /// Relative error that [`Material::stiffened`] or [`isotropic`] left in every modulus; zero for a material as given.
    #[must_use]
    pub const fn modulus_rounding(&self) -> f64 {
        self.modulus_rounding
    }

    /// The longest retardation time (s), or none for a material without creep terms.
    #[must_use]
    pub fn longest_retardation_time(&self) -> Option<f64> {
        self.creep_terms.first().map(|term| term.retardation_time)
    }

    /// The longest relaxation time (s), or none for an elastic material.
    #[must_use]
    pub fn longest_relaxation_time(&self) -> Option<f64> {
        self.relaxation_terms.first().map(|term| term.relaxation_time)
    }

    /// The same material with every modulus multiplied by `factor`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the factor is positive and finite.
    pub fn stiffened(&self, factor: f64) -> Result<Self, Refusal> {
        let factor = require_positive("factor", factor)?;
        let mut scaled = self.clone();
        // Multiplication by a power of two is exact.
        let exact = factor.log2().fract() == 0.0;
        scaled.modulus_rounding += if exact { 0.0 } else { f64::EPSILON };
        scaled.glassy_modulus *= factor;
        scaled.relaxed_modulus *= factor;
        scaled.steady_viscosity = scaled.steady_viscosity.map(|viscosity| viscosity * factor);
        for term in &mut scaled.creep_terms {
            term.compliance /= factor;
        }
        for term in &mut scaled.relaxation_terms {
            term.modulus *= factor;
        }
        scaled.representable()
    }
}

/// (time, strength) pairs sorted from the longest time to the shortest, equal times merged, zero strengths dropped.
fn merged(terms: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = terms.filter(|&(_, strength)| strength > 0.0).collect();
    sorted.sort_by(|left, right| right.0.total_cmp(&left.0));
    let mut result: Vec<(f64, f64)> = Vec::with_capacity(sorted.len());
    for (time, strength) in sorted {
        match result.last_mut() {
            Some(last) if last.0.to_bits() == time.to_bits() => last.1 += strength,
            _ => result.push((time, strength)),
        }
    }
    result
}
