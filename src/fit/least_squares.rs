//! Linear least squares, free and with strengths that must not be negative.
//!
//! Source of the active set: Lawson and Hanson, *Solving Least Squares Problems* (1974), chapter 23. Here the columns are scaled to length
//! one and the whole problem is first reduced to its triangular factor, so that each step costs a small factorization however many data.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// A column whose gain is below this part of its length times the length of the data is at rounding.
const ROUNDING: f64 = 1e-14;

/// Columns of equal length as a matrix.
pub(crate) fn matrix<'a>(columns: impl ExactSizeIterator<Item = &'a [f64]>, rows: usize) -> Mat<f64> {
    let mut matrix = Mat::zeros(rows, columns.len());
    for (j, column) in columns.enumerate() {
        for (place, value) in matrix.col_as_slice_mut(j).iter_mut().zip(column) {
            *place = *value;
        }
    }
    matrix
}

/// Sum of the products of two columns.
pub(crate) fn product(left: &[f64], right: &[f64]) -> f64 {
    left.iter().zip(right).map(|(one, other)| one * other).sum()
}

/// The same least squares on few rows: the triangle of the columns, its columns.
pub(crate) fn reduced(columns: &[Vec<f64>], rows: usize) -> Vec<Vec<f64>> {
    if rows <= columns.len() {
        return columns.to_vec();
    }
    let factor = matrix(columns.iter().map(Vec::as_slice), rows).qr();
    let triangle = factor.thin_R().to_owned();
    (0..columns.len())
        .map(|j| triangle.col_as_slice(j).iter().enumerate().map(|(i, &value)| if i <= j { value } else { 0.0 }).collect())
        .collect()
}

/// x of min ‖Ax − b‖ by Householder QR with column pivoting; none if a number of the answer is not finite.
pub(crate) fn free(matrix: &Mat<f64>, right: &[f64]) -> Option<Vec<f64>> {
    if matrix.ncols() == 0 {
        return Some(Vec::new());
    }
    if matrix.nrows() < matrix.ncols() {
        return None;
    }
    let column = Mat::from_fn(right.len(), 1, |row, _| right[row]);
    finite(&matrix.col_piv_qr().solve_lstsq(&column), matrix.ncols())
}

/// The same without pivoting: for columns that are independent by their making, as damped ones are.
pub(crate) fn damped(matrix: &Mat<f64>, right: &[f64]) -> Option<Vec<f64>> {
    let column = Mat::from_fn(right.len(), 1, |row, _| right[row]);
    finite(&matrix.qr().solve_lstsq(&column), matrix.ncols())
}

fn finite(solution: &Mat<f64>, rows: usize) -> Option<Vec<f64>> {
    let answer: Vec<f64> = (0..rows).map(|row| solution[(row, 0)]).collect();
    answer.iter().all(|value| value.is_finite()).then_some(answer)
}

/// x ≥ 0 of min ‖Ax − b‖, A by its columns.
pub(crate) fn non_negative(given: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let columns = given.len();
    let lengths: Vec<f64> = given.iter().map(|column| product(column, column).sqrt()).collect();
    // [A/lengths | b] → R: the same residuals up to the part of b that no column reaches.
    let mut whole = matrix(given.iter().map(Vec::as_slice).chain(std::iter::once(right)).collect::<Vec<_>>().into_iter(), right.len());
    for (j, &length) in lengths.iter().enumerate().filter(|(_, length)| **length > 0.0) {
        whole.col_as_slice_mut(j).iter_mut().for_each(|value| *value /= length);
    }
    let factor = whole.qr();
    let triangle = factor.thin_R().to_owned();
    let small_rows = triangle.nrows();
    // Nothing stands below the diagonal.
    let column = |j: usize| triangle.col_as_slice(j).get(..small_rows.min(j + 1)).unwrap_or(&[]);
    let mut data = vec![0.0; small_rows];
    data.iter_mut().zip(column(columns)).for_each(|(place, value)| *place = *value);
    let size = product(&data, &data).sqrt();
    let mut x = vec![0.0; columns];
    let mut passive: Vec<usize> = Vec::new();
    for _ in 0..10 * columns.max(10) {
        let mut residual = data.clone();
        for &j in &passive {
            let strength = x[j];
            for (rest, entry) in residual.iter_mut().zip(column(j)) {
                *rest -= entry * strength;
            }
        }
        let gain = |j: usize| product(column(j), &residual);
        let best = (0..columns)
            .filter(|&j| lengths[j] > 0.0 && !passive.contains(&j))
            .map(|j| (gain(j), j))
            .max_by(|left, right| left.0.total_cmp(&right.0));
        let Some((_, entering)) = best.filter(|&(gain, _)| gain > ROUNDING * size) else { break };
        passive.push(entering);
        // Back from the free answer to the border, as often as it crosses it.
        while !passive.is_empty() {
            let reach = passive.iter().map(|&j| j + 1).max().unwrap_or(0).min(small_rows);
            let part = matrix(passive.iter().map(|&j| column(j)), reach);
            let Some(trial) = free(&part, data.get(..reach).unwrap_or(&data)) else {
                passive.pop();
                continue;
            };
            let crossing = passive
                .iter()
                .zip(&trial)
                .filter(|&(_, &value)| value <= 0.0)
                .map(|(&j, &value)| x[j] / (x[j] - value))
                .fold(1.0_f64, f64::min);
            if crossing >= 1.0 && trial.iter().all(|&value| value > 0.0) {
                for (&j, &value) in passive.iter().zip(&trial) {
                    x[j] = value;
                }
                break;
            }
            for (&j, &value) in passive.iter().zip(&trial) {
                x[j] += crossing * (value - x[j]);
            }
            let before = passive.len();
            passive.retain(|&j| x[j] > 0.0);
            if passive.len() == before {
                break;
            }
            for (j, value) in x.iter_mut().enumerate() {
                if !passive.contains(&j) {
                    *value = 0.0;
                }
            }
        }
        // The column that entered and left at once gains nothing but rounding.
        if !passive.contains(&entering) {
            break;
        }
    }
    x.iter().zip(&lengths).map(|(&value, &length)| if length > 0.0 { value / length } else { 0.0 }).collect()
}
