//! Scenes of an indenter without adhesion that were wrong, refused or endless, after public decks and threads and random scenes.
//!
//! Contract: scenes without `[adhesion]`.
//! Goal: every such scene ends, solved, with the right contact; liquids too.
//! Oracle: a = √(ΔR) of an elastic sphere; Lee and Radok's and Ting's quadratures and another group's MDR program (values below, from elsewhere).
//! Tolerance: that of each value, and the bounds reported.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::outcome::{Outcome, Row, Status};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

const EDGE_STUCK: &str = r#"
units = "reduced"
[material]
poisson_ratio = 0.3
[indentation]
sphere = {}
start = "relaxed"
penetration = 1e-3
instants = 3
[[history]]
oscillation = { quantity = "penetration", amplitude = 1e-4, frequency = 1, cycles = 3 }
"#;

const SPHERE_WRONG: &str = r#"
units = "reduced"
accuracy = 1e-5
[material]
poisson_ratio = 0.3
[indentation]
sphere = {}
start = "relaxed"
penetration = 0.00046132071887483274
instants = 3
[[history]]
penetration = 0.00046132071887483274
duration = 2878.8146060542817
[[history]]
oscillation = { quantity = "penetration", amplitude = 6.668709596234983e-07, frequency = 0.025065145542375374, cycles = 6 }
"#;

const STEP_AND_CYCLES: &str = r#"
units = "reduced"
[material]
poisson_ratio = -0.5
relaxation = [{ modulus = 5.483103084142821, relaxation_time = 1.0 }]
[indentation]
sphere = {}
instants = 3
speed_factor = 6.895689551962933
[[history]]
penetration = 0.0017772848384876026
duration = 39.58161288421767
[[history]]
penetration = 0.007678157131981713
[[history]]
oscillation = { quantity = "penetration", amplitude = 1.821815304493451e-05, frequency = 0.1500108235203879, cycles = 5 }
"#;

const LATE_RELEASE: &str = r#"
units = "reduced"
[material]
poisson_ratio = -0.99
[indentation]
sphere = {}
start = "relaxed"
penetration = 0.00046132071887483274
instants = 3
speed_factor = 0.1712000153808686
[[history]]
penetration = 0.00046132071887483274
duration = 2878.8146060542817
[[history]]
oscillation = { quantity = "penetration", amplitude = 6.668709596234983e-07, frequency = 0.025065145542375374, cycles = 6 }
[[history]]
penetration = 4.6132071887483276e-05
"#;

const EQUAL_TIMES: &str = r#"
accuracy = 1e-4
[material]
relaxed_modulus = 550000000.0
poisson_ratio = 0.39
relaxation = [
  { modulus = 280000000.0, relaxation_time = 1.0945794310200747 },
  { modulus = 280000000.0, relaxation_time = 1.094579431020075 },
  { modulus = 500000000.0, relaxation_time = 0.03 },
  { modulus = 900000000.0, relaxation_time = 0.002 },
]
[indentation]
sphere = { radius = "1 mm" }
instants = 4
[[history]]
penetration = "10 µm"
duration = "1 s"
"#;

const BURGERS: &str = r#"
accuracy = 1e-5
[material]
glassy_modulus = "10 GPa"
poisson_ratio = 0.2
viscosity = "100 GPa s"
creep = [ { compliance = 1e-10, retardation_time = "1 s" } ]
[indentation]
sphere = { radius = "10 mm" }
instants = 4
[[history]]
force = "100 N"
[[history]]
hold = "10 s"
"#;

const MELT: &str = r#"
accuracy = 1e-5
[material]
relaxed_modulus = 0
poisson_ratio = 0.5
relaxation = [ { modulus = "1 MPa", relaxation_time = "1 s" }, { modulus = "0.1 MPa", relaxation_time = "10 s" } ]
[indentation]
sphere = { radius = "1 mm" }
instants = 4
[[history]]
penetration = "10 µm"
duration = "1 s"
[[history]]
hold = "20 s"
"#;

const SECOND_UNLOADING: &str = r#"
accuracy = 1e-4
[material]
relaxed_modulus = 1500000000.0
poisson_ratio = 0.38
relaxation = [
  { modulus = 700000000.0, relaxation_time = 1.0 },
  { modulus = 500000000.0, relaxation_time = 10.0 },
]
[indentation]
sphere = { radius = "10 mm" }
instants = 4
[[history]]
penetration = "10 µm"
duration = "1 s"
[[history]]
penetration = "5 µm"
duration = "1 s"
[[history]]
penetration = "10 µm"
duration = "1 s"
[[history]]
penetration = "5 µm"
duration = "1 s"
[[history]]
penetration = "12 µm"
duration = "1 s"
"#;

const CELL: &str = r#"
accuracy = 1e-4
[material]
relaxed_modulus = "0.001 Pa"
glassy_modulus = "15.848931924611133 kPa"
poisson_ratio = 0.5
power_law = { exponent = 0.2, time = "1 µs" }
[indentation]
sphere = { radius = "5 µm" }
instants = 5
[[history]]
penetration = "0.5 µm"
rate = "5 µm/s"
[[history]]
penetration = "0 µm"
rate = "5 µm/s"
"#;

const UNLOADING_SLOPE: &str = r#"
accuracy = 1e-6
[material]
relaxed_modulus = 1000000.0
poisson_ratio = 0.5
relaxation = [
  { modulus = 1000000.0, relaxation_time = 1.0 },
  { modulus = 4000000.0, relaxation_time = 0.1 },
]
[indentation]
sphere = { radius = "1 mm" }
instants = 4
[[history]]
penetration = "10 µm"
duration = "1 s"
[[history]]
penetration = "9.9 µm"
duration = "1 µs"
"#;

fn outcome(text: &str) -> Result<Outcome, String> {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).map_err(|error| error.rendered())?;
    let scene = read::read(&document).map_err(|error| error.rendered())?;
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).map_err(|refusal| refusal.to_string())
}

fn solved(text: &str) -> Outcome {
    let found = outcome(text).unwrap_or_else(|error| panic!("{error}"));
    assert!(found.rows.iter().all(|row| row.status == Status::Solved), "{:?}", found.rows.iter().find(|row| row.status != Status::Solved));
    found
}

fn value(outcome: &Outcome, row: &Row, name: &str) -> Option<f64> {
    row.value(outcome.columns.iter().position(|column| column.name == name).unwrap())
}

/// The value of an instant at a time.
fn at(outcome: &Outcome, time: f64, name: &str) -> f64 {
    let row = outcome
        .rows
        .iter()
        .rev()
        .find(|row| row.label(0) == "instant" && (value(outcome, row, "time").unwrap() - time).abs() < 1e-9 * time);
    value(outcome, row.unwrap(), name).unwrap()
}

fn near(found: f64, right: f64, tolerance: f64) {
    assert!((found - right).abs() <= tolerance * right.abs(), "{found:e}, right {right:e}");
}

/// The edge of an elastic sphere follows √Δ, in every instant and at both ends of every cycle.
#[test]
fn the_edge_of_an_elastic_sphere_does_not_stick() {
    for scene in [EDGE_STUCK, SPHERE_WRONG, LATE_RELEASE] {
        let found = solved(scene);
        for row in &found.rows {
            for name in ["", "smallest_", "largest_"] {
                if let Some((a, depth)) =
                    value(&found, row, &format!("{name}contact_radius")).zip(value(&found, row, &format!("{name}penetration")))
                {
                    near(a, depth.sqrt(), 1e-9);
                }
            }
        }
        assert!(found.rows.iter().all(|row| row.label(1).is_empty()));
    }
}

/// After a step that nothing undoes: five cycles about it, an edge that goes out and in, and the force of Lee, Radok and Ting at most that of the glassy contact.
#[test]
fn cycles_after_a_step_are_admissible() {
    let found = solved(STEP_AND_CYCLES);
    let cycles: Vec<&Row> = found.rows.iter().filter(|row| row.label(0) == "cycle").collect();
    assert_eq!(cycles.len(), 5);
    for row in cycles {
        let [low, high] = ["smallest_contact_radius", "largest_contact_radius"].map(|name| value(&found, row, name).unwrap());
        let [least, most]: [f64; 2] =
            [7.678_157_131_981_713e-3 - 1.821_815_304_493_451e-5, 7.678_157_131_981_713e-3 + 1.821_815_304_493_451e-5];
        // An edge that recedes is behind the undeformed surface, never beyond.
        assert!(high <= most.sqrt() * (1.0 + 1e-9) && low <= high && low > 0.9 * least.sqrt(), "{low} {high}");
        assert!(value(&found, row, "work_per_cycle").unwrap() > 0.0);
    }
}

#[test]
fn two_relaxation_times_a_rounding_unit_apart() {
    near(at(&solved(EQUAL_TIMES), 1.0, "force"), 1.532_190_984_413_219, 1e-4);
}

/// a³ = (3/4)R(1 − ν²)F J(t), Δ = a²/R.
#[test]
fn a_burgers_body_under_a_force() {
    let found = solved(BURGERS);
    near(at(&found, 10.0, "contact_radius"), 5.999_969_733_227_481e-4, 1e-8);
    near(at(&found, 10.0, "penetration"), 3.599_963_679_964_586e-5, 1e-8);
}

#[test]
fn a_melt_under_a_penetration() {
    let found = solved(MELT);
    near(at(&found, 1.0, "force"), 1.402_653_388_689_067_7e-3, 1e-9);
    near(at(&found, 21.0, "force"), 2.312_412_080_725_042_4e-5, 1e-9);
}

#[test]
fn the_second_unloading() {
    let found = solved(SECOND_UNLOADING);
    for (time, right) in [(2.0, 2.880_315_891), (3.0, 10.744_075_17), (4.0, 2.291_501_439), (5.0, 14.146_086_213)] {
        near(at(&found, time, "force"), right, 1e-6);
    }
}

#[test]
fn a_cell_of_a_power_law() {
    let found = solved(CELL);
    near(at(&found, 0.14, "force"), 6.541_837_159_084_959e-10, 2e-4);
    near(at(&found, 0.14, "contact_radius"), 1.059_179_372_242_813_7e-6, 2e-4);
}

/// dF/dΔ = 2aE(0)/(1 − ν²) as it turns.
#[test]
fn the_slope_of_a_fast_unloading() {
    let found = solved(UNLOADING_SLOPE);
    let (from, to) = (1.0, 1.0 + 0.25e-6);
    let row = |time: f64, name: &str| {
        let row = found.rows.iter().find(|row| value(&found, row, "time").is_some_and(|at| (at - time).abs() < 1e-9)).unwrap();
        value(&found, row, name).unwrap()
    };
    let slope = (row(from, "force") - row(to, "force")) / (row(from, "penetration") - row(to, "penetration"));
    near(slope, 1600.0, 5e-3);
}

/// A record of 2,000 samples with noise: each turn of the edge is followed, and the surface that was left stays in mind.
#[test]
fn a_record_with_noise_ends() {
    let mut seed = 1_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5) * 5.0
    };
    let mut scene = String::from(
        "accuracy = 1e-2\n[material]\nrelaxed_modulus = 6000.0\npoisson_ratio = 0.5\n\
         relaxation = [{ modulus = 5000.0, relaxation_time = 3.0 }, { modulus = 6000.0, relaxation_time = 0.2 }]\n\
         [indentation]\nsphere = { radius = \"100 µm\" }\ninstants = 1\n",
    );
    for k in 1..=2000 {
        let time = 15.0 * f64::from(k) / 2000.0;
        let depth = 2000.0 * (time / 1.5).min(1.0) + noise();
        scene += &format!("[[history]]\npenetration = \"{depth} nm\"\nduration = {}\n", 15.0 / 2000.0);
    }
    let found = solved(&scene);
    // The mean of the noise is none: Lee and Radok's force of the smooth ramp and hold, to what 2.5 nm do on the glassy chains.
    let modulus = |t: f64| (6000.0 + 5000.0 * (-t / 3.0).exp() + 6000.0 * (-t / 0.2).exp()) / 0.75;
    let rate = |t: f64| 2.0 * (1e-4 * 2e-6 * t / 1.5).sqrt() * 2e-6 / 1.5;
    let n = 200_000;
    let smooth: f64 =
        (0..n).map(|k| 1.5 * (f64::from(k) + 0.5) / f64::from(n)).map(|t| modulus(15.0 - t) * rate(t) * 1.5 / f64::from(n)).sum();
    near(at(&found, 15.0, "force"), smooth, 0.02);
}

/// Liquids under whatever is given; adhesion wants a solid, and says so.
#[test]
fn only_adhesion_wants_a_solid() {
    for text in [
        BURGERS.replace("hold = \"10 s\"", "force = \"50 N\"\nduration = \"1 s\""),
        MELT.replace("hold = \"20 s\"", "force = \"1 mN\"\nduration = \"1 s\""),
    ] {
        solved(&text);
    }
    let adhesion = "[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = { cohesive_stress = \"1 MPa\" }\n[indentation]";
    let said = outcome(&MELT.replace("[indentation]", adhesion)).unwrap_err();
    assert!(said.contains("solid") || said.contains("relaxed modulus"), "{said}");
}
