//! What a killed run by panels goes on from: every number of the path under way, bit for bit, and the paths before it.
//!
//! A checkpoint is taken between two panels. What a path remembers only to be quick (nodes of the last window, the kernel of the last edge) is left out: it is made
//! anew before it is read.

use super::at_once::AtOnce;
use super::cycles::Cycles;
use super::drive::{Branch, DriveSegment};
use super::events::Mark;
use super::followed::State;
use super::integration::Integration;
use super::line::{Line, Segment};
use super::path::Chart;
use super::problem::{End, Outcome};
use crate::indentation::checkpoint::{Checkpoint, RunState, foreign};
use crate::indentation::record::{Record, RecordState};
use crate::indentation::{EventKind, IndentationWork, Trace, Watch};
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};

/// A run between two panels.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::indentation) struct PanelsState {
    pub(super) run: PathsState,
    pub(super) integration: IntegrationState,
}

/// What a run has besides the path under way.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct PathsState {
    /// Paths that are finished.
    pub(super) finished: u32,
    /// Tolerance of the path that is to be given, those of its round that are finished, and how they ended.
    pub(super) tolerance: f64,
    pub(super) traces: Vec<Trace>,
    pub(super) ends: Vec<(Vec<EventKind>, End)>,
    /// Paths of the last round that can be compared.
    pub(super) best: Option<Vec<Trace>>,
    /// Segments that end early.
    pub(super) stops: Vec<(usize, f64)>,
    pub(super) work: IndentationWork,
}

/// A path between two panels.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct IntegrationState {
    line: Line,
    upcoming: usize,
    branch: Branch,
    at_once: Option<AtOnce>,
    marks: Vec<Mark>,
    previous: Option<(bool, Segment, f64)>,
    span: (Chart, f64),
    /// To the turn, since the turn, residual and rate at the start, stiffness, residual of the last panel.
    numbers: [f64; 6],
    slows: bool,
    /// Refusals, flips, pieces.
    counts: [u32; 3],
    state: Option<State>,
    instants: Vec<f64>,
    met: usize,
    cycles: Option<Cycles>,
    rows: RecordState,
    /// Before the segment or cycle under way: panels; closures and their nodes.
    work: [u64; 3],
    outcome: Outcome,
}

/// Who watches a path, and what the run knows besides it.
#[derive(Clone, Copy)]
pub(super) struct PanelObserver<'a> {
    pub(super) watch: &'a dyn Watch,
    pub(super) run: &'a PathsState,
}

impl Integration<'_> {
    fn checkpoint(&self) -> IntegrationState {
        // Every field is named: a new one must be given a place, or a reason.
        let Self {
            problem: _,
            observer: _,
            // Made anew from the problem.
            points: _,
            window,
            line,
            upcoming,
            branch,
            at_once,
            marks,
            previous,
            span,
            to_turn,
            since_turn,
            slows,
            start_residual,
            start_rate,
            stiffness,
            refusals,
            flips,
            state,
            piece,
            panel_residual,
            instants,
            met,
            cycles,
            rows,
            budget_from,
            outcome,
        } = self;
        IntegrationState {
            line: line.clone(),
            upcoming: *upcoming,
            branch: branch.clone(),
            at_once: *at_once,
            marks: marks.clone(),
            previous: previous.clone(),
            span: *span,
            numbers: [*to_turn, *since_turn, *start_residual, *start_rate, *stiffness, *panel_residual],
            slows: *slows,
            counts: [*refusals, *flips, *piece],
            state: state.clone(),
            instants: instants.clone(),
            met: *met,
            cycles: cycles.clone(),
            rows: rows.state(),
            work: [*budget_from, window.closures, window.kernel_nodes],
            outcome: outcome.clone(),
        }
    }

    /// A path as new, put where a checkpoint was taken.
    pub(super) fn restore(&mut self, state: IntegrationState) -> Result<(), Refusal> {
        let n = self.problem.chain.terms();
        let segments = state.line.inside.iter().chain(&state.line.outside).chain(state.previous.iter().map(|previous| &previous.1));
        if state.branch.memory.len() != n || segments.into_iter().any(|segment| !segment.states.len().is_multiple_of(n + 1)) {
            return Err(foreign("its line has another number of terms"));
        }
        if state.upcoming > self.problem.drive.segments.len() {
            return Err(foreign("its history has fewer segments"));
        }
        if state.instants.len() != self.instants.len() {
            return Err(foreign("it has other instants"));
        }
        if state.line.inside.is_empty() || state.line.outside.is_empty() {
            return Err(foreign("its line is empty"));
        }
        let IntegrationState {
            line,
            upcoming,
            branch,
            at_once,
            marks,
            previous,
            span,
            numbers,
            slows,
            counts,
            instants,
            met,
            cycles,
            rows,
            work,
            outcome,
            ..
        } = state;
        (self.line, self.upcoming, self.branch, self.at_once, self.marks) = (line, upcoming, branch, at_once, marks);
        (self.previous, self.span, self.slows, self.state) = (previous, span, slows, state.state);
        [self.to_turn, self.since_turn, self.start_residual, self.start_rate, self.stiffness, self.panel_residual] = numbers;
        [self.refusals, self.flips, self.piece] = counts;
        (self.instants, self.met, self.cycles, self.outcome) = (instants, met, cycles, outcome);
        self.rows = Record::restored_without_contact(rows);
        [self.budget_from, self.window.closures, self.window.kernel_nodes] = work;
        Ok(())
    }

    /// Between two panels: tells how far the path is, and leaves a checkpoint where one is wanted.
    pub(super) fn observe(&self) {
        let Some(PanelObserver { watch, run }) = self.observer else { return };
        watch.passed(run.finished + 1, self.progress());
        if watch.wants_checkpoint() {
            let state = PanelsState { run: run.clone(), integration: self.checkpoint() };
            watch.checkpoint(&Checkpoint { run: RunState::Panels(Box::new(state)) });
        }
    }

    /// Part (0…1) of the history that is done; a cycle counts as much as a ramp.
    fn progress(&self) -> f64 {
        let weight = |drive_segment: &DriveSegment| {
            1.0 + drive_segment.oscillation.map_or(0.0, |o| o.cycles_at(drive_segment.duration, drive_segment.duration))
        };
        let segments = &self.problem.drive.segments;
        let all: f64 = segments.iter().map(weight).sum();
        let gone: f64 = segments.iter().take(self.upcoming).map(weight).sum();
        let under_way = self.upcoming.checked_sub(1).and_then(|last| segments.get(last));
        // A segment in which the surfaces have touched again has a later start.
        let duration = if self.at_once.is_some() { self.branch.end } else { under_way.map_or(0.0, |drive_segment| drive_segment.duration) };
        let left = (self.branch.end - self.line.time) / duration;
        let left = if left.is_finite() { left.clamp(0.0, 1.0) } else { 0.0 };
        let part = (gone - under_way.map_or(0.0, weight) * left) / all;
        if part.is_finite() { part.clamp(0.0, 1.0) } else { 1.0 }
    }
}
