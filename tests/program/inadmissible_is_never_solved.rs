//! Source: `outcome::Row::settled`, and the plans of all problems; design.md, exit codes.
//!
//! Goal: a state that cannot exist (it overlaps, or is pressed where it must pull) is never printed as solved, whatever the problem.
//!
//! Parameters: one scene for each problem and task; the inputs that once came out as solved without being admissible.
//!
//! Oracle: the certificate that each row carries; falsified in one half of the tests, as it is in the other.
//!
//! Tolerance: none.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::outcome::tally::Tally;
use viscotack_program::outcome::{Outcome, Row, Status, Witness, summary::summary};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

const SOLID: &str = "accuracy = 1e-3\n[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ fraction = 1.0, retardation_time = 1.0 }]\n[adhesion]\nwork_of_adhesion = 0.02\nprocess_zone = { length = 5e-7 }\n";
const WAVE: &str = "[sliding]\nspeed = 1e-6\n[sliding.wave]\nwavelength = 1e-4\namplitude = 3e-6\n";

/// Every problem and task.
fn scenes() -> Vec<(&'static str, String)> {
    let of = |rest: &str| format!("{SOLID}{rest}");
    vec![
        ("steady crack", of("[crack]\nbody = \"against_rigid\"\nplane = \"strain\"\nspeed = 1e-6\n")),
        (
            "delayed fracture",
            of(
                "[crack]\nbody = \"against_rigid\"\nplane = \"strain\"\npoints = 3\n[[history]]\nstress_intensity = 500.0\n[[history]]\nhold = 1.0\n",
            ),
        ),
        ("sliding", of(&WAVE.replace("speed = 1e-6\n", "speed = 1e-6\nmean_pressure = 1e3\n"))),
        ("branch", of(&format!("{WAVE}[sliding.branch]\nparameter = \"mean_pressure\"\npoints = 8\n"))),
        ("strength", of(&format!("{WAVE}[sliding.strength]\n"))),
        (
            "indentation",
            of(
                "[indentation]\ninstants = 2\nsphere = { radius = 1e-3 }\nstart = \"relaxed\"\npenetration = 2e-6\n[[history]]\npenetration = 3e-6\nduration = 1.0\n",
            ),
        ),
    ]
}

fn solved(text: &str) -> Outcome {
    let mut document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    read::resolve_includes(&mut document).unwrap();
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| ()).unwrap()
}

/// The rows settled again, and counted.
fn settled(outcome: &mut Outcome) {
    outcome.rows = std::mem::take(&mut outcome.rows).into_iter().map(Row::settled).collect();
    let mut tally = Tally::new(outcome.accuracy, outcome.columns.len());
    outcome.rows.iter().for_each(|row| tally.add(row, outcome.is_state(row)));
    outcome.tally = tally;
}

/// No row that holds a value has a certificate against it.
fn is_sound(rows: &[Row]) -> bool {
    rows.iter().all(|row| !row.status.has_values() || row.certificate.is_none_or(|certificate| certificate.admissible))
}

#[test]
fn a_falsified_certificate_takes_every_value_and_gives_exit_4() {
    for (name, text) in scenes() {
        let mut outcome = solved(&text);
        assert!(is_sound(&outcome.rows), "{name}");
        let certified = outcome.rows.iter().filter(|row| row.certificate.is_some()).count();
        assert!(certified > 0, "{name}: no row of it is certified");
        for row in &mut outcome.rows {
            if let Some(certificate) = &mut row.certificate {
                certificate.admissible = false;
                row.witness = Some(Witness { name: "overlap".into(), value: -1e-3 });
            }
        }
        settled(&mut outcome);
        for row in outcome.rows.iter().filter(|row| row.certificate.is_some()) {
            assert_eq!(row.status, Status::Inadmissible, "{name}");
            assert!(row.values.iter().all(Option::is_none) && row.fields.is_empty() && row.assumptions.is_empty(), "{name}: {row:?}");
            assert!(
                row.reason.as_ref().is_some_and(|reason| reason.contains("cannot exist (overlap = -1e-3)")),
                "{name}: {:?}",
                row.reason
            );
        }
        let json = summary(&outcome);
        assert_eq!(outcome.exit_code(), 4, "{name}");
        assert_eq!(json["rows"]["inadmissible"], certified, "{name}");
        assert_eq!(json["certificate"]["all_admissible"], false, "{name}");
    }
}

#[test]
fn a_sweep_with_an_inadmissible_row_ends_with_4_and_settling_again_changes_nothing() {
    let (_, text) = scenes().swap_remove(0);
    let mut outcome = solved(&format!("{text}[sweep]\nkey = \"crack.speed\"\nvalues = [1e-6, 1e-5]\n"));
    outcome.rows[0].certificate.as_mut().unwrap().admissible = false;
    settled(&mut outcome);
    assert_eq!((outcome.rows[0].status, outcome.rows[1].status), (Status::Inadmissible, Status::Solved));
    assert_eq!(outcome.exit_code(), 4);
    assert_eq!(outcome.rows.clone().into_iter().map(Row::settled).collect::<Vec<_>>(), outcome.rows);
}

#[test]
fn every_row_of_a_plan_is_settled() {
    // The one door through which rows of a problem leave its plan.
    let source = std::fs::read_to_string(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("program/src/plan/mod.rs")).unwrap();
    let (door, calls) = (source.matches("Row::settled").count(), source.matches("self.problem.solve(").count());
    assert_eq!((door, calls), (1, 1));
    for file in ["run.rs", "state_watch.rs"] {
        let text =
            std::fs::read_to_string(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("program/src/plan").join(file)).unwrap();
        assert!(!text.contains("problem.solve("), "{file}");
    }
}

#[test]
fn oscillations_that_once_stuck_are_solved_or_say_that_they_are_not() {
    const ELASTIC: &str = "units = \"reduced\"\naccuracy = 1e-5\n[material]\npoisson_ratio = 0.3\n[indentation]\nsphere = {}\nstart = \"relaxed\"\npenetration = 0.00046132071887483274\ninstants = 3\n[[history]]\npenetration = 0.00046132071887483274\nduration = 2878.8146060542817\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 6.668709596234983e-07, frequency = 0.025065145542375374, cycles = 6 }\n";
    const VISCOUS: &str = "units = \"reduced\"\n[material]\npoisson_ratio = -0.5\nrelaxation = [{ modulus = 5.483103084142821, relaxation_time = 1.0 }]\n[indentation]\nsphere = {}\ninstants = 3\nspeed_factor = 6.895689551962933\n[[history]]\npenetration = 0.0017772848384876026\nduration = 39.58161288421767\n[[history]]\npenetration = 0.007678157131981713\n[[history]]\noscillation = { quantity = \"penetration\", amplitude = 1.821815304493451e-05, frequency = 0.1500108235203879, cycles = 5 }\n";
    for text in [ELASTIC, VISCOUS] {
        let outcome = solved(text);
        assert!(is_sound(&outcome.rows));
        let radius = outcome.columns.iter().position(|column| column.name == "contact_radius").unwrap();
        let depth = outcome.columns.iter().position(|column| column.name == "penetration").unwrap();
        for row in outcome.rows.iter().filter(|row| row.status == Status::Solved) {
            if let (true, Some(radius), Some(depth)) = (text == ELASTIC, row.values[radius], row.value(depth)) {
                assert!((radius.value - depth.sqrt()).abs() <= radius.error + 1e-5 * depth.sqrt(), "{row:?}");
            }
        }
    }
}
