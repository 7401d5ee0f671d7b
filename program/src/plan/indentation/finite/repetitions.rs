//! The parts of a test, and rows of what a history goes through again and again.

use super::super::protocol::Protocol;
use super::super::rows::Values;
use super::super::timeline::Repetition;
use super::FiniteRangePlan;
use super::bounds::Runs;
use super::columns::{COLUMNS, at};
use super::rows::set;
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::{Record, Run};

impl FiniteRangePlan {
    /// The history as a test, with the states between its legs.
    pub(super) fn protocol(&self, runs: &Runs) -> Protocol<'_> {
        let states = self.between_legs(&runs.tight).into_iter().map(|record| record.map(|record| self.state(record))).collect();
        let compliance = self.indentation.frame_stiffness.map_or(0.0, |stiffness| 1.0 / (stiffness * self.scale.force));
        Protocol::new(&self.timeline, &self.indentation.history, states, compliance)
    }

    /// The contact radius between two legs.
    pub(super) fn radius_between_legs(&self, runs: &Runs, place: usize) -> Option<Estimate> {
        let [loose, tight] = [&runs.loose, &runs.tight].map(|run| self.between_legs(run).get(place).copied().flatten());
        let (loose, tight) = loose.zip(tight)?;
        Some(self.between(loose.contact_radius, tight.contact_radius, self.reduced.scales.radius))
    }

    /// The work and the extremes of every repetition that is a row, coherent; none of those that a run does not reach the end of.
    pub(super) fn of_repetitions(&self, runs: &Runs) -> Vec<Values> {
        let [loose, tight] = [&runs.loose, &runs.tight].map(|run| self.between_legs(run));
        let ends = |states: &[Option<&'_ Record>], repetition: &Repetition| {
            let [from, to] = [repetition.legs.start, repetition.legs.end].map(|place| states.get(place).copied().flatten().copied());
            from.zip(to)
        };
        let shown = crate::plan::curves::thinned(self.timeline.repetitions.iter().collect(), super::super::cycles::MOST_ROWS);
        let of = |repetition: &Repetition| Some(self.of_repetition(runs, repetition, ends(&loose, repetition)?, ends(&tight, repetition)?));
        shown.into_iter().filter_map(of).collect()
    }

    fn of_repetition(&self, runs: &Runs, repetition: &Repetition, loose: (Record, Record), tight: (Record, Record)) -> Values {
        let mut values: Values = vec![None; COLUMNS.len()];
        let units = self.reduced.scales;
        // Running sums: each is known as well as the runs agree about it.
        let [before, after] =
            [(loose.0, tight.0), (loose.1, tight.1)].map(|(loose, tight)| self.between(loose.work, tight.work, units.work));
        let work = Estimate::new(after.value - before.value, after.error + before.error);
        let depth = |of: [Option<(f64, f64)>; 2]| match of {
            [Some(loose), Some(tight)] => {
                let found = self.depth(loose.0, tight.0);
                Some(Estimate::new(found.value, found.error + units.gap * tight.1))
            }
            _ => None,
        };
        let other = |of: [Option<(f64, f64)>; 2], unit: f64| match of {
            [Some(loose), Some(tight)] => {
                let found = self.between(loose.0, tight.0, unit);
                Some(Estimate::new(found.value, found.error + unit * tight.1))
            }
            _ => None,
        };
        let extremes = |of: fn(&Record) -> f64, sign: f64| {
            [(&runs.loose, loose), (&runs.tight, tight)].map(|(run, ends)| extreme(run, ends, of, sign))
        };
        let [penetration, force, radius]: [fn(&Record) -> f64; 3] = [|row| row.penetration, |row| row.force, |row| row.contact_radius];
        let cells = [
            (at::TIME, Some(Estimate::exact(tight.1.time))),
            (at::SEGMENT, Some(Estimate::exact(repetition.segment as f64))),
            (at::CYCLE, Some(Estimate::exact(repetition.number as f64))),
            (at::CYCLE_START, Some(Estimate::exact(tight.0.time))),
            (at::WORK_PER_CYCLE, Some(work)),
            (at::SMALLEST_PENETRATION, depth(extremes(penetration, -1.0))),
            (at::LARGEST_PENETRATION, depth(extremes(penetration, 1.0))),
            (at::SMALLEST_FORCE, other(extremes(force, -1.0), units.force)),
            (at::LARGEST_FORCE, other(extremes(force, 1.0), units.force)),
            (at::SMALLEST_CONTACT_RADIUS, other(extremes(radius, -1.0), units.radius)),
            (at::LARGEST_CONTACT_RADIUS, other(extremes(radius, 1.0), units.radius)),
        ];
        set(&mut values, cells);
        values
    }
}

/// The largest (`sign` 1) or smallest (−1) value of a run between two of its states, and by how much it may be beyond between two steps.
fn extreme(run: &Run, (from, to): (Record, Record), of: fn(&Record) -> f64, sign: f64) -> Option<(f64, f64)> {
    let first = run.rows.iter().position(|row| *row == from).unwrap_or_else(|| run.rows.partition_point(|row| row.time < from.time));
    let last = run.rows.iter().rposition(|row| *row == to).unwrap_or_else(|| run.rows.partition_point(|row| row.time <= to.time));
    let way = run.rows.get(first..(last + 1).min(run.rows.len()))?;
    let size = |row: &Record| sign * of(row);
    let peak = (0..way.len()).max_by(|one, other| size(&way[*one]).total_cmp(&size(&way[*other])))?;
    let row = way.get(peak)?;
    let drop = |neighbour: Option<&Record>| neighbour.map_or(0.0, |beside| size(row) - size(beside));
    let beyond = match peak.checked_sub(1) {
        Some(before) if peak + 1 < way.len() => drop(way.get(before)).max(drop(way.get(peak + 1))),
        _ => 0.0,
    };
    Some((of(row), beyond))
}
