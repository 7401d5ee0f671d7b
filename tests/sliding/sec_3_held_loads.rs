//! Source: `reference_data/sliding_held_loads.csv`, written by `verification/references/sliding_held_loads.py` (thesis Secs 3.2 and 3.3, Eqs 3.23 to 3.30).
//!
//! Goal: under a held mean pressure the solver returns the contact that is stable under it; beyond the limits of this speed it says full contact or no such state, with
//! the limit of this speed.
//!
//! ```text
//! reference:  the integral equation collocated; all eccentricities and half-widths scanned; stability by differences of collocated works
//! ```
//! Parameters: one, two and six terms, β from 2 to 100, sliding ratios from 0.014 to 100, with and without adhesion, equal and unequal works,
//! negative snap-in; the scene
//! of
//! `new sliding` at three speeds. E0 = 2.3 MPa and kv = 7/s, no units.
//!
//! Oracle: the file; limits without adhesion: |E*(kv)| in closed form.
//!
//! Tolerance: three units of the last confirmed digit, or 1e-7, of values; of limits three units of the last confirmed digit, or 1e-4 (the load may turn just
//! after one edge alone becomes unstable; a wrong limit is off by a tenth at least).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::collections::BTreeMap;
use support::{Row, reference_rows};
use viscotack::PlaneMaterial;
use viscotack::Refusal;
use viscotack::material::CreepTerm;
use viscotack::sliding::steady::{Indenter, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

const RELAXED: f64 = 2.3e6;
const RATE: f64 = 7.0;
const LIMIT: f64 = 1e-4;

/// A problem of the file: its rows by what is held, and its limits.
struct Case {
    material: PlaneMaterial,
    adhesion: Option<WaveAdhesion>,
    held: Vec<(f64, Vec<Row>)>,
    limits: Vec<(String, f64, f64)>,
}

fn material(row: &Row) -> PlaneMaterial {
    let terms: Vec<(f64, f64)> = row
        .text("terms")
        .split_whitespace()
        .map(|term| term.split_once(':').unwrap())
        .map(|(compliance, ratio)| (compliance.parse().unwrap(), ratio.parse().unwrap()))
        .collect();
    let glassy = 1.0 - terms.iter().map(|term| term.0).sum::<f64>();
    let terms: Vec<CreepTerm> = terms
        .into_iter()
        .map(|(compliance, ratio)| CreepTerm { compliance: compliance / RELAXED, retardation_time: ratio / RATE })
        .collect();
    PlaneMaterial::from_creep(RELAXED / glassy, &terms, None).unwrap()
}

fn cases() -> BTreeMap<String, Case> {
    let mut cases: BTreeMap<String, Case> = BTreeMap::new();
    for row in reference_rows("sliding_held_loads.csv") {
        let case = cases.entry(row.text("case").to_owned()).or_insert_with(|| Case {
            material: material(&row),
            adhesion: (row.number("zone") > 0.0).then(|| WaveAdhesion {
                trailing_work: row.number("trailing_work"),
                leading_work: row.number("leading_work"),
                trailing_zone: row.number("zone"),
                leading_zone: row.number("zone"),
            }),
            held: Vec::new(),
            limits: Vec::new(),
        });
        if row.text("asked") == "limit" {
            case.limits.push((row.text("index").to_owned(), row.number("value"), 10f64.powf(-row.number("confirmed_digits"))));
            continue;
        }
        let held = row.number("held");
        match case.held.last_mut() {
            Some((load, rows)) if load.to_bits() == held.to_bits() => rows.push(row),
            _ => case.held.push((held, vec![row])),
        }
    }
    cases
}

/// The quantities of the stable contact of a load; none if there is no stable one.
fn stable(rows: &[Row]) -> Option<BTreeMap<&str, (f64, f64)>> {
    let index = rows.iter().find(|row| row.text("quantity") == "stable" && row.number("value") > 0.0)?.text("index");
    let of = rows.iter().filter(|row| row.text("index") == index && !["stable", "stable_contacts"].contains(&row.text("quantity")));
    Some(of.map(|row| (row.text("quantity"), (row.number("value"), 10f64.powf(-row.number("confirmed_digits"))))).collect())
}

fn solved(case: &Case, load: f64) -> Result<SlidingOutcome, Refusal> {
    let problem = SlidingProblem {
        rate: RATE,
        indenter: Indenter::Wave,
        adhesion: case.adhesion,
        work_by_speed: None,
        control: SlidingControl::MeanPressure(load),
        accuracy: 1e-9,
    };
    steady_sliding(&case.material, &problem)
}

/// What is wrong with the answer of a held load; none if it is right.
fn fault(case: &Case, load: f64, rows: &[Row]) -> Option<String> {
    let outcome = solved(case, load);
    if let Some(right) = stable(rows) {
        let Ok(SlidingOutcome::Partial(found)) = outcome else { return Some(format!("a contact exists, {outcome:?}")) };
        let values = &found.values;
        for (name, found) in [
            ("half_width", values.half_width),
            ("eccentricity", values.eccentricity),
            ("penetration", values.penetration),
            ("friction_stress", values.friction_stress),
        ] {
            let (value, digit) = right[name];
            let error = (found.value - value).abs();
            if error.is_nan() || error > 1e-7_f64.max(3.0 * digit) * value.abs().max(1e-2) + found.error {
                return Some(format!("{name} {:.9e}, right {value:.9e}", found.value));
            }
        }
        return None;
    }
    // Without a stable contact: which limit is passed.
    let wrong = |reported: f64, right: &[(f64, f64)]| {
        let is = |&(limit, digit): &(f64, f64)| (reported - limit).abs() <= LIMIT.max(3.0 * digit) * limit.abs().max(0.1);
        (!right.iter().any(is)).then(|| format!("limit {reported:.9e}, right {right:?}"))
    };
    let limits = |kind: &str| -> Vec<(f64, f64)> {
        case.limits.iter().filter(|(name, ..)| name.starts_with(kind)).map(|(_, value, digit)| (*value, *digit)).collect()
    };
    match outcome {
        // No contact at any half-width: no limit of a load is passed.
        Ok(SlidingOutcome::Full(_)) | Err(Refusal::NoSuchState { .. }) if case.adhesion.is_some() && case.limits.is_empty() => None,
        Ok(SlidingOutcome::Full(full)) if case.adhesion.is_none() => {
            let modulus = case.material.complex_modulus(RATE).unwrap();
            wrong(full.limit, &[(modulus.storage.hypot(modulus.loss) / RELAXED, 0.0)])
        }
        Ok(SlidingOutcome::Full(full)) => {
            (load <= full.limit).then(|| "not beyond it".to_owned()).or_else(|| wrong(full.limit, &limits("maximum")))
        }
        Err(Refusal::NoSuchState { limit, .. }) => {
            (load >= limit).then(|| "not below it".to_owned()).or_else(|| wrong(limit, &limits("minimum")))
        }
        other => Some(format!("no contact is stable, {other:?}")),
    }
}

fn assert_right(names: &[&str]) {
    let cases = cases();
    let mut faults = Vec::new();
    for name in names {
        let case = &cases[*name];
        for (load, rows) in &case.held {
            faults.extend(fault(case, *load, rows).map(|fault| format!("{name}, p = {load}: {fault}")));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn loads_just_above_those_that_are_solved_today_by_the_unstable_contact() {
    assert_right(&["fast"]);
}

#[test]
fn the_scene_of_new_sliding_at_25_kpa() {
    assert_right(&["template, 1 cm/s"]);
}

#[test]
fn the_scene_of_new_sliding_on_a_stickier_wave() {
    assert_right(&["template, stickier, 1.1 mm/s", "template, stickier, 13.5 mm/s"]);
}

#[test]
fn limits_are_those_of_the_speed() {
    assert_right(&["slower"]);
}

#[test]
fn contacts_that_exist_only_under_a_pull() {
    assert_right(&["negative snap-in"]);
}

#[test]
fn full_contact_above_a_negative_snap_in() {
    assert_right(&["negative snap-in, faster"]);
}

#[test]
fn full_contact_without_adhesion_needs_the_modulus_of_the_speed() {
    assert_right(&["without adhesion", "without adhesion, slow"]);
    // Just below that a partial contact exists.
    let cases = cases();
    for name in ["without adhesion", "without adhesion, slow"] {
        let case = &cases[name];
        let modulus = case.material.complex_modulus(RATE).unwrap();
        let load = (1.0 - 1e-4) * modulus.storage.hypot(modulus.loss) / RELAXED;
        let outcome = solved(case, load);
        assert!(matches!(outcome, Ok(SlidingOutcome::Partial(_))), "{name}, p = {load}: {outcome:?}");
    }
}

#[test]
fn a_speed_without_any_partial_contact() {
    assert_right(&["none at this speed"]);
}

#[test]
fn several_terms_and_two_works() {
    assert_right(&["soft", "two terms", "two works", "six terms", "stiff", "longer zone"]);
}
