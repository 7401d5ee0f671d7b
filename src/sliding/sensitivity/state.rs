//! The sensitivities of a contact under a load, at a penetration or of a half-width.

use super::linearized::{EVALUATIONS, Linearized, Place};
use super::{Parameter, Sensitivity, compared, logarithmic};
use crate::continuation::fold::CENTRAL_STEP;
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialValues, SlidingProblem};
use nalgebra::{Matrix3, Vector3};

/// How the outputs of a contact follow the parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateSensitivities {
    /// Of the half-width a.
    pub half_width: Sensitivity,
    /// Of the load in its own unit: with E0 it grows even where its reduced value does not.
    pub mean_pressure: Sensitivity,
    /// Of the penetration Δ; of no meaning for a parabola.
    pub penetration: Sensitivity,
    /// Of the friction stress in its own unit.
    pub friction_stress: Sensitivity,
    /// Evaluations of both edge conditions.
    pub closure_evaluations: u64,
}

/// The sensitivities of a solved adhesive contact.
///
/// # Errors
/// [`Refusal::Undefined`] without adhesion; [`Refusal::NotConverged`] at a fold, where they are infinite; those of contacts nearby.
pub fn state_sensitivities(
    material: &PlaneMaterial,
    problem: &SlidingProblem<'_>,
    values: &PartialValues,
) -> Result<StateSensitivities, Refusal> {
    let adhesion = problem.adhesion.ok_or_else(|| Refusal::Undefined {
        quantity: "the sensitivity of a contact",
        reason: "without adhesion there is no process zone and no work of adhesion to vary".into(),
    })?;
    let unknowns = [values.half_width.value, values.eccentricity.value, values.mean_pressure.value];
    let place = Place { material, rate: problem.rate, indenter: problem.indenter, adhesion, unknowns };
    let here = place.linearized(Resolution::Fine, 4.0 * CENTRAL_STEP)?;
    let rough = derivatives(&here, problem.control, unknowns)?;
    // The place itself is known as well as the accuracy of the scene asks: by Newton's step from it, what it lacks is part of the difference that makes the bound.
    let unknowns = nearer(&here, problem.control, unknowns)?;
    let best = derivatives(&Place { unknowns, ..place }.linearized(Resolution::Finest, 2.0 * CENTRAL_STEP)?, problem.control, unknowns)?;
    let of = |output: usize, value: Estimate| -> Sensitivity {
        std::array::from_fn(|index| {
            let (rough, best) = (rough[index]?[output], best[index]?[output]);
            logarithmic(compared(rough, best), value)
        })
    };
    Ok(StateSensitivities {
        half_width: of(0, values.half_width),
        mean_pressure: of(1, values.mean_pressure),
        penetration: of(2, values.penetration),
        friction_stress: of(3, values.friction_stress),
        closure_evaluations: 2 * EVALUATIONS,
    })
}

/// The condition that what is prescribed stays, by the unknowns in units of their scales, and what is left of it.
fn held(linear: &Linearized, control: SlidingControl, [half_width, _, pressure]: [f64; 3]) -> (Vector3<f64>, f64) {
    let [length, _, load] = linear.scales;
    match control {
        SlidingControl::HalfWidth(given) => (Vector3::new(length, 0.0, 0.0), half_width - given),
        SlidingControl::MeanPressure(given) => (Vector3::new(0.0, 0.0, load), pressure - given),
        SlidingControl::Penetration(given) => (Vector3::from(linear.by_unknown[2]), linear.values[0] - given),
    }
}

/// Both edge conditions and what is prescribed, by the unknowns in units of their scales, inverted.
fn inverse(linear: &Linearized, control: SlidingControl, unknowns: [f64; 3]) -> Result<Matrix3<f64>, Refusal> {
    let row = |index: usize| Vector3::from(linear.by_unknown[index]).transpose();
    let singular =
        || Refusal::NotConverged { what: "the sensitivity of a contact", detail: "the Jacobian is singular: a fold is here".into() };
    Matrix3::from_rows(&[row(0), row(1), held(linear, control, unknowns).0.transpose()]).try_inverse().ok_or_else(singular)
}

/// The unknowns after one step of Newton's.
fn nearer(linear: &Linearized, control: SlidingControl, unknowns: [f64; 3]) -> Result<[f64; 3], Refusal> {
    let [trailing, leading] = linear.residual;
    let left = Vector3::new(trailing, leading, held(linear, control, unknowns).1);
    let step = inverse(linear, control, unknowns)? * left;
    Ok(std::array::from_fn(|index| unknowns[index] - linear.scales[index] * step[index]))
}

/// dY/dln θ of a, p̄, Δ and friction (the second and the last in their own units) for each parameter.
type Derivatives = [Option<[Estimate; 4]>; 5];

fn derivatives(linear: &Linearized, control: SlidingControl, unknowns: [f64; 3]) -> Result<Derivatives, Refusal> {
    let [half_width, _, pressure] = unknowns;
    let row = |index: usize| Vector3::from(linear.by_unknown[index]);
    let [length, _, load] = linear.scales;
    let by_half_width = Vector3::new(length, 0.0, 0.0);
    let by_pressure = Vector3::new(0.0, 0.0, load);
    let held_rounding = if let SlidingControl::Penetration(_) = control { linear.rounding[2] } else { 0.0 };
    let inverse = inverse(linear, control, unknowns)?;
    let outputs = [(by_half_width, 0.0), (by_pressure, 0.0), (row(2), linear.rounding[2]), (row(3), linear.rounding[3])];
    let own = [half_width, pressure, linear.values[0], linear.values[1]];
    let of = |parameter: Parameter| -> Option<[Estimate; 4]> {
        let by = match parameter {
            Parameter::ProcessZone => linear.by_zone,
            Parameter::WorkOfAdhesion => linear.by_work,
            // What E0 does to reduced works and loads, pressures being measured in it.
            Parameter::RelaxedModulus => linear.by_work.map(|value| -value),
            Parameter::StiffeningRatio => linear.by_ratio?,
            Parameter::Time => linear.by_time,
        };
        let of_held = match (control, parameter) {
            // p̃ − p̄/E0: the reduced load falls.
            (SlidingControl::MeanPressure(_), Parameter::RelaxedModulus) => pressure,
            (SlidingControl::Penetration(_), _) => by[2],
            _ => 0.0,
        };
        let change = Vector3::new(by[0], by[1], of_held);
        let moved = -(inverse * change);
        let size = 1.0 + moved.abs().sum();
        Some(std::array::from_fn(|output| {
            let (gradient, rounding) = outputs[output];
            let adjoint = inverse.transpose() * gradient;
            let explicit = if output >= 2 { by[output] } else { 0.0 };
            let in_units = match (parameter, output) {
                (Parameter::RelaxedModulus, 1 | 3) => own[output],
                _ => 0.0,
            };
            let uncertain = adjoint.x.abs() * linear.rounding[0] + adjoint.y.abs() * linear.rounding[1] + adjoint.z.abs() * held_rounding;
            let value = gradient.dot(&moved) + explicit + in_units;
            Estimate::new(value, size * (rounding + uncertain) + 4.0 * f64::EPSILON * (value.abs() + in_units.abs()))
        }))
    };
    Ok(Parameter::ALL.map(of))
}
