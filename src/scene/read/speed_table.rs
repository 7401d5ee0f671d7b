//! `adhesion.by_speed.file`: a table of works of adhesion over speed in a CSV file, put where the key stands.
//!
//! ```text
//! # any line that begins so is a comment
//! speed, trailing_work_of_adhesion, leading_work_of_adhesion        or: speed, work_of_adhesion
//! 1e-6, 0.05, 0.03                                                  numbers in SI (or reduced) units, or with a unit, as in a scene
//! 10 µm/s, 80 mJ/m², 31 mJ/m²
//! ```

use crate::scene::diagnostic::{Place, SceneError, SourceText};
use crate::scene::document::{Document, Entry, Node, Value, read_text};
use std::ops::Range;

/// More lines than these are no table that a person made.
const MOST_LINES: usize = 10_000;

/// Replaces `adhesion.by_speed.file` by the entries of that file, as `adhesion.by_speed.table`.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    let Some(node) = document.root.at("adhesion.by_speed.file") else { return Ok(()) };
    let Value::Text(name) = node.value.clone() else { return Ok(()) };
    let place = node.place.clone();
    if document.root.at("adhesion.by_speed.table").is_some() {
        let message = "`adhesion.by_speed.file` and `adhesion.by_speed.table` exclude each other";
        return Err(SceneError::at(&place, message, "leave one of the two out"));
    }
    let text = read_text(&document.folder().join(&name)).map_err(|error| {
        SceneError::at(&place, format!("`adhesion.by_speed.file` = {name:?} cannot be read: {error}"), "this file")
            .help("relative paths start at the scene")
    })?;
    let source = SourceText::new(&name, text);
    let list = Node { value: Value::List(entries(&source)?), place: place.clone() };
    document.add_to_hash(&source);
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

/// The lines as tables, by the names of the first one.
fn entries(source: &SourceText) -> Result<Vec<Node>, SceneError> {
    let place = |span: Range<usize>| Place { source: source.clone(), span };
    let (mut names, mut found): (Vec<(String, Place)>, Vec<Node>) = (Vec::new(), Vec::new());
    let mut start = 0;
    for line in source.text().split_inclusive('\n') {
        let begin = start;
        start += line.len();
        if line.trim().is_empty() || line.trim_start().starts_with('#') {
            continue;
        }
        let line = line.trim_end_matches(['\n', '\r']);
        let whole = place(begin..begin + line.len());
        let cells = cells(line, begin).into_iter().map(|(text, span)| (text.to_owned(), place(span))).collect::<Vec<_>>();
        if names.is_empty() {
            names = cells;
            continue;
        }
        if cells.len() != names.len() {
            let message = format!("a line of {:?} has {} cells, its first one {}", source.name(), cells.len(), names.len());
            return Err(SceneError::at(&whole, message, "this line"));
        }
        if found.len() == MOST_LINES {
            return Err(SceneError::at(&whole, format!("{:?} has more than {MOST_LINES} lines", source.name()), "make it shorter"));
        }
        let members = names
            .iter()
            .zip(cells)
            .map(|((key, key_place), (text, cell))| {
                let value = text.parse().map_or(Value::Text(text), Value::Number);
                Entry { key: key.clone(), key_place: key_place.clone(), node: Node { value, place: cell } }
            })
            .collect();
        found.push(Node { value: Value::Table(members), place: whole });
    }
    if found.is_empty() {
        let message = format!("{:?} holds no line of numbers below its first line, which names its columns", source.name());
        return Err(SceneError::at(&place(0..0), message, "in this file"));
    }
    Ok(found)
}

/// The cells of a line with their places, without the blanks around them.
fn cells(line: &str, begin: usize) -> Vec<(&str, Range<usize>)> {
    let mut place = begin;
    line.split(',')
        .map(|cell| {
            let start = place + (cell.len() - cell.trim_start().len());
            place += cell.len() + 1;
            (cell.trim(), start..start + cell.trim().len())
        })
        .collect()
}
