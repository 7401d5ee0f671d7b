//! Load histories are read segment by segment, and what is wrong in one is said.
//!
//! Contract: the scene section of the design; the catalogue's `history` keys.
//! Goal: each form of a segment gives its typed segment in SI units; each mistake gives one error at its line with key, value and what is
//! allowed; tables of a file are read with their units, also measured columns.
//! Parameters: histories of a crack (one quantity) and of a sphere (four).
//! Oracle: values written out by hand; the line found by a marker in the text.
//! Tolerance: none: every number is the double nearest to what is written.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack_program::scene::diagnostic::SourceText;
use viscotack_program::scene::typed::{CycleWave, HistoryQuantity, HistorySegment, MeasuredTable, Pace};
use viscotack_program::scene::units::Dimension;
use viscotack_program::scene::{Document, SceneError, check::check, read};

const CRACK: &[HistoryQuantity] = &[HistoryQuantity::StressIntensity];
const SPHERE: &[HistoryQuantity] =
    &[HistoryQuantity::Penetration, HistoryQuantity::Force, HistoryQuantity::ContactRadius, HistoryQuantity::Frame];

const CSV: &str = "# a comment, with a comma\ntime (s), penetration (µm), force (mN), stage temperature (K)\n\n10, 0.0, 0, 293\n10.5, 1.3, ,\n  12, -2e-1, 0.7, 294.5\n";

/// The history of a text; `csv` stands in measured.csv.
fn history_of(text: &str, csv: &str, allowed: &[HistoryQuantity], owner: &str) -> Result<Vec<HistorySegment>, SceneError> {
    let mut document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    document.attach("measured.csv", SourceText::new("measured.csv", csv.to_owned()));
    check(&document.root)?;
    Ok(read::history::read_alone(&document, allowed, owner)?.unwrap().segments)
}

#[test]
fn every_form_of_a_segment_is_read() {
    use HistoryQuantity::{ContactRadius, Force, Penetration};
    let text = "[[history]]\nhold = \"1 s\"\n[[history]]\npenetration = \"2 µm\"\nduration = \"3 min\"\n[[history]]\nforce = \"-1 mN\"\nrate = \"0.5 mN/s\"
[[history]]\nhold = 4\n[[history]]\ncontact_radius = \"3 nm\"\n[[history]]\ntable = \"measured.csv\"\nquantity = \"force\"
[[history]]\ncycles = 100\nquantity = \"penetration\"\nperiod = \"10 ms\"\nlower = \"-1 nm\"\nupper = 0\nwave = \"square\"\n";
    let csv = "time (ms),force (µN)\n-1,3\n4,5\n";
    let table = MeasuredTable {
        file: "measured.csv".into(),
        times: vec![0.0, 5e-3],
        values: vec![3e-6, 5e-6],
        rows: vec![0.0, 5e-3],
        others: Vec::new(),
        thinning: None,
        notes: Vec::new(),
    };
    assert_eq!(
        history_of(text, csv, SPHERE, "a sphere").unwrap(),
        vec![
            HistorySegment::Hold { quantity: None, duration: 1.0 },
            HistorySegment::Ramp { quantity: Penetration, value: 2e-6, pace: Pace::Duration(180.0) },
            HistorySegment::Ramp { quantity: Force, value: -1e-3, pace: Pace::Rate(5e-4) },
            HistorySegment::Hold { quantity: Some(Force), duration: 4.0 },
            HistorySegment::Step { quantity: ContactRadius, value: 3e-9 },
            HistorySegment::Table { quantity: Force, table: table.into() },
            HistorySegment::Cycles { quantity: Penetration, count: 100, period: 0.01, lower: -1e-9, upper: 0.0, wave: CycleWave::Square },
        ]
    );
}

#[test]
fn a_problem_with_one_quantity_needs_no_name_for_it() {
    let text =
        "[[history]]\ncycles = 2\nperiod = 1\nlower = 0\nupper = \"1 kPa √m\"\n[[history]]\nstress_intensity = 1\nrate = \"2 kPa √m/s\"\n";
    let quantity = HistoryQuantity::StressIntensity;
    assert_eq!(
        history_of(text, "", CRACK, "a crack").unwrap(),
        vec![
            HistorySegment::Cycles { quantity, count: 2, period: 1.0, lower: 0.0, upper: 1e3, wave: CycleWave::Triangle },
            HistorySegment::Ramp { quantity, value: 1.0, pace: Pace::Rate(2e3) },
        ]
    );
}

#[test]
fn a_table_keeps_what_was_measured_beside_it() {
    let text = "[[history]]\ntable = \"measured.csv\"\nquantity = \"penetration\"\n";
    let read = history_of(text, CSV, SPHERE, "a sphere").unwrap();
    let HistorySegment::Table { table, .. } = &read[0] else { panic!("{read:?}") };
    assert_eq!(table.times, [0.0, 0.5, 2.0]);
    assert_eq!(table.values, [0.0, 1.3e-6, -2e-7]);
    assert_eq!(table.others[0].name, "force");
    assert_eq!(table.others[0].dimension, Dimension::FORCE);
    assert_eq!(table.others[0].values, [Some(0.0), None, Some(7e-4)]);
    assert_eq!(table.others[1].name, "stage temperature");
    assert_eq!(table.others[1].values, [Some(293.0), None, Some(294.5)]);
    // Without units in a reduced scene.
    let reduced = format!("units = \"reduced\"\n{text}");
    assert!(history_of(&reduced, "time, penetration\n0, 1\n1, 2\n", SPHERE, "a sphere").is_ok());
}

/// Segment text, CSV, marker of the line, words.
#[rustfmt::skip]
const WRONG: &[(&str, &str, &str, &[&str])] = &[
    ("penetraton = 1", "", "penetraton", &["`history.0.penetraton` is not a key", "did you mean `penetration`?", "[history.0] knows: stress_intensity, stress, penetration"]),
    ("stress = 1", "", "stress = 1", &["`history.0.stress` is not controlled in a sphere", "`penetration`, `force`, `contact_radius`, `frame`"]),
    ("duration = 1", "", "[[history]]", &["`history.0.penetration`", "`history.0.hold`", "`history.0.cycles`", "`history.0.oscillation` is missing", "exactly one"]),
    ("penetration = 1\nforce = 1", "", "force = 1", &["`history.0.penetration` and `history.0.force` exclude each other"]),
    ("penetration = 1\nhold = 1", "", "hold = 1", &["`history.0.penetration` and `history.0.hold` exclude each other"]),
    ("penetration = 1\nduration = 1\nrate = 1", "", "rate = 1", &["`history.0.duration` and `history.0.rate` exclude each other"]),
    ("penetration = 1\nduration = 0", "", "duration = 0", &["`history.0.duration` = 0", "greater than 0"]),
    ("penetration = 1\nrate = \"-1 µm/s\"", "", "rate", &["`history.0.rate` = \"-1 µm/s\"", "greater than 0"]),
    ("penetration = 1\nrate = \"1 mN/s\"", "", "rate", &["`history.0.rate`", "it is measured in N/s", "must be measured in m/s", "a speed such as"]),
    ("penetration = 1\nperiod = 1", "", "period", &["`history.0.period` does not belong to a segment with `penetration`", "it may have: duration, rate"]),
    ("penetration = \"1 mN\"", "", "penetration = ", &["`history.0.penetration` = \"1 mN\"", "measured in N", "a length such as"]),
    ("contact_radius = -1", "", "contact_radius", &["`history.0.contact_radius` = -1", "0 or more"]),
    ("hold = -1", "", "hold = -1", &["`history.0.hold` = -1", "0 or more"]),
    ("hold = 1\nduration = 1", "", "duration", &["`history.0.duration` does not belong to a segment with `hold`", "it may have: until"]),
    ("cycles = 0", "", "cycles", &["`history.0.cycles` = 0", "a whole number from 1 to 1000000"]),
    ("cycles = 3", "", "[[history]]", &["`history.0.quantity` is missing", "\"penetration\""]),
    ("cycles = 3\nquantity = \"stress\"", "", "quantity", &["`history.0.quantity` = \"stress\" is not controlled in a sphere", "`penetration`, `force`"]),
    ("cycles = 3\nquantity = \"forse\"", "", "forse", &["`history.0.quantity` = \"forse\"", "did you mean \"force\"?"]),
    ("cycles = 3\nquantity = \"force\"\nupper = 1\nlower = 0", "", "[[history]]", &["`history.0.period` is missing", "a time such as"]),
    ("cycles = 3\nquantity = \"force\"\nperiod = 1\nupper = 1", "", "[[history]]", &["`history.0.lower` is missing", "a force such as"]),
    ("cycles = 3\nquantity = \"force\"\nperiod = 1\nupper = 1\nlower = \"1 N\"", "", "upper", &["`history.0.upper` (1e0) is not above `history.0.lower` (1e0)", "the larger one"]),
    ("cycles = 3\nquantity = \"force\"\nperiod = 1\nupper = 1\nlower = 0\nwave = \"sine\"", "", "sine", &["`history.0.wave` = \"sine\"", "\"triangle\", \"square\""]),
    ("table = \"other.csv\"\nquantity = \"force\"", "", "other.csv", &["`history.0.table` = \"other.csv\"", "was not read"]),
    ("table = \"measured.csv\"", CSV, "[[history]]", &["`history.0.quantity` is missing"]),
    ("table = \"measured.csv\"\nquantity = \"force\"\nperiod = 2", CSV, "period", &["`history.0.period` does not belong to a segment with `table`", "it may have: quantity"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "", "", &["\"measured.csv\" is empty", "time (s), force (N)"]),
    ("table = \"measured.csv\"\nquantity = \"frame\"", CSV, "time (s)", &["no column `frame`", "time (s), frame (m)"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "x (s), force (N)\n0, 1\n", "x (s)", &["no column `time`", "time (s), force (N)"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time, force (N)\n0, 1\n", "time, ", &["the column `time` has no unit"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (m)\n0, 1\n", "force (m)", &["`force (m)` has the wrong unit", "must be measured in N"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (furlong)\n0, 1\n", "furlong", &["`furlong` is not a unit"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N\n0, 1\n", "force (N", &["has no `)`"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N), force (N)\n0, 1, 1\n", "force (N), force", &["`force` stands twice"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n", "time (s)", &["has 1 rows", "at least two"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n1, 2, 3\n", "1, 2, 3", &["3 cells, the header 2"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n1, two\n", "1, two", &["`force` = \"two\" is no number, in line 3", "finite number"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n1, nan\n", "1, nan", &["`force` = \"nan\" is no number, in line 3"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n1,\n", "time (s)", &["`force` is empty, in line 3"]),
    ("table = \"measured.csv\"\nquantity = \"force\"", "time (s), force (N)\n0, 1\n1, 2\n1, 3\n", "1, 3", &["`time` = 1 does not increase: the row before has 1e0", "must be later"]),
    ("table = \"measured.csv\"\nquantity = \"contact_radius\"", "time (s), contact_radius (m)\n0, 1\n1, -2\n", "1, -2", &["`contact_radius` = -2 is out of range", "0 or more"]),
];

#[test]
fn what_is_wrong_is_said_at_its_line() {
    for (segment, csv, marker, says) in WRONG {
        let text = format!("title = \"a scene\"\n[[history]]\n{segment}\n");
        let error = history_of(&text, csv, SPHERE, "a sphere").expect_err(segment);
        let said = error.rendered();
        for words in *says {
            assert!(said.contains(words), "{segment}\n{csv}\n{words}\n{said}");
        }
        // In the table where its own marker stands there, else in the scene.
        let in_csv = !csv.is_empty() && (csv.contains(marker) && !marker.is_empty() && !text.contains(marker));
        let (name, source) = if in_csv || marker.is_empty() { ("measured.csv", *csv) } else { ("scene.toml", text.as_str()) };
        let line = 1 + source.find(marker).map_or(0, |at| source[..at].matches('\n').count());
        assert!(said.contains(&format!("{name}:{line}:")), "{segment}: line {line} of {name}\n{said}");
    }
}

#[test]
fn an_empty_history_and_a_missing_one_differ() {
    let document = |text: &str| Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    assert!(read::history::read_alone(&document("title = \"x\""), CRACK, "a crack").unwrap().is_none());
    let error = read::history::read_alone(&document("history = []"), CRACK, "a crack").unwrap_err();
    assert!(error.to_string().contains("empty list"), "{error}");
}
