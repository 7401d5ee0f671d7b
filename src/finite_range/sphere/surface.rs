//! The law of attraction on the tip: pressure, its slope and its work at a node, and what lies outside the mesh.

use std::f64::consts::TAU;

use super::kernel::unit_rule;
use super::tip::Shape;
use crate::finite_range::law::{Attraction, Law};
use crate::refusal::Refusal;

/// A node that touches the wall, or does not, is on its side by so much of h₀, at least.
pub(super) const HAIR: f64 = 1e-12;

/// Points of the rule for the attraction outside the mesh.
const TAIL_POINTS: usize = 16;

/// Gap and pressure as functions of one unknown u. Without a hard wall u is the gap. With one u − wall is the gap where it is positive
/// and minus the excess of pressure where it is negative: both gap and pressure are single-valued in u, so contact needs no search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Local {
    pub(super) gap: f64,
    pub(super) gap_slope: f64,
    pub(super) pressure: f64,
    pub(super) pressure_slope: f64,
}

/// The law with the shape of the tip.
#[derive(Clone)]
pub(super) struct Surface {
    law: Attraction,
    shape: Shape,
    wall: Option<f64>,
    /// The gap at the apex at penetration zero.
    rest: f64,
    rim: f64,
    /// Undeformed gaps at places outside the mesh, with the areas that they have there.
    outside: Vec<(f64, f64)>,
}

impl Surface {
    pub(super) fn new(law: Law, shape: Shape, rim: Option<f64>) -> Result<Self, Refusal> {
        let law = Attraction::new(law, 1.0, 1.0)?;
        let wall = law.wall();
        Ok(Self { rest: wall.unwrap_or(1.0), law, shape, rim: rim.unwrap_or(f64::INFINITY), wall, outside: Vec::new() })
    }

    /// The gap over the undeformed plane at penetration zero.
    pub(super) fn undeformed(&self, x: f64) -> f64 {
        self.rest + self.shape.height(x)
    }

    /// Gap, pressure and slopes at a value of the unknown.
    pub(super) fn at(&self, u: f64) -> Local {
        match self.wall {
            Some(wall) if u < wall => {
                Local { gap: wall, gap_slope: 0.0, pressure: self.law.stress(wall) + (wall - u), pressure_slope: -1.0 }
            }
            _ => Local { gap: u, gap_slope: 1.0, pressure: self.law.stress(u), pressure_slope: self.law.slope(u) },
        }
    }

    pub(super) fn gap(&self, u: f64) -> f64 {
        self.wall.map_or(u, |wall| u.max(wall))
    }

    /// The gap or, on a hard wall, what the excess of pressure would close of it over a unit length of a body that yields so much.
    pub(super) fn yielded(&self, u: f64, yielding: f64) -> f64 {
        match self.wall {
            Some(wall) if u < wall => wall + yielding * (u - wall),
            _ => u,
        }
    }

    pub(super) fn pressure(&self, u: f64) -> f64 {
        match self.wall {
            Some(wall) if u < wall => self.law.stress(wall) + (wall - u),
            _ => self.law.stress(u),
        }
    }

    /// The unknown at which the surface carries this compressive pressure (for first guesses).
    pub(super) fn compressed(&self, pressure: f64) -> f64 {
        match (&self.law.law, self.wall) {
            (_, Some(wall)) => wall - pressure + self.law.stress(wall),
            (Law::LennardJones, _) => (1.0 + 0.375 * pressure.max(0.0)).powf(-1.0 / 9.0),
            _ => pressure / self.law.slope(-1e-9).min(-1e-3),
        }
    }

    /// How far u may move in one correction.
    pub(super) fn reach(&self, u: f64) -> f64 {
        match self.law.law {
            Law::LennardJones => 0.3 * u,
            _ if self.wall.is_some() => f64::INFINITY,
            _ => 0.3 * u.abs().max(1.0),
        }
    }

    /// Whether contact is an inequality: its nodes change sides one Jacobian at a time.
    pub(super) fn has_wall(&self) -> bool {
        self.wall.is_some()
    }

    /// An open node: off the wall by a hair, at least.
    pub(super) fn opened(&self, u: f64) -> f64 {
        self.wall.map_or(u, |wall| u.max(wall + HAIR))
    }

    /// Whether a node touches the hard wall.
    pub(super) fn touches(&self, u: f64) -> bool {
        self.wall.is_some_and(|wall| u < wall)
    }

    /// The energy of the attraction per area at a gap: minus the work left.
    pub(super) fn interface(&self, u: f64) -> f64 {
        -self.law.work_left(self.gap(u))
    }

    /// The gap of the largest tension, by the law's own shape.
    pub(super) fn peak_gap(&self) -> f64 {
        self.law.peak_gap()
    }

    /// Says where the mesh ends.
    pub(super) fn set_outside(&mut self, radius: f64) {
        self.outside.clear();
        if self.ends_at(radius) {
            return;
        }
        let rule = unit_rule(TAIL_POINTS);
        let mut ends = vec![radius];
        ends.extend(self.shape.kinks_beyond(radius).into_iter().filter(|kink| *kink < self.rim));
        ends.push(self.rim);
        for pair in ends.windows(2) {
            // In s = beginning/x, so that the last piece may have no end.
            let (begin, last) = (pair[0], pair[0] / pair[1]);
            for &(part, weight) in &rule {
                let s = last + (1.0 - last) * part;
                let area = (1.0 - last) * weight * TAU * begin * begin / (s * s * s);
                self.outside.push((self.undeformed(begin / s), area));
            }
        }
    }

    /// Outside the mesh, where the body is not deformed: force, its derivative with respect to the penetration, interface energy.
    pub(super) fn outside(&self, penetration: f64) -> (f64, f64, f64) {
        let mut sums = (0.0, 0.0, 0.0);
        for &(undeformed, area) in &self.outside {
            let gap = undeformed - penetration;
            if gap > self.rest {
                sums.0 += area * self.law.stress(gap);
                sums.1 -= area * self.law.slope(gap);
                sums.2 -= area * self.law.work_left(gap);
            }
        }
        sums
    }

    /// The radius to which the tip is known, if it ends nowhere but in a table.
    pub(super) fn known_to(&self) -> Option<f64> {
        match &self.shape {
            Shape::Table(table) if self.rim.is_infinite() => Some(table.reach()),
            _ => None,
        }
    }

    /// Whether the tip ends at a radius.
    pub(super) fn ends_at(&self, radius: f64) -> bool {
        radius >= self.rim
    }

    /// Whether pressures may be without bound at one place: at the edge of a hard wall, where the law has a kink, or under a sharp apex.
    pub(super) fn is_singular(&self) -> bool {
        self.law.is_kinked() || self.shape.is_sharp()
    }
}
