//! The periodic state of an adhesive contact under an oscillating penetration (`by_panels::solve_periodic`).
//!
//! Source: Eq 4.9 and Secs 4.2–4.4 of the thesis; chains closed over a cycle, Anderson's acceleration of the edge's path.
//!
//! Goal: the state is the one that cycles without end lead to, its numbers lie within their bounds, and it costs a few cycles whatever the spectrum.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::{PI, TAU};
use viscotack::Material;
use viscotack::indentation::by_panels::{PeriodicState, solve_periodic};
use viscotack::indentation::{Adhesion, History, IndentationProblem, Oscillation, Profile};
use viscotack::material::CreepTerm;

fn one_term() -> Material {
    Material::from_creep(10.0, &[CreepTerm { compliance: 0.9, retardation_time: 10.0 }], None).unwrap()
}

fn problem(mean: f64, amplitude: f64, omega: f64, (work, zone): (f64, f64)) -> IndentationProblem {
    let adhesion = Adhesion { work_of_adhesion: work, process_zone: zone };
    let history = History::penetration(mean).oscillate(Oscillation::steady(amplitude, omega / TAU), TAU / omega);
    IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, Some(adhesion), history).relaxed()
}

fn shown(what: &str, state: &PeriodicState) {
    let cycle = &state.cycle;
    println!(
        "{what}: {} cycles, {} closures, {} nodes; work {:e} ± {:.1e}, k' {:e} ± {:.1e}, k'' {:e} ± {:.1e}, a {:e} … {:e} ± {:.1e}, F {:e} … {:e} ± {:.1e}; changes a by {:.1e}, drift {:.1e}, reached {}",
        cycle.number,
        state.work.closure_evaluations,
        state.work.history_updates,
        cycle.work.value,
        cycle.work.error,
        cycle.storage_stiffness.value,
        cycle.storage_stiffness.error,
        cycle.loss_stiffness.value,
        cycle.loss_stiffness.error,
        cycle.contact_radius[0].value,
        cycle.contact_radius[1].value,
        cycle.contact_radius[1].error,
        cycle.force[0].value,
        cycle.force[1].value,
        cycle.force[1].error,
        state.change_of_radius,
        cycle.drift,
        state.reached
    );
}

/// Oracle: the same recipe in another program (work ± 3e-11, radii ± 4e-7), and 80 cycles by the time integration at 1e-3 (work 6.90569e-6 π).
#[test]
fn the_periodic_state_meets_another_program() {
    let state = solve_periodic(&one_term(), &problem(0.02, 2e-3, 1.0, (1e-4 * PI, 8e-3)), 40).unwrap();
    shown("one term, ω = 1", &state);
    let near =
        |what: &str, got: f64, value: f64, err: f64| assert!((got - value).abs() <= err, "{what}: {got:e} is not {value:e} ± {err:e}");
    near("work", state.cycle.work.value, 2.169_489e-5, 3e-11 + state.cycle.work.error);
    near("narrowest", state.cycle.contact_radius[0].value, 0.195_201_5, 3e-7 + state.cycle.contact_radius[0].error);
    near("widest", state.cycle.contact_radius[1].value, 0.200_366_1, 4e-7 + state.cycle.contact_radius[1].error);
    assert!(state.reached);
}

/// n terms of equal compliance, over decades.
fn broad(count: i32, decades: f64) -> Material {
    let term = |k: i32| CreepTerm {
        compliance: 7.0 / f64::from(count),
        retardation_time: 10f64.powf(decades * (f64::from(k) / f64::from((count - 1).max(1)) - 0.5)),
    };
    Material::from_creep(3.0, &(0..count).map(term).collect::<Vec<_>>(), None).unwrap()
}

#[test]
fn scratch() {
    for (mean, amplitude) in [(0.02, 2e-3), (0.02, 1e-5), (0.02, 5e-3)] {
        for omega in [1.0, 20.0, 1e3, 1e8, 1e-2, 1e-4, 1e-7] {
            let at = std::time::Instant::now();
            match solve_periodic(&broad(12, 12.0), &problem(mean, amplitude, omega, (3e-4, 4e-3)), 40) {
                Ok(state) => shown(&format!("12 terms A = {amplitude} ω = {omega}"), &state),
                Err(refusal) => println!("12 terms A = {amplitude} ω = {omega}: {refusal}"),
            }
            println!("{:?}", at.elapsed());
        }
    }
}
