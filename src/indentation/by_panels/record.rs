//! Rows of the history: wanted instants, ends of panels, and the least force, evaluated there, not interpolated.

use super::closure::Way;
use super::drive::Instant;
use super::energies::{Energies, TurnedOver, energies, stress_intensity};
use super::events::first_crossing;
use super::force::force;
use super::gauss::Gauss;
use super::line::{Segment, series};
use super::march::March;
use super::problem::Row;
use std::f64::consts::PI;

/// An instant so little beyond a panel, relative, is its end: times are sums.
const LATE: f64 = 1e-13;

impl March<'_> {
    pub(super) fn row(&self, way: Option<Way<'_>>, time: f64) -> Row {
        let mut now = Instant::default();
        let setting = self.setting(false);
        match way {
            Some(way) => setting.along(&way.panel.times, &way.panel.depths, way.theta, &mut now),
            // A straight way at rest, of a Δ that is given.
            None if time == 0.0 => setting.still(&mut now),
            None => setting.along(&[time], &[], 0.0, &mut now),
        }
        let edge = self.line.edge + way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let solid = (&self.problem.chain, &self.problem.profile);
        Row {
            time: self.line.time + time,
            penetration: now.depth,
            contact_radius: edge,
            force: force(solid, &self.line, way, &now),
            stress_intensity: stress_intensity(solid, &self.line, way, &now),
        }
    }

    /// The next wanted instant up to a time. One that is wanted twice is wanted before a sudden step and after it.
    fn due(&self, end: f64) -> Option<f64> {
        let next = self.outcome.wanted.len();
        let wanted = *self.problem.instants.get(next)?;
        let again = next > 0 && self.problem.instants.get(next - 1).is_some_and(|last| last.to_bits() == wanted.to_bits());
        let steps = self.problem.drive.stretches.get(self.upcoming).is_some_and(|stretch| stretch.duration <= 0.0);
        (wanted <= end + LATE * end && !(again && steps)).then_some(wanted)
    }

    /// Rows of the panel: wanted instants, its end, the least force.
    pub(super) fn record(&mut self, advances: bool, segment: &Segment, cut: f64) {
        let at = |march: &Self, theta: f64| march.row(Some(Way { panel: segment, advances, theta }), segment.time_at(theta));
        let (start, end) = (self.line.time, self.line.time + segment.time_at(cut));
        while let Some(wanted) = self.due(end) {
            let theta = first_crossing(|x| segment.time_at(x) - (wanted - start)).map_or(cut, |theta| theta.min(cut));
            let row = at(self, theta);
            self.outcome.wanted.push(row);
        }
        // The least force on samples, then by golden sections.
        let samples = 12;
        let theta = |i: i32| -1.0 + (cut + 1.0) * f64::from(i) / f64::from(samples);
        let rows: Vec<Row> = (0..=samples).map(|i| at(self, theta(i))).collect();
        let least = (0..rows.len()).min_by(|&i, &j| rows[i].force.total_cmp(&rows[j].force)).unwrap_or(0);
        let before = self.outcome.least_force.force;
        if rows[least].force < before + 1e-3 * before.abs() {
            let mut best = rows[least];
            {
                let (mut low, mut high) = (theta((least as i32 - 1).max(0)), theta((least as i32 + 1).min(samples)));
                for _ in 0..40 {
                    let (one, two) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
                    let (r1, r2) = (at(self, one), at(self, two));
                    if r1.force < r2.force {
                        high = two
                    } else {
                        low = one
                    }
                    for row in [r1, r2] {
                        if row.force < best.force {
                            best = row;
                        }
                    }
                }
            }
            if best.force < before {
                self.outcome.least_force = best;
            }
        }
        let row = at(self, cut);
        self.outcome.ends.push(row);
        self.turn_over(advances, segment, cut);
    }

    /// U and P_d on the way, or after a rest.
    fn account(&self, way: Option<Way<'_>>, time: f64) -> Energies {
        let mut now = Instant::default();
        let setting = self.setting(false);
        match way {
            Some(way) => setting.along(&way.panel.times, &way.panel.depths, way.theta, &mut now),
            None if time == 0.0 => setting.still(&mut now),
            None => setting.along(&[time], &[], 0.0, &mut now),
        }
        energies((&self.problem.chain, &self.problem.profile), &self.line, way, &now)
    }

    /// What a panel turns over up to a parameter, by quadrature along it.
    fn turn_over(&mut self, advances: bool, segment: &Segment, cut: f64) {
        if !self.problem.energies {
            return;
        }
        let mut total = self.outcome.accounts.last().map_or_else(TurnedOver::default, |last| last.1);
        let (span, rule) = (cut + 1.0, Gauss::get());
        for (x, weight) in rule.nodes.iter().zip(rule.weights) {
            let theta = -1.0 + span * x;
            let way = Some(Way { panel: segment, advances, theta });
            let (row, account) = (self.row(way, segment.time_at(theta)), self.account(way, 0.0));
            let mut now = Instant::default();
            self.setting(advances).along(&segment.times, &segment.depths, theta, &mut now);
            let duration = weight * span * series(&segment.times, theta).1;
            total.external += duration * now.rate * row.force;
            let area = weight * span * 2.0 * PI * row.contact_radius * segment.place_at(theta).1;
            total.tip += area * row.stress_intensity * row.stress_intensity / (2.0 * self.problem.chain.glassy);
            total.dissipated += duration * account.dissipated_power;
        }
        let end = self.account(Some(Way { panel: segment, advances, theta: cut }), 0.0);
        self.outcome.accounts.push((end, total));
    }

    /// What a jump, or a rest, turned over since the last account: what acts from outside goes straight, and what is not stored is lost.
    pub(super) fn turn_over_at_once(&mut self, before: &Row, now: &Row) {
        if !self.problem.energies {
            return;
        }
        let (start, mut total) = self.outcome.accounts.last().copied().unwrap_or_default();
        let end = self.account(None, 0.0);
        let external = 0.5 * (before.force + now.force) * (now.penetration - before.penetration);
        total.external += external;
        total.dissipated += external + start.stored - end.stored;
        self.outcome.accounts.push((end, total));
    }

    /// Wanted instants of a time in which nothing moves.
    pub(super) fn record_rest(&mut self, time: f64) {
        let start = self.line.time;
        let end = start + time;
        while let Some(wanted) = self.due(end) {
            let row = self.row(None, wanted - start);
            self.outcome.wanted.push(row);
        }
        let row = self.row(None, time);
        self.outcome.ends.push(row);
    }
}
