//! The check of a document against the catalogue: every key known, every type right, every unit and range kept.
//!
//! After it, the typed reader may take any value by its path without looking at types again.

use super::catalogue::{self, Key, Kind, Range, Word};
use super::diagnostic::{SceneError, nearest};
use super::document::{Entry, Node, Value};
use super::suggest::{self, Suggestion};
use super::units::{Dimension, parse_quantity};

/// Characters of a line of a list of keys.
const WIDTH_OF_A_LIST: usize = 110;

/// Checks a whole scene.
///
/// # Errors
/// The first thing that is wrong, in the order of the text.
pub fn check(root: &Node) -> Result<(), SceneError> {
    check_table(root, "", "", Units::of(root))
}

/// Checks a scene that was checked before some of its keys were given other values: only those are checked again.
///
/// # Errors
/// As [`check`].
pub(super) fn check_changed<'k>(root: &Node, keys: impl IntoIterator<Item = &'k str>) -> Result<(), SceneError> {
    let units = Units::of(root);
    let is_right = |path: &str| {
        let found = root.at(path).zip(catalogue::key(&catalogue::generic_path(path)));
        found.is_some_and(|(node, key)| check_value(node, key, path, units).is_ok())
    };
    // The whole check gives the first error in the order of the text.
    if keys.into_iter().all(is_right) { Ok(()) } else { check(root) }
}

/// How numbers are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// SI numbers or texts with a unit.
    Si,
    /// Plain numbers.
    Reduced,
}

impl Units {
    /// The unit system of a scene; anything but `"reduced"` is SI here and checked elsewhere.
    #[must_use]
    pub fn of(root: &Node) -> Self {
        match root.get("units").map(|node| &node.value) {
            Some(Value::Text(word)) if word == "reduced" => Self::Reduced,
            _ => Self::Si,
        }
    }
}

/// Checks a table: `path` is its path with real indices, for messages, `generic` the one that the catalogue knows.
fn check_table(table: &Node, path: &str, generic: &str, units: Units) -> Result<(), SceneError> {
    let below = |path: &str, key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    for entry in table.entries() {
        let path_of_key = below(path, &entry.key);
        let Some(key) = catalogue::key(&below(generic, &entry.key)) else {
            return Err(unknown_key(entry, path, generic));
        };
        check_value(&entry.node, key, &path_of_key, units)?;
    }
    Ok(())
}

/// Words after each other, in lines that a terminal has room for.
fn listed(words: &[&str]) -> String {
    let mut text = String::new();
    let mut width = 0;
    for (index, word) in words.iter().enumerate() {
        if index > 0 {
            text.push(',');
            let full = width + word.len() > WIDTH_OF_A_LIST;
            text.push(if full { '\n' } else { ' ' });
            width = if full { 0 } else { width };
        }
        text.push_str(word);
        width += word.len() + 2;
    }
    text
}

/// The error for a key that the catalogue does not have.
fn unknown_key(entry: &Entry, table: &str, generic: &str) -> SceneError {
    let known: Vec<&str> = catalogue::names_in(generic).collect();
    let path = if table.is_empty() { entry.key.clone() } else { format!("{table}.{}", entry.key) };
    let place = if table.is_empty() { "a scene".to_owned() } else { format!("[{table}]") };
    let meant = suggest::for_key(&entry.key, generic);
    let mut help = if known.is_empty() { format!("{place} has no keys") } else { format!("{place} knows: {}", listed(&known)) };
    let label = match &meant {
        Some(Suggestion { path: Some(path), note }) => {
            let parent = path.rsplit_once('.').map_or("", |(parent, _)| parent);
            let own = parent == generic;
            let name = if own { path.rsplit('.').next().unwrap_or(path) } else { path };
            if !own {
                help.push_str(&format!("; `{path}` exists"));
            }
            if !note.is_empty() {
                help.push_str(&format!("; `{path}`: {note}"));
            }
            format!("did you mean `{name}`?")
        }
        Some(Suggestion { path: None, note }) => {
            help = format!("{note}; {help}");
            "unknown key".to_owned()
        }
        None => "unknown key".to_owned(),
    };
    SceneError::at(&entry.key_place, format!("`{path}` is not a key"), label).help(help)
}

fn check_value(node: &Node, key: &Key, path: &str, units: Units) -> Result<(), SceneError> {
    match key.kind {
        Kind::Number { dimension, range, reduced } => {
            let value = number(node, path, dimension, units)?;
            check_range(node, path, value, range).map_err(|error| match units {
                Units::Reduced => error.help(format!("allowed: {}, in units of {reduced}", range.words())),
                Units::Si => error,
            })
        }
        Kind::Count { least, most } => count(node, path, least, most).map(|_| ()),
        Kind::Choice(words) => choice(node, path, words).map(|_| ()),
        Kind::Choices(words) => check_choices(node, path, words),
        Kind::Text => match &node.value {
            Value::Text(_) => Ok(()),
            _ => Err(wrong_type(node, path, "a text in quotes")),
        },
        Kind::Texts => match &node.value {
            Value::Text(_) => Ok(()),
            Value::List(items) if !items.is_empty() => items.iter().try_for_each(|item| match &item.value {
                Value::Text(_) => Ok(()),
                _ => Err(wrong_type(item, path, "a text in quotes")),
            }),
            _ => Err(wrong_type(node, path, "a text in quotes, or a list of such")),
        },
        Kind::Flag => match &node.value {
            Value::Flag(_) => Ok(()),
            _ => Err(wrong_type(node, path, "true or false")),
        },
        Kind::NumberOfSweptKey => match &node.value {
            Value::Text(_) | Value::Number(_) => Ok(()),
            _ => Err(wrong_type(node, path, "a number, or a text with a unit")),
        },
        Kind::NumbersOfSweptKey => match &node.value {
            Value::List(items) => items.iter().try_for_each(|item| match &item.value {
                Value::Text(_) | Value::Number(_) => Ok(()),
                _ => Err(wrong_type(item, path, "numbers, or texts with a unit")),
            }),
            _ => Err(wrong_type(node, path, "a list of numbers")),
        },
        Kind::Table => check_subtable(node, path, key.path, units),
        Kind::Tables => check_list(node, path, &format!("{}[]", key.path), units),
        Kind::TableOrWord(words) => match &node.value {
            Value::Text(_) => choice(node, path, words).map(|_| ()),
            _ => check_subtable(node, path, key.path, units),
        },
        Kind::TableOrTables => match &node.value {
            Value::List(_) => check_list(node, path, key.path, units),
            _ => check_subtable(node, path, key.path, units),
        },
    }
}

fn check_subtable(node: &Node, path: &str, generic: &str, units: Units) -> Result<(), SceneError> {
    match &node.value {
        Value::Table(_) => check_table(node, path, generic, units),
        _ => {
            let known = catalogue::names_in(generic).collect::<Vec<_>>().join(", ");
            let help = if known.is_empty() {
                format!(
                    "this table has no keys: write [{path}] on a line of its own, or {} = {{}}",
                    path.rsplit('.').next().unwrap_or(path)
                )
            } else {
                format!("such as: {}; [{path}] knows: {known}", example(node, path, generic, units))
            };
            Err(wrong_type(node, path, "a table").help(help))
        }
    }
}

/// A line that gives the table: the key that what was written measures, or the first one.
fn example(node: &Node, path: &str, generic: &str, units: Units) -> String {
    let name = path.rsplit('.').next().unwrap_or(path);
    let keys = || catalogue::names_in(generic).filter_map(|name| Some((name, catalogue::key(&format!("{generic}.{name}"))?.kind)));
    let measures = |kind: Kind, given: Dimension| matches!(kind, Kind::Number { dimension, .. } if given.measures(dimension));
    let given = if let Value::Text(text) = &node.value { parse_quantity(text).ok().map(|quantity| quantity.dimension) } else { None };
    if let Some((key, _)) = given.and_then(|given| keys().find(|(_, kind)| measures(*kind, given))) {
        return format!("{name} = {{ {key} = {} }}", node.written());
    }
    let value = |kind: Kind| match kind {
        Kind::Number { dimension, .. } if units == Units::Si => {
            Some(dimension.example().split('"').nth(1).map_or_else(|| "1".to_owned(), |quantity| format!("{quantity:?}")))
        }
        Kind::Number { .. } => Some("1".to_owned()),
        Kind::Count { least, .. } => Some(least.to_string()),
        Kind::Choice(words) => words.first().map(|word| format!("{:?}", word.word)),
        Kind::Flag => Some("true".to_owned()),
        _ => None,
    };
    match keys().find_map(|(key, kind)| Some((key, value(kind)?))) {
        Some((key, value)) => format!("{name} = {{ {key} = {value} }}"),
        None => format!("[{path}]"),
    }
}

fn check_list(node: &Node, path: &str, generic: &str, units: Units) -> Result<(), SceneError> {
    match &node.value {
        Value::List(items) => {
            items.iter().enumerate().try_for_each(|(index, item)| check_subtable(item, &format!("{path}.{index}"), generic, units))
        }
        _ => Err(wrong_type(node, path, "a list of tables")),
    }
}

fn wrong_type(node: &Node, key: &str, allowed: &str) -> SceneError {
    SceneError::at(&node.place, format!("`{key}` is {}: {}", node.kind(), shortened(node.written())), format!("must be {allowed}"))
}

/// At most 60 characters of a value, for a message.
fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(60).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(60).is_some() {
        short.push('…');
    }
    short
}

/// A number in SI or reduced units, finite.
///
/// # Errors
/// A type, unit or number that is wrong, with what is allowed.
pub fn number(node: &Node, key: &str, dimension: Dimension, units: Units) -> Result<f64, SceneError> {
    let value = match &node.value {
        Value::Number(value) => *value,
        Value::Text(text) if units == Units::Reduced => {
            let message = format!("`{key}` = {text:?} has a unit or is a text, in a scene in reduced units");
            return Err(SceneError::at(&node.place, message, "must be a plain number").help("leave the unit out, or write units = \"si\""));
        }
        Value::Text(text) => {
            let allowed = || format!("allowed: {}, or a plain number in {}", dimension.example(), dimension.si_unit());
            let quantity = parse_quantity(text).map_err(|error| {
                SceneError::at(&node.place, format!("`{key}` = {text:?} is no quantity: {error}"), "here").help(allowed())
            })?;
            if !quantity.dimension.measures(dimension) {
                let message = if text.trim().parse::<f64>().is_ok() {
                    format!("`{key}` = {text:?} has no unit")
                } else {
                    format!("`{key}` = {text:?} has the wrong unit: it is measured in {}", quantity.dimension.si_unit())
                };
                return Err(SceneError::at(&node.place, message, format!("must be measured in {}", dimension.si_unit())).help(allowed()));
            }
            quantity.value
        }
        _ => return Err(wrong_type(node, key, dimension.example())),
    };
    if value.is_finite() {
        // Minus zero is zero.
        Ok(value + 0.0)
    } else {
        let message = format!("`{key}` = {} is not a finite number", shortened(node.written()));
        Err(SceneError::at(&node.place, message, "must be finite").help(format!("allowed: {}", dimension.example())))
    }
}

/// Refuses a number outside its range.
///
/// # Errors
/// The range, in words.
pub fn check_range(node: &Node, key: &str, value: f64, range: Range) -> Result<(), SceneError> {
    if range.holds(value) {
        Ok(())
    } else {
        let message = format!("`{key}` = {} is out of range", shortened(node.written()));
        Err(SceneError::at(&node.place, message, format!("must be {}", range.words())))
    }
}

/// A whole number in a range.
///
/// # Errors
/// A type or value that is wrong, with the range.
pub fn count(node: &Node, key: &str, least: u32, most: u32) -> Result<u32, SceneError> {
    match node.value {
        Value::Number(value) if value.fract() == 0.0 && value >= f64::from(least) && value <= f64::from(most) => Ok(value as u32),
        Value::Number(_) => {
            let message = format!("`{key}` = {} is out of range", shortened(node.written()));
            Err(SceneError::at(&node.place, message, format!("must be a whole number from {least} to {most}")))
        }
        _ => Err(wrong_type(node, key, &format!("a whole number from {least} to {most}"))),
    }
}

/// The index of a word among those allowed.
///
/// # Errors
/// A type or word that is wrong, with the nearest word.
pub fn choice(node: &Node, key: &str, words: &[Word]) -> Result<usize, SceneError> {
    let allowed = || allowed_words(words);
    match &node.value {
        Value::Text(text) => words.iter().position(|word| word.word == text).ok_or_else(|| {
            let label = nearest(text, words.iter().map(|word| word.word))
                .map_or_else(|| "not one of the words allowed".to_owned(), |word| format!("did you mean {word:?}?"));
            SceneError::at(&node.place, format!("`{key}` = {text:?} is not allowed"), label).help(allowed())
        }),
        _ => Err(wrong_type(node, key, "a text").help(allowed())),
    }
}

/// The line that names the words of a choice.
pub fn allowed_words(words: &[Word]) -> String {
    format!("allowed: {}", words.iter().map(|word| format!("{:?}", word.word)).collect::<Vec<_>>().join(", "))
}

fn check_choices(node: &Node, key: &str, words: &[Word]) -> Result<(), SceneError> {
    let Value::List(items) = &node.value else {
        return Err(wrong_type(node, key, "a list of texts").help(allowed_words(words)));
    };
    if items.is_empty() {
        return Err(SceneError::at(&node.place, format!("`{key}` is an empty list"), "name at least one").help(allowed_words(words)));
    }
    let mut seen = Vec::new();
    for item in items {
        let index = choice(item, key, words)?;
        if seen.contains(&index) {
            return Err(SceneError::at(&item.place, format!("`{key}` names {} twice", item.written()), "leave one out"));
        }
        seen.push(index);
    }
    Ok(())
}
