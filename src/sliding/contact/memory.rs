//! The material in the groups of a sliding contact: both series at one sliding rate kv.

use crate::material::Material;
use crate::refusal::{Refusal, require_positive};

/// A creep term: its relative compliance j_j = J_jE0 and its sliding ratio ζ_j = kvτ_j.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CreepMode {
    pub(super) compliance: f64,
    pub(super) ratio: f64,
}

/// A relaxation term: its relative modulus E_i/E0 and its sliding ratio ε_i = kvρ_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RelaxationMode {
    pub(super) modulus: f64,
    pub(super) ratio: f64,
}

/// A solid that slides at a rate kv > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactMemory {
    pub(super) stiffening_ratio: f64,
    pub(super) creep: Vec<CreepMode>,
    pub(super) relaxation: Vec<RelaxationMode>,
}

impl ContactMemory {
    /// The groups of a material at the rate kv (1/s): wave number times sliding speed.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material; [`Refusal::OutOfRange`] unless the rate is positive and finite.
    pub fn new(material: &Material, rate: f64) -> Result<Self, Refusal> {
        let relaxed = material.solid_modulus("a steady sliding contact")?;
        let rate = require_positive("rate", rate)?;
        Ok(Self {
            stiffening_ratio: material.stiffening_ratio(),
            creep: material
                .creep_terms()
                .iter()
                .map(|term| CreepMode { compliance: term.compliance * relaxed, ratio: rate * term.retardation_time })
                .collect(),
            relaxation: material
                .relaxation_terms()
                .iter()
                .map(|term| RelaxationMode { modulus: term.modulus / relaxed, ratio: rate * term.relaxation_time })
                .collect(),
        })
    }

    /// β = E∞/E0.
    #[must_use]
    pub const fn stiffening_ratio(&self) -> f64 {
        self.stiffening_ratio
    }

    /// 1/β + Σ j_j/(1 − iζ_j): the compliance in the first harmonic, as (real, imaginary) part.
    #[must_use]
    pub fn first_harmonic_compliance(&self) -> (f64, f64) {
        let (mut real, mut imaginary) = (1.0 / self.stiffening_ratio, 0.0);
        for mode in &self.creep {
            // 1/(1 − iζ) = (1 + iζ)/(1 + ζ²), by hypot so that nothing overflows.
            let magnitude = mode.ratio.hypot(1.0);
            real += mode.compliance / magnitude / magnitude;
            imaginary += mode.compliance * (mode.ratio / magnitude) / magnitude;
        }
        (real, imaginary)
    }
}
