//! A history as the [[history]] tables that one would type: a standard test, or groups that repeat, written out.

use super::Document;
use super::typed::{Condition, CycleWave, History, HistoryOscillation, HistorySegment, OscillationExtent, Pace, Problem, Scene};
use viscotack::indentation::FrequencySweep;

/// The tables of a scene's history, if they are others than those in its text: one text a segment, without its first line `[[history]]`.
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
    let as_given = given == history.segments.len() && document.root.get("test").is_none();
    (!as_given).then(|| history.segments.iter().map(segment).collect())
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
