//! The law of attraction of [adhesion]: `law` with a range or a largest tension, or a table of it.
//!
//! ```text
//! gap (nm), stress (MPa)        the tension, positive or negative: far apart surfaces attract, which tells the sign
//! 0.3,      -40
//! 0.5,        2
//! 5,          0
//! ```

use super::section::Section;
use super::table_columns::{Columns, Wanted};
use crate::scene::delimited::{DelimitedTable, Options};
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::SceneAttraction;
use crate::scene::units::Dimension;
use viscotack::finite_range::law::{Attraction, Law};

/// Rows of a table: fewer make no curve, more are better thinned.
const ROWS: std::ops::RangeInclusive<usize> = 3..=10_000;
/// The half-width of the ramp that ends a Dugdale law, over the range, where a scene names none.
const DEFAULT_RAMP: f64 = 0.1;
const HELP: &str = "the header is such as: gap (nm), stress (MPa)";
/// Keys of an edge, whose place a law takes.
const OF_AN_EDGE: [&str; 4] = ["trailing_work_of_adhesion", "leading_work_of_adhesion", "by_speed", "interaction_range"];
/// Keys that a law has and a table brings along.
const OF_A_LAW: [&str; 4] = ["work_of_adhesion", "range", "peak_stress", "ramp"];

/// Whether [adhesion] names a law or a table of it.
pub(super) fn is_given(top: &Section<'_>) -> bool {
    top.node().get("adhesion").is_some_and(|table| ["law", "table"].iter().any(|key| table.get(key).is_some()))
}

/// Refuses what belongs to a law, in a scene that has none.
pub(super) fn without(top: &Section<'_>, owner: &str) -> Result<(), SceneError> {
    let Some(table) = top.table("adhesion") else { return Ok(()) };
    for key in ["law", "table", "range", "peak_stress", "ramp", "columns"] {
        if table.node().get(key).is_some() {
            let message = format!("`{}` belongs to a law of attraction, and {owner} has none", table.full(key));
            return Err(SceneError::at(&table.key_place(key), message, "leave it out"));
        }
    }
    Ok(())
}

/// Reads the law; none where [adhesion] names no law. `unit` is the unit of `work_of_adhesion` in a reduced scene, in its pressure times
/// its length of gaps (1 in SI units).
pub(super) fn read(top: &Section<'_>, document: &Document, unit: f64) -> Result<Option<SceneAttraction>, SceneError> {
    if !is_given(top) {
        return Ok(None);
    }
    let table = top.required_table("adhesion", "it holds the law")?;
    let way = table.exactly_one(&["law", "table"])?;
    if table.node().get("process_zone").is_some() {
        let message = format!(
            "`{}` and `{}` exclude each other: a process zone is an edge, a law acts at a distance",
            { table.full("process_zone") },
            table.full(way)
        );
        return Err(SceneError::at(&table.key_place("process_zone"), message, "leave one of the two out"));
    }
    if let Some(key) = OF_AN_EDGE.into_iter().find(|key| table.node().get(key).is_some()) {
        let message = format!("`{}` belongs to an edge with a process zone, but `{}` is given", table.full(key), table.full(way));
        return Err(SceneError::at(&table.key_place(key), message, "leave it out"));
    }
    if way == "table" { from_table(&table, document) } else { from_word(&table, unit) }.map(Some)
}

fn from_word(table: &Section<'_>, unit: f64) -> Result<SceneAttraction, SceneError> {
    if table.node().get("columns").is_some() {
        let message = format!("`{}` belongs to a table of the law", table.full("columns"));
        return Err(SceneError::at(&table.key_place("columns"), message, "leave it out"));
    }
    let (word, law) = match table.required_text("law")? {
        "lennard_jones" => ("lennard_jones", Law::LennardJones),
        "dugdale" => ("dugdale", Law::Dugdale { ramp: table.number("ramp")?.unwrap_or(DEFAULT_RAMP) }),
        "cosine" => ("cosine", Law::Cosine),
        _ => ("exponential", Law::Exponential),
    };
    if word != "dugdale" && table.node().get("ramp").is_some() {
        let message = format!("`{}` belongs to the law \"dugdale\"", table.full("ramp"));
        return Err(SceneError::at(&table.key_place("ramp"), message, "leave it out"));
    }
    let work = table.required_number("work_of_adhesion")? * unit;
    let key = table.exactly_one(&["range", "peak_stress"])?;
    let value = table.required_number(key)?;
    let made = if key == "range" { Attraction::new(law, work, value) } else { Attraction::with_peak_stress(law, work, value) };
    let attraction = made.map_err(|refusal| table.wrong(key, format!("the law of [adhesion] cannot be made: {refusal}"), "here"))?;
    Ok(SceneAttraction { attraction, word, notes: Vec::new() })
}

fn from_table(table: &Section<'_>, document: &Document) -> Result<SceneAttraction, SceneError> {
    if let Some(key) = OF_A_LAW.into_iter().find(|key| table.node().get(key).is_some()) {
        let message = format!("`{}` is given, and so is a table of the law", table.full(key));
        return Err(SceneError::at(&table.key_place(key), message, "leave it out: it follows from the table"));
    }
    let file = table.required_text("table")?;
    let Some(source) = document.attached(file) else {
        return Err(table.wrong("table", format!("`{}` = {file:?} was not read with the scene", table.full("table")), "this file"));
    };
    let read = DelimitedTable::read(source, &Options { help: HELP })?;
    let stated = table.table("columns");
    let Some(block) = read.blocks().first() else { return Err(table.wrong("table", format!("{file:?} is empty"), "this file")) };
    let columns = Columns::new(&read, block, file, table.units(), (("columns", "in [adhesion]"), stated.as_ref()), HELP);
    columns.checked()?;
    if let Some(second) = read.blocks().get(1) {
        let message = format!("{file:?} has a second table");
        return Err(SceneError::at(&read.row_place(&second.header), message, "one table only").help("put it into a file of its own"));
    }
    let numbers = |word, dimension, names| {
        let Some(column) = columns.find(&Wanted { word, dimension, names })? else {
            let message = format!("{file:?} has no column `{word}`");
            return Err(SceneError::at(&columns.header_place(), message, "no such column").help(HELP));
        };
        let mut buffer = String::new();
        read.rows(block).map(|row| columns.number(row, &column, &mut buffer)).collect::<Result<Vec<f64>, SceneError>>()
    };
    let gaps = numbers("gap", Dimension::LENGTH, &["gap", "distance", "separation", "opening"][..])?;
    let mut stresses = numbers("stress", Dimension::PRESSURE, &["stress", "tension", "traction", "pressure"][..])?;
    if !ROWS.contains(&gaps.len()) {
        let message = format!("{file:?} has {} rows", gaps.len());
        return Err(SceneError::at(&columns.header_place(), message, "needs 3 to 10000 below this line"));
    }
    let mut notes = read.notes().to_vec();
    // Far apart the surfaces attract, whichever sign the file gives that.
    if stresses.iter().rev().find(|stress| **stress != 0.0).is_some_and(|last| *last > 0.0) {
        notes.push(format!("{file:?}: a positive stress is a tension, as at the largest gaps"));
        stresses.iter_mut().for_each(|stress| *stress = -*stress);
    } else {
        notes.push(format!("{file:?}: a negative stress is a tension, as at the largest gaps"));
    }
    let attraction = Attraction::from_table(&gaps, &stresses)
        .map_err(|refusal| SceneError::at(&columns.header_place(), format!("{file:?} gives no law: {refusal}"), "in this table"))?;
    Ok(SceneAttraction { attraction, word: "table", notes })
}
