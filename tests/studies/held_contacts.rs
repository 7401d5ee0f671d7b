//! Source: `verification/src/studies/held_contacts`, the reference for sliding states under a held load, penetration or half-width.
//!
//! Goal: the reference finds all contacts, and it notices a wrong answer.
//! Oracle: pairs of conics made to pass through four drawn points; the contacts of `reference_data/sliding_held_loads.csv` (collocation, another program and another
//! search); small motions of two edges with drawn mobilities, integrated in time, for the criterion of stability; answers that are made wrong on purpose. Tolerance:
//! 1e-8 of a point (rounding of a quartic with roots as near as drawn); 1e-6 of a contact (both discretisations confirm seven digits and more); 1e-4 of a limit (the
//! reference takes the turn of the load, the study also a contact just before it where one edge alone becomes unstable); none for results.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::support;

use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;
use std::sync::Arc;
use support::reference_rows;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactEdges, ContactMemory, Indenter, Resolution, WaveContact};
use viscotack::sliding::steady::{PartialValues, WaveAdhesion};
use viscotack::{Estimate, PlaneMaterial};
use viscotack_verification::studies::draw::Draw;
use viscotack_verification::studies::held_contacts::answer::Answer;
use viscotack_verification::studies::held_contacts::conics::common_points;
use viscotack_verification::studies::held_contacts::draws::{Asked, Control};
use viscotack_verification::studies::held_contacts::stability::Held;
use viscotack_verification::studies::held_contacts::states::{Expected, Reached, Speed};
use viscotack_verification::studies::held_contacts::width::{Bodies, Equilibrium};
use viscotack_verification::studies::held_contacts::{Fault, against};

/// A conic through four points and a fifth one: the null vector of five rows.
fn through(points: &[Vector3<f64>; 4], fifth: Vector3<f64>) -> Matrix3<f64> {
    let row = |p: &Vector3<f64>| [p[0] * p[0], p[1] * p[1], p[2] * p[2], 2.0 * p[0] * p[1], 2.0 * p[0] * p[2], 2.0 * p[1] * p[2]];
    let mut rows = nalgebra::DMatrix::<f64>::zeros(6, 6);
    for (index, point) in points.iter().chain([&fifth]).enumerate() {
        for (column, value) in row(point).into_iter().enumerate() {
            rows[(index, column)] = value;
        }
    }
    let decomposed = rows.svd(false, true);
    let v = decomposed.v_t.unwrap();
    let n = v.row(5);
    Matrix3::new(n[0], n[3], n[4], n[3], n[1], n[5], n[4], n[5], n[2])
}

#[test]
fn all_four_common_points_of_two_conics_are_found() {
    for scene in 0..400 {
        let mut draw = Draw::of(36, scene);
        let mut point = || Vector3::from_fn(|_, _| draw.between(-1.0, 1.0)).normalize();
        let points = [point(), point(), point(), point()];
        let (first, second) = (through(&points, point()), through(&points, point()));
        // Axes of unequal size, as works, lengths and loads have.
        let scales = Matrix3::from_diagonal(&Vector3::new(1.0, 1e-3, 40.0));
        let found = common_points(&(scales * first * scales), &(scales * second * scales));
        for point in points {
            let nearest = found
                .iter()
                .map(|other| (scales * other).normalize())
                .map(|other| (other - point).norm().min((other + point).norm()))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-8, "scene {scene}: a common point is missed by {nearest:e}");
        }
        assert!(found.len() <= 4, "scene {scene}: {} common points", found.len());
    }
}

#[test]
fn a_stable_matrix_holds_both_edges_whatever_their_mobilities() {
    // dl/dt = −diag(m) M l: an edge that does more work than adhesion takes recedes.
    for scene in 0..2000 {
        let mut draw = Draw::of(37, scene);
        let m = [[draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)], [draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)]];
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        let stable = m[0][0] > 0.0 && m[1][1] > 0.0 && determinant > 0.0;
        let mut escapes = false;
        for _ in 0..60 {
            let mobilities = [draw.log_between(1e-6, 1.0), draw.log_between(1e-6, 1.0)];
            let (trace, product) = (mobilities[0] * m[0][0] + mobilities[1] * m[1][1], mobilities[0] * mobilities[1] * determinant);
            escapes |= trace <= 0.0 || product <= 0.0;
        }
        // Near the border a few mobilities may not show an escape; a stable one never escapes.
        assert!(!(stable && escapes), "scene {scene}: {m:?}");
        let clear = [m[0][0], m[1][1], determinant].iter().any(|&value| value < -0.05);
        assert!(!clear || escapes, "scene {scene}: {m:?}");
    }
}

/// Material, adhesion, held loads with the half-width of their stable contact, and limits, of a case of the reference.
type Case = (PlaneMaterial, Option<WaveAdhesion>, BTreeMap<u64, Option<f64>>, Vec<(String, f64, f64)>);

fn cases() -> BTreeMap<String, Case> {
    let mut cases: BTreeMap<String, Case> = BTreeMap::new();
    let mut last = f64::NAN;
    for row in reference_rows("sliding_held_loads.csv") {
        let terms: Vec<CreepTerm> = row
            .text("terms")
            .split_whitespace()
            .map(|term| term.split_once(':').unwrap())
            .map(|(compliance, ratio)| CreepTerm { compliance: compliance.parse().unwrap(), retardation_time: ratio.parse().unwrap() })
            .collect();
        let glassy = 1.0 - terms.iter().map(|term| term.compliance).sum::<f64>();
        let case = cases.entry(row.text("case").to_owned()).or_insert_with(|| {
            let adhesion = WaveAdhesion {
                trailing_work: row.number("trailing_work"),
                leading_work: row.number("leading_work"),
                trailing_zone: row.number("zone"),
                leading_zone: row.number("zone"),
            };
            let adhesion = (adhesion.trailing_zone > 0.0).then_some(adhesion);
            (PlaneMaterial::from_creep(1.0 / glassy, &terms, None).unwrap(), adhesion, BTreeMap::new(), Vec::new())
        });
        match (row.text("asked"), row.text("quantity")) {
            ("limit", _) => case.3.push((row.text("index").to_owned(), row.number("value"), 10f64.powf(-row.number("confirmed_digits")))),
            (_, "half_width") => last = row.number("value"),
            (_, "stable") if row.number("value") > 0.0 => {
                case.2.insert(row.number("held").to_bits(), Some(last));
            }
            (_, "stable_contacts") => {
                case.2.entry(row.number("held").to_bits()).or_insert(None);
            }
            _ => {}
        }
    }
    cases
}

#[test]
fn the_reference_finds_the_contacts_and_limits_of_another_program() {
    for (name, (material, adhesion, held, limits)) in cases() {
        let memory = Arc::new(ContactMemory::new(&material, 1.0).unwrap());
        let at = |resolution| Bodies::new(Arc::clone(&memory), Indenter::Wave, adhesion, resolution);
        let speed = Speed::new(at(Resolution::Fine), at(Resolution::Finest), 100, false).unwrap();
        let near = |reported: f64, kind: &str| {
            limits.iter().any(|(name, value, digit)| {
                name.starts_with(kind) && (reported - value).abs() < 1e-4_f64.max(3.0 * digit) * value.abs().max(0.1)
            })
        };
        for (load, right) in held {
            let load = f64::from_bits(load);
            match (speed.expected(Held::Load, load, Reached::Loading), right) {
                (Expected::Contact { contact, .. }, Some(right)) => {
                    assert!((contact.half_width / right - 1.0).abs() < 1e-6, "{name}, p = {load}: {} {right}", contact.half_width);
                }
                (Expected::Full(limit), None) => assert!(adhesion.is_none() || near(limit, "maximum"), "{name}, p = {load}: {limit}"),
                (Expected::Nothing(limit), None) => assert!(near(limit, "minimum"), "{name}, p = {load}: {limit}"),
                (Expected::NoPartial, None) => assert!(limits.is_empty(), "{name}"),
                other => panic!("{name}, p = {load}: {other:?}"),
            }
        }
    }
}

fn values(contact: &Equilibrium) -> PartialValues {
    let reported = |value: f64| Estimate::new(value, 1e-9);
    PartialValues {
        half_width: reported(contact.half_width),
        eccentricity: reported(contact.eccentricity),
        trailing_edge: reported(contact.eccentricity - contact.half_width),
        leading_edge: reported(contact.eccentricity + contact.half_width),
        penetration: reported(contact.penetration),
        mean_pressure: reported(contact.mean_pressure),
        friction_stress: reported(contact.friction_stress),
        friction_coefficient: None,
        interface_work: reported(0.0),
        adhesion: None,
    }
}

#[test]
fn every_wrong_answer_is_noticed() {
    // A wave of one term, well inside its limits.
    let material = PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.9, retardation_time: 1.0 }], None).unwrap();
    let memory = Arc::new(ContactMemory::new(&material, 10.0).unwrap());
    let at = |resolution| Bodies::new(Arc::clone(&memory), Indenter::Wave, Some(WaveAdhesion::even(0.008, 1e-3)), resolution);
    let speed = Speed::new(at(Resolution::Medium), at(Resolution::Finest), 60, true).unwrap();
    let asked = |value: f64| Asked { control: Control::MeanPressure, value, reached: Reached::Loading };
    let fault = |value: f64, answer: Answer| against(0, &speed, asked(value), &answer).fault;
    let Expected::Contact { contact, others } = speed.expected(Held::Load, 0.162, Reached::Loading) else { panic!("a contact") };
    let reported = |values: PartialValues, stable: bool, others: usize| Answer::Contact {
        values: Box::new(values),
        stable: [Some(stable), None, None],
        others: Some(others),
    };
    let right = values(&contact);
    assert_eq!(fault(0.162, reported(right, true, others)), None);
    // The unstable contact of the same load, across the narrow gap.
    let unstable = speed
        .bodies
        .contacts(ContactEdges::new(Indenter::Wave, WaveContact { half_width: 3.118_663_2, eccentricity: 0.0 }).place())
        .unwrap();
    let unstable = unstable.iter().find(|other| (other.mean_pressure - 0.162).abs() < 1e-3).unwrap();
    assert_eq!(fault(0.162, reported(values(unstable), false, others)), Some(Fault::Wrong));
    assert_eq!(fault(0.162, Answer::Full(0.16)), Some(Fault::FalselyFull));
    assert_eq!(fault(0.162, Answer::Nothing(0.17)), Some(Fault::FalselyRefused));
    assert_eq!(fault(0.162, Answer::Failed("not converged".into())), Some(Fault::FalselyRefused));
    assert_eq!(fault(0.162, reported(right, false, others)), Some(Fault::WrongStability));
    assert_eq!(fault(0.162, reported(right, true, others + 1)), Some(Fault::Alternatives));
    let off = PartialValues { friction_stress: Estimate::new(right.friction_stress.value + 1e-7, 1e-9), ..right };
    assert_eq!(fault(0.162, reported(off, true, others)), Some(Fault::Bound));
    assert_eq!(fault(5.61, Answer::Full(5.609_45)), None);
    assert_eq!(fault(5.61, Answer::Full(0.591)), Some(Fault::WrongLimit));
    assert_eq!(fault(5.61, reported(right, true, 0)), Some(Fault::Wrong));
    assert_eq!(fault(-0.11, Answer::Nothing(-0.1024)), None);
    assert_eq!(fault(-0.11, Answer::Nothing(-0.0479)), Some(Fault::WrongLimit));
    assert_eq!(fault(-0.11, Answer::Full(-0.1024)), Some(Fault::FalselyFull));
}
