//! A table of a material: what instruments and spreadsheets write, read without guessing more than a header says.
//!
//! ```text
//! # a comment
//! temperature (°C), frequency (Hz), storage modulus (MPa), loss modulus (MPa)
//! -40,              0.1,            812.0,                 96.1
//! ```
//! How lines and cells are found: [`crate::scene::delimited`]. A unit stands in the header after the name, in a line of its own below the names, or in
//! `material.columns` of the scene. Other columns are passed over, with a note.

use super::column_names::{Role, spoken, word};
use super::material_choice::{Choice, chosen};
use super::material_rows::{Columns, MaterialRows};
use super::material_strain::stretch_to_young;
use super::material_taking::Taking;
use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Document, Value};
use crate::scene::typed::{MaterialData, MeasuredRow, MeasuredSort};

/// Reads the files that the material of a document names.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    for path in ["material.data", "material.shift.table"].into_iter().chain(super::decks::PATHS) {
        let Some(node) = document.root.at(path) else { continue };
        let (Value::Text(name), place) = (node.value.clone(), node.place.clone()) else { continue };
        document.attach_table(path, &name, &place)?;
    }
    Ok(())
}

/// The table that `material.data` names.
pub(super) fn material_data(table: &Section<'_>, document: &Document, poisson_ratio: Option<f64>) -> Result<MaterialData, SceneError> {
    let file = table.required_text("data")?;
    let rows = MaterialRows::read(table, document, "data", file)?;
    let mut notes = rows.notes.clone();
    let choices = rows.blocks.iter().map(|columns| chosen(columns, &rows.stated, file)).collect::<Result<Vec<Choice>, _>>()?;
    let sort = choices.first().map_or(MeasuredSort::Moduli, |choice| choice.sort);
    if let Some(columns) = choices.iter().zip(&rows.blocks).find_map(|(choice, columns)| (choice.sort != sort).then_some(columns)) {
        let message = format!("a part of {file:?} holds another quantity than the first");
        return Err(SceneError::at(&columns.header, message, "these columns").help("keep one of the two parts in the file"));
    }
    for (role, ..) in &rows.stated {
        if let (false, Some(columns)) = (choices.iter().any(|choice| choice.roles.contains(role)), table.table("columns")) {
            let main = choices.first().map_or(Role::Storage, |choice| choice.main);
            let message = format!("`{}` has no effect on a table of the {}", columns.full(word(*role)), spoken(main));
            return Err(columns.wrong(word(*role), message, "leave it out"));
        }
    }
    temperatures_given(&rows, file)?;
    let mut data = MaterialData { file: file.to_owned(), sort, rows: Vec::new(), warnings: Vec::new(), notes: Vec::new() };
    let mut taking = Taking::of(&rows);
    for ((block, columns), choice) in rows.blocks().zip(&choices) {
        let stretch = stretch_to_young(table, columns, choice, poisson_ratio)?;
        for note in &choice.notes {
            if !notes.contains(note) {
                notes.push(note.clone());
            }
        }
        data.rows.reserve(block.len());
        for row in rows.table.rows(block) {
            data.rows.extend(taking.row(row, columns, choice, stretch)?);
        }
    }
    if let Some((lacking, line)) = taking.lacking {
        notes.push(format!("{file:?}: {lacking} rows without a value in a column that is used are passed over, the first is line {line}"));
    }
    if let Some(first) = choices.first().zip(rows.blocks.first()) {
        let others = first.1.others(&first.0.used);
        if !others.is_empty() {
            let names: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
            notes.push(format!("{file:?}: columns that are not used: {}", names.join(", ")));
        }
    }
    if data.rows.len() < 4 {
        let message = format!("{file:?} has {} rows of numbers", data.rows.len());
        return Err(SceneError::at(&rows.header, message, "needs at least four below this line"));
    }
    data.warnings = oddities(&data);
    match taking.tangent.compared(file) {
        Some(Ok(note)) => notes.push(note),
        Some(Err(warning)) => data.warnings.push(warning),
        None => {}
    }
    data.notes = notes;
    Ok(data)
}

/// Refuses several blocks of which some have no temperature: what differs between them?
fn temperatures_given(rows: &MaterialRows, file: &str) -> Result<(), SceneError> {
    let lacks = |columns: &Columns| columns.temperature.is_none() && !columns.has(Role::Temperature);
    let own = rows.blocks().filter(|(block, _)| block.own_header).count();
    let lacking = rows.blocks().filter(|(_, columns)| lacks(columns)).last();
    let some = rows.blocks.iter().any(|columns| !lacks(columns));
    let Some((_, columns)) = lacking.filter(|_| own > 1 || some) else { return Ok(()) };
    let message =
        format!("{file:?} has {} blocks of rows, and nothing gives the temperature of the one below this line", rows.blocks.len());
    Err(SceneError::at(&columns.header, message, "of which temperature?").help(
        "put a line such as `Temperature: 25 °C` above each block; or leave repeated headers out, if all rows are of one temperature",
    ))
}

/// Frequencies and times outside are no instrument's (a factor 2π and a few decades granted).
const USUAL_TIMES: [f64; 2] = [1e-9, 1e9];

/// What is odd about a table, but can be read.
fn oddities(data: &MaterialData) -> Vec<String> {
    let mut odd = Vec::new();
    let same = |left: &MeasuredRow, right: &MeasuredRow| left.temperature == right.temperature;
    let falls = data.rows.windows(2).filter(|pair| same(&pair[0], &pair[1])).map(|pair| pair[1].at > pair[0].at).collect::<Vec<_>>();
    let rises = falls.iter().filter(|&&up| up).count();
    let repeated = data.rows.windows(2).filter(|pair| same(&pair[0], &pair[1]) && pair[1].at.total_cmp(&pair[0].at).is_eq()).count();
    if rises.min(falls.len() - rises) > repeated {
        odd.push("the rows are not in the order of frequency or time; they are sorted".to_owned());
    }
    let mut places: Vec<(u64, u64)> = data.rows.iter().map(|row| (row.temperature.unwrap_or(0.0).to_bits(), row.at.to_bits())).collect();
    places.sort_unstable();
    let double = places.windows(2).filter(|pair| pair[0] == pair[1]).count();
    if double > 0 {
        odd.push(format!("{double} rows repeat a frequency or time at the same temperature; all are used"));
    }
    let strange = data.rows.iter().filter(|row| !(USUAL_TIMES[0]..=USUAL_TIMES[1]).contains(&row.at)).count();
    if strange > 0 && data.rows.iter().any(|row| row.temperature.is_some()) {
        odd.push(format!("{strange} frequencies or times are outside 1e-9 to 1e9, at their own temperatures: is the unit right?"));
    }
    odd
}
