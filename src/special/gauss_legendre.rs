//! One Gauss–Legendre rule on [0, 1], shared by every fixed-order quadrature of this crate.

use std::sync::LazyLock;

/// Number of nodes: exact for polynomials up to degree 31.
const NODES: usize = 16;

/// The nodes and weights on [0, 1], weights summing to one; nodes and weights from the `gauss-quad` crate.
pub static UNIT_RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let Some(nodes) = std::num::NonZeroUsize::new(NODES) else { return Vec::new() };
    let rule = gauss_quad::GaussLegendre::new(nodes);
    rule.iter().map(|&(node, weight)| (0.5 * (1.0 + node), 0.5 * weight)).collect()
});
