//! Speeds at which a load has no steady partial contact.
//!
//! The slow contact of a load is followed to growing speeds, the fast one to falling ones. Where the slow one turns back at a speed below that at which the fast one
//! does, and each returns to the end it came from, every elastic contact of the load at either end belongs to one of the two curves: between
//! the folds none of them is left. A closed curve that reaches neither end (an isola) is another matter: a scan of every contact looks for it, at rates between the
//! folds, or at all rates asked for where neither end has a contact: a load beyond both elastic limits may still be borne by speeds between.

use super::conditions::{BranchPath, BranchProblem, BranchStart};
use super::end::BranchEnd;
use super::fold::{Fold, FoldQuantity, Turn};
use super::scan::{Scan, branches_through, contacts_at, scanned_parameters};
use super::trace::{Branch, trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::equilibrium::ContactAt;
use crate::sliding::steady::{SlidingWork, contact_on_the_curve};

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
    /// Branches that neither end of the speeds belongs to: closed ones (isolas), or such as end in between. Looked for between two folds, and everywhere where
    /// neither end has a contact.
    pub isolated: Vec<Branch>,
    /// What was looked at where neither end has a contact.
    pub everywhere: Option<Everywhere>,
    /// Contacts of the scan at rates (kv in 1/s) that no branch could be followed from, and why.
    pub others: Vec<(f64, ContactAt, Refusal)>,
    /// Evaluations of both edge conditions by scans; those of the branches are counted there.
    pub scan_evaluations: u64,
}

/// A scan of all rates asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Everywhere {
    /// Rates, evenly in their logarithm, and half-widths at each, evenly in ln tan(a/2).
    pub scan: Scan,
    /// Contacts found. None of them: at no rate that was looked at is there a steady partial contact, however it is reached.
    pub contacts: usize,
}

impl SpeedFolds {
    /// Whether a scan of all rates has found no contact: the witness that the load, penetration or half-width is held at no speed.
    #[must_use]
    pub fn at_no_speed(&self) -> bool {
        self.everywhere.is_some_and(|everywhere| everywhere.contacts == 0)
    }
}

/// Follows the slow and the fast contact of a branch along speeds toward each other.
///
/// # Errors
/// [`Refusal::OutOfRange`], [`Refusal::Undefined`] for a wrong problem.
pub fn speed_folds(material: &PlaneMaterial, problem: &BranchProblem) -> Result<SpeedFolds, Refusal> {
    problem.checked()?;
    let from = |start| trace(material, &BranchProblem { start, ..*problem });
    let slow = from(BranchStart::Slow);
    let largest = BranchEnd::Parameter(problem.parameters[1]);
    if slow.as_ref().is_ok_and(|branch| branch.ends == largest) {
        return Ok(SpeedFolds {
            slow,
            fast: None,
            no_contact: None,
            isolated: Vec::new(),
            everywhere: None,
            others: Vec::new(),
            scan_evaluations: 0,
        });
    }
    let fast = from(BranchStart::Fast);
    let mut found =
        SpeedFolds { slow, fast: None, no_contact: None, isolated: Vec::new(), everywhere: None, others: Vec::new(), scan_evaluations: 0 };
    match (&found.slow, &fast) {
        (Ok(slow), Ok(fast)) => {
            if let Some(gap) = between(slow, fast, problem) {
                let [from, to] = [gap.lower.value.value, gap.upper.value.value];
                let rates: Vec<f64> = (0..RATES).map(|index| from + (to - from) * (index as f64 + 0.5) / RATES as f64).collect();
                let (contacts, evaluations) = contacts_at(material, problem, &rates, HALF_WIDTHS)?;
                found.scan_evaluations = evaluations;
                // Whatever lies between the folds is on neither branch.
                if contacts.is_empty() {
                    found.no_contact = Some(gap);
                }
                found.follow(material, problem, contacts);
            }
        }
        (Err(none), Err(_)) if !matches!(none, Refusal::OutOfRange { .. } | Refusal::Undefined { .. }) => {
            let scan = Scan::of(problem);
            let (contacts, evaluations) = contacts_at(material, problem, &scanned_parameters(problem, scan), scan.half_widths)?;
            found.scan_evaluations = evaluations;
            found.everywhere = Some(Everywhere { scan, contacts: contacts.len() });
            found.follow(material, problem, contacts);
        }
        _ => {}
    }
    found.fast = Some(fast);
    Ok(found)
}

impl SpeedFolds {
    /// Follows branches from contacts that belong to no other.
    fn follow(&mut self, material: &PlaneMaterial, problem: &BranchProblem, contacts: Vec<(f64, ContactAt)>) {
        let (branches, left_over) = branches_through(material, problem, Vec::new(), contacts);
        self.isolated = branches;
        self.others = left_over.into_iter().map(|(contact, rate, refusal)| (rate, contact, refusal)).collect();
    }
}

/// Whether neither end of the speeds carries the load, penetration or half-width that is held, by the equilibrium curves there: then all speeds are scanned.
#[must_use]
pub fn beyond_both_ends(material: &PlaneMaterial, problem: &BranchProblem) -> bool {
    let BranchPath::Speeds(control) = problem.path else { return false };
    let carries = |rate: f64| contact_on_the_curve(material, &problem.steady(rate.ln(), control), &mut SlidingWork::default()).is_ok();
    problem.parameters.iter().all(|&rate| !carries(rate))
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
