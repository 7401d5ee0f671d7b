//! Source: this crate's claim that every reported number of a history carries an honest error.
//!
//! Goal: bounds that cover, and that are not a hundred times too wide.
//!
//! Parameters: random solids of 1 to 4 terms, β 1.5 to 300, speeds over eight decades about the relaxation times, process zones 1e-3 to 6e-2 of R, histories of
//! approach, dwell, retraction, from an untouched or a relaxed start, under penetration, force or frame; Pa, m, s and random units.
//!
//! Oracle: the same history integrated 1000 times tighter or more. The integration has other oracles elsewhere (closed forms, a dense scheme, independent steppers).
//!
//! Tolerance: the accuracy asked for, always; the bound itself, always; the median bound at most ten times the error, the 95th percentile at most a hundred times.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::random::Uniform;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, Controlled, History, IndentationProblem, PathPoint, Profile, integrate, run};
use viscotack::material::RelaxationTerm;

fn problem(random: &mut Uniform, accuracy: f64) -> (PlaneMaterial, IndentationProblem) {
    let (modulus, radius, time) = (random.log_between(1e-2, 1e7), random.log_between(1e-4, 1e2), random.log_between(1e-3, 1e3));
    let beta = random.log_between(1.5, 300.0);
    let count = 1 + random.between(0.0, 4.0) as usize;
    let weights: Vec<f64> = (0..count).map(|_| random.between(0.2, 1.0)).collect();
    let total: f64 = weights.iter().sum();
    let terms: Vec<RelaxationTerm> = weights
        .iter()
        .enumerate()
        .map(|(k, weight)| RelaxationTerm {
            modulus: modulus * (beta - 1.0) * weight / total,
            relaxation_time: time * 10f64.powf(1.3 * k as f64 + random.between(0.0, 0.8)),
        })
        .collect();
    let material = PlaneMaterial::from_relaxation(modulus, &terms).unwrap();
    let work = modulus * radius * random.log_between(1e-5, 3e-3);
    let jkr = (9.0 * PI * work * radius * radius / (2.0 * modulus)).cbrt();
    let zone = jkr * random.log_between(3e-3, 0.1);
    let depth = jkr * jkr / radius * random.between(0.1, 1.5);
    let speed = depth / time * 10f64.powf(random.between(-4.0, 4.0));
    let adhesion = Some(Adhesion { work_of_adhesion: work, process_zone: zone });
    let history = match random.between(0.0, 4.0) as usize {
        0 => History::penetration(0.0).at_speed(depth, speed).hold(time * random.between(0.1, 3.0)).at_speed(0.3 * depth, speed),
        1 => History::penetration(depth).at_speed(0.5 * depth, speed).at_speed(0.8 * depth, 0.5 * speed),
        2 => History::force(0.0).ramp(modulus * depth * jkr, depth / speed).ramp(0.0, 2.0 * depth / speed),
        _ => History::frame(0.0).at_speed(2.0 * depth, speed).then(Controlled::Frame, 0.5 * depth, depth / speed),
    };
    let start_relaxed = history.controlled == Controlled::Penetration && history.start > 0.0;
    let mut problem = IndentationProblem::new(Profile::Paraboloid { radius }, adhesion, history);
    problem.frame_stiffness = Some(modulus * jkr * random.log_between(0.3, 30.0));
    problem.instants_per_segment = 2;
    problem.accuracy = accuracy;
    (material, if start_relaxed { problem.relaxed() } else { problem })
}

#[test]
fn bounds_cover_and_are_not_wide() {
    let mut random = Uniform::new();
    let (mut inside, mut outside, mut reached) = (0, 0, 0);
    let mut ratios: Vec<f64> = Vec::new();
    let mut refused = 0;
    for case in 0..60 {
        let accuracy = [1e-3, 1e-4, 1e-5][case % 3];
        let (material, asked) = problem(&mut random, accuracy);
        let (found, exact) = match (run(&material, &asked), integrate(&material, &asked, 1e-3 * accuracy)) {
            (Ok(found), Ok(exact)) => (found, exact),
            (found, exact) => {
                println!("case {case}: {:?} {:?}", found.err(), exact.err());
                refused += 1;
                continue;
            }
        };
        reached += i32::from(found.reached);
        for (one, place) in found.instants.iter().zip(&exact.kept).skip(1) {
            let other = exact.path[*place];
            let scale = |of: fn(&PathPoint) -> f64| exact.path.iter().fold(0.0f64, |most, point| most.max(of(point).abs()));
            for (name, one, other, scale) in [
                ("penetration", one.penetration, other.penetration, scale(|point| point.penetration)),
                ("force", one.force, other.force, scale(|point| point.force)),
                ("radius", one.contact_radius, other.contact_radius, scale(|point| point.contact_radius)),
                ("intensity", one.stress_intensity_factor, other.stress_intensity_factor, scale(|point| point.stress_intensity_factor)),
            ] {
                let error = (one.value - other).abs();
                assert!(error <= accuracy * scale, "case {case}: {name} misses the accuracy");
                if error <= one.error {
                    inside += 1;
                } else {
                    outside += 1;
                    println!("case {case} ({accuracy:e}): {name} {:e} ± {:e}, off {error:e}, of {scale:e}", one.value, one.error);
                }
                // Smaller errors may be those of the truth.
                if error > 1e-5 * accuracy * scale && one.error.is_finite() {
                    ratios.push(one.error / error);
                }
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let at = |share: f64| ratios[(share * (ratios.len() - 1) as f64) as usize];
    println!(
        "inside {inside}, outside {outside}, reached {reached}, refused {refused}; bound over error: 5 % {:.2}, median {:.1}, 95 % {:.1}, of {}",
        at(0.05),
        at(0.5),
        at(0.95),
        ratios.len()
    );
    assert_eq!(refused, 0);
    assert_eq!(outside, 0);
    assert!(at(0.5) < 10.0 && at(0.95) < 100.0);
    assert_eq!(reached, 60);
}

/// Points of a path between kept instants: the same history, tighter, with an instant at the time of the point. What is imposed at the instants beside has no error
/// there.
#[test]
fn points_of_a_path_have_bounds_that_cover() {
    let material = PlaneMaterial::standard_solid(1.0, 30.0, 1.0).unwrap();
    let adhesion = Adhesion { work_of_adhesion: 2e-3, process_zone: 5e-3 };
    let (load, press, down, pull) = (0.02, 0.7, -0.03, 1.5);
    let of = |adhesion: Option<Adhesion>, accuracy: f64, stop: Option<(f64, f64)>| {
        let history = History::force(0.0).ramp(load, press);
        let history = match stop {
            Some((penetration, time)) => history.then(Controlled::Penetration, penetration, time),
            None => history.then(Controlled::Penetration, down, pull),
        };
        IndentationProblem { accuracy, ..IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history) }
    };
    let mut compared = 0;
    for adhesion in [None, Some(adhesion)] {
        for accuracy in [1e-2, 1e-4] {
            let found = run(&material, &of(adhesion, accuracy, None)).unwrap();
            assert_eq!(found.path_errors.len(), found.integration.path.len());
            let start = found.instants[1].penetration.value;
            let inside: Vec<usize> = (0..found.integration.path.len())
                .filter(|index| found.integration.path[*index].time > press * 1.001 && !found.integration.kept.contains(index))
                .filter(|index| found.path_errors[*index].iter().all(|error| error.is_finite()))
                .collect();
            for index in inside.iter().step_by((inside.len() / 12).max(1)) {
                let (point, errors) = (&found.integration.path[*index], found.path_errors[*index]);
                let time = point.time - press;
                // The same ramp up to there, from where the tighter run has its start.
                let begin = run(&material, &of(adhesion, 1e-3 * accuracy, Some((down, pull)))).unwrap().instants[1].penetration;
                let there = begin.value + (down - begin.value) * time / pull;
                let exact = run(&material, &of(adhesion, 1e-3 * accuracy, Some((there, time)))).unwrap();
                let exact = exact.instants.last().unwrap();
                let pairs = [
                    ("penetration", point.penetration, exact.penetration, start.abs()),
                    ("force", point.force, exact.force, load),
                    ("radius", point.contact_radius, exact.contact_radius, start.abs().sqrt()),
                ];
                for (quantity, (name, value, exact, scale)) in pairs.into_iter().enumerate() {
                    let off = (value - exact.value).abs();
                    let allowed = errors[quantity] + exact.error + 1e-12 * scale;
                    assert!(off <= allowed, "{name} at {time}: {value:e} ± {:e}, {:e}", errors[quantity], exact.value);
                    assert!(errors[quantity] < 30.0 * accuracy * scale, "{name} at {time}: ± {:e} of {scale:e}", errors[quantity]);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 60, "{compared}");
}
