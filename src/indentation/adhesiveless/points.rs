//! Points of the path of a course: events, the account of energies.

use super::course::{Course, Loss};
use super::ledger::Sums;
use super::state::Look;
use crate::indentation::solution::{Energies, EventKind, PathPoint};

impl Course<'_> {
    /// The contact has been lost now; `rate`: Δ̇, none where the time is given.
    pub(super) fn lost(&mut self, rate: Option<f64>) {
        let at_axis = |index: usize| self.line.free.first().and_then(|interval| interval.term(index).first()).copied().unwrap_or(0.0);
        let recovering: f64 = self.chain.voigt.iter().enumerate().map(|(index, (slowness, _))| slowness * at_axis(index)).sum();
        // S = Δ − f − Σe_j on the axis, where the contact is lost last.
        self.losses.push(rate.map_or(Loss::GIVEN, |rate| Loss { depth_rate: rate, falling: -(rate + recovering) }));
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
        if let Some(cycle_integrals) = &mut self.cycle_integrals {
            cycle_integrals.passed(&point, &sums);
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
