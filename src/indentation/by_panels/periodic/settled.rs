//! The periodic path of one degree and tolerance.

use super::super::problem::Outcome;
use super::anderson::{WINDOW, amplification, weights};
use super::closed_path::ClosedPath;
use super::cycle_map::{CycleMap, Integrated, not_converged};
use crate::indentation::IndentationWork;
use crate::refusal::Refusal;

/// Phases at which residuals count.
const PHASES: usize = 64;
/// Residual at which a path is periodic, over the tolerance as a length: panels scatter by a tenth of it.
const ENOUGH: f64 = 0.3;
/// Cycles after which no better path comes, and of all.
const NO_BETTER: usize = 4;
const MOST_CYCLES: usize = 40;
/// A residual so much larger than the best one begins anew from the best one.
const WORSE: f64 = 3.0;
/// Part of the tolerance that the series of a path may miss.
const SERIES: f64 = 1e-2;

/// A path that gives itself, as far as it does.
pub(super) struct Settled {
    pub(super) path: ClosedPath,
    /// The largest change of the radius over a cycle (m), and how much farther the periodic path may be.
    pub(super) change: f64,
    pub(super) amplification: f64,
    pub(super) cycles: u32,
}

/// Closed paths, where they led, and by how much that differs.
#[derive(Default)]
struct Tried {
    given: Vec<Vec<f64>>,
    led: Vec<ClosedPath>,
    residuals: Vec<Vec<f64>>,
}

impl Tried {
    fn largest(&self, k: usize) -> f64 {
        self.residuals[k].iter().fold(0.0, |most: f64, r| most.max(r.abs()))
    }
}

/// Finds it, from a path near it if there is one.
pub(super) fn settled(map: &CycleMap<'_>, near: Option<&ClosedPath>, work: &mut IndentationWork) -> Result<Settled, Refusal> {
    let tolerance = map.problem.tolerance * map.length();
    let series = SERIES * tolerance;
    let mut cycles = 0;
    let mut cycle = |path: Option<&ClosedPath>| -> Result<ClosedPath, Refusal> {
        cycles += 1;
        let Integrated { trail, outcome } = map.integrated(path)?;
        add(work, &outcome);
        let path = ClosedPath::of_trail(map.edge, map.period, &trail, 0.0, series);
        let backwards = path.backwards();
        if backwards > tolerance {
            return Err(Refusal::Undefined {
                quantity: "the periodic state of an edge that turns more than twice a cycle",
                reason: format!("it goes back by {backwards:e} m on its way; integrate the cycles"),
            });
        }
        Ok(path)
    };
    let mut path = match near {
        Some(path) => path.clone(),
        None => cycle(None)?,
    };
    let phases = |path: &ClosedPath| -> Vec<f64> { (0..PHASES).map(|k| path.way(map.period * k as f64 / PHASES as f64)).collect() };
    let mut tried = Tried::default();
    let mut best = 0;
    let mut since = 0;
    let mut failed: Option<Refusal> = None;
    for _ in 0..MOST_CYCLES {
        let led = match cycle(Some(&path)) {
            Ok(led) => led,
            // A mixed path may lead nowhere where a plain one does not.
            Err(refusal) if tried.led.len() > 1 && failed.is_none() => {
                path = tried.led[best].clone();
                tried = only(tried, best);
                best = 0;
                failed = Some(refusal);
                continue;
            }
            Err(refusal) => return Err(refusal),
        };
        let (given, reached) = (phases(&path), phases(&led));
        tried.residuals.push(reached.iter().zip(&given).map(|(to, from)| to - from).collect());
        tried.given.push(given);
        tried.led.push(led);
        let now = tried.led.len() - 1;
        let size = tried.largest(now);
        if size <= tried.largest(best) {
            since = if size < 0.7 * tried.largest(best) || now == 0 { 0 } else { since + 1 };
            best = now;
        } else {
            since += 1;
        }
        if size <= ENOUGH * tolerance || since >= NO_BETTER {
            break;
        }
        if size > WORSE * tried.largest(best) {
            path = tried.led[best].clone();
            tried = only(tried, best);
            best = 0;
            continue;
        }
        let window: Vec<&[f64]> = tried.residuals.iter().map(Vec::as_slice).collect();
        let weights = weights(&window);
        let mixed: Vec<(f64, &ClosedPath)> = weights.iter().copied().zip(&tried.led).filter(|(weight, _)| *weight != 0.0).collect();
        path = ClosedPath::mixed(&mixed, series).ok_or_else(|| not_converged("no path".into()))?;
        let spare = tried.led.len().saturating_sub(WINDOW + 1);
        if spare > 0 && best >= spare {
            for _ in 0..spare {
                tried.given.remove(0);
                tried.led.remove(0);
                tried.residuals.remove(0);
            }
            best -= spare;
        }
    }
    let change = tried.largest(best);
    let amplification = amplification(&tried.given, &tried.residuals);
    let path = tried.led.get(best).cloned().ok_or_else(|| not_converged("no path".into()))?;
    Ok(Settled { path, change, amplification, cycles })
}

fn only(mut tried: Tried, best: usize) -> Tried {
    Tried {
        given: vec![tried.given.swap_remove(best)],
        led: vec![tried.led.swap_remove(best)],
        residuals: vec![tried.residuals.swap_remove(best)],
    }
}

pub(super) fn add(work: &mut IndentationWork, outcome: &Outcome) {
    work.add(&IndentationWork {
        steps: outcome.panels + outcome.refused,
        closure_evaluations: outcome.closures,
        history_updates: outcome.kernel_nodes,
        most_panels: outcome.most_segments as u64,
    });
}
