//! The reference values that studies hold solvers and rivals against, carried inside the program.

use std::collections::HashMap;

/// One row of a reference file, by column.
pub(super) struct Row(HashMap<String, String>);

impl Row {
    /// A cell; empty where the file has no such column.
    pub(super) fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
    }

    /// A number; NaN where there is none.
    pub(super) fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or(f64::NAN)
    }
}

/// The rows below the lines that begin with `#`.
pub(super) fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let columns: Vec<String> = reader.headers().map_or_else(|_| Vec::new(), |header| header.iter().map(str::to_owned).collect());
    let row = |record: csv::StringRecord| Row(columns.iter().cloned().zip(record.iter().map(str::to_owned)).collect());
    reader.records().filter_map(Result::ok).map(row).collect()
}

/// Sliding contacts collocated by Chebyshev polynomials (`verification/references/sliding_wave.py`), 11 digits.
pub(super) const SLIDING_WAVE: &str = include_str!("../../../reference_data/sliding_wave.csv");
/// Indenters by dense annuli, extrapolated (`verification/references/sphere_annuli.py`), six to nine digits.
pub(super) const SPHERE_ANNULI: &str = include_str!("../../../reference_data/sphere_annuli.csv");
/// Steady cracks by nested quadrature (`verification/references/steady_crack.py`), 32 digits.
pub(super) const STEADY_CRACK: &str = include_str!("../../../reference_data/steady_crack.csv");
/// Their materials.
pub(super) const STEADY_CRACK_MATERIALS: &str = include_str!("../../../reference_data/steady_crack_materials.csv");
