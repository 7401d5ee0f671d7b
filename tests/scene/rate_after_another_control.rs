//! Source: `program/src/plan/indentation/rates.rs`: a segment at a rate after another quantity was controlled.
//!
//! Goal: press to a force, hold, retract at a rate gives what the same history gives whose durations are written out.
//!
//! Parameters: a sphere with adhesion through a frame and on its penetration, one without adhesion, and a relaxed start; each with two such segments at most.
//!
//! Oracle: the same scene with `duration`, from the depth that a run of the history before shows.
//!
//! Tolerance: the sum of both bounds; ten times the error that the duration has from the depth's bound.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use serde_json::Value;

const HEAD: &str = "accuracy = 1e-4\n[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.49\nrelaxation = [{ modulus = \"4 MPa\", relaxation_time = \"0.5 s\" }]\n";
const STICKY: &str = "[adhesion]\nwork_of_adhesion = \"50 mJ/m²\"\nprocess_zone = { length = \"1 µm\" }\n";

fn results(text: &str) -> Value {
    Folder::with(text).call(&["run", "scene.toml", "--json"]).ended(0).json()
}

/// A number of the row of the state, and its bound.
fn of_state(summary: &Value, name: &str) -> (f64, f64) {
    let value = &summary["results"][0]["values"][name];
    (value["value"].as_f64().unwrap(), value["error"].as_f64().unwrap())
}

#[test]
fn a_rate_after_a_force_is_the_duration_that_it_makes() {
    let sphere = "[indentation]\nsphere = { radius = \"1 mm\" }\ninstants = 4\n";
    let framed = format!("{sphere}frame_stiffness = \"500 N/m\"\n");
    let press = "[[history]]\nforce = \"1 mN\"\nduration = \"2 s\"\n[[history]]\nhold = \"3 s\"\n";
    let relaxed = format!("{sphere}start = \"relaxed\"\nforce = \"1 mN\"\n");
    let cases = [
        (format!("{HEAD}{STICKY}{framed}{press}"), "frame", -20e-6, 5e-6, "pull_off_force", "end_penetration"),
        (format!("{HEAD}{STICKY}{sphere}{press}"), "penetration", -10e-6, 2e-6, "pull_off_force", "end_penetration"),
        (format!("{HEAD}{sphere}{press}"), "penetration", 6e-6, 2e-6, "end_force", "end_penetration"),
        (format!("{HEAD}{STICKY}{relaxed}"), "penetration", -10e-6, 2e-6, "pull_off_force", "end_penetration"),
    ];
    for (head, quantity, to, rate, compared, depth) in cases {
        let before = if head.contains("relaxed\"") { format!("{head}[[history]]\nhold = \"1 s\"\n") } else { head.clone() };
        let before = results(&before);
        let (start, bound) = of_state(&before, depth);
        let force = of_state(&before, "end_force");
        let start = if quantity == "frame" { start + force.0 / 500.0 } else { start };
        let duration = (to - start).abs() / rate;
        let by_rate = results(&format!("{head}[[history]]\n{quantity} = {to:e}\nrate = {rate:e}\n"));
        let by_duration = results(&format!("{head}[[history]]\n{quantity} = {to:e}\nduration = {duration:e}\n"));
        let (one, other) = (of_state(&by_rate, compared), of_state(&by_duration, compared));
        let of_the_start = 10.0 * (bound + force.1 / 500.0) / (to - start).abs() * one.0.abs();
        println!("{quantity} {compared} {one:?} {other:?}");
        assert!((one.0 - other.0).abs() <= one.1 + other.1 + of_the_start, "{quantity} {compared}: {one:?} {other:?}");
        // Another rate is another answer.
        let quick = of_state(&results(&format!("{head}[[history]]\n{quantity} = {to:e}\nrate = {:e}\n", 10.0 * rate)), compared);
        assert!((quick.0 - one.0).abs() > 1e-3 * one.0.abs(), "{quick:?} {one:?}");
    }
}
