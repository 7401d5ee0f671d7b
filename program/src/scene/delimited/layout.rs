//! The reading of a text as a table: separator, lines, blocks, the number of cells in each row, the decimal sign.

use super::blocks::{Reader, whole};
use super::class::{Classes, words};
use super::decimal::{Chosen, Evidence, Open};
use super::number::Decimal;
use super::split::{Cell, Grid, Separator, separator_of};
use super::{DelimitedTable, decode, number};
use crate::scene::diagnostic::{Place, SceneError, SourceText};

/// What the reader of a table wants.
#[derive(Debug, Clone, Copy)]
pub struct Options<'o> {
    /// An example of a header.
    pub help: &'o str,
}

impl DelimitedTable {
    /// Reads a text.
    ///
    /// # Errors
    /// No header, no rows, a row with other cells than the header, or a decimal sign that stays open, with the place and what to type.
    pub fn read(source: &SourceText, options: &Options<'_>) -> Result<Self, SceneError> {
        Self::read_as(source, options, false)
    }

    /// Reads a text in which a number may carry its unit in its own cell.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_with_units(source: &SourceText, options: &Options<'_>) -> Result<Self, SceneError> {
        Self::read_as(source, options, true)
    }

    fn read_as(source: &SourceText, options: &Options<'_>, quantities: bool) -> Result<Self, SceneError> {
        let text = source.text();
        let name = source.name();
        let place = |cell: Cell| Place { source: source.clone(), span: cell.start as usize..cell.end as usize };
        let line = |cell: Cell| decode::line_at(text, cell.start as usize);
        let separator = separator_of(text, quantities).unwrap_or_else(|| separator_of_names(text));
        let grid = Grid::of(text, separator);
        let Some(first) = grid.lines.iter().find(|line| !line.comment) else {
            let nowhere = Place { source: source.clone(), span: 0..0 };
            return Err(SceneError::at(&nowhere, format!("{name:?} is empty"), "here").help(options.help));
        };
        let classes = Classes::of(text, &grid, separator, quantities);
        let reader = Reader { text, grid: &grid, classes: &classes, separator };
        let (blocks, mut notes) = reader.blocks();
        let Some(top) = blocks.first() else {
            let message = format!("{name:?} has no rows of numbers");
            return Err(SceneError::at(&place(whole(first)), message, "needs rows of numbers below this line").help(options.help));
        };
        if top.header.is_empty() {
            let row = top.lines.first().and_then(|index| grid.lines.get(*index as usize)).unwrap_or(first);
            let message = format!("{name:?} has no line that names its columns above line {}", line(whole(row)));
            return Err(SceneError::at(&place(whole(row)), message, "numbers without names").help(options.help));
        }
        let mut evidence = Evidence::default();
        // A number that another program would not read: with blanks or apostrophes in it, or a sign of print.
        let mut unusual = None;
        for block in &blocks {
            for row in block.lines.iter().filter_map(|index| grid.lines.get(*index as usize)) {
                let cells = grid.cells_of(row);
                let surplus = cells.get(block.header.len()..).unwrap_or_default().iter().any(|cell| cell.start < cell.end);
                if surplus || cells.len() < block.header.len() {
                    let message =
                        format!("line {} of {name:?} has {} cells, the header {}", line(whole(row)), cells.len(), block.header.len());
                    let wrong = SceneError::at(&place(whole(row)), message, "in this row");
                    return Err(match separator {
                        Separator::Comma if cells.len() > block.header.len() => {
                            wrong.help("if commas are decimal signs here, save the table with `;` between the columns")
                        }
                        Separator::Blanks => wrong.help("if names or cells hold blanks, put tabulators between the columns"),
                        _ => wrong,
                    });
                }
                let shapes = classes.shapes.get(row.first as usize..).unwrap_or_default();
                for (cell, shape) in cells.iter().zip(shapes) {
                    evidence.add(*cell, *shape);
                    if unusual.is_none() && shape.is_number() && !words(text, *cell).bytes().all(is_usual) {
                        unusual = Some(*cell);
                    }
                }
            }
        }
        let Chosen { decimal, grouped, taken } = evidence.decide().map_err(|open| {
            let quoted = |cell: Cell| words(text, cell).to_owned();
            match open {
                Open::Both(point, comma) => {
                    let message = format!(
                        "{name:?} has decimal points and decimal commas: `{}` in line {} and `{}` in line {}",
                        quoted(point),
                        line(point),
                        quoted(comma),
                        line(comma)
                    );
                    SceneError::at(&place(comma), message, "which of the two?").help("write one decimal sign in all numbers")
                }
                Open::Ambiguous { cell, sign, other } => {
                    let mark = if sign == Decimal::Point { "point" } else { "comma" };
                    let (broken, whole) = (quoted(cell).replace(',', "."), quoted(cell).replace([',', '.'], ""));
                    let message = format!(
                        "`{}` in line {} of {name:?} can be {broken} or {whole}, and no other number settles what its {mark} is",
                        quoted(cell),
                        line(cell),
                    );
                    // Each spelling settles the sign, for all numbers of the file.
                    let as_broken = match (sign, other) {
                        (Decimal::Comma, true) => broken.clone(),
                        (Decimal::Point, true) => quoted(cell).replace('.', ","),
                        (_, false) => format!("{}0", quoted(cell)),
                    };
                    let as_whole = format!("{}{}0", quoted(cell), if sign == Decimal::Comma { '.' } else { ',' });
                    let help = format!("write `{as_broken}` there if it is {broken}, `{as_whole}` if it is {whole}");
                    SceneError::at(&place(cell), message, "decimal sign or mark of thousands?").help(help)
                }
            }
        })?;
        if let Some(note) = source.encoding().note() {
            notes.push(note.to_owned());
        }
        if decimal == Decimal::Comma {
            notes.push("its numbers have decimal commas".to_owned());
        }
        if let Some(cell) = grouped {
            let mark = if decimal == Decimal::Point { "commas" } else { "points" };
            notes.push(format!("its {mark} group thousands, as in `{}` in line {}", words(text, cell), line(cell)));
        }
        if let Some(cell) = taken {
            notes.push(format!("its points are taken as decimal signs, as in `{}` in line {}", words(text, cell), line(cell)));
        }
        if let Some(cell) = unusual
            && let Some(value) = number::value(words(text, cell), decimal, 0, &mut String::new())
        {
            notes.push(format!("`{}` in line {} is read as {value}, and others like it", words(text, cell), line(cell)));
        }
        let notes = notes.into_iter().map(|note| format!("{name:?}: {note}")).collect();
        Ok(Self { source: source.clone(), grid, blocks, separator, decimal, notes })
    }
}

/// The separator of a table without numbers, for the messages about it.
fn separator_of_names(text: &str) -> Separator {
    let names = text.lines().find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#')).unwrap_or("");
    [(';', Separator::Semicolon), ('\t', Separator::Tab)]
        .into_iter()
        .find(|(mark, _)| names.contains(*mark))
        .map_or(Separator::Comma, |(_, separator)| separator)
}

const fn is_usual(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9' | b'.' | b',' | b'+' | b'-' | b'e' | b'E')
}
