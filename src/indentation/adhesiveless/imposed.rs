//! Along a force, a frame or a radius: panels of time, in each of which Δ is a polynomial that meets what is imposed ([`Law`](super::law::Law)), then a
//! drive like one that is given. A panel ends where the edge turns; it is shorter where the polynomial does not end, or passes a place where the line has a
//! kink.

use super::course::Course;
use super::drive::{DEGREE, Drive};
use super::edge::Ended;
use super::law::{Asked, Law, places};
use super::ledger::Gone;
use super::linear::Row;
use super::motions::Wanted;
use super::path_history::Edge;
use super::solve::OF_LAST;
use crate::continuation::bracket::halved;
use crate::indentation::current_segment::CurrentSegment;
use crate::indentation::history::Controlled;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// Time before a contact is lost that is none, over the shortest relaxation time and over the interval.
const NOTHING: f64 = 1e-10;
/// The same after it is found, over what is left: what the strains miss of it goes with its square.
const SOON: f64 = 1e-8;
/// A panel over less than this part of the time that counts is not shortened further: what it leaves counts as unknown.
const SHORTEST: f64 = 1e-13;
/// Part of the way to a force that vanishes, growth and shrinkage of panels.
const TOWARDS: f64 = 0.7;
const FASTEST: f64 = 16.0;
const SLOWEST: f64 = 0.25;
/// A panel that does not end is shortened at most so much at once, and at least so much; one that passes a kink is cut there, if so much of it is left.
const SHORTENED: [f64; 2] = [1e-4, 0.7];
const TO_A_KINK: [f64; 2] = [1e-3, 0.95];
/// Orders at which what a panel leaves goes with its length.
const ORDERS: [f64; 2] = [0.25, DEGREE as f64];
const GROWTH: f64 = 1.5;
/// A panel that is twice no better for being shorter leaves rounding; it is not believed to be so much over what is allowed.
const NO_BETTER: f64 = 0.9;
const TWICE: u32 = 2;
const MOST_NOISE: f64 = 300.0;
const MOST_PANELS: u32 = 200_000;
/// What a panel may leave over what series may, and what rounding leaves of it, over the depth.
const OF_SERIES: f64 = 0.3;
const ROUNDING: f64 = 1e-13;
/// So many times what presses by rounding presses.
const MANY: f64 = 4.0;
/// Times that differ by so much of the later one are the same.
const SAME_TIME: f64 = 4.0 * f64::EPSILON;
/// Instants at which it is looked whether something imposed passes zero.
const LOOKS: u32 = 64;

impl Course<'_> {
    /// What is imposed, and in which unit.
    pub(super) fn asked(&self, controlled: Controlled) -> (Asked, f64) {
        let twice = 2.0 * self.chain.glassy;
        match controlled {
            Controlled::Force => (Asked::Load { of_force: 1.0, of_depth: 0.0 }, twice.recip()),
            Controlled::Frame => (Asked::Load { of_force: self.problem.frame_stiffness.map_or(0.0, |k| twice / k), of_depth: 1.0 }, 1.0),
            Controlled::Penetration => (Asked::Load { of_force: 0.0, of_depth: 1.0 }, 1.0),
            Controlled::ContactRadius => (Asked::Radius, 1.0),
        }
    }

    /// Goes towards a time of an interval that controls something else than the penetration; instants before it are kept on the way.
    pub(super) fn toward(&mut self, current: &CurrentSegment, target: f64, mut wanted: &[Wanted]) -> Result<(), Refusal> {
        let controlled = current.segment.controlled;
        let given = self.drive(current, target);
        let (whole, start) = (given.duration, self.time);
        let (mut at, mut panels) = (0.0, 0);
        while at < whole {
            panels += 1;
            if panels > MOST_PANELS {
                return Err(Refusal::NotConverged { what: "a force or a frame", detail: format!("at t = {:e}", self.now()) });
            }
            self.time = start + at;
            self.keep_reached(&mut wanted, self.time + SAME_TIME * target);
            let nothing = NOTHING * self.chain.shortest_time().min(whole);
            if self.line.radius() == 0.0 {
                // What the contact that was lost leaves pressing, by rounding, does not press.
                let excess = (given.value(at) - self.line.surface_after(0.0)).max(0.0);
                let touch = self.until(&given, at, |course, time| course.presses(controlled, &given, at, time, excess));
                // A frame takes the indenter along: instants on the way are stops.
                let stop = wanted.first().map_or(whole, |instant| instant.time - start);
                self.stay_open(controlled, &given, at, touch.min(stop))?;
                at = touch.min(stop);
                if at < whole && touch <= stop {
                    let soon = SOON * (whole - at);
                    self.stay_open(controlled, &given, at, at + soon)?;
                    at += soon;
                    self.settle(controlled, given.value(at))?;
                    self.corner();
                }
                continue;
            }
            let pulls = matches!(controlled, Controlled::Force | Controlled::ContactRadius);
            let gone = if pulls {
                self.until(&given, at, |_, time| given.value(time) < 0.0 || (time > at && given.value(time) <= 0.0))
            } else {
                f64::INFINITY
            };
            let vanishes = gone < whole || given.end() <= 0.0;
            // What presses hardly at all is let go at once; instants before its end still see it pressed.
            let seen = wanted.first().map(|instant| instant.time - start).filter(|time| *time < gone);
            let unresolved = pulls && vanishes && self.presses_no_more(&given, at, gone);
            let soon = gone - at <= nothing.max(4.0 * f64::EPSILON * gone) || unresolved && seen.is_none();
            if pulls && vanishes && soon {
                self.time = start + gone;
                self.let_go()?;
                self.lost(None);
                self.line.pass_nothing(&Drive::straight(self.line.penetration, self.line.penetration, gone - at));
                at = gone;
                continue;
            }
            let most = match seen {
                Some(time) if unresolved => time - at,
                _ if pulls && vanishes => TOWARDS * (gone - at),
                _ => whole - at,
            };
            at += self.panel(controlled, &given, at, most, &mut wanted)?;
        }
        self.time = start + whole;
        if (self.time - target).abs() <= SAME_TIME * target {
            self.time = target;
        }
        self.keep_reached(&mut wanted, target);
        Ok(())
    }

    /// One panel, at most so long: how long it was.
    fn panel(&mut self, controlled: Controlled, given: &Drive, at: f64, most: f64, wanted: &mut &[Wanted]) -> Result<f64, Refusal> {
        let (asked, unit) = self.asked(controlled);
        let least = SHORTEST * self.chain.shortest_time().min(given.duration);
        let mut length = if self.panel_length > 0.0 { self.panel_length } else { self.chain.shortest_time().min(most) };
        length = length.min(most);
        if matches!(asked, Asked::Radius) {
            length = one_way(given, at, length);
        }
        if most - length < 0.2 * length && !matches!(asked, Asked::Radius) {
            length = most;
        }
        let (mut best, mut worse, mut shortened) = (f64::INFINITY, 0, false);
        let mut longer: Option<(f64, f64)> = None;
        let first = length;
        loop {
            let target: Row = places().map(|part| unit * given.value(at + part * length));
            let law = Law::new(&self.line, self.fresh, length);
            self.evaluations += 1;
            let met = law.met(asked, &target, self.depth_rate)?;
            let start = self.line.penetration;
            let Some(met) = met else {
                if length <= least {
                    return Err(Refusal::NotConverged { what: "a force or a frame", detail: format!("at t = {:e}", self.now()) });
                }
                length *= SLOWEST;
                continue;
            };
            let rises = met.depths.map(|depth| depth - start);
            let reach = rises.iter().fold(self.line.depth, |most, rise| most.max((start + rise).abs()));
            let (left, allowed) = (
                tail(&rises),
                (OF_SERIES * self.fineness.series).max(self.chain.noise.iter().flatten().sum::<f64>()).max(ROUNDING) * reach,
            );
            let factor = if left > 0.0 { (0.3 * allowed / left).powf(1.0 / DEGREE as f64) } else { FASTEST };
            let noise = met.noise.max(imposed_rounding(asked, unit * given.start.abs().max(given.end().abs()), &met.places));
            let (own, allowed) = (allowed, allowed.max(noise));
            if left > allowed {
                worse = if left > NO_BETTER * best { worse + 1 } else { 0 };
                let rounding = left < MOST_NOISE * allowed && worse >= TWICE;
                (best, shortened) = (left.min(best), true);
                if length > least && !rounding {
                    let passed = law.passes(&met).filter(|part| *part > TO_A_KINK[0] && *part < TO_A_KINK[1]);
                    // What two lengths leave tells the order, where both are clear of rounding.
                    let order = longer.filter(|_| left > MOST_NOISE * allowed).map(|(other, of_other)| {
                        let order = (left / of_other).ln() / (length / other).ln();
                        (0.3 * allowed / left).powf(order.clamp(ORDERS[0], ORDERS[1]).recip()).max(SHORTENED[0])
                    });
                    longer = Some((length, left));
                    length *= passed.unwrap_or_else(|| order.unwrap_or(factor.max(SLOWEST)).min(SHORTENED[1]));
                    continue;
                }
                self.line.everywhere += left.min(own * MOST_NOISE);
            } else {
                self.line.cut = self.line.cut.max(OF_LAST * left);
            }
            let through = |depths: &Row| {
                let points: Vec<(f64, f64)> = places().into_iter().zip(depths.map(|depth| depth - start)).collect();
                Drive::through(start, length, &points)
            };
            let mut drive = through(&met.depths);
            (self.left, self.left_of_panel) = (allowed, left);
            let before = self.before(wanted.first().is_some_and(|instant| instant.time - self.time < length));
            let edge = matches!(asked, Asked::Radius).then_some(Edge { given, since: at });
            let mut went = if edge.is_some() {
                self.line.pass(&drive, met.way, edge.as_ref())?;
                (length, Some(met.way), Ended::Whole)
            } else if met.rests {
                self.line.pass_nothing(&drive);
                (length, None, Ended::Whole)
            } else {
                self.line.follow(&drive, &met, allowed)?
            };
            if went.2 == Ended::Unresolved {
                drive = through(&Law::new(&self.line, self.fresh, length).resting().depths);
                self.line.pass_nothing(&drive);
                went = (length, None, Ended::Whole);
            }
            let (passed, way, ended) = went;
            // Turned at once: rounding, for a panel knows its way.
            let rests = passed <= 0.0 && ended == Ended::Turned;
            if rests {
                self.line.pass_nothing(&drive);
            }
            if let Some(before) = before.filter(|_| rests || passed > 0.0) {
                let stiffness = self.problem.frame_stiffness.unwrap_or(0.0);
                let of_frame = |time: f64| stiffness * (given.value(at + time) - drive.value(time));
                let of_force = |time: f64| given.value(at + time);
                let force: Option<&dyn Fn(f64) -> f64> = match controlled {
                    Controlled::Force => Some(&of_force),
                    Controlled::Frame => Some(&of_frame),
                    _ => None,
                };
                let (part, way) = if rests { (drive, None) } else { (drive.until(passed), way) };
                self.gone(&Gone { before: &before, drive: part, way, edge, since: self.time, force }, wanted)?;
            }
            // What rounding leaves is no less of a shorter panel.
            let (length, shortened) = if left > allowed { (first, false) } else { (length, shortened) };
            self.panel_length = (length * factor.clamp(if shortened { SLOWEST } else { GROWTH }, FASTEST)).max(2.0 * least);
            self.time += if rests { drive.duration } else { passed };
            self.depth_rate = (passed > 0.0).then(|| drive.rate(passed));
            // A panel may end just where the edge reaches the axis.
            match ended {
                Ended::Whole | Ended::Touched | Ended::Unresolved if self.line.radius() > 0.0 => {}
                Ended::Whole | Ended::Touched | Ended::Unresolved | Ended::Lost => self.lost(Some(drive.rate(passed))),
                Ended::Turned => self.turned(),
            }
            return Ok(if rests { drive.duration } else { passed.max(f64::MIN_POSITIVE) });
        }
    }

    /// The first time from another one on at which something is so.
    fn until(&self, given: &Drive, from: f64, is_so: impl Fn(&Self, f64) -> bool) -> f64 {
        let whole = given.duration;
        let mut before = from;
        for k in 0..=LOOKS {
            let time = if k == LOOKS { whole } else { from + (whole - from) * f64::from(k) / f64::from(LOOKS) };
            if is_so(self, time) {
                return halved([before, time], |time| !is_so(self, time))[1];
            }
            before = time;
        }
        whole
    }

    /// Whether what falls until it is gone presses less now than what series leave.
    fn presses_no_more(&self, given: &Drive, at: f64, gone: f64) -> bool {
        let left = (self.fineness.series * self.line.depth).max(self.line.unknown());
        let now = given.value(at);
        let falls = || (1..=LOOKS).all(|k| given.value(at + (gone - at) * f64::from(k) / f64::from(LOOKS)) <= now);
        gone.is_finite() && self.line.pressing_at(0.0) <= left && falls()
    }

    /// Whether what is imposed at a time presses an indenter that has been open since another one.
    fn presses(&self, controlled: Controlled, given: &Drive, since: f64, time: f64, excess: f64) -> bool {
        let value = given.value(time);
        match controlled {
            Controlled::Force | Controlled::ContactRadius => value > 0.0,
            Controlled::Frame | Controlled::Penetration => {
                let noise = (self.fineness.series.max(ROUNDING) * self.line.depth).max(self.left).max(MANY * excess);
                value > self.line.surface_after(time - since) + noise
            }
        }
    }

    /// Lets a time pass in which nothing presses: a frame takes the indenter along; without one it stays, unless the surface comes up to it.
    fn stay_open(&mut self, controlled: Controlled, given: &Drive, from: f64, to: f64) -> Result<(), Refusal> {
        if to <= from {
            return Ok(());
        }
        let depth = self.line.penetration;
        let (drive, before) = (Drive::straight(depth, depth, to - from), self.before(false));
        self.line.pass_nothing(&drive);
        if let Some(before) = before {
            self.add_up(&Gone { before: &before, drive, way: None, edge: None, since: self.time, force: Some(&|_| 0.0) }, &[])?;
        }
        let surface = self.line.surface_after(0.0);
        self.line.went_to(if controlled == Controlled::Frame { given.value(to) } else { depth }.min(surface));
        self.time += to - from;
        self.corner();
        Ok(())
    }
}

/// How long, at most so long, a quantity goes one way from a time on.
fn one_way(given: &Drive, from: f64, longest: f64) -> f64 {
    let rate = |k: u32| given.rate(from + longest * f64::from(k) / f64::from(LOOKS));
    let Some(way) = (1..=LOOKS).map(rate).find(|rate| *rate != 0.0) else { return longest };
    let Some(turned) = (2..=LOOKS).find(|k| rate(*k) * way < 0.0) else { return longest };
    let part = longest / f64::from(LOOKS);
    halved([part * f64::from(turned - 1), part * f64::from(turned)], |time| given.rate(from + time) * way > 0.0)[0]
}

/// What rounding of something imposed, which may be as large, leaves of Δ: a small contact tells it least.
fn imposed_rounding(asked: Asked, largest: f64, places: &Row) -> f64 {
    match asked {
        Asked::Radius => 0.0,
        Asked::Load { of_force, of_depth } => {
            let smallest = places.iter().fold(f64::INFINITY, |least, place| least.min(*place));
            2.0 * f64::EPSILON * largest / (of_force * smallest + of_depth).max(f64::MIN_POSITIVE)
        }
    }
}

/// The last coefficients of the Chebyshev series through nodes: where a contact is lost on the way, one alone may be small by chance.
fn tail(rises: &Row) -> f64 {
    let coefficient = |order: usize| {
        let whole = DEGREE as f64;
        let terms = rises.iter().enumerate().map(|(k, rise)| {
            let half = if k + 1 == DEGREE { 0.5 } else { 1.0 };
            half * rise * (PI * (order * (k + 1)) as f64 / whole).cos()
        });
        (if order == DEGREE { 1.0 } else { 2.0 } / whole * terms.sum::<f64>()).abs()
    };
    coefficient(DEGREE).max(0.5 * coefficient(DEGREE - 1))
}
