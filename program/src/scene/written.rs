//! A history as the [[history]] tables that one would type for a standard test.

use super::Document;
use super::typed::{Condition, CycleWave, History, HistoryOscillation, HistorySegment, OscillationExtent, Pace, Problem, Scene};
use std::ops::Range;
use viscotack::indentation::FrequencySweep;

/// The tables of a scene's history, if they are others than those in its text: one text a table, without its first line `[[history]]`.
///
/// Numbers are in SI units, or plain in a reduced scene, with all their digits.
#[must_use]
pub fn history_written_out(scene: &Scene, document: &Document) -> Option<Vec<String>> {
    let Problem::Indentation(indentation) = &scene.problem else { return None };
    let history: &History = &indentation.history;
    let given = document.root.at("history").map_or(0, |node| match &node.value {
        super::document::Value::List(items) => items.len(),
        _ => 0,
    });
    let written = tables(history, 0..history.segments.len(), usize::MAX);
    let as_given = given == written.len() && document.root.get("test").is_none();
    (!as_given).then_some(written)
}

/// The tables of some segments, with groups of fewer than so many as tables that repeat.
fn tables(history: &History, segments: Range<usize>, fewer: usize) -> Vec<String> {
    let (mut written, mut next) = (Vec::new(), segments.start);
    while next < segments.end {
        let begins = history.repetitions.iter().filter(|one| one.segments.start == next && one.number == 1 && one.segments.len() < fewer);
        let Some(first) = begins.max_by_key(|one| one.segments.len()) else {
            written.extend(history.segments.get(next).map(segment));
            next += 1;
            continue;
        };
        let length = first.segments.len();
        let goes_on = |time: u64| {
            let start = first.segments.start + length * time as usize;
            history.repetitions.iter().any(|one| one.number == time + 1 && one.segments == (start..start + length))
        };
        let times = (1..).take_while(|time| goes_on(*time)).count() + 1;
        let own = tables(history, first.segments.clone(), length);
        let repeat = format!("repeat = {times}\nsegments = {}", own.len());
        written.extend(own);
        written.push(repeat);
        next += length * times;
    }
    written
}

fn segment(segment: &HistorySegment) -> String {
    match segment {
        HistorySegment::Step { quantity, value } => format!("{} = {value:e}", quantity.word()),
        HistorySegment::Ramp { quantity, value, pace } => format!("{} = {value:e}{}", quantity.word(), of_pace(Some(*pace))),
        HistorySegment::By { quantity, change, pace } => {
            format!("quantity = \"{}\"\nby = {change:e}{}", quantity.word(), of_pace(*pace))
        }
        HistorySegment::Hold { duration, .. } => format!("hold = {duration:e}"),
        HistorySegment::Table { quantity, table } => {
            format!("quantity = \"{}\"\ntable = {:?}  # with the other keys of its table", quantity.word(), table.file)
        }
        HistorySegment::Cycles { quantity, count, period, lower, upper, wave } => {
            let wave = if *wave == CycleWave::Square { "square" } else { "triangle" };
            let word = quantity.word();
            format!("quantity = \"{word}\"\ncycles = {count}\nperiod = {period:e}\nlower = {lower:e}\nupper = {upper:e}\nwave = \"{wave}\"")
        }
        HistorySegment::Oscillation(oscillation) => format!("oscillation = {{ {} }}", of_oscillation(oscillation)),
        HistorySegment::Until { segment: inner, condition } => {
            let condition = match condition {
                Condition::Reaches(quantity, value) => format!("{} = {value:e}", quantity.word()),
                Condition::Detachment => "event = \"detachment\"".to_owned(),
                Condition::Time(time) => format!("time = {time:e}"),
            };
            format!("{}\nuntil = {{ {condition} }}", self::segment(inner))
        }
    }
}

fn of_pace(pace: Option<Pace>) -> String {
    match pace {
        None => String::new(),
        Some(Pace::Duration(duration)) => format!("\nduration = {duration:e}"),
        Some(Pace::Rate(rate)) => format!("\nrate = {rate:e}"),
    }
}

fn of_oscillation(oscillation: &HistoryOscillation) -> String {
    let HistoryOscillation { quantity, amplitude, frequency, sweep, extent, phase, to, until_stationary } = oscillation;
    let mut text = format!("quantity = \"{}\", amplitude = {amplitude:e}, frequency = {frequency:e}", quantity.word());
    text += &match extent {
        OscillationExtent::Cycles(cycles) => format!(", cycles = {cycles}"),
        OscillationExtent::Duration(duration) => format!(", duration = {duration:e}"),
        OscillationExtent::Periodic => ", periodic = true".to_owned(),
    };
    if let Some((end, how)) = sweep {
        let how = if *how == FrequencySweep::Logarithmic { "logarithmic" } else { "linear" };
        text += &format!(", to_frequency = {end:e}, frequency_sweep = \"{how}\"");
    }
    if *phase != 0.0 {
        text += &format!(", phase = {phase:e}");
    }
    if let Some(to) = to {
        text += &format!(", to = {to:e}");
    }
    if *until_stationary {
        text += ", until_stationary = true";
    }
    text
}
