//! The periodic state of an adhesive contact under an oscillating penetration (`by_panels::solve_periodic`).
//!
//! Source: Eq 4.9 and Secs 4.2–4.4 of the thesis; chains closed over a cycle, Anderson's acceleration of the edge's path.
//!
//! Goal: the state is the one that cycles without end lead to, its numbers lie within their bounds, and it costs a few cycles whatever the spectrum.
//!
//! Oracles: another program (its own errors named); sixty cycles by the time integration in steps (`integrate`, measured once at a tolerance of 1e-4: 40 s); the
//! fundamental of the elastic contact at rest (`elastic_contact`), which slow cycles follow; the power balance of the contact; the same in other units; the same
//! at a tighter accuracy, which the bounds of the looser one must cover.
//!
//! Tolerances: the bounds of the state itself, and what its oracle leaves unknown.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::{PI, TAU};
use viscotack::PlaneMaterial;
use viscotack::Refusal;
use viscotack::indentation::by_panels::{PeriodicState, solve_periodic};
use viscotack::indentation::{Adhesion, History, IndentationProblem, Oscillation, Profile, elastic_contact};
use viscotack::material::CreepTerm;

fn one_term() -> PlaneMaterial {
    PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.9, retardation_time: 10.0 }], None).unwrap()
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

fn near(what: &str, got: f64, value: f64, err: f64) {
    assert!((got - value).abs() <= err, "{what}: {got:e} is not {value:e} ± {err:e}");
}

fn first() -> IndentationProblem {
    problem(0.02, 2e-3, 1.0, (1e-4 * PI, 8e-3))
}

/// Another program: work ± 3e-11, widest ± 4e-7. Sixty cycles in steps, which still drift by 1e-8: all of them to 5e-7.
#[test]
fn the_periodic_state_meets_another_program_and_many_cycles() {
    let state = solve_periodic(&one_term(), &first(), 40).unwrap();
    shown("one term, ω = 1", &state);
    let cycle = &state.cycle;
    near("work", cycle.work.value, 2.169_489e-5, 3e-11 + cycle.work.error);
    near("widest", cycle.contact_radius[1].value, 0.200_366_1, 4e-7 + cycle.contact_radius[1].error);
    for (what, got, value) in [
        ("work", cycle.work, 2.169_487_550e-5),
        ("narrowest", cycle.contact_radius[0], 0.195_199_381),
        ("widest", cycle.contact_radius[1], 0.200_366_100),
        ("least force", cycle.force[0], -2.707_026_544e-3),
        ("largest force", cycle.force[1], 8.109_431_944e-3),
        ("storage stiffness", cycle.storage_stiffness, 2.081_419_227),
        ("loss stiffness", cycle.loss_stiffness, 1.726_423_542),
    ] {
        near(what, got.value, value, 5e-7 * value.abs() + got.error);
    }
    assert!(state.reached);
    assert!(cycle.number <= 40, "{} cycles", cycle.number);
    // Work is the loss stiffness by another integral.
    near("πA²k''", PI * 4e-6 * cycle.loss_stiffness.value, cycle.work.value, 1e-9 * cycle.work.value);
}

/// What the external force does in a cycle and what the edge sets free, the memory loses; nothing is stored.
#[test]
fn the_power_of_a_cycle_balances() {
    let asked = IndentationProblem { energies: true, accuracy: 1e-5, ..first() };
    let state = solve_periodic(&one_term(), &asked, 4).unwrap();
    let turned = state.turned_over.unwrap();
    println!("external {:e}, tip {:e}, dissipated {:e}", turned.external, turned.tip, turned.dissipated);
    near("∮F dΔ", turned.external, state.cycle.work.value, state.cycle.work.error + 1e-8 * turned.external);
    near("balance", turned.external + turned.tip, turned.dissipated, 2e-6 * turned.external);
    assert!(turned.tip.abs() > 1e-3 * turned.external, "the edge takes a part of its own");
}

/// Slow cycles follow the elastic contact of the relaxed solid with its process zone: the fundamental of F(Δ); what is left goes with the frequency.
#[test]
fn slow_cycles_follow_the_elastic_contact() {
    let (material, (work, zone)) = (one_term(), (1e-4 * PI, 8e-3));
    let (mean, amplitude) = (0.02, 2e-3);
    let mut storage = 0.0;
    for k in 0..64 {
        let phase = TAU * f64::from(k) / 64.0;
        let state = elastic_contact(&Profile::Paraboloid { radius: 1.0 }, 1.0, work, zone, mean + amplitude * phase.sin()).unwrap();
        storage += 2.0 / (amplitude * 64.0) * state.force * phase.sin();
    }
    let losses = [1e-4, 1e-5].map(|omega| {
        let state = solve_periodic(&material, &problem(mean, amplitude, omega, (work, zone)), 4).unwrap();
        shown(&format!("ω = {omega}, elastic {storage:e}"), &state);
        near(
            "storage stiffness",
            state.cycle.storage_stiffness.value,
            storage,
            state.cycle.storage_stiffness.error + 300.0 * omega * storage,
        );
        state.cycle.loss_stiffness
    });
    assert!(losses[0].value > losses[1].value && losses[1].value > 0.0);
}

/// A change of units changes nothing but units: lengths by 1e-3, moduli by 1e6, times by 1e-2.
#[test]
fn units_do_not_matter() {
    let plain = solve_periodic(&one_term(), &first(), 8).unwrap();
    let material = PlaneMaterial::from_creep(1e7, &[CreepTerm { compliance: 0.9e-6, retardation_time: 0.1 }], None).unwrap();
    let adhesion = Adhesion { work_of_adhesion: 1e-4 * PI * 1e3, process_zone: 8e-6 };
    let history = History::penetration(2e-5).oscillate(Oscillation::steady(2e-6, 100.0 / TAU), TAU / 100.0);
    let asked = IndentationProblem::new(Profile::Paraboloid { radius: 1e-3 }, Some(adhesion), history).relaxed();
    let other = solve_periodic(&material, &asked, 8).unwrap();
    for (what, one, two, unit) in [
        ("work", plain.cycle.work, other.cycle.work, 1e-3),
        ("storage stiffness", plain.cycle.storage_stiffness, other.cycle.storage_stiffness, 1e3),
        ("mean radius", plain.mean_contact_radius, other.mean_contact_radius, 1e-3),
        ("mean force", plain.mean_force, other.mean_force, 1.0),
    ] {
        near(what, two.value, unit * one.value, two.error + unit * one.error);
    }
}

/// n terms of equal compliance, over decades.
fn broad(count: i32, decades: f64) -> PlaneMaterial {
    let time = |k: i32| 10f64.powf(decades * (f64::from(k) / f64::from((count - 1).max(1)) - 0.5));
    let term = |k: i32| CreepTerm { compliance: 7.0 / f64::from(count), retardation_time: time(k) };
    PlaneMaterial::from_creep(3.0, &(0..count).map(term).collect::<Vec<_>>(), None).unwrap()
}

/// Twelve terms over twelve decades, cycles faster and slower: a few cycles each; looser bounds cover tighter values.
#[test]
fn twelve_terms_over_twelve_decades() {
    let material = broad(12, 12.0);
    for omega in [1e-4, 1.0, 1e4] {
        let asked = problem(0.02, 2e-3, omega, (3e-4, 4e-3));
        let loose = solve_periodic(&material, &IndentationProblem { accuracy: 1e-2, ..asked.clone() }, 4).unwrap();
        let tight = solve_periodic(&material, &IndentationProblem { accuracy: 1e-4, ..asked }, 4).unwrap();
        shown(&format!("twelve terms, ω = {omega}, loose"), &loose);
        shown(&format!("twelve terms, ω = {omega}"), &tight);
        assert!(loose.reached && tight.reached && tight.cycle.number <= 80, "{} cycles", tight.cycle.number);
        for (what, one, two) in [
            ("work", loose.cycle.work, tight.cycle.work),
            ("storage stiffness", loose.cycle.storage_stiffness, tight.cycle.storage_stiffness),
            ("narrowest", loose.cycle.contact_radius[0], tight.cycle.contact_radius[0]),
            ("widest", loose.cycle.contact_radius[1], tight.cycle.contact_radius[1]),
            ("least force", loose.cycle.force[0], tight.cycle.force[0]),
        ] {
            near(what, one.value, two.value, one.error + two.error);
        }
    }
}

/// A contact that lets go within the cycle is refused with where it does; a history that is no oscillation about its start as well.
#[test]
fn what_has_no_periodic_state_is_refused() {
    let lost = solve_periodic(&one_term(), &problem(0.0, 0.05, 1e-3, (1e-4 * PI, 8e-3)), 4);
    assert!(matches!(&lost, Err(Refusal::NoSuchState { reason, .. }) if reason.contains("lets go within a cycle")), "{lost:?}");
    let ramp = IndentationProblem { history: History::penetration(0.02).ramp(0.03, 1.0), ..first() };
    assert!(matches!(solve_periodic(&one_term(), &ramp, 4), Err(Refusal::Undefined { .. })));
}
