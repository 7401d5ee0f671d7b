//! The material of a sliding contact: the creep side of [`SlidingMemory`] with the relaxation terms that belong to it.

use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_non_negative};
use crate::sliding::memory::{MemoryTerm, SlidingMemory};

/// Sliding ratios of the slowest term below this leave no trace in any output, and their squares are no doubles.
const AT_REST: f64 = 1e-200;

/// A relaxation term: its relative modulus E_i/E0 and its sliding ratio ε_i = kvρ_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RelaxationMode {
    pub(super) modulus: f64,
    pub(super) ratio: f64,
}

/// A solid that slides at a rate kv, with both of its series.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactMemory {
    kernel: SlidingMemory,
    stiffening_ratio: f64,
    creep: Vec<MemoryTerm>,
    pub(super) relaxation: Vec<RelaxationMode>,
}

impl ContactMemory {
    /// The groups of a material at the rate kv (1/s): wave number times sliding speed. At rate zero the solid is relaxed and remembers nothing.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material; [`Refusal::OutOfRange`] unless the rate is finite and not negative.
    pub fn new(material: &PlaneMaterial, rate: f64) -> Result<Self, Refusal> {
        let rate = require_non_negative("rate", rate)?;
        let relaxed = material.solid_modulus("a steady sliding contact")?;
        // So slow that no digit of any term has a place in a double: at rest.
        let slowest = material.longest_retardation_time().map_or(0.0, |time| rate * time);
        if rate == 0.0 || (slowest < AT_REST && !material.is_elastic()) {
            return Ok(Self { kernel: SlidingMemory::new(1.0, &[])?, stiffening_ratio: 1.0, creep: Vec::new(), relaxation: Vec::new() });
        }
        let kernel = SlidingMemory::of_material(material, rate, 1.0)?;
        let modes: Vec<RelaxationMode> = material
            .relaxation_terms()
            .iter()
            .map(|term| RelaxationMode { modulus: term.modulus / relaxed, ratio: rate * term.relaxation_time })
            .collect();
        // A retardation and a relaxation time that are equal to rounding belong to a term too weak to be felt, and their pole would be infinite.
        let is = |first: f64, second: f64| first.to_bits() == second.to_bits();
        let creep = kernel.terms().iter().copied().filter(|term| !modes.iter().any(|mode| is(mode.ratio, term.ratio))).collect();
        let relaxation = modes.iter().copied().filter(|mode| !kernel.terms().iter().any(|term| is(mode.ratio, term.ratio))).collect();
        Ok(Self { kernel, stiffening_ratio: material.stiffening_ratio(), creep, relaxation })
    }

    /// β = E∞/E0.
    #[must_use]
    pub const fn stiffening_ratio(&self) -> f64 {
        self.stiffening_ratio
    }

    /// The creep terms, and the compliance that each harmonic sees.
    #[must_use]
    pub const fn kernel(&self) -> &SlidingMemory {
        &self.kernel
    }

    /// ζ_j/(ζ_j − ε_i).
    pub(super) fn pole(&self, creep: usize, relaxation: usize) -> f64 {
        match (self.creep.get(creep), self.relaxation.get(relaxation)) {
            (Some(creep), Some(relaxation)) => creep.ratio / (creep.ratio - relaxation.ratio),
            _ => f64::NAN,
        }
    }

    /// The smallest sliding ratio of both series, a length in 1/k; infinite without terms.
    pub(super) fn thinnest_layer(&self) -> f64 {
        let creep = self.creep().iter().map(|mode| mode.ratio);
        let relaxation = self.relaxation.iter().map(|mode| mode.ratio);
        creep.chain(relaxation).fold(f64::INFINITY, f64::min)
    }

    /// j_j and ζ_j of every creep term.
    pub(super) fn creep(&self) -> &[MemoryTerm] {
        &self.creep
    }
}
