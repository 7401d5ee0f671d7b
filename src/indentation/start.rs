//! The first contact: relaxed or just touched, under any control.

use super::elastic_zone::{elastic_contact, elastic_contact_of_radius};
use super::line::Contact;
use super::panel::Panel;
use super::problem::{Control, IndentationProblem, Start};
use super::profile::Profile;
use super::springs::Springs;
use crate::refusal::Refusal;

/// The radius at which a rising function reaches a value.
pub(super) fn size_of(profile: Profile, function: impl Fn(f64) -> f64, value: f64) -> f64 {
    if profile == Profile::FlatPunch || value <= 0.0 {
        return 0.0;
    }
    let mut high = 1.0;
    while function(high) < value && high < 1e30 {
        high *= 2.0;
    }
    while function(high) > value && high > 1e-30 {
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
    let profile = problem.profile;
    let value = problem.control.history().start;
    let (a, depth) = match (problem.adhesion, &problem.control) {
        (Some(adhesion), Control::Penetration(_)) => {
            let state = elastic_contact(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), Control::ContactRadius(_)) => {
            let state = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), Control::Force(_)) => {
            let by_radius = |a: f64| elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, a);
            // The largest contact in equilibrium: from far out, inwards, to the first force below the imposed one.
            let mut high = 1.01 * adhesion.process_zone;
            let mut beyond = 0;
            while beyond < 60 {
                beyond = if by_radius(high)?.force > value { beyond + 1 } else { 0 };
                high *= 1.02;
            }
            let mut low = high;
            while by_radius(low)?.force > value {
                high = low;
                low /= 1.02;
                if low <= adhesion.process_zone {
                    return Err(Refusal::NoSuchState {
                        reason: format!("the force {value:e} pulls more than any contact can hold"),
                        limit_name: "the process zone",
                        limit: adhesion.process_zone,
                    });
                }
            }
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if by_radius(middle)?.force > value { high = middle } else { low = middle }
            }
            let state = by_radius(high)?;
            (state.contact_radius, state.penetration)
        }
        (None, Control::ContactRadius(_)) => (value, profile.line(value)),
        (None, Control::Penetration(_)) => (size_of(profile, |a| profile.line(a), value), value),
        (None, Control::Force(_)) => {
            let load = |a: f64| {
                let panels = profile.breaks(a);
                let panels = panels.windows(2).map(|pair| Panel::sampled(pair[0], pair[1], |s| profile.line(s)).integral());
                2.0 * modulus * (a * profile.line(a) - panels.sum::<f64>())
            };
            let a = size_of(profile, load, value);
            (a, profile.line(a))
        }
    };
    if relaxed { Contact::relaxed(springs, profile, a, depth) } else { Contact::untouched(springs, profile, a, depth) }
}
