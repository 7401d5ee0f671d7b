//! Oscillations of a scene are those of the library, in the units of the scene.
//!
//! Contract: `[[history]]` with `oscillation`, rows of cycles, release rates with `[indentation.energies]`; theory 4.
//! Goal: rows of cycles are the library's; one physics in reduced and in SI units; a held punch tells the complex modulus of its body; what ends
//! early, thins out or is left out does so.
//! Parameters: the thesis's chapter 4 (γ̃ = 1.6e-4, δ̃ = 0.013, β = 10), and a punch that stays pressed, for which the edge plays no part.
//! Oracle: [`viscotack::indentation::run`] with numbers written here; 2aE*(ω) by [`viscotack::PlaneMaterial::complex_modulus`].
//! Tolerance: the error bounds of the rows themselves; with each test where there are none.
#![allow(clippy::float_cmp, clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::f64::consts::{PI, TAU};
use std::path::Path;
use viscotack::PlaneMaterial;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Adhesion, Cycle, FrequencySweep, History, IndentationProblem, Oscillation, Profile, run};
use viscotack_program::outcome::{Outcome, Row, Status};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

const REDUCED: &str =
    "units = \"reduced\"\naccuracy = 1e-3\n[material]\nglassy_modulus = 10\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]\n
[adhesion]\nwork_of_adhesion = 1.6e-4\nprocess_zone = { length = 0.013 }\n";

fn solved(text: &str) -> Outcome {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
}

fn column(outcome: &Outcome, name: &str) -> usize {
    outcome.columns.iter().position(|column| column.name == name).unwrap_or_else(|| panic!("no column {name}"))
}

fn cell(outcome: &Outcome, row: &Row, name: &str) -> Estimate {
    row.values[column(outcome, name)].unwrap_or_else(|| panic!("no {name} in {row:?}"))
}

fn value(outcome: &Outcome, row: &Row, name: &str) -> f64 {
    cell(outcome, row, name).value
}

fn cycles(outcome: &Outcome) -> Vec<&Row> {
    let rows: Vec<&Row> = outcome.rows.iter().filter(|row| row.label(0) == "cycle").collect();
    assert!(!rows.is_empty(), "{:?}", outcome.rows);
    rows
}

/// A punch that is held down by nothing but its rim, without adhesion: a linear spring of one complex stiffness.
fn punch(terms: &str, history: &str) -> String {
    format!(
        "accuracy = 1e-5\n[material]\nrelaxed_modulus = 7e5\npoisson_ratio = 0.4\nrelaxation = [{terms}]\n[indentation]\nflat_punch = {{ radius = 2e-3 }}\nstart = \"relaxed\"\npenetration = 4e-5\ninstants = 1\n{history}"
    )
}

/// Each quantity of a row of a cycle is the library's, a frequency that goes up on a ramp under a speed factor.
#[test]
fn cycles_in_reduced_units_are_those_of_the_solver() {
    let outcome = solved(&format!(
        "{REDUCED}[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.02\nspeed_factor = 2\ninstants = 1
[[history]]\npenetration = 0.021\nduration = 2
[[history]]\noscillation = {{ quantity = \"penetration\", amplitude = 0.003, frequency = 0.1, to_frequency = 0.2, frequency_sweep = \"logarithmic\", cycles = 4, to = 0.018 }}\n"
    ));
    // Four cycles at the mean frequency of a logarithmic way, twice as fast.
    let duration = 4.0 * 2.0f64.ln() / (2.0 * 0.1);
    let oscillation = Oscillation::swept(0.003, 0.2, 0.4, FrequencySweep::Logarithmic);
    let history = History::penetration(0.02).ramp(0.021, 1.0).ramp_oscillating(0.018, oscillation, duration);
    let adhesion = Adhesion { work_of_adhesion: 1.6e-4 * PI, process_zone: 0.013 };
    let problem = IndentationProblem {
        accuracy: 1e-3,
        ..IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history).relaxed()
    };
    let direct = run(&PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap(), &problem).unwrap();
    let rows = cycles(&outcome);
    assert_eq!((rows.len(), direct.cycles.len()), (4, 4));
    type Of = fn(&Cycle<Estimate>) -> Estimate;
    let quantities: [(&str, f64, Of); 10] = [
        ("work_per_cycle", PI, |cycle| cycle.work),
        ("storage_stiffness", PI, |cycle| cycle.storage_stiffness),
        ("loss_stiffness", PI, |cycle| cycle.loss_stiffness),
        ("phase", 1.0, |cycle| cycle.phase),
        ("smallest_penetration", 1.0, |cycle| cycle.penetration[0]),
        ("largest_penetration", 1.0, |cycle| cycle.penetration[1]),
        ("smallest_force", PI, |cycle| cycle.force[0]),
        ("largest_force", PI, |cycle| cycle.force[1]),
        ("smallest_contact_radius", 1.0, |cycle| cycle.contact_radius[0]),
        ("largest_contact_radius", 1.0, |cycle| cycle.contact_radius[1]),
    ];
    for (index, (row, cycle)) in rows.iter().zip(&direct.cycles).enumerate() {
        assert!(row.status == Status::Solved, "{row:?}");
        assert_eq!(value(&outcome, row, "cycle"), index as f64 + 1.0);
        assert_eq!(value(&outcome, row, "segment"), 1.0);
        for (name, exact) in [("time", cycle.end), ("cycle_start", cycle.start), ("frequency", 1.0 / (cycle.end - cycle.start))] {
            assert!((value(&outcome, row, name) / exact - 1.0).abs() < 1e-12, "{name}");
        }
        for (name, unit, of) in quantities {
            let (found, expected) = (cell(&outcome, row, name), of(cycle));
            // Both are within their bounds of the truth.
            assert!((found.value * unit - expected.value).abs() <= found.error * unit + expected.error, "{name}: {found:?} {expected:?}");
        }
        // The first cycle has none before it.
        let drift = row.values[column(&outcome, "drift")].map(|drift| drift.value);
        assert_eq!(drift.is_some(), index > 0);
        assert!(drift.is_none_or(|drift| (drift / cycle.drift - 1.0).abs() < 1e-3));
    }
    // The ramp beneath is gone down.
    let last = outcome.rows.iter().rfind(|row| row.label(0) == "instant").unwrap();
    assert!((value(&outcome, last, "penetration") - 0.018).abs() < 1e-9);
}

/// R = 2.5 mm, E0* = 0.8 MPa, ρ = 0.3 s: the same oscillation of the force in SI.
#[test]
fn si_and_reduced_oscillations_are_one() {
    let reduced = solved(&format!(
        "{REDUCED}[indentation]\nsphere = {{}}\nstart = \"relaxed\"\nforce = 0.001\ninstants = 1\n[[history]]\noscillation = {{ quantity = \"force\", amplitude = 0.0005, frequency = 0.2, cycles = 3 }}\n"
    ));
    let (radius, modulus, time, nu) = (2.5e-3, 0.8e6, 0.3, 0.3_f64);
    let young = modulus * (1.0 - nu * nu);
    let force = PI * modulus * radius * radius;
    let si = solved(&format!(
        "accuracy = 1e-3\n[material]\nrelaxed_modulus = {young:e}\nglassy_modulus = {:e}\npoisson_ratio = {nu}\nrelaxation = [{{ fraction = 1, relaxation_time = {time} }}]\n
[adhesion]\nwork_of_adhesion = {:e}\nprocess_zone = {{ length = {:e} }}\n[indentation]\nsphere = {{ radius = {radius} }}\nstart = \"relaxed\"\nforce = {:e}\ninstants = 1\n
[[history]]\noscillation = {{ quantity = \"force\", amplitude = \"{:e} N\", frequency = \"{:e} Hz\", cycles = 3 }}\n",
        10.0 * young,
        1.6e-4 * PI * modulus * radius,
        0.013 * radius,
        0.001 * force,
        0.0005 * force,
        0.2 / time,
    ));
    let (first, second) = (cycles(&reduced), cycles(&si));
    assert_eq!((first.len(), second.len()), (3, 3));
    for (one, other) in first.iter().zip(second) {
        for (name, unit) in [
            ("time", time),
            ("frequency", 1.0 / time),
            ("work_per_cycle", force * radius),
            ("storage_stiffness", force / radius),
            ("loss_stiffness", force / radius),
            ("phase", 1.0),
            ("smallest_penetration", radius),
            ("largest_penetration", radius),
            ("smallest_force", force),
            ("largest_force", force),
            ("smallest_contact_radius", radius),
            ("largest_contact_radius", radius),
        ] {
            let (left, right) = (cell(&reduced, one, name).scaled(unit), cell(&si, other, name));
            assert!((left.value - right.value).abs() <= left.error + right.error + 1e-9 * left.value.abs(), "{name}: {left:?} {right:?}");
        }
    }
}

/// A punch that is held and a small oscillation that goes on until nothing changes any more: 2aE*(ω), E* = E/(1 − ν²).
#[test]
fn a_held_punch_tells_the_complex_modulus() {
    let (frequencies, time) = ([0.05, 0.5, 5.0], 0.2);
    let outcome = solved(&punch(
        &format!("{{ modulus = 3e6, relaxation_time = {time} }}"),
        "[[history]]\noscillation = { quantity = \"penetration\", amplitude = \"1 µm\", frequency = 1, cycles = 1000, until_stationary = true }
[sweep]\nkey = \"history.0.oscillation.frequency\"\nvalues = [\"50 mHz\", \"0.5 Hz\", \"5 Hz\"]\n",
    ));
    let term = viscotack::material::RelaxationTerm { modulus: 3e6, relaxation_time: time };
    let material = PlaneMaterial::from_relaxation(7e5, &[term]).unwrap();
    for (state, frequency) in frequencies.into_iter().enumerate() {
        let of_state: Vec<&Row> = cycles(&outcome).into_iter().filter(|row| row.state == state).collect();
        let last = of_state.last().unwrap();
        // It ends of itself.
        assert!(of_state.len() < 1000 && value(&outcome, last, "drift") <= 1e-5);
        let modulus = material.complex_modulus(TAU * frequency).unwrap();
        let size = 4e-3 / (1.0 - 0.16);
        let (storage, loss) = (size * modulus.storage, size * modulus.loss);
        let whole = storage.hypot(loss);
        println!("{frequency} Hz: {} cycles, {:?}, {:?}", of_state.len(), cell(&outcome, last, "storage_stiffness"), storage);
        // The drift that is left, 1e-5 of the cycle, and the bound of the row, 1e-5 as well.
        assert!((value(&outcome, last, "storage_stiffness") - storage).abs() < 2e-5 * whole);
        assert!((value(&outcome, last, "loss_stiffness") - loss).abs() < 2e-5 * whole);
        assert!((value(&outcome, last, "phase") - loss.atan2(storage)).abs() < 2e-5);
        // An ellipse: π k″ A².
        assert!((value(&outcome, last, "work_per_cycle") / (PI * loss * 1e-12) - 1.0).abs() < 1e-4);
    }
    for figure in ["stiffness_against_frequency", "work_per_cycle_against_frequency"] {
        assert!(outcome.figures.iter().any(|(name, _)| name == figure), "{figure}");
    }
}

/// Of many cycles some are rows, evenly, with the first and the last of each segment.
#[test]
fn many_cycles_are_thinned() {
    let outcome = solved(
        &punch(
            "{ modulus = 3e6, relaxation_time = 1 }",
            "[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 3, cycles = 2500 }
[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-7, frequency = 30, cycles = 3 }\n",
        )
        .replace("1e-5\n[mat", "1e-2\n[mat"),
    );
    let numbers = |segment: f64| -> Vec<f64> {
        let of = |row: &&&Row| value(&outcome, row, "segment") == segment;
        cycles(&outcome).iter().filter(of).map(|row| value(&outcome, row, "cycle")).collect()
    };
    let (long, short) = (numbers(0.0), numbers(1.0));
    assert!(long.len() + short.len() == 2000 && short == [1.0, 2.0, 3.0], "{} {short:?}", long.len());
    assert!(long[0] == 1.0 && long[long.len() - 1] == 2500.0);
    assert!(long.windows(2).all(|pair| pair[1] - pair[0] == 1.0 || pair[1] - pair[0] == 2.0));
    // Of each segment at one frequency the last cycle is drawn.
    let (_, figure) = outcome.figures.iter().find(|(name, _)| name == "stiffness_against_frequency").unwrap();
    let drawn: Vec<f64> = figure.curves[0].points.iter().map(|(frequency, _)| frequency.round()).collect();
    assert_eq!(drawn, [3.0, 30.0]);
}

/// Instants of an oscillation: none if few are asked for, the last cycle, or all the way.
#[test]
fn instants_draw_the_last_cycle_or_all() {
    for (instants, from) in [(4, 3.0), (20, 2.0), (36, 0.0)] {
        let outcome = solved(
            &punch(
                "{ modulus = 3e6, relaxation_time = 0.1 }",
                "[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1e-6, frequency = 1, cycles = 3 }\n",
            )
            .replace("instants = 1\n", &format!("instants = {instants}\n")),
        );
        let times: Vec<f64> =
            outcome.rows.iter().filter(|row| row.label(0) == "instant").map(|row| value(&outcome, row, "time")).skip(1).collect();
        assert!((times[0] - from).abs() < 0.1 && times[times.len() - 1] == 3.0, "{instants}: {times:?}");
        assert!(times.len() <= instants + 2 && (instants < 12) == (times.len() == 1), "{instants}: {times:?}");
        // What is drawn lies on the sinus.
        for row in outcome.rows.iter().filter(|row| row.label(0) == "instant") {
            let exact = 4e-5 + 1e-6 * (TAU * value(&outcome, row, "time")).sin();
            assert!((value(&outcome, row, "penetration") - exact).abs() < 1e-14);
        }
    }
}

/// No oscillation, no columns of cycles; no energies, no release rates; with them G_tip = K²/2E∞* and, where the edge moves, G.
#[test]
fn what_is_left_out_has_no_columns() {
    let scene = |energies: &str, second: &str| {
        solved(&format!(
            "{REDUCED}[indentation]\nsphere = {{}}\nstart = \"relaxed\"\npenetration = 0.02\ninstants = 5\n{energies}[[history]]\npenetration = 0.015\nduration = 3\n{second}"
        ))
    };
    let has = |outcome: &Outcome, name: &str| outcome.columns.iter().any(|column| column.name == name);
    let plain = scene("", "");
    for name in ["cycle", "loss_stiffness", "tip_release_rate", "energy_release_rate"] {
        assert!(!has(&plain, name), "{name}");
    }
    let swinging = scene("", "[[history]]\noscillation = { quantity = \"penetration\", amplitude = 0.001, frequency = 0.5, cycles = 1 }\n");
    assert!(has(&swinging, "loss_stiffness") && !has(&swinging, "tip_release_rate") && !has(&swinging, "frame_displacement"));
    assert!(swinging.effects.iter().any(|effect| effect.name == "oscillation" && effect.on));
    let counted = scene("energies = {}\n", "");
    assert!(has(&counted, "tip_release_rate") && !has(&counted, "cycle"));
    let mut moving = 0;
    for row in counted.rows.iter().filter(|row| row.label(0) == "instant") {
        let intensity = cell(&counted, row, "stress_intensity");
        let tip = cell(&counted, row, "tip_release_rate");
        let exact = intensity.value * intensity.value / 20.0 / PI;
        assert!((tip.value - exact).abs() <= 1e-9 * exact, "{tip:?} {exact:e}");
        if let Some(whole) = row.values[column(&counted, "energy_release_rate")].filter(|_| value(&counted, row, "time") > 0.0) {
            // A receding edge: what the memory dissipates comes on top, G = G_tip − P_d/Ȧ with Ȧ < 0.
            assert!(whole.value > tip.value, "{whole:?} {tip:?}");
            moving += 1;
        }
    }
    assert!(moving >= 3);
}

/// An oscillation that begins anywhere in its cycle is the table of its values: end values and the contact there, of a sphere with adhesion at its edge and
/// without, under a penetration and a force. Oracle: 100 rows a cycle, written here from the sine; a chord errs by 5e-4 of the amplitude.
#[test]
fn a_phase_is_where_in_its_cycle_an_oscillation_begins() {
    let material = "accuracy = 1e-4\n[material]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.5\nrelaxation = [{ modulus = 2e6, relaxation_time = 0.4 }]\n";
    let edge = "[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = { length = 2e-6 }\n";
    let sphere = "[indentation]\nsphere = { radius = 1e-3 }\ninstants = 2\n";
    let cases = [
        (
            "no adhesion",
            material.to_owned(),
            format!("{sphere}[[history]]\npenetration = 5e-6\nduration = 0.5\n"),
            "penetration",
            5e-6,
            1e-6,
        ),
        ("no adhesion, force", material.to_owned(), format!("{sphere}[[history]]\nforce = 5e-4\nduration = 0.5\n"), "force", 5e-4, 1e-4),
        ("an edge", format!("{material}{edge}"), format!("{sphere}start = \"relaxed\"\npenetration = 5e-6\n"), "penetration", 5e-6, 1e-6),
    ];
    for (name, head, indentation, word, present, amplitude) in cases {
        for phase in [1.2_f64, PI, -2.0] {
            let (frequency, cycles) = (0.8, 1.3);
            let duration = cycles / frequency;
            let scene = |rest: &str| format!("{head}{indentation}{rest}");
            let swings = solved(&scene(&format!(
                "[[history]]\noscillation = {{ quantity = \"{word}\", amplitude = {amplitude:e}, frequency = {frequency}, duration = {duration}, phase = {phase} }}\n"
            )));
            let rows = 130;
            let values: String = (1..=rows).fold(String::new(), |mut text, row| {
                let part = f64::from(row) / f64::from(rows);
                let to = present + amplitude * ((TAU * cycles * part + phase).sin() - phase.sin());
                text += &format!("[[history]]\n{word} = {to:e}\nduration = {:e}\n", duration / f64::from(rows));
                text
            });
            let table = solved(&scene(&values));
            for (quantity, along) in [("end_penetration", "penetration"), ("end_force", "force"), ("end_radius", "contact_radius")] {
                let [one, other] = [&swings, &table].map(|outcome| value(outcome, &outcome.rows[0], quantity));
                let way = table.rows.iter().filter(|row| row.label(0) == "instant").map(|row| value(&table, row, along));
                let (least, most) = way.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), one| (least.min(one), most.max(one)));
                assert!((one - other).abs() < 1e-3 * (most - least), "{name}, phase {phase}: {quantity} {one:e} {other:e}");
            }
        }
    }
}

/// Stiffness and loss of whole cycles do not depend on where they begin; from the top a cycle goes down by twice the amplitude.
#[test]
fn whole_cycles_are_the_same_from_any_phase() {
    let of = |phase: f64| {
        solved(&punch(
            "{ modulus = 2e6, relaxation_time = 0.3 }",
            &format!(
                "[[history]]\noscillation = {{ quantity = \"penetration\", amplitude = 2e-6, frequency = 0.7, cycles = 12, phase = {phase} }}\n"
            ),
        ))
    };
    let plain = of(0.0);
    for phase in [0.5 * PI, 2.5, -1.0] {
        let other = of(phase);
        for quantity in ["storage_stiffness", "loss_stiffness"] {
            let [one, two] = [&plain, &other].map(|outcome| value(outcome, cycles(outcome).last().unwrap(), quantity));
            assert!((one / two - 1.0).abs() < 1e-3, "{phase}: {quantity} {one:e} {two:e}");
        }
        let last = *cycles(&other).last().unwrap();
        let [least, most] = ["smallest_penetration", "largest_penetration"].map(|quantity| value(&other, last, quantity));
        let mean = 4e-5 - 2e-6 * phase.sin();
        assert!((least / (mean - 2e-6) - 1.0).abs() < 1e-6 && (most / (mean + 2e-6) - 1.0).abs() < 1e-6, "{phase}: {least:e} {most:e}");
    }
}
