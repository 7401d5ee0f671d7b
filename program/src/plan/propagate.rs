//! What a fitted material leaves open, carried to the rows of a state: the state is solved for every draw, and each row gets its spread over them.
//!
//! Every problem comes by here: a plan of one draw is a plan as any other. Rows of two solutions are the same state if their labels are, and, where the
//! problem prescribes an abscissa such as the time, if it is the same; events, whose time is a result, are counted instead.

use super::state_watch::{Progress, Stage, StateWatch};
use super::{ProblemPlan, problem_plan};
use crate::outcome::material_uncertainty::{DrawCounts, MaterialUncertainty};
use crate::outcome::{Assessment, Column, Row, Status, Validity};
use crate::scene::typed::Scene;
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use viscotack::refusal::Refusal;

/// The plan of a draw, or why there is none.
pub(super) type Draw = Result<Arc<dyn ProblemPlan>, Refusal>;

/// How closely two abscissae agree that are the same (they are computed from the same numbers of the scene).
const SAME: f64 = 1e-9;

/// The plans of all draws of a scene; none if it asks for none.
pub(super) fn draws(scene: &Scene) -> Vec<Draw> {
    let Some(draws) = &scene.material.draws else { return Vec::new() };
    draws
        .iter()
        .map(|series| {
            let mut drawn = scene.clone();
            drawn.material.series = series.clone();
            drawn.material.draws = None;
            problem_plan(&drawn)
        })
        .collect()
}

/// Solves the draws of a state and gives each row its spread over them; their work is added to that of the first row.
pub(super) fn attach(problem: &dyn ProblemPlan, draws: &[Draw], rows: &mut [Row], swept: &[f64], progress: Progress<'_>) {
    let Some(state) = rows.first().map(|row| row.state) else { return };
    if draws.is_empty() {
        return;
    }
    let finished = AtomicUsize::new(0);
    let solved: Vec<Result<Vec<Row>, &Refusal>> = draws
        .par_iter()
        .map(|draw| {
            let rows = draw
                .as_ref()
                .map(|plan| plan.solve(state, swept, &StateWatch::new(state, None, &|_| ())).into_iter().map(Row::settled).collect());
            progress(Stage::Draws { state, finished: finished.fetch_add(1, Ordering::Relaxed) + 1, total: draws.len() });
            rows
        })
        .collect();
    let columns = problem.columns();
    let abscissa = problem.abscissa().and_then(|name| columns.iter().position(|column| column.name == name));
    let spreads: Vec<MaterialUncertainty> = (0..rows.len()).map(|index| spread(rows, index, &solved, abscissa)).collect();
    for (row, spread) in rows.iter_mut().zip(spreads) {
        row.material = Some(spread);
    }
    if let Some(first) = rows.first_mut() {
        solved.iter().flatten().flatten().for_each(|row| first.work += row.work);
    }
}

/// The spread of one row.
fn spread(rows: &[Row], index: usize, solved: &[Result<Vec<Row>, &Refusal>], abscissa: Option<usize>) -> MaterialUncertainty {
    let mut counts = DrawCounts { draws: solved.len(), used: 0, other_state: 0, failed: 0, reason: None };
    let mut same = Vec::new();
    let Some(row) = rows.get(index) else { return MaterialUncertainty { counts, columns: Vec::new() } };
    let fail = |counts: &mut DrawCounts, reason: String| {
        counts.failed += 1;
        counts.reason.get_or_insert(reason);
    };
    for draw in solved {
        let draw = match draw {
            Ok(draw) => draw,
            Err(refusal) => {
                fail(&mut counts, refusal.to_string());
                continue;
            }
        };
        let broken = |row: &&Row| matches!(row.status, Status::Undefined | Status::Invalid | Status::NotConverged | Status::Inadmissible);
        let found = counterpart(rows, index, draw, abscissa);
        match found {
            Some(found) if found.labels == row.labels && found.status.has_values() == row.status.has_values() && !broken(&found) => {
                same.push(found)
            }
            _ => match found.into_iter().chain(draw).find(broken) {
                Some(found) => fail(&mut counts, found.reason.clone().unwrap_or_else(|| found.status.word().to_owned())),
                None => counts.other_state += 1,
            },
        }
    }
    MaterialUncertainty::of(row, &same, counts)
}

/// The row of another solution that is the same place of the history, event or contact: as many rows like it stand before it.
fn counterpart<'r>(rows: &[Row], index: usize, others: &'r [Row], abscissa: Option<usize>) -> Option<&'r Row> {
    let row = rows.get(index)?;
    // Rows of a prescribed place are found by it, whatever their state; others by their labels.
    let place = |row: &Row| abscissa.filter(|_| !is_event(row)).and_then(|column| row.value(column));
    let own = place(row);
    let alike = |other: &Row| match (own, place(other)) {
        (Some(own), Some(other_place)) => {
            row.label(0) == other.label(0) && (own - other_place).abs() <= SAME * own.abs().max(other_place.abs())
        }
        (None, None) if is_event(row) => row.labels == other.labels,
        (None, None) => row.label(0) == other.label(0) && !is_event(other),
        _ => false,
    };
    let before = rows.iter().take(index).filter(|other| alike(other)).count();
    others.iter().filter(|other| alike(other)).nth(before)
}

/// Whether a row is an event of a history or a turn of a branch: its last label names it.
fn is_event(row: &Row) -> bool {
    row.labels.len() > 1 && row.labels.first().is_some_and(|label| label == "event")
        || row.labels.len() > 3 && row.labels.last().is_some_and(|label| !label.is_empty())
}

/// How much of the results rests on draws, for the validity block.
pub(super) fn validity(rows: &[Row], columns: &[Column]) -> Option<Validity> {
    let spreads = || rows.iter().filter_map(|row| row.material.as_ref());
    let fewest = spreads()
        .map(|spread| (spread.counts.used as f64 / (spread.counts.draws.max(1)) as f64, spread))
        .min_by(|left, right| left.0.total_cmp(&right.0))?;
    let noted = spreads().find_map(|spread| spread.note(columns));
    let (assessment, meaning) = match noted {
        None => (Assessment::Good, "part of the draws of the material that have the state of each row: all".to_owned()),
        Some(note) => (Assessment::Caution, format!("smallest part of the draws of the material that have the state of a row; {note}")),
    };
    Some(Validity { name: "draws of the material".into(), value: Some(fewest.0), assessment, meaning })
}
