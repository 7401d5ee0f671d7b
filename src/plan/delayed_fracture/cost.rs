//! What a history is expected to cost.

use super::DelayedFracturePlan;
use crate::crack::delayed::trajectory::tends_to;
use crate::crack::delayed::{GrowthProblem, Onset, onset};
use crate::outcome::Work;
use std::collections::HashMap;

impl DelayedFracturePlan {
    /// What finding the delay took.
    pub(super) fn onset_work(&self, evaluations: u64) -> Work {
        Work {
            closure_evaluations: evaluations,
            kernel_evaluations: evaluations * self.plane_material.creep_terms().len() as u64,
            ..Work::default()
        }
    }

    /// What one state is expected to take.
    pub(super) fn work_of_a_state(&self) -> Work {
        Work::default()
    }

    fn _silence(&self, _: &GrowthProblem<'_>) {
        let _: HashMap<u8, Onset>;
        let _ = (onset, tends_to);
    }
}
