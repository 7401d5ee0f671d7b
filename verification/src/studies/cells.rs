//! Cells of tables in few words.

use super::Cell;

/// A word.
pub(super) fn word(text: impl Into<String>) -> Cell {
    Cell::Word(text.into())
}

/// A number.
pub(super) fn number(value: f64) -> Cell {
    Cell::Number(Some(value))
}

/// A count.
pub(super) fn count(value: usize) -> Cell {
    number(value as f64)
}
