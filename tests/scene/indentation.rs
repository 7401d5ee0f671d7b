//! An indentation scene gives what the library gives, in the units of the scene.
//!
//! Contract: `[indentation]`, `[[history]]`, `[adhesion]` of the catalogue; theory 4.
//! Goal: rows, events, largest tension, fields and the measured overlay are those of the integration; one physics in reduced and in SI units; every shape.
//! Parameters: the thesis's chapter 4 (γ̃ = 1.6e-4, δ̃ = 0.013, β = 10, point B at Δ̃ = 0.032).
//! Oracle: [`viscotack::indentation::run`] with numbers written here; the printed state B; the force as the integral of the pressure; shapes that coincide.
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use std::path::Path;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, run};
use viscotack_program::outcome::{Outcome, Row, Status};
use viscotack_program::plan;
use viscotack_program::scene::diagnostic::SourceText;
use viscotack_program::scene::{Document, read};

const REDUCED: &str =
    "units = \"reduced\"\naccuracy = 1e-4\n[material]\nglassy_modulus = 10\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]\n
[adhesion]\nwork_of_adhesion = 1.6e-4\nprocess_zone = { length = 0.013 }\n";

fn solved(text: &str) -> Outcome {
    solved_with(text, [("measured.csv", "time,penetration,force\n0,0.032,0.5\n1,0.030,0.1\n2,0.029,\n".to_owned())])
}

fn solved_with(text: &str, [(name, table)]: [(&str, String); 1]) -> Outcome {
    let mut document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    document.attach(name, SourceText::new(name, table));
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
}

fn column(outcome: &Outcome, name: &str) -> usize {
    outcome.columns.iter().position(|column| column.name == name).unwrap_or_else(|| panic!("no column {name}"))
}

fn value(outcome: &Outcome, row: &Row, name: &str) -> f64 {
    row.value(column(outcome, name)).unwrap_or_else(|| panic!("no {name} in {row:?}"))
}

fn instants(outcome: &Outcome) -> Vec<&Row> {
    outcome.rows.iter().filter(|row| row.label(0) == "instant").collect()
}

fn event<'o>(outcome: &'o Outcome, name: &str) -> &'o Row {
    outcome.rows.iter().find(|row| row.label(1) == name).unwrap_or_else(|| panic!("no {name}"))
}

/// Forces in πE0*R², lengths in R: the printed state B, and each row as the library has it.
#[test]
fn retraction_in_reduced_units_is_that_of_the_solver() {
    let outcome = solved(&format!(
        "{REDUCED}[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.032\ninstants = 6\n[[history]]\npenetration = -0.04\nrate = 0.002\n"
    ));
    let adhesion = Adhesion { work_of_adhesion: 1.6e-4 * PI, process_zone: 0.013 };
    let history = (1..=6).fold(History::penetration(0.032), |history, k| history.ramp(0.032 - 0.072 * f64::from(k) / 6.0, 6.0));
    let problem = IndentationProblem {
        accuracy: 1e-4,
        ..IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history).relaxed()
    };
    let direct = run(&PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap(), &problem).unwrap();
    let rows = instants(&outcome);
    assert_eq!(rows.len(), direct.instants.len());
    for (row, instant) in rows.iter().zip(&direct.instants) {
        assert!(row.status == Status::Solved, "{row:?}");
        // Both are within their bounds of the truth.
        let bar = 2.0 * instant.force.error / PI + 1e-12;
        assert!((value(&outcome, row, "time") - instant.time).abs() < 1e-9);
        assert!((value(&outcome, row, "force") - instant.force.value / PI).abs() <= bar);
        assert!(
            (value(&outcome, row, "contact_radius") - instant.contact_radius.value).abs() <= 2.0 * instant.contact_radius.error + 1e-12
        );
    }
    // Thesis Sec 4.5: ã_B = 0.24515, F̃_B = 1.868e-3.
    assert!((value(&outcome, rows[0], "contact_radius") - 0.24515).abs() < 5e-6);
    assert!((value(&outcome, rows[0], "force") - 1.868e-3).abs() < 5e-7);
    let pull_off = event(&outcome, "largest_tension");
    let ratio = value(&outcome, pull_off, "pull_off_ratio");
    // F_JKR = (3/2)πRΔγ, which is (3/2)πγ̃ in πE0*R².
    assert!((ratio + value(&outcome, pull_off, "force") / (1.5 * PI * 1.6e-4)).abs() < 1e-12 * ratio);
    assert!((ratio - direct.pull_off_force().unwrap().value / (1.5 * PI * PI * 1.6e-4)).abs() < 1e-3 * ratio);
    let detached = event(&outcome, "detachment");
    assert!((value(&outcome, detached, "time") - direct.events[0].time.value).abs() < 1e-3);
    // The answer stands first, then what lies on the way, in order.
    assert_eq!(outcome.rows[0].label(0), "summary");
    assert!(outcome.rows[1..].windows(2).all(|pair| value(&outcome, &pair[0], "time") <= value(&outcome, &pair[1], "time")));
}

/// R = 2.5 mm, E0* = 0.8 MPa, ρ = 0.3 s: the same history in SI, within the error bounds of both.
#[test]
fn si_and_reduced_scenes_are_one() {
    let history = "[[history]]\npenetration = 0.02\nduration = 5\n[[history]]\nhold = 3\n[[history]]\nforce = -0.0005\nduration = 2\n";
    let reduced = solved(&format!("{REDUCED}[indentation]\nsphere = {{}}\ninstants = 4\nframe_stiffness = 0.4\n{history}"));
    let (radius, modulus, time) = (2.5e-3, 0.8e6, 0.3);
    let nu = 0.3_f64;
    let young = modulus * (1.0 - nu * nu);
    let si = solved(&format!(
        "accuracy = 1e-4\n[material]\nrelaxed_modulus = {young:e}\nglassy_modulus = {:e}\npoisson_ratio = {nu}\nrelaxation = [{{ fraction = 1, relaxation_time = {time} }}]\n
[adhesion]\nwork_of_adhesion = {:e}\nprocess_zone = {{ length = {:e} }}\n[indentation]\nsphere = {{ radius = {radius} }}\ninstants = 4\nframe_stiffness = {:e}\n
[[history]]\npenetration = {:e}\nduration = {:e}\n[[history]]\nhold = {:e}\n[[history]]\nforce = {:e}\nduration = {:e}\n",
        10.0 * young,
        1.6e-4 * PI * modulus * radius,
        0.013 * radius,
        0.4 * PI * modulus * radius,
        0.02 * radius,
        5.0 * time,
        3.0 * time,
        -0.0005 * PI * modulus * radius * radius,
        2.0 * time,
    ));
    // Instants that the history names; those inside the last ramp are steps of each integration's own.
    let named = |outcome: &Outcome, unit: f64| -> Vec<Row> {
        let own = |row: &&Row| {
            row.label(0) == "instant" && value(outcome, row, "time") > 8.0 * unit + 1e-9 && value(outcome, row, "time") < 9.99 * unit
        };
        outcome.rows.iter().filter(|row| row.label(0) != "summary" && !own(row)).cloned().collect()
    };
    let (first, second) = (named(&reduced, 1.0), named(&si, time));
    assert!(first.len() >= 10 && first.len() == second.len());
    for (one, other) in first.iter().zip(&second) {
        assert_eq!(one.labels, other.labels);
        for (name, unit) in
            [("penetration", radius), ("force", PI * modulus * radius * radius), ("contact_radius", radius), ("frame_displacement", radius)]
        {
            let place = column(&reduced, name);
            let [left, right] = [one.values[place].unwrap().scaled(unit), other.values[place].unwrap()];
            // Steps are chosen by rounded numbers, so that the two integrations are not the same to the last bit: each is within its own bound.
            assert!(
                (left.value - right.value).abs() <= left.error + right.error + 1e-9 * left.value.abs(),
                "{:?} {name}: {left:?} {right:?}",
                one.labels
            );
        }
        let frame = value(&reduced, one, "penetration") + value(&reduced, one, "force") / 0.4;
        assert!((value(&reduced, one, "frame_displacement") - frame).abs() < 1e-12);
    }
    assert!((value(&reduced, instants(&reduced).last().unwrap(), "force") + 0.0005).abs() < 1e-9);
}

/// 2π∫p r dr is F; inside the contact the surface is the indenter; both within the fields' own bounds, 1e-3.
#[test]
fn fields_carry_the_force_and_lie_on_the_indenter() {
    let outcome = solved(&format!(
        "{REDUCED}[indentation]\nsphere = {{}}\ninstants = 4\n[indentation.fields]\ntimes = [4, 10, 13]\npoints = 2001\n[[history]]\npenetration = 0.02\nrate = 0.002\n[[history]]\npenetration = 0.01\nrate = 0.002\n"
    ));
    let rows: Vec<&Row> = outcome.rows.iter().filter(|row| row.label(0) == "fields").collect();
    assert_eq!(rows.len(), 3);
    for row in rows {
        let (a, depth) = (value(&outcome, row, "contact_radius"), value(&outcome, row, "penetration"));
        let inside: Vec<_> = row.fields.iter().filter(|point| point.place < a).collect();
        // The tension rises as 1/√(a − r): in u = √(a² − r²) the load p r dr = p u du is smooth up to the edge.
        let chord = |r: f64| ((a - r) * (a + r)).sqrt();
        let force: f64 = inside
            .windows(2)
            .map(|pair| {
                let [first, second] = [pair[0], pair[1]].map(|point| (chord(point.place), point.values[1].value * chord(point.place)));
                0.5 * (first.1 + second.1) * (first.0 - second.0)
            })
            .sum();
        // From the last place to the edge p u hardly changes.
        let edge = inside.last().map_or(0.0, |point| point.values[1].value * chord(point.place).powi(2));
        let force = force + edge;
        let expected = value(&outcome, row, "force");
        println!("t {}: F {expected:e}, from the pressure {:e}", value(&outcome, row, "time"), 2.0 * PI * force);
        assert!((2.0 * PI * force - expected).abs() < 2e-3 * expected.abs().max(1e-3));
        for point in inside {
            let off = point.values[2].value - (depth - 0.5 * point.place * point.place);
            assert!(off.abs() < 1e-6, "{off:e} at {}", point.place);
        }
        assert!(row.fields.iter().filter(|point| point.place > a).all(|point| point.values[1].value == 0.0));
        // Outside, the surface lies below the indenter: a gap.
        assert!(
            row.fields
                .iter()
                .filter(|point| point.place > 1.001 * a)
                .all(|point| point.values[2].value > depth - 0.5 * point.place * point.place)
        );
    }
}

/// r^m/(m R^{m−1}) is a sphere at m = 2 and a cone of slope one at m = 1 (tiny depth, slope of the model only).
#[test]
fn shapes_that_coincide() {
    let with = |shape: &str| {
        solved(&format!(
            "units = \"reduced\"\naccuracy = 1e-5\n[material]\nglassy_modulus = 10\nrelaxation = [{{ fraction = 1, relaxation_time = 1 }}]\n[indentation]\n{shape}\nstart = \"relaxed\"\npenetration = 0.02\ninstants = 3\n[[history]]\npenetration = 0.03\nduration = 1\n"
        ))
    };
    for (one, other) in [("sphere = {}", "power_law = { exponent = 2 }"), ("cone = { slope = 1 }", "power_law = { exponent = 1 }")] {
        let (first, second) = (with(one), with(other));
        for (left, right) in instants(&first).iter().zip(instants(&second)) {
            for name in ["force", "contact_radius"] {
                let (left, right) = (value(&first, left, name), value(&second, right, name));
                assert!((left / right - 1.0).abs() < 3e-5, "{other} {name}: {left} {right}");
            }
        }
    }
}

/// The measured force of a table stands beside the computed one, straight between rows, and nowhere where a row has none.
#[test]
fn a_measured_force_is_overlaid() {
    let outcome = solved(&format!(
        "{REDUCED}[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.032\n[[history]]\ntable = \"measured.csv\"\nquantity = \"penetration\"\n"
    ));
    let place = column(&outcome, "measured_force");
    let found: Vec<(f64, Option<f64>)> = instants(&outcome).iter().map(|row| (value(&outcome, row, "time"), row.value(place))).collect();
    assert_eq!(found.len(), 3);
    for (index, expected) in [Some(0.5), Some(0.1), None].into_iter().enumerate() {
        match (found[index].1, expected) {
            (Some(found), Some(expected)) => assert!((found - expected).abs() < 1e-12),
            (found, expected) => assert_eq!(found, expected),
        }
    }
    assert!(outcome.effects.iter().any(|effect| effect.name == "measured force" && effect.on));
    // Below the force against any quantity stand the residuals of the two instants that have a measured one.
    for name in ["force_against_time", "force_against_penetration"] {
        let (_, figure) = outcome.figures.iter().find(|(known, _)| known == name).unwrap();
        let residuals = figure.residuals.as_ref().unwrap();
        assert_eq!(residuals.points.len(), 2, "{name}");
        let rms = value(&outcome, &outcome.rows[0], "rms_deviation");
        assert!((residuals.root_mean_square.unwrap() - rms).abs() <= 1e-12 * rms && residuals.determination.is_some());
    }
}

/// An elastic sphere against forces that are off Hertz's F = (4/3)E*√R Δ^{3/2} by known amounts: deviations, their root mean square and R² follow by hand.
#[test]
fn deviations_from_a_measured_force_are_those_that_were_put_in() {
    let (modulus, radius): (f64, f64) = (3.2e5, 2e-3);
    let depths = [1e-6, 2e-6, 4e-6, 7e-6];
    let hertz = depths.map(|depth: f64| 4.0 / 3.0 * modulus / (1.0 - 0.49 * 0.49) * radius.sqrt() * depth.powf(1.5));
    assert_deviations("accuracy = 1e-4", (modulus, radius), depths, Some(hertz));
}

/// The same where a law attracts: by the program's own forces, at a distance.
#[test]
fn deviations_from_a_measured_force_have_the_bound_of_the_force() {
    let law = "accuracy = 1e-2\n[adhesion]\nwork_of_adhesion = 1e-3\nlaw = \"lennard_jones\"\nrange = 5e-6";
    assert_deviations(law, (3.2e5, 2e-3), [1e-6, 2e-6, 4e-6, 7e-6], None);
}

/// A table holds the depths, and forces that are off `truth` by known amounts, or forces of any kind; the deviations are from the forces found.
fn assert_deviations(head: &str, (modulus, radius): (f64, f64), depths: [f64; 4], truth: Option<[f64; 4]>) {
    let off = [3e-6, -4e-6, 1e-6, 2e-6];
    let forces = truth.unwrap_or([-5e-6, 2e-5, 1.2e-4, 3.4e-4]);
    let measured: Vec<f64> = forces.iter().zip(off).map(|(force, off)| force - off).collect();
    let line = |index: usize| format!("{index},{:e},{:e}\n", depths[index], measured[index]);
    let table = format!("time [s],penetration [m],force [N]\n{}", (0..4).map(line).collect::<String>());
    let scene = format!(
        "{head}\n[material]\nrelaxed_modulus = {modulus:e}\npoisson_ratio = 0.49\n[indentation]\nsphere = {{ radius = {radius:e} }}\n[[history]]\ntable = \"pressed.csv\"\nquantity = \"penetration\"\ntolerance = 0\n"
    );
    let outcome = solved_with(&scene, [("pressed.csv", table)]);
    let estimate = |row: &Row, name: &str| row.values[column(&outcome, name)].unwrap();
    // The first row is of the sphere before it touches.
    let rows = instants(&outcome);
    assert_eq!(rows.len(), 5);
    assert!(rows[0].value(column(&outcome, "force_deviation")).is_none());
    let rows: Vec<&Row> = rows.into_iter().skip(1).collect();
    let mut deviations = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        let (found, force) = (estimate(row, "force_deviation"), estimate(row, "force"));
        let expected = truth.map_or(force.value - measured[index], |_| off[index]);
        assert!((found.value - expected).abs() <= found.error, "{found:?} {expected:e}");
        assert!(found.error >= force.error && found.error - force.error < 1e-14 * force.value.abs(), "{found:?} {force:?}");
        deviations.push(expected);
    }
    let root_mean_square = |of: &dyn Fn(usize) -> f64| ((0..4).map(|index| of(index).powi(2)).sum::<f64>() / 4.0).sqrt();
    let mean = measured.iter().sum::<f64>() / 4.0;
    let (rms, spread) = (root_mean_square(&|index| deviations[index]), root_mean_square(&|index| measured[index] - mean));
    let found = estimate(&outcome.rows[0], "rms_deviation");
    assert!((found.value - rms).abs() <= found.error && found.error < 0.1 * rms, "{found:?} {rms:e}");
    let (found, expected) = (estimate(&outcome.rows[0], "coefficient_of_determination"), 1.0 - (rms / spread).powi(2));
    assert!((found.value - expected).abs() <= found.error && found.error < 1e-2, "{found:?} {expected:e}");
}

/// The speed factor divides every time.
#[test]
fn a_speed_factor_is_a_clock() {
    let scene = |factor: f64, first: f64, second: f64| {
        solved(&format!(
            "{REDUCED}[indentation]\nsphere = {{}}\ninstants = 3\nspeed_factor = {factor}\n[[history]]\npenetration = 0.01\nduration = {first}\n[[history]]\nhold = {second}\n"
        ))
    };
    let (one, other) = (scene(4.0, 8.0, 2.0), scene(1.0, 2.0, 0.5));
    for (left, right) in instants(&one).iter().zip(instants(&other)) {
        for name in ["time", "force", "contact_radius"] {
            assert!((value(&one, left, name) - value(&other, right, name)).abs() <= 1e-10, "{name}");
        }
    }
}

/// δ = αE0*Δγ/(πσ²): that of K² = 2E0*Δγ on a half-space against a rigid body, δ = α(K/(√(2π)σ))². In reduced units σ is in πE0*, so δ = αγ̃/(π²σ̃²).
#[test]
fn a_cohesive_stress_gives_the_zone_of_the_relaxed_body() {
    let rest = "[indentation]\nsphere = {}\nstart = \"relaxed\"\npenetration = 0.032\ninstants = 4\n[[history]]\npenetration = 0.02\nrate = 0.002\n";
    let by_length = solved(&format!("{REDUCED}{rest}"));
    let factor = 0.5;
    let stress = (factor * 1.6e-4 / (PI * PI * 0.013)).sqrt();
    let cohesive = format!("process_zone = {{ cohesive_stress = {stress:e}, factor = {factor} }}");
    let by_stress = solved(&format!("{}{rest}", REDUCED.replace("process_zone = { length = 0.013 }", &cohesive)));
    let (first, second) = (instants(&by_length), instants(&by_stress));
    assert!(first.len() >= 5 && first.len() == second.len());
    for (one, other) in first.iter().zip(&second) {
        for name in ["force", "contact_radius"] {
            let (left, right) = (value(&by_length, one, name), value(&by_stress, other, name));
            // The two lengths differ by rounding, and so may the steps of the integrations: their accuracy is 1e-4.
            assert!((left - right).abs() <= 1e-4 * left.abs(), "{name}: {left:e} {right:e}");
        }
    }
}
