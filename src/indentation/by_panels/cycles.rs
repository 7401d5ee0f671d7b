//! Cycles of an oscillation: ∮F dΔ, amplitudes and extremes, from integrals over the panels themselves.
//!
//! ```text
//! work = ∫F Δ′ dθ,    ∫x φ̇ sin φ dt, ∫x φ̇ cos φ dt  of x = Δ, F
//! ```
//! Eight Gauss points a part, and parts halved until halves agree with the whole to a part of the tolerance. An extreme between points is sought on the polynomial
//! through them, and evaluated there. What is made of the sums, and when cycles are stationary, says `cycle_integrals`, which time steps use as well.

use super::closure::Way;
use super::events::first_crossing;
use super::integration::Integration;
use super::line::{Segment, series};
use super::problem::Row;
use super::record::LATE;
use crate::indentation::cycle_integrals::CycleIntegrals;
use crate::indentation::{Oscillation, PathPoint};
use serde::{Deserialize, Serialize};

/// Halvings of a part.
const MOST_HALVINGS: u32 = 12;
/// Parts of a cycle without contact.
const PARTS_IN_FLIGHT: f64 = 8.0;

/// The oscillation under way.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Cycles {
    cycle_integrals: CycleIntegrals,
    oscillation: Oscillation,
    duration: f64,
    origin: f64,
    segment: usize,
    /// The next cycle to end, from 1.
    number: u64,
    /// Whether its segment ends with the first stationary cycle, and whether that is over.
    seeks_end: bool,
    pub(super) is_stationary: bool,
}

impl Cycles {
    /// When the next whole cycle ends, if the segment holds another.
    fn end_of_cycle(&self) -> Option<f64> {
        self.oscillation.time_of(self.number as f64, self.duration).map(|time| self.origin + time)
    }
}

/// At a parameter: the time and its slope, dΔ by the parameter, and the row.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub(super) pace: f64,
    pub(super) sink: f64,
    pub(super) row: Row,
}

pub(super) fn point_of(row: &Row) -> PathPoint {
    PathPoint {
        time: row.time,
        penetration: row.penetration,
        force: row.force,
        contact_radius: row.contact_radius,
        stress_intensity_factor: row.stress_intensity,
        unresolved_intensity: 0.0,
        residual: 0.0,
        piece: 0,
        energies: None,
    }
}

impl Integration<'_> {
    /// A segment that oscillates begins.
    pub(super) fn begins_cycles(&mut self, segment: usize, duration: f64, oscillation: Option<Oscillation>) {
        self.cycles = None;
        self.budget_from = self.outcome.panels + self.outcome.refused;
        let (Some(oscillation), Some(_)) = (oscillation, self.problem.cycles) else { return };
        let origin = self.branch.start;
        let chain = &self.problem.chain;
        let longest = if chain.terms() == 0 { 0.0 } else { chain.times(false)[1] };
        let now = self.outcome.path.last().map(|last| point_of(&last.row));
        let cycle_integrals = CycleIntegrals::new(segment, (oscillation, duration), origin, longest, now.as_ref());
        let stop = self.problem.stops.iter().find(|stop| stop.0 == segment).map(|stop| stop.1);
        let seeks_end = oscillation.until_stationary && stop.is_none();
        self.cycles = Some(Cycles { cycle_integrals, oscillation, duration, origin, segment, number: 1, seeks_end, is_stationary: false });
        if let Some(stop) = stop {
            self.ends_early(origin + stop);
        }
    }

    /// The segment ends at a time, and all that comes after is earlier.
    pub(super) fn ends_early(&mut self, time: f64) {
        let early = self.branch.end - time;
        self.branch.end = time;
        self.instants.iter_mut().skip(self.met).for_each(|instant| *instant -= early);
        if let Some(cycles) = &self.cycles {
            self.rows.trace.shortened.push((cycles.segment, time - cycles.origin));
        }
    }

    /// When the next cycle ends, where the segment may end with it.
    pub(super) fn may_end(&self) -> Option<f64> {
        self.cycles.as_ref().filter(|cycles| cycles.seeks_end).and_then(Cycles::end_of_cycle)
    }

    /// Ends the segment now if its cycles are stationary. Whether they are.
    pub(super) fn ends_stationary(&mut self) -> bool {
        let ends = self.cycles.as_ref().is_some_and(|cycles| cycles.seeks_end && cycles.is_stationary);
        if ends {
            self.ends_early(self.line.time);
            if let Some(cycles) = &mut self.cycles {
                cycles.seeks_end = false;
            }
            self.record_rest(0.0);
        }
        ends
    }

    /// A segment is over.
    pub(super) fn ends_cycles(&mut self) {
        if let Some(cycles) = self.cycles.take() {
            self.rows.last_cycle(Some(cycles.cycle_integrals));
        }
    }

    /// The edge, or the contact, has changed at once.
    pub(super) fn integrates_at_once(&mut self, row: &Row) {
        if let Some(cycles) = &mut self.cycles {
            cycles.cycle_integrals.step(&point_of(row));
        }
    }

    /// Adds a panel up to a parameter.
    pub(super) fn integrates_panel(&mut self, advances: bool, segment: &Segment, cut: f64) {
        let start = self.line.time;
        let sample = |integration: &Self, theta: f64| {
            let way = Way { panel: segment, advances, theta };
            let pace = series(&segment.times, theta).1;
            Sample { pace, sink: pace * integration.instant(Some(way), 0.0).rate, row: integration.row(Some(way), segment.time_at(theta)) }
        };
        let place = |time: f64| first_crossing(|theta| segment.time_at(theta) - (time - start)).map_or(cut, |theta| theta.min(cut));
        self.integrates((-1.0, cut), start + segment.time_at(cut), place, sample, f64::INFINITY);
    }

    /// Adds a time in which the edge rests.
    pub(super) fn integrates_rest(&mut self, time: f64) {
        let start = self.line.time;
        let sample = |integration: &Self, since: f64| Sample {
            pace: 1.0,
            sink: integration.instant(None, since).rate,
            row: integration.row(None, since),
        };
        let longest = self.cycles.as_ref().map_or(f64::INFINITY, |cycles| (PARTS_IN_FLIGHT * cycles.oscillation.frequency).recip());
        self.integrates((0.0, time), start + time, |end| (end - start).min(time), sample, longest);
    }

    /// Adds a time without contact, between two instants, of a Δ(t) and its rate. When the segment ends early, if it does.
    pub(super) fn integrates_flight(&mut self, (from, to): (f64, f64), depth: impl Fn(f64) -> (f64, f64)) -> Option<f64> {
        let longest = self.cycles.as_ref().map(|cycles| (PARTS_IN_FLIGHT * cycles.oscillation.frequency).recip())?;
        let sample = |_: &Self, time: f64| {
            let (penetration, sink) = depth(time);
            Sample { pace: 1.0, sink, row: Row { time, penetration, ..Row::default() } }
        };
        let mut from = from;
        while let Some(end) = self.may_end().filter(|end| *end <= to) {
            self.integrates((from, end), end, |time| time.min(end), sample, longest);
            from = end;
            if self.cycles.as_ref().is_some_and(|cycles| cycles.is_stationary) {
                return Some(end);
            }
        }
        self.integrates((from, to), to, |time| time.min(to), sample, longest);
        None
    }

    /// Adds what lies between two parameters, the second at a time, cycle by cycle; `place`: the parameter of a time; `longest`: most of a part.
    fn integrates(
        &mut self,
        (from, to): (f64, f64),
        end: f64,
        place: impl Fn(f64) -> f64,
        sample: impl Fn(&Self, f64) -> Sample,
        longest: f64,
    ) {
        let Some(mut cycles) = self.cycles.take() else { return };
        let mut here = from;
        loop {
            let ends = cycles.end_of_cycle().filter(|time| *time <= end + LATE * end.abs());
            let next = ends.map_or(to, |time| place(time).clamp(here, to));
            let parts = ((next - here) / longest).ceil().max(1.0);
            let step = (next - here) / parts;
            for part in 0..parts as u64 {
                let range = (here + step * part as f64, if part as f64 + 1.0 < parts { here + step * (part as f64 + 1.0) } else { next });
                if range.1 > range.0 {
                    let sums = self.added(&cycles.cycle_integrals, range, &sample, MOST_HALVINGS).sums;
                    cycles.cycle_integrals.passed(&point_of(&sample(self, range.1).row), &sums);
                }
            }
            here = next;
            let Some(time) = ends else { break };
            let accuracy = self.problem.cycles.unwrap_or(0.0);
            if self.rows.cycle(&mut cycles.cycle_integrals, time, accuracy) == Some(true) {
                cycles.is_stationary = true;
            }
            cycles.number += 1;
            self.budget_from = self.outcome.panels + self.outcome.refused;
            if cycles.seeks_end && cycles.is_stationary {
                break;
            }
        }
        self.cycles = Some(cycles);
    }
}
