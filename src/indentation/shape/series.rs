//! f and f′ as Chebyshev series, so that a value costs two searches and one recursion, however many points the shape has.

use super::super::row::Row;
use super::abel::{Piece, integrals, line_profile};
use crate::refusal::Refusal;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::{LazyLock, OnceLock};

/// Terms of a series.
const TERMS: usize = 24;
/// Last coefficients over the largest, of f′ over the magnitude of its terms, below which a series has converged.
const SMALL: f64 = 2e-15;
/// Halvings of an interval, all towards a point near which another one lies.
const DEEPEST: u32 = 40;
/// Most series from one point to the next. Halving towards a near point takes one a halving and the deepest ones two; what asks for more is noise, and is
/// summed piece by piece.
const MOST_INTERVALS: usize = 3 * DEEPEST as usize;

/// Widths of an interval between it and a piece beyond which so many places in it tell what the piece does, the widest first: their series err as ρ^{−places},
/// ρ = z + √(z² − 1), z = 1 + 2·widths.
const FAR: [(f64, usize); 3] = [(50.0, 7), (10.0, 10), (2.0, 16)];
/// What each of these places, a part of the interval, adds to the places of a series, of an even one and of a rooted one.
type FarPlace = (f64, [[f64; TERMS]; 2]);
static FAR_PLACES: LazyLock<[Vec<FarPlace>; 3]> = LazyLock::new(|| FAR.map(|(_, count)| far_places(count)));

/// cos jθ_k of the places θ_k of a series, term after term.
static COSINES: LazyLock<[[f64; TERMS]; TERMS]> =
    LazyLock::new(|| std::array::from_fn(|j| std::array::from_fn(|k| (j as f64 * (PI * (k as f64 + 0.5) / TERMS as f64)).cos())));

/// f and f′ over low ≤ s ≤ high.
#[derive(Debug, Clone, PartialEq)]
struct Interval {
    low: f64,
    width: f64,
    /// Whether it starts at a point, where f is smooth in √(s − low).
    rooted: bool,
    value: [f64; TERMS],
    slope: [f64; TERMS],
}

/// The intervals from one point to the next; none where so many do not suffice.
type Section = OnceLock<Option<Vec<Interval>>>;

/// f and f′ from the axis on. A section is cut into intervals when it is first asked for: few contacts reach all points of a table.
#[derive(Debug, Clone)]
pub(super) struct Series {
    pieces: Vec<Piece>,
    /// f = c₀s + c₁s² + c₂s³ up to the first point: there the shape is one polynomial.
    axis: [f64; 3],
    first: f64,
    /// Of each piece.
    sections: Vec<Section>,
    /// f, f′ and half of f″ at the last point, of the parabola beyond.
    last: [f64; 3],
}

impl PartialEq for Series {
    /// What is already cut follows from the pieces.
    fn eq(&self, other: &Self) -> bool {
        self.pieces == other.pieces
    }
}

impl Series {
    pub(super) fn of(pieces: Vec<Piece>) -> Result<Self, Refusal> {
        let Some(axis) = pieces.first() else { return Err(unresolved()) };
        let [a, b, c] = axis.coefficients;
        let [value, slope, size] = line_profile(&pieces, 1.0, 0.0);
        if ![value, slope, size].iter().all(|number| number.is_finite()) {
            return Err(unresolved());
        }
        Ok(Self {
            axis: [FRAC_PI_2 * a, b, FRAC_PI_4 * c],
            first: axis.high,
            sections: pieces.iter().map(|_| Section::new()).collect(),
            last: [value, slope, 0.5 * slope],
            pieces,
        })
    }

    pub(super) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    pub(super) fn piece(&self, s: f64) -> Option<&Piece> {
        self.pieces.get(self.index(s))
    }

    /// The first place at which f does not rise.
    pub(super) fn falls_at(&self) -> Result<Option<f64>, Refusal> {
        // Up to the first piece in which z′ + r z″ is negative, f′ is a sum of positive terms.
        let Some(suspect) = self.pieces.iter().position(|piece| !piece.pushes_up()) else { return Ok(None) };
        let mut places: Vec<f64> = (1..=TERMS).map(|k| self.first * k as f64 / TERMS as f64).collect();
        for index in suspect.max(1)..self.pieces.len() {
            let Some(intervals) = self.section(index) else { return Err(unresolved()) };
            // Where the first term is larger than all others together, f′ cannot vanish.
            let may_fall =
                intervals.iter().filter(|interval| 2.0 * interval.slope[0] <= interval.slope.iter().map(|c| c.abs()).sum::<f64>());
            places.extend(
                may_fall.flat_map(|interval| (0..=2 * TERMS).map(|k| interval.low + interval.width * k as f64 / (2 * TERMS) as f64)),
            );
        }
        Ok(places.into_iter().find(|s| self.slope(*s) <= 0.0))
    }

    fn index(&self, s: f64) -> usize {
        self.pieces.partition_point(|piece| piece.low <= s).saturating_sub(1)
    }

    fn section(&self, index: usize) -> Option<&[Interval]> {
        self.sections.get(index)?.get_or_init(|| intervals(&self.pieces, self.pieces.get(index)?)).as_deref()
    }

    fn interval(&self, s: f64) -> Option<&Interval> {
        let intervals = self.section(self.index(s))?;
        intervals.get(intervals.partition_point(|interval| interval.low <= s).saturating_sub(1))
    }

    /// f and f′, and the magnitudes of the terms of f′, where no series has them.
    fn summed(&self, s: f64) -> [f64; 3] {
        let low = self.piece(s).map_or(0.0, |piece| piece.low);
        line_profile(&self.pieces, low, s - low)
    }

    /// f at eight places in rising order, side by side where one interval holds them all: the same digits as one by one.
    pub(super) fn values(&self, places: &Row) -> Row {
        let [low, .., high] = *places;
        if low > self.first
            && high < 1.0
            && let (Some(interval), Some(other)) = (self.interval(low), self.interval(high))
            && std::ptr::eq(interval, other)
        {
            return sum(&interval.value, places.map(|s| interval.variable(s)));
        }
        places.map(|s| self.value(s))
    }

    pub(super) fn value(&self, s: f64) -> f64 {
        if s <= self.first {
            return s * (self.axis[0] + s * (self.axis[1] + s * self.axis[2]));
        }
        if s >= 1.0 {
            return self.last[0] + (s - 1.0) * (self.last[1] + (s - 1.0) * self.last[2]);
        }
        self.interval(s).map_or_else(|| self.summed(s)[0], |interval| sum(&interval.value, [interval.variable(s)])[0])
    }

    pub(super) fn slope(&self, s: f64) -> f64 {
        if s <= self.first {
            return self.axis[0] + s * (2.0 * self.axis[1] + s * 3.0 * self.axis[2]);
        }
        if s >= 1.0 {
            return self.last[1] + 2.0 * (s - 1.0) * self.last[2];
        }
        self.interval(s).map_or_else(|| self.summed(s)[1], |interval| sum(&interval.slope, [interval.variable(s)])[0])
    }
}

/// Of a piece, halved until their series have converged.
fn intervals(pieces: &[Piece], piece: &Piece) -> Option<Vec<Interval>> {
    let mut found = Vec::new();
    // What is still to be covered, from the point on, the nearest last.
    let mut waiting = vec![(0.0, piece.high - piece.low, true, 0)];
    while let Some((from, to, rooted, depth)) = waiting.pop() {
        let (interval, converged) = Interval::sampled(pieces, piece.low, [from, to], rooted);
        if converged {
            found.push(interval);
        } else if depth < DEEPEST && found.len() < MOST_INTERVALS {
            let middle = 0.5 * (from + to);
            waiting.push((middle, to, false, depth + 1));
            waiting.push((from, middle, rooted, depth + 1));
        } else {
            return None;
        }
    }
    Some(found)
}

fn unresolved() -> Refusal {
    Refusal::NotConverged { what: "the line profile of a shape", detail: "its points are too uneven".into() }
}

impl Interval {
    /// The series through TERMS places that lie so far beyond a point, and whether they suffice.
    fn sampled(pieces: &[Piece], point: f64, [from, to]: [f64; 2], rooted: bool) -> (Self, bool) {
        let (low, high, width) = (point + from, point + to, to - from);
        let cosines = &*COSINES;
        let parts = parts(rooted);
        // The pieces from the axis to the interval, the far ones of each rule and the near ones.
        let mut rest = pieces.get(..pieces.partition_point(|piece| (point - piece.low) + to > 0.0)).unwrap_or(pieces);
        let mut sums = [[0.0; 3]; TERMS];
        for ((widths, _), places) in FAR.iter().zip(FAR_PLACES.iter()) {
            let (far, nearer) = rest.split_at(rest.partition_point(|piece| (point - piece.high) + from >= widths * width));
            rest = nearer;
            for (part, weights) in places.iter().filter(|_| !far.is_empty()) {
                let there = integrals(far, point, from + width * part);
                for (sums, weight) in sums.iter_mut().zip(&weights[usize::from(rooted)]) {
                    for (sum, value) in sums.iter_mut().zip(there) {
                        *sum += weight * value;
                    }
                }
            }
        }
        let samples: [[f64; 3]; TERMS] = std::array::from_fn(|k| {
            let beyond = from + width * parts[k];
            let near = integrals(rest, point, beyond);
            let [value, slope, size]: [f64; 3] = std::array::from_fn(|which| sums[k][which] + near[which]);
            [(point + beyond) * value, slope, size]
        });
        let transformed = |which: usize| -> [f64; TERMS] {
            std::array::from_fn(|j| {
                let factor = if j == 0 { 1.0 } else { 2.0 } / TERMS as f64;
                factor * samples.iter().zip(&cosines[j]).map(|(sample, cosine)| sample[which] * cosine).sum::<f64>()
            })
        };
        let [value, slope] = [transformed(0), transformed(1)];
        let small = |series: &[f64; TERMS], scale: f64| series[TERMS - 3..].iter().all(|c| c.abs() <= SMALL * scale);
        // Where terms of f′ cancel, no more digits are there than their magnitudes leave.
        let slope_scale = samples.iter().fold(0.0, |most: f64, sample| most.max(sample[2])).max(value[0].abs() / high);
        // An interval as narrow as rounding is a line.
        let converged = (small(&value, value[0].abs()) && small(&slope, 4.0 * slope_scale)) || width <= 1e-12 * high;
        (Self { low, width, rooted, value, slope }, converged)
    }

    fn variable(&self, s: f64) -> f64 {
        let x = ((s - self.low) / self.width).clamp(0.0, 1.0);
        2.0 * (if self.rooted { x.sqrt() } else { x }) - 1.0
    }
}

fn far_places(count: usize) -> Vec<FarPlace> {
    let angle = |k: usize| PI * (k as f64 + 0.5) / count as f64;
    (0..count)
        .map(|k| {
            let factor = |j: usize| if j == 0 { 1.0 } else { 2.0 } / count as f64;
            let series: Vec<f64> = (0..count).map(|j| factor(j) * (j as f64 * angle(k)).cos()).collect();
            let weights = [false, true].map(|rooted| sum(&series, parts(rooted).map(|part| 2.0 * part - 1.0)));
            (0.5 * (1.0 + angle(k).cos()), weights)
        })
        .collect()
}

/// Parts of an interval at which the places of its series lie.
fn parts(rooted: bool) -> [f64; TERMS] {
    COSINES[1].map(|cosine| {
        let x = 0.5 * (1.0 + cosine);
        if rooted { x * x } else { x }
    })
}

/// Σ c_j T_j(x) at several places side by side, by Clenshaw's recursion.
fn sum<const COUNT: usize>(series: &[f64], places: [f64; COUNT]) -> [f64; COUNT] {
    let (mut next, mut after) = ([0.0; COUNT], [0.0; COUNT]);
    for c in series.iter().skip(1).rev() {
        for ((next, after), x) in next.iter_mut().zip(&mut after).zip(&places) {
            (*next, *after) = (c + 2.0 * x * *next - *after, *next);
        }
    }
    let constant = series.first().copied().unwrap_or(0.0);
    std::array::from_fn(|k| constant + places[k] * next[k] - after[k])
}
