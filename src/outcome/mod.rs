//! What comes out: rows of values with errors, certificates, validity, work; as screen table, JSON, CSV and plots.

pub mod build;
pub mod checkpoints;
pub mod csv_table;
pub mod folder;
pub mod journal;
pub mod material_uncertainty;
pub mod owned;
pub mod plot;
pub mod row;
pub mod screen;
mod screen_bounds;
pub mod summary;

pub use row::{Certificate, Column, FieldPoint, Row, Status, Witness, Work};

use serde::Serialize;

/// Everything that a run gives.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The line that names the scene.
    pub title: String,
    /// SHA-256 of all that was read.
    pub scene_hash: String,
    /// The problem's name.
    pub problem: &'static str,
    /// Effects that were simulated, and that were not.
    pub effects: Vec<Effect>,
    /// The method, a sentence each.
    pub method: Vec<String>,
    /// Characteristic numbers.
    pub groups: Vec<Group>,
    /// Assumptions of the model against this scene.
    pub validity: Vec<Validity>,
    /// The swept numbers.
    pub swept: Vec<SweptColumn>,
    /// What the values of the rows are.
    pub columns: Vec<Column>,
    /// The columns that a table on the screen has room for; none: the first ones.
    pub headline: &'static [&'static str],
    /// The rows, in the order of the sweep.
    pub rows: Vec<Row>,
    /// Wanted relative accuracy.
    pub accuracy: f64,
    /// Plots, by file stem.
    pub figures: Vec<(String, plot::Figure)>,
    /// What the labels of the rows are: the first tells the rows of one state apart.
    pub labels: &'static [&'static str],
    /// What the field table holds: the place, then the fields.
    pub field_columns: Vec<Column>,
    /// Materials that each state was solved for besides its own, to show what their fit leaves open.
    pub draws: usize,
}

/// A swept number.
#[derive(Debug, Clone, Serialize)]
pub struct SweptColumn {
    /// Its path in the scene.
    pub key: String,
    /// Its unit.
    pub unit: String,
    /// How many values.
    pub values: usize,
}

/// An effect and whether it is simulated.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Effect {
    /// Its name.
    pub name: &'static str,
    /// Whether it is on.
    pub on: bool,
    /// Because of what in the scene.
    pub why: String,
}

/// A characteristic number of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Group {
    /// Name and symbol.
    pub name: String,
    /// Value.
    pub value: f64,
    /// Unit.
    pub unit: String,
}

/// One assumption of the model, held against the results.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Validity {
    /// What is compared.
    pub name: String,
    /// The worst value over all rows.
    pub value: Option<f64>,
    /// Whether the assumption holds.
    pub verdict: Verdict,
    /// What it means.
    pub meaning: String,
}

/// The verdict on an assumption.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It holds.
    Good,
    /// It is doubtful: read the sentence.
    Caution,
    /// It cannot be judged from the scene.
    NotJudged,
}

impl Outcome {
    /// The exit code: 4 if any row is inaccurate, did not converge or is inadmissible. Otherwise 0 if every row is solved, of a sweep if any row
    /// is; else 2 if a row contradicts the scene, and 3 if no such state exists.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        let any = |status: Status| self.rows.iter().any(|row| row.status == status);
        let solved = if self.swept.is_empty() { self.rows.iter().all(|row| row.status == Status::Solved) } else { any(Status::Solved) };
        if any(Status::Inaccurate) || any(Status::NotConverged) || any(Status::Inadmissible) {
            4
        } else if solved {
            0
        } else if any(Status::Invalid) {
            2
        } else {
            3
        }
    }

    /// The work of all rows.
    #[must_use]
    pub fn work(&self) -> Work {
        let mut total = Work::default();
        for row in &self.rows {
            total += row.work;
        }
        total
    }
}

/// An error of the system with the path that it is about.
fn named(path: &std::path::Path, error: std::io::Error) -> std::io::Error {
    std::io::Error::new(error.kind(), format!("`{}` cannot be written: {error}", crate::terminal_text::name(path)))
}
