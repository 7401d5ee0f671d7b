//! A text as lines of cells; a cell is a range of bytes.

use super::number::{Shape, shape_with_unit};

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Separator {
    /// A tabulator.
    Tab,
    /// `;`
    Semicolon,
    /// `,`
    Comma,
    /// One blank or more.
    Blanks,
}

impl Separator {
    pub(super) const ALL: [Self; 4] = [Self::Tab, Self::Semicolon, Self::Comma, Self::Blanks];

    const fn is(self, byte: u8) -> bool {
        match self {
            Self::Tab => byte == b'\t',
            Self::Semicolon => byte == b';',
            Self::Comma => byte == b',',
            Self::Blanks => matches!(byte, b' ' | b'\t'),
        }
    }

    /// What it is called.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Tab => "tabulators",
            Self::Semicolon => "semicolons",
            Self::Comma => "commas",
            Self::Blanks => "blanks",
        }
    }
}

/// A cell: its bytes without blanks and quotation marks around them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    pub(super) start: u32,
    pub(super) end: u32,
    pub(super) quoted: bool,
}

impl Cell {
    /// No cell.
    pub const NONE: Self = Self { start: 0, end: 0, quoted: false };
}

/// A line that says something: its bytes and its cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    pub(super) start: u32,
    pub(super) end: u32,
    pub(super) first: u32,
    pub(super) cells: u32,
    pub(super) comment: bool,
}

/// Longest quoted cell that may hold a line end: a header over two lines. A stray quotation mark must not swallow the table.
const LONGEST_QUOTED: usize = 200;

/// Lines and cells of a text with one separator. Empty lines are left out.
pub(super) struct Grid {
    pub(super) lines: Vec<Line>,
    pub(super) cells: Vec<Cell>,
}

impl Grid {
    pub(super) fn of(text: &str, separator: Separator) -> Self {
        let mut grid = Self { lines: Vec::new(), cells: Vec::new() };
        let mut at = 0;
        while at < text.len() {
            at = grid.line(text, at, separator, false);
        }
        grid
    }

    /// Some lines of the text, for a first look: the first ones, and further ones evenly over it.
    pub(super) fn sample(text: &str, separator: Separator) -> Self {
        let mut grid = Self { lines: Vec::new(), cells: Vec::new() };
        let (mut at, stride) = (0, text.len() / SAMPLED_LINES);
        while at < text.len() {
            let next = grid.line(text, at, separator, false);
            let jump = if grid.lines.len() < SAMPLED_LINES { next } else { line_after(text, (at + stride).max(next)) };
            at = jump;
        }
        grid
    }

    pub(super) fn cells_of(&self, line: &Line) -> &[Cell] {
        self.cells.get(line.first as usize..(line.first + line.cells) as usize).unwrap_or_default()
    }

    /// Reads the line at a place, and gives the place of the next one. A comment is one cell, unless its mark is to be read over.
    pub(super) fn line(&mut self, text: &str, start: usize, separator: Separator, in_comment: bool) -> usize {
        let bytes = text.as_bytes();
        let first = self.cells.len();
        let begin = skip_blanks(bytes, start, separator);
        let comment = !in_comment && is_comment(bytes.get(begin..).unwrap_or_default(), separator);
        let mut at = if in_comment { start } else { begin };
        if comment {
            at = line_end(bytes, at);
            self.cells.push(trimmed(text, begin, at, false));
        } else {
            loop {
                at = skip_blanks(bytes, at, separator);
                let (cell, end) = quoted(text, at, separator).unwrap_or_else(|| {
                    let end = cell_end(bytes, at, separator);
                    (trimmed(text, at, end, false), end)
                });
                at = end;
                let more = bytes.get(at).is_some_and(|byte| separator.is(*byte));
                // Blanks at the end of a line are no separator.
                let blank_end = separator == Separator::Blanks && cell.start == cell.end;
                if !blank_end {
                    self.cells.push(cell);
                }
                if !more {
                    break;
                }
                at += 1;
            }
        }
        let says = self.cells.get(first..).unwrap_or_default().iter().any(|cell| cell.start < cell.end);
        if says {
            let count = self.cells.len() - first;
            let bounds = trimmed(text, begin, at, false);
            self.lines.push(Line { start: bounds.start, end: bounds.end, first: first as u32, cells: count as u32, comment });
        } else {
            self.cells.truncate(first);
        }
        match bytes.get(at..) {
            Some([b'\r', b'\n', ..]) => at + 2,
            _ => at + 1,
        }
    }
}

/// Lines looked at for the separator.
const SAMPLED_LINES: usize = 1000;

/// `#`, `%` and `//` begin a comment; but not as a cell of their own, as in a row of units that begins with `%;`.
fn is_comment(rest: &[u8], separator: Separator) -> bool {
    match rest {
        [b'#' | b'%', next, ..] if separator != Separator::Blanks && separator.is(*next) => false,
        [b'#' | b'%', ..] | [b'/', b'/', ..] => true,
        _ => false,
    }
}

const fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

fn line_end(bytes: &[u8], at: usize) -> usize {
    bytes.get(at..).and_then(|rest| rest.iter().position(|byte| is_line_end(*byte))).map_or(bytes.len(), |length| at + length)
}

/// The start of the first line behind a place.
fn line_after(text: &str, at: usize) -> usize {
    line_end(text.as_bytes(), at).saturating_add(1)
}

fn cell_end(bytes: &[u8], at: usize, separator: Separator) -> usize {
    let ends = |byte: &u8| is_line_end(*byte) || separator.is(*byte);
    bytes.get(at..).and_then(|rest| rest.iter().position(ends)).map_or(bytes.len(), |length| at + length)
}

fn skip_blanks(bytes: &[u8], mut at: usize, separator: Separator) -> usize {
    while bytes.get(at).is_some_and(|byte| *byte == b' ' || (*byte == b'\t' && separator != Separator::Tab)) {
        at += 1;
    }
    at
}

/// A cell in quotation marks and the place behind it: the mark must close before a separator or a line end.
fn quoted(text: &str, at: usize, separator: Separator) -> Option<(Cell, usize)> {
    let bytes = text.as_bytes();
    if bytes.get(at) != Some(&b'"') {
        return None;
    }
    let mut place = at + 1;
    loop {
        match bytes.get(place)? {
            b'"' if bytes.get(place + 1) == Some(&b'"') => place += 2,
            b'"' => break,
            _ if place - at > LONGEST_QUOTED => return None,
            _ => place += 1,
        }
    }
    let after = skip_blanks(bytes, place + 1, separator);
    let closed = separator == Separator::Blanks && after > place + 1;
    let closed = closed || bytes.get(after).is_none_or(|byte| is_line_end(*byte) || separator.is(*byte));
    // Blanks as separators: the loop of the line expects to stand on one.
    let end = if separator == Separator::Blanks { place + 1 } else { after };
    closed.then(|| (trimmed(text, at + 1, place, true), end))
}

fn trimmed(text: &str, start: usize, end: usize, quoted: bool) -> Cell {
    let words = text.get(start..end).unwrap_or("");
    let ahead = words.len() - words.trim_start().len();
    let length = words.trim().len();
    Cell { start: (start + ahead) as u32, end: (start + ahead + length) as u32, quoted }
}

/// What counts for a separator: lines with two numbers at least, and the part of their cells that are numbers.
fn score(text: &str, separator: Separator, quantities: bool) -> f64 {
    let grid = Grid::sample(text, separator);
    let mut sum = 0.0;
    for line in grid.lines.iter().filter(|line| !line.comment) {
        let words = |cell: &Cell| text.get(cell.start as usize..cell.end as usize).unwrap_or("");
        let shapes = grid.cells_of(line).iter().map(|cell| shape_with_unit(words(cell), quantities));
        let (mut numbers, mut texts) = (0_u32, 0_u32);
        for shape in shapes {
            numbers += u32::from(shape.is_number());
            texts += u32::from(shape == Shape::Text);
        }
        if numbers >= 2 {
            sum += f64::from(numbers) / f64::from(numbers + texts);
        }
    }
    sum
}

/// The separator with which most of the text is rows of numbers; where two are equal, the first of tab, semicolon, comma, blanks. None if no line has two numbers.
pub(super) fn separator_of(text: &str, quantities: bool) -> Option<Separator> {
    let mut best = (None, 0.0);
    for separator in Separator::ALL {
        let score = score(text, separator, quantities);
        if score > best.1 * (1.0 + 1e-9) {
            best = (Some(separator), score);
        }
    }
    best.0
}
