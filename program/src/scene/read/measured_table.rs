//! Files that the history, the indenter, the law of attraction and the sliding surface of a scene name, read with it.

use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::document::{Document, Node, Value};

/// Reads the files that a document names besides its material, so that the document holds all that its result depends on.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    let mut named: Vec<(&str, String, Place)> = match document.root.get("history").map(|node| &node.value) {
        Some(Value::List(items)) => items.iter().filter_map(|item| file_of("history.table", item.get("table")?)).collect(),
        _ => Vec::new(),
    };
    for key in ["indentation.profile", "adhesion.table", "sliding.profile.file", "sliding.surface.file"] {
        named.extend(document.root.at(key).and_then(|node| file_of(key, node)));
    }
    named.into_iter().try_for_each(|(key, name, place)| document.attach_table(key, &name, &place))
}

fn file_of<'k>(key: &'k str, node: &Node) -> Option<(&'k str, String, Place)> {
    match &node.value {
        Value::Text(name) => Some((key, name.clone(), node.place.clone())),
        _ => None,
    }
}
