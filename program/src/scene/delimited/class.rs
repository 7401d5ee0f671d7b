//! What each line of a table is: a row of numbers, text, or a line that states a value.

use super::number::{Shape, shape, shape_with_unit};
use super::split::{Cell, Grid, Line, Separator};
use crate::scene::units::parse_quantity;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// A row of numbers, perhaps spoilt.
    Data,
    /// A row in which every cell says that there is no value.
    Nothing,
    /// Names, units, anything else.
    Text,
    /// `Temperature: 25 °C` and the like.
    Stated,
    Comment,
}

/// A line that states a value for the rows below it.
#[derive(Debug, Clone)]
pub struct Stated {
    /// What stands before the colon, the equals sign or the separator.
    pub key: String,
    /// What stands behind it.
    pub value: String,
    /// The line.
    pub line: Cell,
}

pub(super) fn words(text: &str, cell: Cell) -> &str {
    text.get(cell.start as usize..cell.end as usize).unwrap_or("")
}

/// Lines of a grid with their classes and the shapes of their cells.
pub(super) struct Classes {
    pub(super) shapes: Vec<Shape>,
    pub(super) lines: Vec<Class>,
    /// Cells of most rows of numbers.
    pub(super) width: usize,
}

/// No table is wider than this many columns.
const WIDEST: usize = 4096;

impl Classes {
    pub(super) fn of(text: &str, grid: &Grid, separator: Separator, quantities: bool) -> Self {
        let shapes: Vec<Shape> = grid.cells.iter().map(|cell| shape_with_unit(words(text, *cell), quantities)).collect();
        let of = |line: &Line| shapes.get(line.first as usize..(line.first + line.cells) as usize).unwrap_or_default();
        let mut counts = [0_u32; WIDEST];
        for line in grid.lines.iter().filter(|line| !line.comment) {
            if of(line).iter().filter(|shape| shape.is_number()).count() >= 2
                && let Some(count) = counts.get_mut(trimmed(of(line)).len())
            {
                *count += 1;
            }
        }
        // Of equal counts the wider: a row cut short is not the table.
        let width = counts.iter().enumerate().filter(|(_, count)| **count > 0).max_by_key(|(width, count)| (**count, *width));
        let width = width.map_or(0, |(width, _)| width);
        let (mut rows, mut leading) = (0, 0);
        let of_numbers = |line: &&Line| of(line).iter().filter(|shape| shape.is_number()).count() >= 2;
        for line in grid.lines.iter().filter(|line| !line.comment && trimmed(of(line)).len() == width).filter(of_numbers) {
            rows += 1;
            leading += usize::from(of(line).first().is_some_and(|shape| shape.is_number()));
        }
        let numbers_lead = 2 * leading > rows;
        let lines = grid.lines.iter().map(|line| class(text, grid, line, of(line), separator, width, numbers_lead)).collect();
        Self { shapes, lines, width }
    }

    /// The numbers of a line.
    pub(super) fn numbers(&self, line: &Line) -> usize {
        let shapes = self.shapes.get(line.first as usize..(line.first + line.cells) as usize).unwrap_or_default();
        shapes.iter().filter(|shape| shape.is_number()).count()
    }
}

/// Without missing cells at the end.
fn trimmed(shapes: &[Shape]) -> &[Shape] {
    let length = shapes.iter().rposition(|shape| *shape != Shape::Missing).map_or(0, |last| last + 1);
    shapes.get(..length).unwrap_or_default()
}

fn class(text: &str, grid: &Grid, line: &Line, shapes: &[Shape], separator: Separator, width: usize, numbers_lead: bool) -> Class {
    if line.comment {
        return Class::Comment;
    }
    let numbers = shapes.iter().filter(|shape| shape.is_number()).count();
    let cells = trimmed(shapes).len();
    if cells == 0 {
        return Class::Nothing;
    }
    if !(cells == width && numbers >= 2) && stated(text, grid, line, separator).is_some() {
        return Class::Stated;
    }
    let first = grid.cells_of(line).iter().find(|cell| cell.start < cell.end).map_or("", |cell| words(text, *cell));
    let letters = first.chars().filter(|c| c.is_alphabetic()).count();
    let word = letters >= 3 && first.starts_with(char::is_alphabetic) && letters > first.chars().filter(char::is_ascii_digit).count();
    match numbers {
        0 => Class::Text,
        // A word where rows begin with a number.
        _ if word && numbers_lead && (cells != width || numbers < 2) => Class::Text,
        _ => Class::Data,
    }
}

/// Reads a line as `key: value`, `key = value`, or as a key and a quantity in two or three cells; a comment without its mark.
pub(super) fn stated(text: &str, grid: &Grid, line: &Line, separator: Separator) -> Option<Stated> {
    let whole = Cell { start: line.start, end: line.end, quoted: false };
    let full = words(text, whole).trim_start_matches(['#', '%', '/', ' ', '\t']).trim_matches('"');
    let cells = grid.cells_of(line);
    let filled: Vec<&str> = cells.iter().map(|cell| words(text, *cell)).filter(|words| !words.is_empty()).collect();
    if let Some((key, value)) = full.split_once([':', '=']) {
        let first = filled.first().copied().unwrap_or("");
        let leads = line.comment || first.contains([':', '=']) || filled.get(1).is_some_and(|second| second.starts_with([':', '=']));
        let few = line.comment || separator == Separator::Blanks || filled.len() <= 3;
        let key = key.trim().trim_end_matches([';', ',', '"', '\t', ' ']);
        let letters = key.chars().filter(|c| c.is_alphabetic()).count();
        // `T = 25 °C` is the one short key; a spoilt number is none.
        if leads && few && (letters >= 3 || key == "T") && key.len() <= 60 && key.starts_with(|c: char| !c.is_ascii_digit()) {
            let value = value.replace([';', '\t', '"'], " ");
            return Some(Stated { key: key.to_owned(), value: value.trim().trim_start_matches([',', ' ']).to_owned(), line: whole });
        }
    }
    if line.comment || separator == Separator::Blanks || !(2..=3).contains(&filled.len()) {
        return None;
    }
    let [key, value, unit @ ..] = filled.as_slice() else { return None };
    let letters = key.chars().filter(|c| c.is_alphabetic()).count();
    let is_key = letters >= 3 && key.starts_with(char::is_alphabetic) && letters > key.chars().filter(char::is_ascii_digit).count();
    let begins = value.trim_start_matches(['-', '−', '+']).starts_with(|c: char| c.is_ascii_digit());
    let unit_fits = unit.iter().all(|unit| !shape(unit).is_number());
    (is_key && begins && unit_fits).then(|| Stated { key: (*key).to_owned(), value: [&[*value], unit].concat().join(" "), line: whole })
}

/// Whether a line of text can hold units: most of its cells do.
pub(super) fn holds_units(text: &str, cells: &[Cell]) -> bool {
    let (mut known, mut filled, mut named) = (0, 0, false);
    for cell in cells.iter().filter(|cell| cell.start < cell.end) {
        let own = words(text, *cell);
        let unit = bare_unit(own);
        filled += 1;
        let fits = unit != own || matches!(unit, "" | "-" | "—" | "1") || parse_quantity(&format!("1 {unit}")).is_ok();
        known += usize::from(fits);
        named |= fits && !matches!(unit, "" | "-" | "—" | "1");
    }
    named && 2 * known >= filled
}

/// A unit without the brackets around it.
#[must_use]
pub fn bare_unit(text: &str) -> &str {
    let text = text.trim();
    let inner = |open: char, close: char| text.strip_prefix(open).and_then(|rest| rest.strip_suffix(close));
    inner('(', ')').or_else(|| inner('[', ']')).or_else(|| inner('<', '>')).unwrap_or(text).trim()
}
