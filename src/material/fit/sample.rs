//! Observations as a fit uses them: each by itself, or many of half a decade combined into a dozen without loss.
//!
//! Every curve that a series can give is smooth in the logarithm u of frequency or time: over half a decade it is the polynomial through its values f at
//! twelve Chebyshev nodes to 1e-9 of itself (the poles of the kernels lie π/2 from the real axis). The sum of squares of any number of rows is then
//! ```text
//! Σ ((Σ_k ℓ_k(u_i) f_k − y_i)/s_i)² = ‖R f − z‖² + rest,      [ℓ_k(u_i)/s_i | y_i/s_i] = Q [R z; 0 √rest]
//! ```
//! so that no step of the fit depends on the number of rows. Numbers that are relative to themselves are then taken relative to that polynomial.

use super::observation::{Observation, Quantity};
use crate::fit::least_squares::product;
use faer::Mat;
use std::collections::BTreeMap;

/// Where a curve is observed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) quantity: Quantity,
    pub(super) at: f64,
    /// Index of the isotherm.
    pub(super) group: usize,
}

/// Rows that are combinations of the values at consecutive places.
#[derive(Debug, Clone)]
struct Mix {
    first: usize,
    /// Upper triangle, each row from its diagonal on.
    triangle: Vec<Vec<f64>>,
}

/// Data in the form of rows, linear in the values of a curve at places.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    pub(super) places: Vec<Place>,
    /// What the value at a place is multiplied by, before rows are mixed.
    weights: Vec<f64>,
    /// What each row should be.
    pub(super) targets: Vec<f64>,
    mixes: Vec<Mix>,
    /// Sum of squares that no smooth curve lessens.
    pub(super) rest: f64,
    /// Number of observations.
    pub(super) count: usize,
}

/// Nodes over half a decade.
const NODES: usize = 12;
/// Intervals of a decade.
const INTERVALS: f64 = 2.0;
/// Fewer observations in an interval stay as they are.
const LEAST: usize = 3 * NODES;
/// Places closer than this (in the logarithm) are one.
const SAME: f64 = 1e-9;

impl Sample {
    /// Each observation by itself, of one isotherm.
    pub(super) fn plain(data: &[Observation]) -> Self {
        let mut sample = Self::empty();
        data.iter().for_each(|one| sample.add(one, 0));
        sample
    }

    /// Observations of isotherms, combined where they are many.
    pub(super) fn combined<'a>(isotherms: impl Iterator<Item = &'a [Observation]>) -> Self {
        let mut sample = Self::empty();
        for (group, data) in isotherms.enumerate() {
            let mut intervals: BTreeMap<(u8, i64), Vec<&Observation>> = BTreeMap::new();
            for one in data {
                intervals.entry((one.quantity as u8, (one.at.log10() * INTERVALS).floor() as i64)).or_default().push(one);
            }
            for of_one in intervals.values() {
                if of_one.len() < LEAST || !sample.combine(of_one, group) {
                    of_one.iter().for_each(|one| sample.add(one, group));
                }
            }
        }
        sample
    }

    const fn empty() -> Self {
        Self { places: Vec::new(), weights: Vec::new(), targets: Vec::new(), mixes: Vec::new(), rest: 0.0, count: 0 }
    }

    fn add(&mut self, one: &Observation, group: usize) {
        self.places.push(Place { quantity: one.quantity, at: one.at, group });
        self.weights.push(1.0 / one.scale);
        self.targets.push(one.value / one.scale);
        self.count += 1;
    }

    /// Combines observations of one quantity in one interval; false if the reduction fails in double precision.
    fn combine(&mut self, data: &[&Observation], group: usize) -> bool {
        let Some(quantity) = data.first().map(|one| one.quantity) else { return true };
        let logarithms: Vec<f64> = data.iter().map(|one| one.at.ln()).collect();
        let low = logarithms.iter().copied().fold(f64::INFINITY, f64::min);
        let high = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let nodes: Vec<f64> = if high - low < SAME {
            vec![0.5 * (low + high)]
        } else {
            let angle = |index: usize| std::f64::consts::PI * (index as f64 + 0.5) / NODES as f64;
            (0..NODES).map(|index| 0.5 * (low + high) - 0.5 * (high - low) * angle(index).cos()).collect()
        };
        let count = nodes.len();
        let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let weights: Vec<f64> = (0..count).map(|k| sign(k) * (std::f64::consts::PI * (k as f64 + 0.5) / count as f64).sin()).collect();
        let mut scales: Vec<f64> = data.iter().map(|one| one.scale).collect();
        let mut row = vec![0.0; count];
        let mut triangle = |scales: &[f64]| {
            let mut whole = Mat::zeros(data.len(), count + 1);
            for (i, ((one, &at), scale)) in data.iter().zip(&logarithms).zip(scales).enumerate() {
                lagrange(&nodes, &weights, at, &mut row);
                for (k, value) in row.iter().enumerate() {
                    whole[(i, k)] = value / scale;
                }
                whole[(i, count)] = one.value / scale;
            }
            whole.qr().thin_R().to_owned()
        };
        let first_pass = triangle(&scales);
        // A number that scatters downwards must not weigh more than one that scatters upwards: what is relative to itself becomes relative to the smooth curve.
        let relative = data.iter().zip(&scales).all(|(one, scale)| (one.value.abs() - scale).abs() <= 1e-12 * scale);
        if let Some(values) = solved(&first_pass).filter(|_| relative) {
            let mut row = vec![0.0; count];
            for (scale, &at) in scales.iter_mut().zip(&logarithms) {
                lagrange(&nodes, &weights, at, &mut row);
                *scale = product(&row, &values).abs().clamp(0.5 * *scale, 2.0 * *scale);
            }
        }
        let whole = if relative { triangle(&scales) } else { first_pass };
        if (0..=count).any(|i| (i..=count).any(|j| !whole[(i, j)].is_finite())) {
            return false;
        }
        let first = self.places.len();
        for (i, node) in nodes.iter().enumerate() {
            self.places.push(Place { quantity, at: node.exp(), group });
            self.weights.push(1.0);
            self.targets.push(whole[(i, count)]);
        }
        self.mixes.push(Mix { first, triangle: (0..count).map(|i| (i..count).map(|j| whole[(i, j)]).collect()).collect() });
        self.rest += whole[(count, count)].powi(2);
        self.count += data.len();
        true
    }

    /// The rows of a curve whose values at the places are given.
    pub(super) fn rows(&self, mut values: Vec<f64>) -> Vec<f64> {
        for (value, weight) in values.iter_mut().zip(&self.weights) {
            *value *= weight;
        }
        for mix in &self.mixes {
            // Row i of an upper triangle needs no value before i.
            for (i, row) in (mix.first..).zip(&mix.triangle) {
                let sum = values.get(i..).map_or(0.0, |part| product(row, part));
                if let Some(place) = values.get_mut(i) {
                    *place = sum;
                }
            }
        }
        values
    }

    /// The sample with the places of each isotherm moved by ln a, and its values by ln b.
    pub(super) fn shifted(&self, shifts: &[(f64, f64)]) -> Self {
        let mut moved = self.clone();
        for (place, weight) in moved.places.iter_mut().zip(&mut moved.weights) {
            let (horizontal, vertical) = shifts.get(place.group).copied().unwrap_or((0.0, 0.0));
            place.at *= if place.quantity.by_frequency() { horizontal } else { -horizontal }.exp();
            // b multiplies measured moduli and divides measured compliances: a curve at the reference is divided by it where the data stay.
            *weight *= if place.quantity == Quantity::Creep { vertical } else { -vertical }.exp();
        }
        moved
    }

    /// The sample with the values at its places multiplied by a factor.
    pub(super) fn weighted(&self, factor: impl Fn(&Place) -> f64) -> Self {
        let mut weighted = self.clone();
        for (place, weight) in weighted.places.iter().zip(&mut weighted.weights) {
            *weight *= factor(place);
        }
        weighted
    }

    /// The smallest and the largest place as a time.
    pub(super) fn times(&self) -> [f64; 2] {
        let times = self.places.iter().map(|place| if place.quantity.by_frequency() { 1.0 / place.at } else { place.at });
        times.fold([f64::INFINITY, 0.0_f64], |[low, high], time| [low.min(time), high.max(time)])
    }

    pub(super) fn is_creep(&self) -> bool {
        self.places.iter().any(|place| place.quantity == Quantity::Creep)
    }
}

/// Values at the nodes from the triangle [R z; 0 √rest]; none where the rows do not fix them all.
fn solved(triangle: &Mat<f64>) -> Option<Vec<f64>> {
    let count = triangle.ncols() - 1;
    let mut values = vec![0.0; count];
    for i in (0..count).rev() {
        let sum: f64 = ((i + 1)..count).map(|k| triangle[(i, k)] * values[k]).sum();
        values[i] = (triangle[(i, count)] - sum) / triangle[(i, i)];
    }
    let largest = (0..count).map(|i| triangle[(i, i)].abs()).fold(0.0, f64::max);
    let fixed = (0..count).all(|i| triangle[(i, i)].abs() > 1e-10 * largest);
    (fixed && values.iter().all(|value| value.is_finite())).then_some(values)
}

/// Lagrange's polynomials of Chebyshev's nodes at a place, in the barycentric form.
fn lagrange(nodes: &[f64], weights: &[f64], at: f64, values: &mut [f64]) {
    let mut sum = 0.0;
    let mut hit = None;
    for (k, ((value, node), weight)) in values.iter_mut().zip(nodes).zip(weights).enumerate() {
        if (at - node).abs() < 1e-300 {
            hit = Some(k);
        }
        *value = weight / (at - node);
        sum += *value;
    }
    for (k, value) in values.iter_mut().enumerate() {
        *value = hit.map_or(*value / sum, |hit| if hit == k { 1.0 } else { 0.0 });
    }
}
