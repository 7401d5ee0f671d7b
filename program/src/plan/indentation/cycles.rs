//! Rows of the cycles of an oscillation, of both theories of an indenter.

use super::IndentationPlan;
use super::columns::{at, of_cycle};
use crate::plan::curves::thinned;
use std::f64::consts::FRAC_PI_4;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Cycle, IndentationSolution, PathPoint, Spread};

/// Most rows of cycles that one state has; of more, evenly chosen ones, first and last of each piece among them.
pub(super) const MOST_ROWS: usize = 2000;
/// Fewer instants than these draw no cycle, and none is one.
const INSTANTS_PER_CYCLE: f64 = 12.0;

/// Last digits of the quantities of a cycle, which a difference of two keeps.
const DIGITS: f64 = 1e-13;
/// Rounding of the ends of a cycle, over the time.
const END: f64 = 2.0 * f64::EPSILON;

/// The cycles of a history, coherent.
pub(super) struct Cycles<'s> {
    cycles: &'s [Cycle<Estimate>],
    spreads: &'s [Spread],
    /// Of each segment of the solver the segment of the scene, and what is not known of the quantities of its cycles, over their scales.
    segments: Vec<(usize, f64)>,
    /// The longest relaxation time.
    longest: f64,
    /// Where the columns of cycles begin among all.
    place: usize,
}

impl<'s> Cycles<'s> {
    /// Cycles and their spreads, in segments of the solver that are these of the scene.
    pub(super) fn new(
        (cycles, spreads): (&'s [Cycle<Estimate>], &'s [Spread]),
        segments: impl Iterator<Item = usize>,
        longest: Option<f64>,
        place: usize,
    ) -> Self {
        let mut segments: Vec<(usize, f64)> = segments.map(|segment| (segment, 0.0)).collect();
        for cycle in cycles {
            if let Some((_, unknown)) = segments.get_mut(cycle.segment) {
                *unknown = unknown.max(relative_error(cycle));
            }
        }
        Self { cycles, spreads, segments, longest: longest.unwrap_or(0.0), place }
    }

    /// The cycles that become rows.
    pub(super) fn shown(&self) -> Vec<&'s Cycle<Estimate>> {
        if self.cycles.len() <= MOST_ROWS {
            return self.cycles.iter().collect();
        }
        let segments: Vec<Vec<&Cycle<Estimate>>> =
            self.cycles.chunk_by(|one, other| one.segment == other.segment).map(|cycles| cycles.iter().collect()).collect();
        // Short pieces leave their share to long ones.
        let mut lengths: Vec<usize> = segments.iter().map(Vec::len).collect();
        lengths.sort_unstable();
        let (mut left, mut share) = (MOST_ROWS, 0);
        for (index, length) in lengths.iter().enumerate() {
            share = left / (lengths.len() - index);
            left -= share.min(*length);
        }
        segments.into_iter().flat_map(|cycles| thinned(cycles, share.max(2))).collect()
    }

    /// Puts a cycle into its places among the values of a row, which have these scales.
    pub(super) fn put(&self, values: &mut [Option<Estimate>], cycle: &Cycle<Estimate>, scales: &[f64]) {
        let exact = |value: f64| Some(Estimate::exact(value));
        let spread = self.spreads.iter().find(|spread| (spread.segment, spread.cycles[1]) == (cycle.segment, cycle.number));
        // A difference of two has what is not known of them twice, and a drift carries that on.
        let (segment, unknown) = self.segments.get(cycle.segment).copied().unwrap_or_default();
        let carried = 2.0 * (DIGITS + unknown) * (self.longest / (cycle.end - cycle.start)).max(1.0);
        let own = [
            (of_cycle::SEGMENT, exact(segment as f64)),
            (of_cycle::CYCLE, exact(cycle.number as f64)),
            (of_cycle::CYCLE_START, exact(cycle.start)),
            (of_cycle::FREQUENCY, Some(Estimate::relative((cycle.end - cycle.start).recip(), END * cycle.end / (cycle.end - cycle.start)))),
            (of_cycle::WORK_PER_CYCLE, Some(cycle.work)),
            (of_cycle::STORAGE_STIFFNESS, Some(cycle.storage_stiffness)),
            (of_cycle::LOSS_STIFFNESS, Some(cycle.loss_stiffness)),
            (of_cycle::PHASE, Some(cycle.phase)),
            (of_cycle::SMALLEST_PENETRATION, Some(cycle.penetration[0])),
            (of_cycle::LARGEST_PENETRATION, Some(cycle.penetration[1])),
            (of_cycle::SMALLEST_FORCE, Some(cycle.force[0])),
            (of_cycle::LARGEST_FORCE, Some(cycle.force[1])),
            (of_cycle::SMALLEST_CONTACT_RADIUS, Some(cycle.contact_radius[0])),
            (of_cycle::LARGEST_CONTACT_RADIUS, Some(cycle.contact_radius[1])),
            // The first cycle has none before it.
            (of_cycle::DRIFT, Some(Estimate::new(cycle.drift, cycle.drift_error + carried))),
            (of_cycle::SPREAD, spread.map(|spread| Estimate::new(spread.largest(), 2.0 * unknown))),
        ];
        let cells = own.map(|(place, estimate)| (self.place + place, estimate));
        for (place, estimate) in [(at::TIME, exact(cycle.end))].into_iter().chain(cells) {
            if let Some(cell) = values.get_mut(place) {
                // What does not exist, such as the stiffness of a contact that is open, is an empty cell. A cycle that one integration has and the
                // other has not is not known better than the whole.
                let bound = |estimate: Estimate| estimate.value.abs().max(scales.get(place).copied().unwrap_or(0.0));
                *cell = estimate
                    .filter(|estimate| estimate.value.is_finite())
                    .map(|estimate| Estimate::new(estimate.value, estimate.error.min(bound(estimate))));
            }
        }
    }

    /// What errors of cycles are relative to where a value passes through zero: the stiffness as a complex number, the work that cycles of these
    /// widths could take at most, one radian.
    pub(super) fn scales(&self) -> Vec<(usize, f64)> {
        let largest = |of: &dyn Fn(&Cycle<Estimate>) -> f64| {
            self.cycles.iter().map(of).filter(|value| value.is_finite()).fold(0.0, |most: f64, value| most.max(value.abs()))
        };
        let stiffness = largest(&|cycle| cycle.storage_stiffness.value.hypot(cycle.loss_stiffness.value));
        let width = |pair: &[Estimate; 2]| pair[1].value - pair[0].value;
        let work = largest(&|cycle| FRAC_PI_4 * width(&cycle.penetration) * width(&cycle.force)).max(largest(&|cycle| cycle.work.value));
        let extreme = |of: fn(&Cycle<Estimate>) -> &[Estimate; 2]| largest(&|cycle| of(cycle)[0].value.abs().max(of(cycle)[1].value.abs()));
        let depth = extreme(|cycle| &cycle.penetration);
        let force = extreme(|cycle| &cycle.force);
        let radius = extreme(|cycle| &cycle.contact_radius);
        let own = [
            (of_cycle::WORK_PER_CYCLE, work),
            (of_cycle::STORAGE_STIFFNESS, stiffness),
            (of_cycle::LOSS_STIFFNESS, stiffness),
            (of_cycle::PHASE, 1.0),
            (of_cycle::SMALLEST_PENETRATION, depth),
            (of_cycle::LARGEST_PENETRATION, depth),
            (of_cycle::SMALLEST_FORCE, force),
            (of_cycle::LARGEST_FORCE, force),
            (of_cycle::SMALLEST_CONTACT_RADIUS, radius),
            (of_cycle::LARGEST_CONTACT_RADIUS, radius),
        ];
        let of_instants = [(at::PENETRATION, depth), (at::FORCE, force), (at::CONTACT_RADIUS, radius)];
        own.into_iter().map(|(place, scale)| (self.place + place, scale)).chain(of_instants).collect()
    }
}

impl IndentationPlan {
    /// The cycles of a solution.
    pub(super) fn cycles<'s>(&'s self, solution: &'s IndentationSolution) -> Cycles<'s> {
        let segments = self.timeline.legs.iter().map(|leg| leg.segment);
        let found = (solution.cycles.as_slice(), solution.integration.spreads.as_slice());
        Cycles::new(found, segments, self.material.longest_relaxation_time(), at::SEGMENT)
    }

    /// Points of the path that are instants, evenly in time: all through an oscillation for which the scene asks for enough of them, else in its
    /// last cycle.
    pub(super) fn in_oscillations<'s>(&self, solution: &'s IndentationSolution) -> Vec<(usize, &'s PathPoint)> {
        let instants = f64::from(self.indentation.instants);
        if instants < INSTANTS_PER_CYCLE {
            return Vec::new();
        }
        let mut found = Vec::new();
        for cycles in solution.cycles.chunk_by(|one, other| one.segment == other.segment) {
            let (Some(first), Some(last)) = (cycles.first(), cycles.last()) else { continue };
            let all = instants >= INSTANTS_PER_CYCLE * last.number as f64;
            // What follows the last whole cycle belongs to all.
            let end = solution.instants.iter().map(|instant| instant.time).find(|time| *time >= last.end).unwrap_or(last.end);
            let (from, to) = if all { (first.start, end) } else { (last.start, last.end) };
            let mut next = from;
            for (index, point) in solution.integration.path.iter().enumerate().filter(|(_, point)| point.time >= from && point.time < to) {
                if point.time >= next {
                    found.push((index, point));
                    next = point.time.max(next + (to - from) / instants);
                }
            }
        }
        found
    }
}

/// The largest error of work and extremes of a cycle over what their changes are seen against.
fn relative_error(cycle: &Cycle<Estimate>) -> f64 {
    let swing = |range: &[Estimate; 2]| (range[1].value - range[0].value).abs();
    let largest = |range: &[Estimate; 2]| range[0].value.abs().max(range[1].value.abs());
    let stiffness = cycle.storage_stiffness.value.hypot(cycle.loss_stiffness.value);
    let work = cycle.work.value.abs().max(0.25 * swing(&cycle.force) * swing(&cycle.penetration));
    let pairs = [
        (cycle.work.error, work),
        (cycle.storage_stiffness.error, stiffness),
        (cycle.loss_stiffness.error, stiffness),
        (cycle.penetration[0].error.max(cycle.penetration[1].error), swing(&cycle.penetration)),
        (cycle.force[0].error.max(cycle.force[1].error), largest(&cycle.force)),
        (cycle.contact_radius[0].error.max(cycle.contact_radius[1].error), largest(&cycle.contact_radius)),
    ];
    pairs.into_iter().map(|(error, scale)| if error > 0.0 { error / scale } else { 0.0 }).fold(0.0, f64::max)
}
