//! The integrals along both arcs that the linear system of a contact is made of.

use super::arcs::{Arcs, Place};
use super::edges::ContactEdges;
use super::fields::ArcPoint;
use super::indenter::inverse_hyperbolic_sine;
use super::quadrature::{ArcRange, memory_integrals};
use super::resolution::Resolution;
use nalgebra::DMatrix;

/// Integrals over the gap with the memory of one creep term.
#[derive(Debug, Clone)]
pub(super) struct OutsideIntegrals {
    pub(super) cosine: f64,
    pub(super) sine: f64,
    pub(super) depth: f64,
    pub(super) root_cosine: f64,
    pub(super) root_sine: f64,
}

/// M_ε at the trailing edge of H₀, H₁, W and −S.
pub(super) struct InsideIntegrals {
    pub(super) flat: f64,
    pub(super) odd: f64,
    pub(super) wave: f64,
    pub(super) slope: f64,
}

/// The integrals over the contact with the memory of one relaxation term, from its trailing edge.
pub(super) fn inside_integrals(arcs: &Arcs, edges: ContactEdges, ratio: f64, resolution: Resolution) -> InsideIntegrals {
    let (gap, indenter) = (2.0 * edges.half_gap, arcs.indenter);
    let arc = ArcRange { length: 2.0 * edges.half_width, before: gap, behind: gap, starts_at_edge: true };
    let [flat, odd, wave, slope] = memory_integrals(arc, ratio, resolution, |from_trailing, from_leading| {
        let Place { root, angle } = arcs.inside(ArcPoint { from_trailing, from_leading });
        let [flat, odd, wave] = indenter.pressures(angle, root, (0.0, 1.0));
        [flat, odd, wave, -indenter.slope(angle, root)].map(|value| value / ratio)
    });
    InsideIntegrals { flat, odd, wave, slope }
}

/// The integrals over the gap with e^{−v/ζ}, v the distance behind the trailing edge.
///
/// The depth D of H₀ vanishes at both edges and has D' = −cos(y/2)/|X|, so that ∫e^{−v/ζ}D = −ζ∫e^{−v/ζ}cos(y/2)/|X|. The second integral is the cheaper one; where the
/// memory is longer than the gap it would cancel, and the first takes its place.
pub(super) fn outside_integrals(arcs: &Arcs, edges: ContactEdges, ratio: f64, resolution: Resolution) -> OutsideIntegrals {
    let width = 2.0 * edges.half_width;
    let arc = ArcRange { length: 2.0 * edges.half_gap, before: width, behind: width, starts_at_edge: true };
    let s = arcs.half.0;
    let place = |from_trailing, from_leading| arcs.outside(ArcPoint { from_trailing, from_leading });
    if ratio < arc.length {
        let [cosine, sine, root_cosine, root_sine] = memory_integrals(arc, ratio, resolution, |from_trailing, from_leading| {
            let Place { root, angle: (sine, cosine) } = place(from_trailing, from_leading);
            [cosine / root, sine / root, root * cosine, root * sine]
        });
        OutsideIntegrals { cosine, sine, depth: -ratio * cosine, root_cosine, root_sine }
    } else {
        let [depth, sine, root_cosine, root_sine] = memory_integrals(arc, ratio, resolution, |from_trailing, from_leading| {
            let Place { root, angle: (sine, cosine) } = place(from_trailing, from_leading);
            [inverse_hyperbolic_sine(0.5 * root / s), sine / root, root * cosine, root * sine]
        });
        OutsideIntegrals { cosine: -depth / ratio, sine, depth, root_cosine, root_sine }
    }
}

/// 1-norm condition number by the explicit inverse: n is at most some twenty.
pub(super) fn condition_number(matrix: &DMatrix<f64>) -> f64 {
    let norm = |matrix: &DMatrix<f64>| matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max);
    if matrix.is_empty() { 1.0 } else { matrix.clone().try_inverse().map_or(f64::INFINITY, |inverse| norm(matrix) * norm(&inverse)) }
}
