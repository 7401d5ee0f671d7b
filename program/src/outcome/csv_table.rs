//! The one table writer: CSV with the unit of every column in its header; empty cells where there is no value.

use super::{Outcome, Row};
use std::fmt::Write as _;
use std::io::Write;
use viscotack::estimate::Estimate;

/// Which table of an outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    /// One row a state.
    States,
    /// What lies on the way of the states.
    Path,
    /// Fields, a row a place.
    Fields,
}

impl Table {
    /// Its file.
    #[must_use]
    pub const fn file(self) -> &'static str {
        match self {
            Self::States => "states.csv",
            Self::Path => "path.csv",
            Self::Fields => "fields.csv",
        }
    }
}

/// Number of the state of a sweep, from 1, by which rows of the tables of states and paths belong together.
const NUMBER: &str = "sweep_state";

/// A table of an outcome, written row after row: however many there are, they take no memory.
pub struct Rows<'o, W: Write> {
    outcome: &'o Outcome,
    table: Table,
    labels: Vec<usize>,
    columns: Vec<usize>,
    writer: csv::Writer<W>,
    /// Of the cell that is being written.
    text: String,
}

impl<'o, W: Write> Rows<'o, W> {
    /// Writes the header: swept numbers, labels, status, then each value with its error bound.
    ///
    /// # Errors
    /// A writer that refuses.
    pub fn new(outcome: &'o Outcome, table: Table, sink: W) -> Result<Self, csv::Error> {
        let mut rows = Self::further(outcome, table, sink);
        rows.writer.write_record(header(outcome, table, &rows.labels, &rows.columns))?;
        Ok(rows)
    }

    /// The same without the header, for rows that follow others.
    pub fn further(outcome: &'o Outcome, table: Table, sink: W) -> Self {
        let (all_labels, all_columns) = ((0..outcome.labels.len()).collect(), (0..outcome.columns.len()).collect());
        let (labels, columns) = match (&outcome.layout, table) {
            (_, Table::Fields) => (vec![0], Vec::new()),
            (Some(layout), Table::States) => (layout.labels.clone(), layout.states.clone()),
            (Some(layout), Table::Path) => (all_labels, layout.path.clone()),
            (None, _) => (all_labels, all_columns),
        };
        Self { outcome, table, labels, columns, writer: csv::Writer::from_writer(sink), text: String::new() }
    }

    /// Writes a row, if it belongs to the table.
    ///
    /// # Errors
    /// A writer that refuses.
    pub fn write(&mut self, row: &Row) -> Result<(), csv::Error> {
        let outcome = self.outcome;
        match self.table {
            Table::Fields => {
                return row.fields.iter().try_for_each(|point| {
                    self.begin(row)?;
                    self.number(point.place)?;
                    point.values.iter().try_for_each(|&value| self.estimate(Some(value)))?;
                    self.end()
                });
            }
            Table::States if !outcome.is_state(row) => return Ok(()),
            Table::Path if outcome.is_state(row) => return Ok(()),
            Table::States | Table::Path => {}
        }
        self.begin(row)?;
        self.writer.write_field(row.status.word())?;
        for place in 0..self.columns.len() {
            let Some(&index) = self.columns.get(place) else { continue };
            self.estimate(row.values.get(index).copied().flatten())?;
            if outcome.draws > 0 {
                self.number_or_none(row.material_deviation(index))?;
            }
        }
        self.number_or_none(row.certificate.map(|certificate| certificate.residual))?;
        if outcome.draws > 0 {
            draws(outcome, row).iter().try_for_each(|text| self.writer.write_field(text))?;
        }
        self.writer.write_field(row.reason.as_deref().unwrap_or_default())?;
        self.end()
    }

    /// What every row begins with: swept numbers, the number of the state, labels.
    fn begin(&mut self, row: &Row) -> Result<(), csv::Error> {
        row.swept.iter().try_for_each(|&value| self.number(value))?;
        if self.table != Table::Fields && is_numbered(self.outcome) {
            self.writer.write_field((row.state + 1).to_string())?;
        }
        self.labels.iter().try_for_each(|&place| self.writer.write_field(row.label(place)))
    }

    fn estimate(&mut self, estimate: Option<Estimate>) -> Result<(), csv::Error> {
        self.number_or_none(estimate.map(|estimate| estimate.value))?;
        self.number_or_none(estimate.map(|estimate| estimate.error))
    }

    fn number_or_none(&mut self, value: Option<f64>) -> Result<(), csv::Error> {
        match value {
            Some(value) => self.number(value),
            None => self.writer.write_field(""),
        }
    }

    fn number(&mut self, value: f64) -> Result<(), csv::Error> {
        self.text.clear();
        put_number(&mut self.text, value);
        self.writer.write_field(&self.text)
    }

    fn end(&mut self) -> Result<(), csv::Error> {
        self.writer.write_record(None::<&[u8]>)
    }

    /// Hands the rest to the sink and gives it back.
    ///
    /// # Errors
    /// A sink that refuses.
    pub fn finish(self) -> Result<W, csv::Error> {
        self.writer.into_inner().map_err(|error| csv::Error::from(std::io::Error::other(error.to_string())))
    }
}

/// Whether rows of states and of what lies on their way are to be brought together.
fn is_numbered(outcome: &Outcome) -> bool {
    outcome.layout.is_some() && !outcome.swept.is_empty()
}

fn header(outcome: &Outcome, table: Table, labels: &[usize], columns: &[usize]) -> Vec<String> {
    let mut header: Vec<String> = outcome.swept.iter().map(|swept| headed(&swept.key, &swept.unit)).collect();
    if table != Table::Fields && is_numbered(outcome) {
        header.push(NUMBER.to_owned());
    }
    header.extend(labels.iter().filter_map(|place| outcome.labels.get(*place)).map(|label| (*label).to_owned()));
    if table == Table::Fields {
        for (index, column) in outcome.field_columns.iter().enumerate() {
            header.push(headed(column.name, &column.unit));
            // The place is exact.
            if index > 0 {
                header.push(headed(&format!("{}_error", column.name), &column.unit));
            }
        }
        return header;
    }
    header.push("status".to_owned());
    for column in columns.iter().filter_map(|index| outcome.columns.get(*index)) {
        header.push(headed(column.name, &column.unit));
        header.push(headed(&format!("{}_error", column.name), &column.unit));
        if outcome.draws > 0 {
            header.push(headed(&format!("{}_material_uncertainty", column.name), &column.unit));
        }
    }
    header.push("certificate_residual [1]".to_owned());
    if outcome.draws > 0 {
        header.extend(["draws", "draws_used", "draws_in_another_state", "draws_failed", "draws_note"].map(str::to_owned));
    }
    header.push("reason".to_owned());
    header
}

/// How the draws of the material ended in a row.
fn draws(outcome: &Outcome, row: &Row) -> [String; 5] {
    row.material.as_ref().map_or_else(Default::default, |material| {
        let counts = &material.counts;
        let [all, used, other, failed] = [counts.draws, counts.used, counts.other_state, counts.failed].map(|count| count.to_string());
        [all, used, other, failed, material.note(&outcome.columns).unwrap_or_default()]
    })
}

/// A table of the rows that an outcome holds, or none if it has no such rows.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn table(outcome: &Outcome, table: Table) -> Result<Option<Vec<u8>>, csv::Error> {
    let empty = match table {
        Table::States => false,
        Table::Path => outcome.layout.is_none(),
        Table::Fields => outcome.rows.iter().all(|row| row.fields.is_empty()),
    };
    if empty {
        return Ok(None);
    }
    let mut rows = Rows::new(outcome, table, Vec::new())?;
    outcome.rows.iter().try_for_each(|row| rows.write(row))?;
    rows.finish().map(Some)
}

/// A cell of a plain table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A word.
    Word(String),
    /// A number; none is an empty cell.
    Number(Option<f64>),
}

/// A plain table under a header.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn records(header: &[String], rows: &[Vec<Cell>]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header)?;
    for row in rows {
        writer.write_record(row.iter().map(|cell| match cell {
            Cell::Word(word) => word.clone(),
            Cell::Number(value) => value.map_or_else(String::new, number),
        }))?;
    }
    finished(writer)
}

/// A table of plain numbers: names and units of the columns, then the rows; empty cells where there is no number.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn plain(columns: &[(&str, &str)], rows: &[Vec<Option<f64>>]) -> Result<Vec<u8>, csv::Error> {
    let header: Vec<String> = columns.iter().map(|(name, unit)| headed(name, unit)).collect();
    let rows: Vec<Vec<Cell>> = rows.iter().map(|row| row.iter().map(|value| Cell::Number(*value)).collect()).collect();
    records(&header, &rows)
}

fn finished(writer: csv::Writer<Vec<u8>>) -> Result<Vec<u8>, csv::Error> {
    writer.into_inner().map_err(|error| csv::Error::from(std::io::Error::other(error.to_string())))
}

fn headed(name: &str, unit: &str) -> String {
    format!("{name} [{unit}]")
}

/// The shortest text that reads back as the same double.
fn number(value: f64) -> String {
    let mut text = String::new();
    put_number(&mut text, value);
    text
}

/// The same at the end of a text: a string for each cell would take longer than its digits.
fn put_number(text: &mut String, value: f64) {
    // A string refuses nothing.
    let _ = if value == 0.0 || (1e-4..1e6).contains(&value.abs()) { write!(text, "{value}") } else { write!(text, "{value:e}") };
}
