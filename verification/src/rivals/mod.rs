//! The ways others would compute the same: cited, never chosen by a plan, used by tests, studies and benchmarks only.

pub mod annulus_indentation;
mod dense;
pub mod growth_stepping;
pub mod raw_crack_work;
pub mod sliding_collocation;
