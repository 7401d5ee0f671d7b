//! Random numbers of studies.
//!
//! Each scene of a study has a stream of its own, so that any one of them can be drawn again alone, in any order, on any number of threads.

use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;
use viscotack::special::split_mix::SplitMix;

/// A stream of numbers.
#[derive(Debug, Clone)]
pub struct Draw(SplitMix);

impl Draw {
    /// The stream of a scene of a study.
    #[must_use]
    pub fn of(seed: u64, scene: u64) -> Self {
        Self(SplitMix::of(seed, scene))
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.0.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The next number's later digits, as a whole number: independent of the first ones, which decide whatever is drawn by them.
    pub fn digits(&mut self) -> usize {
        ((self.unit() * 4096.0).fract() * 4096.0) as usize
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    /// Uniform in the logarithm.
    pub fn log_between(&mut self, lower: f64, upper: f64) -> f64 {
        (lower.ln() + (upper / lower).ln() * self.unit()).exp()
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// True this often.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// A solid of `terms` terms over `decades` decades below a longest time (s), by either series; E0 (Pa) and β as given.
    ///
    /// # Errors
    /// Those of making a material.
    pub fn solid(&mut self, relaxed: f64, beta: f64, longest: f64, terms: usize, decades: f64) -> Result<PlaneMaterial, Refusal> {
        let weights: Vec<f64> = (0..terms).map(|_| self.log_between(0.2, 5.0)).collect();
        let total: f64 = weights.iter().sum();
        let times: Vec<f64> = (0..terms)
            .map(|index| {
                let place = if index == 0 { 0.0 } else { (index as f64 + self.between(-0.4, 0.4)) / terms as f64 };
                longest * 10f64.powf(-decades * place)
            })
            .collect();
        let pairs = || weights.iter().zip(&times);
        if self.chance(0.5) {
            // ΣJ_j = 1/E0 − 1/E∞
            let gained = (beta - 1.0) / (beta * relaxed);
            let terms: Vec<CreepTerm> =
                pairs().map(|(weight, &retardation_time)| CreepTerm { compliance: gained * weight / total, retardation_time }).collect();
            PlaneMaterial::from_creep(beta * relaxed, &terms, None)
        } else {
            let lost = (beta - 1.0) * relaxed;
            let terms: Vec<RelaxationTerm> =
                pairs().map(|(weight, &relaxation_time)| RelaxationTerm { modulus: lost * weight / total, relaxation_time }).collect();
            PlaneMaterial::from_relaxation(relaxed, &terms)
        }
    }
}
