//! Parts of the history of a contact with an edge, followed for what only a solution knows.

use super::IndentationPlan;
use super::events::is_loss;
use super::known::Known;
use super::locate::{Followed, State, Way, known};
use super::scale::Scale;
use super::timeline::Timeline;
use crate::scene::typed::Indentation;
use viscotack::estimate::Estimate;
use viscotack::indentation::{PathPoint, Trace, integrate, run_watched};
use viscotack::refusal::Refusal;

/// Accuracy of a history with conditions, over that of the scene: the time of a condition is known as well as the quantity is.
pub(super) const WITH_CONDITIONS: f64 = 0.1;

impl IndentationPlan {
    /// The same plan with all known that only a solution knows; none if nothing is open.
    pub(super) fn resolved(&self) -> Result<Option<Self>, Refusal> {
        if self.timeline.open.is_empty() {
            return Ok(None);
        }
        let found = known(self)?;
        let mut plan = self.of_part(self.indentation.clone(), &found, self.solver_accuracy)?;
        plan.accuracy = self.accuracy;
        Ok(Some(plan))
    }
}

impl Followed for IndentationPlan {
    fn scene_part(&self) -> (&Indentation, &Scale, &Timeline, f64) {
        (&self.indentation, &self.scale, &self.timeline, self.accuracy)
    }

    fn of_part(&self, indentation: Indentation, known: &Known, accuracy: f64) -> Result<Self, Refusal> {
        let timeline = Timeline::new(&indentation, &self.scale, known)?;
        Ok(Self { indentation, timeline, known: known.clone(), accuracy, solver_accuracy: accuracy, ..self.clone() })
    }

    fn search(&self, tolerance: f64) -> Result<Way, Refusal> {
        let trace = integrate(&self.material, &self.problem()?, tolerance)?;
        let losses = if self.indentation.adhesion.is_some() {
            trace.events.iter().filter(|event| is_loss(event.kind)).map(|event| event.time).collect()
        } else {
            closings(&trace)
        };
        Ok(Way { states: trace.path.iter().map(state).collect(), losses })
    }

    fn end(&self) -> Result<State<Estimate>, Refusal> {
        let solution = run_watched(&self.material, &self.problem()?, None, None)?;
        let last = solution.instants.last().ok_or_else(|| Refusal::Undefined {
            quantity: "the start of a segment",
            reason: "the history before it has no instant".into(),
        })?;
        Ok(State { time: last.time, penetration: last.penetration, force: last.force, contact_radius: last.contact_radius })
    }
}

/// A point of a path.
pub(super) fn state(point: &PathPoint) -> State<f64> {
    State { time: point.time, penetration: point.penetration, force: point.force, contact_radius: point.contact_radius }
}

/// When a contact without adhesion has closed to nothing: no event says so.
fn closings(trace: &Trace) -> Vec<f64> {
    let pairs = trace.path.windows(2).filter(|pair| pair.iter().map(|point| point.contact_radius > 0.0).eq([true, false]));
    pairs.filter_map(|pair| pair.last()).map(|point| point.time).collect()
}
