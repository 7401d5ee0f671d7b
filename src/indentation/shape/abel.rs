//! The exact line profile of one piece of a shape: f = s∫z′/√(s² − r²) dr and f′ = ∫(z′ + r z″)/√(s² − r²) dr.
//!
//! Every term of the sums is of one sign where z is convex. Where it is not, terms of f′ cancel, so the sum of their magnitudes is reported as well: rounding is
//! relative to it. With r = s − y² the integrand is a polynomial of fourth degree in y over
//! √(2s − y²), which eight nodes integrate to rounding; far from s the root itself is smooth, and nodes in r do without the roots.

use super::super::row::{Row, sum};
use crate::special::gauss_legendre::UNIT_RULE_8;

/// Widths of a piece between it and s beyond which nodes in r are exact to rounding: 8 nodes err as ρ^{−16}, ρ = 9.9.
const FAR: f64 = 2.0;
/// The root of a distance from s, over what is left to √(2s), where it ends: 8 nodes to an interval of 1/2.4 err as ρ^{−16}, ρ = 11.5.
const WIDEST: f64 = 2.4;

/// z = z₀ + c₀x + c₁x²/2 + c₂x³/3, x = r − low, of low ≤ r ≤ high.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    pub(super) low: f64,
    pub(super) high: f64,
    start: f64,
    pub(super) coefficients: [f64; 3],
    /// x, and weights times z′ and z′ + r z″, at the nodes.
    nodes: [f64; 8],
    weighted: [[f64; 8]; 2],
}

impl Piece {
    /// The pieces between points with given slopes.
    pub(super) fn all(x: &[f64], z: &[f64], slopes: &[f64]) -> Vec<Self> {
        (1..x.len()).map(|i| Self::new((x[i - 1], x[i]), (z[i - 1], z[i]), (slopes[i - 1], slopes[i]))).collect()
    }

    fn new((low, high): (f64, f64), (from, to): (f64, f64), (first, last): (f64, f64)) -> Self {
        let width = high - low;
        let secant = (to - from) / width;
        let coefficients =
            [first, 2.0 * (3.0 * secant - 2.0 * first - last) / width, 3.0 * (first + last - 2.0 * secant) / (width * width)];
        let mut piece = Self { low, high, start: from, coefficients, nodes: [0.0; 8], weighted: [[0.0; 8]; 2] };
        for (g, (node, weight)) in UNIT_RULE_8.iter().enumerate().take(8) {
            let [own, other] = piece.integrands(width * node);
            piece.nodes[g] = width * node;
            piece.weighted[0][g] = width * weight * own;
            piece.weighted[1][g] = width * weight * other;
        }
        piece
    }

    /// By how much z″ and half of z‴ jump from the piece before to this one.
    pub(super) fn jumps(&self, before: &Self) -> [f64; 2] {
        let ([_, b, c], [_, b0, c0]) = (self.coefficients, before.coefficients);
        [b - (b0 + 2.0 * c0 * (before.high - before.low)), c - c0]
    }

    pub(super) fn height(&self, r: f64) -> f64 {
        let x = r - self.low;
        let [a, b, c] = self.coefficients;
        self.start + x * (a + x * (0.5 * b + x * c / 3.0))
    }

    pub(super) fn slope(&self, r: f64) -> f64 {
        self.integrands(r - self.low)[0]
    }

    /// Whether z′ + r z″ is nowhere negative in it: a parabola in x, lowest at an end or at its vertex.
    pub(super) fn pushes_up(&self) -> bool {
        let width = self.high - self.low;
        let [_, b, c] = self.coefficients;
        let vertex = -(b + self.low * c) / (3.0 * c);
        let inner = if vertex > 0.0 && vertex < width { vertex } else { 0.0 };
        [0.0, inner, width].iter().all(|x| self.integrands(*x)[1] >= 0.0)
    }

    /// z′ and z′ + r z″ at x = r − low.
    fn integrands(&self, x: f64) -> [f64; 2] {
        let r = self.low + x;
        let [a, b, c] = self.coefficients;
        let slope = a + x * (b + x * c);
        [slope, slope + r * (b + 2.0 * x * c)]
    }

    /// ∫ of both over the part of the piece below s = base + beyond, over √(s² − r²), and of the magnitude of the second.
    fn integrals(&self, base: f64, beyond: f64) -> [f64; 3] {
        let s = base + beyond;
        // Distances from the ends, which rounding of s would spoil near a point.
        let [from_low, from_high] = [self.low, self.high].map(|end| (base - end) + beyond);
        if from_high >= FAR * (self.high - self.low) {
            // Node by node side by side: one does not wait for another.
            let over = self.nodes.map(|x| ((from_low - x) * (s + self.low + x)).sqrt().recip());
            let first = std::array::from_fn(|g| self.weighted[0][g] * over[g]);
            let second: Row = std::array::from_fn(|g| self.weighted[1][g] * over[g]);
            return [sum(&first), sum(&second), sum(&second.map(f64::abs))];
        }
        // By the root of the distance from s, in which the rest is smooth: a piece far narrower than its place keeps its digits.
        let [near, far] = [from_high.max(0.0), from_low].map(f64::sqrt);
        let parts = (WIDEST * (far - near) / ((2.0 * s).sqrt() - far)).ceil().max(1.0);
        let width = (far - near) / parts;
        let mut sums = [0.0; 3];
        for part in 0..parts as u32 {
            let squares: Row = std::array::from_fn(|g| (near + width * (f64::from(part) + UNIT_RULE_8[g].0)).powi(2));
            let over: Row = std::array::from_fn(|g| 2.0 * width * UNIT_RULE_8[g].1 * (2.0 * s - squares[g]).sqrt().recip());
            let values = squares.map(|square| self.integrands(from_low - square));
            let first = std::array::from_fn(|g| values[g][0] * over[g]);
            let second: Row = std::array::from_fn(|g| values[g][1] * over[g]);
            for (total, own) in sums.iter_mut().zip([sum(&first), sum(&second), sum(&second.map(f64::abs))]) {
                *total += own;
            }
        }
        sums
    }
}

/// f and f′ at s = base + beyond > 0 within the pieces, and the sum of the magnitudes of the terms of f′. Near a point, which is then the base, f′ goes as
/// the root of what lies beyond.
pub(super) fn line_profile(pieces: &[Piece], base: f64, beyond: f64) -> [f64; 3] {
    let [value, slope, size] = integrals(pieces, base, beyond);
    [(base + beyond) * value, slope, size]
}

/// f/s, f′ and the magnitudes of some pieces.
pub(super) fn integrals(pieces: &[Piece], base: f64, beyond: f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for piece in pieces.iter().take_while(|piece| (base - piece.low) + beyond > 0.0) {
        for (sum, value) in sums.iter_mut().zip(piece.integrals(base, beyond)) {
            *sum += value;
        }
    }
    sums
}
