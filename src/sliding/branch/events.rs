//! Pull-off, snap-in and separation among the turns of a branch of loads.
//!
//! The branch goes from narrow to wide: through the fold of Δ and the smallest mean pressure to the largest one. Beyond it sliding contacts may turn back
//! under strong pulls, with turns of load and penetration that no stable contact is next to; those are not meant.

use super::conditions::BranchProblem;
use super::end::BranchEnd;
use super::fold::{Fold, FoldQuantity, Turn};
use super::trace::Branch;

impl Branch {
    /// Snap-in, p_IN: the first largest mean pressure from the narrow side; none if adhesion leaves no stable contact under a held load, or if it is beyond
    /// the half-widths asked for.
    #[must_use]
    pub fn snap_in(&self) -> Option<&Fold> {
        self.folds_of(FoldQuantity::MeanPressure).find(|fold| fold.turn == Turn::Maximum)
    }

    /// Pull-off, p_out: the last smallest mean pressure before snap-in, or before the widest half-width asked for.
    #[must_use]
    pub fn pull_off(&self, problem: &BranchProblem) -> Option<&Fold> {
        let end = match self.snap_in() {
            Some(snap_in) => snap_in.arclength,
            None if matches!(self.ends, BranchEnd::HalfWidth(width) if width > problem.half_widths[0]) => f64::INFINITY,
            None => return None,
        };
        self.folds_of(FoldQuantity::MeanPressure).filter(|fold| fold.turn == Turn::Minimum && fold.arclength < end).last()
    }

    /// Separation under a held penetration, Δ_out: the first smallest penetration from the narrow side.
    #[must_use]
    pub fn separation(&self) -> Option<&Fold> {
        self.folds_of(FoldQuantity::Penetration).find(|fold| fold.turn == Turn::Minimum)
    }
}
