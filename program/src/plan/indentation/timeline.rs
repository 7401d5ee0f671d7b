//! A history as legs, straight or with an oscillation, each of which ends at an instant that becomes a row.

use super::known::{Ended, Known, Open};
use super::scale::Scale;
use crate::scene::typed::{
    Condition, CycleWave, HistoryOscillation, HistoryQuantity, HistorySegment, Indentation, MeasuredTable, OscillationExtent, Pace,
};
use std::ops::Range;
use std::sync::Arc;
use viscotack::finite_range::sphere::SUM_OF_DURATIONS;
use viscotack::indentation::{FrequencySweep, Oscillation};
use viscotack::refusal::Refusal;

/// More legs than these are no history that an integration could follow.
const MOST_LEGS: usize = 100_000;
/// Decades over which half of the instants of a hold are spread: what relaxes does so in all of them.
const DECADES_OF_A_HOLD: f64 = 6.0;

/// A straight way to a value, with or without an oscillation, in coherent units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Leg {
    pub(super) quantity: HistoryQuantity,
    /// Zero is a step.
    pub(super) duration: f64,
    pub(super) end: f64,
    pub(super) oscillation: Option<Oscillation>,
    /// Which segment of the scene's history it is part of, from 0.
    pub(super) segment: usize,
}

impl Leg {
    /// Cycles of its oscillation, whole or not.
    pub(super) fn cycles(&self) -> f64 {
        self.oscillation.map_or(0.0, |oscillation| oscillation.cycles_at(self.duration, self.duration))
    }
}

/// Measured columns beside what a table controls.
#[derive(Debug, Clone)]
pub(super) struct Overlay {
    /// When its first row is.
    pub(super) start: f64,
    /// Times of the table over the time of the integration.
    pub(super) speed_factor: f64,
    pub(super) table: Arc<MeasuredTable>,
}

/// All legs of a history.
#[derive(Debug, Clone)]
pub(super) struct Timeline {
    /// What is given at time zero, coherent.
    pub(super) start: (HistoryQuantity, f64),
    pub(super) legs: Vec<Leg>,
    pub(super) overlays: Vec<Overlay>,
    /// Ramps that begin where only the integration knows, in times: their instants are taken from its path.
    pub(super) open_ramps: Vec<(f64, f64)>,
    /// What only a solution knows, the first first: until it is known, durations are guesses.
    pub(super) open: Vec<Open>,
    /// Segments with a condition, and where they end.
    pub(super) ends: Vec<Ended>,
    /// What is gone through again and again, in the order of the ends.
    pub(super) repetitions: Vec<Repetition>,
    /// Whether something is held, or a table or cycles followed: then time is the axis of interest.
    pub(super) in_time: bool,
    /// Whether it is one cycle that repeats itself for ever.
    pub(super) periodic: bool,
}

/// One time through a group of segments that repeats, or through a cycle between two values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Repetition {
    /// The first segment of the group, from 0.
    pub(super) segment: usize,
    /// Which time it is, from 1.
    pub(super) number: u64,
    pub(super) legs: Range<usize>,
}

struct Builder<'s> {
    scale: &'s Scale,
    factor: f64,
    instants: u32,
    here: (HistoryQuantity, f64),
    time: f64,
    segment: usize,
    known: &'s Known,
    timeline: Timeline,
}

/// A straight way.
struct Way {
    /// None where only the solved history before it knows.
    from: Option<f64>,
    end: f64,
    duration: f64,
}

impl Timeline {
    /// The timeline of a history, with what is known of its segments.
    pub(super) fn new(indentation: &Indentation, scale: &Scale, known: &Known) -> Result<Self, Refusal> {
        let (quantity, value) = indentation.at_start;
        let start = (quantity, scale.coherent(quantity, value));
        let timeline = Self {
            start,
            legs: Vec::new(),
            overlays: Vec::new(),
            open_ramps: Vec::new(),
            open: Vec::new(),
            ends: Vec::new(),
            repetitions: Vec::new(),
            in_time: false,
            periodic: false,
        };
        let mut builder = Builder {
            scale,
            factor: indentation.speed_factor,
            instants: indentation.instants,
            here: start,
            time: 0.0,
            segment: 0,
            known,
            timeline,
        };
        let mut begun = vec![0];
        for (index, segment) in indentation.history.segments.iter().enumerate() {
            builder.segment = index;
            builder.segment(segment)?;
            if builder.timeline.legs.len() > MOST_LEGS {
                return Err(Refusal::out_of_range("history", builder.timeline.legs.len() as f64, "at most 100 000 straight pieces"));
            }
            begun.push(builder.timeline.legs.len());
        }
        let groups = indentation.history.repetitions.iter().filter_map(|group| {
            let legs = *begun.get(group.segments.start)?..*begun.get(group.segments.end)?;
            (!legs.is_empty()).then_some(Repetition { segment: group.segments.start, number: group.number, legs })
        });
        builder.timeline.repetitions.extend(groups);
        builder.timeline.repetitions.sort_by_key(|repetition| repetition.legs.end);
        Ok(builder.timeline)
    }

    /// The force that was measured at a time, coherent: between two rows of a table that both hold one.
    pub(super) fn measured_force(&self, time: f64, scale: &Scale) -> Option<f64> {
        self.overlays.iter().rev().find_map(|overlay| {
            let column = overlay.table.others.iter().find(|column| column.name == "force")?;
            let sought = (time - overlay.start) * overlay.speed_factor;
            let next = overlay.table.rows.partition_point(|row| *row < sought);
            let (before, after) = (next.saturating_sub(1), next.min(overlay.table.rows.len() - 1));
            let row = |index: usize| Some((*overlay.table.rows.get(index)?, (*column.values.get(index)?)?));
            let ((first_time, first), (second_time, second)) = (row(before)?, row(after)?);
            // What the sum of durations before it is rounded by beyond its ends is still within the table.
            let width = second_time - first_time;
            let reach = SUM_OF_DURATIONS * time.abs() * overlay.speed_factor;
            if sought < first_time - reach || sought > second_time + reach {
                return None;
            }
            let part = if width > 0.0 { ((sought - first_time) / width).clamp(0.0, 1.0) } else { 0.0 };
            Some((first + (second - first) * part) * scale.force)
        })
    }

    /// Whether a condition ends a segment where only the way to it shows.
    pub(super) fn searches(&self) -> bool {
        self.ends.iter().any(|ended| !ended.exact)
    }

    /// Whether anything oscillates.
    pub(super) fn oscillates(&self) -> bool {
        self.legs.iter().any(|leg| leg.oscillation.is_some())
    }

    /// How long it takes (s), at most.
    pub(super) fn duration(&self) -> f64 {
        self.legs.iter().map(|leg| leg.duration).sum()
    }

    /// Σ of the ways that a quantity goes.
    pub(super) fn way(&self, quantity: HistoryQuantity) -> f64 {
        let mut here = (self.start.0 == quantity).then_some(self.start.1);
        let mut way = 0.0;
        for leg in self.legs.iter().filter(|leg| leg.quantity == quantity) {
            way += here.map_or(0.0, |from| (leg.end - from).abs());
            here = Some(leg.end);
        }
        way
    }
}

impl Builder<'_> {
    fn segment(&mut self, segment: &HistorySegment) -> Result<(), Refusal> {
        match segment {
            HistorySegment::Step { quantity, value } => self.leg(*quantity, 0.0, self.scale.coherent(*quantity, *value)),
            HistorySegment::Ramp { quantity, .. } | HistorySegment::By { quantity, .. } => {
                let way = self.way(segment, false)?;
                self.ramp(*quantity, way.duration, way.end);
            }
            HistorySegment::Until { segment, condition } => self.until(segment, *condition)?,
            HistorySegment::Hold { duration, .. } => {
                self.timeline.in_time = true;
                self.hold(duration / self.factor);
            }
            HistorySegment::Table { quantity, table } => {
                self.timeline.in_time = true;
                self.table(*quantity, table);
            }
            HistorySegment::Oscillation(oscillation) => {
                self.timeline.in_time = true;
                self.oscillation(oscillation)?;
            }
            HistorySegment::Cycles { quantity, count, period, lower, upper, wave } => {
                self.timeline.in_time = true;
                let [lower, upper] = [*lower, *upper].map(|value| self.scale.coherent(*quantity, value));
                let half = 0.5 * period / self.factor;
                if *count as usize > MOST_LEGS / 4 {
                    return Err(Refusal::out_of_range("cycles", f64::from(*count), "at most 25 000"));
                }
                for number in 1..=u64::from(*count) {
                    let first = self.timeline.legs.len();
                    match wave {
                        CycleWave::Triangle => {
                            self.step(*quantity, lower);
                            self.leg(*quantity, half, upper);
                            self.leg(*quantity, half, lower);
                        }
                        CycleWave::Square => {
                            for value in [upper, lower] {
                                self.step(*quantity, value);
                                self.leg(*quantity, half, value);
                            }
                        }
                    }
                    let legs = first..self.timeline.legs.len();
                    self.timeline.repetitions.push(Repetition { segment: self.segment, number, legs });
                }
            }
        }
        Ok(())
    }

    /// Where a straight segment goes, and how long it takes; its start is asked for where the way depends on it, or if it is `needed`.
    fn way(&mut self, segment: &HistorySegment, needed: bool) -> Result<Way, Refusal> {
        let (quantity, pace, relative) = match segment {
            HistorySegment::Ramp { quantity, pace, .. } => (*quantity, Some(*pace), false),
            HistorySegment::By { quantity, pace, .. } => (*quantity, *pace, true),
            // Holds stay where they are; nothing else has a way.
            _ => return Ok(Way { from: Some(self.here.1), end: self.here.1, duration: 0.0 }),
        };
        let found = self.known.starts.iter().find(|start| start.segment == self.segment).map(|start| start.value);
        let from = if self.here.0 == quantity { Some(self.here.1) } else { found };
        if from.is_none() && (needed || relative || matches!(pace, Some(Pace::Rate(_)))) {
            self.timeline.open.push(Open::Start(self.segment));
        }
        let start = from.unwrap_or(0.0);
        let end = match segment {
            HistorySegment::By { change, .. } => start + self.scale.coherent(quantity, *change),
            HistorySegment::Ramp { value, .. } => self.scale.coherent(quantity, *value),
            _ => start,
        };
        if quantity == HistoryQuantity::ContactRadius && end < 0.0 {
            return Err(Refusal::out_of_range("by", end, "no further down than to a contact radius of 0"));
        }
        let duration = match pace {
            None => 0.0,
            Some(Pace::Duration(time)) => time / self.factor,
            Some(Pace::Rate(rate)) => (end - start).abs() / self.scale.coherent(quantity, rate) / self.factor,
        };
        Ok(Way { from, end, duration })
    }

    /// A segment that a condition ends. Times, and the quantity that it controls itself, need no solution.
    fn until(&mut self, segment: &HistorySegment, condition: Condition) -> Result<(), Refusal> {
        let began = self.time;
        let held = matches!(segment, HistorySegment::Hold { .. });
        let mut way = self.way(segment, true)?;
        if let HistorySegment::Hold { duration, .. } = segment {
            self.timeline.in_time = true;
            way.duration = duration / self.factor;
        }
        let quantity = segment.quantity().unwrap_or(self.here.0);
        let condition = match condition {
            Condition::Reaches(of, value) => Condition::Reaches(of, self.scale.coherent(of, value)),
            Condition::Time(time) => Condition::Time(time / self.factor),
            Condition::Detachment => Condition::Detachment,
        };
        let mut ended = Ended { segment: self.segment, began, time: began, condition, met: true, exact: true, sudden: false };
        let stop = match (condition, way.from) {
            (Condition::Time(time), _) if time > began => time - began,
            (Condition::Time(_), _) if !self.timeline.open.is_empty() => way.duration,
            (Condition::Time(time), _) => {
                return Err(Refusal::Undefined {
                    quantity: "a time that ends a segment",
                    reason: format!("{time:e} has gone by when the segment begins, at {began:e}: give a later `until.time`"),
                });
            }
            (Condition::Reaches(of, value), Some(from)) if of == quantity => {
                let share = (value - from) / (way.end - from);
                if share > 0.0 && share <= 1.0 { share * way.duration } else { f64::INFINITY }
            }
            _ => {
                ended.exact = false;
                match self.known.stops.iter().find(|stop| stop.segment == self.segment) {
                    Some(stop) => {
                        ended.sudden = stop.sudden;
                        if stop.met { stop.duration } else { f64::INFINITY }
                    }
                    None => {
                        self.timeline.open.push(Open::Stop { segment: self.segment, began, full: way.duration, condition });
                        f64::INFINITY
                    }
                }
            }
        };
        ended.met = stop <= way.duration;
        if held {
            self.hold(stop.min(way.duration));
        } else {
            let (share, from) = (stop / way.duration, way.from.unwrap_or(0.0));
            let end = if share < 1.0 { from + (way.end - from) * share } else { way.end };
            self.ramp(quantity, stop.min(way.duration), end);
        }
        ended.time = self.time;
        self.timeline.ends.push(ended);
        Ok(())
    }

    fn leg(&mut self, quantity: HistoryQuantity, duration: f64, end: f64) {
        self.timeline.legs.push(Leg { quantity, duration, end, oscillation: None, segment: self.segment });
        self.here = (quantity, end);
        self.time += duration;
    }

    /// One leg, whatever the number of cycles.
    fn oscillation(&mut self, given: &HistoryOscillation) -> Result<(), Refusal> {
        let (quantity, factor) = (given.quantity, self.factor);
        let (held, present) = self.here;
        let amplitude = self.scale.coherent(quantity, given.amplitude);
        // It begins at the present value; `to` is a mean, which lies as far from the value reached after whole cycles.
        let above = amplitude * given.phase.sin();
        let Some(end) = given.to.map(|to| self.scale.coherent(quantity, to) + above).or((held == quantity).then_some(present)) else {
            return Err(Refusal::Undefined {
                quantity: "the mean of an oscillation right after a change of what is controlled",
                reason: "it is only known when the history is solved; give `to`".into(),
            });
        };
        self.timeline.periodic = given.is_periodic();
        let (end_frequency, sweep) = given.sweep.unwrap_or((given.frequency, FrequencySweep::Linear));
        let oscillation = Oscillation {
            amplitude,
            frequency: given.frequency * factor,
            end_frequency: end_frequency * factor,
            sweep,
            phase: given.phase,
            until_stationary: given.until_stationary,
        };
        oscillation.checked()?;
        let duration = given.duration() / factor;
        self.timeline.legs.push(Leg { quantity, duration, end, oscillation: Some(oscillation), segment: self.segment });
        self.time += duration;
        // Whole cycles end where they began, but for the way of the mean.
        let reached = match given.extent {
            OscillationExtent::Cycles(_) | OscillationExtent::Periodic => end,
            OscillationExtent::Duration(_) => end + oscillation.deviation(duration, duration),
        };
        self.here = (quantity, reached);
        Ok(())
    }

    /// A step that is left out where the value is met already.
    fn step(&mut self, quantity: HistoryQuantity, value: f64) {
        if self.here.0 != quantity || self.here.1.to_bits() != value.to_bits() {
            self.leg(quantity, 0.0, value);
        }
    }

    /// Equal parts where the start is known; in one go after a change of what is controlled.
    fn ramp(&mut self, quantity: HistoryQuantity, duration: f64, end: f64) {
        let (held, from) = self.here;
        if held != quantity || duration == 0.0 {
            if duration > 0.0 {
                self.timeline.open_ramps.push((self.time, self.time + duration));
            }
            self.leg(quantity, duration, end);
            return;
        }
        for part in 1..=self.instants {
            let share = f64::from(part) / f64::from(self.instants);
            let value = if part == self.instants { end } else { from + (end - from) * share };
            self.leg(quantity, duration / f64::from(self.instants), value);
        }
    }

    fn hold(&mut self, duration: f64) {
        if duration == 0.0 {
            return;
        }
        let (quantity, value) = self.here;
        // Half of them in equal ratios, half in equal steps: what creeps may let go late.
        let mut shares: Vec<f64> = (1..=self.instants)
            .map(|part| {
                let share = f64::from(part) / f64::from(self.instants);
                if part % 2 == self.instants % 2 { share } else { 10.0_f64.powf(DECADES_OF_A_HOLD * (share - 1.0)) }
            })
            .collect();
        shares.sort_by(f64::total_cmp);
        shares.dedup();
        let mut before = 0.0;
        for share in shares {
            self.leg(quantity, duration * share - before, value);
            before = duration * share;
        }
    }

    fn table(&mut self, quantity: HistoryQuantity, table: &Arc<MeasuredTable>) {
        self.timeline.overlays.push(Overlay { start: self.time, speed_factor: self.factor, table: Arc::clone(table) });
        let mut before = 0.0;
        for (index, (time, value)) in table.times.iter().zip(&table.values).enumerate() {
            let value = self.scale.coherent(quantity, *value);
            if index == 0 {
                self.step(quantity, value);
            } else {
                self.leg(quantity, (time - before) / self.factor, value);
            }
            before = *time;
        }
    }
}
