//! Displacements of the surface under annuli of unit pressure (Eqs 4.15, 4.16).

use super::elliptic::complete_elliptic;
use faer::Mat;
use std::f64::consts::PI;

/// 𝒦(r, R): displacement at radius `place` of a half-space of unit modulus E* under unit pressure on a circle of radius `circle` (4.15).
#[must_use]
pub fn disk_displacement(place: f64, circle: f64) -> f64 {
    if place <= circle {
        let (_, second) = complete_elliptic(place / circle);
        4.0 / PI * circle * second
    } else {
        let ratio = circle / place;
        let (first, second) = complete_elliptic(ratio);
        4.0 / PI * place * (second - (1.0 - ratio) * (1.0 + ratio) * first)
    }
}

/// Where the displacement on annulus h is asked: r_0 = 0, r_q = qλ + λ/2.
pub(super) fn place(index: usize, width: f64) -> f64 {
    if index == 0 { 0.0 } else { (index as f64 + 0.5) * width }
}

/// G_hq of `count` annuli of one width, the first of them a circle (4.16).
#[must_use]
pub fn influence_matrix(count: usize, width: f64) -> Mat<f64> {
    let mut matrix = Mat::zeros(count, count);
    for row in 0..count {
        let r = place(row, width);
        let mut inner = 0.0;
        for column in 0..count {
            let outer = disk_displacement(r, (column as f64 + 1.0) * width);
            matrix[(row, column)] = outer - inner;
            inner = outer;
        }
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At the centre 2R, at the rim 4R/π, far away R²/r: Johnson, Contact Mechanics (1985), Sec 3.4.
    #[test]
    fn a_disk_presses_the_surface_down() {
        assert!((disk_displacement(0.0, 0.7) - 1.4).abs() < 1e-15);
        assert!((disk_displacement(0.7, 0.7) - 2.8 / PI).abs() < 1e-15);
        assert!((disk_displacement(700.0, 0.7) / (0.49 / 700.0) - 1.0).abs() < 1e-6);
    }
}
