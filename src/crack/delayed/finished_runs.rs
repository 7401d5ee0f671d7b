//! What a killed history of growth goes on from: the runs that are finished and the one under way, every number bit for bit.

use super::stepper::{Run, Stepper};
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// Finished runs of one problem, history and list of output times, by their lines per process zone, and a run under way.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct FinishedRuns {
    runs: Vec<(u32, Run)>,
    under_way: Option<Stepper>,
}

impl FinishedRuns {
    /// How many are finished.
    #[must_use]
    pub fn count(&self) -> usize {
        self.runs.len()
    }

    /// Steps that the run under way has taken; 0 if none is.
    #[must_use]
    pub fn steps_under_way(&self) -> u64 {
        self.under_way.as_ref().map_or(0, Stepper::steps)
    }
}

/// Who keeps what a killed history goes on from.
pub trait GrowthWatch {
    /// Whether it is time to keep something; asked between steps.
    fn is_due(&self) -> bool;
    /// What there is.
    fn keep(&self, finished: &FinishedRuns);
}

/// Keeps nothing.
#[derive(Debug, Clone, Copy)]
pub struct Unwatched;

impl GrowthWatch for Unwatched {
    fn is_due(&self) -> bool {
        false
    }

    fn keep(&self, _: &FinishedRuns) {}
}

/// Runs a problem where it has not been run before, from where a run was left off, and hands over what there is whenever that is due.
pub(super) struct Keeper<'a> {
    finished: RefCell<FinishedRuns>,
    watch: &'a dyn GrowthWatch,
}

impl<'a> Keeper<'a> {
    pub(super) fn new(from: Option<FinishedRuns>, watch: &'a dyn GrowthWatch) -> Self {
        Self { finished: RefCell::new(from.unwrap_or_default()), watch }
    }

    /// The run of so many lines: the finished one, or what `compute` gives from where it was left off.
    pub(super) fn run(&self, lines: u32, compute: impl FnOnce(Option<Stepper>, &Self) -> Result<Run, Refusal>) -> Result<Run, Refusal> {
        let known = self.finished.borrow().runs.iter().find(|(of, _)| *of == lines).map(|(_, run)| run.clone());
        if let Some(run) = known {
            return Ok(run);
        }
        let left_off = self.finished.borrow_mut().under_way.take().filter(|stepper| stepper.lines_per_zone() == lines);
        let run = compute(left_off, self)?;
        self.finished.borrow_mut().runs.push((lines, run.clone()));
        if self.watch.is_due() {
            self.watch.keep(&self.finished.borrow());
        }
        Ok(run)
    }

    /// Between two steps of a run.
    pub(super) fn look(&self, stepper: &Stepper) {
        if self.watch.is_due() {
            self.finished.borrow_mut().under_way = Some(stepper.clone());
            self.watch.keep(&self.finished.borrow());
            self.finished.borrow_mut().under_way = None;
        }
    }
}
