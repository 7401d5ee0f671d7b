//! One safeguarded root of a function of a positive unknown.
//!
//! # What it does
//! Finds the sign change of an increasing function inside a bracket 0 < lower < upper, by Newton steps in the logarithm of the unknown,
//! replaced by a geometric bisection whenever a step leaves the bracket or fails to shrink it. The unknown is updated by
//! multiplication, so that it is known to its last digits whatever its magnitude (a step in ln x stored as ln x would lose them).
//!
//! # How it ends
//! When a Newton step is below the tolerance (its size is returned as the error), when the bracket has closed to two neighbouring
//! numbers, or, as a refusal, after [`MOST_EVALUATIONS`].

use crate::refusal::Refusal;

/// Bisection alone closes a bracket of 600 decades to one ulp in 64 steps; Newton needs four to eight.
pub const MOST_EVALUATIONS: u32 = 200;

/// A root with the evidence that it is one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// The unknown at the root, positive.
    pub argument: f64,
    /// Bound on |argument − root| / root from the last step or the bracket; rounding of the function itself is not in it.
    pub relative_error: f64,
    /// How often the function was evaluated.
    pub evaluations: u32,
}

/// The value of a function and its derivative with respect to the LOGARITHM of its argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogSlope {
    /// The function.
    pub value: f64,
    /// d value / d ln(argument).
    pub slope: f64,
}

/// The root of an increasing function in `[lower, upper]`, starting at `start` (moved into the bracket), to a relative `tolerance`.
///
/// The caller guarantees the sign change. Where rounding moves it past an end of the bracket (a limit value is asked for), that end
/// is returned; so the caller that cannot guarantee it checks the ends first.
///
/// # Errors
/// [`Refusal::OutOfRange`] for an empty bracket; [`Refusal::NotConverged`] when the function is not a number, or when no root was
/// closed in on within [`MOST_EVALUATIONS`].
pub(crate) fn increasing_root(
    what: &'static str,
    mut function: impl FnMut(f64) -> LogSlope,
    [lower, upper]: [f64; 2],
    start: f64,
    tolerance: f64,
) -> Result<Root, Refusal> {
    if !(lower > 0.0 && upper >= lower && upper.is_finite()) {
        return Err(Refusal::out_of_range(what, lower, "a bracket 0 < lower <= upper < infinity"));
    }
    let (mut low, mut high) = (lower, upper);
    let mut x = if start >= low && start <= high { start } else { geometric_mean(low, high) };
    let tolerance = tolerance.max(f64::EPSILON);
    let mut last_step = f64::INFINITY;
    for evaluations in 1..=MOST_EVALUATIONS {
        let LogSlope { value, slope } = function(x);
        if value.is_nan() {
            return Err(Refusal::NotConverged { what, detail: format!("the function is not a number at {x:e}") });
        }
        if value == 0.0 {
            return Ok(Root { argument: x, relative_error: f64::EPSILON, evaluations });
        }
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let width = (high / low).ln();
        let step = if slope > 0.0 { -value / slope } else { f64::NAN };
        let newton = x * step.exp();
        // A Newton step may end exactly on a bracket's end, hence the closed comparison.
        let admissible = newton >= low && newton <= high && step.abs() <= 0.6 * last_step;
        if admissible && step.abs() <= tolerance {
            return Ok(Root { argument: newton, relative_error: step.abs().max(f64::EPSILON), evaluations });
        }
        if width <= 2.0 * f64::EPSILON {
            return Ok(Root { argument: x, relative_error: width.max(f64::EPSILON), evaluations });
        }
        let next = if admissible { newton } else { geometric_mean(low, high) };
        // After a bisection any Newton step is welcome again.
        last_step = if admissible { step.abs() } else { f64::INFINITY };
        if next.to_bits() == x.to_bits() {
            return Ok(Root { argument: x, relative_error: width.min(4.0 * f64::EPSILON), evaluations });
        }
        x = next;
    }
    Err(Refusal::NotConverged { what, detail: format!("the bracket is still [{low:e}, {high:e}] after {MOST_EVALUATIONS} evaluations") })
}

/// √(low·high) without overflow or underflow.
fn geometric_mean(low: f64, high: f64) -> f64 {
    low.sqrt() * high.sqrt()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn finds_roots_of_every_magnitude_in_few_evaluations() {
        for exponent in [-300, -20, 0, 20, 300] {
            let root = 10f64.powi(exponent) * 1.234_567;
            let found = increasing_root(
                "cubic",
                |x| LogSlope { value: (x / root).powi(3) - 1.0, slope: 3.0 * (x / root).powi(3) },
                [root * 1e-6, root * 1e6],
                root * 3.0,
                1e-15,
            )
            .unwrap();
            assert!((found.argument / root - 1.0).abs() < 1e-15, "{found:?}");
            assert!(found.evaluations < 12, "{found:?}");
        }
    }

    #[test]
    fn a_wrong_slope_costs_steps_and_not_the_root() {
        let found = increasing_root("wrong slope", |x| LogSlope { value: x - 2.0, slope: 1e-3 }, [1e-3, 1e3], 1.0, 1e-14).unwrap();
        assert!((found.argument - 2.0).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn not_a_number_is_refused() {
        assert!(increasing_root("nan", |_| LogSlope { value: f64::NAN, slope: 1.0 }, [1.0, 2.0], 1.5, 1e-9).is_err());
    }

    #[test]
    fn a_root_past_the_end_lands_on_the_end() {
        let above = increasing_root("no root", |x| LogSlope { value: x, slope: x }, [1.0, 2.0], 1.5, 1e-12).unwrap();
        assert!(above.argument <= 1.0 + 1e-12, "{above:?}");
    }
}
