//! The path of a contact: wanted instants, points of every panel and the least force, evaluated there, not interpolated; events; what is turned over on
//! the way.

use super::closure::Way;
use super::drive::{DriveSegment, Instant};
use super::energies::{Energies, TurnedOver, energies, stress_intensity};
use super::events::first_crossing;
use super::force::force;
use super::gauss::Gauss;
use super::integration::Integration;
use super::line::{Segment, field, series};
use super::problem::{Row, Step};
use super::solution::point;
use super::surface::surface;
use super::turned_over::MOST_HALVINGS;
use crate::indentation::{Event, EventKind};
use std::f64::consts::PI;

/// An instant so little beyond a panel, relative, is its end: times are sums.
pub(super) const LATE: f64 = 1e-13;
/// A force so little above the least one so far, relative, may be less between points.
const NEARLY_LEAST: f64 = 1e-3;
/// Golden sections of a least force: beyond them rounding decides.
const SECTIONS: usize = 40;

impl Integration<'_> {
    pub(super) fn row(&self, way: Option<Way<'_>>, time: f64) -> Row {
        let now = self.instant(way, time);
        let edge = self.line.edge + way.map_or(0.0, |way| way.panel.place_at(way.theta).0);
        let solid = (&self.problem.chain, &self.problem.profile);
        Row {
            time: self.time_after(time),
            penetration: now.depth,
            contact_radius: edge,
            force: force(solid, &self.line, way, &now),
            stress_intensity: stress_intensity(solid, &self.line, way, &now),
        }
    }

    /// The drive on the way, or a time after the origin with the edge at rest.
    pub(super) fn instant(&self, way: Option<Way<'_>>, time: f64) -> Instant {
        let mut now = Instant::default();
        let setting = self.setting(false);
        match way {
            Some(way) => setting.along(&way.panel.times, &way.panel.depths, way.theta, &mut now),
            // A straight way at rest, of a Δ that is given.
            None if time == 0.0 => setting.still(&mut now),
            None => setting.along(&[time], &[], 0.0, &mut now),
        }
        now
    }

    /// The next wanted instant up to a time, from a place of their list on, before a segment of the history.
    /// One that is wanted twice is wanted before a sudden step and after it, one that is wanted more often after each of some steps.
    pub(super) fn due(&self, next: usize, end: f64, upcoming: usize) -> Option<f64> {
        if self.at_once.is_some() {
            return None;
        }
        let instants = &self.instants;
        let wanted = *instants.get(next)?;
        let again = instants.iter().take(next).rev().take_while(|last| last.to_bits() == wanted.to_bits()).count();
        let (gone, ahead) = self.problem.drive.segments.split_at_checked(upcoming)?;
        let steps = gone.iter().rev().take_while(|drive_segment| drive_segment.is_sudden()).count();
        let waits = again > steps && ahead.first().is_some_and(DriveSegment::is_sudden);
        (wanted <= end + LATE * end && !waits).then_some(wanted)
    }

    /// The panel up to a parameter: wanted instants, Gauss points, the least force, the end.
    pub(super) fn record(&mut self, advances: bool, segment: &Segment, cut: f64) {
        let (start, end) = (self.line.time, self.line.time + segment.time_at(cut));
        let (span, rule) = (cut + 1.0, Gauss::get());
        let way = |theta: f64| Way { panel: segment, advances, theta };
        let row = |integration: &Self, theta: f64| integration.row(Some(way(theta)), segment.time_at(theta));
        let mut points: Vec<(f64, Row, bool)> = rule.nodes.iter().map(|x| -1.0 + span * x).map(|at| (at, row(self, at), false)).collect();
        // dA/dt, and what is turned over for each dθ.
        let area_rate = |row: &Row, theta: f64| 2.0 * PI * row.contact_radius * segment.place_at(theta).1 / series(&segment.times, theta).1;
        let mut parts = Vec::new();
        if self.problem.energies {
            let ends = [-1.0, cut].map(|theta| self.account(Some(way(theta)), 0.0).stored);
            self.turned(way(cut), self.part(way(cut), (-1.0, cut)), ends, MOST_HALVINGS, &mut parts);
        }
        let asked = self.met;
        let mut next = asked;
        while let Some(wanted) = self.due(next, end, self.upcoming) {
            next += 1;
            let theta = first_crossing(|x| segment.time_at(x) - (wanted - start)).map_or(cut, |theta| theta.min(cut));
            points.push((theta, row(self, theta), true));
        }
        let start_row = row(self, -1.0);
        let end_row = row(self, cut);
        points.push((cut, end_row, false));
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        if let Some(least) = self.least_of(&start_row, &points, |integration, theta| row(integration, theta)) {
            let place = points.partition_point(|point| point.0 < least.0);
            points.insert(place, (least.0, least.1, false));
        }
        let before = self.turned_over();
        for (theta, row, wanted) in points {
            let account = self.problem.energies.then(|| {
                let total = parts.iter().take_while(|part| part.from < theta).fold(before, |total, part| part.until(theta, total));
                (self.account(Some(way(theta)), 0.0), total)
            });
            let (residual, area_rate) = (self.panel_residual, area_rate(&row, theta));
            self.step(Step { row, residual, piece: self.piece, area_rate, account, wanted });
        }
        self.outcome.ends.push(end_row);
        self.integrates_panel(advances, segment, cut);
        if next > asked && self.is_asked_for_surface(next) {
            let theta = self.instants.last().and_then(|wanted| first_crossing(|x| segment.time_at(x) - (wanted - start)));
            let way = way(theta.map_or(cut, |theta| theta.min(cut)));
            self.outcome.surface =
                Some(surface((&self.problem.chain, &self.problem.profile), &self.line, Some(way), &self.instant(Some(way), 0.0)));
        }
    }

    /// Whether the last of the instants wanted has been met, and its surface is asked for.
    pub(super) fn is_asked_for_surface(&self, met: usize) -> bool {
        self.problem.surface && met == self.problem.instants.len()
    }

    /// Where the force is less than at every point so far, by golden sections, and that row.
    fn least_of(&mut self, start: &Row, points: &[(f64, Row, bool)], row: impl Fn(&Self, f64) -> Row) -> Option<(f64, Row)> {
        let before = self.outcome.least_force.force;
        let at = |place: Option<usize>| place.and_then(|place| points.get(place)).map_or((-1.0, start), |point| (point.0, &point.1));
        let places = std::iter::once(None).chain((0..points.len()).map(Some));
        let least = places.min_by(|&one, &other| at(one).1.force.total_cmp(&at(other).1.force)).flatten();
        let mut best = at(least);
        if best.1.force >= before + NEARLY_LEAST * before.abs() {
            return None;
        }
        let mut low = least.map_or(-1.0, |place| at(place.checked_sub(1)).0);
        let mut high = at(Some(least.map_or(0, |place| (place + 1).min(points.len() - 1)))).0;
        let mut found = *best.1;
        for _ in 0..SECTIONS {
            let [one, two] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
            let rows = [row(self, one), row(self, two)];
            if rows[0].force < rows[1].force {
                high = two
            } else {
                low = one
            }
            for (theta, row) in [one, two].into_iter().zip(rows) {
                if row.force < found.force {
                    (found, best.0) = (row, theta);
                }
            }
        }
        if found.force >= before {
            return None;
        }
        self.outcome.least_force = found;
        Some((best.0, found))
    }

    /// U and P_d on the way, or after a rest.
    pub(super) fn account(&self, way: Option<Way<'_>>, time: f64) -> Energies {
        energies((&self.problem.chain, &self.problem.profile), &self.line, way, &self.instant(way, time))
    }

    pub(super) fn turned_over(&self) -> TurnedOver {
        self.outcome.path.last().and_then(|last| last.account).map_or_else(TurnedOver::default, |account| account.1)
    }

    /// Adds a point to the path.
    pub(super) fn step(&mut self, step: Step) {
        if step.wanted {
            self.met += 1;
            self.outcome.wanted.push(step.row);
        }
        self.outcome.path.push(step);
    }

    /// Adds a point with the edge at rest, or moved at once: what acts from outside goes straight, and what is not stored is lost.
    /// `time`: after the origin.
    pub(super) fn step_at_rest(&mut self, (row, time): (Row, f64), since: &Row, wanted: bool) {
        let account = self.problem.energies.then(|| {
            let now = self.account(None, time);
            let last = self.outcome.path.last().and_then(|last| last.account);
            let (before, mut total) = last.unwrap_or((now, TurnedOver::default()));
            let external = 0.5 * (since.force + row.force) * (row.penetration - since.penetration);
            total.external += external;
            total.dissipated += external + before.stored - now.stored;
            (now, total)
        });
        let residual = self.start_residual.abs() / self.scale();
        self.step(Step { row, residual, piece: self.piece, area_rate: 0.0, account, wanted });
    }

    /// Adds the point at which an edge has been put to its equilibrium: what that takes is of its tip.
    pub(super) fn step_settled(&mut self, row: Row) {
        let last = self.outcome.path.last().copied();
        let account = self.problem.energies.then(|| {
            let now = self.account(None, 0.0);
            let (before, mut total) = last.and_then(|last| last.account).unwrap_or((now, TurnedOver::default()));
            let external = last.map_or(0.0, |last| 0.5 * (last.row.force + row.force) * (row.penetration - last.row.penetration));
            total.external += external;
            total.tip += now.stored - before.stored - external;
            (now, total)
        });
        let residual = self.start_residual.abs() / self.scale();
        self.step(Step { row, residual, piece: self.piece, area_rate: 0.0, account, wanted: false });
    }

    /// Wanted instants of a time in which nothing moves.
    pub(super) fn record_rest(&mut self, time: f64) {
        let start = self.line.time;
        let end = start + time;
        let mut last = self.outcome.path.last().map_or_else(|| self.row(None, 0.0), |last| last.row);
        while let Some(wanted) = self.due(self.met, end, self.upcoming) {
            let row = self.row(None, wanted - start);
            self.step_at_rest((row, wanted - start), &last, true);
            last = row;
            if self.is_asked_for_surface(self.met) {
                let solid = (&self.problem.chain, &self.problem.profile);
                self.outcome.surface = Some(surface(solid, &self.line, None, &self.instant(None, wanted - start)));
            }
        }
        if time > 0.0 {
            self.integrates_rest(time);
        }
        let row = self.row(None, time);
        self.step_at_rest((row, time), &last, false);
        self.outcome.ends.push(row);
    }

    /// An event in a state; what is stored and lost there is that of the last point, if it is of the same time.
    pub(super) fn event(&mut self, kind: EventKind, row: &Row) {
        let last = self.outcome.path.last().filter(|last| last.row.time.to_bits() == row.time.to_bits());
        let without = Step { row: *row, residual: 0.0, piece: self.piece, area_rate: 0.0, account: None, wanted: false };
        let step = last.map_or(without, |last| Step { row: *row, ..*last });
        self.outcome.events.push(Event::at(kind, &point(&step, None, self.problem.chain.glassy)));
    }

    /// The smallest gap outside the edge now.
    pub(super) fn looks_at_gap(&mut self) {
        let now = self.instant(None, 0.0);
        let problem = self.problem;
        let mut least = self.outcome.smallest_gap;
        for segment in &self.line.outside {
            let mut gap = |theta: f64, place: f64| {
                let height = problem.profile.line(self.line.edge + place);
                least = least.min(field(&problem.chain, false, segment, theta, height, &now).value);
            };
            if segment.blank {
                gap(0.0, segment.low);
                continue;
            }
            for x in Gauss::get().nodes {
                let theta = segment.theta_low + (segment.theta_high - segment.theta_low) * x;
                gap(theta, segment.place_at(theta).0);
            }
        }
        self.outcome.smallest_gap = least;
        self.outcome.most_segments = self.outcome.most_segments.max(self.line.inside.len() + self.line.outside.len());
    }
}
