//! The one table writer: CSV with the unit of every column in its header.

use super::Outcome;
use crate::estimate::Estimate;

/// The states table: swept numbers, labels, status, then each value with its error bound; empty cells where there is no value.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn states(outcome: &Outcome) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header: Vec<String> = outcome.swept.iter().map(|swept| headed(&swept.key, &swept.unit)).collect();
    header.extend(outcome.labels.iter().map(|label| (*label).to_owned()));
    header.push("status".to_owned());
    for column in &outcome.columns {
        header.push(headed(column.name, &column.unit));
        header.push(headed(&format!("{}_error", column.name), &column.unit));
        if outcome.draws > 0 {
            header.push(headed(&format!("{}_material_uncertainty", column.name), &column.unit));
        }
    }
    header.push("residual [1]".to_owned());
    if outcome.draws > 0 {
        header.extend(["draws", "draws_used", "draws_in_another_state", "draws_failed", "draws_note"].map(str::to_owned));
    }
    header.push("reason".to_owned());
    writer.write_record(&header)?;
    for row in &outcome.rows {
        let mut record: Vec<String> = row.swept.iter().map(|value| number(*value)).collect();
        record.extend((0..outcome.labels.len()).map(|place| row.label(place).to_owned()));
        record.push(row.status.word().to_owned());
        for index in 0..outcome.columns.len() {
            record.extend(cells(row.values.get(index).copied().flatten()));
            if outcome.draws > 0 {
                record.push(row.material_deviation(index).map_or_else(String::new, number));
            }
        }
        record.push(row.certificate.map_or_else(String::new, |certificate| number(certificate.residual)));
        if outcome.draws > 0 {
            record.extend(draws(outcome, row));
        }
        record.push(row.reason.clone().unwrap_or_default());
        writer.write_record(&record)?;
    }
    finished(writer)
}

/// How the draws of the material ended in a row.
fn draws(outcome: &Outcome, row: &super::Row) -> [String; 5] {
    row.material.as_ref().map_or_else(Default::default, |material| {
        let counts = &material.counts;
        let [all, used, other, failed] = [counts.draws, counts.used, counts.other_state, counts.failed].map(|count| count.to_string());
        [all, used, other, failed, material.note(&outcome.columns).unwrap_or_default()]
    })
}

/// The fields table, or none if no row has fields.
///
/// # Errors
/// Only what the CSV writer itself reports.
pub fn fields(outcome: &Outcome) -> Result<Option<Vec<u8>>, csv::Error> {
    if outcome.rows.iter().all(|row| row.fields.is_empty()) {
        return Ok(None);
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header: Vec<String> = outcome.swept.iter().map(|swept| headed(&swept.key, &swept.unit)).collect();
    header.extend(outcome.labels.first().map(|label| (*label).to_owned()));
    for (index, column) in outcome.field_columns.iter().enumerate() {
        header.push(headed(column.name, &column.unit));
        // The place is exact.
        if index > 0 {
            header.push(headed(&format!("{}_error", column.name), &column.unit));
        }
    }
    writer.write_record(&header)?;
    for row in &outcome.rows {
        for point in &row.fields {
            let mut record: Vec<String> = row.swept.iter().map(|value| number(*value)).collect();
            record.push(row.label(0).to_owned());
            record.push(number(point.place));
            record.extend(point.values.iter().flat_map(|&value| cells(Some(value))));
            writer.write_record(&record)?;
        }
    }
    finished(writer).map(Some)
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

fn cells(estimate: Option<Estimate>) -> [String; 2] {
    estimate.map_or_else(Default::default, |estimate| [number(estimate.value), number(estimate.error)])
}

/// The shortest text that reads back as the same double.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-4..1e6).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}
