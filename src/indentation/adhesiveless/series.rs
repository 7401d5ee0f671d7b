//! How finely the line is cut into intervals: halved until series keep it, joined where one does for two.

use super::grid::{GRID, NODES, Nodal, dot};
use super::line::{Interval, Line, NARROWEST};
use crate::indentation::panel::POINTS;
use crate::indentation::profile::Profile;

/// Halvings of an interval that is not resolved.
const MOST_HALVINGS: u32 = 48;
/// Points of a table in an interval, at most, and what a series leaves there over its last coefficients: those of x^{5/2} fall as n^{−7/2}.
const MOST_KNOTS: usize = 7;
const ACROSS_KNOTS: f64 = 10.0;
/// Strains of this part of the depth are none.
const DEAD: f64 = 1e-18;
/// Intervals from which on they are joined more readily.
const MANY: usize = 3000;

impl Line<'_> {
    /// What each term of a state weighs in S.
    fn shares(&self, in_contact: bool) -> Vec<f64> {
        if in_contact {
            self.chain.maxwell.iter().map(|(modulus, _)| modulus / self.chain.glassy).collect()
        } else {
            vec![1.0; self.chain.terms()]
        }
    }

    /// f at the places of an interval, eight at a time.
    fn heights(&self, interval: &mut Interval) {
        let places: Nodal = std::array::from_fn(|k| interval.place(k));
        for (places, heights) in places.chunks(POINTS).zip(interval.heights.chunks_mut(POINTS)) {
            let row = std::array::from_fn(|k| places.get(k).or(places.last()).copied().unwrap_or(interval.high));
            for (height, value) in heights.iter_mut().zip(self.profile.line_row(&row)) {
                *height = value;
            }
        }
    }

    /// Intervals between two places with the states of a function of place and height, halved until series keep them.
    pub(super) fn build(
        &mut self,
        (low, high): (f64, f64),
        in_contact: bool,
        at: &mut dyn FnMut(f64, f64, &mut [f64]),
        into: &mut Vec<Interval>,
    ) {
        if high - low <= 0.0 {
            return;
        }
        let shares = self.shares(in_contact);
        let noise = &self.chain.noise[usize::from(!in_contact)];
        let knots = if let Profile::Table(shape) = self.profile.face() { shape.knots(low, high) } else { Vec::new() };
        self.build_smooth((low, high), &knots, (&shares, noise), at, into, MOST_HALVINGS);
    }

    /// The same with these points of a table between both places.
    fn build_smooth(
        &mut self,
        (low, high): (f64, f64),
        knots: &[f64],
        (shares, noise): (&[f64], &[f64]),
        at: &mut dyn FnMut(f64, f64, &mut [f64]),
        into: &mut Vec<Interval>,
        halvings: u32,
    ) {
        let cut = (knots.len() / 2, knots.get(knots.len() / 2).copied().unwrap_or(0.5 * (low + high)));
        if knots.len() > MOST_KNOTS {
            return self.build_parts((low, cut, high), knots, (shares, noise), at, into, halvings);
        }
        let terms = self.chain.terms();
        let mut interval = Interval { low, high, heights: [0.0; NODES], state: vec![0.0; terms * NODES], off: 0.0, then: 0.0, fresh: true };
        let mut state = vec![0.0; terms];
        self.heights(&mut interval);
        for k in 0..NODES {
            at(interval.place(k), interval.heights[k], &mut state);
            for (index, value) in state.iter().enumerate() {
                if let Some(cell) = interval.state.get_mut(index * NODES + k) {
                    *cell = *value;
                }
            }
        }
        self.updates += NODES as u64;
        let allowed = self.tolerance * self.depth;
        // A series ends slowly across points of a table.
        let slowly = if knots.is_empty() { 1.0 } else { ACROSS_KNOTS };
        let left = |values: &[f64]| <&Nodal>::try_from(values).map_or(0.0, |values| slowly * GRID.tail(values));
        let mut most = left(&interval.heights);
        let mut resolved = most <= allowed;
        for (index, (share, noise)) in shares.iter().zip(noise).enumerate() {
            let own = share * left(interval.term(index));
            resolved &= own <= allowed.max(noise * self.depth);
            most = most.max(own);
        }
        if resolved {
            self.cut = self.cut.max(most);
        }
        if resolved || halvings == 0 || high - low <= 1e3 * NARROWEST * high {
            into.push(interval);
        } else {
            self.build_parts((low, cut, high), knots, (shares, noise), at, into, halvings - 1);
        }
    }

    /// Two of them, cut at the middle one of the points of a table, or in half.
    fn build_parts(
        &mut self,
        (low, (index, middle), high): (f64, (usize, f64), f64),
        knots: &[f64],
        weights: (&[f64], &[f64]),
        at: &mut dyn FnMut(f64, f64, &mut [f64]),
        into: &mut Vec<Interval>,
        halvings: u32,
    ) {
        let (before, after) = knots.split_at(index);
        self.build_smooth((low, middle), before, weights, at, into, halvings);
        self.build_smooth((middle, high), after.get(1..).unwrap_or(&[]), weights, at, into, halvings);
    }

    /// Joins neighbours that one series keeps, and forgets what has recovered.
    pub(super) fn tidy(&mut self, all: bool) {
        let dead = DEAD * self.depth;
        while self.free.last().is_some_and(|interval| interval.state.iter().all(|e| e.abs() <= dead)) {
            self.free.pop();
        }
        self.most_intervals = self.most_intervals.max((self.contact.len() + self.free.len()) as u64);
        let many = self.contact.len() + self.free.len() > MANY;
        for in_contact in [true, false] {
            let shares = self.shares(in_contact);
            let noise: f64 = self.chain.noise[usize::from(!in_contact)].iter().sum();
            let allowed = (self.tolerance.max(noise)) * self.depth * if many { 100.0 } else { 1.0 };
            let list = std::mem::take(if in_contact { &mut self.contact } else { &mut self.free });
            let mut kept: Vec<Interval> = Vec::with_capacity(list.len());
            for interval in list {
                let mut next = interval;
                while let Some(before) = kept.last() {
                    if !(all || before.fresh || next.fresh) {
                        break;
                    }
                    let Some((mut joined, [change, beyond])) = self.joined(before, &next, &shares, (in_contact, allowed)) else { break };
                    joined.off = before.off.max(next.off) + change;
                    joined.then = before.then.max(next.then) + beyond;
                    self.joined = self.joined.max(joined.off);
                    kept.pop();
                    next = joined;
                }
                kept.push(next);
            }
            for interval in &mut kept {
                interval.fresh = false;
            }
            *(if in_contact { &mut self.contact } else { &mut self.free }) = kept;
        }
    }

    /// The edge passes an interval. Elements recover at their own times, and what its series leaves of each, which S hardly shows before, it shows then; parts of it
    /// are built from the series as it is, and do not show it.
    pub(super) fn passes(&mut self, interval: &Interval, in_contact: bool) {
        let terms = self.chain.terms();
        let (mut last, mut scratch) = (vec![0.0; terms], Vec::new());
        for row in GRID.last_coefficients() {
            for (index, value) in last.iter_mut().enumerate() {
                *value = dot(row, interval.term(index));
            }
            self.cut = self.cut.max(self.chain.beyond(in_contact, &last, &mut scratch));
        }
        self.joined = self.joined.max(interval.then);
    }

    /// Two neighbours as one, and what that changes in S at most, now and once they are free or in contact; none where now it would be more than is allowed.
    fn joined(
        &self,
        first: &Interval,
        second: &Interval,
        shares: &[f64],
        (in_contact, allowed): (bool, f64),
    ) -> Option<(Interval, [f64; 2])> {
        let (low, high) = (first.low, second.high);
        let terms = self.chain.terms();
        let mut whole = Interval { low, high, heights: [0.0; NODES], state: vec![0.0; terms * NODES], off: 0.0, then: 0.0, fresh: true };
        self.heights(&mut whole);
        for k in 0..NODES {
            let place = whole.place(k);
            let of = if place <= first.high { first } else { second };
            let weights = GRID.at(place - of.low, of.high - place);
            for index in 0..terms {
                if let Some(cell) = whole.state.get_mut(index * NODES + k) {
                    *cell = dot(&weights, of.term(index));
                }
            }
        }
        let (mut most, mut beyond) = (0.0_f64, 0.0_f64);
        let (mut difference, mut scratch) = (vec![0.0; terms], Vec::new());
        // The middle of both first: where it fails, it mostly fails at their border.
        for of in [first, second] {
            for k in (0..NODES).rev() {
                let place = of.place(k);
                let weights = GRID.at(place - low, high - place);
                let mut change = (dot(&weights, &whole.heights) - of.heights[k]).abs();
                for ((index, share), difference) in shares.iter().enumerate().zip(&mut difference) {
                    *difference = dot(&weights, whole.term(index)) - of.term(index).get(k).copied().unwrap_or(0.0);
                    change += share * difference.abs();
                }
                most = most.max(change);
                beyond = beyond.max(self.chain.beyond(in_contact, &difference, &mut scratch));
                if most > allowed {
                    return None;
                }
            }
        }
        Some((whole, [most, beyond]))
    }
}
