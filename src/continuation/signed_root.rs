//! One safeguarded root of a monotone function of an unknown that may have either sign.
//!
//! Newton's step kept inside a shrinking bracket. For a positive unknown that may span many decades use [`super::root`], which works in its
//! logarithm and returns the evidence; this one is for unknowns that pass through zero, such as a logarithm itself.

use crate::refusal::Refusal;

/// Newton steps or halvings before giving up. A bracket of two neighbouring decades of doubles needs at most about 60 halvings and
/// the widest bracket of finite doubles about 1100; well-posed calls take fewer than 15 steps.
const MAX_STEPS: usize = 1200;

/// The root of a function that is negative at `below` and positive at `above` (in either order on the axis), and monotone between.
///
/// The two end values are taken on trust and never evaluated: an end that is itself the root, spoilt by rounding, is then approached
/// and returned instead of refused. `function` gives the value and the derivative. Ends when a step no longer changes the point by more
/// than one unit in the last place, which is the accuracy of the root as far as the function's own rounding allows.
pub(crate) fn signed_root(
    what: &'static str,
    below: f64,
    above: f64,
    start: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> Result<f64, Refusal> {
    let (mut below, mut above, mut point) = (below, above, start);
    let mut last_step = (above - below).abs();
    for _ in 0..MAX_STEPS {
        let (value, slope) = function(point);
        if value.is_nan() {
            return Err(Refusal::NotConverged { what, detail: format!("the residual is not a number at {point:e}") });
        }
        if value == 0.0 {
            return Ok(point);
        }
        if value < 0.0 {
            below = point;
        } else {
            above = point;
        }
        let newton = point - value / slope;
        let inside = newton > below.min(above) && newton < below.max(above);
        // A Newton step that fails to halve the one before is not converging yet: halve the bracket instead (Dekker's safeguard).
        let next = if inside && (newton - point).abs() <= 0.5 * last_step { newton } else { 0.5 * (below + above) };
        last_step = (next - point).abs();
        if last_step <= f64::EPSILON * next.abs() {
            return Ok(next);
        }
        point = next;
    }
    Err(Refusal::NotConverged { what, detail: format!("the bracket [{below:e}, {above:e}] stopped shrinking") })
}
