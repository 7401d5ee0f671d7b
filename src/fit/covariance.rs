//! Covariance of the coordinates from the Jacobian of the residuals.

use super::least_squares::product;
use nalgebra::{DMatrix, SymmetricEigen};

/// Directions of which the data say less than this part of what they say of the best known one are not known at all.
const UNKNOWN: f64 = 1e-13;

/// (JᵀJ)⁻¹, with infinite variances where a column is zero, and zero covariances beside these.
pub(super) struct Covariance {
    pub(super) matrix: DMatrix<f64>,
}

impl Covariance {
    pub(super) fn of(jacobian: &[Vec<f64>], factor: f64) -> Self {
        let lengths: Vec<f64> = jacobian.iter().map(|column| product(column, column).sqrt()).collect();
        let known: Vec<usize> = (0..jacobian.len()).filter(|&place| lengths.get(place).is_some_and(|length| *length > 0.0)).collect();
        let column = |place: usize| jacobian.get(place).map_or(&[][..], Vec::as_slice);
        let length = |place: usize| lengths.get(place).copied().unwrap_or(1.0);
        let normal = DMatrix::from_fn(known.len(), known.len(), |i, j| {
            let (i, j) = (known.get(i).copied().unwrap_or(0), known.get(j).copied().unwrap_or(0));
            product(column(i), column(j)) / (length(i) * length(j))
        });
        let mut matrix = DMatrix::zeros(jacobian.len(), jacobian.len());
        for place in 0..jacobian.len() {
            matrix[(place, place)] = f64::INFINITY;
        }
        if known.is_empty() {
            return Self { matrix };
        }
        let eigen = SymmetricEigen::new(normal);
        let best = eigen.eigenvalues.max();
        let inverse = |i: usize, j: usize| -> f64 {
            (0..known.len())
                .map(|k| eigen.eigenvectors[(i, k)] * eigen.eigenvectors[(j, k)] / eigen.eigenvalues[k].max(UNKNOWN * best))
                .sum()
        };
        for (i, &row) in known.iter().enumerate() {
            for (j, &other) in known.iter().enumerate() {
                matrix[(row, other)] = factor * inverse(i, j) / (length(row) * length(other));
            }
        }
        Self { matrix }
    }

    pub(super) fn standard_error(&self, place: usize) -> f64 {
        self.matrix[(place, place)].sqrt()
    }

    pub(super) fn correlations(&self) -> Vec<Vec<f64>> {
        let count = self.matrix.nrows();
        let of = |i: usize, j: usize| {
            let scale = self.standard_error(i) * self.standard_error(j);
            if i == j {
                1.0
            } else if scale.is_finite() && scale > 0.0 {
                (self.matrix[(i, j)] / scale).clamp(-1.0, 1.0)
            } else {
                0.0
            }
        };
        (0..count).map(|i| (0..count).map(|j| of(i, j)).collect()).collect()
    }

    /// The direction of the largest variance, and its standard error; an unknown coordinate is that direction.
    pub(super) fn weakest(&self) -> (Vec<f64>, f64) {
        let count = self.matrix.nrows();
        if let Some(unknown) = (0..count).find(|&place| self.matrix[(place, place)].is_infinite()) {
            return ((0..count).map(|place| if place == unknown { 1.0 } else { 0.0 }).collect(), f64::INFINITY);
        }
        if count == 0 {
            return (Vec::new(), 0.0);
        }
        let eigen = SymmetricEigen::new(self.matrix.clone());
        let worst = eigen.eigenvalues.imax();
        (eigen.eigenvectors.column(worst).iter().copied().collect(), eigen.eigenvalues[worst].max(0.0).sqrt())
    }
}
