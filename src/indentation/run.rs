//! A history of contact from a problem to numbers with errors.

use super::elastic_zone::{elastic_contact, elastic_contact_of_radius, tension_root};
use super::history::{History, Segment};
use super::line::Contact;
use super::march::{Edge, Imposed, Step};
use super::profile::Profile;
use super::solution::{Event, EventKind, IndentationSolution, IndentationWork, Instant, PathPoint, Trace};
use super::springs::Springs;
use crate::estimate::Estimate;
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// Adhesion at the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adhesion {
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// δ (m).
    pub process_zone: f64,
}

/// What is imposed.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// Δ(t) (m).
    Penetration(History),
    /// F(t) (N), compression positive.
    Force(History),
    /// a(t) (m): the penetration follows from the edge condition.
    ContactRadius(History),
}

/// Where the history starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// On an untouched surface: with adhesion it jumps into contact at once, glassily; without it touches at a point.
    Untouched,
    /// From a contact held at the start value until it has relaxed.
    Relaxed,
}

/// How finely a march goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Steps of the edge per process zone (without adhesion: per quarter tenth of the contact's size, that is of a/25).
    pub steps_per_zone: f64,
    /// Largest time step over the time since the last corner of the history, or the last event.
    pub growth: f64,
}

impl Default for Resolution {
    fn default() -> Self {
        Self { steps_per_zone: 25.0, growth: 0.2 }
    }
}

impl Resolution {
    /// Twice as fine.
    #[must_use]
    pub fn halved(self) -> Self {
        Self { steps_per_zone: 2.0 * self.steps_per_zone, growth: 0.5 * self.growth }
    }
}

/// A history of contact: what is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationProblem {
    /// The indenter.
    pub profile: Profile,
    /// Adhesion; none for the contact without (Lee–Radok advancing, Ting receding).
    pub adhesion: Option<Adhesion>,
    /// What is imposed in time.
    pub control: Control,
    /// Where it starts.
    pub start: Start,
    /// Instants to keep in each segment, equally spaced, its end included.
    pub instants_per_segment: u32,
    /// Of the coarser of the two marches.
    pub resolution: Resolution,
}

/// Parts of the step below which an edge without a stable neighbour is taken as unstable.
const SMALLEST_STEP: f64 = 1.0 / 1024.0;
/// First time step of a segment, over the shortest relaxation time and over the segment.
const FIRST_TIME: f64 = 1e-3;
/// Relative change of a rate that is no corner.
const SAME_PACE: f64 = 0.1;
/// Steps between two rounds of joining panels.
const COARSENING_INTERVAL: u64 = 16;
/// Strain, over the largest penetration, by which joining panels may change anything.
const COARSENING_TOLERANCE: f64 = 1e-12;
/// Accepted residual of the edge condition.
const EDGE_TOLERANCE: f64 = 1e-12;
/// Bound over the change between the two marches: 1 for errors of first order, 1/3 for second; the rest is prudence.
const SAFETY: f64 = 1.5;
/// A change that passes through zero is no accuracy: half of the largest so far stays in the bound.
const MEMORY: f64 = 0.5;
/// What the tolerance of the edge condition leaves.
const ROUNDING: f64 = 1e-11;
/// Most steps of one march.
const MOST_STEPS: u64 = 200_000;

/// Solves a history on two resolutions: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// Every refusal of [`march`].
pub fn run(material: &Material, problem: &IndentationProblem) -> Result<IndentationSolution, Refusal> {
    let coarse = march(material, problem, problem.resolution)?;
    let fine = march(material, problem, problem.resolution.halved())?;
    let mut instants = Vec::with_capacity(fine.kept.len());
    let mut largest = [0.0_f64; 8];
    for (index, place) in fine.kept.iter().enumerate() {
        let Some(point) = fine.path.get(*place) else { continue };
        let other = coarse.kept.get(index).and_then(|place| coarse.path.get(*place));
        let mut estimate = |quantity: usize, of: fn(&PathPoint) -> f64| {
            let value = of(point);
            let change = other.map_or(f64::INFINITY, |other| (value - of(other)).abs());
            let so_far = largest.get_mut(quantity).map_or(change, |most| {
                *most = most.max(change);
                *most
            });
            Estimate::new(value, (SAFETY * change).max(MEMORY * so_far) + ROUNDING * value.abs())
        };
        instants.push(Instant {
            time: point.time,
            penetration: estimate(0, |point| point.penetration),
            force: estimate(1, |point| point.force),
            contact_radius: estimate(2, |point| point.contact_radius),
            stress_intensity_factor: estimate(3, |point| point.stress_intensity_factor),
            stored_energy: estimate(4, |point| point.stored_energy),
            dissipated_power: estimate(5, |point| point.dissipated_power),
            external_work: estimate(6, |point| point.external_work),
            dissipated_energy: estimate(7, |point| point.dissipated_energy),
            residual: point.residual,
        });
    }
    let events = fine.events.iter().enumerate().map(|(index, event)| {
        let other = coarse.events.get(index).filter(|other| other.kind == event.kind);
        let estimate = |of: fn(&Event<f64>) -> f64| {
            Estimate::new(of(event), other.map_or(f64::INFINITY, |other| SAFETY * (of(event) - of(other)).abs()))
        };
        Event {
            kind: event.kind,
            time: estimate(|event| event.time),
            penetration: estimate(|event| event.penetration),
            force: estimate(|event| event.force),
            contact_radius: estimate(|event| event.contact_radius),
        }
    });
    let events = events.collect();
    let largest_tension = fine.largest_tension().map(|value| {
        Estimate::new(value, coarse.largest_tension().map_or(value, |other| SAFETY * (value - other).abs() + ROUNDING * value))
    });
    let work = IndentationWork {
        steps: coarse.work.steps + fine.work.steps,
        closure_evaluations: coarse.work.closure_evaluations + fine.work.closure_evaluations,
        history_updates: coarse.work.history_updates + fine.work.history_updates,
        most_panels: coarse.work.most_panels.max(fine.work.most_panels),
    };
    let residual = fine.path.iter().fold(0.0, |most: f64, point| most.max(point.residual.abs()));
    Ok(IndentationSolution { instants, events, largest_tension, balance_defect: fine.balance_defect(), residual, fine, work })
}

/// One march through a history: `material` in moduli E* = E/(1 − ν²).
///
/// # Errors
/// [`Refusal::OutOfRange`] for numbers out of range; [`Refusal::Undefined`] for a viscous material or a start that a control does not have;
/// [`Refusal::NoSuchState`] for a start without equilibrium; [`Refusal::NotConverged`].
pub fn march(material: &Material, problem: &IndentationProblem, resolution: Resolution) -> Result<Trace, Refusal> {
    let springs = Springs::new(material)?;
    Marcher::new(&springs, problem, resolution)?.through()
}

struct Marcher<'a> {
    springs: &'a Springs,
    problem: &'a IndentationProblem,
    resolution: Resolution,
    contact: Contact<'a>,
    edge: Edge,
    time: f64,
    step: f64,
    /// When the history had its last corner, or the contact its last event: time steps grow from there.
    corner: f64,
    /// Rate of the last segment, and the last step and time: nearly the same rate goes on without a small restart.
    pace: Option<(f64, f64, f64)>,
    /// F(t) has a corner when the edge has left the first contact by one process zone: a step ends there.
    landmark: Option<f64>,
    trace: Trace,
}

impl<'a> Marcher<'a> {
    fn new(springs: &'a Springs, problem: &'a IndentationProblem, resolution: Resolution) -> Result<Self, Refusal> {
        let profile = problem.profile.checked()?;
        require_positive("steps_per_zone", resolution.steps_per_zone)?;
        require_positive("growth", resolution.growth)?;
        let history = history(&problem.control);
        history.checked()?;
        if let Some(adhesion) = problem.adhesion {
            require_positive("work_of_adhesion", adhesion.work_of_adhesion)?;
            require_positive("process_zone", adhesion.process_zone)?;
        }
        let contact = started(springs, problem)?;
        let largest = history.segments.iter().fold(history.start.abs(), |most, segment| most.max(segment.end.abs()));
        let size = match problem.control {
            Control::ContactRadius(_) => largest,
            Control::Penetration(_) => size_of(profile, |a| profile.line(a), largest),
            // The smallest contact under the largest force: the glassy one.
            Control::Force(_) => size_of(profile, |a| 2.0 * springs.glassy * a * profile.line(a), largest),
        }
        .max(contact.radius());
        let step = problem.adhesion.map_or(size / 25.0, |adhesion| adhesion.process_zone) / resolution.steps_per_zone;
        let depth_scale = profile.line(size).max(contact.penetration().abs()).max(match problem.control {
            Control::Penetration(_) => largest,
            _ => 0.0,
        });
        // A flat punch has no depth of its own; any length conditions an affine equation.
        let depth_scale = if depth_scale > 0.0 { depth_scale } else { size };
        let edge = Edge {
            adhesion: problem.adhesion,
            kernel: None,
            load_scale: springs.glassy * depth_scale,
            depth_scale,
            tolerance: EDGE_TOLERANCE,
            evaluations: 0,
            updates: 0,
        };
        let landmark = problem.adhesion.map(|adhesion| contact.radius() - adhesion.process_zone);
        let trace = Trace { path: Vec::new(), kept: Vec::new(), events: Vec::new(), work: IndentationWork::default() };
        Ok(Self { springs, problem, resolution, contact, edge, time: 0.0, step, corner: 0.0, pace: None, landmark, trace })
    }

    fn through(mut self) -> Result<Trace, Refusal> {
        let residual = match self.problem.adhesion {
            Some(_) if self.contact.radius() > 0.0 => {
                let (a, depth) = (self.contact.radius(), self.contact.penetration());
                self.edge.residual_at(&self.contact, a, depth, 0.0)?
            }
            _ => 0.0,
        };
        if self.problem.start == Start::Untouched && self.problem.adhesion.is_some() {
            self.happened(EventKind::JumpIn);
        }
        self.record(residual, false);
        self.trace.kept.push(0);
        let history = history(&self.problem.control);
        let mut from = history.start;
        for segment in &history.segments {
            if segment.duration == 0.0 {
                self.segment(from, *segment, 1)?;
            } else {
                self.segment(from, *segment, self.problem.instants_per_segment.max(1))?;
            }
            from = segment.end;
        }
        self.trace.work.closure_evaluations = self.edge.evaluations;
        self.trace.work.history_updates = self.edge.updates;
        Ok(self.trace)
    }

    /// A stretch of the history, landing on each kept instant.
    fn segment(&mut self, from: f64, segment: Segment, instants: u32) -> Result<(), Refusal> {
        let start = self.time;
        let end = start + segment.duration;
        let value = |time: f64| if time >= end { segment.end } else { from + (segment.end - from) * ((time - start) / segment.duration) };
        let first = FIRST_TIME * self.springs.shortest_time().min(segment.duration);
        let rate = (segment.end - from) / segment.duration;
        let (mut reach, mut guess) = match self.pace {
            Some((last, reach, guess)) if (rate - last).abs() <= SAME_PACE * rate.abs() => (reach, guess),
            _ => {
                self.corner = start;
                (0.1 * self.step, first)
            }
        };
        if segment.duration == 0.0 {
            self.at_once(from, segment.end)?;
        }
        for instant in 1..=instants {
            if segment.duration == 0.0 {
                break;
            }
            let target = if instant == instants { end } else { start + segment.duration * (f64::from(instant) / f64::from(instants)) };
            while self.time < target {
                self.trace.work.steps += 1;
                if self.trace.work.steps > MOST_STEPS {
                    return Err(Refusal::NotConverged {
                        what: "the march",
                        detail: format!("{MOST_STEPS} steps reached t = {:e}", self.time),
                    });
                }
                let left = target - self.time;
                let growth = first + self.resolution.growth * (self.time - self.corner);
                let cap = if growth >= 0.999 * left { left } else { growth };
                let now = self.time;
                let dt = if self.contact.radius() == 0.0 && self.is_open(value(now)) {
                    let cap = self.until_touch(cap, &|dt| value(now + dt));
                    self.open(cap, value(now + cap))?;
                    cap
                } else if self.contact.radius() == 0.0 && self.problem.adhesion.is_some() {
                    self.touch_again(&|dt| value(now + dt))?;
                    0.0
                } else if let Control::ContactRadius(_) = self.problem.control {
                    let rate = (segment.end - from).abs() / segment.duration;
                    let cap = if rate * cap > self.step { self.step / rate } else { cap };
                    self.prescribed(value(now + cap), cap)?;
                    cap
                } else {
                    match self.controlled(reach, cap, guess, &|dt| value(now + dt))? {
                        Some(dt) => {
                            guess = if dt > 0.0 { dt } else { guess };
                            dt
                        }
                        None => 0.0,
                    }
                };
                self.time = if dt >= left { target } else { self.time + dt };
                if let Some(last) = self.trace.path.last_mut() {
                    last.time = self.time;
                }
                reach = (1.3 * reach).min(self.step);
                if self.trace.work.steps % COARSENING_INTERVAL == 0 {
                    self.contact.coarsened(COARSENING_TOLERANCE * self.edge.depth_scale);
                }
            }
            self.trace.kept.push(self.trace.path.len() - 1);
        }
        self.pace = (segment.duration > 0.0).then_some((rate, reach, guess));
        Ok(())
    }

    /// W on the axis of an open contact, which the indenter touches first.
    fn surface(&self) -> f64 {
        self.contact.free_displacement(1.0).first().map_or(0.0, |panel| panel.at(0.0))
    }

    /// Whether an open contact stays open under the imposed value.
    fn is_open(&self, value: f64) -> bool {
        match self.problem.control {
            Control::Penetration(_) => value < self.surface(),
            // An indenter pushed by a force stays where it lost contact, until it is pushed again.
            Control::Force(_) => value <= 0.0,
            Control::ContactRadius(_) => value <= 0.0,
        }
    }

    /// The time for which the indenter stays off a surface that creeps back: at most `cap`.
    fn until_touch(&self, cap: f64, value: &dyn Fn(f64) -> f64) -> f64 {
        let Control::Penetration(_) = self.problem.control else { return cap };
        let overlap = |dt: f64| match self.contact.moved(0.0, value(dt), dt, self.edge.sweep()) {
            Ok(later) => value(dt) - later.free_displacement(1.0).first().map_or(0.0, |panel| panel.at(0.0)),
            Err(_) => -1.0,
        };
        if overlap(cap) < 0.0 {
            return cap;
        }
        let (mut low, mut high) = (0.0, cap);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if overlap(middle) < 0.0 { low = middle } else { high = middle }
        }
        high
    }

    /// An adhesive indenter touches a surface that it left before: the edge jumps out to the first stable place.
    fn touch_again(&mut self, value: &dyn Fn(f64) -> f64) -> Result<(), Refusal> {
        let imposed = imposed(&self.problem.control, value);
        self.happened(EventKind::JumpIn);
        let (from, end) = (self.smallest(), 1e3 * self.smallest());
        match self.edge.elsewhere(&self.contact, from, false, 0.5 * self.step, end, &imposed)? {
            Some(place) => self.jump(place, &imposed, true),
            None => Err(no_edge(0.0)),
        }
    }

    fn open(&mut self, dt: f64, value: f64) -> Result<(), Refusal> {
        let depth = if let Control::Penetration(_) = self.problem.control { value } else { self.contact.penetration() };
        self.contact = self.contact.moved(0.0, depth, dt, self.edge.sweep())?;
        self.advance_time(dt, 0.0);
        Ok(())
    }

    /// An instantaneous change of what is imposed: the edge follows glassily, in small parts of the change.
    fn at_once(&mut self, from: f64, end: f64) -> Result<(), Refusal> {
        // Parts of the step, so that a path of equilibria is followed and not jumped over.
        let parts = 64;
        for part in 1..=parts {
            let value = from + (end - from) * f64::from(part) / f64::from(parts);
            if let Control::ContactRadius(_) = self.problem.control {
                self.prescribed(value, 0.0)?;
                continue;
            }
            if self.contact.radius() == 0.0 && self.trace.path.len() > 1 {
                self.open(0.0, value)?;
                continue;
            }
            let fixed = |_: f64| value;
            self.settle(&fixed)?;
        }
        self.trace.kept.push(self.trace.path.len() - 1);
        Ok(())
    }

    /// At a fixed instant, the nearest stable edge the way the residual points.
    fn settle(&mut self, value: &dyn Fn(f64) -> f64) -> Result<(), Refusal> {
        let imposed = imposed(&self.problem.control, value);
        let a = self.contact.radius();
        let here = if a > 0.0 { self.edge.residual(&self.contact, a, 0.0, &imposed)? } else { -1.0 };
        let inwards = here > 0.0;
        if here.abs() <= EDGE_TOLERANCE {
            let depth = self.edge.penetration(&self.contact, a, 0.0, &imposed)?;
            self.contact = self.contact.moved(a, depth, 0.0, self.edge.sweep())?;
            self.record(here, false);
            return Ok(());
        }
        let end = if inwards { self.smallest() } else { 1e3 * (a + self.step) };
        match self.edge.elsewhere(&self.contact, a, inwards, 0.2 * self.step, end, &imposed)? {
            Some(place) => self.jump(place, &imposed, false),
            None if inwards => self.detach(&imposed, EventKind::Detachment),
            None => Err(no_edge(a)),
        }
    }

    fn smallest(&self) -> f64 {
        self.problem.adhesion.map_or(1e-3 * self.step, |adhesion| 1.05 * adhesion.process_zone)
    }

    fn jump(&mut self, place: f64, imposed: &Imposed<'_>, set_free: bool) -> Result<(), Refusal> {
        let depth = self.edge.penetration(&self.contact, place, 0.0, imposed)?;
        let residual = self.edge.residual_at(&self.contact, place, depth, 0.0)?;
        self.contact = self.contact.moved(place, depth, 0.0, self.edge.sweep())?;
        self.record(residual, set_free);
        Ok(())
    }

    fn detach(&mut self, imposed: &Imposed<'_>, kind: EventKind) -> Result<(), Refusal> {
        self.happened(kind);
        let depth = match imposed {
            Imposed::Penetration(history) => history(0.0),
            Imposed::Force(_) => self.contact.penetration(),
        };
        self.contact = self.contact.moved(0.0, depth, 0.0, self.edge.sweep())?;
        self.record(0.0, true);
        Ok(())
    }

    fn happened(&mut self, kind: EventKind) {
        self.corner = self.time;
        self.trace.events.push(Event {
            kind,
            time: self.time,
            penetration: self.contact.penetration(),
            force: self.contact.force(),
            contact_radius: self.contact.radius(),
        });
    }

    /// One step under penetration or force; none if the edge jumped instead.
    fn controlled(&mut self, reach: f64, cap: f64, guess: f64, value: &dyn Fn(f64) -> f64) -> Result<Option<f64>, Refusal> {
        let imposed = imposed(&self.problem.control, value);
        let mut reach = reach;
        let smallest = self.smallest();
        if let Some(mark) = self.landmark {
            let left = self.contact.radius() - mark;
            if left > 1e-6 * self.step && left < reach {
                reach = left;
            }
        }
        let mut inwards = true;
        let first = reach;
        while reach >= SMALLEST_STEP * first {
            if self.contact.radius() - reach <= smallest && self.problem.adhesion.is_some() {
                self.detach(&imposed, EventKind::ZoneReached)?;
                return Ok(None);
            }
            if self.problem.adhesion.is_none() && self.contact.radius() > 0.0 {
                // Shrinks with the contact; a point of contact is lost.
                reach = reach.min(0.25 * self.contact.radius());
                if self.contact.radius() <= smallest
                    && self.edge.residual(&self.contact, self.contact.radius(), guess.min(cap), &imposed)? > 0.0
                {
                    self.detach(&imposed, EventKind::Detachment)?;
                    return Ok(None);
                }
            }
            if self.contact.radius() == 0.0 {
                return self.touched(reach, cap, &imposed).map(Some);
            }
            match self.edge.step(&self.contact, reach, cap, guess, &imposed)? {
                Step::Moved(next, dt, residual) => {
                    self.contact = next;
                    self.advance_time(dt, residual);
                    return Ok(Some(dt));
                }
                Step::Unstable(way) => inwards = way,
            }
            reach *= 0.25;
        }
        let end = if inwards { smallest } else { 1e3 * (self.contact.radius() + self.step) };
        match self.edge.elsewhere(&self.contact, self.contact.radius(), inwards, 0.5 * self.step, end, &imposed)? {
            Some(place) => {
                self.happened(if inwards { EventKind::PartialDetachment } else { EventKind::JumpOut });
                self.jump(place, &imposed, true)?;
            }
            None if inwards => self.detach(&imposed, EventKind::Detachment)?,
            None => return Err(no_edge(self.contact.radius())),
        }
        Ok(None)
    }

    /// Without adhesion the contact grows from a point: the time at which its edge has gone one small step.
    fn touched(&mut self, reach: f64, cap: f64, imposed: &Imposed<'_>) -> Result<f64, Refusal> {
        let mut target = reach;
        for _ in 0..60 {
            let value = self.edge.residual(&self.contact, target, cap, imposed)?;
            if value <= 0.0 {
                let start = self.edge.residual(&self.contact, target, 0.0, imposed)?;
                let contact = self.contact.clone();
                let time = self.edge.root((cap, value), (0.0, start), |edge, time| edge.residual(&contact, target, time, imposed))?;
                let depth = self.edge.penetration(&self.contact, target, time, imposed)?;
                let residual = self.edge.residual_at(&self.contact, target, depth, time)?;
                self.contact = self.contact.moved(target, depth, time, self.edge.sweep())?;
                self.advance_time(time, residual);
                return Ok(time);
            }
            target *= 0.5;
        }
        self.open(
            cap,
            match imposed {
                Imposed::Penetration(history) | Imposed::Force(history) => history(cap),
            },
        )?;
        Ok(cap)
    }

    /// A given edge after dt: the penetration from the edge condition.
    fn prescribed(&mut self, radius: f64, dt: f64) -> Result<(), Refusal> {
        let (here, unit) = (self.contact.penetration(), self.edge.depth_scale);
        let depth = match self.problem.adhesion {
            None => {
                let (first, second) = (
                    self.edge.residual_at(&self.contact, radius, here, dt)?,
                    self.edge.residual_at(&self.contact, radius, here + unit, dt)?,
                );
                here - unit * first / (second - first)
            }
            Some(adhesion) => {
                let zone = adhesion.process_zone;
                let kernel = super::zone::Zone::new(radius, zone)?;
                let mut sample = |x: f64| {
                    self.edge.evaluations += 1;
                    let trial = self.contact.moved_within(radius, here - unit * x, dt, self.edge.sweep(), (radius - zone, radius + zone));
                    trial.zone_work_with(&kernel, zone)
                };
                here - unit * tension_root([sample(0.0), sample(1.0), sample(2.0)], adhesion.work_of_adhesion)?
            }
        };
        let residual = self.edge.residual_at(&self.contact, radius, depth, dt)?;
        self.contact = self.contact.moved(radius, depth, dt, self.edge.sweep())?;
        self.advance_time(dt, residual);
        Ok(())
    }

    fn advance_time(&mut self, dt: f64, residual: f64) {
        let before = self.time;
        self.time += dt;
        self.record(residual, false);
        self.time = before;
    }

    /// Adds the present state to the path; what a jump sets free is counted as dissipated.
    fn record(&mut self, residual: f64, set_free: bool) {
        let contact = &self.contact;
        let mut point = PathPoint {
            time: self.time,
            penetration: contact.penetration(),
            force: contact.force(),
            contact_radius: contact.radius(),
            stress_intensity_factor: contact.stress_intensity_factor(),
            residual,
            stored_energy: contact.stored_energy(),
            dissipated_power: contact.dissipated_power(),
            external_work: 0.0,
            tip_work: 0.0,
            dissipated_energy: 0.0,
            balance_defect: 0.0,
        };
        if let Some(last) = self.trace.path.last() {
            let release = |point: &PathPoint| point.stress_intensity_factor.powi(2) / (2.0 * self.springs.glassy);
            let area = |point: &PathPoint| PI * point.contact_radius * point.contact_radius;
            let external = 0.5 * (point.force + last.force) * (point.penetration - last.penetration);
            let tip = 0.5 * (release(&point) + release(last)) * (area(&point) - area(last));
            let lost = 0.5 * (point.dissipated_power + last.dissipated_power) * (point.time - last.time);
            let stored = point.stored_energy - last.stored_energy;
            if set_free {
                // The interface takes Δγ per area from what the springs release; the rest is set free.
                let work = self.problem.adhesion.map_or(0.0, |adhesion| adhesion.work_of_adhesion) * (area(&point) - area(last));
                point.external_work = last.external_work + external;
                point.tip_work = last.tip_work + work;
                point.dissipated_energy = last.dissipated_energy + external + work - stored;
            } else {
                point.external_work = last.external_work + external;
                point.tip_work = last.tip_work + tip;
                point.dissipated_energy = last.dissipated_energy + lost;
                point.balance_defect = external + tip - stored - lost;
            }
        }
        self.trace.work.most_panels = self.trace.work.most_panels.max(self.contact.panels() as u64);
        self.trace.path.push(point);
    }
}

fn imposed<'h>(control: &Control, value: &'h dyn Fn(f64) -> f64) -> Imposed<'h> {
    match control {
        Control::Force(_) => Imposed::Force(value),
        Control::Penetration(_) | Control::ContactRadius(_) => Imposed::Penetration(value),
    }
}

fn history(control: &Control) -> &History {
    match control {
        Control::Penetration(history) | Control::Force(history) | Control::ContactRadius(history) => history,
    }
}

fn no_edge(radius: f64) -> Refusal {
    Refusal::NoSuchState {
        reason: "the edge runs outwards and finds no equilibrium".into(),
        limit_name: "the contact radius from which it runs",
        limit: radius,
    }
}

/// The radius at which a rising function reaches a value.
fn size_of(profile: Profile, function: impl Fn(f64) -> f64, value: f64) -> f64 {
    if profile == Profile::FlatPunch || value <= 0.0 {
        return 0.0;
    }
    let mut high = 1.0;
    while function(high) < value && high < 1e30 {
        high *= 2.0;
    }
    while function(high) > value && high > 1e-30 {
        high *= 0.5;
    }
    let (mut low, mut top) = (high, 2.0 * high);
    for _ in 0..60 {
        let middle = 0.5 * (low + top);
        if function(middle) < value {
            low = middle;
        } else {
            top = middle;
        }
    }
    top
}

/// The first contact.
fn started<'a>(springs: &'a Springs, problem: &IndentationProblem) -> Result<Contact<'a>, Refusal> {
    let relaxed = problem.start == Start::Relaxed;
    let modulus = if relaxed { springs.relaxed } else { springs.glassy };
    let profile = problem.profile;
    let value = history(&problem.control).start;
    let (a, depth) = match (problem.adhesion, &problem.control) {
        (Some(adhesion), Control::Penetration(_)) => {
            let state = elastic_contact(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), Control::ContactRadius(_)) => {
            let state = elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, value)?;
            (state.contact_radius, state.penetration)
        }
        (Some(adhesion), Control::Force(_)) => {
            let by_radius = |a: f64| elastic_contact_of_radius(profile, modulus, adhesion.work_of_adhesion, adhesion.process_zone, a);
            // The largest contact in equilibrium: from far out, inwards, to the first force below the imposed one.
            let mut high = 1.01 * adhesion.process_zone;
            let mut beyond = 0;
            while beyond < 60 {
                beyond = if by_radius(high)?.force > value { beyond + 1 } else { 0 };
                high *= 1.02;
            }
            let mut low = high;
            while by_radius(low)?.force > value {
                high = low;
                low /= 1.02;
                if low <= adhesion.process_zone {
                    return Err(Refusal::NoSuchState {
                        reason: format!("the force {value:e} pulls more than any contact can hold"),
                        limit_name: "the process zone",
                        limit: adhesion.process_zone,
                    });
                }
            }
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if by_radius(middle)?.force > value { high = middle } else { low = middle }
            }
            let state = by_radius(high)?;
            (state.contact_radius, state.penetration)
        }
        (None, Control::ContactRadius(_)) => (value, profile.line(value)),
        (None, Control::Penetration(_)) => (size_of(profile, |a| profile.line(a), value), value),
        (None, Control::Force(_)) => {
            let load = |a: f64| {
                let panels = profile.breaks(a);
                let panels = panels.windows(2).map(|pair| super::panel::Panel::sampled(pair[0], pair[1], |s| profile.line(s)).integral());
                2.0 * modulus * (a * profile.line(a) - panels.sum::<f64>())
            };
            let a = size_of(profile, load, value);
            (a, profile.line(a))
        }
    };
    if relaxed { Contact::relaxed(springs, profile, a, depth) } else { Contact::untouched(springs, profile, a, depth) }
}
