//! A second integrator, independent of the first: exact exponentials for a pressure that is linear in time over a step.
//!
//! v_j goes to e^{−z} v_j + J_j[(φ − e^{−z}) p_old + (1 − φ) p_new], z = h/τ_j, φ = (1 − e^{−z})/z: order two, one contact a step.
//! Dearer than the first below 1e-4; it serves as a check, with equal steps and two runs of which one has twice as many.

use super::book::Book;
use super::drive::Drive;
use super::mesh::Mesher;
use super::problem::{Accuracy, Problem};
use super::result::Run;
use super::state::State;
use super::step::Solver;
use crate::refusal::{Refusal, require_positive};

/// Meshes tried for one step.
const REMESHES: usize = 60;

impl Solver<'_> {
    /// One step; work by the trapezoid, the uptake of creep by the mean pressure.
    fn exponential_step(&mut self, from: &State, drive: &Drive, h: f64) -> Option<State> {
        let terms = self.chain.terms.clone();
        let means: Vec<(f64, f64)> = terms.iter().map(|&(_, tau)| ((-h / tau).exp(), -(-h / tau).exp_m1() * tau / h)).collect();
        let forced: Vec<Vec<f64>> = from
            .strains
            .iter()
            .zip(&terms)
            .zip(&means)
            .map(|((v, &(j, _)), &(decay, mean))| v.iter().zip(&from.p).map(|(v, p)| (decay * v + j * (mean - decay) * p) / mean).collect())
            .collect();
        // The form (a + zJp)/(1 + z) of an implicit stage, with 1/(1 + z) = φ.
        let z: Vec<f64> = means.iter().map(|&(_, mean)| (1.0 - mean) / mean).collect();
        let row = drive.row(from.time + h);
        let contact = self.contact(from, &forced, &z, row, None, (&from.u, from.penetration))?;
        let mut state = State {
            time: from.time + h,
            penetration: contact.penetration,
            force: contact.force,
            u: contact.u,
            p: contact.p,
            ..from.clone()
        };
        state.strains = forced;
        let mut state = self.strained(state, &z);
        let middle: Vec<f64> = state.p.iter().zip(&from.p).map(|(new, old)| 0.5 * (new + old)).collect();
        let mut image = vec![0.0; middle.len()];
        from.mesh.apply(&middle, &mut image);
        let crept = |i: usize| state.strains.iter().zip(&from.strains).map(|(new, old)| new[i] - old[i]).sum::<f64>();
        let viscous = self.coupling * from.mesh.integral(|i| crept(i) * image[i]);
        state.viscous += viscous;
        state.work += 0.5 * (state.force + from.force) * (state.penetration - from.penetration);
        Some(state)
    }
}

/// Runs a problem with this many equal steps in every piece between instants and ends of legs. `pieces` is at least 1. It cannot
/// continue beyond a fold.
///
/// # Errors
/// As [`run`](super::run); [`Refusal::OutOfRange`] for a leg without duration; [`Refusal::NotConverged`] where a step has no solution.
pub fn run_by_exponentials(problem: &Problem, accuracy: Accuracy, mesher: &mut Mesher, pieces: usize) -> Result<Run, Refusal> {
    let (mut solver, mut state, mut book) = Book::open(problem, accuracy, mesher)?;
    for leg in &problem.history {
        require_positive("duration", leg.motion.duration())?;
        let drive = Drive::new(*leg, &state);
        let end = state.time + leg.motion.duration();
        let mut stops: Vec<f64> = book.instants.iter().copied().filter(|&t| t > state.time && t < end).collect();
        stops.push(end);
        for stop in stops {
            let h = (stop - state.time) / pieces as f64;
            for piece in 0..pieces {
                let mut new = None;
                for _ in 0..REMESHES {
                    let trial = solver.exponential_step(&state, &drive, h).ok_or_else(|| Refusal::NotConverged {
                        what: "a step of the second integrator",
                        detail: format!("no solution at time {}", state.time + h),
                    })?;
                    let flags = solver.unresolved(&trial);
                    match solver.refined_if(&state, &flags) {
                        Some(finer) => state = finer,
                        None => {
                            new = Some(trial);
                            break;
                        }
                    }
                }
                let Some(mut new) = new else { continue };
                if piece + 1 == pieces {
                    new.time = stop;
                }
                book.row(&solver, &new)?;
                state = new;
            }
        }
    }
    Ok(book.close(&solver, None))
}
