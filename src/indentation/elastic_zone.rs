//! An elastic contact that obeys the same closure: what a relaxed, or a glassy, contact is before any time has passed.
//!
//! Q = E*(Δ − f) inside, D = f − Δ outside, at the SAME process zone δ; tends to JKR as δ → 0, with a relative difference O(δ/a).

use super::panel::Panel;
use super::profile::Profile;
use super::zone::Zone;
use super::zone_work::zone_work;
use crate::continuation::bracket::halved_if;
use crate::refusal::{Refusal, require_finite, require_positive};
use std::f64::consts::PI;

/// Ratio of neighbouring trial radii of a search: a stride over a stable contact and an unstable one is found by the least value between.
const SEARCH_RATIO: f64 = 1.1;
/// So many strides on a rising value are far out.
const STRIDES_BEYOND: u32 = 13;
/// Strides of a search at most: 170 decades.
const MOST_STRIDES: u32 = 4_100;

/// A contact in elastic equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticContact {
    /// a (m).
    pub contact_radius: f64,
    /// Δ (m).
    pub penetration: f64,
    /// F (N).
    pub force: f64,
    /// K_I (Pa√m).
    pub stress_intensity_factor: f64,
    /// C/Δγ − 1.
    pub residual: f64,
}

fn work(profile: &Profile, modulus: f64, zone: f64, a: f64, penetration: f64) -> Result<f64, Refusal> {
    let kernel = Zone::new(a, zone)?;
    let inside: Vec<Panel> =
        profile.breaks(a).windows(2).map(|pair| Panel::sampled(pair[0], pair[1], |s| modulus * (penetration - profile.line(s)))).collect();
    let gap = |low: f64, high: f64| (low < high).then(|| Panel::sampled(low, high, |s| profile.line(s) - penetration));
    // Beyond a rim the gap no longer grows.
    let corner = profile.rim().clamp(a, a + zone);
    let outside: Vec<Panel> = gap(a, corner).into_iter().chain(gap(corner, a + zone)).collect();
    let value = zone_work(&kernel, &inside, &outside);
    // A pressed edge over an overlapping surface works positively as well; it is on the other side of equilibrium.
    Ok(if penetration > profile.line(a) { -value } else { value })
}

fn state(profile: &Profile, modulus: f64, a: f64, penetration: f64, residual: f64) -> ElasticContact {
    let panels = profile.breaks(a);
    let force = panels.windows(2).map(|pair| Panel::sampled(pair[0], pair[1], |s| penetration - profile.line(s)).integral()).sum::<f64>();
    let edge = modulus * (profile.line(a) - penetration);
    ElasticContact {
        contact_radius: a,
        penetration,
        force: 2.0 * modulus * force,
        stress_intensity_factor: edge / (PI * a).sqrt(),
        residual,
    }
}

/// Radii that enclose the widest stable contact under an imposed value, such as a force, which is a function of the radius of contacts in equilibrium; or the least value
/// that any contact carries.
///
/// Far out the value rises with the radius. Going inwards it falls to a fold, and rises again where contacts are unstable: the narrowest of them bear any pull's
/// beginning, so that only a rising value is far out. Near a fold a stride may step over the stable contact and the unstable one: where the value has turned, its least
/// one is looked for. `rim`: no contact is wider, and the widest one carries more than the value; infinite without.
pub(super) fn widest_stable(
    process_zone: f64,
    rim: f64,
    value: f64,
    mut imposed: impl FnMut(f64) -> Result<f64, Refusal>,
) -> Result<Result<[f64; 2], f64>, Refusal> {
    let mut high = if rim.is_finite() { rim } else { 1.01 * process_zone };
    let (mut beyond, mut last) = (if rim.is_finite() { STRIDES_BEYOND } else { 0 }, f64::INFINITY);
    for _ in 0..MOST_STRIDES {
        if beyond >= STRIDES_BEYOND {
            break;
        }
        let here = imposed(high)?;
        beyond = if here > value && here > last { beyond + 1 } else { 0 };
        if beyond < STRIDES_BEYOND {
            high *= SEARCH_RATIO;
        }
        last = here;
    }
    let mut here = (high, imposed(high)?);
    let mut before = here;
    for _ in 0..MOST_STRIDES {
        let a = here.0 / SEARCH_RATIO;
        if a <= process_zone {
            break;
        }
        let next = (a, imposed(a)?);
        if next.1 <= value {
            return Ok(Ok([next.0, here.0]));
        }
        if next.1 > here.1 {
            let (least_at, least) = least_between(next.0, before.0, &mut imposed)?;
            return Ok(if least <= value { Ok([least_at, before.0]) } else { Err(least) });
        }
        (before, here) = (here, next);
    }
    Ok(Err(here.1))
}

/// The least value of a function with one minimum between two places, by golden sections, to the digits that a minimum has.
fn least_between(low: f64, high: f64, value: &mut impl FnMut(f64) -> Result<f64, Refusal>) -> Result<(f64, f64), Refusal> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (low, high);
    let (mut inner, mut outer) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_inner, mut at_outer) = (value(inner)?, value(outer)?);
    while high - low > 1e-8 * high {
        if at_inner < at_outer {
            (high, outer, at_outer) = (outer, inner, at_inner);
            inner = high - golden * (high - low);
            at_inner = value(inner)?;
        } else {
            (low, inner, at_inner) = (inner, outer, at_outer);
            outer = low + golden * (high - low);
            at_outer = value(outer)?;
        }
    }
    Ok(if at_inner < at_outer { (inner, at_inner) } else { (outer, at_outer) })
}

/// The stable equilibrium (the larger contact) at a penetration (m): modulus E* (Pa), Δγ (J/m²), δ (m).
///
/// # Errors
/// [`Refusal::NoSuchState`] when no contact larger than the process zone is in equilibrium there; [`Refusal::Undefined`] for a flat punch, whose
/// radius is given; [`Refusal::OutOfRange`].
pub fn elastic_contact(
    profile: &Profile,
    modulus: f64,
    work_of_adhesion: f64,
    process_zone: f64,
    penetration: f64,
) -> Result<ElasticContact, Refusal> {
    profile.clone().checked()?;
    require_positive("contact_modulus", modulus)?;
    require_positive("work_of_adhesion", work_of_adhesion)?;
    require_positive("process_zone", process_zone)?;
    require_finite("penetration", penetration)?;
    if profile.is_flat() {
        return Err(Refusal::Undefined { quantity: "the contact radius of a flat punch", reason: "its rim gives it".into() });
    }
    let rim = profile.rim();
    if rim.is_finite() && penetration >= elastic_contact_of_radius(profile, modulus, work_of_adhesion, process_zone, rim)?.penetration {
        // Its rim holds it: C is below the work of adhesion, or the edge is pressed.
        return Ok(state(profile, modulus, rim, penetration, 0.0));
    }
    let balance = |a: f64| Ok::<f64, Refusal>(work(profile, modulus, process_zone, a, penetration)? / work_of_adhesion - 1.0);
    let equilibrium = |a: f64| Ok(trial_of_radius(profile, modulus, work_of_adhesion, process_zone, a)?.penetration);
    let bracket = match widest_stable(process_zone, rim, penetration, equilibrium)? {
        Ok(bracket) => bracket,
        Err(least) => {
            return Err(Refusal::NoSuchState {
                reason: format!("no contact larger than its process zone is in equilibrium at the penetration {penetration:e}"),
                limit_name: "the least penetration of a contact in equilibrium",
                limit: least,
            });
        }
    };
    let [_, radius] = halved_if(bracket, |a| Ok(balance(a)? <= 0.0))?;
    profile.holds(radius, process_zone)?;
    Ok(state(profile, modulus, radius, penetration, balance(radius)?))
}

/// The equilibrium with a given contact radius (m): C is a quadratic in Δ, and tension picks its root.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a radius not larger than the process zone; [`Refusal::NoSuchState`] when the quadratic has no root, or beyond the
/// last point of a table.
pub fn elastic_contact_of_radius(
    profile: &Profile,
    modulus: f64,
    work_of_adhesion: f64,
    process_zone: f64,
    contact_radius: f64,
) -> Result<ElasticContact, Refusal> {
    profile.holds(contact_radius, process_zone)?;
    trial_of_radius(profile, modulus, work_of_adhesion, process_zone, contact_radius)
}

/// The same for a search, which may try radii beyond the last point of a table.
pub(super) fn trial_of_radius(
    profile: &Profile,
    modulus: f64,
    work_of_adhesion: f64,
    process_zone: f64,
    contact_radius: f64,
) -> Result<ElasticContact, Refusal> {
    profile.clone().checked()?;
    require_positive("contact_modulus", modulus)?;
    require_positive("work_of_adhesion", work_of_adhesion)?;
    require_positive("process_zone", process_zone)?;
    let a = require_positive("contact_radius", contact_radius)?;
    let depth = profile.line(a);
    let unit = (2.0 * PI * a * work_of_adhesion / modulus).sqrt();
    // At Δ ≤ f(a) the sign of `work` is that of C itself.
    let sample = |x: f64| work(profile, modulus, process_zone, a, depth - unit * x);
    let x = tension_root([sample(0.0)?, sample(1.0)?, sample(2.0)?], work_of_adhesion)?;
    let penetration = depth - unit * x;
    let residual = work(profile, modulus, process_zone, a, penetration)? / work_of_adhesion - 1.0;
    Ok(state(profile, modulus, a, penetration, residual))
}

/// The larger root of the parabola through values at 0, 1, 2 where it reaches `level`.
pub(super) fn tension_root(values: [f64; 3], level: f64) -> Result<f64, Refusal> {
    let [first, second, third] = values;
    let square = 0.5 * (third - 2.0 * second + first);
    let slope = second - first - square;
    let constant = first - level;
    let discriminant = slope * slope - 4.0 * square * constant;
    let found = discriminant >= 0.0 && square > 0.0;
    if !found {
        return Err(Refusal::NoSuchState {
            reason: "no tension at the edge balances the work of adhesion".into(),
            limit_name: "the discriminant of the closure",
            limit: discriminant,
        });
    }
    let root = discriminant.sqrt();
    Ok(if slope <= 0.0 { (root - slope) / (2.0 * square) } else { -2.0 * constant / (slope + root) })
}
