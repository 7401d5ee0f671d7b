//! Source: thesis Secs 4.5, 4.9 and 4.10 (Figs 4.5, 4.10, 4.11), with the closed form of fast retraction rederived.
//!
//! Goal: retraction from a relaxed contact, slow to fast.
//!
//! ```text
//! slow      F_off → JKR's of modulus E0 at the same process zone          fast      frozen at a_B, then the glassy punch of the relaxed shape
//! fast, δ → 0:  a = a_B until K_I² = 2E∞*Δγ;  then  Δ = Δ_B − (Δ_B − a²/R)/β − √(2πaΔγ/E∞*),   F = (4/3)E0*a³/R − 2√(2πE∞*Δγ) a^{3/2}
//! always    F dΔ + G_tip dA = dU + P_d dt
//! ```
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, β = 10, Δ̃_B = 0.032 (chapter 4); E0* = R = ρ = 1 unless said otherwise.
//!
//! Oracle: closed forms; the energy identity; the step halved; the same history in another system of units.
//!
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::indentation::{
    Adhesion, EventKind, History, IndentationProblem, Profile, elastic_contact, elastic_contact_of_radius, integrate, run,
};

const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;
const BETA: f64 = 10.0;
const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

/// β = 10 with relaxation time 1, retardation time 10.
fn rubber() -> PlaneMaterial {
    PlaneMaterial::standard_solid(1.0, BETA, BETA).unwrap()
}

fn retraction(speed: f64, end: f64) -> IndentationProblem {
    let adhesion = Adhesion { work_of_adhesion: WORK, process_zone: ZONE };
    IndentationProblem {
        instants_per_segment: 4,
        energies: true,
        ..IndentationProblem::new(SPHERE, Some(adhesion), History::penetration(0.032).at_speed(end, speed)).relaxed()
    }
}

/// F_off at five speeds over five decades: the coarse step is assessed by the fine one, and the change falls at least like the step.
#[test]
fn pull_off_converges_at_every_speed() {
    let jkr = 1.5 * PI * WORK;
    let mut last = 0.0;
    for (speed, end) in [(1e-4, -0.03), (1e-3, -0.03), (1e-2, 0.012), (1e-1, 0.022), (1e1, 0.023)] {
        let forces: Vec<f64> = [1e-3, 1e-4, 1e-5]
            .iter()
            .map(|&tolerance| {
                let problem = retraction(speed, end);
                let trace = integrate(&rubber(), &problem, tolerance).unwrap();
                let balance = trace.balance_defect().unwrap();
                println!(
                    "V {speed:e}: {tolerance:e}: {} steps, {} closures, {} panels, balance {balance:e}, {:?}",
                    trace.work.steps, trace.work.closure_evaluations, trace.work.most_panels, trace.events
                );
                assert!(balance < 1e-4, "{balance}");
                assert!(trace.path.iter().all(|point| point.residual.abs() < 1e-9 && point.stress_intensity_factor >= 0.0));
                trace.largest_tension().unwrap() / jkr
            })
            .collect();
        let (first, second) = ((forces[1] - forces[0]).abs(), (forces[2] - forces[1]).abs());
        println!("V {speed:e}: F_off/F_JKR {forces:?}, changes {first:e} {second:e}");
        // The tolerance times ten bounds what the next tightening changes.
        assert!(first < 1e-3 && second < 1e-4, "{first:e} {second:e}");
        assert!(forces[2] > last && forces[2] < BETA);
        last = forces[2];
    }
}

/// Slow enough, the contact is the elastic one of modulus E0 at the same process zone, all along.
#[test]
fn slow_retraction_is_soft_and_fast_elastic_limits_agree() {
    let problem = retraction(1e-8, 0.0);
    let trace = integrate(&rubber(), &problem, 1e-3).unwrap();
    for &kept in &trace.kept {
        let point = trace.path[kept];
        let elastic = elastic_contact(&SPHERE, 1.0, WORK, ZONE, point.penetration).unwrap();
        println!("slow: {:e} {:e}", point.contact_radius / elastic.contact_radius - 1.0, point.force / elastic.force - 1.0);
        assert!((point.contact_radius / elastic.contact_radius - 1.0).abs() < 1e-4);
    }
    // An elastic material on the same integration makes no error in time at all.
    let elastic = PlaneMaterial::from_relaxation(1.0, &[]).unwrap();
    let trace = integrate(&elastic, &problem, 1e-3).unwrap();
    for point in &trace.path {
        let exact = elastic_contact_of_radius(&SPHERE, 1.0, WORK, ZONE, point.contact_radius).unwrap();
        assert!((point.penetration - exact.penetration).abs() < 1e-10 * 0.032);
        assert!((point.force - exact.force).abs() < 1e-10 * 1.5 * PI * WORK, "{:e}", point.force - exact.force);
    }
}

/// δ → 0 at 1e5 times the relaxation: penetration and force at a given contact radius, error in proportion to δ.
#[test]
fn fast_retraction_is_the_closed_form() {
    let depth = 0.06;
    let mut defects = Vec::new();
    for zone in [8e-3, 4e-3, 2e-3] {
        let problem = IndentationProblem {
            adhesion: Some(Adhesion { work_of_adhesion: WORK, process_zone: zone }),
            history: History::penetration(depth).at_speed(0.048, 1e5),
            ..retraction(1.0, 0.0)
        };
        let trace = integrate(&rubber(), &problem, 1e-3).unwrap();
        let start = trace.path[0];
        let place = trace.path.iter().find(|point| point.contact_radius < start.contact_radius - 0.02).unwrap();
        let a = place.contact_radius;
        let exact_depth = depth - (depth - a * a) / BETA - (2.0 * PI * a * WORK / BETA).sqrt();
        let exact_force = 4.0 / 3.0 * a.powi(3) - 2.0 * (2.0 * PI * BETA * WORK * a.powi(3)).sqrt();
        println!(
            "zone {zone}: a_B {} a {a} depth {:e} force {:e}",
            start.contact_radius,
            place.penetration - exact_depth,
            place.force / exact_force - 1.0
        );
        defects.push((place.penetration - exact_depth) / (depth - exact_depth));
    }
    assert!(defects[2].abs() < 0.02);
    for pair in defects.windows(2) {
        assert!((pair[0] / pair[1] - 2.0).abs() < 0.3, "{defects:?}");
    }
}

/// Pa, m, s → MPa, mm, ms: same numbers, and errors of the estimates that cover an integration four times finer.
#[test]
fn units_and_error_bounds() {
    let (modulus, radius, time) = (0.83e6, 2.7e-3, 0.4);
    let material = PlaneMaterial::standard_solid(modulus, BETA * modulus, BETA * time).unwrap();
    let speed = 3e-3 * radius / time;
    let problem = |length: f64, stress: f64, second: f64| {
        let adhesion = Adhesion { work_of_adhesion: WORK * modulus * radius * stress * length, process_zone: ZONE * radius * length };
        let history = History::penetration(0.032 * radius * length).at_speed(0.01 * radius * length, speed * length / second);
        IndentationProblem {
            instants_per_segment: 5,
            energies: true,
            ..IndentationProblem::new(Profile::Paraboloid { radius: radius * length }, Some(adhesion), history).relaxed()
        }
    };
    let si = run(&material, &problem(1.0, 1.0, 1.0)).unwrap();
    let other = PlaneMaterial::standard_solid(modulus * 1e-6, BETA * modulus * 1e-6, BETA * time * 1e3).unwrap();
    let mm = run(&other, &problem(1e3, 1e-6, 1e3)).unwrap();
    let assess = integrate(&material, &problem(1.0, 1.0, 1.0), 1e-9).unwrap();
    for (index, (first, second)) in si.instants.iter().zip(&mm.instants).enumerate() {
        // The root of each step is found to 1e-10.
        assert!((first.contact_radius.value * 1e3 / second.contact_radius.value - 1.0).abs() < 1e-7);
        assert!((first.force.value - second.force.value).abs() < 1e-7 * first.force.value.abs());
        let truth = assess.path[assess.kept[index]];
        println!(
            "t {:.4}: F {:e} ± {:e}, off {:e}; a ± {:e}, off {:e}; U ± {:e}, off {:e}",
            first.time,
            first.force.value,
            first.force.error,
            (first.force.value - truth.force).abs(),
            first.contact_radius.error,
            (first.contact_radius.value - truth.contact_radius).abs(),
            first.energies.unwrap()[0].error,
            (first.energies.unwrap()[0].value - truth.energies.unwrap().stored).abs()
        );
        assert!((first.force.value - truth.force).abs() <= first.force.error);
        assert!((first.contact_radius.value - truth.contact_radius).abs() <= first.contact_radius.error);
        assert!((first.energies.unwrap()[0].value - truth.energies.unwrap().stored).abs() <= first.energies.unwrap()[0].error);
    }
    assert!((si.pull_off_force().unwrap().value / mm.pull_off_force().unwrap().value - 1.0).abs() < 1e-7);
    assert!(si.events.iter().any(|event| event.kind == EventKind::Detachment) || si.events.is_empty());
}
