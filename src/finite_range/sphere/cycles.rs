//! What every cycle of an oscillation turns out to be, from the record of a run.
//!
//! Steps end on the ends of cycles. Within a step Δ, F and a go along the polynomial through up to six points around it, of one smooth piece
//! between jumps; a jump itself is a straight line. The work is that of the record.

use super::problem::{ON_TIME, Problem};
use super::result::{Record, Run};
use crate::indentation::{Course, Cycle, CycleIntegrals, POINTS_BEHIND, PathPoint, Spread, Sums};

/// Points of a polynomial are at least this part of its step from each other.
const SPACING: f64 = 0.5;

/// Every whole cycle that a run goes through, and by how much those of one frequency differ. A cycle that begins or ends within a jump is left out.
#[must_use]
pub fn cycles(problem: &Problem, run: &Run) -> (Vec<Cycle<f64>>, Vec<Spread>) {
    let longest = problem.creep.times.iter().copied().fold(0.0, f64::max);
    let (mut cycles, mut spreads) = (Vec::new(), Vec::new());
    for (segment, (leg, summary)) in problem.history.iter().zip(&run.legs).enumerate() {
        let Some(oscillation) = leg.motion.oscillation() else { continue };
        let first = run.rows.partition_point(|row| row.time <= summary.begin.time).saturating_sub(1);
        let last = run.rows.partition_point(|row| row.time < summary.end.time);
        let Some(way) = run.rows.get(first..(last + 1).min(run.rows.len())) else { continue };
        let path = path(way, run);
        let Some(start) = path.first() else { continue };
        let mut integrals = CycleIntegrals::new(segment, (oscillation, leg.motion.duration()), start.time, longest, Some(start));
        let mut ends = leg.motion.ends_of_cycles(start.time).peekable();
        let (mut begun, mut before) = (true, start.time);
        for (index, pair) in way.windows(2).enumerate() {
            let ([from, to], Some(point)) = (pair, path.get(index + 1)) else { continue };
            // A jump may take no time.
            let mut sums = if to.time > from.time {
                let points = around(&path, index, |_| true);
                integrals.between(&points, seen_from(&points, [from.time, to.time]))
            } else {
                Sums::default()
            };
            sums.work = to.work - from.work;
            if let Some(extremes) = &mut sums.extremes {
                extremes[2] = radii(&path, index);
            }
            integrals.passed(point, &sums);
            let Some(end) = ends.next_if(|end| point.time >= end - ON_TIME * (end - before)) else { continue };
            let on_time = (point.time - end).abs() <= ON_TIME * (end - before);
            let cycle = integrals.finished(point.time, f64::NEG_INFINITY).0;
            if begun && on_time {
                cycles.push(cycle);
            }
            (begun, before) = (on_time, end);
        }
        spreads.extend(integrals.spread());
    }
    (cycles, spreads)
}

/// The steps of a leg, with a piece for each smooth part and for each jump.
fn path(way: &[Record], run: &Run) -> Vec<PathPoint> {
    let mut piece = 0;
    let jumps = |time: f64| {
        let at = run.jumps.partition_point(|jump| jump.time < time);
        run.jumps.get(at).is_some_and(|jump| jump.time.to_bits() == time.to_bits())
    };
    let mut before = false;
    let points = way.iter().enumerate().map(|(index, row)| {
        let lands = index > 0 && jumps(row.time);
        piece += u32::from(lands || before);
        before = lands;
        PathPoint {
            time: row.time,
            penetration: row.penetration,
            force: row.force,
            contact_radius: row.contact_radius,
            stress_intensity_factor: 0.0,
            unresolved_intensity: 0.0,
            residual: 0.0,
            piece,
            energies: None,
        }
    });
    points.collect()
}

/// The points around a step that a polynomial goes through: of its piece and of a run of points that a condition holds for, as many before it as
/// behind it, where there are. Steps shrink a thousandfold before a jump: points nearer to each other than a part of the step are left out, since a
/// polynomial through a cluster of points says nothing at a distance from it.
fn around(path: &[PathPoint], index: usize, holds: impl Fn(&PathPoint) -> bool) -> Vec<PathPoint> {
    let (Some(before), Some(after)) = (path.get(..=index), path.get(index + 1..)) else { return Vec::new() };
    let (Some(from), Some(to)) = (before.last(), after.first()) else { return Vec::new() };
    let least = SPACING * (to.time - from.time);
    let wide = |points: &mut Vec<PathPoint>, point: &PathPoint| {
        if points.len() < POINTS_BEHIND - 1 && points.last().is_none_or(|last| (last.time - point.time).abs() >= least) {
            points.push(*point);
        }
        points.len() < POINTS_BEHIND - 1
    };
    // The first point of a piece ends the one before.
    let (mut left, mut right) = (Vec::new(), Vec::new());
    let mut next = to;
    for point in before.iter().rev().take_while(|point| std::mem::replace(&mut next, point).piece == to.piece) {
        if !(holds(point) && wide(&mut left, point)) {
            break;
        }
    }
    for point in after.iter().take_while(|point| point.piece == to.piece) {
        if !(holds(point) && wide(&mut right, point)) {
            break;
        }
    }
    let half = POINTS_BEHIND / 2;
    left.truncate(half.max(POINTS_BEHIND - right.len().min(half)));
    right.truncate(POINTS_BEHIND - left.len());
    left.reverse();
    left.append(&mut right);
    left
}

/// Times relative to the last of some points.
fn seen_from(points: &[PathPoint], times: [f64; 2]) -> [f64; 2] {
    let zero = points.last().map_or(0.0, |point| point.time);
    times.map(|time| time - zero)
}

/// Smallest and largest contact radius in a step. Where the contact opens and closes the radius is a root of the time, which no polynomial follows.
fn radii(path: &[PathPoint], index: usize) -> [f64; 2] {
    let [from, to] = [index, index + 1].map(|place| path.get(place).map_or(0.0, |point| point.contact_radius));
    let mut range = [from.min(to), from.max(to)];
    if range[0] > 0.0 {
        let points = around(path, index, |point| point.contact_radius > 0.0);
        let times = [index, index + 1].map(|place| path.get(place).map_or(0.0, |point| point.time));
        if let Some(turn) = Course::through(&points, |point| point.contact_radius).turn(seen_from(&points, times)) {
            range = [range[0].min(turn), range[1].max(turn)];
        }
    }
    range
}
