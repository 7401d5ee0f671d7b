//! Parts of the history of a contact that attracts at a distance, followed for what only a solution knows.

use super::super::known::Known;
use super::super::locate::{Followed, State, Way, known};
use super::super::scale::Scale;
use super::super::timeline::Timeline;
use super::FiniteRangePlan;
use super::history::Course;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::Indentation;
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::{Accuracy, Mesher, Record, run_watched};
use viscotack::indentation::Watch as _;
use viscotack::refusal::Refusal;

/// Accuracy of a history with conditions, over that of the scene: the time of a condition is known as well as the quantity is.
pub(super) const WITH_CONDITIONS: f64 = 0.3;

/// A part of a plan, and the state_watch that hears how far it is.
struct Part<'d> {
    plan: FiniteRangePlan,
    state_watch: &'d StateWatch<'d>,
}

impl FiniteRangePlan {
    /// The same plan with all known that only a solution knows; none if nothing is open.
    pub(super) fn resolved(&self, state_watch: &StateWatch<'_>) -> Result<Option<Self>, Refusal> {
        if self.timeline.open.is_empty() {
            return Ok(None);
        }
        let part = Part { plan: self.clone(), state_watch };
        let found = known(&part)?;
        let mut plan = part.of_part(self.indentation.clone(), &found, self.solver_accuracy)?.plan;
        plan.accuracy = self.accuracy;
        Ok(Some(plan))
    }

    /// A record in coherent units.
    pub(super) fn state(&self, record: &Record) -> State<f64> {
        let scales = &self.reduced.scales;
        State {
            time: record.time,
            penetration: self.reduced.penetration(record.penetration, 0.0).value,
            force: record.force * scales.force,
            contact_radius: record.contact_radius * scales.radius,
        }
    }
}

impl Followed for Part<'_> {
    fn scene_part(&self) -> (&Indentation, &Scale, &Timeline, f64) {
        (&self.plan.indentation, &self.plan.scale, &self.plan.timeline, self.plan.accuracy)
    }

    fn of_part(&self, indentation: Indentation, known: &Known, accuracy: f64) -> Result<Self, Refusal> {
        let old = &self.plan;
        let timeline = Timeline::new(&indentation, &old.scale, known)?;
        let course = Course::new(&indentation, &timeline, &old.reduced, &old.scale);
        let known = known.clone();
        let plan = FiniteRangePlan { indentation, timeline, course, known, accuracy, solver_accuracy: accuracy, ..old.clone() };
        Ok(Self { plan, state_watch: self.state_watch })
    }

    fn search(&self, tolerance: f64) -> Result<Way, Refusal> {
        let accuracy = Accuracy::of_law(tolerance, &self.plan.reduced.law);
        let mut mesher = Mesher::new(accuracy.order);
        let run = run_watched(&self.plan.problem()?, accuracy, &mut mesher, &mut |part| self.state_watch.passed(1, part.min(1.0)))?;
        let losses = run.losses.iter().map(|record| record.time).collect();
        Ok(Way { states: run.rows.iter().map(|record| self.plan.state(record)).collect(), losses })
    }

    fn end(&self) -> Result<State<Estimate>, Refusal> {
        let runs = self.plan.runs(self.state_watch)?;
        let last = self.plan.instants(&runs).last().map(|(loose, tight)| self.plan.of_record_state(loose, tight));
        last.ok_or_else(|| Refusal::Undefined { quantity: "the start of a segment", reason: "the history before it has no instant".into() })
    }
}
