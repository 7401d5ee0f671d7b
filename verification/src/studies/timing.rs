//! Times: the median of several runs of one job on one thread.

use std::hint::black_box;
use std::time::Instant;

/// Runs beyond this time (s) are not repeated once there are enough of them.
const PATIENCE: f64 = 0.25;
/// A median is of at least so many runs, unless one run alone takes longer than [`LONG`].
const FEWEST: usize = 3;
/// See [`FEWEST`] (s).
const LONG: f64 = 1.5;
/// And of at most so many.
const MOST: usize = 15;

/// A job with its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timed<T> {
    /// Median of the runs (s).
    pub seconds: f64,
    /// How many there were.
    pub runs: usize,
    /// What the last one gave.
    pub result: T,
}

/// The median time of a job, and what it gave.
pub fn timed<T>(mut job: impl FnMut() -> T) -> Timed<T> {
    let mut seconds = Vec::new();
    loop {
        let begin = Instant::now();
        let result = black_box(job());
        seconds.push(begin.elapsed().as_secs_f64());
        let spent: f64 = seconds.iter().sum();
        let enough = seconds.len() >= FEWEST && spent > PATIENCE;
        if enough || seconds.len() >= MOST || (seconds.len() == 1 && spent > LONG) {
            return Timed { seconds: median(&mut seconds), runs: seconds.len(), result };
        }
    }
}

/// The median; NaN of nothing.
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match (values.get(middle), values.get(middle.wrapping_sub(1))) {
        (Some(upper), Some(lower)) if values.len().is_multiple_of(2) => 0.5 * (lower + upper),
        (Some(middle), _) => *middle,
        _ => f64::NAN,
    }
}
