//! Source: `studies::hard_cases`; thesis chapters 3 to 5 and the closed forms that each case names.
//!
//! Goal: at least sixty cases over all problems; every one comes out as theory says, or is named as lost with the reason; and the comparison can say no: each
//! expectation, falsified, fails.
//!
//! Parameters: all cases of the reduced report.
//!
//! Oracle: closed forms, limits, textbook fields, other routes, each named with its case; none recorded from a run.
//!
//! Tolerance: stated with each case; bounds as well as errors must be within it.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use viscotack::{Estimate, Refusal};
use viscotack_verification::studies::Effort;
use viscotack_verification::studies::hard_cases::case::{Expected, Found, Kind, falsified, held};
use viscotack_verification::studies::hard_cases::{cases, failures};

#[test]
fn every_hard_case_comes_out_as_theory_says() {
    let all = cases(Effort::Reduced);
    let results: Vec<Vec<String>> = all.par_iter().map(|case| failures(&case.expected, &(case.run)())).collect();
    let mut of_problem: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (case, failures) in all.iter().zip(&results) {
        *of_problem.entry(case.problem).or_default() += 1;
        if !failures.is_empty() {
            wrong.push(format!("{}: {}: {failures:?}", case.problem, case.name));
        }
    }
    println!("{of_problem:?}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(all.len() >= 60 && of_problem.values().all(|count| *count >= 5), "{of_problem:?}");
    let names: BTreeSet<(&str, &str)> = all.iter().map(|case| (case.problem, case.name.as_str())).collect();
    assert_eq!(names.len(), all.len(), "two cases of one name");
}

#[test]
fn the_comparison_says_no() {
    let value = |value, error| Found::default().with("x", Estimate::new(value, error));
    let x = Expected::Value { quantity: "x", value: 2.0, tolerance: 1e-3 };
    assert!(held(&x, &value(2.0005, 1e-4)).is_ok());
    assert!(held(&x, &value(2.002, 1e-4)).is_err(), "a wrong value");
    assert!(held(&x, &value(2.0, 1e-2)).is_err(), "an accuracy that was not reached");
    assert!(held(&x, &value(f64::NAN, 1e-4)).is_err() && held(&x, &value(2.0, f64::NAN)).is_err());
    assert!(held(&x, &Found::default()).is_err(), "a value that is not there");
    assert!(held(&falsified(&x), &value(2.0, 1e-4)).is_err());
    let none = |limit| Found::refused(Refusal::NoSuchState { reason: String::new(), limit_name: "limit", limit });
    let witness = Expected::NoSuchState { limit: 1.0, tolerance: 1e-6 };
    assert!(held(&witness, &none(1.0)).is_ok() && held(&witness, &none(1.1)).is_err(), "a witness of another value");
    assert!(held(&witness, &value(1.0, 0.0)).is_err(), "a state where none exists");
    assert!(held(&witness, &Found::refused(Refusal::NotConverged { what: "x", detail: String::new() })).is_err(), "a defect is no witness");
    let out = Found::refused(Refusal::out_of_range("x", 1.0, "less"));
    assert!(held(&Expected::Refused(Kind::OutOfRange), &out).is_ok() && held(&Expected::Refused(Kind::Undefined), &out).is_err());
    assert!(held(&Expected::Is("held"), &Found::default().is("lost")).is_err());
    assert!(!failures(&[], &value(1.0, 0.0)).is_empty(), "nothing is expected");
}
