//! What a killed run goes on from: every number of the integration under way, bit for bit, and the integrations before it.
//!
//! An integration is a chain of steps; a checkpoint is taken between two of them and holds all that the next one reads. What an integration remembers only to
//! be quick (the panels of the last trial, the kernel of the last edge) is left out, and forgotten before each step, so that an integration with
//! checkpoints and one without take the same steps to the last bit.

use super::by_panels::PanelsState;
use super::current_segment::{Place, part, weight};
use super::cycle_integrals::CycleIntegrals;
use super::history::Controlled;
use super::integrator::Integrator;
use super::line::{Cell, Contact};
use super::panel::POINTS;
use super::path_history::PathHistory;
use super::record::{Record, RecordState};
use super::rim::Rim;
use super::solution::{IndentationWork, Trace};
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};

/// Receives how far a run is, and what it can go on from.
pub trait Watch: Sync {
    /// Integration `number` (from 1; each is tighter than the one before) has done a part (0…1) of its history.
    fn passed(&self, number: u32, part: f64);
    /// Whether a checkpoint is wanted now; asked between any two steps.
    fn wants_checkpoint(&self) -> bool;
    /// The checkpoint that was wanted.
    fn checkpoint(&self, checkpoint: &Checkpoint);
}

/// A run between two steps, or two panels, of the same material and problem only.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Checkpoint {
    pub(super) run: RunState,
}

/// By which method it was under way.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) enum RunState {
    Steps(Box<StepsState>),
    Panels(Box<PanelsState>),
}

/// A run by time steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct StepsState {
    /// Integrations that are finished, and the tolerance of the one under way.
    pub(super) finished: u32,
    pub(super) tolerance: f64,
    /// The last finished ones, the finest first.
    pub(super) integrations: Vec<Trace>,
    pub(super) work: IndentationWork,
    pub(super) integration: IntegrationState,
}

/// An integration between two steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct IntegrationState {
    contact: ContactState,
    edge: (Option<u32>, u64, u64),
    path_history: PathHistory,
    origin: f64,
    time: f64,
    reach: f64,
    dt: f64,
    corner: f64,
    first: f64,
    pace: Option<(Controlled, f64)>,
    kink_places: Vec<(f64, u32)>,
    turns: Vec<f64>,
    slopes: (f64, f64),
    smooth_in_time: bool,
    cycle_integrals: Option<CycleIntegrals>,
    record: RecordState,
    pub(super) place: Place,
}

/// The line of a contact.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct ContactState {
    cells: Vec<Cell>,
    values: Vec<f64>,
    radius: f64,
    penetration: f64,
    way: f64,
    rim: Option<Rim>,
    updates: u64,
}

impl ContactState {
    pub(super) fn of(contact: &Contact<'_>) -> Self {
        let Contact { springs: _, profile: _, cells, values, radius, penetration, way, rim, updates } = contact;
        Self {
            cells: cells.clone(),
            values: values.clone(),
            radius: *radius,
            penetration: *penetration,
            way: *way,
            rim: rim.clone(),
            updates: *updates,
        }
    }

    /// The contact of the same springs and profile as `like`.
    pub(super) fn restored<'a>(self, like: &Contact<'a>) -> Result<Contact<'a>, Refusal> {
        if self.values.len() != self.cells.len() * POINTS * like.springs.terms() {
            return Err(foreign("its line has another number of terms"));
        }
        if self.rim.as_ref().map(Rim::terms) != like.rim.as_ref().map(Rim::terms) {
            return Err(foreign("its indenter has another rim"));
        }
        let Self { cells, values, radius, penetration, way, rim, updates } = self;
        Ok(Contact { springs: like.springs, profile: like.profile.clone(), cells, values, radius, penetration, way, rim, updates })
    }
}

/// The refusal of a checkpoint that belongs to something else.
pub(super) fn foreign(why: &str) -> Refusal {
    Refusal::Undefined { quantity: "the rest of the run", reason: format!("the checkpoint is of another problem: {why}") }
}

impl Integrator<'_> {
    /// All that the next step reads.
    fn state(&self) -> IntegrationState {
        // Every field is named: a new one must be given a place, or a reason.
        let Self {
            springs: _,
            problem: _,
            tolerance: _,
            observer: _,
            // Made anew from the problem.
            length: _,
            opening: _,
            contact,
            edge,
            path_history,
            origin,
            time,
            reach,
            dt,
            corner,
            first,
            pace,
            kink_places,
            turns,
            slopes,
            smooth_in_time,
            cycle_integrals,
            record,
            place,
        } = self;
        IntegrationState {
            contact: ContactState::of(contact),
            edge: (edge.held, edge.evaluations, edge.updates),
            path_history: path_history.clone(),
            origin: *origin,
            time: *time,
            reach: *reach,
            dt: *dt,
            corner: *corner,
            first: *first,
            pace: *pace,
            kink_places: kink_places.clone(),
            turns: turns.clone(),
            slopes: *slopes,
            smooth_in_time: *smooth_in_time,
            cycle_integrals: cycle_integrals.clone(),
            record: record.state(),
            place: *place,
        }
    }

    /// An integration as new, put where a checkpoint was taken.
    pub(super) fn restore(&mut self, state: IntegrationState) -> Result<(), Refusal> {
        let IntegrationState {
            contact,
            edge,
            path_history,
            origin,
            time,
            reach,
            dt,
            corner,
            first,
            pace,
            kink_places,
            turns,
            slopes,
            smooth_in_time,
            cycle_integrals,
            record,
            place,
        } = state;
        if place.segment >= self.problem.history.segments.len() {
            return Err(foreign("its history has fewer segments"));
        }
        self.record = Record::restored(record, &self.contact)?;
        self.contact = contact.restored(&self.contact)?;
        let (held, evaluations, updates) = edge;
        self.edge.restore(held, evaluations, updates);
        (self.path_history, self.pace, self.kink_places, self.turns, self.slopes, self.cycle_integrals) =
            (path_history, pace, kink_places, turns, slopes, cycle_integrals);
        (self.origin, self.time, self.reach, self.dt, self.corner, self.first) = (origin, time, reach, dt, corner, first);
        (self.place, self.smooth_in_time) = (place, smooth_in_time);
        Ok(())
    }

    /// Between two steps: tells how far the integration is, and leaves a checkpoint where one is wanted.
    pub(super) fn observe(&self) {
        let Some(observer) = &self.observer else { return };
        let segments = &self.problem.history.segments;
        let all: f64 = segments.iter().map(weight).sum();
        let before: f64 = segments.iter().take(self.place.segment).map(weight).sum();
        let under_way = segments.get(self.place.segment).map_or(0.0, |segment| weight(segment) * part(segment, self.time));
        observer.watch.passed(observer.finished + 1, (before + under_way) / all);
        if observer.watch.wants_checkpoint() {
            let state = StepsState {
                finished: observer.finished,
                tolerance: self.tolerance,
                integrations: observer.integrations.to_vec(),
                work: observer.work,
                integration: self.state(),
            };
            observer.watch.checkpoint(&Checkpoint { run: RunState::Steps(Box::new(state)) });
        }
    }
}

/// Who watches an integration, and what the run knows besides it.
pub(super) struct Observer<'a> {
    pub(super) watch: &'a dyn Watch,
    pub(super) finished: u32,
    pub(super) integrations: &'a [Trace],
    pub(super) work: IndentationWork,
}
