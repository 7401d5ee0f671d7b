//! Source: Lee & Radok, J. Appl. Mech. 27 (1960) 438; Ting, J. Appl. Mech. 33 (1966) 845 and 35 (1968) 248; Graham, Q. Appl. Math. 26 (1968) 167;
//! Sneddon, Int. J. Eng. Sci. 3 (1965) 47. The cases are those of scenes that were wrong, refused or endless, with neighbours.
//!
//! Goal: without adhesion the right contact for any shape, number of terms, history of the penetration, and force that grows on an untouched surface.
//!
//! ```text
//! growing        a = f⁻¹(Δ),  F = ∫R(t − t′) dF₁(Δ),  F₁ of a unit modulus;  under a force F₁(Δ) = ∫J dF
//! receding       ∫_{t₁}^{t} R(t − t′)Δ̇ dt′ = 0, t₁ when the edge last stood here (Ting)
//! elastic        a = f⁻¹(Δ) at every instant
//! ```
//! Parameters: solids and liquids of 0 to 6 terms in two unit systems.
//!
//! Oracle: closed forms and Gauss quadrature of the hereditary integrals with R and J of the material, here in the test; identities.
//!
//! Tolerance: 1e-9 of the largest value, and the bounds reported.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::FRAC_PI_2;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, EventKind, History, IndentationProblem, IndentationSolution, Oscillation, Profile, run};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack::special::gauss_legendre::UNIT_RULE_20;

fn solved(material: &PlaneMaterial, profile: Profile, history: History, accuracy: f64) -> IndentationSolution {
    let problem = IndentationProblem { accuracy, ..IndentationProblem::new(profile, None, history) };
    let solution = run(material, &problem).unwrap();
    assert!(solution.reached, "{:?}", solution.instants.last());
    assert!(solution.smallest_gap_factor > -1e-12 * solution.integration.summary.scales[0], "{}", solution.smallest_gap_factor);
    solution
}

fn six_terms() -> PlaneMaterial {
    let terms = [(3.0e5, 1e-3), (2e6, 0.04), (4e5, 0.5), (1e6, 3.0), (2e5, 40.0), (5e5, 900.0)];
    let terms = terms.map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time });
    PlaneMaterial::from_relaxation(4e5, &terms).unwrap()
}

/// ∫₀^t kernel(t − t′) g′(t′) dt′ over segments, graded towards both ends of each.
fn hereditary(kernel: &dyn Fn(f64) -> f64, rate: &dyn Fn(f64) -> f64, breaks: &[f64], time: f64) -> f64 {
    let mut total = 0.0;
    for pair in breaks.windows(2) {
        let (low, high) = (pair[0], pair[1].min(time));
        if high <= low {
            continue;
        }
        let half = 0.5 * (high - low);
        let mut ends = vec![low];
        ends.extend((0..45).rev().map(|k| low + half * 0.5_f64.powi(k)));
        ends.extend((1..45).map(|k| high - half * 0.5_f64.powi(k)));
        ends.push(high);
        for cell in ends.windows(2) {
            let width = cell[1] - cell[0];
            total +=
                UNIT_RULE_20.iter().map(|(x, w)| w * width * kernel(time - cell[0] - width * x) * rate(cell[0] + width * x)).sum::<f64>();
        }
    }
    total
}

fn near(found: f64, right: f64, bound: f64, scale: f64, what: &str) {
    assert!((found - right).abs() <= bound + 1e-9 * scale, "{what}: {found:.15e} ± {bound:e}, right {right:.15e}");
}

/// Press, hold, press deeper, hold: the edge follows √(ΔR), the force Lee and Radok.
#[test]
fn press_hold_and_press_deeper() {
    for beta in [1.5, 10.0, 300.0] {
        for scale in [1.0, 1e-5] {
            let radius = 2.0 * scale;
            let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * beta, 10.0).unwrap();
            let (first, second) = (0.01 * radius, 0.02 * radius);
            let history = History::penetration(0.0).ramp(first, 1.0).hold(10.0).ramp(second, 1.0).hold(10.0);
            let solution = solved(&material, Profile::Paraboloid { radius }, history, 1e-6);
            let last = solution.instants.last().unwrap();
            near(last.contact_radius.value, (second * radius).sqrt(), last.contact_radius.error, second, "a");
            // F₁ = (4/3)√R Δ^{3/2}.
            let depth = |t: f64| {
                if t < 1.0 {
                    first * t
                } else if t < 11.0 {
                    first
                } else {
                    first + (second - first) * (t - 11.0).min(1.0)
                }
            };
            let speed = |t: f64| {
                if t < 1.0 {
                    first
                } else if t > 11.0 && t < 12.0 {
                    second - first
                } else {
                    0.0
                }
            };
            let rate = |t: f64| 2.0 * (radius * depth(t)).sqrt() * speed(t);
            let force = hereditary(&|t| material.relaxation(t), &rate, &[0.0, 1.0, 11.0, 12.0, 22.0], 22.0);
            near(last.force.value, force, last.force.error, force, "F");
            assert!(solution.events.is_empty());
        }
    }
}

/// The contact lets go when Ting's condition has gone back to first touch, ∫₀^t R(t − t′)Δ̇ dt′ = 0, and never pulls.
#[test]
fn press_hold_and_retract_detaches() {
    let material = PlaneMaterial::standard_solid(1e6 / (1.0 - 0.49 * 0.49), 1e7 / (1.0 - 0.49 * 0.49), 1.0).unwrap();
    for (profile, what) in [
        (Profile::Paraboloid { radius: 1e-3 }, "sphere"),
        (Profile::Cone { slope: 0.2 }, "cone"),
        (Profile::PowerLaw { coefficient: 3e10, exponent: 4.0 }, "power"),
        (Profile::FlatPunch { radius: 1e-4 }, "punch"),
    ] {
        let history = History::penetration(0.0).ramp(1e-5, 1.0).hold(1.0).at_speed(1e-6, 1e-5);
        let solution = solved(&material, profile, history, 1e-4);
        // The axis knows nothing of the shape.
        let speed = |t: f64| {
            if t < 1.0 {
                1e-5
            } else if t < 2.0 {
                0.0
            } else {
                -1e-5
            }
        };
        let pressed = |t: f64| hereditary(&|x| material.relaxation(x), &speed, &[0.0, 1.0, 2.0, 3.0], t);
        let (mut low, mut high) = (2.0, 2.9);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if pressed(middle) > 0.0 { low = middle } else { high = middle }
        }
        let [event] = &solution.events[..] else { panic!("{what}: {:?}", solution.events) };
        assert_eq!(event.kind, EventKind::Detachment);
        assert!((event.time.value - low).abs() < 1e-9 && (low - 2.210_102_68).abs() < 1e-7, "{what}: {} {low}", event.time.value);
        assert!(solution.pull_off_force().is_none());
        assert_eq!(solution.instants.last().unwrap().contact_radius.value.to_bits(), 0.0_f64.to_bits());
    }
}

/// An elastic contact has no path history: a = f⁻¹(Δ) at every point of the path, oscillating, stepping, under a force.
#[test]
fn elastic_contacts_follow_at_every_instant() {
    let material = PlaneMaterial::elastic(3e6).unwrap();
    let radius = 0.02;
    let history = History::penetration(1e-4).oscillate(Oscillation::steady(3e-5, 2.0), 1.5).step(2e-4).ramp(5e-5, 0.1).hold(1e4);
    for history in [history, History::force(0.1).ramp(0.5, 2.0).hold(1e5).step(0.7).ramp(1.0, 1e-3)] {
        let solution = solved(&material, Profile::Paraboloid { radius }, history, 1e-7);
        for point in &solution.integration.path {
            let a = (point.penetration * radius).sqrt();
            assert!((point.contact_radius - a).abs() < 1e-11 * a, "{point:?}");
            let force = 4.0 / 3.0 * 3e6 * radius.sqrt() * point.penetration.powf(1.5);
            assert!((point.force - force).abs() < 1e-9 * force, "{point:?} {force}");
        }
        assert!(solution.events.is_empty());
    }
}

/// In, half out, in, half out, deeper (an entry of a public corpus; values of another group's MDR program to 1e-3, and of this test's own quadrature in between).
#[test]
fn second_unloading() {
    let plane = 1.0 / (1.0 - 0.38 * 0.38);
    let term = |modulus: f64, relaxation_time| RelaxationTerm { modulus: modulus * plane, relaxation_time };
    let material = PlaneMaterial::from_relaxation(1.5e9 * plane, &[term(7e8, 1.0), term(5e8, 10.0)]).unwrap();
    let history = History::penetration(0.0).ramp(1e-5, 1.0).ramp(5e-6, 1.0).ramp(1e-5, 1.0).ramp(5e-6, 1.0).ramp(1.2e-5, 1.0);
    let solution = solved(&material, Profile::Paraboloid { radius: 0.01 }, history, 1e-4);
    for (place, right) in [(2, 2.880_315_891_1), (3, 10.744_075_17), (4, 2.291_501_439), (5, 14.146_086_213)] {
        let force = solution.instants[place].force;
        assert!((force.value - right).abs() < 1e-6 * right, "{place}: {} for {right}", force.value);
        assert!(force.error < 1e-6 * right);
    }
}

/// Burgers' liquid under a force that is put on at once: a³ = (3/4)R F J(t); Maxwell's under a penetration.
#[test]
fn liquids() {
    let burgers = PlaneMaterial::from_creep(1e10, &[CreepTerm { compliance: 1e-10, retardation_time: 1.0 }], Some(1e11)).unwrap();
    let radius = 0.01;
    let history = History::force(100.0).hold(10.0).ramp(300.0, 5.0);
    let solution = solved(&burgers, Profile::Paraboloid { radius }, history, 1e-6);
    let held = solution.instants[1];
    let a = (0.75 * radius * 100.0 * burgers.creep(10.0)).cbrt();
    near(held.contact_radius.value, a, held.contact_radius.error, a, "a held");
    let last = solution.instants[2];
    let strain = 100.0 * burgers.creep(15.0) + hereditary(&|t| burgers.creep(t), &|_| 40.0, &[10.0, 15.0], 15.0);
    let a = (0.75 * radius * strain).cbrt();
    near(last.contact_radius.value, a, last.contact_radius.error, a, "a raised");
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    let melt = PlaneMaterial::from_relaxation(0.0, &[term(1e6, 1.0), term(1e5, 10.0)]).unwrap();
    for hold in [20.0, 300.0, 1e6] {
        let depth = 1e-5;
        let history = History::penetration(0.0).ramp(depth, 1.0).hold(hold).ramp(0.5 * depth, 1.0);
        let solution = solved(&melt, Profile::Paraboloid { radius: 1e-3 }, history, 1e-6);
        let end = solution.instants[2];
        let rate = |t: f64| 2.0 * (1e-3 * depth * t).sqrt() * depth;
        let force = hereditary(&|t| melt.relaxation(t), &rate, &[0.0, 1.0], 1.0 + hold);
        near(end.force.value, force, end.force.error, solution.instants[1].force.value, "F of a melt");
        near(end.contact_radius.value, 1e-4, end.contact_radius.error, 1e-4, "a of a melt");
        if hold > 250.0 {
            // All of it has flowed: it lets go as the indenter turns.
            assert_eq!(solution.events.len(), 1);
            assert!((solution.events[0].time.value - 1.0 - hold).abs() < 1e-3 + 1e-12 * hold);
        }
    }
}

/// Shapes on first loading: F = 2∫R d[a Δ − ∫₀^a f ds], without an event; a punch from untouched.
#[test]
fn shapes_on_first_loading() {
    let material = six_terms();
    let (end, time) = (2e-6, 0.3);
    let power = |exponent: f64| Profile::PowerLaw { coefficient: 1e-6 / 1e-5_f64.powf(exponent), exponent };
    for (profile, share) in [
        (Profile::Cone { slope: 0.1 }, 0.5),
        (power(1.3), 1.3 / 2.3),
        (power(4.0), 0.8),
        (power(7.5), 7.5 / 8.5),
        (Profile::FlatPunch { radius: 1e-5 }, 1.0),
    ] {
        let radius = |depth: f64| match &profile {
            Profile::Cone { slope } => depth / (FRAC_PI_2 * slope),
            Profile::PowerLaw { coefficient, exponent } => (depth / coefficient).powf(1.0 / exponent),
            _ => 1e-5,
        };
        // dF₁ = 2a dΔ for every shape.
        assert!(share > 0.0);
        let rate = |t: f64| 2.0 * radius(end * t / time) * end / time;
        let force = hereditary(&|t| material.relaxation(t), &rate, &[0.0, time], time);
        let solution = solved(&material, profile.clone(), History::penetration(0.0).ramp(end, time), 1e-6);
        let last = solution.instants.last().unwrap();
        near(last.force.value, force, last.force.error, force, "F");
        near(last.contact_radius.value, radius(end), last.contact_radius.error, radius(end), "a");
        assert!(solution.events.is_empty(), "{:?}", solution.events);
    }
}

/// A force that only grows, over 12 decades of time, with steps and holds: met at every instant; its depth Lee and Radok's, for every shape.
#[test]
fn forces_that_grow_on_a_fresh_surface() {
    for material in
        [six_terms(), PlaneMaterial::from_creep(1e6, &[], Some(1e9)).unwrap(), PlaneMaterial::standard_solid(1e6, 3e8, 0.02).unwrap()]
    {
        for profile in
            [Profile::Paraboloid { radius: 1e-3 }, Profile::Cone { slope: 0.1 }, Profile::PowerLaw { coefficient: 3e8, exponent: 4.0 }]
        {
            let history = History::force(1e-4).hold(1e-6).ramp(1e-3, 0.5).hold(100.0).step(2e-3).hold(1e4).ramp(3e-3, 1e6);
            let problem =
                IndentationProblem { accuracy: 1e-6, instants_per_segment: 3, ..IndentationProblem::new(profile.clone(), None, history) };
            assert!(problem.is_without_steps());
            let solution = run(&material, &problem).unwrap();
            assert!(solution.reached && solution.events.is_empty());
            // Starts of the segments, and the rates between; the step apart.
            let breaks = [0.0, 1e-6, 0.500_001, 100.500_001, 10_100.500_001, 1_010_100.500_001];
            for instant in solution.instants.iter().skip(1) {
                let t = instant.time;
                let rate = |t: f64| {
                    if t > breaks[1] && t < breaks[2] {
                        9e-4 / 0.5
                    } else if t > breaks[4] {
                        1e-3 / 1e6
                    } else {
                        0.0
                    }
                };
                let step = if instant.force.value > 1.5e-3 { 1e-3 * material.creep(t - breaks[3]) } else { 0.0 };
                let driven = 1e-4 * material.creep(t) + step + hereditary(&|x| material.creep(x), &rate, &breaks, t);
                // F₁ of a unit modulus: 4/3 √R Δ^{3/2}; Δ²/(π/2 · slope); 2aΔm/(m + 1).
                let depth = match profile {
                    Profile::Cone { slope } => (driven * FRAC_PI_2 * slope).sqrt(),
                    Profile::PowerLaw { coefficient, exponent } => {
                        (driven * (exponent + 1.0) / (2.0 * exponent)).powf(exponent / (exponent + 1.0))
                            * coefficient.powf(1.0 / (exponent + 1.0))
                    }
                    _ => (0.75 * driven).powf(2.0 / 3.0) / 1e-3_f64.cbrt(),
                };
                near(instant.penetration.value, depth, instant.penetration.error, depth, "Δ");
            }
        }
    }
}

/// Whatever is given, for any shape and start: only adhesion needs steps.
#[test]
fn what_is_solved_without_steps() {
    let of = |history: History| IndentationProblem::new(Profile::Paraboloid { radius: 1e-3 }, None, history);
    for history in [History::penetration(1e-5), History::force(-1.0), History::contact_radius(1e-5), History::frame(0.0)] {
        assert!(of(history.clone()).is_without_steps() && of(history.clone()).relaxed().is_without_steps());
        let adhesion = Some(Adhesion { work_of_adhesion: 0.05, process_zone: 1e-7 });
        assert!(!IndentationProblem { adhesion, ..of(history) }.is_without_steps());
    }
}

/// Thousands of cycles within bounded memory; each of the last ones is the one before.
#[test]
fn many_cycles_are_bounded() {
    let material = PlaneMaterial::standard_solid(1e6, 8e6, 0.5).unwrap();
    let history = History::penetration(2e-5).oscillate(Oscillation::steady(6e-6, 1.0), 20_000.0);
    let solution = solved(&material, Profile::Paraboloid { radius: 1e-3 }, history, 1e-4);
    let last = solution.cycles.last().unwrap();
    assert_eq!(last.number, 20_000);
    assert!(last.work.value > 0.0 && last.drift < 1e-3);
    assert!(solution.work.most_panels < 400, "{}", solution.work.most_panels);
}
