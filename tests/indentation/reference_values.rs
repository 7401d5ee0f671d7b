//! The sphere against values of other methods.
//!
//! Source: `reference_data/indentation.csv` (mpmath, every value at 42 and at 60 digits) and `indentation_march.csv` (double, another method), both
//! written by `verification/references/indentation.py`.
//! Goal: elliptic kernel; closure for smooth, kinked and jumping fields; elastic contacts at a finite process zone; imposed edges without
//! adhesion; whole adhesive histories.
//! Parameters: in the files' `inputs`; one and three relaxation times, spheres and cones, reduced and SI numbers.
//! Oracle: the closure in real space (p(r) and gap by Sneddon's integrals, then 4.9), the integrals of Lee & Radok and of Ting, edges found place by
//! place instead of step by step.
//! Tolerance: rounding for closed numbers, stated with each; for histories the solver's own error bounds, which must therefore be honest.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::path::Path;
use viscotack::PlaneMaterial;
use viscotack::indentation::{
    Adhesion, Contact, History, IndentationProblem, IndentationSolution, Panel, Profile, Springs, Start, Sweep, Zone, elastic_contact,
    elliptic_k, run, zone_work,
};
use viscotack::material::RelaxationTerm;

struct Row {
    case: String,
    inputs: HashMap<String, String>,
    cells: Vec<String>,
}

impl Row {
    fn text(&self, name: &str) -> &str {
        self.inputs.get(name).unwrap_or_else(|| panic!("{} has no {name}", self.case))
    }
    fn input(&self, name: &str) -> f64 {
        self.text(name).parse().unwrap()
    }
    fn cell(&self, place: usize) -> f64 {
        self.cells[place].parse().unwrap()
    }
    fn material(&self) -> PlaneMaterial {
        let numbers: Vec<Vec<f64>> =
            self.text("material").split(';').map(|part| part.split(',').map(|number| number.parse().unwrap()).collect()).collect();
        let terms: Vec<_> = numbers[1..].iter().map(|pair| RelaxationTerm { modulus: pair[0], relaxation_time: pair[1] }).collect();
        PlaneMaterial::from_relaxation(numbers[0][0], &terms).unwrap()
    }
    fn profile(&self) -> Profile {
        match self.text("shape") {
            "cone" => Profile::Cone { slope: self.input("size") },
            _ => Profile::Paraboloid { radius: self.input("size") },
        }
    }
}

fn rows(name: &str) -> Vec<Row> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("reference_data").join(name)).unwrap();
    let (header, body) = text.split_at(text.find("case,").unwrap());
    let hash: String = Sha256::digest(body.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
    assert!(header.contains(&format!("# sha256: {hash}")), "the reference file was edited by hand");
    let read = |record: csv::StringRecord| Row {
        case: record[0].into(),
        inputs: record[1].split(' ').map(|pair| pair.split_once('=').map(|(key, value)| (key.into(), value.into())).unwrap()).collect(),
        cells: record.iter().skip(2).map(String::from).collect(),
    };
    csv::Reader::from_reader(body.as_bytes()).records().map(|record| read(record.unwrap())).collect()
}

/// Rows of the first file with a quantity: cells are quantity, place, value, digits.
fn asked(quantity: &str) -> Vec<Row> {
    let found: Vec<Row> = rows("indentation.csv").into_iter().filter(|row| row.cells[0] == quantity).collect();
    for row in &found {
        assert!(row.cells[3].parse::<u32>().unwrap() >= 20, "{} {quantity}: fewer than 20 digits agree", row.case);
    }
    found
}

#[test]
fn elliptic_kernel() {
    let found = asked("elliptic_k");
    let worst = found.iter().map(|row| (elliptic_k(row.input("m")) / row.cell(2) - 1.0).abs()).fold(0.0, f64::max);
    println!("{} values of K, worst {worst:.1e}", found.len());
    assert!(found.len() >= 10 && worst < 6e-16);
}

/// Pieces "lower|upper,c0,c1,…|…" as panels.
fn panels(text: &str) -> Vec<Panel> {
    let mut parts = text.split('|');
    let mut lower: f64 = parts.next().unwrap().parse().unwrap();
    parts
        .map(|part| {
            let numbers: Vec<f64> = part.split(',').map(|number| number.parse().unwrap()).collect();
            let panel = Panel::sampled(lower, numbers[0], |s| numbers[1..].iter().rev().fold(0.0, |sum, c| sum * s + c));
            lower = numbers[0];
            panel
        })
        .collect()
}

/// 1e-12: the product of two sums of some 1e2 numbers each; the window from a − δ to a + δ is cut in pieces of 8 nodes.
#[test]
fn closure_of_given_fields() {
    let found = asked("closure");
    let mut worst: f64 = 0.0;
    for row in &found {
        let kernel = Zone::new(row.input("a"), row.input("zone")).unwrap();
        let work = zone_work(&kernel, &panels(row.text("load")), &panels(row.text("factor")));
        let error = (work / row.cell(2) - 1.0).abs();
        println!("{:24} {work:.15e} off by {error:.1e}", row.case);
        worst = worst.max(error);
    }
    assert!(found.len() >= 12 && worst < 1e-12, "{worst:e}");
}

/// JKR at equal process zone to 1e-10, the number.
#[test]
fn elastic_contacts_at_a_finite_zone() {
    let (radii, forces) = (asked("contact_radius"), asked("force"));
    let mut worst: f64 = 0.0;
    for (a, force) in radii.iter().zip(&forces) {
        let (modulus, work, zone) = (a.input("modulus"), a.input("work"), a.input("zone"));
        let state = elastic_contact(&a.profile(), modulus, work, zone, a.input("penetration")).unwrap();
        // The force passes through zero: its scale is E*a times the penetration of the profile.
        let scale = modulus * a.cell(2) * a.profile().line(a.cell(2));
        let errors = [(state.contact_radius / a.cell(2) - 1.0).abs(), (state.force - force.cell(2)).abs() / scale];
        println!("{} {}: a off by {:.1e}, F by {:.1e}", a.text("shape"), a.input("penetration"), errors[0], errors[1]);
        worst = worst.max(errors[0]).max(errors[1]);
    }
    assert!(radii.len() >= 8 && worst < 1e-10, "{worst:e}");
}

fn solved(row: &Row, profile: Profile, adhesion: Option<Adhesion>, history: History, start: Start, accuracy: f64) -> IndentationSolution {
    let problem = IndentationProblem { start, instants_per_segment: 4, accuracy, ..IndentationProblem::new(profile, adhesion, history) };
    run(&row.material(), &problem).unwrap()
}

/// Up and down under an imposed edge: each value within its own error bound, and that bound within 1e-8 of the largest value.
#[test]
fn lee_radok_and_ting_by_their_integrals() {
    let mut cases: Vec<Row> = Vec::new();
    for quantity in ["advancing_force", "receding_force", "receding_penetration"] {
        cases.extend(asked(quantity));
    }
    let mut solutions: HashMap<String, IndentationSolution> = HashMap::new();
    let (mut worst, mut least) = (0.0_f64, 0.0_f64);
    for row in &cases {
        let solution = solutions.entry(row.case.clone()).or_insert_with(|| {
            let history =
                History::contact_radius(0.0).ramp(row.input("peak"), row.input("rise")).ramp(row.input("bottom"), row.input("fall"));
            solved(row, row.profile(), None, history, Start::Untouched, 1e-8)
        });
        let quarter: usize = row.cells[1].parse().unwrap();
        let offset = if row.cells[0].starts_with("receding") { 4 } else { 0 };
        let instant = solution.instants[quarter + offset];
        let (found, scale) = if row.cells[0].ends_with("force") {
            (instant.force, solution.instants.iter().fold(0.0, |most: f64, other| most.max(other.force.value)))
        } else {
            (instant.penetration, row.profile().line(row.input("peak")))
        };
        let error = (found.value - row.cell(2)).abs();
        println!("{:20} {:20} {quarter}: off by {:.1e} ± {:.1e}", row.case, row.cells[0], error / scale, found.error / scale);
        assert!(error <= found.error + 1e-12 * scale, "{} {} {quarter}: {error:e} above {:e}", row.case, row.cells[0], found.error);
        worst = worst.max(error / scale);
        least = least.max(found.error / scale);
    }
    println!("{} values, worst {worst:.1e}, widest bound {least:.1e}", cases.len());
    assert!(cases.len() >= 36 && least < 1e-8);
}

/// Every update is exact for a penetration that moves linearly in time: 1e-13.
#[test]
fn flat_punch_relaxes() {
    let found = asked("punch_force");
    for row in &found {
        let material = row.material();
        let springs = Springs::new(&material).unwrap();
        let (a, depth, rise) = (row.input("radius"), row.input("penetration"), row.input("rise"));
        let pressed = if rise == 0.0 {
            Contact::untouched(&springs, Profile::FlatPunch { radius: a }, a, depth).unwrap()
        } else {
            Contact::untouched(&springs, Profile::FlatPunch { radius: a }, a, 0.0).unwrap().moved(a, depth, rise, Sweep::Linear).unwrap()
        };
        let quarter: f64 = row.cells[1].parse().unwrap();
        let held = pressed.moved(a, depth, row.input("hold") * quarter / 4.0, Sweep::Linear).unwrap();
        let error = (held.force() / row.cell(2) - 1.0).abs();
        println!("{} {quarter}: off by {error:.1e}", row.case);
        assert!(error < 1e-13);
    }
    assert_eq!(found.len(), 6);
}

/// Cells are time, penetration, force, radius, digits. Each value within the solver's error bound plus the reference's own.
#[test]
fn adhesive_histories_by_passing_times() {
    let found = rows("indentation_march.csv");
    let mut solutions: HashMap<String, IndentationSolution> = HashMap::new();
    let (mut worst, mut beyond): (f64, Vec<String>) = (0.0, Vec::new());
    let ends: HashMap<String, f64> = found.iter().map(|row| (row.case.clone(), row.cell(0))).collect();
    for row in &found {
        let solution = solutions.entry(row.case.clone()).or_insert_with(|| {
            let (speed, depth, end) = (row.input("speed"), row.input("depth"), ends[&row.case]);
            let relaxed = row.text("kind") == "retraction";
            let last = if relaxed { depth - speed * end } else { speed * end };
            let history = History::penetration(depth).ramp(last, end);
            let adhesion = Adhesion { work_of_adhesion: row.input("work"), process_zone: row.input("zone") };
            let start = if relaxed { Start::Relaxed } else { Start::Untouched };
            solved(row, Profile::Paraboloid { radius: row.input("radius") }, Some(adhesion), history, start, 1e-6)
        });
        let quarter = (4.0 * row.cell(0) / ends[&row.case]).round() as usize;
        let instant = solution.instants[quarter];
        let scale = solution.instants.iter().fold(0.0, |most: f64, other| most.max(other.force.value.abs()));
        // The digits of the file are those in which its two finest grids agree.
        let own = 10.0_f64.powi(-row.cells[4].parse::<i32>().unwrap());
        let errors = [(instant.force.value - row.cell(2)).abs(), (instant.contact_radius.value - row.cell(3)).abs()];
        println!(
            "{:28} {quarter}: F off by {:.1e} ± {:.1e}, a by {:.1e} ± {:.1e} (reference {own:.0e})",
            row.case,
            errors[0] / scale,
            instant.force.error / scale,
            errors[1] / row.cell(3),
            instant.contact_radius.error / row.cell(3)
        );
        if errors[0] > instant.force.error + own * scale || errors[1] > instant.contact_radius.error + own * row.cell(3) {
            beyond.push(format!("{} {quarter}", row.case));
        }
        worst = worst.max(errors[0] / scale).max(errors[1] / row.cell(3));
    }
    println!("{} instants, worst {worst:.1e}", found.len());
    assert!(found.len() >= 24 && worst < 1e-6);
    assert!(beyond.is_empty(), "outside their own error bounds: {beyond:?}");
}
