//! A series of moduli without the promise to be a material: what expansions of laws are made of.

use super::observation::{Observation, Quantity};
use super::sample::Sample;
use super::series::{Ends, Series};

/// Strengths and times, sorted from the shortest time.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesShape(Series);

impl SeriesShape {
    /// From a constant and (strength, time) pairs.
    #[must_use]
    pub fn new(constant: f64, mut terms: Vec<(f64, f64)>) -> Self {
        terms.sort_by(|left, right| left.1.total_cmp(&right.1));
        Self(Series { constant, flow: 0.0, terms, ends: Ends { constant: true, flow: false } })
    }

    /// (strength, time), shortest time first.
    #[must_use]
    pub fn terms(&self) -> &[(f64, f64)] {
        &self.0.terms
    }

    /// Number of terms.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.terms.len()
    }

    /// The series without the terms of which a strength and a time say so.
    #[must_use]
    pub fn without(&self, leave: impl Fn(f64, f64) -> bool) -> Self {
        Self::new(self.0.constant, self.0.terms.iter().copied().filter(|&(strength, time)| !leave(strength, time)).collect())
    }

    /// Residuals relative to their scales; a storage and the loss that follows it share the length of both.
    #[must_use]
    pub fn complex_errors(&self, data: &[Observation]) -> Vec<f64> {
        let residuals = self.0.residuals(&Sample::plain(data));
        let mut errors: Vec<f64> = residuals.iter().map(|residual| residual.abs()).collect();
        for index in 1..data.len() {
            let pair = data[index - 1].quantity == Quantity::Storage && data[index].quantity == Quantity::Loss;
            if pair {
                let length = residuals[index - 1].hypot(residuals[index]);
                (errors[index - 1], errors[index]) = (length, length);
            }
        }
        errors
    }
}
