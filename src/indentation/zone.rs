//! The kernel of the closure on the line, as a double Chebyshev series: [`super::zone_work`] says what for.

use super::elliptic::elliptic_k_of;
use super::panel::POINTS;
use super::row::{Row, add_product, sum};
use crate::refusal::Refusal;
use pulp::{Simd, WithSimd};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Most and fewest Chebyshev terms; 1e-14 of k for a ≥ 1.9δ, 1e-9 at 1.2δ.
const TERMS: (usize, usize) = (4, 24);
/// The most: whole rows.
pub(super) const MOST_TERMS: usize = TERMS.1;
const ROWS: usize = MOST_TERMS / POINTS;

/// A function of ξ or η at Chebyshev's points on 0…1, in rows.
type Sampled = [Row; ROWS];

/// Chebyshev's points on 0…1 for a number of terms, and the discrete cosine transform that takes values there to coefficients.
struct Transform {
    points: Sampled,
    /// Row p: the factors of the values that give the coefficient of T_p.
    coefficients: [Sampled; MOST_TERMS],
}

static TRANSFORMS: LazyLock<Vec<Transform>> = LazyLock::new(|| (0..=MOST_TERMS).map(Transform::new).collect());

impl Transform {
    fn new(terms: usize) -> Self {
        let count = terms as f64;
        let angle = |i: usize| PI * (i as f64 + 0.5) / count;
        let mut points = [[0.5; POINTS]; ROWS];
        let mut coefficients = [[[0.0; POINTS]; ROWS]; MOST_TERMS];
        for i in 0..terms {
            points[i / POINTS][i % POINTS] = 0.5 * (1.0 - angle(i).cos());
            // T_p at x = 2ξ − 1 = −cos(angle): cos(p(π − angle)).
            for (p, row) in coefficients.iter_mut().enumerate().take(terms) {
                let factor = if p == 0 { 1.0 } else { 2.0 } / count;
                row[i / POINTS][i % POINTS] = factor * (p as f64 * (PI - angle(i))).cos();
            }
        }
        Self { points, coefficients }
    }
}

/// The kernel of one edge position.
#[derive(Debug, Clone, PartialEq)]
pub struct Zone {
    pub(super) contact_radius: f64,
    pub(super) length: f64,
    pub(super) terms: usize,
    /// Chebyshev coefficients of k_ξ, row p for ξ, column q for η; of those with p + q ≥ `terms`, which are beyond rounding, none is used.
    pub(super) slope: Vec<f64>,
}

impl Zone {
    /// The kernel at a contact radius a > δ (m).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a ≤ δ, where the zone would reach the axis.
    pub fn new(contact_radius: f64, length: f64) -> Result<Self, Refusal> {
        let ratio = contact_radius / length;
        let larger = ratio > 1.0 && ratio.is_finite();
        if !larger {
            return Err(Refusal::out_of_range("contact_radius", contact_radius, "greater than the process zone"));
        }
        // The nearest singularity is s = 0, at ξ = a/δ: Chebyshev coefficients fall like (z + √(z² − 1))^{−p}, z = 2a/δ − 1.
        let z = 2.0 * ratio - 1.0;
        let terms = ((32.0 / z.acosh()).ceil() as usize + 1).clamp(TERMS.0, TERMS.1);
        let slope = pulp::Arch::new().dispatch(Slope { contact_radius, length, terms });
        Ok(Self { contact_radius, length, terms, slope })
    }
}

/// The arguments of [`slope`]: a closure would not be inlined where the wide instructions are.
pub(super) struct Slope {
    pub(super) contact_radius: f64,
    pub(super) length: f64,
    pub(super) terms: usize,
}

impl WithSimd for Slope {
    type Output = Vec<f64>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Vec<f64> {
        slope(simd, self.contact_radius, self.length, self.terms)
    }
}

/// Coefficients of k_ξ.
#[inline(always)]
fn slope<S: Simd>(simd: S, contact_radius: f64, length: f64, terms: usize) -> Vec<f64> {
    let transform = &TRANSFORMS[terms];
    let rows = terms.div_ceil(POINTS);
    let mut table: [Sampled; MOST_TERMS] = [[[0.0; POINTS]; ROWS]; MOST_TERMS];
    for (i, values) in table.iter_mut().enumerate().take(terms) {
        let xi = transform.points[i / POINTS][i % POINTS];
        let inside = contact_radius - length * xi;
        for (values, etas) in values.iter_mut().zip(&transform.points).take(rows) {
            let product = etas.map(|eta| inside * (contact_radius + length * eta));
            let m = std::array::from_fn(|g| {
                let distance = xi + etas[g];
                length * length * (1.0 - distance * distance) / (4.0 * product[g])
            });
            let k: Row = elliptic_k_of(m);
            *values = std::array::from_fn(|g| k[g] / product[g].sqrt());
        }
    }
    let mut slope = vec![0.0; terms * terms];
    for q in 0..terms {
        // The coefficient of T_q(η) at each ξ, then those of T_p(ξ) of it.
        let mut half: Sampled = [[0.0; POINTS]; ROWS];
        for (i, values) in table.iter().enumerate().take(terms) {
            half[i / POINTS][i % POINTS] = dot(simd, values, &transform.coefficients[q], rows);
        }
        // d/dξ = 2 d/dx, by the usual downward recursion.
        let mut derivative = [0.0; MOST_TERMS + 2];
        for p in (1..terms).rev() {
            derivative[p - 1] = derivative[p + 1] + 2.0 * p as f64 * dot(simd, &half, &transform.coefficients[p], rows);
        }
        derivative[0] *= 0.5;
        for p in 0..terms {
            slope[p * terms + q] = 2.0 * derivative[p];
        }
    }
    slope
}

#[inline(always)]
fn dot<S: Simd>(simd: S, first: &Sampled, second: &Sampled, rows: usize) -> f64 {
    let mut sums = [0.0; POINTS];
    for (first, second) in first.iter().zip(second).take(rows) {
        add_product(simd, &mut sums, first, second);
    }
    sum(&sums)
}
