//! Gauss–Legendre rules on [0, 1], shared by every fixed-order quadrature of this crate; nodes and weights from the `gauss-quad` crate.

use std::sync::LazyLock;

/// A rule of n nodes is exact for polynomials up to degree 2n − 1; nodes rise, weights sum to one.
pub type UnitRule = Vec<(f64, f64)>;

/// Sixteen nodes.
pub static UNIT_RULE: LazyLock<UnitRule> = LazyLock::new(|| rule(16));
/// Eight nodes.
pub static UNIT_RULE_8: LazyLock<UnitRule> = LazyLock::new(|| rule(8));
/// Twelve nodes.
pub static UNIT_RULE_12: LazyLock<UnitRule> = LazyLock::new(|| rule(12));
/// Twenty nodes.
pub static UNIT_RULE_20: LazyLock<UnitRule> = LazyLock::new(|| rule(20));

fn rule(nodes: usize) -> UnitRule {
    let Some(nodes) = std::num::NonZeroUsize::new(nodes) else { return Vec::new() };
    let rule = gauss_quad::GaussLegendre::new(nodes);
    let mut nodes: UnitRule = rule.iter().map(|&(node, weight)| (0.5 * (1.0 + node), 0.5 * weight)).collect();
    nodes.sort_by(|first, second| first.0.total_cmp(&second.0));
    nodes
}
