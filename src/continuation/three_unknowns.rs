//! Three equations in three unknowns: the bordered systems of a curve (two equations and what places a point on it).
//!
//! Newton's method in scaled unknowns with a Jacobian by differences or from a neighbouring point, corrected by what each step shows
//! (Broyden), as in [`super::two_unknowns`].

use crate::refusal::Refusal;
use nalgebra::{Matrix3, Vector3};

/// Steps before giving up.
const MOST_STEPS: u32 = 40;
/// Halvings of one step.
const MOST_HALVINGS: u32 = 8;
/// Longest step in scaled unknowns.
const LONGEST: f64 = 0.33;

/// Three equations with the scales of their unknowns.
pub struct ThreeEquations<'a, T> {
    /// What they are, for refusals.
    pub what: &'static str,
    /// The residuals, of order one away from the solution, and what came with them.
    pub evaluate: &'a dyn Fn([f64; 3]) -> Result<(T, [f64; 3]), Refusal>,
    /// What each unknown is measured in.
    pub scales: [f64; 3],
    /// Steps of the difference quotients, in scaled unknowns.
    pub differences: [f64; 3],
    /// A residual below this that does not fall any more is rounding.
    pub rounding: f64,
}

/// A solution with its cost.
#[derive(Debug, Clone)]
pub struct ThreeSolution<T> {
    /// The unknowns.
    pub unknowns: [f64; 3],
    /// What the equations gave there.
    pub solution: T,
    /// The largest residual.
    pub residual: f64,
    /// ∂residual/∂scaled unknown in its last state, if one was formed.
    pub jacobian: Option<Matrix3<f64>>,
    /// How often the equations were evaluated.
    pub evaluations: u32,
}

impl<T> ThreeEquations<'_, T> {
    /// The solution near `start`, to a `tolerance` of all residuals; `jacobian` is one from nearby.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`]; or the refusal of the equations at the start.
    pub fn solve(&self, start: [f64; 3], jacobian: Option<Matrix3<f64>>, tolerance: f64) -> Result<ThreeSolution<T>, Refusal> {
        let (mut unknowns, mut jacobian) = (start, jacobian);
        let mut evaluations = 1;
        let (mut solution, first) = (self.evaluate)(unknowns)?;
        let mut here = Vector3::from(first);
        let (mut fresh, mut stuck) = (false, false);
        for _ in 0..MOST_STEPS {
            let size = largest(&here);
            if size <= tolerance || stuck {
                return Ok(ThreeSolution { unknowns, solution, residual: size, jacobian, evaluations });
            }
            let matrix = if let Some(matrix) = jacobian {
                matrix
            } else {
                fresh = true;
                evaluations += 3;
                self.jacobian(unknowns, &here)?
            };
            jacobian = Some(matrix);
            let step = matrix.lu().solve(&here).filter(|step| step.iter().all(|part| part.is_finite()));
            let Some(step) = step else {
                if fresh {
                    return Err(self.failed("the Jacobian is singular".into()));
                }
                jacobian = None;
                continue;
            };
            let mut part = (LONGEST / step.amax().max(f64::MIN_POSITIVE)).min(1.0);
            let mut improved = false;
            for _ in 0..if fresh { MOST_HALVINGS } else { 1 } {
                let moved = step * -part;
                let tried = self.displaced(unknowns, &moved);
                evaluations += 1;
                match (self.evaluate)(tried) {
                    Ok((found, residual)) if largest(&Vector3::from(residual)) < size => {
                        let there = Vector3::from(residual);
                        // Below rounding a step that hardly helps tells nothing of the derivatives; if they are true ones, no further step helps either.
                        let slow = largest(&there) > 0.5 * size;
                        let lost = slow && size <= self.rounding;
                        stuck = lost && fresh;
                        jacobian = if slow && part >= 1.0 && !stuck {
                            None
                        } else if lost {
                            Some(matrix)
                        } else {
                            let missed = there - here - matrix * moved;
                            Some(matrix + missed * moved.transpose() / moved.norm_squared())
                        };
                        fresh = false;
                        (unknowns, here, solution) = (tried, there, found);
                        improved = true;
                        break;
                    }
                    _ => part *= 0.5,
                }
            }
            if !improved {
                if size <= self.rounding {
                    return Ok(ThreeSolution { unknowns, solution, residual: size, jacobian, evaluations });
                }
                if fresh {
                    return Err(self.failed(format!("a residual of {size:.1e} does not fall any more")));
                }
                jacobian = None;
            }
        }
        Err(self.failed(format!("{MOST_STEPS} Newton steps were not enough")))
    }

    /// ∂residual/∂scaled unknown by differences; three evaluations.
    ///
    /// # Errors
    /// Those of the equations.
    pub fn jacobian(&self, unknowns: [f64; 3], here: &Vector3<f64>) -> Result<Matrix3<f64>, Refusal> {
        let mut matrix = Matrix3::zeros();
        for index in 0..3 {
            let mut moved = Vector3::zeros();
            let difference = self.differences.get(index).copied().unwrap_or(f64::NAN);
            moved[index] = difference;
            let (_, there) = (self.evaluate)(self.displaced(unknowns, &moved))?;
            matrix.set_column(index, &((Vector3::from(there) - here) / difference));
        }
        Ok(matrix)
    }

    fn displaced(&self, unknowns: [f64; 3], scaled: &Vector3<f64>) -> [f64; 3] {
        let [first, second, third] = unknowns;
        let [one, two, three] = self.scales;
        [first + scaled[0] * one, second + scaled[1] * two, third + scaled[2] * three]
    }

    fn failed(&self, detail: String) -> Refusal {
        Refusal::NotConverged { what: self.what, detail }
    }
}

/// The largest magnitude; a NaN is the largest of all.
fn largest(residual: &Vector3<f64>) -> f64 {
    residual.iter().fold(0.0, |worst: f64, part| if part.is_nan() { f64::INFINITY } else { worst.max(part.abs()) })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn three_surfaces_meet_where_they_do() {
        // x = 1, y = 2, z = 3e-3.
        let evaluate = |[x, y, z]: [f64; 3]| Ok(((), [x * y - 2.0, y + x - 3.0, z * 1e3 * x - 3.0]));
        let equations =
            ThreeEquations { what: "test", evaluate: &evaluate, scales: [1.0, 1.0, 1e-3], differences: [1e-7; 3], rounding: 1e-12 };
        let found = equations.solve([0.8, 2.1, 1e-3], None, 1e-14).unwrap();
        for (unknown, exact) in found.unknowns.iter().zip([1.0, 2.0, 3e-3]) {
            assert!((unknown / exact - 1.0).abs() < 1e-12, "{:?}", found.unknowns);
        }
        assert!(found.evaluations < 25, "{}", found.evaluations);
    }
}
