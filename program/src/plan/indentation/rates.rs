//! Segments at a rate after another quantity was controlled: where they start is found by solving the history before them, ten times as accurately.
//!
//! A press to a force, a hold, and a retraction at a rate is one example: the depth after the hold follows from the force.

use super::IndentationPlan;
use super::timeline::{RateStart, Timeline};
use crate::scene::typed::{HistoryQuantity, HistorySegment, IndentationStart};
use viscotack::estimate::Estimate;
use viscotack::indentation::run_watched;
use viscotack::refusal::Refusal;

/// Accuracy of the history before a segment, over that of the scene.
const TIGHTER: f64 = 0.1;
/// How long a contact at rest is held to see where it is, in any time: nothing moves.
const AT_REST: f64 = 1.0;

impl IndentationPlan {
    /// The same plan with all rates known; none if they are.
    pub(super) fn with_rates(&self) -> Result<Option<Self>, Refusal> {
        if self.timeline.open_rates.is_empty() {
            return Ok(None);
        }
        let mut plan = self.clone();
        while let Some(&segment) = plan.timeline.open_rates.first() {
            let start = plan.start_of(segment)?;
            plan.rate_starts.push(start);
            plan.timeline = Timeline::new(&plan.indentation, &plan.scale, &plan.rate_starts)?;
        }
        Ok(Some(plan))
    }

    /// Where a segment at a rate starts.
    fn start_of(&self, segment: usize) -> Result<RateStart, Refusal> {
        let Some(HistorySegment::Ramp { quantity, value: to, .. }) = self.indentation.history.segments.get(segment) else {
            return Err(Refusal::Undefined { quantity: "a start of a segment", reason: "it is not at a rate".into() });
        };
        let mut before = self.clone();
        before.indentation.history.segments.truncate(segment);
        before.indentation.fields = None;
        before.accuracy = TIGHTER * self.accuracy;
        if segment == 0 {
            if self.indentation.start == IndentationStart::Untouched {
                return Ok(RateStart { segment, value: 0.0, error: 0.0 });
            }
            before.indentation.history.segments.push(HistorySegment::Hold { quantity: None, duration: AT_REST });
        }
        before.timeline = Timeline::new(&before.indentation, &before.scale, &self.rate_starts)?;
        let solution = run_watched(&before.material, &before.problem()?, None, None)?;
        let last = solution.instants.last().ok_or_else(|| Refusal::Undefined {
            quantity: "the start of a segment at a rate",
            reason: "the history before it has no instant".into(),
        })?;
        let found = match quantity {
            HistoryQuantity::Force => last.force,
            HistoryQuantity::ContactRadius => last.contact_radius,
            HistoryQuantity::Frame => {
                let stiffness = self.indentation.frame_stiffness.unwrap_or(f64::INFINITY) * self.scale.force;
                let [one, other] = [last.penetration, last.force.scaled(1.0 / stiffness)];
                Estimate::new(one.value + other.value, one.error + other.error)
            }
            _ => last.penetration,
        };
        let way = (self.scale.coherent(*quantity, *to) - found.value).abs();
        if way <= found.error {
            return Err(Refusal::Undefined {
                quantity: "the duration of a segment at a rate",
                reason: "the history before it ends where the segment is to go, within its error".into(),
            });
        }
        Ok(RateStart { segment, value: found.value, error: found.error / way })
    }
}
