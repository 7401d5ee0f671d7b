//! Steps under a penetration, a force or a frame: sizes by the error of the path, accepted or tried again.

use super::corners::{AT_MARK, PLACE_NOISE};
use super::edge::{Drive, Imposed, Trial};
use super::integrator::{HALF, Integrator, NEARLY};
use super::line::NARROWEST;
use super::motion::Motion;
use super::path_history::Node;
use super::solution::EventKind;
use super::stepping::{EdgeStep, Stepper, TimeStep, Way};
use crate::continuation::bracket::halved_if;
use crate::refusal::Refusal;

/// Attempts at one step; each failed one shrinks it or changes what drives it.
pub(super) const MOST_ATTEMPTS: u32 = 200;
/// Steps of the edge, over the process zone, below which an edge without a stable neighbour is taken as unstable.
const SMALLEST_REACH: f64 = 1e-5;
/// No step is made shorter for its error than this, over the process zone.
const SHORTEST_REACH: f64 = 1e-7;
/// Accepted residual of the edge condition near a fold.
const FOLD_TOLERANCE: f64 = 1e-13;
/// Where the edge is looked at to tell a fold from a path that only slows down, over the distance of the fold: the residual of a step at once, straight
/// less a square, has its zero at twice that distance.
const BEYOND_FOLD: f64 = 3.0;
/// The same at least, over the process zone.
const SHORTEST_LOOK: f64 = 0.15;
/// Part of the way to a fold that one step goes.
const TOWARDS_FOLD: f64 = 0.6;
/// Points behind an extrapolation: more only amplify what is not smooth.
const EXTRAPOLATION: usize = 5;
/// The least change of a step that fails.
pub(super) const SLOWEST: f64 = 0.2;
/// Change of Δ over the depth of the contact that is noise.
const DEPTH_NOISE: f64 = 1e-12;
/// Motion over the process zone that is none.
const AT_REST: f64 = 1e-9;
/// Attempts at the instant at which the edge turns.
const MOST_TURNINGS: u32 = 24;
/// Last term of one of t(y) and y(t) over that of the other, below which the one is smoother.
const SMOOTHER: f64 = 0.5;

/// What drives the next attempt.
enum Choice {
    Edge { inwards: bool, guess: f64 },
    Time { guess: f64 },
}

impl Integrator<'_> {
    /// One step of at most `cap`.
    pub(super) fn advance(&mut self, cap: f64, left: f64, target: f64, imposed: &Imposed<'_>) -> Result<(), Refusal> {
        let (mut reach, mut cap) = (self.reach.min(self.largest_reach()), cap);
        let mut landing = false;
        let a = self.contact.radius();
        if let Some(distance) = self.fold_ahead() {
            // A path that slows down foresees folds that never come: where the glassy edge is stable well beyond one, the fold is further than half of that.
            let beyond = (BEYOND_FOLD * distance).max(SHORTEST_LOOK * self.length);
            if self.is_unstable(imposed, beyond)? == Some(false) {
                reach = reach.min(0.5 * TOWARDS_FOLD * beyond);
            } else {
                // Just behind a corner the first steps are too short to tell of a fold.
                let far_enough = self.path_history.nodes().last().is_some_and(|oldest| (a - oldest.radius).abs() > distance);
                if far_enough && self.is_at_fold(imposed, distance)? && self.is_unstable(imposed, 0.0)? == Some(true) {
                    let fold = self.fold_by_edge_condition(imposed, distance)?;
                    return self.lost(true, Some(fold), imposed);
                }
                reach = reach.min((TOWARDS_FOLD * distance).max(0.5 * self.nearest_to_fold()));
            }
        }
        let mut way = Way::Any;
        if a > 0.0 && self.problem.edge_law.may_rest() {
            match self.way(&mut cap, left, target, imposed)? {
                Some(known) => way = known,
                None => return Ok(()),
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
                None if way == Way::None => Choice::Time { guess: a },
                None => match self.choose(reach, cap) {
                    // An edge that would stop short of the end of the segment: two equal steps of time.
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
                    let outcome = self.stepper().time_driven(cap, way, guess, 1.5 * reach, imposed)?;
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
                        if room <= AT_MARK * self.length {
                            return self.detach(EventKind::ZoneReached, imposed);
                        }
                        // There, and not where the last step before happens to end; a zone that grows moves the end.
                        way = if self.problem.edge_law.growing_zone { -HALF * room } else { -room };
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
            if may_turn && turnings < MOST_TURNINGS && self.moves(trial.motion.to) {
                let place = self.contact.profile().coordinate(trial.motion.to);
                if let Some(time) = self.path_history.turn((trial.motion.time, place)) {
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
            let (_, by_place) = self.slopes;
            let slack = if by_edge { (trial.motion.to - a).abs() / trial.drive } else { 1.0 / by_place };
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
                // An edge that drives may go quicker than the clock can tell.
                let smallest = reach < SHORTEST_REACH * self.length || (!by_edge && cap < self.shortest_step());
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

    /// The rim holds the edge for a while yet: goes to the instant at which it detaches, and starts anew from there.
    fn leave_rim(&mut self, cap: f64, left: f64, target: f64, imposed: &Imposed<'_>) -> Result<bool, Refusal> {
        let rim = self.contact.profile().rim();
        if self.contact.radius() < rim {
            return Ok(false);
        }
        // At its zero already: near a peak of the load the time to it would be noise.
        let here = self.edge.trial(&self.contact, &self.path_history, (rim, 0.0), Drive::Time, imposed)?;
        if here.residual >= -self.edge_tolerance() {
            return Ok(false);
        }
        let [low, _] = halved_if([0.0, cap], |dt| {
            let trial = self.edge.trial(&self.contact, &self.path_history, (rim, dt), Drive::Time, imposed)?;
            Ok(trial.residual <= 0.0)
        })?;
        if low <= (1e-9 * cap).max(4.0 * f64::EPSILON * self.time) {
            return Ok(false);
        }
        let trial = self.edge.trial(&self.contact, &self.path_history, (rim, low), Drive::Time, imposed)?;
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
            let (by_place, by_time) = self.edge.terms(&self.contact, &self.path_history, (trial.motion.to, dt));
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
            self.restart_at_kink();
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
        Stepper { edge: &mut self.edge, contact: &self.contact, path_history: &self.path_history, tolerance, slopes: &mut self.slopes }
    }

    fn choose(&self, reach: f64, cap: f64) -> Choice {
        let nodes = self.path_history.nodes();
        let (Some(now), Some(before)) = (nodes.first(), nodes.get(1)) else {
            return Choice::Time { guess: self.contact.radius() };
        };
        let way = now.radius - before.radius;
        let inwards = way < 0.0;
        if way == 0.0 || before.time >= 0.0 {
            return Choice::Time { guess: self.place_after(cap, reach) };
        }
        let pace = -before.time / way.abs() * reach;
        let target = if inwards { now.radius - reach } else { now.radius + reach };
        let guess = self
            .path_history
            .extrapolated(EXTRAPOLATION, |node| (node.radius - target, node.time))
            .filter(|dt| *dt > 0.1 * pace && *dt < 10.0 * pace)
            .unwrap_or(pace);
        if guess <= cap { Choice::Edge { inwards, guess } } else { Choice::Time { guess: self.place_after(cap, reach) } }
    }

    /// Where the edge is probably going to be.
    fn place_after(&self, dt: f64, reach: f64) -> f64 {
        let here = self.contact.radius();
        let guess = self.path_history.extrapolated(EXTRAPOLATION, |node: &Node| (node.time - dt, node.radius));
        let guess = guess.unwrap_or(here).clamp(here - reach, here + reach);
        // An edge at rest stays: extrapolated rounding is no motion.
        if (guess - here).abs() < AT_REST * self.length { here } else { guess }
    }
}
