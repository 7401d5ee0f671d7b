//! A table of a checked scene, with typed access and the errors that need its place.

use super::end_of;
use crate::scene::catalogue::{self, Kind};
use crate::scene::check::{Units, allowed_words, number};
use crate::scene::diagnostic::{Place, SceneError};
use crate::scene::document::{Node, Value};
use std::cell::RefCell;
use std::collections::HashSet;
use std::rc::Rc;

/// A table at a path of a scene. What is read through it is remembered, so that a key that nobody read is refused: see [`Section::all_read`].
pub(super) struct Section<'a> {
    node: &'a Node,
    /// Path with real indices, for messages.
    path: String,
    units: Units,
    /// Paths that were read in this scene.
    read: Rc<RefCell<HashSet<String>>>,
}

impl<'a> Section<'a> {
    /// The scene itself.
    pub(super) fn top(root: &'a Node, units: Units) -> Self {
        Self { node: root, path: String::new(), units, read: Rc::default() }
    }

    /// The value under a key, which counts as read.
    pub(super) fn value(&self, key: &str) -> Option<&'a Node> {
        let node = self.node.get(key)?;
        self.read.borrow_mut().insert(self.full(key));
        Some(node)
    }

    /// Counts a table as read with all that it holds: its reader is skipped where the same words were read before.
    pub(super) fn taken(&self, key: &str) {
        let mut waiting: Vec<(String, &Node)> = self.node.get(key).map(|node| (self.full(key), node)).into_iter().collect();
        while let Some((path, node)) = waiting.pop() {
            waiting.extend(node.entries().iter().map(|entry| (format!("{path}.{}", entry.key), &entry.node)));
            self.read.borrow_mut().insert(path);
        }
    }

    /// The keys of the scene that were read and begin so.
    pub(super) fn keys_read(&self, below: &[String]) -> Vec<String> {
        self.read.borrow().iter().filter(|key| below.iter().any(|below| key.starts_with(below))).cloned().collect()
    }

    /// Counts keys as read.
    pub(super) fn count_as_read(&self, keys: &[String]) {
        self.read.borrow_mut().extend(keys.iter().cloned());
    }

    /// Refuses the first key of this table that nobody read: it would have no effect. `others` are read elsewhere.
    pub(super) fn all_read(&self, others: &[&str], owner: &str) -> Result<(), SceneError> {
        let read = self.read.borrow();
        let mut waiting: Vec<(String, &Node)> = vec![(self.path.clone(), self.node)];
        while let Some((path, node)) = waiting.pop() {
            for entry in node.entries() {
                let full = if path.is_empty() { entry.key.clone() } else { format!("{path}.{}", entry.key) };
                if others.contains(&full.as_str()) {
                    continue;
                }
                if !read.contains(&full) {
                    let message = format!("`{full}` has no effect on {owner} as this scene describes it");
                    let help = catalogue::key(&catalogue::generic_path(&full)).map_or("", |key| key.meaning);
                    return Err(SceneError::at(&entry.key_place, message, "leave it out").help(format!("{full}: {help}")));
                }
                match &entry.node.value {
                    Value::List(items) => waiting.extend(items.iter().enumerate().map(|(index, item)| (format!("{full}.{index}"), item))),
                    _ => waiting.push((full, &entry.node)),
                }
            }
        }
        Ok(())
    }

    pub(super) const fn node(&self) -> &'a Node {
        self.node
    }

    pub(super) const fn units(&self) -> Units {
        self.units
    }

    /// The subtable under a key, if it is there.
    pub(super) fn table(&self, key: &str) -> Option<Section<'a>> {
        let node = self.value(key)?;
        Some(Section { node, path: self.full(key), units: self.units, read: Rc::clone(&self.read) })
    }

    /// The subtable under a key.
    pub(super) fn required_table(&self, key: &str, why: &str) -> Result<Section<'a>, SceneError> {
        self.table(key).ok_or_else(|| {
            let path = self.full(key);
            SceneError::at(&self.end(), format!("the table [{path}] is missing: {why}"), "the scene ends here").help(known_keys(&path))
        })
    }

    /// The items of a list of tables.
    pub(super) fn items(&self, key: &str) -> Vec<Section<'a>> {
        match self.value(key).map(|node| &node.value) {
            Some(Value::List(items)) => items
                .iter()
                .enumerate()
                .map(|(index, node)| Section {
                    node,
                    path: format!("{}.{index}", self.full(key)),
                    units: self.units,
                    read: Rc::clone(&self.read),
                })
                .collect(),
            _ => Vec::new(),
        }
    }

    /// A number in coherent units.
    pub(super) fn number(&self, key: &str) -> Result<Option<f64>, SceneError> {
        let Some(node) = self.value(key) else { return Ok(None) };
        let path = self.full(key);
        match catalogue::key(&catalogue::generic_path(&path)).map(|entry| entry.kind) {
            Some(Kind::Number { dimension, .. }) => number(node, &path, dimension, self.units).map(Some),
            Some(Kind::Count { .. }) => match node.value {
                Value::Number(value) => Ok(Some(value)),
                _ => Ok(None),
            },
            _ => Ok(None),
        }
    }

    /// A number that must be there.
    pub(super) fn required_number(&self, key: &str) -> Result<f64, SceneError> {
        self.number(key)?.ok_or_else(|| self.missing(key))
    }

    /// A text.
    pub(super) fn text(&self, key: &str) -> Option<&'a str> {
        match &self.value(key)?.value {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// A text that must be there.
    pub(super) fn required_text(&self, key: &str) -> Result<&'a str, SceneError> {
        self.text(key).ok_or_else(|| self.missing(key))
    }

    /// The texts of a list.
    pub(super) fn texts(&self, key: &str) -> Vec<&'a str> {
        match self.value(key).map(|node| &node.value) {
            Some(Value::List(items)) => items
                .iter()
                .filter_map(|item| match &item.value {
                    Value::Text(text) => Some(text.as_str()),
                    _ => None,
                })
                .collect(),
            _ => Vec::new(),
        }
    }

    /// The texts of a key that takes one text or a list of them.
    pub(super) fn text_or_texts(&self, key: &str) -> Vec<String> {
        match self.text(key) {
            Some(text) => vec![text.to_owned()],
            None => self.texts(key).into_iter().map(str::to_owned).collect(),
        }
    }

    /// The one of several keys that is given.
    pub(super) fn exactly_one(&self, keys: &[&'static str]) -> Result<&'static str, SceneError> {
        match self.at_most_one(keys)? {
            Some(key) => Ok(key),
            None => {
                let named = keys.iter().map(|key| format!("`{}`", self.full(key))).collect::<Vec<_>>().join(", ");
                Err(SceneError::at(&self.header(), format!("one of {named} is missing"), "in this table").help("give exactly one of them"))
            }
        }
    }

    /// The one of several keys that is given, or none.
    pub(super) fn at_most_one(&self, keys: &[&'static str]) -> Result<Option<&'static str>, SceneError> {
        let given: Vec<&'static str> = keys.iter().copied().filter(|key| self.node.get(key).is_some()).collect();
        match given.as_slice() {
            [] => Ok(None),
            [one] => Ok(Some(one)),
            [first, second, ..] => {
                let message = format!("`{}` and `{}` exclude each other", self.full(first), self.full(second));
                Err(SceneError::at(&self.key_place(second), message, "leave one of the two out"))
            }
        }
    }

    /// Refuses keys that belong to another problem than this scene's.
    pub(super) fn without(&self, keys: &[&'static str], owner: &str) -> Result<(), SceneError> {
        match keys.iter().find(|key| self.node.get(key).is_some()) {
            Some(key) => {
                let message = format!("`{}` belongs to {owner}, which this scene is not about", self.full(key));
                Err(SceneError::at(&self.key_place(key), message, "leave it out"))
            }
            None => Ok(()),
        }
    }

    /// A contradiction at a key.
    pub(super) fn wrong(&self, key: &str, message: impl Into<String>, label: impl Into<String>) -> SceneError {
        let place = self.node.get(key).map_or_else(|| self.header(), |node| node.place.clone());
        SceneError::at(&place, message, label)
    }

    /// The error for a key that must be there.
    pub(super) fn missing(&self, key: &str) -> SceneError {
        let path = self.full(key);
        let help = catalogue::key(&catalogue::generic_path(&path)).map_or_else(String::new, |entry| {
            let takes = match entry.kind {
                Kind::Number { reduced, .. } if self.units == Units::Reduced => format!(" It is a plain number, in units of {reduced}."),
                Kind::Number { dimension, .. } => format!(" It is {}.", dimension.example()),
                Kind::Choice(words) => format!(" It is a word; {}.", allowed_words(words)),
                _ => String::new(),
            };
            format!("{path}: {}{takes}", entry.meaning)
        });
        SceneError::at(&self.header(), format!("`{path}` is missing"), "in this table").help(help)
    }

    /// Where a key stands.
    pub(super) fn key_place(&self, key: &str) -> Place {
        self.node.entries().iter().find(|entry| entry.key == key).map_or_else(|| self.header(), |entry| entry.key_place.clone())
    }

    /// Where this table begins: the first line of it.
    pub(super) fn header(&self) -> Place {
        if self.path.is_empty() {
            return self.end();
        }
        let mut place = self.node.place.clone();
        let text = place.source.text().get(place.span.clone()).unwrap_or("");
        let length = text.find('\n').unwrap_or(text.len());
        place.span = place.span.start..place.span.start + length;
        place
    }

    /// Where this document ends.
    pub(super) fn end(&self) -> Place {
        end_of(&self.node.place)
    }

    /// The dotted path of a key of this table.
    pub(super) fn full(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }
}

fn known_keys(path: &str) -> String {
    let keys: Vec<String> = catalogue::names_in(path).map(|name| format!("{path}.{name}")).collect();
    format!("it may hold {}", keys.join(", "))
}
