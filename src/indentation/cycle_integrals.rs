//! What is added up over each cycle of an oscillation, from the points of the integration alone.
//!
//! Within a step Δ(t), F(t) and a(t) go along the polynomial through the last six points since a corner of the path, which is of the order of the
//! integration itself; near a corner points are close and fewer. Eight Gauss nodes a step integrate products of two of them, and sin and cos of the
//! phase over 0.4 rad, to rounding.

use super::adhesiveless::Sums as Added;
use super::cycle::Cycle;
use super::oscillation::Oscillation;
use super::panel::RULE;
use super::solution::PathPoint;
use super::spread::Spread;
use crate::continuation::bracket::halved;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Points behind a polynomial.
pub(crate) const POINTS_BEHIND: usize = 6;
/// Cycles in a row without drift that are stationary.
const IN_A_ROW: u32 = 2;

/// Adds up one cycle after the other.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct CycleIntegrals {
    segment: usize,
    oscillation: Oscillation,
    duration: f64,
    origin: f64,
    /// Longest retardation time.
    longest: f64,
    /// The newest last, of one piece of the path between corners.
    points: Vec<PathPoint>,
    number: u64,
    sums: Sums,
    last: Option<Cycle<f64>>,
    still: u32,
    spread: Option<Spread>,
}

/// Of the cycle under way.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Sums {
    start: f64,
    /// Δ and F at its start.
    first: [f64; 2],
    work: f64,
    /// ∫x dφ, ∫x sin φ dφ, ∫x cos φ dφ of Δ and of F.
    moments: [[f64; 3]; 2],
    /// Smallest and largest Δ, F and a.
    extremes: [[f64; 2]; 3],
}

impl Sums {
    const fn new(point: &PathPoint) -> Self {
        let [depth, force, radius] = [point.penetration, point.force, point.contact_radius];
        Self {
            start: point.time,
            first: [depth, force],
            work: 0.0,
            moments: [[0.0; 3]; 2],
            extremes: [[depth, depth], [force, force], [radius, radius]],
        }
    }

    fn add(&mut self, sums: &Added) {
        self.work += sums.work;
        for (moment, part) in self.moments.iter_mut().flatten().zip(sums.moments.iter().flatten()) {
            *moment += part;
        }
        for (quantity, range) in sums.extremes.iter().flatten().enumerate() {
            range.iter().for_each(|value| self.extend(quantity, *value));
        }
    }

    fn extend(&mut self, quantity: usize, value: f64) {
        if let Some([least, most]) = self.extremes.get_mut(quantity) {
            *least = least.min(value);
            *most = most.max(value);
        }
    }
}

/// A polynomial by Newton's divided differences, in times relative to the last point.
pub(crate) struct Course {
    times: Vec<f64>,
    divided: Vec<f64>,
}

impl Course {
    pub(crate) fn through(points: &[PathPoint], of: fn(&PathPoint) -> f64) -> Self {
        let zero = points.last().map_or(0.0, |point| point.time);
        let times: Vec<f64> = points.iter().rev().map(|point| point.time - zero).collect();
        let mut divided: Vec<f64> = points.iter().rev().map(of).collect();
        for order in 1..times.len() {
            for k in (order..times.len()).rev() {
                divided[k] = (divided[k] - divided[k - 1]) / (times[k] - times[k - order]);
            }
        }
        Self { times, divided }
    }

    /// Value and slope.
    pub(super) fn at(&self, time: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for (node, factor) in self.times.iter().zip(&self.divided).rev() {
            slope = slope * (time - node) + value;
            value = value * (time - node) + factor;
        }
        (value, slope)
    }

    /// Where it turns between two times: its value there.
    pub(crate) fn turn(&self, bracket: [f64; 2]) -> Option<f64> {
        let [begin, end] = bracket.map(|time| self.at(time).1);
        (begin * end < 0.0).then(|| self.at(halved(bracket, |time| begin * self.at(time).1 > 0.0)[0]).0)
    }
}

impl CycleIntegrals {
    pub(crate) fn new(
        segment: usize,
        (oscillation, duration): (Oscillation, f64),
        origin: f64,
        longest: f64,
        now: Option<&PathPoint>,
    ) -> Self {
        let nothing = PathPoint {
            time: origin,
            penetration: 0.0,
            force: 0.0,
            contact_radius: 0.0,
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual: 0.0,
            piece: 0,
            energies: None,
        };
        let now = now.unwrap_or(&nothing);
        let sums = Sums::new(now);
        Self { segment, oscillation, duration, origin, longest, points: vec![*now], number: 0, sums, last: None, still: 0, spread: None }
    }

    /// A step has been taken to a point.
    pub(super) fn step(&mut self, point: &PathPoint) {
        let Some(last) = self.points.last().copied() else { return };
        if point.time <= last.time {
            // At once: between the two forces.
            self.sums.work += 0.5 * (last.force + point.force) * (point.penetration - last.penetration);
            self.points.clear();
            self.points.push(*point);
        } else {
            if point.piece != last.piece {
                // The first point of a piece ends the one before.
                self.points.clear();
                self.points.push(last);
            }
            self.points.push(*point);
            let spare = self.points.len().saturating_sub(POINTS_BEHIND);
            self.points.drain(..spare);
            self.add(last.time - point.time);
        }
        for (quantity, value) in [point.penetration, point.force, point.contact_radius].into_iter().enumerate() {
            self.sums.extend(quantity, value);
        }
    }

    /// Adds the last step, which began at a (negative) time before the last point.
    fn add(&mut self, begin: f64) {
        let sums = self.between(&self.points, [begin, 0.0]);
        self.sums.add(&sums);
    }

    /// Sums between two times, relative to the last of some points, along the polynomials through them.
    pub(crate) fn between(&self, points: &[PathPoint], [begin, end]: [f64; 2]) -> Added {
        let now = points.last().map_or(0.0, |point| point.time);
        let of: [fn(&PathPoint) -> f64; 3] = [|point| point.penetration, |point| point.force, |point| point.contact_radius];
        let courses = of.map(|of| Course::through(points, of));
        let mut sums = Added::default();
        for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
            let (time, width) = (begin + (end - begin) * x, (end - begin) * weight);
            let ((depth, depth_rate), (force, _)) = (courses[0].at(time), courses[1].at(time));
            sums.work += width * force * depth_rate;
            let weights = self.weights(now + time);
            for (moments, value) in sums.moments.iter_mut().zip([depth, force]) {
                moments.iter_mut().zip(weights).for_each(|(moment, weight)| *moment += width * weight * value);
            }
        }
        sums.extremes = Some(courses.map(|course| {
            let last = course.at(end).0;
            let turn = course.turn([begin, end]).unwrap_or(last);
            [last.min(turn), last.max(turn)]
        }));
        sums
    }

    /// The weights of a value in its moments at a time: φ̇, φ̇ sin φ and φ̇ cos φ.
    pub(super) fn weights(&self, time: f64) -> [f64; 3] {
        let since = (time - self.origin).clamp(0.0, self.duration);
        let (sin, cos) = self.oscillation.angle(since, self.duration).sin_cos();
        let pace = TAU * self.oscillation.frequency_at(since, self.duration);
        [pace, pace * sin, pace * cos]
    }

    /// A point has been reached, and all up to it has been added up elsewhere.
    pub(crate) fn passed(&mut self, point: &PathPoint, sums: &Added) {
        self.points.clear();
        self.points.push(*point);
        self.sums.add(sums);
        for (quantity, value) in [point.penetration, point.force, point.contact_radius].into_iter().enumerate() {
            self.sums.extend(quantity, value);
        }
    }

    /// The last cycle once more, for one that is the same.
    pub(super) fn again(&mut self) -> Option<Cycle<f64>> {
        let last = self.last?;
        self.number += 1;
        let end = self.origin + self.oscillation.time_of(self.number as f64, self.duration)?;
        let cycle = Cycle { number: self.number, start: last.end, end, ..last };
        self.last = Some(cycle);
        self.sums.start = end;
        Spread::add(&mut self.spread, &cycle, self.oscillation.cycles_at(self.duration, self.duration));
        Some(cycle)
    }

    /// The cycle that ends now, and whether cycles have become stationary, to a tolerance.
    pub(crate) fn finished(&mut self, end: f64, tolerance: f64) -> (Cycle<f64>, bool) {
        let now = self.points.last().copied();
        let at_end = now.map_or(self.sums.first, |point| [point.penetration, point.force]);
        let sums = self.sums;
        // The straight line from end to end, from a phase φ₀ on, has ∫(φ − φ₀) sin φ dφ = −2π cos φ₀ and ∫(φ − φ₀) cos φ dφ = 2π sin φ₀.
        let (sin, cos) = self.oscillation.phase.sin_cos();
        let amplitude = |quantity: usize| {
            let moments = sums.moments.get(quantity).copied().unwrap_or_default();
            let rise = at_end.get(quantity).copied().unwrap_or(0.0) - sums.first.get(quantity).copied().unwrap_or(0.0);
            ((moments[1] + cos * rise) / PI, (moments[2] - sin * rise) / PI)
        };
        let ((depth, depth_behind), (force, force_behind)) = (amplitude(0), amplitude(1));
        let square = depth * depth + depth_behind * depth_behind;
        // What is no number stays none.
        let (storage, loss) = if square <= 0.0 {
            (0.0, 0.0)
        } else {
            ((force * depth + force_behind * depth_behind) / square, (force_behind * depth - force * depth_behind) / square)
        };
        self.number += 1;
        let mut cycle = Cycle {
            segment: self.segment,
            number: self.number,
            start: sums.start,
            end,
            work: sums.work,
            storage_stiffness: storage,
            loss_stiffness: loss,
            phase: loss.atan2(storage),
            penetration: sums.extremes[0],
            force: sums.extremes[1],
            contact_radius: sums.extremes[2],
            drift: f64::INFINITY,
            drift_error: 0.0,
        };
        if let Some(before) = &self.last {
            cycle.drift = change(before, &cycle) * (self.longest / (cycle.end - cycle.start)).max(1.0);
        }
        self.still = if cycle.drift <= tolerance { self.still + 1 } else { 0 };
        self.last = Some(cycle);
        Spread::add(&mut self.spread, &cycle, self.oscillation.cycles_at(self.duration, self.duration));
        if let Some(point) = now {
            self.sums = Sums::new(&point);
        }
        (cycle, self.still >= IN_A_ROW)
    }
}

impl CycleIntegrals {
    /// By how much the cycles differ; none where the frequency itself goes up or down.
    pub(crate) fn spread(&self) -> Option<Spread> {
        self.spread.filter(|_| self.oscillation.frequency.to_bits() == self.oscillation.end_frequency.to_bits())
    }
}

/// Largest change of work and extremes from one cycle to the next, over their scales.
fn change(before: &Cycle<f64>, after: &Cycle<f64>) -> f64 {
    let swing = |range: [f64; 2]| range[1] - range[0];
    let largest = |range: [f64; 2]| range[0].abs().max(range[1].abs());
    let work = after.work.abs().max(0.25 * swing(after.force) * swing(after.penetration));
    let mut most: f64 = 0.0;
    let mut add = |one: f64, other: f64, scale: f64| {
        if one.to_bits() != other.to_bits() {
            most = most.max((one - other).abs() / scale);
        }
    };
    add(before.work, after.work, work);
    for (one, other, scale) in [
        (before.penetration, after.penetration, swing(after.penetration)),
        (before.force, after.force, largest(after.force)),
        (before.contact_radius, after.contact_radius, largest(after.contact_radius)),
    ] {
        add(one[0], other[0], scale);
        add(one[1], other[1], scale);
    }
    most
}
