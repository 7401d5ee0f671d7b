//! The first contact: relaxed or just touched, under any control.

use super::edge::grown;
use super::elastic_zone::{ElasticContact, elastic_contact, elastic_contact_of_radius, trial_of_radius, widest_stable};
use super::history::Controlled;
use super::line::Contact;
use super::panel::Panel;
use super::problem::{Adhesion, IndentationProblem, Start};
use super::profile::Profile;
use super::springs::Springs;
use crate::continuation::bracket::halved_if;
use crate::refusal::Refusal;

/// Rounds in which the process zone of a first contact settles with the pull at its edge, and the change of it that is rounding.
const ROUNDS_OF_GROWTH: usize = 60;
const SAME_ZONE: f64 = 1e-13;

/// The radius at which a rising function reaches a value.
pub(super) fn size_of(profile: &Profile, function: impl Fn(f64) -> f64, value: f64) -> f64 {
    if value <= 0.0 || profile.is_flat() {
        return 0.0;
    }
    if profile.rim().is_finite() && function(profile.rim()) <= value {
        return profile.rim();
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
pub(super) fn started<'a>(springs: &'a Springs, problem: &IndentationProblem, adhesion: Adhesion) -> Result<Contact<'a>, Refusal> {
    let relaxed = problem.start == Start::Relaxed;
    let modulus = if relaxed { springs.relaxed } else { springs.glassy };
    let profile = &problem.profile;
    // An edge that has crept outwards to rest, or jumps out at once.
    let closing = if relaxed { 0.0 } else { f64::INFINITY };
    let adhesion = if profile.rim().is_infinite() {
        if !relaxed {
            problem.edge_law.goes(false)?;
        }
        let [_, leading] = problem.edge_law.levels(closing);
        Adhesion { work_of_adhesion: leading * adhesion.work_of_adhesion, ..adhesion }
    } else {
        adhesion
    };
    let (a, depth) = match at_rim(problem, adhesion, modulus)? {
        Some(held) => held,
        None if problem.edge_law.growing_zone => with_grown_zone(problem, adhesion, (modulus, springs.relaxed))?,
        None => at_edge(problem, adhesion, modulus)?,
    };
    let profile = profile.clone();
    if relaxed { Contact::relaxed(springs, profile, a, depth) } else { Contact::untouched(springs, profile, a, depth) }
}

/// The radius and the penetration of a contact that a rim holds, if one does; a flat face touches by no less.
fn at_rim(problem: &IndentationProblem, adhesion: Adhesion, modulus: f64) -> Result<Option<(f64, f64)>, Refusal> {
    let (profile, history) = (&problem.profile, &problem.history);
    let (rim, value) = (profile.rim(), history.start);
    if rim.is_infinite() || history.controlled == Controlled::ContactRadius {
        return Ok(None);
    }
    // F = slope Δ − shape.
    let (slope, shape) = (2.0 * modulus * rim, 2.0 * modulus * height_integral(profile, rim));
    let depth = match (history.controlled, problem.frame_stiffness) {
        (Controlled::Force, _) => (value + shape) / slope,
        (Controlled::Frame, Some(stiffness)) => (value * stiffness + shape) / (stiffness + slope),
        _ => value,
    };
    let least = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, rim)?.penetration;
    if depth < least && profile.is_flat() {
        return Err(Refusal::NoSuchState {
            reason: format!("the punch is pulled by {depth:e} and loses contact"),
            limit_name: "the penetration at which its rim detaches",
            limit: least,
        });
    }
    Ok((depth >= least).then_some((rim, depth)))
}

/// ∫₀^a f ds (m²).
fn height_integral(profile: &Profile, a: f64) -> f64 {
    profile.breaks(a).windows(2).map(|pair| Panel::sampled(pair[0], pair[1], |s| profile.line(s)).integral()).sum()
}

/// The same with the process zone of its own edge.
fn with_grown_zone(problem: &IndentationProblem, adhesion: Adhesion, (modulus, relaxed): (f64, f64)) -> Result<(f64, f64), Refusal> {
    let profile = &problem.profile;
    let mut zone = adhesion.process_zone;
    for _ in 0..ROUNDS_OF_GROWTH {
        let (a, depth) = at_edge(problem, Adhesion { process_zone: zone, ..adhesion }, modulus)?;
        let next = grown(&adhesion, relaxed, (a, modulus * (depth - profile.line(a))));
        if (next - zone).abs() <= SAME_ZONE * zone {
            return Ok((a, depth));
        }
        zone = next;
    }
    Err(Refusal::NotConverged { what: "the first contact", detail: "its process zone does not settle with the pull at its edge".into() })
}

/// The radius and the penetration of a contact whose edge is free to move.
fn at_edge(problem: &IndentationProblem, adhesion: Adhesion, modulus: f64) -> Result<(f64, f64), Refusal> {
    let (profile, history) = (&problem.profile, &problem.history);
    let value = history.start;
    Ok(match history.controlled {
        Controlled::ContactRadius => {
            let state = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        Controlled::Penetration => {
            let state = elastic_contact(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        Controlled::Force | Controlled::Frame => {
            let imposed = |state: &ElasticContact| match (history.controlled, problem.frame_stiffness) {
                (Controlled::Frame, Some(stiffness)) => state.penetration + state.force / stiffness,
                _ => state.force,
            };
            let by_radius = |a: f64| trial_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, a);
            let bracket = match widest_stable(adhesion.process_zone, profile.rim(), value, |a| Ok(imposed(&by_radius(a)?)))? {
                Ok(bracket) => bracket,
                Err(least) => {
                    return Err(Refusal::NoSuchState {
                        reason: format!("the value {value:e} pulls more than any contact can hold"),
                        limit_name: "the least value of a contact in equilibrium",
                        limit: least,
                    });
                }
            };
            let [_, radius] = halved_if(bracket, |a| Ok(imposed(&by_radius(a)?) <= value))?;
            let state = by_radius(radius)?;
            (state.contact_radius, state.penetration)
        }
    })
}
