//! After the contact: no point is bonded, the indenter goes where its control takes it, and the surface creeps back.
//!
//! ```text
//! F = 0:    penetration and frame give Δ;  under a force the indenter stays where its contact let go, or is pressed in again by one above zero
//! ```

use super::drive::Instant;
use super::energies::{TurnedOver, energies};
use super::gauss::Gauss;
use super::line::field;
use super::march::March;
use super::path::{Chart, passed};
use super::problem::{End, Row, Step};
use super::surface::surface;

/// Instants of a stretch at which the gap is looked at: as many evenly as in equal ratios from the shortest time on.
const LOOKS: i32 = 40;

impl March<'_> {
    /// The rest of the history without contact. Surfaces that touch again end it.
    pub(super) fn flies(&mut self) {
        self.lets_go();
        let (chain, start) = (&self.problem.chain, self.line.time);
        let mut depth = self.outcome.path.last().map_or(0.0, |last| last.row.penetration);
        self.piece += 1;
        let mut branch = self.branch.clone();
        let mut upcoming = self.upcoming;
        let mut next = self.outcome.wanted.len();
        let (mut here, mut lets_go) = (start, true);
        loop {
            // Without a force a frame is at Δ.
            let flown = branch.control.is_some_and(|control| control.depth == 0.0);
            let at = |time: f64| branch.value(time - branch.start).0;
            let depth_at = |time: f64| if flown { depth } else { at(time) };
            if std::mem::take(&mut lets_go) {
                self.step_in_flight(start, depth_at(start), false);
            }
            let [shortest, _] = chain.times(false);
            let length = branch.end - here;
            let even = (1..=LOOKS).map(|k| length * f64::from(k) / f64::from(LOOKS));
            let ratio = (length / shortest).max(1.0);
            let graded = (1..LOOKS).map(|k| length * ratio.powf(f64::from(k) / f64::from(LOOKS) - 1.0));
            let touches = |since: f64| {
                let time = here + since;
                if flown { at(time) > 0.0 } else { self.gap_in_flight(time - start, depth_at(time)) <= 0.0 }
            };
            if even.chain(graded).any(touches) {
                self.outcome.end = End::TouchesAgain;
                return;
            }
            let last = upcoming == self.problem.drive.stretches.len();
            // At the very end rounding leaves none out.
            let end = if last { f64::INFINITY } else { branch.end };
            while let Some(wanted) = self.due(next, end, upcoming) {
                next += 1;
                let time = wanted.min(branch.end);
                let depth = depth_at(time);
                self.step_in_flight(time, depth, true);
                if self.is_asked_for_surface(next) {
                    let now = Instant { time: time - start, depth, ..Instant::default() };
                    self.outcome.surface = Some(surface((&self.problem.chain, &self.problem.profile), &self.line, None, &now));
                    return;
                }
            }
            here = branch.end;
            depth = depth_at(here);
            if last {
                self.step_in_flight(here, depth, false);
                return;
            }
            let Some(stretch) = self.problem.drive.stretches.get(upcoming) else { return };
            upcoming += 1;
            let value =
                if branch.control == stretch.control { at(here) } else { depth * stretch.control.map_or(1.0, |control| control.depth) };
            branch = stretch.branch(here, value, branch.memory.clone());
        }
    }

    /// What is bonded lets go at once.
    fn lets_go(&mut self) {
        while self.line.edge > 0.0 {
            let Some(border) = self.line.inside.last().map(|last| -last.low) else { break };
            let way = if self.line.inside.len() == 1 { self.line.edge } else { border };
            if way > 0.0 {
                let values = vec![0.0; self.points.p + 1];
                let segment = passed(&self.points, &self.setting(false), Chart::TimeOfPlace, -way, &values, &[]);
                self.line.swept(segment, 1.0);
            }
            if self.line.inside.len() == 1 || way <= 0.0 {
                if self.line.inside.len() == 1 {
                    break;
                }
                self.line.inside.pop();
            }
        }
        self.line.inside.clear();
    }

    /// The least gap where there was contact, a time after it ended.
    fn gap_in_flight(&self, time: f64, depth: f64) -> f64 {
        let now = Instant { time, depth, ..Instant::default() };
        let (chain, profile) = (&self.problem.chain, &self.problem.profile);
        let mut least = f64::INFINITY;
        for segment in self.line.outside.iter().filter(|segment| !segment.blank) {
            for x in Gauss::get().nodes.into_iter().chain([0.0, 1.0]) {
                let theta = segment.theta_low + (segment.theta_high - segment.theta_low) * x;
                let height = profile.line((self.line.edge + segment.place_at(theta).0).max(0.0));
                least = least.min(field(chain, false, segment, theta, height, &now).value);
            }
        }
        least
    }

    fn step_in_flight(&mut self, time: f64, depth: f64, wanted: bool) {
        let problem = self.problem;
        let row = Row { time, penetration: depth, ..Row::default() };
        let account = problem.energies.then(|| {
            let now = Instant { time: time - self.line.time, depth, ..Instant::default() };
            let now = energies((&problem.chain, &problem.profile), &self.line, None, &now);
            let last = self.outcome.path.last();
            let since = last.map_or(row, |last| last.row);
            let (before, mut total) = last.and_then(|last| last.account).unwrap_or((now, TurnedOver::default()));
            let external = 0.5 * since.force * (row.penetration - since.penetration);
            total.external += external;
            total.dissipated += external + before.stored - now.stored;
            (now, total)
        });
        self.outcome.path.push(Step { row, residual: 0.0, piece: self.piece, area_rate: 0.0, account, wanted });
    }
}
