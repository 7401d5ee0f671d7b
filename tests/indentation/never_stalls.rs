//! Source: this crate's promise that a history always gives a result or a typed refusal with its reason.
//!
//! Goal: the hard cases of an integration, each with what must happen stated beforehand.
//!
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, E0* = R = 1 (chapter 4) unless a case says otherwise; requested accuracy 1e-4.
//!
//! Oracle: what each case is named for: a limit, an event that must or must not happen, a refusal.
//!
//! Tolerance: as each case says. Every integration: residual below 1e-8, no pressed edge, no overlap, fewer than 40 000 closures in all its integrations.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::indentation::{SPHERE, WORK, ZONE, rubber};
use viscotack::indentation::{
    Adhesion, Controlled, EventKind, History, IndentationProblem, IndentationSolution, Oscillation, Profile, elastic_contact,
    elastic_contact_of_radius, integrate, run,
};
use viscotack::material::RelaxationTerm;
use viscotack::{PlaneMaterial, refusal::Refusal};

fn asked(history: History) -> IndentationProblem {
    IndentationProblem::new(SPHERE, Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE }), history)
}

fn solved(name: &str, material: &PlaneMaterial, problem: &IndentationProblem) -> IndentationSolution {
    let found = run(material, problem).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
    println!(
        "{name}: {} steps, {} closures, F_off {:?}, {:?}",
        found.work.steps,
        found.work.closure_evaluations,
        found.pull_off_force().map(|force| (force.value, force.error)),
        found.events.iter().map(|event| (event.kind, event.time.value)).collect::<Vec<_>>()
    );
    assert!(found.reached, "{name} misses its accuracy");
    for point in found.integration.path.iter().filter(|point| point.residual.abs() > 1e-8) {
        println!("{point:?}");
    }
    assert!(found.residual < 1e-8, "{name}: residual {:e}", found.residual);
    assert!(found.smallest_stress_intensity_factor > -1e-6 && found.smallest_gap_factor > -1e-9, "{name}");
    assert!(found.work.closure_evaluations < 40_000, "{name}");
    for instant in &found.instants {
        for estimate in [instant.force, instant.contact_radius, instant.penetration, instant.stress_intensity_factor] {
            assert!(estimate.value.is_finite() && estimate.error.is_finite(), "{name}");
        }
    }
    found
}

fn happened(found: &IndentationSolution, kind: EventKind) -> usize {
    found.events.iter().filter(|event| event.kind == kind).count()
}

fn wide(terms: usize) -> PlaneMaterial {
    let term = |k: usize| RelaxationTerm {
        modulus: 99.0 / terms as f64,
        relaxation_time: 10f64.powf(-6.0 + 12.0 * k as f64 / (terms - 1) as f64),
    };
    PlaneMaterial::from_relaxation(1.0, &(0..terms).map(term).collect::<Vec<_>>()).unwrap()
}

/// Eight decades of speed: the pull-off of a cycle after a full approach grows from the soft to the glassy one and stays between them.
#[test]
fn eight_decades_of_speed() {
    let mut last = 0.0;
    for power in -4..=4 {
        let speed = 10f64.powi(power);
        let history = History::penetration(0.02).at_speed(-0.05, speed);
        let found = solved(&format!("speed 1e{power}"), &rubber(), &asked(history).relaxed());
        let pull_off = found.pull_off_force().unwrap().value / (1.5 * PI * WORK);
        assert!(pull_off > last - 1e-6 && pull_off < 10.0 && pull_off > 1.0);
        assert_eq!(happened(&found, EventKind::Detachment) + happened(&found, EventKind::ZoneReached), 1);
        last = pull_off;
    }
}

#[test]
fn one_to_twenty_terms_over_twelve_decades() {
    for terms in [2, 6, 20] {
        let history = History::penetration(0.0).at_speed(0.02, 0.1).hold(1e3).at_speed(-0.05, 0.1);
        let found = solved(&format!("{terms} terms"), &wide(terms), &asked(history));
        assert!(found.instants.last().unwrap().contact_radius.value.abs() < 1e-12);
    }
}

#[test]
fn ratios_of_moduli() {
    for beta in [1.0, 1.001, 1000.0] {
        let material = PlaneMaterial::standard_solid(1.0, beta, beta).unwrap();
        let found = solved(&format!("β = {beta}"), &material, &asked(History::penetration(0.02).at_speed(-0.05, 0.1)).relaxed());
        let pull_off = found.pull_off_force().unwrap().value / (1.5 * PI * WORK);
        assert!(pull_off > 0.9 && pull_off < beta.max(1.1));
    }
}

/// Ten billion relaxation times later the contact is the soft elastic one, and goes on sharply from there.
#[test]
fn a_dwell_of_many_relaxation_times() {
    let found = solved("dwell", &rubber(), &asked(History::penetration(0.0).at_speed(0.02, 0.1).hold(1e10).at_speed(-0.05, 0.1)));
    let held = found.instants[2];
    let soft = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.02).unwrap();
    assert!((held.contact_radius.value / soft.contact_radius - 1.0).abs() < 1e-7);
    assert!((held.force.value / soft.force - 1.0).abs() < 1e-6);
    assert_eq!(happened(&found, EventKind::Detachment), 1);
}

#[test]
fn nothing_happens_at_speed_zero() {
    let found = solved("speed zero", &rubber(), &asked(History::penetration(0.02).hold(10.0)).relaxed());
    assert!((found.instants[1].contact_radius.value / found.instants[0].contact_radius.value - 1.0).abs() < 1e-10);
}

/// A pull beyond what even the glassy contact holds opens it at once; one beyond the soft contact only, after a while; a small one never.
#[test]
fn forces_below_pull_off() {
    let soft = 1.5 * PI * WORK;
    for (factor, opens) in [(20.0, Some(0.0)), (2.0, None), (0.5, None)] {
        let found = solved(&format!("{factor} F_JKR"), &rubber(), &asked(History::force(0.0).step(-factor * soft).hold(400.0)).relaxed());
        let event = found.events.iter().find(|event| event.kind == EventKind::Detachment || event.kind == EventKind::ZoneReached);
        match (opens, event) {
            (Some(time), Some(event)) => assert!((event.time.value - time).abs() < 1e-9),
            (None, Some(event)) => assert!(factor > 1.0 && event.time.value > 0.01),
            (None, None) => assert!(factor < 1.0),
            (Some(_), None) => panic!("{factor}: still in contact"),
        }
    }
}

#[test]
fn reversals_and_touching_again() {
    let history = History::penetration(0.02).at_speed(0.015, 1e-2).at_speed(0.03, 1e-2).at_speed(0.0, 3e-2).at_speed(0.01, 1e-3);
    solved("reversals", &rubber(), &asked(history).relaxed());
    let history = History::penetration(0.0).at_speed(0.01, 0.01).at_speed(-0.03, 0.01).hold(3.0).at_speed(0.02, 0.01).at_speed(-0.05, 0.01);
    let found = solved("touching again", &rubber(), &asked(history));
    assert_eq!(happened(&found, EventKind::JumpIn), 2);
    assert_eq!(happened(&found, EventKind::Detachment) + happened(&found, EventKind::ZoneReached), 2);
}

/// Δ + F/k_f is what was imposed, whatever the stiffness; a stiff frame is penetration control.
#[test]
fn frames_between_both_controls() {
    let mut radii = Vec::new();
    for stiffness in [1e-3, 0.1, 1e3] {
        let mut problem = asked(History::frame(0.0).at_speed(0.02, 0.01).at_speed(-30.0, 0.01));
        problem.frame_stiffness = Some(stiffness);
        let found = solved(&format!("frame {stiffness}"), &rubber(), &problem);
        let event = found.events.iter().find(|event| event.kind == EventKind::Detachment).unwrap();
        radii.push(event.contact_radius.value);
        for instant in &found.instants {
            let imposed = if instant.time <= 2.0 { 0.01 * instant.time } else { 0.02 - 0.01 * (instant.time - 2.0) };
            assert!((instant.penetration.value + instant.force.value / stiffness - imposed).abs() < 1e-8 * imposed.abs().max(0.02));
        }
    }
    let rigid = solved("rigid", &rubber(), &asked(History::penetration(0.0).at_speed(0.02, 0.01).at_speed(-0.05, 0.01)));
    let event = rigid.events.iter().find(|event| event.kind == EventKind::Detachment).unwrap();
    assert!((radii[2] / event.contact_radius.value - 1.0).abs() < 1e-2, "{radii:?} {event:?}");
}

/// The rim of a punch holds until the edge there detaches: glassily, when the unloading is fast.
#[test]
fn flat_punches() {
    let radius = 0.1;
    let punch = Profile::FlatPunch { radius };
    let problem =
        IndentationProblem { profile: punch, ..asked(History::penetration(0.0).at_speed(0.005, 0.01).hold(200.0).at_speed(-0.05, 1e5)) };
    let found = solved("punch", &rubber(), &problem);
    let held = found.instants[2];
    assert!((held.force.value / (2.0 * radius * 0.005) - 1.0).abs() < 1e-6);
    // Relaxed and pulled glassily, what opens beyond the rim has opened glassily: the pull-off of a punch of modulus E∞ at the same zone.
    let glassy = elastic_contact_of_radius(&Profile::FlatPunch { radius }, 10.0, WORK, ZONE, radius).unwrap();
    let force = glassy.force;
    let event = found.events.iter().find(|event| event.kind == EventKind::Detachment).unwrap();
    println!("punch: {} against {force}", event.force.value);
    assert!((event.force.value / force - 1.0).abs() < 1e-5);
}

#[test]
fn other_indenters() {
    for profile in [Profile::Cone { slope: 0.1 }, Profile::PowerLaw { coefficient: 3.0, exponent: 2.7 }] {
        let name = format!("{profile:?}");
        let problem = IndentationProblem { profile, ..asked(History::penetration(0.0).at_speed(0.02, 0.01).at_speed(-0.05, 0.01)) };
        assert_eq!(happened(&solved(&name, &rubber(), &problem), EventKind::Detachment), 1);
    }
}

#[test]
fn without_adhesion() {
    let mut problem = asked(History::penetration(0.0).at_speed(0.02, 0.01).at_speed(-0.05, 0.01));
    problem.adhesion = None;
    let found = solved("no adhesion", &rubber(), &problem);
    assert!(found.pull_off_force().is_none_or(|force| force.value < 1e-8) && happened(&found, EventKind::Detachment) == 1);
    problem.history = History::force(0.0).ramp(0.01, 3.0).hold(10.0).ramp(0.0, 3.0).hold(5.0).ramp(0.01, 3.0);
    let found = solved("no adhesion, by force", &rubber(), &problem);
    assert_eq!(happened(&found, EventKind::Detachment), 1);
    assert!((found.instants.last().unwrap().force.value - 0.01).abs() < 1e-9);
}

#[test]
fn controls_that_change_on_the_way() {
    let history =
        History::penetration(0.0).at_speed(0.02, 0.01).then(Controlled::Force, -0.004, 5.0).then(Controlled::Force, -0.004, 100.0);
    let found = solved("mixed", &rubber(), &asked(history));
    let last = found.instants.last().unwrap();
    assert!((last.force.value + 0.004).abs() < 1e-9 || last.contact_radius.value.abs() < 1e-12);
}

/// An elastic solid forgets its way, so that no zone is too short for it: pull-off as Johnson, Kendall and Roberts have it, under the penetration and under the force.
#[test]
fn elastic_solids_with_zones_of_a_millionth_of_the_radius() {
    let elastic = PlaneMaterial::from_relaxation(1.0, &[]).unwrap();
    let pull_off = 1.5 * PI * WORK;
    for zone in [1e-3, 1e-5, 1e-6] {
        let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: zone });
        for history in [History::penetration(0.01).ramp(-0.01, 1.0), History::force(0.0).ramp(-2.0 * pull_off, 1.0)] {
            let found = run(&elastic, &IndentationProblem::new(SPHERE, adhesion, history).relaxed()).unwrap();
            assert!(found.reached && found.residual < 1e-8, "{zone}: {:e}", found.residual);
            let tension = found.pull_off_force().unwrap();
            assert!(
                (tension.value / pull_off - 1.0).abs() < 0.2 * zone.sqrt() + tension.error / pull_off,
                "{zone}: {tension:?} of {pull_off}"
            );
        }
    }
}

#[test]
fn refusals_have_reasons() {
    let refused = |material: &PlaneMaterial, problem: &IndentationProblem| run(material, problem).unwrap_err();
    let below = asked(History::contact_radius(0.2).ramp(0.005, 3.0)).relaxed();
    assert!(matches!(refused(&rubber(), &below), Refusal::OutOfRange { quantity: "contact_radius", .. }));
    let beyond = asked(History::force(-1.0).hold(1.0)).relaxed();
    assert!(matches!(refused(&rubber(), &beyond), Refusal::NoSuchState { .. }));
    let frame = asked(History::frame(0.0).ramp(0.1, 1.0));
    assert!(matches!(refused(&rubber(), &frame), Refusal::Undefined { .. }));
    let viscous = PlaneMaterial::from_relaxation(0.0, &[RelaxationTerm { modulus: 1.0, relaxation_time: 1.0 }]);
    if let Ok(viscous) = viscous {
        assert!(matches!(refused(&viscous, &asked(History::penetration(0.02).hold(1.0))), Refusal::Undefined { .. }));
    }
    for work in [0.0, -1.0, f64::NAN] {
        let mut problem = asked(History::penetration(0.02).hold(1.0));
        problem.adhesion = Some(Adhesion { work_of_adhesion: work, process_zone: ZONE });
        assert!(matches!(refused(&rubber(), &problem), Refusal::OutOfRange { .. }));
    }
}

/// A punch whose rim detaches at the peak of every pull, and takes the edge back: the edge arrives at the rim, rests, and leaves it near the top of a
/// sinus, where the time to the instant of leaving is noise.
#[test]
fn a_rim_detaches_in_every_cycle() {
    let material = PlaneMaterial::standard_solid(1.0e6, 1.0e7, 1e-2).unwrap();
    let (radius, work, zone) = (2e-4, 0.2, 2e-6);
    let mut receded = 0;
    for pull in [5.6e-3, 5.8e-3, 6.0e-3, 6.2e-3] {
        let history = History::force(-pull).oscillate(Oscillation::steady(1.5e-3, 30.0), 1.0);
        let adhesion = Some(Adhesion { work_of_adhesion: work, process_zone: zone });
        let problem = IndentationProblem::new(Profile::FlatPunch { radius }, adhesion, history).relaxed();
        let trace = integrate(&material, &problem, 1e-3).unwrap();
        let least =
            trace.path.iter().filter(|point| point.contact_radius > 0.0).fold(radius, |least, point| least.min(point.contact_radius));
        println!(
            "pull {pull:e}: {} steps, {} events, smallest radius {:.6} of the rim",
            trace.work.steps,
            trace.events.len(),
            least / radius
        );
        // A step may stand still at a corner; many may not.
        let still = trace.path.windows(2).filter(|pair| pair[1].time <= pair[0].time).count();
        assert!(still <= 4 * trace.events.len() + 4, "{still} steps of no time");
        assert!(trace.work.steps < 30 * 200, "{} steps", trace.work.steps);
        // Nothing jumps from the rim to the rim.
        assert!(trace.events.iter().all(|event| event.kind != EventKind::JumpOut || event.contact_radius < radius));
        receded += usize::from(least < radius);
    }
    assert!(receded > 0, "no rim gave way");
}

/// A contact lost late in a segment, in a solid whose shortest time is below what the clock can tell there: the open surface goes on from a step that the clock sees.
/// The pull-off is JKR's of the relaxed solid, within what the process zone and the last of the spectrum leave.
#[test]
fn a_late_pull_off_with_times_below_the_clock() {
    let terms: Vec<RelaxationTerm> =
        (0..20).map(|k| RelaxationTerm { modulus: 2.0, relaxation_time: 10f64.powf(-14.0 + 12.0 * f64::from(k) / 19.0) }).collect();
    let material = PlaneMaterial::from_relaxation(1.0, &terms).unwrap();
    let mut problem = asked(History::penetration(0.02).at_speed(-0.06, 0.01)).relaxed();
    problem.accuracy = 1e-2;
    let found = run(&material, &problem).unwrap();
    println!("{} steps, {:?}", found.work.steps, found.events.iter().map(|event| (event.kind, event.time.value)).collect::<Vec<_>>());
    assert_eq!(happened(&found, EventKind::Detachment) + happened(&found, EventKind::ZoneReached), 1);
    let pull_off = found.pull_off_force().unwrap().value;
    let jkr = 1.5 * PI * WORK;
    assert!(pull_off > 0.9 * jkr && pull_off < 40.0 * jkr, "{:e}", pull_off / jkr);
    // The whole segment was done.
    assert!((found.instants.last().unwrap().penetration.value + 0.06).abs() < 1e-12);
}
