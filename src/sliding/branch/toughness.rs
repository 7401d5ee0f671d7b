//! The work to separate a contact at one speed (thesis Eq 3.41).
//!
//! ```text
//! T = 2π ∫ p̄ dΔ       from the contact without load, Δ₀, along the branch through pull-off to Δ_out, the fold of Δ
//! ```
//! Reduced by E0*Λ²/2 per wavelength. Both p̄ and dΔ are negative on the way, so T > 0. Load and penetration are smooth functions of the half-width on it,
//! and p̄ vanishes at one end, dΔ at the other: Lobatto's rule in ln tan(a/2), whose ends cost nothing, gains a digit and a half with each node. The
//! next rule tells the error: three nodes by four, or four by five, where that is enough; otherwise Gauss's rules of twelve and twenty.
//!
//! Every state on the way slides: material enters at the leading edge and leaves at the trailing one, whichever way the edges creep as the contact is
//! unloaded. So both works of adhesion count on the whole way, each at its own edge and at the sliding speed. (At speed zero, where unloading would open
//! both edges, it is the limit of slow sliding that is slower still to unload.)

use super::conditions::BranchProblem;
use super::equations::BranchEquations;
use super::fold::{Fold, LOOSE};
use super::load::{load_slopes, slopes_at};
use super::trace::{Branch, BranchWork, near, trace};
use crate::continuation::fold::{CENTRAL_STEP, Differences};
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialValues, SlidingProblem, Start};
use crate::special::gauss_legendre::{UNIT_RULE_12, UNIT_RULE_20, UnitRule, VANISHING_RULES};
use std::f64::consts::PI;

/// What Lobatto's rules may be off, over the toughness.
const RELATIVE: f64 = 1e-3;
/// Their contacts are solved this well: slopes are taken at the contact that is found.
const LOOSE_CONTACT: f64 = 1e-7;
/// Steps of their differences: what those leave out is in the difference of two rules as well.
const LOOSE_STEPS: [f64; 3] = [2.0 * CENTRAL_STEP, CENTRAL_STEP, 0.5 * CENTRAL_STEP];
/// Contacts of the finer rules are solved at least this well.
const CONTACT_ACCURACY: f64 = 1e-9;
/// Share of the error of a rule that the next one may still have.
const MARGIN: f64 = 0.3;
/// What may hide where two rules agree by accident, over the highest odd power that their places tell: both rules are even and know nothing of it.
const ODD: f64 = 2e-3;

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

/// The integral by one rule.
#[derive(Debug, Clone, Default)]
struct Integral {
    value: f64,
    /// What contacts and slopes are off.
    error: f64,
    /// Places on [0, 1] with the integrand there.
    places: Vec<(f64, f64)>,
}

/// The toughness of a branch of loads.
///
/// # Errors
/// [`Refusal::NoSuchState`] if no stable contact without load exists (adhesion closes the gap by itself) or no fold of Δ within the half-widths asked for; those of
/// the branch.
pub fn toughness(material: &PlaneMaterial, problem: &BranchProblem) -> Result<Toughness, Refusal> {
    of_branch(material, problem, &trace(material, &BranchProblem { points: 0, ..*problem })?)
}

/// The toughness of a branch of loads that has been traced.
pub(super) fn of_branch(material: &PlaneMaterial, problem: &BranchProblem, branch: &Branch) -> Result<Toughness, Refusal> {
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
    // Differences vary from rule to rule as well, and of Gauss's rules resolution and contacts, so that what two rules differ by knows of these too.
    let mut integral = |rule: &UnitRule, resolution: Resolution, differences: Differences, accuracy: f64| -> Result<Integral, Refusal> {
        let equations = BranchEquations::new(material, problem, resolution)?;
        let mut found = Integral::default();
        let mut jacobian = None;
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
            let (slopes, floors) = slopes_at(&equations, problem, &contact, differences)?;
            // da = sin a dξ.
            let measure = 2.0 * PI * (end - begin) * half_width.sin();
            let pressure = contact.mean_pressure;
            let integrand = measure * pressure.value * slopes[1];
            found.places.push((node, integrand));
            found.value += weight * integrand;
            // What a contact is off changes its slopes by as much, over the narrower of contact and gap.
            let off = contact.eccentricity.error + pressure.error;
            let moved = off * (slopes[1].abs() + 1.0 / half_width.min(problem.indenter.widest() - half_width));
            found.error += weight * measure.abs() * (pressure.error * slopes[1].abs() + pressure.value.abs() * (floors[1] + moved));
        }
        work.closure_evaluations += equations.evaluations();
        Ok(found)
    };
    let enough = |value: f64, error: f64| error <= problem.accuracy.min(RELATIVE * value.abs());
    let fourth = Differences { step: CENTRAL_STEP, second_order: false };
    let mut found = None;
    if problem.accuracy >= LOOSE {
        let mut rougher: Option<Integral> = None;
        for (rule, step) in VANISHING_RULES.iter().zip(LOOSE_STEPS) {
            let better = integral(rule, Resolution::Medium, Differences { step, second_order: true }, LOOSE_CONTACT)?;
            found = rougher.as_ref().map(|rough| (rough.value, off_by(rough, &better))).filter(|(value, error)| enough(*value, *error));
            if found.is_some() {
                break;
            }
            rougher = Some(better);
        }
    }
    let (value, error) = match found {
        Some(found) => found,
        None => {
            let accuracy = CONTACT_ACCURACY.min(problem.accuracy);
            let rough = integral(&UNIT_RULE_12, Resolution::Fine, fourth.wider(), accuracy)?;
            let best = integral(&UNIT_RULE_20, Resolution::Finest, fourth, accuracy)?;
            (best.value, (best.value - rough.value).abs() + best.error)
        }
    };
    let closure_evaluations = work.closure_evaluations;
    // The integrand vanishes at both ends, p̄ at one and dΔ at the other: errors of the ends enter squared.
    let ends = 2.0 * PI * (separation.contact.mean_pressure.value.abs() * separation.value.error + unloaded.mean_pressure.error);
    Ok(Toughness { value: Estimate::new(value, error + ends), unloaded, separation: separation.clone(), closure_evaluations })
}

/// What the rougher of two of Lobatto's rules is off.
fn off_by(rough: &Integral, better: &Integral) -> f64 {
    let highest = odd_power(rough.places.iter().chain(&better.places).copied().collect());
    (1.0 + MARGIN) * (better.value - rough.value).abs() + ODD * highest.abs() + rough.error
}

/// Of the polynomial h in f = (1 − x²) h through an odd number of places on x = [−1, 1], symmetrical about zero: the coefficient of the highest odd power,
/// which is the highest divided difference of x h.
fn odd_power(places: Vec<(f64, f64)>) -> f64 {
    let places: Vec<(f64, f64)> = places.into_iter().map(|(unit, f)| (2.0 * unit - 1.0, f)).collect();
    let term = |(i, &(x, f)): (usize, &(f64, f64))| {
        let others = places.iter().enumerate().filter(|(j, _)| *j != i);
        x * f / (1.0 - x * x) / others.map(|(_, (other, _))| x - other).product::<f64>()
    };
    places.iter().enumerate().map(term).sum()
}

#[cfg(test)]
mod tests {
    use super::odd_power;
    use crate::special::gauss_legendre::VANISHING_RULES;

    #[test]
    fn the_odd_power_is_that_of_the_polynomial() {
        let [three, four, _] = &*VANISHING_RULES;
        let h = |x: f64| 0.7 - 2.0 * x + 3.0 * x.powi(4) - 1.25 * x.powi(5) + 9.0 * x.powi(6);
        let places = three.iter().chain(four).map(|&(unit, _)| (unit, 2.0 * unit - 1.0)).map(|(unit, x)| (unit, (1.0 - x * x) * h(x)));
        let found = odd_power(places.collect());
        assert!((found + 1.25).abs() < 1e-12, "{found}");
    }
}
