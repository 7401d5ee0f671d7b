//! Special functions: kept crates where one reaches the accuracy that is needed, by hand only what nobody offers.

pub mod cohesive_kernel;
pub mod dawson;
pub mod exponential_mean;
pub mod gauss_legendre;
pub mod log_quadrature;
