//! Where one state is solved: what it tells of its way, and where it leaves checkpoints.

use crate::outcome::checkpoints::Checkpoints;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::Mutex;
use std::time::{Duration, Instant};
use viscotack::crack::delayed::{FinishedRuns, GrowthWatch};
use viscotack::indentation::{Checkpoint, Watch};

/// Time between two checkpoints of a state: a kill loses at most so much of it.
const BETWEEN_CHECKPOINTS: Duration = Duration::from_secs(2);
/// Part of the time that checkpoints may take.
const SHARE: u32 = 20;
/// Time between two words about how far it is.
const BETWEEN_WORDS: Duration = Duration::from_millis(100);

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stage {
    /// So many of all states are finished.
    States {
        /// Finished.
        finished: usize,
        /// All.
        total: usize,
    },
    /// A state has been solved for so many of the draws of its material.
    Draws {
        /// Which state, from 0.
        state: usize,
        /// Solved.
        finished: usize,
        /// All.
        total: usize,
    },
    /// A state is under way in its integration `number` (from 1), of which a part (0…1) is done.
    Integration {
        /// Which state, from 0.
        state: usize,
        /// Each integration is tighter than the one before.
        number: u32,
        /// Done of it.
        part: f64,
    },
}

/// Receives how far a run is.
pub type Progress<'a> = &'a (dyn Fn(Stage) + Sync);

/// What a state is solved with.
pub(super) struct StateWatch<'a> {
    state: usize,
    checkpoints: Option<&'a Checkpoints>,
    progress: Progress<'a>,
    clock: Mutex<Clock>,
}

struct Clock {
    next_checkpoint: Instant,
    next_word: Instant,
    failed: Option<std::io::Error>,
}

impl<'a> StateWatch<'a> {
    pub(super) fn new(state: usize, checkpoints: Option<&'a Checkpoints>, progress: Progress<'a>) -> Self {
        let now = Instant::now();
        let clock = Clock { next_checkpoint: now + BETWEEN_CHECKPOINTS, next_word: now + BETWEEN_WORDS, failed: None };
        Self { state, checkpoints, progress, clock: Mutex::new(clock) }
    }

    /// Receives how far the run is.
    pub(super) fn progress(&self) -> Progress<'a> {
        self.progress
    }

    /// Where an earlier, killed run of the same scene was in this state.
    pub(super) fn left_off<T: DeserializeOwned>(&self) -> Option<T> {
        self.checkpoints?.load(self.state)
    }

    /// Whether the next checkpoint is due.
    pub(super) fn is_due(&self) -> bool {
        self.checkpoints.is_some() && self.clock.lock().is_ok_and(|clock| Instant::now() >= clock.next_checkpoint && clock.failed.is_none())
    }

    /// Leaves a checkpoint.
    pub(super) fn leave(&self, checkpoint: &impl Serialize) {
        let Some(checkpoints) = self.checkpoints else { return };
        let begun = Instant::now();
        let saved = checkpoints.save(self.state, checkpoint);
        let Ok(mut clock) = self.clock.lock() else { return };
        let now = Instant::now();
        clock.next_checkpoint = now + BETWEEN_CHECKPOINTS.max((now - begun) * SHARE);
        clock.failed = saved.err();
    }

    /// Why a checkpoint could not be written.
    pub(super) fn failure(self) -> Option<std::io::Error> {
        self.clock.into_inner().ok()?.failed
    }
}

impl GrowthWatch for StateWatch<'_> {
    fn is_due(&self) -> bool {
        self.is_due()
    }

    fn keep(&self, finished: &FinishedRuns) {
        self.leave(finished);
    }
}

impl Watch for StateWatch<'_> {
    fn passed(&self, number: u32, part: f64) {
        let Ok(mut clock) = self.clock.lock() else { return };
        let now = Instant::now();
        if now >= clock.next_word {
            clock.next_word = now + BETWEEN_WORDS;
            (self.progress)(Stage::Integration { state: self.state, number, part });
        }
    }

    fn wants_checkpoint(&self) -> bool {
        self.is_due()
    }

    fn checkpoint(&self, checkpoint: &Checkpoint) {
        self.leave(checkpoint);
    }
}
