//! Compliance factors of confined and free layers against the printed hyperbolic forms in high precision.
//!
//! Source: thesis Sec 2.2.2, below (2.15), and (2.16); `reference_data/layer_factors.csv` from `verification/references/periodic_green.py`.
//! ```text
//!   A = 1 − S,  q = mkd       confined: 2e^{−2q}(C+2q+2q²)/κ ← A → 1        free: −4q²e^{−2q} ← A → −6/q³
//! ```
//! Goal: relative accuracy of A and of S, each where the other hides it: A at thick layers, S at thin ones (incompressible: S = (2/3)q³).
//! Parameters: ν from −0.9 to 0.5, q from 1e-12 to 340 and the seam at q = 1.
//! Oracle: the file; limits of plate bending, lubrication and uniaxial compression, derived independently in the tests.
//! Tolerance: 1e-15 relative (the worst is printed with `--nocapture`).
#![allow(clippy::unwrap_used, clippy::panic)]

use crate::support;

use support::reference_rows;
use viscotack::material::{CreepTerm, Material};
use viscotack::sliding::layer::mean_displacement;
use viscotack::sliding::{Backing, Layer};

const MOST: f64 = 1e-15;

fn backing(name: &str) -> Backing {
    match name {
        "confined" => Backing::Confined,
        "free" => Backing::Free,
        other => panic!("backing {other}"),
    }
}

#[test]
fn every_factor_of_the_file() {
    let rows = reference_rows("layer_factors.csv");
    let mut worst = (0.0_f64, 0.0_f64);
    for row in &rows {
        let layer = Layer::new(backing(row.text("backing")), row.number("poisson_ratio"), row.number("product")).unwrap();
        let correction_error = (layer.correction(1.0) / row.number("correction") - 1.0).abs();
        let factor_error = (layer.compliance_factor(1.0) / row.number("compliance_factor") - 1.0).abs();
        assert!(
            correction_error < MOST && factor_error < MOST,
            "{} ν = {} q = {}: A {correction_error:e}, S {factor_error:e}",
            row.text("backing"),
            row.text("poisson_ratio"),
            row.text("product")
        );
        worst = (worst.0.max(correction_error), worst.1.max(factor_error));
    }
    println!("{} factors: A {:.1e}, S {:.1e}", rows.len(), worst.0, worst.1);
}

#[test]
fn printed_forms_overflow_and_cancel() {
    // The reason for the stable forms: the printed expression in double precision (theory 6).
    let printed = |q: f64, kappa: f64, constant: f64| {
        (2.0 * q - kappa * (2.0 * q).sinh()) / (constant + 2.0 * q * q + kappa * (2.0 * q).cosh()) + 1.0
    };
    let stable = |q: f64| Layer::new(Backing::Confined, 0.5, q).unwrap().correction(1.0);
    assert!((printed(1.0, 1.0, 1.0) / stable(1.0) - 1.0).abs() < 1e-14);
    assert!((printed(20.0, 1.0, 1.0) / stable(20.0) - 1.0).abs() > 1e-3, "1 % wrong at 20");
    assert!(printed(50.0, 1.0, 1.0).abs() < 1e-300 || (printed(50.0, 1.0, 1.0) / stable(50.0)).abs() > 2.0, "all digits lost at 50");
    assert!(printed(360.0, 1.0, 1.0).is_nan(), "overflow at 356");
    assert!(stable(360.0) > 0.0 && stable(1e300) >= 0.0);
}

#[test]
fn thin_and_thick_limits() {
    for nu in [0.0, 0.3, 0.45] {
        // Thin and confined: a Winkler foundation, S = (1−2ν)q/(2(1−ν)²); thin and free: a plate of stiffness E*d³/12, S = 6/q³.
        let q = 1e-7;
        let foundation = (1.0 - 2.0 * nu) * q / (2.0 * (1.0 - nu) * (1.0 - nu));
        assert!((Layer::new(Backing::Confined, nu, q).unwrap().compliance_factor(1.0) / foundation - 1.0).abs() < 1e-6);
        assert!((Layer::new(Backing::Free, nu, q).unwrap().compliance_factor(1.0) * q * q * q / 6.0 - 1.0).abs() < 1e-12);
        // Thick: a half-plane.
        for kind in [Backing::Confined, Backing::Free] {
            let thick = Layer::new(kind, nu, 400.0).unwrap();
            assert!(thick.correction(1.0).abs() < 1e-300 && (thick.compliance_factor(1.0) - 1.0).abs() < 1e-15);
            assert!(Layer::new(kind, nu, 20.0).unwrap().correction(1.0).abs() < 1e-12);
        }
    }
    // Incompressible and confined: squeezed like a lubricating film that is stuck on one side and slips on the other, S = (2/3)q³.
    assert!((Layer::new(Backing::Confined, 0.5, 1e-5).unwrap().compliance_factor(1.0) / (2.0 / 3.0 * 1e-15) - 1.0).abs() < 1e-9);
    // The harmonic number and the thickness enter as a product.
    let (third, alone) = (Layer::new(Backing::Confined, 0.3, 0.4).unwrap(), Layer::new(Backing::Confined, 0.3, 3.0 * 0.4).unwrap());
    assert!((third.correction(3.0) - alone.correction(1.0)).abs() < 1e-16);
}

#[test]
fn factors_fall_together_across_the_seam() {
    for kind in [Backing::Confined, Backing::Free] {
        for nu in [-0.5, 0.3, 0.5] {
            for step in 0..400 {
                let layer = Layer::new(kind, nu, 10f64.powf(-6.0 + 0.02 * f64::from(step))).unwrap();
                let (a, s) = (layer.correction(1.0), layer.compliance_factor(1.0));
                assert!((a + s - 1.0).abs() < 4e-16 * (1.0 + s), "A + S = 1");
                assert!(s > 0.0, "a push never lifts the surface");
                assert!(if kind == Backing::Free { a < 0.0 } else { a > 0.0 }, "confinement stiffens, a free back softens");
            }
        }
    }
}

#[test]
fn mean_displacement_thesis_2_16() {
    let (nu, thickness, pressure) = (0.3, 2e-3, 5e4);
    let elastic = Material::elastic(3e6).unwrap();
    let mean = mean_displacement(&elastic, nu, thickness, pressure).unwrap();
    // Uniaxial compression: p = λ + 2μ times the strain, with Lamé's constants.
    let (lame, shear) = (3e6 * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 3e6 / (2.0 * (1.0 + nu)));
    let oedometric = pressure * thickness / (lame + 2.0 * shear);
    assert!((mean.value / oedometric - 1.0).abs() < 1e-14 && mean.error < 1e-14 * mean.value && mean.value > 0.0, "into the body");
    // The confined layer meets it in the limit of a long wave: 2(1−ν²)/(Ek) S(kd).
    let wave_number = 1e-4;
    let layer = Layer::new(Backing::Confined, nu, wave_number * thickness).unwrap();
    let harmonic = 2.0 * (1.0 - nu * nu) / (3e6 * wave_number) * layer.compliance_factor(1.0) * pressure;
    assert!((harmonic / oedometric - 1.0).abs() < 1e-6);
    // A steady mean pressure has acted for ever: the relaxed modulus counts.
    let solid = Material::from_creep(3e7, &[CreepTerm { compliance: 3e-7, retardation_time: 0.2 }], None).unwrap();
    let relaxed = mean_displacement(&solid, nu, thickness, pressure).unwrap();
    assert!((relaxed.value / mean.value - 3e6 / solid.relaxed_modulus()).abs() < 1e-13);
    // Incompressible: zero for every thickness, the infinite one included; otherwise a half-plane has none, and a viscous layer none either.
    assert_eq!(mean_displacement(&elastic, 0.5, f64::INFINITY, pressure).unwrap().value.to_bits(), 0.0_f64.to_bits());
    assert!(mean_displacement(&elastic, nu, f64::INFINITY, pressure).is_err());
    let viscous = Material::from_creep(1e6, &[], Some(1e3)).unwrap();
    assert!(mean_displacement(&viscous, nu, thickness, pressure).is_err() && mean_displacement(&viscous, 0.5, thickness, pressure).is_ok());
    for (nu, thickness, pressure) in [(0.6, 1.0, 1.0), (0.3, -1.0, 1.0), (0.3, 1.0, f64::NAN), (f64::NAN, 1.0, 1.0), (0.5, f64::NAN, 1.0)] {
        assert!(mean_displacement(&elastic, nu, thickness, pressure).is_err());
    }
}
