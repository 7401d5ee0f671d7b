//! Axes of plots are in the units that the scene writes, and their numbers go with them.
//!
//! Contract: outcome's figures; a scene with units, with plain numbers, in reduced numbers.
//! Oracle: Hertz's force F = 4/3 E* √R Δ^{3/2} (Johnson 1985, 4.23) in the units of the axes, written here.
//! Tolerance: 1e-9 of the force, which is the accuracy of the elastic sphere.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::outcome::Outcome;
use viscotack_program::outcome::plot::{Axis, Figure};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

fn solved(text: &str) -> Outcome {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
}

fn figure<'a>(outcome: &'a Outcome, name: &str) -> &'a Figure {
    &outcome.figures.iter().find(|(stem, _)| stem == name).unwrap_or_else(|| panic!("no {name}")).1
}

fn unit(axis: &Axis) -> &str {
    axis.label.rsplit_once('(').map_or("", |(_, unit)| unit.trim_end_matches(')'))
}

/// An elastic sphere of 2 mm and E* = 4/3 MPa (E = 1 MPa, ν = ½) that is pressed in.
fn sphere(radius: &str, depth: &str, modulus: &str, duration: &str) -> String {
    format!(
        "accuracy = 1e-9\n[material]\nrelaxed_modulus = {modulus}\npoisson_ratio = 0.5\n[indentation]\nsphere = {{ radius = {radius} }}\ninstants = 5
[[history]]\npenetration = {depth}\nduration = {duration}\n"
    )
}

/// Depths in micrometres as the scene writes them, times in minutes, forces, which it does not write, with a prefix; the curve is Hertz's in them.
#[test]
fn numbers_go_with_their_units() {
    let outcome = solved(&sphere("\"2 mm\"", "\"30 µm\"", "\"1 MPa\"", "\"3 min\""));
    let shown = figure(&outcome, "force_against_penetration");
    assert_eq!((unit(&shown.horizontal), unit(&shown.vertical)), ("µm", "mN"));
    let points = &shown.curves.iter().find(|curve| curve.points.len() >= 5).unwrap().points;
    for &(depth, force) in points.iter().filter(|point| point.0 > 0.0) {
        // E* in mN/µm² is 4/3e-3, R in µm.
        let hertz = 4.0 / 3.0 * (4.0 / 3.0 * 1e-3) * 2000f64.sqrt() * depth.powf(1.5);
        assert!((force / hertz - 1.0).abs() < 1e-9, "{depth} µm: {force} mN, Hertz {hertz}");
    }
    assert!((points.last().unwrap().0 - 30.0).abs() < 1e-9);
    let radii = figure(&outcome, "contact_radius_against_penetration");
    // √(2000·30) µm = 245 µm: of the scene's µm and mm the larger one is too large.
    assert_eq!(unit(&radii.vertical), "µm");
    let last = radii.curves.iter().flat_map(|curve| &curve.points).map(|point| point.1).fold(0.0, f64::max);
    assert!((last - 60_000f64.sqrt()).abs() < 1e-6, "{last}");
}

/// Of two lengths of a scene, an axis takes the larger one that its numbers reach.
#[test]
fn the_largest_unit_that_the_numbers_reach() {
    let outcome = solved(&sphere("\"2 m\"", "\"3 mm\"", "\"1 MPa\"", "\"3 s\""));
    let shown = figure(&outcome, "contact_radius_against_penetration");
    // √(2·3e-3) m = 77 mm.
    assert_eq!((unit(&shown.horizontal), unit(&shown.vertical)), ("mm", "mm"));
}

/// Plain numbers are SI, and stay so; reduced numbers have no units.
#[test]
fn plain_numbers_keep_si() {
    let outcome = solved(&sphere("2e-3", "3e-5", "1e6", "3"));
    let shown = figure(&outcome, "force_against_penetration");
    assert_eq!((unit(&shown.horizontal), unit(&shown.vertical)), ("m", "N"));
    let reduced = solved(
        "units = \"reduced\"\n[material]\nglassy_modulus = 10\nrelaxation = [{ fraction = 1, relaxation_time = 1 }]\n[indentation]\nsphere = {}
instants = 5\n[[history]]\npenetration = 0.01\nduration = 1\n",
    );
    let shown = figure(&reduced, "force_against_penetration");
    assert_eq!((unit(&shown.horizontal), unit(&shown.vertical)), ("", ""));
}

/// A logarithmic axis takes a unit of the scene and no prefix of its own.
#[test]
fn logarithms_take_the_units_of_the_scene() {
    let outcome = solved(
        "[material]\nrelaxed_modulus = \"1 MPa\"\nglassy_modulus = \"100 MPa\"\ncreep = [{ fraction = 1, retardation_time = \"1 s\" }]
[adhesion]\nwork_of_adhesion = \"1 J/m²\"\nprocess_zone = { cohesive_stress = \"1 MPa\" }
[crack]\nbody = \"against_rigid\"\nplane = \"stress\"\nspeed = \"1 mm/s\"
[sweep]\nkey = \"crack.speed\"\nfrom = \"1 µm/s\"\nto = \"200 mm/s\"\npoints = 4\n",
    );
    for (name, shown) in &outcome.figures {
        if shown.horizontal.label.contains("speed") {
            assert_eq!(unit(&shown.horizontal), "mm/s", "{name}");
            let last = shown.curves.iter().flat_map(|curve| &curve.points).map(|point| point.0).fold(0.0, f64::max);
            assert!((last - 200.0).abs() < 1e-9, "{name}: {last}");
        }
        assert!(!shown.vertical.label.contains("(mm") || !shown.vertical.label.contains("intensity"), "{}", shown.vertical.label);
    }
    assert!(outcome.figures.iter().any(|(_, shown)| shown.horizontal.label.contains("speed")));
}
