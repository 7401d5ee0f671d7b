//! By how much the cycles of a long segment differ once its first tenth is over.

use super::cycle::Cycle;
use serde::{Deserialize, Serialize};

/// Part of the cycles of a segment that is left to settle.
const SETTLING: f64 = 0.1;
/// Work, two stiffnesses, and both extremes of Δ, F and a.
const QUANTITIES: usize = 9;

/// Differences among the cycles of a segment of one frequency, its first tenth left out. Every cycle counts, kept or not.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Which segment of the history, from 0.
    pub segment: usize,
    /// First and last cycle that count, from 1.
    pub cycles: [u64; 2],
    least: [f64; QUANTITIES],
    most: [f64; QUANTITIES],
    /// What each is seen against.
    scales: [f64; QUANTITIES],
}

impl Spread {
    /// The first cycle that counts.
    fn begun(cycle: &Cycle<f64>) -> Self {
        let values = quantities(cycle);
        let cycles = [cycle.number; 2];
        Self { segment: cycle.segment, cycles, least: values, most: values, scales: scales_of(cycle) }
    }

    /// Takes a cycle in: `whole` cycles make up the segment.
    pub(super) fn add(spread: &mut Option<Self>, cycle: &Cycle<f64>, whole: f64) {
        if cycle.number as f64 <= SETTLING * whole {
            return;
        }
        let all = spread.get_or_insert_with(|| Self::begun(cycle));
        all.cycles[1] = cycle.number;
        for ((least, most), value) in all.least.iter_mut().zip(&mut all.most).zip(quantities(cycle)) {
            *least = least.min(value);
            *most = most.max(value);
        }
        for (scale, value) in all.scales.iter_mut().zip(scales_of(cycle)) {
            *scale = scale.max(value);
        }
    }

    /// The largest relative difference between two cycles: of work, stiffnesses, and extremes of Δ (over its swing), F and a (over their largest values).
    #[must_use]
    pub fn largest(&self) -> f64 {
        let differences = self.least.iter().zip(&self.most).map(|(least, most)| most - least);
        differences
            .zip(&self.scales)
            .fold(0.0, |largest, (difference, scale)| if difference > 0.0 { f64::max(largest, difference / scale) } else { largest })
    }
}

fn quantities(cycle: &Cycle<f64>) -> [f64; QUANTITIES] {
    let [deep, high] = cycle.penetration;
    let [pull, push] = cycle.force;
    let [small, large] = cycle.contact_radius;
    [cycle.work, cycle.storage_stiffness, cycle.loss_stiffness, deep, high, pull, push, small, large]
}

fn scales_of(cycle: &Cycle<f64>) -> [f64; QUANTITIES] {
    let swing = |range: [f64; 2]| range[1] - range[0];
    let largest = |range: [f64; 2]| range[0].abs().max(range[1].abs());
    let work = cycle.work.abs().max(0.25 * swing(cycle.force) * swing(cycle.penetration));
    let stiffness = cycle.storage_stiffness.hypot(cycle.loss_stiffness);
    let (depth, force, radius) = (swing(cycle.penetration), largest(cycle.force), largest(cycle.contact_radius));
    [work, stiffness, stiffness, depth, depth, force, force, radius, radius]
}
