//! From the segments of a scene to those of the library: rates become durations.

use crate::scene::typed::{CycleWave, DelayedFracture, History, HistorySegment, Pace, Scene, Units};
use viscotack::crack::delayed::{LoadHistory, LoadSegment, Wave};
use viscotack::elastic::PureShearStrip;
use viscotack::refusal::Refusal;

/// Values of a swept load that the cost of a sweep is assessed by.
const EXAMPLES: usize = 7;

/// K(t), and how long it is prescribed (s).
pub(super) fn loads(history: &History, strip: Option<&PureShearStrip>) -> Result<(LoadHistory, f64), Refusal> {
    let (segments, duration) = segments(history);
    let loads = match strip {
        Some(strip) => LoadHistory::of_strip_stress(&segments, strip)?,
        None => LoadHistory::from_segments(&segments)?,
    };
    Ok((loads, duration))
}

/// The crack at values all over the sweep of a load; none if no load is swept.
pub(super) fn examples(scene: &Scene, crack: &DelayedFracture) -> Vec<DelayedFracture> {
    let swept = |key: &str| -> Option<usize> {
        let (index, quantity) = key.strip_prefix("history.")?.split_once('.')?;
        if quantity == "stress" || quantity == "stress_intensity" { index.parse().ok() } else { None }
    };
    let Some((index, values)) = scene.sweeps.iter().find_map(|sweep| Some((swept(&sweep.key)?, &sweep.values))) else { return Vec::new() };
    // The reduced stress intensity is √(2E0Δγ) with E0 = 1.
    let unit = if scene.units == Units::Reduced { (2.0 * crack.work_of_adhesion).sqrt() } else { 1.0 };
    let last = values.len().saturating_sub(1);
    let count = EXAMPLES.min(values.len());
    (0..count)
        .filter_map(|example| {
            let chosen = values.get(example * last / count.saturating_sub(1).max(1))?;
            let mut crack = crack.clone();
            let mut any = false;
            for segment in crack.history.of_table(index) {
                any = true;
                match segment {
                    HistorySegment::Step { value, .. } | HistorySegment::Ramp { value, .. } => *value = chosen * unit,
                    _ => return None,
                }
            }
            any.then_some(crack)
        })
        .collect()
}

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
            // A scene lets no crack oscillate, writes relative values out, and has no conditions for cracks.
            HistorySegment::Oscillation(_) | HistorySegment::By { .. } | HistorySegment::Until { .. } => (0.0, None),
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
