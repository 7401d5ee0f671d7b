//! Every number of a scene beside that of the same scene at a thousandth of the accuracy, written in other units.
//!
//! Rows are the same state if their labels are, and, where both answers have another number of them, if their time is the same. Of a branch only turns are compared: its
//! other points are spread along the curve, whose length is a result.

use super::super::calibration::tally::Compared;
use super::drawn::{Drawn, Problem, drawn};
use std::collections::BTreeMap;
use viscotack::estimate::Estimate;
use viscotack_program::outcome::{Outcome, Row, SUMMARY};

/// Two times of a history are one if they agree to this part of the longer.
const SAME_TIME: f64 = 1e-13;

/// What the last digits of inputs, written in other units, leave of a number, over itself.
const INPUTS: f64 = 4.0 * f64::EPSILON;

/// Columns that describe the run that was made, not the contact or crack: counts of work, and what a run itself left of its equations.
const OF_THE_RUN: [&str; 8] =
    ["steps", "nodes", "most_pieces", "most_panels", "residual", "power_balance_defect", "energy_defect", "point"];

/// A number with the column that it stands in.
#[derive(Debug, Clone)]
pub struct Value {
    /// The column; of fields with their own prefix.
    pub column: String,
    /// Which row it is of, in words.
    pub row: String,
    /// Beside its truth.
    pub compared: Compared,
    /// It states no error.
    pub exact: bool,
}

impl Value {
    /// The number and its truth in words.
    #[must_use]
    pub fn described(&self) -> String {
        let Compared { found, truth, .. } = self.compared;
        format!("{} [{}] {:e} ± {:.1e}, truth {:e} ± {:.1e}", self.column, self.row, found.value, found.error, truth.value, truth.error)
    }
}

/// A scene with its numbers.
#[derive(Debug, Clone)]
pub struct Assessed {
    /// The scene.
    pub drawn: Drawn,
    /// Its number.
    pub scene: u64,
    /// Its numbers.
    pub values: Vec<Value>,
    /// Rows or numbers that only one of both answers has.
    pub unmatched: Vec<String>,
    /// Why there is no answer, at the first or the second accuracy.
    pub refused: [Option<String>; 2],
}

/// Draws and solves a scene twice.
#[must_use]
pub fn assessed(seed: u64, problem: Problem, scene: u64) -> Assessed {
    let first = drawn(seed, problem, scene, 0);
    let second = drawn(seed, problem, scene, 1);
    let (found, exact) = (first.solved(first.accuracy), second.solved_tightly());
    compared_with(first, scene, found, exact)
}

/// The rows of a scene beside those of its truth.
#[must_use]
pub fn compared_with(drawn: Drawn, scene: u64, found: Result<Outcome, String>, exact: Result<Outcome, String>) -> Assessed {
    let mut assessed = Assessed { drawn, scene, values: Vec::new(), unmatched: Vec::new(), refused: [None, None] };
    match (found, exact) {
        (Ok(found), Ok(exact)) => compare(&mut assessed, &found, &exact),
        (found, exact) => assessed.refused = [found.err(), exact.err()],
    }
    assessed
}

/// Whether a row is a point of a branch that is no turn.
fn is_spread(problem: Problem, row: &Row) -> bool {
    problem == Problem::Sliding && row.labels.len() > 3 && row.labels.last().is_some_and(String::is_empty)
}

fn compare(assessed: &mut Assessed, found: &Outcome, exact: &Outcome) {
    let time = found.columns.iter().position(|column| column.name == "time");
    if !found.columns.iter().map(|column| column.name).eq(exact.columns.iter().map(|column| column.name)) {
        assessed.unmatched.push("both answers have other columns".into());
        return;
    }
    // How many cycles it takes until they are stationary depends on the accuracy, and with it which one is the last.
    let settles = ["until_stationary", "\"dynamic\""].into_iter().any(|word| assessed.drawn.text.contains(word));
    let rows = |outcome: &Outcome| {
        let mut groups: BTreeMap<(usize, Vec<String>), Vec<Row>> = BTreeMap::new();
        for row in outcome.rows.iter().filter(|row| !(is_spread(assessed.drawn.problem, row) || settles && row.label(0) == SUMMARY)) {
            groups.entry((row.state, row.labels.clone())).or_default().push(row.clone());
        }
        groups
    };
    let (mut ours, theirs) = (rows(found), rows(exact));
    for ((state, labels), truths) in theirs {
        let founds = ours.remove(&(state, labels.clone())).unwrap_or_default();
        let name = format!("{state} {}", labels.join(" "));
        let at = |row: &Row| time.and_then(|column| row.value(column));
        let event = labels.first().is_some_and(|label| label == "event");
        let together = |found: &Row, truth: &Row| match (at(found), at(truth)) {
            (Some(one), Some(two)) => event || (one - two).abs() <= SAME_TIME * one.abs().max(two.abs()),
            _ => true,
        };
        if founds.len() == truths.len() && founds.iter().zip(&truths).all(|(found, truth)| together(found, truth)) {
            founds.iter().zip(&truths).for_each(|(found, truth)| pair(assessed, (&name, found, truth), &exact_columns(exact), exact));
            continue;
        }
        // Points between instants stand where steps of the solver ended.
        if time.is_none() || event {
            assessed.unmatched.push(format!("{name}: {} rows, and {} at the tighter accuracy", founds.len(), truths.len()));
            continue;
        }
        for found in &founds {
            let partner = truths.iter().find(|truth| together(found, truth));
            if let Some(truth) = partner {
                pair(assessed, (&name, found, truth), &exact_columns(exact), exact);
            }
        }
    }
    for ((state, labels), rows) in ours {
        assessed.unmatched.push(format!("{state} {}: {} rows that the tighter accuracy has not", labels.join(" "), rows.len()));
    }
}

fn exact_columns(outcome: &Outcome) -> Vec<(String, String)> {
    outcome.columns.iter().map(|column| (column.name.to_owned(), column.unit.clone())).collect()
}

fn pair(assessed: &mut Assessed, (name, found, truth): (&str, &Row, &Row), columns: &[(String, String)], outcome: &Outcome) {
    if found.status.has_values() != truth.status.has_values() {
        assessed.unmatched.push(format!("{name}: {}, and {} at the tighter accuracy", found.status.word(), truth.status.word()));
        return;
    }
    for (index, (column, unit)) in columns.iter().enumerate().filter(|(_, (column, _))| !OF_THE_RUN.contains(&column.as_str())) {
        let at = |row: &Row| row.values.get(index).copied().flatten();
        match (at(found), at(truth)) {
            (Some(value), Some(other)) => {
                // Rounding is relative to what else is measured in this unit.
                let alike = columns.iter().enumerate().filter(|(_, (_, other))| other == unit);
                let scale = alike.filter_map(|(index, _)| truth.value(index)).fold(0.0, |most: f64, value| most.max(value.abs()));
                assessed.values.push(value_of(column.clone(), name, (value, other), scale));
            }
            (None, None) => {}
            (one, _) => {
                let which = if one.is_some() { "the looser" } else { "the tighter" };
                assessed.unmatched.push(format!("{name}: {column} at {which} accuracy only"));
            }
        }
    }
    if found.fields.len() != truth.fields.len() {
        assessed.unmatched.push(format!("{name}: {} field points, and {}", found.fields.len(), truth.fields.len()));
        return;
    }
    fields(assessed, name, (found, truth), outcome);
}

fn value_of(column: String, row: &str, (found, truth): (Estimate, Estimate), scale: f64) -> Value {
    let truth = Estimate::new(truth.value, truth.error + INPUTS * truth.value.abs());
    let compared = Compared { quantity: "", found, truth, scale, floor: 0.0 };
    Value { column, row: row.to_owned(), compared, exact: found.error == 0.0 }
}

/// Fields at their places; where those follow from a result, the truth goes to the place of the found one along the line through its neighbours.
fn fields(assessed: &mut Assessed, name: &str, (found, truth): (&Row, &Row), outcome: &Outcome) {
    let names = outcome.field_columns.iter().skip(1).map(|column| column.name).collect::<Vec<_>>();
    let most = |place: usize| {
        truth.fields.iter().filter_map(|point| point.values.get(place)).fold(0.0, |most: f64, value| most.max(value.value.abs()))
    };
    let scales: Vec<f64> = (0..names.len()).map(most).collect();
    for (index, (one, other)) in found.fields.iter().zip(&truth.fields).enumerate() {
        let around = |step: usize| if step == 0 { index.checked_sub(1) } else { Some(index + 1) }.and_then(|index| truth.fields.get(index));
        for (place, column) in names.iter().enumerate() {
            let (Some(value), Some(exact)) = (one.values.get(place), other.values.get(place)) else { continue };
            let moved = one.place - other.place;
            let slopes = [around(0), around(1)].map(|next| {
                let next = next?;
                let run = next.place - other.place;
                (run != 0.0).then(|| (next.values.get(place).map_or(f64::NAN, |value| value.value) - exact.value) / run)
            });
            // The truth at the place of the found one, between the slopes on both sides.
            let [one_side, other_side] = [slopes[0].or(slopes[1]).unwrap_or(0.0), slopes[1].or(slopes[0]).unwrap_or(0.0)];
            // At the first and the last place one side alone says little: as much again, and a power of the place.
            let at_an_end = if slopes.iter().all(Option::is_some) { 0.0 } else { one_side.abs() + (exact.value / other.place).abs() };
            let (slope, unknown) = (0.5 * (one_side + other_side), (one_side - other_side).abs() + at_an_end);
            let (carried, unknown) = if moved == 0.0 { (0.0, 0.0) } else { (slope * moved, unknown * moved.abs()) };
            let truth = Estimate::new(exact.value + carried, exact.error + unknown);
            let row = format!("{name} at {:e}", one.place);
            let scale = scales.get(place).copied().unwrap_or(0.0);
            assessed.values.push(value_of(format!("fields: {column}"), &row, (*value, truth), scale));
        }
    }
}
