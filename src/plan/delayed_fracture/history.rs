//! From the segments of a scene to those of the library: rates become durations.

use crate::crack::delayed::{LoadSegment, Wave};
use crate::scene::typed::{CycleWave, History, HistorySegment, Pace};

/// The segments, and how long they take (s).
pub(super) fn segments(history: &History) -> (Vec<LoadSegment>, f64) {
    let (mut load, mut duration) = (0.0_f64, 0.0);
    let mut segments = Vec::with_capacity(history.segments.len());
    for segment in &history.segments {
        let (taken, next) = match segment {
            HistorySegment::Step { value, .. } => (0.0, Some((LoadSegment::Step { load: *value }, *value))),
            HistorySegment::Hold { duration, .. } => (*duration, Some((LoadSegment::Hold { duration: *duration }, load))),
            HistorySegment::Ramp { value, pace, .. } => {
                let duration = match pace {
                    Pace::Duration(duration) => *duration,
                    Pace::Rate(rate) => (value - load).abs() / rate,
                };
                // A ramp to the present load at a rate takes no time.
                (duration, (duration > 0.0).then_some((LoadSegment::Ramp { duration, load: *value }, *value)))
            }
            HistorySegment::Table { table, .. } => {
                let points = table.times.iter().copied().zip(table.values.iter().copied()).collect();
                let last = table.values.last().copied().unwrap_or(load);
                (table.times.last().copied().unwrap_or(0.0), Some((LoadSegment::Table { points }, last)))
            }
            HistorySegment::Cycles { count, period, lower, upper, wave, .. } => {
                let wave = match wave {
                    CycleWave::Triangle => Wave::Triangle,
                    CycleWave::Square => Wave::Square,
                };
                let cycles = LoadSegment::Cycles { count: *count, period: *period, lower: *lower, upper: *upper, wave };
                (f64::from(*count) * period, Some((cycles, *lower)))
            }
        };
        duration += taken;
        if let Some((segment, last)) = next {
            segments.push(segment);
            load = last;
        }
    }
    (segments, duration)
}
