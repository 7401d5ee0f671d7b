//! What the bound on the time of a condition does to all that follows it: it comes that much earlier or later, from a contact that is that much different.

use super::columns::Measure;
use super::known::Ended;
use super::locate::{State, quantity_of};
use crate::scene::typed::Condition;
use viscotack::estimate::Estimate;

/// The words of the row of the end of a segment with a condition.
pub(super) const CONDITION_MET: &str = "condition_met";
pub(super) const LIMIT_REACHED: &str = "limit_reached";
/// Two sums of the same durations differ by less, relative.
pub(super) const SAME_TIME: f64 = 1e-12;

/// The end of a segment, beside the time at which its condition is met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shift {
    /// When the segment ends.
    pub(super) time: f64,
    /// The bound on its difference from the time of the condition.
    pub(super) late: f64,
    /// What penetration, force and contact radius change by in that time, over the scale of each.
    pub(super) parts: [f64; 3],
}

impl Shift {
    /// From the state at the end, with bounds, and the ways and losses of the solution: `states` up to the end, in the order of time.
    pub(super) fn of(ended: &Ended, at_end: &State<Estimate>, states: &[State<f64>], lost: Option<Estimate>, compliance: f64) -> Self {
        let here = State {
            time: ended.time,
            penetration: at_end.penetration.value,
            force: at_end.force.value,
            contact_radius: at_end.contact_radius.value,
        };
        // The end itself, as its own time rounds it, is no other state.
        let mut before = states.iter().rev().skip_while(|state| state.time >= ended.time * (1.0 - SAME_TIME));
        let [one, two] = [before.next(), before.next()];
        let rates = |of: &dyn Fn(&State<f64>) -> f64| rates(of, &here, one, two);
        let length = ended.time - ended.began;
        let late = match (ended.condition, ended.sudden) {
            (Condition::Reaches(quantity, value), false) => {
                let of = |state: &State<f64>| quantity_of(quantity, state, compliance);
                let [speed, _] = rates(&of);
                let errors = State {
                    time: 0.0,
                    penetration: at_end.penetration.error,
                    force: at_end.force.error,
                    contact_radius: at_end.contact_radius.error,
                };
                ((of(&here) - value).abs() + of(&errors)) / speed
            }
            _ => lost.map_or(length, |lost| ended.time - lost.value + lost.error),
        };
        // A quantity that stands still there says no more than that it is within the segment.
        let late = if late.is_finite() { late.min(length) } else { length };
        let scale = |of: fn(&State<f64>) -> f64| states.iter().map(|state| of(state).abs()).fold(of(&here).abs(), f64::max);
        let [penetration, force, contact_radius]: [fn(&State<f64>) -> f64; 3] =
            [|state| state.penetration, |state| state.force, |state| state.contact_radius];
        let parts = [penetration, force, contact_radius].map(|of: fn(&State<f64>) -> f64| {
            let change = rates(&of)[1] * late;
            if change > 0.0 { change / scale(of) } else { 0.0 }
        });
        // What has detached has no radius any more.
        let gone = ended.condition == Condition::Detachment;
        Self { time: ended.time, late, parts: [parts[0], parts[1], if gone { 0.0 } else { parts[2] }] }
    }
}

/// The smallest and the largest magnitude of the rate of a quantity at a state, from one or two states before it: by the straight line, and by the parabola.
fn rates(of: &dyn Fn(&State<f64>) -> f64, here: &State<f64>, one: Option<&State<f64>>, two: Option<&State<f64>>) -> [f64; 2] {
    let slope = |from: &State<f64>, to: &State<f64>| (of(to) - of(from)) / (to.time - from.time);
    let Some(one) = one else { return [0.0; 2] };
    let chord = slope(one, here);
    let curved = two.filter(|two| two.time < one.time).map(|two| {
        let bend = (chord - slope(two, one)) / (here.time - two.time);
        chord + bend * (here.time - one.time)
    });
    let all = [Some(chord), curved].into_iter().flatten().map(f64::abs);
    [all.clone().fold(f64::INFINITY, f64::min), all.fold(0.0, f64::max)]
}

/// Adds to the bounds of the values of a row what the shifts before it may change; columns and scales in the order of the values.
pub(super) fn widened(values: &mut [Option<Estimate>], columns: &[(&str, Measure)], scales: &[f64], shifts: &[Shift]) {
    let at = |values: &[Option<Estimate>], name: &str| {
        let place = columns.iter().position(|column| column.0 == name);
        place.and_then(|place| values.get(place).copied().flatten()).map(|time| time.value)
    };
    let [of_row, of_pull_off, of_loss] = ["time", "pull_off_time", "detachment_time"].map(|name| at(values, name));
    for (value, (name, measure)) in values.iter_mut().zip(columns) {
        let Some(estimate) = value.as_mut() else { continue };
        // The row of a state has values of several times; the others are of its end.
        let time = match name {
            _ if name.starts_with("pull_off") => of_row.or(of_pull_off),
            _ if name.starts_with("detachment") || *name == "time_to_detach" || name.starts_with("work_of_separation") => {
                of_row.or(of_loss)
            }
            _ => of_row,
        };
        let time = time.unwrap_or(f64::INFINITY);
        let (mut late, mut parts) = (0.0, [0.0; 3]);
        for shift in shifts.iter().filter(|shift| shift.time <= time * (1.0 + SAME_TIME)) {
            late += shift.late;
            parts.iter_mut().zip(shift.parts).for_each(|(sum, part)| *sum += part);
        }
        if late == 0.0 {
            continue;
        }
        let behind = quantity_behind(name);
        // What follows from all three changes by the largest part.
        let part = match behind {
            "penetration" => parts[0],
            "force" => parts[1],
            "contact_radius" => parts[2],
            _ => parts.into_iter().fold(0.0, f64::max),
        };
        let scale_of =
            |name: &str| columns.iter().position(|other| other.0 == name).and_then(|place| scales.get(place)).copied().unwrap_or(0.0);
        // A loop is small against the work of the way in and of the way out, and its ends move on both.
        let scale = if behind == "work_per_cycle" { scale_of("force") * scale_of("penetration") } else { scale_of(behind) };
        let more = if *measure == Measure::Time { late } else { part * scale.max(estimate.value.abs()) };
        if *measure != Measure::Number || estimate.error > 0.0 {
            *estimate = Estimate::new(estimate.value, estimate.error + more);
        }
    }
}

/// The column of a row on the way that a column of the answer takes its values from.
fn quantity_behind(name: &str) -> &str {
    match name {
        _ if name.ends_with("penetration") => "penetration",
        _ if name.ends_with("force") || name.ends_with("compression") => "force",
        _ if name.ends_with("radius") => "contact_radius",
        _ => name,
    }
}
