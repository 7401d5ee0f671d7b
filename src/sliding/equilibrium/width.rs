//! Every steady contact of one half-width, speed and adhesion.
//!
//! So no branch can hide: what is not on a curve that was followed belongs to another one.

use super::existence::WhyNot;
use super::forms::{Conditions, Line, direction, of_line};
use super::point::Point;
use super::table::Table;
use crate::continuation::two_unknowns::{TwoResiduals, largest};
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactMemory, ContactState, Indenter, Prescribed, ProcessZone, WaveContact};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::cell::Cell;
use std::f64::consts::PI;
use std::sync::Arc;

/// Largest residual of a root.
const ROOT: f64 = 1e-4;
/// Eccentricities nearer than this are those of one contact (across a narrow gap rounding moves them).
const SAME: f64 = 1e-5;
/// The same of a point that is rough.
const ROUGH: f64 = 1e-3;
/// Conditions this far on both sides of a place tell how they follow it.
const BESIDE: f64 = 1e-4;

/// A steady contact of a half-width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactAt {
    /// a.
    pub half_width: f64,
    /// e.
    pub eccentricity: f64,
    /// p̄.
    pub mean_pressure: f64,
    /// Δ.
    pub penetration: f64,
}

/// The contacts of one material, speed and adhesion.
#[derive(Debug)]
pub(in crate::sliding) struct ContactsOfWidth {
    pub(super) balance: EdgeBalance,
    pub(super) memory: Arc<ContactMemory>,
    pub(super) indenter: Indenter,
    pub(super) adhesion: Option<(WaveAdhesion, Arc<(ProcessZone, ProcessZone)>)>,
    /// The conditions of a range of half-widths, if there are many to be looked at.
    table: Option<Table>,
    /// Half-widths whose conditions were formed: each as much as two evaluations of both conditions.
    pub(super) widths: Cell<u64>,
}

impl ContactsOfWidth {
    /// Of conditions, whatever their control.
    pub(in crate::sliding) fn new(balance: EdgeBalance) -> Self {
        let (memory, indenter) = (Arc::clone(balance.memory()), balance.indenter());
        let adhesion = balance.with_zones();
        Self { balance, memory, indenter, adhesion, table: None, widths: Cell::new(0) }
    }

    pub(super) const fn indenter(&self) -> Indenter {
        self.indenter
    }

    /// Half-widths whose conditions were formed since the last call.
    pub(super) fn take_widths(&self) -> u64 {
        self.widths.take()
    }

    /// As how many evaluations of both conditions they count, with those of checks.
    pub(in crate::sliding) fn evaluations(&self) -> u64 {
        2 * self.widths.take() + self.balance.take_evaluations()
    }

    /// Tabulates the conditions between two places.
    pub(super) fn tabulate(&mut self, range: [f64; 2]) {
        self.table = Some(Table::new(self.indenter, range, |edges| self.conditions(edges).ok()));
    }

    /// The conditions at a place.
    fn conditions_at(&self, place: f64) -> Option<Conditions> {
        let tabulated = self.table.as_ref().and_then(|table| table.at(place));
        tabulated.or_else(|| self.conditions(ContactEdges::at_place(self.indenter, place, 0.0)).ok())
    }

    /// The contacts of a half-width that can exist, in the order of their eccentricities.
    ///
    /// # Errors
    /// Those of the contacts; [`Refusal::NotConverged`] where a work is not a number.
    pub(in crate::sliding) fn at(&self, half_width: f64) -> Result<Vec<ContactAt>, Refusal> {
        let edges = ContactEdges::new(self.indenter, WaveContact { half_width, eccentricity: 0.0 });
        let conditions = self.conditions(edges)?;
        let mut found = Vec::new();
        for point in self.points_of(edges.place(), &conditions) {
            found.extend(self.existing(&point)?.map(|contact| ContactAt { half_width, ..contact }));
        }
        Ok(found)
    }

    /// The contact at a point, at the conditions themselves, if it can exist: both edges pulled and no faces that meet.
    fn existing(&self, point: &Point) -> Result<Option<ContactAt>, Refusal> {
        let edges = ContactEdges::at_place(self.indenter, point.place, point.eccentricity);
        let mut states = self.balance.evaluate_edges(edges, Prescribed::MeanPressure(point.mean_pressure))?;
        let (mut eccentricity, mut mean_pressure) = (point.eccentricity, point.mean_pressure);
        if largest(states.residual()) >= ROOT {
            // Of weak adhesion the point is rough.
            let balance = self.balance.under(SlidingControl::HalfWidth(edges.half_width));
            let near = balance.solve([mean_pressure, eccentricity], None, ROOT);
            self.widths.set(self.widths.get() + balance.take_evaluations().div_ceil(2));
            let Some(near) = near.ok().filter(|near| distance(self.indenter, near.unknowns[1], point.eccentricity) < ROUGH) else {
                return Ok(None);
            };
            [mean_pressure, eccentricity] = near.unknowns;
            states = near.solution;
        }
        let contact = ContactAt { half_width: edges.half_width, eccentricity, mean_pressure, penetration: states.state.penetration() };
        Ok(self.balance.admissibility(&states)?.holds().then_some(contact))
    }

    /// The contact of a control near a half-width and an eccentricity, if one can exist.
    pub(super) fn solved(&self, control: SlidingControl, start: [f64; 2]) -> Option<ContactAt> {
        let balance = self.balance.under(control);
        let found = balance.solve_admissible(start, None, ROOT).ok();
        self.widths.set(self.widths.get() + balance.take_evaluations().div_ceil(2));
        let (solution, _) = found?;
        let state = &solution.solution.state;
        Some(ContactAt {
            half_width: solution.unknowns[0],
            eccentricity: solution.unknowns[1],
            mean_pressure: state.mean_pressure(),
            penetration: state.penetration(),
        })
    }

    /// Whether the contact at a point can exist.
    pub(super) fn can_exist(&self, point: &Point) -> bool {
        matches!(self.existing(point), Ok(Some(_)))
    }

    /// The contacts at a place whose edges are pulled, in the order of their eccentricities; whether faces meet is not looked at.
    pub(super) fn points(&self, place: f64) -> Vec<Point> {
        self.conditions_at(place).map(|conditions| self.points_of(place, &conditions)).unwrap_or_default()
    }

    fn points_of(&self, place: f64, conditions: &Conditions) -> Vec<Point> {
        let mut roots = conditions.roots();
        roots.retain(|&(eccentricity, mean_pressure)| {
            let direction = direction(self.indenter, eccentricity);
            conditions.works.is_none() || conditions.amplitudes.iter().all(|line| of_line(line, direction, mean_pressure) < 0.0)
        });
        roots.sort_by(|first, second| first.0.total_cmp(&second.0));
        roots.dedup_by(|first, second| (first.0 - second.0).abs() < SAME * (1.0 + second.0.abs()));
        // π is −π.
        if let ([first, .., last], Indenter::Wave) = (&roots[..], self.indenter)
            && 2.0 * PI - (last.0 - first.0) < SAME
        {
            roots.pop();
        }
        if roots.is_empty() {
            return Vec::new();
        }
        let beside =
            self.table.as_ref().map(|table| [-BESIDE, BESIDE].map(|step| table.at(place + step).map(|conditions| (step, conditions))));
        roots.into_iter().map(|root| self.point(place, conditions, beside.as_ref(), root)).collect()
    }

    /// What forbids the contact near an eccentricity; none if the conditions have no root there, or nothing does.
    pub(super) fn why_not(&self, place: f64, eccentricity: f64) -> Option<WhyNot> {
        let conditions = self.conditions_at(place)?;
        let far = |root: &(f64, f64)| distance(self.indenter, root.0, eccentricity);
        let root = conditions.roots().into_iter().min_by(|first, second| far(first).total_cmp(&far(second)))?;
        let direction = direction(self.indenter, root.0);
        // Trailing and leading edge in turn.
        let pressed = conditions.amplitudes.iter().position(|line| of_line(line, direction, root.1) >= 0.0);
        match pressed.filter(|_| conditions.works.is_some()) {
            Some(index) if index % 2 == 0 => Some(WhyNot::TrailingPressed),
            Some(_) => Some(WhyNot::LeadingPressed),
            None => self.why_not_at(&self.point(place, &conditions, None, root)),
        }
    }

    /// The same of a point, by the conditions themselves: where an amplitude passes zero the table may not tell its sign.
    fn why_not_at(&self, point: &Point) -> Option<WhyNot> {
        let edges = ContactEdges::at_place(self.indenter, point.place, point.eccentricity);
        let states = self.balance.evaluate_edges(edges, Prescribed::MeanPressure(point.mean_pressure)).ok()?;
        let moved = states.moved.iter().flat_map(|(trailing, leading)| [trailing, leading]);
        let amplitudes: Vec<(f64, f64)> = std::iter::once(&states.state).chain(moved).map(ContactState::edge_amplitudes).collect();
        if amplitudes.iter().any(|(trailing, _)| *trailing >= 0.0) {
            Some(WhyNot::TrailingPressed)
        } else if amplitudes.iter().any(|(_, leading)| *leading >= 0.0) {
            Some(WhyNot::LeadingPressed)
        } else {
            (!self.can_exist(point)).then_some(WhyNot::FacesMeet)
        }
    }

    /// A root with its slopes; `beside`: the conditions a step before and after.
    fn point(
        &self,
        place: f64,
        conditions: &Conditions,
        beside: Option<&[Option<(f64, Conditions)>; 2]>,
        (eccentricity, mean_pressure): (f64, f64),
    ) -> Point {
        let at = direction(self.indenter, eccentricity);
        // Derivatives of a line by e and p̄.
        let by_line = |[c, s, p]: &Line| [if self.indenter == Indenter::Wave { s * at.0 - c * at.1 } else { *s }, *p];
        // Works, or amplitudes with the sign of works, and Δ.
        let values = |conditions: &Conditions| -> [f64; 3] {
            let works = match &conditions.works {
                Some(works) => [0, 1].map(|edge| works.work(edge, at, mean_pressure)),
                None => [0, 1].map(|edge| conditions.amplitudes.get(edge).map_or(f64::NAN, |line| -of_line(line, at, mean_pressure))),
            };
            [works[0], works[1], conditions.depth.as_ref().map_or(0.0, |line| of_line(line, at, mean_pressure))]
        };
        let by = |edge: usize| match &conditions.works {
            Some(works) => works.slopes(edge, self.indenter, eccentricity, mean_pressure),
            None => conditions.amplitudes.get(edge).map_or([f64::NAN; 2], |line| by_line(line).map(|slope| -slope)),
        };
        let [trailing, leading] = [by(0), by(1)];
        let here = values(conditions);
        let side = |index: usize| beside.and_then(|both| both[index].as_ref()).map_or((0.0, here), |(step, other)| (*step, values(other)));
        let ((before, first), (after, second)) = (side(0), side(1));
        let [by_trailing, by_leading, by_depth]: [f64; 3] = std::array::from_fn(|index| (second[index] - first[index]) / (after - before));
        // Of a parabola the depth is relative to a datum, and nothing is held by it.
        let [depth_by_shift, depth_by_load] = conditions.depth.as_ref().map_or([0.0, 1.0], by_line);
        Point {
            place,
            half_width: ContactEdges::at_place(self.indenter, place, 0.0).half_width,
            eccentricity,
            mean_pressure,
            depth: here[2],
            by_shift: [trailing[0], leading[0]],
            by_load: [trailing[1], leading[1]],
            by_place: [by_trailing, by_leading],
            depth_slopes: [by_depth, depth_by_shift, depth_by_load],
        }
    }

    /// The contact of a half-width that continues one of another.
    pub(super) fn nearest(&self, place: f64, eccentricity: f64) -> Option<Point> {
        let far = |point: &Point| distance(self.indenter, point.eccentricity, eccentricity);
        self.points(place).into_iter().min_by(|first, second| far(first).total_cmp(&far(second)))
    }
}

/// From one eccentricity to another; a wave repeats.
pub(super) fn change(indenter: Indenter, from: f64, to: f64) -> f64 {
    let far = to - from;
    match indenter {
        Indenter::Wave => far - 2.0 * PI * (far / (2.0 * PI)).round(),
        Indenter::Parabola => far,
    }
}

/// The distance of two eccentricities.
pub(super) fn distance(indenter: Indenter, first: f64, second: f64) -> f64 {
    change(indenter, first, second).abs()
}
