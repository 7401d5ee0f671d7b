//! What is turned over on a panel: ∫F dΔ, ∫G_tip dA and ∫P_d dt by Gauss points, in parts that are halved where the balance of energies does not close.

use super::closure::Way;
use super::energies::TurnedOver;
use super::gauss::{Gauss, NODES};
use super::integration::Integration;
use super::line::series;
use std::f64::consts::PI;

/// Defect of the balance of energies on a part of a panel, over the tolerance and what has been turned over; rounding of what is stored; change by halving, over the
/// defect, below which the defect is not one of the sums; halvings.
const BALANCED: f64 = 1e-4;
const SAME: f64 = 0.1;
const ROUNDING: f64 = 1e-14;
pub(super) const MOST_HALVINGS: u32 = 8;

/// A part of a panel, and what is turned over at its Gauss points.
pub(super) struct Part {
    pub(super) from: f64,
    to: f64,
    rates: [TurnedOver; NODES],
}

impl Part {
    /// With what it turns over up to a parameter.
    pub(super) fn until(&self, theta: f64, mut total: TurnedOver) -> TurnedOver {
        let share = ((theta - self.from) / (self.to - self.from)).min(1.0);
        let rule = Gauss::get();
        let weights = if share < 1.0 { rule.until(share) } else { rule.weights };
        for (weight, rate) in weights.iter().zip(&self.rates) {
            total.external += weight * rate.external;
            total.tip += weight * rate.tip;
            total.dissipated += weight * rate.dissipated;
        }
        total
    }
}

impl Integration<'_> {
    /// What is turned over on a part of a panel, of which the stored energy at both ends is known: halved where F dΔ + G_tip dA = dU + P_d dt does not close
    /// and halves differ from the whole.
    pub(super) fn turned(&self, way: Way<'_>, part: Part, stored: [f64; 2], halvings: u32, parts: &mut Vec<Part>) {
        let (from, to) = (part.from, part.to);
        let [all, so_far] = [part.until(to, TurnedOver::default()), self.turned_over()];
        let gain = |turned: &TurnedOver| turned.external + turned.tip - turned.dissipated;
        let defect = (gain(&all) - (stored[1] - stored[0])).abs();
        let size = |turned: &TurnedOver| turned.external.abs() + turned.tip.abs() + turned.dissipated;
        let allowed = BALANCED * self.problem.tolerance * (size(&all) + size(&so_far)) + ROUNDING * (stored[0] + stored[1]);
        if halvings == 0 || defect <= allowed {
            return parts.push(part);
        }
        let middle = 0.5 * (from + to);
        let halves = [(from, middle), (middle, to)].map(|range| self.part(way, range));
        let changed = halves.iter().map(|half| gain(&half.until(half.to, TurnedOver::default()))).sum::<f64>() - gain(&all);
        if changed.abs() < SAME * defect {
            return parts.extend(halves);
        }
        let between = self.account(Some(Way { theta: middle, ..way }), 0.0).stored;
        for (half, stored) in halves.into_iter().zip([[stored[0], between], [between, stored[1]]]) {
            self.turned(way, half, stored, halvings - 1, parts);
        }
    }

    pub(super) fn part(&self, way: Way<'_>, (from, to): (f64, f64)) -> Part {
        let (segment, span) = (way.panel, to - from);
        let mut part = Part { from, to, rates: [TurnedOver::default(); NODES] };
        for (rate, x) in part.rates.iter_mut().zip(Gauss::get().nodes) {
            let theta = from + span * x;
            let here = Way { theta, ..way };
            let row = self.row(Some(here), segment.time_at(theta));
            let duration = span * series(&segment.times, theta).1;
            let area = span * 2.0 * PI * row.contact_radius * segment.place_at(theta).1;
            rate.external = duration * self.instant(Some(here), 0.0).rate * row.force;
            rate.tip = area * row.stress_intensity * row.stress_intensity / (2.0 * self.problem.chain.glassy);
            rate.dissipated = duration * self.account(Some(here), 0.0).dissipated_power;
        }
        part
    }
}
