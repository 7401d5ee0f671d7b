//! Dense systems by `faer`: partial-pivot LU on one thread, checked here because `faer` reports no singular matrix.

use crate::refusal::Refusal;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::{Conj, Mat, MatRef, Par};

/// Largest residual over Σ|A||x| + |b|; a backward-stable solution leaves some 1e-14.
const LARGEST_RESIDUAL: f64 = 1e-11;

/// x with Ax = b for every column b of `sides`.
///
/// # Errors
/// [`Refusal::NotConverged`] if a component is not finite or the residual is not that of a backward-stable solution.
pub(super) fn solved(matrix: MatRef<'_, f64>, sides: MatRef<'_, f64>) -> Result<Mat<f64>, Refusal> {
    let what = "the dense system of a collocated contact";
    let count = matrix.nrows();
    if count == 0 || matrix.ncols() != count || sides.nrows() != count {
        return Err(Refusal::NotConverged { what, detail: "the system is not square".into() });
    }
    let mut factors = matrix.to_owned();
    let mut solution = sides.to_owned();
    let (mut forward, mut backward) = (vec![0_usize; count], vec![0_usize; count]);
    let parameters = Default::default();
    let factor_scratch = factor::lu_in_place_scratch::<usize, f64>(count, count, Par::Seq, parameters);
    let solve_scratch = solve::solve_in_place_scratch::<usize, f64>(count, sides.ncols(), Par::Seq);
    let mut buffer = MemBuffer::new(factor_scratch.or(solve_scratch));
    let stack = MemStack::new(&mut buffer);
    let (_, rows) = factor::lu_in_place(factors.as_mut(), &mut forward, &mut backward, Par::Seq, stack, parameters);
    solve::solve_in_place_with_conj(factors.as_ref(), factors.as_ref(), rows, Conj::No, solution.as_mut(), Par::Seq, stack);
    for side in 0..sides.ncols() {
        for row in 0..count {
            let (mut defect, mut scale) = (-sides[(row, side)], sides[(row, side)].abs());
            for column in 0..count {
                let term = matrix[(row, column)] * solution[(column, side)];
                defect += term;
                scale += term.abs();
            }
            // A NaN or an infinity fails this comparison too.
            if !(defect.abs() <= LARGEST_RESIDUAL * scale && scale.is_finite()) {
                let detail = format!("row {row} keeps a residual of {defect:.1e}: the matrix is singular to rounding");
                return Err(Refusal::NotConverged { what, detail });
            }
        }
    }
    Ok(solution)
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
