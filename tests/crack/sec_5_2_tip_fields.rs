//! Source: thesis Secs 5.2 and 5.3, Eqs 5.11–5.18, 5.30–5.36, Figs 5.2 and 5.4.
//!
//! Goal: the opening and the stress around a moving tip, from deep inside the glassy zone to far in the relaxed one.
//!
//! ```text
//!   opening, ln u                     ____  K/E0 √(8s/π)            closing, ln σ    \___ (E∞/E0)K₁/√(2πd)
//!            slope ½   _____-----                                                        \
//!   ____-----  K/E∞ √(8s/π)                                                               |  compressive for β > 4.51    ___ K₁/√(2πd)
//!   ──────────────────────────► ln s                                ─────────────────────────────────────────► ln d
//! ```
//! Parameters: one to several terms, β from 1.5 to 1e6, distances over 20 decades around vτ, two unit systems.
//!
//! Oracle: the two asymptotes with their next terms, the vanishing net force of the closing stress, mpmath values through
//! `crack_sec_5_2_5_3_raw_double_integrals`.
//!
//! Tolerance: 1e-14 relative beyond the next term of an asymptote. The naive difference is shown to lose β ulp: six digits at β = 1e6.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use physics::{Random, in_mpa_ms, random_solid, relative};
use std::f64::consts::{PI, TAU};
use viscotack::closure::EdgeFields;
use viscotack::crack::CrackBody;
use viscotack::crack::near_tip::{ClosingTip, OpeningTip};
use viscotack::material::{PlaneMaterial, RelaxationTerm};
use viscotack::special::dawson::dawson;
use viscotack::special::gauss_legendre::UNIT_RULE;

const RIGID: CrackBody = CrackBody::AgainstRigid;
const INTENSITY: f64 = 4.1e4;

#[test]
fn trumpet_between_its_two_parabolas_over_twenty_decades() {
    for beta in [2.0, 1e3, 1e6] {
        let material = PlaneMaterial::standard_solid(7.9e5, 7.9e5 * beta, 0.023).unwrap();
        let speed = 3.7e-4;
        let length = speed * 0.023;
        let tip = OpeningTip::new(&material, RIGID, INTENSITY, speed).unwrap();
        let mut before: Option<(f64, f64)> = None;
        for index in -200..=200 {
            let s = length * 10f64.powf(f64::from(index) / 20.0);
            let opening = tip.displacement(s).unwrap();
            let parabola = INTENSITY * (8.0 * s / PI).sqrt();
            let compliance = opening.value / parabola;
            assert!(opening.value > 0.0 && opening.relative_error() < 5e-15);
            // 1/E∞ ≤ u/parabola ≤ 1/E0 and the next terms: (2/3)s/vτ near, vτ/(2s) far, of the term's own compliance.
            let gained = material.creep_terms()[0].compliance;
            assert!(compliance >= (1.0 - 1e-15) / material.glassy_modulus() && compliance <= (1.0 + 1e-15) / material.relaxed_modulus());
            let (near, far) = (2.0 / 3.0 * s / length, 0.5 * length / s);
            if near < 1e-8 {
                let expected = 1.0 / material.glassy_modulus() + gained * near;
                assert!(relative(compliance, expected) <= 2e-8 * near.min(1.0) * beta.min(1.0 / near) + 2e-15, "β = {beta:e}, s = {s:e}");
            }
            if far < 1e-8 {
                let expected = 1.0 / material.relaxed_modulus() - gained * far;
                assert!(relative(compliance, expected) <= 4e-15, "β = {beta:e}, s = {s:e}: {:e}", relative(compliance, expected));
            }
            // Slope ½ at both ends, more between, never less.
            if let Some((last_s, last)) = before {
                let slope = (opening.value / last).ln() / (s / last_s).ln();
                assert!(slope >= 0.5 - 1e-13, "{slope}");
                if near * beta < 1e-9 || far < 1e-9 {
                    assert!((slope - 0.5).abs() < 3e-9, "β = {beta:e}, s/vτ = {:e}: slope {slope}", s / length);
                }
            }
            before = Some((s, opening.value));
        }
    }
}

#[test]
fn two_radii_of_the_trumpet_eqs_5_16_and_5_18() {
    let mut random = Random(71);
    for _ in 0..50 {
        let material = random_solid(&mut random, 12, 9.0, 1e6);
        let tip = OpeningTip::new(&material, RIGID, INTENSITY, 1e-3).unwrap();
        let beta = material.stiffening_ratio();
        assert!(relative(tip.relaxed_radius().unwrap() / tip.glassy_radius(), beta * beta) <= 8.0 * f64::EPSILON);
        // ρ = u²/(2s) of the parabola u² = 2ρs, at each end of the profile.
        let shortest = material.creep_terms().last().unwrap().retardation_time;
        let longest = material.longest_retardation_time().unwrap();
        let radius = |s: f64| tip.displacement(s).unwrap().value.powi(2) / (2.0 * s);
        assert!(relative(radius(1e-3 * shortest * 1e-9 / beta), tip.glassy_radius()) <= 1e-6);
        assert!(relative(radius(1e-3 * longest * 1e9), tip.relaxed_radius().unwrap()) <= 1e-6);
        // In terms of G = K²/(2E0): 8G/(πβE∞) and 8G/(πE0).
        let rate = INTENSITY * INTENSITY / (2.0 * material.relaxed_modulus());
        assert!(relative(tip.glassy_radius(), 8.0 * rate / (PI * beta * material.glassy_modulus())) <= 8.0 * f64::EPSILON);
        assert!(relative(tip.relaxed_radius().unwrap(), 8.0 * rate / (PI * material.relaxed_modulus())) <= 8.0 * f64::EPSILON);
    }
}

#[test]
fn naive_difference_of_the_trumpet_loses_beta_ulp_near_the_tip() {
    let material = PlaneMaterial::standard_solid(7.9e3, 7.9e9, 0.023).unwrap();
    let speed = 3.7e-4;
    let tip = OpeningTip::new(&material, RIGID, INTENSITY, speed).unwrap();
    let term = material.creep_terms()[0];
    let mut lost = Vec::new();
    for exponent in [-4, -6, -8, -10, -12] {
        let s = speed * 0.023 * 10f64.powi(exponent);
        let length = (speed * term.retardation_time).sqrt();
        // K√(8/π)[√s/E0 − J₁√(vτ)D(√(s/vτ))], Eq 5.11 with the integral done.
        let naive =
            INTENSITY * (8.0 / PI).sqrt() * (s.sqrt() / material.relaxed_modulus() - term.compliance * length * dawson(s.sqrt() / length));
        let near =
            INTENSITY * (8.0 * s / PI).sqrt() * (1.0 / material.glassy_modulus() + term.compliance * 2.0 / 3.0 * 10f64.powi(exponent));
        let value = tip.displacement(s).unwrap().value;
        // The next term is −(4/15)(s/vτ)² J₁.
        assert!(relative(value, near) <= 0.4 * 10f64.powi(exponent) + 3e-15, "{value:e} {near:e}");
        lost.push(relative(naive, value));
    }
    println!("relative error of the naive form at s/vτ = 1e-4 … 1e-12, β = 1e6: {lost:?}");
    assert!(lost[4] > 1e-11, "the naive form is as good: {lost:?}");
}

#[test]
fn closing_stress_between_its_two_hyperbolas_over_twenty_decades() {
    for beta in [1.5, 100.0, 1e6] {
        let material = PlaneMaterial::standard_solid(7.9e5, 7.9e5 * beta, 0.023).unwrap();
        let (speed, time) = (3.7e-4, material.relaxation_terms()[0].relaxation_time);
        let (length, displacement) = (speed * time, 2.3e-4);
        let tip = ClosingTip::new(&material, RIGID, displacement, speed).unwrap();
        let lost = material.relaxation_terms()[0].modulus;
        for index in -200..=200 {
            let d = length * 10f64.powf(f64::from(index) / 20.0);
            let stress = tip.stress(d).unwrap();
            let modulus = stress.value * (TAU * d).sqrt() / displacement;
            let (near, far) = (2.0 * d / length, 0.5 * length / d);
            assert!(modulus <= material.glassy_modulus() * (1.0 + 1e-15));
            if near < 1e-8 {
                assert!(relative(modulus, material.glassy_modulus() - lost * near) <= 4e-15, "near, β = {beta}");
            }
            // Far: D′ = −(1/2y²)(1 + 3/(2y²) + …).
            if far < 1e-8 {
                let expected = material.relaxed_modulus() - lost * far * (1.0 + 3.0 * far);
                let scale = material.relaxed_modulus() + lost * far;
                assert!((modulus - expected).abs() <= 4e-15 * scale, "far, β = {beta}: {modulus:e} {expected:e}");
            }
            assert!(
                (tip.displacement(d).unwrap().value - displacement * (8.0 * d / PI).sqrt()).abs()
                    <= 4.0 * f64::EPSILON * displacement * d.sqrt()
            );
        }
        assert!(relative(tip.radius(), 4.0 / PI * displacement * displacement) <= 2.0 * f64::EPSILON);
        // Slope −½ at both ends; the far stress recovers K₁ only a factor β beyond vρ, at vτ.
        let slope = |d: f64| (tip.stress(1.1 * d).unwrap().value / tip.stress(d).unwrap().value).ln() / 1.1f64.ln();
        assert!((slope(1e-9 * length) + 0.5).abs() < 1e-7 && (slope(1e9 * beta * length) + 0.5).abs() < 1e-7);
    }
}

/// The smallest value of [E0 + ΣE_i D′(y_i)]/E0 over all distances: negative exactly if there is a compressive zone.
fn smallest_bracket(material: &PlaneMaterial) -> f64 {
    let speed = 1e-3;
    let tip = ClosingTip::new(material, RIGID, 1.0 / material.relaxed_modulus(), speed).unwrap();
    let (first, last) = (material.relaxation_terms().last().unwrap().relaxation_time, material.longest_relaxation_time().unwrap());
    let count = (200.0 * (2.0 + (last / first).log10())) as i32;
    (-100..=count)
        .map(|index| {
            let d = speed * first * 10f64.powf(f64::from(index) / 200.0);
            tip.stress(d).unwrap().value * (TAU * d).sqrt()
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn a_compressive_zone_exists_if_one_drop_of_modulus_exceeds_the_factor_4_51() {
    // One term: E0 + E₁D′(y) with D′ ≥ −0.284749 (at y = 1.501975), so compression iff β − 1 > 1/0.284749, β > 4.51185.
    let threshold = 1.0 + 1.0 / 0.284_749_4;
    println!("one term: compressive zone iff β > {threshold:.4}");
    for (beta, compressive) in [(2.0, false), (4.0, false), (threshold - 2e-3, false), (threshold + 2e-3, true), (5.0, true), (1e6, true)] {
        let material = PlaneMaterial::standard_solid(7.9e5, 7.9e5 * beta, 0.023).unwrap();
        let smallest = smallest_bracket(&material);
        assert_eq!(smallest < 0.0, compressive, "β = {beta}: {smallest}");
        assert!((smallest - (1.0 - 0.284_749_4 * (beta - 1.0))).abs() <= 1e-4 * beta, "{smallest}");
    }
    // Many decades apart each drop counts by itself, E_i against all that is left behind it: β = 4⁶ = 4096 without compression …
    let stairs = |factor: f64, count: i32| {
        let terms: Vec<RelaxationTerm> = (0..count)
            .map(|index| RelaxationTerm {
                modulus: 7.9e5 * factor.powi(index) * (factor - 1.0),
                relaxation_time: 10f64.powi(3 - 5 * index),
            })
            .collect();
        PlaneMaterial::from_relaxation(7.9e5, &terms).unwrap()
    };
    let gentle = stairs(4.0, 6);
    assert!(relative(gentle.stiffening_ratio(), 4096.0) < 1e-12 && smallest_bracket(&gentle) > 0.0, "{}", smallest_bracket(&gentle));
    // … and steps of 5 with it, at every step.
    let steep = stairs(5.0, 3);
    assert!(smallest_bracket(&steep) < 0.0);
    let speed = 1e-3;
    let tip = ClosingTip::new(&steep, RIGID, 1e-4, speed).unwrap();
    for term in steep.relaxation_terms() {
        assert!(tip.stress(2.2559 * speed * term.relaxation_time).unwrap().value < 0.0, "at ρ = {:e}", term.relaxation_time);
    }
    // In any case no more than 0.285(β − 1) of the far stress.
    let mut random = Random(73);
    for _ in 0..100 {
        let material = random_solid(&mut random, 12, 9.0, 1e6);
        assert!(smallest_bracket(&material) >= 1.0 - 0.284_75 * (material.stiffening_ratio() - 1.0));
    }
}

#[test]
fn closing_stress_carries_no_net_force_beyond_its_far_field() {
    // ∫₀^x [σ − K₁/√(2πd)] dd = K₁/(E0√(2π)) Σ E_i 2√(vρ_i) D(√(x/vρ_i)): positive, and zero for x → ∞. The glassy excess at the tip is
    // paid back exactly by the missing tension behind it.
    let mut random = Random(79);
    let mut worst = 0.0_f64;
    for _ in 0..30 {
        let material = random_solid(&mut random, 6, 5.0, 1e4);
        let (speed, displacement) = (2.9e-4, 3.1e-4);
        let tip = ClosingTip::new(&material, RIGID, displacement, speed).unwrap();
        let shortest = material.relaxation_terms().last().unwrap().relaxation_time;
        let relaxed = material.relaxed_modulus();
        let excess = |d: f64| tip.tension(d) - displacement * relaxed / (TAU * d).sqrt();
        // In q = √d the excess times dd is smooth; panels grow by √2.
        let (mut sum, mut owed, mut magnitude, mut left, mut width) = (0.0, 0.0, 0.0, 0.0, 1e-3 * (speed * shortest).sqrt());
        let mut checked = 0;
        let far = 1e3 * (speed * material.longest_relaxation_time().unwrap()).sqrt();
        while left < far {
            for &(node, weight) in UNIT_RULE.iter() {
                let q = left + width * node;
                let part = weight * width * 2.0 * q * excess(q * q);
                sum += part;
                owed += part.abs();
                // Rounding is relative to the two stresses that are subtracted.
                magnitude += weight * width * 2.0 * q * tip.tension(q * q).abs() + part.abs();
            }
            left += width;
            width = width.max(0.3 * left);
            let expected: f64 = material
                .relaxation_terms()
                .iter()
                .map(|term| {
                    term.modulus * 2.0 * (speed * term.relaxation_time).sqrt() * dawson(left / (speed * term.relaxation_time).sqrt())
                })
                .sum::<f64>()
                * displacement
                / TAU.sqrt();
            let error = (sum - expected).abs() / magnitude;
            assert!(error <= 1e-14 && expected > 0.0, "at √d = {left:e}: {sum:e} {expected:e}");
            worst = worst.max(error);
            checked += 1;
        }
        assert!(sum < 2e-2 * owed && checked > 30, "{sum:e} of {owed:e}");
    }
    println!("force balance to {worst:.1e} of the magnitudes");
}

#[test]
fn fields_in_two_unit_systems_and_for_two_halves() {
    let mut random = Random(83);
    for _ in 0..30 {
        let si = random_solid(&mut random, 8, 9.0, 1e5);
        let other = in_mpa_ms(&si);
        let (speed, distance) = (random.decade(1e-9, 1e2), random.decade(1e-12, 1e-3));
        // Pa√m → MPa√mm: 1e-6·√1e3; √m → √mm: √1e3. m/s = mm/ms.
        let root = 1e3_f64.sqrt();
        let one = OpeningTip::new(&si, RIGID, INTENSITY, speed).unwrap().displacement(distance).unwrap().value;
        let two = OpeningTip::new(&other, RIGID, INTENSITY * 1e-6 * root, speed).unwrap().displacement(distance * 1e3).unwrap().value;
        assert!(relative(two, one * 1e3) <= 1e-14, "{one:e} {two:e}");
        let one = ClosingTip::new(&si, RIGID, 2.3e-4, speed).unwrap().stress(distance).unwrap();
        let two = ClosingTip::new(&other, RIGID, 2.3e-4 * root, speed).unwrap().stress(distance * 1e3).unwrap();
        assert!((two.value - one.value * 1e-6).abs() <= 2.0 * (two.error + one.error * 1e-6), "{one:?} {two:?}");
        // Two halves: the same fields of each, twice the gap.
        let (single, double) =
            (OpeningTip::new(&si, RIGID, INTENSITY, speed).unwrap(), OpeningTip::new(&si, CrackBody::TwoHalves, INTENSITY, speed).unwrap());
        assert!(relative(double.gap(distance), 2.0 * single.gap(distance)) <= f64::EPSILON);
        assert!(relative(double.tension(distance), single.tension(distance)) <= f64::EPSILON);
    }
}

#[test]
fn elastic_limits_at_rest_and_infinitely_fast() {
    let material = PlaneMaterial::standard_solid(7.9e5, 7.9e8, 0.023).unwrap();
    for s in [1e-9, 1e-6, 1e-2] {
        for (speed, modulus) in [(0.0, 7.9e5), (f64::INFINITY, 7.9e8)] {
            let opening = OpeningTip::new(&material, RIGID, INTENSITY, speed).unwrap().displacement(s).unwrap().value;
            assert!(relative(opening, INTENSITY / modulus * (8.0 * s / PI).sqrt()) <= 4.0 * f64::EPSILON, "v = {speed}");
            let stress = ClosingTip::new(&material, RIGID, 2.3e-4, speed).unwrap().stress(s).unwrap().value;
            assert!(relative(stress, 2.3e-4 * modulus / (TAU * s).sqrt()) <= 4.0 * f64::EPSILON, "v = {speed}");
        }
    }
    let tip = OpeningTip::new(&material, RIGID, INTENSITY, 1e-3).unwrap();
    assert!(tip.displacement(0.0).unwrap().value.abs() <= 0.0);
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(tip.displacement(bad).is_err());
        assert!(ClosingTip::new(&material, RIGID, 2.3e-4, 1e-3).unwrap().stress(bad).is_err());
        assert!(OpeningTip::new(&material, RIGID, bad, 1e-3).is_err());
    }
    let fluid = PlaneMaterial::from_relaxation(0.0, &[RelaxationTerm { modulus: 3.3e6, relaxation_time: 0.7 }]).unwrap();
    assert!(OpeningTip::new(&fluid, RIGID, INTENSITY, 0.0).unwrap().displacement(1e-6).is_err());
    assert!(OpeningTip::new(&fluid, RIGID, INTENSITY, 1e-6).unwrap().relaxed_radius().is_err());
}
