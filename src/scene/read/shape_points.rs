//! A CSV file that holds the shape of an indenter, as a profilometer measures it.
//!
//! ```text
//! # a comment
//! r (µm), z (nm)
//! 0,      0
//! 10,     52
//! ```
//! One header line: `r`, the distance from the axis, and `z`, the height above the lowest point, each with a unit in SI scenes; other columns are
//! passed over. Both start at 0 and rise from row to row.

use super::measured_table::{cells_of, headers, lines_of, number, written};
use super::section::Section;
use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::document::Document;
use crate::scene::units::Dimension;

/// Rows: fewer have no smooth shape, more are better thinned.
const ROWS: std::ops::RangeInclusive<usize> = 4..=2000;
const HELP: &str = "the header is such as: r (µm), z (nm), from the axis outwards; of a line scan x, z give r = |x − x of its lowest point| and the mean of both sides";

/// The points (r, z) of the file that `key` names.
pub(super) fn shape_points(table: &Section<'_>, document: &Document, key: &str) -> Result<Vec<(f64, f64)>, SceneError> {
    let file = table.required_text(key)?;
    let Some(source) = document.attached(file) else {
        let message = format!("`{}` = {file:?} was not read with the scene", table.full(key));
        return Err(table.wrong(key, message, "this file"));
    };
    let mut lines = lines_of(source);
    let Some(first) = lines.next() else {
        let place = Place { source: source.clone(), span: 0..0 };
        return Err(SceneError::at(&place, format!("{file:?} is empty"), "here").help(HELP));
    };
    let known = |name: &str| (name == "z").then_some(Dimension::LENGTH);
    let headers = headers(&first, table.units(), ("r", Dimension::LENGTH), known, HELP)?;
    let Some(height) = headers.iter().position(|header| header.name == "z") else {
        return Err(SceneError::at(&first, format!("{file:?} has no column `z`"), "no such column").help(HELP));
    };
    let mut points: Vec<(f64, f64)> = Vec::new();
    for line in lines {
        let cells = cells_of(&line);
        if cells.len() != headers.len() {
            let message = format!("this row has {} cells, the header {}", cells.len(), headers.len());
            return Err(SceneError::at(&line, message, "in this row"));
        }
        let mut values = [0.0; 2];
        for (value, index) in values.iter_mut().zip([0, height]) {
            if let (Some(cell), Some(header)) = (cells.get(index), headers.get(index)) {
                *value = number(cell, header, true)?.unwrap_or_default();
            }
        }
        let before = points.last().map(|point| [point.0, point.1]);
        for (k, index) in [0, height].into_iter().enumerate() {
            let Some(cell) = cells.get(index) else { continue };
            let name = if k == 0 { "r" } else { "z" };
            let (now, last) = (values.get(k).copied().unwrap_or_default(), before.and_then(|before| before.get(k).copied()));
            match last {
                None if now != 0.0 => {
                    let message =
                        format!("`{name}` = {} in the first row: the shape starts on its axis, at its lowest point", written(cell));
                    return Err(SceneError::at(cell, message, "must be 0"));
                }
                Some(last) if now <= last => {
                    let message = format!("`{name}` = {} does not increase: the row before has {last:e}", written(cell));
                    return Err(SceneError::at(cell, message, "must be larger"));
                }
                _ => {}
            }
        }
        points.push((values[0], values[1]));
    }
    if ROWS.contains(&points.len()) {
        return Ok(points);
    }
    Err(SceneError::at(&first, format!("{file:?} has {} rows", points.len()), "needs 4 to 2000 below this line"))
}
