//! The first contact: relaxed or just touched, under any control.

use super::elastic_zone::{ElasticContact, elastic_contact, elastic_contact_of_radius, trial_of_radius, widest_stable};
use super::history::Controlled;
use super::line::Contact;
use super::panel::Panel;
use super::problem::{Adhesion, IndentationProblem, Start};
use super::profile::Profile;
use super::springs::Springs;
use crate::refusal::Refusal;

/// The radius at which a rising function reaches a value.
pub(super) fn size_of(profile: &Profile, function: impl Fn(f64) -> f64, value: f64) -> f64 {
    if value <= 0.0 || profile.rim().is_finite() {
        return 0.0;
    }
    let mut high = 1.0;
    while function(high) < value && high < 1e300 {
        high *= 2.0;
    }
    while function(high) > value && high > 1e-300 {
        high *= 0.5;
    }
    let (mut low, mut top) = (high, 2.0 * high);
    for _ in 0..60 {
        let middle = 0.5 * (low + top);
        if function(middle) < value {
            low = middle;
        } else {
            top = middle;
        }
    }
    top
}

/// The first contact.
pub(super) fn started<'a>(springs: &'a Springs, problem: &IndentationProblem) -> Result<Contact<'a>, Refusal> {
    let relaxed = problem.start == Start::Relaxed;
    let modulus = if relaxed { springs.relaxed } else { springs.glassy };
    let profile = &problem.profile;
    let history = &problem.history;
    let value = history.start;
    // An edge that has crept outwards to rest, or jumps out at once.
    let closing = if relaxed { 0.0 } else { f64::INFINITY };
    let adhesion = match problem.adhesion {
        Some(adhesion) if profile.rim().is_infinite() => {
            if !relaxed {
                problem.edge_law.goes(false)?;
            }
            let [_, leading] = problem.edge_law.levels(closing);
            Some(Adhesion { work_of_adhesion: leading * adhesion.work_of_adhesion, ..adhesion })
        }
        adhesion => adhesion,
    };
    let (a, depth) = match (adhesion, history.controlled) {
        (Some(adhesion), Controlled::ContactRadius) => {
            let state = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), controlled) if profile.rim().is_finite() => {
            // A flat punch that its rim holds; more tension than the rim bears is no start.
            let rim = profile.rim();
            let slope = 2.0 * modulus * rim;
            let depth = match controlled {
                Controlled::Force => value / slope,
                Controlled::Frame => problem.frame_stiffness.map_or(value, |stiffness| value * stiffness / (stiffness + slope)),
                Controlled::Penetration | Controlled::ContactRadius => value,
            };
            let most = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, rim)?.penetration;
            if depth < most {
                return Err(Refusal::NoSuchState {
                    reason: format!("the punch is pulled by {depth:e} and loses contact"),
                    limit_name: "the penetration at which its rim gives way",
                    limit: most,
                });
            }
            (rim, depth)
        }
        (Some(adhesion), Controlled::Penetration) => {
            let state = elastic_contact(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), Controlled::Force | Controlled::Frame) => {
            let imposed = |state: &ElasticContact| match (history.controlled, problem.frame_stiffness) {
                (Controlled::Frame, Some(stiffness)) => state.penetration + state.force / stiffness,
                _ => state.force,
            };
            let by_radius = |a: f64| trial_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, a);
            let [mut low, mut high] = match widest_stable(adhesion.process_zone, value, |a| Ok(imposed(&by_radius(a)?)))? {
                Ok(bracket) => bracket,
                Err(least) => {
                    return Err(Refusal::NoSuchState {
                        reason: format!("the value {value:e} pulls more than any contact can hold"),
                        limit_name: "the least value of a contact in equilibrium",
                        limit: least,
                    });
                }
            };
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if imposed(&by_radius(middle)?) > value { high = middle } else { low = middle }
            }
            let state = by_radius(high)?;
            (state.contact_radius, state.penetration)
        }
        (None, Controlled::ContactRadius) => (value, profile.line(value)),
        (None, Controlled::Penetration) => (touching(profile, |a| profile.line(a), value), value),
        (None, Controlled::Force | Controlled::Frame) => {
            let load = |a: f64| {
                let panels = profile.breaks(a);
                let panels = panels.windows(2).map(|pair| Panel::sampled(pair[0], pair[1], |s| profile.line(s)).integral());
                2.0 * modulus * (a * profile.line(a) - panels.sum::<f64>())
            };
            let rim = profile.rim();
            if rim.is_finite() {
                let slope = 2.0 * modulus * rim;
                let depth = match (history.controlled, problem.frame_stiffness) {
                    (Controlled::Frame, Some(stiffness)) => value * stiffness / (stiffness + slope),
                    _ => value / slope,
                };
                (if depth > 0.0 { rim } else { 0.0 }, depth)
            } else {
                let imposed = |a: f64| match (history.controlled, problem.frame_stiffness) {
                    (Controlled::Frame, Some(stiffness)) => profile.line(a) + load(a) / stiffness,
                    _ => load(a),
                };
                let a = size_of(profile, imposed, value);
                (a, profile.line(a))
            }
        }
    };
    let profile = profile.clone();
    if relaxed { Contact::relaxed(springs, profile, a, depth) } else { Contact::untouched(springs, profile, a, depth) }
}

/// The radius at which an indenter without adhesion touches under a penetration.
fn touching(profile: &Profile, function: impl Fn(f64) -> f64, value: f64) -> f64 {
    if profile.rim().is_finite() && value > 0.0 { profile.rim() } else { size_of(profile, function, value) }
}
