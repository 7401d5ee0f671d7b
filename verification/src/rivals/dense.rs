//! Dense systems by `faer`: partial-pivot LU on one thread, checked here because `faer` reports no singular matrix.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::{Conj, Mat, MatRef, Par};
use viscotack::refusal::Refusal;

/// Largest residual over Σ|A||x| + |b|; a backward-stable solution leaves some 1e-14.
const LARGEST_RESIDUAL: f64 = 1e-11;

const WHAT: &str = "the dense system of a rival";

/// A matrix and its LU factors, for many right-hand sides.
#[derive(Debug, Clone)]
pub(super) struct Factors {
    matrix: Mat<f64>,
    factors: Mat<f64>,
    forward: Vec<usize>,
    backward: Vec<usize>,
}

impl Factors {
    /// PA = LU.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] for a matrix that is empty or not square.
    pub(super) fn of(matrix: MatRef<'_, f64>) -> Result<Self, Refusal> {
        let count = matrix.nrows();
        if count == 0 || matrix.ncols() != count {
            return Err(Refusal::NotConverged { what: WHAT, detail: "the system is not square".into() });
        }
        let mut factors = matrix.to_owned();
        let (mut forward, mut backward) = (vec![0_usize; count], vec![0_usize; count]);
        let parameters = Default::default();
        let scratch = factor::lu_in_place_scratch::<usize, f64>(count, count, Par::Seq, parameters);
        let mut buffer = MemBuffer::new(scratch);
        factor::lu_in_place(factors.as_mut(), &mut forward, &mut backward, Par::Seq, MemStack::new(&mut buffer), parameters);
        Ok(Self { matrix: matrix.to_owned(), factors, forward, backward })
    }

    /// x with Ax = b for every column b of `sides`.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] if a component is not finite or the residual is not that of a backward-stable solution.
    pub(super) fn solved(&self, sides: MatRef<'_, f64>) -> Result<Mat<f64>, Refusal> {
        let count = self.matrix.nrows();
        if sides.nrows() != count {
            return Err(Refusal::NotConverged { what: WHAT, detail: "the right-hand side has another length".into() });
        }
        let mut solution = sides.to_owned();
        let rows = PermRef::new_checked(&self.forward, &self.backward, count);
        let mut buffer = MemBuffer::new(solve::solve_in_place_scratch::<usize, f64>(count, sides.ncols(), Par::Seq));
        let stack = MemStack::new(&mut buffer);
        solve::solve_in_place_with_conj(self.factors.as_ref(), self.factors.as_ref(), rows, Conj::No, solution.as_mut(), Par::Seq, stack);
        for side in 0..sides.ncols() {
            // Column by column, as the matrix is stored.
            let mut defects: Vec<(f64, f64)> = (0..count).map(|row| (-sides[(row, side)], sides[(row, side)].abs())).collect();
            for column in 0..count {
                let factor = solution[(column, side)];
                for (row, (defect, scale)) in defects.iter_mut().enumerate() {
                    let term = self.matrix[(row, column)] * factor;
                    *defect += term;
                    *scale += term.abs();
                }
            }
            for (row, (defect, scale)) in defects.into_iter().enumerate() {
                // A NaN or an infinity fails this comparison too.
                if !(defect.abs() <= LARGEST_RESIDUAL * scale && scale.is_finite()) {
                    let detail = format!("row {row} keeps a residual of {defect:.1e}: the matrix is singular to rounding");
                    return Err(Refusal::NotConverged { what: WHAT, detail });
                }
            }
        }
        Ok(solution)
    }
}

/// x with Ax = b for every column b of `sides`.
///
/// # Errors
/// [`Refusal::NotConverged`] as [`Factors::of`] and [`Factors::solved`].
pub(super) fn solved(matrix: MatRef<'_, f64>, sides: MatRef<'_, f64>) -> Result<Mat<f64>, Refusal> {
    Factors::of(matrix)?.solved(sides)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn a_regular_system_is_solved_and_a_singular_one_is_refused() {
        let side = Mat::from_fn(3, 1, |row, _| 1.0 + row as f64);
        let regular = Mat::from_fn(3, 3, |row, column| 1.0 / (1.0 + row as f64 + column as f64));
        let solution = solved(regular.as_ref(), side.as_ref()).unwrap();
        // The inverse of Hilbert's matrix is integer: (1, 2, 3) gives (27, −192, 210).
        for (row, exact) in [27.0, -192.0, 210.0].into_iter().enumerate() {
            assert!((solution[(row, 0)] - exact).abs() < 1e-10);
        }
        let singular = Mat::from_fn(3, 3, |row, _| row as f64);
        assert!(solved(singular.as_ref(), side.as_ref()).is_err());
        let poisoned = Mat::from_fn(3, 3, |row, column| if row == column { f64::NAN } else { 1.0 });
        assert!(solved(poisoned.as_ref(), side.as_ref()).is_err());
        assert!(solved(regular.as_ref().submatrix(0, 0, 2, 3), side.as_ref()).is_err());
    }
}
