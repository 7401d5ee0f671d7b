//! Groups of segments that repeat: written out one after the other.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{History, HistoryQuantity, HistorySegment, Repetition};
use std::ops::Range;

/// More segments than these are no history that a solver could follow.
const MOST_SEGMENTS: usize = 20_000;

/// The tables of a history, in order, and the segments that they stand for.
#[derive(Default)]
pub(super) struct Tables {
    segments: Vec<HistorySegment>,
    /// The table of each segment.
    of: Vec<usize>,
    /// The segments of each table.
    ranges: Vec<Range<usize>>,
    repetitions: Vec<Repetition>,
}

impl Tables {
    /// What is controlled at the end.
    pub(super) fn last_quantity(&self) -> Option<HistoryQuantity> {
        self.segments.iter().rev().find_map(HistorySegment::quantity)
    }

    /// A table of one segment.
    pub(super) fn add(&mut self, segment: HistorySegment) {
        let here = self.segments.len();
        self.segments.push(segment);
        self.of.push(self.ranges.len());
        self.ranges.push(here..here + 1);
    }

    /// A table that repeats those before it.
    pub(super) fn repeat(&mut self, item: &Section<'_>) -> Result<(), SceneError> {
        let times = item.required_number("repeat")? as usize;
        let count = item.number("segments")?.unwrap_or(1.0) as usize;
        let before = self.ranges.len();
        let Some(first) = before.checked_sub(count).and_then(|first| self.ranges.get(first)) else {
            let message = format!("`{}` = {count}: only {before} [[history]] tables stand before this one", item.full("segments"));
            let key = if item.node().get("segments").is_some() { "segments" } else { "repeat" };
            return Err(item.wrong(key, message, "put it behind the tables that it repeats, or repeat fewer"));
        };
        let (from, to) = (first.start, self.segments.len());
        let total = (to - from).saturating_mul(times.saturating_sub(1)).saturating_add(to);
        if total > MOST_SEGMENTS {
            let message = format!("`{}` = {times} makes {total} segments of this history", item.full("repeat"));
            return Err(item.wrong("repeat", message, format!("at most {MOST_SEGMENTS} segments")));
        }
        self.go_through(from, times);
        self.ranges.push(to..self.segments.len());
        Ok(())
    }

    /// The segments from a place on, so many times in all.
    pub(super) fn go_through(&mut self, from: usize, times: usize) {
        let to = self.segments.len();
        let within = self.repetitions.iter().filter(|repetition| repetition.segments.start >= from).cloned();
        let inner: Vec<Repetition> = within.collect();
        for time in 0..times {
            let later = time * (to - from);
            let moved = |segments: &Range<usize>| segments.start + later..segments.end + later;
            if time > 0 {
                for place in from..to {
                    let (Some(segment), Some(&of)) = (self.segments.get(place).cloned(), self.of.get(place)) else { continue };
                    let segment = held(segment, self.last_quantity());
                    self.segments.push(segment);
                    self.of.push(of);
                }
                self.repetitions.extend(inner.iter().map(|one| Repetition { segments: moved(&one.segments), ..one.clone() }));
            }
            self.repetitions.push(Repetition { segments: moved(&(from..to)), number: time as u64 + 1 });
        }
    }

    pub(super) fn written_out(self) -> History {
        History { segments: self.segments, tables: self.of, repetitions: self.repetitions }
    }
}

/// A hold holds what is controlled before it.
fn held(segment: HistorySegment, last: Option<HistoryQuantity>) -> HistorySegment {
    match segment {
        HistorySegment::Hold { duration, .. } => HistorySegment::Hold { quantity: last, duration },
        HistorySegment::Until { segment, condition } => HistorySegment::Until { segment: Box::new(held(*segment, last)), condition },
        other => other,
    }
}
