//! A curve F(x) = 0 of two equations in three unknowns, followed by its arclength (Keller's pseudo-arclength continuation).
//!
//! ```text
//!            predicted ×                 rows of ∂F/∂x: r₁, r₂          tangent t = r₁ × r₂
//!          t ↗       |  corrected        F₁ = F₂ = 0 and t·(x − x_predicted) = 0
//!   ──────•──────────•───                at a fold of a quantity g:     dg/ds = ∇g·t = 0
//! ```
//! Two of the unknowns are thought of as x and one as the parameter λ, but none is treated differently: a turning point is an ordinary point. The
//! unknowns are measured in local scales, which the equations give at each point. The corrector is Newton's method in the bordered
//! system, with the Jacobian of the point before. A corrected point that is far from its prediction, whose tangent turns much, or that the equations
//! say cannot exist is a jump to another curve: the step is halved, nothing is kept. Source: Keller, in: Applications of Bifurcation Theory,
//! Academic Press 1977, 359; Allgower and Georg, Numerical Continuation Methods, Springer 1990, Ch. 6.

use super::curve::{CurveEquations, CurvePoint, Evaluated, Quantity, linearized};
use super::three_unknowns::ThreeEquations;
use crate::refusal::Refusal;
use nalgebra::{Matrix3, RowVector3, Vector3};

/// How a curve is followed.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// First step, in scaled arclength.
    pub first: f64,
    /// Longest step.
    pub longest: f64,
    /// A step below this ends the curve.
    pub shortest: f64,
    /// Most points.
    pub most: usize,
    /// Residual of the points.
    pub tolerance: f64,
}

/// How a curve ended.
#[derive(Debug, Clone)]
pub enum CurveEnd<S> {
    /// Outside the region asked for; the last point is beyond its border.
    Left,
    /// Back where it began: the curve is closed, and the last point is the first one once more, to within a step.
    Closed,
    /// The largest number of points was reached.
    MostPoints,
    /// However short the step, the next point cannot exist; what the equations left there.
    Inadmissible(S),
    /// No point follows however short the step; the reason is that of the last attempt.
    Lost(Refusal),
}

/// A part of a curve.
#[derive(Debug, Clone)]
pub struct Curve<S> {
    /// Its points in order.
    pub points: Vec<CurvePoint<S>>,
    /// How it ended.
    pub end: CurveEnd<S>,
    /// Steps that were refused and halved.
    pub refused: u64,
}

/// Turn of the tangent in one step that is aimed at (radians).
const AIMED_TURN: f64 = 0.12;
/// Turn of the tangent above which a step is a jump: cos 0.5.
const LARGEST_TURN_COSINE: f64 = 0.877_6;
/// Largest distance of a corrected point from its prediction over the step.
const LARGEST_CORRECTION: f64 = 0.4;

/// A closed curve has more points than this.
const FEWEST_OF_LOOP: usize = 10;

/// Follows the curve through the point near `start` while `inside` holds, first toward growing `toward` (or falling, if `sign` is negative).
///
/// # Errors
/// Those of the start: no admissible point of the curve is near.
pub fn follow<E: CurveEquations>(
    equations: &E,
    start: [f64; 3],
    toward: Quantity,
    sign: f64,
    steps: &Steps,
    inside: &dyn Fn(&CurvePoint<E::State>) -> bool,
) -> Result<Curve<E::State>, Refusal> {
    let mut refused = 0;
    let mut here = begun(equations, start, steps)?;
    if here.slope(toward) * sign < 0.0 {
        here.tangent = here.tangent.map(|part| -part);
    }
    let mut points = Vec::new();
    let mut step = steps.first;
    let end = loop {
        // The start may lie on the border.
        if !points.is_empty() && !inside(&here) {
            points.push(here);
            break CurveEnd::Left;
        }
        if points.len() + 1 >= steps.most {
            points.push(here);
            break CurveEnd::MostPoints;
        }
        match advanced(equations, &here, step, steps) {
            Ok((next, turn)) => {
                if points.first().is_some_and(|first| points.len() > FEWEST_OF_LOOP && meets(first, &next, step)) {
                    points.push(here);
                    points.push(next);
                    break CurveEnd::Closed;
                }
                let stretch = (AIMED_TURN / turn.max(1e-3)).clamp(0.5, 1.7);
                step = (step * stretch).min(steps.longest);
                points.push(here);
                here = next;
            }
            Err(failure) => {
                refused += 1;
                step *= 0.5;
                if step < steps.shortest {
                    points.push(here);
                    break match failure {
                        Failure::Refused(refusal) => CurveEnd::Lost(refusal),
                        Failure::Inadmissible(state) => CurveEnd::Inadmissible(*state),
                    };
                }
            }
        }
    };
    Ok(Curve { points, end, refused })
}

/// Whether the start is within a step behind or ahead of a point, along nearly the same tangent.
fn meets<S>(first: &CurvePoint<S>, point: &CurvePoint<S>, step: f64) -> bool {
    let away = Vector3::from_fn(|index, _| (first.unknowns[index] - point.unknowns[index]) / point.scales[index]);
    let tangent = rescaled(&Vector3::from(first.tangent), first.scales, point.scales);
    let here = Vector3::from(point.tangent);
    // Nearly the same tangent, and across it no farther than a curve bends within a step.
    away.norm() < step && tangent.dot(&here) > 0.9 && (away - here * away.dot(&here)).norm() < 0.2 * step
}

/// Why a step was refused.
enum Failure<S> {
    Refused(Refusal),
    /// A root that cannot exist.
    Inadmissible(Box<S>),
}

/// The next point, and how much the tangent has turned.
type Stepped<S> = Result<(CurvePoint<S>, f64), Failure<S>>;

impl<S> From<Refusal> for Failure<S> {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

fn unphysical() -> Refusal {
    Refusal::NotConverged { what: "a point of a curve", detail: "the root found is unphysical".into() }
}

/// The point of the curve nearest to a start, in the plane across the tangent.
fn begun<E: CurveEquations>(equations: &E, start: [f64; 3], steps: &Steps) -> Result<CurvePoint<E::State>, Refusal> {
    let first = equations.evaluate(start)?;
    let (_, tangent) = linearized(equations, start, &first)?;
    let found = across(equations, start, &tangent, None, equations.scales(start), steps)?;
    point(equations, found, 0.0, None).map_err(|failure| match failure {
        Failure::Refused(refusal) => refusal,
        Failure::Inadmissible(_) => unphysical(),
    })
}

/// The next point, and how much the tangent has turned.
fn advanced<E: CurveEquations>(equations: &E, here: &CurvePoint<E::State>, step: f64, steps: &Steps) -> Stepped<E::State> {
    let tangent = Vector3::from(here.tangent);
    let along = |length: f64, index: usize| here.unknowns[index] + length * here.tangent[index] * here.scales[index];
    let predicted = [along(step, 0), along(step, 1), along(step, 2)];
    let rows = here.rows;
    let bordered = Matrix3::from_rows(&[RowVector3::from(rows[0]), RowVector3::from(rows[1]), tangent.transpose()]);
    let (found, state) = across(equations, predicted, &tangent, Some(bordered), here.scales, steps)?;
    let correction = (0..3).map(|index| ((found[index] - predicted[index]) / here.scales[index]).powi(2)).sum::<f64>().sqrt();
    if correction > LARGEST_CORRECTION * step {
        return Err(jumped("a corrected point is far from its prediction").into());
    }
    let next = point(equations, (found, state), here.arclength + step, Some(here))?;
    let before = rescaled(&tangent, here.scales, next.scales);
    let cosine = before.dot(&Vector3::from(next.tangent)).clamp(-1.0, 1.0);
    if cosine < LARGEST_TURN_COSINE {
        return Err(jumped("the tangent turns too much").into());
    }
    Ok((next, cosine.acos()))
}

fn jumped(detail: &str) -> Refusal {
    Refusal::NotConverged { what: "a step along a curve", detail: detail.into() }
}

/// A tangent in other scales, of unit length again.
fn rescaled(tangent: &Vector3<f64>, from: [f64; 3], to: [f64; 3]) -> Vector3<f64> {
    Vector3::from_fn(|index, _| tangent[index] * from[index] / to[index]).normalize()
}

/// The solution in the plane through a predicted point across a tangent.
fn across<E: CurveEquations>(
    equations: &E,
    predicted: [f64; 3],
    tangent: &Vector3<f64>,
    bordered: Option<Matrix3<f64>>,
    scales: [f64; 3],
    steps: &Steps,
) -> Result<([f64; 3], Evaluated<E::State>), Refusal> {
    let evaluate = |unknowns: [f64; 3]| {
        let found = equations.evaluate(unknowns)?;
        let off = (0..3).map(|index| tangent[index] * (unknowns[index] - predicted[index]) / scales[index]).sum::<f64>();
        let [first, second] = found.residual;
        Ok((found, [first, second, off]))
    };
    let system = ThreeEquations {
        what: "a point of a curve",
        evaluate: &evaluate,
        scales,
        differences: equations.differences(predicted),
        rounding: 10.0 * steps.tolerance,
    };
    let found = system.solve(predicted, bordered, steps.tolerance)?;
    Ok((found.unknowns, found.solution))
}

/// A checked point with its tangent, along that of the point before.
fn point<E: CurveEquations>(
    equations: &E,
    (unknowns, found): ([f64; 3], Evaluated<E::State>),
    arclength: f64,
    before: Option<&CurvePoint<E::State>>,
) -> Result<CurvePoint<E::State>, Failure<E::State>> {
    if !equations.admissible(&found.state)? {
        return Err(Failure::Inadmissible(Box::new(found.state)));
    }
    let (rows, mut tangent) = linearized(equations, unknowns, &found)?;
    let scales = equations.scales(unknowns);
    if let Some(before) = before
        && rescaled(&Vector3::from(before.tangent), before.scales, scales).dot(&tangent) < 0.0
    {
        tangent = -tangent;
    }
    Ok(CurvePoint { unknowns, watched: found.watched, state: found.state, scales, tangent: tangent.into(), rows, arclength })
}

/// Where a curve was landed on: the unknowns, and what the equations gave there.
pub type Landed<S> = ([f64; 3], Evaluated<S>);

/// The point of a curve between two of its points where a quantity has a value, by Newton's method from the chord.
///
/// # Errors
/// [`Refusal::NotConverged`]; also if the point found is not between the two.
pub fn landed<E: CurveEquations>(
    equations: &E,
    (from, to): (&CurvePoint<E::State>, &CurvePoint<E::State>),
    quantity: Quantity,
    value: f64,
    tolerance: f64,
) -> Result<Landed<E::State>, Refusal> {
    let (begin, end) = (from.value(quantity), to.value(quantity));
    let part = ((value - begin) / (end - begin)).clamp(0.0, 1.0);
    let start: [f64; 3] = std::array::from_fn(|index| from.unknowns[index] + part * (to.unknowns[index] - from.unknowns[index]));
    let span = (end - begin).abs().max(f64::MIN_POSITIVE);
    let scales = equations.scales(start);
    let evaluate = |unknowns: [f64; 3]| {
        let found = equations.evaluate(unknowns)?;
        let [first, second] = found.residual;
        let off = (quantity.of(unknowns, found.watched) - value) / span;
        Ok((found, [first, second, off]))
    };
    let system = ThreeEquations {
        what: "a point of a curve",
        evaluate: &evaluate,
        scales,
        differences: equations.differences(start),
        rounding: 100.0 * tolerance,
    };
    let found = system.solve(start, None, tolerance)?;
    let far = (0..3).map(|index| ((found.unknowns[index] - start[index]) / scales[index]).abs()).fold(0.0, f64::max);
    if far > 2.0 * (to.arclength - from.arclength).abs() {
        return Err(jumped("the point found is not between the two it was looked for"));
    }
    if !equations.admissible(&found.solution.state)? {
        return Err(unphysical());
    }
    Ok((found.unknowns, found.solution))
}
