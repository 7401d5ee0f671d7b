//! Both closures of a collocated contact (thesis Secs 3.2, 3.3).
//!
//! ```text
//! (1/2δ) ∫ tension₊·gap₋  ≈  (1/2δ) Σ −p₊ h gap₋(ξ)     over the elements of the moved contact whose midpoint ξ is outside the old one
//! ```
//! The rule is the same for both layouts; only in a window-aligned one do those elements fill the process zone and nothing else.

use super::contact::CollocatedContact;
use super::mesh::Element;
use std::f64::consts::PI;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::Edge;
use viscotack::sliding::edge_balance::WaveAdhesion;

/// A contact, the two with an edge moved out at the same penetration, and the works at the edges.
#[derive(Debug, Clone)]
pub struct CollocatedClosures {
    /// The contact.
    pub contact: CollocatedContact,
    /// With the trailing edge moved out by its process zone.
    pub trailing_moved: CollocatedContact,
    /// With the leading edge moved out by its process zone.
    pub leading_moved: CollocatedContact,
    /// (1/2δ) ∫ tension₊·gap₋ of the trailing edge in E0*Λ²k/2; 2πΓ in equilibrium (3.25).
    pub trailing_work: f64,
    /// The same of the leading edge.
    pub leading_work: f64,
}

impl CollocatedClosures {
    /// G/Δγ of the (trailing, leading) edge: [U(moved) − U]/(2πΓδ), (3.21) and (3.22).
    #[must_use]
    pub fn releases(&self, adhesion: &WaveAdhesion) -> (f64, f64) {
        let work = self.contact.interface_work();
        let release = |moved: &CollocatedContact, of_edge: f64, zone: f64| (moved.interface_work() - work) / (2.0 * PI * of_edge * zone);
        (
            release(&self.trailing_moved, adhesion.trailing_work, adhesion.trailing_zone),
            release(&self.leading_moved, adhesion.leading_work, adhesion.leading_zone),
        )
    }
}

/// The work at an edge; `gap` is that of the old contact at the midpoint of an element of the moved one (index, element).
pub(super) fn window_work(
    moved: &CollocatedContact,
    edge: Edge,
    process_zone: f64,
    gap: impl Fn(usize, &Element) -> Result<f64, Refusal>,
) -> Result<f64, Refusal> {
    let mut work = 0.0;
    for (index, (element, pressure)) in moved.elements().iter().zip(moved.pressures()).enumerate() {
        let outside = match edge {
            Edge::Trailing => element.middle.from_trailing < 0.0,
            Edge::Leading => element.middle.from_leading < 0.0,
        };
        if outside {
            work -= pressure * element.width * gap(index, element)?;
        }
    }
    Ok(work / (2.0 * process_zone))
}
