//! The way of an indenter by one time integration, without bounds: what a fit compares with data.

use super::IndentationPlan;
use super::scale::Scale;
use crate::plan::path_curve::PathCurve;
use viscotack::indentation::{Event, EventKind, PathPoint, integrate};
use viscotack::refusal::Refusal;

/// The words of the columns.
const WORDS: [&str; 5] = ["time", "penetration", "force", "contact_radius", "frame"];

impl IndentationPlan {
    /// The way at a tolerance; nearly all values err by less than a hundredth of it.
    pub(super) fn way(&self, tolerance: f64) -> Result<PathCurve, Refusal> {
        if self.timeline.periodic {
            return Err(Refusal::Undefined {
                quantity: "a curve of a periodic state",
                reason: "it has no beginning to count time from".into(),
            });
        }
        if let Some(resolved) = self.resolved()? {
            return resolved.way(tolerance);
        }
        let trace = integrate(&self.material, &self.problem()?, tolerance)?;
        let values = |point: [f64; 4]| row(point, self.indentation.frame_stiffness, &self.scale);
        let of_point = |point: &PathPoint| values([point.time, point.penetration, point.force, point.contact_radius]);
        let rows: Vec<Vec<f64>> = trace.path.iter().map(of_point).collect();
        let touching = |point: &PathPoint| point.contact_radius > 0.0;
        let contact = trace.path.iter().position(touching).zip(trace.path.iter().rposition(touching)).map(|(first, last)| [first, last]);
        let open = trace.path.last().is_some_and(|point| point.contact_radius == 0.0);
        let loss = trace.events.iter().rfind(|event| matches!(event.kind, EventKind::Detachment | EventKind::ZoneReached)).filter(|_| open);
        let of_event = |event: &Event<f64>| values([event.time, event.penetration, event.force, event.contact_radius]);
        // Without adhesion the contact closes to nothing, and no event says so.
        let closed = || contact.filter(|_| open).and_then(|[_, last]| trace.path.get(last + 1)).map(of_point);
        let lost = loss.map(of_event).or_else(closed);
        let gained = trace.events.iter().find(|event| event.kind == EventKind::JumpIn).map(of_event);
        let pieces = trace.path.iter().map(|point| point.piece).collect();
        Ok(PathCurve { columns: columns(&rows), pieces, contact, gained, lost, at_a_distance: false })
    }
}

/// Time, penetration, force and contact radius, coherent, as a row of a curve in the units of the scene, with the far end of a frame.
pub(super) fn row([time, penetration, force, radius]: [f64; 4], frame_stiffness: Option<f64>, scale: &Scale) -> Vec<f64> {
    // An open contact has the force 0, not −0.
    let shown = force / scale.force + 0.0;
    let frame = frame_stiffness.map(|stiffness| penetration + shown / stiffness);
    [time, penetration, shown, radius].into_iter().chain(frame).collect()
}

/// Rows as columns with their words.
pub(super) fn columns(rows: &[Vec<f64>]) -> Vec<(&'static str, Vec<f64>)> {
    let width = rows.first().map_or(0, Vec::len);
    let of = |(place, word): (usize, &'static str)| (word, rows.iter().filter_map(|row| row.get(place).copied()).collect());
    WORDS.into_iter().take(width).enumerate().map(of).collect()
}
