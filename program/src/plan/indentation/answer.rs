//! The answer of a state in one row: pull-off, separation, the largest contact, the end of the history, the last cycle.

use super::IndentationPlan;
use super::columns::{COLUMNS, at};
use super::events::is_loss;
use super::rows::Values;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Cycle, IndentationSolution, PathPoint};

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
        let of_cycle = solution.cycles.last().map(|cycle| self.of_cycle(solution, cycle, scales));
        let cycle = |place: usize| cell(of_cycle.as_ref(), place);
        let radius = self.largest(solution, at::CONTACT_RADIUS, |point| point.contact_radius, |cycle| cycle.contact_radius.get(1).copied());
        let force = self.largest(solution, at::FORCE, |point| point.force, |cycle| cycle.force.get(1).copied());
        let cells = [
            (at::PULL_OFF_FORCE, pull(at::FORCE).map(|force| Estimate::new(-force.value, force.error))),
            (at::PULL_OFF_TIME, pull(at::TIME)),
            (at::PULL_OFF_PENETRATION, pull(at::PENETRATION)),
            (at::PULL_OFF_RADIUS, pull(at::CONTACT_RADIUS)),
            (at::PULL_OFF_RATIO, pull(at::PULL_OFF_RATIO)),
            (at::WORK_OF_SEPARATION, work_of_separation(solution)),
            (at::DETACHMENT_TIME, cell(lost.as_ref(), at::TIME)),
            (at::DETACHMENT_PENETRATION, cell(lost.as_ref(), at::PENETRATION)),
            (at::LARGEST_RADIUS, radius.filter(|radius| radius.value > 0.0)),
            (at::LARGEST_COMPRESSION, force.filter(|force| force.value > 0.0)),
            (at::END_PENETRATION, end(at::PENETRATION)),
            (at::END_FORCE, end(at::FORCE)),
            (at::END_RADIUS, end(at::CONTACT_RADIUS)),
            (at::BALANCE_DEFECT, solution.balance_defect.map(Estimate::exact)),
            (at::STEPS, exact(solution.march.work.steps as f64)),
            (at::PANELS, exact(solution.march.work.most_panels as f64)),
        ];
        let of_last_cycle =
            [at::FREQUENCY, at::WORK_PER_CYCLE, at::STORAGE_STIFFNESS, at::LOSS_STIFFNESS, at::PHASE, at::DRIFT, at::SPREAD]
                .map(|place| (place, cycle(place)));
        for (place, value) in cells.into_iter().chain(of_last_cycle) {
            if let Some(cell) = values.get_mut(place) {
                *cell = value;
            }
        }
        values
    }

    /// The largest value on the way: of a point it is known as the other marches show it, and as the points beside it show.
    fn largest(
        &self,
        solution: &IndentationSolution,
        place: usize,
        of_point: fn(&PathPoint) -> f64,
        of_cycle: fn(&Cycle<Estimate>) -> Option<Estimate>,
    ) -> Option<Estimate> {
        let path = &solution.march.path;
        let peak = path.iter().enumerate().max_by(|one, other| of_point(one.1).total_cmp(&of_point(other.1)));
        let on_path = peak.and_then(|(index, point)| {
            let known = self.of_path_point(solution, index, point).get(place).copied().flatten()?;
            let drop = |neighbour: Option<&PathPoint>| neighbour.map(|beside| known.value - of_point(beside));
            let [before, after] = [index.checked_sub(1), index.checked_add(1)].map(|index| index.and_then(|index| path.get(index)));
            let smooth = before.is_some_and(|before| before.piece == point.piece) && after.is_some_and(|after| after.piece == point.piece);
            // Between smooth neighbours the maximum may lie beside the point; a corner of the history is the maximum itself.
            let beyond = match (drop(before), drop(after)) {
                (Some(before), Some(after)) if smooth => before.max(after),
                (Some(before), Some(after)) => before.min(after),
                _ => 0.0,
            };
            Some(Estimate::new(known.value, known.error + beyond))
        });
        let instants = || solution.instants.iter().filter_map(|instant| self.of_instant(instant).get(place).copied().flatten());
        let cycles = solution.cycles.iter().filter_map(of_cycle).filter(|extreme| extreme.value.is_finite() && extreme.error.is_finite());
        // A point that another march does not show is the largest, or the largest of the instants is.
        let kept = || instants().max_by(|one, other| one.value.total_cmp(&other.value));
        let on_path = on_path.map(|known| {
            let least = kept().filter(|_| !known.error.is_finite()).map(|kept| known.value - kept.value + kept.error);
            Estimate::new(known.value, least.map_or(known.error, f64::abs))
        });
        instants().chain(cycles).chain(on_path).max_by(|one, other| one.value.total_cmp(&other.value))
    }
}

/// ∫F dΔ from where the force begins to pull, before the largest tension, to the loss of contact after it (coherent); none without such a loss.
///
/// The bound adds what the path leaves open between its points to the errors of force and penetration over the way that each goes.
fn work_of_separation(solution: &IndentationSolution) -> Option<Estimate> {
    solution.largest_tension?;
    let path = &solution.march.path;
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
    let step = |from: (f64, f64, u32), to: (f64, f64, u32)| 0.5 * (from.1 + to.1) * (to.0 - from.0);
    let (mut sum, mut open) = (0.0, 0.0);
    let (mut force_way, mut depth_way) = (0.0, 0.0);
    for pair in way.windows(2) {
        let [from, to] = pair else { continue };
        sum += step(*from, *to);
        force_way += (to.1 - from.1).abs();
        depth_way += (to.0 - from.0).abs();
    }
    // Twice as wide steps within each smooth stretch; a step alone is known as well as the rectangle around it.
    for stretch in way.chunk_by(|from, to| from.2 == to.2) {
        let mut rest = stretch;
        while let [from, middle, to, ..] = rest {
            open += (step(*from, *middle) + step(*middle, *to) - step(*from, *to)).abs();
            rest = rest.get(2..).unwrap_or(&[]);
        }
        if let [from, to] = rest {
            open += 0.5 * ((to.1 - from.1) * (to.0 - from.0)).abs();
        }
    }
    let worst = |errors: &mut dyn Iterator<Item = f64>| errors.filter(|error| error.is_finite()).fold(0.0, f64::max);
    let force_error = worst(&mut solution.instants.iter().map(|instant| instant.force.error));
    let depth_error = worst(&mut solution.instants.iter().map(|instant| instant.penetration.error));
    let tension = lost.force.value.abs() + force_error;
    let at_the_end = tension * lost.penetration.error.min(depth_way);
    let error = open + force_error * depth_way + depth_error * force_way + at_the_end;
    (sum.is_finite() && error.is_finite()).then(|| Estimate::new(sum, error))
}
