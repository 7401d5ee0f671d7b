//! Running means of the creep and relaxation functions, and every other mean with a kernel of t/τ.
//!
//! ```text
//! ⟨J⟩(T) = (1/T) ∫₀^T J dt = 1/E∞ + Σ J_j (1 − φ(T/τ_j)) + T/(2η)          φ(z) = (1 − e^{−z})/z
//! ⟨R⟩(T) = (1/T) ∫₀^T R dt = E0 + Σ E_i φ(T/ρ_i)
//! ```
//! The balance at a moving edge is one of these two means over the time T in which the edge crosses its process zone. Every theory of
//! steady cracks in this crate is such a sum with its own kernel, so one function evaluates them all, with its error.

use super::{GivenSeries, Material};
use crate::special::exponential_mean::{exponential_mean, exponential_mean_complement, exponential_mean_decline};

/// A weighted mean of a material function, its logarithmic slope in time, and a bound on its relative error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightedMean {
    /// The mean (1/Pa or Pa).
    pub value: f64,
    /// d ln(mean)/d ln T: between 0 and 1 for creep, between −1 and 0 for relaxation.
    pub log_slope: f64,
    /// Bound on |error|/value: rounding of the sum, of the kernels, and of a converted series.
    pub relative_error: f64,
}

/// Relative error granted to a kernel and its argument, products and the sum's last additions, in units of the last place.
const KERNEL_ULPS: f64 = 8.0;

impl Material {
    /// 1/E∞·`glassy` + Σ J_j·k(T/τ_j) + (T/η)·`flow`, with a kernel k ≥ 0 that vanishes at z = 0, and dk/d ln z.
    pub fn creep_mean(&self, time: f64, glassy: f64, flow: f64, kernel: impl Fn(f64) -> (f64, f64)) -> WeightedMean {
        let (mut terms, mut slope, mut error) = (0.0, 0.0, 0.0);
        // Shortest time first: with equal strengths the smallest summands come last in either order, so any order will do.
        for (index, term) in self.creep_terms.iter().enumerate() {
            let (weight, weight_slope) = kernel(time / term.retardation_time);
            terms += term.compliance * weight;
            slope += term.compliance * weight_slope;
            if self.given == GivenSeries::Relaxation
                && let Some(converted) = self.conversion_errors.get(index)
            {
                error += term.compliance * (weight * converted.strength + weight_slope.abs() * converted.time);
            }
        }
        let flow = self.steady_viscosity.map_or(0.0, |viscosity| flow * (time / viscosity));
        let value = glassy / self.glassy_modulus + terms + flow;
        self.finished(value, slope + flow, error)
    }

    /// E0·`relaxed` + Σ E_i·k(T/ρ_i), with the kernel k ≥ 0 falling to 0 and its derivative dk/d ln z ≤ 0.
    pub fn relaxation_mean(&self, time: f64, relaxed: f64, kernel: impl Fn(f64) -> (f64, f64)) -> WeightedMean {
        let (mut value, mut slope, mut error) = (self.relaxed_modulus * relaxed, 0.0, 0.0);
        for (index, term) in self.relaxation_terms.iter().enumerate() {
            let (weight, weight_slope) = kernel(time / term.relaxation_time);
            value += term.modulus * weight;
            slope += term.modulus * weight_slope;
            if self.given == GivenSeries::Creep
                && let Some(converted) = self.conversion_errors.get(index)
            {
                error += term.modulus * (weight * converted.strength + weight_slope.abs() * converted.time);
            }
        }
        self.finished(value, slope, error)
    }

    /// ⟨J⟩ over a time T > 0 (s; ∞ is allowed and gives 1/E0), in 1/Pa.
    #[must_use]
    pub fn mean_creep(&self, time: f64) -> WeightedMean {
        self.creep_mean(time, 1.0, 0.5, |z| (exponential_mean_complement(z), exponential_mean_decline(z)))
    }

    /// ⟨R⟩ over a time T > 0 (s; ∞ is allowed and gives E0), in Pa.
    #[must_use]
    pub fn mean_relaxation(&self, time: f64) -> WeightedMean {
        self.relaxation_mean(time, 1.0, |z| (exponential_mean(z), -exponential_mean_decline(z)))
    }

    /// Number of terms a creep mean evaluates its kernel at.
    #[must_use]
    pub fn creep_kernel_count(&self) -> u64 {
        self.creep_terms.len() as u64
    }

    /// Number of terms a relaxation mean evaluates its kernel at.
    #[must_use]
    pub fn relaxation_kernel_count(&self) -> u64 {
        self.relaxation_terms.len() as u64
    }

    fn finished(&self, value: f64, slope: f64, conversion: f64) -> WeightedMean {
        let terms = self.creep_terms.len().max(self.relaxation_terms.len()) as f64;
        // A sum of n positive terms loses at most n/2 ulp in the worst case and √n in practice; the bound takes the worst.
        let rounding = (KERNEL_ULPS + 0.5 * terms) * 0.5 * f64::EPSILON;
        // A viscous material's creep grows without limit: its mean over an infinite time is infinite, with slope one.
        let log_slope = if value.is_infinite() { 1.0 } else { slope / value };
        WeightedMean { value, log_slope, relative_error: conversion / value + rounding }
    }
}
