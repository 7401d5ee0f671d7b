//! A kept point of a branch, to the accuracy asked for.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::BranchEquations;
use super::fold::contact_at;
use super::stability::SecondVariations;
use super::start::place_of;
use super::trace::{BranchWork, Coarse, near as near_start, parameter_of};
use crate::continuation::arclength::{CurveEquations, Quantity, landed};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Resolution, WaveContact};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl};
use crate::sliding::steady::{PartialValues, Start};
use std::sync::Arc;

/// Part of the tangent along the parameter below which a turn is so near that the parameter is found and the half-width given.
const NEAR_TURN: f64 = 0.1;
/// Largest distance of an accurate point from the coarse curve in scaled unknowns.
const FARTHEST: f64 = 0.03;

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

/// The accurate point at a part of the way between two points of the coarse curve.
pub(super) fn accurate_point(
    material: &Material,
    problem: &BranchProblem,
    fine: &BranchEquations<'_>,
    (from, to): (&Coarse, &Coarse),
    part: f64,
    near: [f64; 3],
    work: &mut BranchWork,
) -> Result<BranchPoint, Refusal> {
    let along = (1.0 - part) * from.tangent[2] + part * to.tangent[2];
    let pressure = |part: f64| (1.0 - part) * from.state.state.mean_pressure() + part * to.state.state.mean_pressure();
    let (parameter, values) = match problem.held() {
        None => {
            let wider = (1.0 - part) * from.tangent[0] + part * to.tangent[0];
            let (control, start) = if wider.abs() > NEAR_TURN {
                (SlidingControl::HalfWidth(fine.edges(near).half_width), Start::at(near[2], near[1]))
            } else {
                (SlidingControl::MeanPressure(near[2]), Start::at(fine.edges(near).half_width, near[1]))
            };
            let found = near_start(material, &problem.steady(0.0, control), &start, work)?;
            (found.values.mean_pressure, found.values)
        }
        Some(control) if along.abs() > NEAR_TURN => {
            let first = if matches!(control, SlidingControl::HalfWidth(_)) { near[0] } else { fine.edges(near).half_width };
            let found = near_start(material, &problem.steady(near[2], control), &Start::at(first, near[1]), work)?;
            (Estimate::exact(parameter_of(problem, near[2])), found.values)
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
    let half_width_held = matches!(problem.held(), Some(SlidingControl::HalfWidth(_)));
    let first = if half_width_held { values.mean_pressure.value } else { place_of(problem, values.half_width.value) };
    let far = ((first - near[0]) / scales[0]).abs().max(((values.eccentricity.value - near[1]) / scales[1]).abs());
    if far > FARTHEST {
        return Err(Refusal::NotConverged {
            what: "a point of a branch",
            detail: format!("the accurate contact is {far:.1e} away from the curve at p̄ ≈ {:.3e}", pressure(part)),
        });
    }
    let third = if problem.path == BranchPath::Loads { 0.0 } else { parameter.value.ln() };
    let variations = variations_at(material, problem, third, &values, Resolution::Fine, work)?;
    Ok(BranchPoint { arclength: 0.0, parameter, values, variations })
}

/// The second variations at a contact of a branch.
pub(super) fn variations_at(
    material: &Material,
    problem: &BranchProblem,
    third: f64,
    values: &PartialValues,
    resolution: Resolution,
    work: &mut BranchWork,
) -> Result<SecondVariations, Refusal> {
    let (rate, adhesion) = problem.at(third);
    let pressure = values.mean_pressure.value;
    let memory = Arc::new(ContactMemory::new(material, rate)?);
    let balance = EdgeBalance::new(memory, problem.indenter, Some(adhesion), SlidingControl::MeanPressure(pressure), resolution);
    let contact = WaveContact { half_width: values.half_width.value, eccentricity: values.eccentricity.value };
    work.closure_evaluations += 13;
    SecondVariations::new(&balance, contact, pressure, problem.indenter)
}
