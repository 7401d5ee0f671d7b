//! A steady sliding contact from a problem to numbers with errors.

mod problem;
mod solution;
mod solve;

pub use super::contact::Indenter;
pub use problem::{SlidingControl, SlidingProblem};
pub use solution::{AdhesiveValues, FullContact, PartialContact, PartialValues, SlidingCertificate, SlidingOutcome, SlidingWork};
pub use solve::steady_sliding;
