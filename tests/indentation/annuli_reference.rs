//! The sphere under prescribed edges against dense annuli.
//!
//! Source: `reference_data/sphere_annuli.csv`, written by `verification/references/sphere_annuli.py` (thesis Eqs 4.1 and 4.9).
//!
//! Goal: the reduction to a line, its memory, the closure on it and the surface outside the contact, without the reduction.
//!
//! ```text
//! solver:     Q and W on the line, each place a spring chain of its own
//! reference:  pressure on annuli, a dense kernel of disks, the memory of every place of the surface stepped; four meshes extrapolated
//! ```
//! Parameters: 1 to 3 terms, spheres and cones, reduced and SI; approach, retraction, rest, return, up to three ways; relaxed and glassy starts.
//!
//! Oracle: the file, each value with its change when the coarsest mesh is left out.
//!
//! Tolerance: 1e-5 of the largest value in the history, as the worst change is 2e-6. The closed loops of the file are read by the cross-checks.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::collections::BTreeMap;
use support::{Row, reference_rows};
use viscotack::PlaneMaterial;
use viscotack::indentation::{Contact, Profile, Springs, SurfaceFields, Sweep};
use viscotack::material::CreepTerm;

fn numbers(text: &str) -> Vec<f64> {
    text.split(',').map(|number| number.parse().unwrap()).collect()
}

/// Glassy modulus; J_j,τ_j; …
fn material(text: &str) -> PlaneMaterial {
    let (glassy, terms) = text.split_once(';').unwrap();
    let terms: Vec<CreepTerm> =
        terms.split(';').map(numbers).map(|pair| CreepTerm { compliance: pair[0], retardation_time: pair[1] }).collect();
    PlaneMaterial::from_creep(glassy.parse().unwrap(), &terms, None).unwrap()
}

/// The states of a history at the ends of its segments.
fn walked<'a>(row: &Row, springs: &'a Springs) -> Vec<Contact<'a>> {
    let size = row.number("size");
    let profile = if row.text("shape") == "cone" { Profile::Cone { slope: size } } else { Profile::Paraboloid { radius: size } };
    let path: Vec<Vec<f64>> = row.text("path").split(';').map(numbers).collect();
    let mut contact = match row.text("start") {
        "relaxed" => Contact::relaxed(springs, profile, path[0][0], path[0][1]),
        "untouched" => Contact::untouched(springs, profile, path[0][0], path[0][1]),
        other => panic!("start {other}"),
    }
    .unwrap();
    path[1..]
        .iter()
        .map(|segment| {
            contact = contact.moved(segment[0], segment[1], segment[2], Sweep::Linear).unwrap();
            contact.clone()
        })
        .collect()
}

#[test]
fn forces_works_and_surfaces_of_prescribed_edges() {
    let rows = reference_rows("sphere_annuli.csv");
    let mut worst: BTreeMap<&str, (usize, f64)> = BTreeMap::new();
    let mut cases: Vec<&str> = Vec::new();
    for first in rows.iter().filter(|row| row.text("kind") == "prescribed") {
        let case = first.text("case");
        if cases.contains(&case) {
            continue;
        }
        cases.push(case);
        let springs = Springs::new(&material(first.text("material"))).unwrap();
        let states = walked(first, &springs);
        for row in rows.iter().filter(|row| row.text("case") == case) {
            let state = &states[row.number("instant") as usize];
            let value = match row.text("quantity") {
                "force" => state.force(),
                "zone_work" => state.zone_work(row.number("zone")).unwrap(),
                "displacement" => SurfaceFields::of(state).displacement(row.number("place")).unwrap(),
                other => panic!("quantity {other}"),
            };
            let error = (value - row.number("value")).abs() / row.number("scale");
            let name = format!("{case} {} {}", row.text("instant"), row.text("quantity"));
            assert!(row.number("change") < 3e-6, "{name}: the reference itself has not converged");
            assert!(error < 1e-5, "{name}: {value:e} instead of {:e}, {error:e} of the largest", row.number("value"));
            let entry = worst.entry(row.text("quantity")).or_insert((0, 0.0));
            *entry = (entry.0 + 1, entry.1.max(error));
        }
    }
    for (quantity, (count, error)) in &worst {
        println!("{} histories, {quantity}: {count} values, worst {error:.1e}", cases.len());
    }
    assert!(cases.len() >= 20 && worst.values().map(|entry| entry.0).sum::<usize>() >= 100);
}
