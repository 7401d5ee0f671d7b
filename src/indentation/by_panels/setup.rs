//! A problem of this crate in the terms of the room: its chain, its drive and its first contact; what is not solved yet is refused by name.

use super::chain::Chain;
use super::drive::Drive;
use super::followed::Control;
use crate::indentation::{Controlled, EdgeLaw, IndentationProblem, Oscillation, Profile, Segment};
use crate::material::Material;
use crate::refusal::Refusal;

/// Strides down from a deep contact to the first crossing of a control's value, over the depth where they start; halvings of the last one.
const STRIDES: f64 = 100.0;
const HALVINGS: u32 = 60;

pub(super) fn chain_of(material: &Material) -> Result<Chain, Refusal> {
    let relaxed = material.solid_modulus("the relaxed contact")?;
    let creep: Vec<_> = material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect();
    let relaxation: Vec<_> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
    Ok(Chain::new(material.glassy_modulus(), relaxed, &creep, &relaxation))
}

/// What this room does not solve yet is refused by name.
pub(super) fn supported(problem: &IndentationProblem) -> Result<(), Refusal> {
    let history = &problem.history;
    let first = history.segments.first().map_or(history.controlled, |segment| segment.controlled);
    let mixed = history.segments.iter().any(|segment| segment.controlled != first);
    let steady = |o: &Oscillation| o.frequency.to_bits() == o.end_frequency.to_bits() && !o.until_stationary;
    let sudden = |segment: &Segment| segment.duration <= 0.0;
    let refusals = [
        (!matches!(problem.profile, Profile::Paraboloid { .. } | Profile::Cone { .. }), "other shapes than spheres and cones"),
        (problem.edge_law != EdgeLaw::CONSTANT, "edge laws"),
        (mixed, "controls that change after the first stretch"),
        (first == Controlled::ContactRadius || history.controlled == Controlled::ContactRadius, "a given contact radius"),
        (problem.adhesion.is_none() && (first != Controlled::Penetration || history.controlled != first), "a force without adhesion"),
        (first == Controlled::Penetration && history.controlled != first, "a penetration after a start at a force"),
        (first == Controlled::Penetration && history.segments.iter().any(sudden), "sudden steps of the penetration"),
        (history.segments.last().is_some_and(sudden), "a step that ends the history"),
        (!history.segments.iter().filter_map(|segment| segment.oscillation.as_ref()).all(steady), "swept or open-ended oscillations"),
    ];
    match refusals.iter().find(|(is, _)| *is) {
        Some((_, what)) => Err(Refusal::Undefined { quantity: "the march by panels", reason: format!("it does not solve {what} yet") }),
        None => Ok(()),
    }
}

/// c_F and c_D of a control; none of a given penetration.
pub(super) fn control_of(controlled: Controlled, frame_stiffness: f64) -> Option<Control> {
    match controlled {
        Controlled::Force => Some(Control { force: 1.0, depth: 0.0 }),
        Controlled::Frame => Some(Control { force: frame_stiffness.recip(), depth: 1.0 }),
        Controlled::Penetration | Controlled::ContactRadius => None,
    }
}

/// c_F F + c_D Δ of an elastic contact.
pub(super) fn imposed(profile: &Profile, modulus: f64, control: Control, edge: f64, depth: f64) -> f64 {
    let volume: f64 = match profile {
        Profile::Paraboloid { .. } => edge * profile.line(edge) / 3.0,
        _ => edge * profile.line(edge) / 2.0,
    };
    control.force * 2.0 * modulus * (edge * depth - volume) + control.depth * depth
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

pub(super) fn drive_of(
    chain: &Chain,
    problem: &IndentationProblem,
    control: Option<Control>,
    first: &dyn Fn(Control) -> f64,
) -> Result<Drive, Refusal> {
    // A control that takes over starts from its value by then.
    let mut value = control.filter(|_| problem.history.controlled == Controlled::Penetration).map_or(problem.history.start, first);
    let mut drive = Drive::from(value);
    drive.control = control;
    for segment in &problem.history.segments {
        if segment.duration <= 0.0 {
            drive = drive.step(segment.end);
        } else {
            let rate = (segment.end - value) / segment.duration;
            drive = match segment.oscillation {
                None => drive.ramp(chain, rate, segment.duration),
                Some(o) => drive.oscillate(chain, rate, o.amplitude, std::f64::consts::TAU * o.frequency, segment.duration),
            };
        }
        value = segment.value(value, segment.duration);
    }
    Ok(drive)
}

/// The radius at which f is a depth.
pub(super) fn radius_of(profile: &Profile, depth: f64) -> f64 {
    match profile {
        Profile::Paraboloid { radius } => (radius * depth).sqrt(),
        _ => depth / profile.line(1.0),
    }
}
