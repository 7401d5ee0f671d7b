//! A steady sliding contact from a problem to numbers with errors.

mod accuracy;
mod elastic_start;
mod elsewhere;
mod faint;
mod path;
mod prepared;
mod problem;
mod solution;
mod solve;
mod uneven_start;

pub use super::contact::Indenter;
pub use super::edge_balance::{SlidingControl, WaveAdhesion};
pub use path::Start;
pub(super) use path::{From, end_bears, start_at_rate};
pub(super) use prepared::Prepared;
pub use problem::SlidingProblem;
pub(super) use problem::adhesion_at;
pub use solution::{AdhesiveValues, FullContact, PartialContact, PartialValues, SlidingCertificate, SlidingOutcome, SlidingWork};
pub use solve::{full_contact_friction, steady_sliding, steady_sliding_near};
pub(super) use solve::{near_counted, steady_by_paths};
