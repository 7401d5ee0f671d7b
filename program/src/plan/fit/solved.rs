//! Models that were solved lately: the rounds of a fit ask for the same numbers again, and where coarse and fine tolerance are one, so do its descents.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Numbers that are kept, of all models together: 16 MB.
const MOST_NUMBERS: usize = 1 << 21;

/// Bits of the parameters and of the tolerance, and the model there.
type One = (Vec<u64>, Result<Vec<f64>, String>);

/// The latest models, and how many were solved.
#[derive(Debug, Default)]
pub(super) struct Solved {
    latest: Mutex<VecDeque<One>>,
    count: AtomicUsize,
}

impl Solved {
    /// The model at these numbers, solved if it is not known.
    pub(super) fn or_else(
        &self,
        values: &[f64],
        tolerance: f64,
        solve: impl FnOnce() -> Result<Vec<f64>, String>,
    ) -> Result<Vec<f64>, String> {
        let key: Vec<u64> = values.iter().chain([&tolerance]).map(|value| value.to_bits()).collect();
        let known = self.latest.lock().unwrap_or_else(PoisonError::into_inner).iter().find(|one| one.0 == key).map(|one| one.1.clone());
        if let Some(known) = known {
            return known;
        }
        self.count.fetch_add(1, Ordering::Relaxed);
        let found = solve();
        let mut latest = self.latest.lock().unwrap_or_else(PoisonError::into_inner);
        let most = MOST_NUMBERS / found.as_ref().map_or(1, Vec::len).max(1);
        latest.push_back((key, found.clone()));
        while latest.len() > most {
            latest.pop_front();
        }
        drop(latest);
        found
    }

    /// How many were solved.
    pub(super) fn count(&self) -> usize {
        self.count.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::Solved;

    #[test]
    fn what_is_known_is_not_solved_again_and_what_differs_is() {
        let solved = Solved::default();
        let solve = |value: f64, tolerance: f64| solved.or_else(&[value], tolerance, || Ok(vec![value + tolerance]));
        for (value, tolerance, count) in [(1.0, 0.5, 1), (1.0, 0.5, 1), (1.0, 0.25, 2), (2.0, 0.5, 3), (1.0, 0.25, 3)] {
            assert_eq!(solve(value, tolerance), Ok(vec![value + tolerance]));
            assert_eq!(solved.count(), count);
        }
    }
}
