//! Scenes with the fitted values, which run as they stand, and the files that they name.

use super::carry_out::Fit;
use super::setup::Role;
use super::words::{known, quantity};
use crate::scene::document::{Document, Node, Value, toml_text};
use std::fmt::Write;

/// The scene of each test that differs from the others, with all values put in: names and bytes. Files that they name lie beside them.
#[must_use]
pub fn fitted_scenes(fit: &Fit) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut scenes = Vec::new();
    for (number, test) in fit.setup.tests.iter().enumerate() {
        let differs = fit.setup.task.tests.get(number).is_some_and(|given| !given.set.is_empty());
        if number > 0 && !differs {
            continue;
        }
        let name = if number == 0 { "fitted.toml".to_owned() } else { format!("fitted_{}.toml", number + 1) };
        let mut document = test.document.clone();
        let mut comments = Vec::new();
        for (place, ((role, unit), value)) in fit.setup.roles.iter().zip(&fit.fitted.values).enumerate() {
            let Role::Scene(put) = role else { continue };
            let node = Node { value: Value::Number(*value), place: put.place.clone() };
            if document.replace(&put.key, node).is_ok() {
                let interval = fit.fitted.by_profile.get(place);
                let half = interval.map_or(0.0, |one| 0.5 * (one.upper.value() - one.lower.value()));
                let ends = interval
                    .map(|one| format!("; 95 %: {} to {}", known(one.lower.value(), half, unit), known(one.upper.value(), half, unit)));
                comments.push((put.key.clone(), format!("{}{}", known(*value, half, unit), ends.unwrap_or_default())));
            }
        }
        let names = attached(&document, &mut files);
        let mut text = format!("# Made by `viscotack fit` from {}, with the fitted values.\n", test.file.replace(char::is_control, " "));
        for ((role, unit), value) in fit.setup.roles.iter().zip(&fit.fitted.values) {
            if let Role::Of(of, offset) = role
                && *of == number
            {
                let _ = writeln!(text, "# Of the data: {} offset {}.", format!("{offset:?}").to_lowercase(), quantity(*value, unit));
            }
        }
        Writer { text: &mut text, names: &names, comments: &comments }.table(&document.root, "");
        scenes.push((name, text.into_bytes()));
    }
    scenes.extend(files);
    scenes
}

/// Files that a document names: their names in it, and beside the scene.
fn attached(document: &Document, files: &mut Vec<(String, Vec<u8>)>) -> Vec<(String, String)> {
    document
        .attachments()
        .map(|(name, source)| {
            let own = name.rsplit(['/', '\\']).next().unwrap_or(name).to_owned();
            let bytes = source.text().as_bytes().to_vec();
            let mut free = own.clone();
            let mut number = 2;
            while files.iter().any(|(other, held)| *other == free && *held != bytes) {
                free = format!("{number}_{own}");
                number += 1;
            }
            if !files.iter().any(|(other, _)| *other == free) {
                files.push((free.clone(), bytes));
            }
            (name.to_owned(), free)
        })
        .collect()
}

struct Writer<'w> {
    text: &'w mut String,
    names: &'w [(String, String)],
    comments: &'w [(String, String)],
}

impl Writer<'_> {
    /// The entries of a table: plain ones first, then tables below it.
    fn table(&mut self, node: &Node, path: &str) {
        let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        for entry in node.entries() {
            if is_table(&entry.node) {
                continue;
            }
            let full = below(&entry.key);
            let value = self.inline(&entry.node);
            let comment = self.comments.iter().find(|comment| comment.0 == full);
            let comment = comment.map_or_else(String::new, |(_, words)| format!(" # {words}"));
            let _ = writeln!(self.text, "{} = {value}{comment}", bare(&entry.key));
        }
        for entry in node.entries().iter().filter(|entry| is_table(&entry.node)) {
            let full = below(&entry.key);
            match &entry.node.value {
                Value::List(items) => {
                    for (index, item) in items.iter().enumerate() {
                        let _ = writeln!(self.text, "\n[[{}]]", header(&full));
                        self.table(item, &format!("{full}.{index}"));
                    }
                }
                _ => {
                    let _ = writeln!(self.text, "\n[{}]", header(&full));
                    self.table(&entry.node, &full);
                }
            }
        }
    }

    fn inline(&self, node: &Node) -> String {
        match &node.value {
            Value::Number(value) => format!("{value:?}"),
            Value::Text(text) => toml_text(self.names.iter().find(|name| name.0 == *text).map_or(text, |name| &name.1)),
            Value::Flag(flag) => flag.to_string(),
            Value::Date => node.written().to_owned(),
            Value::List(items) => format!("[{}]", items.iter().map(|item| self.inline(item)).collect::<Vec<_>>().join(", ")),
            Value::Table(entries) => {
                let parts: Vec<String> =
                    entries.iter().map(|entry| format!("{} = {}", bare(&entry.key), self.inline(&entry.node))).collect();
                format!("{{ {} }}", parts.join(", "))
            }
        }
    }
}

/// Whether a value stands under a header of its own.
fn is_table(node: &Node) -> bool {
    match &node.value {
        Value::Table(_) => true,
        Value::List(items) => items.iter().any(|item| matches!(item.value, Value::Table(_))),
        _ => false,
    }
}

fn bare(key: &str) -> String {
    let plain = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    if plain { key.to_owned() } else { toml_text(key) }
}

/// A path as a header: of an item of a list the header of its list.
fn header(path: &str) -> String {
    path.split('.').filter(|part| part.parse::<usize>().is_err()).map(bare).collect::<Vec<_>>().join(".")
}
