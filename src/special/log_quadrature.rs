//! Quadrature over (0, 1) of a function with power-law ends and layers at any scale near either end.
//!
//! # What it does
//! ```text
//! ∫₀¹ f dt = ∫ f(t(τ)) t(1−t) dτ,      t = 1/(1 + e^{−τ}),  1 − t = 1/(1 + e^{τ})
//! ```
//! by the trapezoidal rule in τ, halving the step. A layer at distance ε from an end becomes a feature of width one at τ = ln ε, whatever
//! ε: that is why this map is used, and not the double-exponential one, which squeezes such layers into ever narrower features. The rule
//! converges exponentially in 1/step for fields that are analytic in the logarithm of the distance: halving the step squares the error.
//!
//! # Range
//! The integrand t(1−t)f must fall at least like √t at both ends (1/√d times √d′ does).

use crate::refusal::Refusal;

/// The value of an integral with its error and cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// The integral.
    pub value: f64,
    /// Bound on its absolute error from truncation and rounding.
    pub error: f64,
    /// Evaluations of the integrand.
    pub evaluations: u64,
}

/// The coarsest step in τ: a quarter of the half-width π of the strip in which the map itself is analytic.
const FIRST_STEP: f64 = 0.8;
/// The finest step is `FIRST_STEP`/2⁵ = 0.025; a smooth pair of fields needs 0.2 for 1e-15.
const MOST_HALVINGS: u32 = 5;
/// |τ| beyond which √t is below 1e-17.
const HALF_RANGE: f64 = 80.0;

/// ∫₀¹ f(t, 1 − t) dt to a relative `tolerance`; both arguments are passed with full relative accuracy.
///
/// # Errors
/// [`Refusal::NotConverged`] when the integrand is not finite, or the tolerance is not reached (a kink, noise).
pub fn integrate_between_edges(mut function: impl FnMut(f64, f64) -> f64, tolerance: f64) -> Result<Integral, Refusal> {
    let what = "a quadrature with power-law ends";
    let mut evaluations = 0;
    let mut sum_of = |offset: f64, step: f64| -> f64 {
        let mut sum = 0.0;
        let count = (HALF_RANGE / step) as i64;
        for index in -count..=count {
            let tau = offset + step * index as f64;
            // The smaller of t and 1 − t by a decaying exponential, the other as its complement.
            let decaying = (-tau.abs()).exp();
            let (small, large) = (decaying / (1.0 + decaying), 1.0 / (1.0 + decaying));
            let (left, right) = if tau < 0.0 { (small, large) } else { (large, small) };
            sum += function(left, right) * small * large;
            evaluations += 1;
        }
        sum
    };
    let mut step = FIRST_STEP;
    let mut sum = sum_of(0.0, step);
    let mut last_change = f64::INFINITY;
    for _ in 0..MOST_HALVINGS {
        let coarse = sum * step;
        sum += sum_of(0.5 * step, step);
        step *= 0.5;
        let value = sum * step;
        if !value.is_finite() {
            return Err(Refusal::NotConverged { what, detail: "the integrand is not finite inside its range".into() });
        }
        let change = (value - coarse).abs();
        // The error squares at every halving; a factor of ten covers the constant. Where the last change did not square (a kink,
        // noise), the change itself bounds the error.
        let squared = 10.0 * change * change / value.abs().max(f64::MIN_POSITIVE);
        let squares = change <= 100.0 * last_change * last_change / value.abs().max(f64::MIN_POSITIVE);
        let truncation = if squares { squared.min(change) } else { change };
        last_change = change;
        if truncation <= tolerance * value.abs() || value == 0.0 {
            let rounding = 4.0 * f64::EPSILON * value.abs();
            return Ok(Integral { value, error: truncation + rounding, evaluations });
        }
    }
    Err(Refusal::NotConverged { what, detail: format!("a change of {last_change:e} remains at step {step}") })
}
