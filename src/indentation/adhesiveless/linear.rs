//! Systems of as many equations as a panel has nodes.

use super::drive::DEGREE;

/// A number for each node but the first, which is the start.
pub(super) type Row = [f64; DEGREE];
pub(super) type Square = [Row; DEGREE];

/// The solution for one right side.
pub(super) fn solved(matrix: Square, right: Row) -> Row {
    eliminated(matrix, right.map(|value| [value])).map(|[value]| value)
}

/// Gauss' elimination with the largest pivots of each column, for several right sides at once: one in each column.
pub(super) fn eliminated<const COUNT: usize>(mut matrix: Square, mut right: [[f64; COUNT]; DEGREE]) -> [[f64; COUNT]; DEGREE] {
    for k in 0..DEGREE {
        let pivot = (k..DEGREE).max_by(|one, other| matrix[*one][k].abs().total_cmp(&matrix[*other][k].abs())).unwrap_or(k);
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let (own, own_right) = (matrix[k], right[k]);
        for row in k + 1..DEGREE {
            let factor = matrix[row][k] / own[k];
            subtract(&mut matrix[row], factor, &own);
            subtract(&mut right[row], factor, &own_right);
        }
    }
    for k in (0..DEGREE).rev() {
        let mut own = right[k];
        for l in k + 1..DEGREE {
            subtract(&mut own, matrix[k][l], &right[l]);
        }
        right[k] = own.map(|value| value / matrix[k][k]);
    }
    right
}

fn subtract<const COUNT: usize>(from: &mut [f64; COUNT], factor: f64, values: &[f64; COUNT]) {
    for (own, value) in from.iter_mut().zip(values) {
        *own -= factor * value;
    }
}

pub(super) fn transposed(matrix: &Square) -> Square {
    std::array::from_fn(|k| std::array::from_fn(|l| matrix[l][k]))
}
