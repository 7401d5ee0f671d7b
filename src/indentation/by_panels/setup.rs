//! A problem of this crate in the terms of the room: its chain, its drive and its first contact; what is not solved yet is refused by name.

use super::chain::Chain;
use super::drive::{Drive, DriveSegment};
use super::followed::Control;
use super::prescribed::RADIUS;
use crate::indentation::{Controlled, EdgeLaw, IndentationProblem, Oscillation, Profile, Segment};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// Strides down from a deep contact to the first crossing of a control's value, over the depth where they start; halvings of the last one.
const STRIDES: f64 = 100.0;
const HALVINGS: u32 = 60;
/// Rounding of a rate, over the value and the time.
const SAME_PACE: f64 = 1e-14;

pub(super) fn chain_of(material: &PlaneMaterial) -> Result<Chain, Refusal> {
    let relaxed = material.solid_modulus("the relaxed contact")?;
    let creep: Vec<_> = material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect();
    let relaxation: Vec<_> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
    Ok(Chain::new(material.glassy_modulus(), relaxed, &creep, &relaxation))
}

/// What this room does not solve yet is refused by name.
pub(super) fn supported(problem: &IndentationProblem) -> Result<(), Refusal> {
    let history = &problem.history;
    let by_depth = history.controls(Controlled::Penetration)
        && history.segments.iter().all(|segment| segment.controlled == Controlled::Penetration && segment.duration > 0.0);
    let given = |controlled: Controlled| controlled == Controlled::ContactRadius;
    let steady = |o: &Oscillation| o.frequency.to_bits() == o.end_frequency.to_bits();
    let refusals = [
        (problem.profile.rim().is_finite(), "shapes with a rim"),
        (problem.edge_law != EdgeLaw::CONSTANT, "edge laws"),
        (problem.adhesion.is_none() && given(history.controlled), "a given contact radius without adhesion"),
        (problem.adhesion.is_none() && !by_depth, "a force or a sudden step without adhesion"),
        (!history.segments.iter().filter_map(|segment| segment.oscillation.as_ref()).all(steady), "swept oscillations"),
    ];
    match refusals.iter().find(|(is, _)| *is) {
        Some((_, what)) => {
            Err(Refusal::Undefined { quantity: "the integration by panels", reason: format!("it does not solve {what} yet") })
        }
        None => Ok(()),
    }
}

/// c_F and c_D of a control; none of a given penetration.
pub(super) fn control_of(controlled: Controlled, frame_stiffness: f64) -> Option<Control> {
    match controlled {
        Controlled::Force => Some(Control { force: 1.0, depth: 0.0 }),
        Controlled::Frame => Some(Control { force: frame_stiffness.recip(), depth: 1.0 }),
        Controlled::ContactRadius => Some(RADIUS),
        Controlled::Penetration => None,
    }
}

/// c_F F + c_D Δ of an elastic contact.
pub(super) fn imposed(profile: &Profile, modulus: f64, control: Control, edge: f64, depth: f64) -> f64 {
    control.force * 2.0 * modulus * (edge * depth - profile.volume(edge)) + control.depth * depth
}

/// The penetration at which a control has a value, on the branch that is stable far out: from there inwards to the first crossing.
pub(super) fn started(profile: &Profile, modulus: f64, control: Control, value: f64, radius: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let excess = |depth: f64| radius(depth).map(|edge| imposed(profile, modulus, control, edge, depth) - value);
    let mut high = profile.line(radius(0.0)?);
    while excess(high)? < 0.0 {
        high *= 2.0;
    }
    let stride = high / STRIDES;
    let mut low = high;
    while excess(low)? > 0.0 {
        high = low;
        low -= stride;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if excess(middle)? > 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}

/// The segments of the history.
pub(super) fn drive_of(problem: &IndentationProblem, frame_stiffness: f64) -> Drive {
    let drive_segment = |number: usize, segment: &Segment| DriveSegment {
        control: control_of(segment.controlled, frame_stiffness),
        end: segment.end,
        duration: segment.duration,
        oscillation: segment.oscillation,
        segment: number,
    };
    let history = &problem.history;
    let mut segments: Vec<DriveSegment> = Vec::new();
    // Where the last segment began, if its quantity was given there, and where the history is.
    let (mut from, mut here): (Option<f64>, _) = (None, (history.controlled, history.start));
    for (number, segment) in history.segments.iter().enumerate() {
        let start = (here.0 == segment.controlled).then_some(here.1);
        here = (segment.controlled, segment.value(here.1, segment.duration));
        let straight = segment.duration > 0.0 && segment.oscillation.is_none();
        if let (Some(last), Some(from), Some(start), true) = (segments.last_mut(), from, start, straight) {
            let (before, now): (f64, f64) = ((start - from) / last.duration, (segment.end - start) / segment.duration);
            let noise = SAME_PACE * (from.abs().max(start.abs()).max(segment.end.abs())) / last.duration.min(segment.duration);
            if (before - now).abs() <= noise {
                // One straight way in parts.
                (last.end, last.duration) = (segment.end, last.duration + segment.duration);
                continue;
            }
        }
        from = start.filter(|_| straight);
        segments.push(drive_segment(number, segment));
    }
    Drive { start: (control_of(history.controlled, frame_stiffness), history.start), segments }
}

/// The radius at which f is a depth.
pub(super) fn radius_of(profile: &Profile, depth: f64) -> f64 {
    let mut high = 1.0;
    while profile.line(high) < depth {
        high *= 2.0;
    }
    while high > 0.0 && profile.line(0.5 * high) > depth {
        high *= 0.5;
    }
    let mut low = 0.5 * high;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if profile.line(middle) > depth { high = middle } else { low = middle }
    }
    high
}
