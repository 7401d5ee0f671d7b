//! What an indentation is expected to cost: the one place to tune when the solver changes.

use super::IndentationPlan;
use crate::outcome::Work;

impl IndentationPlan {
    /// Expected work of one state.
    pub(super) fn work_of_a_state(&self) -> Work {
        let fields = self.indentation.fields.as_ref().map_or(0, |fields| u64::from(fields.points) * fields.times.len() as u64);
        Work { closure_evaluations: 1000, kernel_evaluations: 1_000_000, field_evaluations: fields, ..Work::default() }
    }
}
