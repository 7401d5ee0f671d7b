//! Source: thesis Secs 4.2 to 4.5; this crate's force and radius control.
//!
//! Goal: the same history seen by two controls is one history; an unloaded contact grows from the glassy to the soft one.
//!
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, β = 10 (chapter 4), E0* = R = ρ = 1; a three-term solid.
//!
//! Oracle: elastic contacts at equal process zone; the energy identity; the step halved; an integration under another control.
//!
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use support::indentation::{SPHERE, WORK, ZONE, integrated, rubber, three_terms};
use viscotack::indentation::{Adhesion, EventKind, History, IndentationProblem, Start, elastic_contact, integrate};

/// No load after first touch: the contact creeps from the glassy to the soft unloaded one.
#[test]
fn unloaded_contact_grows_from_glassy_to_soft() {
    let trace = integrated(&rubber(), History::force(0.0).hold(2000.0), Start::Untouched, 1e-5);
    let end = trace.path.last().unwrap();
    let soft = elastic_contact(&SPHERE, 1.0, WORK, ZONE, end.penetration).unwrap();
    println!(
        "a {} to {}, soft {}, F {:e} of {:e}",
        trace.path[0].contact_radius, end.contact_radius, soft.contact_radius, end.force, soft.force
    );
    assert!((end.contact_radius / soft.contact_radius - 1.0).abs() < 1e-6 && soft.force.abs() < 1e-5 * WORK);
    assert!(trace.balance_defect().unwrap() < 1e-6);
}

/// A force ramp until the contact opens; its penetration imposed on a second integration gives the same contact.
#[test]
fn force_and_penetration_tell_one_story() {
    for material in [rubber(), three_terms()] {
        let start = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.02).unwrap();
        let history = History::force(start.force).ramp(-45.0 * WORK, 20.0);
        let force = integrated(&material, history, Start::Relaxed, 1e-6);
        assert!(force.events.iter().any(|event| event.kind == EventKind::Detachment));
        assert!(force.balance_defect().unwrap() < 1e-6);
        let mut depths = History::penetration(force.path[0].penetration);
        let mut time = 0.0;
        let before: Vec<_> = force.path.iter().take_while(|point| point.time < 0.9 * force.events[0].time).collect();
        for point in &before[1..] {
            if point.time > time {
                depths = depths.ramp(point.penetration, point.time - time);
                time = point.time;
            }
        }
        let penetration = integrated(&material, depths, Start::Relaxed, 1e-6);
        let (last, same) = (before.last().unwrap(), penetration.path.last().unwrap());
        println!("a {} {} F {} {}", last.contact_radius, same.contact_radius, last.force, same.force);
        assert!((last.contact_radius / same.contact_radius - 1.0).abs() < 1e-3);
        assert!((last.force - same.force).abs() < 2e-3 * last.force.abs());
    }
}

/// A prescribed edge gives a penetration; that penetration gives the edge.
#[test]
fn radius_and_penetration_tell_one_story() {
    let start = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.02).unwrap();
    let a = start.contact_radius;
    let radius = integrated(&rubber(), History::contact_radius(a).ramp(0.8 * a, 10.0).ramp(0.9 * a, 5.0), Start::Relaxed, 1e-6);
    assert!(radius.balance_defect().unwrap() < 1e-6);
    let mut depths = History::penetration(radius.path[0].penetration);
    let mut time = 0.0;
    for point in &radius.path[1..] {
        depths = depths.ramp(point.penetration, point.time - time);
        time = point.time;
    }
    let penetration = integrated(&rubber(), depths, Start::Relaxed, 1e-6);
    let (last, same) = (radius.path.last().unwrap(), penetration.path.last().unwrap());
    println!("a {} {} F {} {}", last.contact_radius, same.contact_radius, last.force, same.force);
    assert!((last.contact_radius / same.contact_radius - 1.0).abs() < 1e-3);
}

/// When a contact held by a spring opens, the spring gives what it stored, F²/(2k_f), once; what the solid then no longer stores is lost.
#[test]
fn a_frame_gives_its_energy_when_the_contact_opens() {
    for stiffness in [0.03, 0.3] {
        let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
        let mut problem = IndentationProblem::new(SPHERE, adhesion, History::frame(0.02).at_speed(-1.0, 0.02)).relaxed();
        (problem.frame_stiffness, problem.energies) = (Some(stiffness), true);
        let trace = integrate(&rubber(), &problem, 1e-5).unwrap();
        let index = trace.path.iter().position(|point| point.contact_radius.abs() < f64::MIN_POSITIVE).unwrap();
        let (before, after) = (trace.path[index - 1], trace.path[index]);
        let (first, second) = (before.energies.unwrap(), after.energies.unwrap());
        let given = second.external_work - first.external_work;
        let exact = before.force * before.force / (2.0 * stiffness);
        println!("k_f = {stiffness}: the frame gives {given:e}, F²/2k {exact:e}");
        assert!((given / exact - 1.0).abs() < 1e-9);
        let lost = second.dissipated - first.dissipated;
        assert!(lost > 0.0 && (lost - (given + first.stored - second.stored)).abs() < 1e-12 * lost);
    }
}
