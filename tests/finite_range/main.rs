//! Surfaces that attract at a distance.
#![allow(missing_docs)]

mod line;
mod sphere;
mod sphere_samples;
mod stability;
