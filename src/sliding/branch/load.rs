//! Load, penetration and their slopes by the half-width, at one half-width of the branch of one speed.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::BranchEquations;
use crate::continuation::curve::{CurveEquations, tangent_of};
use crate::continuation::fold::{CENTRAL_STEP, gradients};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialContact, SlidingOutcome, SlidingProblem, Start, steady_sliding, steady_sliding_near};
use nalgebra::Vector3;

/// Contacts that slopes are taken at are solved at least this well.
const CONTACT_ACCURACY: f64 = 1e-9;
/// Evaluations for the slopes at one resolution: four along each of three unknowns, and one where they are wanted.
const SLOPE_EVALUATIONS: u64 = 13;

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
    material: &Material,
    problem: &BranchProblem,
    half_width: f64,
    start: Option<(f64, f64)>,
) -> Result<LoadSlopes, Refusal> {
    if problem.path != BranchPath::Loads {
        return Err(Refusal::Undefined { quantity: "the slope of the load", reason: "the branch is not one of loads".into() });
    }
    // Slopes are taken at the contact that is found: what it is off counts in them, and their bars do not see it.
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
    let edges = ContactEdges::new(problem.indenter, WaveContact { half_width, eccentricity: contact.values.eccentricity.value });
    let unknowns = [edges.place(), contact.values.eccentricity.value, contact.values.mean_pressure.value];
    let slopes = |resolution: Resolution, step: f64| -> Result<([f64; 2], f64), Refusal> {
        let equations = BranchEquations::new(material, problem, resolution)?;
        let scales = equations.natural(unknowns);
        let rows = gradients(&equations, unknowns, scales, step)?;
        let tangent = tangent_of(&rows)?;
        let width = tangent[0] * scales[0] * edges.width_by_place();
        let here = equations.evaluate(unknowns)?;
        let depth = match problem.indenter {
            Indenter::Wave => here.state.state.mean_separation(),
            Indenter::Parabola => 1.0,
        };
        let penetration = depth * Vector3::from(rows[2]).dot(&tangent);
        // Half the sum and the difference of both roundings are never largest together: their sum is the larger bound.
        Ok(([tangent[2] * scales[2] / width, penetration / width], here.rounding[0].max(here.rounding[1])))
    };
    let (rough, _) = slopes(Resolution::Fine, 2.0 * CENTRAL_STEP)?;
    let (best, rounding) = slopes(Resolution::Finest, CENTRAL_STEP)?;
    // Rounding of the differences, over sizes of order one in scaled unknowns.
    let floor = (rounding + f64::EPSILON) / CENTRAL_STEP;
    let scale = 1.0 / edges.narrower();
    let estimate = |index: usize| Estimate::new(best[index], (best[index] - rough[index]).abs() + floor * (best[index].abs() + scale));
    let closure_evaluations = contact.work.closure_evaluations + 2 * SLOPE_EVALUATIONS;
    Ok(LoadSlopes { pressure_slope: estimate(0), penetration_slope: estimate(1), contact, closure_evaluations })
}
