//! The catalogue of keys: every key a scene may hold, with its kind, range, meaning, and the problem it belongs to.
//!
//! One list serves the check of a scene, the nearest-key suggestion, the editor schema, and the documentation. A path is dotted; `[]`
//! stands for any item of a list.

mod adhesion;
mod crack;
mod fields;
mod fit;
mod general;
mod history;
mod indentation;
mod material;
mod sliding;
mod standard_test;
mod surface;

use super::units::Dimension;

/// One key.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// Dotted path, `[]` for the items of a list.
    pub path: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// One sentence for a person.
    pub meaning: &'static str,
}

/// What a key takes.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A number with a unit (SI), or a plain number in reduced groups.
    Number {
        /// Its dimension.
        dimension: Dimension,
        /// Its range.
        range: Range,
        /// The unit it has in `units = "reduced"`.
        reduced: &'static str,
    },
    /// A number of the dimension of another key (a sweep's values, the ends of a branch, the rate of a segment of a history).
    NumberOfSweptKey,
    /// A list of such numbers.
    NumbersOfSweptKey,
    /// A whole number.
    Count {
        /// The smallest allowed.
        least: u32,
        /// The largest allowed.
        most: u32,
    },
    /// One of a few words.
    Choice(&'static [Word]),
    /// A list of different ones of a few words.
    Choices(&'static [Word]),
    /// A free text.
    Text,
    /// A text or a list of texts.
    Texts,
    /// true or false.
    Flag,
    /// A table.
    Table,
    /// A list of tables.
    Tables,
    /// A table or a list of tables.
    TableOrTables,
    /// A table or one of a few words.
    TableOrWord(&'static [Word]),
}

/// A word that a choice allows.
#[derive(Debug, Clone, Copy)]
pub struct Word {
    /// The word.
    pub word: &'static str,
    /// What it means.
    pub meaning: &'static str,
}

/// The range of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// > 0.
    Positive,
    /// ≥ 0.
    NonNegative,
    /// Strictly between the first and the second, or equal to the second.
    AboveUpTo(f64, f64),
    /// Any finite number.
    Finite,
}

impl Range {
    /// Whether a finite number lies in the range.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Positive => value > 0.0,
                Self::NonNegative => value >= 0.0,
                Self::AboveUpTo(low, high) => value > low && value <= high,
                Self::Finite => true,
            }
    }

    /// The range in words.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Self::Positive => "greater than 0".into(),
            Self::NonNegative => "0 or more".into(),
            Self::AboveUpTo(low, high) => format!("greater than {low} and at most {high}"),
            Self::Finite => "a finite number".into(),
        }
    }
}

/// Every key, in the order of the documentation.
pub fn keys() -> impl Iterator<Item = &'static Key> {
    [
        general::KEYS,
        material::KEYS,
        adhesion::KEYS,
        crack::KEYS,
        indentation::KEYS,
        history::KEYS,
        standard_test::KEYS,
        sliding::KEYS,
        surface::KEYS,
        fields::KEYS,
        fit::KEYS,
    ]
    .into_iter()
    .flatten()
}

/// The key at a path, `[]` for list items.
#[must_use]
pub fn key(path: &str) -> Option<&'static Key> {
    keys().find(|key| key.path == path)
}

/// The names of the keys of the table at a path (the empty path is the scene itself).
pub fn names_in(table: &str) -> impl Iterator<Item = &'static str> {
    keys().filter_map(move |key| {
        let rest = if table.is_empty() { key.path } else { key.path.strip_prefix(table)?.strip_prefix('.')? };
        (!rest.contains('.') && !rest.contains('[')).then_some(rest)
    })
}

/// The path of a key with list indices replaced by `[]`: `material.creep.0.compliance` → `material.creep[].compliance`.
#[must_use]
pub fn generic_path(path: &str) -> String {
    let mut generic = String::new();
    for part in path.split('.') {
        if !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit()) {
            generic.push_str("[]");
        } else {
            if !generic.is_empty() {
                generic.push('.');
            }
            generic.push_str(part);
        }
    }
    generic
}
