//! Pull-off of a rigid flat cylinder.
//!
//! Source: Kendall, J. Phys. D 4 (1971) 1186.
//! Goal: pull-off force and displacement, and the field they come from.
//!
//! ```text
//!      ^ F
//!    +-|-+
//!   _|___|_    radius a
//! ```
//!
//! Parameters: a = 0.83 mm, E* = 4.7 MPa, Δγ = 0.37 J/m².
//! Oracles: the energy U = F²/(4E*a) of the printed compliance: its derivative in the area at fixed penetration, by central differences, is Δγ at pull-off; the
//! pressure integrates to the force, and its Boussinesq integral at the centre to the penetration; K from the pressure next to the rim.
//! Tolerance: differences 1e-8, quadratures 1e-12, near-rim limit 1e-6 (relative distance 1e-6).
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::elastic::KendallPunch;

const A: f64 = 0.83e-3;
const MODULUS: f64 = 4.7e6;
const WORK: f64 = 0.37;

#[test]
fn energy_release_at_pull_off_is_the_work_of_adhesion() {
    let punch = KendallPunch::new(A, MODULUS, WORK).unwrap();
    let depth = punch.pull_off_penetration();
    let energy = |a: f64| {
        let other = KendallPunch::new(a, MODULUS, WORK).unwrap();
        0.5 * other.force(depth).unwrap() * depth
    };
    let h = 1e-4 * A;
    let release = (energy(A + h) - energy(A - h)) / (2.0 * h) / (2.0 * PI * A);
    assert_relative_eq!(release, WORK, epsilon = 0.0, max_relative = 1e-8);
    assert_relative_eq!(punch.energy_release_rate(depth).unwrap(), WORK, epsilon = 0.0, max_relative = 2e-15);
    assert_relative_eq!(-punch.force(depth).unwrap(), punch.pull_off_force().unwrap(), epsilon = 0.0, max_relative = 1e-15);
    assert_relative_eq!(
        punch.pull_off_force().unwrap().powi(2),
        8.0 * PI * MODULUS * WORK * A.powi(3),
        epsilon = 0.0,
        max_relative = 3e-15
    );
    assert!(punch.energy_release_rate(-depth).unwrap().abs() < f64::MIN_POSITIVE);
}

#[test]
fn pressure_carries_force_depth_and_singularity() {
    let punch = KendallPunch::new(A, MODULUS, WORK).unwrap();
    let depth = -2.3e-6;
    let n = 64;
    let (mut force, mut centre) = (0.0, 0.0);
    for i in 0..n {
        let u = A * (f64::from(i) + 0.5) / f64::from(n);
        force += 2.0 * PI * u * punch.pressure(depth, (A - u).sqrt() * (A + u).sqrt()).unwrap() * A / f64::from(n);
        let phi = PI / 2.0 * (f64::from(i) + 0.5) / f64::from(n);
        centre += 2.0 / MODULUS * punch.pressure(depth, A * phi.sin()).unwrap() * A * phi.cos() * PI / 2.0 / f64::from(n);
    }
    assert_relative_eq!(force, punch.force(depth).unwrap(), epsilon = 0.0, max_relative = 1e-12);
    assert_relative_eq!(centre, depth, epsilon = 0.0, max_relative = 1e-12);
    let near = 1e-6 * A;
    let factor = -punch.pressure(depth, A - near).unwrap() * (2.0 * PI * near).sqrt();
    assert_relative_eq!(factor, punch.stress_intensity_factor(depth).unwrap(), epsilon = 0.0, max_relative = 1e-6);
    assert!(punch.pressure(depth, A).is_err());
    assert!(punch.pressure(depth, 2.0 * A).unwrap().abs() < f64::MIN_POSITIVE);
}

#[test]
fn units_do_not_matter_and_bad_arguments_are_refused() {
    let metres = KendallPunch::new(A, MODULUS, WORK).unwrap();
    let millimetres = KendallPunch::new(A * 1e3, MODULUS * 1e-6, WORK * 1e-3).unwrap();
    assert_relative_eq!(metres.pull_off_force().unwrap(), millimetres.pull_off_force().unwrap(), epsilon = 0.0, max_relative = 2e-15);
    assert_relative_eq!(metres.pull_off_penetration() * 1e3, millimetres.pull_off_penetration(), epsilon = 0.0, max_relative = 2e-15);
    assert!(KendallPunch::new(-A, MODULUS, WORK).is_err() && KendallPunch::new(A, MODULUS, f64::NAN).is_err());
    assert!(metres.force(f64::NAN).is_err() && metres.force(1e306).is_err());
}
