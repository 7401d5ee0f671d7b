//! Runs of programs that are not here: measured once on a named machine, kept with their stamp, drawn hollow.
//!
//! `verification/peers/work_precision*.csv`, which the build puts together, one run a row:
//!
//! | column | meaning |
//! |---|---|
//! | problem | identifier of the diagram, as `sliding_one_term` |
//! | method | program and method |
//! | setting | what sets its accuracy, as `N = 128` |
//! | error | against the same truth by the same measure as the diagram; empty for a run that failed |
//! | seconds | median time of one solution on one thread, start of the interpreter not counted |
//! | machine, version, date | the stamp |

use super::reference::{Row, rows};

const FILES: &str = include_str!(concat!(env!("OUT_DIR"), "/work_precision.csv"));
/// Two programs that fitted series to the same dynamic moduli (`verification/peers/pyvisco_fit.py`).
const FITS: &str = include_str!("../../peers/pyvisco_fit.csv");

/// A stored run.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredRun {
    /// Identifier of the diagram.
    pub problem: String,
    /// Program and method.
    pub method: String,
    /// What sets its accuracy.
    pub setting: String,
    /// Its error; none for a failure.
    pub error: Option<f64>,
    /// Its time (s).
    pub seconds: f64,
    /// Machine, version and date.
    pub stamp: [String; 3],
}

/// The stored runs of all problems, in the order of the files.
#[must_use]
pub fn stored_runs() -> Vec<StoredRun> {
    let mut runs = parse(FILES);
    let tool = FITS.lines().find_map(|line| line.strip_prefix("# tool: ")).unwrap_or("version unknown");
    runs.extend(rows(FITS).iter().map(|row| StoredRun {
        problem: format!("material_fit_{}", row.text("data")),
        method: row.text("method").to_owned(),
        setting: format!("{} terms", row.text("terms")),
        error: Some(row.number("rms_relative_to_truth")),
        seconds: row.number("seconds"),
        stamp: ["one machine, process start included for viscotack".to_owned(), tool.to_owned(), String::new()],
    }));
    runs
}

/// The runs of a text; rows without a time are left out, and so are the headers of files put together.
#[must_use]
pub fn parse(text: &str) -> Vec<StoredRun> {
    let run = |row: &Row| StoredRun {
        problem: match row.text("problem") {
            // Names in words of the finite elements.
            "sphere, retraction along a prescribed edge, one relaxation time" => "sphere_prescribed_edge".to_owned(),
            "flat punch pressed at once and held, elastic bulk, viscoelastic shear" => "flat_punch_elastic_bulk".to_owned(),
            name => name.to_owned(),
        },
        method: row.text("method").to_owned(),
        setting: row.text("setting").to_owned(),
        error: Some(row.number("error")).filter(|error| error.is_finite()),
        seconds: row.number("seconds"),
        stamp: ["machine", "version", "date"].map(|column| row.text(column).to_owned()),
    };
    rows(text).iter().map(run).filter(|run| run.seconds > 0.0).collect()
}
