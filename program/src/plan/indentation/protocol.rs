//! The parts of a test: where it dwells, where the retraction begins that ends in the loss of contact.

use super::locate::{State, quantity_of};
use super::shift::SAME_TIME;
use super::timeline::{Leg, Timeline};
use crate::scene::typed::{History, HistorySegment};

/// A history of legs with the states between them. The state k is that before the leg k, the last one that at the end.
pub(super) struct Protocol<'p> {
    timeline: &'p Timeline,
    history: &'p History,
    /// None where there is none.
    states: Vec<Option<State<f64>>>,
    /// The time of each state.
    times: Vec<f64>,
    /// The displacement of the far end of a frame over the force, coherent; zero without a frame.
    compliance: f64,
}

impl<'p> Protocol<'p> {
    pub(super) fn new(timeline: &'p Timeline, history: &'p History, states: Vec<Option<State<f64>>>, compliance: f64) -> Self {
        let mut time = 0.0;
        let ends = timeline.legs.iter().map(|leg| {
            time += leg.duration;
            time
        });
        let planned = std::iter::once(0.0).chain(ends).enumerate();
        // Oscillations until they are stationary end earlier than planned.
        let times = planned.map(|(place, time)| states.get(place).copied().flatten().map_or(time, |state| state.time)).collect();
        Self { timeline, history, states, times, compliance }
    }

    /// The state at the end of the last hold before a time that ends in contact.
    pub(super) fn dwell(&self, before: f64) -> Option<usize> {
        let held = |leg: &Leg| {
            let segment = self.history.segments.get(leg.segment);
            segment.is_some_and(|segment| match segment {
                HistorySegment::Until { segment, .. } => matches!(**segment, HistorySegment::Hold { .. }),
                other => matches!(other, HistorySegment::Hold { .. }),
            })
        };
        let legs = &self.timeline.legs;
        let last = |place: usize| legs.get(place + 1).map(|next| next.segment) != legs.get(place).map(|leg| leg.segment);
        let ends = legs.iter().enumerate().filter(|(place, leg)| held(leg) && last(*place)).map(|(place, _)| place + 1);
        let touches = |end: &usize| self.states.get(*end).copied().flatten().is_some_and(|state| state.contact_radius > 0.0);
        ends.rev().find(|end| self.times.get(*end).is_some_and(|time| *time <= before * (1.0 + SAME_TIME)) && touches(end))
    }

    /// When the retraction begins in which the contact is lost at a time, or after which it is lost while something is held: where what is imposed begins
    /// to fall, of a measured table where it is largest before the loss. None of a contact that is lost in an oscillation, or without a retraction.
    pub(super) fn retraction(&self, lost: f64) -> Option<f64> {
        let within = |leg: &usize| match (self.times.get(*leg), self.times.get(leg + 1)) {
            (Some(begin), Some(end)) => *begin <= lost * (1.0 + SAME_TIME) && *end >= lost * (1.0 - SAME_TIME),
            _ => false,
        };
        let legs = || (0..self.timeline.legs.len()).filter(within);
        let mut leg = legs().find(|leg| self.way(*leg) < 0.0).or_else(|| legs().find(|leg| self.way(*leg) == 0.0))?;
        while self.way(leg) == 0.0 {
            leg = leg.checked_sub(1)?;
        }
        let way = self.way(leg);
        if way.is_nan() || way > 0.0 {
            return None;
        }
        loop {
            if let Some(top) = self.top_of_a_table(leg) {
                leg = top;
                break;
            }
            match leg.checked_sub(1).filter(|before| self.way(*before) < 0.0) {
                Some(before) => leg = before,
                None => break,
            }
        }
        self.times.get(leg).copied()
    }

    /// Where what is imposed in a leg begins.
    fn from(&self, leg: usize) -> Option<f64> {
        let quantity = self.timeline.legs.get(leg)?.quantity;
        let before = leg.checked_sub(1).and_then(|before| self.timeline.legs.get(before));
        let (held, value) = before.map_or(self.timeline.start, |before| (before.quantity, before.end));
        if held == quantity && before.is_none_or(|before| before.oscillation.is_none()) {
            return Some(value);
        }
        self.states.get(leg).copied().flatten().map(|state| quantity_of(quantity, &state, self.compliance))
    }

    /// The way of a leg; no number where it is unknown, or of an oscillation.
    fn way(&self, leg: usize) -> f64 {
        match (self.timeline.legs.get(leg), self.from(leg)) {
            (Some(leg), Some(from)) if leg.oscillation.is_none() => leg.end - from,
            _ => f64::NAN,
        }
    }

    /// Of a leg of a measured table: the last of its legs up to this one that begins at the largest value.
    fn top_of_a_table(&self, leg: usize) -> Option<usize> {
        let segment = self.timeline.legs.get(leg)?.segment;
        matches!(self.history.segments.get(segment), Some(HistorySegment::Table { .. })).then_some(())?;
        let own = (0..=leg).rev().take_while(|other| self.timeline.legs.get(*other).is_some_and(|other| other.segment == segment));
        let from = |leg: &usize| self.from(*leg).unwrap_or(f64::NEG_INFINITY);
        // Of several as large ones `max_by` takes the last.
        own.collect::<Vec<_>>().into_iter().rev().max_by(|one, other| from(one).total_cmp(&from(other)))
    }
}
