//! Stability, every state of one input, and the fold of a pulled contact (`viscotack::finite_range::line`).
//!
//! Source: issue 41; method note "finite range", section c.
//!
//! Goal: a state says rightly whether it stays under a held pressure or gap; several states at one input are all listed; a pull-off is the reference's.
//!
//! Oracle: a branch through its folds: between folds the sign of d(mean pressure)/d(mean gap) is that of its points, and stability under a held
//! gap changes at the folds of the gap alone. Of five states at one gap: dense Newton steps on one grid of 1024 nodes and the growth rates of the
//! linearised evolution of the material's retarded strains (dense eigenvalues), by a program that shares no code with this crate.
//!
//! Tolerance: signs; numbers of the other program's one grid 2 %, of the state without contact 1e-6.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, missing_docs)]

use crate::line::{Dice, assert_within, material, reference, usual};
use std::f64::consts::TAU;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::line::{
    Branch, Control, Direction, FoldKind, Harmonic, Problem, Profile, Request, every, full_contact, pull_off, solve, trace_refined,
};
use viscotack::sliding::branch::Stability;
use viscotack::sliding::layer::{Backing, Layer};

/// The points of a branch whose stability agrees with the slope between the points around it, where they lie clear of folds.
fn compared(what: &str, branch: &Branch) -> usize {
    let gaps: Vec<f64> = branch.points.iter().map(|point| point.mean_gap).collect();
    let pressures: Vec<f64> = branch.points.iter().map(|point| point.mean_pressure).collect();
    let steady = |values: &[f64], i: usize| (values[i] - values[i - 1]) * (values[i + 1] - values[i]) > 0.0;
    let mut compared = 0;
    for i in 1..branch.points.len().saturating_sub(1) {
        let Some(point) = &branch.refined[i] else { continue };
        if !steady(&gaps, i) || !steady(&pressures, i) {
            continue;
        }
        let slope = (pressures[i + 1] - pressures[i - 1]) / (gaps[i + 1] - gaps[i - 1]);
        // Folds of the gap on the way from the start, which is stable.
        let of_gap = |kind| matches!(kind, FoldKind::LargestGap | FoldKind::LeastGap);
        let turns = gaps[..=i].windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0).count();
        assert!(turns <= branch.folds.iter().filter(|fold| of_gap(fold.kind)).count(), "{what}: a turn of the gap without a fold");
        let (by_pressure, by_gap) = (point.stability.under_mean_pressure(), point.stability.under_mean_gap());
        if turns == 0 {
            assert_ne!(by_gap, Stability::Unstable, "{what}, point {i}: gap {}, pressure {}", gaps[i], pressures[i]);
        } else if turns == 1 {
            assert_ne!(by_gap, Stability::Stable, "{what}, point {i}: gap {}, pressure {}", gaps[i], pressures[i]);
        }
        let wanted = if turns == 0 && slope < 0.0 { Stability::Stable } else { Stability::Unstable };
        if turns < 2 && by_pressure != Stability::Marginal && by_gap != Stability::Marginal {
            assert_eq!(by_pressure, wanted, "{what}, point {i}: slope {slope}, gap {}, pressure {}", gaps[i], pressures[i]);
            // A stiff frame is a held gap, a soft one a held pressure.
            assert_eq!(point.stability.in_frame(1e9), by_gap, "{what}, point {i}");
            assert_eq!(point.stability.in_frame(1e-9), by_pressure, "{what}, point {i}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn stability_changes_at_the_folds_of_a_branch() {
    let mut unstable = 0;
    for speed in [0.03, 0.3, 1.0] {
        let problem = usual(speed, 0.008, 0.05, Control::MeanPressure(0.1));
        let branch = trace_refined(&problem, 512, Direction::Unloading, 60).unwrap();
        assert!(compared(&format!("speed {speed}"), &branch) >= 6, "{speed}");
        let lost = |refined: &viscotack::finite_range::line::Refined| refined.stability.under_mean_pressure() == Stability::Unstable;
        unstable += branch.refined.iter().flatten().filter(|refined| lost(refined)).count();
    }
    assert!(unstable >= 3, "only {unstable} states beyond a fold");
}

#[test]
fn stability_of_random_branches_is_that_of_their_slopes() {
    let (mut dice, mut points, mut branches) = (Dice(20_261_127), 0, 0);
    while branches < 8 {
        let (beta, speed) = (dice.between(2.0, 100.0), dice.between(0.01, 30.0));
        let attraction = Attraction::new(Law::Exponential, TAU * dice.between(0.003, 0.02), dice.between(0.06, 0.2)).unwrap();
        let backing = if dice.unit() < 0.5 { Backing::Free } else { Backing::Confined };
        let layer = (dice.unit() < 0.5).then(|| Layer::new(backing, 0.5, dice.between(0.7, 10.0)).unwrap());
        let waves = [1, 2, 3].map(|number| Harmonic { number, amplitude: dice.unit() / f64::from(number), phase: TAU * dice.unit() });
        let profile = Profile::harmonics(&waves).unwrap();
        let modulus = material(beta, &[1.0 - 1.0 / beta], &[1.0]);
        let problem = Problem { profile, modulus, speed, attraction, layer, control: Control::MeanPressure(0.1) };
        let what = format!("beta {beta}, speed {speed}, {:?}, {layer:?}, {waves:?}", problem.attraction);
        if let Ok(branch) = trace_refined(&problem, 256, Direction::Unloading, 40) {
            points += compared(&what, &branch);
            branches += 1;
        }
    }
    assert!(points >= 100, "{points} points");
}

/// A thin free layer is so soft that five states exist at one gap.
fn five_states() -> Problem {
    let waves = [
        Harmonic { number: 1, amplitude: 0.093_323_322_592_581_14, phase: 2.473_687_689_760_581 },
        Harmonic { number: 2, amplitude: 0.440_918_870_763_903_9, phase: 5.805_302_588_737_629_5 },
        Harmonic { number: 5, amplitude: 0.143_424_372_427_617_63, phase: 1.090_110_371_606_592_7 },
    ];
    Problem {
        profile: Profile::harmonics(&waves).unwrap(),
        modulus: material(124.171_232_400_418_45, &[0.787_009_040_773_252_8, 0.204_937_564_083_053_47], &[1.0, 0.123_949_530_815_869_27]),
        speed: 0.179_942_557_117_674_82,
        attraction: Attraction::new(Law::Exponential, 0.050_800_680_541_172_05, 0.036_216_907_257_414_12).unwrap(),
        layer: Some(Layer::new(Backing::Free, 0.5, 0.522_359_496_628_065_5).unwrap()),
        control: Control::MeanGap(1.077_069_598_198_028),
    }
}

#[test]
fn five_states_at_one_gap_are_found_and_the_first_one_is_stable() {
    let request = Request { accuracy: 1e-3, ..Request::default() };
    let all = every(&five_states(), &request).unwrap();
    // Friction and mean pressure, relative tolerance, whether it stays under the gap.
    let other_program = [
        (0.059_169_6, -0.045_410, 2e-2, Stability::Stable),
        (0.048_403_5, -0.029_891, 2e-2, Stability::Stable),
        (0.000_978_148_394, -0.006_412, 1e-3, Stability::Unstable),
        (4.166_8e-12, -4.21e-7, 1e-2, Stability::Stable),
    ];
    for (friction, pressure, tolerance, stability) in other_program {
        let near = |a: f64, b: f64| (a - b).abs() <= tolerance * b.abs();
        let found = all.iter().find(|state| near(state.numbers.friction_stress, friction) && near(state.numbers.mean_pressure, pressure));
        let found =
            found.unwrap_or_else(|| panic!("no state of friction {friction}: {:?}", all.iter().map(|s| s.numbers).collect::<Vec<_>>()));
        assert_eq!(found.stability(&five_states()).under_mean_gap(), stability, "friction {friction}");
    }
    let first = solve(&five_states(), &request).unwrap();
    assert_eq!(first.numbers, all[0].numbers);
    assert_eq!(first.stability(&five_states()).under_mean_gap(), Stability::Stable);
}

#[test]
fn full_contact_beside_a_partial_one_is_listed_and_stays() {
    let problem = usual(0.05, 0.006, 0.04, Control::MeanPressure(0.12));
    let all = every(&problem, &Request::default()).unwrap();
    assert_eq!(all.len(), 2);
    let full = full_contact(&problem, &Request::default()).unwrap();
    assert_eq!(all[1].numbers, full.numbers);
    assert!(all.iter().all(|state| state.stability(&problem).under_mean_pressure() == Stability::Stable));
}

#[test]
fn a_pull_off_is_the_fold_of_the_reference() {
    let want = &reference()["folds"][0];
    // From a load that no state carries, as from any other.
    let fold = pull_off(&usual(0.05, 0.006, 0.04, Control::MeanPressure(-0.5)), &Request::default()).unwrap();
    assert_eq!(fold.kind, FoldKind::LeastPressure);
    assert_within("pressure", fold.numbers.mean_pressure, want["mean_pressure"].as_f64().unwrap(), 4e-6 + fold.errors.mean_pressure);
    assert_within("gap", fold.numbers.mean_gap, want["mean_gap"].as_f64().unwrap(), 1e-3 + fold.errors.mean_gap);
    assert!(fold.errors.mean_pressure < 2e-5, "{:?}", fold.errors);
    // Just above it there is a stable state, just below none.
    let at = |load: f64| solve(&usual(0.05, 0.006, 0.04, Control::MeanPressure(load)), &Request::default());
    let above = at(fold.numbers.mean_pressure + 1e-3).unwrap();
    assert_eq!(above.stability(&usual(0.05, 0.006, 0.04, Control::MeanPressure(0.0))).under_mean_pressure(), Stability::Stable);
    assert!(at(fold.numbers.mean_pressure - 1e-3).is_err());
}
