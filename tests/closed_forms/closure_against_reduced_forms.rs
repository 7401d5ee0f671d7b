//! Source: thesis Eqs 5.19–5.21 and 5.37 (the balance), 5.11, 5.12, 5.30, 5.32 (the fields).
//!
//! Goal: the general balance, evaluated from two fields by quadrature, is the running mean that the theory of steady cracks uses.
//!
//! ```text
//!   (1/2δ) ∫₀^δ tension(d) gap(δ − d) dd  =  ½ c K² ⟨J⟩(δ/v)   opening,      ½ c (K₁/E0)² ⟨R⟩(δ/v)   closing,      c = 1 or 2 halves
//! ```
//! Parameters: random materials of 1 to 20 terms over 12 decades with β to 1e6, process zones crossed in 1e-12 to 1e12 of a middle time;
//! synthetic fields with closed forms: powers (Euler's beta function), a layer of any thickness, fields that change sign.
//!
//! Oracle: the running means (held to mpmath in `crack_sec_5_2_5_3_raw_double_integrals`), closed forms.
//!
//! Tolerance: opening 1e-14 relative, all integrands positive. Closing: the stress changes sign, and what is left of it may be 1e-3 of its
//! parts, so the error is held to the stated bounds, plus that of the stress, and both to 1e-14 of the integral of the magnitudes.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use physics::{Random, random_solid, relative};
use proptest::prelude::*;
use std::cell::Cell;
use std::f64::consts::PI;
use viscotack::closure::{EdgeFields, process_zone_work};
use viscotack::crack::CrackBody;
use viscotack::crack::near_tip::{ClosingTip, OpeningTip};
use viscotack::{PlaneMaterial, Refusal};

/// Two fields given by functions of the distance to the edge.
struct Fields<T: Fn(f64) -> f64, G: Fn(f64) -> f64>(T, G);

impl<T: Fn(f64) -> f64, G: Fn(f64) -> f64> EdgeFields for Fields<T, G> {
    fn tension(&self, distance_inside: f64) -> f64 {
        self.0(distance_inside)
    }

    fn gap(&self, distance_outside: f64) -> f64 {
        self.1(distance_outside)
    }
}

/// ½∫ tension·gap/δ by a fixed rule in the logarithms of the distances, good to a percent: for magnitudes and bounds, which have kinks.
fn about(tension: impl Fn(f64) -> f64, gap: impl Fn(f64) -> f64, zone: f64) -> f64 {
    (-1600..=1600)
        .map(|index| {
            let tau = 0.05 * f64::from(index);
            let (left, right) = (1.0 / (1.0 + (-tau).exp()), 1.0 / (1.0 + tau.exp()));
            0.5 * 0.05 * tension(zone * left) * gap(zone * right) * left * right
        })
        .sum()
}

/// A material, a body, a zone length and a speed at which it is crossed in `crossing` times the middle time of the material.
fn case(seed: u64, crossing: f64, two_halves: bool) -> (PlaneMaterial, CrackBody, f64, f64) {
    let mut random = Random(seed);
    let material = random_solid(&mut random, 20, 12.0, 1e6);
    let middle = (material.longest_retardation_time().unwrap() * material.relaxation_terms().last().unwrap().relaxation_time).sqrt();
    let zone = random.decade(1e-9, 1e-3);
    (material, if two_halves { CrackBody::TwoHalves } else { CrackBody::AgainstRigid }, zone, zone / (crossing * middle))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(5), ..ProptestConfig::default() })]

    #[test]
    fn opening_work_is_the_running_mean_of_creep(seed in any::<u64>(), exponent in -12.0..12.0_f64, two in any::<bool>()) {
        let (material, body, zone, speed) = case(seed, 10f64.powf(exponent), two);
        let intensity = 3.7e4;
        let tip = OpeningTip::new(&material, body, intensity, speed).unwrap();
        let work = process_zone_work(&tip, zone, 1e-14).unwrap();
        let mean = material.mean_creep(zone / speed);
        let expected = 0.5 * body.deformable_halves() * intensity * intensity * mean.value;
        let error = (work.value - expected).abs();
        // The gap carries the error of its own mean, the same conversion errors as ⟨J⟩.
        let bar = work.error + expected * (2.0 * mean.relative_error + 6.0 * f64::EPSILON);
        prop_assert!(error <= bar, "{error:e} above {bar:e} of {expected:e}");
        prop_assert!(relative(work.value, expected) <= 1e-14, "{:e}", relative(work.value, expected));
        prop_assert!(work.evaluations <= 1800, "{}", work.evaluations);
    }

    #[test]
    fn closing_work_is_the_running_mean_of_relaxation(seed in any::<u64>(), exponent in -12.0..12.0_f64, two in any::<bool>()) {
        let (material, body, zone, speed) = case(seed, 10f64.powf(exponent), two);
        let intensity = 2.9e-4;
        let tip = ClosingTip::new(&material, body, intensity, speed).unwrap();
        let mean = material.mean_relaxation(zone / speed);
        let expected = 0.5 * body.deformable_halves() * intensity * intensity * mean.value;
        let work = process_zone_work(&tip, zone, 1e-12).unwrap();
        let magnitude = about(|d| tip.tension(d).abs(), |s| tip.gap(s), zone);
        let stress_bar = about(|d| tip.stress(d).unwrap().error, |s| tip.gap(s), zone);
        let error = (work.value - expected).abs();
        let bar = work.error + stress_bar + expected * (mean.relative_error + 6.0 * f64::EPSILON);
        prop_assert!(error <= bar, "{error:e} above {bar:e} of {expected:e}");
        prop_assert!(error <= 1e-14 * magnitude + 1e-12 * expected, "{error:e} of {expected:e}, magnitude {magnitude:e}");
        prop_assert!(work.evaluations <= 3600, "{}", work.evaluations);
    }

    #[test]
    fn powers_give_the_beta_function(p in 0_i32..4, q in 0_i32..4, zone in 1e-9..1e3_f64, amplitude in 1e-6..1e9_f64) {
        // tension d^{p − 1/2}, gap d^{q + 1/2}: (1/2) δ^{p+q} B(p + 1/2, q + 3/2).
        let fields = Fields(|d: f64| amplitude * d.powi(p) / d.sqrt(), |s: f64| s.powi(q) * s.sqrt());
        let work = process_zone_work(&fields, zone, 1e-14).unwrap();
        // B(p + ½, q + 3/2) = π (2p−1)!! (2q+1)!!/(2^{p+q+1} (p+q+1)!)
        let odd = |n: i32| (1..=n).map(|k| f64::from(2 * k - 1)).product::<f64>();
        let factorial: f64 = (1..=p + q + 1).map(f64::from).product();
        let beta = PI * odd(p) * odd(q + 1) / (2f64.powi(p + q + 1) * factorial);
        let expected = 0.5 * amplitude * zone.powi(p + q) * beta;
        prop_assert!((work.value - expected).abs() <= work.error + 8.0 * f64::EPSILON * expected, "{:e} {expected:e} ± {:e}", work.value, work.error);
        prop_assert!(relative(work.value, expected) <= 4e-15);
    }
}

#[test]
fn layers_of_every_thickness_have_their_closed_form() {
    // gap √s·s/(s + ε): a glassy foot of width ε. ∫₀¹ t^{3/2}(1−t)^{−1/2}/(t+ε) dt = π[½ − ε + ε√(ε/(1+ε))].
    let mut worst = 0.0_f64;
    for exponent in -30..=0 {
        let layer = 10f64.powi(exponent);
        let (zone, amplitude) = (4.3e-7, 8.1e5);
        let fields = Fields(|d: f64| amplitude / d.sqrt(), |s: f64| s.sqrt() * s / (s + layer * zone));
        let work = process_zone_work(&fields, zone, 1e-13).unwrap();
        let expected = 0.5 * amplitude * PI * (0.5 - layer + layer * (layer / (1.0 + layer)).sqrt());
        worst = worst.max(relative(work.value, expected));
        assert!((work.value - expected).abs() <= work.error + 8.0 * f64::EPSILON * expected, "ε = {layer:e}");
        // The same layer in the tension: ∫ t^{1/2}(1−t)^{1/2}/(t+ε) dt = π[½ + ε − √(ε(1+ε))].
        let fields = Fields(|d: f64| amplitude * d.sqrt() / (d + layer * zone), |s: f64| s.sqrt());
        let work = process_zone_work(&fields, zone, 1e-13).unwrap();
        let expected = 0.5 * amplitude * PI * (0.5 + layer - (layer * (1.0 + layer)).sqrt());
        assert!((work.value - expected).abs() <= work.error + 2e-15 * amplitude, "ε = {layer:e}: {:e} {expected:e}", work.value);
        worst = worst.max(relative(work.value, expected));
    }
    println!("worst error with a layer {worst:.1e}");
    assert!(worst <= 1e-14);
}

#[test]
fn bounds_hold_where_the_integrand_cancels() {
    // tension (1 − κd)/√d changes sign: ½δ-mean = π/4 − κδ·π/16 of unit amplitudes; at κδ = 4 it vanishes and only rounding is left.
    let zone = 2.9e-6;
    for excess in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.1] {
        let fields = Fields(|d: f64| (1.0 - (4.0 - excess) * d / zone) / d.sqrt(), |s: f64| s.sqrt());
        let expected = 0.5 * PI * excess / 8.0;
        match process_zone_work(&fields, zone, 1e-3) {
            Ok(work) => {
                assert!((work.value - expected).abs() <= work.error, "{excess:e}: {:e} {expected:e} ± {:e}", work.value, work.error)
            }
            Err(refusal) => assert!(matches!(refusal, Refusal::NotConverged { .. }) && excess < 1e-12, "{excess:e}: {refusal}"),
        }
    }
}

#[test]
fn fields_that_are_not_numbers_are_refused_and_so_is_a_zone_of_no_length() {
    let healthy = |s: f64| s.sqrt();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refusal = process_zone_work(&Fields(|d: f64| if d > 3e-7 { bad } else { 1.0 / d.sqrt() }, healthy), 1e-6, 1e-9);
        assert!(matches!(refusal, Err(Refusal::NotConverged { .. })), "{bad}: {refusal:?}");
        let refusal = process_zone_work(&Fields(|d: f64| 1.0 / d.sqrt(), |s: f64| if s > 9e-7 { bad } else { s.sqrt() }), 1e-6, 1e-9);
        assert!(matches!(refusal, Err(Refusal::NotConverged { .. })), "{bad}: {refusal:?}");
    }
    for zone in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refusal = process_zone_work(&Fields(|d: f64| 1.0 / d.sqrt(), healthy), zone, 1e-9);
        assert!(matches!(refusal, Err(Refusal::OutOfRange { quantity: "process_zone", .. })), "{zone}: {refusal:?}");
    }
    // A jump in the middle of the zone is no analytic field: refused at a fine tolerance, bounded at a coarse one.
    let jump = Fields(|d: f64| 1.0 / d.sqrt(), |s: f64| if s < 4.7e-7 { 0.0 } else { s.sqrt() });
    assert!(process_zone_work(&jump, 1e-6, 1e-10).is_err());
    let coarse = process_zone_work(&jump, 1e-6, 0.1).unwrap();
    // ½∫_a^1 √(t/(1−t)) dt = ½[π/2 − arcsin√a + √(a(1−a))].
    let edge = 0.47_f64;
    let expected = 0.5 * (0.5 * PI - edge.sqrt().asin() + (edge * (1.0 - edge)).sqrt());
    assert!((coarse.value - expected).abs() <= coarse.error, "{coarse:?} {expected}");
}

#[test]
fn evaluations_are_counted_and_pinned() {
    let count = Cell::new(0_u64);
    let fields = Fields(
        |d: f64| {
            count.set(count.get() + 1);
            1.0 / d.sqrt()
        },
        |s: f64| s.sqrt(),
    );
    let work = process_zone_work(&fields, 1.0, 1e-14).unwrap();
    assert_eq!(work.evaluations, count.get(), "every pair of evaluations is counted, and each is made once");
    println!("square-root fields: {} evaluations", work.evaluations);
    assert_eq!(work.evaluations, 439);
    let material = PlaneMaterial::standard_solid(1.3e6, 1.3e9, 0.017).unwrap();
    let mut counts = Vec::new();
    for exponent in -6..=6 {
        let speed = 1e-6 / (0.017 * 10f64.powi(exponent));
        let opening = OpeningTip::new(&material, CrackBody::AgainstRigid, 1.0, speed).unwrap();
        let closing = ClosingTip::new(&material, CrackBody::AgainstRigid, 1.0, speed).unwrap();
        counts.push((
            process_zone_work(&opening, 1e-6, 1e-12).unwrap().evaluations,
            process_zone_work(&closing, 1e-6, 1e-12).unwrap().evaluations,
        ));
    }
    println!("one term, β = 1000, T/τ = 1e-6…1e6: {counts:?}");
    assert!(counts.iter().all(|&(opening, closing)| opening <= 880 && closing <= 940), "{counts:?}");
}
