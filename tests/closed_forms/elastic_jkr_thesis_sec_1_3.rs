//! Adhesive sphere of Johnson, Kendall and Roberts.
//!
//! Source: Proc. R. Soc. A 324 (1971) 301; thesis Sec 1.3, Fig 1.2 (its parameter Δγ/(πE*R) = 1.6e-4 is the first sphere here).
//! Goal: both controls, both branches, the folds, jump-in, the fields and the energy belong together.
//!
//! ```text
//!     F ^                    A: fold of F, −(3/2)πRΔγ
//!       |          /         B: fold of Δ, −(5/6)πRΔγ
//!   ----+---o-----/--- Δ     o: jump-in at Δ = 0, −(4/3)πRΔγ
//!     B(  `-.A_.-´
//! ```
//!
//! Parameters: three spheres, moduli 0.3 Pa to 2 GPa, in SI and in mm-N-MPa.
//! Oracles: (i) the energy release rate as numerical derivative, at fixed Δ, of U = ∫F dΔ (quadrature of the force, from the Hertz contact of the same
//! radius), must be Δγ; (ii) F and Δ from integrals of the pressure; (iii) the gap by Abel's integral of s²/R − Δ;
//! (iv) stability from the sign of the second derivative of the total energy; (v) folds by scanning the branch.
//! Tolerance: quadratures 1e-12; central differences 1e-8 (step 1e-4, order 4); round trips by the state's own bound.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::Refusal;
use viscotack::elastic::jkr::JkrState;
use viscotack::elastic::{Control, EquilibriumBranch, HertzSphere, JkrSphere, KendallPunch};

/// (R, E*, Δγ).
const SPHERES: [(f64, f64, f64); 3] = [(1.3, 0.3, 0.3 * PI * 1.3 * 1.6e-4), (6.1e-3, 1.7e6, 0.21), (4.4e-7, 2.0e9, 0.047)];

fn sphere((radius, modulus, work): (f64, f64, f64)) -> JkrSphere {
    JkrSphere::new(radius, modulus, work).unwrap()
}

/// Equilibria from narrower than the fold of Δ to well pressed.
fn states(sphere: &JkrSphere) -> Vec<JkrState> {
    let unit = sphere.pull_off(Control::Load).unwrap().contact_radius;
    [0.05, 0.3, 0.47, 0.49, 0.8, 0.99, 1.01, 1.6, 5.0].iter().map(|ratio| sphere.state_by_contact_radius(ratio * unit).unwrap()).collect()
}

/// Central difference of order 4.
fn slope(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-4 * x.abs();
    (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h)
}

#[test]
fn energy_released_by_the_rim_is_the_work_of_adhesion() {
    for parameters in SPHERES {
        let (radius, modulus, work) = parameters;
        let sphere = sphere(parameters);
        let hertz = HertzSphere::new(radius, modulus).unwrap();
        for state in states(&sphere) {
            // Hertz energy at radius a, then the sphere is pulled to Δ at fixed a: F is linear in Δ, so the trapezoid rule is exact.
            let energy = |a: f64| {
                let start = hertz.state_by_contact_radius(a).unwrap();
                let end = sphere.force(a, state.penetration).unwrap();
                0.4 * start.force * start.penetration + 0.5 * (start.force + end) * (state.penetration - start.penetration)
            };
            let a = state.contact_radius;
            assert_relative_eq!(energy(a), sphere.strain_energy(a, state.penetration).unwrap(), epsilon = 0.0, max_relative = 1e-12);
            // Stationary total energy U − πa²Δγ: dU/dA = +Δγ, for U grows with the stuck area.
            let release = slope(energy, a) / (2.0 * PI * a);
            assert_relative_eq!(release, work, epsilon = 0.0, max_relative = 1e-7);
            let factor = sphere.stress_intensity_factor(a, state.penetration).unwrap();
            assert!(factor > 0.0);
            assert_relative_eq!(factor * factor / (2.0 * modulus), work, epsilon = 0.0, max_relative = 1e-11);
            // Stable under fixed penetration when the total energy has a minimum there, i.e. G − Δγ grows with a.
            let growth = slope(|a| sphere.stress_intensity_factor(a, state.penetration).unwrap().powi(2) / (2.0 * modulus), a);
            assert_eq!(sphere.is_stable(&state, Control::Penetration), growth > 0.0);
            let at_load = |a: f64| {
                let depth = state.force / (2.0 * modulus * a) + a * a / (3.0 * radius);
                sphere.stress_intensity_factor(a, depth).unwrap().powi(2) / (2.0 * modulus)
            };
            assert_eq!(sphere.is_stable(&state, Control::Load), slope(at_load, a) > 0.0);
        }
    }
}

#[test]
fn pressure_carries_force_and_depth_and_the_gap_is_abels() {
    for parameters in SPHERES {
        let (radius, modulus, _) = parameters;
        let sphere = sphere(parameters);
        for state in states(&sphere) {
            let a = state.contact_radius;
            // r = a sin φ: p·cos φ is a polynomial in cos φ; r dr = −u du with u = √(a² − r²) for the force.
            let n = 64;
            let (mut force, mut depth) = (0.0, 0.0);
            for i in 0..n {
                let phi = PI / 2.0 * (f64::from(i) + 0.5) / f64::from(n);
                let weight = PI / 2.0 / f64::from(n);
                depth += 2.0 / modulus * sphere.pressure(a, a * phi.sin()).unwrap() * a * phi.cos() * weight;
                let u = a * (f64::from(i) + 0.5) / f64::from(n);
                // Midpoint rule on a quadratic errs by h²/12 of its boundary slope: corrected below by Richardson through u² exactly.
                force += 2.0 * PI * sphere.pressure(a, (a - u).sqrt() * (a + u).sqrt()).unwrap() * u * a / f64::from(n);
            }
            // ∫u² by midpoints is a³/3·(1 − 1/(4n²)); the quadratic part of 2πup is (4E*/R)u².
            force += 4.0 * modulus / radius * a.powi(3) / 3.0 / (4.0 * f64::from(n * n));
            let scale = modulus * a.powi(3) / radius + sphere.pull_off_force();
            assert!((force - state.force).abs() < 1e-12 * scale);
            assert!((depth - state.penetration).abs() < 1e-12 * (a * a / radius + state.penetration.abs()));
            // gap(r) = (2/π)∫_a^r (s²/R − Δ)/√(r² − s²) ds with s = r cos θ.
            for ratio in [1.0 + 1e-9, 1.001, 1.2, 4.0] {
                let r = ratio * a;
                let end = ((r - a).sqrt() * (r + a).sqrt()).atan2(a);
                let m = 4000;
                let f = |t: f64| (r * t.cos()).powi(2) / radius - state.penetration;
                let integral = (0..m).fold(0.0, |sum, i| {
                    let (left, right) = (end * f64::from(i) / f64::from(m), end * f64::from(i + 1) / f64::from(m));
                    sum + (right - left) / 6.0 * (f(left) + 4.0 * f(0.5 * (left + right)) + f(right))
                });
                assert_relative_eq!(sphere.gap(a, r).unwrap(), 2.0 / PI * integral, epsilon = 0.0, max_relative = 1e-11);
            }
            assert!(sphere.gap(a, a).unwrap().abs() < f64::MIN_POSITIVE && sphere.pressure(a, a).is_err());
        }
    }
}

#[test]
fn folds_and_jump_in_stand_where_the_branch_turns() {
    for parameters in SPHERES {
        let (radius, modulus, work) = parameters;
        let sphere = sphere(parameters);
        let unit = PI * radius * work;
        let load = sphere.pull_off(Control::Load).unwrap();
        let depth = sphere.pull_off(Control::Penetration).unwrap();
        assert_relative_eq!(load.force, -1.5 * unit, epsilon = 0.0, max_relative = 2e-15);
        assert_relative_eq!(depth.force, -5.0 / 6.0 * unit, epsilon = 0.0, max_relative = 3e-15);
        for state in [load, depth] {
            // Each is an equilibrium of the printed relations …
            let a = state.contact_radius;
            let lift = (2.0 * PI * a * work / modulus).sqrt();
            assert_relative_eq!(state.penetration, a * a / radius - lift, epsilon = 0.0, max_relative = 2e-15);
            assert_relative_eq!(state.force, sphere.force(a, state.penetration).unwrap(), epsilon = 0.0, max_relative = 4e-15);
        }
        // … and no neighbour passes it.
        for step in [-1e-3, 1e-3] {
            // 1.5e-3 in q moves F/F_A = q(q − 2) by q's square; 5e-4 in y moves y⁴ − 4y = −3 by 6 times its square.
            let force = sphere.state_by_contact_radius(load.contact_radius * (1.0 + step)).unwrap().force;
            assert_relative_eq!(1.0 - force / load.force, 2.25e-6, epsilon = 0.0, max_relative = 2e-3);
            let penetration = sphere.state_by_contact_radius(depth.contact_radius * (1.0 + step)).unwrap().penetration;
            assert_relative_eq!(1.0 - penetration / depth.penetration, 5e-7, epsilon = 0.0, max_relative = 2e-3);
        }
        assert_relative_eq!(
            sphere.unloaded().unwrap().contact_radius.powi(3),
            4.5 * unit * radius / modulus,
            epsilon = 0.0,
            max_relative = 4e-15
        );
        assert!(sphere.unloaded().unwrap().force.abs() < 1e-15 * unit);
        let jump = sphere.jump_in(Control::Penetration).unwrap();
        assert_relative_eq!(jump.force, -4.0 / 3.0 * unit, epsilon = 0.0, max_relative = 3e-15);
        assert_relative_eq!(jump.contact_radius.powi(3), 2.0 * unit * radius / modulus, epsilon = 0.0, max_relative = 4e-15);
        assert_eq!(sphere.jump_in(Control::Load).unwrap(), sphere.unloaded().unwrap());
    }
}

#[test]
fn inverses_return_to_the_state_they_came_from() {
    for parameters in SPHERES {
        let sphere = sphere(parameters);
        for state in states(&sphere) {
            let branch = |control| if sphere.is_stable(&state, control) { EquilibriumBranch::Stable } else { EquilibriumBranch::Unstable };
            for same in [
                sphere.state_by_force(state.force, branch(Control::Load)).unwrap(),
                sphere.state_by_penetration(state.penetration, branch(Control::Penetration)).unwrap(),
            ] {
                assert_relative_eq!(same.contact_radius, state.contact_radius, epsilon = 0.0, max_relative = 2.0 * same.relative_error);
            }
        }
        // The folds themselves are answered, and one part in 1e12 beyond them is refused with the limit as witness.
        for branch in [EquilibriumBranch::Stable, EquilibriumBranch::Unstable] {
            let load = sphere.pull_off(Control::Load).unwrap();
            let state = sphere.state_by_force(load.force, branch).unwrap();
            assert_relative_eq!(state.contact_radius, load.contact_radius, epsilon = 0.0, max_relative = state.relative_error);
            let depth = sphere.pull_off(Control::Penetration).unwrap();
            let state = sphere.state_by_penetration(depth.penetration, branch).unwrap();
            assert_relative_eq!(state.contact_radius, depth.contact_radius, epsilon = 0.0, max_relative = state.relative_error);
            let refusal = sphere.state_by_force(load.force * (1.0 + 1e-12), branch).unwrap_err();
            assert!(matches!(refusal, Refusal::NoSuchState { limit, .. } if limit < 0.0 && (limit / load.force - 1.0).abs() < 1e-15));
            let refusal = sphere.state_by_penetration(depth.penetration * (1.0 + 1e-12), branch).unwrap_err();
            assert!(matches!(refusal, Refusal::NoSuchState { limit, .. } if (limit / depth.penetration - 1.0).abs() < 1e-15));
        }
        assert!(sphere.state_by_force(0.0, EquilibriumBranch::Unstable).is_err());
        assert!(sphere.state_by_penetration(0.0, EquilibriumBranch::Unstable).is_err());
        assert!(sphere.state_by_force(f64::NAN, EquilibriumBranch::Stable).is_err());
        assert!(sphere.state_by_penetration(f64::INFINITY, EquilibriumBranch::Stable).is_err());
    }
    assert!(JkrSphere::new(1.0, 1.0, 0.0).is_err());
}

#[test]
fn units_do_not_matter() {
    for (radius, modulus, work) in SPHERES {
        let metres = JkrSphere::new(radius, modulus, work).unwrap();
        let millimetres = JkrSphere::new(radius * 1e3, modulus * 1e-6, work * 1e-3).unwrap();
        for fraction in [-0.9, -0.3, 0.7, 300.0] {
            let force = fraction * metres.pull_off_force();
            let (a, b) = (
                metres.state_by_force(force, EquilibriumBranch::Stable).unwrap(),
                millimetres.state_by_force(force, EquilibriumBranch::Stable).unwrap(),
            );
            assert_relative_eq!(a.contact_radius * 1e3, b.contact_radius, epsilon = 0.0, max_relative = 5e-15);
            assert_relative_eq!(a.penetration * 1e3, b.penetration, epsilon = 0.0, max_relative = 5e-14);
            let (c, d) = (
                metres.state_by_penetration(a.penetration, EquilibriumBranch::Stable).unwrap(),
                millimetres.state_by_penetration(a.penetration * 1e3, EquilibriumBranch::Stable).unwrap(),
            );
            assert_relative_eq!(c.contact_radius * 1e3, d.contact_radius, epsilon = 0.0, max_relative = 5e-15);
            assert_relative_eq!(c.force, d.force, epsilon = 1e-13 * metres.pull_off_force(), max_relative = 1e-13);
        }
    }
}

/// Far beyond adhesion the sphere is Hertz's, and a heavily stuck, hardly curved one is Kendall's punch.
#[test]
fn limits_are_hertz_and_kendall() {
    let (radius, modulus, work) = SPHERES[1];
    let sphere = sphere(SPHERES[1]);
    let force = 1e8 * sphere.pull_off_force();
    let hertz = HertzSphere::new(radius, modulus).unwrap().state_by_force(force).unwrap();
    let state = sphere.state_by_force(force, EquilibriumBranch::Stable).unwrap();
    // q = 1 + √(1 + F/F_A) against √(F/F_A), and a ∝ q^{2/3}: the first correction is (2/3)·10⁻⁴.
    assert_relative_eq!(state.contact_radius / hertz.contact_radius - 1.0, 2.0 / 3.0 * 1e-4, epsilon = 0.0, max_relative = 1e-3);
    let small = sphere.state_by_contact_radius(1e-6 * sphere.pull_off(Control::Load).unwrap().contact_radius).unwrap();
    let punch = KendallPunch::new(small.contact_radius, modulus, work).unwrap();
    assert_relative_eq!(small.force, -punch.pull_off_force().unwrap(), epsilon = 0.0, max_relative = 1e-8);
    assert_relative_eq!(small.penetration, punch.pull_off_penetration(), epsilon = 0.0, max_relative = 1e-8);
}
