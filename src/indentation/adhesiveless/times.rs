//! When a chain leaves contact or is touched, as the zero of its own S.

use super::drive::{Drive, Moment};
use super::line::Line;

/// Iterations of a bracketed root.
const MOST_ITERATIONS: u32 = 100;

/// When a chain in contact with u_i (now) leaves: `moment` is then set to it.
pub(super) fn leaving(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], by: f64, guess: f64, moment: &mut Moment) -> f64 {
    let chain = line.chain;
    let soft = chain.relaxed / chain.glassy;
    let mut pressing = |time: f64, moment: &mut Moment| {
        moment.set(chain, drive, time);
        let (mut value, mut slope) = (soft * (moment.depth - height), moment.rate);
        for ((&(modulus, rho), u), (kept, gained)) in chain.maxwell.iter().zip(state).zip(moment.kept.iter().zip(&moment.gained)) {
            let share = modulus / chain.glassy * (u * kept + gained);
            value += share;
            slope -= share / rho;
        }
        (-value, -slope)
    };
    rising_zero(by, guess, moment, &mut pressing)
}

/// When a free chain with e_j (now) touches: `moment` is then set to it.
pub(super) fn touching(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], guess: f64, moment: &mut Moment) -> f64 {
    let chain = line.chain;
    let mut overlap = |time: f64, moment: &mut Moment| {
        moment.set_free(chain, drive, time);
        let (mut value, mut slope) = (moment.depth - height, moment.rate);
        for ((&(rate, _), e), kept) in chain.voigt.iter().zip(state).zip(&moment.recovered) {
            value -= e * kept;
            slope += rate * e * kept;
        }
        (value, slope)
    };
    rising_zero(drive.duration, guess, moment, &mut overlap)
}

/// The time of 0…`by` at which a function rises through zero, by Newton's steps within a bracket.
fn rising_zero(by: f64, guess: f64, moment: &mut Moment, function: &mut dyn FnMut(f64, &mut Moment) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, by);
    let mut time = if guess > 0.0 && guess < by { guess } else { by };
    let (mut step, mut last_step) = (by, by);
    for _ in 0..MOST_ITERATIONS {
        let (value, slope) = function(time, moment);
        if value == 0.0 {
            return time;
        }
        if value > 0.0 {
            high = time;
        } else {
            low = time;
        }
        if time >= by && value < 0.0 {
            // Rounding alone keeps it from being passed.
            return by;
        }
        if high - low <= f64::EPSILON * high {
            break;
        }
        let newton = time - value / slope;
        // Where Newton's steps do not halve, the bracket is.
        let fine = newton > low && newton < high && (newton - time).abs() < 0.5 * last_step;
        let next = if fine {
            newton
        } else if low == 0.0 && high > 0.0 {
            // Times may be far shorter than the stretch.
            0.1 * high
        } else {
            0.5 * (low + high)
        };
        last_step = step;
        step = (next - time).abs();
        if step <= 0.5 * f64::EPSILON * time {
            break;
        }
        time = next;
        if high <= 1e-25 * by {
            time = 0.0;
            function(time, moment);
            break;
        }
    }
    if (moment.time - time).abs() > 0.0 {
        function(time, moment);
    }
    time
}
