//! Delimited text as people have it: one reader for every table that a scene names.
//!
//! ```text
//! bytes ──► open, decode ──► split (lines, cells; the separator from the rows) ──► class (numbers, text, `key: value`)
//!                                                       │
//!        decimal (its sign, from all numbers) ◄─────────┴──► layout (blocks: stated values, header, units, rows)
//! ```
//! A cell is a range of bytes: nothing is copied. A choice that is no matter of course is stated in a note; what would change a number and stays open is refused.

mod blocks;
mod class;
mod decimal;
pub mod decode;
mod header;
mod layout;
mod number;
mod open;
mod scale;
mod split;

pub use blocks::Block;
pub use class::{Stated, bare_unit};
pub use layout::Options;
pub use number::Decimal;
pub use open::open;
pub use scale::Scale;
pub use split::{Cell, Separator};

use super::diagnostic::{Place, SourceText};
use class::words;
use split::Grid;
use std::borrow::Cow;

/// Most characters of a cell in a message.
const LONGEST_SHOWN: usize = 40;

/// A table: its blocks of rows, each below its own header.
pub struct DelimitedTable {
    source: SourceText,
    grid: Grid,
    blocks: Vec<Block>,
    separator: Separator,
    decimal: Decimal,
    notes: Vec<String>,
}

impl DelimitedTable {
    /// The blocks, in order; at least one, with at least one row in all.
    #[must_use]
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The cells of the rows of a block, as many as names; missing ones have no width.
    pub fn rows<'t>(&'t self, block: &'t Block) -> impl Iterator<Item = &'t [Cell]> {
        block.lines.iter().filter_map(|index| self.grid.lines.get(*index as usize)).map(|line| {
            let cells = self.grid.cells_of(line);
            // Behind the last name there are only empty cells.
            cells.get(..block.header.len()).unwrap_or(cells)
        })
    }

    /// What was chosen, for the person who reads the result.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What stands between two columns.
    #[must_use]
    pub const fn separator(&self) -> Separator {
        self.separator
    }

    /// The decimal sign.
    #[must_use]
    pub const fn decimal(&self) -> Decimal {
        self.decimal
    }

    /// The words of a cell, on one line, with doubled quotation marks as one.
    #[must_use]
    pub fn text(&self, cell: Cell) -> Cow<'_, str> {
        let words = words(self.source.text(), cell);
        if !(words.contains(char::is_control) || cell.quoted && words.contains('"')) {
            return Cow::Borrowed(words);
        }
        let text = if cell.quoted { words.replace("\"\"", "\"") } else { words.to_owned() };
        Cow::Owned(text.split(char::is_control).map(str::trim).filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" "))
    }

    /// The words of a cell for a message, cut if they are many.
    #[must_use]
    pub fn shown(&self, cell: Cell) -> String {
        let text = self.text(cell);
        match text.char_indices().nth(LONGEST_SHOWN) {
            None => text.into_owned(),
            Some((end, _)) => format!("{}…", text.get(..end).unwrap_or("")),
        }
    }

    /// Whether a cell is empty or a word for no value.
    #[must_use]
    pub fn is_missing(&self, cell: Cell) -> bool {
        number::shape(words(self.source.text(), cell)) == number::Shape::Missing
    }

    /// The number of a cell in SI units; `buffer` is scratch. None for a cell that is no finite number with the table's decimal sign.
    #[must_use]
    pub fn number(&self, cell: Cell, scale: &Scale, buffer: &mut String) -> Option<f64> {
        let folded = number::value(words(self.source.text(), cell), self.decimal, scale.power, buffer)?;
        Some(scale.apply(folded)).filter(|value| value.is_finite())
    }

    /// Where a cell stands.
    #[must_use]
    pub fn place(&self, cell: Cell) -> Place {
        Place { source: self.source.clone(), span: cell.start as usize..cell.end as usize }
    }

    /// The line of a cell, counted from one.
    #[must_use]
    pub fn line(&self, cell: Cell) -> usize {
        decode::line_at(self.source.text(), cell.start as usize)
    }

    /// Where a row stands, from its first cell to its last.
    #[must_use]
    pub fn row_place(&self, row: &[Cell]) -> Place {
        let span = row.first().zip(row.last()).map_or(0..0, |(first, last)| first.start as usize..last.end as usize);
        Place { source: self.source.clone(), span }
    }

    /// A number with or without a unit of its own, as in `Temperature: 25,0 °C`: its digits with a point, and its unit.
    #[must_use]
    pub fn quantity(text: &str) -> Option<(String, String)> {
        number::quantity(text).map(|(value, unit)| (format!("{value:e}"), unit.to_owned()))
    }
}

#[cfg(test)]
mod tests;
