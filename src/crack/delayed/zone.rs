//! The process zone over the greatest one of the history.

use super::problem::GrowthProblem;
use serde::{Deserialize, Serialize};

/// A zone shorter than this part of the greatest one counts as this: below it lie places that cannot be distinguished.
const SHORTEST: f64 = 1e-9;

/// z(κ): 1, or (κ/κ_greatest)² where the zone follows the load.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct RelativeZone {
    greatest: Option<f64>,
}

impl RelativeZone {
    /// The zone of a history whose greatest load is `peak`; `limit` is the load that κ is measured in.
    pub(crate) fn new(problem: &GrowthProblem<'_>, peak: f64, limit: f64) -> Self {
        let greatest = peak / limit;
        Self { greatest: (problem.follows_the_load() && greatest > 0.0).then_some(greatest) }
    }

    pub(crate) const fn follows(&self) -> bool {
        self.greatest.is_some()
    }

    pub(crate) fn at(&self, load: f64) -> f64 {
        self.greatest.map_or(1.0, |greatest| (load / greatest).powi(2).clamp(SHORTEST, 1.0))
    }

    /// dz/dt while the load rises by `slope` a second.
    pub(crate) fn rate(&self, load: f64, slope: f64) -> f64 {
        self.greatest.map_or(0.0, |greatest| {
            let ratio = load / greatest;
            if ratio * ratio > SHORTEST { 2.0 * ratio * (slope / greatest) } else { 0.0 }
        })
    }
}
