//! First and second moment of the pressure of a parabola.
//!
//! ```text
//! p = β f₀ − Σ E_i u_i,  u = M_ε f:     ∫u yᵐ = ∫ f(ξ) Q_m(ξ) dξ,     Q₁ = ξ − ε,  Q₂ = ξ² − 2εξ + 2ε²              (as M_ε f(−a) = 0)
//!                                               = −∫ f(ξ) ∫_ξ^a yᵐ e^{(y−ξ)/ε} dy/ε dξ                            for layers longer than the contact
//! ```
//! The first form is closed, as f is made of X, y/X and 1/X; for ε ≫ a it would lose (ε/a)² digits, and the second takes its place.

use super::quadrature::{ArcRange, memory_integrals};
use super::state::ContactState;
use std::f64::consts::PI;

impl ContactState {
    /// ∫p y dy of a parabola.
    pub(super) fn first_moment(&self) -> f64 {
        self.moment(1)
    }

    /// ∫p y² dy of a parabola.
    pub(super) fn second_moment(&self) -> f64 {
        self.moment(2)
    }

    fn moment(&self, power: i32) -> f64 {
        let mut sum = self.memory.stiffening_ratio() * self.elastic_moment(self.strengths(None), power);
        for (term, mode) in self.memory.relaxation.iter().enumerate() {
            let (strengths, layer) = (self.strengths(Some(term)), mode.ratio);
            let of = |power: i32| self.elastic_moment(strengths, power);
            let remembered = if layer < 2.0 * self.edges.half_width {
                if power == 1 { of(1) - layer * of(0) } else { of(2) - 2.0 * layer * (of(1) - layer * of(0)) }
            } else {
                self.remembered_moment(strengths, layer, power)
            };
            sum -= mode.modulus * remembered;
        }
        sum
    }

    /// ∫f yᵐ with f = X − e y/X + flat/X + odd y/2X.
    fn elastic_moment(&self, (flat, odd): (f64, f64), power: i32) -> f64 {
        let (a, e) = (self.edges.half_width, self.edges.eccentricity);
        match power {
            0 => PI * (0.5 * a * a + flat),
            1 => PI * a * a * (0.25 * odd - 0.5 * e),
            _ => PI * a * a * (0.125 * a * a + 0.5 * flat),
        }
    }

    /// The second form.
    fn remembered_moment(&self, (flat, odd): (f64, f64), layer: f64, power: i32) -> f64 {
        let (a, e) = (self.edges.half_width, self.edges.eccentricity);
        let arc = ArcRange { length: 2.0 * a, before: f64::INFINITY, behind: f64::INFINITY, starts_at_edge: true };
        let rule = self.resolution.arc_rule();
        let [sum] = memory_integrals(arc, f64::INFINITY, self.resolution, |distance, rest| {
            let root = (distance * rest).sqrt();
            let position = if distance < rest { distance - a } else { a - rest };
            let field = root + (flat + (0.5 * odd - e) * position) / root;
            let kernel: f64 =
                rule.iter().map(|&(node, weight)| weight * (position + rest * node).powi(power) * (rest * node / layer).exp()).sum();
            [field * kernel * rest / layer]
        });
        -sum
    }
}
