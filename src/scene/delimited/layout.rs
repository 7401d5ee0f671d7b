//! From classed lines to blocks: stated values, a header, units below it, rows of numbers.

use super::class::{Class, Classes, Stated, holds_units, stated, words};
use super::decimal::{Chosen, Evidence, Open};
use super::header::{header_cells, units_below};
use super::number::Decimal;
use super::split::{Cell, Grid, Line, Separator, separator_of};
use super::{DelimitedTable, decode, number};
use crate::scene::diagnostic::{Place, SceneError, SourceText};

/// What the reader of a table wants.
#[derive(Debug, Clone, Copy)]
pub struct Options<'o> {
    /// An example of a header.
    pub help: &'o str,
    /// Whether a number may carry its unit in its own cell.
    pub quantities: bool,
}

/// Rows of numbers below one header.
#[derive(Debug, Clone, Default)]
pub struct Block {
    /// Lines above the rows that state a value, the nearest last; those of the whole file stand with the first block.
    pub stated: Vec<Stated>,
    /// The names of the columns.
    pub header: Vec<Cell>,
    /// Cells of a row of units below the names; empty, or as many as names.
    pub units: Vec<Cell>,
    /// Whether the header stands above these rows, and is not that of the block before.
    pub own_header: bool,
    pub(super) lines: Vec<u32>,
}

impl Block {
    /// Rows of the block.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }
}

/// What stood between the rows of two blocks.
#[derive(Default)]
struct Between {
    /// Lines of text and comments, by index.
    lines: Vec<usize>,
    passed: usize,
}

impl DelimitedTable {
    /// Reads a text.
    ///
    /// # Errors
    /// No header, no rows, a row with other cells than the header, or a decimal sign that stays open, with the place and what to type.
    pub fn read(source: &SourceText, options: &Options<'_>) -> Result<Self, SceneError> {
        let text = source.text();
        let name = source.name();
        let place = |cell: Cell| Place { source: source.clone(), span: cell.start as usize..cell.end as usize };
        let line = |cell: Cell| decode::line_at(text, cell.start as usize);
        let separator = separator_of(text, options.quantities).unwrap_or_else(|| separator_of_names(text));
        let grid = Grid::of(text, separator);
        let Some(first) = grid.lines.iter().find(|line| !line.comment) else {
            let nowhere = Place { source: source.clone(), span: 0..0 };
            return Err(SceneError::at(&nowhere, format!("{name:?} is empty"), "here").help(options.help));
        };
        let classes = Classes::of(text, &grid, separator, options.quantities);
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
                Open::Doubtful { cell, sign, other } => {
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

fn whole(line: &Line) -> Cell {
    Cell { start: line.start, end: line.end, quoted: false }
}

struct Reader<'r> {
    text: &'r str,
    grid: &'r Grid,
    classes: &'r Classes,
    separator: Separator,
}

impl Reader<'_> {
    /// The blocks, and notes on lines that are passed over.
    fn blocks(&self) -> (Vec<Block>, Vec<String>) {
        let (mut blocks, mut between): (Vec<Block>, _) = (Vec::new(), Between::default());
        let (mut nothing, mut passed, mut first_passed) = (0_usize, 0_usize, None);
        let start = self.first_header();
        for (index, (line, class)) in self.grid.lines.iter().zip(&self.classes.lines).enumerate() {
            match class {
                Class::Nothing => nothing += 1,
                Class::Comment | Class::Text | Class::Stated => between.lines.push(index),
                // Above the first header, a line with numbers is part of what precedes the table.
                Class::Data if start.is_some_and(|start| index < start) => between.lines.push(index),
                Class::Data => {
                    if !between.lines.is_empty() || blocks.is_empty() {
                        let (block, starts) = self.begun(&between.lines, blocks.last());
                        if starts || blocks.is_empty() {
                            blocks.push(block);
                        }
                        between.passed = self.passed(&between.lines, blocks.last());
                        if between.passed > 0 {
                            first_passed = first_passed.or(between.lines.iter().find(|at| self.is_text(**at)).copied());
                        }
                        passed += between.passed;
                        between = Between::default();
                    }
                    if let Some(block) = blocks.last_mut() {
                        block.lines.push(index as u32);
                    }
                    let _ = line;
                }
            }
        }
        let below = between.lines.iter().filter(|index| self.is_text(**index)).count();
        let mut notes = Vec::new();
        let at = |index: usize| self.grid.lines.get(index).map_or(0, |line| decode::line_at(self.text, line.start as usize));
        if let (1.., Some(first)) = (passed, first_passed) {
            notes.push(format!("{passed} lines of text that are not part of the table are passed over, the first is line {}", at(first)));
        }
        if let (1.., Some(first)) = (below, between.lines.iter().find(|index| self.is_text(**index))) {
            notes.push(format!("{below} lines of text below the rows are passed over, the first is line {}", at(*first)));
        }
        if nothing > 0 {
            notes.push(format!("{nothing} rows without any value are passed over"));
        }
        (blocks, notes)
    }

    fn is_text(&self, index: usize) -> bool {
        !matches!(self.classes.lines.get(index), None | Some(Class::Comment))
    }

    /// The index of the first line that names columns, if rows of numbers follow it.
    fn first_header(&self) -> Option<usize> {
        let mut texts: Vec<usize> = Vec::new();
        let numbers = |index: usize| self.grid.lines.get(index).map_or(0, |line| self.classes.numbers(line));
        for (index, class) in self.classes.lines.iter().enumerate() {
            match class {
                Class::Data if numbers(index) + 1 >= self.classes.width.min(2) => {
                    if let (Some(header), _) = self.header_of(&texts) {
                        return Some(header);
                    }
                    texts.clear();
                }
                Class::Data => texts.clear(),
                _ => texts.push(index),
            }
        }
        None
    }

    /// Among lines above rows: the one that names the columns, and the one below it that holds units.
    fn header_of(&self, texts: &[usize]) -> (Option<usize>, Option<usize>) {
        let names = |index: &usize| {
            matches!(self.classes.lines.get(*index), Some(Class::Text)) && self.filled(*index) >= 2.min(self.classes.width.max(1))
        };
        let mut candidates = texts.iter().rev().copied().filter(|index| names(index));
        let (nearest, second) = (candidates.next(), candidates.next());
        let Some(low) = nearest else {
            // Names in a comment, as some programs write them.
            let comment = texts.iter().rev().copied().find(|index| {
                let line = self.grid.lines.get(*index).filter(|line| line.comment);
                line.is_some_and(|line| self.commented(line).len() == self.classes.width)
            });
            return (comment, None);
        };
        let cells = |index: usize| self.grid.lines.get(index).map_or(&[][..], |line| self.grid.cells_of(line));
        match second {
            Some(high) if holds_units(self.text, cells(low)) && self.filled(high) >= self.filled(low).min(2) => (Some(high), Some(low)),
            _ => (Some(low), None),
        }
    }

    fn filled(&self, index: usize) -> usize {
        let cells = self.grid.lines.get(index).map_or(&[][..], |line| self.grid.cells_of(line));
        cells.iter().filter(|cell| cell.start < cell.end).count()
    }

    /// The cells of a comment, behind its marks.
    fn commented(&self, line: &Line) -> Vec<Cell> {
        let words = words(self.text, whole(line));
        let marks = words.len() - words.trim_start_matches(['#', '%', '/', ' ']).len();
        let mut grid = Grid { lines: Vec::new(), cells: Vec::new() };
        let start = line.start as usize + marks;
        let text = self.text.get(..line.end as usize).unwrap_or("");
        grid.line(text, start, self.separator, true);
        let fits = grid.cells.len() == self.classes.width;
        if !fits && self.separator != Separator::Blanks {
            grid.cells.clear();
            grid.line(text, start, Separator::Blanks, true);
        }
        if !fits {
            return header_cells(self.text, Cell { start: start as u32, end: line.end, quoted: false }, &grid.cells, self.classes.width);
        }
        grid.cells
    }

    /// A block that begins below some lines, and whether anything in them begins one.
    fn begun(&self, above: &[usize], before: Option<&Block>) -> (Block, bool) {
        let stated: Vec<Stated> = above
            .iter()
            .filter_map(|index| self.grid.lines.get(*index))
            .filter(|line| line.comment || self.classes.numbers(line) < 2)
            .filter_map(|line| stated(self.text, self.grid, line, self.separator))
            .collect();
        let (names, below) = self.header_of(above);
        let own = names.filter(|index| self.is_text(*index) || before.is_none()).and_then(|index| self.grid.lines.get(index));
        let Some(names) = own else {
            let starts = !stated.is_empty() || above.iter().any(|index| self.is_text(*index));
            let inherited = before.map_or_else(Block::default, |before| Block {
                header: before.header.clone(),
                units: before.units.clone(),
                ..Block::default()
            });
            return (Block { stated, own_header: false, ..inherited }, starts);
        };
        let blanks = self.separator == Separator::Blanks;
        let mut header = match (names.comment, blanks) {
            (true, _) => self.commented(names),
            (false, true) => header_cells(self.text, whole(names), self.grid.cells_of(names), self.classes.width),
            (false, false) => self.grid.cells_of(names).to_vec(),
        };
        while header.len() > self.classes.width && header.last().is_some_and(|cell| cell.start == cell.end) {
            header.pop();
        }
        let units = below.and_then(|index| self.grid.lines.get(index)).map_or_else(Vec::new, |line| {
            let cells = self.grid.cells_of(line);
            if blanks && cells.len() < header.len() { units_below(self.text, &header, cells) } else { cells.to_vec() }
        });
        (Block { stated, header, units, own_header: true, lines: Vec::new() }, true)
    }

    /// Lines of text above a block that are neither names nor units nor stated values.
    fn passed(&self, above: &[usize], block: Option<&Block>) -> usize {
        let texts = above.iter().filter(|index| self.is_text(**index)).count();
        let used = block.map_or(0, |block| if block.own_header { usize::from(!block.units.is_empty()) + 1 } else { 0 });
        let said = block.map_or(0, |block| {
            let comment = |line: &Cell| words(self.text, *line).starts_with(['#', '%', '/']);
            block.stated.iter().filter(|stated| !comment(&stated.line)).count()
        });
        texts.saturating_sub(used + said)
    }
}
