//! Cells of a header whose names hold blanks, where blanks separate the columns.

use super::class::words;
use super::split::Cell;

/// The cells of a line, split as its number of columns asks: at every blank, at two blanks or more, or behind every bracket that closes.
pub(super) fn header_cells(text: &str, line: Cell, plain: &[Cell], width: usize) -> Vec<Cell> {
    let plain = merged_units(text, plain);
    if plain.len() == width {
        return plain;
    }
    let wide = split_at(text, line, |before, after| (before.ends_with(' ') && after.starts_with(' ')) || after.starts_with('\t'));
    if wide.len() == width {
        return wide;
    }
    let bracketed = split_at(text, line, |before, after| after.starts_with(' ') && before.trim_end().ends_with([')', ']']));
    if bracketed.len() == width { bracketed } else { plain }
}

/// `frequency (Hz)` is one cell: what stands in brackets belongs to the name before it.
fn merged_units(text: &str, plain: &[Cell]) -> Vec<Cell> {
    let mut merged: Vec<Cell> = Vec::new();
    let named = plain.iter().any(|cell| !words(text, *cell).starts_with(['(', '[']));
    for cell in plain {
        match merged.last_mut() {
            Some(last) if named && words(text, *cell).starts_with(['(', '[']) && !words(text, *last).ends_with([')', ']']) => {
                last.end = cell.end;
            }
            _ => merged.push(*cell),
        }
    }
    merged
}

fn split_at(text: &str, line: Cell, ends: impl Fn(&str, &str) -> bool) -> Vec<Cell> {
    let (mut cells, mut start) = (Vec::new(), line.start as usize);
    let end = line.end as usize;
    let mut push = |from: usize, to: usize| {
        let words = text.get(from..to).unwrap_or("");
        let (ahead, length) = (words.len() - words.trim_start().len(), words.trim().len());
        if length > 0 {
            cells.push(Cell { start: (from + ahead) as u32, end: (from + ahead + length) as u32, quoted: false });
        }
    };
    for (at, _) in words(text, line).char_indices().map(|(at, c)| (at + line.start as usize, c)) {
        let (before, after) = (text.get(start..at).unwrap_or(""), text.get(at..end).unwrap_or(""));
        if at > start && ends(before, after) {
            push(start, at);
            start = at;
        }
    }
    push(start, end);
    cells
}

/// Units below names, by the column of the text where they stand: some names have none.
pub(super) fn units_below(text: &str, header: &[Cell], units: &[Cell]) -> Vec<Cell> {
    let column = |at: u32| {
        let before = text.get(..at as usize).unwrap_or("");
        let begin = before.rfind(['\n', '\r']).map_or(0, |place| place + 1);
        before.get(begin..).unwrap_or("").chars().count()
    };
    let centre = |cell: &Cell| column(cell.start) + column(cell.end);
    let mut below = vec![Cell { start: 0, end: 0, quoted: false }; header.len()];
    for unit in units {
        let nearest = header.iter().enumerate().min_by_key(|(_, name)| centre(name).abs_diff(centre(unit)));
        if let Some(place) = nearest.and_then(|(index, _)| below.get_mut(index)) {
            *place = *unit;
        }
    }
    below
}
