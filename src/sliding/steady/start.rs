//! Where a contact is solved from.

use crate::continuation::two_unknowns::Jacobian;

/// A contact from which one like it is found in a few steps: both unknowns, and how the edge conditions follow them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    pub(in crate::sliding) unknowns: [f64; 2],
    pub(in crate::sliding) jacobian: Option<Jacobian>,
}

impl Start {
    /// At given edges; at a prescribed half-width `first` is the mean pressure.
    #[must_use]
    pub const fn at(first: f64, eccentricity: f64) -> Self {
        Self { unknowns: [first, eccentricity], jacobian: None }
    }
}
