//! Source: Lee & Radok, J. Appl. Mech. 27 (1960) 438; Ting, J. Appl. Mech. 33 (1966) 845; Hertz's contact.
//!
//! Goal: without adhesion a force, a frame or a contact radius gives the right contact, through its loss and the next touch.
//!
//! ```text
//! flat punch     Δ = ∫J(t − t′)dF₊/2a while it is pressed, F₊ = max(F, 0), whatever it lost before
//! radius         F = ∫₀^{t₁} R(t − t′)d(4a³/3R), t₁ when the edge was last here (Ting)
//! elastic        Hertz's sphere, alone and on a spring
//! liquid         a³ = (3/4)RFJ(t) under a force that stays
//! ```
//! Parameters: solids and liquids of 0 to 2 terms, spheres and punches.
//!
//! Oracle: closed forms, and Gauss quadrature of the hereditary integral with R of the material, here in the test.
//!
//! Tolerance: 1e-8 of the largest value, and the bounds reported.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::PlaneMaterial;
use viscotack::indentation::{Controlled, EventKind, History, IndentationProblem, IndentationSolution, Instant, Oscillation, Profile, run};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack::special::gauss_legendre::UNIT_RULE_20;

const RADIUS: f64 = 1e-3;
const SPHERE: Profile = Profile::Paraboloid { radius: RADIUS };
const PUNCH: Profile = Profile::FlatPunch { radius: RADIUS };

fn solved(material: &PlaneMaterial, profile: Profile, history: History, stiffness: Option<f64>) -> IndentationSolution {
    let problem = IndentationProblem {
        accuracy: 1e-6,
        frame_stiffness: stiffness,
        instants_per_segment: 5,
        ..IndentationProblem::new(profile, None, history)
    };
    let solution = run(material, &problem).unwrap();
    assert!(solution.reached);
    assert!(solution.smallest_gap_factor > -1e-11 * solution.integration.summary.scales[0], "{}", solution.smallest_gap_factor);
    solution
}

fn two_terms() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(1e6, &[term(3e6, 0.05), term(5e6, 2.0)]).unwrap()
}

/// J(t) and ∫₀^t J of a material.
fn compliance(material: &PlaneMaterial, time: f64) -> [f64; 2] {
    let mut sums = [material.creep(0.0), material.creep(0.0) * time];
    for CreepTerm { compliance, retardation_time } in material.creep_terms() {
        let risen = -(-time / retardation_time).exp_m1();
        sums[0] += compliance * risen;
        sums[1] += compliance * (time - retardation_time * risen);
    }
    sums
}

/// Δ of a punch by segments (from, to, F there) and steps (when, by how much) of the force.
fn punch_depth(material: &PlaneMaterial, ramps: &[(f64, f64, f64, f64)], steps: &[(f64, f64)], time: f64) -> f64 {
    let mut sum: f64 = steps.iter().filter(|step| step.0 <= time).map(|step| step.1 * compliance(material, time - step.0)[0]).sum();
    for &(from, to, first, last) in ramps.iter().filter(|ramp| ramp.0 < time) {
        let area = |start: f64| compliance(material, time - start)[1];
        sum += (last - first) / (to - from) * (area(from) - area(to.min(time)));
    }
    sum / (2.0 * RADIUS)
}

fn pressed(solution: &IndentationSolution) -> impl Iterator<Item = &Instant> {
    solution.instants.iter().filter(|instant| instant.contact_radius.value > 0.0)
}

fn near(found: viscotack::Estimate, right: f64, scale: f64, what: &str) {
    let off = (found.value - right).abs();
    assert!(off <= 1e-8 * scale && off <= found.error + 1e-12 * scale, "{what}: {} ± {}, right {right}", found.value, found.error);
}

#[test]
fn a_punch_under_a_force_that_is_lost_and_found() {
    let material = two_terms();
    let history = History::force(0.0).ramp(0.02, 1.0).ramp(-0.01, 1.5).hold(0.3).ramp(0.03, 0.8).hold(50.0);
    let solution = solved(&material, PUNCH, history, None);
    // 0 at 2 s, and again at 2.8 + 0.2 s.
    let ramps = [(0.0, 1.0, 0.0, 0.02), (1.0, 2.0, 0.02, 0.0), (3.0, 3.6, 0.0, 0.03)];
    let scale = punch_depth(&material, &ramps, &[], 53.6);
    for instant in pressed(&solution) {
        near(instant.penetration, punch_depth(&material, &ramps, &[], instant.time), scale, &format!("Δ at {}", instant.time));
    }
    let lost: Vec<f64> = solution.events.iter().filter(|event| event.kind == EventKind::Detachment).map(|event| event.time.value).collect();
    assert_eq!(lost.len(), 1, "{lost:?}");
    assert!((lost[0] - 2.0).abs() < 1e-9);
}

#[test]
fn a_punch_of_a_liquid_under_a_force_that_oscillates() {
    let liquid = PlaneMaterial::from_creep(1e7, &[CreepTerm { compliance: 4e-7, retardation_time: 0.3 }], Some(2e7)).unwrap();
    let history = History::force(0.02).oscillate(Oscillation::steady(0.005, 0.5), 6.0);
    let solution = solved(&liquid, PUNCH, history, None);
    assert_eq!(solution.cycles.len(), 3);
    // Whole cycles: ∫J(t − t′)dF of the sine, by quadrature.
    let pace = std::f64::consts::PI;
    for instant in pressed(&solution) {
        let cells = 200;
        let width = instant.time / f64::from(cells);
        let mut sum = 0.02 * compliance(&liquid, instant.time)[0] + 0.02 * instant.time / 2e7;
        for cell in 0..cells {
            for (x, weight) in UNIT_RULE_20.iter() {
                let then = width * (f64::from(cell) + x);
                let lag = instant.time - then;
                sum += weight * width * 0.005 * pace * (pace * then).cos() * (compliance(&liquid, lag)[0] + lag / 2e7);
            }
        }
        near(instant.penetration, sum / (2.0 * RADIUS), 2e-5, &format!("Δ at {}", instant.time));
    }
}

#[test]
fn a_punch_oscillates_under_a_penetration() {
    let material = PlaneMaterial::elastic(2e6).unwrap();
    let solution = solved(&material, PUNCH, History::penetration(1e-5).oscillate(Oscillation::steady(4e-6, 3.0), 2.0), None);
    for instant in &solution.instants {
        near(instant.force, 2.0 * RADIUS * 2e6 * instant.penetration.value, 0.06, "F");
    }
}

#[test]
fn a_radius_out_and_back_is_tings() {
    let material = two_terms();
    let top = 1e-4;
    let solution = solved(&material, SPHERE, History::contact_radius(0.0).ramp(top, 1.0).ramp(0.1 * top, 0.9), None);
    let load = |time: f64, until: f64| {
        let cells = 400;
        let width = until / f64::from(cells);
        let rate = |then: f64| 4.0 * top.powi(3) * then * then / RADIUS;
        let mut sum = 0.0;
        for cell in 0..cells {
            let own = UNIT_RULE_20.iter().map(|(x, weight)| {
                let then = width * (f64::from(cell) + x);
                weight * width * material.relaxation(time - then) * rate(then)
            });
            sum += own.sum::<f64>();
        }
        sum
    };
    let scale = load(1.0, 1.0);
    for instant in &solution.instants {
        let turned = if instant.time <= 1.0 { instant.time } else { 2.0 - instant.time };
        near(instant.contact_radius, top * turned, top, "a");
        near(instant.force, load(instant.time, turned), scale, &format!("F at {}", instant.time));
    }
}

#[test]
fn elastic_spheres_follow_hertz_under_forces_and_frames() {
    let modulus = 2e6;
    let material = PlaneMaterial::elastic(modulus).unwrap();
    let hertz = |a: f64| 4.0 / 3.0 * modulus * a.powi(3) / RADIUS;
    let forces = History::force(0.0).ramp(0.01, 1.0).ramp(0.002, 0.5).step(0.02).ramp(-0.01, 3.0).ramp(0.005, 1.0).hold(1e6);
    let solution = solved(&material, SPHERE, forces, None);
    assert!(pressed(&solution).count() > 20);
    for instant in pressed(&solution) {
        near(instant.force, hertz(instant.contact_radius.value), 0.02, "F");
        near(instant.penetration, instant.contact_radius.value.powi(2) / RADIUS, 4e-5, "Δ");
    }
    for stiffness in [10.0, 1e3, 1e5] {
        let places = History::frame(-1e-6).ramp(2e-5, 1.0).hold(10.0).ramp(-1e-5, 2.0).step(1e-5).ramp(2e-5, 1.0);
        let solution = solved(&material, SPHERE, places, Some(stiffness));
        for instant in &solution.instants {
            near(instant.force, hertz(instant.contact_radius.value), hertz(1.5e-4), "F");
            if instant.contact_radius.value > 0.0 {
                near(instant.penetration, instant.contact_radius.value.powi(2) / RADIUS, 2e-5, "Δ");
            }
        }
        let last = solution.instants.last().unwrap();
        near(last.penetration, 2e-5 - last.force.value / stiffness, 2e-5, "the frame");
    }
}

#[test]
fn a_held_frame_does_not_drift_in_the_end() {
    // Δ + F/k = X, F = 4/3 E0 Δ^{3/2} R^{1/2} when all has relaxed.
    let material = two_terms();
    let solution = solved(&material, SPHERE, History::frame(0.0).ramp(2e-5, 0.1).hold(1e6), Some(500.0));
    let last = solution.instants.last().unwrap();
    let force = 4.0 / 3.0 * 1e6 * last.penetration.value.powf(1.5) * RADIUS.sqrt();
    near(last.force, force, force, "F");
    near(last.penetration, 2e-5 - force / 500.0, 2e-5, "Δ");
}

#[test]
fn a_liquid_sinks_under_a_force_and_lets_go_when_it_is_gone() {
    let liquid = PlaneMaterial::from_creep(1e7, &[CreepTerm { compliance: 4e-7, retardation_time: 0.3 }], Some(2e7)).unwrap();
    let solution = solved(&liquid, SPHERE, History::force(0.01).hold(30.0).ramp(0.0, 0.5), None);
    let cube = |time: f64| 0.75 * RADIUS * 0.01 * (compliance(&liquid, time)[0] + time / 2e7);
    for instant in solution.instants.iter().filter(|instant| instant.time <= 30.0) {
        near(instant.contact_radius, cube(instant.time).cbrt(), cube(30.0).cbrt(), "a");
    }
    let lost: Vec<f64> = solution.events.iter().filter(|event| event.kind == EventKind::Detachment).map(|event| event.time.value).collect();
    assert!(lost.len() == 1 && (lost[0] - 30.5).abs() < 1e-8, "{lost:?}");
}

/// What one control finds is found again under another one.
#[test]
fn controls_agree() {
    let material = two_terms();
    let by_force = solved(&material, SPHERE, History::force(0.0).ramp(0.01, 0.5).ramp(0.003, 0.3), None);
    let end = by_force.instants.last().unwrap();
    let mixed = History::force(0.0).ramp(0.01, 0.5).ramp(0.003, 0.3).then(Controlled::Penetration, end.penetration.value, 0.0);
    let again = solved(&material, SPHERE, mixed.then(Controlled::ContactRadius, end.contact_radius.value, 0.0), None);
    near(again.instants.last().unwrap().force, 0.003, 0.01, "F");
}
