//! A kept point of a branch, to the accuracy asked for.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::BranchEquations;
use super::fold::contact_at;
use super::stability::SecondVariations;
use super::start::place_of;
use super::trace::{BranchWork, Coarse, near as near_start, parameter_of};
use crate::continuation::arclength::landed;
use crate::continuation::curve::{CurveEquations, Quantity};
use crate::continuation::two_unknowns::Jacobian;
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialValues, Prepared, Start};
use std::f64::consts::PI;

/// Part of the tangent along the parameter below which a turn is so near that the parameter is found and the half-width given.
const NEAR_TURN: f64 = 0.1;
/// Half gaps below this need every digit for the signs of second variations.
const NARROW: f64 = 0.2;
/// Largest distance of an accurate point from the coarse curve in scaled unknowns.
const FARTHEST: f64 = 0.03;

/// The resolution of second variations: signs are known to five digits.
pub(super) const VARIATIONS: Resolution = Resolution::Medium;

/// A point of a branch.
#[derive(Debug, Clone)]
pub struct BranchPoint {
    /// Arclength in scaled unknowns; its zero is where the branch begins to be followed.
    pub arclength: f64,
    /// The third unknown: p̄ along loads, or the rate kv (1/s), Γ, the factor of the zones. Exact unless a turn is near.
    pub parameter: Estimate,
    /// The numbers of the contact. Along loads the half-width is exact, and load and penetration follow; near a turn of the half-width the load is exact.
    pub values: PartialValues,
    /// How the works at the edges change when they move.
    pub variations: SecondVariations,
}

/// What a branch is of: the material, the problem, and along loads the conditions at its one speed.
pub(super) type Of<'a> = (&'a PlaneMaterial, &'a BranchProblem<'a>, Option<&'a Prepared>);

/// A Jacobian of a contact nearby, with whether it is of a prescribed half-width.
pub(super) type Nearby = Option<(bool, Jacobian)>;

/// The accurate point at a part of the way between two points of the coarse curve.
pub(super) fn accurate_point(
    (material, problem, prepared): Of<'_>,
    fine: &BranchEquations<'_>,
    (from, to): (&Coarse, &Coarse),
    (part, near): (f64, [f64; 3]),
    nearby: &mut Nearby,
    work: &mut BranchWork,
) -> Result<BranchPoint, Refusal> {
    let along = (1.0 - part) * from.tangent[2] + part * to.tangent[2];
    let pressure = |part: f64| (1.0 - part) * from.state.state.mean_pressure() + part * to.state.state.mean_pressure();
    let half_width = fine.edges(near).half_width;
    let by_width = matches!(problem.held(), Some(SlidingControl::HalfWidth(_)));
    let own;
    let prepared = match prepared {
        Some(prepared) => prepared,
        None => {
            own = problem.prepared(material, near[2])?;
            &own
        }
    };
    let mut solved = |third: f64, control: SlidingControl, first: f64| -> Result<PartialValues, Refusal> {
        let of_width = matches!(control, SlidingControl::HalfWidth(_));
        let jacobian = nearby.filter(|(width, _)| *width == of_width).map(|(_, jacobian)| jacobian);
        let start = Start { unknowns: [first, near[1]], jacobian };
        let found = near_start(prepared, &problem.steady(third, control), &start, work)?;
        *nearby = found.start.jacobian.map(|jacobian| (of_width, jacobian));
        Ok(found.values)
    };
    let (parameter, values) = match problem.held() {
        None => {
            let wider = (1.0 - part) * from.tangent[0] + part * to.tangent[0];
            let values = if wider.abs() > NEAR_TURN {
                solved(0.0, SlidingControl::HalfWidth(half_width), near[2])?
            } else {
                solved(0.0, SlidingControl::MeanPressure(near[2]), half_width)?
            };
            (values.mean_pressure, values)
        }
        Some(control) if along.abs() > NEAR_TURN => {
            let values = solved(near[2], control, if by_width { near[0] } else { half_width })?;
            (Estimate::exact(parameter_of(problem, near[2])), values)
        }
        Some(_) => {
            let finest = BranchEquations::new(material, problem, Resolution::Finest)?;
            let (rough, _) = landed(fine, (from, to), Quantity::Unknown(0), near[0], 1e-12)?;
            let best = landed(&finest, (from, to), Quantity::Unknown(0), near[0], 1e-12);
            work.closure_evaluations += finest.evaluations();
            let (best, found) = best?;
            let error = (best[2] - rough[2]).abs() + found.rounding[0] + found.rounding[1] + 1e-12;
            let values = contact_at(material, problem, best, (found.state.state.mean_pressure(), false), [0.0, 0.0, error], work)?;
            (Estimate::relative(parameter_of(problem, best[2]), error), values)
        }
    };
    let scales = fine.scales(near);
    let first = if by_width { values.mean_pressure.value } else { place_of(problem, values.half_width.value) };
    let far = ((first - near[0]) / scales[0]).abs().max(((values.eccentricity.value - near[1]) / scales[1]).abs());
    if far > FARTHEST {
        return Err(Refusal::NotConverged {
            what: "a point of a branch",
            detail: format!("the accurate contact is {far:.1e} away from the curve at p̄ ≈ {:.3e}", pressure(part)),
        });
    }
    let variations = match problem.path {
        BranchPath::Loads => variations_at(prepared, problem, &values, VARIATIONS, work)?,
        _ => variations_at(&problem.prepared(material, parameter.value.ln())?, problem, &values, VARIATIONS, work)?,
    };
    Ok(BranchPoint { arclength: 0.0, parameter, values, variations })
}

/// The second variations at a contact of a branch.
pub(super) fn variations_at(
    prepared: &Prepared,
    problem: &BranchProblem,
    values: &PartialValues,
    resolution: Resolution,
    work: &mut BranchWork,
) -> Result<SecondVariations, Refusal> {
    let pressure = values.mean_pressure.value;
    let contact = WaveContact { half_width: values.half_width.value, eccentricity: values.eccentricity.value };
    let resolution = if problem.indenter == Indenter::Wave && PI - contact.half_width < NARROW { Resolution::Finest } else { resolution };
    let balance = prepared.balance(SlidingControl::MeanPressure(pressure), resolution);
    let found = SecondVariations::new(&balance, contact, pressure, problem.indenter);
    work.closure_evaluations += balance.take_evaluations();
    found
}
