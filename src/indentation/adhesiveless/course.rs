//! One course through a history: the stretches of the history, the instants to keep, cycles, events and energies.

use super::chain::Chain;
use super::drive::{Drive, Wave};
use super::edge::Ended;
use super::fresh::Fresh;
use super::line::Line;
use crate::indentation::checkpoint::Watch;
use crate::indentation::history::{Controlled, Segment};
use crate::indentation::meter::{Course as Polynomial, Meter};
use crate::indentation::panel::RULE;
use crate::indentation::problem::{IndentationProblem, Start};
use crate::indentation::record::Record;
use crate::indentation::solution::{Energies, Event, EventKind, PathPoint, Trace};
use crate::indentation::stretch::{Stretch, part, weight};
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Turns and losses of one drive, at most.
const MOST_TURNS: u32 = 100_000;
/// Points of a path that a polynomial goes through.
const POINTS_BEHIND: usize = 6;
/// Relative change of a rate that is no corner.
const SAME_PACE: f64 = 1e-9;
/// Longest time of one drive of an oscillation (cycles), and of one whose frequency changes.
const LONGEST_OF_CYCLE: f64 = 0.25;
const LONGEST_OF_SWEEP: f64 = 1.0 / 24.0;
/// Instants between which the power is added up: the first over the shortest relaxation time.
const FIRST_OF_LEDGER: f64 = 0.02;

/// Change of all cycles that are left, over the accuracy and the depth, at which they are one.
const REPEATED: f64 = 1e-5;
/// Change of a cycle over the depth that is rounding.
const NO_CHANGE: f64 = 4e-15;

/// How finely a course goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// What series leave, over the depth.
    pub(super) series: f64,
    /// Points of a cycle.
    pub(super) of_cycle: u32,
    /// Ratio of instants after a corner, and even ones of a stretch, between which power is added up.
    pub(super) ledger: (f64, u32),
}

/// A course under way.
pub(super) struct Course<'a> {
    pub(super) chain: &'a Chain,
    pub(super) problem: &'a IndentationProblem,
    pub(super) line: Line<'a>,
    pub(super) fineness: Fineness,
    pub(super) fresh: Fresh<'a>,
    /// Start of the stretch under way and the time since.
    origin: f64,
    pub(super) time: f64,
    record: Record<'a>,
    meter: Option<Meter>,
    /// The last points of the same smooth piece.
    recent: Vec<PathPoint>,
    pace: Option<(Controlled, f64)>,
    pub(super) evaluations: u64,
    watch: Option<(&'a dyn Watch, u32)>,
    stop: Option<Line<'a>>,
    until: f64,
    /// The time of the stretch from which on a point is seen to be admissible.
    look_at: f64,
}

impl<'a> Course<'a> {
    pub(super) fn new(chain: &'a Chain, problem: &'a IndentationProblem, fineness: Fineness) -> Self {
        let line = Line::untouched(chain, &problem.profile, fineness.series);
        Self {
            chain,
            problem,
            line,
            fineness,
            fresh: Fresh::of(&problem.profile),
            origin: 0.0,
            time: 0.0,
            record: Record::without_contact(),
            meter: None,
            recent: Vec::new(),
            pace: None,
            evaluations: 0,
            watch: None,
            stop: None,
            until: f64::INFINITY,
            look_at: 0.0,
        }
    }

    pub(super) fn watched(mut self, watch: Option<&'a dyn Watch>, number: u32) -> Self {
        self.watch = watch.map(|watch| (watch, number));
        self
    }

    /// The whole history; `stops`: stretches that end early, and how long they take. The path, and what is not known of any strain of it beyond what another course tells (m).
    pub(super) fn through(mut self, stops: &[(usize, f64)]) -> Result<(Trace, f64), Refusal> {
        self.record.trace.shortened = stops.to_vec();
        self.run()?;
        let mut trace = self.record.finished();
        trace.work.closure_evaluations = self.evaluations;
        trace.work.history_updates = self.line.updates;
        trace.work.most_panels = self.line.most_stretches;
        trace.tolerance = self.fineness.series;
        Ok((trace, self.line.joined))
    }

    /// The line at a time of the history.
    pub(super) fn line_at(mut self, time: f64, stops: &[(usize, f64)]) -> Result<Line<'a>, Refusal> {
        self.record.trace.shortened = stops.to_vec();
        self.until = time;
        self.run()?;
        Ok(self.stop.unwrap_or(self.line))
    }

    fn run(&mut self) -> Result<(), Refusal> {
        let history = &self.problem.history;
        self.begin()?;
        let mut last = history.start;
        for (index, segment) in history.segments.iter().enumerate() {
            if self.stop.is_some() {
                return Ok(());
            }
            let stretch = Stretch { from: last, segment: *segment };
            let duration = if segment.duration == 0.0 {
                self.at_once(segment.controlled, segment.end)?;
                self.pace = None;
                self.record.keep();
                0.0
            } else {
                self.stretch(index, &stretch)?
            };
            last = segment.value(last, duration);
            self.observe(index, None);
        }
        Ok(())
    }

    fn observe(&self, index: usize, inside: Option<&Segment>) {
        let Some((watch, number)) = self.watch else { return };
        let segments = &self.problem.history.segments;
        let all: f64 = segments.iter().map(weight).sum();
        let done = index + usize::from(inside.is_none());
        let before: f64 = segments.iter().take(done).map(weight).sum();
        let under_way = inside.map_or(0.0, |segment| weight(segment) * part(segment, self.time));
        watch.passed(number, (before + under_way) / all);
    }

    pub(super) fn now(&self) -> f64 {
        self.origin + self.time
    }

    fn begin(&mut self) -> Result<(), Refusal> {
        let history = &self.problem.history;
        match self.problem.start {
            Start::Untouched => self.settle(history.controlled, history.start)?,
            Start::Relaxed => self.relaxed(history.start)?,
        }
        self.point(false);
        self.record.keep();
        Ok(())
    }

    /// A step of what is controlled.
    fn at_once(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        self.record.sudden();
        self.corner();
        let had = self.line.radius() > 0.0;
        let before = self.event();
        self.settle(controlled, value)?;
        if had && self.line.radius() == 0.0 {
            self.record.event(Event { kind: EventKind::Detachment, ..before });
        }
        self.point(true);
        self.record.new_piece();
        Ok(())
    }

    /// Nothing behind counts for what follows.
    pub(super) fn corner(&mut self) {
        self.recent.clear();
    }

    fn event(&self) -> Event<f64> {
        Event {
            kind: EventKind::Detachment,
            time: self.now(),
            penetration: self.line.penetration,
            force: self.line.force(),
            contact_radius: self.line.radius(),
        }
    }

    /// The contact has been lost now.
    pub(super) fn lost(&mut self) {
        let event = self.event();
        self.record.event(event);
        self.point(false);
        self.record.new_piece();
        self.corner();
    }

    /// The edge has turned: F goes on smoothly, with two derivatives.
    pub(super) fn turned(&mut self) {
        self.point(false);
    }

    /// Adds the present state to the path.
    pub(super) fn point(&mut self, sudden: bool) {
        let force = self.line.force();
        let (mut residual, looked_at) = (0.0, self.time >= self.look_at);
        if looked_at {
            let (pressing, at_edge) = self.line.least();
            let least = &mut self.record.trace.smallest_gap_factor;
            *least = least.min(pressing);
            residual = at_edge;
        }
        let mut point = PathPoint {
            time: self.now(),
            penetration: self.line.penetration,
            force,
            contact_radius: self.line.radius(),
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual,
            piece: self.record.piece(),
            energies: None,
        };
        if self.problem.energies {
            let [stored, dissipated_power] = self.line.energies();
            point.energies = Some(Energies { stored, dissipated_power, ..Energies::default() });
            self.recent.push(point);
            let spare = self.recent.len().saturating_sub(POINTS_BEHIND);
            self.recent.drain(..spare);
            let energies = self.account(&point, sudden);
            point.energies = Some(energies);
        }
        self.record.trace.work.steps += 1;
        self.record.push(point);
        if let Some(meter) = &mut self.meter {
            meter.step(&point);
        }
    }

    /// The running account of energies up to a point that is the newest of the recent ones.
    fn account(&self, point: &PathPoint, sudden: bool) -> Energies {
        let now = point.energies.unwrap_or_default();
        let Some(last) = self.record.trace.path.last() else { return now };
        let Some(before) = last.energies else { return now };
        let (mut external, mut lost) = (0.0, 0.0);
        if sudden || point.time <= last.time {
            // Springs alone take a step: what it does is stored.
            external = now.stored - before.stored;
        } else {
            let [depth, force, power] = [
                Polynomial::through(&self.recent, |point| point.penetration),
                Polynomial::through(&self.recent, |point| point.force),
                Polynomial::through(&self.recent, |point| point.energies.map_or(0.0, |energies| energies.dissipated_power)),
            ];
            let begin = last.time - point.time;
            for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
                let time = begin * (1.0 - x);
                external += -begin * weight * force.at(time).0 * depth.at(time).1;
                lost += -begin * weight * power.at(time).0;
            }
        }
        Energies {
            external_work: before.external_work + external,
            dissipated: before.dissipated + lost,
            balance_defect: external - (now.stored - before.stored) - lost,
            ..now
        }
    }

    /// A stretch of the history, to each kept instant and the end of each cycle: how long it took.
    fn stretch(&mut self, index: usize, stretch: &Stretch) -> Result<f64, Refusal> {
        let segment = stretch.segment;
        let rate = stretch.rate();
        let same = segment.oscillation.is_none()
            && self
                .pace
                .is_some_and(|(controlled, last)| controlled == segment.controlled && (rate - last).abs() <= SAME_PACE * rate.abs());
        if !same {
            self.record.new_piece();
            self.corner();
            self.recent.extend(self.record.trace.path.last().copied());
        }
        self.meter = segment.oscillation.map(|oscillation| {
            Meter::new(index, (oscillation, segment.duration), self.origin, self.chain.longest_time(), self.record.trace.path.last())
        });
        let stop = self.record.end_of(index);
        let mut duration = stop.unwrap_or(segment.duration);
        let until_stationary = segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
        let instants = if until_stationary { 1 } else { self.problem.instants_per_segment.max(1) };
        let (mut instant, mut cycle) = (1_u32, 1_u64);
        let mut at_start: Option<Line<'a>> = None;
        while self.time < duration {
            let next_instant = duration * if instant == instants { 1.0 } else { f64::from(instant) / f64::from(instants) };
            let end_of_cycle = stretch.end_of_cycle(cycle);
            let target = end_of_cycle.map_or(next_instant, |end| end.min(next_instant));
            for time in self.between(stretch, target) {
                if self.origin + time >= self.until {
                    let time = self.until - self.origin;
                    if time > self.time {
                        self.reach(stretch, time)?;
                    }
                    self.stop = Some(self.line.clone());
                    return Ok(duration);
                }
                self.reach(stretch, time)?;
            }
            if end_of_cycle.is_some_and(|end| end <= target) {
                cycle += 1;
                self.line.tidy(true);
                self.observe(index, Some(&segment));
                let stationary =
                    self.meter.as_mut().and_then(|meter| self.record.cycle(meter, self.origin + target, self.problem.accuracy));
                if until_stationary && stop.is_none() && stationary == Some(true) {
                    duration = target;
                    self.record.trace.shortened.push((index, target));
                }
                let skipped = self.repeated(stretch, &mut at_start, cycle, next_instant);
                cycle += skipped;
            }
            if self.time >= next_instant || self.time >= duration {
                self.record.keep();
                instant += 1;
            }
        }
        self.record.last_cycle(self.meter.take());
        self.pace = segment.oscillation.is_none().then_some((segment.controlled, rate));
        self.origin += duration;
        self.time = 0.0;
        Ok(duration)
    }

    /// Cycles that are left out because each is the last one again: none where that is not sure to what was asked for.
    fn repeated(&mut self, stretch: &Stretch, at_start: &mut Option<Line<'a>>, next: u64, by: f64) -> u64 {
        let Some(oscillation) = stretch.segment.oscillation else { return 0 };
        let steady = oscillation.frequency.to_bits() == oscillation.end_frequency.to_bits()
            && stretch.segment.end.to_bits() == stretch.from.to_bits()
            && !oscillation.until_stationary;
        if !steady || self.until.is_finite() || next < 3 {
            return 0;
        }
        let last = (by * oscillation.frequency * (1.0 + 1e-12)).floor() as u64;
        let left = (last + 1).saturating_sub(next);
        let before = at_start.replace(self.line.clone());
        let Some(before) = before.filter(|_| left > 1) else { return 0 };
        // Nothing that follows makes a difference larger: so many cycles change by at most so many times as much as this one did, and no more of them
        // than memory lasts.
        let last_change = self.line.distance(&before);
        let remembered = 2.0 * (1.0 + oscillation.frequency * self.chain.memory());
        let change = last_change * remembered.min(left as f64);
        let allowed = REPEATED * self.problem.accuracy * self.line.depth;
        if change > allowed && last_change > NO_CHANGE * self.line.depth {
            return 0;
        }
        self.line.joined += change;
        let Some(meter) = &mut self.meter else { return 0 };
        for _ in 0..left {
            self.record.cycle_again(meter);
        }
        self.time = stretch.end_of_cycle(next + left - 1).unwrap_or(by).min(by);
        self.point(false);
        left
    }

    /// Times up to a target at which points of the path are wanted, the target last.
    fn between(&self, stretch: &Stretch, target: f64) -> Vec<f64> {
        let mut times = Vec::new();
        if let Some(oscillation) = stretch.segment.oscillation {
            let duration = stretch.segment.duration;
            let of_cycle = f64::from(self.fineness.of_cycle);
            let mut k = (oscillation.cycles_at(self.time, duration) * of_cycle * (1.0 + 1e-12)).floor();
            loop {
                k += 1.0;
                match oscillation.time_of(k / of_cycle, duration) {
                    Some(time) if time < target * (1.0 - 1e-12) => {
                        if time > self.time {
                            times.push(time);
                        }
                    }
                    _ => break,
                }
            }
        } else if self.problem.energies && self.until.is_infinite() {
            let (ratio, even) = self.fineness.ledger;
            let mut way = FIRST_OF_LEDGER * self.chain.shortest_time().min(target - self.time);
            while self.time + way < target {
                times.push(self.time + way);
                way *= ratio;
            }
            times.extend((1..even).map(|k| self.time + (target - self.time) * f64::from(k) / f64::from(even)));
            times.sort_by(f64::total_cmp);
            times.dedup_by(|second, first| *second - *first <= 1e-9 * *second);
        }
        times.retain(|time| *time < target * (1.0 - 1e-13));
        times.push(target);
        times
    }

    /// Goes on to a time of a stretch, and adds the state there to the path.
    fn reach(&mut self, stretch: &Stretch, target: f64) -> Result<(), Refusal> {
        self.look_at = target;
        while self.time < target {
            match stretch.segment.controlled {
                Controlled::Penetration => {
                    let drive = self.drive(stretch, target);
                    self.along(&drive)?;
                }
                _ => self.toward(stretch, target)?,
            }
        }
        self.point(false);
        Ok(())
    }

    /// The next part of a stretch, as a drive of its own quantity.
    pub(super) fn drive(&self, stretch: &Stretch, target: f64) -> Drive {
        let from = self.time;
        let Some(oscillation) = stretch.segment.oscillation else {
            return Drive::straight(stretch.value(from), stretch.value(target), target - from);
        };
        let duration = stretch.segment.duration;
        let swept = oscillation.frequency.to_bits() != oscillation.end_frequency.to_bits();
        let longest = if swept { LONGEST_OF_SWEEP } else { LONGEST_OF_CYCLE } / oscillation.frequency_at(from, duration);
        let target = if from + longest < target { from + longest } else { target };
        if swept {
            return Drive::fitted(stretch.value(from), target - from, |time| stretch.value(from + time));
        }
        let cycles = oscillation.cycles_at(from, duration);
        let phase = TAU * (cycles - cycles.round());
        let mean = |time: f64| stretch.from + (stretch.segment.end - stretch.from) * (time / duration);
        let wave = Wave { amplitude: oscillation.amplitude, pace: TAU * oscillation.frequency, phase };
        let start = stretch.value(from);
        Drive::straight(start, start + (mean(target) - mean(from)), target - from).with_wave(wave)
    }

    /// Goes along a drive of the penetration.
    pub(super) fn along(&mut self, drive: &Drive) -> Result<(), Refusal> {
        let end = self.time + drive.duration;
        let mut drive = *drive;
        if drive.start.to_bits() != self.line.penetration.to_bits() {
            self.line.leap(drive.start)?;
        }
        for _ in 0..MOST_TURNS {
            self.evaluations += 1;
            let (time, ended) = self.line.go(&drive)?;
            if ended == Ended::Whole {
                self.time = end;
                return Ok(());
            }
            let rest = drive.duration - time;
            self.time = if rest > 0.0 { end - rest } else { end };
            if ended == Ended::Lost {
                self.lost()
            } else {
                self.turned()
            }
            if rest <= 4.0 * f64::EPSILON * drive.duration {
                self.line.leap(drive.end())?;
                self.time = end;
                return Ok(());
            }
            drive = drive.rest(time);
        }
        Err(Refusal::NotConverged { what: "the edge", detail: format!("turns again and again at t = {:e}", self.now()) })
    }
}
