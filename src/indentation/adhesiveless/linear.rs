//! Systems of as many equations as a panel has nodes.

use super::drive::DEGREE;

/// A number for each node but the first, which is the start.
pub(super) type Row = [f64; DEGREE];
pub(super) type Square = [Row; DEGREE];

/// Gauss' elimination with the largest pivots of each column.
pub(super) fn solved(mut matrix: Square, mut right: Row) -> Row {
    for k in 0..DEGREE {
        let pivot = (k..DEGREE).max_by(|one, other| matrix[*one][k].abs().total_cmp(&matrix[*other][k].abs())).unwrap_or(k);
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let own = matrix[k];
        for row in k + 1..DEGREE {
            let factor = matrix[row][k] / own[k];
            for l in k..DEGREE {
                matrix[row][l] -= factor * own[l];
            }
            right[row] -= factor * right[k];
        }
    }
    for k in (0..DEGREE).rev() {
        for l in k + 1..DEGREE {
            right[k] -= matrix[k][l] * right[l];
        }
        right[k] /= matrix[k][k];
    }
    right
}
