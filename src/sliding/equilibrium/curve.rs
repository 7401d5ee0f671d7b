//! The contacts along the half-widths, joined to curves.
//!
//! At each of a row of half-widths all contacts are known; neighbours of nearly one eccentricity belong together. Between two half-widths where a contact appears or
//! vanishes more half-widths are looked at. Two contacts that vanish together are the two sides of a turn of the half-width.

use super::width::{ContactsOfWidth, Point, apart};
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactMemory, Indenter, Resolution, WaveContact};
use crate::sliding::edge_balance::WaveAdhesion;
use std::f64::consts::PI;
use std::sync::Arc;

/// Distance of neighbouring places, ln tan(a/2).
const SPACING: f64 = 0.9;
/// The same at both ends of the row, where a turn has a neighbour on one side only; it grows from there.
const END_SPACING: f64 = 0.15;
/// How much from one to the next.
const GROWTH: f64 = 1.8;
/// A change of load below this part of those beside is looked at more closely.
const DIP: f64 = 0.8;
/// Parts of it.
const DIP_PARTS: u32 = 6;
/// Where contacts appear or vanish, places are at least this near.
const FINEST: f64 = 0.1;
/// Largest change of eccentricity between neighbours, of a parabola over the half-width.
const NEIGHBOURS: f64 = 0.6;
/// The narrowest contact, over the longer process zone.
const WIDTH_IN_ZONES: f64 = 0.02;
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
}

impl EquilibriumCurve {
    /// The contacts of a material, speed and adhesion; `size`: of a cylinder the half-width around which contacts are looked for.
    ///
    /// # Errors
    /// Those of the contacts.
    pub(in crate::sliding) fn new(
        memory: Arc<ContactMemory>,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
        size: f64,
        resolution: Resolution,
    ) -> Result<Self, Refusal> {
        let zone = adhesion.map_or(0.0, |adhesion| adhesion.trailing_zone.max(adhesion.leading_zone));
        // In a narrower gap the zones of both edges overlap, and the works of closing have turns of their own.
        let narrowest_gap = adhesion.map_or(0.0, |adhesion| adhesion.trailing_zone + adhesion.leading_zone + zone);
        let (narrowest, widest) = match indenter {
            Indenter::Wave => ((WIDTH_IN_ZONES * zone).clamp(NARROWEST, 1.0), PI - (0.5 * narrowest_gap).clamp(NARROWEST, 1.0)),
            Indenter::Parabola => ((WIDTH_IN_ZONES * zone).max(RANGE[0] * size), RANGE[1] * (size + zone)),
        };
        Self::within(ContactsOfWidth::new(memory, indenter, adhesion, resolution), [narrowest, widest])
    }

    /// The contacts of a range of half-widths.
    ///
    /// # Errors
    /// As [`EquilibriumCurve::new`].
    pub(in crate::sliding) fn within(every: ContactsOfWidth, half_widths: [f64; 2]) -> Result<Self, Refusal> {
        let indenter = every.indenter();
        let [narrowest, widest] =
            half_widths.map(|half_width| ContactEdges::new(indenter, WaveContact { half_width, eccentricity: 0.0 }).place());
        // A width that is refused is a gap in the row: the zone may be wider than the room there.
        let row = |place: f64| Row { place, points: every.points(ContactEdges::at_place(indenter, place, 0.0)).unwrap_or_default() };
        let mut rows: Vec<Row> = places(narrowest, widest).into_iter().map(row).collect();
        let mut index = 0;
        while let (Some(from), Some(to)) = (rows.get(index), rows.get(index + 1)) {
            let joined = joined(indenter, &from.points, &to.points).len();
            if joined == from.points.len().max(to.points.len()) || to.place - from.place <= FINEST {
                index += 1;
            } else {
                let middle = row(0.5 * (from.place + to.place));
                rows.insert(index + 1, middle);
            }
        }
        let mut chains = chains(indenter, rows);
        for chain in &mut chains {
            *chain = with_dips(&every, std::mem::take(chain));
        }
        Ok(Self { every, chains })
    }

    /// The contact of another half-width near one that is known.
    pub(super) fn beside(&self, place: f64, eccentricity: f64) -> Option<Point> {
        let point = self.every.nearest(place, eccentricity)?;
        near(self.every.indenter(), &point, eccentricity).then_some(point)
    }

    /// Half-widths that were looked at.
    pub(in crate::sliding) fn widths(&self) -> u64 {
        self.every.widths()
    }

    /// What that counts in evaluations of both conditions, with those of checks.
    pub(in crate::sliding) fn evaluations(&self) -> u64 {
        self.every.evaluations()
    }
}

/// A chain with more contacts where the load changes so much less than beside that it may turn twice between two neighbours.
fn with_dips(every: &ContactsOfWidth, chain: Vec<Point>) -> Vec<Point> {
    let change = |from: usize| match (chain.get(from), chain.get(from + 1)) {
        (Some(one), Some(other)) => other.mean_pressure - one.mean_pressure,
        _ => f64::NAN,
    };
    let mut all = Vec::with_capacity(chain.len());
    for (index, point) in chain.iter().enumerate() {
        all.push(*point);
        let (before, here, after) = (if index > 0 { change(index - 1) } else { f64::NAN }, change(index), change(index + 1));
        let dips = before * here > 0.0 && here * after > 0.0 && here.abs() < DIP * before.abs().min(after.abs());
        if let (true, Some(next)) = (dips, chain.get(index + 1)) {
            for part in 1..DIP_PARTS {
                let part = f64::from(part) / f64::from(DIP_PARTS);
                let eccentricity = point.eccentricity + part * (next.eccentricity - point.eccentricity);
                all.extend(every.nearest(point.place + part * (next.place - point.place), eccentricity));
            }
        }
    }
    all
}

/// Places from one end to the other.
fn places(narrowest: f64, widest: f64) -> Vec<f64> {
    let middle = 0.5 * (narrowest + widest);
    let half = |from: f64, sign: f64| {
        let (mut places, mut step) = (vec![from], END_SPACING);
        let mut place = from;
        while sign * (middle - place) > step {
            place += sign * step;
            places.push(place);
            step = (GROWTH * step).min(SPACING);
        }
        places
    };
    let mut places = half(narrowest, 1.0);
    places.extend(half(widest, -1.0).into_iter().rev());
    places
}

/// Whether a point may continue one of an eccentricity.
fn near(indenter: Indenter, point: &Point, eccentricity: f64) -> bool {
    let size = if indenter == Indenter::Wave { 1.0 } else { point.half_width + eccentricity.abs() };
    apart(indenter, point.eccentricity, eccentricity) < NEIGHBOURS * size
}

/// Pairs of contacts of two half-widths that are each other's nearest.
fn joined(indenter: Indenter, from: &[Point], to: &[Point]) -> Vec<(usize, usize)> {
    let nearest = |point: &Point, row: &[Point]| {
        let far = |index: &usize| row.get(*index).map_or(f64::INFINITY, |other| apart(indenter, other.eccentricity, point.eccentricity));
        (0..row.len()).min_by(|first, second| far(first).total_cmp(&far(second)))
    };
    from.iter()
        .enumerate()
        .filter_map(|(index, point)| {
            let other = nearest(point, to)?;
            let back = nearest(to.get(other)?, from)?;
            (back == index && near(indenter, to.get(other)?, point.eccentricity)).then_some((index, other))
        })
        .collect()
}

/// Joins rows to curves.
fn chains(indenter: Indenter, rows: Vec<Row>) -> Vec<Vec<Point>> {
    let begins: Vec<usize> = rows
        .iter()
        .scan(0, |sum, row| {
            let begin = *sum;
            *sum += row.points.len();
            Some(begin)
        })
        .collect();
    let count = rows.iter().map(|row| row.points.len()).sum();
    // Neighbours of each point along its curve, at most two.
    let mut links: Vec<Vec<usize>> = vec![Vec::new(); count];
    let (mut has_narrower, mut has_wider) = (vec![false; count], vec![false; count]);
    for (index, pair) in rows.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        for (first, second) in joined(indenter, &from.points, &to.points) {
            let (first, second) = (begins[index] + first, begins[index + 1] + second);
            links[first].push(second);
            links[second].push(first);
            (has_wider[first], has_narrower[second]) = (true, true);
        }
    }
    // Two neighbours of one row whose curves end on the same side: a turn of the half-width between this row and the next.
    for (index, row) in rows.iter().enumerate() {
        for (missing, inner) in [(&has_wider, index + 1 < rows.len()), (&has_narrower, index > 0)] {
            if !inner {
                continue;
            }
            for pair in 0..row.points.len().saturating_sub(1) {
                let (first, second) = (begins[index] + pair, begins[index] + pair + 1);
                if !missing[first]
                    && !missing[second]
                    && links[first].len() < 2
                    && links[second].len() < 2
                    && !links[first].contains(&second)
                {
                    links[first].push(second);
                    links[second].push(first);
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
