//! The edge condition of a trial step.
//!
//! The residual g(a, dt) falls below zero when the edge advances too little for its time and is positive where it should recede:
//! g = C/Δγ − 1, with the sign of a pressed edge turned, or −Q(a) without adhesion. At dt = 0 the solid answers glassily, and a stable
//! edge has g(a − h) < 0 < g(a + h).

use super::edge_law::EdgeLaw;
use super::line::{Contact, Sweep};
use super::motion::{Motion, Passage};
use super::panel::value_at;
use super::path_history::{Node, PathHistory};
use super::problem::Adhesion;
use super::profile::Profile;
use super::springs::DEGREE;
use super::stepping::SMALLEST;
use super::window::Window;
use super::zone::Zone;
use super::zone_work::zone_work;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// A window graded for one time serves shorter times, and longer ones up to this factor: within a search its grading must not go back and forth.
const SAME_GRADING: f64 = 4.0;

/// A zone that grows, over its length at G = Δγ: below, the pull is nowhere near enough for the edge to move.
const LEAST_GROWTH: f64 = 1e-2;
/// Room about the edge for a zone that grows.
const ROOM: f64 = 2.0;
/// Deviation from a straight way, over the depth, that is rounding.
const STRAIGHT_TO: f64 = 8.0 * f64::EPSILON;
/// Powers 1 to 5 of the polynomials of degree five that are zero at 0 and at all fifths but one.
const THROUGH_FIFTHS: [[f64; DEGREE]; DEGREE] = [
    [25.0, -1925.0 / 12.0, 8875.0 / 24.0, -4375.0 / 12.0, 3125.0 / 24.0],
    [-25.0, 2675.0 / 12.0, -7375.0 / 12.0, 8125.0 / 12.0, -3125.0 / 12.0],
    [50.0 / 3.0, -325.0 / 2.0, 6125.0 / 12.0, -625.0, 3125.0 / 12.0],
    [-25.0 / 4.0, 1525.0 / 24.0, -5125.0 / 24.0, 6875.0 / 24.0, -3125.0 / 24.0],
    [1.0, -125.0 / 12.0, 875.0 / 24.0, -625.0 / 12.0, 625.0 / 24.0],
];

/// What is imposed at a time after the present instant.
#[derive(Clone, Copy)]
pub(super) enum Imposed<'h> {
    /// Δ.
    Penetration(&'h dyn Fn(f64) -> f64),
    /// F + k·(Δ + F/k)… of a force (k = 0) or a frame: F + kΔ = k·(place of the frame), or F = force.
    Load {
        /// F, or k times the place of the frame.
        value: &'h dyn Fn(f64) -> f64,
        /// k_f, 0 for a force.
        stiffness: f64,
    },
}

/// What drives a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Drive {
    /// The edge goes a given way: t(y) is the polynomial.
    Edge,
    /// A given time goes by: y(t) is.
    Time,
}

/// A step tried.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    pub(super) motion: Motion,
    pub(super) penetration: f64,
    pub(super) residual: f64,
    /// −g at the same place at once, what the time makes up for; infinite where it was not asked for.
    pub(super) drive: f64,
    /// Error of one degree less: of the place of the edge within the step, and of Δ (m).
    pub(super) place_error: f64,
    pub(super) depth_error: f64,
    pub(super) degree: u32,
}

/// The edge condition, what it remembers, and its counters.
pub(super) struct Edge {
    pub(super) adhesion: Adhesion,
    pub(super) law: EdgeLaw,
    /// Length scale of changes of Δ, to condition differences.
    pub(super) depth_scale: f64,
    /// The kernel and the window of the last trial edge: many trials share one.
    kernel: Option<(f64, Zone)>,
    /// Degree of the path in the search under way.
    pub(super) held: Option<u32>,
    window: Option<Window>,
    pub(super) evaluations: u64,
    pub(super) updates: u64,
}

impl Edge {
    pub(super) fn new((adhesion, law): (Adhesion, EdgeLaw), depth_scale: f64) -> Self {
        Self { adhesion, law, depth_scale, kernel: None, held: None, window: None, evaluations: 0, updates: 0 }
    }

    /// As it was between two steps: what makes trials quick is found again.
    pub(super) fn restore(&mut self, held: Option<u32>, evaluations: u64, updates: u64) {
        (self.held, self.evaluations, self.updates) = (held, evaluations, updates);
        (self.kernel, self.window) = (None, None);
    }

    /// δ₀.
    pub(super) fn zone(&self) -> f64 {
        self.adhesion.process_zone
    }

    /// δ at an edge of a contact with Q(a).
    pub(super) fn zone_at(&self, contact: &Contact<'_>, radius: f64, edge_load: f64) -> f64 {
        if self.law.growing_zone { grown(&self.adhesion, contact.springs().relaxed, (radius, edge_load)) } else { self.zone() }
    }

    /// How far about an edge the closure may look: a zone that grows may do so within the step.
    fn reach(&self, contact: &Contact<'_>) -> f64 {
        if !self.law.growing_zone {
            return self.zone();
        }
        ROOM * self.zone_at(contact, contact.radius(), contact.edge_load()).max(self.zone())
    }

    /// Forgets what belongs to the state before a step.
    pub(super) fn forget(&mut self) {
        self.window = None;
    }

    /// How the edge goes from here to a place in a time.
    fn passage(
        &mut self,
        contact: &Contact<'_>,
        path_history: &PathHistory,
        (radius, dt): (f64, f64),
        drive: Drive,
    ) -> (Passage, f64, u32) {
        let Some(&now) = path_history.nodes().first() else { return (Passage::Radius, 0.0, 1) };
        let way = contact.profile().coordinate(radius) - now.place;
        if dt == 0.0 || way == 0.0 {
            return (Passage::Radius, 0.0, 1);
        }
        let parts = |node: &Node| ((node.place - now.place) / way, node.time / dt);
        let distance = (radius - contact.radius()).abs();
        match drive {
            Drive::Edge => {
                let bridge = path_history.bridge(self.held, false, parts);
                self.held = Some(bridge.degree);
                (Passage::TimeOfPlace(bridge.coefficients), bridge.error * distance, bridge.degree)
            }
            Drive::Time => {
                let bridge = path_history.bridge(self.held, true, |node| {
                    let (place, time) = parts(node);
                    (time, place)
                });
                self.held = Some(bridge.degree);
                (Passage::PlaceOfTime(bridge.coefficients), bridge.error * distance, bridge.degree)
            }
        }
    }

    /// The degree that a path to a place would have by itself, whatever the search under way holds to.
    pub(super) fn free_degree(&mut self, contact: &Contact<'_>, path_history: &PathHistory, (radius, dt): (f64, f64), drive: Drive) -> u32 {
        let held = self.held.take();
        let (_, _, degree) = self.passage(contact, path_history, (radius, dt), drive);
        self.held = held;
        degree
    }

    /// Last terms of t(y) and of y(t) of a path to a place: which of the two is the smoother.
    pub(super) fn terms(&mut self, contact: &Contact<'_>, path_history: &PathHistory, to: (f64, f64)) -> (f64, f64) {
        let held = self.held.take();
        let mut term = |drive: Drive| {
            self.held = None;
            self.passage(contact, path_history, to, drive).1
        };
        let terms = (term(Drive::Edge), term(Drive::Time));
        self.held = held;
        terms
    }

    /// A step to an edge in a time, the penetration as imposed.
    pub(super) fn trial(
        &mut self,
        contact: &Contact<'_>,
        path_history: &PathHistory,
        (radius, dt): (f64, f64),
        drive: Drive,
        imposed: &Imposed<'_>,
    ) -> Result<Trial, Refusal> {
        let (passage, place_error, degree) = self.passage(contact, path_history, (radius, dt), drive);
        let here = contact.penetration();
        let motion_of = |powers: [f64; DEGREE]| Motion::new(contact.profile(), (contact.radius(), radius), dt, passage, here, powers);
        let (motion, depth_error) = match imposed {
            Imposed::Penetration(history) => (motion_of(course(dt, here, self.depth_scale, history)), 0.0),
            Imposed::Load { value, stiffness } => {
                // An edge at rest says nothing about how smoothly Δ goes.
                let rests = radius.to_bits() == contact.radius().to_bits();
                let depth_degree = if rests { path_history.nodes().len().clamp(1, DEGREE) as u32 } else { degree };
                let depths = |rise: f64| match path_history.nodes().first() {
                    Some(_) if dt > 0.0 => path_history.powers(rise, depth_degree, |node| (node.time / dt, node.penetration - here)),
                    _ => ([rise, 0.0, 0.0, 0.0, 0.0], 0.0),
                };
                // F is affine in Δ; a unit of its own size keeps the digits of a contact that grows from a point.
                let own = contact.profile().line(radius).max(here.abs());
                let unit = if own > 0.0 { own } else { self.depth_scale };
                let first = self.load(contact, &motion_of(depths(0.0).0)) + stiffness * here;
                let second = self.load(contact, &motion_of(depths(unit).0)) + stiffness * (here + unit);
                let rise = unit * (value(dt) - first) / (second - first);
                let (powers, error) = depths(rise);
                (motion_of(powers), error)
            }
        };
        let residual = self.residual(contact, &motion, matches!(imposed, Imposed::Load { .. }))?;
        Ok(Trial { penetration: motion.end_penetration(), motion, residual, drive: f64::INFINITY, place_error, depth_error, degree })
    }

    fn prepare(&mut self, contact: &Contact<'_>, motion: &Motion, whole: bool) -> Window {
        match self.window.take() {
            Some(window) if window.radius.to_bits() == motion.to.to_bits() && motion.time <= SAME_GRADING * window.time => window,
            _ => Window::new(contact, motion.to, motion.time, self.reach(contact), whole),
        }
    }

    /// C (J/m²) after a motion, with Q(a) and D(a).
    fn closure(&mut self, contact: &Contact<'_>, motion: &Motion, whole: bool) -> Result<[f64; 3], Refusal> {
        self.evaluations += 1;
        let mut window = self.prepare(contact, motion, whole);
        self.updates += window.after(contact, motion);
        let edge_load = value_at(&window.loads, motion.to);
        let length = self.zone_at(contact, motion.to, edge_load);
        if length > window.reach {
            window = Window::new(contact, motion.to, motion.time, ROOM * length, whole);
            self.updates += window.after(contact, motion);
        }
        let kernel = self.kernel_at(motion.to, length)?;
        let work = zone_work(&kernel, &window.loads, &window.gaps);
        self.kernel = Some((motion.to, kernel));
        let found = [work, edge_load, value_at(&window.gaps, motion.to)];
        self.window = Some(window);
        Ok(found)
    }

    fn load(&mut self, contact: &Contact<'_>, motion: &Motion) -> f64 {
        let mut window = self.prepare(contact, motion, true);
        self.updates += window.after(contact, motion);
        let force = window.force(contact, motion);
        self.window = Some(window);
        force
    }

    /// g of a motion.
    pub(super) fn residual(&mut self, contact: &Contact<'_>, motion: &Motion, whole: bool) -> Result<f64, Refusal> {
        let [work, edge_load, edge_gap] = self.closure(contact, motion, whole)?;
        let speed = if self.law.by_speed.is_some() { motion.edge_speed(contact.profile()) } else { 0.0 };
        finite(self.signed(work / self.adhesion.work_of_adhesion, (edge_load, edge_gap), motion.to - motion.from, speed), motion.to)
    }

    /// C is a product: a pressed edge over an overlapping surface works positively as well, on the other side of equilibrium. D(a) = −Q(a)/E∞*, so both sides of the
    /// edge tell; one alone may be noise, where a layer is thinner than any panel.
    fn signed(&self, work: f64, (edge_load, edge_gap): (f64, f64), way: f64, speed: f64) -> f64 {
        if edge_load > 0.0 && edge_gap < 0.0 { -work.abs() - 1.0 } else { self.law.excess(work, way, speed) }
    }

    fn kernel_at(&mut self, radius: f64, length: f64) -> Result<Zone, Refusal> {
        match self.kernel.take() {
            Some((place, kernel)) if place.to_bits() == radius.to_bits() && kernel.length.to_bits() == length.to_bits() => Ok(kernel),
            _ => Zone::new(radius, length),
        }
    }

    /// C of a motion (J/m²).
    pub(super) fn work(&mut self, contact: &Contact<'_>, motion: &Motion) -> Result<f64, Refusal> {
        let [work, ..] = self.closure(contact, motion, false)?;
        finite(work, motion.to)
    }

    /// The contact with its edge at another place at once, and g there: a place may be far away.
    pub(super) fn jumped<'a>(&mut self, contact: &Contact<'a>, radius: f64, imposed: &Imposed<'_>) -> Result<(Contact<'a>, f64), Refusal> {
        let here = contact.penetration();
        let mut next = match imposed {
            Imposed::Penetration(history) => contact.moved(radius, history(0.0), 0.0, Sweep::Linear)?,
            Imposed::Load { value, stiffness } => {
                // At once the state does not change with Δ: F is affine in it, with the glassy slope.
                let first = contact.moved(radius, here, 0.0, Sweep::Linear)?;
                let slope = 2.0 * contact.springs().glassy * radius + stiffness;
                let rise = (value(0.0) - first.force() - stiffness * here) / slope;
                contact.moved(radius, here + rise, 0.0, Sweep::Linear)?
            }
        };
        self.updates += next.updates - contact.updates;
        next.updates = contact.updates;
        self.evaluations += 1;
        let loads = next.line_load();
        let edge_load = value_at(&loads, radius);
        let length = self.zone_at(&next, radius, edge_load);
        let kernel = self.kernel_at(radius, length)?;
        let gaps = next.gap_factor(radius + length);
        let work = zone_work(&kernel, &loads, &gaps) / self.adhesion.work_of_adhesion;
        self.kernel = Some((radius, kernel));
        let g = self.signed(work, (edge_load, value_at(&gaps, radius)), radius - contact.radius(), f64::INFINITY);
        Ok((next, finite(g, radius)?))
    }
}

/// δ of a zone that grows, at an edge with Q(a).
pub(super) fn grown(adhesion: &Adhesion, relaxed_modulus: f64, (radius, edge_load): (f64, f64)) -> f64 {
    let growth = edge_load / (2.0 * PI * relaxed_modulus * adhesion.work_of_adhesion) * (edge_load / radius);
    (growth.max(LEAST_GROWTH) * adhesion.process_zone).min(radius / SMALLEST)
}

/// Powers of the part of a time of an imposed Δ, less Δ now: straight if it is to rounding, else through five equal parts.
fn course(dt: f64, here: f64, scale: f64, history: &dyn Fn(f64) -> f64) -> [f64; DEGREE] {
    let end = history(dt) - here;
    let straight = [end, 0.0, 0.0, 0.0, 0.0];
    if dt == 0.0 {
        return straight;
    }
    let rises: [f64; DEGREE] = std::array::from_fn(|k| if k + 1 == DEGREE { end } else { history(0.2 * (k as f64 + 1.0) * dt) - here });
    let bent = rises.iter().enumerate().any(|(k, rise)| (rise - 0.2 * (k as f64 + 1.0) * end).abs() > STRAIGHT_TO * (scale + here.abs()));
    if !bent {
        return straight;
    }
    std::array::from_fn(|power| rises.iter().zip(&THROUGH_FIFTHS).map(|(rise, row)| rise * row[power]).sum())
}

/// A point of the integration that is now.
pub(super) fn node_of(profile: &Profile, contact: &Contact<'_>, force: f64) -> Node {
    Node { time: 0.0, place: profile.coordinate(contact.radius()), penetration: contact.penetration(), force, radius: contact.radius() }
}

fn finite(value: f64, radius: f64) -> Result<f64, Refusal> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Refusal::NotConverged { what: "the edge condition", detail: format!("it is not a number at a = {radius:e}") })
    }
}
