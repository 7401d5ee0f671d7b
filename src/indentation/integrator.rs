//! One integration through a history: segments, kept instants, and what happens between steps.

use super::checkpoint::{IntegrationState, Observer};
use super::current_segment::{CurrentSegment, Place};
use super::cycle_integrals::CycleIntegrals;
use super::edge::{Edge, Imposed, node_of};
use super::history::Controlled;
use super::line::Contact;
use super::path_history::PathHistory;
use super::problem::{IndentationProblem, Start};
use super::record::Record;
use super::solution::{EventKind, Trace};
use super::springs::Springs;
use super::start::{size_of, started};
use super::step_sizes::towards;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// First time step of a segment, over the shortest relaxation time and over the segment, at a tolerance of 1; it goes with the root of the tolerance.
const FIRST_TIME: f64 = 0.1;
/// Ulp of the time below which no step goes: a clock that does not move is an integration that stands still.
pub(super) const CLOCK: f64 = 4.0;
/// Part of what is left of a segment, or of a way, that is all of it; and the part that is gone when two steps go there.
pub(super) const NEARLY: f64 = 0.999;
pub(super) const HALF: f64 = 0.5;
/// Relative change of a rate that is no corner.
const SAME_PACE: f64 = 1e-3;
/// Steps between two rounds of joining panels.
const COARSENING_INTERVAL: u64 = 4;
/// State, over the opening at the edge and the tolerance, by which joining panels may change anything.
const COARSENING_TOLERANCE: f64 = 1e-4;
/// Tolerance at which steps are as large as they may be.
pub(super) const LOOSEST: f64 = 0.03;
/// Parts of an instantaneous change, so that a path of equilibria is followed and not jumped over.
const PARTS: u32 = 16;

/// One integration through a history, at a tolerance of its path (of the edge over the process zone, per step): `material` in moduli E* = E/(1 − ν²). Where no steps
/// are needed ([`IndentationProblem::is_without_steps`]) one course of the exact method, as fine as the tolerance as an accuracy asks for.
///
/// # Errors
/// [`Refusal::OutOfRange`] for numbers out of range; [`Refusal::Undefined`] for a viscous material or a start that a control does not have;
/// [`Refusal::NoSuchState`] for a start without equilibrium, or a contact beyond the last point of a table; [`Refusal::NotConverged`].
pub fn integrate(material: &PlaneMaterial, problem: &IndentationProblem, tolerance: f64) -> Result<Trace, Refusal> {
    if problem.is_without_steps() {
        problem.checked()?;
        return super::adhesiveless::course(material, problem, crate::refusal::require_positive("tolerance", tolerance)?);
    }
    integrate_to(material, problem, tolerance, &[], Guide::default())
}

/// Where an integration begins, and who watches it.
#[derive(Default)]
pub(super) struct Guide<'a> {
    pub(super) from: Option<IntegrationState>,
    pub(super) observer: Option<Observer<'a>>,
}

/// The same with segments that end early: which, and how long they take (s).
pub(super) fn integrate_to(
    material: &PlaneMaterial,
    problem: &IndentationProblem,
    tolerance: f64,
    stops: &[(usize, f64)],
    guide: Guide<'_>,
) -> Result<Trace, Refusal> {
    problem.checked()?;
    let springs = Springs::new(material)?;
    let mut integrator = Integrator::new(&springs, problem, tolerance)?;
    let zone = integrator.edge.zone();
    integrator.observer = guide.observer;
    let mut trace = match guide.from {
        Some(state) => {
            integrator.restore(state)?;
            integrator.through(true)?
        }
        None => {
            integrator.record.trace.shortened = stops.to_vec();
            integrator.begin()?;
            integrator.through(false)?
        }
    };
    problem.profile.holds(trace.summary.scales[2], zone)?;
    trace.tolerance = tolerance;
    Ok(trace)
}

pub(super) struct Integrator<'a> {
    pub(super) springs: &'a Springs,
    pub(super) problem: &'a IndentationProblem,
    pub(super) tolerance: f64,
    pub(super) contact: Contact<'a>,
    pub(super) edge: Edge,
    pub(super) path_history: PathHistory,
    /// Start of the segment under way, and the time since: steps stay sharp after any dwell.
    pub(super) origin: f64,
    pub(super) time: f64,
    /// Next steps of the edge and of time.
    pub(super) reach: f64,
    pub(super) dt: f64,
    /// δ, or a 25th of the contact's size.
    pub(super) length: f64,
    /// Opening scale at the edge: errors of Δ and of states are seen against it.
    pub(super) opening: f64,
    /// When the history had its last corner, or the contact its last event: time steps grow from there.
    pub(super) corner: f64,
    /// Shortest time that counts after a corner.
    pub(super) first: f64,
    pub(super) pace: Option<(Controlled, f64)>,
    /// F(t) has a corner when the edge has left the place of its last corner by one process zone, and a weaker one when it has left that by another: a step ends there.
    /// Place and generation.
    pub(super) kink_places: Vec<(f64, u32)>,
    /// Where the edge turned, the latest last: the line has a kink there, and F(t) a corner when the edge comes back.
    pub(super) turns: Vec<f64>,
    pub(super) slopes: (f64, f64),
    /// Whether y(t) went on more smoothly than t(y) in the last step: time drives the next one then.
    pub(super) smooth_in_time: bool,
    /// What is added up over the cycle under way.
    pub(super) cycle_integrals: Option<CycleIntegrals>,
    pub(super) record: Record<'a>,
    pub(super) place: Place,
    pub(super) observer: Option<Observer<'a>>,
}

impl<'a> Integrator<'a> {
    fn new(springs: &'a Springs, problem: &'a IndentationProblem, tolerance: f64) -> Result<Self, Refusal> {
        let tolerance = crate::refusal::require_positive("tolerance", tolerance)?.min(0.1);
        let Some(adhesion) = problem.adhesion else {
            return Err(Refusal::Undefined {
                quantity: "an integration without adhesion",
                reason: "such a contact is solved without steps".into(),
            });
        };
        let contact = started(springs, problem, adhesion)?;
        let profile = &problem.profile;
        let largest = |controlled: Controlled| {
            let start = if problem.history.controlled == controlled { problem.history.start } else { 0.0 };
            let segments = problem.history.segments.iter().filter(|segment| segment.controlled == controlled);
            segments.fold(start.abs(), |most, segment| {
                most.max(segment.end.abs() + segment.oscillation.map_or(0.0, |it| it.amplitude + it.offset().abs()))
            })
        };
        let deepest = largest(Controlled::Penetration).max(largest(Controlled::Frame));
        // The smallest contact under the largest force: the glassy one.
        let size = size_of(profile, |a| profile.line(a), deepest)
            .max(size_of(profile, |a| 2.0 * springs.glassy * a * profile.line(a), largest(Controlled::Force)))
            .max(largest(Controlled::ContactRadius))
            .max(contact.radius());
        let size = if size > 0.0 { size } else { profile.rim() };
        let length = adhesion.process_zone;
        let depth = profile.line(size).max(contact.penetration().abs()).max(deepest);
        // A flat punch has no depth of its own; any length conditions an affine equation.
        let depth = if depth > 0.0 { depth } else { size };
        let opening = (2.0 * PI * contact.radius().max(length) * adhesion.work_of_adhesion / springs.glassy).sqrt().min(depth);
        let edge = Edge::new((adhesion, problem.edge_law.clone()), depth);
        Ok(Self {
            springs,
            problem,
            tolerance,
            cycle_integrals: None,
            record: Record::new(&contact, problem.energies),
            contact,
            edge,
            path_history: PathHistory::default(),
            origin: 0.0,
            time: 0.0,
            reach: 0.0,
            dt: 0.0,
            length,
            opening,
            corner: 0.0,
            first: 0.0,
            pace: None,
            kink_places: Vec::new(),
            turns: Vec::new(),
            slopes: (0.0, 0.0),
            smooth_in_time: false,
            place: Place::default(),
            observer: None,
        })
    }

    /// The state at the start, as the first point of the path.
    fn begin(&mut self) -> Result<(), Refusal> {
        let residual = if self.contact.radius() > 0.0 {
            let depth = self.contact.penetration();
            let here = move |_: f64| depth;
            let (_, residual) = self.edge.jumped(&self.contact, self.contact.radius(), &Imposed::Penetration(&here))?;
            if self.contact.radius() >= self.contact.profile().rim() {
                // A punch that its rim holds is in equilibrium below the work of adhesion.
                residual.max(0.0)
            } else if self.problem.start == Start::Untouched && self.problem.edge_law.by_speed.is_some() {
                // It jumped in, which no speed at rest tells of.
                0.0
            } else {
                residual
            }
        } else {
            0.0
        };
        self.record.point(self.now(), &self.contact, residual);
        if self.problem.start == Start::Untouched {
            self.record.happened(EventKind::JumpIn);
        }
        self.record.keep();
        Ok(())
    }

    /// The segments one after the other; `restored`: from within the one that a checkpoint was taken in.
    fn through(mut self, restored: bool) -> Result<Trace, Refusal> {
        let history = &self.problem.history;
        let mut last = (history.controlled, history.start);
        let first = if restored { self.place.segment } else { 0 };
        for (index, segment) in history.segments.iter().enumerate().skip(first) {
            let under_way = restored && index == first;
            let from = if under_way {
                self.place.from
            } else if segment.controlled == last.0 {
                last.1
            } else {
                self.present(segment.controlled)
            };
            let current = CurrentSegment { from, segment: *segment };
            let duration = if segment.duration == 0.0 {
                self.suddenly(&current)?;
                0.0
            } else {
                if !under_way {
                    self.enter(index, &current);
                }
                self.segment(&current)?
            };
            last = (segment.controlled, segment.value(from, duration));
        }
        let mut trace = self.record.finished();
        trace.work.closure_evaluations = self.edge.evaluations;
        trace.work.history_updates = self.edge.updates + self.contact.updates();
        Ok(trace)
    }

    /// Time since the start of the history (s).
    pub(super) fn now(&self) -> f64 {
        self.origin + self.time
    }

    /// The present value of a quantity.
    fn present(&self, controlled: Controlled) -> f64 {
        match controlled {
            Controlled::Penetration => self.contact.penetration(),
            Controlled::Force => self.contact.force(),
            Controlled::ContactRadius => self.contact.radius(),
            Controlled::Frame => {
                self.contact.penetration() + self.problem.frame_stiffness.map_or(0.0, |stiffness| self.contact.force() / stiffness)
            }
        }
    }

    /// An instantaneous segment.
    fn suddenly(&mut self, current: &CurrentSegment) -> Result<(), Refusal> {
        // The line keeps where the edge was; where it comes to rest the next segment begins.
        self.remember_turn(self.contact.radius());
        self.at_once(current)?;
        self.pace = None;
        self.record.keep();
        Ok(())
    }

    /// The start of a segment.
    fn enter(&mut self, index: usize, current: &CurrentSegment) {
        let segment = current.segment;
        let rate = current.rate();
        let same = segment.oscillation.is_none()
            && self
                .pace
                .is_some_and(|(controlled, last)| controlled == segment.controlled && (rate - last).abs() <= SAME_PACE * rate.abs());
        self.first = FIRST_TIME * self.springs.shortest_time().min(segment.duration).min(current.longest_step(0.0));
        if !same {
            self.restart_at_corner();
        }
        self.cycle_integrals = segment.oscillation.map(|oscillation| {
            let longest = self.springs.longest_retardation_time();
            CycleIntegrals::new(index, (oscillation, segment.duration), self.origin, longest, self.record.trace.path.last())
        });
        self.place = Place {
            segment: index,
            from: current.from,
            duration: self.record.end_of(index).unwrap_or(segment.duration),
            instant: 1,
            cycle: 1,
            budget: self.record.trace.work.steps + self.most_steps(),
        };
    }

    /// A segment of the history from where the integration is in it, landing on each kept instant and at the end of each cycle. How long it took: one
    /// that oscillates may end early.
    fn segment(&mut self, current: &CurrentSegment) -> Result<f64, Refusal> {
        let segment = current.segment;
        let until_stationary = segment.oscillation.is_some_and(|oscillation| oscillation.until_stationary);
        // Instants of a segment whose end is not known are its end alone.
        let instants = if until_stationary { 1 } else { self.problem.instants_per_segment.max(1) };
        let stop = self.record.end_of(self.place.segment);
        while self.time < self.place.duration {
            let Place { duration, instant, cycle, .. } = self.place;
            let next_instant = duration * if instant == instants { 1.0 } else { f64::from(instant) / f64::from(instants) };
            let end_of_cycle = current.end_of_cycle(cycle);
            let target = end_of_cycle.map_or(next_instant, |end| end.min(next_instant));
            self.go_to(current, target)?;
            if end_of_cycle.is_some_and(|end| end <= target) {
                self.place.cycle += 1;
                // What one cycle leaves of its steps is not the next one's: an integration that stands still would go through all of it.
                self.place.budget = self.record.trace.work.steps + self.most_steps();
                let stationary = self
                    .cycle_integrals
                    .as_mut()
                    .and_then(|cycle_integrals| self.record.cycle(cycle_integrals, self.origin + target, self.problem.accuracy));
                if until_stationary && stop.is_none() && stationary == Some(true) {
                    self.place.duration = target;
                    self.record.trace.shortened.push((self.place.segment, target));
                }
            }
            if self.time >= next_instant || self.time >= self.place.duration {
                self.record.keep();
                self.place.instant += 1;
            }
        }
        let duration = self.place.duration;
        self.record.last_cycle(self.cycle_integrals.take());
        self.pace = segment.oscillation.is_none().then_some((segment.controlled, current.rate()));
        self.origin += duration;
        self.time = 0.0;
        self.corner -= duration;
        Ok(duration)
    }

    fn go_to(&mut self, current: &CurrentSegment, target: f64) -> Result<(), Refusal> {
        while self.time < target {
            self.observe();
            // What an integration with a checkpoint here would not have.
            self.edge.forget();
            self.record.trace.work.steps += 1;
            if self.record.trace.work.steps > self.place.budget {
                let what = if current.segment.oscillation.is_some() { "cycle" } else { "segment" };
                return Err(Refusal::NotConverged {
                    what: "the integration",
                    detail: format!("{} steps of one {what} reached t = {:e}", self.most_steps(), self.now()),
                });
            }
            self.step(current, target)?;
            // Near a fold what joining changes would move the edge by its root, to and fro.
            if self.record.trace.work.steps.is_multiple_of(COARSENING_INTERVAL) && !self.is_near_fold() {
                self.contact.coarsened(COARSENING_TOLERANCE * self.tolerance.min(1e-2) * self.opening);
            }
        }
        Ok(())
    }

    /// One step towards a target time.
    fn step(&mut self, current: &CurrentSegment, target: f64) -> Result<(), Refusal> {
        let left = target - self.time;
        let grown = self.first_step().max(self.stride() * (self.time - self.corner));
        let cap = self.dt.min(grown).min(self.stride() * current.longest_step(self.time));
        let cap = towards(left, cap, CLOCK * f64::EPSILON * self.time);
        let now = self.time;
        let value = |dt: f64| current.value(if now + dt >= target { target } else { now + dt });
        let stiffness = self.problem.frame_stiffness.unwrap_or(0.0);
        let load = |dt: f64| if current.segment.controlled == Controlled::Frame { stiffness * value(dt) } else { value(dt) };
        let imposed = match current.segment.controlled {
            Controlled::Penetration => Imposed::Penetration(&value),
            Controlled::Force => Imposed::Load { value: &load, stiffness: 0.0 },
            Controlled::Frame => Imposed::Load { value: &load, stiffness },
            Controlled::ContactRadius => return self.prescribed_step(&value, cap, left, target),
        };
        let controlled = current.segment.controlled;
        let free_time = if self.contact.radius() == 0.0 { self.until_touch(controlled, cap, &value) } else { 0.0 };
        if free_time > 0.0 {
            // Time steps of an open contact may grow quickly: the surface relaxes exactly.
            let cap = free_time;
            self.open(controlled, cap, value(cap))?;
            self.dt = 2.0 * cap;
            self.went(cap, left, target, 0.0);
            return Ok(());
        }
        if self.contact.radius() == 0.0 {
            return self.touch_again(&imposed);
        }
        self.advance(cap, left, target, &imposed)
    }

    /// Time has gone by: records the state that is there now.
    pub(super) fn went(&mut self, dt: f64, left: f64, target: f64, residual: f64) {
        self.time = if dt >= left { target } else { self.time + dt };
        self.record.point(self.now(), &self.contact, residual);
        let node = node_of(self.contact.profile(), &self.contact, self.record.force());
        self.path_history.push(node, dt);
        self.edge.forget();
        if let (Some(cycle_integrals), Some(point)) = (&mut self.cycle_integrals, self.record.trace.path.last()) {
            cycle_integrals.step(point);
        }
    }

    /// An instantaneous change of what is imposed: the edge follows glassily, in small parts of the change.
    fn at_once(&mut self, current: &CurrentSegment) -> Result<(), Refusal> {
        let controlled = current.segment.controlled;
        let stiffness = self.problem.frame_stiffness.unwrap_or(0.0);
        for part in 1..=PARTS {
            let value = current.from + (current.segment.end - current.from) * f64::from(part) / f64::from(PARTS);
            if controlled == Controlled::ContactRadius {
                self.prescribed(value, 0.0, 1)?;
                self.went(0.0, 0.0, self.time, 0.0);
                continue;
            }
            if self.contact.radius() == 0.0 && self.is_open(controlled, value) {
                self.open(controlled, 0.0, value)?;
                self.went(0.0, 0.0, self.time, 0.0);
                continue;
            }
            let fixed = |_: f64| value;
            let load = |_: f64| stiffness * value;
            let imposed = match controlled {
                Controlled::Penetration | Controlled::ContactRadius => Imposed::Penetration(&fixed),
                Controlled::Force => Imposed::Load { value: &fixed, stiffness: 0.0 },
                Controlled::Frame => Imposed::Load { value: &load, stiffness },
            };
            if self.contact.radius() == 0.0 {
                self.touch_again(&imposed)?;
            } else {
                self.settle(&imposed)?;
            }
        }
        Ok(())
    }
}
