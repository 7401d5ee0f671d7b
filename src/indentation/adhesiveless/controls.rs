//! A force that only grows on a surface that nothing has touched: it gives Δ at once ([`Fresh`](super::fresh::Fresh)), which is then followed like a Δ that
//! is given, in polynomials.

use super::course::Course;
use super::drive::Drive;
use super::fresh::Moved;
use super::grid::NODES;
use super::line::Line;
use crate::indentation::history::Controlled;
use crate::indentation::stretch::Stretch;
use crate::refusal::Refusal;

/// Iterations of one unknown.
const MOST_ITERATIONS: u32 = 60;
/// A polynomial over less than this part of the time gone by is not shortened further: what it leaves counts as unknown.
const SHORTEST: f64 = 1e-3;
/// What rounding leaves of a polynomial, over the depth.
const ROUNDING: f64 = 1e-13;

impl<'a> Course<'a> {
    /// Goes towards a time of a stretch that controls the force.
    pub(super) fn toward(&mut self, stretch: &Stretch, target: f64) -> Result<(), Refusal> {
        let force = self.drive(stretch, target);
        let whole = force.duration;
        let moved = Moved { chain: self.chain, force, strains: self.line.whole_strains() };
        let start_time = self.time;
        let depth_at = |course: &Self, time: f64| course.fresh.depth(0.5 * moved.at(time));
        let reached = depth_at(self, whole)?;
        self.line.depth = self.line.depth.max(reached);
        let mut at = 0.0;
        if reached > 0.0 && self.line.radius() == 0.0 {
            // So short a time that nothing relaxes and little is pressed.
            let mut short = (1e-14 * self.chain.shortest_time()).min(1e-12 * whole);
            while short < 1e-3 * whole && depth_at(self, 4.0 * short)? <= 1e-12 * reached {
                short *= 4.0;
                if short > 1e-14 * self.chain.shortest_time() {
                    break;
                }
            }
            at = short.min(whole);
            let depth = depth_at(self, at)?;
            self.line.leap(depth)?;
        }
        let mut length = if at > 0.0 { 3.0 * at } else { whole };
        let allowed = (0.1 * self.fineness.series).max(ROUNDING) * reached;
        while at < whole {
            length = length.min(whole - at);
            if whole - at < 1.2 * length {
                length = whole - at;
            }
            let start = self.line.penetration;
            let mut failed = None;
            let drive = Drive::fitted(start, length, |time| {
                depth_at(self, at + time).unwrap_or_else(|refusal| {
                    failed = Some(refusal);
                    f64::NAN
                })
            });
            if let Some(refusal) = failed {
                return Err(refusal);
            }
            let mut off = 0.0_f64;
            for part in [0.03, 0.3, 0.62, 0.93] {
                off = off.max((drive.value(part * length) - depth_at(self, at + part * length)?).abs());
            }
            if off > allowed {
                if length > SHORTEST * at.max(1e-14 * whole) {
                    length *= 0.6;
                    continue;
                }
                self.line.joined += off;
            }
            self.along(&drive)?;
            at += length;
            self.time = start_time + at;
            if off < 0.02 * allowed {
                length *= 1.7;
            }
        }
        self.time = target;
        Ok(())
    }

    /// Meets an imposed value at once.
    pub(super) fn settle(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        if controlled == Controlled::Penetration {
            self.line.leap(value)?;
            return Ok(());
        }
        if value <= 0.0 {
            return Ok(());
        }
        // The force rises with Δ.
        let here = self.line.penetration;
        let size = self.fresh.depth(0.5 * value / self.chain.glassy)?.max(f64::MIN_POSITIVE);
        let excess = |course: &mut Self, depth: f64| -> Result<(f64, Line<'a>), Refusal> {
            course.evaluations += 1;
            let mut line = course.line.clone();
            line.leap(depth)?;
            let excess = line.force() - value;
            Ok((excess, line))
        };
        let (first, mut line) = excess(self, here)?;
        let (mut low, mut high) = ((here, first), (here, first));
        let mut way = size;
        for _ in 0..MOST_ITERATIONS {
            if low.1 <= 0.0 && high.1 >= 0.0 {
                break;
            }
            let depth = if low.1 > 0.0 { low.0 - way } else { high.0 + way };
            let (value, _) = excess(self, depth)?;
            if low.1 > 0.0 {
                high = low;
                low = (depth, value);
            } else {
                low = high;
                high = (depth, value);
            }
            way *= 2.0;
        }
        let mut side = 0;
        for _ in 0..MOST_ITERATIONS {
            if low.1 == 0.0 {
                high = low;
            }
            if high.0 - low.0 <= 2.0 * f64::EPSILON * high.0.abs().max(low.0.abs()) {
                break;
            }
            let chord = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            let depth = if chord > low.0 && chord < high.0 { chord } else { 0.5 * (low.0 + high.0) };
            let (value, after) = excess(self, depth)?;
            line = after;
            if value == 0.0 {
                (low, high) = ((depth, 0.0), (depth, 0.0));
                break;
            }
            if value < 0.0 {
                low = (depth, value);
                if side == -1 {
                    high.1 *= 0.5;
                }
                side = -1;
            } else {
                high = (depth, value);
                if side == 1 {
                    low.1 *= 0.5;
                }
                side = 1;
            }
        }
        let depth = if high.1.abs() < low.1.abs() { high.0 } else { low.0 };
        if line.penetration.to_bits() != depth.to_bits() {
            line = excess(self, depth)?.1;
        }
        self.line = line;
        Ok(())
    }

    /// A contact that has been held at a penetration until it has relaxed.
    pub(super) fn relaxed(&mut self, depth: f64) -> Result<(), Refusal> {
        if self.chain.relaxed == 0.0 && depth > 0.0 {
            return Err(Refusal::Undefined {
                quantity: "the relaxed contact",
                reason: "the material has no relaxed modulus: it flows for ever; start untouched and hold".into(),
            });
        }
        self.line.rested(depth)
    }
}

impl Line<'_> {
    /// S at a place now.
    pub(super) fn pressing_at(&self, place: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        if let Some(stretch) = self.contact.iter().find(|stretch| place <= stretch.high) {
            stretch.at(place, &mut state);
            let soft = self.chain.relaxed / self.chain.glassy * (self.penetration - self.profile.line(place));
            return soft + self.chain.maxwell.iter().zip(&state).map(|((modulus, _), u)| modulus / self.chain.glassy * u).sum::<f64>();
        }
        if let Some(stretch) = self.free.iter().find(|stretch| place <= stretch.high) {
            stretch.at(place, &mut state);
        }
        self.penetration - self.profile.line(place) - state.iter().sum::<f64>()
    }

    /// A relaxed contact at a penetration: no spring of a branch holds anything.
    pub(super) fn rested(&mut self, penetration: f64) -> Result<(), Refusal> {
        self.went_to(penetration);
        let edge = self.virgin_edge(penetration, 0.0)?;
        let mut stretches = Vec::new();
        if edge > 0.0 && penetration > 0.0 {
            self.build((0.0, edge), true, &mut |_, _, state| state.fill(0.0), &mut stretches);
        }
        self.contact = stretches;
        Ok(())
    }

    /// The least of what must not be negative, Q/E∞* inside and D outside (m), and what Q leaves at the edge, over the depth.
    pub(super) fn least(&self) -> (f64, f64) {
        let mut least = f64::INFINITY;
        let mut at_edge = 0.0;
        for stretch in &self.contact {
            let load = self.load(stretch);
            least = load.iter().fold(least, |least: f64, q| least.min(q / self.chain.glassy));
            at_edge = load[NODES - 1] / self.chain.glassy;
        }
        if self.radius() >= self.profile.rim() {
            // A rim may be pressed.
            at_edge = 0.0;
        }
        for stretch in &self.free {
            for (k, height) in stretch.heights.iter().enumerate() {
                let surface: f64 = (0..self.chain.terms()).map(|index| stretch.term(index).get(k).copied().unwrap_or(0.0)).sum();
                least = least.min(surface - (self.penetration - height));
            }
        }
        if self.free.is_empty() && self.radius() < self.profile.rim() {
            least = least.min(self.profile.line(self.radius()) - self.penetration);
        }
        let depth = if self.depth > 0.0 { self.depth } else { 1.0 };
        (least, at_edge / depth)
    }

    /// The largest difference of two lines in any strain of a dashpot (m).
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let terms = self.chain.terms();
        let (mut own, mut theirs, mut scratch) = (vec![0.0; terms], vec![0.0; terms], Vec::new());
        let mut most = 0.0_f64;
        let dashpots = |line: &Self, place: f64, state: &mut [f64], scratch: &mut Vec<f64>| {
            if let Some(stretch) = line.contact.iter().find(|stretch| place <= stretch.high) {
                stretch.at(place, state);
                let under = line.penetration - line.profile.line(place);
                for u in state.iter_mut() {
                    *u = under - *u;
                }
            } else {
                match line.free.iter().find(|stretch| place <= stretch.high) {
                    Some(stretch) => stretch.at(place, state),
                    None => state.fill(0.0),
                }
                line.chain.touched(0.0, state, scratch);
                for u in state.iter_mut() {
                    *u = -*u;
                }
            }
        };
        for (one, another) in [(self, other), (other, self)] {
            for stretch in one.contact.iter().chain(&one.free) {
                for k in 0..NODES {
                    let place = stretch.place(k);
                    dashpots(one, place, &mut own, &mut scratch);
                    dashpots(another, place, &mut theirs, &mut scratch);
                    most = own.iter().zip(&theirs).fold(most, |most, (own, theirs)| most.max((own - theirs).abs()));
                }
            }
        }
        most
    }
}
