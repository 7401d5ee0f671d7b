//! Forces, frames and radii that are imposed: Δ follows from what is imposed at each instant.
//!
//! On a surface that nothing has touched, a force gives Δ at once ([`Fresh`](super::fresh::Fresh)). Else Δ is the polynomial through its last values
//! whose newest one meets what is imposed at the end of the step; every trial of it is a drive of its own, solved as any other.

use super::course::Course;
use super::drive::{DEGREE, Drive, Moment};
use super::edge::Ended;
use super::fresh::Moved;
use super::grid::NODES;
use super::line::Line;
use crate::indentation::history::Controlled;
use crate::indentation::stretch::Stretch;
use crate::refusal::Refusal;

/// Values behind a polynomial, besides the present one.
const BEHIND: usize = 5;
/// First step after a corner, over the shortest time that counts, at a tolerance of 1.
const FIRST: f64 = 0.1;
/// Change of Δ at which what is imposed is met, over the error of a step.
const MET: f64 = 1e-5;
/// Growth and shrinkage of steps.
const FASTEST: f64 = 2.5;
const SLOWEST: f64 = 0.2;
/// Part of a step's change against its prediction that is its error.
const OF_CHANGE: f64 = 0.2;
/// Shortest step, over the stretch and over its time.
const SHORTEST: f64 = 1e-16;
/// Time left of a force that vanishes, over the stretch, at which the contact is let go.
const VANISHING: f64 = 1e-10;
/// Part of a drive that is no time to wait.
const NEAR: f64 = 1e-9;
/// Δ that rounding leaves, over the depth.
const ROUNDING: f64 = 1e-14;
/// Iterations of one unknown, and trials of one step.
const MOST_ITERATIONS: u32 = 60;
const MOST_TRIALS: u32 = 200;
/// Instants at which it is seen whether a fresh contact grows on.
const LOOKS: u32 = 64;
/// Force that is none, over the largest of a stretch.
const NO_FORCE: f64 = 1e-14;

impl<'a> Course<'a> {
    /// Goes some way towards a time of a stretch that controls something else than the penetration.
    pub(super) fn toward(&mut self, stretch: &Stretch, controlled: Controlled, target: f64) -> Result<(), Refusal> {
        let open = self.line.radius() == 0.0;
        match controlled {
            Controlled::Force | Controlled::ContactRadius if open => {
                let rest = self.until_pressed(stretch, target);
                if rest > 0.0 {
                    return self.rest(rest);
                }
            }
            Controlled::Frame if open => {
                // Without a force the far end of the frame is where the indenter is.
                let drive = self.drive(stretch, target);
                let touch = self.line.until_touch(&drive);
                // A touch that is near lies within the next step.
                if touch > NEAR * drive.duration {
                    let end = self.time + drive.duration;
                    let part = if touch < drive.duration { drive.until(touch) } else { drive };
                    self.line.pass_nothing(&part);
                    self.time = if touch < drive.duration { end - (drive.duration - touch) } else { end };
                    if touch < drive.duration {
                        self.turned();
                        self.corner();
                    }
                    return Ok(());
                }
            }
            _ => {}
        }
        if controlled == Controlled::Force && self.line.is_fresh_outside() && self.growing(stretch, target)? {
            return Ok(());
        }
        self.step(stretch, controlled, target)
    }

    /// How long an open contact stays open under a force or a radius that is none.
    fn until_pressed(&self, stretch: &Stretch, target: f64) -> f64 {
        let none = NO_FORCE * largest(stretch);
        let pressed = |time: f64| stretch.value(time) > none;
        let soon = self.time + 1e-9 * (target - self.time);
        if pressed(soon) && stretch.value(self.time) >= 0.0 {
            return 0.0;
        }
        let step = (target - self.time) / f64::from(LOOKS);
        for k in 1..=LOOKS {
            let time = if k == LOOKS { target } else { self.time + step * f64::from(k) };
            if pressed(time) {
                let (mut low, mut high) = (self.time + step * f64::from(k - 1), time);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if pressed(middle) { high = middle } else { low = middle }
                }
                return low - self.time;
            }
        }
        target - self.time
    }

    /// An indenter that nothing presses: it stays where it lost contact, unless the surface comes up to it and takes it along.
    fn rest(&mut self, duration: f64) -> Result<(), Refusal> {
        let depth = self.line.penetration;
        let drive = Drive::straight(depth, depth, duration);
        self.line.pass_nothing(&drive);
        let surface = self.line.surface();
        self.line.went_to(depth.min(surface));
        self.time += duration;
        self.corner();
        Ok(())
    }

    /// A fresh contact that grows under its force: as far as that goes; whether it went at all.
    fn growing(&mut self, stretch: &Stretch, target: f64) -> Result<bool, Refusal> {
        let force = self.drive(stretch, target);
        let moved = Moved { chain: self.chain, force, strains: self.line.whole_strains() };
        let whole = force.duration;
        let falls = |time: f64| {
            // An elastic contact follows its force down as well.
            let (value, rate) = moved.at(time);
            !moved.chain.maxwell.is_empty() && rate < -moved.rounding(time) - 1e-14 * value / whole
        };
        let mut until = whole;
        let mut before = 0.0;
        let halved = (4..70).rev().map(|k| whole * 0.5_f64.powi(k));
        let even = (1..=16).map(|k| whole * f64::from(k) / 16.0);
        for time in halved.chain(even) {
            if falls(time) {
                let (mut low, mut high) = (before, time);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    if falls(middle) { high = middle } else { low = middle }
                }
                until = low;
                break;
            }
            before = time;
        }
        if until <= 1e-9 * whole {
            return Ok(false);
        }
        let end = self.time + whole;
        let depth_at = |course: &Self, time: f64| course.fresh.depth(0.5 * moved.at(time).0);
        let reached = depth_at(self, until)?;
        self.line.depth = self.line.depth.max(reached);
        let start_time = self.time;
        let mut at = 0.0;
        if self.line.radius() == 0.0 {
            // So short a time that nothing relaxes and little is pressed.
            let mut short = (1e-14 * self.chain.shortest_time()).min(1e-12 * until);
            while short < 1e-3 * until && depth_at(self, 4.0 * short)? <= 1e-12 * reached {
                short *= 4.0;
                if short > 1e-14 * self.chain.shortest_time() {
                    break;
                }
            }
            at = short.min(until);
            let depth = depth_at(self, at)?;
            self.line.leap(depth)?;
        }
        let mut length = if at > 0.0 { 3.0 * at } else { until };
        let allowed = (0.1 * self.fineness.series).max(1e-14) * reached;
        while at < until {
            length = length.min(until - at);
            if until - at < 1.2 * length {
                length = until - at;
            }
            let start = self.line.penetration;
            let mut failed = None;
            let drive = Drive::fitted(start, length, |time| {
                depth_at(self, at + time).unwrap_or_else(|refusal| {
                    failed = Some(refusal);
                    f64::NAN
                })
            });
            if let Some(refusal) = failed {
                return Err(refusal);
            }
            let mut off = 0.0_f64;
            for part in [0.03, 0.3, 0.62, 0.93] {
                off = off.max((drive.value(part * length) - depth_at(self, at + part * length)?).abs());
            }
            if off > allowed && length > 1e-6 * at.max(1e-12 * until) {
                length *= 0.6;
                continue;
            }
            self.along(&drive)?;
            at += length;
            self.time = if at >= until { start_time + until } else { start_time + at };
            if off < 0.02 * allowed {
                length *= 1.7;
            }
        }
        if until < whole {
            self.time = start_time + until;
            self.corner();
        } else {
            self.time = end;
        }
        Ok(true)
    }

    /// How fast the excess rises with a Δ that is reached in a time.
    fn stiffness(&self, controlled: Controlled, duration: f64) -> f64 {
        let of_time: f64 = self
            .chain
            .maxwell
            .iter()
            .map(|&(modulus, rho)| modulus * if duration > 0.0 { -(-duration / rho).exp_m1() * rho / duration } else { 1.0 })
            .sum();
        let force = 2.0 * self.line.radius() * (self.chain.relaxed + of_time);
        match controlled {
            Controlled::Force => force,
            Controlled::Frame => 1.0 + self.problem.frame_stiffness.map_or(0.0, |k| force / k),
            Controlled::ContactRadius | Controlled::Penetration => 1.0,
        }
    }

    /// One step: a trial of Δ at its end is a drive through the last values.
    fn step(&mut self, stretch: &Stretch, controlled: Controlled, target: f64) -> Result<(), Refusal> {
        let left = target - self.time;
        let least = (SHORTEST * stretch.segment.duration).max(8.0 * f64::EPSILON * self.time);
        let opening = self.line.radius() == 0.0;
        if self.step == 0.0 {
            let pace = stretch.segment.oscillation.map_or(f64::INFINITY, |it| it.frequency_at(self.time, stretch.segment.duration).recip());
            let counts = self.chain.shortest_time().min(stretch.segment.duration).min(pace);
            self.step = (FIRST * self.fineness.steps.powf(0.4) * counts).max(least);
            if opening && controlled != Controlled::Frame {
                // Δ goes with a broken power of the time from there.
                self.step = 16.0 * least;
            }
        }
        let longest = stretch.segment.oscillation.map_or(f64::INFINITY, |it| 0.1 / it.frequency_at(self.time, stretch.segment.duration));
        for _ in 0..MOST_TRIALS {
            let mut dt = self.step.min(left).min(longest);
            if left - dt < 0.1 * dt {
                dt = left;
            }
            let mut value = stretch.value(self.time + dt);
            let pulls = matches!(controlled, Controlled::Force | Controlled::ContactRadius);
            if pulls && value <= 0.0 {
                // The contact is lost where the force vanishes: nearer and nearer to it.
                let (mut low, mut high) = (0.0, dt);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    if stretch.value(self.time + middle) > 0.0 { low = middle } else { high = middle }
                }
                if low <= VANISHING * stretch.segment.duration || stretch.value(self.time) <= 0.0 {
                    self.time = if high >= left * (1.0 - 1e-9) { target } else { self.time + high };
                    self.let_go()?;
                    self.lost();
                    return Ok(());
                }
                dt = 0.5 * low;
                value = stretch.value(self.time + dt);
            }
            let now = self.line.penetration;
            let mut behind: Vec<(f64, f64)> =
                self.past.iter().rev().take(BEHIND).map(|&(t, depth)| ((t - self.time) / dt, depth - now)).collect();
            // Values close to each other tell little but their rounding.
            let mut louder = amplified(&behind);
            while behind.len() > 1 && louder * ROUNDING > 0.1 * self.fineness.steps {
                behind.pop();
                louder = amplified(&behind);
            }
            let predicted = match behind.len() {
                0 => now,
                _ => {
                    let drive = Drive::through(now, dt, behind.get(..behind.len().min(DEGREE - 1)).unwrap_or(&[]));
                    drive.value(dt)
                }
            };
            let slope = self.stiffness(controlled, dt);
            let (mut best, mut found) = (None, now);
            {
                let line = &self.line;
                let count = &mut self.evaluations;
                let mut trial = |depth: f64| -> Result<(f64, Line<'a>, Vec<(f64, Ended)>), Refusal> {
                    *count += 1;
                    let mut points = behind.clone();
                    points.push((1.0, depth - now));
                    let drive = Drive::through(now, dt, &points);
                    let mut after = line.clone();
                    let happened = after.travel(&drive)?;
                    Ok((depth, after, happened))
                };
                let tolerance = (MET * self.fineness.steps).max(ROUNDING) * line.depth;
                let (mut low, mut high): (Option<(f64, f64)>, Option<(f64, f64)>) = (None, None);
                let mut depth = predicted;
                let mut steepness = slope;
                let mut last: Option<(f64, f64)> = None;
                for _ in 0..MOST_ITERATIONS {
                    let (_, after, happened) = trial(depth)?;
                    let excess = excess_of(self.problem.frame_stiffness, &after, controlled, value);
                    best = Some((after, happened));
                    found = depth;
                    if excess == 0.0 {
                        break;
                    }
                    if excess > 0.0 {
                        high = Some((depth, excess))
                    } else {
                        low = Some((depth, excess))
                    }
                    let secant = last.filter(|(other, _)| (depth - other).abs() > 100.0 * tolerance);
                    let secant = secant.map_or(steepness, |(other, of_other)| (excess - of_other) / (depth - other));
                    let secant = if secant > 0.0 && secant.is_finite() { secant } else { slope };
                    steepness = secant;
                    last = Some((depth, excess));
                    let mut next = depth - excess / secant;
                    match (low, high) {
                        (Some((below, _)), Some((above, _))) if !(next > below && next < above) => next = 0.5 * (below + above),
                        (None, _) | (_, None) if !next.is_finite() => {
                            next = depth - excess.signum() * (1e-3 * self.line.depth).max(f64::MIN_POSITIVE);
                        }
                        _ => {}
                    }
                    if (next - depth).abs() <= tolerance {
                        break;
                    }
                    depth = next;
                }
            }
            let Some((after, happened)) = best else { break };
            let depth = self.line.depth.max(after.depth);
            let change = if behind.is_empty() { 0.0 } else { OF_CHANGE * ((found - predicted).abs() - louder * ROUNDING * depth).max(0.0) };
            let order = (behind.len() + 2) as f64;
            let error = change / (self.fineness.steps * depth);
            let factor = if error > 0.0 { 0.9 * error.powf(-1.0 / order) } else { FASTEST };
            if error > 1.0 && dt > least {
                self.step = dt * factor.clamp(SLOWEST, 0.9);
                continue;
            }
            self.past.push((self.time, now));
            let spare = self.past.len().saturating_sub(BEHIND);
            self.past.drain(..spare);
            self.line = after;
            self.time = if dt == left { target } else { self.time + dt };
            self.step = if dt < self.step {
                self.step.min(dt * factor.clamp(SLOWEST, FASTEST)).max(dt)
            } else {
                dt * factor.clamp(SLOWEST, FASTEST)
            };
            let lost = happened.iter().any(|(_, ended)| *ended == Ended::Lost) && self.line.radius() == 0.0;
            if lost {
                self.lost();
            } else if happened.is_empty() {
                if self.time < target {
                    self.point(false);
                }
            } else {
                self.turned();
                let keep = self.past.len().saturating_sub(2);
                self.past.drain(..keep);
            }
            return Ok(());
        }
        Err(Refusal::NotConverged { what: "a step of the contact", detail: format!("at t = {:e}", self.now()) })
    }

    /// The contact is lost with its force.
    fn let_go(&mut self) -> Result<(), Refusal> {
        let pressed = self.line.pressing_at(0.0);
        let depth = self.line.penetration - pressed;
        self.line.leap(depth)?;
        self.line.release_all();
        self.line.went_to(depth.min(self.line.surface()));
        Ok(())
    }

    /// Meets an imposed value at once.
    pub(super) fn settle(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        if controlled == Controlled::Penetration {
            self.line.leap(value)?;
            return Ok(());
        }
        let pulls = matches!(controlled, Controlled::Force | Controlled::ContactRadius);
        if pulls && value <= 0.0 {
            if self.line.radius() > 0.0 {
                self.let_go()?;
            }
            return Ok(());
        }
        if controlled == Controlled::ContactRadius && value > self.line.profile.rim() {
            return Err(Refusal::NoSuchState {
                reason: format!("the contact of a punch reaches no further than its rim, not to {value:e}"),
                limit_name: "the radius of its rim",
                limit: self.line.profile.rim(),
            });
        }
        // What is met rises with Δ.
        let here = self.line.penetration;
        let mut size = match controlled {
            Controlled::Frame => value.abs().max(here.abs()),
            Controlled::ContactRadius => self.line.profile.line(value),
            _ => self.fresh.depth(0.5 * value / self.chain.glassy)?,
        };
        size = size.max(f64::MIN_POSITIVE);
        let excess = |course: &mut Self, depth: f64| -> Result<(f64, Line<'a>), Refusal> {
            course.evaluations += 1;
            let mut line = course.line.clone();
            line.leap(depth)?;
            let excess = excess_of(course.problem.frame_stiffness, &line, controlled, value);
            Ok((excess, line))
        };
        let (first, mut line) = excess(self, here)?;
        let (mut low, mut high) = ((here, first), (here, first));
        let mut way = size;
        for _ in 0..MOST_ITERATIONS {
            if low.1 <= 0.0 && high.1 >= 0.0 {
                break;
            }
            let depth = if low.1 > 0.0 { low.0 - way } else { high.0 + way };
            let (value, _) = excess(self, depth)?;
            if low.1 > 0.0 {
                high = low;
                low = (depth, value);
            } else {
                low = high;
                high = (depth, value);
            }
            way *= 2.0;
        }
        let mut side = 0;
        for _ in 0..MOST_ITERATIONS {
            if low.1 == 0.0 {
                high = low;
            }
            if high.0 - low.0 <= 2.0 * f64::EPSILON * high.0.abs().max(low.0.abs()) {
                break;
            }
            let chord = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            let depth = if chord > low.0 && chord < high.0 { chord } else { 0.5 * (low.0 + high.0) };
            let (value, after) = excess(self, depth)?;
            line = after;
            if value == 0.0 {
                (low, high) = ((depth, 0.0), (depth, 0.0));
                break;
            }
            if value < 0.0 {
                low = (depth, value);
                if side == -1 {
                    high.1 *= 0.5;
                }
                side = -1;
            } else {
                high = (depth, value);
                if side == 1 {
                    low.1 *= 0.5;
                }
                side = 1;
            }
        }
        let depth = if high.1.abs() < low.1.abs() { high.0 } else { low.0 };
        if line.penetration.to_bits() != depth.to_bits() {
            line = excess(self, depth)?.1;
        }
        self.line = line;
        Ok(())
    }

    /// A contact that has been held until it has relaxed.
    pub(super) fn relaxed(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        let modulus = self.chain.relaxed;
        if modulus == 0.0 && value > 0.0 {
            return Err(Refusal::Undefined {
                quantity: "the relaxed contact",
                reason: "the material has no relaxed modulus: it flows for ever; start untouched and hold".into(),
            });
        }
        let depth = match controlled {
            Controlled::Penetration => value,
            Controlled::ContactRadius => self.line.profile.line(value),
            Controlled::Force => self.fresh.depth(0.5 * value / modulus)?,
            Controlled::Frame => {
                let stiffness = self.problem.frame_stiffness.unwrap_or(f64::INFINITY);
                // Δ + 2E0*Φ/k_f = value: the load rises with Δ.
                let (mut low, mut high) = (0.0, value.max(0.0));
                for _ in 0..200 {
                    let middle = 0.5 * (low + high);
                    let load = self.fresh.depth(0.5 * stiffness * (value - middle) / modulus)?;
                    // More force than Δ asks for: deeper.
                    if load > middle {
                        low = middle
                    } else {
                        high = middle
                    }
                    if high - low <= f64::EPSILON * high {
                        break;
                    }
                }
                if value > 0.0 { 0.5 * (low + high) } else { value }
            }
        };
        self.line.rested(depth)
    }
}

/// By how much the polynomial through earlier places and 0 makes an error of its values larger at 1.
fn amplified(behind: &[(f64, f64)]) -> f64 {
    let places = || behind.iter().map(|point| point.0).chain([0.0]);
    let weight = |k: usize, own: f64| {
        places().enumerate().filter(|(l, _)| *l != k).map(|(_, other)| (1.0 - other) / (own - other)).product::<f64>().abs()
    };
    places().enumerate().map(|(k, own)| weight(k, own)).sum()
}

/// The largest value that a stretch imposes.
fn largest(stretch: &Stretch) -> f64 {
    let amplitude = stretch.segment.oscillation.map_or(0.0, |oscillation| oscillation.amplitude);
    stretch.from.abs().max(stretch.segment.end.abs()) + amplitude
}

/// What an imposed value leaves: it rises with Δ.
fn excess_of(stiffness: Option<f64>, line: &Line<'_>, controlled: Controlled, value: f64) -> f64 {
    match controlled {
        Controlled::Penetration => line.penetration - value,
        Controlled::Force => line.force() - value,
        Controlled::Frame => line.penetration + stiffness.map_or(0.0, |k| line.force() / k) - value,
        Controlled::ContactRadius => line.pressing_at(value),
    }
}

impl Line<'_> {
    /// Goes along a whole drive: what happened on the way.
    pub(super) fn travel(&mut self, drive: &Drive) -> Result<Vec<(f64, Ended)>, Refusal> {
        let mut happened = Vec::new();
        let mut drive = *drive;
        let mut since = 0.0;
        for _ in 0..64 {
            let (time, ended) = self.go(&drive)?;
            if ended == Ended::Whole {
                break;
            }
            since += time;
            happened.push((since, ended));
            if drive.duration - time <= 4.0 * f64::EPSILON * drive.duration {
                self.leap(drive.end())?;
                break;
            }
            drive = drive.rest(time);
        }
        Ok(happened)
    }

    /// S at a place now.
    pub(super) fn pressing_at(&self, place: f64) -> f64 {
        let mut state = vec![0.0; self.chain.terms()];
        if let Some(stretch) = self.contact.iter().find(|stretch| place <= stretch.high) {
            stretch.at(place, &mut state);
            let soft = self.chain.relaxed / self.chain.glassy * (self.penetration - self.profile.line(place));
            return soft + self.chain.maxwell.iter().zip(&state).map(|((modulus, _), u)| modulus / self.chain.glassy * u).sum::<f64>();
        }
        if let Some(stretch) = self.free.iter().find(|stretch| place <= stretch.high) {
            stretch.at(place, &mut state);
        }
        self.penetration - self.profile.line(place) - state.iter().sum::<f64>()
    }

    /// How long an open contact stays open along a drive of the penetration.
    pub(super) fn until_touch(&self, drive: &Drive) -> f64 {
        let mut moment = Moment::default();
        let noise = 2e-15 * self.depth;
        let mut overlap = |time: f64| {
            moment.set_free(self.chain, drive, time);
            match self.free.first() {
                Some(stretch) => self.opened(stretch, &moment)[0],
                None => moment.depth - self.profile.line(0.0),
            }
        };
        let mut before = 0.0;
        for k in 0..=64 {
            let time = drive.duration * f64::from(k) / 64.0;
            if overlap(time) > noise {
                let (mut low, mut high) = (before, time);
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    if overlap(middle) > noise { high = middle } else { low = middle }
                }
                return low;
            }
            before = time;
        }
        drive.duration
    }

    /// A relaxed contact at a penetration: no spring of a branch holds anything.
    pub(super) fn rested(&mut self, penetration: f64) -> Result<(), Refusal> {
        self.went_to(penetration);
        let edge = self.virgin_edge(penetration, 0.0)?;
        let mut stretches = Vec::new();
        if edge > 0.0 && penetration > 0.0 {
            self.build((0.0, edge), true, &mut |_, _, state| state.fill(0.0), &mut stretches);
        }
        self.contact = stretches;
        Ok(())
    }

    /// The least of what must not be negative, Q/E∞* inside and D outside (m), and what Q leaves at the edge, over the depth.
    pub(super) fn least(&self) -> (f64, f64) {
        let mut least = f64::INFINITY;
        let mut at_edge = 0.0;
        for stretch in &self.contact {
            let load = self.load(stretch);
            least = load.iter().fold(least, |least: f64, q| least.min(q / self.chain.glassy));
            at_edge = load[NODES - 1] / self.chain.glassy;
        }
        if self.radius() >= self.profile.rim() {
            // A rim may be pressed.
            at_edge = 0.0;
        }
        for stretch in &self.free {
            for (k, height) in stretch.heights.iter().enumerate() {
                let surface: f64 = (0..self.chain.terms()).map(|index| stretch.term(index).get(k).copied().unwrap_or(0.0)).sum();
                least = least.min(surface - (self.penetration - height));
            }
        }
        if self.free.is_empty() && self.radius() < self.profile.rim() {
            least = least.min(self.profile.line(self.radius()) - self.penetration);
        }
        let depth = if self.depth > 0.0 { self.depth } else { 1.0 };
        (least, at_edge / depth)
    }

    /// The largest difference of two lines in any strain of a dashpot (m).
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let terms = self.chain.terms();
        let (mut own, mut theirs, mut scratch) = (vec![0.0; terms], vec![0.0; terms], Vec::new());
        let mut most = 0.0_f64;
        let dashpots = |line: &Self, place: f64, state: &mut [f64], scratch: &mut Vec<f64>| {
            if let Some(stretch) = line.contact.iter().find(|stretch| place <= stretch.high) {
                stretch.at(place, state);
                let under = line.penetration - line.profile.line(place);
                for u in state.iter_mut() {
                    *u = under - *u;
                }
            } else {
                match line.free.iter().find(|stretch| place <= stretch.high) {
                    Some(stretch) => stretch.at(place, state),
                    None => state.fill(0.0),
                }
                line.chain.touched(0.0, state, scratch);
                for u in state.iter_mut() {
                    *u = -*u;
                }
            }
        };
        for (one, another) in [(self, other), (other, self)] {
            for stretch in one.contact.iter().chain(&one.free) {
                for k in 0..NODES {
                    let place = stretch.place(k);
                    dashpots(one, place, &mut own, &mut scratch);
                    dashpots(another, place, &mut theirs, &mut scratch);
                    most = own.iter().zip(&theirs).fold(most, |most, (own, theirs)| most.max((own - theirs).abs()));
                }
            }
        }
        most
    }
}
