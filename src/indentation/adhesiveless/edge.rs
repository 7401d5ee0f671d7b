//! How the edge goes through an interval of time while Δ(x) is given: one way at a time, until it turns, is lost, or the time is over.
//!
//! Each chain knows when the edge passes it: in contact when its own S falls through zero, free when it rises through zero. No chain waits for another one.

use super::drive::Drive;
use super::grid::{GRID, NODES};
use super::law::Met;
use super::line::Line;
use super::moment::Moment;
use super::times::{leaving, touching};
use crate::refusal::Refusal;

/// S that rounding leaves, over the depth.
const ROUNDING: f64 = 2e-15;
/// Instants looked at evenly, and halvings of the time towards its start.
const EVEN: u32 = 8;
const MOST_HALVINGS: i32 = 70;
/// Part of the shortest relaxation time below which nothing turns by itself.
const SHORTEST: f64 = 0.05;
/// Iterations of a bracketed root.
const MOST_ITERATIONS: u32 = 100;

/// Part of an interval of time after whose start a touch is at its start.
const AT_ONCE: f64 = 1e-9;

/// What ended an interval of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ended {
    /// It is over.
    Whole,
    /// The edge turned.
    Turned,
    /// The contact was lost, at this instant.
    Lost,
    /// It was found.
    Touched,
    /// What presses is less than what the panel leaves: whether the contact is lost is not known, and nothing was passed.
    Unresolved,
}

/// How far, which way (none at rest), and why no further.
pub(super) type Went = (f64, Option<Way>, Ended);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Inwards,
    Outwards,
}

impl Line<'_> {
    fn noise(&self) -> f64 {
        ROUNDING * self.depth
    }

    /// S at the edge after a moment, by the chains inside and outside; none on a side without chains.
    fn at_edge(&self, moment: &Moment) -> (Option<f64>, Option<f64>) {
        let inside = self.contact.last().map(|interval| self.pressed(interval, moment)[NODES - 1]);
        let a = self.radius();
        let outside = match self.free.first() {
            Some(interval) => Some(self.opened(interval, moment)[0]),
            None if a < self.profile.rim() => Some(moment.depth - self.profile.line(a)),
            None => None,
        };
        (inside, outside)
    }

    /// Where the edge is after a moment of going one way; none where an edge that goes inwards has passed the axis.
    fn edge_after(&self, moment: &Moment, way: Way) -> Result<Option<f64>, Refusal> {
        match way {
            Way::Inwards => {
                for interval in self.contact.iter().rev() {
                    let pressed = self.pressed(interval, moment);
                    if pressed[0] >= 0.0 {
                        if pressed[NODES - 1] >= 0.0 {
                            return Ok(Some(interval.high));
                        }
                        return Ok(Some(interval.low + interval.width() * GRID.part(GRID.falling_zero(&pressed))));
                    }
                }
                Ok(None)
            }
            Way::Outwards => {
                let mut reached = self.radius();
                for interval in &self.free {
                    let opened = self.opened(interval, moment);
                    if opened[NODES - 1] < 0.0 {
                        if opened[0] < 0.0 {
                            return Ok(Some(reached));
                        }
                        return Ok(Some(interval.low + interval.width() * GRID.part(GRID.falling_zero(&opened))));
                    }
                    reached = interval.high;
                }
                let rim = self.profile.rim();
                if reached >= rim {
                    return Ok(Some(rim));
                }
                self.virgin_edge(moment.depth, reached).map(Some)
            }
        }
    }

    /// dS/dt at the edge, a moment after which it is at a place.
    fn rate_at(&self, place: f64, moment: &Moment, way: Way) -> f64 {
        let terms = self.chain.terms();
        let mut state = vec![0.0; terms];
        match way {
            Way::Inwards => {
                let Some(interval) = self.contact.iter().rev().find(|interval| interval.low <= place) else { return moment.rate };
                interval.at(place, &mut state);
                let branches = self.chain.maxwell.iter().zip(&state).zip(moment.kept.iter().zip(&moment.gained));
                let relaxing: f64 =
                    branches.map(|((&(modulus, rho), u), (kept, gained))| modulus / self.chain.glassy * (u * kept + gained) / rho).sum();
                moment.rate - relaxing
            }
            Way::Outwards => {
                let Some(interval) = self.free.iter().find(|interval| interval.high >= place) else { return moment.rate };
                interval.at(place, &mut state);
                let elements = self.chain.voigt.iter().zip(&state).zip(&moment.recovered);
                moment.rate + elements.map(|((&(rate, _), e), kept)| rate * e * kept).sum::<f64>()
            }
        }
    }

    /// Instants at which the edge is looked at, those that are wanted among them.
    fn looked_at(&self, drive: &Drive, wanted: &[f64]) -> Vec<f64> {
        let whole = drive.duration;
        let even = evenly(whole).chain(wanted.iter().copied());
        let shortest = SHORTEST * self.chain.shortest_time();
        let halved = (4..MOST_HALVINGS).map(|k| whole * 0.5_f64.powi(k)).take_while(|time| *time > shortest);
        let mut times: Vec<f64> = halved.chain(even).collect();
        times.sort_by(f64::total_cmp);
        times
    }

    /// Goes on along a drive, as far as the edge goes one way: how far, which way, and why it ended there. `touched`: the contact has just been found.
    /// `wanted`: instants within it at which the edge is looked at besides.
    pub(super) fn go(&mut self, drive: &Drive, touched: bool, wanted: &[f64]) -> Result<Went, Refusal> {
        self.led(drive, None, touched, self.looked_at(drive, wanted))
    }

    /// The same along a panel that knows its way, and what its polynomial leaves of Δ. Where the edge goes that way from node to node, the end of the panel
    /// is looked at only.
    pub(super) fn follow(&mut self, drive: &Drive, met: &Met, left: f64) -> Result<Went, Refusal> {
        let [_, .., last] = met.places;
        let goes_on = std::iter::once(self.radius()).chain(met.places).is_sorted_by(|one, other| match met.way {
            Way::Inwards => one > other,
            Way::Outwards => one < other,
        });
        let times =
            if goes_on && last > 0.0 && last < self.profile.rim() { vec![drive.duration] } else { evenly(drive.duration).collect() };
        self.led(drive, Some((met.way, left)), true, times)
    }

    fn led(&mut self, drive: &Drive, known: Option<(Way, f64)>, touched: bool, times: Vec<f64>) -> Result<Went, Refusal> {
        self.depth = self.depth.max(drive.start.abs()).max(drive.end().abs());
        let mut moment = Moment::default();
        let mut way: Option<Way> = known.map(|(way, _)| way);
        let noise = known.map_or(0.0, |(_, left)| left).max(self.noise());
        let mut before = 0.0;
        for mut time in times {
            if way.is_none() && self.radius() == 0.0 {
                // A surface that recovers may touch an indenter that goes away, and let go again before it is looked at.
                time = self.nearest(drive, (before, time), &mut moment);
            }
            moment.set(self.chain, drive, time);
            moment.set_free(self.chain, drive, time);
            if way.is_none() {
                let (inside, outside) = self.at_edge(&moment);
                let (inwards, outwards) = (inside.map_or(0.0, |s| -s), outside.unwrap_or(0.0));
                if inwards.max(outwards) <= self.noise() {
                    before = time;
                    continue;
                }
                way = Some(if inwards > outwards { Way::Inwards } else { Way::Outwards });
                if self.radius() == 0.0 && !touched {
                    let touch = self.touched_at(drive, time);
                    if touch > AT_ONCE * drive.duration {
                        self.pass_nothing(&drive.until(touch));
                        return Ok((touch, None, Ended::Touched));
                    }
                }
            }
            let Some(heading) = way else { continue };
            let place = self.edge_after(&moment, heading)?;
            // Less than rounding in all the time since it was last looked at is no turn.
            let least = 8.0 * noise / (time - before);
            let wrong = |rate: f64| match heading {
                Way::Inwards => rate > least,
                Way::Outwards => rate < -least,
            };
            let turned = match place {
                None => false,
                Some(place) if place >= self.profile.rim() => false,
                Some(place) => wrong(self.rate_at(place, &moment, heading)),
            };
            if turned {
                let turn = self.turn(drive, heading, (before, time), least)?;
                if turn > 0.0 {
                    let drive = drive.until(turn);
                    self.pass(&drive, heading, None)?;
                    return Ok((turn, way, Ended::Turned));
                }
                if known.is_some() {
                    break;
                }
                // It turned at once: it goes the other way.
                way = Some(if heading == Way::Inwards { Way::Outwards } else { Way::Inwards });
                before = time;
                continue;
            }
            let whole = place.is_some_and(|place| place >= self.profile.rim()) && self.radius() < self.profile.rim();
            if whole && known.is_none() && heading == Way::Outwards && time < drive.duration {
                // All is touched: from now on it is what presses that tells.
                self.pass(&drive.until(time), heading, None)?;
                return Ok((time, way, Ended::Turned));
            }
            if place.is_none() {
                if known.is_some_and(|(_, left)| self.hardly_lost(drive, left)) {
                    return Ok((0.0, None, Ended::Unresolved));
                }
                // The axis is the last to lose contact.
                let lost = self.lost_at(drive, time);
                if lost < drive.duration {
                    // What has flowed to the end holds nothing: it is lost before any time has gone by.
                    if lost > 0.0 {
                        self.pass(&drive.until(lost), heading, None)?;
                    }
                    self.release_all();
                    return Ok((lost, way, Ended::Lost));
                }
                self.pass(drive, heading, None)?;
                self.release_all();
                return Ok((drive.duration, way, Ended::Lost));
            }
            before = time;
        }
        match way {
            Some(way) => self.pass(drive, way, None)?,
            None => self.pass_nothing(drive),
        }
        Ok((drive.duration, way, Ended::Whole))
    }

    /// Whether S on the axis never falls clearly below zero along a panel, which leaves so much of Δ: a load that has relaxed is positive, however small.
    fn hardly_lost(&self, drive: &Drive, left: f64) -> bool {
        let Some(interval) = self.contact.first() else { return false };
        let mut moment = Moment::default();
        evenly(drive.duration).all(|time| {
            moment.set(self.chain, drive, time);
            self.pressed(interval, &moment)[0] >= -left
        })
    }

    /// The time of an interval at which the surface and an open indenter that went towards each other part again; its end if they do not.
    fn nearest(&self, drive: &Drive, (from, to): (f64, f64), moment: &mut Moment) -> f64 {
        let mut closing = |time: f64| {
            moment.set_free(self.chain, drive, time);
            self.rate_at(0.0, moment, Way::Outwards) > 0.0
        };
        if !closing(from) || closing(to) {
            return to;
        }
        let (mut low, mut high) = (from, to);
        for _ in 0..MOST_ITERATIONS {
            let middle = 0.5 * (low + high);
            if high - low <= f64::EPSILON * high || middle <= low || middle >= high {
                break;
            }
            if closing(middle) { low = middle } else { high = middle }
        }
        moment.set_free(self.chain, drive, low);
        if self.at_edge(moment).1.unwrap_or(0.0) > self.noise() { low } else { to }
    }

    /// When the chain on the axis leaves contact, at most at a time.
    fn lost_at(&self, drive: &Drive, by: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        let Some(interval) = self.contact.first() else { return 0.0 };
        interval.at(interval.low, &mut state);
        let mut moment = Moment::default();
        leaving(self, drive, interval.heights[0], &state, by, by, &mut moment)
    }

    /// When the chain on the axis is touched, at most at a time.
    fn touched_at(&self, drive: &Drive, by: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        if let Some(interval) = self.free.first() {
            interval.at(0.0, &mut state);
        }
        touching(self, drive, self.profile.line(0.0), &state, by, 0.0)
    }

    /// When, between two times, the edge turns: where dS/dt at the edge vanishes.
    /// A rate that rounding leaves is none.
    fn turn(&self, drive: &Drive, way: Way, (from, to): (f64, f64), least: f64) -> Result<f64, Refusal> {
        let mut moment = Moment::default();
        let mut rate = |time: f64| -> Result<f64, Refusal> {
            moment.set(self.chain, drive, time);
            moment.set_free(self.chain, drive, time);
            let place = match self.edge_after(&moment, way)? {
                Some(place) => match way {
                    Way::Inwards => place.min(self.radius()),
                    Way::Outwards => place.max(self.radius()),
                },
                None => 0.0,
            };
            let rate = self.rate_at(place, &moment, way);
            Ok(if way == Way::Inwards { -rate } else { rate })
        };
        let (mut low, mut high) = (from, to);
        let (mut good, mut bad) = (rate(low)?, rate(high)?);
        if good <= least {
            return Ok(from);
        }
        if bad >= 0.0 {
            return Ok(to);
        }
        let mut side = 0;
        for _ in 0..MOST_ITERATIONS {
            let chord = low + (high - low) * good / (good - bad);
            let time = if chord > low && chord < high { chord } else { 0.5 * (low + high) };
            let value = rate(time)?;
            if value >= 0.0 {
                (low, good) = (time, value);
                if side == 1 {
                    bad *= 0.5;
                }
                side = 1;
            } else {
                (high, bad) = (time, value);
                if side == -1 {
                    good *= 0.5;
                }
                side = -1;
            }
            if high - low <= 4.0 * f64::EPSILON * high || value == 0.0 {
                break;
            }
        }
        Ok(low)
    }
}

fn evenly(whole: f64) -> impl Iterator<Item = f64> {
    (1..=EVEN).map(move |k| whole * f64::from(k) / f64::from(EVEN))
}
