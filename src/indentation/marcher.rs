//! One march through a history: the way from step to step, jumps, loss of contact, and the account of energies.

use super::edge::{Edge, Imposed, Step};
use super::elastic_zone::tension_root;
use super::history::Segment;
use super::line::{Contact, Sweep};
use super::panel::RULE;
use super::problem::{Control, IndentationProblem, Resolution, Start};
use super::solution::{Event, EventKind, IndentationWork, PathPoint, Trace};
use super::springs::Springs;
use super::start::{size_of, started};
use super::zone::Zone;
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

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
/// Most steps of one march.
const MOST_STEPS: u64 = 200_000;

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
    /// The contact at the last point of the path.
    recorded: Contact<'a>,
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
        let history = problem.control.history();
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
        let recorded = contact.clone();
        Ok(Self { springs, problem, resolution, contact, recorded, edge, time: 0.0, step, corner: 0.0, pace: None, landmark, trace })
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
        let history = self.problem.control.history();
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
                if self.trace.work.steps.is_multiple_of(COARSENING_INTERVAL) {
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
                let kernel = Zone::new(radius, zone)?;
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
            let area = |point: &PathPoint| PI * point.contact_radius * point.contact_radius;
            let [external, tip, lost] = if set_free {
                [0.5 * (point.force + last.force) * (point.penetration - last.penetration), 0.0, 0.0]
            } else {
                turned_over(&self.recorded, contact, point.time - last.time, self.edge.sweep())
            };
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
        self.recorded = self.contact.clone();
    }
}

/// ∫F dΔ, ∫G_tip dA and ∫P_d dt over one step, by Gauss points of the motion itself: the line is exact at any instant within a step.
fn turned_over(from: &Contact<'_>, to: &Contact<'_>, time: f64, sweep: Sweep) -> [f64; 3] {
    let (rise, growth) = (to.penetration() - from.penetration(), to.radius() - from.radius());
    let mut sums = [0.0; 3];
    for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
        let radius = from.radius() + growth * x;
        let middle = from.moved_within(radius, from.penetration() + rise * x, time * x, sweep, (0.0, f64::INFINITY));
        sums[0] += weight * rise * middle.force();
        sums[1] += weight * growth * 2.0 * PI * radius * middle.tip_release_rate();
        sums[2] += weight * time * middle.dissipated_power();
    }
    sums
}

fn imposed<'h>(control: &Control, value: &'h dyn Fn(f64) -> f64) -> Imposed<'h> {
    match control {
        Control::Force(_) => Imposed::Force(value),
        Control::Penetration(_) | Control::ContactRadius(_) => Imposed::Penetration(value),
    }
}

fn no_edge(radius: f64) -> Refusal {
    Refusal::NoSuchState {
        reason: "the edge runs outwards and finds no equilibrium".into(),
        limit_name: "the contact radius from which it runs",
        limit: radius,
    }
}
