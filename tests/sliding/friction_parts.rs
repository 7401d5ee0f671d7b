//! Source: thesis Sec 3.6 (Eqs 3.37–3.40), Sec 3.7 and Fig 3.14c; issue "Sliding branches", part 3.
//!
//! Goal: where the power of friction goes, and the elastic reference contact of modulus |E(kv)|.
//!
//! ```text
//! friction·v·λ = dissipation of the solid + (K₁² − K₂²)/2E∞* · v        tips as sharp as the model has them, per width and wavelength
//!              = (G₁ − G₂) v  +  the rest                               the split of (3.40): edges and bulk
//! dissipation  = 2 Σ_m Im Ĉ_m |p_m|²                                    harmonic by harmonic, p_m of the pressure, Ĉ_m the compliance at the rate mkv
//! ```
//! Parameters: one and three times, slow, middle and fast; even and uneven works; a load, a pull.
//!
//! Oracle: Fourier's coefficients of the pressure by quadrature and the complex compliance of the material, harmonic by harmonic (no edge, no energy release, no
//! eccentricity enters); Johnson's wave in closed form, as δ → 0, at the modulus formed from the complex modulus by hand.
//!
//! Tolerance: 1e-5 of the friction: 3000 harmonics, the mean of the rest by its asymptote, which begins at those of the thinnest layer at an edge (1e-3); 1e-8 for the
//! limit of three process zones.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::elastic::{Control, JohnsonWave, WestergaardWave};
use viscotack::material::CreepTerm;
use viscotack::sliding::branch::BranchProblem;
use viscotack::sliding::elastic_reference::{elastic_reference_contact, elastic_reference_strength};
use viscotack::sliding::steady::{Indenter, PartialContact, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

const RELAXED: f64 = 0.7e6;
const HARMONICS: u32 = 3000;

fn solid(beta: f64, shares: &[(f64, f64)]) -> PlaneMaterial {
    let gained = (1.0 - 1.0 / beta) / RELAXED;
    let terms: Vec<CreepTerm> =
        shares.iter().map(|&(share, time)| CreepTerm { compliance: gained * share, retardation_time: time }).collect();
    PlaneMaterial::from_creep(RELAXED * beta, &terms, None).unwrap()
}

fn solved(material: &PlaneMaterial, rate: f64, adhesion: WaveAdhesion, pressure: f64) -> (PartialContact, SlidingProblem<'static>) {
    let problem = SlidingProblem {
        rate,
        indenter: Indenter::Wave,
        adhesion: Some(adhesion),
        work_by_speed: None,
        control: SlidingControl::MeanPressure(pressure),
        accuracy: 1e-11,
    };
    match steady_sliding(material, &problem).unwrap() {
        SlidingOutcome::Partial(contact) => (*contact, problem),
        SlidingOutcome::Full(_) => panic!("full contact"),
    }
}

/// 2 Σ Im Ĉ_m |p_m|² from the pressure alone, with the mean of the harmonics that are left out.
fn dissipation(material: &PlaneMaterial, rate: f64, contact: &PartialContact) -> f64 {
    let a = contact.state.contact().half_width;
    let nodes = 2 * HARMONICS + 600;
    // y = −a cos φ takes the root singularities away; then the midpoint rule is exact but for exponentially little.
    let samples: Vec<(f64, f64)> = (0..nodes)
        .map(|index| {
            let angle = PI * (f64::from(index) + 0.5) / f64::from(nodes);
            let (half, other) = ((0.5 * angle).sin().powi(2), (0.5 * angle).cos().powi(2));
            let point = if half < 0.5 {
                contact.state.inside_trailing(2.0 * a * half).unwrap()
            } else {
                contact.state.inside_leading(2.0 * a * other).unwrap()
            };
            (-a * angle.cos(), contact.state.pressure(point) * a * angle.sin() * PI / f64::from(nodes))
        })
        .collect();
    let lossy = |harmonic: u32| -> f64 {
        material
            .creep_terms()
            .iter()
            .map(|term| {
                let x = f64::from(harmonic) * rate * term.retardation_time;
                RELAXED * term.compliance * x / (1.0 + x * x)
            })
            .sum()
    };
    let mut sum = 0.0;
    for harmonic in 1..=HARMONICS {
        let (mut real, mut imaginary) = (0.0, 0.0);
        for &(place, weight) in &samples {
            let (sine, cosine) = (f64::from(harmonic) * place).sin_cos();
            real += weight * cosine;
            imaginary -= weight * sine;
        }
        sum += 2.0 * lossy(harmonic) * (real * real + imaginary * imaginary) / (4.0 * PI * PI);
    }
    // |p_m|² ≈ (k₁² + k₂²)/(8π sin a m) on the mean, and Im Ĉ_m ≈ Σ j/(ζm).
    let (behind, ahead) = contact.state.edge_amplitudes();
    let mean = (behind * behind + ahead * ahead) / (8.0 * PI * a.sin());
    sum + 2.0 * lossy(HARMONICS) * mean * f64::from(HARMONICS) / (f64::from(HARMONICS) + 0.5)
}

const ONE: [(f64, f64); 1] = [(1.0, 1.0)];
const THREE: [(f64, f64); 3] = [(0.5, 3.0), (0.3, 0.4), (0.2, 0.05)];

#[test]
fn the_power_of_friction_is_dissipated_or_goes_into_the_tips() {
    let even = WaveAdhesion { trailing_zone: 4e-3, ..WaveAdhesion::even(0.004, 8e-3) };
    let uneven = WaveAdhesion { leading_work: 0.001, ..even };
    for (name, material, beta, rate, adhesion, pressure) in [
        ("slow", solid(10.0, &ONE), 10.0, 0.1, even, 0.1),
        ("middle", solid(10.0, &ONE), 10.0, 0.6, even, 0.1),
        ("fast", solid(10.0, &ONE), 10.0, 8.0, even, 0.3),
        ("pull", solid(10.0, &ONE), 10.0, 0.2, even, -0.02),
        ("three times", solid(30.0, &THREE), 30.0, 0.8, even, 0.2),
        ("two works", solid(10.0, &ONE), 10.0, 0.3, uneven, 0.1),
        ("two works, three times", solid(30.0, &THREE), 30.0, 2.0, uneven, 0.3),
    ] {
        let (contact, _) = solved(&material, rate, adhesion, pressure);
        let values = &contact.values;
        let (behind, ahead) = contact.state.edge_amplitudes();
        let tips = (behind * behind - ahead * ahead) / (8.0 * beta * values.half_width.value.sin());
        let lost = dissipation(&material, rate, &contact);
        let (friction, edges) = (values.friction_stress.value, values.adhesion.unwrap().adhesive_friction_stress.value);
        println!(
            "{name}: friction {friction:.6e} = dissipated {lost:.6e} + tips {tips:.6e}, off by {:.0e}; edges {edges:.3e}, share {:.3}",
            friction - lost - tips,
            edges / friction
        );
        assert!((friction - lost - tips).abs() < 1e-5 * friction, "{name}");
        assert!(lost > 0.0);
        // (3.40) is the difference of what is stored when each edge moves, each in units of its own work.
        let adhesive = values.adhesion.unwrap();
        let parts = adhesion.trailing_work * adhesive.trailing_release.value - adhesion.leading_work * adhesive.leading_release.value;
        assert!((edges - parts).abs() < 1e-12);
    }
}

#[test]
fn edges_govern_slow_friction_and_the_bulk_governs_fast() {
    // Small-scale dissipation: zone ≪ 1, speeds where the edges feel it and the contact does not (thesis: μ ≈ μ_a).
    let material = solid(10.0, &ONE);
    let share = |rate: f64, zone: f64| {
        let (contact, _) = solved(&material, rate, WaveAdhesion::even(0.005, zone), 0.02);
        contact.values.adhesion.unwrap().adhesive_friction_stress.value / contact.values.friction_stress.value
    };
    let shares = [1e-2, 3e-3, 1e-3].map(|zone| share(zone, zone));
    println!("shares at kvτ = kδ: {shares:?}");
    assert!(shares[2] > 0.99 && (1.0 - shares[2]).abs() < (1.0 - shares[1]).abs() && (1.0 - shares[1]).abs() < (1.0 - shares[0]).abs());
    assert!(share(3.0, 1e-3) < 0.1);
}

/// Johnson's pull-off and snap-in of a modulus m at Γ: in units of m at Γ/m, times m.
fn johnson(modulus: f64, work: f64) -> [f64; 2] {
    let wave = JohnsonWave::new(WestergaardWave::new(1.0, 2.0 * PI, 1.0).unwrap(), PI * work / modulus).unwrap();
    let pull_off = wave.pull_off(Control::Load).unwrap().mean_pressure;
    let snap_in = wave.snap_in().unwrap().mean_pressure;
    [2.0 * modulus * pull_off, 2.0 * modulus * snap_in]
}

#[test]
fn the_reference_contact_carries_what_johnsons_wave_of_its_modulus_does() {
    let material = solid(10.0, &ONE);
    for (rate, work) in [(0.0, 0.005), (0.3, 0.005), (2.0, 0.0025), (50.0, 0.005)] {
        // E(ω)/E0 = β(1 + iωρ)... of one retardation time: (1 + iζ)/(1 + iζ/β), ζ = kvτ.
        let (zeta, beta) = (rate, 10.0_f64);
        let modulus = ((1.0 + zeta * zeta) / (1.0 + (zeta / beta).powi(2))).sqrt();
        let of_zone = |zone: f64| {
            let reference =
                elastic_reference_strength(&material, &BranchProblem::loads(rate, WaveAdhesion::even(work, zone), 1e-10)).unwrap();
            assert!((reference.modulus.value - modulus).abs() <= reference.modulus.error + 1e-14 * modulus);
            let pressure = |fold: &Option<viscotack::sliding::branch::Fold>| fold.as_ref().unwrap().value.value * reference.modulus.value;
            [pressure(&reference.found.pull_off), pressure(&reference.found.snap_in)]
        };
        let [coarse, middle, fine] = [4e-4, 2e-4, 1e-4].map(of_zone);
        for (index, expected) in johnson(modulus, work).into_iter().enumerate() {
            let (first, second) = (2.0 * middle[index] - coarse[index], 2.0 * fine[index] - middle[index]);
            let found = (4.0 * second - first) / 3.0;
            println!("kvτ = {rate}: {found} against {expected}");
            assert!((found - expected).abs() < 1e-7 * expected.abs(), "{rate} {found} {expected}");
        }
    }
}

#[test]
fn the_reference_of_a_contact_is_the_same_contact_of_a_stiffer_elastic_solid() {
    let material = solid(30.0, &THREE);
    for control in [SlidingControl::MeanPressure(0.15), SlidingControl::Penetration(0.3), SlidingControl::HalfWidth(0.8)] {
        let (_, base) = solved(&material, 0.5, WaveAdhesion { leading_work: 0.002, ..WaveAdhesion::even(0.004, 5e-3) }, 0.15);
        let problem = SlidingProblem { control, ..base };
        let reference = elastic_reference_contact(&material, &problem).unwrap();
        let SlidingOutcome::Partial(elastic) = reference.found else { panic!("full contact") };
        let modulus = reference.modulus.value;
        // The same in pascals: a glassy modulus of m E0, far above all times, must be the same contact.
        let stiff = PlaneMaterial::standard_solid(1.0, modulus, 1.0).unwrap();
        let SlidingOutcome::Partial(glassy) = steady_sliding(&stiff, &SlidingProblem { rate: 1e13, ..problem }).unwrap() else {
            panic!("full contact")
        };
        for (one, two, unit) in [
            (elastic.values.half_width, glassy.values.half_width, 1.0),
            (elastic.values.eccentricity, glassy.values.eccentricity, 1.0),
            (elastic.values.penetration, glassy.values.penetration, 1.0),
            (elastic.values.mean_pressure, glassy.values.mean_pressure, modulus),
        ] {
            assert!((one.value * unit - two.value).abs() < 1e-8 * (1.0 + two.value.abs()), "{control:?}: {one:?} {two:?}");
        }
    }
    let cylinder = SlidingProblem { indenter: Indenter::Parabola, ..solved(&material, 0.5, WaveAdhesion::even(0.004, 5e-3), 0.15).1 };
    assert!(elastic_reference_contact(&material, &cylinder).unwrap_err().to_string().contains("wave number"));
}
