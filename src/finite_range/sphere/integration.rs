//! Integration through the history: step control, mesh, events.

use super::book::Book;
use super::drive::Drive;
use super::mesh::Mesher;
use super::problem::{Accuracy, Control, Leg, Problem};
use super::result::{Jump, LANDED, LegSummary, Run};
use super::state::State;
use super::step::{SHIFTS, Solver};
use crate::refusal::Refusal;

/// Travel of the first step of a leg, in h₀, and its part of the duration where nothing travels.
const FIRST_TRAVEL: f64 = 1e-3;
const FIRST_PART: f64 = 1e-4;
/// Safety factor and largest growth of a step; growth for some steps after Newton's method failed.
const SAFETY: f64 = 0.85;
const GROWTH: f64 = 2.5;
const CAREFUL_GROWTH: f64 = 1.25;
const CAREFUL_STEPS: usize = 6;
/// Order of the method.
const ORDER: i32 = 4;
/// Without a solution at this part of the usual step, over the tolerance of a step, there is a fold (under force control: at a smaller one). What a
/// jump releases is wrong by that part, so that it must fall with the tolerance.
const FOLD_PER_ACCURACY: f64 = 0.1;
/// That part, at least and at most.
const FOLD: [f64; 2] = [1e-7, 1e-3];
const FOLD_OF_FORCE: f64 = 1e-7;
/// The first jump step over the step that failed at last.
const JUMP_STEP: f64 = 4.0;
/// Under force control the surfaces are lost to each other at this gap, in h₀.
const LOST: f64 = 30.0;
/// Meshes tried for one step.
const REMESHES: usize = 60;
/// Steps between attempts to coarsen.
const COARSEN_EVERY: usize = 3;

/// Runs a problem by the adaptive implicit method. The order of `mesher` is that of `accuracy`.
///
/// # Errors
/// [`Refusal`] for a number that is not allowed, a start or a landing that was not found, or an exhausted budget of steps.
pub fn run(problem: &Problem, accuracy: Accuracy, mesher: &mut Mesher) -> Result<Run, Refusal> {
    run_watched(problem, accuracy, mesher, &mut |_| {})
}

/// The same; `watch` is called after every step with the part of the history (0 to 1) that is done.
///
/// # Errors
/// As [`run`].
pub fn run_watched(problem: &Problem, accuracy: Accuracy, mesher: &mut Mesher, watch: &mut dyn FnMut(f64)) -> Result<Run, Refusal> {
    let (solver, state, book) = Book::open(problem, accuracy, mesher)?;
    let whole = problem.history.iter().map(|leg| leg.motion.duration()).sum();
    let mut integration = Integration { solver, state, book, watch, whole };
    for leg in &problem.history {
        if integration.whole_leg(leg)? {
            let detachment = integration.book.rows.last().copied();
            integration.book.losses.extend(detachment);
            return Ok(integration.book.close(&integration.solver, detachment));
        }
    }
    integration.book.keep_last(&integration.solver, &integration.state);
    Ok(integration.book.close(&integration.solver, None))
}

struct Integration<'m> {
    solver: Solver<'m>,
    state: State,
    book: Book,
    watch: &'m mut dyn FnMut(f64),
    /// How long the history is.
    whole: f64,
}

/// The states of a leg that the search for its events needs.
struct Window {
    before: Option<State>,
    best: State,
    zero: Option<State>,
}

impl Solver<'_> {
    /// Whether a contact ends between two states.
    fn parts(&self, old: &State, new: &State) -> bool {
        let open = |state: &State| state.open_at_axis(&self.mesher.quadrature.rule, &self.surface) > 0.0;
        !open(old) && open(new)
    }
}

impl Integration<'_> {
    /// One leg, in time or at once; true if contact ended under force control.
    fn whole_leg(&mut self, leg: &Leg) -> Result<bool, Refusal> {
        if leg.motion.duration() > 0.0 {
            return self.leg(leg);
        }
        let time = std::mem::replace(&mut self.state.time, 0.0);
        self.solver.frozen = Some(time);
        let ended = self.leg(leg);
        self.solver.frozen = None;
        self.state.time = time;
        ended
    }

    /// One leg; true if contact ended under force control.
    fn leg(&mut self, leg: &Leg) -> Result<bool, Refusal> {
        let drive = Drive::new(*leg, &self.state);
        let end = drive.begin + drive.motion.duration();
        let longest = drive.motion.longest_step(self.solver.accuracy.steps_of_a_cycle);
        self.state.rate = None;
        let mut window = Window { before: None, best: self.state.clone(), zero: None };
        let first = self.book.record(&self.solver, &self.state);
        // Steps that no tolerance shortens, with which a leg begins, differ between two runs all the same: else both would err alike.
        let finer = self.solver.accuracy.length_of_unbound_steps();
        let quickest = 1.0 + (GROWTH - 1.0) * finer;
        let (mut h, mut careful) = ((first_step(&drive, end) * finer.powi(ORDER)).min(longest), 0);
        let mut usual = h;
        let (mut remeshed, mut shifted, mut balanced) = (0, 0, false);
        let mut detached = false;
        let mut known = None;
        while self.state.time < end {
            self.solver.fine_enough(self.state.time)?;
            if self.book.attempts() >= self.solver.accuracy.budget {
                return Err(Refusal::NotConverged {
                    what: "the integration in time",
                    detail: format!("the budget of {} steps is used up at time {}", self.solver.accuracy.budget, self.state.time),
                });
            }
            let (step, next) = self.bounded(h, end);
            let trial = match self.solver.step_again(&self.state, &drive, step, known.take().as_ref()) {
                Some(trial) if trial.error <= 1.0 => Some(trial),
                Some(trial) => {
                    if trial.odd_beginning
                        && !std::mem::replace(&mut balanced, true)
                        && let Some(state) = self.solver.in_equilibrium(&self.state, &drive)
                    {
                        self.state = state;
                        continue;
                    }
                    self.book.rejected += 1;
                    h = step * (SAFETY * trial.error.powf(-0.25)).clamp(0.1, 0.9);
                    None
                }
                None => {
                    self.book.failed += 1;
                    if shifted < SHIFTS
                        && let Some(finer) = self.solver.refined_at_edge(&self.state)
                    {
                        (shifted, balanced) = (shifted + 1, false);
                        self.state = finer;
                        continue;
                    }
                    (h, careful, shifted) = (0.25 * step, CAREFUL_STEPS, 0);
                    None
                }
            };
            let Some(trial) = trial else {
                // However short, the step has no solution, or one far away.
                let part = (FOLD_PER_ACCURACY * self.solver.accuracy.step).clamp(FOLD[0], FOLD[1]);
                let fold = if leg.control == Control::Force { FOLD_OF_FORCE } else { part };
                if h < fold * usual || self.state.time + h <= self.state.time {
                    if !self.jump(&drive, JUMP_STEP * h, end, &mut window)? {
                        detached = true;
                        break;
                    }
                    (h, usual) = (JUMP_STEP * FOLD[1] * usual, 0.1 * usual);
                }
                continue;
            };
            let factor = SAFETY * trial.error.max(1e-8).powf(-0.25);
            let flags = self.solver.unresolved(&trial.state);
            if remeshed < REMESHES
                && flags.contains(&true)
                && let Some(finer) = self.solver.refined_if(&self.state, &flags)
            {
                (self.book.refined, remeshed, balanced) = (self.book.refined + 1, remeshed + 1, false);
                known = Some(trial.stages.carried(&self.state, &finer, self.solver.mesher, &self.solver.surface));
                self.state = finer;
                continue;
            }
            (remeshed, shifted, balanced) = (0, 0, false);
            let mut new = trial.state;
            new.time = next.unwrap_or(new.time);
            self.accepted(new, &drive, &mut window)?;
            let growth = if careful > 0 { CAREFUL_GROWTH.min(quickest) } else { quickest };
            careful = careful.saturating_sub(1);
            // A step cut short by an instant says nothing about the next one.
            h = (step * factor.min(growth)).max(if next.is_some() { h } else { 0.0 }).min(longest);
            usual = step.max(0.9 * usual);
        }
        let summary = LegSummary {
            begin: first,
            largest_tension: self.book.record(&self.solver, &window.best),
            zero_of_force: window.zero.as_ref().map(|state| self.book.record(&self.solver, state)),
            end: self.book.record(&self.solver, &self.state),
        };
        self.book.legs.push(summary);
        Ok(detached)
    }

    /// The next instant that is asked for, or the end of the leg.
    fn next_stop(&self, end: f64) -> f64 {
        let instants: &[f64] = if self.solver.frozen.is_some() { &[] } else { &self.book.instants };
        let next = instants.partition_point(|&t| t <= self.state.time * (1.0 + LANDED));
        instants.get(next).copied().filter(|&t| t < end).unwrap_or(end)
    }

    /// The step cut or stretched to the next instant or the end of the leg, and the time to land on.
    fn bounded(&self, h: f64, end: f64) -> (f64, Option<f64>) {
        let stop = self.next_stop(end);
        let left = stop - self.state.time;
        if h * 1.001 >= left {
            (left, Some(stop))
        } else if 2.0 * h > left {
            (0.5 * left, None)
        } else {
            (h, None)
        }
    }

    /// Books a step: row, events, coarser mesh.
    fn accepted(&mut self, new: State, drive: &Drive, window: &mut Window) -> Result<(), Refusal> {
        let old = std::mem::replace(&mut self.state, new);
        self.book.row(&self.solver, &self.state)?;
        (self.watch)(self.solver.frozen.unwrap_or(self.state.time) / self.whole.max(f64::MIN_POSITIVE));
        if drive.control == Control::Force && self.state.u.iter().all(|&u| self.solver.surface.gap(u) > LOST) {
            let reason = "the force goes to zero and the surfaces part without limit".to_owned();
            return Err(Refusal::NoSuchState { reason, limit_name: "time", limit: self.state.time });
        }
        if self.state.force < window.best.force {
            window.best = self.state.clone();
        }
        if let Some(before) = &window.before
            && old.force <= before.force
            && old.force < self.state.force
            && old.force < window.best.force + 0.02 * window.best.force.abs()
        {
            let found = self.solver.largest_tension([before, &old, &self.state], drive);
            if found.force < window.best.force {
                window.best = found;
            }
        }
        if self.solver.parts(&old, &self.state) {
            let lost = self.solver.open_axis(&old, &self.state, drive);
            let lost = self.book.record(&self.solver, &lost);
            self.book.losses.push(lost);
        }
        if old.force > 0.0 && self.state.force <= 0.0 {
            window.zero = Some(self.solver.zero_of_force(&old, &self.state, drive));
        }
        window.before = Some(old);
        if self.book.steps.is_multiple_of(COARSEN_EVERY)
            && let Some(coarser) = self.solver.coarsened(&self.state)
        {
            self.state = coarser;
        }
        Ok(())
    }

    /// Passes a fold; false if there is no equilibrium beyond it.
    fn jump(&mut self, drive: &Drive, h: f64, end: f64, window: &mut Window) -> Result<bool, Refusal> {
        let before = self.state.clone();
        let landing = self.solver.jump(&before, drive, h.max(1e-12 * before.time), self.next_stop(end), end);
        self.solver.fine_enough(before.time)?;
        let Some(landing) = landing else {
            if drive.control == Control::Force && drive.row(before.time).value < 0.0 {
                return Ok(false);
            }
            let detail = format!("no equilibrium was found beyond the fold at penetration {}, force {}", before.penetration, before.force);
            return Err(Refusal::NotConverged { what: "the landing of a jump", detail });
        };
        if !landing.jumped {
            self.accepted(landing.state, drive, window)?;
            return Ok(true);
        }
        self.state = landing.state;
        let row = self.book.record(&self.solver, &self.state);
        self.book.rows.push(row);
        self.book.keep_surface(&self.solver, &self.state);
        let from = self.book.record(&self.solver, &before);
        if from.contact_radius > 0.0 && row.contact_radius == 0.0 {
            self.book.losses.push(row);
        }
        self.book.jumps.push(Jump {
            time: row.time,
            radius_before: from.contact_radius,
            penetration: before.penetration,
            force_before: before.force,
            force_after: row.force,
            penetration_after: row.penetration,
            radius_after: row.contact_radius,
            released: landing.released,
        });
        if before.force > 0.0 && row.force <= 0.0 {
            window.zero = Some(self.state.clone());
        }
        if row.force < window.best.force {
            window.best = self.state.clone();
        }
        window.before = None;
        Ok(true)
    }
}

/// The first step of a leg.
fn first_step(drive: &Drive, end: f64) -> f64 {
    let (rate, duration) = (drive.rate(drive.begin).abs(), end - drive.begin);
    match drive.control {
        Control::Penetration | Control::Frame(_) if rate > 0.0 => (FIRST_TRAVEL / rate).min(0.1 * duration),
        _ => FIRST_PART * duration,
    }
}
