//! What a held load or penetration finds on the equilibrium curve: its contacts, which of them are stable, and where such contacts end.

use super::curve::EquilibriumCurve;
use super::existence::Place;
use super::point::{HeldQuantity, Point};
use super::width::change;
use std::f64::consts::FRAC_PI_2;

/// Steps of the searches between two neighbours.
const STEPS: usize = 40;
/// A turn is found where its place is known to this: an error of the place enters the value squared.
const TURN_PLACE: f64 = 1e-6;
/// A crossing is found where the bracket is this narrow, in ln tan(a/2).
const CROSSING_PLACE: f64 = 1e-9;
/// What is held at a crossing is off by at most this part of its distance to the neighbours.
const CROSSING: f64 = 1e-6;
/// Smaller margins of stability, as they are at turns, have no sign.
const NO_MARGIN: f64 = 1e-4;

/// A contact of what is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sliding) struct Crossing {
    /// ln tan(a/2), of a parabola ln(a/2).
    pub(in crate::sliding) place: f64,
    /// a.
    pub(in crate::sliding) half_width: f64,
    /// e.
    pub(in crate::sliding) eccentricity: f64,
    /// Whether it is stable under what is held.
    pub(in crate::sliding) stable: bool,
    /// The half-widths of the contacts that it lies between.
    pub(in crate::sliding) between: [f64; 2],
}

/// How a segment of stable contacts ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum End {
    /// What is held turns: a fold.
    Turn,
    /// One edge alone becomes unstable, and nothing turns.
    Stability,
    /// The curve ends.
    Last,
}

/// A contact where a segment ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sliding) struct SegmentEnd {
    pub(in crate::sliding) end: End,
    /// What is held there.
    pub(in crate::sliding) value: f64,
    pub(in crate::sliding) place: f64,
    pub(in crate::sliding) half_width: f64,
    pub(in crate::sliding) eccentricity: f64,
    pub(in crate::sliding) mean_pressure: f64,
}

/// Stable contacts next to each other on the curve.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sliding) struct StableSegment {
    /// The smallest value of what is held.
    pub(in crate::sliding) lowest: SegmentEnd,
    /// The largest.
    pub(in crate::sliding) highest: SegmentEnd,
    /// What is held, and the place, of all contacts from the lowest to the highest.
    pub(in crate::sliding) along: Vec<(f64, Place)>,
}

impl EquilibriumCurve {
    /// The contacts of a held value, narrow ones first.
    pub(in crate::sliding) fn held(&self, quantity: HeldQuantity, value: f64) -> Vec<Crossing> {
        let mut found = Vec::new();
        for chain in &self.chains {
            // A turn that the value is beyond of needs no place.
            let chain = self.with_turns(quantity, chain, |from, to| may_reach(quantity, value, from, to));
            for pair in chain.windows(2) {
                let [from, to] = pair else { continue };
                let (before, after) = (quantity.of(from) - value, quantity.of(to) - value);
                // A value met exactly belongs to one of both sides.
                if (before <= 0.0) != (after <= 0.0) {
                    found.push(self.crossing(quantity, value, from, to));
                }
            }
        }
        found.sort_by(|first, second| first.half_width.total_cmp(&second.half_width));
        found
    }

    /// The largest value of any contact about the crest, stable or not; none without contacts.
    pub(in crate::sliding) fn largest(&self, quantity: HeldQuantity) -> Option<SegmentEnd> {
        let chains = self.chains.iter().flat_map(|chain| self.with_turns(quantity, chain, |_, _| true));
        // A contact on the other side of the trough says nothing of one on the crest.
        let about_the_crest = chains.filter(|point| point.eccentricity.abs() < FRAC_PI_2);
        let largest = about_the_crest.max_by(|first, second| quantity.of(first).total_cmp(&quantity.of(second)));
        largest.map(|point| end_at(quantity, &point, End::Last))
    }

    /// The segments of stable contacts, narrow ones first.
    pub(in crate::sliding) fn stable_segments(&self, quantity: HeldQuantity) -> Vec<StableSegment> {
        let mut found = Vec::new();
        for chain in &self.chains {
            self.segments(quantity, &self.with_borders(quantity, self.with_turns(quantity, chain, |_, _| true)), &mut found);
        }
        found.sort_by(|first, second| first.lowest.half_width.total_cmp(&second.lowest.half_width));
        found
    }

    /// A chain with the contacts at which what is held turns, between neighbours where it matters.
    fn with_turns(&self, quantity: HeldQuantity, chain: &[Point], matters: impl Fn(&Point, &Point) -> bool) -> Vec<Point> {
        let turns = |one: &Point, other: &Point| quantity.rise(one) * quantity.rise(other) < 0.0;
        self.with_more(chain, |from, to| {
            if turns(from, to) && matters(from, to) { self.divided(from, to, TURN_PLACE, |point| quantity.slope(point)) } else { None }
        })
    }

    /// A chain with the contacts at which stability begins or ends without a turn.
    fn with_borders(&self, quantity: HeldQuantity, chain: Vec<Point>) -> Vec<Point> {
        let indenter = self.every.indenter();
        self.with_more(&chain, |from, to| {
            let resolved = [from, to].iter().all(|point| point.margin(indenter, quantity).abs() > NO_MARGIN);
            if resolved { self.divided(from, to, TURN_PLACE, |point| point.margin(indenter, quantity)) } else { None }
        })
    }

    fn with_more(&self, chain: &[Point], between: impl Fn(&Point, &Point) -> Option<Point>) -> Vec<Point> {
        let mut all = Vec::with_capacity(chain.len() + 4);
        for (index, point) in chain.iter().enumerate() {
            all.push(*point);
            all.extend(chain.get(index + 1).and_then(|next| between(point, next)));
        }
        all
    }

    /// The contact between two neighbours at which a function changes its sign; none if it has the same at both.
    fn divided(&self, from: &Point, to: &Point, shortest: f64, function: impl Fn(&Point) -> f64) -> Option<Point> {
        let (mut low, mut high) = (*from, *to);
        let (mut at_low, mut at_high) = (function(&low), function(&high));
        if (at_low < 0.0) == (at_high < 0.0) {
            return None;
        }
        let mut kept = 0;
        for step in 0..STEPS {
            if (high.place - low.place).abs() < shortest {
                break;
            }
            let part = if step % 4 == 3 { 0.5 } else { (at_low / (at_low - at_high)).clamp(0.01, 0.99) };
            let middle = self.part_way(&low, &high, part)?;
            let value = function(&middle);
            if (value < 0.0) == (at_low < 0.0) {
                (low, at_low) = (middle, value);
                if kept == -1 {
                    at_high *= 0.5;
                }
                kept = -1;
            } else {
                (high, at_high) = (middle, value);
                if kept == 1 {
                    at_low *= 0.5;
                }
                kept = 1;
            }
            if value == 0.0 {
                return Some(middle);
            }
        }
        Some(if at_low.abs() < at_high.abs() { low } else { high })
    }

    /// The contact at a part of the way between two.
    fn part_way(&self, low: &Point, high: &Point, part: f64) -> Option<Point> {
        let eccentricity = low.eccentricity + part * change(self.every.indenter(), low.eccentricity, high.eccentricity);
        self.beside(low.place + part * (high.place - low.place), eccentricity)
    }

    /// The contact of a value between two neighbours.
    fn crossing(&self, quantity: HeldQuantity, value: f64, from: &Point, to: &Point) -> Crossing {
        let between = [from.half_width.min(to.half_width), from.half_width.max(to.half_width)];
        let (mut low, mut high) = if quantity.of(to) > quantity.of(from) { (*from, *to) } else { (*to, *from) };
        let (mut below, mut above) = (quantity.of(&low) - value, quantity.of(&high) - value);
        // Near a turn its other side has a contact of the value as well: nearer than that.
        let near = CROSSING * below.abs().min(above.abs());
        let part = |below: f64, above: f64| below / (below - above);
        let mut kept = 0;
        for step in 0..STEPS {
            if (high.place - low.place).abs() < CROSSING_PLACE {
                break;
            }
            let part = if step % 4 == 3 { 0.5 } else { part(below, above).clamp(0.01, 0.99) };
            let Some(point) = self.part_way(&low, &high, part) else { break };
            let off = quantity.of(&point) - value;
            if off <= 0.0 {
                (low, below) = (point, off);
                if kept == -1 {
                    above *= 0.5;
                }
                kept = -1;
            } else {
                (high, above) = (point, off);
                if kept == 1 {
                    below *= 0.5;
                }
                kept = 1;
            }
            if off.abs() <= near {
                (low, high) = (point, point);
                break;
            }
        }
        let part = if low == high { 0.0 } else { part(quantity.of(&low) - value, quantity.of(&high) - value) };
        let mix = |one: f64, other: f64| one + part * (other - one);
        Crossing {
            place: mix(low.place, high.place),
            half_width: mix(low.half_width, high.half_width),
            eccentricity: mix(low.eccentricity, high.eccentricity),
            stable: self.clearer_margin(quantity, &low, &high) > 0.0,
            between,
        }
    }

    /// The margin of stability of two neighbours of one sign: the one that is further from zero.
    fn clearer_margin(&self, quantity: HeldQuantity, from: &Point, to: &Point) -> f64 {
        let [one, other] = [from, to].map(|point| point.margin(self.every.indenter(), quantity));
        if one.abs() > other.abs() { one } else { other }
    }

    /// The stable segments of a chain.
    fn segments(&self, quantity: HeldQuantity, chain: &[Point], found: &mut Vec<StableSegment>) {
        let stable: Vec<bool> = chain
            .windows(2)
            .map(|pair| match pair {
                [from, to] => {
                    let margin = self.clearer_margin(quantity, from, to);
                    // Between two turns it is shown by what lies between.
                    let resolved = if margin.abs() > NO_MARGIN { None } else { self.part_way(from, to, 0.5) };
                    resolved.map_or(margin, |middle| middle.margin(self.every.indenter(), quantity)) > 0.0
                }
                _ => false,
            })
            .collect();
        let rises = |index: usize| quantity.of(&chain[index + 1]) > quantity.of(&chain[index]);
        let mut begin = 0;
        while begin < stable.len() {
            if !stable[begin] {
                begin += 1;
                continue;
            }
            let mut end = begin + 1;
            while end < stable.len() && stable[end] && rises(end) == rises(begin) {
                end += 1;
            }
            let how = |index: usize| {
                if index == 0 || index + 1 == chain.len() {
                    End::Last
                } else if rises(index - 1) == rises(index) {
                    End::Stability
                } else {
                    End::Turn
                }
            };
            let (first, last) = (end_at(quantity, &chain[begin], how(begin)), end_at(quantity, &chain[end], how(end)));
            let mut along: Vec<(f64, Place)> =
                chain[begin..=end].iter().map(|point| (quantity.of(point), (point.place, point.eccentricity))).collect();
            let (lowest, highest) = if first.value <= last.value { (first, last) } else { (last, first) };
            if first.value > last.value {
                along.reverse();
            }
            found.push(StableSegment { lowest, highest, along });
            begin = end;
        }
    }
}

/// Whether a value may be met between two neighbours: the one turn there may be is not beyond what the steeper slope of both reaches.
fn may_reach(quantity: HeldQuantity, value: f64, from: &Point, to: &Point) -> bool {
    let reach = (to.place - from.place).abs() * quantity.slope(from).abs().max(quantity.slope(to).abs());
    let (one, other) = (quantity.of(from), quantity.of(to));
    !(value < one.min(other) - reach || value > one.max(other) + reach)
}

fn end_at(quantity: HeldQuantity, point: &Point, end: End) -> SegmentEnd {
    SegmentEnd {
        end,
        value: quantity.of(point),
        place: point.place,
        half_width: point.half_width,
        eccentricity: point.eccentricity,
        mean_pressure: point.mean_pressure,
    }
}
