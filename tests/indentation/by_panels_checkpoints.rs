//! Source: the promise that a run killed at any instant loses nothing (README, "Runs that take long").
//!
//! Goal: a history that panels solve goes on from a checkpoint to the same numbers, whichever panel it was taken before.
//! Parameters: histories of every control, with energies, sudden steps, surfaces that touch again, cycles, a segment that ends when stationary; three panels of each,
//! drawn from the first sixty; a chain of checkpoints through all paths. Oracle: the run that was never stopped.
//! Tolerance: none, every number is compared bit by bit (events, cycles, path, bounds and work counters too); checkpoints go through bytes.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout, missing_docs)]

use crate::support::physics::Random;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use viscotack::indentation::by_panels::{solve_by_panels, solve_by_panels_watched};
use viscotack::indentation::{
    Adhesion, Checkpoint, Controlled, History, IndentationProblem, IndentationSolution, Oscillation, Profile, Segment, Watch, run,
    run_watched,
};
use viscotack::material::{PlaneMaterial, RelaxationTerm};

/// Counts panels, and takes a checkpoint before some of them.
struct Taker {
    wanted: Vec<u64>,
    asked: AtomicU64,
    taken: Mutex<Vec<Vec<u8>>>,
    parts: Mutex<Vec<(u32, f64)>>,
}

impl Taker {
    fn before(wanted: &[u64]) -> Self {
        Self { wanted: wanted.to_vec(), asked: AtomicU64::new(0), taken: Mutex::new(Vec::new()), parts: Mutex::new(Vec::new()) }
    }

    fn checkpoints(self) -> Vec<Checkpoint> {
        self.taken.into_inner().unwrap().iter().map(|bytes| postcard::from_bytes(bytes).unwrap()).collect()
    }
}

impl Watch for Taker {
    fn passed(&self, number: u32, part: f64) {
        self.parts.lock().unwrap().push((number, part));
    }

    fn wants_checkpoint(&self) -> bool {
        self.wanted.contains(&self.asked.fetch_add(1, Ordering::Relaxed))
    }

    fn checkpoint(&self, checkpoint: &Checkpoint) {
        self.taken.lock().unwrap().push(postcard::to_allocvec(checkpoint).unwrap());
    }
}

/// A checkpoint is taken before some of so many first panels, which every case has.
const FEWEST: f64 = 60.0;

fn material() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(2.0, &[term(3.0, 0.5), term(10.0, 0.02)]).unwrap()
}

fn problem(history: History) -> IndentationProblem {
    let adhesion = Some(Adhesion { work_of_adhesion: 3e-3, process_zone: 0.013 });
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history);
    IndentationProblem { instants_per_segment: 5, accuracy: 1e-3, ..problem }
}

fn cases() -> Vec<(&'static str, IndentationProblem)> {
    let approach = problem(History::penetration(0.0).ramp(0.03, 1.0).hold(0.5).ramp(-0.2, 2.0));
    let steps = problem(History::force(0.0).ramp(0.02, 1.0).step(0.01).ramp(0.03, 1.0).step(0.02).step(0.025).hold(0.1));
    let weak = Some(Adhesion { work_of_adhesion: 5e-4, process_zone: 0.013 });
    let frame = problem(History::frame(0.0).ramp(0.03, 1.0).ramp(-0.3, 2.0).ramp(0.02, 2.0));
    let frame = IndentationProblem { frame_stiffness: Some(0.7), adhesion: weak, ..frame };
    let again = problem(History::penetration(0.0).ramp(0.01, 0.5).ramp(-0.15, 0.5).ramp(0.02, 1.0));
    let cycles = problem(History::penetration(0.0).ramp(0.03, 1.0).oscillate(Oscillation::steady(0.004, 2.0), 3.0));
    let tapping = problem(History::penetration(0.0).oscillate(Oscillation::steady(0.1, 1.0), 2.0));
    let radius = problem(History::contact_radius(0.2).ramp(0.25, 1.0).step(0.24).hold(0.3)).relaxed();
    let swings = Oscillation { until_stationary: true, ..Oscillation::steady(0.002, 1.0) };
    let mut settles = History::penetration(0.02);
    settles.segments.push(Segment { duration: 40.0, end: 0.02, controlled: Controlled::Penetration, oscillation: Some(swings) });
    let settles = IndentationProblem { accuracy: 5e-2, ..problem(settles.ramp(0.0, 1.0)).relaxed() };
    vec![
        ("with energies", IndentationProblem { energies: true, ..approach.clone() }),
        ("approach, dwell, pull off", approach),
        ("sudden steps of the force", steps),
        ("a frame", frame),
        ("touched again", again),
        ("cycles", cycles),
        ("touched in every cycle", tapping),
        ("a given radius", radius),
        ("cycles until stationary", settles),
    ]
}

fn the_same(found: &IndentationSolution, whole: &IndentationSolution, name: &str) {
    // Debug prints doubles in full, NaN and signs of zero included.
    assert!(format!("{found:?}") == format!("{whole:?}"), "{name}: other numbers");
}

#[test]
fn a_run_goes_on_from_any_panel_to_the_same_bits() {
    let mut random = Random(20_261_126);
    for (name, problem) in cases() {
        let material = material();
        let drawn: Vec<u64> = (0..3).map(|_| random.between(0.0, FEWEST) as u64).collect();
        let taker = Taker::before(&drawn);
        let whole = solve_by_panels_watched(&material, &problem, None, Some(&taker)).unwrap();
        the_same(&solve_by_panels(&material, &problem).unwrap(), &whole, name);
        let panels = taker.asked.load(Ordering::Relaxed);
        // Reported in order, from path to path, and to the end of each.
        let parts = taker.parts.lock().unwrap().clone();
        assert!(parts.windows(2).all(|pair| pair[1].0 > pair[0].0 || pair[1].1 >= pair[0].1), "{name}: backwards");
        assert!(parts.iter().all(|(_, part)| (0.0..=1.0).contains(part)), "{name}: a part");
        assert!(parts.last().is_some_and(|(number, _)| *number >= 3), "{name}: {:?}", parts.last());
        let checkpoints = taker.checkpoints();
        assert!(!checkpoints.is_empty(), "{name}: {drawn:?} of {panels}");
        for (checkpoint, panel) in checkpoints.into_iter().zip(&drawn) {
            let resumed = solve_by_panels_watched(&material, &problem, Some(checkpoint), None).unwrap();
            the_same(&resumed, &whole, &format!("{name}, one of {drawn:?}, {panel}"));
        }
        println!("{name}: {panels} panels");
    }
}

#[test]
fn a_run_stopped_again_and_again_ends_in_the_same_bits() {
    let (name, problem) = cases().swap_remove(4);
    let material = material();
    let whole = solve_by_panels(&material, &problem).unwrap();
    let mut from: Option<Checkpoint> = None;
    let mut stops = 0;
    loop {
        // A run goes on for 17 panels more, and is stopped.
        let taker = Taker::before(&[17]);
        let solved = solve_by_panels_watched(&material, &problem, from.take(), Some(&taker)).unwrap();
        the_same(&solved, &whole, name);
        from = taker.checkpoints().pop();
        if from.is_none() {
            break;
        }
        stops += 1;
    }
    println!("stopped {stops} times");
    assert!(stops > 5);
}

#[test]
fn a_checkpoint_of_another_problem_is_refused() {
    let (_, problem) = cases().swap_remove(1);
    let taker = Taker::before(&[20]);
    solve_by_panels_watched(&material(), &problem, None, Some(&taker)).unwrap();
    let checkpoint = taker.checkpoints().pop().unwrap();
    let refusal = |material: &PlaneMaterial, problem: &IndentationProblem| {
        solve_by_panels_watched(material, problem, Some(checkpoint.clone()), None).unwrap_err().to_string()
    };
    let other = PlaneMaterial::from_relaxation(2.0, &[RelaxationTerm { modulus: 3.0, relaxation_time: 0.5 }]).unwrap();
    assert!(refusal(&other, &problem).contains("another problem"));
    let mut more = problem.clone();
    more.instants_per_segment = 7;
    assert!(refusal(&material(), &more).contains("other instants"));
    // One that time steps left.
    let taker = Taker::before(&[20]);
    run_watched(&material(), &problem, None, Some(&taker)).unwrap();
    let refused = solve_by_panels_watched(&material(), &problem, taker.checkpoints().pop(), None).unwrap_err().to_string();
    assert!(refused.contains("it was left by time steps"), "{refused}");
}

/// An elastic contact on a power law, which `run` gives to the panels: watched and resumed through `run_watched`.
#[test]
fn a_run_that_panels_solve_is_watched_and_resumed() {
    let elastic = PlaneMaterial::elastic(2.0).unwrap();
    let history = History::penetration(0.0).ramp(0.03, 1.0).ramp(0.01, 0.5).step(0.02).hold(0.2);
    let asked = IndentationProblem { profile: Profile::PowerLaw { coefficient: 2.0, exponent: 2.5 }, ..problem(history) };
    let whole = run(&elastic, &asked).unwrap();
    assert!(whole.by_panels);
    let taker = Taker::before(&[1, 10, 20]);
    run_watched(&elastic, &asked, None, Some(&taker)).unwrap();
    let checkpoints = taker.checkpoints();
    assert_eq!(checkpoints.len(), 3);
    for checkpoint in checkpoints {
        the_same(&run_watched(&elastic, &asked, Some(checkpoint), None).unwrap(), &whole, "an elastic contact");
    }
}
