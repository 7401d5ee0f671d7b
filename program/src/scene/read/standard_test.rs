//! The [test] table: a standard test of an indenter, written out as the segments of a history.

use super::repeat::Tables;
use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{
    Condition, History, HistoryOscillation, HistoryQuantity, HistorySegment, IndentationShape, OscillationExtent, Pace,
};

/// Keys that each kind may have, in the order of the kinds; `kind` itself aside.
const TAKES: [(&str, &[&str]); 6] = [
    ("pull_off", &["approach_speed", "preload", "depth", "approach_to", "dwell", "retraction_speed", "retract_to"]),
    ("tack", &["approach_speed", "preload", "approach_to", "dwell", "retraction_speed", "retract_to"]),
    ("creep", &["preload", "rise", "dwell", "recovery"]),
    ("relaxation", &["approach_speed", "preload", "depth", "approach_to", "dwell"]),
    (
        "dynamic",
        &["approach_speed", "preload", "depth", "approach_to", "dwell", "amplitude", "frequency", "to_frequency", "frequencies", "cycles"],
    ),
    ("cyclic", &["approach_speed", "preload", "depth", "approach_to", "dwell", "retraction_speed", "retract_to", "cycles"]),
];
/// Frequencies and cycles of a dynamic test where a scene names no number.
const DEFAULT_FREQUENCIES: f64 = 5.0;
const DEFAULT_CYCLES: f64 = 20.0;

/// What a test is made on.
pub(super) struct Rig<'s> {
    pub(super) shape: &'s IndentationShape,
    pub(super) frame_stiffness: Option<f64>,
    /// Whether a law of attraction acts: every cycle is integrated.
    pub(super) at_a_distance: bool,
}

/// The history of the test; none if the scene has no [test].
pub(super) fn read(top: &Section<'_>, rig: &Rig<'_>) -> Result<Option<History>, SceneError> {
    let Some(test) = top.table("test") else { return Ok(None) };
    if top.node().get("history").is_some() {
        let message = "`test` stands for a history, and the scene has [[history]] as well";
        return Err(SceneError::at(&top.key_place("test"), message, "leave one of the two out")
            .help("`viscotack explain` prints the [[history]] tables of a test: change those, and leave [test] out"));
    }
    let kind = test.required_text("kind")?;
    let takes = TAKES.iter().find(|(word, _)| *word == kind).map_or(&[][..], |(_, takes)| *takes);
    if let Some(entry) = test.node().entries().iter().find(|entry| entry.key != "kind" && !takes.contains(&entry.key.as_str())) {
        let message = format!("`{}` does not belong to a test of the kind {kind:?}", test.full(&entry.key));
        return Err(SceneError::at(&entry.key_place, message, "leave it out").help(format!("{kind:?} may have: {}", takes.join(", "))));
    }
    let test = Test { table: test, rig, quantity: rig.frame_stiffness.map_or(HistoryQuantity::Penetration, |_| HistoryQuantity::Frame) };
    let mut segments = Vec::new();
    match kind {
        "creep" => test.creep(&mut segments)?,
        "cyclic" => {
            let mut tables = Tables::default();
            tables.add(test.approach()?);
            test.dwell()?.into_iter().for_each(|dwell| tables.add(dwell));
            tables.add(test.retraction(Some(0.0))?);
            tables.go_through(0, test.table.required_number("cycles")? as usize);
            return Ok(Some(tables.written_out()));
        }
        _ => {
            segments.push(test.approach()?);
            match kind {
                "tack" => {
                    segments.push(HistorySegment::Step { quantity: HistoryQuantity::Force, value: test.table.required_number("preload")? });
                }
                "relaxation" => {
                    test.table.required_number("dwell")?;
                }
                _ => {}
            }
            segments.extend(test.dwell()?.map(|dwell| match dwell {
                HistorySegment::Hold { duration, .. } if kind == "tack" => {
                    HistorySegment::Hold { quantity: Some(HistoryQuantity::Force), duration }
                }
                dwell => dwell,
            }));
            match kind {
                "pull_off" | "tack" => {
                    segments.push(HistorySegment::Until { segment: Box::new(test.retraction(None)?), condition: Condition::Detachment })
                }
                "dynamic" => test.oscillations(&mut segments)?,
                _ => {}
            }
        }
    }
    Ok(Some(History::of(segments)))
}

struct Test<'s> {
    table: Section<'s>,
    rig: &'s Rig<'s>,
    /// What is moved.
    quantity: HistoryQuantity,
}

impl Test<'_> {
    /// At a speed until the preload, or to a depth.
    fn approach(&self) -> Result<HistorySegment, SceneError> {
        let given = if self.takes("depth") { self.table.exactly_one(&["preload", "depth"])? } else { "preload" };
        let (quantity, pace) = (self.quantity, Pace::Rate(self.table.required_number("approach_speed")?));
        if given == "depth" {
            if self.table.node().get("approach_to").is_some() {
                let message =
                    format!("`{}` is the limit of an approach to `preload`, and a depth is given", self.table.full("approach_to"));
                return Err(SceneError::at(&self.table.key_place("approach_to"), message, "leave it out"));
            }
            return Ok(HistorySegment::Ramp { quantity, value: self.table.required_number("depth")?, pace });
        }
        let preload = self.table.required_number("preload")?;
        let value = match self.table.number("approach_to")? {
            Some(limit) => limit,
            None => {
                let bent = self.rig.frame_stiffness.map_or(0.0, |stiffness| (preload / stiffness).abs());
                let limit = self.size("approach_to")? + bent;
                if !limit.is_finite() {
                    let message = format!("`{}` bends the frame by more than a number holds", self.table.full("preload"));
                    return Err(self.table.wrong("preload", message, "lower it, or give a stiffer frame_stiffness"));
                }
                limit
            }
        };
        let segment = Box::new(HistorySegment::Ramp { quantity, value, pace });
        Ok(HistorySegment::Until { segment, condition: Condition::Reaches(HistoryQuantity::Force, preload) })
    }

    fn dwell(&self) -> Result<Option<HistorySegment>, SceneError> {
        let duration = self.table.number("dwell")?.unwrap_or(0.0);
        Ok((duration > 0.0).then_some(HistorySegment::Hold { quantity: Some(self.quantity), duration }))
    }

    fn retraction(&self, default: Option<f64>) -> Result<HistorySegment, SceneError> {
        let value = match (self.table.number("retract_to")?, default) {
            (Some(value), _) | (None, Some(value)) => value,
            (None, None) => -self.size("retract_to")?,
        };
        let speed = match self.table.number("retraction_speed")? {
            Some(speed) => speed,
            None => self.table.required_number("approach_speed")?,
        };
        Ok(HistorySegment::Ramp { quantity: self.quantity, value, pace: Pace::Rate(speed) })
    }

    fn creep(&self, segments: &mut Vec<HistorySegment>) -> Result<(), SceneError> {
        let quantity = HistoryQuantity::Force;
        let rise = self.table.number("rise")?;
        let go = |value: f64| match rise {
            Some(rise) => HistorySegment::Ramp { quantity, value, pace: Pace::Duration(rise) },
            None => HistorySegment::Step { quantity, value },
        };
        let hold = |duration: f64| HistorySegment::Hold { quantity: Some(quantity), duration };
        segments.push(go(self.table.required_number("preload")?));
        segments.push(hold(self.table.required_number("dwell")?));
        if let Some(recovery) = self.table.number("recovery")? {
            segments.extend([go(0.0), hold(recovery)]);
        }
        Ok(())
    }

    /// One oscillation a frequency.
    fn oscillations(&self, segments: &mut Vec<HistorySegment>) -> Result<(), SceneError> {
        let (amplitude, first) = (self.table.required_number("amplitude")?, self.table.required_number("frequency")?);
        let cycles = self.table.number("cycles")?.unwrap_or(DEFAULT_CYCLES) as u32;
        let frequencies: Vec<f64> = match (self.table.number("to_frequency")?, self.table.number("frequencies")?) {
            (Some(last), count) => {
                let count = count.unwrap_or(DEFAULT_FREQUENCIES) as u32;
                let share = |k: u32| f64::from(k) / f64::from(count.saturating_sub(1).max(1));
                // By powers of each: their ratio may be more than a number holds.
                let between = |share: f64| first.powf(1.0 - share) * last.powf(share);
                (0..count).map(|k| if k + 1 == count { last } else { between(share(k)) }).collect()
            }
            (None, None) => vec![first],
            (None, Some(_)) => {
                let message =
                    format!("`{}` are those from `frequency` to `to_frequency`, which is missing", self.table.full("frequencies"));
                return Err(self.table.wrong("frequencies", message, "leave it out, or give to_frequency"));
            }
        };
        segments.extend(frequencies.into_iter().map(|frequency| {
            HistorySegment::Oscillation(HistoryOscillation {
                quantity: self.quantity,
                amplitude,
                frequency,
                sweep: None,
                extent: OscillationExtent::Cycles(cycles),
                phase: 0.0,
                to: None,
                until_stationary: !self.rig.at_a_distance,
            })
        }));
        Ok(())
    }

    fn takes(&self, key: &str) -> bool {
        let kind = self.table.text("kind");
        TAKES.iter().any(|(word, takes)| Some(*word) == kind && takes.contains(&key))
    }

    /// How far an indenter of this shape goes at most.
    fn size(&self, key: &str) -> Result<f64, SceneError> {
        match self.rig.shape {
            IndentationShape::Sphere { radius } | IndentationShape::FlatPunch { radius } | IndentationShape::PowerLaw { radius, .. } => {
                Ok(*radius)
            }
            IndentationShape::Table { points, .. } => Ok(points.last().map_or(0.0, |(r, _)| *r)),
            IndentationShape::Cone { .. } => Err(self.table.missing(key)),
        }
    }
}
