//! A fit as a scene asks for it, with its data.

use crate::scene::catalogue::Range;
use crate::scene::diagnostic::Place;
use crate::scene::units::Dimension;

/// What `viscotack fit` is asked.
#[derive(Debug, Clone)]
pub struct FitTask {
    /// Columns of the result that are compared with the data.
    pub compare: Vec<String>,
    /// Where the first of them is named.
    pub compare_place: Place,
    /// What the data are given against, if it is said: `time`, `penetration`, `frame`, or the path of a number.
    pub against: Option<String>,
    /// What a number of that path is measured in.
    pub against_dimension: Option<Dimension>,
    /// What is free.
    pub free: Vec<FitFree>,
    /// The tests; at least one.
    pub tests: Vec<FitTest>,
    /// Whether the noise goes with the value, if it is said.
    pub relative: Option<bool>,
    /// Whether Huber's loss is asked for.
    pub huber: bool,
    /// Descents.
    pub starts: usize,
}

/// A free number.
#[derive(Debug, Clone)]
pub struct FitFree {
    /// Its dotted path, or that of an offset.
    pub key: String,
    /// Where it is named.
    pub place: Place,
    /// The smallest and the largest value; none for an offset that goes without.
    pub bounds: Option<[f64; 2]>,
    /// What it is measured in.
    pub dimension: Dimension,
    /// What is allowed.
    pub range: Range,
}

/// A test.
#[derive(Debug, Clone)]
pub struct FitTest {
    /// What was measured.
    pub table: FitTable,
    /// What differs in the scene, as in `--set`.
    pub set: Vec<String>,
}

/// A table of data.
#[derive(Debug, Clone)]
pub struct FitTable {
    /// The file as the scene names it.
    pub file: String,
    /// Where it is named.
    pub place: Place,
    /// Its columns that a fit uses, in SI (or reduced) units.
    pub columns: Vec<FitColumn>,
}

impl FitTable {
    /// A column by the word of its quantity.
    #[must_use]
    pub fn column(&self, word: &str) -> Option<&FitColumn> {
        self.columns.iter().find(|column| column.word == word)
    }
}

/// A column of data.
#[derive(Debug, Clone)]
pub struct FitColumn {
    /// The word of its quantity.
    pub word: String,
    /// What it is measured in.
    pub dimension: Dimension,
    /// Where its header stands.
    pub place: Place,
    /// A number a row, all finite.
    pub values: Vec<f64>,
}
