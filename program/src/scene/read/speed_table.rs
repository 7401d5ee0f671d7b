//! `adhesion.by_speed.file`: a table of works of adhesion over speed, put where the key stands.
//!
//! ```text
//! # any line that begins so is a comment
//! speed, trailing_work_of_adhesion, leading_work_of_adhesion        or: speed, work_of_adhesion
//! 1e-6, 0.05, 0.03                                                  numbers in SI (or reduced) units, or with a unit, as in a scene
//! 10 µm/s, 80 mJ/m², 31 mJ/m²
//! ```
//! A unit may stand in the header, too, as in other tables: `speed (µm/s)`.

use super::column_names::split;
use crate::scene::catalogue;
use crate::scene::delimited::{Block, Cell, DelimitedTable, Options, Scale, bare_unit};
use crate::scene::diagnostic::{SceneError, SourceText};
use crate::scene::document::{Document, Entry, Node, Value};

/// More lines than these are no table that a person made.
const MOST_LINES: usize = 10_000;
const HELP: &str = "the header is such as: speed (µm/s), work_of_adhesion (mJ/m²)";

/// Replaces `adhesion.by_speed.file` by the entries of that file, as `adhesion.by_speed.table`.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    let Some(node) = document.root.at("adhesion.by_speed.file") else { return Ok(()) };
    let Value::Text(name) = node.value.clone() else { return Ok(()) };
    let place = node.place.clone();
    if document.root.at("adhesion.by_speed.table").is_some() {
        let message = "`adhesion.by_speed.file` and `adhesion.by_speed.table` exclude each other";
        return Err(SceneError::at(&place, message, "leave one of the two out"));
    }
    document.attach_table("adhesion.by_speed.file", &name, &place)?;
    let Some(source) = document.attached(&name).cloned() else { return Ok(()) };
    let (entries, notes) = entries(&source)?;
    let list = Node { value: Value::List(entries), place: place.clone() };
    document.note(notes);
    if let Some(Value::Table(given)) = value_at(&mut document.root, &["adhesion", "by_speed"]) {
        given.retain(|entry| entry.key != "file");
        given.push(Entry { key: "table".into(), key_place: place, node: list });
    }
    Ok(())
}

fn value_at<'a>(node: &'a mut Node, path: &[&str]) -> Option<&'a mut Value> {
    let Some((first, rest)) = path.split_first() else { return Some(&mut node.value) };
    match &mut node.value {
        Value::Table(entries) => value_at(&mut entries.iter_mut().find(|entry| entry.key == *first)?.node, rest),
        _ => None,
    }
}

/// The rows as tables, by the names of the header.
fn entries(source: &SourceText) -> Result<(Vec<Node>, Vec<String>), SceneError> {
    let table = DelimitedTable::read_with_units(source, &Options { help: HELP })?;
    let mut found: Vec<Node> = Vec::new();
    for block in table.blocks() {
        let names = names(&table, block);
        for row in table.rows(block) {
            let whole = table.row_place(row);
            if found.len() == MOST_LINES {
                return Err(SceneError::at(&whole, format!("{:?} has more than {MOST_LINES} lines", source.name()), "make it shorter"));
            }
            let members = names
                .iter()
                .zip(row)
                .map(|(name, cell)| Entry {
                    key: name.key.clone(),
                    key_place: table.place(name.cell),
                    node: Node { value: value(&table, *cell, name.unit.as_deref()), place: table.place(*cell) },
                })
                .collect();
            found.push(Node { value: Value::Table(members), place: whole });
        }
    }
    let mut notes = table.notes().to_vec();
    for stated in table.blocks().iter().flat_map(|block| &block.stated) {
        if !table.text(stated.line).starts_with(['#', '%', '/']) {
            notes.push(format!("{:?}: line {} is passed over", source.name(), table.line(stated.line)));
        }
    }
    Ok((found, notes))
}

/// A column: the key that its cells stand for, and its unit, if the header has one.
struct Name {
    key: String,
    cell: Cell,
    unit: Option<String>,
}

fn names(table: &DelimitedTable, block: &Block) -> Vec<Name> {
    let known = |name: &str| catalogue::key(&format!("adhesion.by_speed.table[].{}", name.replace(' ', "_"))).is_some();
    let name = |(index, cell): (usize, &Cell)| {
        let below = block.units.get(index).map(|cell| table.text(*cell).into_owned());
        let (key, own) = split(&table.text(*cell), known);
        let unit = own.or(below).map(|unit| bare_unit(&unit).to_owned()).filter(|unit| !unit.is_empty());
        Name { key: key.replace(' ', "_"), cell: *cell, unit }
    };
    block.header.iter().enumerate().map(name).collect()
}

/// A number, with its unit if there is one, or the text of a cell that is none: the check of the scene reads it, or refuses it.
fn value(table: &DelimitedTable, cell: Cell, unit: Option<&str>) -> Value {
    match (table.number(cell, &Scale::ONE, &mut String::new()), unit) {
        (Some(value), None) => Value::Number(value),
        (Some(value), Some(unit)) => Value::Text(format!("{value:e} {unit}")),
        (None, _) => {
            let text = table.text(cell);
            let spelt = DelimitedTable::quantity(&text).map(|(digits, unit)| format!("{digits} {unit}"));
            Value::Text(spelt.unwrap_or_else(|| text.into_owned()))
        }
    }
}
