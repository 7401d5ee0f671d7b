//! A function on a panel of the line by its values at eight Gauss nodes: integral, interpolation, running integral.

use super::row::Row;
use crate::special::gauss_legendre::UNIT_RULE_8;
use std::sync::LazyLock;

/// Nodes of a panel: polynomials up to degree 7 are kept exactly, their squares are integrated exactly.
pub const POINTS: usize = 8;

/// Nodes on 0…1, weights, factors of Lagrange's polynomials, and running[l][g] = ∫₀^{x_g} of the l-th Lagrange polynomial.
pub(super) struct Rule {
    pub(super) nodes: Row,
    pub(super) weights: Row,
    /// 1/Π(x_i − x_k).
    pub(super) lagrange: Row,
    pub(super) running: [Row; POINTS],
    /// slopes[g][l] = the slope of the l-th Lagrange polynomial at x_g.
    slopes: [Row; POINTS],
}

pub(super) static RULE: LazyLock<Rule> = LazyLock::new(|| {
    let nodes: [f64; POINTS] = std::array::from_fn(|i| UNIT_RULE_8.get(i).map_or(f64::NAN, |pair| pair.0));
    let weights: [f64; POINTS] = std::array::from_fn(|i| UNIT_RULE_8.get(i).map_or(f64::NAN, |pair| pair.1));
    let factors = std::array::from_fn(|i| (0..POINTS).filter(|&k| k != i).map(|k| 1.0 / (nodes[i] - nodes[k])).product::<f64>());
    let lagrange = |l: usize, x: f64| (0..POINTS).filter(|&k| k != l).map(|k| (x - nodes[k]) / (nodes[l] - nodes[k])).product::<f64>();
    let running = std::array::from_fn(|l| {
        std::array::from_fn(|g| (0..POINTS).map(|q| weights[q] * nodes[g] * lagrange(l, nodes[g] * nodes[q])).sum::<f64>())
    });
    // Of the own node from the others: a constant has no slope.
    let slopes = std::array::from_fn(|g| {
        let across = |l: usize| if l == g { 0.0 } else { factors[l] / factors[g] / (nodes[g] - nodes[l]) };
        let own = -(0..POINTS).map(across).sum::<f64>();
        std::array::from_fn(|l| if l == g { own } else { across(l) })
    });
    Rule { nodes, weights, lagrange: factors, running, slopes }
});

impl Rule {
    /// Factors of the values at the nodes that give the interpolant at x (0…1 inside): Lagrange's products, without a division.
    pub(super) fn interpolation(&self, x: f64) -> [f64; POINTS] {
        let mut factors = self.lagrange;
        let mut product = 1.0;
        for (factor, node) in factors.iter_mut().zip(&self.nodes) {
            *factor *= product;
            product *= x - node;
        }
        product = 1.0;
        for (factor, node) in factors.iter_mut().zip(&self.nodes).rev() {
            *factor *= product;
            product *= x - node;
        }
        factors
    }
}

/// A scalar on one panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panel {
    /// Left end (m).
    pub lower: f64,
    /// Right end (m).
    pub upper: f64,
    /// Values at the nodes, from left to right.
    pub values: Row,
}

impl Panel {
    /// A function sampled on a panel.
    #[must_use]
    pub fn sampled(lower: f64, upper: f64, function: impl Fn(f64) -> f64) -> Self {
        Self { lower, upper, values: RULE.nodes.map(|x| function(lower + (upper - lower) * x)) }
    }

    /// The interpolant at s.
    #[must_use]
    pub fn at(&self, s: f64) -> f64 {
        // The polynomial goes on a little beyond its panel, where rounding may put an edge; further out it means nothing.
        let factors = RULE.interpolation(((s - self.lower) / (self.upper - self.lower)).clamp(-1.0, 2.0));
        factors.iter().zip(&self.values).map(|(factor, value)| factor * value).sum()
    }

    /// The slope of the interpolant, which the same nodes keep.
    pub(super) fn slope(&self) -> Self {
        let width = self.upper - self.lower;
        let at = |row: &Row| row.iter().zip(&self.values).map(|(slope, value)| slope * value).sum::<f64>() / width;
        Self { values: std::array::from_fn(|g| at(&RULE.slopes[g])), ..*self }
    }

    /// The interpolant at an end of the panel, and by how much it would differ without the node furthest from there.
    pub(super) fn at_end(&self, s: f64) -> (f64, f64) {
        let value = self.at(s);
        let x = (s - self.lower) / (self.upper - self.lower);
        let far = if x > 0.5 { 0 } else { POINTS - 1 };
        let weight = |l: usize| {
            let others = (0..POINTS).filter(move |&k| k != l && k != far);
            others.map(|k| (x - RULE.nodes[k]) / (RULE.nodes[l] - RULE.nodes[k])).product::<f64>()
        };
        let fewer: f64 = (0..POINTS).filter(|&l| l != far).map(|l| weight(l) * self.values[l]).sum();
        (value, (value - fewer).abs())
    }

    /// ∫ over the panel.
    #[must_use]
    pub fn integral(&self) -> f64 {
        (self.upper - self.lower) * RULE.weights.iter().zip(&self.values).map(|(weight, value)| weight * value).sum::<f64>()
    }
}

/// The panel of an ordered list that holds s; the end panel beyond the ends.
pub(super) fn panel_at(panels: &[Panel], s: f64) -> Option<&Panel> {
    panels.get(panels.partition_point(|panel| panel.upper < s).min(panels.len().saturating_sub(1)))
}

/// The value at s of an ordered list of panels; the end panel is continued beyond the ends.
pub(super) fn value_at(panels: &[Panel], s: f64) -> f64 {
    panel_at(panels, s).map_or(0.0, |panel| panel.at(s))
}
