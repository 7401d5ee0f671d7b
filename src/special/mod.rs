//! Special functions: kept crates where one reaches the accuracy that is needed, by hand only what nobody offers.

pub mod angle;
pub mod clausen;
pub mod cohesive_kernel;
pub mod dawson;
pub mod dilogarithm_circle;
pub mod even_zeta;
pub mod exponential_integral;
pub mod exponential_mean;
pub mod gauss_legendre;
pub mod harmonic_imaginary;
pub mod log_quadrature;
pub mod log_sine;
pub mod memory_clausen;
pub mod normal;
pub mod split_mix;
