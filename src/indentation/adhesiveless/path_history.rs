//! What the edge does to the chains that it passes: each at its own time.

use super::chain::Chain;
use super::drive::{Drive, decayed};
use super::edge::Way;
use super::grid::{GRID, NODES, Nodal};
use super::line::{Interval, Line, NARROWEST};
use super::moment::Moment;
use super::times::{Guesses, leaving, touching};
use crate::refusal::Refusal;

/// Where the edge is imposed to be: a quantity that goes one way, from a time of it on.
#[derive(Clone, Copy)]
pub(super) struct Edge<'e> {
    pub(super) given: &'e Drive,
    pub(super) since: f64,
}

impl Edge<'_> {
    fn place(&self, time: f64) -> f64 {
        self.given.value(self.since + time).max(0.0)
    }

    /// When it passes a place, within a duration.
    fn time(&self, place: f64, duration: f64) -> f64 {
        let outwards = self.place(duration) > self.place(0.0);
        let (mut low, mut high) = (0.0, duration);
        let (mut below, mut above) = (self.place(low) - place, self.place(high) - place);
        while high - low > f64::EPSILON * duration {
            let chord = low - below * (high - low) / (above - below);
            // A chord and its mirror enclose the root of what is nearly straight; a half is the way out.
            for time in [chord, chord + 1e-3 * (high - low), chord - 1e-3 * (high - low), 0.5 * (low + high)] {
                if time > low && time < high {
                    let value = self.place(time) - place;
                    if value == 0.0 {
                        return time;
                    }
                    if (value < 0.0) == outwards { (low, below) = (time, value) } else { (high, above) = (time, value) }
                }
            }
            if 0.5 * (low + high) <= low || 0.5 * (low + high) >= high {
                break;
            }
        }
        if above.abs() < below.abs() { high } else { low }
    }
}

/// What a look at the same line a shorter time along the same drive has found.
pub(super) struct Earlier {
    pub(super) end: Moment,
    /// Where the edge was, and the intervals that it had passed.
    pub(super) place: f64,
    pub(super) intervals: Vec<Interval>,
}

/// Intervals that the edge has passed by a moment, at a later one of the same drive.
fn later(chain: &Chain, mut intervals: Vec<Interval>, before: Option<&Moment>, end: &Moment, way: Way) -> Vec<Interval> {
    let Some(before) = before else { return intervals };
    let time = end.time - before.time;
    let changes: Vec<(f64, f64)> = match way {
        Way::Inwards => chain.voigt.iter().map(|&(rate, _)| (decayed(rate * time), 0.0)).collect(),
        Way::Outwards => {
            let gained = chain.maxwell.iter().zip(before.gained.iter().zip(&end.gained));
            gained
                .map(|(&(_, rho), (before, whole))| {
                    let kept = decayed(time / rho);
                    (kept, whole - before * kept)
                })
                .collect()
        }
    };
    for interval in &mut intervals {
        for (values, (kept, gained)) in interval.state.chunks_exact_mut(NODES).zip(&changes) {
            for value in values {
                *value = *value * kept + gained;
            }
        }
    }
    intervals
}

impl Line<'_> {
    /// A time in which the edge rests.
    pub(super) fn pass_nothing(&mut self, drive: &Drive) {
        let moment = Moment::new(self.chain, drive, drive.duration);
        self.age(&moment);
        self.went_to(moment.depth);
    }

    /// A whole drive along which the edge goes one way, to where S vanishes or where it is imposed.
    pub(super) fn pass(&mut self, drive: &Drive, way: Way, edge: Option<&Edge<'_>>) -> Result<(), Refusal> {
        self.passed(drive, drive.duration, way, edge, None)?;
        self.tidy(false);
        Ok(())
    }

    /// The same up to a time of the drive, for a look at the line there, which is not gone on with: its intervals stay as they are. `earlier`: what a look at
    /// an earlier time found. What it finds itself, without the intervals, and how many of these the edge has passed.
    pub(super) fn passed(
        &mut self,
        drive: &Drive,
        until: f64,
        way: Way,
        edge: Option<&Edge<'_>>,
        earlier: Option<Earlier>,
    ) -> Result<(Moment, usize), Refusal> {
        self.depth = self.depth.max(drive.start.abs()).max(drive.value(until).abs());
        let mut end = earlier.as_ref().map_or_else(Moment::default, |earlier| earlier.end.clone());
        end.set(self.chain, drive, until);
        end.set_free(self.chain, drive, until);
        let this = self.without_intervals();
        let to = edge.map(|edge| edge.place(until));
        let (mut moment, mut scratch) = (end.clone(), Vec::new());
        let (before, place, known) = match earlier {
            Some(earlier) => (Some(earlier.end), Some(earlier.place), earlier.intervals),
            None => (None, None, Vec::new()),
        };
        let since = before.as_ref().map_or(0.0, |before| before.time);
        let mut guesses = Guesses::default();
        if way == Way::Outwards {
            guesses.found(since);
        }
        let known = later(this.chain, known, before.as_ref(), &end, way);
        let count = match way {
            Way::Inwards => self.recede(&end, to, place.map(|place| (place, known)), &mut |place, height, state| {
                let time = if let Some(edge) = edge {
                    let time = edge.time(place, until);
                    moment.set_at(this.chain, drive, time);
                    time
                } else {
                    leaving(&this, drive, height, state, until, guesses.next(place), &mut moment)
                };
                guesses.found(time);
                for ((u, kept), gained) in state.iter_mut().zip(&moment.kept).zip(&moment.gained) {
                    *u = *u * kept + gained;
                }
                this.chain.released(moment.depth - height, state, &mut scratch);
                for (e, &(rate, _)) in state.iter_mut().zip(&this.chain.voigt) {
                    *e *= decayed(rate * (until - time));
                }
            }),
            Way::Outwards => self.advance(&end, to, place.map(|place| (place, known)), &mut |place, height, state| {
                let time = match edge {
                    Some(edge) => edge.time(place, until),
                    None => touching(&this, drive, height, state, until, guesses.next(place)),
                };
                guesses.found(time);
                let displacement = drive.value(time) - height;
                if state.iter().all(|e| *e == 0.0) {
                    state.fill(displacement);
                } else {
                    for (e, &(rate, _)) in state.iter_mut().zip(&this.chain.voigt) {
                        *e *= decayed(rate * time);
                    }
                    this.chain.touched(displacement, state, &mut scratch);
                }
                end.held(this.chain, drive, time, state);
            })?,
        };
        self.went_to(end.depth);
        Ok((end, count))
    }

    /// A step of the penetration, at once, and of the edge where that is imposed.
    pub(super) fn leap(&mut self, to: f64, edge: Option<f64>) -> Result<(), Refusal> {
        let before = self.penetration;
        self.depth = self.depth.max(to.abs());
        let terms = self.chain.terms();
        // No dashpot moves: every spring takes the step.
        let end = Moment {
            depth: to,
            kept: vec![1.0; terms],
            gained: vec![to - before; terms],
            recovered: vec![1.0; terms],
            ..Moment::default()
        };
        let (chain, mut scratch) = (self.chain, Vec::new());
        let inwards = edge.map_or(to < before, |edge| edge < self.radius());
        if inwards {
            self.recede(&end, edge, None, &mut |_, height, state| chain.released(before - height, state, &mut scratch));
        } else {
            self.advance(&end, edge, None, &mut |_, height, state| chain.touched(to - height, state, &mut scratch))?;
        }
        self.went_to(to);
        self.tidy(false);
        Ok(())
    }

    /// The edge goes inwards: `released` takes a chain with its place and height from u_i at the start to e_j at the end. `known`: the place from which on
    /// outwards these intervals are what the edge has passed. How many intervals it has passed.
    fn recede(
        &mut self,
        end: &Moment,
        edge: Option<f64>,
        known: Option<(f64, Vec<Interval>)>,
        released: &mut dyn FnMut(f64, f64, &mut [f64]),
    ) -> usize {
        let (from, mut freed) = known.unwrap_or((f64::INFINITY, Vec::new()));
        let mut cut = None;
        while let Some(interval) = self.contact.pop() {
            let place = snapped(&interval, edge.unwrap_or_else(|| zero_in(&interval, &self.pressed(&interval, end)))).min(from);
            if place >= interval.high {
                self.contact.push(interval);
                break;
            }
            self.passes(&interval, true);
            let mut parts = Vec::new();
            self.build(
                (place.max(interval.low), interval.high.min(from)),
                false,
                &mut |s, height, state| {
                    interval.at(s, state);
                    released(s, height, state);
                },
                &mut parts,
            );
            parts.iter_mut().for_each(|part| (part.off, part.then) = (interval.off, interval.then));
            parts.append(&mut freed);
            freed = parts;
            if place > interval.low {
                cut = Some((interval, place));
                break;
            }
        }
        if let Some((whole, place)) = cut {
            let mut parts = Vec::new();
            self.build((whole.low, place), true, &mut |s, _, state| whole.at(s, state), &mut parts);
            parts.iter_mut().for_each(|part| (part.off, part.then) = (whole.off, whole.then));
            self.contact.append(&mut parts);
        }
        self.age(end);
        let count = freed.len();
        freed.append(&mut self.free);
        self.free = freed;
        count
    }

    /// The edge goes outwards: `touched` takes a chain with its place and height from e_j at the start to u_i at the end. `known`: the place up to which these
    /// intervals are what the edge has passed. How many intervals it has passed.
    fn advance(
        &mut self,
        end: &Moment,
        to: Option<f64>,
        known: Option<(f64, Vec<Interval>)>,
        touched: &mut dyn FnMut(f64, f64, &mut [f64]),
    ) -> Result<usize, Refusal> {
        let (from, mut gained) = known.unwrap_or((0.0, Vec::new()));
        let mut rest: Vec<Interval> = Vec::new();
        let (mut reached, mut stopped) = (self.radius().max(from), false);
        for interval in std::mem::take(&mut self.free) {
            if stopped {
                rest.push(interval);
                continue;
            }
            if interval.high <= from {
                continue;
            }
            let (own, others) = (gained.len(), rest.len());
            let place = snapped(&interval, to.unwrap_or_else(|| zero_in(&interval, &self.opened(&interval, end)))).max(from);
            if place > interval.low {
                self.passes(&interval, false);
                self.build(
                    (interval.low.max(from), place),
                    true,
                    &mut |s, height, state| {
                        interval.at(s, state);
                        touched(s, height, state);
                    },
                    &mut gained,
                );
                reached = place;
            }
            stopped = place < interval.high;
            if stopped && place > interval.low {
                self.build((place, interval.high), false, &mut |s, _, state| interval.at(s, state), &mut rest);
            } else if stopped {
                rest.push(interval.clone());
            }
            gained
                .iter_mut()
                .skip(own)
                .chain(rest.iter_mut().skip(others))
                .for_each(|part| (part.off, part.then) = (interval.off, interval.then));
        }
        self.free = rest;
        if !stopped {
            let edge = if let Some(to) = to { to.min(self.profile.rim()) } else { self.virgin_edge(end.depth, reached)? };
            if edge - reached > NARROWEST * edge {
                self.build(
                    (reached, edge),
                    true,
                    &mut |s, height, state| {
                        state.fill(0.0);
                        touched(s, height, state);
                    },
                    &mut gained,
                );
            }
        }
        self.age(end);
        let count = gained.len();
        self.contact.append(&mut gained);
        Ok(count)
    }

    /// What rounding has left in contact when it was lost.
    pub(super) fn release_all(&mut self) {
        let depth = self.penetration;
        let chain = self.chain;
        let mut freed = Vec::new();
        let mut scratch = Vec::new();
        for interval in std::mem::take(&mut self.contact) {
            self.passes(&interval, true);
            let own = freed.len();
            self.build(
                (interval.low, interval.high),
                false,
                &mut |s, height, state| {
                    interval.at(s, state);
                    chain.released(depth - height, state, &mut scratch);
                },
                &mut freed,
            );
            freed.iter_mut().skip(own).for_each(|part| (part.off, part.then) = (interval.off, interval.then));
        }
        freed.append(&mut self.free);
        self.free = freed;
    }

    fn without_intervals(&self) -> Self {
        Self { contact: Vec::new(), free: Vec::new(), ..*self }
    }
}

/// Where S passes zero in an interval; an end where it does not.
fn zero_in(interval: &Interval, values: &Nodal) -> f64 {
    if values[NODES - 1] >= 0.0 {
        interval.high
    } else if values[0] < 0.0 {
        interval.low
    } else {
        interval.low + interval.width() * GRID.part(GRID.falling_zero(values))
    }
}

/// The same, at an end where it is next to one.
fn snapped(interval: &Interval, place: f64) -> f64 {
    let near = NARROWEST * interval.high;
    // Beyond an end is at it, too.
    if place - interval.low <= near {
        interval.low
    } else if interval.high - place <= near {
        interval.high
    } else {
        place
    }
}
