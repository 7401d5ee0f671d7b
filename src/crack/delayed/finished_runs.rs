//! What a killed history of growth goes on from: the runs that are finished, every number bit for bit. Each run takes about as long as all before it.

use super::stepper::Run;
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// Finished runs of one problem, history and list of output times, by their lines per process zone.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct FinishedRuns {
    runs: Vec<(u32, Run)>,
}

impl FinishedRuns {
    /// How many are finished.
    #[must_use]
    pub fn count(&self) -> usize {
        self.runs.len()
    }
}

/// Runs a problem where it has not been run before, and hands over all that is finished after each new run.
pub(super) struct Keeper<'a> {
    finished: RefCell<FinishedRuns>,
    keep: &'a dyn Fn(&FinishedRuns),
}

impl<'a> Keeper<'a> {
    pub(super) fn new(from: Option<FinishedRuns>, keep: &'a dyn Fn(&FinishedRuns)) -> Self {
        Self { finished: RefCell::new(from.unwrap_or_default()), keep }
    }

    /// The run of so many lines: the finished one, or what `compute` gives.
    pub(super) fn run(&self, lines: u32, compute: impl FnOnce() -> Result<Run, Refusal>) -> Result<Run, Refusal> {
        let known = self.finished.borrow().runs.iter().find(|(of, _)| *of == lines).map(|(_, run)| run.clone());
        if let Some(run) = known {
            return Ok(run);
        }
        let run = compute()?;
        let mut finished = self.finished.borrow_mut();
        finished.runs.push((lines, run.clone()));
        (self.keep)(&finished);
        Ok(run)
    }
}
