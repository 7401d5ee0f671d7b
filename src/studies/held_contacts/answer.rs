//! The solver's answer, as far as it is compared: the one file that knows its library interface.

use super::states::Reached;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::steady::{PartialValues, SlidingOutcome, SlidingProblem, steady_sliding};

/// Stiffness of the frame in which stability is compared (p̄ per Δ).
pub const FRAME: f64 = 0.7;

/// What the solver says.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// A contact with two edges.
    Contact {
        /// Its numbers.
        values: Box<PartialValues>,
        /// Whether it is stable under a held load, at a held penetration and in a frame of stiffness [`FRAME`], where the solver says so.
        stable: [Option<bool>; 3],
        /// How many other stable contacts there are, where the solver says so.
        others: Option<usize>,
    },
    /// Full contact beyond a limit.
    Full(f64),
    /// No such state, beyond a limit.
    Nothing(f64),
    /// Anything else: never right for a problem of this study.
    Failed(String),
}

/// Asks the solver.
#[must_use]
pub fn answer(material: &Material, problem: &SlidingProblem<'_>, _reached: Reached) -> Answer {
    match steady_sliding(material, problem) {
        Ok(SlidingOutcome::Partial(found)) => Answer::Contact { values: Box::new(found.values), stable: [None; 3], others: None },
        Ok(SlidingOutcome::Full(full)) => Answer::Full(full.limit),
        Err(Refusal::NoSuchState { limit, .. }) => Answer::Nothing(limit),
        Err(refusal) => Answer::Failed(refusal.to_string()),
    }
}
