//! Anderson's acceleration: weights of the last paths such that the sum of their residuals is least.
//!
//! ```text
//! min ‖Σ α_k r_k‖,  Σ α_k = 1;   next = Σ α_k g_k,   r_k = g_k − x_k
//! ```

use super::super::gauss::solve;

/// Residuals that count, beside the last one.
pub(super) const WINDOW: usize = 4;
/// Sum of |α| beyond which residuals are so alike that their differences are noise.
const MOST_WEIGHT: f64 = 20.0;
/// Of the squared differences, so that alike ones do no harm.
const REGULAR: f64 = 1e-12;

/// The weights, of the last residuals in their order.
pub(super) fn weights(residuals: &[&[f64]]) -> Vec<f64> {
    let mut first = residuals.len().saturating_sub(WINDOW + 1);
    loop {
        let window = &residuals[first..];
        let found = of_all(window);
        let size: f64 = found.iter().map(|weight| weight.abs()).sum();
        if size.is_finite() && size <= MOST_WEIGHT || window.len() <= 1 {
            let mut weights = vec![0.0; first];
            weights.extend(found);
            return weights;
        }
        first += 1;
    }
}

fn of_all(residuals: &[&[f64]]) -> Vec<f64> {
    let Some((last, others)) = residuals.split_last() else { return Vec::new() };
    let n = others.len();
    let differences: Vec<Vec<f64>> = others.iter().map(|other| other.iter().zip(*last).map(|(one, now)| one - now).collect()).collect();
    let product = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
    let mut matrix = vec![0.0; n * n];
    let mut right: Vec<f64> = differences.iter().map(|difference| -product(difference, last)).collect();
    for i in 0..n {
        for j in 0..n {
            matrix[i * n + j] = product(&differences[i], &differences[j]);
        }
        matrix[i * n + i] *= 1.0 + REGULAR;
    }
    if !solve(&mut matrix, &mut right) {
        return vec![f64::INFINITY; n + 1];
    }
    let rest = 1.0 - right.iter().sum::<f64>();
    right.push(rest);
    right
}

/// How much farther the periodic path may be than a residual is large: the largest step over the change of the residual that it made.
pub(super) fn amplification(paths: &[Vec<f64>], residuals: &[Vec<f64>]) -> f64 {
    let distance = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let pairs = paths.windows(2).zip(residuals.windows(2));
    let ratio = pairs.map(|(path, residual)| distance(&path[0], &path[1]) / distance(&residual[0], &residual[1]));
    ratio.filter(|ratio| ratio.is_finite()).fold(1.0, f64::max)
}
