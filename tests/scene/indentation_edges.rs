//! Scenes of an indenter whose edge has two works of adhesion, or works by its speed, and of a punch under its rim.
//!
//! Contract: `adhesion.trailing_work_of_adhesion`, `leading_work_of_adhesion`, `by_speed` and `process_zone.law` of the catalogue; theory 4 and 9.
//! Goal: nothing given is ignored: each key changes the result as the closed forms say, or is refused with the place and what to write.
//! Oracle: Johnson, Kendall and Roberts, and Kendall, at the tolerance of each case; the library with the same numbers.
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::outcome::{Outcome, Row, Status};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

const SPHERE: &str = r#"
accuracy = 1e-4
[material]
relaxed_modulus = "1 MPa"
poisson_ratio = 0.5
[adhesion]
WORKS
process_zone = { length = "0.1 µm" }
[indentation]
sphere = { radius = "1 mm" }
instants = 20
[[history]]
penetration = "5 µm"
rate = "1 µm/s"
[[history]]
penetration = "-20 µm"
rate = "1 µm/s"
"#;

const PUNCH: &str = r#"
accuracy = 1e-3
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.5
creep = [{ fraction = 1, retardation_time = "0.1 s" }]
[adhesion]
work_of_adhesion = "50 mJ/m²"
process_zone = { length = "0.1 µm" }
[indentation]
flat_punch = { radius = "100 µm" }
start = "relaxed"
penetration = "0 µm"
instants = 10
[[history]]
penetration = "-60 µm"
rate = "1 m/s"
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

fn value(outcome: &Outcome, row: &Row, name: &str) -> f64 {
    row.value(outcome.columns.iter().position(|column| column.name == name).unwrap()).unwrap()
}

fn event<'o>(outcome: &'o Outcome, name: &str) -> &'o Row {
    outcome.rows.iter().find(|row| row.label(1) == name).unwrap_or_else(|| panic!("no {name}"))
}

fn with_works(works: &str) -> String {
    SPHERE.replace("WORKS", works)
}

/// An elastic sphere that closes with 5 mJ/m² and opens with 50: it jumps in as JKR's at the closing work, and comes off as at the opening one.
#[test]
fn a_sphere_closes_with_one_work_and_opens_with_another() {
    for works in [
        "work_of_adhesion = \"50 mJ/m²\"\nleading_work_of_adhesion = \"5 mJ/m²\"",
        "trailing_work_of_adhesion = \"50 mJ/m²\"\nleading_work_of_adhesion = \"5 mJ/m²\"",
        "work_of_adhesion = \"5 mJ/m²\"\ntrailing_work_of_adhesion = \"50 mJ/m²\"",
    ] {
        let found = solved(&with_works(works));
        // a³ = 2πΔγR²/E* at Δ = 0, with 5 mJ/m²; (3/2)πRΔγ with 50.
        let jump = value(&found, event(&found, "jump_in"), "contact_radius") / 2.866_841_694_066_518_8e-5;
        let pull_off = value(&found, event(&found, "largest_tension"), "force") / -2.356_194_490_192_345e-4;
        println!("jump-in {jump}, pull-off {pull_off}");
        assert!((jump - 1.0).abs() < 2e-3 && (pull_off - 1.0).abs() < 2e-3);
    }
}

/// A fast pull is Kendall's of the glassy modulus whatever the preload, a slow one that of the soft modulus.
#[test]
fn a_punch_comes_off_as_kendalls() {
    for preload in ["0 µm", "0.1 µm", "1 µm", "20 µm"] {
        let fast = solved(&PUNCH.replace("\"0 µm\"", &format!("\"{preload}\"")));
        let force = value(&fast, event(&fast, "largest_tension"), "force") / -4.093_306_831_785_954e-3;
        println!("{preload}: {force}");
        assert!((force - 1.0).abs() < 1e-3, "{preload}");
    }
    let slow = solved(&PUNCH.replace("1 m/s", "1 nm/s"));
    let force = value(&slow, event(&slow, "largest_tension"), "force") / -1.294_417_275_037_132_8e-3;
    println!("slow: {force}");
    assert!((force - 1.0).abs() < 0.02);
}

/// A constant cohesive stress gives the zone at G = Δγ; one that grows lets a viscoelastic punch off earlier, an elastic one as before.
#[test]
fn a_zone_that_grows_follows_the_load() {
    let stress = |law: &str| PUNCH.replace("{ length = \"0.1 µm\" }", &format!("{{ cohesive_stress = \"0.3 MPa\", factor = 1.645{law} }}"));
    let of = |text: &str| {
        let found = solved(&text.replace("1 m/s", "10 µm/s"));
        -value(&found, event(&found, "largest_tension"), "force")
    };
    let (constant, named, grows) = (of(&stress("")), of(&stress(", law = \"constant\"")), of(&stress(", law = \"growing\"")));
    println!("{constant} constant, {grows} growing");
    assert!(constant.to_bits() == named.to_bits() && grows < 0.99 * constant && grows > 0.5 * constant);
    let elastic = |text: String| {
        text.replace("glassy_modulus = \"10 MPa\"\n", "").replace("creep = [{ fraction = 1, retardation_time = \"0.1 s\" }]\n", "")
    };
    let (constant, grows) = (of(&elastic(stress(""))), of(&elastic(stress(", law = \"growing\""))));
    assert!((constant / grows - 1.0).abs() < 2e-2, "{constant} {grows}");
}

/// A law of the speed of the edge: a table whose leading work is constant holds an approach, and raises pull-off; speeds in SI.
#[test]
fn works_follow_the_speed_of_the_edge() {
    let plain = solved(&with_works("work_of_adhesion = \"50 mJ/m²\""));
    let entry = |speed: &str, trailing: &str| {
        format!("{{ speed = \"{speed}\", trailing_work_of_adhesion = \"{trailing}\", leading_work_of_adhesion = \"50 mJ/m²\" }}")
    };
    let table = format!("by_speed = {{ table = [{}, {}] }}", entry("1 nm/s", "50 mJ/m²"), entry("100 µm/s", "150 mJ/m²"));
    let followed = solved(&with_works(&table));
    let pull = |found: &Outcome| value(found, event(found, "largest_tension"), "force");
    println!("{} and {}", pull(&plain), pull(&followed));
    assert!(pull(&followed) < 1.3 * pull(&plain) && pull(&followed) > 3.2 * pull(&plain));
    // Loading is the same: nothing opens.
    let first =
        |found: &Outcome| found.rows.iter().filter(|row| row.label(0) == "instant").nth(15).map(|row| value(found, row, "force")).unwrap();
    assert!((first(&plain) / first(&followed) - 1.0).abs() < 1e-4);
}

#[test]
fn what_cannot_be_is_refused_with_its_place() {
    let refused = |text: &str| match outcome(text) {
        Err(error) => error,
        Ok(found) => found.rows.iter().find_map(|row| row.reason.clone()).unwrap_or_else(|| panic!("nothing is refused")),
    };
    for (text, says) in [
        (with_works("work_of_adhesion = \"5 mJ/m²\"\nleading_work_of_adhesion = \"50 mJ/m²\""), "leading_work_of_adhesion"),
        (with_works("leading_work_of_adhesion = \"50 mJ/m²\""), "`adhesion.trailing_work_of_adhesion` is missing"),
        (with_works("work_of_adhesion = 1\nleading_work_of_adhesion = 1\ntrailing_work_of_adhesion = 1"), "exclude each other"),
        (with_works("work_of_adhesion = \"50 mJ/m²\"\nby_speed = { speed = \"1 µm/s\", exponent = 0.5 }"), "no speed is stable"),
        (
            with_works("work_of_adhesion = 1").replace("{ length = \"0.1 µm\" }", "{ cohesive_stress = 1e5, law = \"schapery\" }"),
            "is no law of an indenter's process zone",
        ),
    ] {
        let found = refused(&text);
        assert!(found.contains(says), "{found}");
    }
}
