//! Rows of what a history goes through again and again: groups of segments that repeat, cycles between two values.

use super::IndentationPlan;
use super::answer::work_along;
use super::columns::{COLUMNS, at};
use super::parts::state as state_of;
use super::protocol::Protocol;
use super::rows::Values;
use super::timeline::Repetition;
use crate::plan::curves::thinned;
use viscotack::estimate::Estimate;
use viscotack::indentation::{IndentationSolution, PathPoint};

/// Place of the work of the force among the energies of an instant.
const EXTERNAL_WORK: usize = 2;

impl IndentationPlan {
    /// The history as a test, with the states between its legs.
    pub(super) fn protocol(&self, solution: &IndentationSolution) -> Protocol<'_> {
        let path = &solution.integration.path;
        let states = solution.integration.kept.iter().map(|place| path.get(*place).map(state_of)).collect();
        let compliance = self.indentation.frame_stiffness.map_or(0.0, |stiffness| 1.0 / (stiffness * self.scale.force));
        Protocol::new(&self.timeline, &self.indentation.history, states, compliance)
    }

    /// The repetitions that become rows.
    pub(super) fn repetitions_shown(&self) -> Vec<&Repetition> {
        thinned(self.timeline.repetitions.iter().collect(), super::cycles::MOST_ROWS)
    }

    /// The work and the extremes of one time through a group, coherent; none where the solution has no state at one of its ends.
    pub(super) fn of_repetition(&self, solution: &IndentationSolution, repetition: &Repetition) -> Option<Values> {
        let mut values: Values = vec![None; COLUMNS.len()];
        let ends = [repetition.legs.start, repetition.legs.end];
        let [from, to] = ends.map(|end| solution.instants.get(end));
        let (from, to) = from.zip(to)?;
        let [first, last] = ends.map(|end| solution.integration.kept.get(end).copied());
        let (first, last) = first.zip(last)?;
        let way = solution.integration.path.get(first..=last)?;
        let work = match (from.energies, to.energies) {
            (Some(before), Some(after)) => {
                let [before, after] = [before, after].map(|energies| energies[EXTERNAL_WORK]);
                Estimate::new(after.value - before.value, after.error + before.error)
            }
            _ => {
                let way: Vec<(f64, f64, u32)> = way.iter().map(|point| (point.penetration, point.force, point.piece)).collect();
                work_along(&way).estimate(solution)
            }
        };
        type Of = fn(&PathPoint) -> f64;
        let instants = solution.instants.get(ends[0]..=ends[1])?;
        let extreme = |place: usize, of: Of, sign: f64| self.extreme(solution, first..last + 1, instants, place, of, sign);
        let [penetration, force, radius]: [Of; 3] = [|point| point.penetration, |point| point.force, |point| point.contact_radius];
        let cells = [
            (at::TIME, Some(Estimate::exact(to.time))),
            (at::SEGMENT, Some(Estimate::exact(repetition.segment as f64))),
            (at::CYCLE, Some(Estimate::exact(repetition.number as f64))),
            (at::CYCLE_START, Some(Estimate::exact(from.time))),
            (at::WORK_PER_CYCLE, Some(work)),
            (at::SMALLEST_PENETRATION, extreme(at::PENETRATION, penetration, -1.0)),
            (at::LARGEST_PENETRATION, extreme(at::PENETRATION, penetration, 1.0)),
            (at::SMALLEST_FORCE, extreme(at::FORCE, force, -1.0)),
            (at::LARGEST_FORCE, extreme(at::FORCE, force, 1.0)),
            (at::SMALLEST_CONTACT_RADIUS, extreme(at::CONTACT_RADIUS, radius, -1.0)),
            (at::LARGEST_CONTACT_RADIUS, extreme(at::CONTACT_RADIUS, radius, 1.0)),
        ];
        for (place, value) in cells {
            if let Some(cell) = values.get_mut(place) {
                *cell = value;
            }
        }
        Some(values)
    }
}
