//! Source: the studies of `viscotack verify`; least squares on two columns.
//!
//! Goal: an order is fitted on the asymptotic part and nothing else, a missed order fails, a grown counter fails, a rival that wins is said to win.
//!
//! ```text
//! ln error │ · (coarse, not asymptotic)
//!          │    \·
//!          │      \·   slope = order          a floor below which points are rounding
//! ```
//! Parameters: made-up errors of orders 0.5 to 6 and of digits a node, with a coarse point off the line and points on the floor.
//!
//! Oracle: the order they were made with. Tolerance: rounding, 1e-9.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack_verification::studies::counters::{Counter, against};
use viscotack_verification::studies::order::{Convergence, Expectation, FINEST, fitted_digits, fitted_order};
use viscotack_verification::studies::precision::{Method, Sample, contest};
use viscotack_verification::studies::stored::parse;
use viscotack_verification::studies::timing::median;
use viscotack_verification::studies::{Cell, CheckResult};

fn errors(order: f64, floor: f64) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = (0..12).map(|k| 2f64.powi(k)).map(|n| (n, (3.0 * n.powf(-order)).max(floor))).collect();
    // Too coarse to know the order.
    points[0].1 = 0.7;
    points
}

#[test]
fn known_orders_are_fitted_above_the_floor_only() {
    for order in [0.5, 1.0, 2.0, 2.6, 4.0, 6.0] {
        let fit = fitted_order(&errors(order, 1e-11), 1e-11, FINEST).unwrap();
        assert!((fit.rate - order).abs() < 1e-9, "{order}: {fit:?}");
        assert!(fit.points == 4);
    }
    let geometric: Vec<(f64, f64)> = [8.0, 12.0, 16.0].map(|n: f64| (n, 10f64.powf(-0.75 * n))).to_vec();
    assert!((fitted_digits(&geometric, 1e-16).unwrap().rate - 0.75).abs() < 1e-9);
    // On the floor at the second rule: no less than this.
    let quick = [(8.0, 1e-8), (12.0, 1e-17), (16.0, 1e-17)];
    assert!((fitted_digits(&quick, 1e-14).unwrap().rate - 1.5).abs() < 1e-9);
}

#[test]
fn too_few_points_show_no_order() {
    assert!(fitted_order(&[(1.0, 0.1), (2.0, 0.05)], 1e-15, FINEST).is_none());
    // All but two are on the floor.
    assert!(fitted_order(&[(1.0, 0.1), (2.0, 0.01), (4.0, 1e-12), (8.0, 1e-12)], 1e-12, FINEST).is_none());
    assert!(fitted_order(&[(1.0, f64::NAN), (2.0, f64::INFINITY), (4.0, 0.1)], 1e-12, FINEST).is_none());
}

fn convergence(expected: Expectation) -> Convergence {
    Convergence { name: "made up".into(), points: errors(2.0, 1e-13), floor: 1e-13, fitted: FINEST, expected }
}

/// The right order passes, a falsified one fails, from above and from below.
#[test]
fn a_falsified_order_fails() {
    let order = |order: f64| Expectation::Order { order, least: order - 0.3, most: order + 0.3, reason: "made up" };
    assert_eq!(convergence(order(2.0)).check().result, CheckResult::Passed);
    assert_eq!(convergence(order(1.0)).check().result, CheckResult::Failed);
    assert_eq!(convergence(order(3.0)).check().result, CheckResult::Failed);
    assert_eq!(convergence(Expectation::Erratic { least_error: 0.1, reason: "made up" }).check().result, CheckResult::Failed);
    assert_eq!(convergence(Expectation::Digits { least: 3.0, reason: "made up" }).check().result, CheckResult::Failed);
    let few = Convergence { points: vec![(1.0, 0.1)], ..convergence(order(2.0)) };
    assert_eq!(few.check().result, CheckResult::Failed, "no order is no pass");
    assert!(convergence(order(2.0)).label().contains("order 2.00"));
}

fn sample(seconds: f64, error: f64) -> Sample {
    let error = if error.is_nan() { Err("lost".to_owned()) } else { Ok(error) };
    Sample { setting: format!("{seconds}"), seconds, runs: 3, counted: Vec::new(), error }
}

#[test]
fn a_rival_that_wins_anywhere_is_said_to_win() {
    let method = |own: bool, samples: &[(f64, f64)]| Method {
        name: "made up".into(),
        own,
        samples: samples.iter().map(|&(seconds, error)| sample(seconds, error)).collect(),
    };
    let ours = method(true, &[(1e-3, 1e-3), (2e-3, 1e-6), (4e-3, 1e-9)]);
    let slow = contest(&[&ours], &method(false, &[(1.0, 1e-2), (10.0, 1e-5), (20.0, f64::NAN)]));
    assert!(slow.dominates() && slow.runs == 2, "{slow:?}");
    assert!((slow.closest.as_ref().unwrap().0 - 1000.0).abs() < 1e-9 && (slow.at_its_best.unwrap().1 - 5000.0).abs() < 1e-9, "{slow:?}");
    let quick = contest(&[&ours], &method(false, &[(1e-4, 1e-2), (10.0, 1e-5)]));
    assert!(!quick.dominates() && quick.text().contains("LOSES"), "{quick:?}");
    let exact = contest(&[&ours], &method(false, &[(1.0, 1e-12)]));
    assert!(!exact.dominates() && exact.text().contains("out of reach"), "{exact:?}");
    let none = contest(&[&ours], &method(false, &[(1.0, f64::NAN)]));
    assert!(none.runs == 0 && none.text().contains("no result"));
}

#[test]
fn counters_that_grew_fail_and_those_that_fell_do_not() {
    let file = "problem,run,counted,count\np,one,steps,100\np,two,steps,100\n";
    let counter = |run: &str, count: f64| Counter { problem: "p".into(), run: run.into(), counted: "steps", count };
    let result = |counters: &[Counter]| against(file, counters).1.result;
    assert_eq!(result(&[counter("one", 105.0), counter("two", 50.0)]), CheckResult::Passed);
    assert_eq!(result(&[counter("one", 111.0), counter("two", 50.0)]), CheckResult::Failed);
    // Runs that nobody stored prove nothing.
    assert_eq!(result(&[counter("three", 1.0)]), CheckResult::Failed);
    let (table, _) = against(file, &[counter("one", 111.0)]);
    assert!(table.rows[0].contains(&Cell::Number(Some(111.0))));
}

#[test]
fn stored_runs_keep_their_stamp_and_their_failures() {
    let text = "problem,method,setting,error,seconds,machine,version,date\na,peer,N = 8,1e-3,0.5,box,1.0,2026-01-01\na,peer,N = 4,,0.1,box,1.0,2026-01-01\na,peer,N = 2,1,,box,1.0,2026-01-01\n";
    let runs = parse(text);
    assert!(runs.len() == 2, "a run without a time is none");
    assert!(runs[0].error == Some(1e-3) && runs[1].error.is_none());
    assert_eq!(runs[0].stamp, ["box", "1.0", "2026-01-01"].map(str::to_owned));
}

#[test]
fn medians() {
    assert!((median(&mut [3.0, 1.0, 2.0]) - 2.0).abs() < 1e-15 && (median(&mut [4.0, 1.0, 2.0, 3.0]) - 2.5).abs() < 1e-15);
    assert!(median(&mut []).is_nan());
}
