//! Integrals from an edge with an exponential memory and square-root ends.
//!
//! ```text
//! ∫₀^length e^{−d/scale} f(d, length − d) dd,      f like 1/√d at d = 0 and 1/√(length − d) at the other end
//! ```
//! The range is cut at 40 scales (e^{−40} = 4e-18) and mapped by d = cut·sin²(φ/2), which removes both roots; 16-point Gauss–Legendre panels in φ.

use crate::special::gauss_legendre::UNIT_RULE;
use std::f64::consts::PI;

/// Where e^{−d/scale} is below rounding.
const MEMORY_CUT: f64 = 40.0;
/// Panels in φ: 64 nodes leave 1e-15 of integrals whose exponential decays by e^{−40} (measured against four times as many).
const PANELS: usize = 4;

/// Adds `e^{−d/scale}·f` over the range; `f` gives several integrands at once.
pub(super) fn memory_integrals<const N: usize>(length: f64, scale: f64, mut f: impl FnMut(f64, f64) -> [f64; N]) -> [f64; N] {
    let cut = length.min(MEMORY_CUT * scale);
    let mut sums = [0.0; N];
    let width = PI / PANELS as f64;
    for panel in 0..PANELS {
        for &(node, weight) in UNIT_RULE.iter() {
            let half = 0.5 * width * (panel as f64 + node);
            let (sine, cosine) = half.sin_cos();
            let distance = cut * sine * sine;
            // dd = cut·sin(φ/2)cos(φ/2) dφ.
            let measure = weight * width * cut * sine * cosine * (-distance / scale).exp();
            let rest = (length - cut) + cut * cosine * cosine;
            for (sum, value) in sums.iter_mut().zip(f(distance, rest)) {
                *sum += measure * value;
            }
        }
    }
    sums
}
