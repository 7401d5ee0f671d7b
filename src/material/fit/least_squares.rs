//! Linear least squares, free and with strengths that must not be negative.
//!
//! Source of the active set: Lawson and Hanson, *Solving Least Squares Problems* (1974), chapter 23. Here the columns are scaled to length
//! one and the whole problem is first reduced to its triangular factor, so that each step costs a small factorization however many data.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// A column whose gain is below this part of its length times the length of the data is at rounding.
const ROUNDING: f64 = 1e-14;

/// x of min ‖Ax − b‖ by Householder QR with column pivoting; none if a number of the answer is not finite.
pub(super) fn free(matrix: &Mat<f64>, right: &[f64]) -> Option<Vec<f64>> {
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
pub(super) fn damped(matrix: &Mat<f64>, right: &[f64]) -> Option<Vec<f64>> {
    let column = Mat::from_fn(right.len(), 1, |row, _| right[row]);
    finite(&matrix.qr().solve_lstsq(&column), matrix.ncols())
}

fn finite(solution: &Mat<f64>, rows: usize) -> Option<Vec<f64>> {
    let answer: Vec<f64> = (0..rows).map(|row| solution[(row, 0)]).collect();
    answer.iter().all(|value| value.is_finite()).then_some(answer)
}

/// x ≥ 0 of min ‖Ax − b‖.
pub(super) fn non_negative(matrix: &Mat<f64>, right: &[f64]) -> Vec<f64> {
    let (rows, columns) = (matrix.nrows(), matrix.ncols());
    let lengths: Vec<f64> = (0..columns).map(|j| (0..rows).map(|i| matrix[(i, j)].powi(2)).sum::<f64>().sqrt()).collect();
    // [A/lengths | b] → R: the same residuals up to the part of b that no column reaches.
    let whole = Mat::from_fn(rows, columns + 1, |i, j| {
        if j == columns {
            right[i]
        } else if lengths[j] > 0.0 {
            matrix[(i, j)] / lengths[j]
        } else {
            0.0
        }
    });
    let factor = whole.qr();
    let triangle = factor.thin_R();
    let small_rows = triangle.nrows();
    let column = |j: usize| (0..small_rows).map(move |i| triangle[(i, j)]);
    let data: Vec<f64> = column(columns).collect();
    let size = data.iter().map(|value| value * value).sum::<f64>().sqrt();
    let mut x = vec![0.0; columns];
    let mut passive: Vec<usize> = Vec::new();
    for _ in 0..10 * columns.max(10) {
        let mut residual = data.clone();
        for &j in &passive {
            for (rest, entry) in residual.iter_mut().zip(column(j)) {
                *rest -= entry * x[j];
            }
        }
        let gain = |j: usize| column(j).zip(&residual).map(|(entry, rest)| entry * rest).sum::<f64>();
        let best = (0..columns)
            .filter(|&j| lengths[j] > 0.0 && !passive.contains(&j))
            .map(|j| (gain(j), j))
            .max_by(|left, right| left.0.total_cmp(&right.0));
        let Some((_, entering)) = best.filter(|&(gain, _)| gain > ROUNDING * size) else { break };
        passive.push(entering);
        // Back from the free answer to the border, as often as it crosses it.
        while !passive.is_empty() {
            let part = Mat::from_fn(small_rows, passive.len(), |i, j| triangle[(i, passive[j])]);
            let Some(trial) = free(&part, &data) else {
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
