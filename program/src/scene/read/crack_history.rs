//! The [crack] table of a scene with a `[[history]]`: a crack under a load history.

use super::crack::{adhesion, body, lateral, plane};
use super::history;
use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{
    CohesiveLaw, DelayedFracture, History, HistoryQuantity, HistorySegment, LoadedStrip, OutputTimes, Pace, ProcessZoneLaw, SceneMaterial,
};

/// Output times where a scene names no number.
const DEFAULT_POINTS: f64 = 200.0;
/// The first of logarithmic output times over the length of the history, where a scene names none.
const FIRST_TIME: f64 = 1e-6;
/// Keys of a steady crack, whose place the history takes.
const STEADY: [&str; 4] = ["theories", "speed", "energy_release_rate", "stress_intensity"];

pub(super) fn read(top: &Section<'_>, document: &Document, material: &SceneMaterial) -> Result<DelayedFracture, SceneError> {
    let crack = top.required_table("crack", "it is the problem")?;
    let not_here = |section: &Section<'_>, key: &str, label: &str| {
        let message = format!("`{}` belongs to a steady crack, but the scene has a [[history]]", section.full(key));
        Err(SceneError::at(&section.key_place(key), message, label))
    };
    if let Some(key) = STEADY.iter().find(|key| crack.node().get(key).is_some()) {
        return not_here(&crack, key, "leave it, or the history, out");
    }
    if crack.text("motion") == Some("closing") {
        let message = "`crack.motion` = \"closing\": under a load history a crack opens, rests and never heals";
        return Err(crack.wrong("motion", message, "must be \"opening\" (or left out)"));
    }
    if top.node().get("fields").is_some() {
        return not_here(top, "fields", "leave it out");
    }
    let body = body(&crack)?;
    let plane = plane(&crack, top, material)?;
    let (work_of_adhesion, process_zone) = adhesion(top, None, body)?;
    if let ProcessZoneLaw::Cohesive { law: CohesiveLaw::Schapery, .. } = process_zone {
        let zone = top.required_table("adhesion", "")?.required_table("process_zone", "")?;
        let message = "`adhesion.process_zone.law` = \"schapery\" is the length of a closing cohesive zone";
        return Err(zone.wrong("law", message, "must be \"growing\" or \"constant\""));
    }
    let strip = match crack.table("strip") {
        None => None,
        Some(table) => {
            if let Some(key) = ["strain", "stress"].iter().find(|key| table.node().get(key).is_some()) {
                return not_here(&table, key, "leave it out: the history controls the stress");
            }
            let lateral = lateral(&table, (top, &crack), plane, material)?;
            Some(LoadedStrip { half_height: table.required_number("half_height")?, lateral })
        }
    };
    let (quantity, owner) = match strip {
        Some(_) => (HistoryQuantity::Stress, "a crack in a strip"),
        None => (HistoryQuantity::StressIntensity, "a crack (for a stress give [crack.strip])"),
    };
    let Some(history) = history::read(top, document, &[quantity], owner)? else { return Err(top.missing("history")) };
    let duration = duration(&history);
    let output = output(&crack, duration)?;
    if duration == 0.0 && output.points > 0 {
        let message = "the history takes no time: it only steps";
        return Err(top.wrong("history", message, "add a hold").help("or write crack.points = 0 for the delay and the speeds alone"));
    }
    // The reduced stress intensity is √(2E0Δγ) with E0 = 1.
    let unit = if top.units() == Units::Reduced { (2.0 * work_of_adhesion).sqrt() } else { 1.0 };
    Ok(DelayedFracture { body, plane, work_of_adhesion, process_zone, history: scaled(history, unit), strip, output })
}

fn output(crack: &Section<'_>, duration: f64) -> Result<OutputTimes, SceneError> {
    let points = crack.number("points")?.unwrap_or(DEFAULT_POINTS) as u32;
    let logarithmic = crack.text("spacing") == Some("logarithmic");
    let first = match (logarithmic, crack.number("first_time")?) {
        (true, first) => Some(first.unwrap_or(FIRST_TIME * duration)),
        (false, None) => None,
        (false, Some(_)) => {
            let message = "`crack.first_time` belongs to spacing = \"logarithmic\"";
            return Err(crack.wrong("first_time", message, "leave it out, or write crack.spacing = \"logarithmic\""));
        }
    };
    if let Some(first) = first.filter(|first| points > 0 && duration > 0.0 && *first >= duration) {
        let message = format!("`crack.first_time` ({first:e} s) is not before the end of the history ({duration:e} s)");
        return Err(crack.wrong("first_time", message, "must be earlier"));
    }
    Ok(OutputTimes { points, first })
}

/// How long a history of one quantity takes (s).
fn duration(history: &History) -> f64 {
    let mut present = 0.0;
    history
        .segments
        .iter()
        .map(|segment| match segment {
            HistorySegment::Step { value, .. } => {
                present = *value;
                0.0
            }
            HistorySegment::Ramp { value, pace, .. } => {
                let way: f64 = (value - present).abs();
                present = *value;
                match pace {
                    Pace::Duration(duration) => *duration,
                    Pace::Rate(rate) => way / rate,
                }
            }
            HistorySegment::Hold { duration, .. } => *duration,
            HistorySegment::Table { table, .. } => {
                present = table.values.last().copied().unwrap_or(present);
                table.times.last().copied().unwrap_or(0.0)
            }
            // Cracks do not oscillate: the reader of segments has refused it.
            HistorySegment::Oscillation(oscillation) => oscillation.duration(),
            // Values relative to others are written out, and conditions refused.
            HistorySegment::By { .. } | HistorySegment::Until { .. } => 0.0,
            HistorySegment::Cycles { count, period, lower, .. } => {
                present = *lower;
                f64::from(*count) * period
            }
        })
        .sum()
}

/// The same history in another unit of its quantity.
fn scaled(mut history: History, unit: f64) -> History {
    for segment in &mut history.segments {
        match segment {
            HistorySegment::Step { value, .. } | HistorySegment::Ramp { value, pace: Pace::Duration(_), .. } => *value *= unit,
            HistorySegment::Ramp { value, pace: Pace::Rate(rate), .. } => {
                *value *= unit;
                *rate *= unit;
            }
            HistorySegment::Hold { .. } | HistorySegment::Oscillation(_) | HistorySegment::By { .. } | HistorySegment::Until { .. } => {}
            HistorySegment::Table { table, .. } => {
                if unit.to_bits() != 1.0_f64.to_bits() {
                    std::sync::Arc::make_mut(table).values.iter_mut().for_each(|value| *value *= unit);
                }
            }
            HistorySegment::Cycles { lower, upper, .. } => {
                *lower *= unit;
                *upper *= unit;
            }
        }
    }
    history
}
