//! A change of sign: near a guess, or in a bracket.

/// Corrections at most; from a good guess three settle.
const MOST_SECANTS: u32 = 8;

/// A correction of this part of the value leaves less than an ulp: it is the square of the one before that is left.
const SETTLED: f64 = 1e-12;

/// The zero in 0…`upper` near a guess, by secants from a slope that the function knows roughly (value, slope); none if they leave or wander.
pub(super) fn near<C>(upper: f64, guess: f64, function: impl Fn(f64, &mut C) -> [f64; 2], context: &mut C) -> Option<f64> {
    let [mut value, mut slope] = function(guess, context);
    let mut x = guess;
    for _ in 0..MOST_SECANTS {
        if value.abs() <= f64::EPSILON {
            return Some(x);
        }
        let next = x - value / slope;
        if !(next > 0.0 && next <= upper) {
            return None;
        }
        if (next - x).abs() <= SETTLED * x {
            return Some(next);
        }
        let [after, _] = function(next, context);
        let secant = (after - value) / (next - x);
        if !(secant * slope > 0.0 && after.abs() < value.abs()) {
            return None;
        }
        (x, value, slope) = (next, after, secant);
    }
    None
}

/// The place in 0…`upper` where a function negative at 0 and positive at `upper` changes sign: the rule of Anderson and Björck (1973,
/// BIT 13, 253) with halving as its safeguard.
pub(super) fn bracketed<C>(upper: f64, guess: f64, function: impl Fn(f64, &mut C) -> f64, context: &mut C) -> f64 {
    bracketed_to(2.0 * f64::EPSILON, upper, guess, function, context)
}

/// The same, to a part of itself.
pub(super) fn bracketed_to<C>(part: f64, upper: f64, guess: f64, function: impl Fn(f64, &mut C) -> f64, context: &mut C) -> f64 {
    let (mut low, mut high) = (0.0, upper);
    let (mut f_low, mut f_high) = (f64::NAN, f64::NAN);
    let mut x = if guess > 0.0 && guess < upper { guess } else { 0.5 * upper };
    let (mut slow, mut last_below) = (0, None);
    for _ in 0..200 {
        let width = high - low;
        let value = function(x, context);
        if value.abs() <= f64::EPSILON {
            return x;
        }
        // The end that is kept twice running is weighed less.
        let (kept, passed) = if value < 0.0 { (&mut f_high, &mut f_low) } else { (&mut f_low, &mut f_high) };
        if last_below == Some(value < 0.0) && kept.is_finite() {
            let factor = 1.0 - value / *passed;
            *kept *= if factor > 0.0 { factor } else { 0.5 };
        }
        last_below = Some(value < 0.0);
        *passed = value;
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        if high - low <= part * high {
            return high;
        }
        slow = if high - low > 0.5 * width { slow + 1 } else { 0 };
        let known = f_low.is_finite() && f_high.is_finite();
        x = if known && slow <= 3 { low + (high - low) * (f_low / (f_low - f_high)) } else { 0.5 * (low + high) };
        if slow > 3 {
            slow = 0;
        }
        if x <= low || x >= high {
            x = 0.5 * (low + high);
        }
        if x <= low || x >= high {
            return high;
        }
    }
    0.5 * (low + high)
}
