//! Rows of the history: wanted instants, ends of panels, and the least force, evaluated there, not interpolated.

use super::closure::Way;
use super::drive::Instant;
use super::events::first_crossing;
use super::force::force;
use super::line::Segment;
use super::march::March;
use super::problem::Row;

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
        Row { time: self.line.time + time, penetration: now.depth, contact_radius: edge, force: force(solid, &self.line, way, &now) }
    }

    /// Rows of the panel: wanted instants, its end, the least force.
    pub(super) fn record(&mut self, advances: bool, segment: &Segment, cut: f64) {
        let at = |march: &Self, theta: f64| march.row(Some(Way { panel: segment, advances, theta }), segment.time_at(theta));
        let (start, end) = (self.line.time, self.line.time + segment.time_at(cut));
        while let Some(wanted) = self.problem.instants.get(self.outcome.wanted.len()).copied().filter(|&wanted| wanted <= end + LATE * end)
        {
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
    }

    /// Wanted instants of a time in which nothing moves.
    pub(super) fn record_rest(&mut self, time: f64) {
        let start = self.line.time;
        let end = start + time;
        while let Some(wanted) = self.problem.instants.get(self.outcome.wanted.len()).copied().filter(|&wanted| wanted <= end + LATE * end)
        {
            let row = self.row(None, wanted - start);
            self.outcome.wanted.push(row);
        }
        let row = self.row(None, time);
        self.outcome.ends.push(row);
    }
}
