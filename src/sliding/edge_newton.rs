//! Newton's method for the two edges of a contact, whatever the two conditions are.
//!
//! The unknowns are the half-width and the eccentricity; the Jacobian is formed by differences; a step that does not lower the residual is
//! halved, and one that would close the contact or the gap is cut short.

use super::contact::WaveContact;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// Newton steps before giving up.
const MOST_STEPS: u32 = 40;
/// Halvings of one step.
const MOST_HALVINGS: u32 = 12;
/// Step of the difference quotients, relative to the smaller of a and π − a.
const DIFFERENCE: f64 = 1e-6;
/// A residual below this that does not fall any more is rounding.
const ROUNDING: f64 = 1e-9;

/// What an edge condition gives at one pair of edges.
pub(crate) trait EdgeResidual {
    /// The two conditions, of order one away from the solution.
    fn residual(&self) -> [f64; 2];
}

/// A solution with its cost.
pub(crate) struct Edges<T> {
    pub(crate) solution: T,
    pub(crate) residual: f64,
    pub(crate) evaluations: u32,
}

/// The edges near `start` at which both conditions hold to `tolerance`.
///
/// # Errors
/// [`Refusal::NotConverged`]; or the refusal of the condition at the start.
pub(crate) fn solve_edges<T: EdgeResidual>(
    what: &'static str,
    evaluate: impl Fn(WaveContact) -> Result<T, Refusal>,
    start: WaveContact,
    tolerance: f64,
) -> Result<Edges<T>, Refusal> {
    let mut contact = start;
    let mut evaluations = 1;
    let mut here = evaluate(contact)?;
    for _ in 0..MOST_STEPS {
        let size = largest(here.residual());
        if size <= tolerance {
            return Ok(Edges { solution: here, residual: size, evaluations });
        }
        let (width, shift) = newton_step(what, &evaluate, contact, here.residual())?;
        evaluations += 2;
        let room = 0.33 * contact.half_width.min(PI - contact.half_width);
        let mut scale = 1.0_f64.min(room / width.abs().max(f64::MIN_POSITIVE)).min(0.5 / shift.abs().max(f64::MIN_POSITIVE));
        let mut improved = false;
        for _ in 0..MOST_HALVINGS {
            let tried = WaveContact { half_width: contact.half_width + scale * width, eccentricity: contact.eccentricity + scale * shift };
            evaluations += 1;
            match evaluate(tried) {
                Ok(there) if largest(there.residual()) < size => {
                    contact = tried;
                    here = there;
                    improved = true;
                    break;
                }
                _ => scale *= 0.5,
            }
        }
        if !improved {
            if size <= tolerance.max(ROUNDING) {
                return Ok(Edges { solution: here, residual: size, evaluations });
            }
            return Err(Refusal::NotConverged { what, detail: format!("a residual of {size:.1e} does not fall any more") });
        }
    }
    Err(Refusal::NotConverged { what, detail: format!("{MOST_STEPS} Newton steps were not enough") })
}

fn newton_step<T: EdgeResidual>(
    what: &'static str,
    evaluate: &impl Fn(WaveContact) -> Result<T, Refusal>,
    contact: WaveContact,
    here: [f64; 2],
) -> Result<(f64, f64), Refusal> {
    let small = DIFFERENCE * contact.half_width.min(PI - contact.half_width);
    let column = |moved: WaveContact| -> Result<[f64; 2], Refusal> {
        let there = evaluate(moved)?.residual();
        Ok([(there[0] - here[0]) / small, (there[1] - here[1]) / small])
    };
    let width = column(WaveContact { half_width: contact.half_width + small, ..contact })?;
    let shift = column(WaveContact { eccentricity: contact.eccentricity + small, ..contact })?;
    let determinant = width[0] * shift[1] - width[1] * shift[0];
    let step = ((here[1] * shift[0] - here[0] * shift[1]) / determinant, (width[1] * here[0] - width[0] * here[1]) / determinant);
    if step.0.is_finite() && step.1.is_finite() {
        Ok(step)
    } else {
        Err(Refusal::NotConverged { what, detail: "the Jacobian is singular: a fold is near".into() })
    }
}

/// The larger of two residuals; a NaN is the largest of all.
fn largest([first, second]: [f64; 2]) -> f64 {
    if first.is_nan() || second.is_nan() { f64::INFINITY } else { first.abs().max(second.abs()) }
}
