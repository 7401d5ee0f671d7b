//! summary.json: the whole outcome. Rows are written one by one, so that a long sweep needs no memory for them.

use super::{Outcome, Row, Status};
use crate::estimate::Estimate;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

/// Most rows in `summary.json`. It says so where there are more, which only the CSV file holds.
const MOST_ROWS: usize = 10_000;

/// The summary with all rows, as pretty JSON, row after row. Two runs of the same scene by the same build give the same bytes.
///
/// # Errors
/// A writer that refuses.
pub fn write_whole(outcome: &Outcome, writer: impl std::io::Write) -> Result<(), serde_json::Error> {
    serde_json::to_writer_pretty(writer, &Summary { head: head(outcome), results: Results { outcome, most: usize::MAX } })
}

/// The same for a folder that holds all rows in `states.csv`, too: with no rows where there are very many.
///
/// # Errors
/// A writer that refuses.
pub fn write_short(outcome: &Outcome, writer: impl std::io::Write) -> Result<(), serde_json::Error> {
    let mut head = head(outcome);
    let omitted = omitted(outcome);
    if let (true, Some(rows)) = (omitted > 0, head.get_mut("rows").and_then(Value::as_object_mut)) {
        rows.insert("omitted".into(), omitted.into());
        rows.insert("omitted_rows_are_in".into(), "states.csv".into());
    }
    serde_json::to_writer_pretty(writer, &Summary { head, results: Results { outcome, most: MOST_ROWS } })
}

/// Rows that `summary.json` leaves out.
#[must_use]
pub fn omitted(outcome: &Outcome) -> usize {
    if outcome.rows.len() > MOST_ROWS { outcome.rows.len() } else { 0 }
}

/// The summary with all rows, as a value.
#[must_use]
pub fn summary(outcome: &Outcome) -> Value {
    let mut summary = head(outcome);
    if let Some(members) = summary.as_object_mut() {
        members.insert("results".into(), outcome.rows.iter().map(|row| result(outcome, row)).collect());
    }
    summary
}

#[derive(Serialize)]
struct Summary<'o> {
    #[serde(flatten)]
    head: Value,
    results: Results<'o>,
}

/// Rows, made one by one as they are written.
struct Results<'o> {
    outcome: &'o Outcome,
    most: usize,
}

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let rows = if self.outcome.rows.len() <= self.most { self.outcome.rows.as_slice() } else { &[] };
        serializer.collect_seq(rows.iter().map(|row| result(self.outcome, row)))
    }
}

/// All but the rows.
fn head(outcome: &Outcome) -> Value {
    let count = |status: Status| outcome.rows.iter().filter(|row| row.status == status).count();
    json!({
        "title": outcome.title,
        "problem": outcome.problem,
        "provenance": {
            "program": "viscotack",
            "version": env!("CARGO_PKG_VERSION"),
            "commit": env!("VISCOTACK_COMMIT"),
            "scene_sha256": outcome.scene_hash,
        },
        "accuracy": outcome.accuracy,
        "exit_code": outcome.exit_code(),
        "effects": outcome.effects,
        "method": outcome.method,
        "groups": outcome.groups,
        "validity": outcome.validity,
        "certificate": certificate(outcome),
        "work": outcome.work(),
        "swept": outcome.swept,
        "columns": outcome.columns,
        "rows": {
            "total": outcome.rows.len(),
            "solved": count(Status::Solved),
            "inaccurate": count(Status::Inaccurate),
            "no_such_state": count(Status::NoSuchState),
            "undefined": count(Status::Undefined),
            "invalid": count(Status::Invalid),
            "not_converged": count(Status::NotConverged),
            "inadmissible": count(Status::Inadmissible),
        },
    })
}

/// The worst of every row's certificate.
fn certificate(outcome: &Outcome) -> Value {
    let certificates = || outcome.rows.iter().filter_map(|row| row.certificate);
    let worst = |of: fn(&super::Certificate) -> f64| certificates().map(|certificate| of(&certificate)).fold(0.0, f64::max);
    json!({
        "largest_residual": worst(|certificate| certificate.residual),
        "largest_condition": worst(|certificate| certificate.condition),
        "all_admissible": certificates().all(|certificate| certificate.admissible),
    })
}

fn result(outcome: &Outcome, row: &Row) -> Value {
    let mut values = Map::new();
    for (index, (column, value)) in outcome.columns.iter().zip(&row.values).enumerate() {
        if let Some(Estimate { value, error }) = value {
            let mut entry = json!({ "value": value, "error": error, "unit": column.unit });
            if row.material.is_some() {
                entry["material_uncertainty"] = json!(row.material_deviation(index));
            }
            values.insert(column.name.to_owned(), entry);
        }
    }
    let swept: Map<String, Value> = outcome
        .swept
        .iter()
        .zip(&row.swept)
        .map(|(swept, value)| (swept.key.clone(), json!({ "value": value, "unit": swept.unit })))
        .collect();
    let mut result = Map::new();
    result.insert("swept".into(), swept.into());
    for (place, label) in outcome.labels.iter().enumerate() {
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
        draws["note"] = json!(material.note(&outcome.columns));
        result.insert("material_draws".into(), draws);
    }
    result.into()
}
