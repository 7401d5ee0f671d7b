//! A series while it is being fitted.

use super::observation::Quantity;
use super::sample::Sample;
use crate::fit::least_squares;
use crate::fit::{Descent, descended};

/// What a series may have besides its terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Ends {
    /// A constant: E0, or 1/E∞ of creep.
    pub(super) constant: bool,
    /// Flow t/η of creep.
    pub(super) flow: bool,
}

/// c + (1/η)·t + Σ s_k·kernel(x_k): strengths and times, sorted from the shortest time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    pub(super) constant: f64,
    /// 1/η of creep, else 0.
    pub(super) flow: f64,
    /// (strength, time).
    pub(super) terms: Vec<(f64, f64)>,
    pub(super) ends: Ends,
}

impl Series {
    pub(super) fn value(&self, quantity: Quantity, at: f64) -> f64 {
        let terms: f64 = self.terms.iter().map(|&(strength, time)| strength * quantity.kernel(quantity.argument(at, time)).0).sum();
        self.constant * quantity.constant() + self.flow * quantity.flow(at) + terms
    }

    pub(super) fn residuals(&self, sample: &Sample) -> Vec<f64> {
        let mut rows = sample.rows(sample.places.iter().map(|place| self.value(place.quantity, place.at)).collect());
        for (row, target) in rows.iter_mut().zip(&sample.targets) {
            *row -= target;
        }
        rows
    }

    /// Half the sum of squares is what a fit makes small; this is the whole sum.
    pub(super) fn misfit(&self, sample: &Sample) -> f64 {
        sample.rest + self.residuals(sample).iter().map(|residual| residual * residual).sum::<f64>()
    }

    /// The columns of the ends, then of terms with the given times and unit strength.
    pub(super) fn unit_columns(times: &[f64], sample: &Sample, ends: Ends) -> Vec<Vec<f64>> {
        let column =
            |value: &dyn Fn(Quantity, f64) -> f64| sample.rows(sample.places.iter().map(|place| value(place.quantity, place.at)).collect());
        let mut columns = Vec::with_capacity(times.len() + 2);
        if ends.constant {
            columns.push(column(&|quantity, _| quantity.constant()));
        }
        if ends.flow {
            columns.push(column(&|quantity, at| quantity.flow(at)));
        }
        columns.extend(times.iter().map(|&time| column(&|quantity, at| quantity.kernel(quantity.argument(at, time)).0)));
        columns
    }

    /// The best strengths for the given times; terms without strength are dropped.
    pub(super) fn at_times(times: &[f64], sample: &Sample, ends: Ends) -> Self {
        let strengths = least_squares::non_negative(&Self::unit_columns(times, sample, ends), &sample.targets);
        Self::with_strengths(&strengths, times, ends)
    }

    /// The series of strengths in the order of [`Self::unit_columns`].
    pub(super) fn with_strengths(strengths: &[f64], times: &[f64], ends: Ends) -> Self {
        let mut numbers = strengths.iter().copied();
        let constant = if ends.constant { numbers.next().unwrap_or(0.0) } else { 0.0 };
        let flow = if ends.flow { numbers.next().unwrap_or(0.0) } else { 0.0 };
        let mut terms: Vec<(f64, f64)> = numbers.zip(times.iter().copied()).filter(|&(strength, _)| strength > 0.0).collect();
        terms.sort_by(|left, right| left.1.total_cmp(&right.1));
        Self { constant, flow, terms, ends }
    }

    /// Numbers before those of the terms.
    fn own(&self) -> usize {
        usize::from(self.constant > 0.0) + usize::from(self.flow > 0.0)
    }

    /// Number of free numbers.
    pub(super) fn freedom(&self) -> usize {
        2 * self.terms.len() + self.own()
    }

    /// Derivatives of the rows by ln c (if c > 0), ln 1/η (if it flows), then by ln s_k and ln ρ_k of each term; frozen times have zero columns.
    pub(super) fn columns(&self, sample: &Sample, window: [f64; 2]) -> Vec<Vec<f64>> {
        let values =
            |value: &dyn Fn(Quantity, f64) -> f64| sample.rows(sample.places.iter().map(|place| value(place.quantity, place.at)).collect());
        let mut columns = Vec::with_capacity(self.freedom());
        if self.constant > 0.0 {
            columns.push(values(&|quantity, _| self.constant * quantity.constant()));
        }
        if self.flow > 0.0 {
            columns.push(values(&|quantity, at| self.flow * quantity.flow(at)));
        }
        for &(strength, time) in &self.terms {
            let both: Vec<(f64, f64)> =
                sample.places.iter().map(|place| place.quantity.kernel(place.quantity.argument(place.at, time))).collect();
            columns.push(sample.rows(both.iter().map(|both| strength * both.0).collect()));
            let free = time > window[0] && time < window[1];
            columns.push(sample.rows(both.iter().map(|both| if free { strength * both.1 } else { 0.0 }).collect()));
        }
        columns
    }

    /// Derivatives of a value by the same numbers.
    pub(super) fn gradient(&self, quantity: Quantity, at: f64, window: [f64; 2]) -> Vec<f64> {
        let mut gradient = Vec::with_capacity(self.freedom());
        if self.constant > 0.0 {
            gradient.push(self.constant * quantity.constant());
        }
        if self.flow > 0.0 {
            gradient.push(self.flow * quantity.flow(at));
        }
        for &(strength, time) in &self.terms {
            let (value, slope) = quantity.kernel(quantity.argument(at, time));
            gradient.push(strength * value);
            gradient.push(if time > window[0] && time < window[1] { strength * slope } else { 0.0 });
        }
        gradient
    }

    /// The derivative of a value by the logarithm of all times together, as a shift factor changes them.
    pub(super) fn slope(&self, quantity: Quantity, at: f64) -> f64 {
        let terms: f64 = self.terms.iter().map(|&(strength, time)| strength * quantity.kernel(quantity.argument(at, time)).1).sum();
        terms - self.flow * quantity.flow(at)
    }

    /// The series after a step in the logarithms, times kept in the window.
    pub(super) fn moved(&self, step: &[f64], window: [f64; 2]) -> Self {
        // No step changes a number by more than e³: the linear picture ends long before.
        let mut factors = step.iter().map(|value| value.clamp(-3.0, 3.0).exp());
        let mut factor = || factors.next().unwrap_or(1.0);
        let constant = if self.constant > 0.0 { self.constant * factor() } else { 0.0 };
        let flow = if self.flow > 0.0 { self.flow * factor() } else { 0.0 };
        let terms = self
            .terms
            .iter()
            .map(|&(strength, time)| {
                let strength = strength * factor();
                (strength, (time * factor()).clamp(window[0], window[1]))
            })
            .collect();
        Self { constant, flow, terms, ends: self.ends }
    }

    /// Levenberg and Marquardt's descent from here; at most so many steps.
    pub(super) fn refined(self, sample: &Sample, window: [f64; 2], steps: usize) -> Self {
        let mut series = descended(Refined { series: self, sample, window }, steps).series;
        series.terms.sort_by(|left, right| left.1.total_cmp(&right.1));
        series
    }
}

/// A series on its way.
struct Refined<'a> {
    series: Series,
    sample: &'a Sample,
    window: [f64; 2],
}

impl Descent for Refined<'_> {
    fn residuals(&self) -> Vec<f64> {
        self.series.residuals(self.sample)
    }

    fn rest(&self) -> f64 {
        self.sample.rest
    }

    fn jacobian(&self) -> Vec<Vec<f64>> {
        self.series.columns(self.sample, self.window)
    }

    fn moved(&self, step: &[f64]) -> Self {
        Self { series: self.series.moved(step, self.window), sample: self.sample, window: self.window }
    }
}
