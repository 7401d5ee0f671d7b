//! One state on one grid: semi-smooth Newton with an active set (Hintermüller, Ito & Kunisch, 2002).
//!
//! Each step solves the equations with the law linearised and the contact set held, then moves the set: a node is in contact where
//! the contact pressure, taken as a length, exceeds the gap over the wall.
//!
//! Where a state has ceased to exist Newton's steps wander about the place where it was. [`relax`] adds a damping that falls with the residual
//! (pseudo-transient continuation; Kelley & Keyes, 1998): the gap then moves on to the next state that stays.

use super::gmres;
use super::grid::{Equations, State};

/// Vectors that the linear solver keeps.
const RESTART: usize = 80;
/// Residual of the pressure (reduced unit plus the largest tension) at which a state of the answer is accepted.
pub(super) const FINE: f64 = 1e-12;
/// The same for a state that only leads to another one.
pub(super) const COARSE: f64 = 1e-7;
/// Most Newton steps: an edge on a fine grid may move by one node a step.
const STEPS: usize = 120;
/// The same of a damped motion to an answer: its edges move slowly.
const DAMPED_STEPS: usize = 400;
/// Steps over which the residual must fall.
const PATIENCE: usize = 4;
/// One more Newton step builds its Krylov space anew: it costs about as many products as three digits.
const A_STEP_MORE: f64 = 1e3;
/// Most halvings of one step.
const HALVINGS: usize = 6;
/// Steps without a wall within which the least residual must halve.
const WANDERING: usize = 20;

/// What a solve took and reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Report {
    /// Newton steps.
    pub(super) steps: usize,
    /// Products with the matrix.
    pub(super) products: usize,
    /// Largest residual of the pressure off contact and of the control.
    pub(super) residual: f64,
    /// Root of the mean square of that residual.
    pub(super) mean_residual: f64,
    /// The least contact pressure (zero or more up to the residual).
    pub(super) least_contact_pressure: f64,
}

/// Why a solve ended without a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stalled {
    /// Newton steps.
    pub(super) steps: usize,
    /// The residual at the end.
    pub(super) residual: f64,
}

/// Moves `state` to a solution near it.
/// Ends when the residual falls below `accepted` or rounding, or the budget of products is spent.
pub(super) fn solve(equations: &mut Equations, state: &mut State, accepted: f64, budget: usize) -> Result<Report, Stalled> {
    descend(equations, state, accepted, budget, false)
}

/// Moves `state` along a damped motion to a solution that may lie far from it.
pub(super) fn relax(equations: &mut Equations, state: &mut State, accepted: f64, budget: usize) -> Result<Report, Stalled> {
    descend(equations, state, accepted, budget, true)
}

fn descend(equations: &mut Equations, state: &mut State, accepted: f64, budget: usize, damped: bool) -> Result<Report, Stalled> {
    let n = equations.len();
    let wall = equations.wall();
    let has_wall = wall.is_finite();
    let peak = equations.law.peak_stress();
    let singular = !equations.law.stress(0.0).is_finite();
    let height = equations.heights.iter().fold(0.0_f64, |m, h| m.max(h.abs()));
    // Rounding of the transforms: the stiffest wave multiplies the last digit of the heights.
    let tolerance = accepted * (1.0 + peak) + 8.0 * f64::EPSILON * equations.stiffest * height;
    let first = equations.products;
    let (mut pressure, mut rhs, mut step) = (vec![0.0; n], vec![0.0; n + 1], vec![0.0; n + 1]);
    equations.pressure(state, &mut pressure);
    let mut vectors = gmres::Vectors::default();
    let mut residual = f64::INFINITY;
    let mut recent: Vec<f64> = Vec::new();
    let least_of = |norms: &[f64]| norms.iter().copied().fold(f64::INFINITY, f64::min);
    let most = if damped && accepted <= FINE { DAMPED_STEPS } else { STEPS };
    for steps in 0..=most {
        let mut changed = false;
        if has_wall {
            changed = move_contact(equations, state, &pressure, steps == 0);
            if changed {
                equations.pressure(state, &mut pressure);
            }
        }
        let mut least = f64::INFINITY;
        residual = 0.0;
        for i in 0..n {
            let stress = equations.stress(state.gap[i]);
            let lack = stress - pressure[i];
            rhs[i] = if state.contact[i] { 0.0 } else { lack };
            if state.contact[i] {
                least = least.min(-lack);
            } else {
                residual = residual.max(lack.abs());
            }
        }
        let control = equations.control_residual(state);
        residual = residual.max(control.abs());
        if !residual.is_finite() {
            break;
        }
        // The set repeats when no node of it pulls and none outside it has crossed the wall.
        let set_holds = !changed || least >= -tolerance;
        if residual < tolerance && set_holds && least >= -tolerance {
            let least_contact_pressure = if least.is_finite() { least } else { 0.0 };
            let square = norm(&rhs[..n]).powi(2) / n as f64 + control * control;
            let products = equations.products - first;
            return Ok(Report { steps, products, residual, mean_residual: square.sqrt(), least_contact_pressure });
        }
        let spent = equations.products - first;
        let (before, latest) = recent.split_at(recent.len().saturating_sub(WANDERING));
        let wanders = !has_wall && !damped && !before.is_empty() && least_of(latest) > 0.5 * least_of(before);
        if steps == most || spent >= budget || wanders {
            break;
        }
        rhs[n] = control * (n as f64).sqrt();
        recent.push(norm(&rhs[..n]));
        equations.linearise(state);
        if damped {
            let start = recent.first().copied().unwrap_or(1.0);
            equations.damp(equations.law.steepest_slope() * (norm(&rhs[..n]) / start).min(1.0));
        }
        step.fill(0.0);
        // No more digits than the next step can keep, and none beyond what is accepted; all of these where the contact set of
        // an answer rests and one step more would cost more than they do.
        let (kept, enough) = (0.1 * residual / (1.0 + peak), 0.1 * tolerance / residual);
        let accuracy = if accepted <= FINE && !changed && kept < A_STEP_MORE * enough { enough } else { kept }.clamp(1e-10, 1e-3);
        gmres::solve(equations, &mut vectors, &rhs, &mut step, accuracy, RESTART, budget - spent);
        let mut length = 1.0_f64;
        if singular {
            // A gap may at most halve: the repulsion of the law grows by orders of magnitude there.
            for (g, d) in state.gap.iter().zip(&step) {
                if *g > 0.0 && *d < -0.5 * g {
                    length = length.min(-0.5 * g / d);
                }
            }
        }
        // Without a wall the law bends within one step: the step is halved until the residual falls. With a wall the set takes that part.
        // It may rise for a while: a residual that may only fall gets caught between two edges that must move together.
        let start = recent.iter().rev().take(PATIENCE).fold(0.0_f64, |m, r| m.max(*r));
        for attempt in 0..=HALVINGS {
            state.gap.iter_mut().zip(&step).for_each(|(g, d)| *g += length * d);
            state.mean_pressure += length * step[n] * (n as f64).sqrt();
            equations.pressure(state, &mut pressure);
            if has_wall || damped || attempt == HALVINGS {
                break;
            }
            let lack: f64 = state.gap.iter().zip(&pressure).map(|(g, p)| (equations.law.stress(*g) - p).powi(2)).sum();
            if lack.sqrt() < start || start < tolerance {
                break;
            }
            state.gap.iter_mut().zip(&step).for_each(|(g, d)| *g -= length * d);
            state.mean_pressure -= length * step[n] * (n as f64).sqrt();
            length *= 0.5;
        }
    }
    Err(Stalled { steps: most, residual })
}

/// Moves the contact set and puts its nodes on the wall; whether anything changed. On the first pass the set is the given one, except
/// for nodes beyond the wall.
fn move_contact(equations: &Equations, state: &mut State, pressure: &[f64], first: bool) -> bool {
    let (wall, nx) = (equations.wall(), equations.grid.nx());
    let (n, wall_stress) = (equations.len(), equations.law.stress(equations.wall()));
    let length_per_pressure = 4.0 / equations.stiffest;
    let wanted: Vec<bool> = (0..n)
        .map(|i| {
            let g = state.gap[i];
            if first {
                return state.contact[i] || g < wall;
            }
            let stress = if state.contact[i] { wall_stress } else { equations.law.stress(g.max(wall)) };
            length_per_pressure * (pressure[i] - stress) > g - wall
        })
        .collect();
    let held = |i: usize| state.contact[i] && wanted[i];
    // A single node inside the contact that pulls is an overshoot of the edge's last move: released, the hole would travel on
    // through the contact. It is released only when nothing else moves.
    let lonely = |i: usize| {
        let row = i / nx * nx;
        let along = held(row + (i + 1 - row) % nx) && held(row + (i + nx - 1 - row) % nx);
        along && (n == nx || (held((i + nx) % n) && held((i + n - nx) % n)))
    };
    let leaves: Vec<usize> = (0..n).filter(|&i| state.contact[i] && !wanted[i]).collect();
    let enters: Vec<usize> = (0..n).filter(|&i| !state.contact[i] && wanted[i]).collect();
    let together: Vec<usize> = leaves.iter().copied().filter(|&i| !lonely(i)).collect();
    let released = if together.is_empty() && enters.is_empty() { leaves } else { together };
    let mut changed = !released.is_empty() || !enters.is_empty();
    released.into_iter().for_each(|i| state.contact[i] = false);
    enters.into_iter().for_each(|i| state.contact[i] = true);
    for (gap, contact) in state.gap.iter_mut().zip(&state.contact) {
        if *contact && (*gap - wall).abs() > 0.0 {
            *gap = wall;
            changed = true;
        }
    }
    changed
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum::<f64>().sqrt()
}
