//! summary.json: the whole outcome. Rows are written one by one, so that a long sweep needs no memory for them.

use super::tally::Ended;
use super::{Column, Outcome, Row, Status, SweptColumn};
use serde_json::{Map, Value, json};
use std::io::Write;
use viscotack::estimate::Estimate;

/// Most rows in `summary.json`. It says so where there are more, which only the CSV file holds.
const MOST_ROWS: usize = 10_000;

/// The summary with all rows, as pretty JSON, row after row. Two runs of the same scene by the same build give the same bytes.
///
/// # Errors
/// A writer that refuses, or a journal that cannot be read.
pub fn write_whole(outcome: &Outcome, mut writer: impl Write + Send) -> std::io::Result<()> {
    let head = pretty(&head(outcome))?;
    writeln!(writer, "{},", head.trim_end_matches("\n}"))?;
    let mut results = Results::new(outcome.into(), &mut writer)?;
    let names = Names::from(outcome);
    outcome.each_part(
        |rows| rows.iter().map(|row| indented(names, row)).collect::<std::io::Result<Vec<_>>>(),
        |texts| texts.iter().try_for_each(|text| results.write(text)),
    )?;
    results.finish()?.write_all(b"\n}")
}

/// The same for a folder that holds all rows in its tables, too: with no rows where there are very many.
///
/// # Errors
/// A writer that refuses.
pub fn write_short(outcome: &Outcome, mut writer: impl Write + Send) -> std::io::Result<()> {
    let omitted = omitted(outcome);
    if omitted == 0 {
        return write_whole(outcome, writer);
    }
    let mut head = head(outcome);
    if let Some(rows) = head.get_mut("rows").and_then(Value::as_object_mut) {
        rows.insert("omitted".into(), omitted.into());
        rows.insert("omitted_rows_are_in".into(), omitted_rows_are_in(outcome).into());
    }
    if let Some(members) = head.as_object_mut() {
        members.insert("results".into(), json!([]));
    }
    writer.write_all(pretty(&head)?.as_bytes())
}

/// Rows that `summary.json` leaves out.
#[must_use]
pub fn omitted(outcome: &Outcome) -> usize {
    if outcome.tally.rows > MOST_ROWS { outcome.tally.rows } else { 0 }
}

/// The files that hold them.
#[must_use]
pub fn omitted_rows_are_in(outcome: &Outcome) -> &'static str {
    if outcome.layout.is_some() { "states.csv and path.csv" } else { "states.csv" }
}

/// The summary with the rows that the outcome holds, as a value.
#[must_use]
pub fn summary(outcome: &Outcome) -> Value {
    let mut summary = head(outcome);
    if let Some(members) = summary.as_object_mut() {
        members.insert("results".into(), outcome.rows.iter().map(|row| result(outcome.into(), row)).collect());
    }
    summary
}

/// A summary whose rows are written while they are solved, before all else: however many there are, they take no memory.
pub struct Streamed<'o, W: Write> {
    results: Results<'o, W>,
}

impl<'o, W: Write> Streamed<'o, W> {
    /// Begins the summary.
    ///
    /// # Errors
    /// A writer that refuses.
    pub fn new(names: Names<'o>, mut writer: W) -> std::io::Result<Self> {
        writer.write_all(b"{\n")?;
        Ok(Self { results: Results::new(names, writer)? })
    }

    /// Writes a row.
    ///
    /// # Errors
    /// A writer that refuses.
    pub fn write(&mut self, row: &Row) -> std::io::Result<()> {
        self.results.write(&indented(self.results.names, row)?)
    }

    /// Writes all else.
    ///
    /// # Errors
    /// A writer that refuses.
    pub fn finish(self, outcome: &Outcome) -> std::io::Result<()> {
        let mut writer = self.results.finish()?;
        let head = pretty(&head(outcome))?;
        write!(writer, ",\n{}", head.trim_start_matches("{\n"))?;
        writer.flush()
    }
}

/// What the parts of a row are called.
#[derive(Debug, Clone, Copy)]
pub struct Names<'o> {
    /// The swept numbers.
    pub swept: &'o [SweptColumn],
    /// The labels.
    pub labels: &'static [&'static str],
    /// The values.
    pub columns: &'o [Column],
}

impl<'o> From<&'o Outcome> for Names<'o> {
    fn from(outcome: &'o Outcome) -> Self {
        Self { swept: &outcome.swept, labels: outcome.labels, columns: &outcome.columns }
    }
}

/// The member `results`, a row at a time.
struct Results<'o, W: Write> {
    names: Names<'o>,
    writer: W,
    rows: usize,
}

impl<'o, W: Write> Results<'o, W> {
    fn new(names: Names<'o>, mut writer: W) -> std::io::Result<Self> {
        writer.write_all(b"  \"results\": [")?;
        Ok(Self { names, writer, rows: 0 })
    }

    /// Writes the text of a row.
    fn write(&mut self, text: &str) -> std::io::Result<()> {
        self.writer.write_all(if self.rows == 0 { b"\n" } else { b",\n" })?;
        self.rows += 1;
        self.writer.write_all(text.as_bytes())
    }

    fn finish(mut self) -> std::io::Result<W> {
        self.writer.write_all(if self.rows == 0 { b"]" } else { b"\n  ]" })?;
        Ok(self.writer)
    }
}

/// The text of a row as it stands in the member `results`.
fn indented(names: Names<'_>, row: &Row) -> std::io::Result<String> {
    Ok(format!("    {}", pretty(&result(names, row))?.replace('\n', "\n    ")))
}

fn pretty(value: &Value) -> std::io::Result<String> {
    Ok(serde_json::to_string_pretty(value)?)
}

/// All but the rows.
fn head(outcome: &Outcome) -> Value {
    let ended = |of: fn(&Ended) -> usize, total: usize| {
        let mut counts = Map::new();
        counts.insert("total".into(), total.into());
        counts.extend(Status::ALL.map(|status| (status.word().to_owned(), of(outcome.tally.ended(status)).into())));
        counts
    };
    let tally = &outcome.tally;
    json!({
        "title": outcome.title,
        "problem": outcome.problem,
        "provenance": {
            "program": "viscotack",
            "version": crate::VERSION,
            "commit": crate::COMMIT,
            "scene_sha256": outcome.scene_hash,
        },
        "accuracy": outcome.accuracy,
        "exit_code": outcome.exit_code(),
        "effects": outcome.effects,
        "method": outcome.method,
        "groups": outcome.groups,
        "validity": outcome.validity,
        "certificate": {
            "largest_residual": tally.largest_residual,
            "largest_condition": tally.largest_condition,
            "all_admissible": tally.all_admissible,
        },
        "work": outcome.work(),
        "swept": outcome.swept,
        "columns": outcome.columns,
        "rows": ended(|ended| ended.rows, tally.rows),
        "states": ended(|ended| ended.states, tally.states),
    })
}

fn result(names: Names<'_>, row: &Row) -> Value {
    let mut values = Map::new();
    for (index, (column, value)) in names.columns.iter().zip(&row.values).enumerate() {
        if let Some(Estimate { value, error }) = value {
            let mut entry = json!({ "value": value, "error": error, "unit": column.unit });
            if row.material.is_some() {
                entry["material_uncertainty"] = json!(row.material_deviation(index));
            }
            values.insert(column.name.to_owned(), entry);
        }
    }
    let swept: Map<String, Value> = names
        .swept
        .iter()
        .zip(&row.swept)
        .map(|(swept, value)| (swept.key.clone(), json!({ "value": value, "unit": swept.unit })))
        .collect();
    let mut result = Map::new();
    result.insert("swept".into(), swept.into());
    for (place, label) in names.labels.iter().enumerate() {
        result.insert((*label).to_owned(), row.label(place).into());
    }
    for (name, value) in [
        ("status", json!(row.status)),
        ("reason", json!(row.reason)),
        ("witness", json!(row.witness)),
        ("values", values.into()),
        ("certificate", json!(row.certificate)),
        ("work", json!(row.work)),
    ] {
        result.insert(name.to_owned(), value);
    }
    if let Some(material) = &row.material {
        let mut draws = json!(material.counts);
        draws["note"] = json!(material.note(names.columns));
        result.insert("material_draws".into(), draws);
    }
    result.into()
}
