//! A history of contact from a problem to numbers with errors: five marches or more, each tighter than the one before, until the errors meet the accuracy.

use super::checkpoint::{Checkpoint, Observer, Watch};
use super::convergence::{TIGHTER, WITNESSES};
use super::judgement::judged;
use super::marcher::{Guide, march_to};
use super::problem::IndentationProblem;
use super::solution::{IndentationSolution, IndentationWork, Trace};
use crate::material::Material;
use crate::refusal::Refusal;

/// Tolerance of the first march, over the accuracy.
const FIRST: f64 = 10.0;
/// The loosest first march.
const LOOSEST: f64 = 0.01;
/// Marches at least, unless the first two took all the work that is allowed.
const FEWEST_MARCHES: u32 = WITNESSES as u32 + 1;
/// Marches at most.
const MOST_MARCHES: u32 = 11;
/// Evaluations of the edge condition after which no tighter march is begun.
const MOST_EVALUATIONS: u64 = 200_000;
/// The same for each cycle of an oscillation.
const EVALUATIONS_OF_A_CYCLE: u64 = 2_000;
/// No march is tighter than this: rounding of the edge condition takes over.
const TIGHTEST: f64 = 1e-9;

/// Solves a history to its accuracy: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// Every refusal of [`march`](crate::indentation::march).
pub fn run(material: &Material, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    run_watched(material, problem, None, None)
}

/// The same, watched, and from a checkpoint of the same material and problem: the numbers are the same, to the last bit.
///
/// # Errors
/// Every refusal of [`march`](super::march); [`Refusal::Undefined`] for a checkpoint of something else.
pub fn run_watched(
    material: &Material,
    problem: &IndentationProblem,
    from: Option<Checkpoint>,
    watch: Option<&dyn Watch>,
) -> Result<IndentationSolution, Refusal> {
    problem.checked()?;
    let mut finished = 0;
    let mut tolerance = (FIRST * problem.accuracy).clamp(TIGHTEST, LOOSEST);
    // The last ones, the newest first.
    let mut coarser: Vec<Trace> = Vec::new();
    let mut work = IndentationWork::default();
    let mut under_way = None;
    if let Some(checkpoint) = from {
        let march;
        Checkpoint { finished, tolerance, coarser, work, march } = checkpoint;
        under_way = Some(march);
    }
    loop {
        let observer = watch.map(|watch| Observer { watch, finished, coarser: &coarser, work });
        // Stretches that were stationary early are as long for every tighter march.
        let stops = coarser.first().map_or(&[][..], |coarse| &coarse.shortened);
        let mut fine = march_to(material, problem, tolerance, stops, Guide { from: under_way.take(), observer })?;
        finished += 1;
        work.add(&fine.work);
        if finished > 1 {
            let most = MOST_EVALUATIONS + EVALUATIONS_OF_A_CYCLE * fine.cycles.last().map_or(0, |cycle| cycle.number);
            let last = finished > MOST_MARCHES || tolerance <= TIGHTEST || work.closure_evaluations > most;
            if last || finished >= FEWEST_MARCHES {
                let judged = judged(problem, &coarser, (tolerance, fine), work);
                if judged.reached || last {
                    return Ok(judged);
                }
                fine = judged.fine;
            }
        }
        coarser.insert(0, fine);
        coarser.truncate(WITNESSES);
        tolerance = (TIGHTER * tolerance).max(TIGHTEST);
    }
}

impl IndentationWork {
    fn add(&mut self, other: &Self) {
        self.steps += other.steps;
        self.closure_evaluations += other.closure_evaluations;
        self.history_updates += other.history_updates;
        self.most_panels = self.most_panels.max(other.most_panels);
    }
}
