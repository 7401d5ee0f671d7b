//! Source: thesis Secs 3.3–3.6: adhesive and adhesiveless sliding over many decades of speed.
//!
//! Goal: contacts are reached at any speed, with the limits that physics demands: relaxed at rest, glassy when fast, adhesiveless as Γ → 0.
//!
//! Parameters: β = 20 with one term; a twelve-term rubber over twelve decades with a modulus that is no unit; p̄ and Γ as stated.
//!
//! Oracle: `JohnsonWave` and `WestergaardWave` with the relaxed and the glassy modulus (closed forms, with their own tests); the adhesiveless
//! contact without adhesion for Γ → 0; full contact by the complex modulus.
//!
//! Tolerance: the fast limit at a finite process zone δ differs from δ → 0 by O(δ/a): 3δ; Γ → 0 differs by O(√Γ).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::sliding::contact_at_rate;
use viscotack::PlaneMaterial;
use viscotack::elastic::johnson_wave::WaveBranch;
use viscotack::elastic::{JohnsonWave, WestergaardWave};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack::sliding::contact::Prescribed;
use viscotack::sliding::steady::WaveAdhesion;
use viscotack::sliding::steady::full_contact_friction;

fn adhesion(reduced_work: f64, zone: f64) -> WaveAdhesion {
    WaveAdhesion::even(reduced_work, zone)
}

fn johnson(modulus: f64, reduced_work: f64, mean_pressure: f64) -> f64 {
    let wave = WestergaardWave::new(modulus, 2.0 * PI, 1.0).unwrap();
    let adhesive = JohnsonWave::new(wave, PI * reduced_work).unwrap();
    adhesive.state_by_mean_pressure(0.5 * mean_pressure, WaveBranch::Stable).unwrap().contact_half_width
}

#[test]
fn one_term_over_ten_decades_of_speed() {
    let (beta, work, zone, pressure) = (20.0, 0.002, 1e-3, 0.1);
    let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * beta, 0.2).unwrap();
    for exponent in -6..=4 {
        let ratio = 10f64.powi(exponent);
        let found = contact_at_rate(&material, ratio / 0.2, Some(adhesion(work, zone)), Prescribed::MeanPressure(pressure), 1e-11).unwrap();
        let state = &found.state;
        println!(
            "ζ = 1e{exponent}: a {:.6} e {:+.3e} Δ {:.6} μp̄ {:.3e} G₁ {:.4} G₂ {:.4} residual {:.0e} condition {:.1} steps {}",
            state.contact().half_width,
            state.contact().eccentricity,
            state.penetration(),
            state.friction_stress(),
            found.trailing_release,
            found.leading_release,
            found.residual,
            state.condition(),
            found.steps
        );
        assert!(found.admissible);
        assert!((state.mean_pressure() - pressure).abs() < 1e-13);
        assert!(state.friction_stress() > 0.0, "friction opposes the motion");
        if exponent <= -2 {
            // Small-scale losses: each edge is a crack. At ζ near one the bulk rubs, and G of an edge may have any sign.
            assert!(found.trailing_release > 0.99 && found.trailing_release < beta);
            assert!(found.leading_release > 1.0 / beta && found.leading_release < 1.01);
        }
    }
    let half_width = |ratio: f64| {
        let found = contact_at_rate(&material, ratio / 0.2, Some(adhesion(work, zone)), Prescribed::MeanPressure(pressure), 1e-11).unwrap();
        found.state.contact().half_width
    };
    assert!((half_width(1e-7) - johnson(1.0, work, pressure)).abs() < 3.0 * zone);
    assert!((half_width(1e5) - johnson(beta, work, pressure)).abs() < 3.0 * zone);
}

#[test]
fn the_adhesiveless_contact_is_reached_as_adhesion_vanishes_and_its_limits_are_westergaards() {
    let (beta, pressure) = (20.0, 0.1);
    let material = PlaneMaterial::standard_solid(3.1e6, 3.1e6 * beta, 0.5).unwrap();
    let westergaard = |modulus: f64| {
        WestergaardWave::new(modulus, 2.0 * PI, 1.0).unwrap().state_by_mean_pressure(0.5 * pressure).unwrap().contact_half_width
    };
    for ratio in [1e-3, 0.1, 1.0, 30.0] {
        let adhesiveless = contact_at_rate(&material, ratio / 0.5, None, Prescribed::MeanPressure(pressure), 1e-13).unwrap().state;
        let distance = |work: f64| {
            let found =
                contact_at_rate(&material, ratio / 0.5, Some(adhesion(work, 1e-4)), Prescribed::MeanPressure(pressure), 1e-10).unwrap();
            (found.state.contact().half_width - adhesiveless.contact().half_width).abs()
        };
        let (coarse, fine) = (distance(1e-6), distance(1e-8));
        println!("ζ = {ratio}: a {:.6}, adhesive minus adhesiveless {coarse:.2e}, {fine:.2e}", adhesiveless.contact().half_width);
        // √Γ falls tenfold; the process zone of 1e-4 stays.
        assert!(fine < 0.2 * coarse + 2e-4, "{coarse:e} {fine:e}");
        assert!(adhesiveless.friction_stress() > 0.0);
    }
    let half_width = |ratio: f64| {
        contact_at_rate(&material, ratio / 0.5, None, Prescribed::MeanPressure(pressure), 1e-13).unwrap().state.contact().half_width
    };
    assert!((half_width(1e-8) / westergaard(1.0) - 1.0).abs() < 1e-6);
    assert!((half_width(1e8) / westergaard(beta) - 1.0).abs() < 1e-6);
}

/// By the relaxation function in time: a sinusoidal strain of amplitude ε has the loss ω∫₀^∞ (R(t) − E0) cos ωt dt. Simpson's rule over 40 of the
/// longest relaxation times; tolerance 1e-9, its truncation.
#[test]
fn full_contact_friction_is_the_fourier_integral_of_the_relaxation_function() {
    let terms: Vec<CreepTerm> =
        [(2e-7, 0.9), (5e-7, 0.2), (3e-7, 0.05)].map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).to_vec();
    let material = PlaneMaterial::from_creep(2.2e7, &terms, None).unwrap();
    let relaxed = material.relaxed_modulus();
    for rate in [0.3, 4.0, 50.0] {
        let points = 4_000_000;
        let longest = material.relaxation_terms()[0].relaxation_time;
        let step = 40.0 * longest / f64::from(points);
        let integral: f64 = (0..=points)
            .map(|index| {
                let time = f64::from(index) * step;
                let weight = if index == 0 || index == points { 1.0 } else { 2.0 + 2.0 * f64::from(index % 2) };
                weight * (material.relaxation(time) - relaxed) * (rate * time).cos()
            })
            .sum::<f64>()
            * step
            / 3.0;
        let expected = 0.5 * rate * integral / relaxed;
        let found = full_contact_friction(&material, rate).unwrap();
        println!("kv = {rate}: {} against {expected}", found.value);
        assert!((found.value / expected - 1.0).abs() < 1e-9);
    }
}

#[test]
fn full_contact_friction_is_half_the_loss_modulus() {
    // One term: ½ζ(1 − 1/β)/(1 + ε²), ε = ζ/β.
    let (beta, time) = (7.0, 0.3);
    let material = PlaneMaterial::standard_solid(2.2e6, 2.2e6 * beta, time).unwrap();
    for ratio in [1e-3, 0.4, 3.0, 50.0] {
        let epsilon: f64 = ratio / beta;
        let expected = 0.5 * ratio * (1.0 - 1.0 / beta) / (1.0 + epsilon * epsilon);
        assert!((full_contact_friction(&material, ratio / time).unwrap().value / expected - 1.0).abs() < 1e-14);
    }
}

#[test]
fn twelve_terms_over_twelve_decades() {
    // E0 = 1.1 MPa; the glassy modulus is 40 times that, so that partial contact exists at every speed.
    let terms: Vec<RelaxationTerm> =
        (0..12).map(|k| RelaxationTerm { modulus: 1.1e6 * 39.0 / 12.0, relaxation_time: 10f64.powi(2 - k) }).collect();
    let material = PlaneMaterial::from_relaxation(1.1e6, &terms).unwrap();
    for exponent in [-3, 2] {
        let rate = 10f64.powi(exponent);
        let found = contact_at_rate(&material, rate, Some(adhesion(0.002, 1e-3)), Prescribed::MeanPressure(0.1), 1e-10).unwrap();
        let state = &found.state;
        println!(
            "kv = 1e{exponent}/s: a {:.6} e {:+.3e} Δ {:.6} friction {:.3e} G₁ {:.3} G₂ {:.3} condition {:.1}",
            state.contact().half_width,
            state.contact().eccentricity,
            state.penetration(),
            state.friction_stress(),
            found.trailing_release,
            found.leading_release,
            state.condition()
        );
        assert!(found.admissible);
        assert!(state.condition() < 1e3, "the memory-load form keeps its scale");
        assert!(state.friction_stress() > 0.0);
    }
}
