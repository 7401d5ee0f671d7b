//! Sums over a part of a cycle: integrals by eight Gauss points, halved until halves agree with the whole, and extremes.

use super::cycles::Sample;
use super::gauss::{Gauss, NODES};
use super::integration::Integration;
use super::problem::Row;
use crate::indentation::adhesiveless::Sums;
use crate::indentation::cycle_integrals::CycleIntegrals;

/// Change of the work by halving a part, over the tolerance and what is turned over there.
const ENOUGH: f64 = 1e-3;
/// Golden sections of the place of an extreme.
const SECTIONS: u32 = 30;

impl Integration<'_> {
    /// The sums between two parameters, in up to 2^`cuts` parts.
    pub(super) fn added(
        &self,
        cycle_integrals: &CycleIntegrals,
        (from, to): (f64, f64),
        sample: &impl Fn(&Self, f64) -> Sample,
        cuts: u32,
    ) -> Added {
        let middle = 0.5 * (from + to);
        let whole = self.gauss(cycle_integrals, (from, to), sample);
        let halves = [(from, middle), (middle, to)].map(|range| self.gauss(cycle_integrals, range, sample));
        let work = halves[0].sums.work + halves[1].sums.work;
        let size = halves[0].size + halves[1].size;
        if cuts == 0 || (work - whole.sums.work).abs() <= ENOUGH * self.problem.tolerance * size {
            let [first, second] = halves.map(|half| self.with_extremes(half, sample));
            return first.and(&second);
        }
        let [first, second] = [(from, middle), (middle, to)].map(|range| self.added(cycle_integrals, range, sample, cuts - 1));
        first.and(&second)
    }

    fn gauss(&self, cycle_integrals: &CycleIntegrals, (from, to): (f64, f64), sample: &impl Fn(&Self, f64) -> Sample) -> Added {
        let rule = Gauss::get();
        let samples = rule.nodes.map(|x| sample(self, from + (to - from) * x));
        let mut sums = Sums { work: 0.0, lost: 0.0, moments: [[0.0; 3]; 2], extremes: None };
        let mut size = 0.0;
        for (Sample { pace, sink, row }, weight) in samples.iter().zip(rule.weights) {
            let part = weight * (to - from);
            sums.work += part * row.force * sink;
            size += part * (row.force * sink).abs();
            let weights = cycle_integrals.weights(row.time);
            for (moments, value) in sums.moments.iter_mut().zip([row.penetration, row.force]) {
                moments.iter_mut().zip(weights).for_each(|(moment, weight)| *moment += part * pace * weight * value);
            }
        }
        Added { range: (from, to), samples: Some(samples), sums, size }
    }

    /// With the extremes of Δ, F and a at the points and between them.
    fn with_extremes(&self, mut added: Added, sample: &impl Fn(&Self, f64) -> Sample) -> Added {
        let Some(samples) = added.samples.take() else { return added };
        let numbers = |row: &Row| [row.penetration, row.force, row.contact_radius];
        let mut extremes = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut take = |row: &Row| {
            for (pair, value) in extremes.iter_mut().zip(numbers(row)) {
                *pair = [pair[0].min(value), pair[1].max(value)];
            }
        };
        samples.iter().for_each(|sample| take(&sample.row));
        let (from, to) = added.range;
        // The edge turns at ends of panels only.
        for quantity in 0..2 {
            for sign in [-1.0, 1.0] {
                let values: [f64; NODES] = std::array::from_fn(|k| sign * numbers(&samples[k].row)[quantity]);
                if let Some(x) = highest(&values) {
                    take(&sample(self, from + (to - from) * x).row);
                }
            }
        }
        added.sums.extremes = Some(extremes);
        added
    }
}

/// Sums over a part, with the samples that they are made of, and ∫|F dΔ|.
pub(super) struct Added {
    range: (f64, f64),
    samples: Option<[Sample; NODES]>,
    pub(super) sums: Sums,
    size: f64,
}

impl Added {
    fn and(&self, other: &Self) -> Self {
        let mut sums = Sums { work: self.sums.work + other.sums.work, ..self.sums };
        sums.moments.iter_mut().flatten().zip(other.sums.moments.iter().flatten()).for_each(|(sum, part)| *sum += part);
        sums.extremes = match (self.sums.extremes, other.sums.extremes) {
            (Some(one), Some(two)) => Some(std::array::from_fn(|k| [one[k][0].min(two[k][0]), one[k][1].max(two[k][1])])),
            (one, two) => one.or(two),
        };
        Self { range: (self.range.0, other.range.1), samples: None, sums, size: self.size + other.size }
    }
}

/// Where the polynomial through values at the Gauss points has its top.
fn highest(values: &[f64; NODES]) -> Option<f64> {
    let nodes = &Gauss::get().nodes;
    let top = (0..NODES).max_by(|&one, &other| values[one].total_cmp(&values[other]))?;
    let at = |x: f64| -> f64 {
        let basis = |h: usize| (0..NODES).filter(|&k| k != h).map(|k| (x - nodes[k]) / (nodes[h] - nodes[k])).product::<f64>();
        (0..NODES).map(|h| basis(h) * values[h]).sum()
    };
    // Up to the ends of the part, where its neighbour has no point either.
    let mut low = if top > 0 { nodes[top - 1] } else { 0.0 };
    let mut high = if top + 1 < NODES { nodes[top + 1] } else { 1.0 };
    for _ in 0..SECTIONS {
        let [one, two] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
        if at(one) > at(two) { high = two } else { low = one }
    }
    Some(0.5 * (low + high))
}
