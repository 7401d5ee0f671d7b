//! What happens to a crack does not depend on the accuracy that is asked for: lists of events at 1e-3 … 1e-7, of cheap scenes also at 1e-9, with every number within
//! both bounds.
//!
//! A scene is solved at each accuracy as a user solves it. The lists must be equal; each number must agree with that of the finest run within both bounds. A run at 1e-9
//! has five times as many lines as one at 1e-7, and so a hundredth of its error.

pub mod scenes;

use super::cells::{count, number, word};
use super::draw::Draw;
use super::effects::solved;
use super::{Check, Column, Effort, Progress, Section, Table};
use rayon::prelude::*;
use std::path::Path;
use viscotack::estimate::Estimate;
use viscotack_program::outcome::{Row, Status};
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, read};

/// Accuracies of a scene; the last one is what the others are compared with. Only cheap scenes are solved at the last one.
pub const ACCURACIES: [f64; 6] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9];

/// The seed of the scenes that assess; the bounds were set with others.
pub const SEED: u64 = 0x3600_0007;

/// Scenes of the full study, and of the reduced one.
const SCENES: (usize, usize) = (2000, 12);

/// Scenes are solved at the last accuracy, too, of which no more integrals of a term are predicted: in the reduced study, which takes no others, and in the full one.
const CHEAP: (u64, u64) = (1_500_000, 300_000);

/// The full study leaves out scenes of which more are predicted, minutes each: one in six.
const MOST: u64 = 10_000_000;

/// A scene at all accuracies.
#[derive(Debug, Clone, Default)]
pub struct Compared {
    /// Events at the finest accuracy.
    pub events: Vec<String>,
    /// Lists that differ, runs that fail.
    pub wrong_lists: Vec<String>,
    /// Numbers that differ by more than both bounds: how many times, and which.
    pub outside: Vec<(f64, String)>,
    /// Rows flagged as inaccurate.
    pub flagged: usize,
    /// Numbers compared.
    pub numbers: usize,
}

/// The label of a row, without that of its place among the others.
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

fn of_kind(rows: &[Row], events: bool) -> Vec<&Row> {
    rows.iter().filter(|row| is_event(row) == events).collect()
}

fn list(rows: &[Row]) -> Vec<String> {
    of_kind(rows, true).into_iter().map(label).collect()
}

/// Solves a scene at some accuracies, and compares all with the last.
#[must_use]
pub fn compared(scene: &str, accuracies: &[f64]) -> Compared {
    let mut compared = Compared::default();
    let mut found = Vec::new();
    for accuracy in accuracies {
        match solved(&format!("accuracy = {accuracy:e}\n{scene}"), 1) {
            Ok((outcome, _)) => {
                compared.flagged += outcome.rows.iter().filter(|row| row.status == Status::Inaccurate).count();
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
    compared.events = list(&finest.rows);
    for (accuracy, outcome) in &found {
        let events = list(&outcome.rows);
        if events != compared.events {
            compared.wrong_lists.push(format!("{accuracy:e}: {}", events.join(", ")));
            continue;
        }
        for events in [true, false] {
            for (row, other) in of_kind(&outcome.rows, events).into_iter().zip(of_kind(&finest.rows, events)) {
                for ((name, one), two) in names.iter().zip(&row.values).zip(&other.values) {
                    match (one, two) {
                        // Counters of work are not results.
                        _ if ["steps", "most_pieces"].contains(name) => {}
                        (Some(one), Some(two)) => {
                            compared.numbers += 1;
                            let times = over_both_bounds(one, two);
                            if times > 1.0 {
                                compared.outside.push((times, format!("{accuracy:e}: {name} of {}: {one:?} {two:?}", label(row))));
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
fn over_both_bounds(one: &Estimate, two: &Estimate) -> f64 {
    let (off, bounds) = ((one.value - two.value).abs(), one.error + two.error);
    if off <= bounds { 0.0 } else { off / bounds }
}

/// Integrals of a term that a scene is predicted to take at the first accuracy.
#[must_use]
pub fn predicted(scene: &str) -> Option<u64> {
    let document = Document::parse("scene.toml", format!("accuracy = 1e-3\n{scene}"), Path::new("/nowhere")).ok()?;
    let scene = read::read(&document).ok()?;
    Some(Plan::new(&scene).ok()?.predicted_work().kernel_evaluations)
}

/// The accuracies of a scene.
fn accuracies(scene: &str, effort: Effort) -> &'static [f64] {
    let cheap = predicted(scene).is_none_or(|work| work < effort.choose(CHEAP.0, CHEAP.1));
    if cheap { &ACCURACIES } else { ACCURACIES.split_last().map_or(&[], |(_, others)| others) }
}

/// The first scenes of a seed of which no more integrals of a term are predicted.
#[must_use]
pub fn drawn(seed: u64, many: usize, most: u64) -> Vec<(u64, String)> {
    (0..)
        .map(|scene| (scene, scenes::scene(&mut Draw::of(seed, scene))))
        .filter(|(_, text)| predicted(text).is_none_or(|work| work < most))
        .take(many)
        .collect()
}

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let chosen = drawn(SEED, effort.choose(SCENES.1, SCENES.0), effort.choose(CHEAP.0, MOST));
    progress.expect(chosen.len() as u64);
    let found: Vec<(u64, Compared)> = chosen
        .into_par_iter()
        .map(|(scene, text)| {
            let found = compared(&text, accuracies(&text, effort));
            progress.advance(1);
            (scene, found)
        })
        .collect();
    let mut section = Section::new("event_lists", "Events of cracks at all accuracies");
    section.say(
        "Random cracks under steps, ramps, holds, cycles and tables are solved at accuracies from 1e-3 to 1e-7, those of little work also at 1e-9. Starts, arrests, restarts, jumps and kinks must \
         be the same in the same order, and each number must agree with that of the finest run within both bounds.",
    );
    let numbers: usize = found.iter().map(|(_, one)| one.numbers).sum();
    let events: usize = found.iter().map(|(_, one)| one.events.len()).sum();
    let wrong: Vec<(u64, String)> = found
        .iter()
        .filter_map(|(scene, one)| Some((*scene, format!("[{}] {}", one.events.join(", "), one.wrong_lists.first()?))))
        .collect();
    let outside: Vec<(u64, f64, String)> = found
        .iter()
        .filter_map(|(scene, one)| {
            one.outside.iter().max_by(|one, other| one.0.total_cmp(&other.0)).map(|(times, what)| (*scene, *times, what.clone()))
        })
        .collect();
    let first = wrong.first().map_or_else(String::new, |(scene, what)| format!(", the first: scene {scene}, {what}"));
    section.checks.push(Check::new(
        "the lists of events are equal at all accuracies",
        "0 scenes with another list",
        format!("{} of {} scenes with {events} events{first}", wrong.len(), found.len()),
        wrong.is_empty(),
    ));
    let first =
        outside.first().map_or_else(String::new, |(scene, times, what)| format!(", the first: scene {scene}, {times:.2} times, {what}"));
    section.checks.push(Check::new(
        "numbers at all accuracies agree within both bounds",
        "0 scenes with a number outside",
        format!("{} of {} scenes with {numbers} numbers{first}", outside.len(), found.len()),
        outside.is_empty(),
    ));
    let columns = vec![Column::new("scene", "1"), Column::new("times both bounds", "1"), Column::words("what")];
    let mut table = Table::new("wrong", "Scenes with another list or a number outside its bounds: empty if all is well.", columns);
    table.rows.extend(wrong.into_iter().map(|(scene, what)| vec![count(scene as usize), number(f64::NAN), word(what)]));
    table.rows.extend(outside.into_iter().map(|(scene, times, what)| vec![count(scene as usize), number(times), word(what)]));
    section.tables.push(table.folded());
    section
}
