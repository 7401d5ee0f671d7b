//! What a held load or penetration finds on the equilibrium curve: its contacts, which of them are stable, and where such contacts end.
//!
//! ```text
//! M_ij = ∂(work_i/2πΓ)/∂l_j at what is held       stable if M₁₁ > 0, M₂₂ > 0, det M > 0         (see the second variations of branches)
//! ```
//! Along the curve both works stay what they are, so that ∂work/∂a = −(∂work/∂e de/da + ∂work/∂p̄ dp̄/da): the slopes of the curve and the two forms give M.

use super::curve::EquilibriumCurve;
use super::width::{Point, apart};
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::SlidingControl;
use std::f64::consts::FRAC_PI_2;

/// Steps of the search for a turn; an error of the place enters the value squared.
const TURN_STEPS: usize = 24;
/// A turn this many times its uncertainty away from the held value is on its side of it.
const FAR_FROM_HELD: f64 = 30.0;
/// What a turn is told from: its neighbours are nearer to each other than this, or its value is known to the second.
const TURN_BRACKET: f64 = 0.8;
/// See [`TURN_BRACKET`].
const TURN_VALUE: f64 = 1e-11;
/// Parts of a bracket more uneven than this are evened.
const LOPSIDED: f64 = 4.0;
/// A turn is found where its place is known to this.
const TURN_PLACE: f64 = 1e-5;
/// Steps between two neighbours to a crossing.
const CROSSING_STEPS: usize = 40;
/// A crossing is found where the bracket is this narrow, in ln tan(a/2).
const CROSSING_PLACE: f64 = 1e-8;
/// How far beyond the last point of a chain no contact is any more, in ln tan(a/2): more than the finest spacing.
const END_STEP: f64 = 0.2;
/// Largest change of eccentricity between neighbours where it matters, of a parabola over the half-width.
const BEND: f64 = 0.12;
/// Nearer places are not divided, in ln tan(a/2).
const SHORTEST_BEND: f64 = 0.01;
/// Halvings between a stable contact and one that is not.
const STABILITY_HALVINGS: usize = 30;
/// Halvings towards the end of a chain.
const END_HALVINGS: usize = 30;
/// What is held at a crossing is off by at most this part of its distance to the neighbours.
const CROSSING: f64 = 1e-6;
/// Distance of the places that the slope of the curve is taken between.
const SLOPE_STEP: f64 = 1e-3;

/// What is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum HeldQuantity {
    /// p̄.
    MeanPressure,
    /// Δ − 1 of a wave.
    Penetration,
}

impl HeldQuantity {
    /// A held value as a control.
    pub(super) const fn control(self, value: f64, indenter: Indenter) -> SlidingControl {
        match (self, indenter) {
            (Self::MeanPressure, _) => SlidingControl::MeanPressure(value),
            (Self::Penetration, Indenter::Wave) => SlidingControl::Penetration(1.0 + value),
            (Self::Penetration, Indenter::Parabola) => SlidingControl::Penetration(value),
        }
    }

    pub(super) fn of(self, point: &Point) -> f64 {
        match self {
            Self::MeanPressure => point.mean_pressure,
            Self::Penetration => point.depth,
        }
    }
}

/// A contact of what is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sliding) struct Crossing {
    /// ln tan(a/2), of a parabola ln(a/2).
    pub(in crate::sliding) place: f64,
    /// a.
    pub(in crate::sliding) half_width: f64,
    /// e.
    pub(in crate::sliding) eccentricity: f64,
    /// p̄.
    pub(in crate::sliding) mean_pressure: f64,
    /// Whether it is stable under what is held; not known at a turn of the half-width.
    pub(in crate::sliding) stable: Option<bool>,
    /// The half-widths of the contacts that it lies between.
    pub(in crate::sliding) between: [f64; 2],
}

/// How a stretch of stable contacts ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::sliding) enum End {
    /// What is held turns: a fold.
    Turn,
    /// The curve ends, or its contacts go on unstable without a turn.
    Last,
}

/// A contact where a stretch ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sliding) struct StretchEnd {
    pub(in crate::sliding) end: End,
    /// What is held there.
    pub(in crate::sliding) value: f64,
    pub(in crate::sliding) place: f64,
    pub(in crate::sliding) half_width: f64,
    pub(in crate::sliding) eccentricity: f64,
    pub(in crate::sliding) mean_pressure: f64,
    /// Its neighbours on the curve, inside the stretch and beyond its end, if there are any.
    pub(in crate::sliding) neighbours: [Option<(f64, f64)>; 2],
}

/// Stable contacts next to each other on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sliding) struct Stretch {
    /// The smallest value of what is held.
    pub(in crate::sliding) lowest: StretchEnd,
    /// The largest.
    pub(in crate::sliding) highest: StretchEnd,
}

/// What is found of a held value.
#[derive(Debug, Clone)]
pub(in crate::sliding) struct Held {
    /// The contacts, narrow ones first.
    pub(in crate::sliding) crossings: Vec<Crossing>,
    /// The largest value of any contact about the crest, stable or not; none without contacts.
    pub(in crate::sliding) largest: Option<StretchEnd>,
}

impl EquilibriumCurve {
    /// The contacts of a held value.
    pub(in crate::sliding) fn held(&self, quantity: HeldQuantity, value: f64) -> Held {
        let mut found = Held { crossings: Vec::new(), largest: None };
        for chain in &self.chains {
            let chain = self.followed(quantity, value, chain);
            // A contact on the other side of the trough says nothing of one on the crest.
            for point in chain.iter().filter(|point| point.eccentricity.abs() < FRAC_PI_2) {
                if found.largest.is_none_or(|largest| quantity.of(point) > largest.value) {
                    found.largest = Some(end_at(quantity, point, End::Last, [None; 2]));
                }
            }
            for pair in chain.windows(2) {
                let [from, to] = pair else { continue };
                let (before, after) = (quantity.of(from) - value, quantity.of(to) - value);
                // A value met exactly belongs to one of both sides.
                if (before <= 0.0) == (after <= 0.0) {
                    continue;
                }
                found.crossings.push(self.crossing(quantity, value, from, to));
            }
        }
        found.crossings.sort_by(|first, second| first.half_width.total_cmp(&second.half_width));
        found
    }

    /// The stretches of stable contacts, narrow ones first; located as well as it takes to compare them with a held value.
    pub(in crate::sliding) fn stable_stretches(&self, quantity: HeldQuantity, value: f64) -> Vec<Stretch> {
        let mut found = Vec::new();
        for chain in &self.chains {
            self.stretches(quantity, &self.followed(quantity, value, chain), &mut found);
        }
        found.sort_by(|first, second| first.lowest.half_width.total_cmp(&second.lowest.half_width));
        found
    }

    /// A chain as far as it goes, as finely as it bends, with its turns.
    fn followed(&self, quantity: HeldQuantity, value: f64, chain: &[Point]) -> Vec<Point> {
        let ends = self.with_ends(quantity, value, chain);
        // Contacts of a penetration stay beyond the turn of the half-width, where the eccentricity changes most.
        let bends = if quantity == HeldQuantity::Penetration { self.with_bends(ends) } else { ends };
        self.with_turns(quantity, value, &bends)
    }

    /// A chain as far as it goes, where the value may lie between its last point and its end.
    fn with_ends(&self, quantity: HeldQuantity, value: f64, chain: &[Point]) -> Vec<Point> {
        let mut all = chain.to_vec();
        for _ in 0..2 {
            if let [.., before, last] = all[..] {
                let (step, off) = (quantity.of(&last) - quantity.of(&before), value - quantity.of(&last));
                if step * off >= 0.0 && off.abs() <= step.abs() {
                    all.extend(self.last_of_chain(&before, &last));
                }
            }
            all.reverse();
        }
        all
    }

    /// A chain of which no two neighbours differ much in eccentricity, as far as that can be.
    fn with_bends(&self, chain: Vec<Point>) -> Vec<Point> {
        let indenter = self.every.indenter();
        let mut all: Vec<Point> = Vec::with_capacity(2 * chain.len());
        for point in chain {
            let mut open = vec![point];
            while let Some(next) = open.pop() {
                let bent = |last: &Point| {
                    let size = if indenter == Indenter::Wave { 1.0 } else { last.half_width };
                    apart(indenter, last.eccentricity, next.eccentricity) > BEND * size && (next.place - last.place).abs() > SHORTEST_BEND
                };
                let middle = all
                    .last()
                    .filter(|last| bent(last))
                    .and_then(|last| self.beside(0.5 * (last.place + next.place), 0.5 * (last.eccentricity + next.eccentricity)));
                match middle {
                    Some(middle) => open.extend([next, middle]),
                    None => all.push(next),
                }
            }
        }
        all
    }

    /// The last contact of a chain whose edges are pulled, beyond its last point; none if that is it, to the finest spacing.
    fn last_of_chain(&self, before: &Point, last: &Point) -> Option<Point> {
        let outward = (last.place - before.place).signum();
        let tilt = (last.eccentricity - before.eccentricity) / (last.place - before.place);
        let (mut good, mut bad) = (*last, last.place + outward * END_STEP);
        if !tilt.is_finite() || self.beside(bad, last.eccentricity).is_some() {
            return None;
        }
        for _ in 0..END_HALVINGS {
            let middle = 0.5 * (good.place + bad);
            match self.beside(middle, good.eccentricity) {
                Some(point) => good = point,
                None => bad = middle,
            }
        }
        (good != *last).then_some(good)
    }

    /// A chain with the contacts at which what is held turns.
    fn with_turns(&self, quantity: HeldQuantity, held: f64, chain: &[Point]) -> Vec<Point> {
        let mut all = Vec::with_capacity(chain.len() + 4);
        for (index, point) in chain.iter().enumerate() {
            let neighbours = index.checked_sub(1).and_then(|before| chain.get(before)).zip(chain.get(index + 1));
            let Some((before, after)) = neighbours else {
                all.push(*point);
                continue;
            };
            let [one, here, other] = [before, point, after].map(|point| quantity.of(point));
            let turns = (here > one && here >= other) || (here < one && here <= other);
            match turns.then(|| self.turn(quantity, Some(held), [*before, *point, *after])).flatten() {
                Some(turn) if turn.place.total_cmp(&point.place).is_eq() => all.push(*point),
                // In the order of the chain.
                Some(turn) if (turn.place - point.place) * (after.place - before.place) < 0.0 => all.extend([turn, *point]),
                Some(turn) => all.extend([*point, turn]),
                None => all.push(*point),
            }
        }
        all
    }

    /// The turn between three neighbours, by parabolas through the best three, as well as it takes to see on which side of a held value it is; none where the half-width turns
    /// as well.
    fn turn(&self, quantity: HeldQuantity, held: Option<f64>, [before, here, after]: [Point; 3]) -> Option<Point> {
        let sign = if quantity.of(&here) >= quantity.of(&before) { 1.0 } else { -1.0 };
        let mut three = if before.place < after.place { [before, here, after] } else { [after, here, before] };
        if !(three[0].place < three[1].place && three[1].place < three[2].place) {
            return None;
        }
        for _ in 0..TURN_STEPS {
            let [low, middle, high] = three;
            let [x, y, z] = three.map(|point| point.place);
            let [f, g, h] = three.map(|point| sign * quantity.of(&point));
            // The parabola through all three: its vertex, and how far that is above the best of them.
            let (left, right) = ((y - x) * (g - h), (y - z) * (g - f));
            let vertex = y - 0.5 * ((y - x) * left - (y - z) * right) / (left - right);
            let bend = ((h - g) / (z - y) - (g - f) / (y - x)) / (z - x);
            let above = (bend * (vertex - y) * (vertex - y)).abs();
            if !vertex.is_finite() || z - x < TURN_PLACE {
                break;
            }
            let clear = held.is_some_and(|held| FAR_FROM_HELD * above < (sign * held - g).abs());
            let known = z - x < TURN_BRACKET && (clear || above < TURN_VALUE * (1.0 + g.abs()));
            if known {
                break;
            }
            // A vertex on a known place, or always on one side of it: the longer part in two.
            let least = 1e-3 * (z - x);
            let lopsided = (y - x).max(z - y) > LOPSIDED * (y - x).min(z - y);
            let next = if lopsided || (vertex - y).abs() < least {
                if z - y > y - x { y + 0.5 * (z - y).min(LOPSIDED * (y - x)) } else { y - 0.5 * (y - x).min(LOPSIDED * (z - y)) }
            } else {
                vertex.clamp(x + least, z - least)
            };
            let between = |one: &Point, other: &Point| {
                one.eccentricity + (next - one.place) / (other.place - one.place) * (other.eccentricity - one.eccentricity)
            };
            let point = self.beside(next, if next < y { between(&low, &middle) } else { between(&middle, &high) })?;
            three = match (next < y, sign * quantity.of(&point) > g) {
                (true, true) => [low, point, middle],
                (true, false) => [point, middle, high],
                (false, true) => [middle, point, high],
                (false, false) => [low, middle, point],
            };
        }
        Some(three[1])
    }

    /// The contact of a value between two neighbours.
    fn crossing(&self, quantity: HeldQuantity, value: f64, from: &Point, to: &Point) -> Crossing {
        let rises = quantity.of(to) > quantity.of(from);
        let between = [from.half_width.min(to.half_width), from.half_width.max(to.half_width)];
        let (mut low, mut high) = if rises { (*from, *to) } else { (*to, *from) };
        let (mut below, mut above) = (quantity.of(&low) - value, quantity.of(&high) - value);
        // Near a turn its other side has a contact of the value as well: nearer than that.
        let near = CROSSING * below.abs().min(above.abs());
        let part = |below: f64, above: f64| below / (below - above);
        let mut kept = 0;
        for step in 0..CROSSING_STEPS {
            if (high.place - low.place).abs() < CROSSING_PLACE {
                break;
            }
            let part = if step % 4 == 3 { 0.5 } else { part(below, above).clamp(0.01, 0.99) };
            let eccentricity = low.eccentricity + part * (high.eccentricity - low.eccentricity);
            let Some(point) = self.beside(low.place + part * (high.place - low.place), eccentricity) else { break };
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
        // Away from a turn of the half-width the sign of the slope is that of both neighbours.
        let slope = (to.place - from.place).abs() > 0.0;
        let stable = slope.then(|| {
            let sign = if (to.place > from.place) == rises { 1.0 } else { -1.0 };
            self.is_stable(quantity, &low, sign, tilt(from, to))
        });
        Crossing {
            place: mix(low.place, high.place),
            half_width: mix(low.half_width, high.half_width),
            eccentricity: mix(low.eccentricity, high.eccentricity),
            mean_pressure: mix(low.mean_pressure, high.mean_pressure),
            stable,
            between,
        }
    }

    /// Whether a contact is stable, where what is held rises (or falls) with the half-width and the eccentricity follows the place by a tilt.
    fn is_stable(&self, quantity: HeldQuantity, point: &Point, sign: f64, tilt: f64) -> bool {
        let beside = [-SLOPE_STEP, SLOPE_STEP].map(|step| self.beside(point.place + step, point.eccentricity + tilt * step));
        let (one, other) = match beside {
            [Some(one), Some(other)] => (one, other),
            [Some(one), None] => (one, *point),
            [None, Some(other)] => (*point, other),
            [None, None] => return false,
        };
        held_by(self.every.indenter(), quantity, point, [&one, &other], Some(sign))
    }

    /// The turn at the end of a stretch, located.
    pub(in crate::sliding) fn located_turn(&self, quantity: HeldQuantity, end: &StretchEnd) -> StretchEnd {
        let [Some(inside), Some(beyond)] = end.neighbours else { return *end };
        let three = [inside, (end.place, end.eccentricity), beyond].map(|(place, eccentricity)| self.beside(place, eccentricity));
        let [Some(one), Some(here), Some(other)] = three else { return *end };
        match self.turn(quantity, None, [one, here, other]) {
            Some(turn) => end_at(quantity, &turn, End::Turn, [Some(&one), Some(&other)]),
            None => *end,
        }
    }

    /// The last value of a stretch that ends because its contacts go on unstable without a turn; none if it ends otherwise.
    pub(in crate::sliding) fn last_stable(&self, quantity: HeldQuantity, end: &StretchEnd) -> Option<f64> {
        let [Some(inside), Some(beyond)] = end.neighbours else { return None };
        let at = |(place, eccentricity): (f64, f64)| self.beside(place, eccentricity);
        let (mut good, mut bad) = (at(inside)?, at(beyond)?);
        let sign = ((quantity.of(&bad) - quantity.of(&good)) * (bad.place - good.place)).signum();
        let tilt = tilt(&good, &bad);
        if !self.is_stable(quantity, &good, sign, tilt) || self.is_stable(quantity, &bad, sign, tilt) {
            return None;
        }
        for _ in 0..STABILITY_HALVINGS {
            let middle = at((0.5 * (good.place + bad.place), 0.5 * (good.eccentricity + bad.eccentricity)))?;
            if self.is_stable(quantity, &middle, sign, tilt) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        Some(quantity.of(&good))
    }

    /// The stable stretches of a chain.
    fn stretches(&self, quantity: HeldQuantity, chain: &[Point], found: &mut Vec<Stretch>) {
        // Half way between neighbours, where a turn at one of them does not blur the signs.
        let middles: Vec<Option<Point>> = chain
            .windows(2)
            .map(|pair| match pair {
                [from, to] if (to.place - from.place).abs() > 0.0 => {
                    let middle = self.beside(0.5 * (from.place + to.place), 0.5 * (from.eccentricity + to.eccentricity))?;
                    let sign = ((quantity.of(to) - quantity.of(from)) * (to.place - from.place)).signum();
                    self.is_stable(quantity, &middle, sign, tilt(from, to)).then_some(middle)
                }
                _ => None,
            })
            .collect();
        let stable: Vec<bool> = middles.iter().map(Option::is_some).collect();
        let mut begin = 0;
        while begin < stable.len() {
            if !stable[begin] {
                begin += 1;
                continue;
            }
            let rises = |index: usize| quantity.of(&chain[index + 1]) > quantity.of(&chain[index]);
            let mut end = begin + 1;
            while end < stable.len() && stable[end] && rises(end) == rises(begin) {
                end += 1;
            }
            let how = |index: usize| {
                if index == 0 || index + 1 == chain.len() {
                    return End::Last;
                }
                let [one, here, other] = [index - 1, index, index + 1].map(|index| quantity.of(&chain[index]));
                if (here >= one) == (here >= other) { End::Turn } else { End::Last }
            };
            let before = begin.checked_sub(1).and_then(|before| chain.get(before));
            let first = end_at(quantity, &chain[begin], how(begin), [middles[begin].as_ref(), before]);
            let last = end_at(quantity, &chain[end], how(end), [middles[end - 1].as_ref(), chain.get(end + 1)]);
            let (lowest, highest) = if first.value <= last.value { (first, last) } else { (last, first) };
            found.push(Stretch { lowest, highest });
            begin = end;
        }
    }
}

/// How the eccentricity follows the place between two contacts.
fn tilt(from: &Point, to: &Point) -> f64 {
    let tilt = (to.eccentricity - from.eccentricity) / (to.place - from.place);
    if tilt.is_finite() { tilt } else { 0.0 }
}

fn end_at(quantity: HeldQuantity, point: &Point, end: End, neighbours: [Option<&Point>; 2]) -> StretchEnd {
    StretchEnd {
        end,
        neighbours: neighbours.map(|neighbour| neighbour.map(|point| (point.place, point.eccentricity))),
        value: quantity.of(point),
        place: point.place,
        half_width: point.half_width,
        eccentricity: point.eccentricity,
        mean_pressure: point.mean_pressure,
    }
}

/// Whether a contact is stable, from the slopes of the curve between two neighbours; `sign` is that of the slope of what is held, if it is known better.
fn held_by(indenter: Indenter, quantity: HeldQuantity, point: &Point, [from, to]: [&Point; 2], sign: Option<f64>) -> bool {
    let width = to.half_width - from.half_width;
    let mut shift = to.eccentricity - from.eccentricity;
    if indenter == Indenter::Wave {
        shift -= 2.0 * std::f64::consts::PI * (shift / (2.0 * std::f64::consts::PI)).round();
    }
    let slope = |quantity: HeldQuantity| (quantity.of(to) - quantity.of(from)) / width;
    let (ahead, mut pressed) = (shift / width, slope(HeldQuantity::MeanPressure));
    if let (HeldQuantity::MeanPressure, Some(sign)) = (quantity, sign) {
        pressed = sign * pressed.abs();
    }
    // Derivatives by a and e at the load; then at the penetration.
    let [by_depth_shift, by_depth_load] = point.depth_slopes;
    let rows = [0, 1].map(|edge| {
        let (by_shift, by_load) = (point.by_shift[edge], point.by_load[edge]);
        let by_width = -(by_shift * ahead + by_load * pressed);
        match quantity {
            HeldQuantity::MeanPressure => (by_width, by_shift),
            HeldQuantity::Penetration => {
                let mut deeper = slope(HeldQuantity::Penetration);
                if let Some(sign) = sign {
                    deeper = sign * deeper.abs();
                }
                // ∂Δ/∂a at e and p̄, from the slope of the curve.
                let by_depth_width = deeper - by_depth_shift * ahead - by_depth_load * slope(HeldQuantity::MeanPressure);
                let load = by_load / by_depth_load;
                (by_width - load * by_depth_width, by_shift - load * by_depth_shift)
            }
        }
    });
    // An edge moves out by one: half of it wider, and the middle by half of it to that side.
    let [[a, b], [c, d]] = rows.map(|(wider, ahead)| [0.5 * (wider - ahead), 0.5 * (wider + ahead)]);
    a > 0.0 && d > 0.0 && a * d - b * c > 0.0
}
