//! Source: Eq 4.9 and Secs 4.2–4.4, 4.10 of the thesis, solved by panels of the edge's path; JKR (1971) for elastic contacts.
//!
//! Goal: what a history may hold besides ramps: sudden steps, surfaces that touch again, and cycles.
//!
//! ```text
//!   Δ │  step ┌──      a step is the limit of an ever faster ramp:  F dΔ + G_tip dA = dU, nothing is dissipated
//!     │ ──────┘        a surface that is touched again bonds at once from the axis: D(0) = 0, or F = 0⁺
//! ```
//! Parameters: spheres of β = 10 (one term) and of two terms; zones of 1e-2 to 1e-4 of R.
//!
//! Oracles: time steps (`run`), within the bounds of both; elastic contacts of the same process zone (their own oracle: `indentation_reference_values`) to 1e-9 where
//! a solid is elastic, or has relaxed; ramps of 1e-8 relaxation times to their own creep, 1e-6; the balance of energies over a step to 1e-7 of what is turned over.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout, missing_docs)]

use std::f64::consts::TAU;
use viscotack::Estimate;
use viscotack::PlaneMaterial;
use viscotack::indentation::by_panels::{End, PanelOptions, integrate_by_panels, solve_by_panels};
use viscotack::indentation::{
    Adhesion, Controlled, Cycle, EventKind, History, IndentationProblem, IndentationSolution, Oscillation, Profile, Segment,
    elastic_contact, elastic_contact_of_radius, run,
};
use viscotack::material::RelaxationTerm;

const WORK: f64 = 5e-4;
const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };
const FINE: PanelOptions = PanelOptions { degree: 7, tolerance: 1e-8 };
const USUAL: PanelOptions = PanelOptions { degree: 5, tolerance: 1e-6 };

fn sphere(zone: f64, history: History) -> IndentationProblem {
    IndentationProblem::new(SPHERE, Some(Adhesion { work_of_adhesion: WORK, process_zone: zone }), history)
}

fn rubber() -> PlaneMaterial {
    PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap()
}

fn two_terms() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(2.0, &[term(3.0, 0.5), term(10.0, 0.02)]).unwrap()
}

/// Every number of panels and time steps within the bounds of both, and the same events.
fn agree(name: &str, material: &PlaneMaterial, problem: &IndentationProblem) -> [IndentationSolution; 2] {
    let (panels, steps) = (solve_by_panels(material, problem).unwrap(), run(material, problem).unwrap());
    assert!(panels.by_panels && panels.reached && !steps.by_panels, "{name}");
    assert_eq!(panels.instants.len(), steps.instants.len(), "{name}");
    let scales = steps.integration.summary.scales;
    for (ours, theirs) in panels.instants.iter().zip(&steps.instants) {
        let pairs = [(ours.penetration, theirs.penetration), (ours.force, theirs.force), (ours.contact_radius, theirs.contact_radius)];
        for (quantity, (one, other)) in pairs.into_iter().enumerate() {
            let allowed = one.error + other.error + 1e-9 * scales[quantity];
            assert!((one.value - other.value).abs() <= allowed, "{name}, {quantity}: {ours:?} {theirs:?}");
        }
        let energies = ours.energies.iter().flatten().zip(theirs.energies.iter().flatten());
        for (which, (one, other)) in energies.enumerate().filter(|(which, _)| *which != 1) {
            let most = panels.instants.iter().flat_map(|at| at.energies).map(|all| all[2].value.abs()).fold(0.0, f64::max);
            assert!((one.value - other.value).abs() <= one.error + other.error + 1e-3 * most, "{name}, energy {which}: {one:?} {other:?}");
        }
    }
    let kinds = |found: &IndentationSolution| found.events.iter().map(|event| event.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&panels), kinds(&steps), "{name}");
    for (ours, theirs) in panels.events.iter().zip(&steps.events) {
        let pairs = [(ours.time, theirs.time), (ours.penetration, theirs.penetration), (ours.force, theirs.force)];
        for (one, other) in pairs {
            assert!((one.value - other.value).abs() <= one.error + other.error + 1e-9, "{name}: {ours:?} {theirs:?}");
        }
    }
    [panels, steps]
}

#[test]
fn a_large_step_finds_the_elastic_equilibrium_of_its_depth() {
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    for zone in [2e-3, 2e-4] {
        for (first, second) in [(0.01, 0.06), (0.02, 0.5), (0.01, 1.0), (0.01, 3.0), (0.5, 0.01), (3.0, 0.01)] {
            let outcome =
                integrate_by_panels(&elastic, &sphere(zone, History::penetration(first).step(second)), USUAL, &[0.0, 0.0]).unwrap();
            assert_eq!(outcome.end, End::History);
            let (before, after) = (outcome.wanted[0], outcome.wanted[1]);
            for (row, depth) in [(before, first), (after, second)] {
                let same_zone = elastic_contact(&SPHERE, 1.0, WORK, zone, depth).unwrap();
                let off = [row.contact_radius / same_zone.contact_radius - 1.0, row.force / same_zone.force - 1.0];
                println!("zone {zone}, {first} to {second}, at {depth}: off by {off:?}");
                assert!(off.iter().all(|off| off.abs() < 1e-9), "{row:?} {same_zone:?}");
            }
        }
    }
}

/// Two steps in a row have a row each, and the frozen contact does not depend on the way: there and back it is the one before.
#[test]
fn steps_there_and_back_leave_the_contact_as_it_was() {
    let history = History::penetration(0.03).step(0.05).step(0.03).hold(1.0);
    let problem = IndentationProblem { energies: true, ..sphere(1e-2, history) }.relaxed();
    let outcome = integrate_by_panels(&rubber(), &problem, FINE, &[0.0, 0.0, 0.0]).unwrap();
    let [before, there, back] = [0, 1, 2].map(|k| outcome.wanted[k]);
    println!("{before:?}\n{there:?}\n{back:?}");
    assert!(there.contact_radius > 1.03 * before.contact_radius && there.penetration.to_bits() == 0.05_f64.to_bits());
    assert!((back.contact_radius / before.contact_radius - 1.0).abs() < 1e-10 && (back.force / before.force - 1.0).abs() < 1e-9);
}

/// F dΔ + G_tip dA = dU: a body answers with E∞ at once, and a glassy solid dissipates nothing.
#[test]
fn nothing_is_dissipated_by_a_step() {
    for (material, step) in [(rubber(), 0.035), (rubber(), 0.024), (two_terms(), 0.04), (PlaneMaterial::elastic(1.0).unwrap(), 0.0)] {
        let asked = sphere(1e-2, History::penetration(0.03).step(step)).relaxed();
        let problem = IndentationProblem { energies: true, ..asked };
        let solved = solve_by_panels(&material, &problem).unwrap();
        let ([stored, _, _, _], [after, _, external, dissipated]) =
            (solved.instants[0].energies.unwrap(), solved.instants[1].energies.unwrap());
        let tip = solved.integration.path.last().unwrap().energies.unwrap().tip_work;
        println!("to {step}: U {} to {}, ∫F dΔ {}, ∫G dA {tip}, lost {}", stored.value, after.value, external.value, dissipated.value);
        let size = external.value.abs() + tip.abs();
        assert!((external.value + tip - (after.value - stored.value)).abs() < 1e-7 * size && dissipated.value.abs() < 1e-7 * size);
        // dF = 2aE∞ dΔ with the smaller and the larger of both radii.
        let [first, second] = [0, 1].map(|k| solved.instants[k]);
        let glassy = 2.0 * material.glassy_modulus() * (step - 0.03);
        let secant = (second.force.value - first.force.value) / glassy;
        let radii = [first.contact_radius.value, second.contact_radius.value];
        assert!(secant > 0.0 && secant < radii[0].max(radii[1]) * 1.5, "{secant} {radii:?}");
    }
}

/// Pulled at once beyond what the glassy contact carries: it lets go where a ramp of no time does.
#[test]
fn a_step_to_detachment_lets_go_where_the_fastest_ramp_does() {
    let (material, time) = (rubber(), 1e-8);
    for (depth, end) in [(0.03, -0.2), (0.05, -0.5)] {
        let step =
            integrate_by_panels(&material, &sphere(1e-2, History::penetration(depth).step(end).hold(1.0)).relaxed(), USUAL, &[]).unwrap();
        let ramp =
            integrate_by_panels(&material, &sphere(1e-2, History::penetration(depth).ramp(end, time)).relaxed(), USUAL, &[]).unwrap();
        let least = [step.least_force, ramp.least_force].map(|row| [row.force, row.penetration, row.contact_radius]);
        println!("{least:?}");
        assert_eq!((step.end, ramp.end), (End::Lost, End::Lost));
        assert!((least[0][0] / least[1][0] - 1.0).abs() < 1e-6, "{least:?}");
        assert!(step.ends.last().unwrap().time == 0.0);
        let [one, other] = [step.ends.last().unwrap(), ramp.ends.last().unwrap()];
        assert!((one.penetration / other.penetration - 1.0).abs() < 1e-6, "{one:?} {other:?}");
    }
}

/// Every control, against time steps (which take a step in sixteen parts).
#[test]
fn steps_of_every_control_agree_with_time_steps() {
    let depth = History::penetration(0.02).hold(0.3).step(0.026).hold(0.4).step(0.022).ramp(0.03, 1.0);
    let force = History::force(0.004).hold(0.2).step(0.012).hold(0.5).step(0.002).hold(1.0);
    let frame = History::frame(0.03).hold(0.2).step(0.045).ramp(0.05, 0.5).step(0.03).hold(1.0);
    let radius = History::contact_radius(0.15).hold(0.2).step(0.17).hold(0.3).step(0.16).hold(0.5);
    let changing = History::penetration(0.02).hold(0.3).then(Controlled::Force, 0.01, 0.0).then(Controlled::Force, 0.01, 0.5);
    for (name, history, stiffness) in [
        ("depth", depth, None),
        ("force", force, None),
        ("frame", frame, Some(0.7)),
        ("radius", radius, None),
        ("changing", changing, None),
    ] {
        for material in [rubber(), two_terms()] {
            let problem = IndentationProblem {
                frame_stiffness: stiffness,
                instants_per_segment: 3,
                energies: name == "depth",
                ..sphere(1e-2, history.clone()).relaxed()
            };
            agree(name, &material, &problem);
        }
    }
    let held = integrate_by_panels(
        &rubber(),
        &sphere(1e-2, History::contact_radius(0.15).step(0.18).hold(1e5)).relaxed(),
        USUAL,
        &[0.0, 0.0, 1e5],
    );
    let held = held.unwrap();
    let rest = elastic_contact_of_radius(&SPHERE, 1.0, WORK, 1e-2, 0.18).unwrap();
    println!("{held:?} {rest:?}");
    assert!((held.wanted[1].contact_radius / 0.18 - 1.0).abs() < 1e-9 && held.wanted[1].penetration > rest.penetration);
}

/// An elastic surface is back at once: it is touched where it was, and bonds to JKR's contact at Δ = 0.
#[test]
fn an_elastic_surface_is_touched_where_it_was() {
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    for zone in [2e-3, 2e-4] {
        let history = History::penetration(0.01).ramp(-0.1, 1.0).ramp(0.02, 1.0);
        let outcome = integrate_by_panels(&elastic, &sphere(zone, history), USUAL, &[2.0]).unwrap();
        assert_eq!(outcome.end, End::History);
        let landed = outcome.jumps.last().unwrap();
        let touched = elastic_contact(&SPHERE, 1.0, WORK, zone, 0.0).unwrap();
        println!("{landed:?} {touched:?}");
        assert!(landed.penetration.abs() < 1e-15 && (landed.time - (1.0 + 0.1 / 0.12)).abs() < 1e-12);
        assert!((landed.contact_radius / touched.contact_radius - 1.0).abs() < 1e-9);
        let pressed = elastic_contact(&SPHERE, 1.0, WORK, zone, 0.02).unwrap();
        let end = outcome.wanted.last().unwrap();
        assert!((end.contact_radius / pressed.contact_radius - 1.0).abs() < 1e-6 && (end.force / pressed.force - 1.0).abs() < 1e-6);
    }
}

#[test]
fn surfaces_that_touch_again_agree_with_time_steps() {
    let depth = History::penetration(0.0).ramp(0.01, 0.5).ramp(-0.15, 0.5).ramp(0.02, 1.0).hold(0.5);
    let twice = History::penetration(0.0).ramp(0.01, 0.5).ramp(-0.15, 0.5).ramp(0.02, 1.0).ramp(-0.2, 0.5).ramp(0.01, 0.5);
    let pressed = History::force(0.0).ramp(0.02, 1.0).ramp(-0.1, 1.0).ramp(0.01, 0.5).ramp(0.03, 1.0);
    let frame = History::frame(0.0).ramp(0.03, 1.0).ramp(-0.3, 2.0).ramp(0.02, 2.0);
    for (name, history, stiffness) in
        [("depth", depth, None), ("twice", twice, None), ("force", pressed, None), ("frame", frame, Some(0.7))]
    {
        let problem = IndentationProblem { frame_stiffness: stiffness, instants_per_segment: 4, energies: true, ..sphere(1.3e-2, history) };
        let [solved, _] = agree(name, &two_terms(), &problem);
        let kinds: Vec<_> = solved.events.iter().map(|event| event.kind).collect();
        println!("{name}: {kinds:?}");
        assert!(kinds.windows(2).any(|pair| pair == [EventKind::Detachment, EventKind::JumpIn]), "{kinds:?}");
        assert!(solved.balance_defect.unwrap() < 1e-6, "{name}: {:?}", solved.balance_defect);
    }
}

/// After many times the longest relaxation time nothing is left of what was before.
#[test]
fn a_surface_that_was_touched_again_relaxes_to_the_soft_contact() {
    let history = History::penetration(0.0).ramp(0.01, 0.5).ramp(-0.15, 0.5).ramp(0.02, 1.0).hold(1e4);
    let solved = solve_by_panels(&two_terms(), &sphere(1.3e-2, history)).unwrap();
    let end = solved.instants.last().unwrap();
    let soft = elastic_contact(&SPHERE, 2.0, WORK, 1.3e-2, 0.02).unwrap();
    println!("{end:?} {soft:?}");
    assert!((end.contact_radius.value - soft.contact_radius).abs() < end.contact_radius.error + 1e-6 * soft.contact_radius);
    assert!((end.force.value - soft.force).abs() < end.force.error + 1e-6 * soft.force);
}

fn numbers(cycle: &Cycle<Estimate>) -> [Estimate; 10] {
    let Cycle { work, storage_stiffness, loss_stiffness, phase, penetration, force, contact_radius, .. } = *cycle;
    let ([low, high], [least, most], [narrow, wide]) = (penetration, force, contact_radius);
    [work, storage_stiffness, loss_stiffness, phase, low, high, least, most, narrow, wide]
}

fn cycles_agree(name: &str, panels: &IndentationSolution, steps: &IndentationSolution) {
    assert_eq!(panels.cycles.len(), steps.cycles.len(), "{name}");
    assert_eq!(panels.integration.spreads.len(), steps.integration.spreads.len(), "{name}");
    for (ours, theirs) in panels.cycles.iter().zip(&steps.cycles) {
        assert_eq!((ours.segment, ours.number), (theirs.segment, theirs.number), "{name}");
        assert!((ours.start - theirs.start).abs() < 1e-12 * ours.end && (ours.end - theirs.end).abs() < 1e-12 * ours.end, "{name}");
        let stiffness = ours.storage_stiffness.value.hypot(ours.loss_stiffness.value);
        let swing = ours.penetration[1].value - ours.penetration[0].value;
        let size = [stiffness * swing * swing, stiffness, stiffness, 1.0, swing, swing, stiffness * swing, stiffness * swing, 0.1, 0.1];
        for (which, (one, other)) in numbers(ours).into_iter().zip(numbers(theirs)).enumerate() {
            assert!(
                (one.value - other.value).abs() <= one.error + other.error + 1e-9 * size[which],
                "{name}, {which}: {one:?} {other:?} {ours:?}"
            );
        }
    }
}

#[test]
fn rows_of_cycles_agree_with_time_steps() {
    let swings = |amplitude, frequency| Oscillation::steady(amplitude, frequency);
    let depth = History::penetration(0.02).hold(0.2).oscillate(swings(0.002, 2.0), 2.25).ramp(0.025, 1.0);
    let ramped = History::penetration(0.0).ramp(0.02, 0.5).ramp_oscillating(0.03, swings(0.004, 2.0), 2.0);
    let force = History::force(0.01).oscillate(swings(0.002, 1.0), 3.0);
    let frame = History::frame(0.04).oscillate(swings(0.004, 1.0), 3.0);
    for (name, history, stiffness) in
        [("depth", depth, None), ("ramped", ramped, None), ("force", force, None), ("frame", frame, Some(0.7))]
    {
        for material in [rubber(), two_terms()] {
            let asked = sphere(1e-2, history.clone());
            let problem = IndentationProblem { frame_stiffness: stiffness, ..if name == "ramped" { asked } else { asked.relaxed() } };
            let [panels, steps] = agree(name, &material, &problem);
            println!("{name}: {:?}", panels.cycles.last().map(|cycle| cycle.work));
            assert!(panels.cycles.len() > 1);
            cycles_agree(name, &panels, &steps);
        }
    }
}

/// An elastic contact has one force for each depth: no work, and the fundamental of F(Δ₀ + A sin φ), by the trapezoidal rule over 64 elastic contacts.
#[test]
fn the_cycle_of_an_elastic_contact_is_that_of_its_equilibria() {
    let (depth, amplitude, zone) = (0.02, 0.005, 1e-2);
    let elastic = PlaneMaterial::elastic(1.0).unwrap();
    let history = History::penetration(depth).oscillate(Oscillation::steady(amplitude, 1.0), 2.0);
    let solved = solve_by_panels(&elastic, &IndentationProblem { accuracy: 1e-6, ..sphere(zone, history).relaxed() }).unwrap();
    let force = |k: u32| {
        let phase = f64::from(k) / 64.0 * TAU;
        (elastic_contact(&SPHERE, 1.0, WORK, zone, depth + amplitude * phase.sin()).unwrap().force, phase.sin())
    };
    let stiffness = (0..64).map(force).map(|(force, sin)| force * sin).sum::<f64>() / (32.0 * amplitude);
    let [low, high] = [-amplitude, amplitude].map(|way| elastic_contact(&SPHERE, 1.0, WORK, zone, depth + way).unwrap());
    for cycle in &solved.cycles {
        println!("{cycle:?}, {stiffness}");
        assert!((cycle.storage_stiffness.value / stiffness - 1.0).abs() < 1e-7);
        assert!(cycle.work.value.abs() < 1e-7 * stiffness * amplitude * amplitude && cycle.loss_stiffness.value.abs() < 1e-7 * stiffness);
        assert!((cycle.force[0].value - low.force).abs() < 1e-7 * high.force && (cycle.force[1].value / high.force - 1.0).abs() < 1e-7);
        assert!((cycle.contact_radius[0].value / low.contact_radius - 1.0).abs() < 1e-6);
        assert!((cycle.contact_radius[1].value / high.contact_radius - 1.0).abs() < 1e-6);
        assert!((cycle.penetration[1].value - depth - amplitude).abs() < 1e-12);
    }
    assert_eq!(solved.cycles.len(), 2);
}

/// Surfaces that part and touch in every cycle.
#[test]
fn cycles_in_which_the_contact_lets_go() {
    let history = History::penetration(0.0).oscillate(Oscillation::steady(0.1, 1.0), 3.0);
    let problem = sphere(1.3e-2, history);
    let [panels, steps] = agree("tapping", &two_terms(), &problem);
    assert_eq!(panels.events.iter().filter(|event| event.kind == EventKind::Detachment).count(), 3);
    cycles_agree("tapping", &panels, &steps);
    assert!(panels.cycles.iter().all(|cycle| cycle.work.value > 0.0 && cycle.contact_radius[0].value == 0.0));
}

#[test]
fn a_segment_ends_when_its_cycles_are_stationary() {
    let swings = Oscillation { until_stationary: true, ..Oscillation::steady(0.002, 1.0) };
    let segment = |controlled, end| Segment { duration: 40.0, end, controlled, oscillation: Some(swings) };
    for (controlled, start) in [(Controlled::Penetration, 0.02), (Controlled::Force, 0.02)] {
        let mut history = History::from(controlled, start);
        history.segments.push(segment(controlled, start));
        let history = history.then(controlled, 0.9 * start, 1.0);
        let problem = IndentationProblem { accuracy: 5e-2, ..sphere(1.3e-2, history).relaxed() };
        let [panels, steps] = agree("stationary", &two_terms(), &problem);
        println!("{:?} {:?}", panels.integration.shortened, steps.integration.shortened);
        assert_eq!(panels.integration.shortened.len(), 1);
        assert!((panels.integration.shortened[0].1 - steps.integration.shortened[0].1).abs() < 1e-9);
        assert!((panels.instants.last().unwrap().time - panels.integration.shortened[0].1 - 1.0).abs() < 1e-9);
        cycles_agree("stationary", &panels, &steps);
    }
}
