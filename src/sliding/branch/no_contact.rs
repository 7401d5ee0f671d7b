//! Speeds at which a load has no steady partial contact.
//!
//! The slow contact of a load is followed to growing speeds, the fast one to falling ones. Where the slow one turns back at a speed below that at which the fast one
//! does, and each returns to the end it came from, every elastic contact of the load at either end belongs to one of the two curves: between
//! the folds none of them is left. A closed curve that reaches neither end would be another matter: a scan of every contact at rates between the folds looks for it.

use super::conditions::{BranchProblem, BranchStart};
use super::end::BranchEnd;
use super::every::ContactAt;
use super::fold::{Fold, FoldQuantity, Turn};
use super::scan::contacts_of;
use super::trace::{Branch, trace};
use crate::material::Material;
use crate::refusal::Refusal;

/// Rates and half-widths that are looked at between two folds.
const RATES: usize = 4;
/// See [`RATES`].
const HALF_WIDTHS: usize = 48;

/// No steady partial contact exists at rates between two folds.
#[derive(Debug, Clone)]
pub struct NoContactBetween {
    /// The fold at which the slow contact turns back: the largest rate of its branch.
    pub lower: Fold,
    /// The fold at which the fast contact turns back: the smallest rate of its branch.
    pub upper: Fold,
    /// Whether both branches were followed back to the end they came from, or until the contact left the half-widths asked for.
    pub closed: bool,
    /// How many rates between the folds, and how many half-widths at each, were looked at; none of them has a steady partial contact.
    pub scanned: (usize, usize),
}

/// The contacts of a held load, penetration or half-width over a range of speeds.
#[derive(Debug, Clone)]
pub struct SpeedFolds {
    /// The branch of the slow contact; or why there is none.
    pub slow: Result<Branch, Refusal>,
    /// The branch of the fast contact, unless it is the same; or why there is none.
    pub fast: Option<Result<Branch, Refusal>>,
    /// The gap between them, if there is one.
    pub no_contact: Option<NoContactBetween>,
    /// Contacts at rates (kv in 1/s) between the folds, which belong to neither branch: then there is no gap, but a branch of its own ([`super::every_branch`]).
    pub others: Vec<(f64, ContactAt)>,
}

/// Follows the slow and the fast contact of a branch along speeds toward each other.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem.
pub fn speed_folds(material: &Material, problem: &BranchProblem) -> Result<SpeedFolds, Refusal> {
    problem.checked()?;
    let from = |start| trace(material, &BranchProblem { start, ..*problem });
    let slow = from(BranchStart::Slow);
    let largest = BranchEnd::Parameter(problem.parameters[1]);
    if slow.as_ref().is_ok_and(|branch| branch.ends == largest) {
        return Ok(SpeedFolds { slow, fast: None, no_contact: None, others: Vec::new() });
    }
    let fast = from(BranchStart::Fast);
    let no_contact = match (&slow, &fast) {
        (Ok(slow), Ok(fast)) => between(slow, fast, problem),
        _ => None,
    };
    let mut others = Vec::new();
    if let Some(NoContactBetween { lower, upper, .. }) = &no_contact {
        let [from, to] = [lower.value.value, upper.value.value];
        for index in 0..RATES {
            let log_rate = from + (to - from) * (index as f64 + 0.5) / RATES as f64;
            let found = contacts_of(material, problem, problem.held(), log_rate, HALF_WIDTHS)?;
            others.extend(found.into_iter().map(|contact| (log_rate.exp(), contact)));
        }
    }
    let no_contact = no_contact.filter(|_| others.is_empty());
    Ok(SpeedFolds { slow, fast: Some(fast), no_contact, others })
}

fn between(slow: &Branch, fast: &Branch, problem: &BranchProblem) -> Option<NoContactBetween> {
    let lower = slow
        .folds_of(FoldQuantity::LogRate)
        .filter(|fold| fold.turn == Turn::Maximum)
        .max_by(|first, second| first.value.value.total_cmp(&second.value.value))?;
    let upper = fast
        .folds_of(FoldQuantity::LogRate)
        .filter(|fold| fold.turn == Turn::Minimum)
        .min_by(|first, second| first.value.value.total_cmp(&second.value.value))?;
    // The fast branch is followed toward growing rates first: it comes back from its backward end.
    let back = |end: &BranchEnd, rate: f64| *end == BranchEnd::Parameter(rate) || matches!(end, BranchEnd::HalfWidth(_));
    let closed = back(&slow.ends, problem.parameters[0]) && back(&fast.begins, problem.parameters[1]);
    (lower.value.value < upper.value.value).then(|| NoContactBetween {
        lower: lower.clone(),
        upper: upper.clone(),
        closed,
        scanned: (RATES, HALF_WIDTHS),
    })
}
