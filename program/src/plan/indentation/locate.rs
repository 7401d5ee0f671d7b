//! What only a solution knows of a history is found by solving parts of it.
//!
//! A press until a force, a hold, and a retraction at a rate is one example: when the press ends follows from the way to it, and the depth after a held force
//! from the history before. Both theories of an indenter are followed by the same code.

use super::known::{Known, Open, Start, Stop};
use super::scale::Scale;
use super::timeline::Timeline;
use crate::outcome::{Column, Row};
use crate::scene::typed::{Condition, HistoryQuantity, HistorySegment, Indentation, IndentationStart};
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;

/// Accuracy of the history before a segment, over that of the scene; tolerance of a way that is searched.
const TIGHTER: f64 = 0.1;
/// How long a contact at rest is held to see where it is, in any time: nothing moves.
const AT_REST: f64 = 1.0;
/// Parts of a segment that are searched for its condition, one after the other: most limits are far beyond it.
const PARTS: [f64; 4] = [1.0 / 32.0, 0.125, 0.5, 1.0];
/// Deviation from a condition, over the tolerance and the scale of its quantity, with which it counts as met.
const MET: f64 = 0.005;
/// The same where solutions scatter too much to come nearer.
const NEARLY_MET: f64 = 5.0;
/// Solutions, at most, between the first sight of a condition and its place.
const MOST_STEPS: u32 = 12;
/// Two times nearer than this part of a segment are one.
const SAME_TIME: f64 = 1e-9;
/// Of the time, what sums of durations leave.
const SMALLEST: f64 = 1e-12;
/// How long after a jump a segment ends, over the time of the jump since its beginning and the tolerance.
const AFTER_A_JUMP: f64 = 1.0;

/// Time, penetration, force and contact radius, coherent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State<T> {
    pub(super) time: f64,
    pub(super) penetration: T,
    pub(super) force: T,
    pub(super) contact_radius: T,
}

/// The way of a history by one integration.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Way {
    /// In the order of time.
    pub(super) states: Vec<State<f64>>,
    /// When the contact was lost.
    pub(super) losses: Vec<f64>,
}

/// The plan of a history that can be followed in part.
pub(super) trait Followed: Sized {
    /// What the scene says.
    fn scene_part(&self) -> (&Indentation, &Scale, &Timeline, f64);
    /// The same plan of another history, with what is known of it, to an accuracy.
    fn of_part(&self, indentation: Indentation, known: &Known, accuracy: f64) -> Result<Self, Refusal>;
    /// Its way at a tolerance.
    fn search(&self, tolerance: f64) -> Result<Way, Refusal>;
    /// Its end, with bounds.
    fn end(&self) -> Result<State<Estimate>, Refusal>;
}

/// Finds all that is open in the history of a plan.
pub(super) fn known(plan: &impl Followed) -> Result<Known, Refusal> {
    let (indentation, scale, timeline, _) = plan.scene_part();
    let (mut known, mut open) = (Known::default(), timeline.open.first().copied());
    while let Some(next) = open {
        match next {
            Open::Start(segment) => {
                let start = start_of(plan, segment, &known)?;
                known.starts.push(start);
            }
            Open::Stop { segment, began, full, condition } => {
                let stop = Search { plan, known: &known, segment, began, full, condition }.stop()?;
                known.stops.push(stop);
            }
        }
        open = Timeline::new(indentation, scale, &known)?.open.first().copied();
    }
    Ok(known)
}

/// Adds to the bounds of rows what the errors of starts may change: a rate that is off by a part moves what follows by at most that part. Counts stay exact.
pub(super) fn of_starts(rows: &mut [Row], columns: &[Column], known: &Known) {
    let part = known.starts.iter().map(|start| start.error).sum::<f64>();
    if part > 0.0 {
        let values = rows.iter_mut().flat_map(|row| row.values.iter_mut().zip(columns));
        let moved = values.filter_map(|(value, column)| Some((value.as_mut()?, column.unit != "1")));
        for (estimate, _) in moved.filter(|(estimate, measured)| *measured || estimate.error > 0.0) {
            estimate.error += part * estimate.value.abs();
        }
    }
}

/// What `explain` says of a history that only a solution knows; none if it is known.
pub(super) fn sentence(timeline: &Timeline, times: u32) -> Option<String> {
    let searched = timeline.searches();
    (searched || !timeline.open.is_empty()).then(|| {
        let more = if searched { format!(", and it is solved {times} times as accurately as asked for") } else { String::new() };
        format!("where segments start or end that only the way to them shows is found by following the history up to there{more}")
    })
}

/// The displacement of the far end of a frame over the force, coherent; none without a frame.
fn compliance(indentation: &Indentation, scale: &Scale) -> f64 {
    indentation.frame_stiffness.map_or(0.0, |stiffness| 1.0 / (stiffness * scale.force))
}

/// Where a segment starts.
fn start_of(plan: &impl Followed, segment: usize, known: &Known) -> Result<Start, Refusal> {
    let (indentation, scale, _, accuracy) = plan.scene_part();
    let mut before = indentation.clone();
    let wanted = match before.history.segments.get(segment) {
        Some(HistorySegment::Until { segment, .. }) => Some(segment.as_ref().clone()),
        other => other.cloned(),
    };
    before.history.segments.truncate(segment);
    before.fields = None;
    before.energies = false;
    if segment == 0 {
        let (quantity, value) = indentation.at_start;
        let touches = indentation.start == IndentationStart::Untouched;
        if touches && value == 0.0 && indentation.adhesion.is_none() && indentation.attraction.is_none() {
            return Ok(Start { segment, value: 0.0, error: 0.0 });
        }
        // At rest nothing moves; an untouched surface creeps as soon as it is touched.
        let rest = HistorySegment::Hold { quantity: None, duration: AT_REST };
        before.history.segments.push(if touches { HistorySegment::Step { quantity, value } } else { rest });
    }
    let last = plan.of_part(before, known, TIGHTER * accuracy)?.end()?;
    let found = |quantity: HistoryQuantity| match quantity {
        HistoryQuantity::Force => last.force,
        HistoryQuantity::ContactRadius => last.contact_radius,
        HistoryQuantity::Frame => {
            let bent = last.force.scaled(compliance(indentation, scale));
            Estimate::new(last.penetration.value + bent.value, last.penetration.error + bent.error)
        }
        _ => last.penetration,
    };
    let (found, way) = match wanted {
        Some(HistorySegment::Ramp { quantity, value, .. }) => {
            let found = found(quantity);
            (found, scale.coherent(quantity, value) - found.value)
        }
        Some(HistorySegment::By { quantity, change, .. }) => (found(quantity), scale.coherent(quantity, change)),
        _ => return Err(Refusal::Undefined { quantity: "a start of a segment", reason: "it goes nowhere".into() }),
    };
    if way.abs() <= found.error {
        return Err(Refusal::Undefined {
            quantity: "the duration of a segment at a rate",
            reason: "the history before it ends where the segment is to go, within its error".into(),
        });
    }
    Ok(Start { segment, value: found.value, error: found.error / way.abs() })
}

/// The search for the end of a segment.
struct Search<'p, P> {
    plan: &'p P,
    known: &'p Known,
    segment: usize,
    began: f64,
    full: f64,
    condition: Condition,
}

/// Where a condition is met on a way.
enum Place {
    /// Between two times, by a function that passes through zero; the first guess between them.
    Between { from: f64, to: f64, guess: f64, rises: bool },
    /// At once.
    Jump(f64),
}

impl<P: Followed> Search<'_, P> {
    fn stop(&self) -> Result<Stop, Refusal> {
        let (_, _, _, accuracy) = self.plan.scene_part();
        let tolerance = TIGHTER * accuracy;
        for part in PARTS {
            let way = self.way(part * self.full, tolerance)?;
            match self.place(&way, accuracy)? {
                None => {}
                Some(Place::Jump(time)) => return self.after_jump(time, tolerance),
                Some(Place::Between { from, to, guess, rises }) => return self.between([from, to], guess, rises, tolerance),
            }
        }
        Ok(Stop { segment: self.segment, duration: self.full, met: false, sudden: false })
    }

    /// The way of the history whose last segment takes so long.
    fn way(&self, duration: f64, tolerance: f64) -> Result<Way, Refusal> {
        let (indentation, ..) = self.plan.scene_part();
        let mut part = indentation.clone();
        part.history.segments.truncate(self.segment + 1);
        part.fields = None;
        part.energies = false;
        let mut known = self.known.clone();
        known.stops.push(Stop { segment: self.segment, duration, met: true, sudden: false });
        self.plan.of_part(part, &known, tolerance)?.search(tolerance)
    }

    /// How far a quantity is from its value; none of a condition that is no quantity.
    fn distance(&self, state: &State<f64>) -> Option<f64> {
        let Condition::Reaches(quantity, value) = self.condition else { return None };
        let (indentation, scale, ..) = self.plan.scene_part();
        Some(quantity_of(quantity, state, compliance(indentation, scale)) - value)
    }

    /// The first place on a way where the condition is met.
    fn place(&self, way: &Way, accuracy: f64) -> Result<Option<Place>, Refusal> {
        let same = SAME_TIME * self.full;
        if self.condition == Condition::Detachment {
            return Ok(way.losses.iter().find(|time| **time >= self.began - same).map(|time| Place::Jump(*time)));
        }
        let first = way.states.iter().rposition(|state| state.time <= self.began + same).unwrap_or(0);
        let distances: Vec<f64> = way.states.iter().filter_map(|state| self.distance(state)).collect();
        let (Some(states), Some(distances)) = (way.states.get(first..), distances.get(first..)) else { return Ok(None) };
        // Where the way goes far beyond the condition its own scale would be too large.
        let scale = states.first().map_or(0.0, |state| self.scale(std::slice::from_ref(state)));
        if distances.first().is_some_and(|distance| distance.abs() <= accuracy * scale) {
            return Err(Refusal::Undefined {
                quantity: "the end of a segment with a condition",
                reason: format!(
                    "the condition of segment {} is met when it begins, within the accuracy: leave the segment out, or give another value",
                    self.segment
                ),
            });
        }
        let passes = distances.windows(2).position(|pair| pair.iter().product::<f64>() <= 0.0);
        let Some(index) = passes else { return Ok(None) };
        let (Some(before), Some(after)) = (states.get(index), states.get(index + 1)) else { return Ok(None) };
        if after.time - before.time <= same {
            return Ok(Some(Place::Jump(after.time)));
        }
        let points: Vec<(f64, f64)> =
            (index.saturating_sub(1)..index + 3).filter_map(|place| Some((states.get(place)?.time, *distances.get(place)?))).collect();
        let guess = root(&points, [before.time, after.time]);
        let rises = distances.get(index).is_some_and(|distance| *distance < 0.0);
        Ok(Some(Place::Between { from: before.time, to: after.time, guess, rises }))
    }

    /// The scale of the quantity.
    fn scale(&self, states: &[State<f64>]) -> f64 {
        let Condition::Reaches(_, value) = self.condition else { return 1.0 };
        states.iter().filter_map(|state| self.distance(state)).fold(value.abs(), |most, distance| most.max((distance + value).abs()))
    }

    /// Right after a jump: the segment goes on until it is behind it.
    fn after_jump(&self, time: f64, tolerance: f64) -> Result<Stop, Refusal> {
        let duration = ((time - self.began) * (1.0 + AFTER_A_JUMP * tolerance) + SMALLEST * time).min(self.full);
        Ok(Stop { segment: self.segment, duration, met: true, sudden: true })
    }

    /// The root between two times: each step solves the history up to a guess.
    fn between(&self, [mut from, mut to]: [f64; 2], guess: f64, rises: bool, tolerance: f64) -> Result<Stop, Refusal> {
        let mut time = guess;
        let mut last: Option<(f64, f64)> = None;
        let mut nearest: Option<(f64, f64)> = None;
        let met = |time: f64| Stop { segment: self.segment, duration: time - self.began, met: true, sudden: false };
        for _ in 0..MOST_STEPS {
            let way = self.way(time - self.began, tolerance)?;
            let Some(here) = way.states.last().and_then(|state| self.distance(state)) else { break };
            let part = here.abs() / (tolerance * self.scale(&way.states));
            if part <= MET {
                return Ok(met(time));
            }
            if nearest.is_none_or(|(_, best)| part < best) {
                nearest = Some((time, part));
            }
            if (here > 0.0) == rises {
                to = time
            } else {
                from = time
            }
            let slope = match last {
                Some((before, there)) if there.to_bits() != here.to_bits() => (here - there) / (time - before),
                _ => slope(&way, |state| self.distance(state).unwrap_or(0.0)),
            };
            last = Some((time, here));
            let next = time - here / slope;
            time = if next > from && next < to { next } else { 0.5 * (from + to) };
            if to - from <= SAME_TIME * tolerance * self.full {
                break;
            }
        }
        // What jumps between two steps has no root: it is met behind the jump.
        match nearest {
            Some((time, part)) if part <= NEARLY_MET => Ok(met(time)),
            _ => self.after_jump(to, tolerance),
        }
    }
}

/// A quantity of a state.
pub(super) fn quantity_of(quantity: HistoryQuantity, state: &State<f64>, compliance: f64) -> f64 {
    match quantity {
        HistoryQuantity::Force => state.force,
        HistoryQuantity::ContactRadius => state.contact_radius,
        HistoryQuantity::Frame => state.penetration + compliance * state.force,
        _ => state.penetration,
    }
}

/// How fast a quantity goes at the end of a way.
fn slope(way: &Way, of: impl Fn(&State<f64>) -> f64) -> f64 {
    let mut last = way.states.iter().rev();
    let (Some(end), Some(before)) = (last.next(), last.next()) else { return f64::NAN };
    (of(end) - of(before)) / (end.time - before.time)
}

/// Where values pass through zero, between two times: by the polynomial of the time through them, or by the straight line.
fn root(points: &[(f64, f64)], [from, to]: [f64; 2]) -> f64 {
    let by_polynomial: f64 = points
        .iter()
        .enumerate()
        .map(|(k, (time, value))| {
            let others = points.iter().enumerate().filter(|(l, _)| *l != k);
            time * others.map(|(_, (_, other))| other / (other - value)).product::<f64>()
        })
        .sum();
    if by_polynomial > from && by_polynomial < to {
        return by_polynomial;
    }
    let at = |time: f64| points.iter().find(|point| point.0.to_bits() == time.to_bits()).map_or(0.0, |point| point.1);
    let (here, there) = (at(from), at(to));
    let chord = from + (to - from) * here / (here - there);
    if chord > from && chord < to { chord } else { 0.5 * (from + to) }
}
