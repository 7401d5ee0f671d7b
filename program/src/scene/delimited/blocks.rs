//! From classed lines to blocks: stated values, a header, units below it, rows of numbers.

use super::class::{Class, Classes, Stated, holds_units, stated, words};
use super::decode;
use super::header::{header_cells, units_below};
use super::split::{Cell, Grid, Line, Separator};

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

pub(super) fn whole(line: &Line) -> Cell {
    Cell { start: line.start, end: line.end, quoted: false }
}

/// What blocks are found in.
pub(super) struct Reader<'r> {
    pub(super) text: &'r str,
    pub(super) grid: &'r Grid,
    pub(super) classes: &'r Classes,
    pub(super) separator: Separator,
}

impl Reader<'_> {
    /// The blocks, and notes on lines that are passed over.
    pub(super) fn blocks(&self) -> (Vec<Block>, Vec<String>) {
        let (mut blocks, mut between): (Vec<Block>, Vec<usize>) = (Vec::new(), Vec::new());
        let (mut nothing, mut passed, mut first_passed) = (0_usize, 0_usize, None);
        let start = self.first_header();
        for (index, class) in self.classes.lines.iter().enumerate() {
            match class {
                Class::Nothing => nothing += 1,
                Class::Comment | Class::Text | Class::Stated => between.push(index),
                // Above the first header, a line with numbers is part of what precedes the table.
                Class::Data if start.is_some_and(|start| index < start) => between.push(index),
                Class::Data => {
                    if !between.is_empty() || blocks.is_empty() {
                        let (block, starts) = self.begun(&between, blocks.last());
                        if starts || blocks.is_empty() {
                            blocks.push(block);
                        }
                        let more = self.passed(&between, blocks.last());
                        if more > 0 {
                            first_passed = first_passed.or(between.iter().find(|at| self.is_text(**at)).copied());
                        }
                        passed += more;
                        between.clear();
                    }
                    if let Some(block) = blocks.last_mut() {
                        block.lines.push(index as u32);
                    }
                }
            }
        }
        let below = between.iter().filter(|index| self.is_text(**index)).count();
        let mut notes = Vec::new();
        let at = |index: usize| self.grid.lines.get(index).map_or(0, |line| decode::line_at(self.text, line.start as usize));
        if let (1.., Some(first)) = (passed, first_passed) {
            notes.push(format!("{passed} lines of text that are not part of the table are passed over, the first is line {}", at(first)));
        }
        if let (1.., Some(first)) = (below, between.iter().find(|index| self.is_text(**index))) {
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
