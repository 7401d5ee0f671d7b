//! Source: thesis Secs 3.2–3.5; Johnson (1995) for the elastic wave; chapter 5 for edges seen from near.
//!
//! Goal: the equilibrium of both edges meets the elastic closed form as δ → 0 with an error of first order, and each edge of a slow contact
//! is a steady crack: G₁ opens and G₂ closes as the crack theory of this crate says for the same process zone and speed.
//!
//! Parameters: β from 1 to 100, Γ = 0.005, zones from 1e-3 to 1e-5 of 1/k.
//!
//! Oracle: `JohnsonWave` (closed form, its own tests); `VirtualWork` (checked against raw double integrals), another reduction of another
//! problem: a contact sees its edge as a crack only from a distance much smaller than its width, so agreement is to O(√(δ + ζ)).
//!
//! Tolerance: elastic, the ratio of the errors at δ and δ/10 is 10 to within 10 %; slow edges, 2 % at ζ, δ about 1e-4.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::sliding::{contact_at_rate, contact_near};
use viscotack::PlaneMaterial;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, at_speed};
use viscotack::elastic::johnson_wave::WaveBranch;
use viscotack::elastic::{JohnsonWave, WestergaardWave};
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::steady::WaveAdhesion;

const REDUCED_WORK: f64 = 0.005;

fn adhesion(zone: f64) -> WaveAdhesion {
    WaveAdhesion::even(REDUCED_WORK, zone)
}

/// Half-width of Johnson's wave at a reduced mean pressure, for modulus `modulus`·E0.
fn johnson(modulus: f64, mean_pressure: f64) -> f64 {
    // E* = modulus, k = 1, Λ = 1: pressures in kΛ/2 of E0 = 1, Δγ = πΓ.
    let wave = WestergaardWave::new(modulus, 2.0 * PI, 1.0).unwrap();
    let adhesive = JohnsonWave::new(wave, PI * REDUCED_WORK).unwrap();
    adhesive.state_by_mean_pressure(0.5 * mean_pressure, WaveBranch::Stable).unwrap().contact_half_width
}

#[test]
fn elastic_contact_meets_johnsons_wave_at_first_order_in_the_process_zone() {
    let material = PlaneMaterial::elastic(0.7e6).unwrap();
    let memory = ContactMemory::new(&material, 1.0).unwrap();
    for mean_pressure in [-0.02, 0.0, 0.05] {
        let exact = johnson(1.0, mean_pressure);
        let errors: Vec<f64> = [1e-3, 1e-4, 1e-5]
            .into_iter()
            .map(|zone| {
                let start = WaveContact { half_width: exact, eccentricity: 0.0 };
                let found = contact_near(&memory, Some(adhesion(zone)), Prescribed::MeanPressure(mean_pressure), start, 1e-13).unwrap();
                assert!(found.state.contact().eccentricity.abs() < 1e-12);
                found.state.contact().half_width - exact
            })
            .collect();
        println!(
            "p = {mean_pressure}: a(δ) − a(0) over δ: {:?}",
            errors.iter().zip([1e-3, 1e-4, 1e-5]).map(|(e, d)| e / d).collect::<Vec<_>>()
        );
        for pair in errors.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!((ratio - 10.0).abs() < 1.0, "p = {mean_pressure}: errors {errors:?}");
        }
    }
}

/// ζ → 0 with E0 and ζ → ∞ with E∞: the contact of the program at both ends of the speed range, as δ → 0. Tolerance: errors fall tenfold with δ to 10 %;
/// ζ and 1/ζ are 1e-6 δ and below, so that the memory adds less than that.
#[test]
fn both_limits_of_the_speed_are_johnsons_waves_at_first_order_in_the_process_zone() {
    for (beta, terms) in [(20.0, 1), (8.0, 6)] {
        let relaxed = 0.7e6;
        let terms: Vec<CreepTerm> = (0..terms)
            .map(|index| CreepTerm {
                compliance: (1.0 - 1.0 / beta) / relaxed / f64::from(terms),
                retardation_time: 0.4 * 0.3_f64.powi(index),
            })
            .collect();
        let material = PlaneMaterial::from_creep(relaxed * beta, &terms, None).unwrap();
        for mean_pressure in [-0.02, 0.05] {
            for (name, modulus, rate) in [("slow", 1.0, 1e-12), ("fast", beta, 1e12)] {
                let exact = johnson(modulus, mean_pressure);
                let errors: Vec<f64> = [1e-3, 1e-4, 1e-5]
                    .into_iter()
                    .map(|zone| {
                        let found =
                            contact_at_rate(&material, rate, Some(adhesion(zone)), Prescribed::MeanPressure(mean_pressure), 1e-10).unwrap();
                        assert!((found.trailing_release - 1.0).abs() < 1e-5 && (found.leading_release - 1.0).abs() < 1e-5);
                        found.state.contact().half_width - exact
                    })
                    .collect();
                println!("β = {beta}, {name}, p = {mean_pressure}: a(δ) − a(0) = {errors:?}");
                for pair in errors.windows(2) {
                    let ratio = pair[0] / pair[1];
                    assert!((ratio - 10.0).abs() < 1.0, "{name}, p = {mean_pressure}: errors {errors:?}");
                }
            }
        }
    }
}

#[test]
fn edges_of_a_slow_contact_are_steady_cracks() {
    for (beta, ratio, zone) in [(10.0, 1e-4, 1e-4), (10.0, 3e-5, 1e-4), (100.0, 1e-4, 2e-5)] {
        let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * beta, 0.2).unwrap();
        let memory = ContactMemory::new(&material, ratio / 0.2).unwrap();
        let mean_pressure = 0.02;
        let start = WaveContact { half_width: johnson(1.0, mean_pressure), eccentricity: 0.0 };
        let found = contact_near(&memory, Some(adhesion(zone)), Prescribed::MeanPressure(mean_pressure), start, 1e-11).unwrap();
        let interface =
            Interface { work_of_adhesion: 1.0, process_zone: ProcessZone::Constant { length: zone }, body: CrackBody::AgainstRigid };
        let crack = |motion| {
            let curve = VirtualWork::new(&material, motion, interface).unwrap();
            at_speed(&curve, ratio / 0.2, 1e-14).unwrap().energy_release_rate_ratio.unwrap().value
        };
        let (opening, closing) = (crack(Motion::Opening), crack(Motion::Closing));
        println!(
            "β = {beta}, ζ = {ratio:e}, δ = {zone:e}: G₁ {:.5} (crack {opening:.5}), G₂ {:.5} (crack {closing:.5}), e = {:.3e}, {} evaluations",
            found.trailing_release,
            found.leading_release,
            found.state.contact().eccentricity,
            found.steps
        );
        assert!((found.trailing_release / opening - 1.0).abs() < 0.02, "opening {} {opening}", found.trailing_release);
        assert!((found.leading_release / closing - 1.0).abs() < 0.02, "closing {} {closing}", found.leading_release);
    }
}
