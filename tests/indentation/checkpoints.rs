//! Source: the promise that a run killed at any instant loses nothing (README, "Runs that take long").
//!
//! Goal: a run that goes on from a checkpoint ends in the same numbers, whichever step it was taken after, whatever the history does there.
//! Parameters: histories of every control, with energies, frames, turns, touching again, cycles, segments that end when stationary; three to eight steps of each,
//! drawn from all steps of all integrations; a chain of checkpoints, each run taking over from the one before. Oracle: the run that was never stopped.
//! Tolerance: none, every number is compared bit by bit (events, cycles, path, errors and work counters too); checkpoints go through bytes.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use physics::Random;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use viscotack::closure::work_by_speed::{WorkAtSpeed, WorkBySpeed};
use viscotack::indentation::{
    Adhesion, Checkpoint, Controlled, EdgeLaw, History, IndentationProblem, IndentationSolution, Oscillation, Profile, Segment, Start,
    Watch, run, run_watched,
};
use viscotack::material::{PlaneMaterial, RelaxationTerm};

/// Counts steps, and takes a checkpoint after one of them.
struct Taker {
    wanted: u64,
    asked: AtomicU64,
    taken: Mutex<Option<Vec<u8>>>,
    parts: Mutex<Vec<(u32, f64)>>,
}

impl Taker {
    fn after(wanted: u64) -> Self {
        Self { wanted, asked: AtomicU64::new(0), taken: Mutex::new(None), parts: Mutex::new(Vec::new()) }
    }
}

impl Watch for Taker {
    fn passed(&self, number: u32, part: f64) {
        self.parts.lock().unwrap().push((number, part));
    }

    fn wants_checkpoint(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) == self.wanted
    }

    fn checkpoint(&self, checkpoint: &Checkpoint) {
        *self.taken.lock().unwrap() = Some(postcard::to_allocvec(checkpoint).unwrap());
    }
}

fn material() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(2.0, &[term(3.0, 0.5), term(10.0, 0.02)]).unwrap()
}

fn problem(controlled: Controlled, start: f64, segments: Vec<Segment>) -> IndentationProblem {
    IndentationProblem {
        profile: Profile::Paraboloid { radius: 1.0 },
        adhesion: Some(Adhesion { work_of_adhesion: 3e-3, process_zone: 0.013 }),
        edge_law: EdgeLaw::CONSTANT,
        history: History { start, controlled, segments },
        frame_stiffness: None,
        start: Start::Untouched,
        instants_per_segment: 5,
        energies: false,
        accuracy: 1e-3,
    }
}

fn cases() -> Vec<(&'static str, IndentationProblem)> {
    let ramp = |controlled, end, duration| Segment { duration, end, controlled, oscillation: None };
    let depth = Controlled::Penetration;
    let force = Controlled::Force;
    let swings = |controlled, end, amplitude, frequency, duration, until_stationary| Segment {
        duration,
        end,
        controlled,
        oscillation: Some(Oscillation { until_stationary, ..Oscillation::steady(amplitude, frequency) }),
    };
    let approach = problem(depth, 0.0, vec![ramp(depth, 0.03, 1.0), ramp(depth, 0.03, 0.5), ramp(depth, -0.2, 2.0)]);
    let energies = IndentationProblem { energies: true, ..approach.clone() };
    let pressed =
        problem(force, 0.0, vec![ramp(force, 0.02, 1.0), ramp(force, -0.01, 1.0), ramp(force, 0.01, 0.0), ramp(force, 0.03, 1.0)]);
    let frame = IndentationProblem {
        frame_stiffness: Some(0.7),
        ..problem(Controlled::Frame, 0.0, vec![ramp(Controlled::Frame, 0.05, 1.0), ramp(Controlled::Frame, -0.2, 3.0)])
    };
    let again = problem(depth, 0.0, vec![ramp(depth, 0.01, 0.5), ramp(depth, -0.15, 0.5), ramp(depth, 0.02, 1.0)]);
    let cycles = problem(depth, 0.0, vec![ramp(depth, 0.03, 1.0), swings(depth, 0.03, 0.004, 2.0, 3.0, false)]);
    let settled = IndentationProblem {
        start: Start::Relaxed,
        accuracy: 5e-2,
        ..problem(force, 0.02, vec![swings(force, 0.02, 0.002, 1.0, 40.0, true), ramp(force, 0.0, 1.0)])
    };
    let rim = IndentationProblem {
        profile: Profile::FlatPunch { radius: 0.3 },
        start: Start::Relaxed,
        edge_law: EdgeLaw { growing_zone: true, ..EdgeLaw::CONSTANT },
        ..problem(depth, 0.02, vec![ramp(depth, -0.03, 0.2), ramp(depth, 0.04, 0.1), ramp(depth, -0.3, 3.0)])
    };
    let two_works = IndentationProblem { edge_law: EdgeLaw { leading_ratio: 0.3, ..EdgeLaw::CONSTANT }, ..approach.clone() };
    let entry = |speed: f64, trailing: f64, leading: f64| WorkAtSpeed { speed, trailing, leading };
    let by_speed = WorkBySpeed::table(&[entry(1e-3, 1.0, 1.0), entry(1.0, 4.0, 0.5)]).unwrap();
    let by_speed = IndentationProblem { edge_law: EdgeLaw { by_speed: Some(by_speed), ..EdgeLaw::CONSTANT }, ..approach.clone() };
    vec![
        ("the rim of a punch", rim),
        ("two works of adhesion", two_works),
        ("works by the speed of the edge", by_speed),
        ("approach, dwell, pull off", approach),
        ("with energies", energies),
        ("forces, one at once", pressed),
        ("a frame", frame),
        ("touched again", again),
        ("cycles", cycles),
        ("cycles until stationary", settled),
    ]
}

fn the_same(found: &IndentationSolution, whole: &IndentationSolution, name: &str) {
    // Debug prints doubles in full, NaN and signs of zero included.
    assert!(format!("{found:?}") == format!("{whole:?}"), "{name}: other numbers");
}

#[test]
fn a_run_goes_on_from_any_step_to_the_same_bits() {
    let mut random = Random(20_261_122);
    for (name, problem) in cases() {
        let material = material();
        let counter = Taker::after(u64::MAX);
        let whole = run_watched(&material, &problem, None, Some(&counter)).unwrap();
        the_same(&run(&material, &problem).unwrap(), &whole, name);
        let steps = counter.asked.load(Ordering::Relaxed);
        // Reported in order, from integration to integration, and to the end of each.
        let parts = counter.parts.into_inner().unwrap();
        assert!(parts.windows(2).all(|pair| pair[1].0 > pair[0].0 || pair[1].1 >= pair[0].1), "{name}: backwards");
        assert!(parts.iter().all(|(_, part)| (0.0..=1.0).contains(part)), "{name}: a part");
        assert!(parts.last().is_some_and(|(_, part)| *part > 0.8), "{name}: {:?}", parts.last());
        // A run of many steps is shown by fewer of them.
        let draws = if steps < 1000 { 8 } else { 3 };
        for _ in 0..draws {
            let step = random.between(0.0, steps as f64) as u64;
            let taker = Taker::after(step.min(steps - 1));
            run_watched(&material, &problem, None, Some(&taker)).unwrap();
            let bytes = taker.taken.into_inner().unwrap().unwrap();
            let checkpoint: Checkpoint = postcard::from_bytes(&bytes).unwrap();
            let resumed = run_watched(&material, &problem, Some(checkpoint), None).unwrap();
            the_same(&resumed, &whole, &format!("{name}, step {step} of {steps}"));
        }
        println!("{name}: {steps} steps");
    }
}

#[test]
fn a_run_stopped_again_and_again_ends_in_the_same_bits() {
    let (name, problem) = cases().swap_remove(6);
    let material = material();
    let whole = run(&material, &problem).unwrap();
    let mut from: Option<Checkpoint> = None;
    let mut stops = 0;
    loop {
        // A run goes on for 37 steps more, and is stopped.
        let taker = Taker::after(37);
        let solved = run_watched(&material, &problem, from.take(), Some(&taker)).unwrap();
        the_same(&solved, &whole, name);
        match taker.taken.into_inner().unwrap() {
            Some(bytes) => from = Some(postcard::from_bytes(&bytes).unwrap()),
            None => break,
        }
        stops += 1;
    }
    println!("stopped {stops} times");
    assert!(stops > 5);
}

#[test]
fn a_checkpoint_of_another_problem_is_refused() {
    let (_, problem) = cases().swap_remove(0);
    let taker = Taker::after(20);
    run_watched(&material(), &problem, None, Some(&taker)).unwrap();
    let bytes = taker.taken.into_inner().unwrap().unwrap();
    let checkpoint = || -> Checkpoint { postcard::from_bytes(&bytes).unwrap() };
    let other = PlaneMaterial::from_relaxation(2.0, &[RelaxationTerm { modulus: 3.0, relaxation_time: 0.5 }]).unwrap();
    let refusal = run_watched(&other, &problem, Some(checkpoint()), None).unwrap_err().to_string();
    assert!(refusal.contains("another problem"), "{refusal}");
    let mut shorter = problem;
    shorter.history.segments.clear();
    assert!(run_watched(&material(), &shorter, Some(checkpoint()), None).is_err());
}
