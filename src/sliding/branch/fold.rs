//! A turn of a branch: where it is, what turns there, and how well both are known.
//!
//! The fold equations are solved at one resolution; what they are off at the next, with longer differences, is the error, with what rounding leaves. Where that is
//! above the request, the next resolution follows.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::{BranchEquations, edges_at};
use super::point::variations_at;
use super::trace::{BranchWork, Coarse, near};
use super::values::widened;
use crate::continuation::curve::{CurveEquations, Quantity, linearized};
use crate::continuation::fold::{CENTRAL_STEP, Differences, FoldPoint, between, located, part_at, shifted};
use crate::estimate::Estimate;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeStates, SlidingControl};
use crate::sliding::steady::{PartialValues, Start};

use super::stability::SecondVariations;

/// Part of the tangent along the half-width below which the mean pressure is prescribed instead.
const NEAR_TURN: f64 = 0.1;
/// Accuracies above this begin at the medium resolution.
const COARSEST_FOR: f64 = 1e-9;
/// Accuracies from here on take differences of second order.
pub(super) const LOOSE: f64 = 1e-5;
/// Residual of the fold equations over the accuracy: it widens the bounds.
const RESIDUAL: f64 = 1e-3;
/// Share of the accuracy that the uncertain place of a fold may take; bounds of the contact there are its own as well.
const PLACE: f64 = 0.5;
/// A place whose shift at the next level is below this part of its error is uncertain by rounding.
const ROUNDED: f64 = 0.05;
/// The longest differences that are taken against rounding.
const LONGEST_STEP: f64 = 4.0 * CENTRAL_STEP;
/// Share of an error that the finer level may still have.
const MARGIN: f64 = 0.3;

/// What turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldQuantity {
    /// p̄ along loads: pull-off at a minimum, snap-in at a maximum.
    MeanPressure,
    /// Δ along loads: Δ_out at a minimum.
    Penetration,
    /// a along loads.
    HalfWidth,
    /// ln(kv·s) along speeds.
    LogRate,
    /// ln Γ along adhesions.
    LogWork,
    /// ln of the factor of the zones.
    LogZone,
}

impl FoldQuantity {
    /// Those that are looked for along a path.
    pub(super) fn of(problem: &BranchProblem) -> &'static [Self] {
        match (problem.path, problem.indenter) {
            (BranchPath::Loads, Indenter::Wave) => &[Self::MeanPressure, Self::Penetration, Self::HalfWidth],
            // The penetration of a parabola counts from a datum; another datum adds a multiple of the load, so a turn of it means nothing by itself.
            (BranchPath::Loads, Indenter::Parabola) => &[Self::MeanPressure, Self::HalfWidth],
            (BranchPath::Speeds(_), _) => &[Self::LogRate],
            (BranchPath::Adhesions(_), _) => &[Self::LogWork],
            (BranchPath::Zones(_), _) => &[Self::LogZone],
        }
    }

    /// The quantity itself at a fold of what the curve has in its place, with an error.
    fn reported(self, problem: &BranchProblem, point: &FoldPoint<EdgeStates>, error: f64) -> Estimate {
        let state = &point.found.state.state;
        match self {
            Self::HalfWidth => {
                let edges = edges_at(problem, point.unknowns[0], point.unknowns[1]);
                Estimate::new(edges.half_width, error * edges.width_by_place() + f64::EPSILON * edges.half_width)
            }
            // Watched is −ln(1 − Δ).
            Self::Penetration => Estimate::new(state.penetration(), error * state.mean_separation() + f64::EPSILON),
            _ => Estimate::new(point.value, error),
        }
    }

    /// Where it stands among the unknowns of the curve.
    pub(super) const fn unknown(self) -> Quantity {
        match self {
            Self::MeanPressure | Self::LogRate | Self::LogWork | Self::LogZone => Quantity::Unknown(2),
            Self::Penetration => Quantity::Watched,
            Self::HalfWidth => Quantity::Unknown(0),
        }
    }
}

/// Which way a quantity turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// Smallest at the fold.
    Minimum,
    /// Largest at the fold.
    Maximum,
}

/// A turn of a branch.
#[derive(Debug, Clone)]
pub struct Fold {
    /// What turns.
    pub quantity: FoldQuantity,
    /// Which way.
    pub turn: Turn,
    /// The value at the turn, of the quantity as it is named (logarithms too).
    pub value: Estimate,
    /// The contact at the turn; bounds include what is uncertain of its place.
    pub contact: PartialValues,
    /// Whether one side of the turn is stable under what turns (load or penetration; along parameters what is held); otherwise both are unstable.
    pub borders_stable: bool,
    /// The second variations there: one determinant is zero to rounding.
    pub variations: SecondVariations,
    /// Where on the coarse curve.
    pub arclength: f64,
    /// The largest residual of the fold equations.
    pub residual: f64,
}

impl Fold {
    /// The value itself where the quantity is a logarithm: kv in 1/s, Γ, or the factor of the zones.
    #[must_use]
    pub fn parameter(&self) -> Estimate {
        match self.quantity {
            FoldQuantity::LogRate | FoldQuantity::LogWork | FoldQuantity::LogZone => {
                Estimate::relative(self.value.value.exp(), self.value.error.exp_m1() + f64::EPSILON * (1.0 + self.value.value.abs()))
            }
            _ => self.value,
        }
    }
}

/// A fold at the level of resolution that the accuracy takes, with its bounds.
struct Solved {
    point: FoldPoint<EdgeStates>,
    value: Estimate,
    errors: [f64; 3],
    tangent: [f64; 3],
}

/// Solves a fold at one level and sees what it is off at the next, with longer differences as well, until that is below the accuracy.
fn solved(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    quantity: FoldQuantity,
    (start, scales): ([f64; 3], [f64; 3]),
    work: &mut BranchWork,
) -> Result<Solved, Refusal> {
    let (mut start, mut jacobian) = (start, None);
    let mut differences = Differences { step: CENTRAL_STEP, second_order: problem.accuracy >= LOOSE };
    let mut level = if problem.accuracy > COARSEST_FOR { Resolution::Medium } else { Resolution::Fine };
    loop {
        let Some(finer) = level.finer() else {
            return Err(Refusal::NotConverged { what: "the accuracy of a fold", detail: "no finer level is left".into() });
        };
        let (here, there) = (BranchEquations::new(material, problem, level)?, BranchEquations::new(material, problem, finer)?);
        let both = located(&here, start, quantity.unknown(), scales, jacobian, (differences, RESIDUAL * problem.accuracy.min(LOOSE)))
            .and_then(|point| {
                let shift = shifted(&there, &point, quantity.unknown(), differences.wider())?;
                let (_, tangent) = linearized(&here, point.unknowns, &point.found)?;
                Ok((point, shift, tangent))
            });
        work.closure_evaluations += here.evaluations() + there.evaluations();
        let (point, shift, tangent) = match both {
            Ok(found) => found,
            // Rough fields may turn a little elsewhere, or twice.
            Err(_) if finer.finer().is_some() => {
                (jacobian, level) = (None, finer);
                continue;
            }
            Err(refusal) => return Err(refusal),
        };
        let value = quantity.reported(problem, &point, (1.0 + MARGIN) * shift.value.abs() + point.value_rounding);
        let shifts = shift.unknowns.map(|shift| (1.0 + MARGIN) * shift.abs());
        let errors: [f64; 3] = std::array::from_fn(|index| shifts[index] + point.unknown_rounding[index]);
        // Its place is an output as well, and less sure than what turns there.
        let by_width = matches!(problem.held(), Some(SlidingControl::HalfWidth(_)));
        let width = if by_width { 1.0 } else { edges_at(problem, point.unknowns[0], point.unknowns[1]).width_by_place() };
        let place = |[first, eccentricity, _]: [f64; 3]| (first * width).max(eccentricity);
        let placed = place(errors) <= PLACE * problem.accuracy;
        let enough = placed && value.error <= problem.accuracy * value.value.abs().max(1.0);
        if !placed && place(shifts) < ROUNDED * place(errors) && differences.step < LONGEST_STEP {
            // Rounding over the step is what is left: no finer level helps, longer differences do.
            (start, jacobian, differences) = (point.unknowns, point.jacobian, differences.wider());
            continue;
        }
        if enough || finer.finer().is_none() {
            return Ok(Solved { point, value, errors, tangent: tangent.into() });
        }
        start = std::array::from_fn(|index| point.unknowns[index] + shift.unknowns[index]);
        jacobian = point.jacobian;
        level = finer;
    }
}

/// The value of what turns along loads near given unknowns (ln tan(a/2), e, p̄), to the accuracy of the problem.
///
/// # Errors
/// [`Refusal::NotConverged`] if nothing turns there.
pub(in crate::sliding) fn turn_near(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    quantity: FoldQuantity,
    start: [f64; 3],
) -> Result<Estimate, Refusal> {
    let scales = BranchEquations::new(material, problem, Resolution::Medium)?.scales(start);
    solved(material, problem, quantity, (start, scales), &mut BranchWork::default()).map(|found| found.value)
}

/// The fold between two neighbouring points of a coarse curve.
pub(super) fn located_fold(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    quantity: FoldQuantity,
    from: &Coarse,
    to: &Coarse,
    work: &mut BranchWork,
) -> Result<Fold, Refusal> {
    let start = between(from, to, quantity.unknown());
    let Solved { point, value, errors, tangent } = solved(material, problem, quantity, (start, from.scales), work)?;
    let far = (0..3).map(|index| ((point.unknowns[index] - start[index]) / from.scales[index]).abs()).fold(0.0, f64::max);
    if far > 2.0 * (to.arclength - from.arclength) {
        return Err(Refusal::NotConverged { what: "a fold of a branch", detail: "the fold found is not where the curve turns".into() });
    }
    let pressure = point.found.state.state.mean_pressure();
    let by_pressure = tangent[0].abs() < NEAR_TURN;
    let contact = contact_at(material, problem, point.unknowns, (pressure, by_pressure), errors, work)?;
    let third = if problem.path == BranchPath::Loads { 0.0 } else { point.unknowns[2] };
    let variations = variations_at(&problem.prepared(material, third)?, problem, &contact, Resolution::Fine, work)?;
    let frame = match (quantity, problem.held()) {
        (FoldQuantity::Penetration, _) | (_, Some(SlidingControl::Penetration(_))) => f64::INFINITY,
        _ => 0.0,
    };
    // Where its neighbours are placed by the same unknown, the fold comes between those it lies between.
    let along = if problem.held().is_none() && by_pressure { 2 } else { 0 };
    let place = point.unknowns.get(along).copied().unwrap_or(f64::NAN);
    Ok(Fold {
        quantity,
        turn: if from.slope(quantity.unknown()) < 0.0 { Turn::Minimum } else { Turn::Maximum },
        value,
        contact,
        borders_stable: variations.each_edge_is_held(frame),
        variations,
        arclength: from.arclength + part_at(from, to, along, place) * (to.arclength - from.arclength),
        residual: point.residual,
    })
}

/// The contact at given unknowns of a curve, with what their errors make of its values. Prescribed is the half-width or the mean pressure, whichever
/// changes along the curve, so that a turn of the other is an ordinary contact.
pub(super) fn contact_at(
    material: &PlaneMaterial,
    problem: &BranchProblem,
    unknowns: [f64; 3],
    (pressure, by_pressure): (f64, bool),
    errors: [f64; 3],
    work: &mut BranchWork,
) -> Result<PartialValues, Refusal> {
    let [first, eccentricity, third] = unknowns;
    let edges = edges_at(problem, first, eccentricity);
    let (half_width, width_error) = (edges.half_width, errors[0] * edges.width_by_place());
    // The prescribed unknown with its error, what makes a control of it, the guess of the other, and whether a parameter is left over.
    type Control = fn(f64) -> SlidingControl;
    let (given, error, control, guess): (f64, f64, Control, f64) = match problem.held() {
        Some(SlidingControl::HalfWidth(half_width)) => (first, errors[0], SlidingControl::MeanPressure, half_width),
        None if by_pressure => (third, errors[2], SlidingControl::MeanPressure, half_width),
        _ => (half_width, width_error, SlidingControl::HalfWidth, pressure),
    };
    let mut at = |given: f64, third: f64| -> Result<PartialValues, Refusal> {
        Ok(near(&problem.prepared(material, third)?, &problem.steady(third, control(given)), &Start::at(guess, eccentricity), work)?.values)
    };
    let here = at(given, third)?;
    // Differences far above the bounds of both, far below curvature, and away from the narrower of contact and gap.
    let room = match control(given) {
        SlidingControl::HalfWidth(half_width) => half_width.min(problem.indenter.widest() - half_width),
        _ => given.abs().max(1e-3),
    };
    let step = 1e-4 * room;
    // Where contacts end just beyond, the other side tells the same.
    let beside = match at(given + step, third) {
        Ok(beside) => beside,
        Err(_) => at(given - step, third)?,
    };
    let mut values = widened(&here, &beside, error / step);
    if problem.path != BranchPath::Loads {
        values = widened(&values, &at(given, third + 1e-4)?, errors[2] / 1e-4);
    }
    Ok(values)
}
