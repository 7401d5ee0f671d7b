//! A scene with a law of attraction and an indenter gives what an independent program gives, in both systems of units.
//!
//! Source: `reference_data/finite_sphere.json`, eight histories computed by an independent prototype in another language; closed forms; the
//! balance of energy; the theory of an edge with a process zone, which shares nothing with this solver.
//! Goal: the way from a scene to the solver and back: units, zero of the penetration, controls, steps, bounds, energies, fields, refusals.
//! Parameters: Tabor numbers 0.35 to 3.2, one and three terms, every control, sphere, cone and power law.
//! Oracle: as under Source.
//! Tolerance: the stated errors of the source and our own bounds; otherwise with each test.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use serde_json::Value;
use std::f64::consts::PI;
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

fn refused(text: &str) -> String {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    read::read(&document).expect_err(text).rendered()
}

fn value(outcome: &Outcome, row: &Row, name: &str) -> Estimate {
    let column = outcome.columns.iter().position(|column| column.name == name).unwrap_or_else(|| panic!("no column {name}"));
    row.values[column].unwrap_or_else(|| panic!("no {name} in {row:?}"))
}

fn answer(outcome: &Outcome, name: &str) -> Estimate {
    value(outcome, &outcome.rows[0], name)
}

fn rows<'o>(outcome: &'o Outcome, label: &'o str) -> impl Iterator<Item = &'o Row> {
    outcome.rows.iter().filter(move |row| row.label(0) == label)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The range of the law in the radius of the sphere.
const RANGE: f64 = 1e-3;

/// A state of the source as a scene in reduced units: Δγ = (μ h₀)^{3/2} with R = E0* = 1, the unit of work πE0*R.
fn scene_of(input: &Value) -> String {
    let list = |key: &str| -> Vec<f64> { input[key].as_array().unwrap().iter().map(number).collect() };
    let terms: Vec<String> = list("creep_fractions")
        .iter()
        .zip(list("retardation_times"))
        .map(|(fraction, time)| format!("{{ fraction = {fraction:e}, retardation_time = {time:e} }}"))
        .collect();
    let work = (number(&input["mu"]) * RANGE).powf(1.5) / PI;
    let solid = if terms.is_empty() {
        String::new()
    } else {
        format!("glassy_modulus = {:e}\ncreep = [{}]\n", number(&input["beta"]), terms.join(", "))
    };
    let mut text = format!(
        "units = \"reduced\"\naccuracy = 1e-5\n[material]\n{solid}[adhesion]\nwork_of_adhesion = {work:e}\nlaw = \"lennard_jones\"\nrange = {RANGE:e}\n[indentation]\nsphere = {{}}\ninstants = 1\n"
    );
    let start = if input["start"] == "relaxed" { "relaxed" } else { "untouched" };
    text += &format!("start = \"{start}\"\npenetration = {:e}\n", RANGE * number(&input["start_penetration"]));
    let times: Vec<String> = list("instants").iter().map(|time| format!("{time:e}")).collect();
    if !times.is_empty() {
        text += &format!("[indentation.fields]\npoints = 2\ntimes = [{}]\n", times.join(", "));
    }
    for leg in input["history"].as_array().unwrap() {
        text += "[[history]]\n";
        text += &match leg["control"].as_str().unwrap() {
            "penetration" => format!("penetration = {:e}\nrate = {:e}\n", RANGE * number(&leg["to"]), RANGE * number(&leg["rate"])),
            "dwell" => format!("hold = {:e}\n", number(&leg["time"])),
            _ => format!("force = {:e}\nduration = {:e}\n", work * number(&leg["to"]), number(&leg["time"])),
        };
    }
    text
}

#[test]
fn the_states_of_an_independent_program_are_met_by_scenes() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../reference_data/finite_sphere.json");
    let all: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    for state in all["states"].as_array().unwrap() {
        let (input, result) = (&state["input"], &state["result"]);
        let outcome = solved(&scene_of(input));
        let name = &input["name"];
        let work = (number(&input["mu"]) * RANGE).powf(1.5) / PI;
        let stated = |key: &str| number(&state["error_estimates"][key]["mesh"]) + number(&state["error_estimates"][key]["time"]);
        let meets = |what: &str, ours: Estimate, theirs: f64, error: f64| {
            assert!((ours.value - theirs).abs() <= ours.error + error + 1e-11, "{name}: {what} = {ours:?}, expected {theirs} ± {error:e}");
        };
        if result["pull_off_force"].is_number() {
            meets("ratio", answer(&outcome, "pull_off_ratio"), number(&result["pull_off_over_jkr"]), stated("pull_off_over_jkr"));
            for (ours, theirs) in [("work_of_separation", "work_of_separation"), ("work_to_pull_off", "work_to_pull_off")] {
                let unit = work * RANGE;
                meets(ours, answer(&outcome, ours), unit * number(&result[theirs]), unit * stated(theirs));
            }
        }
        for (k, (theirs, row)) in result["at_instants"].as_array().unwrap().iter().zip(rows(&outcome, "fields")).enumerate() {
            assert!((value(&outcome, row, "time").value - number(&theirs["time"])).abs() < 1e-9 * number(&theirs["time"]));
            meets("force", value(&outcome, row, "force"), work * number(&theirs["force"]), work * stated(&format!("force_{k}")));
            let depth = RANGE * number(&theirs["penetration"]);
            meets("penetration", value(&outcome, row, "penetration"), depth, RANGE * stated(&format!("penetration_{k}")));
        }
        assert_eq!(rows(&outcome, "event").any(|row| row.label(1) == "detachment"), answer_ends(&outcome), "{name}");
    }
}

/// Whether the state says that its contact ended.
fn answer_ends(outcome: &Outcome) -> bool {
    let column = outcome.columns.iter().position(|column| column.name == "detachment_time").unwrap();
    outcome.rows[0].values[column].is_some()
}

/// A sphere of 5 µm on rubber, a range of 60 nm: Tabor numbers 3.2 and 0.69.
const RUBBER: &str = r#"
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.5
creep = [{ fraction = 1, retardation_time = "1 s" }]

[adhesion]
work_of_adhesion = "50 mJ/m²"
law = "lennard_jones"
range = "60 nm"

[indentation]
sphere = { radius = "5 µm" }
start = "relaxed"
penetration = "0.2 µm"
instants = 10
"#;

const PULLED: &str = "[[history]]\npenetration = \"-0.6 µm\"\nrate = \"1 µm/s\"\n";

#[test]
fn both_systems_of_units_hold_one_physics() {
    let si = solved(&format!("{RUBBER}{PULLED}"));
    let (modulus, radius) = (1e6 / 0.75, 5e-6);
    let reduced = solved(&format!(
        "units = \"reduced\"\n[material]\nglassy_modulus = 10\ncreep = [{{ fraction = 1, retardation_time = 1 }}]\n[adhesion]\nwork_of_adhesion = {:e}\nlaw = \"lennard_jones\"\nrange = 1.2e-2\n[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.04\ninstants = 10\n[[history]]\npenetration = -0.12\nrate = 0.2\n",
        0.05 / (PI * modulus * radius)
    ));
    for (name, unit) in [
        ("pull_off_ratio", 1.0),
        ("tabor_number", 1.0),
        ("pull_off_force", PI * modulus * radius * radius),
        ("work_of_separation", PI * modulus * radius.powi(3)),
        ("largest_radius", radius),
        ("detachment_penetration", radius),
        ("pull_off_time", 1.0),
    ] {
        let (one, other) = (answer(&si, name), answer(&reduced, name));
        let allowed = one.error + unit * other.error + 1e-9 * one.value.abs();
        assert!((one.value - unit * other.value).abs() <= allowed, "{name}: {one:?}, {other:?} × {unit}");
    }
}

#[test]
fn bounds_cover_what_a_far_finer_run_finds() {
    let dwell = "[[history]]\nforce = \"0.5 µN\"\nduration = \"1 s\"\n[[history]]\nhold = \"3 s\"\n[[history]]\npenetration = \"-0.6 µm\"\nduration = \"1 s\"\n";
    for history in [PULLED, dwell] {
        let [coarse, fine] =
            ["1e-3", "1e-5"].map(|accuracy| solved(&format!("accuracy = {accuracy}\n{RUBBER}[indentation.energies]\n{history}")));
        for (one, other) in rows(&coarse, "instant").zip(rows(&fine, "instant")).chain([(&coarse.rows[0], &fine.rows[0])]) {
            assert_eq!(one.status, Status::Solved);
            for ((column, a), b) in coarse.columns.iter().zip(&one.values).zip(&other.values) {
                // Counts and residuals are of one run; where a flat maximum lies, and what jumps lose, is soft and says so.
                let own = ["steps", "nodes", "residual", "energy_defect", "jump_loss", "released_energy"].contains(&column.name);
                let soft = column.name.starts_with("pull_off_") && !["pull_off_force", "pull_off_ratio"].contains(&column.name);
                if let (Some(a), Some(b), false) = (a, b, own || soft) {
                    assert!((a.value - b.value).abs() <= a.error + b.error, "{}: {a:?}, {b:?}", column.name);
                }
            }
        }
    }
}

#[test]
fn what_is_put_in_is_stored_lost_or_in_the_interface() {
    let outcome = solved(&format!("accuracy = 1e-4\n{RUBBER}[indentation.energies]\n{PULLED}"));
    let of = |row: &Row, name: &str| value(&outcome, row, name).value;
    let first = rows(&outcome, "instant").next().unwrap();
    let largest = rows(&outcome, "instant").map(|row| of(row, "external_work").abs()).fold(0.0, f64::max);
    for row in rows(&outcome, "instant") {
        let change = |name: &str| of(row, name) - of(first, name);
        let kept = change("stored_energy") + change("interface_energy") + of(row, "dissipated_energy") + of(row, "released_energy");
        assert!((of(row, "external_work") - kept).abs() < 1e-4 * largest, "{} {kept}", of(row, "external_work"));
    }
    assert!(answer(&outcome, "energy_defect").value < 1e-4);
    // The surfaces are apart at the end: the work of adhesion is paid for, and more by the memory.
    assert!(of(rows(&outcome, "instant").last().unwrap(), "dissipated_energy") > 0.0);
}

#[test]
fn a_force_at_the_start_is_that_of_its_penetration() {
    let by_depth = solved(&format!("accuracy = 1e-5\n{RUBBER}{PULLED}"));
    let first = rows(&by_depth, "instant").next().unwrap();
    let force = value(&by_depth, first, "force").value;
    let text = RUBBER.replace("penetration = \"0.2 µm\"", &format!("force = {force:e}"));
    let by_force = solved(&format!("accuracy = 1e-5\n{text}[[history]]\npenetration = \"-0.6 µm\"\nduration = \"0.8 s\"\n"));
    let start = value(&by_force, rows(&by_force, "instant").next().unwrap(), "penetration");
    assert!((start.value - 0.2e-6).abs() < 1e-5 * 0.2e-6, "{start:?}");
    let [one, other] = [&by_depth, &by_force].map(|outcome| answer(outcome, "pull_off_ratio"));
    assert!((one.value - other.value).abs() < 1e-4 * one.value, "{one:?} {other:?}");
}

#[test]
fn a_frame_moves_by_penetration_and_force() {
    let text = RUBBER.replace("instants = 10", "instants = 10\nframe_stiffness = \"2 N/m\"");
    let outcome = solved(&format!("{text}[[history]]\nframe = \"-3 µm\"\nduration = \"2 s\"\n"));
    let last = rows(&outcome, "instant").last().unwrap();
    let frame = value(&outcome, last, "frame_displacement");
    assert!((frame.value + 3e-6).abs() <= frame.error + 1e-12, "{frame:?}");
    let [depth, force] = ["penetration", "force"].map(|name| value(&outcome, last, name).value);
    assert!((depth + force / 2.0 + 3e-6).abs() < 1e-10);
}

#[test]
fn a_step_at_once_is_the_limit_of_quick_ramps() {
    let outcome = |history: &str| solved(&format!("accuracy = 1e-5\n{RUBBER}{history}[[history]]\nhold = \"2 s\"\n"));
    let sudden = outcome("[[history]]\npenetration = \"0.3 µm\"\n");
    let quick = outcome("[[history]]\npenetration = \"0.3 µm\"\nduration = \"1 ns\"\n");
    let [one, other] = [&sudden, &quick].map(|outcome| value(outcome, rows(outcome, "instant").last().unwrap(), "force"));
    assert!((one.value - other.value).abs() <= one.error + other.error + 1e-8 * one.value.abs(), "{one:?} {other:?}");
    let times: Vec<f64> = rows(&sudden, "instant").map(|row| value(&sudden, row, "time").value).collect();
    assert!(times[0] == 0.0 && times[1] == 0.0 && times[2] > 0.0, "{times:?}");
}

#[test]
fn the_pressure_carries_the_force_and_the_gap_is_that_of_both_surfaces() {
    let fields = "[indentation.fields]\ntimes = [\"0.05 s\", \"0.2 s\"]\nto = \"8 µm\"\npoints = 4001\n";
    let outcome = solved(&format!("accuracy = 1e-4\n{RUBBER}{fields}{PULLED}"));
    for row in rows(&outcome, "fields") {
        let depth = value(&outcome, row, "penetration").value;
        let mut force = 0.0;
        for pair in row.fields.windows(2) {
            let of = |point: &viscotack_program::outcome::FieldPoint| point.values[1].value * point.place;
            force += PI * (of(&pair[0]) + of(&pair[1])) * (pair[1].place - pair[0].place);
        }
        // Outside of 8 µm the gap is r²/2R: the attraction left there is less than 1e-3 of the force.
        let expected = value(&outcome, row, "force").value;
        assert!((force - expected).abs() < 3e-3 * expected.abs().max(1e-6), "{force} {expected}");
        for point in &row.fields {
            let [displacement, gap] = [2, 3].map(|k| point.values[k].value);
            let shape = point.place * point.place / (2.0 * 5e-6);
            assert!((gap - (60e-9 + shape - depth + displacement)).abs() < 1e-13, "{gap} at {}", point.place);
        }
    }
}

#[test]
fn cones_and_powers_are_the_shapes_they_are_called() {
    // r²/(2R) as a power law, and a cone as a power law of exponent one, in other keys.
    let sphere = solved(&format!("accuracy = 1e-4\n{RUBBER}{PULLED}"));
    let power = RUBBER.replace("sphere = { radius = \"5 µm\" }", "power_law = { radius = \"5 µm\", exponent = 2 }");
    let power = solved(&format!("accuracy = 1e-4\n{power}{PULLED}"));
    let of = |outcome: &Outcome, name: &str| answer(outcome, name);
    for name in ["pull_off_force", "work_of_separation", "largest_radius", "tabor_number"] {
        let (one, other) = (of(&sphere, name), of(&power, name));
        assert!((one.value - other.value).abs() <= one.error + other.error + 1e-9 * one.value.abs(), "{name}: {one:?} {other:?}");
    }
    let [cone, one] = ["cone = { slope = 1 }", "power_law = { radius = \"5 µm\", exponent = 1 }"]
        .map(|shape| solved(&format!("accuracy = 1e-4\n{}{PULLED}", RUBBER.replace("sphere = { radius = \"5 µm\" }", shape))));
    for name in ["pull_off_force", "largest_radius"] {
        let (a, b) = (of(&cone, name), of(&one, name));
        assert!((a.value - b.value).abs() <= a.error + b.error + 1e-9 * a.value.abs(), "{name}: {a:?} {b:?}");
    }
}

#[test]
fn a_punch_with_constant_tension_follows_its_closed_form() {
    // Maugis' zone of constant tension σ on a flat face: c from Δ = −(2σ/E*)√(a² − c²), F = −2σ(c√(a² − c²) + a² arccos(c/a)).
    let (radius, modulus, tension) = (2e-6_f64, 2.4e6 / 0.75, 1.25e6);
    let scene = "accuracy = 1e-3\n[material]\nrelaxed_modulus = \"2.4 MPa\"\npoisson_ratio = 0.5\n[adhesion]\nwork_of_adhesion = \"0.5 J/m²\"\nlaw = \"dugdale\"\nramp = 0.1\npeak_stress = \"1.25 MPa\"\n[indentation]\nflat_punch = { radius = \"2 µm\" }\nstart = \"relaxed\"\npenetration = \"0.1 µm\"\ninstants = 8\n[[history]]\npenetration = \"-1 µm\"\nrate = \"1 µm/s\"\n";
    let outcome = solved(scene);
    let mut compared = 0;
    for row in rows(&outcome, "instant") {
        let depth = value(&outcome, row, "penetration").value;
        let root = -depth * modulus / (2.0 * tension);
        let expected = if root <= 0.0 {
            2.0 * radius * modulus * depth
        } else if root < 0.9 * radius {
            let contact = (radius * radius - root * root).sqrt();
            let opening = 4.0 * tension / (PI * modulus) * (root * (contact / radius).acos() - radius + contact);
            if opening > 0.9 * 0.4e-6 {
                continue;
            }
            -2.0 * tension * (contact * root + radius * radius * (contact / radius).acos())
        } else {
            continue;
        };
        let force = value(&outcome, row, "force");
        assert!((force.value - expected).abs() <= force.error, "{depth:e}: {force:?} {expected:e}");
        assert!(force.error < 5e-3 * expected.abs(), "{force:?}");
        compared += 1;
    }
    assert!(compared >= 5, "{compared}");
}

#[test]
fn a_profile_of_a_sphere_is_the_sphere_and_a_rim_holds_less() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..61).map(|k| 0.5 * f64::from(k)).map(|r| format!("{r}, {}\n", r * r / 10.0)).collect();
    std::fs::write(folder.path().join("sphere.csv"), format!("r (µm), z (µm)\n{rows}")).unwrap();
    let with = |shape: &str| {
        let text = format!("accuracy = 1e-4\n{}{PULLED}", RUBBER.replace("sphere = { radius = \"5 µm\" }", shape));
        let path = folder.path().join("scene.toml");
        std::fs::write(&path, text).unwrap();
        let mut document = Document::load(&path).unwrap();
        read::resolve_includes(&mut document).unwrap();
        let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
        plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
    };
    let sphere = with("sphere = { radius = \"5 µm\" }");
    let profile = with("profile = \"sphere.csv\"");
    for name in ["pull_off_force", "work_of_separation", "largest_radius", "tabor_number"] {
        let (one, other) = (answer(&sphere, name), answer(&profile, name));
        assert!((one.value - other.value).abs() <= one.error + other.error + 1e-9 * one.value.abs(), "{name}: {one:?} {other:?}");
    }
    let beyond = profile.validity.iter().any(|entry| entry.name.contains("beyond the last row"));
    assert!(beyond, "{:?}", profile.validity);
    let rimmed = with("sphere = { radius = \"5 µm\" }\nrim_radius = \"0.4 µm\"");
    let [free, held] = [&sphere, &rimmed].map(|outcome| answer(outcome, "pull_off_force").value);
    assert!(held < 0.8 * free && answer(&rimmed, "largest_radius").value <= 0.4e-6 * (1.0 + 1e-9), "{held:e} {free:e}");
}

#[test]
fn a_short_range_tends_to_the_theory_of_an_edge() {
    // The process zone is Dugdale's length (π²/4)a₀ of the same peak: with shorter ranges both theories come together.
    let pull = "[[history]]\npenetration = \"-1 µm\"\nrate = \"10 µm/s\"\n";
    let off = |range: f64| {
        let (modulus, peak) = (1e6 / 0.75, 16.0 / (9.0 * 3_f64.sqrt()) * 0.05 / range);
        let zone = 0.25 * PI * modulus * 0.05 / (peak * peak);
        let ranged = RUBBER.replace("range = \"60 nm\"", &format!("range = {range:e}"));
        let law = "law = \"lennard_jones\"\nrange = \"60 nm\"";
        let sharp = RUBBER.replace(law, &format!("process_zone = {{ length = {zone:e} }}"));
        let [ranged, sharp] = [ranged, sharp].map(|text| answer(&solved(&format!("{text}{pull}")), "pull_off_ratio").value);
        (ranged / sharp - 1.0).abs()
    };
    let (long, short) = (off(60e-9), off(15e-9));
    assert!(short < 0.15 && short < 0.6 * long, "{long} {short}");
}

#[test]
fn a_law_with_a_hard_wall_is_solved_and_its_bounds_hold() {
    let shallow = PULLED.replace("-0.6 µm", "-0.4 µm");
    let text = RUBBER.replace("law = \"lennard_jones\"", "law = \"dugdale\"\nramp = 0.2").replace("instants = 10", "instants = 2");
    let [coarse, fine] = ["1e-2", "1e-3"].map(|accuracy| solved(&format!("accuracy = {accuracy}\n{text}{shallow}")));
    for name in ["pull_off_ratio", "end_force", "largest_radius", "work_of_separation"] {
        let (a, b) = (answer(&coarse, name), answer(&fine, name));
        assert!((a.value - b.value).abs() <= a.error + b.error, "{name}: {a:?} {b:?}");
    }
    assert!(answer(&fine, "energy_defect").value < 1e-3);
    // Maugis' closed form holds the other end: `finite_range::sphere`.
}

#[test]
fn what_is_not_solved_is_refused_with_a_remedy() {
    let scene = format!("{RUBBER}{PULLED}");
    for (from, to, says) in [
        ("penetration = \"0.2 µm\"", "contact_radius = \"1 µm\"", ["indentation.contact_radius", "indentation.penetration"]),
        (
            "penetration = \"-0.6 µm\"\nrate = \"1 µm/s\"",
            "contact_radius = \"1 µm\"\nduration = 1",
            ["contact_radius", "control penetration"],
        ),
        ("range = \"60 nm\"", "range = \"60 nm\"\ninteraction_range = \"1 nm\"", ["interaction_range", "leave it out"]),
        (
            "penetration = \"-0.6 µm\"\nrate = \"1 µm/s\"",
            "oscillation = { quantity = \"penetration\", amplitude = 1e-8, frequency = 1, cycles = 9, until_stationary = true }",
            ["until_stationary", "cycles = 20"],
        ),
    ] {
        let message = refused(&scene.replacen(from, to, 1));
        assert!(says.iter().all(|words| message.contains(words)), "{message}");
    }
}
