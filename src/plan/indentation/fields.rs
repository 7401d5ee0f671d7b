//! Pressure and surface displacement at chosen times: the march is walked again along its own path, thinned.

use super::IndentationPlan;
use super::rows::Values;
use crate::estimate::Estimate;
use crate::indentation::{Contact, IndentationSolution, Instant, PathPoint, Springs, Start, SurfaceFields, Sweep};
use crate::outcome::FieldPoint;
use crate::refusal::Refusal;
use crate::scene::typed::IndentationFields;

/// Moves in which a path is walked again, in two ways: their difference is the error of the walk.
const MOVES: [usize; 2] = [240, 120];
/// Bound over that difference: the thinned path is an edge that moves in longer straight pieces, an error of second order.
const SAFETY: f64 = 1.5;
/// Rounding of a field over its largest value.
const ROUNDING: f64 = 1e-11;
/// How far a place keeps from the edge, over the contact radius: there the pressure is infinite.
const FROM_EDGE: f64 = 1e-6;

/// One instant with its fields.
pub(super) struct FieldRow {
    pub(super) values: Values,
    pub(super) points: Vec<FieldPoint>,
}

impl IndentationPlan {
    pub(super) fn fields_of(&self, solution: &IndentationSolution, wanted: &IndentationFields) -> Result<Vec<FieldRow>, Refusal> {
        let springs = Springs::new(&self.material)?;
        let path = &solution.fine.path;
        let end = path.last().map_or(0.0, |point| point.time);
        let states: Vec<(f64, [Contact<'_>; 2])> = wanted
            .times
            .iter()
            .map(|time| {
                let time = time / self.indentation.speed_factor;
                if time > end * (1.0 + 1e-9) {
                    return Err(Refusal::OutOfRange { quantity: "fields.times", value: time, allowed: "within the history" });
                }
                let time = time.min(end);
                Ok((time, [self.walked(&springs, path, time, MOVES[0])?, self.walked(&springs, path, time, MOVES[1])?]))
            })
            .collect::<Result<_, Refusal>>()?;
        let largest = path.iter().fold(0.0, |most: f64, point| most.max(point.contact_radius));
        let reach = wanted.to.unwrap_or_else(|| {
            let asked = states.iter().fold(0.0, |most: f64, (_, [contact, _])| most.max(contact.radius()));
            2.0 * if asked > 0.0 { asked } else { largest }
        });
        states.iter().map(|(time, pair)| self.field_row(solution, *time, pair, reach, wanted.points)).collect()
    }

    /// The contact at a time, along `moves` straight pieces of the path; jumps and corners are walked as they were.
    fn walked<'s>(&self, springs: &'s Springs, path: &[PathPoint], time: f64, moves: usize) -> Result<Contact<'s>, Refusal> {
        let profile = self.profile();
        let problem = self.problem()?;
        let sweep = if problem.adhesion.is_some() { Sweep::Linear } else { Sweep::Profile };
        let Some(first) = path.first() else {
            return Err(Refusal::NotConverged { what: "the march", detail: "it has no path".into() });
        };
        let mut contact = match problem.start {
            Start::Relaxed => Contact::relaxed(springs, profile, first.contact_radius, first.penetration)?,
            Start::Untouched => Contact::untouched(springs, profile, first.contact_radius, first.penetration)?,
        };
        let before = path.partition_point(|point| point.time <= time).max(1);
        let stride = before.div_ceil(moves).max(1);
        let (mut here, mut index) = (first, 0);
        while index + 1 < before {
            let sudden = |place: usize| match path.get(place..place + 2) {
                Some([one, other]) => other.time <= one.time,
                _ => false,
            };
            let furthest = (index + stride).min(before - 1);
            // A jump stays a jump: the walk stops before and after it.
            let next = (index + 1..furthest).find(|&place| sudden(place) || sudden(place - 1)).unwrap_or(furthest);
            let Some(point) = path.get(next) else { break };
            contact = contact.moved(point.contact_radius, point.penetration, point.time - here.time, sweep)?;
            (here, index) = (point, next);
        }
        // Within a step the edge and the penetration move straight.
        if let Some(after) = path.get(before)
            && time > here.time
        {
            let part = (time - here.time) / (after.time - here.time);
            let between = |from: f64, to: f64| from + (to - from) * part;
            contact = contact.moved(
                between(here.contact_radius, after.contact_radius),
                between(here.penetration, after.penetration),
                time - here.time,
                sweep,
            )?;
        }
        Ok(contact)
    }

    fn field_row(
        &self,
        solution: &IndentationSolution,
        time: f64,
        [fine, coarse]: &[Contact<'_>; 2],
        reach: f64,
        points: u32,
    ) -> Result<FieldRow, Refusal> {
        // The kept instants before and after bound what the march itself leaves open.
        let after = solution.instants.partition_point(|instant| instant.time < time).min(solution.instants.len().saturating_sub(1));
        let neighbours = || [after.saturating_sub(1), after].into_iter().filter_map(|place| solution.instants.get(place));
        let widest = |of: fn(&Instant) -> Estimate| neighbours().fold(0.0, |most: f64, instant| most.max(of(instant).error));
        let force_error = widest(|instant| instant.force) + SAFETY * (fine.force() - coarse.force()).abs();
        let (a, force) = (fine.radius(), fine.force());
        let values = self.basic(
            Estimate::exact(time),
            Estimate::new(fine.penetration(), widest(|instant| instant.penetration)),
            Estimate::new(force, force_error),
            Estimate::new(a, widest(|instant| instant.contact_radius)),
        );
        let scale = solution.instants.iter().fold(force.abs(), |most, instant| most.max(instant.force.value.abs()));
        // A relative error of the load is one of the pressure.
        let load_error = if scale > 0.0 { force_error / scale } else { 0.0 };
        let fields = [SurfaceFields::of(fine), SurfaceFields::of(coarse)];
        let mut found: Vec<(f64, [f64; 2], [f64; 2])> = Vec::with_capacity(points as usize);
        for place in places(a, reach, points) {
            let [field, other] = &fields;
            let (pressure, displacement) = (field.pressure(place)?, field.displacement(place)?);
            found.push((place, [pressure, displacement], [other.pressure(place)? - pressure, other.displacement(place)? - displacement]));
        }
        let largest = |of: fn(&[f64; 2]) -> f64| found.iter().fold(0.0, |most: f64, (_, values, _)| most.max(of(values).abs()));
        let roundings = [ROUNDING * largest(|values| values[0]), ROUNDING * largest(|values| values[1])];
        let unit = 1.0 / self.scale.force;
        let points = found
            .iter()
            .map(|&(place, [pressure, displacement], [by, off])| {
                let error = |value: f64, difference: f64, rounding: f64| SAFETY * difference.abs() + load_error * value.abs() + rounding;
                let pressure = if place > a { Estimate::exact(0.0) } else { Estimate::new(pressure, error(pressure, by, roundings[0])).scaled(unit) };
                let displacement = Estimate::new(displacement, error(displacement, off, roundings[1]));
                FieldPoint { place, values: vec![Estimate::exact(time), pressure, displacement] }
            })
            .collect();
        Ok(FieldRow { values, points })
    }
}

/// Places from the axis outwards: half of them inside and half outside of the edge, dense at it.
fn places(a: f64, reach: f64, points: u32) -> Vec<f64> {
    let even = |from: f64, to: f64, count: u32, dense_end: bool, dense_start: bool| -> Vec<f64> {
        (0..count)
            .map(|index| {
                let x = f64::from(index) / f64::from(count.saturating_sub(1).max(1));
                let graded = match (dense_start, dense_end) {
                    (false, true) => 1.0 - (1.0 - x) * (1.0 - x),
                    (true, false) => x * x,
                    _ => x,
                };
                from + (to - from) * graded
            })
            .collect()
    };
    if a <= 0.0 || a >= reach {
        let end = if a <= 0.0 { reach } else { reach.min(a * (1.0 - FROM_EDGE)) };
        return even(0.0, end, points, false, false);
    }
    let inside = points / 2;
    let mut all = even(0.0, a * (1.0 - FROM_EDGE), inside, true, false);
    all.extend(even(a * (1.0 + FROM_EDGE), reach, points - inside, false, true));
    all
}
