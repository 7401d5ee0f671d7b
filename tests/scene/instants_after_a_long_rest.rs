//! After a rest of hours a ramp of milliseconds has rows at its own instants.
//!
//! Source: the ramp itself: what is imposed is known at each instant.
//! Goal: a row of an instant is the state of that instant, however short the leg is beside the time that has passed.
//! Parameters: a rest of 10⁴ s, then a ramp of 10 µs to 1 s, by both theories of the edge.
//! Oracle: the penetration of the ramp at the instant that the row names, by its part of the ramp.
//! Tolerance: the bound of the penetration, and the rounding of a time of 10⁴ s.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::outcome::Status;
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

const REST: f64 = 1e4;
const BODY: &str = "[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.5\ncreep = [{ fraction = 1, retardation_time = 1 }]\n[adhesion]\nwork_of_adhesion = 0.05\n";

#[test]
fn rows_of_a_quick_ramp_are_those_of_its_instants() {
    for theory in ["law = \"lennard_jones\"\nrange = 6e-8\n", "process_zone = { length = 2e-7 }\n"] {
        for duration in [1.0, 1e-3, 1e-5] {
            let text = format!(
                "accuracy = 1e-3\n{BODY}{theory}[indentation]\nsphere = {{ radius = 5e-6 }}\nstart = \"relaxed\"\npenetration = 2e-7\ninstants = 8\n[[history]]\nhold = {REST:e}\n[[history]]\npenetration = 1e-7\nduration = {duration:e}\n"
            );
            let document = Document::parse("scene.toml", text, Path::new(".")).unwrap();
            let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
            let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap();
            let at = |name: &str| outcome.columns.iter().position(|column| column.name == name).unwrap();
            let (time, depth) = (at("time"), at("penetration"));
            let mut parts = Vec::new();
            for row in outcome.rows.iter().filter(|row| row.label(0) == "instant") {
                assert_eq!(row.status, Status::Solved, "{row:?}");
                let (time, depth) = (row.values[time].unwrap(), row.values[depth].unwrap());
                if time.value < REST * (1.0 + 1e-14) {
                    continue;
                }
                let part = (time.value - REST) / duration;
                let known = 1e-7 * 4.0 * f64::EPSILON * REST / duration;
                let expected = 2e-7 - 1e-7 * part;
                assert!(
                    (depth.value - expected).abs() <= depth.error + known + 1e-20,
                    "{theory} {duration:e} {part}: {depth:?} is not {expected:e}"
                );
                parts.push((part, known / 1e-7));
            }
            // Eight even instants, none taken for another.
            assert_eq!(parts.len(), 8, "{theory} {duration:e}");
            for (index, (part, known)) in parts.iter().enumerate() {
                assert!((part - (index as f64 + 1.0) / 8.0).abs() <= 2.0 * known + 1e-12, "{theory} {duration:e}: {parts:?}");
            }
        }
    }
}
