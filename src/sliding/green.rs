//! The periodic Green's function of a viscoelastic half-plane in steady sliding (thesis Fig 2.4, Eq 3.24).
//!
//! ```text
//! 𝒢(x) = (1/π) [ L(x)/β + Σ_j j_j 𝓛(x; ζ_j) ] = −(1/π) Re Σ_{m≥1} Ĉ_m e^{imx}/m
//! 𝒦(x) = ∫₀^x 𝒢 = −(1/π) [ Cl₂(x)/β + Σ_j j_j (I(x; ζ_j) − I(0; ζ_j)) ]            (thesis Sec 3.3)
//! displacement under equal line loads P (N/m) one period apart:   w(x) = −(2/E0*) P 𝒢(kx)
//! ```
//! 𝒢 is even at rest (L/π) and in the fast limit (L/(βπ)); between them the wake behind the load recovers slowly and 𝒢 is lopsided. Fig 2.4 draws π𝒢.
//! It has a logarithm of strength 1/(βπ) at the load, whatever the speed: a value AT the load is refused.
//!
//! Notation: [`super`]. Accuracy: 2e-14·(1 + |𝒢|) for every x, ζ and number of terms, returned as a bound with each value; the error of a converted
//! relaxation series is added to it. Cost per term, measured on a shared
//! machine: 0.2 µs for ζ ≥ 1, 0.3 µs for ζ ≤ 0.01, 2 µs just below ζ = 1; 1 µs to prepare.

use super::memory::SlidingMemory;
use crate::estimate::Estimate;
use crate::refusal::{Refusal, require_positive};
use crate::special::angle::Angle;
use crate::special::clausen::clausen;
use crate::special::log_sine::log_sine;
use crate::special::memory_clausen::MemoryClausen;
use std::f64::consts::PI;

/// Bound on the relative error of L, over 1 + |L|.
const LOGARITHM_ERROR: f64 = 4e-16;
/// Bound on the error of 𝓛 over min(1, 1/ζ) + |𝓛|, and of I − I(0) over itself: three times the worst of
/// `memory_clausen.csv`; two expansions meet at ζ = 1, x = π within 1.4e-14, the worst place there is.
const MEMORY_ERROR: f64 = 2e-14;
/// |ζ ∂𝓛/∂ζ| and |ζ ∂(I − I(0))/∂ζ| are at most this, away from x = 0 where the former tends to one.
const RATIO_CONDITION: f64 = 4.0;

/// The kernel of a half-plane: prepared once per speed, evaluated anywhere.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfPlaneGreen {
    memory: SlidingMemory,
    functions: Vec<MemoryClausen>,
}

impl HalfPlaneGreen {
    /// Prepares the kernel.
    ///
    /// # Errors
    /// None for a [`SlidingMemory`] that exists; passed on from [`MemoryClausen::new`].
    pub fn new(memory: SlidingMemory) -> Result<Self, Refusal> {
        let functions = memory.terms().iter().map(|term| MemoryClausen::new(term.ratio)).collect::<Result<_, _>>()?;
        Ok(Self { memory, functions })
    }

    /// The solid in reduced groups.
    #[must_use]
    pub const fn memory(&self) -> &SlidingMemory {
        &self.memory
    }

    /// 𝒢 at a position x (in 1/k, any number of periods).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] at a load (a multiple of 2π, where 𝒢 = −∞), for an infinity or a NaN.
    pub fn value(&self, position: f64) -> Result<Estimate, Refusal> {
        let angle = Angle::new(position)?;
        let logarithm = log_sine(angle);
        if logarithm.is_infinite() {
            return Err(Refusal::out_of_range(
                "position",
                position,
                "away from the line loads at multiples of 2*pi, where the kernel is infinite",
            ));
        }
        let glassy = self.memory.glassy_compliance();
        let mut sum = glassy * logarithm;
        let mut error = glassy * LOGARITHM_ERROR * (1.0 + logarithm.abs());
        for (function, (term, (strength_error, time_error))) in self.functions.iter().zip(self.memory.terms_with_errors()) {
            let value = function.logarithm(angle);
            sum += term.compliance * value;
            let scale = 1.0_f64.min(1.0 / term.ratio.abs());
            error += term.compliance * (MEMORY_ERROR * (scale + value.abs()) + strength_error * value.abs() + RATIO_CONDITION * time_error);
        }
        Ok(Estimate::new(sum / PI, (error + f64::EPSILON * sum.abs()) / PI))
    }

    /// 𝒦(x) = ∫₀^x 𝒢, periodic, zero at the load.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an infinity or a NaN.
    pub fn antiderivative(&self, position: f64) -> Result<Estimate, Refusal> {
        let angle = Angle::new(position)?;
        let mut sum = self.memory.glassy_compliance() * clausen(angle);
        let mut error = LOGARITHM_ERROR * sum.abs();
        for (function, (term, (strength_error, time_error))) in self.functions.iter().zip(self.memory.terms_with_errors()) {
            let value = function.increment(angle);
            sum += term.compliance * value;
            // The increment has a second zero in the period, where only the size of its parts bounds its error.
            let scale = 1.0_f64.min(1.0 / term.ratio.abs()) * angle.signed().abs();
            error += term.compliance * (MEMORY_ERROR * (scale + value.abs()) + strength_error * value.abs() + RATIO_CONDITION * time_error);
        }
        Ok(Estimate::new(-sum / PI, (error + f64::EPSILON * sum.abs()) / PI))
    }

    /// The displacement into the body (m) per line load (N/m, compression) at a position x = k × distance: −(2/E0*)𝒢, without its mean.
    ///
    /// # Errors
    /// As [`HalfPlaneGreen::value`]; [`Refusal::OutOfRange`] unless the relaxed plane modulus E0* (Pa) is positive.
    pub fn displacement_per_line_load(&self, position: f64, relaxed_plane_modulus: f64) -> Result<Estimate, Refusal> {
        Ok(self.value(position)?.scaled(-2.0 / require_positive("relaxed_plane_modulus", relaxed_plane_modulus)?))
    }
}
