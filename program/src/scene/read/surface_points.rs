//! Files that hold a sliding profile or surface.
//!
//! ```text
//! x (µm), h (nm)        0.1 0.4 0.2 …         x (µm), y (µm), z (nm)
//! 0,      12            0.0 0.3 0.5 …         0,      0,      12
//! 0.1,    15            rows of heights       0.1,    0,      15
//! ```

use super::section::Section;
use super::table_columns::{Columns, Wanted};
use crate::scene::check::Units;
use crate::scene::delimited::{DelimitedTable, Options};
use crate::scene::diagnostic::{Place, SceneError, SourceText};
use crate::scene::document::Document;
use crate::scene::units::Dimension;

/// Points of a profile, and heights of a map, at most.
const MOST_POINTS: usize = 1 << 22;
/// Two neighbouring distances differ by less than this part, or the places are not evenly spaced.
const EVEN: f64 = 1e-3;
const PROFILE_HELP: &str = "the header is such as: x (µm), h (nm)";
const MAP_HELP: &str = "write rows of numbers, or a header such as: x (µm), y (µm), z (nm)";
const X: &[&str] = &["x", "lateral", "position", "distance", "xposition", "scanlength"];
const Y: &[&str] = &["y", "yposition"];
const Z: &[&str] = &["h", "z", "height", "zheight", "totalprofile", "profile", "topography"];

/// Heights on a regular grid: `across` along x, with their pitch.
pub(super) struct Grid {
    pub(super) across: usize,
    pub(super) heights: Vec<f64>,
    /// Distance of two heights along x and along y.
    pub(super) pitch: [f64; 2],
    pub(super) notes: Vec<String>,
}

fn source_of<'d>(table: &Section<'_>, document: &'d Document) -> Result<(String, &'d SourceText), SceneError> {
    let file = table.required_text("file")?;
    let source = document
        .attached(file)
        .ok_or_else(|| table.wrong("file", format!("`{}` = {file:?} was not read with the scene", table.full("file")), "this file"))?;
    Ok((file.to_owned(), source))
}

/// Columns, the place of their header, and what was chosen in reading them.
type Found = (Vec<Vec<f64>>, Place, Vec<String>);

/// Columns of a table by name, in coherent units.
fn columns_of(
    table: &Section<'_>,
    source: &SourceText,
    file: &str,
    wanted: &[(&'static str, &[&str])],
    path: (&str, &str),
    help: &'static str,
) -> Result<Found, SceneError> {
    let read = DelimitedTable::read(source, &Options { help })?;
    let stated = table.table("columns");
    let Some(block) = read.blocks().first() else { return Err(table.wrong("file", format!("{file:?} is empty"), "this file")) };
    let columns = Columns::new(&read, block, file, table.units(), (path, stated.as_ref()), help);
    columns.checked()?;
    if let Some(second) = read.blocks().get(1) {
        let message = format!("{file:?} has a second table");
        return Err(SceneError::at(&read.row_place(&second.header), message, "one table only").help("put it into a file of its own"));
    }
    let rows: Vec<_> = read.rows(block).collect();
    if rows.len() > MOST_POINTS {
        let message = format!("{file:?} has {} rows", rows.len());
        return Err(SceneError::at(&columns.header_place(), message, format!("at most {MOST_POINTS}: leave every other one out")));
    }
    let mut buffer = String::new();
    let mut found = Vec::with_capacity(wanted.len());
    for &(word, names) in wanted {
        let Some(column) = columns.find(&Wanted { word, dimension: Dimension::LENGTH, names })? else {
            let message = format!("{file:?} has no column `{word}`");
            return Err(SceneError::at(&columns.header_place(), message, "no such column").help(help));
        };
        found.push(rows.iter().map(|row| columns.number(row, &column, &mut buffer)).collect::<Result<Vec<f64>, SceneError>>()?);
    }
    Ok((found, columns.header_place(), read.notes().to_vec()))
}

/// A profile over x, on evenly spaced places.
pub(super) fn profile(table: &Section<'_>, document: &Document) -> Result<Grid, SceneError> {
    let (file, source) = source_of(table, document)?;
    let path = ("columns", "in [sliding.profile]");
    let (mut found, place, mut notes) = columns_of(table, source, &file, &[("x", X), ("h", Z)], path, PROFILE_HELP)?;
    let (h, x) = (found.pop().unwrap_or_default(), found.pop().unwrap_or_default());
    let n = x.len();
    if n < 8 {
        return Err(SceneError::at(&place, format!("{file:?} has {n} rows"), "needs at least 8 below this line"));
    }
    if let Some(pair) = x.windows(2).find(|pair| pair[1] <= pair[0]) {
        let message = format!("`x` = {:e} in {file:?} is not above the place before it, {:e}", pair[1], pair[0]);
        return Err(SceneError::at(&place, message, "must rise from row to row"));
    }
    let pitch = (x[n - 1] - x[0]) / (n - 1) as f64;
    let even = x.windows(2).all(|pair| ((pair[1] - pair[0]) / pitch - 1.0).abs() < EVEN);
    let heights = if even {
        h
    } else {
        notes.push(format!("{file:?}: its places are not evenly spaced; heights between them lie on straight lines"));
        let mut piece = 0;
        let height = |i: usize| {
            let place = x[0] + pitch * i as f64;
            while piece + 2 < n && x[piece + 1] < place {
                piece += 1;
            }
            let part = ((place - x[piece]) / (x[piece + 1] - x[piece])).clamp(0.0, 1.0);
            h[piece] + part * (h[piece + 1] - h[piece])
        };
        (0..n).map(height).collect()
    };
    Ok(Grid { across: n, heights, pitch: [pitch; 2], notes })
}

/// A map: rows of heights, or columns x, y, z.
pub(super) fn map(table: &Section<'_>, document: &Document) -> Result<Grid, SceneError> {
    let (file, source) = source_of(table, document)?;
    match rows_of_numbers(source, &file)? {
        Some((across, heights)) => {
            if table.node().get("columns").is_some() {
                let message = format!("`{}` belongs to a file of x, y and z, but {file:?} holds rows of heights", table.full("columns"));
                return Err(SceneError::at(&table.key_place("columns"), message, "leave it out"));
            }
            let (pixel, unit) = match table.units() {
                Units::Si => (table.required_number("pixel")?, table.required_number("height_unit")?),
                Units::Reduced => (reduced_pixel(table, across)?, table.number("height_unit")?.unwrap_or(1.0)),
            };
            let heights: Vec<f64> = heights.iter().map(|h| h * unit).collect();
            Ok(Grid { across, heights, pitch: [pixel; 2], notes: Vec::new() })
        }
        None => {
            if let Some(key) = ["pixel", "height_unit"].into_iter().find(|key| table.node().get(key).is_some()) {
                let message = format!("`{}` belongs to a map of rows, but {file:?} has columns", table.full(key));
                return Err(SceneError::at(&table.key_place(key), message, "leave it out"));
            }
            let path = ("columns", "in [sliding.surface]");
            let (found, place, notes) = columns_of(table, source, &file, &[("x", X), ("y", Y), ("z", Z)], path, MAP_HELP)?;
            on_grid(&found, &place, &file).map(|(across, heights, pitch)| Grid { across, heights, pitch, notes })
        }
    }
}

/// In reduced units the period is 2π; the number of columns fixes the pixel once the ends are known, so any length serves.
fn reduced_pixel(table: &Section<'_>, across: usize) -> Result<f64, SceneError> {
    if table.node().get("pixel").is_some() {
        let message = format!("`{}`: in reduced units the period is 2π", table.full("pixel"));
        return Err(table.wrong("pixel", message, "leave it out"));
    }
    Ok(std::f64::consts::TAU / across as f64)
}

/// Rows of as many numbers each; none if the first line that is no remark holds words.
fn rows_of_numbers(source: &SourceText, file: &str) -> Result<Option<(usize, Vec<f64>)>, SceneError> {
    let (mut across, mut heights) = (0, Vec::new());
    let mut start = 0;
    for (index, line) in source.text().split('\n').enumerate() {
        let span = start..start + line.len();
        start += line.len() + 1;
        let line = line.trim();
        if line.is_empty() || line.starts_with(['#', '%']) {
            continue;
        }
        let before = heights.len();
        for cell in line.split(|c: char| matches!(c, ',' | ';') || c.is_whitespace()).filter(|cell| !cell.is_empty()) {
            match cell.parse::<f64>() {
                Ok(value) if value.is_finite() => heights.push(value),
                _ if across == 0 => return Ok(None),
                _ => {
                    let place = Place { source: source.clone(), span };
                    let message = format!("{cell:?} in line {} of {file:?} is no number", index + 1);
                    return Err(SceneError::at(&place, message, "a finite number, with a point for its decimals"));
                }
            }
        }
        let here = heights.len() - before;
        if across == 0 {
            across = here;
        }
        if here != across || heights.len() > MOST_POINTS {
            let place = Place { source: source.clone(), span };
            let message = if here == across {
                format!("{file:?} has more than {MOST_POINTS} heights")
            } else {
                format!("line {} of {file:?} has {here} heights, and the first row {across}", index + 1)
            };
            return Err(SceneError::at(&place, message, "every row has as many heights as the first one"));
        }
    }
    Ok((across > 0).then_some((across, heights)))
}

/// Columns x, y, z as rows along x; every node must be there once.
fn on_grid(columns: &[Vec<f64>], place: &Place, file: &str) -> Result<(usize, Vec<f64>, [f64; 2]), SceneError> {
    let [x, y, z] = columns else { return Err(SceneError::at(place, format!("{file:?} has no columns"), "here")) };
    let (xs, dx) = places(x, "x", place, file)?;
    let (ys, dy) = places(y, "y", place, file)?;
    let mut heights = vec![f64::NAN; xs.saturating_mul(ys).min(2 * MOST_POINTS)];
    let low = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let (x0, y0) = (low(x), low(y));
    if heights.len() == x.len() {
        for ((x, y), z) in x.iter().zip(y).zip(z) {
            let (i, j) = (((x - x0) / dx).round() as usize, ((y - y0) / dy).round() as usize);
            if let Some(height) = heights.get_mut(j * xs + i) {
                *height = *z;
            }
        }
    }
    if heights.iter().any(|h| h.is_nan()) {
        let message = format!("{file:?} has {} rows, which do not fill a grid of {xs} by {ys} places", x.len());
        return Err(SceneError::at(place, message, "every place of a regular grid, once"));
    }
    Ok((xs, heights, [dx, dy]))
}

/// How many different places a column has, and their distance.
fn places(values: &[f64], name: &str, place: &Place, file: &str) -> Result<(usize, f64), SceneError> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let span = sorted.last().copied().unwrap_or(0.0) - sorted.first().copied().unwrap_or(0.0);
    sorted.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * span);
    let count = sorted.len();
    let pitch = span / (count.max(2) - 1) as f64;
    let even = sorted.windows(2).all(|pair| ((pair[1] - pair[0]) / pitch - 1.0).abs() < EVEN);
    if count < 4 || !even {
        let what = if count < 4 { format!("has {count} different places") } else { "is not evenly spaced".to_owned() };
        return Err(SceneError::at(place, format!("the column `{name}` of {file:?} {what}"), "at least 4 evenly spaced places"));
    }
    Ok((count, pitch))
}
