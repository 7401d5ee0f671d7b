//! States that are found on the way of an indentation: events, the largest tension, the ends of segments with a condition.

use super::IndentationPlan;
use super::columns::at;
use super::locate::State;
use super::parts::state as state_of;
use super::rows::{LARGEST_TENSION, Values};
use super::shift::{CONDITION_MET, LIMIT_REACHED, SAME_TIME, Shift};
use crate::scene::typed::Condition;
use viscotack::estimate::Estimate;
use viscotack::indentation::{Energies, Event, EventKind, IndentationSolution, Instant, PathPoint};
use viscotack::refusal::Refusal;

/// The word of an event in tables.
pub(super) const fn word(kind: EventKind) -> &'static str {
    match kind {
        EventKind::JumpIn => "jump_in",
        EventKind::JumpOut => "jump_out",
        EventKind::PartialDetachment => "partial_detachment",
        EventKind::Detachment => "detachment",
        EventKind::ZoneReached => "zone_reached",
        EventKind::LargestTension => LARGEST_TENSION,
    }
}

/// Whether an event ends the contact.
pub(super) const fn is_loss(kind: EventKind) -> bool {
    matches!(kind, EventKind::Detachment | EventKind::ZoneReached)
}

/// The end of a segment with a condition: the word, the values there, and what follows from the bound on its time.
pub(super) type End = (&'static str, Values, Option<Shift>);

impl IndentationPlan {
    /// Where segments with a condition end: the word, the values there, and what follows from the bound on the time.
    pub(super) fn ends_of_segments(&self, solution: &IndentationSolution) -> Result<Vec<End>, Refusal> {
        let compliance = self.indentation.frame_stiffness.map_or(0.0, |stiffness| 1.0 / (stiffness * self.scale.force));
        let mut ends = Vec::new();
        for ended in &self.timeline.ends {
            // Of two instants at once the first: what is stepped to afterwards is another segment.
            let nearest = solution.instants.iter().min_by(|one, other| {
                let [one, other] = [one, other].map(|instant| (instant.time - ended.time).abs());
                one.total_cmp(&other)
            });
            let Some(instant) = nearest else { continue };
            let at_end =
                State { time: ended.time, penetration: instant.penetration, force: instant.force, contact_radius: instant.contact_radius };
            let mut values = self.of_instant(&Instant { time: ended.time, ..*instant });
            if !ended.met || ended.exact {
                ends.push((if ended.met { CONDITION_MET } else { LIMIT_REACHED }, values, None));
                continue;
            }
            let within = |time: f64| time >= ended.began && time <= ended.time;
            let lost = solution.events.iter().rfind(|event| within(event.time.value)).map(|event| event.time);
            let path = &solution.integration.path;
            let states: Vec<State<f64>> = path.iter().filter(|point| point.time <= ended.time).map(state_of).collect();
            let closed = || {
                let touches = states.iter().rposition(|state| state.contact_radius > 0.0)?;
                let (last, first) = (states.get(touches)?, states.get(touches + 1)?);
                Some(Estimate::new(first.time, first.time - last.time))
            };
            let lost = if ended.sudden { lost.or_else(closed) } else { None };
            if ended.condition == Condition::Detachment && at_end.contact_radius.value > 0.0 {
                return Err(Refusal::NotConverged {
                    what: "the end of a segment by detachment",
                    detail: "a tighter solution detaches later; ask for a higher accuracy".into(),
                });
            }
            let shift = Shift::of(ended, &at_end, &states, lost, compliance);
            late_energies(&mut values, path, &shift);
            ends.push((CONDITION_MET, values, Some(shift)));
        }
        Ok(ends)
    }

    pub(super) fn of_event(&self, event: &Event<Estimate>, scales: &[f64]) -> Values {
        // An event that one integration has and the other has not: its place is not known better than the whole.
        let known = |estimate: Estimate, place: usize| {
            let scale = scales.get(place).copied().unwrap_or(0.0).max(estimate.value.abs());
            Estimate::new(estimate.value, estimate.error.min(scale))
        };
        let mut values = self.basic(
            known(event.time, at::TIME),
            known(event.penetration, at::PENETRATION),
            known(event.force, at::FORCE),
            known(event.contact_radius, at::CONTACT_RADIUS),
        );
        let energies = event.energies.filter(|_| self.indentation.energies);
        let energy = |which: usize| energies.and_then(|energies| energies.get(which).copied());
        for (place, value) in [
            (at::STRESS_INTENSITY, self.indentation.adhesion.map(|_| event.stress_intensity_factor)),
            (at::STORED_ENERGY, energy(0)),
            (at::DISSIPATED_POWER, energy(1)),
            (at::EXTERNAL_WORK, energy(2)),
            (at::DISSIPATED_ENERGY, energy(3)),
            (at::TIP_RELEASE_RATE, event.tip_release_rate.filter(|_| self.indentation.energies)),
            (at::ENERGY_RELEASE_RATE, event.energy_release_rate.filter(|_| self.indentation.energies)),
        ] {
            if let (Some(cell), Some(value)) = (values.get_mut(place), value) {
                *cell = Some(known(value, place));
            }
        }
        values
    }

    /// The row of the largest tension. Where other tensions of the path are as large, as far as is known, it acts here or there.
    pub(super) fn of_largest_tension(&self, solution: &IndentationSolution, scales: &[f64]) -> Option<Values> {
        let tension = solution.largest_tension?;
        let mut values = self.of_event(&tension, scales);
        let as_large = as_large_tensions(&solution.integration.path, &tension);
        type Of = fn(&PathPoint) -> f64;
        let quantities: [(usize, Of); 4] = [
            (at::TIME, |point| point.time),
            (at::PENETRATION, |point| point.penetration),
            (at::CONTACT_RADIUS, |point| point.contact_radius),
            (at::STRESS_INTENSITY, |point| point.stress_intensity_factor),
        ];
        for (place, of) in quantities {
            if let Some(Some(cell)) = values.get_mut(place) {
                let away = as_large.iter().map(|point| (of(point) - cell.value).abs());
                *cell = Estimate::new(cell.value, away.fold(cell.error, f64::max));
            }
        }
        if let (Some(cell), Some(unit)) = (values.get_mut(at::PULL_OFF_RATIO), self.jkr_pull_off()) {
            *cell = Some(tension.force.scaled(-1.0 / unit));
        }
        Some(values)
    }
}

/// Adds to the bounds of the stress intensity and the energies at the end of a segment what they change by in the time by which it may come late.
fn late_energies(values: &mut Values, path: &[PathPoint], shift: &Shift) {
    let until = path.partition_point(|point| point.time <= shift.time * (1.0 + SAME_TIME));
    let before = path.get(..until).unwrap_or(&[]);
    let Some((last, from)) = before.last().and_then(|last| Some((last, before.iter().rfind(|point| point.time < last.time)?))) else {
        return;
    };
    let energy = |of: fn(&Energies) -> f64| Some(of(&last.energies?) - of(&from.energies?));
    for (place, change) in [
        (at::STRESS_INTENSITY, Some(last.stress_intensity_factor - from.stress_intensity_factor)),
        (at::STORED_ENERGY, energy(|energies| energies.stored)),
        (at::DISSIPATED_POWER, energy(|energies| energies.dissipated_power)),
        (at::EXTERNAL_WORK, energy(|energies| energies.external_work)),
        (at::DISSIPATED_ENERGY, energy(|energies| energies.dissipated)),
        (at::TIP_RELEASE_RATE, energy(|energies| energies.tip_release_rate)),
        (at::ENERGY_RELEASE_RATE, energy(|energies| energies.energy_release_rate.unwrap_or(energies.tip_release_rate))),
    ] {
        if let (Some(Some(cell)), Some(change)) = (values.get_mut(place), change) {
            // The straight line through the last two points, and as much again for its bend.
            *cell = Estimate::new(cell.value, cell.error + 2.0 * shift.late * change.abs() / (last.time - from.time));
        }
    }
}

/// Whether the contact holds at the end, and no tension was larger than that there, as far as is known.
pub(super) fn is_held_at_its_end(solution: &IndentationSolution) -> bool {
    let pulls = |(last, tension): (&PathPoint, Estimate)| last.contact_radius > 0.0 && -last.force >= tension.value - 2.0 * tension.error;
    solution.integration.path.last().zip(solution.pull_off_force()).is_some_and(pulls)
}

/// Part of the largest tension below which a difference of tensions is rounding of the edge condition.
const ALIKE: f64 = 1e-9;

/// Points in contact that pull as hard as the largest tension does, as far as is known, and are not beside it: of other peaks, or of a plateau.
fn as_large_tensions<'p>(path: &'p [PathPoint], tension: &Event<Estimate>) -> Vec<&'p PathPoint> {
    let (largest, unknown) = (-tension.force.value, tension.force.error);
    let pulls = |point: &PathPoint, less: f64| point.contact_radius > 0.0 && -point.force >= largest - less;
    let above = |point: &PathPoint| pulls(point, 2.0 * unknown);
    let (mut found, mut passed) = (Vec::new(), 0);
    for piece in path.chunk_by(|one, other| above(one) == above(other)) {
        let (before, after) = (path.get(passed.max(1) - 1), path.get(passed + piece.len()).or(piece.last()));
        passed += piece.len();
        let holds_it = before.zip(after).is_some_and(|(from, to)| (from.time..=to.time).contains(&tension.time.value));
        found.extend(piece.iter().filter(|point| above(point) && (!holds_it || pulls(point, ALIKE * largest))));
    }
    found
}
