//! What integrations of the sphere cost, in counters: steps, evaluations of the edge condition, points of the line updated.
//!
//! Goal: cost in proportion to the steps, however long the history, and to the terms; no step dearer because more has happened before.
//! Parameters: the thesis's Fig 4.3 (γ̃ = 1.6e-4, δ̃ = 0.013, β = 10, V·ρ/R = 2e-3), one cycle and many, one term and sixteen.
//! Oracle: none; counters are bounded by a tenth more than they were when this was written, and what grows is compared with what it should grow with.
//! Never a time.
#![allow(clippy::unwrap_used, clippy::float_cmp, missing_docs)]

use crate::support;

use support::indentation::{SPHERE, WORK, ZONE, rubber};
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, History, IndentationProblem, IndentationWork, Oscillation, integrate, run};
use viscotack::material::RelaxationTerm;

const SPEED: f64 = 2e-3;

fn problem(history: History, accuracy: f64) -> IndentationProblem {
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    IndentationProblem { accuracy, instants_per_segment: 4, ..IndentationProblem::new(SPHERE, adhesion, history) }
}

fn show(name: &str, work: &IndentationWork) {
    println!(
        "{name}: {} steps, {} evaluations ({:.2} a step), {} updates ({:.0} a step), {} panels",
        work.steps,
        work.closure_evaluations,
        work.closure_evaluations as f64 / work.steps as f64,
        work.history_updates,
        work.history_updates as f64 / work.steps as f64,
        work.most_panels
    );
}

/// An approach and retraction at two accuracies, every integration of the search for it counted.
#[test]
fn a_cycle_at_two_accuracies() {
    for (accuracy, steps, evaluations) in [(1e-4, LIMITS[0].0, LIMITS[0].1), (1e-6, LIMITS[1].0, LIMITS[1].1)] {
        let found = run(&rubber(), &problem(History::penetration(0.0).at_speed(0.032, SPEED).at_speed(-0.02, SPEED), accuracy)).unwrap();
        show(&format!("{accuracy:e}"), &found.work);
        assert!(found.reached && found.work.steps <= steps && found.work.closure_evaluations <= evaluations);
    }
}

/// Steps, evaluations and updates of many cycles grow with the number of cycles and no faster: panels stay as many.
#[test]
fn many_cycles_cost_as_many_times() {
    let cycles = |count: u32| {
        let history = (0..count).fold(History::penetration(0.0), |history, _| history.at_speed(0.032, SPEED).at_speed(0.015, SPEED));
        let work = integrate(&rubber(), &problem(history, 1e-3), 1e-3).unwrap().work;
        show(&format!("{count} cycles"), &work);
        work
    };
    // The first cycles have fewer old corners to come back over.
    let (few, many) = (cycles(32), cycles(128));
    assert!((many.steps as f64) < 4.3 * few.steps as f64);
    assert!((many.closure_evaluations as f64) < 4.3 * few.closure_evaluations as f64);
    assert!((many.history_updates as f64) < 4.5 * few.history_updates as f64);
    assert!(many.most_panels <= few.most_panels + few.most_panels / 4);
    let oscillation = |count: f64| {
        let history = History::penetration(0.02).oscillate(Oscillation::steady(0.004, 0.05), 20.0 * count);
        let work = integrate(&rubber(), &problem(history, 1e-3), 3e-3).unwrap().work;
        show(&format!("{count} oscillations"), &work);
        work
    };
    let (few, many) = (oscillation(40.0), oscillation(320.0));
    assert!((many.steps as f64) < 8.8 * few.steps as f64);
    assert!((many.history_updates as f64) < 9.6 * few.history_updates as f64);
    assert!(many.most_panels <= few.most_panels + few.most_panels / 4);
}

/// Terms within one decade need the same steps; each point of the line then carries n numbers.
#[test]
fn terms_cost_in_proportion() {
    let material = |count: i32| {
        let term = |k: i32| RelaxationTerm {
            modulus: 9.0 / f64::from(count),
            relaxation_time: 10f64.powf((f64::from(k) + 0.5) / f64::from(count) - 0.5),
        };
        PlaneMaterial::from_relaxation(1.0, &(0..count).map(term).collect::<Vec<_>>()).unwrap()
    };
    let history = || History::penetration(0.0).at_speed(0.032, SPEED).at_speed(-0.02, SPEED);
    let works: Vec<IndentationWork> =
        [1, 4, 16].iter().map(|&count| integrate(&material(count), &problem(history(), 1e-3), 1e-4).unwrap().work).collect();
    for (count, work) in [1, 4, 16].iter().zip(&works) {
        show(&format!("{count} terms"), work);
    }
    // Updates count points; a point costs n, and n² once, when the edge passes it.
    assert!(works.iter().all(|work| work.history_updates < 2 * works[0].history_updates));
    assert!(works.iter().all(|work| work.steps < 2 * works[0].steps));
}

/// Steps and evaluations of three integrations at accuracies of 1e-4 and 1e-6.
const LIMITS: [(u64, u64); 2] = [(1755, 5624), (3549, 10724)];
