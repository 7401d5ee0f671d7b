//! Closed forms of elastic contact and fracture, one a file: the limits that every viscoelastic result must reach.

pub mod plane_modulus;

pub use plane_modulus::PlaneState;
