//! Source: Johnson, Kendall & Roberts (1971) for a sphere, Kendall (1971) for a punch; thesis Secs 4.3, 4.4 (a start answers with E∞, a relaxed one with E0).
//!
//! Goal: what a contact does at once: which modulus it starts with, and where its edge goes when it is pressed so far that the edge itself is pressed.
//!
//! ```text
//!   step of Δ    a ──┐ pressed edge: compression meets overlapping faces, so the closure, a product, is positive again
//!                    └──→ the edge must go out to the equilibrium of the new depth; the root of the pressed edge lies inwards
//! ```
//! Parameters: steps of 2 to 120 times the depth that the tension of the edge stands for, up and down (the integration takes a sixteenth at once: above 32 the edge is
//! pressed so hard that the product exceeds the work of adhesion); an elastic solid and β = 10; zones 0.02 to 1 % of the contact.
//!
//! Oracle: elastic contacts at equal process zone (their own oracle: `indentation_reference_values`), and JKR's closed form at the same depth; for punches Kendall's
//! pull-off and F = 2aΔ/J(t).
//!
//! Tolerance: 1e-9 against the elastic contact of the same zone, twice δ/a against JKR (first order in the zone); for punches rounding (1e-12) at the start, 1e-7 for
//! creep (the integration is asked for 1e-7), and 1e-3 for the pull-off (first order in a zone of 1e-4).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::indentation::{SPHERE, WORK};
use viscotack::PlaneMaterial;
use viscotack::elastic::{EquilibriumBranch, JkrSphere, KendallPunch};
use viscotack::indentation::{Adhesion, EventKind, History, IndentationProblem, Profile, elastic_contact, integrate};
use viscotack::refusal::Refusal;

fn sphere(zone: f64, history: History) -> IndentationProblem {
    IndentationProblem::new(SPHERE, Some(Adhesion { work_of_adhesion: WORK, process_zone: zone }), history)
}

#[test]
fn a_large_step_of_penetration_finds_the_equilibrium_of_its_depth() {
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    let closed = JkrSphere::new(1.0, 1.0, WORK).unwrap();
    for zone in [2e-3, 2e-4] {
        for (first, second) in [(0.01, 0.06), (0.02, 0.5), (0.01, 1.0), (0.01, 3.0), (0.5, 0.01), (3.0, 0.01)] {
            let trace = integrate(&elastic, &sphere(zone, History::penetration(first).step(second)), 1e-3).unwrap();
            let end = trace.path.last().unwrap();
            let same_zone = elastic_contact(&SPHERE, 1.0, WORK, zone, second).unwrap();
            let off = [end.contact_radius / same_zone.contact_radius - 1.0, end.force / same_zone.force - 1.0];
            println!("zone {zone}, {first} to {second}: a = {:.9}, off by {off:?}", end.contact_radius);
            assert!(off.iter().all(|off| off.abs() < 1e-9), "{end:?} {same_zone:?}");
            assert!(trace.events.iter().all(|event| event.kind == EventKind::JumpIn), "{:?}", trace.events);
            let jkr = closed.state_by_penetration(second, EquilibriumBranch::Stable).unwrap();
            assert!((end.contact_radius / jkr.contact_radius - 1.0).abs() < 2.0 * zone / jkr.contact_radius);
        }
    }
}

/// β = 10: at once the step is carried by E∞ upon what the relaxed contact held, so that the contact radius lies between those of the two depths, and after a thousand
/// relaxation times nothing of the way is left.
#[test]
fn a_large_step_on_rubber_goes_outwards_and_relaxes() {
    let rubber = PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    for (first, second) in [(0.01, 0.1), (0.01, 0.4)] {
        let zone = 2e-3;
        let problem = sphere(zone, History::penetration(first).step(second).hold(1e4)).relaxed();
        let trace = integrate(&rubber, &problem, 1e-3).unwrap();
        let at_once = trace.path[trace.kept[1]];
        let [low, high] = [first, second].map(|depth| elastic_contact(&SPHERE, 1.0, WORK, zone, depth).unwrap());
        println!("{first} to {second}: {} between {} and {}", at_once.contact_radius, low.contact_radius, high.contact_radius);
        assert!(at_once.contact_radius > 1.5 * low.contact_radius && at_once.contact_radius < high.contact_radius);
        let end = trace.path.last().unwrap();
        assert!((end.contact_radius / high.contact_radius - 1.0).abs() < 1e-6 && (end.force / high.force - 1.0).abs() < 1e-6, "{end:?}");
    }
}

/// A punch that just touched is glassy, a relaxed one soft, under force too: Δ = F J(t)/2a, and the rim holds √(8πE*Δγa³) of its own modulus.
#[test]
fn a_punch_starts_with_the_modulus_of_its_past() {
    let (radius, relaxed, beta) = (0.1, 1.0, 10.0);
    let material = PlaneMaterial::standard_solid(relaxed, beta * relaxed, 10.0).unwrap();
    for adhesion in [None, Some(Adhesion { work_of_adhesion: WORK, process_zone: 1e-4 })] {
        let loaded = |force: f64| IndentationProblem::new(Profile::FlatPunch { radius }, adhesion, History::force(force).hold(30.0));
        for (problem, compliance) in [(loaded(0.02), 1.0 / (beta * relaxed)), (loaded(0.02).relaxed(), 1.0 / relaxed)] {
            let trace = integrate(&material, &problem, 1e-7).unwrap();
            let start = trace.path[0];
            assert!((start.penetration / (0.02 * compliance / (2.0 * radius)) - 1.0).abs() < 1e-12, "{start:?}");
            // A relaxed punch stays; a fresh one creeps.
            let fresh = compliance < 1.0 / relaxed;
            let creep = if fresh { material.creep(30.0) } else { compliance };
            let end = trace.path.last().unwrap();
            assert!((end.penetration / (0.02 * creep / (2.0 * radius)) - 1.0).abs() < 1e-7, "{end:?}");
        }
    }
    let zone = 1e-5;
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: zone });
    for (modulus, is_relaxed) in [(beta * relaxed, false), (relaxed, true)] {
        let holds = KendallPunch::new(radius, modulus, WORK).unwrap().pull_off_force().unwrap();
        assert!((holds / (8.0 * PI * modulus * WORK * radius.powi(3)).sqrt() - 1.0).abs() < 1e-14);
        let pulled = |part: f64| {
            let problem = IndentationProblem::new(Profile::FlatPunch { radius }, adhesion, History::force(-part * holds));
            integrate(&material, &if is_relaxed { problem.relaxed() } else { problem }, 1e-3)
        };
        // First order in the zone: δ/a = 1e-4.
        assert!(pulled(0.999).is_ok());
        let beyond = pulled(1.001).err();
        assert!(matches!(beyond, Some(Refusal::NoSuchState { .. })), "{beyond:?}");
    }
}
