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

/// The coarsest step in τ: half of the half-width π of the strip in which the map itself is analytic. A dyadic number, so that no node
/// is rounded: e^{−τ} at τ = 60 would otherwise be off by 1e-14.
const FIRST_STEP: f64 = 1.5;
/// The finest step is `FIRST_STEP`/2⁶ = 0.023; a smooth pair of fields needs 0.375 for 1e-15.
const MOST_HALVINGS: u32 = 6;
/// |τ| up to which layers are looked for; √t is below 1e-17 beyond.
const HALF_RANGE: f64 = 80.0;
/// |τ| at which the sum stops in any case: √t is 1e-65.
const LONGEST_HALF_RANGE: f64 = 300.0;
/// Beyond `HALF_RANGE` the sum goes on while a summand is above this part of it: at a stiff edge √t comes with a factor β.
const NEGLIGIBLE: f64 = 1e-18;

/// ∫₀¹ f(t, 1 − t) dt to a relative `tolerance`; both arguments are passed with full relative accuracy.
///
/// # Errors
/// [`Refusal::NotConverged`] when the integrand is not finite, or the tolerance is not reached (a kink, noise).
pub fn integrate_between_edges(mut function: impl FnMut(f64, f64) -> f64, tolerance: f64) -> Result<Integral, Refusal> {
    let what = "a quadrature with power-law ends";
    let mut evaluations = 0;
    // The sum and the sum of magnitudes: where the integrand changes sign, rounding is relative to the latter.
    let mut sum_of = |offset: f64, step: f64| -> [f64; 2] {
        let [mut sum, mut magnitude] = [0.0; 2];
        for direction in [1.0, -1.0] {
            let mut tau: f64 = if direction > 0.0 { offset } else { offset - step };
            while tau.abs() < LONGEST_HALF_RANGE {
                // The smaller of t and 1 − t by a decaying exponential, the other as its complement.
                let decaying = (-tau.abs()).exp();
                let (small, large) = (decaying / (1.0 + decaying), 1.0 / (1.0 + decaying));
                let (left, right) = if tau < 0.0 { (small, large) } else { (large, small) };
                let summand = function(left, right) * small * large;
                sum += summand;
                magnitude += summand.abs();
                evaluations += 1;
                if tau.abs() >= HALF_RANGE && summand.abs() <= NEGLIGIBLE * magnitude {
                    break;
                }
                tau += direction * step;
            }
        }
        [sum, magnitude]
    };
    let mut step = FIRST_STEP;
    let [mut sum, mut magnitude] = sum_of(0.0, step);
    let mut last_change = f64::INFINITY;
    for _ in 0..MOST_HALVINGS {
        let coarse = sum * step;
        let [between, between_magnitude] = sum_of(0.5 * step, step);
        sum += between;
        magnitude += between_magnitude;
        step *= 0.5;
        let value = sum * step;
        if !value.is_finite() {
            return Err(Refusal::NotConverged { what, detail: "the integrand is not finite inside its range".into() });
        }
        let change = (value - coarse).abs();
        // With an error C·q at one step, C·q² at the next and C·q⁴ at the one after, the last two changes are C·q and C·q², and
        // change²/last_change = C·q³ bounds the error without knowledge of C, whatever share of the value a narrow layer has. Where the
        // changes do not fall like that (a kink, a jump), their size is all that is known.
        let falls = change <= 0.1 * last_change && last_change.is_finite();
        let truncation = if falls { change.min(10.0 * change * (change / last_change)) } else { 2.0 * change.max(last_change) };
        last_change = change;
        if magnitude == 0.0 {
            return Ok(Integral { value: 0.0, error: 0.0, evaluations });
        }
        if truncation <= tolerance * value.abs() {
            let rounding = 4.0 * f64::EPSILON * magnitude * step;
            return Ok(Integral { value, error: truncation + rounding, evaluations });
        }
    }
    Err(Refusal::NotConverged { what, detail: format!("a change of {last_change:e} remains at step {step}") })
}
