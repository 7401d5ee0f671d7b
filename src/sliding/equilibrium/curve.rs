//! The contacts along the half-widths, joined to curves.
//!
//! At each of a row of half-widths all contacts are known, and how each goes on. Rows are divided until the contacts of neighbours are each other's continuation
//! without any question: what both slopes predict is met much nearer than any other contact, and load and depth turn once at most between them. Where a contact appears
//! or
//! vanishes, rows are divided to the last: two that vanish together are the two sides of a turn of the half-width, one alone is an end.

use super::held::SegmentEnd;
use super::point::{HeldQuantity, Point};
use super::width::{ContactsOfWidth, distance};
use crate::sliding::contact::{ContactEdges, Indenter, WaveContact};
use crate::sliding::edge_balance::EdgeBalance;
use std::f64::consts::PI;

/// Largest distance of neighbouring places, ln tan(a/2).
const SPACING: f64 = 0.4;
/// Where contacts appear or vanish, places are this near: what bends with a root there is known to a thousandth.
const FINEST: f64 = 1e-6;
/// Load and depth are not looked at more closely than this.
const STRAIGHT: f64 = 5e-3;
/// Largest distance of an eccentricity from what both slopes predict, of a parabola over its size; and of the two sides of a turn.
const CONTINUES: f64 = 0.1;
/// The same over the distance to another contact.
const OF_THE_DISTANCE: f64 = 0.25;
/// Rows at most: more only where what exists is lost in rounding.
const MOST_ROWS: usize = 1500;
/// The narrowest contact, over the longer process zone.
const WIDTH_IN_ZONES: f64 = 0.02;
/// The same over an unloaded one.
const WIDTH_IN_UNLOADED: f64 = 0.05;
/// The narrowest contact and gap without adhesion, in 1/k.
const NARROWEST: f64 = 1e-5;
/// Half-widths of a cylinder, under and over its size.
const RANGE: [f64; 2] = [1e-3, 1e2];

/// The contacts of one half-width.
#[derive(Debug, Clone)]
struct Row {
    place: f64,
    points: Vec<Point>,
}

/// All contacts of one speed and adhesion, joined.
#[derive(Debug)]
pub(in crate::sliding) struct EquilibriumCurve {
    pub(super) every: ContactsOfWidth,
    /// Each a curve of contacts in the order along it.
    pub(super) chains: Vec<Vec<Point>>,
    /// The narrowest place that was looked at.
    narrowest: f64,
    /// Half-widths that were looked at.
    rows: u64,
    /// Half-widths whose conditions were formed for it.
    formed: u64,
}

impl EquilibriumCurve {
    /// The contacts of conditions, whatever their control; `size`: of a cylinder the half-width around which contacts are looked for.
    ///
    /// # Errors
    /// Those of the contacts.
    pub(in crate::sliding) fn new(balance: EdgeBalance, size: f64) -> Self {
        let range = half_widths(&balance, size);
        Self::within(ContactsOfWidth::new(balance), range)
    }

    /// The contacts of a range of half-widths.
    pub(in crate::sliding) fn within(mut every: ContactsOfWidth, half_widths: [f64; 2]) -> Self {
        let indenter = every.indenter();
        let [low, high] = half_widths.map(|half_width| ContactEdges::new(indenter, WaveContact { half_width, eccentricity: 0.0 }).place());
        every.tabulate([low, high]);
        let row = |place: f64| Row { place, points: every.points(place) };
        let count = ((high - low) / SPACING).ceil().max(1.0) as u32;
        let mut open: Vec<Row> = (0..=count).rev().map(|index| row(low + (high - low) * f64::from(index) / f64::from(count))).collect();
        let mut rows: Vec<Row> = Vec::new();
        while let Some(next) = open.pop() {
            match rows.last() {
                Some(last) if rows.len() < MOST_ROWS && !last.is_followed_by(indenter, &next) => {
                    let middle = row(0.5 * (last.place + next.place));
                    open.extend([next, middle]);
                }
                _ => rows.push(next),
            }
        }
        let (count, formed) = (rows.len() as u64, every.take_widths());
        Self { chains: chains(indenter, rows), every, narrowest: low, rows: count, formed }
    }

    /// The contact of another half-width near one that is known.
    pub(super) fn beside(&self, place: f64, eccentricity: f64) -> Option<Point> {
        let point = self.every.nearest(place, eccentricity)?;
        let far = distance(self.every.indenter(), point.eccentricity, eccentricity);
        (far < CONTINUES * size(self.every.indenter(), &point)).then_some(point)
    }

    /// Whether a contact is the narrowest that was looked at.
    pub(in crate::sliding) fn is_narrowest(&self, contact: &SegmentEnd) -> bool {
        contact.place <= self.narrowest
    }

    /// Half-widths that were looked at.
    pub(in crate::sliding) const fn rows(&self) -> u64 {
        self.rows
    }

    /// Evaluations of both conditions that the curve and the checks since the last call count as: the same for each of the contacts that share it.
    pub(in crate::sliding) fn evaluations(&self) -> u64 {
        2 * self.formed + self.every.evaluations()
    }
}

/// The half-widths among which contacts are looked for; `size`: of a cylinder the one around which.
pub(in crate::sliding) fn half_widths(balance: &EdgeBalance, size: f64) -> [f64; 2] {
    let (indenter, adhesion) = (balance.indenter(), balance.adhesion());
    let zone = adhesion.map_or(0.0, |adhesion| adhesion.trailing_zone.max(adhesion.leading_zone));
    // Without a load a glassy contact has a³ = 32Γ/β, and no contact is pulled off before it is some tenths of that.
    let work = adhesion.map_or(0.0, |adhesion| adhesion.trailing_work.min(adhesion.leading_work));
    let unloaded = (32.0 * work / balance.memory().stiffening_ratio()).cbrt();
    let narrow = (WIDTH_IN_ZONES * zone).max(WIDTH_IN_UNLOADED * unloaded);
    // In a narrower gap the zones of both edges overlap, and the works of closing have turns of their own.
    let narrowest_gap = adhesion.map_or(0.0, |adhesion| adhesion.trailing_zone + adhesion.leading_zone + zone);
    match indenter {
        Indenter::Wave => [narrow.clamp(NARROWEST, 1.0), PI - (0.5 * narrowest_gap).clamp(NARROWEST, 1.0)],
        Indenter::Parabola => [if adhesion.is_some() { narrow } else { RANGE[0] * size }, RANGE[1] * (size + zone)],
    }
}

/// What eccentricities are compared with.
fn size(indenter: Indenter, point: &Point) -> f64 {
    if indenter == Indenter::Wave { 1.0 } else { point.half_width + point.eccentricity.abs() }
}

impl Row {
    /// Whether nothing is open between this row and the next.
    fn is_followed_by(&self, indenter: Indenter, next: &Self) -> bool {
        let length = next.place - self.place;
        let pairs = joined(indenter, self, next);
        let straight = |quantity: HeldQuantity, one: &Point, other: &Point| {
            let change = quantity.of(other) - quantity.of(one);
            let [before, after] = [one, other].map(|point| length * quantity.slope(point));
            // Monotone as a cubic is, or one turn.
            before * after <= 0.0 || (before * change > 0.0 && before.abs().max(after.abs()) <= 3.0 * change.abs())
        };
        let all = pairs.len() == self.points.len().max(next.points.len());
        if !all {
            return length <= FINEST;
        }
        length < STRAIGHT
            || pairs.iter().all(|&(from, to)| {
                let (Some(one), Some(other)) = (self.points.get(from), next.points.get(to)) else { return true };
                straight(HeldQuantity::MeanPressure, one, other)
                    && (indenter == Indenter::Parabola || straight(HeldQuantity::Penetration, one, other))
            })
    }

    /// How far the nearest other contact is.
    fn nearest_other(&self, indenter: Indenter, index: usize) -> f64 {
        let here = self.points.get(index).map_or(f64::NAN, |point| point.eccentricity);
        let others = self.points.iter().enumerate().filter(|&(other, _)| other != index);
        others.map(|(_, point)| distance(indenter, point.eccentricity, here)).fold(f64::INFINITY, f64::min)
    }
}

/// Pairs of contacts of two half-widths of which the slopes of both predict each other.
fn joined(indenter: Indenter, from: &Row, to: &Row) -> Vec<(usize, usize)> {
    let half = 0.5 * (to.place - from.place);
    let off = |one: &Point, other: &Point| distance(indenter, one.eccentricity + half * (one.tilt() + other.tilt()), other.eccentricity);
    let mut pairs = Vec::new();
    for (index, one) in from.points.iter().enumerate() {
        for (other_index, other) in to.points.iter().enumerate() {
            let room = from.nearest_other(indenter, index).min(to.nearest_other(indenter, other_index));
            let change = distance(indenter, one.eccentricity, other.eccentricity);
            if off(one, other) < (CONTINUES * size(indenter, one)).min(OF_THE_DISTANCE * room) && change < (size(indenter, one)).min(room) {
                pairs.push((index, other_index));
            }
        }
    }
    // Of those that could be both none is.
    let once = |&(from, to): &(usize, usize)| pairs.iter().filter(|&&(one, other)| one == from || other == to).count() == 1;
    pairs.iter().copied().filter(once).collect()
}

/// Joins rows to curves.
fn chains(indenter: Indenter, rows: Vec<Row>) -> Vec<Vec<Point>> {
    let mut begins = vec![0];
    begins.extend(rows.iter().scan(0, |sum, row| {
        *sum += row.points.len();
        Some(*sum)
    }));
    let count = begins.last().copied().unwrap_or(0);
    // Neighbours of each point along its curve, at most two.
    let mut links: Vec<Vec<usize>> = vec![Vec::new(); count];
    let (mut has_narrower, mut has_wider) = (vec![false; count], vec![false; count]);
    for (index, pair) in rows.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        for (first, second) in joined(indenter, from, to) {
            let (first, second) = (begins[index] + first, begins[index + 1] + second);
            links[first].push(second);
            links[second].push(first);
            (has_wider[first], has_narrower[second]) = (true, true);
        }
    }
    // Two contacts of one row whose curves end on the same side, next to each other: a turn of the half-width between this row and the next.
    for (index, row) in rows.iter().enumerate() {
        for (missing, inner) in [(&has_wider, index + 1 < rows.len()), (&has_narrower, index > 0)] {
            let open: Vec<usize> = (0..row.points.len()).filter(|point| inner && !missing[begins[index] + point]).collect();
            for (order, &first) in open.iter().enumerate() {
                for &second in open.iter().skip(order + 1) {
                    let (one, other) = (&row.points[first], &row.points[second]);
                    let near = distance(indenter, one.eccentricity, other.eccentricity) < CONTINUES * size(indenter, one);
                    let (first, second) = (begins[index] + first, begins[index] + second);
                    if near && links[first].len() < 2 && links[second].len() < 2 && !links[first].contains(&second) {
                        links[first].push(second);
                        links[second].push(first);
                    }
                }
            }
        }
    }
    let points: Vec<Point> = rows.into_iter().flat_map(|row| row.points).collect();
    let mut seen = vec![false; count];
    let mut chains = Vec::new();
    // Open curves from their ends first; what is left is closed.
    let ends = (0..count).filter(|&index| links[index].len() < 2).chain(0..count);
    for start in ends.collect::<Vec<_>>() {
        if seen[start] {
            continue;
        }
        let mut chain = Vec::new();
        let mut next = Some(start);
        while let Some(index) = next {
            seen[index] = true;
            chain.push(points[index]);
            next = links[index].iter().copied().find(|&other| !seen[other]);
        }
        // A closed curve ends where it begins.
        if links[start].len() == 2 {
            chain.push(points[start]);
        }
        chains.push(chain);
    }
    chains
}
