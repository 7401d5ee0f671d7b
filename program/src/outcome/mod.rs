//! What comes out: rows of values with errors, certificates, validity, work; as screen table, JSON, CSV and plots.

pub mod build;
pub mod checkpoints;
pub mod csv_table;
pub mod folder;
pub mod gather;
pub mod journal;
mod known_digests;
pub mod material_uncertainty;
pub mod owned;
pub mod page;
mod place;
pub mod plot;
pub mod report;
pub mod row;
pub mod screen;
pub mod shard;
pub mod shown_units;
pub mod summary;
pub mod tally;

pub use row::{Certificate, Column, FieldPoint, Row, Status, Witness, Work};

use crate::in_order::in_order;
use serde::Serialize;
use shown_units::ShownUnits;
use std::path::PathBuf;
use tally::Tally;

/// First label of the row that is the answer of a state, where other rows lie on the way to it.
pub const SUMMARY: &str = "summary";

/// Of rows that are answers of states and rows on their way: which columns each kind has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    /// Which labels say something about a state.
    pub labels: Vec<usize>,
    /// Columns of states, in the order of their table.
    pub states: Vec<usize>,
    /// Columns of what lies on the way.
    pub path: Vec<usize>,
}

/// Rows that are written together, where all are held, and such parts under way.
const ROWS_OF_A_PART: usize = 64;
const PARTS_AHEAD: usize = 16;

/// Which pictures of a figure are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pictures {
    /// Vectors.
    pub svg: bool,
    /// Pixels.
    pub png: bool,
}

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
    /// The same of rows on the way of a state.
    pub path_headline: &'static [&'static str],
    /// Which columns belong to the row of a state and which to the rows on its way; none: each row is a state.
    pub layout: Option<Layout>,
    /// The rows, in the order of the sweep: all, or, of a very long sweep, those that are drawn and shown.
    pub rows: Vec<Row>,
    /// The journal that holds all rows, where [`Self::rows`] does not.
    pub stored: Option<PathBuf>,
    /// Counts over all rows.
    pub tally: Tally,
    /// Wanted relative accuracy.
    pub accuracy: f64,
    /// Plots, by file stem.
    pub figures: Vec<(String, plot::Figure)>,
    /// Which pictures are drawn of them.
    pub pictures: Pictures,
    /// What the labels of the rows are: the first distinguishes the rows of one state.
    pub labels: &'static [&'static str],
    /// What the field table holds: the place, then the fields.
    pub field_columns: Vec<Column>,
    /// Materials that each state was solved for besides its own, to show what their fit leaves open.
    pub draws: usize,
    /// The units in which people read it.
    pub shown_in: ShownUnits,
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
    #[serde(rename = "verdict")]
    pub assessment: Assessment,
    /// What it means.
    pub meaning: String,
}

/// What is found of an assumption.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Assessment {
    /// It holds.
    Good,
    /// It may fail: read the sentence.
    Caution,
    /// It cannot be assessed from the scene.
    #[serde(rename = "not_judged")]
    NotAssessed,
}

impl Outcome {
    /// Whether a row is the answer of a state, and not one on its way.
    #[must_use]
    pub fn is_state(&self, row: &Row) -> bool {
        is_state(self.layout.as_ref(), row)
    }

    /// Whether [`Self::rows`] are all rows.
    #[must_use]
    pub fn holds_all_rows(&self) -> bool {
        self.rows.len() == self.tally.rows
    }

    /// Does work on parts of all rows, side by side, and hands the results over in the order of the rows: of a very long sweep from the journal, so that no
    /// memory is needed for them.
    ///
    /// # Errors
    /// A journal that cannot be read, and what the caller reports.
    pub fn each_part<R: Send>(
        &self,
        work: impl Fn(&[Row]) -> std::io::Result<R> + Sync,
        mut take: impl FnMut(&mut R) -> std::io::Result<()> + Send,
    ) -> std::io::Result<()> {
        match &self.stored {
            Some(journal) if !self.holds_all_rows() => {
                journal::each(journal, |states| work(&states.into_iter().flatten().collect::<Vec<_>>()), take)
            }
            _ => {
                in_order(self.rows.chunks(ROWS_OF_A_PART).map(Ok), PARTS_AHEAD, work, |results| results.iter_mut().try_for_each(&mut take))
            }
        }
    }

    /// The exit code. 4 if any row is inaccurate, did not converge or is inadmissible. Otherwise a sweep gives 0 if any row is solved, a single
    /// state only if every row of it is; else 2 if a state contradicts the scene, 3 if no such state exists.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        let count = |status: Status| self.tally.ended(status).rows;
        let solved = count(Status::Solved);
        if [Status::Inaccurate, Status::NotConverged, Status::Inadmissible].into_iter().any(|status| count(status) > 0) {
            4
        } else if solved == self.tally.rows || !self.swept.is_empty() && solved > 0 {
            0
        } else if count(Status::Invalid) > 0 {
            2
        } else {
            3
        }
    }

    /// The work of all rows.
    #[must_use]
    pub fn work(&self) -> Work {
        self.tally.work
    }
}

/// An error of the system with the path that it is about.
fn named(path: &std::path::Path, error: std::io::Error) -> std::io::Error {
    std::io::Error::new(error.kind(), format!("`{}` cannot be written: {error}", crate::terminal_text::name(path)))
}

/// Whether a row is the answer of a state: where none lie on the way, each is.
#[must_use]
pub fn is_state(layout: Option<&Layout>, row: &Row) -> bool {
    layout.is_none() || row.labels.is_empty() || row.label(0) == SUMMARY
}
