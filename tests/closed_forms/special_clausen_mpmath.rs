//! Clausen's integral, the dilogarithm on the circle and the periodic logarithm against mpmath.
//!
//! Source: `reference_data/clausen.csv`, written by `verification/references/memory_clausen.py` (mpmath `clsin` and `polylog`, 60 digits).
//! Goal: full relative accuracy for every double, next to multiples of π and for angles of many turns too.
//! Oracle: the file; the functional equations Cl₂(2x) = 2Cl₂(x) − 2Cl₂(π − x) and Σ over four rotations; the error of thesis (2.15) as printed.
//! Tolerance: 5e-16 relative for Cl₂ (the worst of the file is printed with `--nocapture`), 5e-16 absolute for the real part of Li₂, which has
//! zeros, 3e-16·(1 + |L|) for L.
#![allow(clippy::unwrap_used, clippy::panic)]

use crate::support;

use std::f64::consts::{FRAC_PI_2, PI};
use support::reference_rows;
use viscotack::special::angle::Angle;
use viscotack::special::clausen::clausen;
use viscotack::special::dilogarithm_circle::dilogarithm_on_circle;
use viscotack::special::log_sine::log_sine;

fn angle(x: f64) -> Angle {
    Angle::new(x).unwrap()
}

#[test]
fn every_angle_of_the_file() {
    let (mut worst_clausen, mut worst_real, mut worst_log) = (0.0_f64, 0.0_f64, 0.0_f64);
    let rows = reference_rows("clausen.csv");
    assert!(rows.len() >= 50);
    for row in &rows {
        let x = row.number("angle");
        let error = (clausen(angle(x)) / row.number("clausen") - 1.0).abs();
        assert!(error < 5e-16, "Cl2({x:e}): relative error {error:e}");
        let dilogarithm = dilogarithm_on_circle(angle(x));
        let real_error = (dilogarithm.real - row.number("dilogarithm_real")).abs();
        assert!(real_error < 5e-16, "Re Li2 at {x:e}: error {real_error:e}");
        assert_eq!(dilogarithm.imaginary.to_bits(), clausen(angle(x)).to_bits());
        let logarithm = row.number("log_sine");
        let log_error = (log_sine(angle(x)) - logarithm).abs() / (1.0 + logarithm.abs());
        assert!(log_error < 3e-16, "L({x:e}): error {log_error:e}");
        worst_clausen = worst_clausen.max(error);
        worst_real = worst_real.max(real_error);
        worst_log = worst_log.max(log_error);
    }
    println!("{} angles: Cl2 {worst_clausen:.1e} relative, Re Li2 {worst_real:.1e}, L {worst_log:.1e}", rows.len());
}

#[test]
fn functional_equations_parity_and_period() {
    let mut worst = 0.0_f64;
    for step in -400..=400 {
        let x = 0.0173 * f64::from(step);
        let at = |x: f64| clausen(angle(x));
        worst = worst.max((at(2.0 * x) - 2.0 * at(x) + 2.0 * at(PI - x)).abs());
        // Multiplication by four: Cl₂(4x) = 4 Σ_{j<4} Cl₂(x + jπ/2).
        let rotated: f64 = (0..4).map(|turn| at(x + f64::from(turn) * FRAC_PI_2)).sum();
        worst = worst.max((at(4.0 * x) - 4.0 * rotated).abs());
        assert_eq!(at(-x).to_bits(), (-at(x)).to_bits(), "odd");
        // The double 2π is short of a turn by 2.4e-16; the slope of Cl₂ is at most 1 + 37 here.
        assert!((at(x + 2.0 * PI) - at(x)).abs() < 5e-14);
    }
    assert!(worst < 2e-14, "{worst:e}");
}

#[test]
fn no_nan_comes_out() {
    assert!(Angle::new(f64::NAN).is_err() && Angle::new(f64::NEG_INFINITY).is_err());
    assert!(log_sine(angle(0.0)).is_infinite() && log_sine(angle(0.0)) < 0.0);
    assert_eq!(clausen(angle(0.0)).to_bits(), 0.0_f64.to_bits());
    for exponent in -320..=300 {
        let x = 10f64.powi(exponent);
        assert!(clausen(angle(x)).is_finite() && log_sine(angle(x)) <= 2f64.ln() + 1e-16);
    }
}

/// Erratum: below thesis (2.15) the elastic kernel is printed with √(log(2 − 2cos kx)). The root belongs inside: log √(2 − 2cos kx) = L. The printed
/// one is no number where 2 − 2cos kx < 1, a third of the period, and has no zero mean.
#[test]
fn erratum_4_root_of_the_logarithm_after_thesis_2_15() {
    let mut mean_of_mended = 0.0;
    let mut undefined = 0;
    let count = 3000;
    for index in 0..count {
        let x = 2.0 * PI * (f64::from(index) + 0.5) / f64::from(count);
        let inside = 2.0 - 2.0 * x.cos();
        let mended = inside.sqrt().ln();
        assert!((mended - log_sine(angle(x))).abs() < 1e-9 * (1.0 + mended.abs()));
        // Midpoint rule of a logarithm: the mean is in error by log 2/N exactly.
        mean_of_mended += mended / f64::from(count);
        undefined += i32::from(inside.ln().sqrt().is_nan());
    }
    assert!((mean_of_mended - 2f64.ln() / f64::from(count)).abs() < 1e-12, "{mean_of_mended:e}");
    assert!((f64::from(undefined) / f64::from(count) - 1.0 / 3.0).abs() < 1e-3);
    // First Fourier coefficient of L is −1 (the elastic response to cos x); of the printed root it is not even real.
}
