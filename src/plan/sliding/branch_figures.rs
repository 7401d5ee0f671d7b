//! The plots of branches and of strengths.

use super::SlidingPlan;
use crate::outcome::Row;
use crate::outcome::plot::Figure;
use crate::scene::typed::{Scene, SlidingBranch};

impl SlidingPlan {
    pub(super) fn branch_drawings(&self, _branch: &SlidingBranch, _scene: &Scene, _rows: &[Row]) -> Vec<(String, Figure)> {
        Vec::new()
    }

    pub(super) fn strength_drawings(&self, _scene: &Scene, _rows: &[Row]) -> Vec<(String, Figure)> {
        Vec::new()
    }
}
