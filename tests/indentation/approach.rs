//! Source: thesis Secs 4.4 (approach and retraction), 4.5, 4.9.
//!
//! Goal: approach, return and re-advance under a prescribed penetration.
//!
//! ```text
//!   Δ  /\          first touch: glassy jump-in at Δ = 0;   fast: the glassy elastic contact;   slow: the soft one
//!     /  \  /      re-advance past the edge of the relaxed start: an atom of Q stays inside the contact
//! ```
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, β = 10 (chapter 4), E0* = R = ρ = 1; a three-term solid.
//!
//! Oracle: elastic contacts at equal process zone; the energy identity; the step halved.
//!
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use support::indentation::{SPHERE, WORK, ZONE, integrated, rubber, three_terms};
use viscotack::indentation::{EventKind, History, Start, Trace, elastic_contact};

/// The changes of a quantity over two halvings of the step, and its last value.
fn changes(ends: &[[f64; 3]], quantity: usize) -> [f64; 3] {
    let at = |fineness: usize| ends[fineness][quantity];
    [(at(1) - at(0)).abs(), (at(2) - at(1)).abs(), at(2).abs()]
}

fn kept(trace: &Trace, index: usize) -> viscotack::indentation::PathPoint {
    trace.path[trace.kept[index]]
}

#[test]
fn first_touch_and_the_two_elastic_limits_of_approach() {
    for (speed, modulus) in [(1e5, 10.0), (1e-9, 1.0)] {
        let trace = integrated(&rubber(), History::penetration(0.0).at_speed(0.01, speed), Start::Untouched, 1e-3);
        let first = elastic_contact(&SPHERE, 10.0, WORK, ZONE, 0.0).unwrap();
        assert!((kept(&trace, 0).contact_radius / first.contact_radius - 1.0).abs() < 1e-10);
        for index in 1..=4 {
            let point = kept(&trace, index);
            let elastic = elastic_contact(&SPHERE, modulus, WORK, ZONE, point.penetration).unwrap();
            let defect = point.contact_radius / elastic.contact_radius - 1.0;
            println!("V {speed:e}: defect of a {defect:e}");
            assert!(defect.abs() < 1e-4);
        }
    }
}

#[test]
fn cycles_converge_and_dissipate() {
    for (material, speeds) in [(rubber(), [2e-3]), (three_terms(), [2e-2])] {
        for speed in speeds {
            let history = History::penetration(0.0).at_speed(0.02, speed).at_speed(0.005, speed);
            let ends: Vec<[f64; 3]> = [1e-3, 1e-4, 1e-5]
                .iter()
                .map(|&tolerance| {
                    let trace = integrated(&material, history.clone(), Start::Untouched, tolerance);
                    assert!(trace.balance_defect().unwrap() < 1e-4);
                    let turn = kept(&trace, 4);
                    [turn.contact_radius, turn.force, trace.largest_tension().unwrap()]
                })
                .collect();
            for quantity in 0..3 {
                let [first, second, value] = changes(&ends, quantity);
                println!("V {speed:e} {quantity}: {} {first:e} {second:e}", value);
                assert!(second < 0.8 * first + 1e-4 * value);
                assert!(second < 3e-3 * value);
            }
        }
    }
}

/// Relaxed, a little back, held, then far forward past the edge of the relaxed start.
#[test]
fn re_advance_past_the_relaxed_edge() {
    let history = History::penetration(0.032).at_speed(0.0, 2e-3).hold(1.0).at_speed(0.05, 2e-3).hold(300.0);
    let ends: Vec<[f64; 3]> = [1e-3, 1e-4, 1e-5]
        .iter()
        .map(|&tolerance| {
            let trace = integrated(&rubber(), history.clone(), Start::Relaxed, tolerance);
            assert!(trace.balance_defect().unwrap() < 1e-4);
            let radii: Vec<f64> = (0..trace.kept.len()).map(|k| kept(&trace, k).contact_radius).collect();
            println!("  radii {radii:?}");
            let end = trace.path.last().unwrap();
            [kept(&trace, 12).contact_radius, kept(&trace, 12).force, end.contact_radius]
        })
        .collect();
    println!("{ends:?}");
    for quantity in 0..3 {
        let [first, second, value] = changes(&ends, quantity);
        assert!(second < 0.8 * first + 1e-5 && second < 2e-3 * value);
    }
    // Thirty retardation times later the contact has forgotten it all.
    let elastic = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.05).unwrap();
    assert!((ends[2][2] / elastic.contact_radius - 1.0).abs() < 2e-3);
}

/// A step of the penetration is answered glassily, and a hold after it relaxes; opened and pushed again, the contact jumps in again.
#[test]
fn steps_holds_and_touching_again() {
    let history = History::penetration(0.01).step(0.03).hold(500.0).step(-0.02).hold(1.0).at_speed(0.03, 0.05).hold(500.0);
    let trace = integrated(&rubber(), history, Start::Relaxed, 1e-3);
    let soft = elastic_contact(&SPHERE, 1.0, WORK, ZONE, 0.03).unwrap();
    let held = trace.path.iter().rfind(|point| point.time <= 500.0 && (point.penetration - 0.03).abs() < 1e-12).unwrap();
    println!("held {} soft {}", held.contact_radius, soft.contact_radius);
    assert!((held.contact_radius / soft.contact_radius - 1.0).abs() < 1e-3);
    assert!(trace.events.iter().any(|event| event.kind == EventKind::Detachment));
    assert!(trace.events.iter().any(|event| event.kind == EventKind::JumpIn));
    assert!((trace.path.last().unwrap().contact_radius / soft.contact_radius - 1.0).abs() < 1e-3);
}
