//! Runs of programs that are not here: measured once on a named machine, kept with their stamp, drawn hollow.
//!
//! `verification/peers/work_precision.csv`, one run a row:
//!
//! | column | meaning |
//! |---|---|
//! | problem | identifier of the diagram, as `sliding_one_term` |
//! | method | program and method |
//! | setting | what sets its accuracy, as `N = 128` |
//! | error | against the same truth by the same measure as the diagram; empty for a run that failed |
//! | seconds | median wall time, start of the interpreter not counted |
//! | machine, version, date | the stamp |

use super::reference::{Row, rows};

const FILE: &str = include_str!("../../verification/peers/work_precision.csv");

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

/// The stored runs of all problems, in the order of the file.
#[must_use]
pub fn stored_runs() -> Vec<StoredRun> {
    parse(FILE)
}

/// The runs of a file; rows without a time are left out.
#[must_use]
pub fn parse(text: &str) -> Vec<StoredRun> {
    let run = |row: &Row| StoredRun {
        problem: row.text("problem").to_owned(),
        method: row.text("method").to_owned(),
        setting: row.text("setting").to_owned(),
        error: Some(row.number("error")).filter(|error| error.is_finite()),
        seconds: row.number("seconds"),
        stamp: ["machine", "version", "date"].map(|column| row.text(column).to_owned()),
    };
    rows(text).iter().map(run).filter(|run| run.seconds > 0.0).collect()
}
