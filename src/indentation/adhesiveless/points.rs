//! Points of the path of a course: events, the account of energies.

use super::course::Course;
use super::ledger::Sums;
use super::state::Look;
use crate::indentation::solution::{Energies, EventKind, PathPoint};

impl Course<'_> {
    /// The contact has been lost now.
    pub(super) fn lost(&mut self) {
        self.point(false);
        self.record.happened(EventKind::Detachment);
        self.record.new_piece();
        self.corner();
    }

    /// The edge has turned: F goes on smoothly, with two derivatives.
    pub(super) fn turned(&mut self) {
        self.point(false);
    }

    /// Adds the present state to the path.
    pub(super) fn point(&mut self, sudden: bool) {
        let look = Look::at(&self.line, self.time >= self.look_at, self.problem.energies);
        self.point_of(&look, sudden);
    }

    /// Adds a state to the path.
    pub(super) fn point_of(&mut self, look: &Look, sudden: bool) {
        let mut residual = 0.0;
        if let Some((pressing, at_edge)) = look.least {
            let least = &mut self.record.trace.smallest_gap_factor;
            *least = least.min(pressing + self.line.unknown());
            residual = at_edge;
        }
        let mut point = PathPoint {
            time: self.now(),
            penetration: look.penetration,
            force: look.force,
            contact_radius: look.radius,
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual,
            piece: self.record.piece(),
            energies: None,
        };
        let sums = std::mem::take(&mut self.sums);
        point.energies = look.energies.map(|now| self.account(now, &sums, sudden));
        self.record.trace.work.steps += 1;
        self.record.push(point);
        if let Some(meter) = &mut self.meter {
            meter.passed(&point, &sums);
        }
    }

    /// The running account of energies. What is not stored of the work is lost: the power lost, added up by itself, tells how well both agree.
    fn account(&self, [stored, dissipated_power]: [f64; 2], sums: &Sums, sudden: bool) -> Energies {
        let now = Energies { stored, dissipated_power, ..Energies::default() };
        let Some(before) = self.record.trace.path.last().and_then(|last| last.energies) else { return now };
        let rise = stored - before.stored;
        // Springs alone take a step: what it does is stored.
        let (work, lost) = if sudden { (rise, 0.0) } else { (sums.work, sums.work - rise) };
        Energies {
            external_work: before.external_work + work,
            dissipated: before.dissipated + lost,
            balance_defect: lost - sums.lost,
            ..now
        }
    }
}
