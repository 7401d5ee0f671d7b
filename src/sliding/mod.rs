//! placeholder until the kernel room is merged
pub mod contact;
pub mod equilibrium;
