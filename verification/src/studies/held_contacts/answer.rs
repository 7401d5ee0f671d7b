//! The solver's answer, as far as it is compared: the one file that knows its library interface.

use super::states::Reached;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::Stability;
use viscotack::sliding::contact::Indenter;
use viscotack::sliding::steady::{PartialValues, ReachedBy, SlidingOutcome, SlidingProblem, steady_sliding_reached_by};

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
pub fn answer(material: &PlaneMaterial, problem: &SlidingProblem<'_>, reached: Reached) -> Answer {
    let by = if reached == Reached::Loading { ReachedBy::Loading } else { ReachedBy::Unloading };
    match steady_sliding_reached_by(material, problem, by) {
        Ok(SlidingOutcome::Partial(found)) => {
            let reported = |stability: Stability| match stability {
                Stability::Stable => Some(true),
                Stability::Unstable => Some(false),
                Stability::Marginal => None,
            };
            let wave = problem.indenter == Indenter::Wave;
            let stable = found.stability.filter(|_| problem.adhesion.is_some()).map_or([None; 3], |stability| {
                let of_wave = |stability: Stability| if wave { reported(stability) } else { None };
                [reported(stability.under_load()), of_wave(stability.under_penetration()), of_wave(stability.in_frame(FRAME))]
            });
            Answer::Contact { values: Box::new(found.values), stable, others: Some(found.others) }
        }
        Ok(SlidingOutcome::Full(full)) => Answer::Full(full.limit),
        Err(Refusal::NoSuchState { limit, .. }) => Answer::Nothing(limit),
        Err(refusal) => Answer::Failed(refusal.to_string()),
    }
}
