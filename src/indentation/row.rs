//! Eight numbers, one for each node of a panel, and what is done to all of them at once.
//!
//! Everything here is a product, a sum, a quotient or a root of two numbers, in an order that the source fixes: any set of vector instructions gives the same digits.

use super::panel::{POINTS, RULE};
use pulp::Simd;

/// A number for each node of a panel.
pub(super) type Row = [f64; POINTS];

/// `sum` + `factor`·`row`.
#[inline(always)]
pub(super) fn add_scaled<S: Simd>(simd: S, sum: &mut Row, factor: f64, row: &Row) {
    let factor = simd.splat_f64s(factor);
    for (sum, value) in S::as_mut_simd_f64s(sum).0.iter_mut().zip(S::as_simd_f64s(row).0) {
        *sum = simd.add_f64s(*sum, simd.mul_f64s(factor, *value));
    }
}

/// `sum` + `first`·`second`.
#[inline(always)]
pub(super) fn add_product<S: Simd>(simd: S, sum: &mut Row, first: &Row, second: &Row) {
    let factors = S::as_simd_f64s(first).0.iter().zip(S::as_simd_f64s(second).0);
    for (sum, (first, second)) in S::as_mut_simd_f64s(sum).0.iter_mut().zip(factors) {
        *sum = simd.add_f64s(*sum, simd.mul_f64s(*first, *second));
    }
}

/// `first`·`second`.
#[inline(always)]
pub(super) fn product<S: Simd>(simd: S, first: &Row, second: &Row) -> Row {
    let mut product = *first;
    for (first, second) in S::as_mut_simd_f64s(&mut product).0.iter_mut().zip(S::as_simd_f64s(second).0) {
        *first = simd.mul_f64s(*first, *second);
    }
    product
}

/// `row` − `less`.
#[inline(always)]
pub(super) fn less<S: Simd>(simd: S, row: &Row, less: f64) -> Row {
    let less = simd.splat_f64s(less);
    let mut difference = *row;
    for value in S::as_mut_simd_f64s(&mut difference).0 {
        *value = simd.sub_f64s(*value, less);
    }
    difference
}

/// The sum of a row, in pairs.
#[inline(always)]
pub(super) fn sum(row: &Row) -> f64 {
    let [a, b, c, d, e, f, g, h] = *row;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

/// The next of Chebyshev's polynomials at x from the last two: 2xT_p − T_{p−1}.
#[inline(always)]
pub(super) fn next_chebyshev<S: Simd>(simd: S, twice_x: &Row, here: &Row, last: &Row) -> Row {
    let mut next = product(simd, twice_x, here);
    for (next, last) in S::as_mut_simd_f64s(&mut next).0.iter_mut().zip(S::as_simd_f64s(last).0) {
        *next = simd.sub_f64s(*next, *last);
    }
    next
}

/// The interpolant of `values` at the nodes of a panel at eight other places x (0…1 inside): Lagrange's products, without a division.
#[inline(always)]
pub(super) fn interpolated<S: Simd>(simd: S, values: &Row, places: &Row) -> Row {
    let rule = &*RULE;
    let mut before = [[1.0; POINTS]; POINTS];
    for k in 1..POINTS {
        before[k] = product(simd, &before[k - 1], &less(simd, places, rule.nodes[k - 1]));
    }
    let (mut sum, mut after) = ([0.0; POINTS], [1.0; POINTS]);
    for k in (0..POINTS).rev() {
        add_scaled(simd, &mut sum, rule.lagrange[k] * values[k], &product(simd, &before[k], &after));
        after = product(simd, &after, &less(simd, places, rule.nodes[k]));
    }
    sum
}
