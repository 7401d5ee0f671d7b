//! Source: this crate's claim that every number carries an honest error bound; `studies::calibration`.
//!
//! Goal: the study sees dishonest bounds: one that is too short, one that is a thousand times too wide, an answer that is lost; and it passes over honest ones.
//!
//! Parameters: forty steady contacts, a hundred steady cracks and eight spheres of the study's own scenes, the one crack under a history whose bound was missed, and one
//! strength.
//!
//! Oracle: falsification: bounds divided by a thousand, values moved by two bounds, bounds times a thousand.
//!
//! Tolerance: the promises of the study: no miss, median at most 10, 95th percentile at most 100.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use viscotack::Estimate;
use viscotack_verification::studies::calibration::tally::{Assessed, Compared, Tally, Truth};
use viscotack_verification::studies::calibration::{crack, delayed, sliding, sphere, strength};

fn scenes() -> Vec<Assessed> {
    let contacts = (0..40_u64).into_par_iter().map(sliding::assessed);
    let cracks = (0..100_u64).into_par_iter().map(crack::assessed);
    contacts.chain(cracks).collect()
}

fn with_bounds(assessed: &[Assessed], change: impl Fn(&Compared) -> Estimate) -> Vec<Assessed> {
    let changed = |one: &Compared| Compared { found: change(one), ..*one };
    assessed.iter().map(|scene| Assessed { compared: scene.compared.iter().map(changed).collect(), ..scene.clone() }).collect()
}

#[test]
fn true_bounds_pass_and_falsified_ones_do_not() {
    let assessed = scenes();
    let tally = Tally::of(&assessed);
    println!("{} values, widths {:?} {:?} of {}", tally.values, tally.width(0.5), tally.width(0.95), tally.widths.len());
    assert!(tally.misses.is_empty() && tally.troubles.is_empty(), "{:?} {:?}", tally.misses, tally.troubles);
    assert!(tally.values > 300 && 20 * tally.by_another_route >= tally.scenes);

    let short = Tally::of(&with_bounds(&assessed, |one| Estimate::new(one.found.value, 1e-3 * one.found.error)));
    assert!(short.misses.len() * 20 > tally.values, "bounds a thousandth as long miss in {} of {}", short.misses.len(), tally.values);
    let moved = Tally::of(&with_bounds(&assessed, |one| Estimate::new(one.found.value + 3.0 * one.found.error, one.found.error)));
    assert!(moved.misses.len() * 4 > tally.values, "values moved by three bounds miss in {} of {}", moved.misses.len(), tally.values);
    let wide = Tally::of(&with_bounds(&assessed, |one| Estimate::new(one.found.value, 1e3 * one.found.error)));
    assert!(wide.width(0.5).unwrap() > 10.0 * tally.width(0.5).unwrap(), "{:?} {:?}", wide.width(0.5), tally.width(0.5));
}

/// A speed near the end of a step from a line that all four runs have in common: all of them err by the same, so that nothing between them tells (1e-11 of it, 2.4 times
/// both bounds before the parabola of the step was in the bound).
#[test]
fn a_step_that_all_runs_share_is_in_the_bar() {
    let assessed = delayed::assessed(2880);
    assert!(assessed.trouble.is_none() && assessed.compared.len() == 2, "{assessed:?}");
    assert!(assessed.compared.iter().all(|one| !one.is_missed()), "{:?}", assessed.compared);
}

/// Lobatto's rules of three and four nodes agree on this toughness by accident: their difference is 0.37 of the error of the first.
#[test]
fn rules_that_agree_by_accident_are_in_the_bar() {
    let assessed = strength::assessed(11);
    assert!(assessed.trouble.is_none() && assessed.compared.iter().any(|one| one.quantity == "toughness"), "{assessed:?}");
    assert!(assessed.compared.iter().all(|one| !one.is_missed()), "{:?}", assessed.compared);
}

#[test]
fn what_is_no_number_is_missed() {
    let one = |found: Estimate, truth: Estimate| Compared { quantity: "x", found, truth, scale: 1.0, floor: 0.0 };
    assert!(one(Estimate::new(f64::NAN, 1.0), Estimate::exact(1.0)).is_missed());
    assert!(one(Estimate::new(1.0, f64::NAN), Estimate::exact(1.0)).is_missed());
    assert!(!one(Estimate::new(1.0, 0.1), Estimate::new(1.15, 0.06)).is_missed());
    assert!(one(Estimate::new(1.0, 0.1), Estimate::new(1.17, 0.06)).is_missed());
    // A bound above rounding over an error that is known: 0.1/0.02.
    assert!((one(Estimate::new(1.0, 0.1), Estimate::exact(1.02)).width().unwrap() - 5.0).abs() < 1e-9);
    // Not known where the truth is hardly better, or the bound is rounding.
    assert!(one(Estimate::new(1.0, 0.1), Estimate::new(1.02, 0.05)).width().is_none());
    assert!(one(Estimate::new(1.0, 1e-15), Estimate::exact(1.0)).width().is_none());
    // A scene without an answer counts as lost, not as honest.
    let lost = Assessed {
        scene: 0,
        accuracy: 1e-3,
        described: String::new(),
        compared: Vec::new(),
        truth: Truth::Tighter,
        trouble: Some("no".into()),
    };
    assert_eq!(Tally::of(&[lost]).troubles.len(), 1);
}

/// Nearly all bounds of spheres are below a thousandth of the accuracy: the truth is known well enough to see that these are too short.
#[test]
fn bounds_of_spheres_a_tenth_as_long_are_seen() {
    let assessed: Vec<Assessed> = (31..39_u64).into_par_iter().map(sphere::assessed).collect();
    let tally = Tally::of(&assessed);
    assert!(tally.misses.is_empty() && tally.troubles.is_empty(), "{:?} {:?}", tally.misses, tally.troubles);
    assert!(tally.width(0.5).unwrap() < 10.0 && tally.width(0.95).unwrap() < 100.0 && 2 * tally.widths.len() > tally.values);
    let short = Tally::of(&with_bounds(&assessed, |one| Estimate::new(one.found.value, 0.1 * one.found.error)));
    println!("{} values, bounds over errors {:?}, a tenth as long: {} missed", tally.values, tally.width(0.5), short.misses.len());
    assert!(3 * short.misses.len() > tally.values);
}
