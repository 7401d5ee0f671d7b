//! Hertz contact of a rigid sphere.
//!
//! Source: Johnson, *Contact Mechanics* (1985), Sec 4.2.
//! Goal: force, penetration, pressure and energy belong together, in any unit system.
//!
//! ```text
//!        F
//!      ( R )        contact 0 < r < a, p ∝ √(a² − r²)
//!   ____\_/____
//! ```
//!
//! Parameters: R = 7.3 mm, E* = 2.9 MPa, a = 0.41 mm.
//! Oracles: F = ∫2πrp dr (Simpson in u = √(a² − r²), exact because p ∝ u); the centre's displacement by Boussinesq,
//! w(0) = (2/E*)∫p dr = Δ, which the closed form Δ = a²/R does not know (midpoint rule in φ, r = a sin φ, exact for cos²φ); U = ∫F dΔ.
//! Tolerance: 1e-13 for quadratures, 1e-15·few for round trips.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::Refusal;
use viscotack::elastic::HertzSphere;

const RADIUS: f64 = 7.3e-3;
const MODULUS: f64 = 2.9e6;
const CONTACT: f64 = 0.41e-3;

/// ∫₀^{π/2} f dφ by the midpoint rule: exponentially accurate, f being smooth and even about both ends.
fn quarter_turn(f: impl Fn(f64) -> f64) -> f64 {
    let n = 64;
    let step = PI / 2.0 / f64::from(n);
    (0..n).map(|i| f((f64::from(i) + 0.5) * step)).sum::<f64>() * step
}

#[test]
fn pressure_carries_the_force_and_the_depth() {
    let sphere = HertzSphere::new(RADIUS, MODULUS).unwrap();
    let state = sphere.state_by_contact_radius(CONTACT).unwrap();
    let p = |phi: f64| sphere.pressure(CONTACT, CONTACT * phi.sin()).unwrap() * CONTACT * phi.cos();
    let ring = |u: f64| 2.0 * PI * u * sphere.pressure(CONTACT, (CONTACT - u).sqrt() * (CONTACT + u).sqrt()).unwrap();
    let force = CONTACT / 6.0 * (4.0 * ring(0.5 * CONTACT) + ring(CONTACT));
    assert_relative_eq!(force, state.force, epsilon = 0.0, max_relative = 1e-13);
    assert_relative_eq!(2.0 / MODULUS * quarter_turn(p), state.penetration, epsilon = 0.0, max_relative = 1e-13);
}

#[test]
fn energy_is_the_work_of_the_force() {
    let sphere = HertzSphere::new(RADIUS, MODULUS).unwrap();
    let state = sphere.state_by_contact_radius(CONTACT).unwrap();
    // F ∝ Δ^{3/2}: with Δ = Δ₁u² the integrand is a quartic in u, where 4000 panels of Simpson leave 1e-14.
    let n = 4000;
    let f = |u: f64| sphere.state_by_penetration(state.penetration * u * u).unwrap().force * 2.0 * state.penetration * u;
    let simpson = (0..n).fold(0.0, |sum, i| {
        let (a, b) = (f64::from(i) / f64::from(n), f64::from(i + 1) / f64::from(n));
        sum + (b - a) / 6.0 * (f(a) + 4.0 * f(0.5 * (a + b)) + f(b))
    });
    assert_relative_eq!(simpson, sphere.strain_energy(CONTACT).unwrap(), epsilon = 0.0, max_relative = 1e-12);
}

#[test]
fn inverses_return_and_units_do_not_matter() {
    let sphere = HertzSphere::new(RADIUS, MODULUS).unwrap();
    let millimetres = HertzSphere::new(RADIUS * 1e3, MODULUS * 1e-6).unwrap();
    for decade in -8..3 {
        let force = 3.7 * 10_f64.powi(decade);
        let state = sphere.state_by_force(force).unwrap();
        assert_relative_eq!(sphere.state_by_penetration(state.penetration).unwrap().force, force, epsilon = 0.0, max_relative = 2e-15);
        assert_relative_eq!(
            sphere.state_by_contact_radius(state.contact_radius).unwrap().force,
            force,
            epsilon = 0.0,
            max_relative = 2e-15
        );
        let same = millimetres.state_by_force(force).unwrap();
        assert_relative_eq!(same.contact_radius, state.contact_radius * 1e3, epsilon = 0.0, max_relative = 1e-15);
        assert_relative_eq!(same.penetration, state.penetration * 1e3, epsilon = 0.0, max_relative = 1e-15);
    }
}

#[test]
fn arguments_outside_the_meaning_are_refused() {
    assert!(matches!(HertzSphere::new(0.0, 1.0), Err(Refusal::OutOfRange { quantity: "sphere_radius", .. })));
    assert!(matches!(HertzSphere::new(1.0, f64::NAN), Err(Refusal::OutOfRange { quantity: "contact_modulus", .. })));
    let sphere = HertzSphere::new(RADIUS, MODULUS).unwrap();
    assert!(sphere.state_by_force(-1e-9).is_err());
    assert!(sphere.state_by_penetration(-1e-9).is_err());
    assert!(sphere.state_by_contact_radius(1e200).is_err());
    assert!(sphere.pressure(CONTACT, f64::INFINITY).is_err());
    assert!(sphere.pressure(CONTACT, CONTACT).unwrap().abs() < f64::MIN_POSITIVE);
}
