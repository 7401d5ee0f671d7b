//! A record as a polyline of the fewest corners that stays within a tolerance of it.
//!
//! The record is a polyline itself. Moved up and down by the tolerance it bounds a tunnel, and the path of fewest straight links through the tunnel
//! is found by looking as far ahead as possible from each link's window (Imai and Iri 1986, doi 10.1016/S0734-189X(86)80027-5).
//! Each row enters two searches at most, so the time is proportional to the number of rows.
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | t, y | time and value of a row | any |
//! | ε | tolerance | that of y |

use crate::refusal::{Refusal, require_finite};
use std::collections::VecDeque;

/// What rounding may take of the tolerance.
const MARGIN: f64 = 1e-9;

/// A polyline beside a record.
#[derive(Debug, Clone, PartialEq)]
pub struct Thinned {
    /// (t, y) of its corners, both ends included: times increase.
    pub corners: Vec<(f64, f64)>,
    /// The largest distance in y between it and a row of the record: at most the tolerance.
    pub deviation: f64,
}

/// The polyline of fewest corners that starts at the first row, ends at the time of the last, is at most `tolerance` away from every row (and from the
/// straight lines between them), and is nowhere below `floor` if no row is. At tolerance zero it is the record.
///
/// A reversal larger than twice the tolerance is always kept.
///
/// # Errors
/// [`Refusal::OutOfRange`] for fewer than two rows, times that do not increase, or a tolerance that is negative or not finite.
pub fn thinned(rows: &[(f64, f64)], tolerance: f64, floor: f64) -> Result<Thinned, Refusal> {
    require_finite("tolerance of a polyline", tolerance)?;
    if tolerance < 0.0 {
        return Err(Refusal::out_of_range("tolerance of a polyline", tolerance, "0 or more"));
    }
    if rows.len() < 2 {
        return Err(Refusal::out_of_range("number of rows of a record", rows.len() as f64, "2 or more"));
    }
    let mut before = f64::NEG_INFINITY;
    for &(time, value) in rows {
        require_finite("time of a record", time)?;
        require_finite("value of a record", value)?;
        if time <= before {
            return Err(Refusal::out_of_range("time of a record", time, "later than the row before"));
        }
        before = time;
    }
    let whole = || Thinned { corners: rows.to_vec(), deviation: 0.0 };
    if tolerance == 0.0 {
        return Ok(whole());
    }
    let mut corners = Tunnel::new(rows, tolerance * (1.0 - MARGIN), floor).path();
    if rows.iter().all(|row| row.1 >= floor) {
        // A corner on the floor may be a rounding below it.
        corners.iter_mut().for_each(|corner| corner.1 = corner.1.max(floor));
    }
    let deviation = deviation(&corners, rows);
    // Only where the tolerance is of the order of rounding.
    Ok(if deviation <= tolerance && corners.len() <= rows.len() { Thinned { corners, deviation } } else { whole() })
}

/// The largest distance in y between a polyline and rows within its times; NaN beyond them.
#[must_use]
pub fn deviation(corners: &[(f64, f64)], rows: &[(f64, f64)]) -> f64 {
    let mut links = corners.windows(2).filter_map(|pair| Some((*pair.first()?, *pair.last()?)));
    let mut link = links.next();
    let mut most = 0.0_f64;
    for &(time, value) in rows {
        while link.is_some_and(|(_, end)| time > end.0) {
            link = links.next();
        }
        let Some((start, end)) = link else { return f64::NAN };
        let part = (time - start.0) / (end.0 - start.0);
        most = most.max((start.1 + (end.1 - start.1) * part - value).abs());
    }
    most
}

/// The standard deviation of noise that differs from row to row, from how far rows lie from the straight line between their neighbours: the median of
/// these distances, over what noise of the standard deviation one would give. Zero for fewer than three rows, and where most rows lie on such lines.
#[must_use]
pub fn noise(rows: &[(f64, f64)]) -> f64 {
    let mut distances: Vec<f64> = rows
        .windows(3)
        .filter_map(|three| {
            let [first, middle, last] = three else { return None };
            let part = (middle.0 - first.0) / (last.0 - first.0);
            let distance = middle.1 - first.1 - (last.1 - first.1) * part;
            // Of independent noise of all three.
            Some(distance.abs() / (1.0 + part * part + (1.0 - part) * (1.0 - part)).sqrt())
        })
        .collect();
    let place = distances.len() / 2;
    if distances.is_empty() {
        return 0.0;
    }
    let (_, median, _) = distances.select_nth_unstable_by(place, f64::total_cmp);
    *median * MEDIAN_TO_DEVIATION
}

/// The standard deviation of a normal distribution over the median of its magnitude.
const MEDIAN_TO_DEVIATION: f64 = 1.482_602_218_505_602;

/// A straight line through a point.
#[derive(Debug, Clone, Copy)]
struct Line {
    at: (f64, f64),
    slope: f64,
}

impl Line {
    fn value(&self, time: f64) -> f64 {
        self.at.1 + self.slope * (time - self.at.0)
    }
}

/// A point of one wall; its row, or none for the point where the last link meets the wall.
#[derive(Debug, Clone, Copy)]
struct Point {
    time: f64,
    value: f64,
    row: Option<usize>,
}

/// One wall as a search sees it: its points so far that a later line may touch, and the line that leans on it last.
struct Wall {
    /// +1 for the upper wall, −1 for the lower one, whose values are taken with this sign.
    sign: f64,
    hull: VecDeque<Point>,
    /// The line of extreme slope that touches the other wall first and then this one, and the point on this wall.
    extreme: Option<(Line, Point)>,
}

impl Wall {
    const fn new(sign: f64) -> Self {
        Self { sign, hull: VecDeque::new(), extreme: None }
    }

    /// Whether the extreme line of the other wall passes a point of this one on the wrong side.
    fn blocks(&self, other: &Self, time: f64, value: f64) -> bool {
        other.extreme.is_some_and(|(line, _)| self.sign * (value - line.value(time)) < 0.0)
    }

    /// Turns the extreme line of this wall where a new point of it lies inside.
    fn lean(&mut self, other: &mut Self, point: Point) {
        if self.extreme.is_some_and(|(line, _)| self.sign * (point.value - line.value(point.time)) >= 0.0) {
            return;
        }
        let slope = |from: &Point| self.sign * (point.value - from.value) / (point.time - from.time);
        // The touched points of the other wall only move ahead.
        while let (Some(first), Some(second)) = (other.hull.front(), other.hull.get(1)) {
            if second.time >= point.time || slope(second) > slope(first) {
                break;
            }
            other.hull.pop_front();
        }
        if let Some(first) = other.hull.front().filter(|first| first.time < point.time) {
            let line = Line { at: (point.time, point.value), slope: self.sign * slope(first) };
            self.extreme = Some((line, point));
        }
    }

    /// Adds a point to those that a later line may touch: the upper wall is touched from below.
    fn add(&mut self, point: Point) {
        while let (Some(last), Some(before)) = (self.hull.back(), self.hull.len().checked_sub(2).and_then(|place| self.hull.get(place))) {
            let turn = (last.value - before.value) * (point.time - before.time) - (point.value - before.value) * (last.time - before.time);
            if self.sign * turn < 0.0 {
                break;
            }
            self.hull.pop_back();
        }
        self.hull.push_back(point);
    }
}

/// The record between its walls.
struct Tunnel<'r> {
    rows: &'r [(f64, f64)],
    tolerance: f64,
    floor: f64,
}

impl<'r> Tunnel<'r> {
    fn new(rows: &'r [(f64, f64)], tolerance: f64, floor: f64) -> Self {
        Self { rows, tolerance, floor }
    }

    /// The point of a wall at a row: at the first one both walls meet.
    fn point(&self, row: usize, sign: f64) -> Option<Point> {
        let &(time, value) = self.rows.get(row)?;
        let value = match (row, sign > 0.0) {
            (0, _) => value,
            (_, true) => value + self.tolerance,
            (_, false) => (value - self.tolerance).max(self.floor.min(value)),
        };
        Some(Point { time, value, row: Some(row) })
    }

    fn path(&self) -> Vec<(f64, f64)> {
        let mut corners: Vec<(f64, f64)> = self.rows.first().copied().into_iter().collect();
        let (mut upper, mut lower) = (Wall::new(1.0), Wall::new(-1.0));
        for wall in [&mut upper, &mut lower] {
            if let Some(point) = self.point(0, wall.sign) {
                wall.add(point);
            }
        }
        // The link before, and between which times the next one leaves it.
        let mut last: Option<(Line, f64, f64)> = None;
        let (mut row, mut closed_at) = (1, 0);
        let mut put = |line: &Line, last: &Option<(Line, f64, f64)>| {
            if let Some((before, from, to)) = last {
                let time = before.at.0 + (before.at.1 - line.value(before.at.0)) / (line.slope - before.slope);
                let time = if time.is_finite() { time.clamp(*from, *to) } else { *to };
                if corners.last().is_none_or(|corner| time > corner.0) {
                    corners.push((time, before.value(time)));
                }
            }
        };
        while let (Some(above), Some(below)) = (self.point(row, 1.0), self.point(row, -1.0)) {
            let closed = if upper.blocks(&lower, above.time, above.value) {
                Some((&upper, &lower))
            } else if lower.blocks(&upper, below.time, below.value) {
                Some((&lower, &upper))
            } else {
                None
            };
            let Some((blocking, other)) = closed else {
                upper.lean(&mut lower, above);
                lower.lean(&mut upper, below);
                upper.add(above);
                lower.add(below);
                row += 1;
                continue;
            };
            // Only rounding can close a tunnel twice at one row.
            if closed_at == row {
                break;
            }
            closed_at = row;
            // The other wall's extreme line is as far as this link can see: where it meets the blocking wall is the end of its window.
            let Some((line, touched)) = other.extreme else { break };
            put(&line, &last);
            let (sign, other_sign) = (blocking.sign, other.sign);
            let (Some(inside), Some(outside)) = (self.point(row - 1, sign), self.point(row, sign)) else { break };
            let (room, excess) =
                ((sign * (inside.value - line.value(inside.time))).max(0.0), sign * (line.value(outside.time) - outside.value));
            let time = inside.time + (outside.time - inside.time) * (room / (room + excess)).clamp(0.0, 1.0);
            let end = Point { time: time.max(touched.time), value: line.value(time.max(touched.time)), row: None };
            last = Some((line, touched.time, end.time));
            // The next search: the touched wall from the touched point on, the blocking one from the end of the window on.
            let (mut blocking, mut other) = (Wall::new(sign), Wall::new(other_sign));
            other.add(touched);
            let next = touched.row.map_or_else(|| self.rows.partition_point(|row| row.0 <= touched.time), |row| row + 1);
            for point in (next..row).filter_map(|row| self.point(row, other_sign)) {
                other.add(point);
            }
            blocking.lean(&mut other, end);
            blocking.add(end);
            (upper, lower) = if sign > 0.0 { (blocking, other) } else { (other, blocking) };
        }
        let line = match (upper.extreme, lower.extreme) {
            (Some((one, _)), Some((other, _))) => {
                let time = self.rows.last().map_or(0.0, |row| row.0);
                Some(Line { at: (time, 0.5 * (one.value(time) + other.value(time))), slope: 0.5 * (one.slope + other.slope) })
            }
            (Some((line, _)), None) | (None, Some((line, _))) => Some(line),
            (None, None) => None,
        };
        if let (Some(line), Some(end)) = (line, self.rows.last()) {
            put(&line, &last);
            if corners.last().is_none_or(|corner| end.0 > corner.0) {
                corners.push((end.0, line.value(end.0)));
            }
        }
        corners
    }
}
