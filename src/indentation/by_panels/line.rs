//! The line: which points are bonded and which are free, as two lists of segments.
//!
//! ```text
//!   bonded (inside)                     edge a                       free (outside)
//!   ──────[ segment ][ segment ]──────────┼──────────[ segment ][ segment ]────── untouched →
//! ```
//! A segment is a piece of the path of the edge: the place s(θ), the instant T(θ) at which the edge passed it, and the state X(θ) in which
//! it left the point, all as Chebyshev series of the parameter θ of the panel of the path that made it.
//!
//! | list | X | at any later time t |
//! |---|---|---|
//! | free | e_j(T), the Voigt strains | D = Σ e^{−(t−T)/τ_j}X_j − (Δ − f) |
//! | bonded | q_i(T⁺) − P_i(T) | Q = E0(Δ − f) + Σ[e^{−(t−T)/ρ_i}X_i + P_i(t)] |
//!
//! Nothing is ever updated. Places and times are relative to an origin that moves with the edge, so that what is near it keeps its digits
//! however short the process zone is against the contact. A blank segment has X = 0: relaxed where bonded, untouched where free.

use super::chain::Chain;
use super::drive::Instant;
use super::trail::Trail;
use serde::{Deserialize, Serialize};

/// Most coefficients of a series.
pub(super) const SERIES: usize = 16;

/// Lag, in units of a relaxation or retardation time, at which nothing is left of a strain: e^{−40} = 4e-18.
pub(super) const FADED: f64 = 40.0;

/// Chebyshev polynomials at a parameter.
pub(super) fn chebyshev(x: f64, values: &mut [f64]) {
    let (mut last, mut here) = (x, 1.0);
    for value in values {
        *value = here;
        (last, here) = (here, 2.0 * x * here - last);
    }
}

/// A series and its slope.
pub(super) fn series(coefficients: &[f64], x: f64) -> (f64, f64) {
    let (mut b1, mut b2, mut d1, mut d2) = (0.0, 0.0, 0.0, 0.0);
    for &c in coefficients.iter().skip(1).rev() {
        (d1, d2) = (2.0 * b1 + 2.0 * x * d1 - d2, d1);
        (b1, b2) = (c + 2.0 * x * b1 - b2, b1);
    }
    (coefficients.first().copied().unwrap_or(0.0) + x * b1 - b2, b1 + x * d1 - d2)
}

/// A piece of the path.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Segment {
    /// Its ends, and the parameter there.
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) theta_low: f64,
    pub(super) theta_high: f64,
    /// Where and when its series count from.
    pub(super) place: f64,
    pub(super) time: f64,
    pub(super) blank: bool,
    /// s(θ) is a straight line.
    pub(super) straight: bool,
    pub(super) places: Vec<f64>,
    pub(super) times: Vec<f64>,
    /// Δ(θ), where it is not given but follows.
    pub(super) depths: Vec<f64>,
    /// n + 1 numbers for each polynomial: X, and what the passage changed (Q before letting go, D before bonding).
    pub(super) states: Vec<f64>,
}

impl Segment {
    pub(super) fn blank(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            theta_low: -1.0,
            theta_high: 1.0,
            place: 0.0,
            time: 0.0,
            blank: true,
            straight: true,
            places: vec![0.0, 1.0],
            times: vec![],
            depths: vec![],
            states: vec![],
        }
    }

    /// s and ds/dθ.
    pub(super) fn place_at(&self, theta: f64) -> (f64, f64) {
        let (value, slope) = series(&self.places, theta);
        (self.place + value, slope)
    }

    pub(super) fn time_at(&self, theta: f64) -> f64 {
        self.time + series(&self.times, theta).0
    }

    /// X_j at a parameter.
    pub(super) fn state_at(&self, n: usize, j: usize, theta: f64) -> f64 {
        let mut basis = [0.0; SERIES];
        chebyshev(theta, &mut basis);
        self.states.chunks_exact(n + 1).zip(basis).map(|(row, b)| row[j] * b).sum()
    }

    /// θ at a place: closed if straight, else by Newton's method kept within its bracket.
    pub(super) fn theta_at(&self, s: f64) -> f64 {
        if self.straight {
            return (s - self.place - self.places[0]) / self.places[1];
        }
        let (mut below, mut above) = (self.theta_low, self.theta_high);
        let part = ((s - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        let mut theta = below + part * (above - below);
        for _ in 0..60 {
            let (place, slope) = self.place_at(theta);
            let excess = place - s;
            if excess < 0.0 {
                below = theta
            } else {
                above = theta
            }
            let next = theta - excess / slope;
            let inside = (next - below) * (next - above) <= 0.0;
            let next = if inside { next } else { 0.5 * (below + above) };
            if (next - theta).abs() <= 4e-16 {
                return next;
            }
            theta = next;
        }
        theta
    }
}

/// The field of a point and what a change of the instant of its passage does to it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Field {
    pub(super) value: f64,
    pub(super) rate: f64,
    pub(super) memory: f64,
}

/// Q (bonded) or D (free) at a parameter of a segment; `height`: f there.
pub(super) fn field(chain: &Chain, bonded: bool, segment: &Segment, theta: f64, height: f64, now: &Instant) -> Field {
    let mut field = if bonded {
        Field { value: now.base - chain.relaxed * height, rate: now.base_rate, memory: 0.0 }
    } else {
        Field { value: height - now.depth, rate: -now.rate, memory: 0.0 }
    };
    if segment.blank {
        return field;
    }
    let terms = if bonded { &chain.relaxation } else { &chain.creep };
    let mut basis = [0.0; SERIES];
    let length = segment.times.len();
    chebyshev(theta, &mut basis[..length]);
    let time: f64 = segment.times.iter().zip(&basis).map(|(c, b)| c * b).sum();
    let lag = now.time - segment.time - time;
    if terms.iter().all(|term| lag * term.1 > FADED) {
        return field;
    }
    let n = chain.terms();
    let count = segment.states.len() / (n + 1);
    if length < count {
        chebyshev(theta, &mut basis[..count]);
    }
    let mut kernel = 0.0;
    for (j, &(weight, rate)) in terms.iter().enumerate() {
        let kept = (-lag * rate).exp();
        let state: f64 = segment.states.chunks_exact(n + 1).zip(&basis).map(|(row, b)| row[j] * b).sum();
        field.value += kept * state;
        field.rate -= rate * kept * state;
        kernel += weight * rate * kept;
    }
    let passed: f64 = segment.states.chunks_exact(n + 1).zip(&basis).map(|(row, b)| row[n] * b).sum();
    // J′(lag)·Q, or R′(lag)·D.
    field.memory = if bonded { -kernel * passed } else { kernel * passed };
    field
}

/// Both lists; the segment nearest the edge is the last of its list.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Line {
    /// a and t of the origin, with what rounding leaves.
    pub(super) edge: f64,
    pub(super) time: f64,
    pub(super) rest: (f64, f64),
    pub(super) inside: Vec<Segment>,
    pub(super) outside: Vec<Segment>,
    /// Places of no smooth continuation of the profile.
    pub(super) breaks: Vec<Break>,
    /// The path of the edge, where it is kept.
    pub(super) trail: Option<Trail>,
}

/// A place of no smooth continuation of the profile.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct Break {
    pub(super) place: f64,
    /// b and c of what f has more beyond it, b·h^{3/2} + c·h^{5/2}; None where pieces only grow towards a place that is rough.
    pub(super) roots: Option<[f64; 2]>,
}

/// What eight nodes over an interval with such a root within it leave of its value at the end.
const LEFT: [f64; 2] = [4e-4, 2e-5];

impl Break {
    /// What f has more at a way beyond the place.
    pub(super) fn size(&self, way: f64) -> Option<f64> {
        self.roots.map(|[b, c]| (b.abs() + c.abs() * way) * way * way.sqrt())
    }

    /// Whether eight nodes over an interval miss more of f than allowed.
    pub(super) fn cuts(&self, width: f64, allowed: f64) -> bool {
        self.roots.is_none_or(|[b, c]| (LEFT[0] * b.abs() + LEFT[1] * c.abs() * width) * width * width.sqrt() > allowed)
    }
}

impl Line {
    /// Relaxed inside and untouched outside; `breaks`: radii at which the profile has no smooth continuation.
    pub(super) fn new(edge: f64, breaks: &[Break]) -> Self {
        let (inside, outside) = (vec![Segment::blank(-edge, 0.0)], vec![Segment::blank(0.0, f64::INFINITY)]);
        let mut breaks: Vec<Break> = breaks.iter().map(|at| Break { place: at.place - edge, ..*at }).collect();
        breaks.sort_by(|one, other| one.place.total_cmp(&other.place));
        Self { edge, time: 0.0, rest: (0.0, 0.0), inside, outside, breaks, trail: None }
    }

    /// Two places with the breaks of the profile between them, in their order.
    pub(super) fn broken(&self, low: f64, high: f64) -> impl Iterator<Item = f64> {
        let between = self.breaks.iter().map(|at| at.place).filter(move |place| *place > low && *place < high);
        std::iter::once(low).chain(between).chain(std::iter::once(high))
    }

    /// The parameters of a segment from a place to another, in pieces on which the profile is smooth; `from`, `to`: the parameters there.
    pub(super) fn pieces(&self, segment: &Segment, (low, high): (f64, f64), (from, to): (f64, f64)) -> Vec<(f64, f64)> {
        let mut theta = from;
        let next = |place: f64| {
            let next = if place < high { segment.theta_at(place) } else { to };
            (std::mem::replace(&mut theta, next), next)
        };
        self.broken(low, high).skip(1).map(next).collect()
    }

    pub(super) fn list(&self, inside: bool) -> &[Segment] {
        if inside { &self.inside } else { &self.outside }
    }

    /// The segment of a list that holds a place, or the one at that end.
    pub(super) fn at(&self, inside: bool, s: f64) -> &Segment {
        let list = self.list(inside);
        let beyond = |segment: &&Segment| if inside { segment.low <= s } else { segment.high >= s };
        list.iter().rev().find(beyond).unwrap_or(&list[0])
    }

    /// After a time in which the edge rested.
    pub(super) fn waited(&mut self, time: f64) {
        self.trail.iter_mut().for_each(|trail| trail.waits(time));
        self.inside.iter_mut().chain(&mut self.outside).for_each(|segment| segment.time -= time);
        (self.time, self.rest.1) = added(self.time, self.rest.1, time);
    }

    /// After a panel up to θ: what it swept goes from one list and joins the other; the origin moves to its end.
    pub(super) fn swept(&mut self, mut panel: Segment, theta: f64) {
        let (way, _) = panel.place_at(theta);
        let duration = panel.time_at(theta);
        self.trail.iter_mut().for_each(|trail| trail.goes(&panel, theta));
        let advances = way > 0.0;
        let (growing, shrinking) = if advances { (&mut self.inside, &mut self.outside) } else { (&mut self.outside, &mut self.inside) };
        while shrinking.len() > 1 && shrinking.last().is_some_and(|last| if advances { last.high <= way } else { last.low >= way }) {
            shrinking.pop();
        }
        if let Some(last) = shrinking.last_mut() {
            let theta = last.theta_at(way);
            if advances { (last.low, last.theta_low) = (way, theta) } else { (last.high, last.theta_high) = (way, theta) }
        }
        if advances {
            (panel.low, panel.high, panel.theta_low, panel.theta_high) = (0.0, way, -1.0, theta);
        } else {
            (panel.low, panel.high, panel.theta_low, panel.theta_high) = (way, 0.0, theta, -1.0);
        }
        growing.push(panel);
        for segment in self.inside.iter_mut().chain(&mut self.outside) {
            segment.low -= way;
            segment.high -= way;
            segment.place -= way;
            segment.time -= duration;
        }
        self.breaks.iter_mut().for_each(|at| at.place -= way);
        (self.edge, self.rest.0) = added(self.edge, self.rest.0, way);
        (self.time, self.rest.1) = added(self.time, self.rest.1, duration);
    }
}

/// A sum and what rounding left of it.
pub(super) fn added(sum: f64, rest: f64, more: f64) -> (f64, f64) {
    let more = more + rest;
    let total = sum + more;
    (total, more - (total - sum))
}
