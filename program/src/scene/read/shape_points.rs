//! A file that holds the shape of an indenter: the shape itself, a scan along a line, or a map.
//!
//! ```text
//! r (µm), z (nm)        x (µm), z (nm)        x (µm), y (µm), z (nm)
//! 0,      0             -10,    1061          -10,    -10,    2110
//! 10,     52            -9.9,   1040          -9.9,   -10,    2089
//! ```
//! With `r`, the distance from the axis, both columns start at 0 and rise. A scan is levelled, centred and averaged ([`viscotack::indentation::scan`]); the
//! table `indentation.scan` says what is known of it.

use super::section::Section;
use super::table_columns::{Column, Columns, Wanted};
use crate::scene::delimited::{DelimitedTable, Options};
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::MeasuredShape;
use crate::scene::units::Dimension;
use viscotack::indentation::scan::{Apex, ScanOptions, axisymmetric};

/// Rows of a shape: fewer have no smooth shape, more are better thinned.
const ROWS: std::ops::RangeInclusive<usize> = 4..=2000;
/// Points of a scan, at most.
const MOST_POINTS: usize = 2_000_000;
/// The largest residual over the height of a scan, if the scene states none.
const LARGEST_RESIDUAL: f64 = 0.05;
const HELP: &str =
    "the header is such as: r (µm), z (nm), from the axis outwards; or of a scan x (µm), z (nm); of a map x (µm), y (µm), z (nm)";
const NAMES: [(&str, &[&str]); 4] = [
    ("r", &["r", "radius"]),
    ("x", &["x", "lateral", "position", "distance", "xposition", "scanlength"]),
    ("y", &["y", "yposition"]),
    ("z", &["z", "height", "zheight", "totalprofile", "profile", "topography"]),
];
/// Keys that only a scan has.
const OF_A_SCAN: [&str; 3] = ["apex", "to", "largest_residual"];

/// Points of a shape, and what was measured.
pub(super) type Shape = (Vec<(f64, f64)>, MeasuredShape);

/// The shape of the file that `key` names.
pub(super) fn shape_points(table: &Section<'_>, document: &Document, key: &str) -> Result<Shape, SceneError> {
    let file = table.required_text(key)?;
    let Some(source) = document.attached(file) else {
        let message = format!("`{}` = {file:?} was not read with the scene", table.full(key));
        return Err(table.wrong(key, message, "this file"));
    };
    let read = DelimitedTable::read(source, &Options { help: HELP })?;
    let scan = table.table("scan");
    let stated = scan.as_ref().and_then(|scan| scan.table("columns"));
    let path = ("scan.columns", "in [indentation]");
    let Some(block) = read.blocks().first() else { return Err(table.wrong(key, format!("{file:?} is empty"), "this file")) };
    let columns = Columns::new(&read, block, file, table.units(), (path, stated.as_ref()), HELP);
    columns.checked()?;
    if let Some(second) = read.blocks().get(1) {
        let line = read.rows(second).next().and_then(|row| row.first().map(|cell| read.line(*cell))).unwrap_or(0);
        let message = format!("{file:?} has a second table from line {line} on");
        return Err(SceneError::at(&read.row_place(&second.header), message, "one table only").help("put it into a file of its own"));
    }
    let find = |word: &'static str| {
        let names = NAMES.iter().find(|entry| entry.0 == word).map_or(&[][..], |entry| entry.1);
        columns.find(&Wanted { word, dimension: Dimension::LENGTH, names })
    };
    let Some(height) = find("z")? else {
        return Err(SceneError::at(&columns.header_place(), format!("{file:?} has no column `z`"), "no such column").help(HELP));
    };
    let [radius, along, across] = [find("r")?, find("x")?, find("y")?];
    // A column that the scene calls r is no x, whatever its name, unless the scene calls it x as well.
    let named = stated.as_ref().is_some_and(|stated| stated.node().get("x").is_some());
    let along = along.filter(|along| named || radius.as_ref().is_none_or(|radius| radius.index != along.index));
    let mut notes = read.notes().to_vec();
    let used: Vec<usize> =
        [Some(&height), radius.as_ref(), along.as_ref(), across.as_ref()].into_iter().flatten().map(|column| column.index).collect();
    let unused: Vec<String> = columns
        .headers()
        .into_iter()
        .enumerate()
        .filter(|(index, name)| !used.contains(index) && !name.is_empty())
        .map(|(_, name)| format!("`{name}`"))
        .collect();
    if !unused.is_empty() {
        notes.push(format!("{file:?}: not used: {}", unused.join(", ")));
    }
    let rows: Vec<_> = read.rows(block).collect();
    let mut buffer = String::new();
    let mut numbers =
        |column: &Column| rows.iter().map(|row| columns.number(row, column, &mut buffer)).collect::<Result<Vec<f64>, SceneError>>();
    match (radius, along) {
        (Some(_), Some(second)) => {
            let message = format!("{file:?} has both `r` and `x`");
            Err(SceneError::at(&second.place, message, "a shape or a scan?").help("leave one of the two columns out"))
        }
        (None, None) => {
            Err(SceneError::at(&columns.header_place(), format!("{file:?} has neither a column `r` nor a column `x`"), "no such column")
                .help(HELP))
        }
        (Some(radius), None) => {
            if let (Some(scan), Some(key)) =
                (&scan, OF_A_SCAN.into_iter().find(|key| scan.as_ref().is_some_and(|scan| scan.node().get(key).is_some())))
            {
                let message = format!("`{}` belongs to a scan of x and z, but {file:?} has the shape itself, over r", scan.full(key));
                return Err(scan.wrong(key, message, "leave it out"));
            }
            let (r, z) = (numbers(&radius)?, numbers(&height)?);
            let points = rising(&columns, &read, &rows, [&radius, &height], r.into_iter().zip(z).collect(), file)?;
            Ok((points, MeasuredShape { file: file.to_owned(), scan: None, notes }))
        }
        (None, Some(along)) => {
            if rows.len() > MOST_POINTS {
                let message = format!("{file:?} has {} points", rows.len());
                return Err(SceneError::at(&columns.header_place(), message, format!("at most {MOST_POINTS}: leave every other one out")));
            }
            let x = numbers(&along)?;
            let y = across.as_ref().map(&mut numbers).transpose()?.unwrap_or_else(|| vec![0.0; x.len()]);
            let z = numbers(&height)?;
            let points: Vec<[f64; 3]> = x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect();
            let options = options(scan.as_ref())?;
            let found = axisymmetric(&points, &options).map_err(|refusal| {
                let message = format!("{file:?} gives no shape of an indenter: {refusal}");
                let wrong = SceneError::at(&columns.header_place(), message, "in this scan");
                let own = columns.headers();
                let names = [&along, &height].map(|column| own.get(column.index).cloned().unwrap_or_default());
                let remedy = as_a_shape(&points, &names).or_else(|| remedy(&points, &options));
                wrong.help(remedy.unwrap_or_else(|| {
                    "the apex must lie inside the scan, and the heights must change steadily from it on both sides".to_owned()
                }))
            })?;
            Ok((found.points.clone(), MeasuredShape { file: file.to_owned(), scan: Some(found), notes }))
        }
    }
}

/// What the scene says of the scan.
fn options(scan: Option<&Section<'_>>) -> Result<ScanOptions, SceneError> {
    let mut options = ScanOptions { apex: None, to: None, largest_residual: LARGEST_RESIDUAL };
    if let Some(scan) = scan {
        options.apex = match scan.text("apex") {
            Some("lowest") => Some(Apex::Lowest),
            Some(_) => Some(Apex::Highest),
            None => None,
        };
        options.to = scan.number("to")?;
        options.largest_residual = scan.number("largest_residual")?.unwrap_or(LARGEST_RESIDUAL);
    }
    Ok(options)
}

/// What to type if the points over x are the shape itself, from its axis on.
fn as_a_shape(points: &[[f64; 3]], [along, height]: &[String; 2]) -> Option<String> {
    let starts = points.first().is_some_and(|first| first[0] == 0.0 && first[2] == 0.0);
    let rises = points.windows(2).all(|pair| matches!(pair, [one, other] if other[0] > one[0] && other[2] > one[2]));
    (starts && rises && ROWS.contains(&points.len()))
        .then(|| format!("if x is the distance from the axis, say so in [indentation]: scan.columns = {{ r = {along:?}, z = {height:?} }}"))
}

/// What to type so that the scan gives a shape, tried before it is offered.
fn remedy(points: &[[f64; 3]], options: &ScanOptions) -> Option<String> {
    let works = |options: &ScanOptions| axisymmetric(points, options).ok();
    if options.apex.is_some() && works(&ScanOptions { apex: None, ..*options }).is_some() {
        return Some("the scan is curved the other way: leave indentation.scan.apex out".to_owned());
    }
    for residual in [0.1, 0.2, 0.4] {
        if residual > options.largest_residual
            && let Some(found) = works(&ScanOptions { largest_residual: residual, ..*options })
        {
            let part = found.residual / found.height();
            return Some(format!(
                "if that is meant, add [indentation.scan] largest_residual = {residual} (it is {part:.3}), or end the shape earlier by `to`"
            ));
        }
    }
    let x = points.iter().map(|point| point[0]);
    let (low, high) = x.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let whole = options.to.unwrap_or(0.5 * (high - low));
    (1..12).find_map(|step| {
        let to: f64 = format!("{:.2e}", whole * 0.8_f64.powi(step)).parse().ok()?;
        works(&ScanOptions { to: Some(to), ..*options }).map(|_| format!("end the shape earlier: [indentation.scan] to = {to:e} gives one"))
    })
}

/// Points over r: from (0, 0) on, rising.
fn rising(
    columns: &Columns<'_>,
    read: &DelimitedTable,
    rows: &[&[crate::scene::delimited::Cell]],
    both: [&Column; 2],
    points: Vec<(f64, f64)>,
    file: &str,
) -> Result<Vec<(f64, f64)>, SceneError> {
    let mut before: Option<(f64, f64)> = None;
    for (row, point) in rows.iter().zip(&points) {
        for (name, column, now, last) in
            [("r", both[0], point.0, before.map(|last| last.0)), ("z", both[1], point.1, before.map(|last| last.1))]
        {
            let cell = row.get(column.index).copied();
            let place = cell.map_or_else(|| column.place.clone(), |cell| read.place(cell));
            let written = cell.map(|cell| read.text(cell).into_owned()).unwrap_or_default();
            match last {
                None if now != 0.0 => {
                    let message = format!("`{name}` = {written} in the first row: the shape starts on its axis, at its lowest point");
                    return Err(SceneError::at(&place, message, "must be 0")
                        .help("a scan over both sides has a column x instead of r: it is centred and levelled"));
                }
                Some(last) if now <= last => {
                    let message = format!("`{name}` = {written} does not increase: the row before has {last:e}");
                    return Err(SceneError::at(&place, message, "must be larger")
                        .help("a scan over both sides has a column x instead of r: it is centred and averaged"));
                }
                _ => {}
            }
        }
        before = Some(*point);
    }
    if ROWS.contains(&points.len()) {
        return Ok(points);
    }
    Err(SceneError::at(&columns.header_place(), format!("{file:?} has {} rows", points.len()), "needs 4 to 2000 below this line"))
}
