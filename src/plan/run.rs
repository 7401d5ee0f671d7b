//! Carrying out a plan: every state of the sweep, in parallel, in order, with a journal.

use super::Plan;
use super::desk::{Desk, Progress, Stage};
use crate::outcome::build;
use crate::outcome::checkpoints::Checkpoints;
use crate::outcome::journal::{Journal, JournalHeader};
use crate::outcome::{Outcome, Row, Status, SweptColumn};
use crate::refusal::Refusal;
use crate::scene::document::Document;
use crate::scene::sweep::{indices, states};
use crate::scene::typed::Scene;
use crate::scene::{SceneError, read};
use rayon::prelude::*;
use thiserror::Error;

/// Most states between two entries of the journal: a kill loses at most these.
const MOST_STATES: u64 = 128;
/// Linear systems between two entries, where states are dear.
const MOST_SOLVES: u64 = 4000;

/// Why a run ended without an outcome.
#[derive(Debug, Error)]
pub enum RunError {
    /// The scene is wrong.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The physics refuses a number of the scene.
    #[error("{0}")]
    Refused(#[from] Refusal),
    /// The journal, or a checkpoint, cannot be written.
    #[error("{0}")]
    Journal(#[from] std::io::Error),
}

/// What a journal of this scene and build is headed with.
#[must_use]
pub fn journal_header(document: &Document, scene: &Scene) -> JournalHeader {
    JournalHeader { program: build::identity().to_owned(), scene: document.hash().to_owned(), states: states(&scene.sweeps) }
}

/// Where a run keeps what it must not lose.
#[derive(Debug)]
pub struct Safe<'a> {
    /// Of finished states.
    pub journal: &'a mut Journal,
    /// Of states under way.
    pub checkpoints: Checkpoints,
}

/// Solves all states of a scene; those in `finished` are taken over.
///
/// # Errors
/// [`RunError`]; a state that cannot be solved is no error, but a row with its reason.
pub fn run(
    document: &Document,
    scene: &Scene,
    finished: Vec<Vec<Row>>,
    safe: Option<Safe<'_>>,
    progress: Progress<'_>,
) -> Result<Outcome, RunError> {
    run_planned(&Plan::new(scene)?, document, scene, finished, safe, progress)
}

/// The same of a scene that has been planned.
///
/// # Errors
/// As [`run`].
pub fn run_planned(
    plan: &Plan,
    document: &Document,
    scene: &Scene,
    finished: Vec<Vec<Row>>,
    mut safe: Option<Safe<'_>>,
    progress: Progress<'_>,
) -> Result<Outcome, RunError> {
    let total = plan.states();
    let solves_a_state = plan.predicted_work().linear_solves / (total as u64).max(1);
    let between = (MOST_SOLVES / solves_a_state.max(1)).clamp(4, MOST_STATES) as usize;
    let mut all: Vec<Vec<Row>> = finished.into_iter().take(total).collect();
    while all.len() < total {
        progress(Stage::States { finished: all.len(), total });
        let chunk = all.len()..total.min(all.len() + between);
        let checkpoints = safe.as_ref().map(|safe| &safe.checkpoints);
        let solve = |state| {
            let desk = Desk::new(state, checkpoints, progress);
            let rows = solve_state(plan, document, scene, &desk, state);
            desk.failure().map_or(Ok(()), Err).or_else(gone).map(|()| rows)
        };
        // One alone needs no threads.
        let solved: Vec<Vec<Row>> = if chunk.len() == 1 {
            vec![solve(chunk.start)?]
        } else {
            chunk.clone().into_par_iter().map(solve).collect::<Result<_, _>>()?
        };
        if let Some(safe) = &mut safe {
            safe.journal.append(&solved).or_else(gone)?;
            chunk.into_iter().try_for_each(|state| safe.checkpoints.remove(state)).or_else(gone)?;
        }
        all.extend(solved);
    }
    progress(Stage::States { finished: total, total });
    let rows: Vec<Row> = all.into_iter().flatten().collect();
    Ok(Outcome {
        title: scene.title.clone(),
        scene_hash: document.hash().to_owned(),
        problem: plan.problem(),
        effects: plan.effects(),
        method: plan.method(),
        groups: plan.groups(),
        validity: plan.validity(&rows),
        swept: scene
            .sweeps
            .iter()
            .map(|sweep| SweptColumn { key: sweep.key.clone(), unit: sweep.unit.clone(), values: sweep.values.len() })
            .collect(),
        columns: plan.columns(),
        headline: plan.headline(),
        figures: plan.figures(scene, &rows),
        rows,
        accuracy: scene.accuracy,
        labels: plan.labels(),
        field_columns: plan.field_columns(),
        draws: plan.draws(),
    })
}

/// A folder that somebody has removed is no reason to stop: the results are there at the end all the same. A full disk is: what is finished is kept.
fn gone(error: std::io::Error) -> std::io::Result<()> {
    use std::io::ErrorKind::{NotADirectory, NotFound};
    if matches!(error.kind(), NotFound | NotADirectory) { Ok(()) } else { Err(error) }
}

/// One state: its swept values put into the scene, read, planned, solved.
fn solve_state(plan: &Plan, document: &Document, scene: &Scene, desk: &Desk<'_>, state: usize) -> Vec<Row> {
    let places = indices(&scene.sweeps, state);
    let swept: Vec<f64> = scene.sweeps.iter().zip(&places).filter_map(|(sweep, &index)| sweep.values.get(index).copied()).collect();
    let solved = || -> Result<Vec<Row>, String> {
        if scene.sweeps.is_empty() {
            return Ok(plan.solve_at(desk, state, &swept));
        }
        let mut varied = document.clone();
        for (sweep, &index) in scene.sweeps.iter().zip(&places) {
            sweep.put(&mut varied, index).map_err(|error| error.to_string())?;
        }
        let varied = read::read_state(&varied).map_err(|error| error.to_string())?;
        Ok(Plan::new(&varied).map_err(|refusal| refusal.to_string())?.solve_at(desk, state, &swept))
    };
    solved().unwrap_or_else(|reason| {
        // The swept value contradicts the rest of the scene: one row that says so.
        let mut row = Row::new(state, &swept, Vec::new(), 0);
        row.status = Status::Invalid;
        row.reason = Some(reason);
        vec![row]
    })
}
