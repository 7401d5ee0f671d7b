//! Fits of a scene to measured curves: joins [`viscotack::fit`], which knows numbers only, with scenes and their solvers.
//!
//! ```text
//! [fit] and its data ──► Setup (tests with their jumps and noise, free numbers, checks of the data)
//!                 └──► Fit: viscotack::fit with a closure that puts the numbers into the scene of each test and follows it
//!                        └──► screen, summary, residual plots, a scene with the fitted values
//! ```

mod beside;
mod carry_out;
mod compare;
mod figures;
mod further;
mod inspect;
mod interpolate;
mod models;
mod noise;
mod other_theory;
mod report;
mod scene_file;
mod screen;
mod setup;
mod solved;
mod words;

pub use carry_out::{Fit, carry_out};
pub use further::{Further, further};
pub use models::{Alternative, models};
pub use report::{summary, tables};
pub use scene_file::fitted_scenes;

/// A fit, and what else was asked of it.
#[derive(Debug, Clone)]
pub struct Found {
    /// The fit.
    pub fit: Fit,
    /// The model of the scene and simpler ones, if they were asked for.
    pub models: Vec<Alternative>,
    /// Further tests, if they were asked for.
    pub further: Vec<Further>,
}

pub use screen::screen;
pub use setup::Setup;
