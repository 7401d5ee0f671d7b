//! Gauss–Legendre rules on [0, 1], shared by every fixed-order quadrature of this crate; nodes and weights from the `gauss-quad` crate.

use gauss_quad::FiniteAboveNegOneF64;
use std::sync::LazyLock;

/// Nodes with their weights; nodes rise. Gauss's rule of n nodes is exact for polynomials up to degree 2n − 1, and its weights sum to one.
pub type UnitRule = Vec<(f64, f64)>;

/// Sixteen nodes.
pub static UNIT_RULE: LazyLock<UnitRule> = LazyLock::new(|| rule(16));
/// Eight nodes.
pub static UNIT_RULE_8: LazyLock<UnitRule> = LazyLock::new(|| rule(8));
/// Twelve nodes.
pub(crate) static UNIT_RULE_12: LazyLock<UnitRule> = LazyLock::new(|| rule(12));
/// Twenty nodes.
pub static UNIT_RULE_20: LazyLock<UnitRule> = LazyLock::new(|| rule(20));

/// Rules of three, four and five nodes for what vanishes at both ends.
pub(crate) static VANISHING_RULES: LazyLock<[UnitRule; 3]> = LazyLock::new(|| [3, 4, 5].map(vanishing));

fn rule(nodes: usize) -> UnitRule {
    let Some(nodes) = std::num::NonZeroUsize::new(nodes) else { return Vec::new() };
    let rule = gauss_quad::GaussLegendre::new(nodes);
    on_unit(rule.iter().map(|&(node, weight)| (node, weight)))
}

/// Lobatto's rule without its ends, where the integrand is known to be zero: n nodes are exact up to degree 2n + 1. The weights of the rule for (1 − x²)
/// are divided by 1 − x².
fn vanishing(nodes: usize) -> UnitRule {
    let (Some(nodes), Some(one)) = (std::num::NonZeroUsize::new(nodes), FiniteAboveNegOneF64::new(1.0)) else { return Vec::new() };
    let rule = gauss_quad::GaussJacobi::new(nodes, one, one);
    on_unit(rule.iter().map(|&(node, weight)| (node, weight / ((1.0 - node) * (1.0 + node)))))
}

/// From [−1, 1] to [0, 1], in order.
fn on_unit(rule: impl Iterator<Item = (f64, f64)>) -> UnitRule {
    let mut nodes: UnitRule = rule.map(|(node, weight)| (0.5 * (1.0 + node), 0.5 * weight)).collect();
    nodes.sort_by(|first, second| first.0.total_cmp(&second.0));
    nodes
}

#[cfg(test)]
mod tests {
    use super::VANISHING_RULES;

    #[test]
    fn rules_for_vanishing_integrands_are_exact_to_their_degree() {
        for (n, rule) in (3_u32..).zip(VANISHING_RULES.iter()) {
            assert_eq!(rule.len(), n as usize);
            for power in 0..2 * n as i32 {
                // ∫ x (1 − x) xᵖ dx = 1/((p + 2)(p + 3)).
                let sum: f64 = rule.iter().map(|&(x, weight)| weight * (1.0 - x) * x.powi(power + 1)).sum();
                let exact = 1.0 / f64::from((power + 2) * (power + 3));
                assert!((sum - exact).abs() < 1e-15, "{n} nodes, power {power}: {sum} for {exact}");
            }
        }
    }
}
