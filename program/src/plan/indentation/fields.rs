//! Pressure and surface displacement at chosen times: an integration is walked again along its own path, thinned; a history without steps, or by
//! panels, is solved again up to each.

use super::IndentationPlan;
use super::rows::Values;
use crate::outcome::FieldPoint;
use crate::scene::typed::IndentationFields;
use viscotack::estimate::Estimate;
use viscotack::finite_range::sphere::SUM_OF_DURATIONS;
use viscotack::indentation::{Contact, IndentationSolution, Instant, PathPoint, Springs, Start, SurfaceFields, Sweep, surface_of};
use viscotack::refusal::Refusal;

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
        let path = &solution.integration.path;
        let end = path.last().map_or(0.0, |point| point.time);
        let problem = self.problem()?;
        let states: Vec<(PathPoint, [SurfaceFields; 2], f64)> = wanted
            .times
            .iter()
            .map(|time| {
                let time = time / self.indentation.speed_factor;
                if time > end * (1.0 + SUM_OF_DURATIONS) {
                    return Err(Refusal::OutOfRange { quantity: "fields.times", value: time, allowed: "within the history" });
                }
                let time = time.min(end);
                if let Some((point, surfaces)) = surface_of(&self.material, &problem, solution, time)? {
                    return Ok((point, surfaces, 0.0));
                }
                let springs = Springs::new(&self.material)?;
                let [fine, coarse] = [self.walked(&springs, path, time, MOVES[0])?, self.walked(&springs, path, time, MOVES[1])?];
                let nothing = PathPoint { time, energies: None, ..path.first().copied().ok_or_else(no_path)? };
                let point = PathPoint { penetration: fine.penetration(), force: fine.force(), contact_radius: fine.radius(), ..nothing };
                Ok((point, [SurfaceFields::of(&fine), SurfaceFields::of(&coarse)], SAFETY * (fine.force() - coarse.force()).abs()))
            })
            .collect::<Result<_, Refusal>>()?;
        let largest = path.iter().fold(0.0, |most: f64, point| most.max(point.contact_radius));
        let reach = wanted.to.unwrap_or_else(|| {
            let asked = states.iter().fold(0.0, |most: f64, (point, ..)| most.max(point.contact_radius));
            2.0 * if asked > 0.0 { asked } else { largest }
        });
        states.iter().map(|(point, fields, off)| self.field_row(solution, point, fields, *off, (reach, wanted.points))).collect()
    }

    /// The contact at a time, in about `moves` straight pieces of the path, which is a polynomial between its points; jumps stay jumps.
    fn walked<'s>(&self, springs: &'s Springs, path: &[PathPoint], time: f64, moves: usize) -> Result<Contact<'s>, Refusal> {
        let profile = self.profile.clone();
        let problem = self.problem()?;
        let sweep = if problem.adhesion.is_some() { Sweep::Linear } else { Sweep::Profile };
        let first = path.first().ok_or_else(no_path)?;
        let mut contact = match problem.start {
            Start::Relaxed => Contact::relaxed(springs, profile, first.contact_radius, first.penetration)?,
            Start::Untouched => Contact::untouched(springs, profile, first.contact_radius, first.penetration)?,
        };
        let steps = path.partition_point(|point| point.time <= time).max(1);
        // Fewer moves than steps leave steps out, of one piece; more moves cut them.
        let (stride, cuts) = (steps.div_ceil(moves).max(1), (moves / steps).max(1));
        let mut index = 0;
        while let Some(here) = path.get(index).filter(|here| here.time < time || path.get(index + 1).is_some_and(|next| next.time <= time))
        {
            let joined = |place: usize| {
                path.get(place).is_some_and(|point| point.piece == here.piece && point.time > here.time && point.time <= time)
            };
            let next = index + (1..=stride).take_while(|&ahead| joined(index + ahead)).last().unwrap_or(1);
            let Some(there) = path.get(next) else { break };
            let end = there.time.min(time);
            if there.time <= here.time {
                contact = contact.moved(there.contact_radius, there.penetration, 0.0, sweep)?;
            } else {
                for cut in 1..=cuts {
                    let now = if cut == cuts { end } else { here.time + (end - here.time) * cut as f64 / cuts as f64 };
                    let before = here.time + (end - here.time) * (cut - 1) as f64 / cuts as f64;
                    let [radius, depth] =
                        if now >= there.time { [there.contact_radius, there.penetration] } else { between(path, index, now) };
                    contact = contact.moved(radius.max(0.0), depth, now - before, sweep)?;
                }
            }
            index = next;
        }
        Ok(contact)
    }

    fn field_row(
        &self,
        solution: &IndentationSolution,
        point: &PathPoint,
        fields: &[SurfaceFields; 2],
        force_off: f64,
        (reach, points): (f64, u32),
    ) -> Result<FieldRow, Refusal> {
        let time = point.time;
        // The kept instants before and after bound what the solution itself leaves open.
        let after = solution.instants.partition_point(|instant| instant.time < time).min(solution.instants.len().saturating_sub(1));
        let neighbours = || [after.saturating_sub(1), after].into_iter().filter_map(|place| solution.instants.get(place));
        let widest = |of: fn(&Instant) -> Estimate| neighbours().fold(0.0, |most: f64, instant| most.max(of(instant).error));
        let force_error = widest(|instant| instant.force) + force_off;
        let (a, force) = (point.contact_radius, point.force);
        let values = self.basic(
            Estimate::exact(time),
            Estimate::new(point.penetration, widest(|instant| instant.penetration)),
            Estimate::new(force, force_error),
            Estimate::new(a, widest(|instant| instant.contact_radius)),
        );
        let scale = solution.instants.iter().fold(force.abs(), |most, instant| most.max(instant.force.value.abs()));
        // A relative error of the load is one of the pressure.
        let load_error = if scale > 0.0 { force_error / scale } else { 0.0 };
        let mut found: Vec<(f64, [f64; 2], [f64; 2])> = Vec::with_capacity(points as usize);
        for place in places(a, reach, points) {
            let [field, other] = fields;
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
                let pressure =
                    if place > a { Estimate::exact(0.0) } else { Estimate::new(pressure, error(pressure, by, roundings[0])).scaled(unit) };
                let displacement = Estimate::new(displacement, error(displacement, off, roundings[1]));
                FieldPoint { place, values: vec![Estimate::exact(time), pressure, displacement] }
            })
            .collect();
        Ok(FieldRow { values, points })
    }
}

fn no_path() -> Refusal {
    Refusal::NotConverged { what: "the integration", detail: "it has no path".into() }
}

/// a and Δ within the step that begins at a place of the path: the polynomial in time through the nearest points of the same piece.
fn between(path: &[PathPoint], index: usize, time: f64) -> [f64; 2] {
    let Some((here, next)) = path.get(index).zip(path.get(index + 1)) else { return [0.0; 2] };
    let straight = || {
        let part = (time - here.time) / (next.time - here.time);
        let on = |from: f64, to: f64| from + (to - from) * part;
        [on(here.contact_radius, next.contact_radius), on(here.penetration, next.penetration)]
    };
    // The first point of the next piece ends this one.
    let own = |place: usize| path.get(place).filter(|point| point.piece == here.piece || (place == index + 1));
    let mut near: Vec<&PathPoint> = (index.saturating_sub(2)..=index + 3).filter_map(own).collect();
    near.dedup_by(|second, first| second.time <= first.time);
    if near.len() < 3 || near.iter().any(|point| point.contact_radius <= 0.0) {
        return straight();
    }
    let weight = |k: usize, one: &PathPoint| -> f64 {
        near.iter().enumerate().filter(|(l, _)| *l != k).map(|(_, other)| (time - other.time) / (one.time - other.time)).product()
    };
    let sum = |of: fn(&PathPoint) -> f64| near.iter().enumerate().map(|(k, one)| weight(k, one) * of(one)).sum::<f64>();
    let found = [sum(|point| point.contact_radius), sum(|point| point.penetration)];
    // A polynomial that leaves the step's own range by more than its width is no guide.
    let [low, high] = [here.contact_radius.min(next.contact_radius), here.contact_radius.max(next.contact_radius)];
    let width = (high - low).max(1e-12 * high);
    if found[0] >= low - width && found[0] <= high + width { found } else { straight() }
}

/// Places from the axis outwards: half of them inside and half outside of the edge, dense at it.
pub(super) fn places(a: f64, reach: f64, points: u32) -> Vec<f64> {
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
