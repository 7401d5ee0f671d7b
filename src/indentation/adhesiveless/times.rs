//! When a chain leaves contact or is touched, as the zero of its own S.

use super::drive::{Drive, decayed};
use super::line::Line;
use super::moment::Moment;

/// Iterations of a bracketed root.
const MOST_ITERATIONS: u32 = 100;
/// A step over the time that differs from none, with a margin; over what series leave.
const SETTLED: f64 = 0.01 * f64::EPSILON;
const OF_SERIES: f64 = 1e-3;

/// When a chain in contact with u_i (now) leaves: `moment` is then set to it.
pub(super) fn leaving(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], by: f64, guess: f64, moment: &mut Moment) -> f64 {
    let chain = line.chain;
    moment.prepare(chain, drive);
    let time = rising_zero(by, guess, (OF_SERIES * line.tolerance).max(SETTLED), |time| {
        let (value, slope) = moment.pressing(chain, drive, height, state, time);
        (-value, -slope)
    });
    moment.set_at(chain, drive, time);
    time
}

/// When a free chain with e_j (now) touches, at most at a time.
pub(super) fn touching(line: &Line<'_>, drive: &Drive, height: f64, state: &[f64], by: f64, guess: f64) -> f64 {
    let chain = line.chain;
    rising_zero(by, guess, (OF_SERIES * line.tolerance).max(SETTLED), |time| {
        let (mut value, mut slope) = (drive.value(time) - height, drive.rate(time));
        for (&(rate, _), e) in chain.voigt.iter().zip(state) {
            // What has recovered counts no more.
            if *e != 0.0 {
                let left = e * decayed(rate * time);
                value -= left;
                slope += rate * left;
            }
        }
        (value, slope)
    })
}

/// Times of chain after chain along an interval, each of which is guessed from those before it: they are smooth from place to place of its grid.
#[derive(Default)]
pub(super) struct Guesses {
    place: f64,
    /// The latest first.
    times: [f64; 4],
    known: usize,
}

impl Guesses {
    pub(super) fn next(&mut self, place: f64) -> f64 {
        // Places fall, or stand still, where another interval begins.
        if place <= self.place {
            self.known = self.known.min(1);
        }
        self.place = place;
        let [last, second, third, fourth] = self.times;
        match self.known {
            0 | 1 => last,
            2 => 2.0 * last - second,
            3 => 3.0 * (last - second) + third,
            _ => 4.0 * (last + third) - 6.0 * second - fourth,
        }
    }

    pub(super) fn found(&mut self, time: f64) {
        let [last, second, third, _] = self.times;
        self.times = [time, last, second, third];
        self.known += 1;
    }
}

/// The time of 0…`by` at which a function rises through zero, by Newton's steps within a bracket.
fn rising_zero(by: f64, guess: f64, settled: f64, mut function: impl FnMut(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, by);
    let mut time = if guess > 0.0 && guess < by { guess } else { by };
    let (mut step, mut last_step, mut newtons) = (by, by, false);
    for _ in 0..MOST_ITERATIONS {
        let (value, slope) = function(time);
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
            // Times may be far shorter than the interval.
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
        // Newton's next step would be as much smaller as the square of this one's part of the last one.
        if fine && newtons && step * (step / last_step).powi(2) <= settled * time {
            break;
        }
        newtons = fine;
        if high <= 1e-25 * by {
            return 0.0;
        }
    }
    time
}
