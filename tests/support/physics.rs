//! What the physics tests share: relative errors and random materials that are the same on every machine.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};

/// |value/expected − 1|, and never a comparison that a small unit makes vacuous.
pub fn relative(value: f64, expected: f64) -> f64 {
    assert!(expected != 0.0 && expected.is_finite(), "a relative error needs a finite reference that is not zero: {expected:e}");
    ((value - expected) / expected).abs()
}

/// Numbers from a seed: splitmix64, by Steele, Lea and Flood (2014).
pub struct Random(pub u64);

impl Random {
    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    /// Uniform in the logarithm.
    pub fn decade(&mut self, lower: f64, upper: f64) -> f64 {
        (lower.ln() + (upper / lower).ln() * self.unit()).exp()
    }

    pub fn count(&mut self, most: usize) -> usize {
        1 + (self.unit() * most as f64) as usize
    }
}

/// A solid with up to `most_terms` terms over up to `decades` decades and β up to `largest_beta`, given by either series; its moduli
/// and times are nothing like one.
pub fn random_solid(random: &mut Random, most_terms: usize, decades: f64, largest_beta: f64) -> PlaneMaterial {
    let count = random.count(most_terms);
    let beta = 1.0 + random.decade(0.01, largest_beta - 1.0);
    let relaxed = random.decade(1e3, 1e8);
    let first = random.decade(1e-9, 1e-3);
    let span = random.between(0.3, decades);
    let times: Vec<f64> = (0..count).map(|_| first * 10f64.powf(span * random.unit())).collect();
    let slope = random.between(-0.4, 0.4);
    let weights: Vec<f64> = times.iter().map(|time| (time / first).powf(slope) * random.decade(0.1, 10.0)).collect();
    let total: f64 = weights.iter().sum();
    if random.unit() < 0.5 {
        // ΣJ_j = 1/E0 − 1/E∞
        let gained = (beta - 1.0) / (beta * relaxed);
        let terms: Vec<CreepTerm> = times
            .iter()
            .zip(&weights)
            .map(|(&retardation_time, weight)| CreepTerm { compliance: gained * weight / total, retardation_time })
            .collect();
        PlaneMaterial::from_creep(beta * relaxed, &terms, None).unwrap()
    } else {
        let lost = (beta - 1.0) * relaxed;
        let terms: Vec<RelaxationTerm> = times
            .iter()
            .zip(&weights)
            .map(|(&relaxation_time, weight)| RelaxationTerm { modulus: lost * weight / total, relaxation_time })
            .collect();
        PlaneMaterial::from_relaxation(relaxed, &terms).unwrap()
    }
}

/// The same solid in MPa, mm and ms: stresses times 1e-6, times times 1e3.
pub fn in_mpa_ms(material: &PlaneMaterial) -> PlaneMaterial {
    match material.given() {
        viscotack::material::GivenSeries::Creep => PlaneMaterial::from_creep(
            material.glassy_modulus() * 1e-6,
            &material
                .creep_terms()
                .iter()
                .map(|term| CreepTerm { compliance: term.compliance * 1e6, retardation_time: term.retardation_time * 1e3 })
                .collect::<Vec<_>>(),
            material.steady_viscosity().map(|viscosity| viscosity * 1e-3),
        ),
        viscotack::material::GivenSeries::Relaxation => PlaneMaterial::from_relaxation(
            material.relaxed_modulus() * 1e-6,
            &material
                .relaxation_terms()
                .iter()
                .map(|term| RelaxationTerm { modulus: term.modulus * 1e-6, relaxation_time: term.relaxation_time * 1e3 })
                .collect::<Vec<_>>(),
        ),
    }
    .unwrap()
}
