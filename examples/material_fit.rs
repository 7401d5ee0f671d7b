//! A relaxation series fitted to dynamic moduli with two per cent of scatter: as many terms as the scatter allows.
//!
//! `cargo run --release --example material_fit`

use std::error::Error;
use viscotack::Material;
use viscotack::material::RelaxationTerm;
use viscotack::material::fit::{Wanted, complex_modulus, fit};

fn main() -> Result<(), Box<dyn Error>> {
    let term = |modulus: f64, relaxation_time: f64| RelaxationTerm { modulus, relaxation_time };
    let truth = Material::from_relaxation(1e6, &[term(1e6, 1.0), term(4e6, 1e-2), term(3e7, 1e-4)])?;
    // Scatter from a generator of its own, so that the table is the same each time.
    let mut seed = 1_u64;
    let mut scatter = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1.0 + 0.02 * 1.732 * ((seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    };
    let mut data = Vec::new();
    for tenth in -30..=60 {
        let frequency = 10f64.powf(0.1 * f64::from(tenth));
        let modulus = truth.complex_modulus(frequency)?;
        data.extend(complex_modulus(frequency, modulus.storage * scatter(), modulus.loss * scatter()));
    }
    let found = fit(&data, Wanted::Scatter)?;
    println!("{} data, {} terms, residuals {:.2} %", found.observations, found.material.relaxation_terms().len(), 100.0 * found.rms_error);
    println!("{:>16} {:>16}", "time (s)", "modulus (Pa)");
    for term in found.material.relaxation_terms() {
        println!("{:16.4e} {:16.4e}", term.relaxation_time, term.modulus);
    }
    println!("{:>16} {:16.4e}", "relaxed", found.material.relaxed_modulus());
    Ok(())
}
