//! Rows of cycles of an indenter with a law of attraction.
//!
//! Contract: `[[history]]` with `oscillation` and `adhesion.law`; the columns of the theory of an edge.
//! Goal: stiffness, loss, work and extremes with bounds that hold, in both systems of units; figures and counts of rows as with an edge.
//! Parameters: a sphere of 5 µm on rubber, ranges of 8 to 60 nm, amplitudes of 0.5 to 300 nm, moduli other than 1.
//! Oracle: elastic states at rest by Chebyshev's rule; 2a|E*(ω)| by the complex modulus; the theory of an edge; a far finer run.
//! Tolerance: the bounds of the rows; otherwise with each test.
#![allow(clippy::float_cmp, clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::f64::consts::{PI, TAU};
use std::path::Path;
use viscotack::Estimate;
use viscotack_program::outcome::{Outcome, Row, Status};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

fn solved(text: &str) -> Outcome {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
}

fn cell(outcome: &Outcome, row: &Row, name: &str) -> Option<Estimate> {
    let column = outcome.columns.iter().position(|column| column.name == name).unwrap_or_else(|| panic!("no column {name}"));
    row.values[column]
}

fn value(outcome: &Outcome, row: &Row, name: &str) -> Estimate {
    cell(outcome, row, name).unwrap_or_else(|| panic!("no {name} in {row:?}"))
}

fn cycles(outcome: &Outcome) -> Vec<&Row> {
    outcome.rows.iter().filter(|row| row.label(0) == "cycle").collect()
}

const SOLID: &str = "glassy_modulus = \"10 MPa\"\ncreep = [{ fraction = 1, retardation_time = \"1 s\" }]\n";
const LAW: &str = "law = \"lennard_jones\"\nrange = \"60 nm\"";

fn scene(accuracy: &str, solid: &str, law: &str, rest: &str) -> String {
    format!(
        "accuracy = {accuracy}\n[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\n{solid}[adhesion]\nwork_of_adhesion = \"50 mJ/m²\"\n{law}\n[indentation]\nsphere = {{ radius = \"5 µm\" }}\nstart = \"relaxed\"\ninstants = 1\n{rest}"
    )
}

fn swing(start: &str, oscillation: &str) -> String {
    format!("{start}\n[[history]]\noscillation = {{ {oscillation} }}\n")
}

/// The range of which Dugdale's zone of the same peak is so long, and that zone.
fn zone(range: f64) -> String {
    let peak = 16.0 / (9.0 * 3_f64.sqrt()) * 0.05 / range;
    format!("process_zone = {{ length = {:e} }}", 0.25 * PI * 1e6 / 0.75 * 0.05 / (peak * peak))
}

const QUANTITIES: [&str; 11] = [
    "frequency",
    "work_per_cycle",
    "storage_stiffness",
    "loss_stiffness",
    "phase",
    "smallest_penetration",
    "largest_penetration",
    "smallest_force",
    "largest_force",
    "smallest_contact_radius",
    "largest_contact_radius",
];

/// An elastic body gives back all that it takes, and its stiffness is the fundamental of the force at rest: (2/πA)∫F(Δ + A cos θ) cos θ dθ over half a
/// cycle, by twelve states that are solved each on its own.
#[test]
fn an_elastic_body_loses_nothing_and_has_the_stiffness_of_its_states_at_rest() {
    let (depth, amplitude, count) = (0.2e-6, 40e-9, 12);
    let outcome = solved(&scene(
        "1e-4",
        "",
        LAW,
        &swing(
            &format!("penetration = {depth:e}"),
            &format!("quantity = \"penetration\", amplitude = {amplitude:e}, frequency = 3, cycles = 2"),
        ),
    ));
    let (mut stiffness, mut error) = (0.0, 0.0);
    for k in 0..count {
        let cosine = ((f64::from(k) + 0.5) * PI / f64::from(count)).cos();
        let at_rest = scene("1e-6", "", LAW, &format!("penetration = {:e}\n[[history]]\nhold = 1\n", depth + amplitude * cosine));
        let rest = solved(&at_rest);
        let force = value(&rest, &rest.rows[0], "end_force");
        stiffness += 2.0 * force.value * cosine / (f64::from(count) * amplitude);
        error += 2.0 * force.error / (f64::from(count) * amplitude);
    }
    let rows = cycles(&outcome);
    assert_eq!(rows.len(), 2);
    for row in rows {
        assert!(row.status == Status::Solved, "{row:?}");
        let [storage, loss, work] = ["storage_stiffness", "loss_stiffness", "work_per_cycle"].map(|name| value(&outcome, row, name));
        println!("{storage:?} of {stiffness} ± {error:e}, {loss:?}, {work:?}");
        assert!((storage.value - stiffness).abs() <= storage.error + error && storage.error < 1e-4 * stiffness);
        assert!(loss.value.abs() <= loss.error && work.value.abs() <= work.error);
        assert!(work.error < 1e-4 * PI * stiffness * amplitude * amplitude);
        for (name, exact) in [("smallest_penetration", depth - amplitude), ("largest_penetration", depth + amplitude), ("frequency", 3.0)] {
            let found = value(&outcome, row, name);
            assert!((found.value - exact).abs() <= found.error.max(1e-12 * exact), "{name}: {found:?}");
        }
    }
}

/// A small oscillation about a contact whose radius stays: 2a|E*(ω)| with the complex modulus 1/J*, the nearer the shorter the range; and what the theory of
/// an edge says of the same history.
#[test]
fn a_short_range_tends_to_the_complex_modulus_and_to_the_theory_of_an_edge() {
    let (relaxed, frequency) = (1e6 / 0.75, 0.5);
    let history = swing("penetration = \"0.2 µm\"", "quantity = \"penetration\", amplitude = \"0.5 nm\", frequency = 0.5, cycles = 8");
    let (re, im) = (0.1 + 0.9 / (1.0 + (TAU * frequency).powi(2)), -0.9 * TAU * frequency / (1.0 + (TAU * frequency).powi(2)));
    let square = re * re + im * im;
    let off = |range: f64| {
        let law = format!("law = \"lennard_jones\"\nrange = {range:e}");
        let outcome = solved(&scene("1e-3", SOLID, &law, &history));
        let state = &outcome.rows[0];
        let of = |outcome: &Outcome| ["storage_stiffness", "loss_stiffness"].map(|name| value(outcome, &outcome.rows[0], name).value);
        let [storage, loss] = of(&outcome);
        let rigid = 2.0 * value(&outcome, state, "end_radius").value * relaxed / square;
        let sharp = solved(&scene("1e-3", SOLID, &zone(range), &history));
        let [edge_storage, edge_loss] = of(&sharp);
        assert!(state.status == Status::Solved, "{state:?}");
        let size = rigid * square.sqrt();
        [(storage - rigid * re).hypot(loss + rigid * im) / size, (storage - edge_storage).hypot(loss - edge_loss) / size]
    };
    let [long, middle, short] = [60e-9, 25e-9, 8e-9].map(off);
    println!("{long:?} {middle:?} {short:?}");
    assert!(short[0] < 2e-3 && short[0] < 0.5 * middle[0] && middle[0] < 0.5 * long[0], "{long:?} {middle:?} {short:?}");
    assert!(short[1] < 5e-3 && short[1] < middle[1] && middle[1] < long[1], "{long:?} {middle:?} {short:?}");
}

/// Counts, ends and frequencies of cycles are those of the theory of an edge, with a frequency that goes up, a phase and a rest of a cycle; the names of columns and
/// figures as well.
#[test]
fn cycles_are_counted_as_with_an_edge() {
    let history = "penetration = \"0.2 µm\"\nspeed_factor = 2\n[[history]]\npenetration = \"0.25 µm\"\nduration = 1
[[history]]\noscillation = { quantity = \"penetration\", amplitude = \"5 nm\", frequency = 0.5, to_frequency = 2, frequency_sweep = \"logarithmic\", duration = 3.1, phase = 1, to = \"0.22 µm\" }
[[history]]\noscillation = { quantity = \"penetration\", amplitude = \"2 nm\", frequency = 1, cycles = 3 }\n";
    let [ranged, sharp] = [LAW.to_owned(), zone(60e-9)].map(|law| solved(&scene("1e-3", SOLID, &law, history)));
    let (ours, theirs) = (cycles(&ranged), cycles(&sharp));
    assert!(ours.len() == theirs.len() && ours.len() > 5, "{} {}", ours.len(), theirs.len());
    for (one, other) in ours.iter().zip(&theirs) {
        for name in ["time", "segment", "cycle", "cycle_start", "frequency"] {
            let [one, other] = [value(&ranged, one, name).value, value(&sharp, other, name).value];
            assert!((one - other).abs() <= 1e-12 * other.abs(), "{name}: {one} {other}");
        }
        // The first cycle has none before it; the last of one frequency says how all differ.
        for name in ["drift", "spread"] {
            assert_eq!(cell(&ranged, one, name).is_some(), cell(&sharp, other, name).is_some(), "{name}");
        }
    }
    let meanings = |outcome: &Outcome| {
        let of_cycles = outcome.columns.iter().skip_while(|column| column.name != "segment").take(16);
        of_cycles.map(|column| (column.name, column.unit.clone(), column.meaning)).collect::<Vec<_>>()
    };
    assert_eq!(meanings(&ranged), meanings(&sharp));
    let figures = |outcome: &Outcome| {
        let of_cycles = |name: &&String| name.starts_with("stiffness") || name.starts_with("work_per") || name.starts_with("last");
        outcome.figures.iter().map(|(name, _)| name).filter(of_cycles).cloned().collect::<Vec<_>>()
    };
    assert!(figures(&ranged) == figures(&sharp) && figures(&ranged).len() >= 2, "{:?}", figures(&ranged));
    let states = |outcome: &Outcome| value(outcome, &outcome.rows[0], "loss_stiffness").value;
    assert_eq!(states(&ranged), value(&ranged, ours.last().unwrap(), "loss_stiffness").value);
}

/// Large and tiny swings, under every control, with contacts that open and close in each cycle and with a hard wall: a far finer run lies within the bounds.
#[test]
fn bounds_of_cycles_cover_what_a_far_finer_run_finds() {
    let walled = "law = \"dugdale\"\nramp = 0.2\nrange = \"60 nm\"";
    let cases = [
        (
            LAW,
            "1e-3",
            "1e-6",
            "penetration = \"0.2 µm\"",
            "quantity = \"penetration\", amplitude = \"0.5 nm\", frequency = 0.5, cycles = 3",
        ),
        (
            LAW,
            "1e-3",
            "1e-5",
            "penetration = \"0.1 µm\"",
            "quantity = \"penetration\", amplitude = \"0.4 µm\", frequency = 0.3, cycles = 2",
        ),
        (LAW, "1e-3", "1e-6", "force = 0", "quantity = \"force\", amplitude = \"0.5 µN\", frequency = 2, cycles = 3, phase = 1"),
        (
            LAW,
            "1e-2",
            "1e-5",
            "frame_stiffness = 20\npenetration = \"0.1 µm\"\n[[history]]\nframe = \"0.1 µm\"\nduration = 1",
            "quantity = \"frame\", amplitude = \"60 nm\", frequency = 0.1, cycles = 2",
        ),
        (
            walled,
            "1e-2",
            "1e-3",
            "penetration = \"0.2 µm\"",
            "quantity = \"penetration\", amplitude = \"20 nm\", frequency = 0.5, cycles = 2",
        ),
    ];
    let two_terms =
        "glassy_modulus = \"3.3 MPa\"\ncreep = [{ fraction = 0.6, retardation_time = 3.5 }, { fraction = 0.4, retardation_time = 0.35 }]\n";
    let cases = cases.map(|(law, accuracy, finer, start, oscillation)| (SOLID, law, accuracy, finer, start, oscillation));
    // Steps that shrink before a jump, behind a step that is far longer; a transient that no tolerance of a step sees.
    let hard = [
        (
            two_terms,
            "law = \"lennard_jones\"\nrange = 1.147775e-07",
            "1e-4",
            "1e-6",
            "penetration = 5.66e-8",
            "quantity = \"penetration\", amplitude = 3.386e-7, frequency = 0.0556, cycles = 1, phase = 1.3",
        ),
        (
            two_terms,
            "law = \"lennard_jones\"\nrange = 2.66e-7",
            "1e-3",
            "1e-6",
            "force = 3.32e-7",
            "quantity = \"force\", amplitude = 1.5e-10, frequency = 0.078, cycles = 3, phase = 1.3",
        ),
    ];
    for (solid, law, accuracy, finer, start, oscillation) in cases.into_iter().chain(hard) {
        let [coarse, fine] = [accuracy, finer].map(|accuracy| solved(&scene(accuracy, solid, law, &swing(start, oscillation))));
        let (ours, theirs) = (cycles(&coarse), cycles(&fine));
        assert!(ours.len() == theirs.len() && !ours.is_empty(), "{oscillation}");
        for (one, other) in ours.iter().zip(&theirs) {
            for name in QUANTITIES.into_iter().chain(["drift"]) {
                let (Some(a), Some(b)) = (cell(&coarse, one, name), cell(&fine, other, name)) else { continue };
                assert!((a.value - b.value).abs() <= a.error + b.error, "{oscillation}: {name} = {a:?}, {b:?}");
                println!("{oscillation}: {name} {:.1e} ± {:.1e}", (a.value - b.value) / b.value, a.error / b.value);
            }
        }
    }
}

/// R = 5 µm, E0* = 4/3 MPa, τ = 0.3 s: the same oscillation of the force in reduced units.
#[test]
fn si_and_reduced_cycles_at_a_distance_are_one() {
    let (radius, modulus, time) = (5e-6, 1e6 / 0.75, 0.3);
    let force = PI * modulus * radius * radius;
    let si = solved(&scene(
        "1e-3",
        "glassy_modulus = \"10 MPa\"\ncreep = [{ fraction = 1, retardation_time = \"0.3 s\" }]\n",
        LAW,
        &swing("penetration = \"0.2 µm\"", "quantity = \"penetration\", amplitude = \"10 nm\", frequency = 1.5, cycles = 3"),
    ));
    let reduced = solved(&format!(
        "units = \"reduced\"\naccuracy = 1e-3\n[material]\nglassy_modulus = 10\ncreep = [{{ fraction = 1, retardation_time = 1 }}]\n[adhesion]\nwork_of_adhesion = {:e}\nlaw = \"lennard_jones\"\nrange = 1.2e-2\n[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.04\ninstants = 1\n[[history]]\noscillation = {{ quantity = \"penetration\", amplitude = 0.002, frequency = 0.45, cycles = 3 }}\n",
        0.05 / (PI * modulus * radius)
    ));
    let units = [1.0 / time, force * radius, force / radius, force / radius, 1.0, radius, radius, force, force, radius, radius];
    let (first, second) = (cycles(&reduced), cycles(&si));
    assert_eq!((first.len(), second.len()), (3, 3));
    for (one, other) in first.iter().zip(second) {
        for (name, unit) in QUANTITIES.into_iter().zip(units) {
            let (left, right) = (value(&reduced, one, name).scaled(unit), value(&si, other, name));
            // Rounding of the units lets steps differ, but by no more than the bounds.
            assert!((left.value - right.value).abs() <= left.error + right.error + 1e-9 * left.value.abs(), "{name}: {left:?} {right:?}");
        }
    }
}

/// Of many cycles some are rows, as with an edge.
#[test]
fn many_cycles_at_a_distance_are_thinned() {
    let outcome = solved(&scene(
        "1e-2",
        "",
        LAW,
        &swing("penetration = \"0.2 µm\"", "quantity = \"penetration\", amplitude = \"1 nm\", frequency = 3, cycles = 2100"),
    ));
    let rows = cycles(&outcome);
    let numbers: Vec<f64> = rows.iter().map(|row| value(&outcome, row, "cycle").value).collect();
    assert!(rows.len() == 2000 && numbers[0] == 1.0 && numbers[1999] == 2100.0, "{}", rows.len());
    // A body without memory repeats itself.
    let [drift, spread] = ["drift", "spread"].map(|name| value(&outcome, rows[1999], name));
    assert!(drift.value <= drift.error && spread.value <= spread.error, "{drift:?} {spread:?}");
}
