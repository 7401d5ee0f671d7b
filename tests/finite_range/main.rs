//! Surfaces that attract at a distance.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod hard_walls;
mod independent;
mod line;
mod sphere;
mod sphere_cycles;
mod sphere_samples;
mod stability;
mod tips;
