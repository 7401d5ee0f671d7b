//! Source: thesis Sec 5.4: Eqs 5.53, 5.58, 5.59, and the parameters printed under Fig 5.7b.
//!
//! Goal: each erratum is shown to be one: the printed form contradicts the thesis's own result, the mended form gives it.
//!
//! ```text
//!   printed  √(8/π)(x₀ − x)   K/√(2π)(x − a)         mended  √(8(x₀ − x)/π)   K/√(2π(x − a))
//! ```
//! Parameters: a glassy instant with K = 940 Pa√m, E∞ = 7.3 MPa; zones from 1e-9 to 1e-3 m; Fig 5.7b as printed (E0 = 650 MPa, E∞ = 10E0, τ = 1 ms,
//! h = 6.2 nm, Δγ = 0.03 J/m², ε = 0.36 nm, so σ_c = Δγ/ε).
//!
//! Oracle: (5.60), ½K²/E∞ for any zone length, by quadrature of the two fields; and arithmetic on the printed parameters.
//!
//! Tolerance: 1e-13 for quadrature.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::closure::{EdgeFields, process_zone_work};
use viscotack::crack::delayed::validity::growth_validity;
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, LoadSegment, Onset, Regime, Resolution, TipState, onset, regime, trajectory};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::elastic::PureShearStrip;
use viscotack::elastic::plane_modulus::PlaneState;
use viscotack::elastic::pure_shear_strip::SidewaysStrain;

const INTENSITY: f64 = 940.0;
const GLASSY: f64 = 7.3e6;

/// The two fields of the glassy instant, with either root as printed or over the distance.
struct Instant {
    tension_mended: bool,
    gap_mended: bool,
}

impl EdgeFields for Instant {
    fn tension(&self, d: f64) -> f64 {
        if self.tension_mended { INTENSITY / (2.0 * PI * d).sqrt() } else { INTENSITY / (2.0 * PI).sqrt() * d }
    }

    fn gap(&self, d: f64) -> f64 {
        let amplitude = INTENSITY / GLASSY;
        if self.gap_mended { amplitude * (8.0 * d / PI).sqrt() } else { amplitude * (8.0 / PI).sqrt() * d }
    }
}

/// The work over the zone in units of (5.60).
fn ratio(tension_mended: bool, gap_mended: bool, zone: f64) -> f64 {
    let work = process_zone_work(&Instant { tension_mended, gap_mended }, zone, 1e-14).unwrap();
    work.value / (0.5 * INTENSITY * INTENSITY / GLASSY)
}

#[test]
fn eq_5_53_and_5_58_the_root_covers_the_distance() {
    for zone in [1e-9, 1e-6, 1e-3] {
        assert!((ratio(true, true, zone) - 1.0).abs() < 1e-13);
    }
    // As printed, the work of (5.60) would depend on the length of the zone, and vanish with it.
    let printed = [1e-6, 1e-4].map(|zone| ratio(true, false, zone));
    println!("gap as printed: {printed:?}");
    assert!((printed[1] / printed[0] - 10.0).abs() < 1e-9 && printed[1] < 0.01);
}

#[test]
fn eq_5_59_the_root_covers_the_distance() {
    let printed = [1e-6, 1e-4].map(|zone| ratio(false, true, zone));
    println!("stress as printed: {printed:?}");
    // δ^{3/2} times the work that (5.60) states: there is no singularity at the tip at all.
    assert!((printed[1] / printed[0] - 1e3).abs() < 1e-6);
    // Both as printed: (2/π)∫₀¹ d(1 − d) dd = 1/(3π), times δ².
    let both = ratio(false, false, 1e-4) / 1e-8;
    assert!((both - 1.0 / (3.0 * PI)).abs() < 1e-12, "{both}");
}

#[test]
fn eq_5_64_as_printed_is_the_mended_form() {
    // (5.63, 5.64) print the root over the distance: with J(t) for 1/E∞ they give (5.65).
    assert!((ratio(true, true, 4.1e-7) - 1.0).abs() < 1e-13);
}

#[test]
fn fig_5_7b_parameters_break_the_assumptions_and_still_compute() {
    let (relaxed, half_height, work, range) = (650e6, 6.2e-9, 0.03, 0.36e-9);
    let cohesive = work / range;
    let material = PlaneMaterial::standard_solid(relaxed, 10.0 * relaxed, 1e-3).unwrap();
    let strip = PureShearStrip::new(half_height, SidewaysStrain::Free, PlaneState::Stress, 0.5).unwrap();
    let law = ProcessZone::Growing { cohesive_stress: cohesive, factor: 1.0 };
    let interface = Interface { work_of_adhesion: work, process_zone: law, body: CrackBody::AgainstRigid };
    for k in [1.01, 2.0, 5.0, 9.9] {
        // k = hσ²/(2ΔγE0), the axis of Fig 5.7a; delayed for 1 < k < 10.
        let stress = (2.0 * work * relaxed * k / half_height).sqrt();
        let intensity = strip.stress_intensity_factor(stress).unwrap();
        let problem = GrowthProblem::new(&material, interface, intensity).unwrap();
        let zone = problem.process_zone_at(intensity);
        assert!((zone / (0.8937e-9 * k) - 1.0).abs() < 1e-3, "δ = {zone:e} at k = {k}: 0.9k nm");
        let validity = growth_validity(zone, half_height, stress, Some(cohesive)).unwrap();
        println!("k = {k}: δ = {:.3} nm, {validity:?}", zone * 1e9);
        // δ/h = (σ∞/σ_c)²/2π in this strip: not small anywhere in the figure, and the remote stress exceeds the cohesive one.
        let other = validity.remote_to_cohesive_stress.unwrap().powi(2) / (2.0 * PI);
        assert!((validity.zone_to_half_height / other - 1.0).abs() < 1e-12);
        assert!(validity.zone_to_half_height > 0.14 && validity.remote_to_cohesive_stress.unwrap() > 0.95 && !validity.holds(0.1));
        // It computes all the same: a delay, and growth after it.
        assert_eq!(regime(&problem, intensity).unwrap().regime, Regime::Delayed);
        let Onset::After { delay, .. } = onset(&problem, intensity).unwrap() else { panic!() };
        let history = LoadHistory::of_strip_stress(&[LoadSegment::Step { load: stress }], &strip).unwrap();
        let found = trajectory(&problem, &history, &[delay.value + 2e-3], Resolution::default()).unwrap();
        assert_eq!(found.samples[0].state, TipState::Growing);
        assert!(found.samples[0].growth.unwrap().value > 0.0);
    }
    // A strip a thousand times as high under the same K meets the assumptions.
    assert!(growth_validity(0.9e-9, 1e4 * half_height, 0.01 * cohesive, Some(cohesive)).unwrap().holds(0.1));
}

#[test]
fn eq_5_68_regimes_with_the_inequality_that_decides() {
    let material = PlaneMaterial::standard_solid(650e6, 6.5e9, 1e-3).unwrap();
    let law = ProcessZone::Constant { length: 1e-9 };
    for body in [CrackBody::AgainstRigid, CrackBody::TwoHalves] {
        let interface = Interface { work_of_adhesion: 0.03, process_zone: law, body };
        let problem = GrowthProblem::new(&material, interface, 0.0).unwrap();
        for (factor, of_glassy, expected) in [
            (0.999_999, false, Regime::NoGrowth),
            (1.000_001, false, Regime::Delayed),
            (0.999_999, true, Regime::Delayed),
            (1.000_001, true, Regime::Immediate),
            (0.0, true, Regime::NoGrowth),
        ] {
            let limit = if of_glassy { problem.glassy_limit() } else { problem.relaxed_limit() };
            let report = regime(&problem, factor * limit).unwrap();
            let (words, left, right) = report.decision();
            assert_eq!(report.regime, expected, "{words}");
            match words {
                words if words.contains("<=") => assert!(left <= right),
                words if words.contains(">=") => assert!(left >= right),
                _ => assert!(left < right && report.relaxed_release > right),
            }
        }
        let ratio = (problem.glassy_limit() / problem.relaxed_limit()).powi(2);
        assert!((ratio / 10.0 - 1.0).abs() < 1e-14);
        assert!(regime(&problem, f64::NAN).is_err() && regime(&problem, -1.0).is_err());
    }
}

#[test]
fn elastic_and_viscous_materials_have_their_own_onset() {
    let law = ProcessZone::Constant { length: 1e-6 };
    let interface = Interface { work_of_adhesion: 0.3, process_zone: law, body: CrackBody::AgainstRigid };
    let elastic = PlaneMaterial::elastic(2.1e6).unwrap();
    let problem = GrowthProblem::new(&elastic, interface, 0.0).unwrap();
    assert_eq!(onset(&problem, 0.99 * problem.glassy_limit()).unwrap(), Onset::Never);
    assert_eq!(onset(&problem, 1.01 * problem.glassy_limit()).unwrap(), Onset::AtOnce);
    let history = LoadHistory::from_segments(&[LoadSegment::Ramp { duration: 2.0, load: 1.3 * problem.glassy_limit() }]).unwrap();
    let found = trajectory(&problem, &history, &[1.0, 2.0], Resolution::default()).unwrap();
    assert_eq!(found.samples[0].state, TipState::Resting);
    assert_eq!(found.samples[1].state, TipState::Unbounded);
    // A Maxwell solid under any load starts some time: J(t) = 1/E∞ + t/η.
    let viscous = PlaneMaterial::from_creep(2.1e6, &[], Some(4.3e5)).unwrap();
    let problem = GrowthProblem::new(&viscous, interface, 0.0).unwrap();
    for part in [1e-6, 0.1, 0.9] {
        let load = part * problem.glassy_limit();
        let Onset::After { delay, initial_speed, .. } = onset(&problem, load).unwrap() else { panic!() };
        let exact = 4.3e5 / 2.1e6 * (1.0 / (part * part) - 1.0);
        assert!((delay.value / exact - 1.0).abs() < 1e-13 && (initial_speed.value * delay.value / 1e-6 - 1.0).abs() < 1e-13);
        let found =
            trajectory(&problem, &LoadHistory::constant(load).unwrap(), &[0.5 * exact, 3.0 * exact], Resolution::default()).unwrap();
        assert_eq!(found.samples[0].state, TipState::Resting);
        assert!(found.samples[1].growth.unwrap().value > 1e-6);
    }
}
