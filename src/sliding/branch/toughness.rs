//! The work to separate a contact at one speed (thesis Eq 3.41).
//!
//! ```text
//! T = 2π ∫ p̄ dΔ       from the contact without load, Δ₀, along the branch through pull-off to Δ_out, the fold of Δ
//! ```
//! Reduced by E0*Λ²/2 per wavelength. Both p̄ and dΔ are negative on the way, so T > 0. As load and penetration are smooth functions of the half-width on
//! it, Gauss's rule in ln tan(a/2) gains digits with each node; two rules tell the error.
//!
//! Every state on the way slides: material enters at the leading edge and leaves at the trailing one, whichever way the edges creep as the contact is
//! unloaded. So both works of adhesion count on the whole way, each at its own edge and at the sliding speed. (At speed zero, where unloading would open
//! both edges, it is the limit of slow sliding that is slower still to unload.)

use super::conditions::BranchProblem;
use super::fold::Fold;
use super::load::load_slopes;
use super::trace::{Branch, trace};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::steady::PartialValues;
use crate::special::gauss_legendre::{UNIT_RULE_12, UNIT_RULE_20, UnitRule};
use std::f64::consts::PI;

/// The work to separate, with the states between which it is done.
#[derive(Debug, Clone)]
pub struct Toughness {
    /// T in E0*Λ²/2 per wavelength; positive.
    pub value: Estimate,
    /// The contact without load.
    pub unloaded: PartialValues,
    /// The fold of Δ at which the contact is lost under a held penetration.
    pub separation: Fold,
    /// Evaluations of both edge conditions for the integral; those of the branch are counted there.
    pub closure_evaluations: u64,
}

/// The toughness of a branch of loads.
///
/// # Errors
/// [`Refusal::NoSuchState`] if no stable contact without load exists (adhesion closes the gap by itself) or no fold of Δ within the half-widths asked for; those of
/// the branch.
pub fn toughness(material: &Material, problem: &BranchProblem) -> Result<Toughness, Refusal> {
    of_branch(material, problem, &trace(material, &BranchProblem { points: 0, ..*problem })?)
}

/// The toughness of a branch of loads that has been traced.
pub(super) fn of_branch(material: &Material, problem: &BranchProblem, branch: &Branch) -> Result<Toughness, Refusal> {
    let missing = |reason: &str, limit_name: &'static str, limit: f64| Refusal::NoSuchState { reason: reason.into(), limit_name, limit };
    let separation = branch.separation().ok_or_else(|| {
        missing("the penetration has no smallest value on this branch", "the narrowest half-width (in 1/k)", problem.half_widths[0])
    })?;
    let narrow = separation.contact.half_width.value;
    // The first contact without load on the way from separation to snap-in.
    let unloaded = branch
        .zero_load
        .iter()
        .find(|point| point.arclength > separation.arclength && branch.snap_in().is_none_or(|snap_in| point.arclength < snap_in.arclength))
        .map(|point| point.values)
        .ok_or_else(|| {
            let snap_in = branch.snap_in();
            missing(
                "no contact without load is stable: adhesion closes the gap by itself",
                "snap-in mean pressure",
                snap_in.map_or(0.0, |fold| fold.value.value),
            )
        })?;
    let place = |half_width: f64| (0.5 * half_width).tan().ln();
    let (begin, end) = (place(unloaded.half_width.value), place(narrow));
    let outline = branch.outline();
    let guess = |half_width: f64| {
        let after = outline.partition_point(|point| point[0] < half_width).clamp(1, outline.len().saturating_sub(1).max(1));
        match (outline.get(after - 1), outline.get(after)) {
            (Some(low), Some(high)) => {
                let part = (half_width - low[0]) / (high[0] - low[0]);
                Some((low[2] + part * (high[2] - low[2]), low[1] + part * (high[1] - low[1])))
            }
            _ => None,
        }
    };
    let mut closure_evaluations = 0;
    let mut integral = |rule: &UnitRule| -> Result<(f64, f64), Refusal> {
        let (mut sum, mut error) = (0.0, 0.0);
        for &(node, weight) in rule {
            let half_width = 2.0 * (begin + (end - begin) * node).exp().atan();
            let slopes = load_slopes(material, problem, half_width, guess(half_width))?;
            closure_evaluations += slopes.closure_evaluations;
            // da = sin a dξ.
            let measure = 2.0 * PI * weight * (end - begin) * half_width.sin();
            let (pressure, slope) = (slopes.contact.values.mean_pressure, slopes.penetration_slope);
            sum += measure * pressure.value * slope.value;
            error += measure.abs() * (pressure.error * slope.value.abs() + pressure.value.abs() * slope.error);
        }
        Ok((sum, error))
    };
    let (rough, _) = integral(&UNIT_RULE_12)?;
    let (best, error) = integral(&UNIT_RULE_20)?;
    // The integrand vanishes at both ends, p̄ at one and dΔ at the other: errors of the ends enter squared.
    let ends = 2.0 * PI * (separation.contact.mean_pressure.value.abs() * separation.value.error + unloaded.mean_pressure.error);
    Ok(Toughness {
        value: Estimate::new(best, (best - rough).abs() + error + ends),
        unloaded,
        separation: separation.clone(),
        closure_evaluations,
    })
}
