//! A steady sliding contact from a problem to numbers with errors.

mod accuracy;
mod full;
mod limits;
mod negligible;
mod nothing;
mod prepared;
mod problem;
mod solution;
mod solve;
mod start;

pub use super::contact::Indenter;
pub use super::edge_balance::{SlidingControl, WaveAdhesion};
pub use full::full_contact_friction;
pub(super) use prepared::Prepared;
pub use problem::SlidingProblem;
pub(super) use problem::adhesion_at;
pub use solution::{
    AdhesiveValues, ContactStability, FullContact, PartialContact, PartialValues, SlidingCertificate, SlidingOutcome, SlidingWork,
};
pub use solve::{ReachedBy, steady_sliding, steady_sliding_near, steady_sliding_reached_by};
pub(super) use solve::{contact_on_the_curve, near_counted};
pub use start::Start;
