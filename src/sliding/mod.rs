//! placeholder until the kernel room is merged
pub mod adhesiveless;
pub mod contact;
mod edge_newton;
pub mod equilibrium;
pub mod speed_path;
