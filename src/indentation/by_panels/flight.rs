//! After the contact: no point is bonded, the indenter goes where its control takes it, and the surface creeps back, until they touch again.
//!
//! ```text
//! F = 0:    penetration and frame give Δ;  under a force the indenter stays where its contact let go, or is pressed in again by one above zero
//! touch:    D(0) = 0, the gap on the axis;  or F = 0⁺
//! ```
//! What touches again bonds at once, from the axis to the first place where the edge is in equilibrium.

use super::drive::{Branch, Instant};
use super::energies::{TurnedOver, energies};
use super::followed::State;
use super::gauss::Gauss;
use super::integration::Integration;
use super::jump::FLOOR;
use super::line::field;
use super::prescribed::RADIUS;
use super::problem::{End, Row, Step};
use super::surface::surface;
use crate::indentation::EventKind;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Instants of a segment at which the gap is looked at: as many evenly as in equal ratios from the shortest time on; evenly in each cycle of an oscillation.
const LOOKS: u32 = 40;
const LOOKS_IN_A_CYCLE: f64 = 24.0;
/// Halvings of the time in which the surfaces touch.
const HALVINGS: u32 = 60;
/// Parts of an arc over which D is averaged, for the gap away from the axis.
const ARC: u32 = 32;

/// What the look at an instant of the flight shows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Look {
    Open,
    Touches,
    /// Away from the axis: no disc is bonded there.
    TouchesInARing,
}

/// The indenter in flight: what drives it, the place where it stays under a force, what comes next.
struct Flight {
    branch: Branch,
    depth: f64,
    upcoming: usize,
}

impl Flight {
    /// Whether the indenter stays where it is: under a force, for without one a frame is at Δ.
    fn stays(&self) -> bool {
        self.branch.control.is_some_and(|control| control.depth == 0.0)
    }

    fn value(&self, time: f64) -> f64 {
        self.branch.value(time - self.branch.start).0
    }

    fn depth(&self, time: f64) -> f64 {
        if self.stays() { self.depth } else { self.value(time) }
    }
}

impl Integration<'_> {
    /// The history without contact. Whether the surfaces touch again, at the time and in the segment that the integration then has.
    pub(super) fn flies(&mut self) -> bool {
        self.ends_at_once(false);
        self.lets_go();
        let start = self.line.time;
        let depth = self.outcome.path.last().map_or(0.0, |last| last.row.penetration);
        self.piece += 1;
        let mut flight = Flight { branch: self.branch.clone(), depth, upcoming: self.upcoming };
        let mut here = start;
        self.step_in_flight(start, flight.depth(start), false);
        let row = Row { time: start, penetration: flight.depth(start), ..Row::default() };
        self.integrates_at_once(&row);
        loop {
            let last = flight.upcoming == self.problem.drive.segments.len();
            let mut touch = self.touch(&flight, here);
            let until = touch.map_or(flight.branch.end, |touch| touch.0);
            let rate = |time: f64| if flight.stays() { 0.0 } else { flight.branch.value(time - flight.branch.start).1 };
            if let Some(stop) = self.integrates_flight((here, until), |time| (flight.depth(time), rate(time))) {
                self.branch = flight.branch.clone();
                self.ends_early(stop);
                (flight.branch.end, touch) = (stop, None);
            }
            // At the very end rounding leaves none out.
            let end = touch.map_or(if last { f64::INFINITY } else { flight.branch.end }, |touch| touch.0);
            while let Some(wanted) = self.due(self.met, end, flight.upcoming) {
                self.met += 1;
                let time = wanted.min(flight.branch.end);
                let depth = flight.depth(time);
                self.step_in_flight(time, depth, true);
                if self.is_asked_for_surface(self.met) {
                    let now = Instant { time: time - start, depth, ..Instant::default() };
                    self.outcome.surface = Some(surface((&self.problem.chain, &self.problem.profile), &self.line, None, &now));
                    return false;
                }
            }
            if let Some((time, look)) = touch {
                let depth = flight.depth(time);
                self.step_in_flight(time, depth, false);
                // At the instant of letting go nothing has crept back: what still overlaps then is no touch.
                if look == Look::TouchesInARing || time <= start || flight.branch.control == Some(RADIUS) {
                    self.outcome.end = End::TouchesAgain;
                    return false;
                }
                self.line.waited(time - start);
                self.upcoming = flight.upcoming;
                self.branch = flight.branch.from(time);
                let memory = self.branch.memory.clone();
                self.state = self.branch.control.map(|_| State { depth, rate: 0.0, memory });
                return true;
            }
            here = flight.branch.end;
            let depth = flight.depth(here);
            flight.depth = depth;
            if last {
                self.step_in_flight(here, depth, false);
                return false;
            }
            let Some(drive_segment) = self.problem.drive.segments.get(flight.upcoming) else { return false };
            flight.upcoming += 1;
            let value = if flight.branch.control == drive_segment.control {
                flight.value(here)
            } else {
                depth * drive_segment.control.map_or(1.0, |control| control.depth)
            };
            flight.branch = drive_segment.branch(here, value, flight.branch.memory.clone());
            self.ends_cycles();
            self.branch = flight.branch.clone();
            self.begins_cycles(drive_segment.segment, drive_segment.duration, drive_segment.oscillation);
            flight.branch = self.branch.clone();
        }
    }

    /// When the surfaces first touch in the segment under way, from an instant on, and how.
    fn touch(&self, flight: &Flight, from: f64) -> Option<(f64, Look)> {
        let [shortest, _] = self.problem.chain.times(false);
        let length = flight.branch.end - from;
        let cycles = length * flight.branch.omega / std::f64::consts::TAU;
        let count = f64::from(LOOKS).max((LOOKS_IN_A_CYCLE * cycles).ceil());
        let even = (0..=count as u64).map(|k| length * (k as f64 / count).min(1.0));
        let ratio = (length / shortest).max(1.0);
        let graded = (1..LOOKS).map(|k| length * ratio.powf(f64::from(k) / f64::from(LOOKS) - 1.0));
        let mut looks: Vec<f64> = even.chain(graded).map(|since| from + since).collect();
        looks.sort_by(f64::total_cmp);
        let mut open = from;
        for time in looks {
            let look = self.look(flight, time);
            if look == Look::Open {
                open = time;
                continue;
            }
            let mut touched = (time, look);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (open + touched.0);
                match self.look(flight, middle) {
                    Look::Open => open = middle,
                    look => touched = (middle, look),
                }
            }
            return Some(touched);
        }
        None
    }

    fn look(&self, flight: &Flight, time: f64) -> Look {
        if flight.stays() {
            return if flight.value(time) > 0.0 { Look::Touches } else { Look::Open };
        }
        let now = Instant { time: time - self.line.time, depth: flight.depth(time), ..Instant::default() };
        if self.gap_factor(0.0, &now) <= 0.0 {
            return Look::Touches;
        }
        // Where no D is negative, no mean of it is.
        let rings = self.line.outside.iter().filter(|segment| !segment.blank);
        let places = |segment: &super::line::Segment| {
            let (from, to) = (segment.theta_low, segment.theta_high);
            Gauss::get().nodes.into_iter().chain([0.0, 1.0]).map(move |x| from + (to - from) * x).collect::<Vec<f64>>()
        };
        let pressed: Vec<f64> = rings
            .flat_map(|segment| places(segment).into_iter().map(|theta| self.line.edge + segment.place_at(theta).0))
            .filter(|radius| self.gap_factor(*radius, &now) <= 0.0)
            .collect();
        // g(r) = (2/π)∫₀^r D/√(r² − s²) ds, the mean of D over s = r sin φ.
        let gap = |radius: &f64| {
            let at = |k: u32| self.gap_factor(radius * (FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(ARC)).sin(), &now);
            FRAC_2_PI * (0..ARC).map(at).sum::<f64>() * FRAC_PI_2 / f64::from(ARC)
        };
        if pressed.iter().any(|radius| gap(radius) <= 0.0) { Look::TouchesInARing } else { Look::Open }
    }

    /// D at a place of a line that is free throughout.
    fn gap_factor(&self, radius: f64, now: &Instant) -> f64 {
        let place = radius - self.line.edge;
        let segment = self.line.at(false, place);
        let height = self.problem.profile.line(radius.max(0.0));
        field(&self.problem.chain, false, segment, segment.theta_at(place), height, now).value
    }

    /// What touches bonds at once, to the first place where the edge is in equilibrium; no contact is narrower than a process zone. Whether there is one.
    pub(super) fn touches_again(&mut self) -> bool {
        let Some(from) = self.outcome.path.last().map(|last| last.row) else { return false };
        let zone = self.problem.zone;
        while self.line.edge < FLOOR * zone {
            let border = self.line.outside.last().map_or(f64::INFINITY, |last| last.high);
            let left = FLOOR * zone - self.line.edge;
            let way = if border > 0.0 { border.min(left) } else { left };
            self.goes_at_once(way);
            if way >= left {
                break;
            }
        }
        self.previous = None;
        (self.refusals, self.flips, self.start_rate) = (0, 0, 0.0);
        self.balance();
        let lands = self.sudden(0.0) < 0.0 && self.lands(true, zone / 16.0, 0.0, (Some(EventKind::JumpIn), from)).is_none();
        if !lands || self.outcome.events.last().is_none_or(|event| event.kind != EventKind::JumpIn) {
            self.outcome.end = End::TouchesAgain;
            return false;
        }
        true
    }

    /// What is bonded lets go at once.
    fn lets_go(&mut self) {
        while self.line.edge > 0.0 {
            let Some(border) = self.line.inside.last().map(|last| -last.low) else { break };
            let last = self.line.inside.len() == 1;
            let way = if last { self.line.edge } else { border };
            if way > 0.0 {
                self.goes_at_once(-way);
            }
            if last {
                break;
            }
            if way <= 0.0 {
                self.line.inside.pop();
            }
        }
        self.line.inside.clear();
        (self.line.edge, self.line.rest.0) = (0.0, 0.0);
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
