//! Load, penetration and their slopes by the half-width, at one half-width of the branch of one speed.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::BranchEquations;
use crate::continuation::curve::{CurveEquations, tangent_of};
use crate::continuation::fold::{CENTRAL_STEP, Differences, gradients};
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialContact, PartialValues, SlidingOutcome, SlidingProblem, Start, steady_sliding, steady_sliding_near};
use nalgebra::Vector3;

/// Contacts that slopes are taken at are solved at least this well.
const CONTACT_ACCURACY: f64 = 1e-9;
/// Evaluations for the slopes at one resolution: four along each of three unknowns, and one where they are wanted.
pub(super) const SLOPE_EVALUATIONS: u64 = 13;

/// A contact of given half-width and how its load follows it.
#[derive(Debug, Clone)]
pub struct LoadSlopes {
    /// The contact.
    pub contact: PartialContact,
    /// dp̄/da along the branch; zero at pull-off and snap-in.
    pub pressure_slope: Estimate,
    /// dΔ/da along the branch; zero at Δ_out.
    pub penetration_slope: Estimate,
    /// Evaluations of both edge conditions, those of the contact among them.
    pub closure_evaluations: u64,
}

/// The slopes of mean pressure and penetration by the half-width (in 1/k) at one half-width, from a `start` (mean pressure, eccentricity) if one is known.
///
/// # Errors
/// Those of the contact; [`Refusal::Undefined`] if the branch is not one of loads.
pub fn load_slopes(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    half_width: f64,
    start: Option<(f64, f64)>,
) -> Result<LoadSlopes, Refusal> {
    if problem.path != BranchPath::Loads {
        return Err(Refusal::Undefined { quantity: "the slope of the load", reason: "the branch is not one of loads".into() });
    }
    // Slopes are taken at the contact that is found: what it is off counts in them, and their bounds do not see it.
    let steady = problem.steady(0.0, SlidingControl::HalfWidth(half_width));
    let steady = SlidingProblem { accuracy: steady.accuracy.min(CONTACT_ACCURACY), ..steady };
    let contact = match start {
        Some((pressure, eccentricity)) => steady_sliding_near(material, &steady, &Start::at(pressure, eccentricity))?,
        None => match steady_sliding(material, &steady)? {
            SlidingOutcome::Partial(contact) => *contact,
            SlidingOutcome::Full(full) => {
                return Err(Refusal::NoSuchState {
                    reason: "there is full contact at this half-width".into(),
                    limit_name: full.limit_name,
                    limit: full.limit,
                });
            }
        },
    };
    let slopes = |resolution: Resolution, differences: Differences| {
        slopes_at(&BranchEquations::new(material, problem, resolution)?, problem, &contact.values, differences)
    };
    let differences = Differences { step: CENTRAL_STEP, second_order: false };
    let (rough, _) = slopes(Resolution::Fine, differences.wider())?;
    let (best, floor) = slopes(Resolution::Finest, differences)?;
    let estimate = |index: usize| Estimate::new(best[index], (best[index] - rough[index]).abs() + floor[index]);
    let closure_evaluations = contact.work.closure_evaluations + 2 * SLOPE_EVALUATIONS;
    Ok(LoadSlopes { pressure_slope: estimate(0), penetration_slope: estimate(1), contact, closure_evaluations })
}

/// dp̄/da and dΔ/da at a contact of known half-width, by equations of one resolution and differences of one step; and what rounding leaves uncertain of both.
///
/// # Errors
/// Those of the equations.
pub(super) fn slopes_at(
    equations: &BranchEquations<'_>,
    problem: &BranchProblem,
    values: &PartialValues,
    differences: Differences,
) -> Result<([f64; 2], [f64; 2]), Refusal> {
    let edges =
        ContactEdges::new(problem.indenter, WaveContact { half_width: values.half_width.value, eccentricity: values.eccentricity.value });
    let unknowns = [edges.place(), values.eccentricity.value, values.mean_pressure.value];
    let scales = equations.natural(unknowns);
    let rows = gradients(equations, unknowns, scales, differences)?;
    let tangent = tangent_of(&rows)?;
    let width = tangent[0] * scales[0] * edges.width_by_place();
    let here = equations.evaluate(unknowns)?;
    let depth = match problem.indenter {
        Indenter::Wave => here.state.state.mean_separation(),
        Indenter::Parabola => 1.0,
    };
    let slopes = [tangent[2] * scales[2] / width, depth * Vector3::from(rows[2]).dot(&tangent) / width];
    // Half the sum and the difference of both roundings are never largest together: their sum is the larger bound. Over sizes of order one in scaled unknowns.
    let floor = (here.rounding[0].max(here.rounding[1]) + f64::EPSILON) / CENTRAL_STEP;
    Ok((slopes, slopes.map(|slope| floor * (slope.abs() + 1.0 / edges.narrower()))))
}
