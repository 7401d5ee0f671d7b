//! The number that is meant by a path that is none: a segment in brackets or without its number, a name without its table, a slip of a letter.

use crate::scene::catalogue;
use crate::scene::document::{Node, Value};
use crate::scene::read::{history::dependent_kind, is_number, nearest_number};
use crate::scene::suggest;

/// The path to type, if one is near.
pub(super) fn number(root: &Node, path: &str) -> Option<String> {
    let plain = path.replace("[]", ".").replace('[', ".").replace(']', "");
    let parts: Vec<&str> = plain.split('.').filter(|part| !part.is_empty()).collect();
    let (last, above) = parts.split_last()?;
    // The same path with a number behind every list that has none.
    let mut numbered = String::new();
    for (index, part) in parts.iter().enumerate() {
        if !numbered.is_empty() {
            numbered.push('.');
        }
        numbered.push_str(part);
        let is_index = |part: &&str| part.bytes().all(|byte| byte.is_ascii_digit());
        if index < above.len() && !parts.get(index + 1).is_some_and(is_index) && is_list(&catalogue::generic_path(&numbered)) {
            numbered.push_str(&format!(".{}", item_with(root, &numbered, last)));
        }
    }
    let is_swept = |path: &str| {
        catalogue::key(&catalogue::generic_path(path)).is_some_and(|key| is_number(key) || dependent_kind(root, path, key).is_some())
    };
    if is_swept(&numbered) {
        return Some(numbered);
    }
    // The name of a number in a table that the scene has, whole or as the end of its name; the table that was named comes first.
    let named = |path: &str| concrete(root, path, last);
    let in_scene: Vec<String> = catalogue::keys()
        .filter(|key| {
            is_number(key) && key.path.rsplit('.').next().is_some_and(|name| name == *last || name.ends_with(&format!("_{last}")))
        })
        .map(|key| named(key.path))
        .filter(|path| path.rsplit_once('.').is_some_and(|(table, _)| root.at(table).is_some()))
        .collect();
    let whole = |path: &&String| path.rsplit('.').next() == Some(last);
    let of_table = |path: &&String| above.first().is_some_and(|table| path.split('.').next() == Some(table));
    let found = in_scene.iter().find(|path| of_table(path) && whole(path)).or_else(|| in_scene.iter().find(of_table));
    let found = found.or_else(|| in_scene.iter().find(whole)).or_else(|| in_scene.first());
    let near = || nearest_number(path).map(named);
    let of_field = || {
        let suggestion = suggest::for_key(last, &catalogue::generic_path(&above.join(".")))?;
        suggestion.path.map(named).filter(|path| is_swept(path))
    };
    found.cloned().or_else(near).or_else(of_field)
}

/// Whether the catalogue has tables below this path that are items of a list.
fn is_list(path: &str) -> bool {
    catalogue::keys().any(|key| key.path.strip_prefix(path).is_some_and(|rest| rest.starts_with("[]")))
}

/// The first item of a list that has a key; 0 if none has.
fn item_with(root: &Node, list: &str, key: &str) -> usize {
    match root.at(list).map(|node| &node.value) {
        Some(Value::List(items)) => items.iter().position(|item| item.get(key).is_some()).unwrap_or(0),
        _ => 0,
    }
}

/// A path of the catalogue with a number in place of `[]`.
fn concrete(root: &Node, path: &str, last: &str) -> String {
    let mut whole = String::new();
    for (index, part) in path.split("[]").enumerate() {
        if index > 0 {
            whole.push_str(&format!(".{}", item_with(root, &whole, last)));
        }
        whole.push_str(part);
    }
    whole
}
