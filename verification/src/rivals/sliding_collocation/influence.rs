//! Displacements of midpoints per pressure of elements (thesis Eqs 3.35, 3.36 and the antiderivative below them).
//!
//! ```text
//! w(ξ_l) = Σ_q A_lq p_q,      A_lq = −∫_{z_{q−1}}^{z_q} 𝒢(ξ_l − η) dη = 𝒦(ξ_l − z_q) − 𝒦(ξ_l − z_{q−1})
//! ```
//! 𝒦 is [`HalfPlaneGreen::antiderivative`]: Clausen's integral for the glassy part and its memory integral for each creep term.

use super::mesh::{Element, separation};
use faer::Mat;
use viscotack::refusal::Refusal;
use viscotack::sliding::HalfPlaneGreen;
use viscotack::sliding::contact::ArcPoint;

/// The displacement (Λ per E0*kΛ/2) of one point under unit pressure on each element.
///
/// # Errors
/// [`Refusal::OutOfRange`] for positions that are not finite.
pub fn influence_row(green: &HalfPlaneGreen, point: ArcPoint, elements: &[Element]) -> Result<Vec<f64>, Refusal> {
    let mut row = Vec::with_capacity(elements.len());
    let mut before = match elements.first() {
        Some(first) => green.antiderivative(separation(point, first.low))?.value,
        None => return Ok(row),
    };
    for element in elements {
        let after = green.antiderivative(separation(point, element.high))?.value;
        row.push(after - before);
        before = after;
    }
    Ok(row)
}

/// A: row l the midpoint ξ_l, column q the element.
///
/// # Errors
/// As [`influence_row`].
pub(super) fn influence_matrix(green: &HalfPlaneGreen, elements: &[Element]) -> Result<Mat<f64>, Refusal> {
    let mut matrix = Mat::zeros(elements.len(), elements.len());
    for (index, element) in elements.iter().enumerate() {
        for (column, value) in influence_row(green, element.middle, elements)?.into_iter().enumerate() {
            matrix[(index, column)] = value;
        }
    }
    Ok(matrix)
}
