//! The answer of a state in one row: pull-off, separation, the largest contact, the end of the history, the last cycle.

use super::IndentationPlan;
use super::columns::{COLUMNS, at};
use super::events::is_loss;
use super::rows::Values;
use std::ops::Range;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Cycle, IndentationSolution, Instant, PathPoint};

impl IndentationPlan {
    /// The values of the state as a whole, coherent.
    pub(super) fn of_state(&self, solution: &IndentationSolution, scales: &[f64]) -> Values {
        let mut values: Values = vec![None; COLUMNS.len()];
        let cell = |row: Option<&Values>, place: usize| row.and_then(|row| row.get(place).copied().flatten());
        let tension = self.of_largest_tension(solution, scales);
        let pull = |place: usize| cell(tension.as_ref(), place);
        let lost = solution.events.iter().rfind(|event| is_loss(event.kind)).map(|event| self.of_event(event, scales));
        let last = solution.instants.last().map(|instant| self.of_instant(instant));
        let end = |place: usize| cell(last.as_ref(), place);
        let exact = |number: f64| Some(Estimate::exact(number));
        let of_cycle = solution.cycles.last().map(|cycle| {
            let mut values: Values = vec![None; COLUMNS.len()];
            self.cycles(solution).put(&mut values, cycle, scales);
            values
        });
        let cycle = |place: usize| cell(of_cycle.as_ref(), place);
        let protocol = self.protocol(solution);
        let dwell = protocol.dwell(solution.largest_tension.map_or(f64::INFINITY, |tension| tension.time.value));
        let detachment = cell(lost.as_ref(), at::TIME);
        let retraction = detachment.and_then(|lost| protocol.retraction(lost.value));
        let repeated = self.timeline.repetitions.last().and_then(|last| self.of_repetition(solution, last));
        let radius = self.largest(solution, at::CONTACT_RADIUS, |point| point.contact_radius, |cycle| cycle.contact_radius.get(1).copied());
        let force = self.largest(solution, at::FORCE, |point| point.force, |cycle| cycle.force.get(1).copied());
        let cells = [
            (at::PULL_OFF_FORCE, pull(at::FORCE).map(|force| Estimate::new(-force.value, force.error))),
            (at::PULL_OFF_TIME, pull(at::TIME)),
            (at::PULL_OFF_PENETRATION, pull(at::PENETRATION)),
            (at::PULL_OFF_RADIUS, pull(at::CONTACT_RADIUS)),
            (at::PULL_OFF_RATIO, pull(at::PULL_OFF_RATIO)),
            (at::WORK_OF_SEPARATION, work_of_separation(solution)),
            (at::DWELL_RADIUS, dwell.and_then(|end| solution.instants.get(end)).map(|instant| instant.contact_radius)),
            (at::TIME_TO_DETACH, detachment.zip(retraction).map(|(lost, begin)| Estimate::new(lost.value - begin, lost.error))),
            (at::DETACHMENT_TIME, detachment),
            (at::DETACHMENT_PENETRATION, cell(lost.as_ref(), at::PENETRATION)),
            (at::LARGEST_RADIUS, radius.filter(|radius| radius.value > 0.0)),
            (at::LARGEST_COMPRESSION, force.filter(|force| force.value > 0.0)),
            (at::END_PENETRATION, end(at::PENETRATION)),
            (at::END_FORCE, end(at::FORCE)),
            (at::END_RADIUS, end(at::CONTACT_RADIUS)),
            (at::BALANCE_DEFECT, solution.balance_defect.map(Estimate::exact)),
            (at::STEPS, exact(solution.integration.work.steps as f64)),
            (at::PANELS, exact(solution.integration.work.most_panels as f64)),
        ];
        let of_last_cycle =
            [at::FREQUENCY, at::STORAGE_STIFFNESS, at::LOSS_STIFFNESS, at::PHASE, at::DRIFT, at::SPREAD].map(|place| (place, cycle(place)));
        // Of whatever repeats last.
        let time = |values: &Option<Values>| cell(values.as_ref(), at::TIME).map(|time| time.value);
        let last = if time(&repeated) > time(&of_cycle) { &repeated } else { &of_cycle };
        let work = (at::WORK_PER_CYCLE, cell(last.as_ref(), at::WORK_PER_CYCLE));
        for (place, value) in cells.into_iter().chain(of_last_cycle).chain([work]) {
            if let Some(cell) = values.get_mut(place) {
                *cell = value;
            }
        }
        values
    }

    /// The largest value on the way.
    fn largest(
        &self,
        solution: &IndentationSolution,
        place: usize,
        of_point: fn(&PathPoint) -> f64,
        of_cycle: fn(&Cycle<Estimate>) -> Option<Estimate>,
    ) -> Option<Estimate> {
        let whole = self.extreme(solution, 0..solution.integration.path.len(), &solution.instants, place, of_point, 1.0);
        let cycles = solution.cycles.iter().filter_map(of_cycle).filter(|extreme| extreme.value.is_finite() && extreme.error.is_finite());
        cycles.chain(whole).max_by(|one, other| one.value.total_cmp(&other.value))
    }

    /// The largest (`sign` 1) or smallest (−1) value at some points of the path and the instants among them: known as the other integrations show it, and as the points
    /// beside it show.
    pub(super) fn extreme(
        &self,
        solution: &IndentationSolution,
        points: Range<usize>,
        instants: &[Instant],
        place: usize,
        of_point: fn(&PathPoint) -> f64,
        sign: f64,
    ) -> Option<Estimate> {
        let path = &solution.integration.path;
        let size = |point: &PathPoint| sign * of_point(point);
        let index = points.max_by(|one, other| {
            let [one, other] = [one, other].map(|place| path.get(*place).map_or(f64::NEG_INFINITY, size));
            one.total_cmp(&other)
        })?;
        let point = path.get(index)?;
        let known = self.of_path_point(solution, index, point).get(place).copied().flatten()?;
        let drop = |neighbour: Option<&PathPoint>| neighbour.map(|beside| sign * known.value - size(beside));
        let [before, after] = [index.checked_sub(1), index.checked_add(1)].map(|index| index.and_then(|index| path.get(index)));
        let smooth = before.is_some_and(|before| before.piece == point.piece) && after.is_some_and(|after| after.piece == point.piece);
        // Between smooth neighbours the extreme may lie beside the point; a corner of the history is the extreme itself.
        let beyond = match (drop(before), drop(after)) {
            (Some(before), Some(after)) if smooth => before.max(after),
            (Some(before), Some(after)) => before.min(after),
            _ => 0.0,
        };
        let kept = instants.iter().filter_map(|instant| self.of_instant(instant).get(place).copied().flatten());
        let kept = kept.max_by(|one, other| (sign * one.value).total_cmp(&(sign * other.value)));
        // A point that another integration does not show is the extreme, or that of the instants is.
        let error = match kept {
            Some(kept) if !known.error.is_finite() => (known.value - kept.value).abs() + kept.error,
            _ => known.error + beyond.max(0.0),
        };
        let on_path = Estimate::new(known.value, error);
        kept.into_iter().chain([on_path]).max_by(|one, other| (sign * one.value).total_cmp(&(sign * other.value)))
    }
}

/// ∫F dΔ from where the force begins to pull, before the largest tension, to the loss of contact after it (coherent); none without such a loss.
///
/// The bound adds what the path leaves open between its points to the errors of force and penetration over the way that each goes.
fn work_of_separation(solution: &IndentationSolution) -> Option<Estimate> {
    solution.largest_tension?;
    let path = &solution.integration.path;
    let peak = path.iter().enumerate().min_by(|one, other| one.1.force.total_cmp(&other.1.force))?.0;
    let peak_time = path.get(peak)?.time;
    let lost = solution.events.iter().find(|event| is_loss(event.kind) && event.time.value >= peak_time)?;
    let first = path.get(..peak)?.iter().rposition(|point| point.force >= 0.0);
    let mut way: Vec<(f64, f64, u32)> = Vec::new();
    if let Some((from, to)) = first.and_then(|first| path.get(first).zip(path.get(first + 1))) {
        // The force passes through zero between two points.
        let part = from.force / (from.force - to.force);
        way.push((from.penetration + part * (to.penetration - from.penetration), 0.0, to.piece));
    }
    let pulled = path.iter().skip(first.map_or(0, |first| first + 1)).take_while(|point| point.time <= lost.time.value);
    way.extend(pulled.filter(|point| point.contact_radius > 0.0).map(|point| (point.penetration, point.force, point.piece)));
    way.push((lost.penetration.value, lost.force.value, way.last()?.2));
    let along = work_along(&way);
    let tension = lost.force.value.abs() + largest_errors(solution)[1];
    let at_the_end = tension * lost.penetration.error.min(along.depth_way);
    let found = along.estimate(solution);
    let error = found.error + at_the_end;
    (found.value.is_finite() && error.is_finite()).then(|| Estimate::new(found.value, error))
}

/// ∫F dΔ along points of a path, and what its bound is made of.
pub(super) struct Along {
    work: f64,
    /// What the path leaves open between its points.
    open: f64,
    /// The way that the force goes, and that the penetration goes.
    force_way: f64,
    depth_way: f64,
}

impl Along {
    /// With the errors of force and penetration over the way that each goes.
    pub(super) fn estimate(&self, solution: &IndentationSolution) -> Estimate {
        let [depth_error, force_error] = largest_errors(solution);
        Estimate::new(self.work, self.open + force_error * self.depth_way + depth_error * self.force_way)
    }
}

/// The largest errors of penetration and force at instants.
fn largest_errors(solution: &IndentationSolution) -> [f64; 2] {
    let of: [fn(&Instant) -> f64; 2] = [|instant| instant.penetration.error, |instant| instant.force.error];
    of.map(|of| solution.instants.iter().map(of).filter(|error| error.is_finite()).fold(0.0, f64::max))
}

/// Along points with penetration, force and piece.
pub(super) fn work_along(way: &[(f64, f64, u32)]) -> Along {
    let step = |from: (f64, f64, u32), to: (f64, f64, u32)| 0.5 * (from.1 + to.1) * (to.0 - from.0);
    let mut along = Along { work: 0.0, open: 0.0, force_way: 0.0, depth_way: 0.0 };
    for pair in way.windows(2) {
        let [from, to] = pair else { continue };
        along.work += step(*from, *to);
        along.force_way += (to.1 - from.1).abs();
        along.depth_way += (to.0 - from.0).abs();
        // From one piece to the next the force may go at once, along a way that no point shows.
        if from.2 != to.2 {
            along.open += 0.5 * ((to.1 - from.1) * (to.0 - from.0)).abs();
        }
    }
    // Twice as wide steps within each smooth piece; a step alone is known as well as the rectangle around it.
    for piece in way.chunk_by(|from, to| from.2 == to.2) {
        let mut rest = piece;
        while let [from, middle, to, ..] = rest {
            along.open += (step(*from, *middle) + step(*middle, *to) - step(*from, *to)).abs();
            rest = rest.get(2..).unwrap_or(&[]);
        }
        if let [from, to] = rest {
            along.open += 0.5 * ((to.1 - from.1) * (to.0 - from.0)).abs();
        }
    }
    along
}
