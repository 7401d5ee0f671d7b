//! A turn of a branch: where it is, what turns there, and how well both are known.
//!
//! The fold equations are solved at one resolution, with longer differences, and at the next; the difference, with what rounding leaves, is the error.

use super::conditions::{BranchPath, BranchProblem};
use super::equations::BranchEquations;
use super::trace::{BranchWork, Coarse};
use super::values::widened;
use crate::continuation::arclength::{Quantity, linearized};
use crate::continuation::fold::{CENTRAL_STEP, between, located};
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl};
use crate::sliding::steady::{PartialValues, Start, steady_sliding_near};
use std::sync::Arc;

use super::stability::SecondVariations;

/// Part of the tangent along the half-width below which the mean pressure is prescribed instead.
const NEAR_TURN: f64 = 0.1;

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
            // The penetration of a parabola counts from a datum of no meaning.
            (BranchPath::Loads, Indenter::Parabola) => &[Self::MeanPressure, Self::HalfWidth],
            (BranchPath::Speeds(_), _) => &[Self::LogRate],
            (BranchPath::Adhesions(_), _) => &[Self::LogWork],
            (BranchPath::Zones(_), _) => &[Self::LogZone],
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
    /// The contact at the turn; bars include what is uncertain of its place.
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

/// The fold between two neighbouring points of a coarse curve.
pub(super) fn located_fold(
    material: &Material,
    problem: &BranchProblem,
    quantity: FoldQuantity,
    from: &Coarse,
    to: &Coarse,
    work: &mut BranchWork,
) -> Result<Fold, Refusal> {
    let start = between(from, to, quantity.unknown());
    let fine = BranchEquations::new(material, problem, Resolution::Fine)?;
    let finest = BranchEquations::new(material, problem, Resolution::Finest)?;
    let rough = located(&fine, start, quantity.unknown(), from.scales, None, 2.0 * CENTRAL_STEP)?;
    let best = located(&finest, rough.unknowns, quantity.unknown(), from.scales, rough.jacobian, CENTRAL_STEP)?;
    work.closure_evaluations += rough.evaluations + best.evaluations;
    let far = (0..3).map(|index| ((best.unknowns[index] - start[index]) / from.scales[index]).abs()).fold(0.0, f64::max);
    if far > 2.0 * (to.arclength - from.arclength) {
        return Err(Refusal::NotConverged { what: "a fold of a branch", detail: "the fold found is not where the curve turns".into() });
    }
    let errors: [f64; 3] = std::array::from_fn(|index| (best.unknowns[index] - rough.unknowns[index]).abs() + best.unknown_rounding[index]);
    let value = Estimate::new(best.value, (best.value - rough.value).abs() + best.value_rounding);
    let state = &best.found.state.state;
    let pressure = state.mean_pressure();
    let (_, tangent) = linearized(&finest, best.unknowns, &best.found, 1e-6)?;
    let by_pressure = tangent[0].abs() < NEAR_TURN;
    let contact = contact_at(material, problem, best.unknowns, (pressure, by_pressure), errors, work)?;
    let (rate, adhesion) = problem.at(best.unknowns[2]);
    let balance = EdgeBalance::new(
        Arc::new(ContactMemory::new(material, rate)?),
        problem.indenter,
        Some(adhesion),
        SlidingControl::MeanPressure(pressure),
        Resolution::Finest,
    );
    let variations = SecondVariations::new(&balance, state.contact(), pressure, problem.indenter)?;
    work.closure_evaluations += 12;
    let frame = match (quantity, problem.held()) {
        (FoldQuantity::Penetration, _) | (_, Some(SlidingControl::Penetration(_))) => f64::INFINITY,
        _ => 0.0,
    };
    let borders_stable = variations.each_edge_is_held(frame);
    Ok(Fold {
        quantity,
        turn: if from.slope(quantity.unknown()) < 0.0 { Turn::Minimum } else { Turn::Maximum },
        value,
        contact,
        variations,
        arclength: 0.5 * (from.arclength + to.arclength),
        residual: best.residual,
        borders_stable,
    })
}

/// The contact at given unknowns of a curve, with what their errors make of its values. Prescribed is the half-width or the mean pressure, whichever
/// changes along the curve, so that a turn of the other is an ordinary contact.
pub(super) fn contact_at(
    material: &Material,
    problem: &BranchProblem,
    unknowns: [f64; 3],
    (pressure, by_pressure): (f64, bool),
    errors: [f64; 3],
    work: &mut BranchWork,
) -> Result<PartialValues, Refusal> {
    let [first, eccentricity, third] = unknowns;
    // The prescribed unknown with its error, what makes a control of it, the guess of the other, and whether a parameter is left over.
    type Control = fn(f64) -> SlidingControl;
    let (given, error, control, guess): (f64, f64, Control, f64) = match problem.held() {
        Some(SlidingControl::HalfWidth(half_width)) => (first, errors[0], SlidingControl::MeanPressure, half_width),
        None if by_pressure => (third, errors[2], SlidingControl::MeanPressure, first),
        _ => (first, errors[0], SlidingControl::HalfWidth, pressure),
    };
    let mut at = |given: f64, third: f64| -> Result<PartialValues, Refusal> {
        let found = steady_sliding_near(material, &problem.steady(third, control(given)), &Start::at(guess, eccentricity))?;
        work.closure_evaluations += found.work.closure_evaluations;
        Ok(found.values)
    };
    let here = at(given, third)?;
    // Differences far above the bars of both, far below curvature, and away from the narrower of contact and gap.
    let room = match control(given) {
        SlidingControl::HalfWidth(half_width) => half_width.min(problem.indenter.widest() - half_width),
        _ => given.abs().max(1e-3),
    };
    let step = 1e-4 * room;
    let mut values = widened(&here, &at(given + step, third)?, error / step);
    if problem.path != BranchPath::Loads {
        values = widened(&values, &at(given, third + 1e-4)?, errors[2] / 1e-4);
    }
    Ok(values)
}
