//! An indenter whose work of adhesion is that of the way and of the speed of its edge.
//!
//! Source: theory notes, section 0 (an apparent work of adhesion Δγ(v_edge)) and section 4; Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301,
//! [10.1098/rspa.1971.0141](https://doi.org/10.1098/rspa.1971.0141).
//!
//! Goal: C = Δγ(da/dt) at an edge that moves, by the trailing work where it recedes and the leading one where it advances; rest between the two.
//!
//! ```text
//!  F |        / loading: JKR, leading work
//!    |      / |
//!    |    /   |  the edge rests
//!    |___/____/______ Δ
//!    |  \____/  unloading: JKR, trailing work, to pull-off
//! ```
//! Oracles: `reference_data/edge_speed.csv`, an initial-value problem on closed elastic fields (`verification/references/edge_speed.py`); JKR; the same problem with
//! one constant work where works are equal. Viscoelastic edges of a punch with works by speed are in `indentation_rim.rs`.
//!
//! Tolerances: the bounds of both, the accuracy asked for, or first order in the zone, as each test says.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::{Row, reference_rows};
use viscotack::closure::work_by_speed::{WorkAtSpeed, WorkBySpeed};
use viscotack::elastic::{EquilibriumBranch, JkrSphere};
use viscotack::indentation::{
    Adhesion, EdgeLaw, EventKind, History, IndentationProblem, IndentationSolution, Profile, elastic_contact, run,
};
use viscotack::material::RelaxationTerm;
use viscotack::{PlaneMaterial, Refusal};

fn entry(speed: f64, trailing: f64, leading: f64) -> WorkAtSpeed {
    WorkAtSpeed { speed, trailing, leading }
}

fn sphere(radius: f64, work_of_adhesion: f64, process_zone: f64, history: History) -> IndentationProblem {
    IndentationProblem::new(Profile::Paraboloid { radius }, Some(Adhesion { work_of_adhesion, process_zone }), history)
}

fn with(problem: &IndentationProblem, edge_law: EdgeLaw) -> IndentationProblem {
    IndentationProblem { edge_law, ..problem.clone() }
}

fn two_works(leading_ratio: f64) -> EdgeLaw {
    EdgeLaw { leading_ratio, ..EdgeLaw::CONSTANT }
}

fn by_speed(law: WorkBySpeed) -> EdgeLaw {
    EdgeLaw { by_speed: Some(law), ..EdgeLaw::CONSTANT }
}

fn solved(material: &PlaneMaterial, problem: &IndentationProblem) -> IndentationSolution {
    let found = run(material, problem).unwrap_or_else(|refusal| panic!("{problem:?}: {refusal}"));
    assert!(found.reached, "{problem:?}");
    assert!(found.residual < 1e-5, "{:e}", found.residual);
    found
}

fn of_row(row: &Row) -> (PlaneMaterial, IndentationProblem) {
    let numbers = |text: &str| text.split(',').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>();
    let mut path = row.text("path").split(';').map(numbers);
    let start = path.next().unwrap()[0];
    let history = path.fold(History::penetration(start), |history, piece| history.ramp(piece[0], piece[1]));
    let mut problem = sphere(row.number("radius"), row.number("trailing"), row.number("zone"), history).relaxed();
    problem.edge_law = two_works(row.number("leading") / row.number("trailing"));
    let law: Vec<&str> = row.text("law").split(';').collect();
    problem.edge_law.by_speed = match law[0] {
        "power" => Some(WorkBySpeed::power(law[1].parse().unwrap(), law[2].parse().unwrap()).unwrap()),
        "table" => {
            let entries: Vec<WorkAtSpeed> = law[1..].iter().map(|text| numbers(text)).map(|it| entry(it[0], it[1], it[2])).collect();
            Some(WorkBySpeed::table(&entries).unwrap())
        }
        _ => None,
    };
    (PlaneMaterial::elastic(row.number("modulus")).unwrap(), problem)
}

/// Two unit systems; laws and tables; approach, rest, retraction, and an approach again.
#[test]
fn elastic_edges_are_the_initial_value_problem() {
    let rows = reference_rows("edge_speed.csv");
    let mut names: Vec<&str> = rows.iter().map(|row| row.text("case")).collect();
    names.dedup();
    assert_eq!(names.len(), 5);
    for name in names {
        let case: Vec<&Row> = rows.iter().filter(|row| row.text("case") == name).collect();
        let (material, problem) = of_row(case[0]);
        let found = solved(&material, &IndentationProblem { accuracy: 1e-5, ..problem });
        let scale = |quantity: &str| {
            case.iter().filter(|row| row.text("quantity") == quantity).fold(0.0_f64, |most, row| most.max(row.number("value").abs()))
        };
        for row in &case {
            let (quantity, exact) = (row.text("quantity"), row.number("value"));
            let (value, scale) = match quantity {
                "pull_off" => (found.pull_off_force().unwrap().value, exact),
                "force" => (found.instants[row.number("instant") as usize].force.value, scale("force").max(scale("pull_off"))),
                _ => (found.instants[row.number("instant") as usize].contact_radius.value, scale("contact_radius")),
            };
            let error = (value - exact).abs() / scale;
            println!("{name} {} {quantity}: {error:.1e}", row.text("instant"));
            // The accuracy that was asked for.
            assert!(error < 1e-5, "{name} {} {quantity}: {value} against {exact}", row.text("instant"));
        }
    }
}

fn three_terms() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(1.3e6, &[term(3e6, 0.05), term(5e6, 1.0), term(2e6, 20.0)]).unwrap()
}

/// Works that do not differ, or that no speed changes, are one work: every instant within both bounds.
#[test]
fn equal_works_are_one_work() {
    let flat = || WorkBySpeed::table(&[entry(1e-9, 1.0, 1.0), entry(1e9, 1.0, 1.0)]).unwrap();
    let history = History::penetration(0.0).ramp(5e-6, 5.0).hold(2.0).ramp(2e-6, 1.0).ramp(4e-6, 0.5).ramp(-30e-6, 40.0);
    for material in [PlaneMaterial::elastic(1.3e6).unwrap(), PlaneMaterial::standard_solid(1.3e6, 1.3e7, 1.0).unwrap(), three_terms()] {
        let problem = IndentationProblem { instants_per_segment: 5, ..sphere(1e-3, 0.05, 2e-7, history.clone()) };
        let one = solved(&material, &problem);
        for (name, law) in [("a flat table", by_speed(flat())), ("leading work 1 − 1e-12 of the trailing one", two_works(1.0 - 1e-12))] {
            let other = solved(&material, &with(&problem, law));
            let mut worst = 0.0_f64;
            for (first, second) in one.instants.iter().zip(&other.instants) {
                for (first, second, scale) in [(first.force, second.force, 2.4e-4), (first.contact_radius, second.contact_radius, 1e-4)] {
                    let allowed = first.error + second.error + 1e-9 * scale;
                    worst = worst.max((first.value - second.value).abs() / scale);
                    assert!((first.value - second.value).abs() <= 2.0 * allowed, "{name}: {first:?} {second:?}");
                }
            }
            println!("{name}: {worst:.1e} apart at most");
        }
    }
}

/// Quasi-static: loading follows JKR with the leading work, unloading holds the radius, then follows JKR with the trailing work, whose pull-off it has.
#[test]
fn two_works_are_two_curves_of_jkr() {
    let (radius, modulus) = (1e-3, 1e6 / 0.75);
    let (trailing, leading) = (0.05, 0.005);
    let slow = PlaneMaterial::standard_solid(modulus, 10.0 * modulus, 1e-4).unwrap();
    for (name, material, zone) in [("elastic", PlaneMaterial::elastic(modulus).unwrap(), 1e-7), ("slow rubber", slow, 1e-7)] {
        let history = History::penetration(0.0).ramp(5e-6, 500.0).ramp(-3e-6, 800.0);
        let problem =
            IndentationProblem { instants_per_segment: 8, ..with(&sphere(radius, trailing, zone, history), two_works(leading / trailing)) };
        let found = solved(&material, &problem);
        let jkr = |work: f64, depth: f64| {
            JkrSphere::new(radius, modulus, work).unwrap().state_by_penetration(depth, EquilibriumBranch::Stable).unwrap()
        };
        // First order in the zone, over a contact of 30 µm or more.
        let allowed = 2.0 * zone / 3e-5 + 1e-4;
        let largest = jkr(leading, 5e-6).contact_radius;
        for instant in found.instants.iter().skip(1).take(8) {
            let exact = jkr(leading, instant.penetration.value).contact_radius;
            assert!((instant.contact_radius.value / exact - 1.0).abs() < allowed, "{name}: {instant:?} {exact}");
        }
        for instant in found.instants.iter().skip(9).filter(|instant| instant.contact_radius.value > 0.0) {
            let exact = jkr(trailing, instant.penetration.value).contact_radius.min(largest);
            assert!((instant.contact_radius.value / exact - 1.0).abs() < allowed, "{name}: {instant:?} {exact}");
        }
        let pull_off = found.pull_off_force().unwrap().value / (1.5 * PI * radius * trailing);
        println!("{name}: pull-off {pull_off} of JKR with the trailing work");
        assert!((pull_off - 1.0).abs() < 1e-2 && found.events.iter().any(|event| event.kind == EventKind::Detachment));
        if name == "elastic" {
            let first = found.instants[0].contact_radius.value / jkr(leading, 0.0).contact_radius;
            assert!((pull_off - 1.0).abs() < 1e-3 && (first - 1.0).abs() < 1e-3);
        }
    }
}

/// One physics in two unit systems: a viscoelastic sphere with two works that follow the speed, pressed, held and pulled off.
#[test]
fn two_unit_systems() {
    let run_in = |length: f64, time: f64, modulus: f64| {
        let material = PlaneMaterial::standard_solid(modulus, 10.0 * modulus, 0.3 * time).unwrap();
        let speed = length / time;
        let law =
            WorkBySpeed::table(&[entry(1e-3 * speed, 1.0, 1.0), entry(0.1 * speed, 4.0, 0.5), entry(10.0 * speed, 9.0, 0.2)]).unwrap();
        let history = History::penetration(0.0).ramp(0.05 * length, time).hold(time).ramp(-0.4 * length, 4.0 * time);
        let problem = sphere(length, 2e-3 * modulus * length, 5e-3 * length, history);
        let law = EdgeLaw { leading_ratio: 0.4, ..by_speed(law) };
        let found = solved(&material, &IndentationProblem { instants_per_segment: 6, ..with(&problem, law) });
        let forces: Vec<f64> = found.instants.iter().map(|instant| instant.force.value / (modulus * length * length)).collect();
        (forces, found.pull_off_force().unwrap().value / (modulus * length * length))
    };
    let (one, other) = (run_in(1.0, 1.0, 1.0), run_in(2.3e-3, 0.017, 4.1e6));
    for (first, second) in one.0.iter().zip(&other.0) {
        assert!((first - second).abs() < 1e-4 * one.1, "{first} {second}");
    }
    println!("pull-off {} and {}", one.1, other.1);
    assert!((one.1 / other.1 - 1.0).abs() < 1e-4);
}

/// Works of the speed make pull-off higher at any speed of the pull than the work at rest, and lower than that of the fastest edge.
#[test]
fn pull_off_between_the_works_of_slow_and_fast_edges() {
    for material in [PlaneMaterial::elastic(1.3e6).unwrap(), three_terms()] {
        let problem = |history: History| sphere(1e-3, 0.05, 2e-7, history).relaxed();
        let pulled = |law: EdgeLaw, work: f64| {
            let history = History::penetration(2e-6).at_speed(-60e-6, 3e-6);
            let base = problem(history);
            let adhesion = base.adhesion.map(|adhesion| Adhesion { work_of_adhesion: work, ..adhesion });
            solved(&material, &with(&IndentationProblem { adhesion, ..base }, law)).pull_off_force().unwrap().value
        };
        let table = WorkBySpeed::table(&[entry(1e-8, 1.0, 1.0), entry(1e-4, 3.0, 1.0)]).unwrap();
        let (slow, between) = (pulled(EdgeLaw::CONSTANT, 0.05), pulled(by_speed(table), 0.05));
        println!("pull-off: {slow} at rest's work, {between} by speed");
        assert!(between > 1.02 * slow && between < 3.2 * slow);
    }
}

/// What has no stable speed, or no sense, is refused with the reason, whenever it comes up.
#[test]
fn refusals_have_reasons() {
    let material = PlaneMaterial::standard_solid(1.3e6, 1.3e7, 1.0).unwrap();
    let approach = sphere(1e-3, 0.05, 2e-7, History::penetration(0.0).ramp(5e-6, 5.0));
    let refusal = |problem: &IndentationProblem| run(&material, problem).unwrap_err();
    let rising = || by_speed(WorkBySpeed::power(1e-6, 0.5).unwrap());
    // It jumps in, or advances later on, and its work rises with its speed.
    for problem in [approach.clone(), sphere(1e-3, 0.05, 2e-7, History::penetration(1e-6).ramp(5e-6, 5.0)).relaxed()] {
        let found = refusal(&with(&problem, rising()));
        assert!(matches!(&found, Refusal::Undefined { quantity: "the speed of the advancing edge", .. }), "{found}");
    }
    let falling = by_speed(WorkBySpeed::table(&[entry(1e-9, 1.0, 1.0), entry(1e-3, 0.5, 1.0)]).unwrap());
    let found = refusal(&with(&sphere(1e-3, 0.05, 2e-7, History::penetration(1e-6).ramp(-5e-6, 5.0)).relaxed(), falling));
    assert!(matches!(&found, Refusal::Undefined { quantity: "the speed of the receding edge", .. }), "{found}");
    for ratio in [1.1, 0.0, -1.0, f64::NAN] {
        assert!(matches!(refusal(&with(&approach, two_works(ratio))), Refusal::OutOfRange { .. }));
    }
    let radius = sphere(1e-3, 0.05, 2e-7, History::contact_radius(1e-4).hold(1.0)).relaxed();
    assert!(matches!(refusal(&with(&radius, two_works(0.5))), Refusal::Undefined { .. }));
    let growing = EdgeLaw { growing_zone: true, ..EdgeLaw::CONSTANT };
    // Untouched, or pressed in again.
    let again = sphere(1e-3, 0.05, 2e-7, History::penetration(1e-6).ramp(0.0, 1.0).ramp(1e-6, 1.0)).relaxed();
    for problem in [&radius, &approach, &again] {
        assert!(matches!(refusal(&with(problem, growing.clone())), Refusal::Undefined { .. }));
    }
}

/// A relaxed sphere is an elastic contact with the zone of its own K. Pulled, the larger zone lets it off at a smaller force; an elastic sphere as before.
#[test]
fn a_zone_that_grows_on_a_sphere_is_that_of_its_edge() {
    let (relaxed, glassy, work, zone) = (1.3e6, 1.3e7, 0.05, 2e-7);
    let material = PlaneMaterial::standard_solid(relaxed, glassy, 1.0).unwrap();
    let growing = EdgeLaw { growing_zone: true, ..EdgeLaw::CONSTANT };
    let wide = 40.0 * zone;
    let held = sphere(1e-3, work, wide, History::penetration(5e-7).ramp(4.999_999e-7, 1e-9)).relaxed();
    let first = solved(&material, &with(&held, growing.clone())).instants[0];
    let growth = first.stress_intensity_factor.value.powi(2) / (2.0 * relaxed * work);
    let contact = elastic_contact(&held.profile, relaxed, work, wide * growth, 5e-7).unwrap().contact_radius;
    let constant = solved(&material, &held).instants[0].contact_radius.value;
    println!("G/Δγ {growth}: {} against {contact}, constant {constant}", first.contact_radius.value);
    assert!((first.contact_radius.value / contact - 1.0).abs() < 1e-6 && (constant / contact - 1.0).abs() > 1e-5);
    let pull_off = |material: &PlaneMaterial, rate: f64, law: &EdgeLaw| {
        let history = History::penetration(5e-6).ramp(-40e-6, 45e-6 / rate);
        let problem = sphere(1e-3, work, zone, history).relaxed();
        solved(material, &with(&problem, law.clone())).pull_off_force().unwrap().value
    };
    for rate in [1e-6, 1e-5] {
        let [constant, grows] = [&EdgeLaw::CONSTANT, &growing].map(|law| pull_off(&material, rate, law));
        println!("rate {rate}: {constant} constant, {grows} growing");
        assert!(grows < 0.99 * constant && grows > 0.5 * constant);
    }
    // Where G = Δγ at every instant, both zones are one.
    let elastic = PlaneMaterial::elastic(relaxed).unwrap();
    let [constant, grows] = [&EdgeLaw::CONSTANT, &growing].map(|law| pull_off(&elastic, 1e-5, law));
    println!("elastic: {constant} and {grows}");
    assert!((grows / constant - 1.0).abs() < 1e-3);
}
