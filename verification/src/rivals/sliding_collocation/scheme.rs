//! The scheme: a kernel, a mesh, and the three contacts of a closure.

use super::closures::{CollocatedClosures, window_work};
use super::contact::CollocatedContact;
use super::influence::influence_matrix;
use super::mesh::{Element, elements_between, mapped_nodes, widened};
use std::f64::consts::{PI, TAU};
use viscotack::refusal::{Refusal, require_finite, require_positive};
use viscotack::sliding::contact::{ArcPoint, Edge, Prescribed, WaveContact};
use viscotack::sliding::edge_balance::WaveAdhesion;
use viscotack::sliding::{HalfPlaneGreen, SlidingMemory};

/// How the moved contacts are meshed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// Each contact by its own mapped mesh, as the thesis.
    Mapped,
    /// The mesh of the contact, and its process zones by mapped meshes of their own.
    WindowAligned {
        /// Elements of each process zone.
        window_elements: usize,
    },
}

/// Collocation with piecewise-constant pressure at one sliding speed.
#[derive(Debug, Clone)]
pub struct SlidingCollocation {
    green: HalfPlaneGreen,
    layout: Layout,
    elements: usize,
    density: f64,
}

impl SlidingCollocation {
    /// N = `elements` per contact, with the mesh density exponent n = `density` of (3.32).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] when a mesh cannot be made of these numbers; passed on from [`HalfPlaneGreen::new`].
    pub fn new(memory: &SlidingMemory, layout: Layout, elements: usize, density: f64) -> Result<Self, Refusal> {
        mapped_nodes(1.0, elements, density)?;
        if let Layout::WindowAligned { window_elements } = layout {
            mapped_nodes(1.0, window_elements, density)?;
        }
        Ok(Self { green: HalfPlaneGreen::new(memory.clone())?, layout, elements, density })
    }

    /// The kernel.
    #[must_use]
    pub const fn green(&self) -> &HalfPlaneGreen {
        &self.green
    }

    /// A contact with given edges.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for edges outside 0 < a < π; [`Refusal::NotConverged`] for a singular system.
    pub fn contact(&self, contact: WaveContact, prescribed: Prescribed) -> Result<CollocatedContact, Refusal> {
        let elements = elements_between(&self.nodes(contact)?);
        let matrix = influence_matrix(&self.green, &elements)?;
        CollocatedContact::new(contact, elements, matrix.as_ref(), prescribed)
    }

    /// A contact with given edges, the two moved ones and the works at both edges.
    ///
    /// # Errors
    /// As [`SlidingCollocation::contact`]; [`Refusal::OutOfRange`] for a process zone that is not positive or reaches around the wave.
    pub fn closures(&self, adhesion: &WaveAdhesion, prescribed: Prescribed, contact: WaveContact) -> Result<CollocatedClosures, Refusal> {
        require_positive("trailing_zone", adhesion.trailing_zone)?;
        require_positive("leading_zone", adhesion.leading_zone)?;
        match self.layout {
            Layout::Mapped => self.mapped_closures(adhesion, prescribed, contact),
            Layout::WindowAligned { window_elements } => self.aligned_closures(adhesion, prescribed, contact, window_elements),
        }
    }

    fn mapped_closures(
        &self,
        adhesion: &WaveAdhesion,
        prescribed: Prescribed,
        contact: WaveContact,
    ) -> Result<CollocatedClosures, Refusal> {
        let old = self.contact(contact, prescribed)?;
        let held = Prescribed::Penetration(old.penetration());
        let moved = |trailing: f64, leading: f64| {
            let width = 2.0 * contact.half_width + trailing + leading;
            let nodes: Vec<ArcPoint> =
                mapped_nodes(width, self.elements, self.density)?.into_iter().map(|node| widened(node, -trailing, -leading)).collect();
            let elements = elements_between(&nodes);
            let matrix = influence_matrix(&self.green, &elements)?;
            CollocatedContact::new(contact, elements, matrix.as_ref(), held)
        };
        let trailing_moved = moved(adhesion.trailing_zone, 0.0)?;
        let leading_moved = moved(0.0, adhesion.leading_zone)?;
        let gap = |_: usize, element: &Element| old.gap(&self.green, element.middle);
        let trailing_work = window_work(&trailing_moved, Edge::Trailing, adhesion.trailing_zone, gap)?;
        let leading_work = window_work(&leading_moved, Edge::Leading, adhesion.leading_zone, gap)?;
        Ok(CollocatedClosures { contact: old, trailing_moved, leading_moved, trailing_work, leading_work })
    }

    /// One matrix serves the three contacts: its rows and columns are [trailing zone | contact | leading zone].
    fn aligned_closures(
        &self,
        adhesion: &WaveAdhesion,
        prescribed: Prescribed,
        contact: WaveContact,
        window: usize,
    ) -> Result<CollocatedClosures, Refusal> {
        let width = 2.0 * contact.half_width;
        if width + adhesion.trailing_zone + adhesion.leading_zone >= TAU {
            return Err(Refusal::out_of_range("half_width", contact.half_width, "below π with both process zones"));
        }
        let trailing_zone = mapped_nodes(adhesion.trailing_zone, window, self.density)?;
        let leading_zone = mapped_nodes(adhesion.leading_zone, window, self.density)?;
        let mut nodes: Vec<ArcPoint> = trailing_zone
            .iter()
            .take(window)
            .map(|node| ArcPoint { from_trailing: -node.from_leading, from_leading: width + node.from_leading })
            .collect();
        nodes.extend(self.nodes(contact)?);
        nodes.extend(
            leading_zone
                .iter()
                .skip(1)
                .map(|node| ArcPoint { from_trailing: width + node.from_trailing, from_leading: -node.from_trailing }),
        );
        let elements = elements_between(&nodes);
        let matrix = influence_matrix(&self.green, &elements)?;
        let solve = |first: usize, count: usize, prescribed: Prescribed| {
            let own: Vec<Element> = elements.iter().skip(first).take(count).copied().collect();
            CollocatedContact::new(contact, own, matrix.as_ref().submatrix(first, first, count, count), prescribed)
        };
        let old = solve(window, self.elements, prescribed)?;
        let held = Prescribed::Penetration(old.penetration());
        let trailing_moved = solve(0, window + self.elements, held)?;
        let leading_moved = solve(window, window + self.elements, held)?;
        // The gap of the old contact at the midpoint in a row of the matrix.
        let gap = |row: usize, element: &Element| {
            Ok(old.gap_by_row(element.middle, (window..window + self.elements).map(|column| matrix[(row, column)])))
        };
        let trailing_work = window_work(&trailing_moved, Edge::Trailing, adhesion.trailing_zone, gap)?;
        let leading_work =
            window_work(&leading_moved, Edge::Leading, adhesion.leading_zone, |index, element| gap(window + index, element))?;
        Ok(CollocatedClosures { contact: old, trailing_moved, leading_moved, trailing_work, leading_work })
    }

    fn nodes(&self, contact: WaveContact) -> Result<Vec<ArcPoint>, Refusal> {
        if !(contact.half_width > 0.0 && contact.half_width < PI) {
            return Err(Refusal::out_of_range("half_width", contact.half_width, "greater than 0 and below π (in 1/k)"));
        }
        require_finite("eccentricity", contact.eccentricity)?;
        mapped_nodes(2.0 * contact.half_width, self.elements, self.density)
    }
}
