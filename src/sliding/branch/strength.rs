//! Pull-off, snap-in and toughness over speeds and works of adhesion (thesis Fig 3.14).

use super::conditions::{BranchPath, BranchProblem};
use super::fold::{Fold, FoldQuantity};
use super::stability::Stability;
use super::toughness::{Toughness, of_branch};
use super::trace::{Branch, BranchWork, as_far_as_snap_in, trace};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::WaveAdhesion;
use crate::sliding::steady::PartialValues;
use rayon::prelude::*;

/// What a contact of one speed and adhesion can bear.
#[derive(Debug, Clone)]
pub struct Strength {
    /// The smallest mean pressure, p_out; none if no contact is stable under a held load, or the fold is outside the half-widths asked for.
    pub pull_off: Option<Fold>,
    /// The largest mean pressure of a partial contact, p_IN.
    pub snap_in: Option<Fold>,
    /// The smallest penetration, Δ_out.
    pub separation: Option<Fold>,
    /// The stable contact without load.
    pub zero_load: Option<PartialValues>,
    /// The work to separate; or why it is none.
    pub toughness: Result<Toughness, Refusal>,
    /// Turns of load and penetration that were seen and not solved: those of the above that are none may be among them.
    pub unlocated: Vec<(FoldQuantity, Refusal)>,
    /// What the branch took.
    pub work: BranchWork,
}

impl Strength {
    /// Why a turn of a quantity is none though the branch turns, if that is so.
    #[must_use]
    pub fn why_not(&self, quantity: FoldQuantity) -> Option<&Refusal> {
        self.unlocated.iter().find(|(turned, _)| *turned == quantity).map(|(_, refusal)| refusal)
    }
}

/// A strength at its speed and adhesion.
#[derive(Debug, Clone)]
pub struct StrengthAt {
    /// kv (1/s).
    pub rate: f64,
    /// Γ of the trailing edge, in reduced units.
    pub reduced_work: f64,
    /// The strength, or why there is none.
    pub strength: Result<Strength, Refusal>,
}

/// Pull-off, snap-in, Δ_out and toughness at each pair of a rate kv (1/s) and a work of adhesion Γ of the trailing edge (that of the leading one in a fixed ratio
/// to it); rates fastest.
#[must_use]
pub fn strengths(material: &PlaneMaterial, rates: &[f64], works: &[f64], adhesion: WaveAdhesion, accuracy: f64) -> Vec<StrengthAt> {
    let pairs: Vec<(f64, f64)> = works.iter().flat_map(|&work| rates.iter().map(move |&rate| (rate, work))).collect();
    pairs
        .into_par_iter()
        .map(|(rate, reduced_work)| {
            let problem = BranchProblem::loads(rate, adhesion.with_trailing_work(reduced_work), accuracy);
            StrengthAt { rate, reduced_work, strength: strength(material, &problem) }
        })
        .collect()
}

/// What the contacts of a branch of loads can bear.
///
/// # Errors
/// Those of [`trace`].
pub fn strength(material: &PlaneMaterial, problem: &BranchProblem) -> Result<Strength, Refusal> {
    let mut work = BranchWork::default();
    // Of a cylinder no load is the largest.
    if problem.path == BranchPath::Loads
        && problem.indenter == Indenter::Wave
        && let Some(branch) = as_far_as_snap_in(material, problem, &mut work)?
    {
        let strength = of_branch_of_loads(material, problem, &branch);
        if strength.toughness.is_ok() {
            return Ok(strength);
        }
    }
    // What is missing may lie beyond, or the whole branch tells why.
    let mut branch = trace(material, problem)?;
    branch.work.closure_evaluations += work.closure_evaluations;
    Ok(of_branch_of_loads(material, problem, &branch))
}

fn of_branch_of_loads(material: &PlaneMaterial, problem: &BranchProblem, branch: &Branch) -> Strength {
    let toughness = of_branch(material, problem, branch);
    let stable = || branch.zero_load.iter().find(|point| point.variations.under_load() == Stability::Stable).map(|point| point.values);
    let zero_load = toughness.as_ref().map_or_else(|_| stable(), |toughness| Some(toughness.unloaded));
    Strength {
        pull_off: branch.pull_off(problem).cloned(),
        snap_in: branch.snap_in().cloned(),
        separation: branch.separation().cloned(),
        unlocated: branch.unlocated.iter().map(|(quantity, _, refusal)| (*quantity, refusal.clone())).collect(),
        work: BranchWork {
            closure_evaluations: branch.work.closure_evaluations + toughness.as_ref().map_or(0, |toughness| toughness.closure_evaluations),
            ..branch.work
        },
        zero_load,
        toughness,
    }
}
