//! Stored and dissipated energy of a strip under a stress step.
//!
//! Source: thesis Eq 5.48 (stored energy; its 1/E_j are the compliances J_j).
//! Goal: stored + dissipated = work of the stress, at every time and for any spectrum, plane state and unit.
//!
//! ```text
//!   σ0 --/\/\--[/\/\ ∥ ==]--[/\/\ ∥ ==]-- σ0
//! ```
//!
//! Parameters: E∞ = 41 MPa; creep terms (0.7/MPa, 3 ms), (2.9/MPa, 0.8 s), (11/MPa, 700 s); σ0 = 0.13 MPa; ν = 0.37.
//! Oracles: (i) the energy balance with the strain taken from each Voigt element integrated in time by Runge-Kutta; (ii) the dissipation as quadrature of
//! (τ/J)ė²; (iii) elastic limits at t = 0 and t → ∞; (iv) a term split in two equal ones.
//! Tolerance: 1e-9 for Runge-Kutta (4000 steps), 1e-14 for identities.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use viscotack::elastic::strip_energy::elastic_energy_density;
use viscotack::elastic::{CreepingStrip, PlaneState};

const GLASSY: f64 = 41e6;
const TERMS: [(f64, f64); 3] = [(0.7e-6, 3e-3), (2.9e-6, 0.8), (11e-6, 700.0)];
const STRESS: f64 = 0.13e6;
const NU: f64 = 0.37;

#[test]
fn stored_and_dissipated_energy_follow_from_the_voigt_elements() {
    for time in [1e-3_f64, 0.02, 2.0, 400.0] {
        let (mut strain, mut stored, mut lost) = (STRESS / GLASSY, 0.5 * STRESS * STRESS / GLASSY, 0.0);
        for (compliance, retardation) in TERMS {
            // ė = (Jσ0 − e)/τ with Runge-Kutta 4; only the part of the time in which the element moves.
            let end = time.min(45.0 * retardation);
            let n = 4000;
            let h = end / f64::from(n);
            let rate = |e: f64| (compliance * STRESS - e) / retardation;
            let power = |e: f64| retardation / compliance * rate(e).powi(2);
            let mut e = 0.0;
            for _ in 0..n {
                let k1 = rate(e);
                let k2 = rate(e + 0.5 * h * k1);
                let k3 = rate(e + 0.5 * h * k2);
                let k4 = rate(e + h * k3);
                let next = e + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
                let middle = 0.5 * (e + next) + h / 8.0 * (rate(e) - rate(next));
                lost += h / 6.0 * (power(e) + 4.0 * power(middle) + power(next));
                e = next;
            }
            strain += e;
            stored += 0.5 * e * e / compliance;
        }
        let strip = CreepingStrip::new(GLASSY, &TERMS, PlaneState::Stress, NU).unwrap();
        assert_relative_eq!(strip.strain(STRESS, time).unwrap(), strain, epsilon = 0.0, max_relative = 1e-9);
        assert_relative_eq!(strip.stored_energy_density(STRESS, time).unwrap(), stored, epsilon = 0.0, max_relative = 1e-9);
        assert_relative_eq!(strip.dissipated_energy_density(STRESS, time).unwrap(), lost, epsilon = 0.0, max_relative = 1e-8);
    }
}

#[test]
fn energy_balance_holds_to_rounding() {
    for state in [PlaneState::Stress, PlaneState::Strain] {
        let strip = CreepingStrip::new(GLASSY, &TERMS, state, NU).unwrap();
        for decade in -12..9 {
            let time = 1.7 * 10_f64.powi(decade);
            let creep = strip.strain(STRESS, time).unwrap() - strip.strain(STRESS, 0.0).unwrap();
            let work = STRESS * creep + strip.stored_energy_density(STRESS, 0.0).unwrap();
            let sum = strip.stored_energy_density(STRESS, time).unwrap() + strip.dissipated_energy_density(STRESS, time).unwrap();
            assert_relative_eq!(sum, work, epsilon = 0.0, max_relative = 1e-14);
        }
        // The first instants: dissipation σ0²Σ(J/τ)t, digits kept although 1 − exp(−2t/τ) is 1e-12.
        let early = 1e-15;
        let rate: f64 = TERMS.iter().map(|(compliance, time)| compliance / time).sum();
        let factor = 1.0 / state.stiffening(NU).unwrap();
        assert_relative_eq!(
            strip.dissipated_energy_density(STRESS, early).unwrap(),
            factor * STRESS * STRESS * rate * early,
            epsilon = 0.0,
            max_relative = 1e-12
        );
    }
}

#[test]
fn ends_are_elastic_and_plane_strain_stores_less() {
    let relaxed = 1.0 / (1.0 / GLASSY + TERMS.iter().map(|(compliance, _)| compliance).sum::<f64>());
    for state in [PlaneState::Stress, PlaneState::Strain] {
        let strip = CreepingStrip::new(GLASSY, &TERMS, state, NU).unwrap();
        for (time, modulus) in [(0.0, GLASSY), (f64::INFINITY, relaxed), (1e6, relaxed)] {
            let elastic = elastic_energy_density(STRESS, modulus, state, NU).unwrap();
            assert_relative_eq!(strip.stored_energy_density(STRESS, time).unwrap(), elastic, epsilon = 0.0, max_relative = 4e-15);
            assert_relative_eq!(strip.stored_energy_density(-STRESS, time).unwrap(), elastic, epsilon = 0.0, max_relative = 4e-15);
        }
    }
    // Hooke in plane strain: ε_z = 0 needs σ_z = νσ, and the work per volume is ½σ(σ − νσ_z)/E.
    let hooke = 0.5 * STRESS * (STRESS - NU * NU * STRESS) / GLASSY;
    assert_relative_eq!(
        elastic_energy_density(STRESS, GLASSY, PlaneState::Strain, NU).unwrap(),
        hooke,
        epsilon = 0.0,
        max_relative = 2e-15
    );
}

#[test]
fn splitting_a_term_and_changing_units_change_nothing() {
    let strip = CreepingStrip::new(GLASSY, &TERMS, PlaneState::Strain, NU).unwrap();
    let mut split = vec![(0.5 * TERMS[0].0, TERMS[0].1); 2];
    split.extend_from_slice(&TERMS[1..]);
    let split = CreepingStrip::new(GLASSY, &split, PlaneState::Strain, NU).unwrap();
    let scaled: Vec<_> = TERMS.iter().map(|(compliance, time)| (compliance * 1e6, *time)).collect();
    let millimetres = CreepingStrip::new(GLASSY * 1e-6, &scaled, PlaneState::Strain, NU).unwrap();
    for time in [0.0, 1e-3, 5.0, 1e4] {
        let value = strip.stored_energy_density(STRESS, time).unwrap();
        assert_relative_eq!(split.stored_energy_density(STRESS, time).unwrap(), value, epsilon = 0.0, max_relative = 2e-15);
        assert_relative_eq!(
            millimetres.stored_energy_density(STRESS * 1e-6, time).unwrap() * 1e6,
            value,
            epsilon = 0.0,
            max_relative = 2e-15
        );
    }
    assert!(strip.strain(STRESS, -1.0).is_err() && strip.strain(STRESS, f64::NAN).is_err());
    assert!(strip.stored_energy_density(f64::NAN, 1.0).is_err() && strip.stored_energy_density(1e200, 1.0).is_err());
    assert!(CreepingStrip::new(GLASSY, &[(1e-6, 0.0)], PlaneState::Stress, NU).is_err());
    assert!(CreepingStrip::new(GLASSY, &TERMS, PlaneState::Strain, 0.51).is_err());
    assert!(CreepingStrip::new(GLASSY, &[], PlaneState::Stress, NU).is_ok());
}
