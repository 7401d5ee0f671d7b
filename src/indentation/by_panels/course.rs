//! The course of a history: contact and flight in turn; the scales of its errors; what a refused panel leads to.

use super::integration::{Integration, PATIENCE};
use super::path::{Chart, Motion, Setting};
use super::problem::{End, Outcome};
use crate::indentation::{EventKind, Trace};

/// Panels of a segment or a cycle, accepted or not.
const MOST_PANELS: u64 = 20_000;
/// Shortest panel over the process zone, or over the time.
const SHORTEST: f64 = 1e-12;
/// Way of an elastic edge over a whole segment, over its radius, that is rounding of a value held.
const IDLE: f64 = 1e-12;

impl Integration<'_> {
    pub(super) fn setting(&self, advances: bool) -> Setting<'_> {
        let problem = self.problem;
        let motion = self.state.as_ref().map_or(Motion::Given(&self.branch), |state| Motion::Followed(state, &self.branch));
        Setting {
            chain: &problem.chain,
            profile: &problem.profile,
            line: &self.line,
            motion,
            adhesion: problem.adhesion,
            scale: self.scale(),
            advances,
        }
    }

    /// What residuals are compared with.
    pub(super) fn scale(&self) -> f64 {
        let profile = &self.problem.profile;
        self.problem.adhesion.unwrap_or_else(|| profile.line(self.line.edge.max(self.problem.zone)))
    }

    /// The displacement that the passage of the edge changes at once.
    pub(super) fn displacement(&self) -> f64 {
        match self.problem.adhesion {
            Some(adhesion) => (adhesion * self.line.edge / self.problem.chain.glassy).sqrt(),
            None => self.scale(),
        }
    }

    /// The length of which the tolerance is a part.
    pub(super) fn length(&self) -> f64 {
        let zone = self.problem.zone;
        if self.problem.adhesion.is_some() { (zone * self.line.edge).sqrt() } else { self.line.edge.max(zone) }
    }

    pub(super) fn run(mut self) -> Outcome {
        loop {
            self.outcome.end = self.in_contact();
            let last = self.outcome.path.last().map(|step| step.row);
            match (self.outcome.end, last) {
                (End::Lost, Some(row)) => self.event(EventKind::Detachment, &row),
                (End::Floor, Some(row)) => self.event(EventKind::ZoneReached, &row),
                _ => break,
            }
            if !(self.flies() && self.touches_again()) {
                break;
            }
        }
        self.ends_cycles();
        let Trace { cycles, spreads, shortened, .. } = self.rows.finished();
        (self.outcome.cycles, self.outcome.spreads, self.outcome.shortened) = (cycles, spreads, shortened);
        self.outcome.closures = self.window.closures;
        self.outcome.kernel_nodes = self.window.kernel_nodes;
        self.outcome
    }

    /// Panel by panel until the contact or the history ends.
    fn in_contact(&mut self) -> End {
        loop {
            if self.outcome.surface.is_some() {
                return End::History;
            }
            self.observe();
            if let Some(end) = self.panel() {
                return end;
            }
            if self.outcome.panels + self.outcome.refused - self.budget_from > MOST_PANELS {
                return End::Failed;
            }
        }
    }

    /// Whether a way is rounding of what holds an elastic solid still.
    pub(super) fn is_idle(&self, way: f64) -> bool {
        self.problem.chain.terms() == 0 && self.branch.amplitude == 0.0 && way.abs() <= IDLE * self.line.edge
    }

    /// A shorter panel, in place if it was in time and no turn is near; `way`: how far it would have gone.
    pub(super) fn refuses(&mut self, span: f64, factor: f64, way: f64) -> Option<End> {
        self.outcome.refused += 1;
        let time = if self.at_once.is_some() { self.branch.end } else { self.line.time.max(1e-3 * self.branch.end) };
        let least = SHORTEST * if self.span.0 == Chart::TimeOfPlace { self.problem.zone } else { time };
        self.span.1 = factor * span;
        if self.span.0 == Chart::PlaceOfTime && way != 0.0 && (if self.slows { self.to_turn } else { self.since_turn }) > 1.5 * way.abs() {
            self.span = (Chart::TimeOfPlace, factor * way);
        }
        self.refusals += 1;
        if self.refusals == PATIENCE && self.span.0 == Chart::TimeOfPlace || self.refusals == 3 * PATIENCE {
            self.previous = None;
            return None;
        }
        if span.abs() >= least {
            return None;
        }
        if self.refusals < PATIENCE && self.state.is_none() && self.branch.is_held() {
            // It may be at rest, but for rounding.
            self.refusals = PATIENCE;
            self.previous = None;
            return None;
        }
        Some(End::Failed)
    }
}
