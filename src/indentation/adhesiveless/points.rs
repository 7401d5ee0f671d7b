//! Points of the path of a course: events, the account of energies.

use super::course::Course;
use crate::indentation::meter::Course as Polynomial;
use crate::indentation::panel::RULE;
use crate::indentation::solution::{Energies, Event, EventKind, PathPoint};

/// Points of a path that a polynomial goes through.
const POINTS_BEHIND: usize = 6;

impl Course<'_> {
    pub(super) fn event(&self) -> Event<f64> {
        Event {
            kind: EventKind::Detachment,
            time: self.now(),
            penetration: self.line.penetration,
            force: self.line.force(),
            contact_radius: self.line.radius(),
        }
    }

    /// The contact has been lost now.
    pub(super) fn lost(&mut self) {
        let event = self.event();
        self.record.event(event);
        self.point(false);
        self.record.new_piece();
        self.corner();
    }

    /// The edge has turned: F goes on smoothly, with two derivatives.
    pub(super) fn turned(&mut self) {
        self.point(false);
    }

    /// Adds the present state to the path.
    pub(super) fn point(&mut self, sudden: bool) {
        let force = self.line.force();
        let (mut residual, looked_at) = (0.0, self.time >= self.look_at);
        if looked_at {
            let (pressing, at_edge) = self.line.least();
            let least = &mut self.record.trace.smallest_gap_factor;
            *least = least.min(pressing);
            residual = at_edge;
        }
        let mut point = PathPoint {
            time: self.now(),
            penetration: self.line.penetration,
            force,
            contact_radius: self.line.radius(),
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual,
            piece: self.record.piece(),
            energies: None,
        };
        if self.problem.energies {
            let [stored, dissipated_power] = self.line.energies();
            point.energies = Some(Energies { stored, dissipated_power, ..Energies::default() });
            self.recent.push(point);
            let spare = self.recent.len().saturating_sub(POINTS_BEHIND);
            self.recent.drain(..spare);
            let energies = self.account(&point, sudden);
            point.energies = Some(energies);
        }
        self.record.trace.work.steps += 1;
        self.record.push(point);
        if let Some(meter) = &mut self.meter {
            meter.step(&point);
        }
    }

    /// The running account of energies up to a point that is the newest of the recent ones.
    fn account(&self, point: &PathPoint, sudden: bool) -> Energies {
        let now = point.energies.unwrap_or_default();
        let Some(last) = self.record.trace.path.last() else { return now };
        let Some(before) = last.energies else { return now };
        let (mut external, mut lost) = (0.0, 0.0);
        if sudden || point.time <= last.time {
            // Springs alone take a step: what it does is stored.
            external = now.stored - before.stored;
        } else {
            let [depth, force, power] = [
                Polynomial::through(&self.recent, |point| point.penetration),
                Polynomial::through(&self.recent, |point| point.force),
                Polynomial::through(&self.recent, |point| point.energies.map_or(0.0, |energies| energies.dissipated_power)),
            ];
            let begin = last.time - point.time;
            for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
                let time = begin * (1.0 - x);
                external += -begin * weight * force.at(time).0 * depth.at(time).1;
                lost += -begin * weight * power.at(time).0;
            }
        }
        Energies {
            external_work: before.external_work + external,
            dissipated: before.dissipated + lost,
            balance_defect: external - (now.stored - before.stored) - lost,
            ..now
        }
    }
}
