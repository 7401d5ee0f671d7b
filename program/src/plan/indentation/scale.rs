//! From the numbers of a scene to coherent ones and back. In a reduced scene R = E0* = reference time = 1 are coherent already; what is measured in
//! πE0* (forces, pressures, Δγ, stiffness, energies, powers) carries a π.

use crate::scene::typed::{HistoryQuantity, Units};
use std::f64::consts::PI;

/// What one unit of the scene is in coherent units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    /// πE0*R² of a force, πE0* of a pressure, πE0*R of Δγ and of a stiffness, πE0*R³ of an energy: one number.
    pub(super) force: f64,
}

impl Scale {
    pub(super) fn new(units: Units) -> Self {
        Self { force: if units == Units::Reduced { PI } else { 1.0 } }
    }

    /// A value of a controlled quantity in coherent units.
    pub(super) fn coherent(&self, quantity: HistoryQuantity, value: f64) -> f64 {
        if quantity == HistoryQuantity::Force { value * self.force } else { value }
    }
}
