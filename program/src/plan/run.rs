//! Carrying out a plan: every state of the sweep, in parallel, in order, with a journal.

use super::Plan;
use super::axis_units::{put_on, shown_in};
use super::kept::Kept;
use super::state_watch::{Progress, Stage, StateWatch};
use crate::in_order::{in_order, together};
use crate::outcome::build;
use crate::outcome::checkpoints::Checkpoints;
use crate::outcome::journal::{self, Encoded, Journal, JournalHeader};
use crate::outcome::shard::Shard;
use crate::outcome::shown_units::ShownUnits;
use crate::outcome::tally::Tally;
use crate::outcome::{Outcome, Pictures, Row, Status, SweptColumn};
use crate::scene::document::Document;
use crate::scene::sweep::{indices, states};
use crate::scene::typed::{Picture, Scene};
use crate::scene::written_units::WrittenUnits;
use crate::scene::{SceneError, read};
use std::ops::Range;
use std::path::Path;
use thiserror::Error;
use viscotack::refusal::Refusal;

/// Most states that are under way or wait for an earlier one: a kill loses at most these.
const MOST_STATES: u64 = 128;
/// More of them where they are quick: so many, and so much work (s of one core).
const MOST_QUICK_STATES: u64 = 1024;
const SECONDS_UNDER_WAY: f64 = 0.05;
/// Linear systems of such states, where each takes long.
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

/// What a journal of this scene and build is headed with, for a part of its states.
#[must_use]
pub fn journal_header(document: &Document, scene: &Scene, shard: Shard) -> JournalHeader {
    JournalHeader { program: build::identity().to_owned(), scene: document.hash().to_owned(), states: states(&scene.sweeps), shard }
}

/// Where a run keeps what it must not lose.
#[derive(Debug)]
pub struct Safe<'a> {
    /// Of finished states.
    pub journal: &'a mut Journal,
    /// Of states under way.
    pub checkpoints: Checkpoints,
}

/// Receives the rows of each state, in order, as soon as they are there.
pub type Sink<'a> = &'a mut (dyn FnMut(&[Row]) -> std::io::Result<()> + Send);

/// Solves all states of a scene and keeps every row; those in `finished` are taken over.
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
    run_all(&Plan::new(scene)?, document, scene, Some(finished), safe, None, progress)
}

/// The same of a scene that has been planned. States that the journal holds are taken over, each state goes to the sink, and of a very long sweep
/// the outcome holds only what is drawn and shown: its memory does not grow with the number of states.
///
/// # Errors
/// As [`run`].
pub fn run_planned(
    plan: &Plan,
    document: &Document,
    scene: &Scene,
    safe: Option<Safe<'_>>,
    sink: Option<Sink<'_>>,
    progress: Progress<'_>,
) -> Result<Outcome, RunError> {
    run_all(plan, document, scene, None, safe, sink, progress)
}

fn run_all(
    plan: &Plan,
    document: &Document,
    scene: &Scene,
    finished: Option<Vec<Vec<Row>>>,
    mut safe: Option<Safe<'_>>,
    mut sink: Option<Sink<'_>>,
    progress: Progress<'_>,
) -> Result<Outcome, RunError> {
    let total = plan.states();
    let (columns, layout) = (plan.columns(), plan.layout());
    let tally = Tally::new(scene.accuracy, columns.len());
    let mut kept = Kept::new(&scene.sweeps, layout.as_ref(), tally, plan.rows_of_a_state(), finished.is_some());
    let mut done = 0;
    for rows in finished.into_iter().flatten().take(total) {
        if let Some(sink) = &mut sink {
            sink(&rows)?;
        }
        kept.add(rows);
        done += 1;
    }
    let mut states = States { kept: &mut kept, sink };
    if let Some(safe) = safe.as_ref().filter(|safe| safe.journal.states() > done) {
        states.take_over(safe.journal.path())?;
        done = safe.journal.states();
    }
    solve_states(plan, document, scene, (done..total, Shard::WHOLE), safe.as_mut(), states, progress)?;
    progress(Stage::States { finished: total, total });
    let (mut rows, held, tally) = kept.into_parts();
    let validity = plan.validity(&rows);
    rows.truncate(held);
    let mut figures = if scene.plots.is_empty() { Vec::new() } else { plan.figures(scene, &rows) };
    if rows.len() < tally.rows {
        let states = rows
            .iter()
            .map(|row| row.state)
            .fold((0, None), |(count, last), state| (count + usize::from(last != Some(state)), Some(state)))
            .0;
        figures.iter_mut().for_each(|(_, figure)| figure.add_note(format!("{states} of {total} states are drawn")));
    }
    let units = WrittenUnits::of(&document.root);
    for (_, figure) in &mut figures {
        put_on(&units, figure);
        figure.note_what_is_negative();
    }
    let unsolved = unsolved(plan, document, scene);
    Ok(Outcome {
        figures,
        shown_in: shown_in(&units, &unsolved, &rows),
        validity,
        stored: safe.map(|safe| safe.journal.path().to_owned()),
        rows,
        tally,
        ..unsolved
    })
}

/// Solves a part of the states of a scene into the journal of a shard; no picture is made and no row is kept.
///
/// # Errors
/// As [`run`].
pub fn run_shard(
    plan: &Plan,
    document: &Document,
    scene: &Scene,
    header: &JournalHeader,
    mut safe: Safe<'_>,
    progress: Progress<'_>,
) -> Result<Tally, RunError> {
    let layout = plan.layout();
    let mut kept = Kept::counts(&scene.sweeps, layout.as_ref(), Tally::new(scene.accuracy, plan.columns().len()));
    let mut states = States { kept: &mut kept, sink: None };
    let done = safe.journal.states();
    states.take_over(safe.journal.path())?;
    solve_states(plan, document, scene, (done..header.own_states(), header.shard), Some(&mut safe), states, progress)?;
    Ok(kept.tally)
}

/// What becomes of the rows of states, in their order.
struct States<'k, 's, 'r> {
    kept: &'k mut Kept<'s>,
    sink: Option<Sink<'r>>,
}

/// Some states, by the thread that has solved or read them: it counts their rows, and gives back those that are not kept.
struct Part<'s> {
    kept: Kept<'s>,
    /// For the sink.
    rows: Vec<Vec<Row>>,
}

impl<'s> Part<'s> {
    fn add(&mut self, rows: Vec<Row>, to_sink: bool) {
        if to_sink { self.rows.push(rows) } else { self.kept.add(rows) }
    }
}

impl<'s> States<'_, 's, '_> {
    fn take(&mut self, part: &mut Part<'s>) -> std::io::Result<()> {
        if let Some(sink) = &mut self.sink {
            for rows in part.rows.drain(..) {
                sink(&rows)?;
                self.kept.add(rows);
            }
        }
        self.kept.join(&mut part.kept);
        Ok(())
    }

    /// Takes the states that a journal holds.
    fn take_over(&mut self, journal: &Path) -> std::io::Result<()> {
        let (none, to_sink) = (self.kept.part(), self.sink.is_some());
        let part = |states: Vec<Vec<Row>>| {
            let mut part = Part { kept: none.part(), rows: Vec::new() };
            states.into_iter().for_each(|rows| part.add(rows, to_sink));
            Ok(part)
        };
        journal::each(journal, part, |part| self.take(part))
    }
}

/// Solves a range of the states of a shard: side by side, journalled and taken in order.
fn solve_states<'s>(
    plan: &Plan,
    document: &Document,
    scene: &Scene,
    (range, shard): (Range<usize>, Shard),
    safe: Option<&mut Safe<'_>>,
    mut states: States<'_, 's, '_>,
    progress: Progress<'_>,
) -> std::io::Result<()> {
    let (mut finished, total) = (range.start, range.end);
    progress(Stage::States { finished, total });
    let ahead = states_under_way(plan);
    let alone = document.without_sweep();
    let (mut journal, checkpoints) = match safe {
        Some(safe) => (Some(&mut *safe.journal), Some(&safe.checkpoints)),
        None => (None, None),
    };
    let (is_journalled, to_sink, none) = (journal.is_some(), states.sink.is_some(), states.kept.part());
    let solve = |indices: Range<usize>| -> std::io::Result<Solved<'s>> {
        let (count, mut text) = (indices.len(), Encoded::default());
        let mut part = Part { kept: none.part(), rows: Vec::new() };
        for state in indices.map(|index| shard.state(index)) {
            let state_watch = StateWatch::new(state, checkpoints, progress);
            let rows = solve_state(plan, &alone, scene, &state_watch, state);
            state_watch.failure().map_or(Ok(()), Err).or_else(gone)?;
            // A text of many digits takes as long as some states.
            if is_journalled {
                text.push(&rows)?;
            }
            part.add(rows, to_sink);
        }
        Ok(Solved { count, text, part })
    };
    let mut taken = |solved: &mut [Solved<'s>]| -> std::io::Result<()> {
        if let (Some(journal), Some(checkpoints)) = (&mut journal, checkpoints) {
            journal.append_encoded(solved.iter().flat_map(|part| part.text.states())).or_else(gone)?;
            let ended = finished..finished + solved.iter().map(|part| part.count).sum::<usize>();
            ended.map(|index| shard.state(index)).try_for_each(|state| checkpoints.remove(state)).or_else(gone)?;
        }
        for Solved { count, part, .. } in solved {
            finished += *count;
            states.take(part)?;
        }
        progress(Stage::States { finished, total });
        Ok(())
    };
    // One alone needs no threads.
    if range.len() == 1 {
        return solve(range).and_then(|solved| taken(&mut [solved]));
    }
    let together = together(range.len(), ahead);
    let parts = range.clone().step_by(together).map(|start| Ok(start..range.end.min(start + together)));
    in_order(parts, ahead / together, solve, taken)
}

/// How many states may be under way or wait: a kill loses them.
fn states_under_way(plan: &Plan) -> usize {
    let solves_a_state = plan.predicted_work().linear_solves / (plan.states() as u64).max(1);
    let few = (MOST_SOLVES / solves_a_state.max(1)).clamp(4, MOST_STATES);
    let quick = (SECONDS_UNDER_WAY / plan.predicted_seconds_of_a_state()) as u64;
    few.max(quick.min(MOST_QUICK_STATES)) as usize
}

/// Some states that are solved.
struct Solved<'s> {
    count: usize,
    /// As the journal holds them, if there is one.
    text: Encoded,
    part: Part<'s>,
}

/// An outcome without rows: what a run of the scene will give, before anything is solved.
#[must_use]
pub fn unsolved(plan: &Plan, document: &Document, scene: &Scene) -> Outcome {
    let columns = plan.columns();
    Outcome {
        title: scene.title.clone(),
        scene_hash: document.hash().to_owned(),
        problem: plan.problem(),
        effects: plan.effects(),
        method: plan.method(),
        groups: plan.groups(),
        validity: Vec::new(),
        swept: swept_columns(scene),
        tally: Tally::new(scene.accuracy, columns.len()),
        columns,
        headline: plan.headline(),
        path_headline: plan.path_headline(),
        layout: plan.layout(),
        figures: Vec::new(),
        pictures: Pictures { svg: scene.plots.contains(&Picture::Svg), png: scene.plots.contains(&Picture::Png) },
        stored: None,
        rows: Vec::new(),
        accuracy: scene.accuracy,
        labels: plan.labels(),
        field_columns: plan.field_columns(),
        draws: plan.draws(),
        shown_in: ShownUnits::default(),
    }
}

/// What the swept numbers of a scene are called.
#[must_use]
pub fn swept_columns(scene: &Scene) -> Vec<SweptColumn> {
    let column =
        |sweep: &crate::scene::sweep::Sweep| SweptColumn { key: sweep.key.clone(), unit: sweep.unit.clone(), values: sweep.values.len() };
    scene.sweeps.iter().map(column).collect()
}

/// A folder that somebody has removed is no reason to stop: the results are there at the end all the same. A full disk is: what is finished is kept.
fn gone(error: std::io::Error) -> std::io::Result<()> {
    use std::io::ErrorKind::{NotADirectory, NotFound};
    if matches!(error.kind(), NotFound | NotADirectory) { Ok(()) } else { Err(error) }
}

/// One state: its swept values put into the scene, read, planned, solved.
fn solve_state(plan: &Plan, document: &Document, scene: &Scene, state_watch: &StateWatch<'_>, state: usize) -> Vec<Row> {
    let places = indices(&scene.sweeps, state);
    let swept: Vec<f64> = scene.sweeps.iter().zip(&places).filter_map(|(sweep, &index)| sweep.values.get(index).copied()).collect();
    let solved = || -> Result<Vec<Row>, String> {
        if scene.sweeps.is_empty() {
            return Ok(plan.solve_at(state_watch, state, &swept));
        }
        let varied = read::read_varied(document.clone(), &scene.sweeps, state).map_err(|error| error.to_string())?;
        Ok(Plan::new(&varied).map_err(|refusal| refusal.to_string())?.solve_at(state_watch, state, &swept))
    };
    solved().unwrap_or_else(|reason| {
        // The swept value contradicts the rest of the scene: one row that says so.
        let mut row = Row::new(state, &swept, Vec::new(), 0);
        row.status = Status::Invalid;
        row.reason = Some(reason);
        vec![row]
    })
}
