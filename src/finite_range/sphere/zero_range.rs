//! The relaxed contact of zero range (JKR) on any tip, from which first guesses and the size of the mesh are taken:
//! Δ = f(a) − √(2πma), F = 2(a f(a) − ∫₀^a f ds)/m − √(8πa³/m), f the line profile; at a rim the contact grows no further, and Δ is free.

use std::f64::consts::PI;

use super::newton::Row;
use super::problem::Problem;
use super::tip::Shape;
use crate::continuation::bracket::halved;

/// The widest radius of a search.
const WIDEST: f64 = 1e100;

/// A contact of zero range on a tip.
pub(super) struct ZeroRange<'a> {
    shape: &'a Shape,
    rim: f64,
    /// m of a modulus.
    coupling: f64,
}

impl<'a> ZeroRange<'a> {
    /// On the tip of a problem, with so many times the relaxed compliance.
    pub(super) fn of(problem: &'a Problem, compliance: f64) -> Self {
        Self { shape: &problem.shape, rim: problem.rim.unwrap_or(f64::INFINITY), coupling: problem.tabor.powf(1.5) * compliance }
    }

    fn penetration(&self, a: f64) -> f64 {
        self.shape.line(a) - (2.0 * PI * self.coupling * a).sqrt()
    }

    /// The force at a radius and a penetration.
    fn force(&self, a: f64, penetration: f64) -> f64 {
        2.0 / self.coupling * (a * penetration - self.shape.volume(a))
    }

    /// The radius at which the penetration is least (`part` 1) or the force (3), both along the equilibria.
    fn least(&self, part: f64) -> f64 {
        let opening = part * (0.5 * PI * self.coupling).sqrt();
        self.radius(0.0, |a| self.shape.line_slope(a) * a.sqrt() - opening)
    }

    /// The radius, from one up to the rim, at which a rising quantity is zero.
    fn radius(&self, from: f64, rising: impl Fn(f64) -> f64) -> f64 {
        let mut high = (2.0 * from.max(1.0)).min(self.rim);
        while rising(high) < 0.0 && high < self.rim.min(WIDEST) {
            high = (2.0 * high).min(self.rim);
        }
        halved([from, high], |a| rising(a) < 0.0)[0]
    }

    /// The penetration at which the contact has a value of what is imposed.
    pub(super) fn depth(&self, row: Row) -> f64 {
        if row.force == 0.0 {
            return row.value / row.penetration;
        }
        let along = |a: f64| {
            let depth = self.penetration(a);
            row.penetration * depth + row.force * self.force(a, depth) - row.value
        };
        if self.rim.is_finite() && along(self.rim) < 0.0 {
            // The whole face touches, which is then a spring.
            let stiffness = 2.0 / self.coupling * self.rim;
            let volume = 2.0 / self.coupling * self.shape.volume(self.rim);
            return (row.value + row.force * volume) / (row.penetration + row.force * stiffness);
        }
        self.penetration(self.radius(self.least(3.0), along))
    }

    /// The larger radius at a penetration. None where there is no contact.
    pub(super) fn contact(&self, depth: f64) -> Option<f64> {
        let least = self.least(1.0);
        (self.penetration(least) <= depth).then(|| self.radius(least, |a| self.penetration(a) - depth))
    }

    /// The radius within which the undeformed tip is less high than a depth.
    pub(super) fn reach(&self, depth: f64) -> f64 {
        self.radius(0.0, |x| self.shape.height(x) - depth)
    }
}
