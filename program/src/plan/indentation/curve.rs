//! The way of an indenter by one time integration, without bounds: what a fit compares with data.

use super::IndentationPlan;
use super::columns::Measure;
use crate::plan::path_curve::PathCurve;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Event, EventKind, PathPoint, march};
use viscotack::refusal::Refusal;

/// The words of the columns, and what they measure.
const WORDS: [(&str, Measure); 5] = [
    ("time", Measure::Time),
    ("penetration", Measure::Length),
    ("force", Measure::Force),
    ("contact_radius", Measure::Length),
    ("frame", Measure::Length),
];

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
        let trace = march(&self.material, &self.problem()?, tolerance)?;
        let values = |point: [f64; 4]| -> Vec<f64> {
            let [time, penetration, force, radius] = point;
            let frame = self.frame_displacement(penetration, force);
            let all = [Some(time), Some(penetration), Some(force), Some(radius), frame];
            all.into_iter()
                .zip(WORDS)
                .filter_map(|(value, (_, measure))| Some(self.in_units(Estimate::exact(value?), measure).value))
                .collect()
        };
        let of_point = |point: &PathPoint| values([point.time, point.penetration, point.force, point.contact_radius]);
        let rows: Vec<Vec<f64>> = trace.path.iter().map(of_point).collect();
        let columns = WORDS
            .iter()
            .enumerate()
            .filter(|(place, _)| rows.first().is_some_and(|row| *place < row.len()))
            .map(|(place, (word, _))| (*word, rows.iter().filter_map(|row| row.get(place).copied()).collect()))
            .collect();
        let touching = |point: &PathPoint| point.contact_radius > 0.0;
        let contact = trace.path.iter().position(touching).zip(trace.path.iter().rposition(touching)).map(|(first, last)| [first, last]);
        let open = trace.path.last().is_some_and(|point| point.contact_radius == 0.0);
        let loss = trace.events.iter().rfind(|event| matches!(event.kind, EventKind::Detachment | EventKind::ZoneReached)).filter(|_| open);
        let of_event = |event: &Event<f64>| values([event.time, event.penetration, event.force, event.contact_radius]);
        // Without adhesion the contact closes to nothing, and no event says so.
        let closed = || contact.filter(|_| open).and_then(|[_, last]| trace.path.get(last + 1)).map(of_point);
        let lost = loss.map(of_event).or_else(closed);
        let gained = trace.events.iter().find(|event| event.kind == EventKind::JumpIn).map(of_event);
        Ok(PathCurve { columns, pieces: trace.path.iter().map(|point| point.piece).collect(), contact, gained, lost })
    }

    /// Displacement of the far end of the frame, coherent.
    fn frame_displacement(&self, penetration: f64, force: f64) -> Option<f64> {
        Some(penetration + force / (self.indentation.frame_stiffness? * self.scale.force))
    }
}
