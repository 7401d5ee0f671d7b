//! The work to separate a contact at one speed (thesis Eq 3.41).
//!
//! ```text
//! T = 2π ∫ p̄ dΔ       from the contact without load, Δ₀, along the branch through pull-off to Δ_out, the fold of Δ
//! ```
//! Reduced by E0*Λ²/2 per wavelength. Both p̄ and dΔ are negative on the way, so T > 0. As load and penetration are smooth functions of the half-width on
//! it, Gauss's rule in ln tan(a/2) gains digits with each node; two rules tell the error, of eight and twelve nodes where that is enough.
//!
//! Every state on the way slides: material enters at the leading edge and leaves at the trailing one, whichever way the edges creep as the contact is
//! unloaded. So both works of adhesion count on the whole way, each at its own edge and at the sliding speed. (At speed zero, where unloading would open
//! both edges, it is the limit of slow sliding that is slower still to unload.)

use super::conditions::BranchProblem;
use super::equations::BranchEquations;
use super::fold::Fold;
use super::load::{load_slopes, slopes_at};
use super::trace::{Branch, BranchWork, near, trace};
use crate::continuation::fold::CENTRAL_STEP;
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialValues, SlidingProblem, Start};
use crate::special::gauss_legendre::{UNIT_RULE_8, UNIT_RULE_12, UNIT_RULE_20, UnitRule};
use std::f64::consts::PI;

/// Accuracies from here on are tried by the coarsest rule.
const LOOSE: f64 = 1e-5;
/// What that rule may be off, over the toughness.
const RELATIVE: f64 = 1e-3;
/// Contacts of the finer rules are solved at least this well.
const CONTACT_ACCURACY: f64 = 1e-9;
/// Share of the error of a rule that the next one may still have.
const MARGIN: f64 = 0.3;

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
    let mut work = BranchWork::default();
    let prepared = problem.prepared(material, 0.0)?;
    // The equations differ from rule to rule as well, so that the difference of two rules knows of resolution, differences and contacts too.
    let mut integral = |rule: &UnitRule, resolution: Resolution, step: f64, accuracy: f64| -> Result<(f64, f64), Refusal> {
        let equations = BranchEquations::new(material, problem, resolution)?;
        let (mut sum, mut error, mut jacobian) = (0.0, 0.0, None);
        for &(node, weight) in rule {
            let half_width = 2.0 * (begin + (end - begin) * node).exp().atan();
            let steady = SlidingProblem { accuracy, ..problem.steady(0.0, SlidingControl::HalfWidth(half_width)) };
            let contact = match guess(half_width) {
                Some((pressure, eccentricity)) => {
                    let start = Start { jacobian, ..Start::at(pressure, eccentricity) };
                    let contact = near(&prepared, &steady, &start, &mut work)?;
                    jacobian = contact.start.jacobian;
                    contact.values
                }
                None => {
                    let contact = load_slopes(material, problem, half_width, None)?.contact;
                    work.closure_evaluations += contact.work.closure_evaluations;
                    contact.values
                }
            };
            let (slopes, floors) = slopes_at(&equations, problem, &contact, step)?;
            // da = sin a dξ.
            let measure = 2.0 * PI * weight * (end - begin) * half_width.sin();
            let pressure = contact.mean_pressure;
            sum += measure * pressure.value * slopes[1];
            error += measure.abs() * (pressure.error * slopes[1].abs() + pressure.value.abs() * floors[1]);
        }
        work.closure_evaluations += equations.evaluations();
        Ok((sum, error))
    };
    let rough = if problem.accuracy >= LOOSE { Some(integral(&UNIT_RULE_8, Resolution::Medium, 2.0 * CENTRAL_STEP, LOOSE)?) } else { None };
    let better = integral(&UNIT_RULE_12, Resolution::Fine, 2.0 * CENTRAL_STEP, CONTACT_ACCURACY.min(problem.accuracy))?;
    let told = rough
        .map(|(rough, error)| (rough, (1.0 + MARGIN) * (better.0 - rough).abs() + error))
        .filter(|(value, error)| *error <= problem.accuracy.min(RELATIVE * value.abs()));
    let (value, error) = match told {
        Some(told) => told,
        None => {
            let (best, error) = integral(&UNIT_RULE_20, Resolution::Finest, CENTRAL_STEP, CONTACT_ACCURACY.min(problem.accuracy))?;
            (best, (best - better.0).abs() + error)
        }
    };
    let closure_evaluations = work.closure_evaluations;
    // The integrand vanishes at both ends, p̄ at one and dΔ at the other: errors of the ends enter squared.
    let ends = 2.0 * PI * (separation.contact.mean_pressure.value.abs() * separation.value.error + unloaded.mean_pressure.error);
    Ok(Toughness { value: Estimate::new(value, error + ends), unloaded, separation: separation.clone(), closure_evaluations })
}
