//! Source: thesis Sec 5.4; the promise of this crate that no argument makes it panic, hang or return a NaN.
//!
//! Goal: every history ends, with finite numbers or a refusal in a sentence, at any magnitude of load, time and length; memory stays bounded in
//! rests of many cycles.
//!
//! Parameters: random solids of 1 to 12 terms over up to 12 decades of time; loads from 1e-200 to 1e5 glassy limits; dwells from 1e-12 to 1e9 times; loads
//! within rounding of both limits.
//!
//! Oracle: none needed. Tolerance: none; the step budget is 3000 a run.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use physics::{Random, random_solid};
use viscotack::crack::delayed::{
    EventKind, GrowthProblem, LoadHistory, LoadSegment, Onset, Resolution, Trajectory, Wave, onset, trajectory,
};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::{Estimate, PlaneMaterial, Refusal};

fn problem(material: &PlaneMaterial, work_of_adhesion: f64, length: f64) -> GrowthProblem<'_> {
    let process_zone = ProcessZone::Constant { length };
    GrowthProblem::new(material, Interface { work_of_adhesion, process_zone, body: CrackBody::TwoHalves }, 0.0).unwrap()
}

fn assert_finite(what: &str, numbers: &[Estimate]) {
    for number in numbers {
        assert!(number.value.is_finite() && number.error.is_finite() && number.error >= 0.0, "{what}: {number:?}");
    }
}

fn assert_sound(what: &str, found: &Trajectory) {
    for sample in &found.samples {
        assert_finite(what, &[sample.growth, sample.speed].into_iter().flatten().collect::<Vec<_>>());
    }
    for event in &found.events {
        assert_finite(what, &[event.time, event.growth]);
        match event.kind {
            EventKind::GrowthBegins { speed } | EventKind::Restart { speed } | EventKind::Arrest { speed_before: speed } => {
                assert_finite(what, &[speed]);
            }
            EventKind::Jump { distance } => assert_finite(what, &[distance]),
            EventKind::Kink { speed_before, speed_after } => assert_finite(what, &[speed_before, speed_after]),
            EventKind::Unbounded => {}
        }
    }
}

#[test]
fn any_history_ends_in_numbers_or_in_a_sentence() {
    let mut random = Random(90_210);
    let (mut solved, mut refused) = (0, 0);
    for case in 0..60 {
        let material = random_solid(&mut random, 12, 12.0, 1e5);
        let problem = problem(&material, random.decade(1e-9, 1e9), random.decade(1e-15, 1e3));
        let (low, high) = (problem.relaxed_limit(), problem.glassy_limit());
        let longest = material.longest_retardation_time().unwrap_or(1.0);
        let mut segments = Vec::new();
        let mut total = 0.0;
        for _ in 0..random.count(6) {
            let load = match random.count(8) {
                1 => 0.0,
                2 => low * (1.0 + random.between(-4.0, 4.0) * f64::EPSILON),
                3 => high * (1.0 + random.between(-4.0, 4.0) * f64::EPSILON),
                4 => high * random.decade(1e-200, 1e5),
                _ => low * (high / low).powf(random.between(-0.2, 1.0)),
            };
            let duration = longest * random.decade(1e-12, 1e9);
            total += duration;
            segments.push(match random.count(4) {
                1 => LoadSegment::Ramp { duration, load },
                2 => LoadSegment::Cycles {
                    count: 3,
                    period: duration / 3.0,
                    lower: 0.5 * load,
                    upper: load,
                    wave: if random.unit() < 0.5 { Wave::Square } else { Wave::Triangle },
                },
                3 => LoadSegment::Table { points: vec![(0.0, load), (0.3 * duration, 0.2 * load), (duration, 0.9 * load)] },
                _ => LoadSegment::Step { load },
            });
        }
        let history = LoadHistory::from_segments(&segments).unwrap();
        let times = [0.0, 1e-9 * total, 0.1 * total, 0.5 * total, total, 2.0 * total];
        let what = format!("case {case}: {segments:?}");
        match trajectory(&problem, &history, &times, Resolution { lines_per_zone: 8, most_steps: 3000 }) {
            Ok(found) => {
                assert_sound(&what, &found);
                solved += 1;
            }
            Err(Refusal::NotConverged { .. }) => refused += 1,
            Err(refusal) => panic!("{what}: {refusal}"),
        }
    }
    println!("{solved} solved, {refused} need more steps than the budget");
    assert!(solved > 25);
}

#[test]
fn onset_within_rounding_of_both_limits_is_a_number_or_none() {
    let mut random = Random(11);
    for _ in 0..400 {
        let material = random_solid(&mut random, 12, 12.0, 1e6);
        let problem = problem(&material, random.decade(1e-6, 1e3), 1e-6);
        let limit = if random.unit() < 0.5 { problem.relaxed_limit() } else { problem.glassy_limit() };
        let load = limit * (1.0 + random.between(-8.0, 8.0) * f64::EPSILON);
        match onset(&problem, load) {
            Ok(Onset::After { delay, initial_speed, .. }) => assert_finite("onset", &[delay, initial_speed]),
            Ok(Onset::Never | Onset::AtOnce) | Err(Refusal::NotConverged { .. }) => {}
            Err(refusal) => panic!("{refusal}"),
        }
    }
}

#[test]
fn rest_of_many_cycles_is_one_piece_of_memory() {
    let material = PlaneMaterial::standard_solid(7.3e5, 7.3e6, 0.43).unwrap();
    let problem = problem(&material, 0.3, 1e-6);
    let upper = 0.9 * problem.relaxed_limit();
    let cycles = LoadSegment::Cycles { count: 5000, period: 0.1, lower: 0.0, upper, wave: Wave::Triangle };
    let history = LoadHistory::from_segments(&[cycles]).unwrap();
    let found = trajectory(&problem, &history, &[250.0, 500.0], Resolution::default()).unwrap();
    println!("{:?}", found.work);
    assert!(found.events.is_empty() && found.work.most_pieces == 1 && found.work.steps < 4 * 10_100, "{:?}", found.work);
}
