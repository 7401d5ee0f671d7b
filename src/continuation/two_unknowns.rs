//! Two equations in two unknowns: Newton's method that forms its Jacobian once and corrects it by what each step shows (Broyden).
//!
//! The Jacobian comes from differences, or from a neighbouring problem. A step that does not lower the residual by half makes the next one
//! start from fresh differences; one that does not lower it at all is halved. A caller's limit keeps steps where the equations mean something.

use crate::refusal::Refusal;

/// Steps before giving up.
const MOST_STEPS: u32 = 60;
/// Halvings of one step.
const MOST_HALVINGS: u32 = 12;
/// A residual below this that does not fall any more is rounding.
const ROUNDING: f64 = 1e-9;

/// ∂residual_i/∂unknown_j as `[i][j]`.
pub type Jacobian = [[f64; 2]; 2];

/// What the equations give at one pair of unknowns.
pub trait TwoResiduals {
    /// The two residuals, of order one away from the solution.
    fn residual(&self) -> [f64; 2];

    /// What rounding leaves uncertain of them: a residual that does not fall below it any more is accepted.
    fn rounding(&self) -> f64 {
        0.0
    }
}

/// Two equations.
pub struct TwoEquations<'a, E, L> {
    /// What they are, for refusals.
    pub what: &'static str,
    /// The residuals at a pair of unknowns.
    pub evaluate: &'a E,
    /// The largest part of a step from a pair of unknowns that may be taken, at most one.
    pub limit: &'a L,
    /// Steps of the difference quotients at a pair of unknowns.
    pub differences: &'a dyn Fn([f64; 2]) -> [f64; 2],
}

/// A solution with its cost.
#[derive(Debug, Clone)]
pub struct Solution<T> {
    /// The unknowns.
    pub unknowns: [f64; 2],
    /// What the equations gave there.
    pub solution: T,
    /// The larger residual.
    pub residual: f64,
    /// The Jacobian in its last state, if one was formed.
    pub jacobian: Option<Jacobian>,
    /// How often the equations were evaluated.
    pub evaluations: u32,
}

impl<T, E, L> TwoEquations<'_, E, L>
where
    T: TwoResiduals,
    E: Fn([f64; 2]) -> Result<T, Refusal>,
    L: Fn([f64; 2], [f64; 2]) -> f64,
{
    /// The solution near `start`, to a `tolerance` of both residuals.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`]; or the refusal of the equations at the start.
    pub fn solve(&self, start: [f64; 2], jacobian: Option<Jacobian>, tolerance: f64) -> Result<Solution<T>, Refusal> {
        let (mut unknowns, mut jacobian) = (start, jacobian);
        let mut evaluations = 1;
        let mut here = (self.evaluate)(unknowns)?;
        // A Jacobian from elsewhere, or one that many steps have corrected, is not held responsible for a failure.
        let mut fresh = false;
        for _ in 0..MOST_STEPS {
            let size = largest(here.residual());
            if size <= tolerance {
                return Ok(Solution { unknowns, solution: here, residual: size, jacobian, evaluations });
            }
            let matrix = match jacobian {
                Some(matrix) => matrix,
                None => {
                    fresh = true;
                    evaluations += 2;
                    self.jacobian(unknowns, here.residual())?
                }
            };
            jacobian = Some(matrix);
            let Some(step) = solve_two_by_two(&matrix, here.residual()) else {
                if fresh {
                    return Err(self.failed("the Jacobian is singular: a fold is near".into()));
                }
                jacobian = None;
                continue;
            };
            let mut scale = (self.limit)(unknowns, step).min(1.0);
            let mut improved = false;
            for _ in 0..if fresh { MOST_HALVINGS } else { 1 } {
                let moved = [scale * step[0], scale * step[1]];
                let tried = [unknowns[0] - moved[0], unknowns[1] - moved[1]];
                evaluations += 1;
                match (self.evaluate)(tried) {
                    Ok(there) if largest(there.residual()) < size => {
                        let new = largest(there.residual());
                        jacobian = if new > 0.5 * size && scale >= 1.0 {
                            None
                        } else {
                            Some(broyden(&matrix, [-moved[0], -moved[1]], here.residual(), there.residual(), (self.differences)(unknowns)))
                        };
                        fresh = false;
                        unknowns = tried;
                        here = there;
                        improved = true;
                        break;
                    }
                    _ => scale *= 0.5,
                }
            }
            if !improved {
                if size <= tolerance.max(ROUNDING).max(here.rounding()) {
                    return Ok(Solution { unknowns, solution: here, residual: size, jacobian, evaluations });
                }
                if fresh {
                    return Err(self.failed(format!("a residual of {size:.1e} does not fall any more")));
                }
                jacobian = None;
            }
        }
        Err(self.failed(format!("{MOST_STEPS} Newton steps were not enough")))
    }

    /// The Jacobian by differences; two evaluations.
    ///
    /// # Errors
    /// Those of the equations.
    pub fn jacobian(&self, unknowns: [f64; 2], here: [f64; 2]) -> Result<Jacobian, Refusal> {
        let small = (self.differences)(unknowns);
        let column = |index: usize| -> Result<[f64; 2], Refusal> {
            let mut moved = unknowns;
            moved[index] += small[index];
            // Of a large unknown with a small step: what the step has become.
            let step = moved[index] - unknowns[index];
            let there = (self.evaluate)(moved)?.residual();
            Ok([(there[0] - here[0]) / step, (there[1] - here[1]) / step])
        };
        let (first, second) = (column(0)?, column(1)?);
        Ok([[first[0], second[0]], [first[1], second[1]]])
    }

    fn failed(&self, detail: String) -> Refusal {
        Refusal::NotConverged { what: self.what, detail }
    }
}

/// The solution of a 2 × 2 system; none if it is not finite.
#[must_use]
pub(crate) fn solve_two_by_two(matrix: &Jacobian, right: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
    let solution = [
        (right[0] * matrix[1][1] - right[1] * matrix[0][1]) / determinant,
        (matrix[0][0] * right[1] - matrix[1][0] * right[0]) / determinant,
    ];
    solution.iter().all(|value| value.is_finite()).then_some(solution)
}

/// Broyden's correction of the Jacobian after a step, in unknowns scaled by their difference steps.
fn broyden(matrix: &Jacobian, step: [f64; 2], before: [f64; 2], after: [f64; 2], scales: [f64; 2]) -> Jacobian {
    let weighted = [step[0] / (scales[0] * scales[0]), step[1] / (scales[1] * scales[1])];
    let norm = step[0] * weighted[0] + step[1] * weighted[1];
    let mut corrected = *matrix;
    if norm > 0.0 && norm.is_finite() {
        for (row, (before, after)) in corrected.iter_mut().zip(before.iter().zip(after)) {
            let missed = after - before - row[0] * step[0] - row[1] * step[1];
            row[0] += missed * weighted[0] / norm;
            row[1] += missed * weighted[1] / norm;
        }
    }
    corrected
}

/// The larger of two residuals; a NaN is the largest of all.
#[must_use]
pub fn largest([first, second]: [f64; 2]) -> f64 {
    if first.is_nan() || second.is_nan() { f64::INFINITY } else { first.abs().max(second.abs()) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    struct Pair([f64; 2]);
    impl TwoResiduals for Pair {
        fn residual(&self) -> [f64; 2] {
            self.0
        }
    }

    #[test]
    fn a_circle_and_a_parabola_meet_where_they_do() {
        // x² + y² = 2, y = x²: (1, 1).
        let evaluate = |[x, y]: [f64; 2]| Ok(Pair([x * x + y * y - 2.0, y - x * x]));
        let equations = TwoEquations { what: "test", evaluate: &evaluate, limit: &|_, _| 1.0, differences: &|_| [1e-7, 1e-7] };
        for start in [[2.0, 3.0], [0.5, 0.1], [9.0, 0.2]] {
            let found = equations.solve(start, None, 1e-14).unwrap();
            assert!(
                (found.unknowns[0] - 1.0).abs() < 1e-13 && (found.unknowns[1] - 1.0).abs() < 1e-13,
                "{found:?}",
                found = found.unknowns
            );
            assert!(found.evaluations < 25, "{}", found.evaluations);
        }
        // A Jacobian from elsewhere saves the differences; a wrong one is replaced.
        let right = equations.solve([1.01, 1.0], Some([[2.0, 2.0], [-2.0, 1.0]]), 1e-13).unwrap();
        assert!(right.evaluations <= 6, "{}", right.evaluations);
        let wrong = equations.solve([1.01, 1.0], Some([[-2.0, 2.0], [2.0, 1.0]]), 1e-13).unwrap();
        assert!((wrong.unknowns[0] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn equations_without_a_solution_are_refused() {
        let evaluate = |[x, y]: [f64; 2]| Ok(Pair([x * x + 1.0, y]));
        let equations = TwoEquations { what: "test", evaluate: &evaluate, limit: &|_, _| 1.0, differences: &|_| [1e-7, 1e-7] };
        assert!(matches!(equations.solve([1.0, 1.0], None, 1e-12), Err(Refusal::NotConverged { .. })));
    }
}
