//! Steps under a penetration, a force or a frame, and under a prescribed edge: sizes by the error of the path, accepted or tried again.

use super::edge::{Drive, Imposed, Trial};
use super::elastic_zone::tension_root;
use super::line::NARROWEST;
use super::marcher::{CLOCK, HALF, LOOSEST, Marcher, NEARLY};
use super::motion::{Motion, Passage};
use super::past::Node;
use super::solution::EventKind;
use super::stepping::{EdgeStep, Stepper, TimeStep};
use crate::refusal::Refusal;

/// Attempts at one step; each failed one shrinks it or changes what drives it.
const MOST_ATTEMPTS: u32 = 200;
/// Steps of the edge, over the process zone, below which an edge without a stable neighbour is taken as unstable.
const SMALLEST_REACH: f64 = 1e-5;
/// Accepted residual of the edge condition near a fold.
const FOLD_TOLERANCE: f64 = 1e-13;
/// Distance from the fold of t(a), over the process zone, at which it is taken as reached.
const AT_FOLD: f64 = 4e-4;
/// Where the edge is looked at to tell a fold from a path that only slows down, over the distance of the fold: the residual of a step at once, straight
/// less a square, has its zero at twice that distance.
const BEYOND_FOLD: f64 = 3.0;
/// The same at least, over the process zone.
const SHORTEST_LOOK: f64 = 0.15;
/// And where a fold has been reached: below it the residual is noise.
const SMALLEST_BEYOND: f64 = 1e-2;
/// Distance of a fold, over the process zone, that is near.
const NEAR_FOLD: f64 = 2.0;
/// Shortest step, over the time since the last corner.
const SHORTEST: f64 = 1e-12;
/// Part of the way to a fold that one step goes.
const TOWARDS_FOLD: f64 = 0.6;
/// Points behind an extrapolation: more only amplify what is not smooth.
const EXTRAPOLATION: usize = 5;
/// Growth of a step over the one before at the tolerance below: polynomials through points whose distances double tell little of their own errors. It goes with the
/// tolerance by the order of the path: marches that grow alike err alike, however tight they are.
const GROWTH: f64 = 0.5;
const AT_GROWTH: f64 = 1e-2;
/// The least: below it the error of a step rules alone.
const SMALLEST_GROWTH: f64 = 0.15;

/// The least change of a step that fails.
const SLOWEST: f64 = 0.2;

/// Narrowest panels within which the place of an edge is noise.
const PLACE_NOISE: f64 = 4.0;
/// Change of Δ over the depth of the contact that is noise.
const DEPTH_NOISE: f64 = 1e-12;
/// Motion over the process zone that is none.
const AT_REST: f64 = 1e-9;
/// Halvings of the time at which a rim gives way.
const RIM_HALVINGS: u32 = 50;

/// Distance to a corner of the path, over the process zone, that is none.
const AT_MARK: f64 = 1e-6;
/// Motion of a step, over the tolerance of the path, whose turn does not count.
const STILL: f64 = 1e-4;
/// Accuracy of the instant at which the edge turns, over the step that leads there, at the loosest tolerance; it goes with the cube root. The least, and attempts.
const AT_TURN: f64 = 3e-3;
const LEAST_AT_TURN: f64 = 1e-5;
const MOST_TURNINGS: u32 = 24;

/// Last term of one of t(y) and y(t) over that of the other, below which the one is smoother.
const SMOOTHER: f64 = 0.5;

/// Least measure of an error, over the process zone.
const SHORTEST_MEASURE: f64 = 1e-2;

/// What drives the next attempt.
enum Choice {
    Edge { inwards: bool, guess: f64 },
    Time { guess: f64 },
}

impl Marcher<'_> {
    /// One step of at most `cap`.
    pub(super) fn advance(&mut self, cap: f64, left: f64, target: f64, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        let (mut reach, mut cap) = (self.reach.min(self.largest_reach()), cap);
        let mut landing = false;
        let a = self.contact.radius();
        if a == 0.0 {
            // From a point, without adhesion: y grows smoothly, and only time can drive it.
            reach = reach.max(self.largest_reach());
        } else if self.problem.adhesion.is_none() {
            reach = reach.min(0.25 * a);
        }
        if let Some(distance) = self.fold_ahead() {
            // A path that slows down foresees folds that never come: where the glassy edge is stable well beyond one, the fold is further than half of that.
            let beyond = (BEYOND_FOLD * distance).max(SHORTEST_LOOK * self.length);
            if self.is_unstable(imposed, beyond)? == Some(false) {
                reach = reach.min(0.5 * TOWARDS_FOLD * beyond);
            } else {
                // Just behind a corner the first steps are too short to tell of a fold.
                let told = self.past.nodes().last().is_some_and(|oldest| (a - oldest.radius).abs() > distance);
                if told && distance < AT_FOLD * self.length && self.is_unstable(imposed, 0.0)? == Some(true) {
                    return self.lost(true, Some(distance), imposed);
                }
                reach = reach.min((TOWARDS_FOLD * distance).max(0.5 * AT_FOLD * self.length));
            }
        }
        let mut forced: Option<Choice> = None;
        let mut was_far = false;
        let mut turnings = 0;
        // The longest attempt at a step over a turn.
        let mut longest = 0.0_f64;
        for _ in 0..MOST_ATTEMPTS {
            let choice = match forced.take() {
                Some(choice) => choice,
                None => match self.choose(reach, cap) {
                    // An edge that would stop short of the end of the stretch: two equal steps of time.
                    Choice::Edge { guess, .. } if guess > HALF * left && guess < NEARLY * left && cap > HALF * left => {
                        cap = HALF * left;
                        Choice::Time { guess: self.place_after(cap, reach) }
                    }
                    Choice::Edge { guess, .. } if self.smooth_in_time => {
                        cap = guess;
                        Choice::Time { guess: self.place_after(cap, reach) }
                    }
                    choice => choice,
                },
            };
            let found = match choice {
                Choice::Time { guess } => {
                    let outcome = self.stepper().time_driven(cap, guess, 1.5 * reach, imposed)?;
                    match outcome {
                        TimeStep::Found(trial) => {
                            if trial.motion.to < a && self.leave_rim(cap, left, target, imposed)? {
                                return Ok(());
                            }
                            match self.mark_within(trial.motion.to - a) {
                                // Not over a corner: to it.
                                Some(mark) if !was_far => {
                                    was_far = true;
                                    reach = (mark - a).abs();
                                    let guess = cap * reach / (trial.motion.to - a).abs();
                                    forced = Some(Choice::Edge { inwards: mark < a, guess });
                                    None
                                }
                                _ => Some((trial, false)),
                            }
                        }
                        TimeStep::Far(inwards) => {
                            if inwards && self.leave_rim(cap, left, target, imposed)? {
                                return Ok(());
                            }
                            was_far = true;
                            forced = Some(Choice::Edge { inwards, guess: 0.5 * cap });
                            None
                        }
                    }
                }
                Choice::Edge { inwards, guess } => {
                    let mut way = if inwards { -reach } else { reach.min(self.contact.profile().rim() - a) };
                    landing = false;
                    if let Some(mark) = self.mark_within(1.2 * way) {
                        way = mark - a;
                        landing = true;
                    } else if let Some(mark) = self.mark_within(way / HALF) {
                        way = HALF * (mark - a);
                    }
                    if a + way <= self.smallest() {
                        landing = false;
                        let room = a - self.smallest();
                        way = match self.problem.adhesion {
                            Some(_) if room <= AT_MARK * self.length => return self.detach(EventKind::ZoneReached, imposed),
                            // There, and not where the last step before happens to end.
                            Some(_) => -room,
                            None if a <= 2.0 * self.smallest() => return self.detach(EventKind::Detachment, imposed),
                            None => 0.5 * way.max(-a),
                        };
                    }
                    match self.stepper().edge_driven(a + way, guess, cap, imposed)? {
                        EdgeStep::Found(trial) => Some((trial, true)),
                        EdgeStep::Late => {
                            if was_far {
                                cap *= 0.5;
                                was_far = false;
                            }
                            forced = Some(Choice::Time { guess: self.place_after(cap, reach) });
                            None
                        }
                        EdgeStep::Unstable => {
                            reach *= 0.25;
                            if reach < SMALLEST_REACH * self.length {
                                return self.lost(inwards, None, imposed);
                            }
                            // A shorter time lets the edge go less far.
                            forced = Some(Choice::Edge { inwards, guess: 0.25 * guess });
                            None
                        }
                    }
                }
            };
            let Some((trial, by_edge)) = found else { continue };
            if by_edge && !landing && !was_far && trial.motion.slows_down() {
                // y(t) goes on smoothly to a rest, t(y) does not.
                (cap, was_far) = (trial.motion.time, true);
                forced = Some(Choice::Time { guess: trial.motion.to });
                continue;
            }
            // The edge turns: a step ends there, and the path starts anew.
            let mut turned = false;
            let may_turn = !by_edge || self.reverses(trial.motion.to);
            if may_turn && !self.is_nearly_a_point() && turnings < MOST_TURNINGS && self.moves(trial.motion.to) {
                let place = self.contact.profile().coordinate(trial.motion.to);
                if let Some(time) = self.past.turn((trial.motion.time, place)) {
                    let part = time / trial.motion.time;
                    let near = self.at_turn();
                    longest = longest.max(trial.motion.time);
                    if time < near * longest {
                        self.restart_at_turn();
                        cap = cap.min(self.dt);
                        continue;
                    }
                    if part < 1.0 - near {
                        turnings += 1;
                        cap = time;
                        continue;
                    }
                    turned = part < 1.0 + near;
                }
            }
            // Places are only known to the narrowest panel, and to what the accepted residual leaves: below that a path has no shape.
            let (by_time, by_place) = self.slopes;
            let slack = if by_edge { (trial.motion.to - a).abs() / by_time } else { 1.0 / by_place };
            let slack = if slack.is_finite() { slack * self.edge_tolerance() } else { 0.0 };
            let noise = PLACE_NOISE * (NARROWEST * a.max(self.length)).max(slack);
            let place_error = if trial.place_error <= noise { 0.0 } else { trial.place_error };
            let depth_error = if trial.depth_error <= DEPTH_NOISE * self.edge.depth_scale { 0.0 } else { trial.depth_error };
            let measure = self.measure((trial.motion.to - a).abs());
            let error = (place_error / measure).max(depth_error / self.opening);
            let ideal =
                if error > 0.0 { 0.9 * (self.tolerance / error).powf(1.0 / f64::from(trial.degree.max(1))) } else { self.fastest() };
            let factor = ideal.clamp(SLOWEST, self.fastest());
            if error > self.tolerance && factor < 0.9 {
                let smallest = reach < 1e-7 * self.length || cap < self.shortest_step();
                if !smallest {
                    if by_edge {
                        reach *= factor
                    } else {
                        cap *= factor
                    }
                    continue;
                }
            }
            self.accept(&trial, by_edge, (reach, cap, factor), (left, target), landing && by_edge)?;
            if turned {
                self.restart_at_turn();
            }
            return Ok(());
        }
        Err(Refusal::NotConverged { what: "a step of the contact", detail: format!("at t = {:e}, a = {a:e}", self.time) })
    }

    /// See [`AT_TURN`]: just after a turn K goes with the time since.
    fn at_turn(&self) -> f64 {
        (AT_TURN * (self.tolerance / LOOSEST).cbrt()).clamp(LEAST_AT_TURN, AT_TURN)
    }

    /// Whether a step to a place goes against the one before: an edge that drives it has turned on the way.
    fn reverses(&self, to: f64) -> bool {
        let a = self.contact.radius();
        self.past.nodes().get(1).is_some_and(|node| (to - a) * (a - node.radius) < 0.0)
    }

    /// Whether a step to a place, or one of the last before it, is more than the path is known to: steps towards a turn become as short as one likes.
    fn moves(&self, to: f64) -> bool {
        let a = self.contact.radius();
        let last = self.past.nodes().windows(2).fold(0.0_f64, |most, pair| most.max((pair[0].radius - pair[1].radius).abs()));
        (to - a).abs().max(last) > (STILL * self.tolerance * self.length).max(PLACE_NOISE * NARROWEST * a)
    }

    /// Whether the contact is one without adhesion that has just grown from a point, or shrinks to one: it goes by a root of the time, noise may look like a turn,
    /// and only time can drive it.
    fn is_nearly_a_point(&self) -> bool {
        let a = self.contact.radius();
        a == 0.0 || (self.problem.adhesion.is_none() && a < self.length)
    }

    /// The nearest corner of the path within a way of the edge.
    fn mark_within(&self, way: f64) -> Option<f64> {
        let a = self.contact.radius();
        if self.is_nearly_a_point() {
            return None;
        }
        let distance = |mark: &f64| (mark - a) * way.signum();
        let marks = self.landmarks.iter().map(|(mark, _)| mark).chain(&self.turns).copied();
        marks
            .filter(|mark| distance(mark) > AT_MARK * self.length && distance(mark) <= way.abs())
            .min_by(|one, other| distance(one).total_cmp(&distance(other)))
    }

    /// The rim holds the edge for a while yet: goes to the instant at which it gives way, and starts anew from there.
    fn leave_rim(&mut self, cap: f64, left: f64, target: f64, imposed: &Imposed<'_>) -> Result<bool, Refusal> {
        let rim = self.contact.profile().rim();
        if self.contact.radius() < rim {
            return Ok(false);
        }
        // At its zero already: near a peak of the load the time to it would be noise.
        let here = self.edge.trial(&self.contact, &self.past, (rim, 0.0), Drive::Time, imposed)?;
        if here.residual >= -self.edge_tolerance() {
            return Ok(false);
        }
        let (mut low, mut high) = (0.0, cap);
        for _ in 0..RIM_HALVINGS {
            let middle = 0.5 * (low + high);
            let trial = self.edge.trial(&self.contact, &self.past, (rim, middle), Drive::Time, imposed)?;
            if trial.residual <= 0.0 { low = middle } else { high = middle }
        }
        if low <= (1e-9 * cap).max(4.0 * f64::EPSILON * self.time) {
            return Ok(false);
        }
        let trial = self.edge.trial(&self.contact, &self.past, (rim, low), Drive::Time, imposed)?;
        self.go(&trial.motion, trial.penetration);
        self.went(low, left, target, 0.0);
        self.restart();
        Ok(true)
    }

    fn accept(
        &mut self,
        trial: &Trial,
        by_edge: bool,
        (reach, cap, factor): (f64, f64, f64),
        (left, target): (f64, f64),
        landing: bool,
    ) -> Result<(), Refusal> {
        let dt = trial.motion.time;
        let rim = self.contact.profile().rim();
        if dt > 0.0 && trial.degree > 2 {
            let (by_place, by_time) = self.edge.terms(&self.contact, &self.past, (trial.motion.to, dt));
            if by_time < SMOOTHER * by_place {
                self.smooth_in_time = true;
            } else if by_place < SMOOTHER * by_time {
                self.smooth_in_time = false;
            }
        }
        let arrived = self.contact.radius() < rim && trial.motion.to >= rim;
        self.go(&trial.motion, trial.penetration);
        self.went(dt, left, target, trial.residual);
        if by_edge {
            self.reach = reach * factor;
            self.dt = self.dt.max(dt).min(3.0 * dt * factor);
        } else if cap < left || factor < 1.0 {
            self.dt = cap * factor;
        }
        self.reach = self.reach.min(self.largest_reach());
        if !by_edge {
            // While time drives, the edge may find its pace again.
            self.reach = (self.reach * self.fastest()).min(self.largest_reach());
        }
        // A rim stops the edge: a corner of its path.
        if landing || arrived {
            self.restart_at_landmark();
        }
        Ok(())
    }

    /// Makes a motion.
    pub(super) fn go(&mut self, motion: &Motion, penetration: f64) {
        self.record.passed(&self.contact, motion);
        self.contact = self.contact.after(motion, penetration);
    }

    fn stepper(&mut self) -> Stepper<'_, '_> {
        let tolerance = if self.is_near_fold() { FOLD_TOLERANCE } else { self.edge_tolerance() };
        Stepper { edge: &mut self.edge, contact: &self.contact, past: &self.past, tolerance, slopes: &mut self.slopes }
    }

    fn choose(&self, reach: f64, cap: f64) -> Choice {
        let nodes = self.past.nodes();
        let (Some(now), Some(before)) = (nodes.first(), nodes.get(1)) else {
            return Choice::Time { guess: self.contact.radius() };
        };
        let way = now.radius - before.radius;
        let inwards = way < 0.0;
        if way == 0.0 || now.time <= before.time {
            return Choice::Time { guess: self.place_after(cap, reach) };
        }
        let pace = (now.time - before.time) / way.abs() * reach;
        let target = if inwards { now.radius - reach } else { now.radius + reach };
        let guess = self
            .past
            .extrapolated(EXTRAPOLATION, |node| (node.radius - target, node.time))
            .map(|time| time - now.time)
            .filter(|dt| *dt > 0.1 * pace && *dt < 10.0 * pace)
            .unwrap_or(pace);
        if guess <= cap { Choice::Edge { inwards, guess } } else { Choice::Time { guess: self.place_after(cap, reach) } }
    }

    /// Where the edge is probably going to be.
    fn place_after(&self, dt: f64, reach: f64) -> f64 {
        let here = self.contact.radius();
        let Some(now) = self.past.nodes().first() else { return here };
        let guess = self.past.extrapolated(EXTRAPOLATION, |node: &Node| (node.time - now.time - dt, node.radius));
        let guess = guess.unwrap_or(here).clamp(here - reach, here + reach);
        // An edge at rest stays: extrapolated rounding is no motion.
        if (guess - here).abs() < AT_REST * self.length { here } else { guess }
    }

    /// The distance of the fold of t(a) that the last three points foresee: where the edge would run away.
    fn fold_ahead(&self) -> Option<f64> {
        let [now, one, two] = *self.past.nodes().get(..3)? else { return None };
        let (first, second) = (now.radius - one.radius, one.radius - two.radius);
        if first * second <= 0.0 {
            return None;
        }
        let (fast, slow) = ((now.time - one.time) / first.abs(), (one.time - two.time) / second.abs());
        let bend = 2.0 * (fast - slow) / (first.abs() + second.abs());
        let slope = fast + 0.5 * bend * first.abs();
        // Only a fold that is near counts; further away the path will show itself.
        (bend < 0.0 && slope > 0.0).then(|| -slope / bend).filter(|distance| *distance < 4.0 * first.abs().max(self.reach))
    }

    /// Near a fold dt goes with the square of the way left: the root of the residual is what the place is known to.
    pub(super) fn is_near_fold(&self) -> bool {
        self.problem.adhesion.is_some() && self.fold_ahead().is_some_and(|distance| distance < NEAR_FOLD * self.length)
    }

    /// Whether the edge, moved at once a little further on, would run on by itself; none where there is no place to look at.
    pub(super) fn is_unstable(&mut self, imposed: &Imposed<'_>, way: f64) -> Result<Option<bool>, Refusal> {
        let [now, before] = *self.past.nodes().get(..2).unwrap_or(&[]) else { return Ok(None) };
        let way = way.max(SMALLEST_BEYOND * self.length) * (now.radius - before.radius).signum();
        if now.radius + way <= self.smallest() || now.radius + way >= self.contact.profile().rim() {
            return Ok(None);
        }
        let (_, value) = self.edge.jumped(&self.contact, now.radius + way, imposed)?;
        Ok(Some(if way < 0.0 { value >= 0.0 } else { value <= 0.0 }))
    }

    /// What an error of the place of the edge is seen against: the stresses that a step leaves behind an adhering edge know the way that it went, and K with them.
    fn measure(&self, way: f64) -> f64 {
        if self.problem.adhesion.is_none() {
            return self.length;
        }
        (way * self.length).sqrt().clamp(SHORTEST_MEASURE * self.length, self.length)
    }

    /// Growth of a step over the one before, at most.
    fn fastest(&self) -> f64 {
        1.0 + (GROWTH * (self.tolerance / AT_GROWTH).powf(1.0 / 6.0)).clamp(SMALLEST_GROWTH, GROWTH)
    }

    /// No step is made shorter for its error than this.
    fn shortest_step(&self) -> f64 {
        (SHORTEST * (self.time - self.corner)).max(CLOCK * f64::EPSILON * self.time)
    }

    /// A step of a prescribed edge.
    pub(super) fn prescribed_step(&mut self, value: &dyn Fn(f64) -> f64, cap: f64, left: f64, target: f64) -> Result<(), Refusal> {
        let mut cap = cap;
        for _ in 0..MOST_ATTEMPTS {
            let way = (value(cap) - self.contact.radius()).abs();
            if way > self.largest_reach() {
                cap *= (0.99 * self.largest_reach() / way).max(0.1);
                continue;
            }
            let (motion, residual, error) = self.prescribed_motion(value(cap), cap, 5)?;
            let error = error / self.opening;
            let ideal = if error > 0.0 { 0.9 * (self.tolerance / error).powf(0.25) } else { self.fastest() };
            let factor = ideal.clamp(SLOWEST, self.fastest());
            if error > self.tolerance && factor < 0.9 && cap > self.shortest_step() {
                cap *= factor;
                continue;
            }
            self.go(&motion, motion.end_penetration());
            self.went(cap, left, target, residual);
            if cap < left || factor < 1.0 {
                self.dt = cap * factor;
            }
            return Ok(());
        }
        Err(Refusal::NotConverged { what: "a step of the prescribed edge", detail: format!("at t = {:e}", self.time) })
    }

    /// A given edge after dt: the penetration from the edge condition.
    pub(super) fn prescribed(&mut self, radius: f64, dt: f64, degree: u32) -> Result<(), Refusal> {
        let (motion, _, _) = self.prescribed_motion(radius, dt, degree)?;
        self.go(&motion, motion.end_penetration());
        Ok(())
    }

    fn prescribed_motion(&mut self, radius: f64, dt: f64, degree: u32) -> Result<(Motion, f64, f64), Refusal> {
        let here = self.contact.penetration();
        let now = self.past.nodes().first().copied();
        let powers = |rise: f64| match now {
            Some(now) if dt > 0.0 => self.past.powers(rise, degree, |node| ((node.time - now.time) / dt, node.penetration - here)),
            _ => ([rise, 0.0, 0.0, 0.0, 0.0], 0.0),
        };
        let motion = |rise: f64| {
            let (powers, error) = powers(rise);
            (Motion::new(self.contact.profile(), (self.contact.radius(), radius), dt, Passage::Radius, here, powers), error)
        };
        let unit = self.opening;
        let rise = match self.problem.adhesion {
            None => {
                let first = self.edge.residual(&self.contact, &motion(0.0).0, false)?;
                let second = self.edge.residual(&self.contact, &motion(unit).0, false)?;
                -unit * first / (second - first)
            }
            Some(adhesion) => {
                // C is a quadratic in the rise; sampled again about its root it keeps its digits.
                let mut about = self.contact.profile().line(radius) - here;
                let mut scale = -unit;
                for _ in 0..2 {
                    let mut sample = |x: f64| self.edge.work(&self.contact, &motion(about + scale * x).0);
                    let samples = [sample(0.0)?, sample(1.0)?, sample(2.0)?];
                    about += scale * tension_root(samples, adhesion.work_of_adhesion)?;
                    about += 0.5 * unit;
                    scale = -0.5 * unit;
                }
                about - 0.5 * unit
            }
        };
        let (motion, error) = motion(rise);
        let residual = self.edge.residual(&self.contact, &motion, false)?;
        Ok((motion, residual, error))
    }
}
