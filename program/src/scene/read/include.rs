//! `material.file`: the [material] table of another file, put where the key stands.

use crate::scene::diagnostic::{SceneError, SourceText};
use crate::scene::document::{Document, Entry, Node, Value, parse_tree, read_text};
use std::path::Path;

/// Replaces `material.file` by the content of that file's [material] table.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    let Some(node) = document.root.at("material.file") else { return Ok(()) };
    let Value::Text(name) = node.value.clone() else { return Ok(()) };
    let place = node.place.clone();
    let source = match document.attached(&name).or_else(|| document.provided(&name)) {
        Some(attached) => attached.clone(),
        None => {
            let text = read_text(&document.folder().join(&name)).map_err(|error| {
                SceneError::at(&place, format!("`material.file` = {name:?} cannot be read: {error}"), "this file")
                    .help("relative paths start at the scene")
            })?;
            SourceText::new(&name, text)
        }
    };
    let tree = parse_tree(&source)?;
    let Some(Node { value: Value::Table(included), .. }) = tree.get("material") else {
        return Err(SceneError::at(&place, format!("`material.file` = {name:?} has no [material] table"), "this file"));
    };
    if let Some(stray) = tree.entries().iter().find(|entry| entry.key != "material") {
        return Err(SceneError::at(&stray.key_place, format!("`{}` does not belong in a material file", stray.key), "unknown key")
            .help("a material file holds one table, [material]"));
    }
    let mut included: Vec<Entry> = included.clone();
    // What a material file names lies beside it.
    for path in ["data", "shift.table", "abaqus", "ansys", "ls_dyna", "comsol", "moose"] {
        if let Some(node) = entry_at(&mut included, path)
            && let Value::Text(own) = &mut node.value
            && let Some(folder) = Path::new(&name).parent()
        {
            *own = folder.join(&*own).display().to_string();
        }
    }
    document.include(&name, source);
    if let Some(Entry { node: Node { value: Value::Table(given), .. }, .. }) = entry_of(&mut document.root, "material") {
        given.retain(|entry| entry.key != "file");
        for new in included {
            if new.key == "file" {
                return Err(SceneError::at(&new.key_place, "a material file cannot name another file", "leave it out"));
            }
            if let Some(old) = given.iter().find(|old| old.key == new.key) {
                let message = format!("`material.{}` is given here and in {name:?}", new.key);
                return Err(SceneError::at(&old.key_place, message, "leave one of the two out"));
            }
            given.push(new);
        }
    }
    Ok(())
}

fn entry_at<'a>(entries: &'a mut [Entry], path: &str) -> Option<&'a mut Node> {
    let (head, tail) = path.split_once('.').map_or((path, None), |(head, tail)| (head, Some(tail)));
    let node = &mut entries.iter_mut().find(|entry| entry.key == head)?.node;
    let Some(tail) = tail else { return Some(node) };
    match &mut node.value {
        Value::Table(entries) => entry_at(entries, tail),
        _ => None,
    }
}

fn entry_of<'a>(node: &'a mut Node, key: &str) -> Option<&'a mut Entry> {
    match &mut node.value {
        Value::Table(entries) => entries.iter_mut().find(|entry| entry.key == key),
        _ => None,
    }
}
