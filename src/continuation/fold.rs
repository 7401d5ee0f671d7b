//! Where a quantity turns along a curve: F₁ = F₂ = 0 and dg/ds = ∇g·t = 0, t = ∇F₁ × ∇F₂.
//!
//! The gradients are central differences, of fourth order where many digits are asked for, so that the third equation is known to some ten digits where the equations
//! themselves are known to rounding; of second order they take half the evaluations and leave five. The value of the quantity is stationary at a fold: an error of the
//! location enters it squared.

use super::bracket::halved;
use super::curve::{CurveEquations, CurvePoint, Evaluated, Quantity, tangent_of};
use super::three_unknowns::ThreeEquations;
use crate::refusal::Refusal;
use nalgebra::{Matrix3, Vector3};

/// Step of the central differences, in scaled unknowns: truncation (5e-4)⁴ or (5e-4)², rounding 1e-16/5e-4.
pub(crate) const CENTRAL_STEP: f64 = 5e-4;
/// Step of the Jacobian of the fold equations.
const OUTER_STEP: f64 = 1e-4;
/// Central differences of a gradient: how far apart, in scaled unknowns, and of which order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differences {
    /// Distance of neighbouring points.
    pub step: f64,
    /// Whether of second order, with two points along each unknown; otherwise of fourth, with four.
    pub second_order: bool,
}

impl Differences {
    /// The same twice as far apart: what they leave out shows in the change.
    #[must_use]
    pub fn wider(self) -> Self {
        Self { step: 2.0 * self.step, ..self }
    }

    /// Places along one unknown, in steps, with their weights.
    const fn weights(self) -> &'static [(f64, f64)] {
        if self.second_order {
            &[(-1.0, -0.5), (1.0, 0.5)]
        } else {
            &[(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)]
        }
    }
}

/// Least residual asked for; one that does not fall any more below the second, or what rounding leaves up to the third, is rounding and widens the bounds.
const TOLERANCE: (f64, f64, f64) = (1e-13, 1e-5, 1e-3);

/// A turning point.
#[derive(Debug, Clone)]
pub struct FoldPoint<S> {
    /// Where.
    pub unknowns: [f64; 3],
    /// What the equations gave there.
    pub found: Evaluated<S>,
    /// The value of the quantity that turns.
    pub value: f64,
    /// What rounding leaves uncertain of the unknowns.
    pub unknown_rounding: [f64; 3],
    /// What rounding leaves uncertain of the value.
    pub value_rounding: f64,
    /// The largest residual of the three equations.
    pub residual: f64,
    /// ∂(equations)/∂scaled unknown, for a fold nearby.
    pub jacobian: Option<Matrix3<f64>>,
    scales: [f64; 3],
    natural: [f64; 3],
}

/// How far a fold is off in finer equations.
#[derive(Debug, Clone, Copy)]
pub struct FoldShift {
    /// Change of the unknowns.
    pub unknowns: [f64; 3],
    /// Change of the value.
    pub value: f64,
}

/// Gradients of both residuals and of the watched quantity at a point in given scales, by central differences; six or twelve evaluations.
///
/// # Errors
/// Those of the equations.
pub(crate) fn gradients<E: CurveEquations>(
    equations: &E,
    unknowns: [f64; 3],
    scales: [f64; 3],
    differences: Differences,
) -> Result<[[f64; 3]; 3], Refusal> {
    let step = differences.step;
    let mut rows = [[0.0; 3]; 3];
    for index in 0..3 {
        for &(times, weight) in differences.weights() {
            let mut moved = unknowns;
            moved[index] += times * step * scales[index];
            let there = equations.evaluate(moved)?;
            for (row, value) in rows.iter_mut().zip([there.residual[0], there.residual[1], there.watched]) {
                row[index] += weight * value / step;
            }
        }
    }
    Ok(rows)
}

/// The gradient of a quantity in scaled unknowns.
fn gradient(quantity: Quantity, rows: &[[f64; 3]; 3], scales: [f64; 3]) -> Vector3<f64> {
    match quantity {
        Quantity::Watched => Vector3::from(rows[2]),
        Quantity::Unknown(index) => Vector3::from_fn(|row, _| if row == index { scales[index] } else { 0.0 }),
    }
}

/// The gradient of a quantity in natural units of the unknowns, and its part along the curve over its size: zero at a fold.
fn turning<E: CurveEquations>(
    equations: &E,
    unknowns: [f64; 3],
    quantity: Quantity,
    natural: [f64; 3],
    differences: Differences,
) -> Result<(Vector3<f64>, f64), Refusal> {
    let rows = gradients(equations, unknowns, natural, differences)?;
    let tangent = tangent_of(&rows)?;
    let gradient = gradient(quantity, &rows, natural);
    let slope = gradient.dot(&tangent) / gradient.norm();
    Ok((gradient, slope))
}

/// Where a chord between two points of a curve on both sides of a fold has the slope zero.
#[must_use]
pub fn between<S>(from: &CurvePoint<S>, to: &CurvePoint<S>, quantity: Quantity) -> [f64; 3] {
    let (before, after) = (from.slope(quantity), to.slope(quantity));
    let part = (before / (before - after)).clamp(0.0, 1.0);
    interpolated(from, to, part)
}

/// A point between two of a curve: cubic in the part of the step, with both tangents.
#[must_use]
pub fn interpolated<S>(from: &CurvePoint<S>, to: &CurvePoint<S>, part: f64) -> [f64; 3] {
    let step = to.arclength - from.arclength;
    let (square, cube) = (part * part, part * part * part);
    std::array::from_fn(|index| {
        let (begin, end) = (from.unknowns[index], to.unknowns[index]);
        let (slope, end_slope) = (step * from.tangent[index] * from.scales[index], step * to.tangent[index] * to.scales[index]);
        begin * (1.0 - 3.0 * square + 2.0 * cube)
            + slope * (part - 2.0 * square + cube)
            + end * (3.0 * square - 2.0 * cube)
            + end_slope * (cube - square)
    })
}

/// The part of the way between two points of a curve at which the interpolated curve has a value of one unknown; that of the chord if the value is not between.
#[must_use]
pub(crate) fn part_at<S>(from: &CurvePoint<S>, to: &CurvePoint<S>, index: usize, value: f64) -> f64 {
    let off = |part: f64| interpolated(from, to, part).get(index).map_or(f64::NAN, |unknown| unknown - value);
    let (begin, end) = (off(0.0), off(1.0));
    if begin * end >= 0.0 || begin.is_nan() || end.is_nan() {
        return (begin / (begin - end)).clamp(0.0, 1.0);
    }
    halved([0.0, 1.0], |part| off(part) * begin > 0.0)[0]
}

/// The fold of a quantity near a start, to a `tolerance` of the three equations, with the gradients by `differences`.
///
/// What the differences leave out is no part of the bounds: [`shifted`] with wider ones shows it.
///
/// # Errors
/// [`Refusal::NotConverged`].
pub fn located<E: CurveEquations>(
    equations: &E,
    start: [f64; 3],
    quantity: Quantity,
    scales: [f64; 3],
    jacobian: Option<Matrix3<f64>>,
    (differences, tolerance): (Differences, f64),
) -> Result<FoldPoint<E::State>, Refusal> {
    let step = differences.step;
    let natural = equations.natural(start);
    let of_start = equations.evaluate(start)?.rounding;
    let rounding = ((of_start[0] + of_start[1]) / step).clamp(TOLERANCE.1, TOLERANCE.2);
    let evaluate = |unknowns: [f64; 3]| {
        let found = equations.evaluate(unknowns)?;
        let (gradient, slope) = turning(equations, unknowns, quantity, natural, differences)?;
        let [first, second] = found.residual;
        Ok(((found, gradient), [first, second, slope]))
    };
    let outer = std::array::from_fn(|index| OUTER_STEP * natural[index] / scales[index]);
    let system = ThreeEquations { what: "a fold of a curve", evaluate: &evaluate, scales, differences: outer, rounding };
    let solved = system.solve(start, jacobian, tolerance.max(TOLERANCE.0))?;
    let (found, gradient) = solved.solution;
    // In scaled unknowns.
    let gradient = Vector3::from_fn(|index, _| gradient[index] * scales[index] / natural[index]);
    let here = Vector3::new(found.residual[0], found.residual[1], 0.0);
    let matrix = match solved.jacobian {
        Some(matrix) => matrix,
        None => system.jacobian(solved.unknowns, &here)?,
    };
    let inverse = matrix
        .try_inverse()
        .ok_or_else(|| Refusal::NotConverged { what: "a fold of a curve", detail: "two folds merge: the Jacobian is singular".into() })?;
    // The residuals that are left count as rounding.
    let left = [found.rounding[0] + found.residual[0].abs(), found.rounding[1] + found.residual[1].abs()];
    let of_slope = (found.rounding[0] + found.rounding[1]) / step + solved.residual;
    let spread = |weights: Vector3<f64>| (weights[0] * left[0]).abs() + (weights[1] * left[1]).abs() + (weights[2] * of_slope).abs();
    let unknown_rounding = std::array::from_fn(|index| spread(inverse.row(index).transpose()) * scales[index]);
    let value = quantity.of(solved.unknowns, found.watched);
    let through = inverse.transpose() * gradient;
    // The third column is along the tangent, on which the value is stationary.
    let across = (through[0] * left[0]).abs() + (through[1] * left[1]).abs();
    let along = (0..3).map(|row| (inverse[(row, 2)] * of_slope).powi(2)).sum::<f64>() * gradient.norm();
    Ok(FoldPoint {
        unknowns: solved.unknowns,
        value,
        unknown_rounding,
        value_rounding: across + along + 8.0 * f64::EPSILON * value.abs(),
        residual: solved.residual,
        jacobian: Some(matrix),
        scales,
        natural,
        found,
    })
}

/// What a fold is off in finer equations, by one Newton step in them with other `differences`; seven or thirteen evaluations.
///
/// # Errors
/// Those of the equations; [`Refusal::NotConverged`] where two folds merge.
pub fn shifted<E: CurveEquations>(
    finer: &E,
    fold: &FoldPoint<E::State>,
    quantity: Quantity,
    differences: Differences,
) -> Result<FoldShift, Refusal> {
    let found = finer.evaluate(fold.unknowns)?;
    let (gradient, slope) = turning(finer, fold.unknowns, quantity, fold.natural, differences)?;
    let gradient = Vector3::from_fn(|index, _| gradient[index] * fold.scales[index] / fold.natural[index]);
    let residual = Vector3::new(found.residual[0], found.residual[1], slope);
    let moved = fold
        .jacobian
        .and_then(|matrix| matrix.lu().solve(&residual))
        .ok_or_else(|| Refusal::NotConverged { what: "a fold of a curve", detail: "two folds merge: the Jacobian is singular".into() })?;
    let unknowns = std::array::from_fn(|index| -moved[index] * fold.scales[index]);
    // Along the tangent the value is stationary.
    let value = quantity.of(fold.unknowns, found.watched) - fold.value - gradient.dot(&moved);
    Ok(FoldShift { unknowns, value })
}
