//! Where a branch ends, and the evidence for it.

use super::conditions::{BranchPath, BranchProblem};
use super::trace::Coarse;
use crate::refusal::Refusal;
use crate::sliding::edge_balance::{EdgeBalance, EdgeStates};

/// How an end of a branch came about.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// The narrowest or widest half-width asked for was passed.
    HalfWidth(f64),
    /// The smallest or largest parameter asked for was passed (rate kv in 1/s, Γ, factor of the zones).
    Parameter(f64),
    /// The curve of both edge conditions goes on, but its contacts cannot exist: half-width and parameter (mean pressure along loads) of the last that can, and
    /// what has changed its sign within the next hundred-thousandth of arclength.
    Impossible {
        /// a.
        half_width: f64,
        /// The third unknown: p̄, or rate, Γ, factor.
        parameter: f64,
        /// What forbids the next contact.
        witness: Impossible,
    },
    /// The equations were not solved any more: a defect of the numbers, not of the contact. Half-width and parameter of the last contact, and the refusal of the next.
    Lost {
        /// a.
        half_width: f64,
        /// The third unknown: p̄, or rate, Γ, factor.
        parameter: f64,
        /// Why.
        reason: Refusal,
    },
    /// The branch is a closed curve, and ends where it begins.
    Closed,
    /// The branch has more points than are followed, 3000 to each side.
    TooLong,
}

/// Why a contact cannot exist though both edge conditions hold, with the number that changed its sign: in the last contact that can, and in the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Impossible {
    /// The trailing edge, in the contact or with an edge moved, is pressed instead of pulled: the largest of its amplitudes.
    TrailingPressed([f64; 2]),
    /// The leading edge is.
    LeadingPressed([f64; 2]),
    /// The faces meet in the gap (a second contact begins there): the smallest gap over the largest.
    FacesMeet([f64; 2]),
}

impl Impossible {
    /// In words.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::TrailingPressed(_) => "beyond it the trailing edge is pressed",
            Self::LeadingPressed(_) => "beyond it the leading edge is pressed",
            Self::FacesMeet(_) => "beyond it the faces meet inside the gap",
        }
    }
}

/// What has changed its sign between a contact that can exist and one that cannot; none if nothing has.
pub(super) fn impossible(balance: &EdgeBalance, last: &EdgeStates, next: &EdgeStates) -> Option<Impossible> {
    let largest = |states: &EdgeStates| {
        let moved = states.moved.iter().flat_map(|(trailing, leading)| [trailing, leading]);
        moved
            .chain([&states.state])
            .map(|contact| contact.edge_amplitudes())
            .fold((f64::NEG_INFINITY, f64::NEG_INFINITY), |(trailing, leading), amplitudes| {
                (trailing.max(amplitudes.0), leading.max(amplitudes.1))
            })
    };
    let (before, after) = (largest(last), largest(next));
    if before.0 < 0.0 && after.0 >= 0.0 {
        return Some(Impossible::TrailingPressed([before.0, after.0]));
    }
    if before.1 < 0.0 && after.1 >= 0.0 {
        return Some(Impossible::LeadingPressed([before.1, after.1]));
    }
    let gaps = [balance.admissibility(last).ok()?.smallest_gap, balance.admissibility(next).ok()?.smallest_gap];
    (gaps[0] > 0.0 && gaps[1] <= 0.0).then_some(Impossible::FacesMeet(gaps))
}

/// The border of the region asked for that a point has passed.
pub(super) fn border(problem: &BranchProblem, point: &Coarse) -> Option<BranchEnd> {
    let half_width = point.state.state.contact().half_width;
    let [narrowest, widest] = problem.half_widths;
    if half_width < narrowest {
        return Some(BranchEnd::HalfWidth(narrowest));
    }
    if half_width > widest {
        return Some(BranchEnd::HalfWidth(widest));
    }
    if problem.path != BranchPath::Loads {
        let [smallest, largest] = problem.parameters;
        let parameter = point.unknowns[2].exp();
        if parameter < smallest * (1.0 - 1e-9) {
            return Some(BranchEnd::Parameter(smallest));
        }
        if parameter > largest * (1.0 + 1e-9) {
            return Some(BranchEnd::Parameter(largest));
        }
    }
    None
}
