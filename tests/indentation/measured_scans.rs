//! Source: `src/indentation/scan`: line scans and maps of indenters made axisymmetric shapes.
//!
//! Goal: centre, tilt and shape are those that the scan was made of, with and without noise; noise does not move the apex to its lowest point; what is no round
//! shape that rises is refused.
//!
//! Oracle: the closed forms that the scans are made of (paraboloid, sphere, cone, fourth power), and the force by Hertz and Sneddon on the shapes found.
//!
//! Tolerance: 1e-6 without noise; with noise as stated beside each.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use viscotack::indentation::Profile;
use viscotack::indentation::scan::{Apex, ScanOptions, ScannedShape, axisymmetric};

const OPTIONS: ScanOptions = ScanOptions { apex: None, to: None, largest_residual: 0.05 };

/// Numbers of a normal distribution, always the same ones.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.next()).ln()).sqrt() * (std::f64::consts::TAU * self.next()).cos()
    }
}

/// A line of `count` points from `from` to `to` about `centre`, with an offset, a tilt and noise.
fn line(shape: impl Fn(f64) -> f64, (from, to, count): (f64, f64, usize), centre: f64, tilt: f64, noise: f64) -> Vec<[f64; 3]> {
    let mut random = Random(11);
    (0..count)
        .map(|place| {
            let x = from + (to - from) * place as f64 / (count - 1) as f64;
            [x, 3e-6, 12e-6 + shape((x - centre).abs()) + tilt * (x - centre) + noise * random.normal()]
        })
        .collect()
}

/// 2∫₀^a (Δ − f) ds with f(a) = Δ: the force over E*.
fn force_over_modulus(found: &ScannedShape, depth: f64) -> f64 {
    let profile = Profile::table(&found.points).unwrap();
    let (mut low, mut high) = (0.0, found.reach());
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if profile.line(middle) < depth { low = middle } else { high = middle }
    }
    let parts = 4000;
    let width = low / f64::from(parts);
    (0..parts).map(|part| 2.0 * (depth - profile.line((f64::from(part) + 0.5) * width)) * width).sum()
}

fn hertz(radius: f64, depth: f64) -> f64 {
    4.0 / 3.0 * radius.sqrt() * depth.powf(1.5)
}

#[track_caller]
fn near(found: f64, right: f64, tolerance: f64) {
    assert!((found / right - 1.0).abs() <= tolerance, "{found:e}, right: {right:e}");
}

#[test]
fn exact_scans_are_met() {
    let parabola = |r: f64| r * r / 10e-6;
    for (count, centre) in [(13, 1e-6), (14, 0.93e-6), (201, -1.234e-6)] {
        let found = axisymmetric(&line(parabola, (-5e-6, 7e-6, count), centre, 0.0, 0.0), &OPTIONS).unwrap();
        assert!((found.centre[0] - centre).abs() < 1e-13 && (found.centre[1] - 3e-6).abs() < 1e-15, "{found:?}");
        assert!(found.residual < 1e-14 && found.tilt.iter().all(|tilt| tilt.abs() < 1e-300) && found.apex == Apex::Lowest, "{found:?}");
        near(force_over_modulus(&found, 1e-6), hertz(5e-6, 1e-6), 1e-4);
    }
    // A tilted parabola is a parabola with another lowest point.
    let found = axisymmetric(&line(parabola, (-5e-6, 7e-6, 121), 1e-6, 0.1, 0.0), &OPTIONS).unwrap();
    assert!((found.centre[0] - 0.5e-6).abs() < 1e-12 && found.tilt.iter().all(|tilt| tilt.abs() < 1e-300), "{found:?}");
    near(force_over_modulus(&found, 1e-6), hertz(5e-6, 1e-6), 1e-4);
}

#[test]
fn a_tilt_that_shows_is_taken_out() {
    for (shape, tilt) in [((|r: f64| 0.3 * r) as fn(f64) -> f64, 0.02), (|r| r.powi(4) / 1e-15, -0.05), (|r| 0.3 * r, -0.08)] {
        let found = axisymmetric(&line(shape, (-10e-6, 12e-6, 441), 0.5e-6, tilt, 0.0), &OPTIONS).unwrap();
        near(found.tilt[0], tilt, 2e-2);
        assert!((found.centre[0] - 0.5e-6).abs() < 5e-8, "{:?} {tilt}", found.centre);
        assert!(found.residual < 2e-3 * found.height(), "{:e}", found.residual);
    }
}

#[test]
fn noise_moves_neither_apex_nor_force() {
    for (noise, tilt) in [(20e-9, 0.0), (60e-9, 0.03)] {
        let found = axisymmetric(&line(|r| r * r / 10e-6, (-5e-6, 7e-6, 601), 1e-6, tilt, noise), &OPTIONS).unwrap();
        near(found.residual, noise, 0.15);
        assert!((found.centre[0] - 1e-6 + 5e-6 * tilt).abs() < 2e-8, "{:?}", found.centre);
        near(force_over_modulus(&found, 1e-6), hertz(5e-6, 1e-6), 0.02);
    }
    let found = axisymmetric(&line(|r| 0.3 * r, (-10e-6, 12e-6, 801), 0.5e-6, 0.02, 30e-9), &OPTIONS).unwrap();
    // Sneddon: F = (2/π)E*Δ²/slope.
    near(force_over_modulus(&found, 1.5e-6), 2.0 / std::f64::consts::PI * 2.25e-12 / 0.3, 0.03);
    near(found.tilt[0], 0.02, 0.1);
}

#[test]
fn a_map_is_averaged_over_its_rings() {
    let mut random = Random(5);
    let mut points = Vec::new();
    for row in 0..64 {
        for column in 0..64 {
            let (x, y) = (f64::from(column) * 0.2e-6, f64::from(row) * 0.2e-6);
            let (dx, dy) = (x - 6.1e-6, y - 6.63e-6);
            let r: f64 = dx.hypot(dy);
            points.push([x, y, (50e-6_f64.powi(2) - r * r).sqrt() + 3e-9 * random.normal()]);
        }
    }
    // A sphere of 50 µm that points up.
    let found = axisymmetric(&points, &OPTIONS).unwrap();
    assert_eq!(found.apex, Apex::Highest);
    assert!((found.centre[0] - 6.1e-6).abs() < 1e-8 && (found.centre[1] - 6.63e-6).abs() < 1e-8, "{:?}", found.centre);
    near(found.residual, 3e-9, 0.1);
    near(force_over_modulus(&found, 0.2e-6), hertz(50e-6, 0.2e-6), 0.02);
}

#[test]
fn what_points_up_is_turned_over_and_may_be_stated() {
    let up = line(|r| -r * r / 10e-6, (-5e-6, 7e-6, 121), 1e-6, 0.0, 0.0);
    let found = axisymmetric(&up, &OPTIONS).unwrap();
    assert_eq!(found.apex, Apex::Highest);
    near(force_over_modulus(&found, 1e-6), hertz(5e-6, 1e-6), 1e-4);
    assert_eq!(axisymmetric(&up, &ScanOptions { apex: Some(Apex::Highest), ..OPTIONS }).unwrap(), found);
    assert!(axisymmetric(&up, &ScanOptions { apex: Some(Apex::Lowest), ..OPTIONS }).is_err());
}

#[test]
fn flat_surroundings_are_left_out_by_a_reach() {
    let cap = |r: f64| -(r * r / 20e-6).min(0.8e-6);
    let scan = line(cap, (-10e-6, 12e-6, 661), 0.4e-6, 0.0, 2e-9);
    let found = axisymmetric(&scan, &ScanOptions { to: Some(3.9e-6), ..OPTIONS }).unwrap();
    assert!((found.centre[0] - 0.4e-6).abs() < 1e-8 && found.reach() <= 3.9e-6, "{:?}", found.centre);
    near(force_over_modulus(&found, 0.2e-6), hertz(10e-6, 0.2e-6), 0.02);
    let beyond = axisymmetric(&scan, &ScanOptions { to: Some(11e-6), ..OPTIONS }).unwrap_err().to_string();
    assert!(beyond.contains("not all sides"), "{beyond}");
}

#[test]
fn what_is_no_round_shape_is_refused() {
    let reason = |scan: &[[f64; 3]]| axisymmetric(scan, &OPTIONS).unwrap_err().to_string();
    let one_side = line(|r| r * r / 10e-6, (1e-6, 7e-6, 61), 0.9e-6, 0.0, 0.0);
    assert!(reason(&one_side).contains("both sides"), "{}", reason(&one_side));
    let noisy = line(|r| r * r / 10e-6, (-5e-6, 7e-6, 61), 1e-6, 0.0, 1.5e-6);
    assert!(reason(&noisy).contains("rings"), "{}", reason(&noisy));
    let straight: Vec<[f64; 3]> = (0..20).map(|place| [f64::from(place), 0.0, 2.0 * f64::from(place)]).collect();
    axisymmetric(&straight, &OPTIONS).unwrap_err();
    assert!(axisymmetric(&one_side[..5], &OPTIONS).is_err());
    let mut broken = one_side.clone();
    broken[3][2] = f64::NAN;
    assert!(axisymmetric(&broken, &OPTIONS).is_err());
}

#[test]
fn scale_and_order_do_not_matter() {
    let scan = line(|r| r * r / 10e-6, (-5e-6, 7e-6, 101), 1e-6, 0.0, 5e-9);
    let found = axisymmetric(&scan, &OPTIONS).unwrap();
    let mut other: Vec<[f64; 3]> = scan.iter().map(|point| [2e6 * point[0] + 7.0, 2e6 * point[1], 1e3 * point[2]]).collect();
    other.reverse();
    let scaled = axisymmetric(&other, &OPTIONS).unwrap();
    near(scaled.height(), 1e3 * found.height(), 1e-6);
    near(scaled.centre[0], 2e6 * found.centre[0] + 7.0, 1e-6);
}
