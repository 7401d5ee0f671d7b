//! The sensitivities of what a contact carries: pull-off, snap-in, separation and toughness.

use super::linearized::{EVALUATIONS, Linearized, Place, QUANTITIES};
use super::{Parameter, Sensitivity, compared, logarithmic};
use crate::continuation::fold::CENTRAL_STEP;
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::branch::{BranchProblem, Fold, FoldQuantity, Strength, Toughness};
use crate::sliding::contact::Resolution;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::steady::{PartialValues, SlidingOutcome, Start, steady_sliding, steady_sliding_near};
use crate::special::gauss_legendre::{UNIT_RULE_12, UNIT_RULE_20, UnitRule};
use nalgebra::{Matrix2, Vector2, Vector3};
use std::f64::consts::PI;

/// How the limits of a contact follow the parameters; none where there is no such limit.
#[derive(Debug, Clone)]
pub struct StrengthSensitivities {
    /// Of the pull-off pressure p_out, in its own unit.
    pub pull_off: Option<Sensitivity>,
    /// Of the snap-in pressure p_IN.
    pub snap_in: Option<Sensitivity>,
    /// Of the smallest penetration Δ_out.
    pub separation: Option<Sensitivity>,
    /// Of the toughness T; or why there is none.
    pub toughness: Result<Sensitivity, Refusal>,
    /// Evaluations of both edge conditions.
    pub closure_evaluations: u64,
}

/// The sensitivities of a strength, from its branch of loads.
///
/// # Errors
/// Those of contacts near the limits.
pub fn strength_sensitivities(
    material: &PlaneMaterial,
    problem: &BranchProblem<'_>,
    strength: &Strength,
) -> Result<StrengthSensitivities, Refusal> {
    let mut closure_evaluations = 0;
    let mut of = |fold: &Option<Fold>| -> Result<Option<Sensitivity>, Refusal> {
        let Some(fold) = fold else { return Ok(None) };
        closure_evaluations += 2 * EVALUATIONS;
        of_fold(material, problem, fold).map(|derivatives| Some(derivatives.map(|derivative| logarithmic(derivative?, fold.value))))
    };
    let (pull_off, snap_in, separation) = (of(&strength.pull_off)?, of(&strength.snap_in)?, of(&strength.separation)?);
    let toughness = match &strength.toughness {
        Ok(toughness) => of_toughness(material, problem, toughness, &mut closure_evaluations),
        Err(refusal) => Err(refusal.clone()),
    };
    Ok(StrengthSensitivities { pull_off, snap_in, separation, toughness, closure_evaluations })
}

/// d/dln θ for each parameter.
type Derivatives = [Option<Estimate>; 5];

fn place<'a>(material: &'a PlaneMaterial, problem: &BranchProblem<'_>, values: &PartialValues) -> Place<'a> {
    let unknowns = [values.half_width.value, values.eccentricity.value, values.mean_pressure.value];
    Place { material, rate: problem.rate, indenter: problem.indenter, adhesion: problem.adhesion, unknowns }
}

/// The partial derivatives by a parameter in reduced units at a given reduced load.
fn by(linear: &Linearized, parameter: Parameter) -> Option<[f64; QUANTITIES]> {
    Some(match parameter {
        Parameter::ProcessZone => linear.by_zone,
        Parameter::WorkOfAdhesion => linear.by_work,
        Parameter::RelaxedModulus => linear.by_work.map(|value| -value),
        Parameter::StiffeningRatio => linear.by_ratio?,
        Parameter::Time => linear.by_time,
    })
}

fn of_fold(material: &PlaneMaterial, problem: &BranchProblem<'_>, fold: &Fold) -> Result<Derivatives, Refusal> {
    let place = place(material, problem, &fold.contact);
    let watched = fold.quantity == FoldQuantity::Penetration;
    let at = |resolution, step| -> Result<Derivatives, Refusal> {
        let linear = place.linearized(resolution, step)?;
        let row = |index: usize| Vector3::from(linear.by_unknown[index]);
        let (first, second) = (row(0), row(1));
        let (gradient, rounding) = if watched { (row(2), linear.rounding[2]) } else { (Vector3::new(0.0, 0.0, linear.scales[2]), 0.0) };
        // Least squares: three equations for two multipliers, which agree at a turn.
        let normal = Matrix2::new(first.dot(&first), first.dot(&second), second.dot(&first), second.dot(&second));
        let inverse = normal.try_inverse().ok_or_else(|| Refusal::NotConverged {
            what: "the sensitivity of a fold",
            detail: "both edge conditions have the same gradient".into(),
        })?;
        let multipliers = inverse * Vector2::new(first.dot(&gradient), second.dot(&gradient));
        let missed = (gradient - first * multipliers.x - second * multipliers.y).norm();
        let shift = |change: [f64; QUANTITIES]| (inverse * Vector2::new(change[0], change[1])).norm() * (first.norm() + second.norm());
        Ok(Parameter::ALL.map(|parameter| {
            let change = by(&linear, parameter)?;
            let explicit = if watched { change[2] } else { 0.0 };
            let in_units = if !watched && parameter == Parameter::RelaxedModulus { place.unknowns[2] } else { 0.0 };
            let value = explicit - multipliers.x * change[0] - multipliers.y * change[1] + in_units;
            let moved = shift(change);
            let uncertain = multipliers.x.abs() * linear.rounding[0] + multipliers.y.abs() * linear.rounding[1] + rounding;
            Some(Estimate::new(value, missed * moved + (1.0 + moved) * uncertain + 4.0 * f64::EPSILON * value.abs()))
        }))
    };
    let rough = at(Resolution::Fine, 4.0 * CENTRAL_STEP)?;
    let best = at(Resolution::Finest, 2.0 * CENTRAL_STEP)?;
    Ok(std::array::from_fn(|index| Some(compared(rough[index]?, best[index]?))))
}

fn of_toughness(
    material: &PlaneMaterial,
    problem: &BranchProblem<'_>,
    toughness: &Toughness,
    evaluations: &mut u64,
) -> Result<Sensitivity, Refusal> {
    let separation = &toughness.separation;
    *evaluations += 2 * EVALUATIONS;
    let at_end = of_fold(material, problem, separation)?;
    let place_of = |half_width: f64| (0.5 * half_width).tan().ln();
    let (begin, end) = (place_of(toughness.unloaded.half_width.value), place_of(separation.contact.half_width.value));
    let mut integral = |rule: &UnitRule, resolution: Resolution, step: f64| -> Result<Derivatives, Refusal> {
        let mut sums: Derivatives = [Some(Estimate::exact(0.0)); 5];
        let mut near = toughness.unloaded;
        for &(node, weight) in rule {
            let half_width = 2.0 * (begin + (end - begin) * node).exp().atan();
            let steady = problem.steady(0.0, SlidingControl::HalfWidth(half_width));
            let start = Start::at(near.mean_pressure.value, near.eccentricity.value);
            let contact = match steady_sliding_near(material, &steady, &start) {
                Ok(contact) => contact,
                Err(_) => match steady_sliding(material, &steady)? {
                    SlidingOutcome::Partial(contact) => *contact,
                    SlidingOutcome::Full(_) => {
                        return Err(Refusal::NotConverged { what: "the sensitivity of a toughness", detail: "a contact was lost".into() });
                    }
                },
            };
            near = contact.values;
            *evaluations += contact.work.closure_evaluations + EVALUATIONS;
            let linear = place(material, problem, &near).linearized(resolution, step)?;
            let measure = 2.0 * PI * weight * (end - begin) * half_width.sin();
            let slopes = Slopes::new(&linear)?;
            for (sum, parameter) in sums.iter_mut().zip(Parameter::ALL) {
                *sum = sum
                    .zip(slopes.integrand(&linear, parameter))
                    .map(|(sum, more)| Estimate::new(sum.value + measure * more.value, sum.error + measure.abs() * more.error));
            }
        }
        Ok(sums)
    };
    let rough = integral(&UNIT_RULE_12, Resolution::Fine, 4.0 * CENTRAL_STEP)?;
    let best = integral(&UNIT_RULE_20, Resolution::Finest, 2.0 * CENTRAL_STEP)?;
    let pressure = separation.contact.mean_pressure;
    Ok(std::array::from_fn(|index| {
        let (inside, ends) = (compared(rough[index]?, best[index]?), at_end[index]?);
        let boundary = 2.0 * PI * pressure.value * ends.value;
        let bar = 2.0 * PI * (pressure.value.abs() * ends.error + pressure.error * ends.value.abs());
        // T is in units of E0*.
        let in_units = if Parameter::ALL[index] == Parameter::RelaxedModulus { toughness.value } else { Estimate::exact(0.0) };
        let derivative = Estimate::new(inside.value + boundary + in_units.value, inside.error + bar + in_units.error);
        logarithmic(derivative, toughness.value)
    }))
}

/// How e and p̄ follow the half-width along a branch of loads, and the inverse that gives the same for parameters.
struct Slopes {
    /// ∂(r₁, r₂)/∂(e, p̄) inverted, in scaled unknowns.
    inverse: Matrix2<f64>,
    /// de/da and dp̄/da, scaled.
    by_width: Vector2<f64>,
    /// dΔ/da, scaled.
    penetration: f64,
}

impl Slopes {
    fn new(linear: &Linearized) -> Result<Self, Refusal> {
        let [first, second, depth, _] = linear.by_unknown;
        let matrix = Matrix2::new(first[1], first[2], second[1], second[2]);
        let inverse = matrix.try_inverse().ok_or_else(|| Refusal::NotConverged {
            what: "the sensitivity of a toughness",
            detail: "the half-width turns on the way".into(),
        })?;
        let by_width = -(inverse * Vector2::new(first[0], second[0]));
        let penetration = depth[0] + depth[1] * by_width.x + depth[2] * by_width.y;
        Ok(Self { inverse, by_width, penetration })
    }

    /// p̄_θ Δ_a − Δ_θ p̄_a at fixed half-width.
    fn integrand(&self, linear: &Linearized, parameter: Parameter) -> Option<Estimate> {
        let change = by(linear, parameter)?;
        let [length, _, load] = linear.scales;
        let moved = -(self.inverse * Vector2::new(change[0], change[1]));
        let depth = linear.by_unknown[2];
        let deeper = change[2] + depth[1] * moved.x + depth[2] * moved.y;
        let value = load * (moved.y * self.penetration - deeper * self.by_width.y) / length;
        let amplified = self.inverse.abs().sum() * (linear.rounding[0] + linear.rounding[1]);
        let size = 1.0 + moved.abs().sum() + self.by_width.abs().sum();
        let terms = self.penetration.abs() + deeper.abs() + self.by_width.y.abs() + depth[1].abs() + depth[2].abs();
        Some(Estimate::new(value, load / length * size * (terms * amplified + (1.0 + self.by_width.y.abs()) * linear.rounding[2])))
    }
}
