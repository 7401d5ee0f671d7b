//! Source: thesis Eqs 3.16–3.24 (the integral equation of a sliding contact) and theory of the memory loads in `sliding::contact`.
//!
//! Goal: the pressure of a contact with given edges, put through the exact Fourier symbol of the material, returns the wave inside the contact
//! and the computed gap outside; totals (mean, penetration, friction) by the same route.
//!
//! ```text
//!   p(y) ─► p̂_m = ∫p e^{−imy} ─► ŵ_m = Ĉ_m p̂_m/(πm),  Ĉ_m = 1/β + Σ j_j/(1 − imζ_j) ─► w(y) = cos(y + e) − 1 + Δ (+ gap outside)
//! ```
//! Parameters: 1, 2, 6 and 12 terms, β from 10 to 1000, sliding ratios from 0.01 to 1e9 (layers that 2000 points resolve), non-unit moduli.
//!
//! Oracle: the Fourier sum itself, which knows nothing of memory loads; pressures at Chebyshev points take both edge roots exactly.
//!
//! Tolerance: the sum of 2000 harmonics of a field with square-root edges, Cesàro-averaged twice, is good to about 1e-4 of Λ; so is the test.
//! Integrals of p have spectral accuracy: 1e-9.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, ContactState, Prescribed, WaveContact};

const HARMONICS: usize = 2000;
const POINTS: usize = 2000;

fn material(relaxed: f64, beta: f64, times: &[f64]) -> PlaneMaterial {
    let gained = (1.0 - 1.0 / beta) / relaxed;
    let terms: Vec<CreepTerm> =
        times.iter().map(|&retardation_time| CreepTerm { compliance: gained / times.len() as f64, retardation_time }).collect();
    PlaneMaterial::from_creep(relaxed * beta, &terms, None).unwrap()
}

/// Ĉ_m of a material at a rate kv, from its creep series alone.
fn symbol(material: &PlaneMaterial, rate: f64, harmonic: f64) -> (f64, f64) {
    let relaxed = material.relaxed_modulus();
    let (mut real, mut imaginary) = (relaxed / material.glassy_modulus(), 0.0);
    for term in material.creep_terms() {
        let y = harmonic * rate * term.retardation_time;
        real += term.compliance * relaxed / (1.0 + y * y);
        imaginary += term.compliance * relaxed * y / (1.0 + y * y);
    }
    (real, imaginary)
}

fn check(name: &str, material: &PlaneMaterial, rate: f64, contact: WaveContact, mean_pressure: f64) {
    let memory = ContactMemory::new(material, rate).unwrap();
    let state = ContactState::new(&memory, contact, Prescribed::MeanPressure(mean_pressure)).unwrap();
    let a = contact.half_width;
    // Chebyshev points: dy = a sin θ dθ takes the edge roots of p.
    let step = PI / POINTS as f64;
    let samples: Vec<(f64, f64)> = (0..POINTS)
        .map(|index| {
            let theta = (index as f64 + 0.5) * step;
            let distance = 2.0 * a * (0.5 * theta).sin().powi(2);
            let point = if theta < 0.5 * PI {
                state.inside_trailing(distance)
            } else {
                state.inside_leading(2.0 * a * (0.5 * theta).cos().powi(2))
            };
            (-a * theta.cos(), state.pressure(point.unwrap()) * a * theta.sin() * step)
        })
        .collect();
    let mean = samples.iter().map(|sample| sample.1).sum::<f64>() / (2.0 * PI);
    assert!((mean - mean_pressure).abs() < 2e-6 * (1.0 + mean_pressure.abs()), "{name}: mean pressure {mean} instead of {mean_pressure}");
    let coefficients: Vec<(f64, f64)> = (1..=HARMONICS)
        .map(|m| {
            let m = m as f64;
            let (real, imaginary) = samples.iter().fold((0.0, 0.0), |sum, &(y, weight)| {
                let (sine, cosine) = (m * y).sin_cos();
                (sum.0 + weight * cosine, sum.1 - weight * sine)
            });
            let c = symbol(material, rate, m);
            ((c.0 * real - c.1 * imaginary) / (PI * m), (c.0 * imaginary + c.1 * real) / (PI * m))
        })
        .collect();
    // Friction from the first harmonic of p itself, by quadrature of the samples.
    let (first_real, first_imaginary) =
        samples.iter().fold((0.0, 0.0), |sum, &(y, weight)| (sum.0 + weight * y.cos(), sum.1 - weight * y.sin()));
    let (sin_e, cos_e) = contact.eccentricity.sin_cos();
    let friction = -(first_imaginary * cos_e - first_real * sin_e) / (2.0 * PI);
    assert!(
        (friction - state.friction_stress()).abs() < 2e-6 * (1.0 + friction.abs()),
        "{name}: friction {friction} {}",
        state.friction_stress()
    );
    let displacement = |y: f64| {
        let mut sum = 0.0;
        let mut first = 0.0;
        let mut total = 0.0;
        for (index, &(real, imaginary)) in coefficients.iter().enumerate() {
            let (sine, cosine) = ((index + 1) as f64 * y).sin_cos();
            sum += real * cosine - imaginary * sine;
            // The mean of the last half of the partial sums.
            if index >= HARMONICS / 2 {
                first += sum;
                total += 1.0;
            }
        }
        first / total
    };
    for part in [-0.7, -0.2, 0.1, 0.6] {
        let y = part * a;
        let expected = (y + contact.eccentricity).cos() - 1.0 + state.penetration();
        let found = displacement(y);
        assert!((found - expected).abs() < 2e-4, "{name}: inside at {part} a: {found} instead of {expected}");
    }
    for part in [0.1, 0.4, 0.8] {
        let distance = part * 2.0 * (PI - a);
        let y = 2.0 * PI - a - distance;
        let gap = state.gap(state.behind_trailing(distance).unwrap());
        let expected = (y + contact.eccentricity).cos() - 1.0 + state.penetration() + gap;
        let found = displacement(y);
        assert!((found - expected).abs() < 2e-4, "{name}: outside at {part}: {found} instead of {expected} (gap {gap})");
    }
    assert!(state.condition() < 300.0, "{name}: condition {:e}", state.condition());
}

#[test]
fn pressure_through_the_symbol_returns_the_wave_and_the_gap() {
    let contact = |half_width, eccentricity| WaveContact { half_width, eccentricity };
    check("1 term", &material(0.7e6, 10.0, &[1.0]), 0.3, contact(1.0, 0.1), 0.2);
    check("1 term, fast", &material(0.7e6, 100.0, &[1.0]), 30.0, contact(2.0, 0.02), -0.1);
    check("2 terms", &material(3.0, 100.0, &[1.0, 0.01]), 3.0, contact(1.2, 0.05), 0.1);
    check("6 terms", &material(2e5, 50.0, &[1e3, 1e2, 10.0, 1.0, 0.1, 0.01]), 1.0, contact(0.8, -0.03), 0.05);
    let times: Vec<f64> = (0..12).map(|k| 10f64.powi(9 - k)).collect();
    check("12 terms, ten of them slower than the passage", &material(1.1e6, 1000.0, &times), 0.7, contact(1.2, 0.05), 0.1);
}

#[test]
fn both_controls_agree_and_the_elastic_contact_is_recovered() {
    let viscoelastic = material(0.7e6, 100.0, &[1.0, 0.02]);
    let memory = ContactMemory::new(&viscoelastic, 2.0).unwrap();
    let contact = WaveContact { half_width: 1.1, eccentricity: 0.07 };
    let by_load = ContactState::new(&memory, contact, Prescribed::MeanPressure(0.13)).unwrap();
    let by_depth = ContactState::new(&memory, contact, Prescribed::Penetration(by_load.penetration())).unwrap();
    assert!((by_depth.mean_pressure() - 0.13).abs() < 1e-14, "{}", by_depth.mean_pressure());
    assert!((by_depth.friction_stress() / by_load.friction_stress() - 1.0).abs() < 1e-13);
    // Elastic and centred: Δ = 1 − (1 − s² + 2s² ln s) − D ln s with D = 2(p̄ − s²) (theory of the Westergaard wave).
    let elastic = PlaneMaterial::elastic(2.5e6).unwrap();
    let memory = ContactMemory::new(&elastic, 1.0).unwrap();
    let state = ContactState::new(&memory, WaveContact { half_width: 1.1, eccentricity: 0.0 }, Prescribed::MeanPressure(0.2)).unwrap();
    let s = 0.55_f64.sin();
    let expected = 1.0 - (1.0 - s * s + 2.0 * s * s * s.ln()) - 2.0 * (0.2 - s * s) * s.ln();
    assert!((state.penetration() - expected).abs() < 1e-15);
    assert!(state.friction_stress().abs() < 1e-16);
}

#[test]
fn splitting_a_term_or_adding_a_vanishing_one_changes_nothing() {
    let contact = WaveContact { half_width: 1.3, eccentricity: 0.04 };
    let solved = |terms: &[CreepTerm]| {
        let material = PlaneMaterial::from_creep(6.6e7, terms, None).unwrap();
        ContactState::new(&ContactMemory::new(&material, 1.7).unwrap(), contact, Prescribed::MeanPressure(0.1)).unwrap()
    };
    let term = |compliance: f64, retardation_time: f64| CreepTerm { compliance, retardation_time };
    let one = solved(&[term(1.4e-6, 0.3)]);
    for (name, other, tolerance) in [
        ("two equal halves", solved(&[term(0.7e-6, 0.3), term(0.7e-6, 0.3)]), 1e-14),
        ("two nearly equal halves", solved(&[term(0.7e-6, 0.3), term(0.7e-6, 0.3 * (1.0 + 1e-9))]), 1e-8),
        ("a vanishing term", solved(&[term(1.4e-6, 0.3), term(1.4e-22, 5.0)]), 1e-13),
    ] {
        for (left, right) in [
            (one.penetration(), other.penetration()),
            (one.friction_stress(), other.friction_stress()),
            (one.edge_amplitudes().1, other.edge_amplitudes().1),
        ] {
            assert!((left / right - 1.0).abs() < tolerance, "{name}: {left:e} {right:e}");
        }
    }
}

/// 1 − Δ and Δ are one number, each without the digits that it loses in the other; near full contact the separation is that of a narrow gap, whose elastic
/// closed form without flat pressure is x²/2 + x³/6 + … with x = cos²(a/2).
#[test]
fn separation_keeps_its_digits_near_full_contact() {
    let solid = material(1.3e6, 100.0, &[0.5, 0.01]);
    for half_width in [0.01, 0.7, 1.5, 2.9, 3.13] {
        let memory = ContactMemory::new(&solid, 2.0).unwrap();
        let contact = WaveContact { half_width, eccentricity: 0.1 * (PI - half_width).min(half_width) };
        let state = ContactState::new(&memory, contact, Prescribed::MeanPressure(0.3)).unwrap();
        assert!((state.mean_separation() + state.penetration() - 1.0).abs() < 1e-14);
        let again = ContactState::new(&memory, contact, Prescribed::MeanSeparation(state.mean_separation())).unwrap();
        assert!((again.mean_pressure() - 0.3).abs() < 1e-13, "{half_width}: {}", again.mean_pressure());
    }
    let elastic = ContactMemory::new(&PlaneMaterial::elastic(1.0).unwrap(), 1.0).unwrap();
    for gap in [1e-2_f64, 1e-4, 1e-6] {
        let contact = WaveContact { half_width: PI - gap, eccentricity: 0.0 };
        let s = (0.5 * contact.half_width).sin();
        let state = ContactState::new(&elastic, contact, Prescribed::MeanPressure(s * s)).unwrap();
        let x = (0.5 * contact.half_width).cos().powi(2);
        let expected = x * x / 2.0 + x.powi(3) / 6.0 + x.powi(4) / 12.0;
        assert!((state.mean_separation() / expected - 1.0).abs() < 1e-9, "{gap}: {:e} {expected:e}", state.mean_separation());
    }
}
