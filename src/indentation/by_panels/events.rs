//! Events: where a converged panel is cut, and how the next one begins.
//!
//! | event | root of | then |
//! |---|---|---|
//! | corner of the history | T(θ) − its instant | the edge sets out anew |
//! | fold | T′(θ), in the chart t(a) | a jump, if it is one |
//! | turn | s′(θ), in the chart a(t) | the other direction, same chart |
//! | kink of the line | panels in t(a) end on it | beyond a jump of the state the edge sets out anew |
//!
//! The chart of the next panel: a(t) while the distance to a turn, v²/(2|v̇|), is less than a panel or two, else t(a).

use super::drive::Instant;
use super::followed::State;
use super::force::force;
use super::integration::Integration;
use super::line::{Break, series};
use super::newton::Panel;
use super::path::Chart;
use super::prescribed::RADIUS;
use super::problem::End;
use serde::{Deserialize, Serialize};

/// Distances to kinks below this part of the zone are rounding of places.
const KINK_NOISE: f64 = 1e-9;
/// Part of the tolerance that merging may spend on the fields, and how far from the edge, in zones, segments are merged.
pub(super) const MERGE: f64 = 1e-2;
const CLEAR: f64 = 0.02;
/// Panels between two merges.
const MERGED_EVERY: u64 = 8;
/// Marks of turns and corners that are kept: those of the last four turns suffice (same results as with all).
const WEAK_MARKS: usize = 8;
/// The same of jumps, of which a surface that is touched again and again has two each time.
const STRONG_MARKS: usize = 32;

/// A place where the state of the line has a kink, or jumps.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct Mark {
    pub(super) place: f64,
    pub(super) jump: bool,
}

impl Integration<'_> {
    /// The next place where the closure has a kink, in the direction of the edge, and whether it is from a jump of the state in sight of
    /// the window.
    pub(super) fn next_kink(&self, advances: bool) -> (f64, bool, bool) {
        let zone = self.problem.zone;
        let sign = if advances { 1.0 } else { -1.0 };
        let mut nearest = (f64::INFINITY, false, false);
        for mark in &self.marks {
            for image in -2..=2_i32 {
                let way = sign * (mark.place + f64::from(image) * zone);
                let strong = mark.jump && image == 0;
                if way > KINK_NOISE * zone && way < nearest.0 && (mark.jump || image == 0) {
                    nearest = (way, strong, mark.jump && image.abs() == 1);
                }
            }
        }
        (sign * nearest.0, nearest.1, nearest.2)
    }

    /// The first break of the profile, or its image by the zone, beyond which the rest of a way would see more of it than the tolerance.
    pub(super) fn kink_of_shape(&self, span: f64) -> Option<f64> {
        let (zone, sign) = (self.problem.zone, span.signum());
        let seen = self.problem.tolerance * self.displacement();
        let images = |at: &Break| [-1.0, 0.0, 1.0].map(|image| (sign * (at.place + image * zone), *at));
        let of = |(way, at): (f64, Break)| {
            let rest = span.abs() - way;
            (way > KINK_NOISE * zone && rest > 0.0 && at.size(rest).is_some_and(|size| size > seen)).then_some(way)
        };
        let near = |at: &&Break| at.place.abs() < span.abs() + zone;
        let nearest = self.line.breaks.iter().filter(near).flat_map(images).filter_map(of).fold(f64::INFINITY, f64::min);
        nearest.is_finite().then_some(sign * nearest)
    }

    pub(super) fn accept(&mut self, advances: bool, panel: Panel, factor: f64, floor: bool) -> Option<End> {
        let Panel { chart, segment, .. } = panel;
        let sign = if advances { 1.0 } else { -1.0 };
        let left = self.branch.end - self.line.time;
        let corner = first_crossing(|x| segment.time_at(x) - left).filter(|&x| x < 1.0 || segment.time_at(1.0) >= left * (1.0 - 1e-14));
        let stop = self.may_end().and_then(|end| first_crossing(|x| segment.time_at(x) - (end - self.line.time)));
        let (kink, strong, steep) = self.next_kink(advances);
        let timed = chart == Chart::PlaceOfTime;
        let fold = (!timed).then(|| first_crossing(|x| -series(&segment.times, x).1)).flatten();
        let turn = timed.then(|| turning(|x| -sign * segment.place_at(x).1)).flatten();
        let cut = [corner, fold, turn, stop].into_iter().flatten().fold(1.0, f64::min);
        let whole = cut >= 1.0;
        let met = !timed && whole && (strong || steep) && (segment.place_at(1.0).0 - kink).abs() <= KINK_NOISE * self.problem.zone;
        self.record(advances, &segment, cut);
        let (way, _) = segment.place_at(cut);
        let duration = segment.time_at(cut);
        let full = if timed { segment.time_at(1.0) } else { segment.place_at(1.0).0.abs() };
        let beyond = segment.place_at(1.0).0 - way;
        if let Some(state) = &self.state {
            let mut now = Instant::default();
            state.along(&self.problem.chain, &segment.times, &segment.depths, cut, &mut now);
            self.state = Some(State { depth: now.depth, rate: now.rate, memory: now.memory });
        }
        self.line.swept(segment, cut);
        for mark in &mut self.marks {
            mark.place -= way;
        }
        let previous = self.line.list(advances).last().cloned()?;
        let next_way = factor * way.abs();
        let speed = |x: f64| previous.place_at(x).1 / series(&previous.times, x).1;
        let step = 1e-3 * (cut + 1.0);
        let v = speed(cut);
        let acceleration = (v - speed(cut - step)) / (previous.time_at(cut) - previous.time_at(cut - step));
        let to_turn = v * v / (2.0 * acceleration.abs());
        self.to_turn = to_turn;
        let slows = v * acceleration < 0.0;
        self.slows = slows;
        self.since_turn += way.abs();
        let since_turn = self.since_turn;
        self.span = match chart {
            // With the turn ahead, or just behind, a(t) is smooth and t(a) is not; with a fold ahead it is the other way round.
            Chart::TimeOfPlace if slows && to_turn < 1.5 * next_way => {
                (Chart::PlaceOfTime, (next_way / v.abs()).min(1.5 * (v / acceleration).abs()).min(factor * duration))
            }
            Chart::PlaceOfTime if if slows { to_turn < 3.0 * next_way } else { since_turn < 2.0 * way.abs() } => {
                (Chart::PlaceOfTime, full * factor)
            }
            Chart::PlaceOfTime => (Chart::TimeOfPlace, sign * next_way.min(if slows { to_turn } else { since_turn })),
            Chart::TimeOfPlace => (Chart::TimeOfPlace, sign * factor * full),
        };
        self.previous = Some((advances, previous, cut));
        self.looks_at_gap();
        if self.outcome.panels.is_multiple_of(MERGED_EVERY) {
            self.merge();
        }
        if cut < 1.0 {
            self.start_residual = self.sudden(0.0);
        }
        if floor && whole {
            return Some(End::Floor);
        }
        if fold == Some(cut) && cut < 1.0 {
            // What the panel holds beyond the fold, or a part of it, stands clear of the tolerance.
            return self.jumps(advances, beyond.abs().max(0.3 * way.abs()));
        }
        if turn == Some(cut) {
            (self.to_turn, self.since_turn) = (0.0, 0.0);
            self.start_rate = self.rate(advances);
            self.mark(false);
            self.merge();
            self.span = (Chart::PlaceOfTime, full * factor.min(1.0));
            self.previous = self.previous.take().map(|(_, previous, theta)| (!advances, previous, theta));
        }
        if corner == Some(cut) {
            self.mark(false);
            return self.next_segment();
        }
        if self.ends_stationary() {
            self.mark(false);
            return self.next_segment();
        }
        if met && (strong || !self.goes_on(v)) {
            self.previous = None;
        }
        None
    }

    /// Nothing moves for a time.
    pub(super) fn rests(&mut self, time: f64) -> Option<End> {
        let until = self.may_end().map_or(f64::INFINITY, |end| end - self.line.time);
        let (time, whole) = (time.min(until), time <= until);
        self.record_rest(time);
        self.line.waited(time);
        if let Some(state) = &mut self.state {
            let faded = |rate: f64| (-time * rate).exp();
            state.memory.iter_mut().zip(&self.problem.chain.relaxation).for_each(|(memory, term)| *memory *= faded(term.1));
        }
        if self.ends_stationary() || whole { self.next_segment() } else { None }
    }

    /// The next segment of the history.
    pub(super) fn next_segment(&mut self) -> Option<End> {
        self.ends_at_once(true);
        self.ends_cycles();
        if self.upcoming == self.problem.drive.segments.len() {
            return Some(End::History);
        }
        self.begins();
        None
    }

    /// Begins the segment: its quantity goes on from where it is, or changes at once.
    pub(super) fn begins(&mut self) {
        self.previous = None;
        self.start_rate = 0.0;
        (self.refusals, self.flips) = (0, 0);
        self.piece += 1;
        let Some(drive_segment) = self.problem.drive.segments.get(self.upcoming) else { return };
        let chain = &self.problem.chain;
        let (before, time) = (self.branch.control, self.line.time);
        let mut now = Instant::default();
        self.setting(false).still(&mut now);
        let value = if before == drive_segment.control && self.upcoming > 0 {
            // As it was given to be, without the rounding of what followed it.
            self.branch.value(self.branch.end - self.branch.start).0
        } else if self.upcoming == 0 && self.problem.drive.start.0 == drive_segment.control {
            self.problem.drive.start.1
        } else {
            let radius = self.line.edge;
            drive_segment.control.map_or(now.depth, |control| {
                if control == RADIUS {
                    radius
                } else {
                    control.force * force((chain, &self.problem.profile), &self.line, None, &now) + control.depth * now.depth
                }
            })
        };
        self.upcoming += 1;
        if drive_segment.is_sudden() {
            return self.begins_at_once(drive_segment, value, now);
        }
        let (segment, duration, oscillation) = (drive_segment.segment, drive_segment.duration, drive_segment.oscillation);
        self.branch = drive_segment.branch(time, value, now.memory.clone());
        self.state = drive_segment.control.map(|_| State { depth: now.depth, rate: 0.0, memory: now.memory });
        self.begins_cycles(segment, duration, oscillation);
    }

    /// Joins old segments where nothing is lost by it.
    pub(super) fn merge(&mut self) {
        let problem = self.problem;
        let (zone, error) = (problem.zone, MERGE * problem.tolerance * self.displacement());
        self.line.merge(&problem.chain, true, CLEAR * zone, error * problem.chain.glassy);
        self.line.merge(&problem.chain, false, CLEAR * zone, error);
    }

    /// Marks the place of the edge; of each kind the last few.
    pub(super) fn mark(&mut self, jump: bool) {
        self.marks.push(Mark { place: 0.0, jump });
        let alike = self.marks.iter().filter(|mark| mark.jump == jump).count();
        let most = if jump { STRONG_MARKS } else { WEAK_MARKS };
        if let Some(oldest) = self.marks.iter().position(|mark| mark.jump == jump).filter(|_| alike > most) {
            self.marks.remove(oldest);
        }
    }
}

/// Where a function that is negative just after −1 becomes positive.
pub(super) fn turning(function: impl Fn(f64) -> f64) -> Option<f64> {
    if function(-1.0 + 1e-3) >= 0.0 { None } else { first_crossing(|x| if x < -1.0 + 1e-3 { -1.0 } else { function(x) }) }
}

/// The first θ in (−1, 1] at which a function that is negative at −1 becomes positive.
pub(super) fn first_crossing(function: impl Fn(f64) -> f64) -> Option<f64> {
    let samples = 24;
    let place = |i: i32| -1.0 + 2.0 * f64::from(i) / f64::from(samples);
    let first = (1..=samples).find(|&i| function(place(i)) >= 0.0)?;
    let (mut low, mut high) = (place(first - 1), place(first));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if function(middle) >= 0.0 { high = middle } else { low = middle }
    }
    Some(high)
}
