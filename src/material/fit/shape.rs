//! A series of moduli without the promise to be a material: what expansions of laws refine and spread.

use super::best::one_of_two;
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

    /// The series with the two neighbours in one that count least beside a modulus at their time.
    #[must_use]
    pub fn weakest_joined(&self, beside: impl Fn(f64) -> f64) -> Self {
        let mut terms = self.0.terms.clone();
        let counts = |pair: &[(f64, f64)]| pair.iter().map(|&(strength, time)| strength / beside(time)).sum::<f64>();
        let weakest = terms.windows(2).map(counts).enumerate().min_by(|left, right| left.1.total_cmp(&right.1));
        if let Some((index, _)) = weakest {
            let one = one_of_two(terms[index], terms[index + 1]);
            terms.splice(index..index + 2, [one]);
        }
        Self::new(self.0.constant, terms)
    }

    /// Strengths and times refined together.
    #[must_use]
    pub fn refined(&self, data: &[Observation], window: [f64; 2], steps: usize) -> Self {
        Self(self.0.clone().refined(&Sample::plain(data), window, steps))
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

    /// The same spectrum on another number of places: place and running sum of the strengths are followed between the old places.
    #[must_use]
    pub fn spread_over(&self, count: usize) -> Self {
        let old = &self.0.terms;
        if old.len() < 2 || count == 0 || count == old.len() {
            return self.clone();
        }
        // Logarithms of times and strengths are smooth in the number of the term: cubic through the four nearest.
        let logarithms: Vec<(f64, f64)> = old.iter().map(|&(strength, time)| (strength.ln(), time.ln())).collect();
        let ratio = old.len() as f64 / count as f64;
        let terms = (0..count)
            .map(|index| {
                let place = ((index as f64 + 0.5) * ratio - 0.5).clamp(0.0, (old.len() - 1) as f64);
                let (strength, time) = cubic(&logarithms, place);
                (strength.exp() * ratio, time.exp())
            })
            .collect();
        Self::new(self.0.constant, terms)
    }
}

/// Lagrange's cubic through the four points nearest to a place (fewer points, a lower degree).
fn cubic(points: &[(f64, f64)], place: f64) -> (f64, f64) {
    let width = points.len().min(4);
    let first = (place.floor() as usize).saturating_sub(1).min(points.len() - width);
    let mut sum = (0.0, 0.0);
    for (i, point) in points.iter().enumerate().skip(first).take(width) {
        let weight: f64 = (first..first + width).filter(|&j| j != i).map(|j| (place - j as f64) / (i as f64 - j as f64)).product();
        sum = (sum.0 + weight * point.0, sum.1 + weight * point.1);
    }
    sum
}
