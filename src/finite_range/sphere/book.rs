//! The record of a run while it is made.

use super::kept_surface::Surface;
use super::mesh::Mesher;
use super::newton::Row;
use super::problem::{Accuracy, Control, Motion, ON_TIME, Problem, Start};
use super::result::{Certificate, Jump, LANDED, LegSummary, Record, Run, SUM_OF_DURATIONS};
use super::state::{Energies, State};
use super::step::Solver;
use super::zero_range::ZeroRange;
use crate::refusal::Refusal;

/// The contact must stay within this part of the mesh.
const INSIDE: f64 = 0.9;

/// Rows, events and counts.
pub(super) struct Book {
    initial: Energies,
    pub(super) instants: Vec<f64>,
    pub(super) rows: Vec<Record>,
    pub(super) legs: Vec<LegSummary>,
    surfaces: Vec<Surface>,
    /// Times of surfaces still to come, the last first.
    wanted: Vec<f64>,
    pub(super) jumps: Vec<Jump>,
    pub(super) losses: Vec<Record>,
    pub(super) steps: usize,
    pub(super) rejected: usize,
    pub(super) failed: usize,
    pub(super) refined: usize,
    nodes: usize,
    largest: f64,
}

impl Book {
    /// Checks a problem and finds its first state.
    pub(super) fn open<'m>(problem: &Problem, accuracy: Accuracy, mesher: &'m mut Mesher) -> Result<(Solver<'m>, State, Self), Refusal> {
        problem.check()?;
        accuracy.check(mesher.order())?;
        let mut solver = Solver::new(problem, accuracy, mesher)?;
        let state = solver.start(problem, deepest(problem))?;
        let initial = state.energies(&solver.surface, &solver.chain, solver.coupling);
        let mut instants: Vec<f64> = problem.instants.iter().chain(&problem.surfaces).copied().collect();
        instants.sort_by(f64::total_cmp);
        instants = with_ends_of_cycles(problem, instants);
        let mut wanted = problem.surfaces.clone();
        wanted.sort_by(|a, b| b.total_cmp(a));
        let mut book = Self {
            initial,
            instants,
            rows: Vec::new(),
            legs: Vec::new(),
            surfaces: Vec::new(),
            wanted,
            jumps: Vec::new(),
            losses: Vec::new(),
            steps: 0,
            rejected: 0,
            failed: 0,
            refined: 0,
            nodes: 0,
            largest: 0.0,
        };
        book.rows.push(book.record(&solver, &state));
        book.keep_surface(&solver, &state);
        Ok((solver, state, book))
    }

    /// Attempted steps.
    pub(super) fn attempts(&self) -> usize {
        self.steps + self.rejected + self.failed + self.refined
    }

    /// A state as a row.
    pub(super) fn record(&self, solver: &Solver, state: &State) -> Record {
        let energies = state.energies(&solver.surface, &solver.chain, solver.coupling);
        let change = energies.instant - self.initial.instant + energies.interface - self.initial.interface;
        Record {
            time: solver.frozen.unwrap_or(state.time),
            penetration: state.penetration,
            force: state.force,
            contact_radius: state.radius_at_gap(solver.surface.peak_gap(), &solver.mesher.quadrature.rule, &solver.surface),
            tension_radius: state.tension_radius(),
            energies,
            work: state.work,
            dissipated: state.viscous - (energies.delayed - self.initial.delayed),
            released: state.released,
            residual: state.work - change - state.viscous - state.released,
        }
    }

    /// Books an accepted step.
    pub(super) fn row(&mut self, solver: &Solver, state: &State) -> Result<(), Refusal> {
        self.steps += 1;
        self.nodes = self.nodes.max(state.mesh.nodes());
        let row = self.record(solver, state);
        if !row.residual.is_finite() || row.contact_radius > INSIDE * state.mesh.radius() && !solver.surface.ends_at(state.mesh.radius()) {
            return Err(Refusal::out_of_range("contact radius", row.contact_radius, "well inside the mesh"));
        }
        if let Some(end) = solver.surface.known_to()
            && row.contact_radius > end
        {
            return Err(Refusal::NoSuchState {
                reason: format!("the contact reaches out to {:e}, where the table has no shape", row.contact_radius),
                limit_name: "the radius of its last point",
                limit: end,
            });
        }
        self.rows.push(row);
        self.keep_surface(solver, state);
        let energies = [row.work, row.energies.instant, row.energies.delayed];
        self.largest = energies.iter().fold(self.largest, |most, e| most.max(e.abs()));
        Ok(())
    }

    /// Keeps the surface of a state, if it is wanted at its time.
    pub(super) fn keep_surface(&mut self, solver: &Solver, state: &State) {
        let time = solver.frozen.unwrap_or(state.time);
        while let Some(&wanted) = self.wanted.last()
            && wanted <= time * (1.0 + LANDED)
        {
            self.wanted.pop();
            self.surfaces.push(Surface::of(
                state,
                wanted,
                self.rows.len().saturating_sub(1),
                &solver.mesher.quadrature.rule,
                &solver.surface,
            ));
        }
    }

    /// Keeps the last state as the surface of times that only the rounding of sums of durations puts behind the end.
    pub(super) fn keep_last(&mut self, solver: &Solver, state: &State) {
        while let Some(wanted) = self.wanted.pop_if(|wanted| *wanted <= state.time * (1.0 + SUM_OF_DURATIONS)) {
            self.surfaces.push(Surface::of(
                state,
                wanted,
                self.rows.len().saturating_sub(1),
                &solver.mesher.quadrature.rule,
                &solver.surface,
            ));
        }
    }

    /// The finished run.
    pub(super) fn close(self, solver: &Solver, detachment: Option<Record>) -> Run {
        let certificate = Certificate {
            energy_residual: self.rows.iter().fold(0.0_f64, |most, row| most.max(row.residual.abs())),
            energy_scale: self.largest,
            nodes: self.nodes,
            steps: self.steps,
            rejected: self.rejected,
            failed: self.failed,
            refined: self.refined,
            factorisations: solver.newton.factorisations,
            iterations: solver.newton.iterations,
            newton_residual: solver.newton.last_correction,
            accuracy: solver.accuracy,
        };
        Run { rows: self.rows, legs: self.legs, surfaces: self.surfaces, jumps: self.jumps, losses: self.losses, detachment, certificate }
    }
}

/// Instants with the ends of cycles, on which steps end as well; an end that is an instant but for rounding is that instant.
fn with_ends_of_cycles(problem: &Problem, mut instants: Vec<f64>) -> Vec<f64> {
    let (mut begin, mut ends) = (0.0, Vec::new());
    for leg in &problem.history {
        let mut before = begin;
        for end in leg.motion.ends_of_cycles(begin) {
            let after = instants.partition_point(|instant| *instant < end);
            let near = [after.checked_sub(1), Some(after)].into_iter().flatten().filter_map(|place| instants.get(place));
            if near.into_iter().all(|instant| (instant - end).abs() > ON_TIME * (end - before)) {
                ends.push(end);
            }
            before = end;
        }
        begin += leg.motion.duration();
    }
    instants.append(&mut ends);
    instants.sort_by(f64::total_cmp);
    instants
}

/// An upper estimate of the penetrations of the history.
fn deepest(problem: &Problem) -> f64 {
    let contact = ZeroRange::of(problem, 1.0);
    let of_force = |value: f64| contact.depth(Row { penetration: 0.0, force: 1.0, value: value.max(0.0) });
    let mut now = match problem.start {
        Start::Relaxed(depth) | Start::Unstrained(depth) => depth,
        Start::Held { control: Control::Force, value, .. } => of_force(value),
        Start::Held { value, .. } => value,
    };
    let mut most = now;
    for leg in &problem.history {
        let value = match leg.motion {
            Motion::Ramp { to, .. } => to,
            Motion::Hold(_) => continue,
            Motion::Oscillation { amplitude, .. } => amplitude.abs(),
            Motion::Swing { to, oscillation, .. } => to + oscillation.amplitude - oscillation.offset(),
        };
        let depth = if leg.control == Control::Force { of_force(value) } else { value };
        now = if matches!(leg.motion, Motion::Oscillation { .. }) { most + depth } else { depth };
        most = most.max(now);
    }
    most
}
