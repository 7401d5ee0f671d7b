//! Integrals along an arc, from one of its ends, with an exponential memory and square-root ends.
//!
//! ```text
//! ∫₀^length e^{−d/scale} f(d, length − d) dd,      f like 1/√d at d = 0 and 1/√(length − d) at the other end
//! ```
//! The variable is √d in the nearer half and √(length − d) in the farther one, which removes both roots; panels are no longer than three
//! times √scale, over which the exponential is smooth, and no longer than their distance to the nearest singularity outside the arc (the other
//! edge of the neighbouring arc). The range is cut where the memory is below the resolution.

use super::resolution::Resolution;

/// Longest panel in units of √scale.
const LONGEST_PANEL: f64 = 3.2;

/// An arc seen from the end where the integral starts.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcRange {
    /// Its length; infinite where there is no other end.
    pub(super) length: f64,
    /// Distance of the nearest singularity in front of the start.
    pub(super) before: f64,
    /// Distance of the nearest singularity behind the other end.
    pub(super) behind: f64,
    /// Whether the start itself is an edge, with a root; otherwise the range starts between two edges.
    pub(super) starts_at_edge: bool,
}

/// Adds `e^{−d/scale}·f(d, length − d)` over the arc; `f` gives several integrands at once.
pub(super) fn memory_integrals<const N: usize>(
    arc: ArcRange,
    scale: f64,
    resolution: Resolution,
    mut f: impl FnMut(f64, f64) -> [f64; N],
) -> [f64; N] {
    let mut sums = [0.0; N];
    let (cut, rule) = (resolution.memory_cut() * scale, resolution.arc_rule());
    let reaches_end = cut > 0.5 * arc.length;
    let near_end = if reaches_end { 0.5 * arc.length } else { cut };
    let add = |low: f64, high: f64, value: &mut dyn FnMut(f64, f64)| {
        for &(node, weight) in rule {
            let t = low + (high - low) * node;
            // dd = 2t dt.
            value(t, 2.0 * t * weight * (high - low));
        }
    };
    for_panels(near_end, arc.before, scale, arc.starts_at_edge, |low, high| {
        add(low, high, &mut |t, measure| {
            let distance = t * t;
            let weight = measure * (-distance / scale).exp();
            for (sum, value) in sums.iter_mut().zip(f(distance, arc.length - distance)) {
                *sum += weight * value;
            }
        });
    });
    if reaches_end {
        for_panels(0.5 * arc.length, arc.behind, scale, true, |low, high| {
            add(low, high, &mut |t, measure| {
                let rest = t * t;
                let distance = arc.length - rest;
                let weight = measure * (-distance / scale).exp();
                for (sum, value) in sums.iter_mut().zip(f(distance, rest)) {
                    *sum += weight * value;
                }
            });
        });
    }
    sums
}

/// Panels in t = √d from 0 to √end.
fn for_panels(end: f64, singularity: f64, scale: f64, at_edge: bool, mut panel: impl FnMut(f64, f64)) {
    let end = end.sqrt();
    let longest = LONGEST_PANEL * scale.sqrt();
    // An edge in front of a start that is no edge is a root at −singularity itself, a stronger one than beyond an edge.
    let near = if at_edge { singularity.sqrt() } else { 0.7 * singularity.sqrt() };
    let mut low = 0.0;
    while low < end {
        let step = longest.min(low.max(near));
        // No sliver at the end.
        let high = if low + 1.3 * step >= end { end } else { low + step };
        panel(low, high);
        low = high;
    }
}
