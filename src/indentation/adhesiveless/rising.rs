//! A function that rises along the line from a place on, and how far and how much a level is above it: ∫(y − p)₊ ds.

use super::drive::DEGREE;
use super::grid::{GRID, NODES, Nodal, dot};
use super::line::{Interval, Line};
use super::linear::Row;

/// p(s) at each node of a panel: a share of the heights and one of each term, interval after interval. Its values within an interval are added up where they
/// are asked for, once.
pub(super) struct Rising<'l> {
    start: f64,
    intervals: &'l [Interval],
    of_heights: f64,
    of_terms: Vec<Row>,
    /// p where the first interval starts, and where each one ends.
    first: Option<Row>,
    ends: Vec<Row>,
    /// ∫p ds up to each interval, and over all.
    before: Vec<Row>,
    whole: Row,
    seen: [Option<Seen>; DEGREE],
    /// How well places are found (ξ): what is above them goes with the square of that.
    settled: f64,
}

/// Where a level was met last: the interval, p at its places, ∫p ds over its width from its low end to each, and ξ.
#[derive(Clone, Copy)]
struct Seen {
    index: usize,
    values: Nodal,
    running: Nodal,
    xi: f64,
}

/// How far a level is above it.
#[derive(Clone, Copy)]
pub(super) struct Reached {
    pub(super) area: f64,
    pub(super) place: f64,
    /// Whether it is above the last interval too.
    pub(super) beyond: bool,
}

/// The same over what series leave.
const OF_SERIES: f64 = 1e-3;

impl<'l> Rising<'l> {
    fn new((start, tolerance): (f64, f64), intervals: &'l [Interval], of_heights: f64, of_terms: Vec<Row>) -> Self {
        let sums = |of: &dyn Fn(&[f64]) -> f64, heights: f64, interval: &Interval| -> Row {
            let mut row = [of_heights * heights; DEGREE];
            for (index, shares) in of_terms.iter().enumerate() {
                let sum = of(interval.term(index));
                for (value, share) in row.iter_mut().zip(shares) {
                    *value += share * sum;
                }
            }
            row
        };
        let at = |interval: &Interval, k: usize| sums(&|term| term.get(k).copied().unwrap_or(0.0), interval.heights[k], interval);
        let first = intervals.first().map(|interval| at(interval, 0));
        let ends = intervals.iter().map(|interval| at(interval, NODES - 1)).collect();
        let mut whole = [0.0; DEGREE];
        let mut before = Vec::with_capacity(intervals.len());
        for interval in intervals {
            before.push(whole);
            let own = sums(&|term| dot(&GRID.weights, term), GRID.integral(&interval.heights), interval);
            for (whole, own) in whole.iter_mut().zip(own) {
                *whole += interval.width() * own;
            }
        }
        Self {
            start,
            intervals,
            of_heights,
            of_terms,
            first,
            ends,
            before,
            whole,
            seen: [None; DEGREE],
            settled: (OF_SERIES * tolerance).max(f64::EPSILON),
        }
    }

    pub(super) fn first(&self, k: usize) -> Option<f64> {
        self.first.map(|first| first[k])
    }

    pub(super) fn last(&self, k: usize) -> Option<f64> {
        self.ends.last().map(|end| end[k])
    }

    fn end(&self) -> f64 {
        self.intervals.last().map_or(self.start, |interval| interval.high)
    }

    /// The whole area between a level and all intervals, above or below.
    pub(super) fn under(&self, k: usize, level: f64) -> f64 {
        level * (self.end() - self.start) - self.whole[k]
    }

    /// p at the places of an interval.
    fn values(&self, k: usize, interval: &Interval) -> Nodal {
        interval.weighted(self.of_heights, self.of_terms.iter().map(|shares| shares[k]))
    }

    pub(super) fn reached(&mut self, k: usize, level: f64) -> Reached {
        if self.first.is_some_and(|first| level <= first[k]) {
            return Reached { area: 0.0, place: self.start, beyond: false };
        }
        let index = self.ends.partition_point(|end| end[k] < level);
        let (Some(interval), Some(before)) = (self.intervals.get(index), self.before.get(index)) else {
            return Reached { area: self.under(k, level), place: self.end(), beyond: true };
        };
        let seen = self.seen[k].filter(|seen| seen.index == index);
        let (values, running) = seen.map_or_else(
            || {
                let values = self.values(k, interval);
                (values, GRID.running(&values))
            },
            |seen| (seen.values, seen.running),
        );
        let xi = GRID.falling_zero_near(&values.map(|value| level - value), seen.map(|seen| seen.xi), self.settled);
        let place = interval.low + interval.width() * GRID.part(xi);
        let own = interval.width() * GRID.value(xi, &running);
        self.seen[k] = Some(Seen { index, values, running, xi });
        Reached { area: level * (place - self.start) - (before[k] + own), place, beyond: false }
    }

    /// p at a place; none beyond the last interval.
    pub(super) fn value(&self, k: usize, place: f64) -> Option<f64> {
        let interval = self.intervals.iter().find(|interval| place <= interval.high)?;
        let values = self.values(k, interval);
        Some(dot(&GRID.at(place - interval.low, interval.high - place), &values))
    }
}

impl Line<'_> {
    /// What κ = ΣE_i(all that Δ has done)/E∞* must exceed for a place in contact to press: E0/E∞*·f − ΣE_i/E∞* u_i e^{−t/ρ_i}.
    pub(super) fn holding(&self, kept: &[Row]) -> Rising<'_> {
        let soft = self.chain.relaxed / self.chain.glassy;
        let shares = self.chain.maxwell.iter().zip(kept).map(|((modulus, _), kept)| kept.map(|kept| -modulus / self.chain.glassy * kept));
        Rising::new((0.0, self.tolerance), &self.contact, soft, shares.collect())
    }

    /// What Δ must exceed for a free place to be touched: f + Σe_j e^{−t/τ_j}.
    pub(super) fn surfaces(&self, recovered: &[Row]) -> Rising<'_> {
        Rising::new((self.radius(), self.tolerance), &self.free, 1.0, recovered.to_vec())
    }

    /// Places between two at which intervals meet.
    pub(super) fn borders(&self, one: f64, other: f64) -> impl Iterator<Item = f64> {
        let (low, high) = (one.min(other), one.max(other));
        let clear = 1e-9 * high;
        let ends = self.contact.iter().chain(&self.free).flat_map(|interval| [interval.low, interval.high]);
        ends.filter(move |place| *place > low + clear && *place < high - clear)
    }
}
