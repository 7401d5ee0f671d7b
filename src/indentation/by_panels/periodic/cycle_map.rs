//! One cycle of the contact, or two, from the line of a closed path, by the panels of this room.

use super::super::events::Mark;
use super::super::integration::Integration;
use super::super::line::Line;
use super::super::problem::{End, Outcome, Problem};
use super::super::start::breaks;
use super::super::trail::Trail;
use super::closed_chains::ClosedChains;
use super::closed_path::ClosedPath;
use super::sinus::Sinus;
use crate::refusal::Refusal;

/// Part of the tolerance that the states of a closed path may miss of ΣX, as old segments that are joined may.
const STATES: f64 = 1e-2;
/// Panels of a cycle, accepted or not.
const MOST_PANELS: u64 = 5_000;

/// What is integrated; its history is the oscillation, for as long as is asked.
pub(super) struct CycleMap<'a> {
    pub(super) problem: &'a Problem,
    pub(super) sinus: Sinus,
    pub(super) period: f64,
    /// Of the relaxed contact at the mean.
    pub(super) edge: f64,
}

/// What a cycle gives.
pub(super) struct Integrated {
    pub(super) trail: Trail,
    pub(super) outcome: Outcome,
}

impl CycleMap<'_> {
    /// √(δa), or a: the length of which tolerances are a part.
    pub(super) fn length(&self) -> f64 {
        if self.problem.adhesion.is_some() { (self.problem.zone * self.edge).sqrt() } else { self.edge }
    }

    /// The relaxed contact at the mean.
    fn at_rest(&self) -> (Line, Vec<Mark>) {
        (Line::new(self.edge, &breaks(&self.problem.profile, self.edge)), vec![Mark { place: 0.0, jump: true }])
    }

    /// The line of a closed path.
    fn of(&self, path: &ClosedPath) -> Option<(Line, Vec<Mark>)> {
        let problem = self.problem;
        let displacement = problem
            .adhesion
            .map_or_else(|| problem.profile.line(self.edge), |adhesion| (adhesion * self.edge / problem.chain.glassy).sqrt());
        let error = STATES * problem.tolerance * displacement;
        let (chain, profile, sinus) = (&problem.chain, &problem.profile, self.sinus);
        let samples = problem.degree + 5;
        let zone = problem.zone;
        let closed = ClosedChains { chain, profile, sinus, path, zone, samples, errors: [error, error * chain.glassy] };
        let line = closed.line(|edge| breaks(profile, edge))?;
        let origin = path.way(0.0);
        let marks = [path.narrowest, path.widest].map(|turn| Mark { place: path.way(turn) - origin, jump: false });
        Some((line, marks.to_vec()))
    }

    /// Integrates the history from a closed path, or from the relaxed contact at the mean.
    pub(super) fn integrated(&self, path: Option<&ClosedPath>) -> Result<Integrated, Refusal> {
        let started = match path {
            Some(path) => self.of(path),
            None => Some(self.at_rest()),
        };
        let Some((mut line, marks)) = started else {
            return Err(not_converged("a chain of the line has no periodic state".into()));
        };
        line.trail = Some(Trail { way: path.map_or(0.0, |path| path.way(0.0)), ..Trail::default() });
        let mut integration = Integration::new(self.problem, line.edge, self.sinus.mean);
        integration.line = line;
        integration.marks = marks;
        integration.merge();
        integration.branch.memory = self.sinus.memory(&self.problem.chain, 0.0);
        let row = integration.row(None, 0.0);
        integration.outcome.path.clear();
        integration.outcome.wanted.clear();
        integration.met = 0;
        (integration.outcome.start, integration.outcome.least_force) = (row, row);
        integration.start_residual = integration.sudden(0.0);
        let end = loop {
            if let Some(end) = integration.panel() {
                break end;
            }
            if integration.outcome.panels + integration.outcome.refused > MOST_PANELS {
                break End::Failed;
            }
        };
        integration.outcome.closures = integration.window.closures;
        integration.outcome.kernel_nodes = integration.window.kernel_nodes;
        let (time, radius) = (integration.line.time, integration.line.edge);
        let cycle = time / self.period;
        match end {
            End::History => {}
            End::Lost | End::Floor => {
                return Err(Refusal::NoSuchState {
                    reason: format!(
                        "the contact lets go within a cycle, {:.0} % of it after the penetration passes its mean",
                        100.0 * cycle.fract()
                    ),
                    limit_name: "contact radius there",
                    limit: radius,
                });
            }
            End::Failed | End::TouchesAgain => {
                return Err(not_converged(format!("panels of no length {cycle:.6} cycles from the start, at a = {radius:e} m")));
            }
        }
        if let Some(jump) = integration.outcome.jumps.first() {
            return Err(Refusal::Undefined {
                quantity: "the periodic state of an edge that jumps",
                reason: format!(
                    "within a cycle it jumps to a = {:e} m at Δ = {:e} m; integrate the cycles",
                    jump.contact_radius, jump.penetration
                ),
            });
        }
        let trail = integration.line.trail.take().unwrap_or_default();
        Ok(Integrated { trail, outcome: integration.outcome })
    }
}

pub(super) fn not_converged(detail: String) -> Refusal {
    Refusal::NotConverged { what: "the periodic state", detail }
}
