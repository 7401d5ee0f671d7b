//! A series and the shifts of isotherms refined together.

use super::observation::Quantity;
use super::sample::Sample;
use super::series::Series;
use crate::fit::{Descent, descended};

/// Which shifts are free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Free {
    /// Number of isotherms.
    pub(super) isotherms: usize,
    /// The one whose factors are 1.
    pub(super) base: usize,
    /// Whether values are shifted, too.
    pub(super) vertical: bool,
}

impl Free {
    /// No shift is free.
    pub(super) const NONE: Self = Self { isotherms: 1, base: 0, vertical: false };

    /// Number of free shifts.
    pub(super) const fn count(self) -> usize {
        (self.isotherms - 1) * if self.vertical { 2 } else { 1 }
    }

    /// The place of an isotherm's ln a among the free numbers; none for the base. Its ln b follows.
    pub(super) fn place(self, isotherm: usize) -> Option<usize> {
        let each = if self.vertical { 2 } else { 1 };
        match isotherm.cmp(&self.base) {
            std::cmp::Ordering::Less => Some(isotherm * each),
            std::cmp::Ordering::Equal => None,
            std::cmp::Ordering::Greater => Some((isotherm - 1) * each),
        }
    }

    /// Shifts after a step.
    pub(super) fn moved(self, shifts: &[(f64, f64)], step: &[f64]) -> Vec<(f64, f64)> {
        let number = |index: usize| step.get(index).map_or(0.0, |value| value.clamp(-1.0, 1.0));
        let moved = |isotherm: usize, (a, b): (f64, f64)| match self.place(isotherm) {
            Some(place) => (a + number(place), b + if self.vertical { number(place + 1) } else { 0.0 }),
            None => (a, b),
        };
        shifts.iter().enumerate().map(|(isotherm, &shift)| moved(isotherm, shift)).collect()
    }
}

/// Columns of the free shifts, then those of the series, at shifted data.
pub(super) fn columns(series: &Series, shifted: &Sample, free: Free, window: [f64; 2]) -> Vec<Vec<f64>> {
    let mut columns = Vec::with_capacity(free.count() + series.freedom());
    for isotherm in (0..free.isotherms).filter(|&isotherm| free.place(isotherm).is_some()) {
        let of = |value: &dyn Fn(Quantity, f64) -> f64| {
            shifted.rows(
                shifted.places.iter().map(|place| if place.group == isotherm { value(place.quantity, place.at) } else { 0.0 }).collect(),
            )
        };
        columns.push(of(&|quantity, at| series.slope(quantity, at)));
        if free.vertical {
            columns.push(of(&|quantity, at| series.value(quantity, at) * if quantity == Quantity::Creep { 1.0 } else { -1.0 }));
        }
    }
    columns.extend(series.columns(shifted, window));
    columns
}

/// Series and shifts after at most so many steps of their common descent.
pub(super) fn refined(
    series: Series,
    shifts: Vec<(f64, f64)>,
    sample: &Sample,
    free: Free,
    window: [f64; 2],
    steps: usize,
) -> (Series, Vec<(f64, f64)>) {
    let shifted = sample.shifted(&shifts);
    let end = descended(Joint { series, shifts, sample, shifted, free, window }, steps);
    let mut series = end.series;
    series.terms.sort_by(|left, right| left.1.total_cmp(&right.1));
    (series, end.shifts)
}

struct Joint<'a> {
    series: Series,
    shifts: Vec<(f64, f64)>,
    sample: &'a Sample,
    shifted: Sample,
    free: Free,
    window: [f64; 2],
}

impl Descent for Joint<'_> {
    fn residuals(&self) -> Vec<f64> {
        self.series.residuals(&self.shifted)
    }

    fn rest(&self) -> f64 {
        self.sample.rest
    }

    fn jacobian(&self) -> Vec<Vec<f64>> {
        columns(&self.series, &self.shifted, self.free, self.window)
    }

    fn moved(&self, step: &[f64]) -> Self {
        let (own, rest) = step.split_at(self.free.count().min(step.len()));
        let shifts = self.free.moved(&self.shifts, own);
        let shifted = self.sample.shifted(&shifts);
        Self { series: self.series.moved(rest, self.window), shifts, shifted, ..*self }
    }
}
