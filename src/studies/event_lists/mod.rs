//! What happens to a crack does not depend on the accuracy that is asked for: lists of events at 1e-3 … 1e-7, with every number within both bounds.

pub mod scenes;

use super::effects::solved;
use crate::estimate::Estimate;
use crate::outcome::{Row, Status};

/// Accuracies of a scene; the last one, of five times as many lines and so with a hundredth of the error, is what the others are compared with.
pub const ACCURACIES: [f64; 6] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9];

/// A scene at all accuracies.
#[derive(Debug, Clone, Default)]
pub struct Compared {
    /// Events at the finest accuracy.
    pub events: Vec<String>,
    /// Lists that differ, runs that fail.
    pub wrong_lists: Vec<String>,
    /// Numbers that differ by more than both bounds: how many times, and which.
    pub outside: Vec<(f64, String)>,
    /// Rows flagged as inaccurate, by accuracy.
    pub flagged: [usize; ACCURACIES.len()],
    /// Numbers compared.
    pub numbers: usize,
}

/// The label of an event, or that of a sample.
fn label(row: &Row) -> String {
    match row.labels.as_slice() {
        [record, state, event] if record == "event" => format!("{event} ({state})"),
        [record, state, _] => format!("{record} {state}"),
        _ => String::new(),
    }
}

/// Whether it is a row of an event, or of the end.
fn is_event(row: &Row) -> bool {
    row.labels.first().is_some_and(|record| record == "event")
}

/// Solves a scene at all accuracies, and compares.
#[must_use]
pub fn compared(scene: &str, accuracies: &[f64]) -> Compared {
    let mut compared = Compared::default();
    let mut found = Vec::new();
    for (index, accuracy) in accuracies.iter().enumerate() {
        match solved(&with_accuracy(scene, *accuracy), 1) {
            Ok((outcome, _)) => {
                if let Some(flagged) = compared.flagged.get_mut(index) {
                    *flagged = outcome.rows.iter().filter(|row| row.status == Status::Inaccurate).count();
                }
                if let Some(row) = outcome.rows.iter().find(|row| !matches!(row.status, Status::Solved | Status::Inaccurate)) {
                    compared.wrong_lists.push(format!("{accuracy:e}: {:?} {:?}", row.status, row.reason));
                }
                found.push((*accuracy, outcome));
            }
            Err(words) => compared.wrong_lists.push(format!("{accuracy:e}: {words}")),
        }
    }
    let Some((_, finest)) = found.pop() else { return compared };
    let names: Vec<&str> = finest.columns.iter().map(|column| column.name).collect();
    let list = |rows: &[Row]| rows.iter().filter(|row| is_event(row)).map(label).collect::<Vec<_>>();
    compared.events = list(&finest.rows);
    for (accuracy, outcome) in &found {
        let events = list(&outcome.rows);
        if events != compared.events {
            compared.wrong_lists.push(format!("{accuracy:e}: {}", events.join(", ")));
            continue;
        }
        for of_events in [true, false] {
            let rows = |rows: &'_ [Row]| rows.iter().filter(|row| is_event(row) == of_events).cloned().collect::<Vec<_>>();
            for (position, (row, other)) in rows(&outcome.rows).iter().zip(&rows(&finest.rows)).enumerate() {
                for ((name, one), two) in names.iter().zip(&row.values).zip(&other.values) {
                    if ["steps", "most_pieces"].contains(name) {
                        continue;
                    }
                    match (one, two) {
                        (Some(one), Some(two)) => {
                            compared.numbers += 1;
                            let times = outside(one, two);
                            if times > 1.0 {
                                let what = format!("{accuracy:e}: {name} of row {position}, {}: {one:?} {two:?}", label(row));
                                compared.outside.push((times, what));
                            }
                        }
                        (None, None) => {}
                        _ => compared.wrong_lists.push(format!("{accuracy:e}: {name} of {} is there at one accuracy only", label(row))),
                    }
                }
            }
        }
    }
    compared
}

/// How many times both bounds two numbers are apart.
fn outside(one: &Estimate, two: &Estimate) -> f64 {
    let bounds = one.error + two.error;
    let off = (one.value - two.value).abs();
    if off <= bounds { 0.0 } else { off / bounds }
}

fn with_accuracy(scene: &str, accuracy: f64) -> String {
    format!("accuracy = {accuracy:e}\n{scene}")
}
