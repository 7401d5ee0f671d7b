//! What a source computes: named columns of numbers with error bounds, and of words.

use super::source::SourceError;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use viscotack_program::outcome::{Outcome, Row};

/// A column of numbers; none where a quantity does not exist.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Column {
    pub(super) values: Vec<Option<f64>>,
    /// Bounds on the errors; empty for numbers that are exact to rounding.
    pub(super) errors: Vec<Option<f64>>,
}

/// Columns of equal length.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Table {
    pub(super) rows: usize,
    pub(super) numbers: BTreeMap<String, Column>,
    pub(super) words: BTreeMap<String, Vec<String>>,
    /// Rows that are not solved, with the reason.
    pub(super) remarks: Vec<String>,
    /// What it took (s).
    pub(super) seconds: f64,
}

/// Remarks beyond this number are counted, not listed.
const MOST_REMARKS: usize = 4;

impl Table {
    /// From columns of exact numbers.
    pub(super) fn exact(columns: &[(&str, Vec<f64>)]) -> Self {
        let mut table = Self { rows: columns.first().map_or(0, |(_, values)| values.len()), ..Self::default() };
        for (name, values) in columns {
            let values = values.iter().map(|value| value.is_finite().then_some(*value)).collect();
            table.numbers.insert((*name).to_owned(), Column { values, errors: Vec::new() });
        }
        table
    }

    /// The rows of an outcome; with `fields`, one row for each point of them.
    pub(super) fn of_outcome(outcome: &Outcome, fields: bool) -> Result<Self, SourceError> {
        let mut table = Self::default();
        for row in &outcome.rows {
            if !row.status.has_values() {
                let swept: Vec<String> =
                    outcome.swept.iter().zip(&row.swept).map(|(swept, value)| format!("{} = {value}", swept.key)).collect();
                table.remarks.push(format!("{} {}: {}", row.label(0), swept.join(", "), row.reason.as_deref().unwrap_or("no value")));
            }
            if fields {
                for point in &row.fields {
                    table.push_row(outcome, row);
                    for (index, column) in outcome.field_columns.iter().enumerate() {
                        let estimate = if index == 0 {
                            Some((point.place, 0.0))
                        } else {
                            point.values.get(index - 1).map(|value| (value.value, value.error))
                        };
                        table.put(column.name, estimate);
                    }
                    table.rows += 1;
                }
            } else {
                table.push_row(outcome, row);
                table.rows += 1;
            }
        }
        let more = table.remarks.len().saturating_sub(MOST_REMARKS);
        table.remarks.truncate(MOST_REMARKS);
        if more > 0 {
            table.remarks.push(format!("and {more} more rows without values"));
        }
        if table.rows == 0 {
            return Err(SourceError::Empty);
        }
        Ok(table)
    }

    fn push_row(&mut self, outcome: &Outcome, row: &Row) {
        for (index, column) in outcome.columns.iter().enumerate() {
            let estimate = row.values.get(index).copied().flatten().map(|estimate| (estimate.value, estimate.error));
            self.put(column.name, estimate);
        }
        for (swept, value) in outcome.swept.iter().zip(&row.swept) {
            self.put(&swept.key, Some((*value, 0.0)));
        }
        for (place, label) in outcome.labels.iter().enumerate() {
            self.words.entry((*label).to_owned()).or_default().push(row.label(place).to_owned());
        }
    }

    /// Writes a number of the row under way; a later column of the same name wins.
    fn put(&mut self, name: &str, estimate: Option<(f64, f64)>) {
        let rows = self.rows;
        let column = self.numbers.entry(name.to_owned()).or_default();
        column.values.resize(rows, None);
        column.errors.resize(rows, None);
        column.values.push(estimate.map(|(value, _)| value));
        column.errors.push(estimate.map(|(_, error)| error));
    }

    /// The rows of another table of the same columns; a column that only one of them has is left out.
    pub(super) fn append(&mut self, other: &Self) {
        self.numbers.retain(|name, _| other.numbers.contains_key(name));
        self.words.retain(|name, _| other.words.contains_key(name));
        for (name, column) in &mut self.numbers {
            if let Some(more) = other.numbers.get(name) {
                column.values.resize(self.rows, None);
                column.errors.resize(self.rows, None);
                column.values.extend(&more.values);
                column.errors.extend(&more.errors);
            }
        }
        for (name, words) in &mut self.words {
            words.extend(other.words.get(name).into_iter().flatten().cloned());
        }
        self.rows += other.rows;
    }

    /// A number and its error bound.
    pub(super) fn number(&self, column: &str, row: usize) -> Option<(f64, f64)> {
        let column = self.numbers.get(column)?;
        let value = column.values.get(row).copied().flatten()?;
        Some((value, column.errors.get(row).copied().flatten().unwrap_or(0.0)))
    }

    /// The names of all columns, for messages.
    pub(super) fn names(&self) -> String {
        self.numbers.keys().chain(self.words.keys()).map(String::as_str).collect::<Vec<_>>().join(", ")
    }
}
