//! Which contacts stay: the second variations, by differences of works that are evaluated anew at moved edges.
//!
//! ```text
//! M_ij = ∂(work_i/2πΓ_i)/∂l_j      at fixed p̄ (load), fixed Δ (penetration), fixed Δ + p̄/k_f (frame)
//! ```
//! Each is differentiated as it is held: the contact is solved at the held load, penetration or frame, no chain rule joins one to the other. Stable, whatever the
//! mobilities of the two edges: M₁₁ > 0, M₂₂ > 0, det M > 0.

use super::width::{Bodies, Equilibrium};
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactEdges, Prescribed};

/// Step of the differences over contact or gap.
const STEP: f64 = 2e-4;

/// What is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Held {
    /// p̄.
    Load,
    /// Δ.
    Penetration,
    /// Δ + p̄/k_f.
    Frame(f64),
}

/// The matrix and what it says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variations {
    /// M.
    pub matrix: [[f64; 2]; 2],
    /// det M over the sum of the sizes of its two products.
    pub determinant: f64,
}

impl Variations {
    /// By central differences of fourth order.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn new(bodies: &Bodies, contact: &Equilibrium, held: Held) -> Result<Self, Refusal> {
        let edges = ContactEdges::at_place(bodies.indenter, contact.place, contact.eccentricity);
        let step = STEP * edges.narrower();
        let at = |trailing: f64, leading: f64| -> Result<[f64; 2], Refusal> {
            let wider = 0.5 * (trailing + leading);
            let moved = ContactEdges {
                half_width: edges.half_width + wider,
                half_gap: edges.half_gap - wider,
                eccentricity: edges.eccentricity + 0.5 * (leading - trailing),
            };
            let prescribed = match held {
                Held::Load => Prescribed::MeanPressure(contact.mean_pressure),
                Held::Penetration => Prescribed::Penetration(contact.penetration),
                Held::Frame(stiffness) => {
                    // Δ is affine in p̄ at given edges.
                    let depth = |load: f64| bodies.works(moved, Prescribed::MeanPressure(load)).map(|works| works.penetration);
                    let (here, more) = (depth(contact.mean_pressure)?, depth(contact.mean_pressure + 1.0)?);
                    Prescribed::MeanPressure(contact.mean_pressure - (here - contact.penetration) / (more - here + 1.0 / stiffness))
                }
            };
            Ok(bodies.works(moved, prescribed)?.works)
        };
        let mut matrix = [[0.0; 2]; 2];
        for (times, weight) in [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)] {
            let (behind, ahead) = (at(times * step, 0.0)?, at(0.0, times * step)?);
            for row in 0..2 {
                matrix[row][0] += weight * behind[row] / step;
                matrix[row][1] += weight * ahead[row] / step;
            }
        }
        let (product, other) = (matrix[0][0] * matrix[1][1], matrix[0][1] * matrix[1][0]);
        Ok(Self { matrix, determinant: (product - other) / (product.abs() + other.abs()) })
    }

    /// The least of what must be positive, each over its size: below zero unstable, above stable.
    #[must_use]
    pub fn margin(&self) -> f64 {
        let size = self.matrix.iter().flatten().fold(0.0_f64, |size, value| size.max(value.abs()));
        (self.matrix[0][0] / size).min(self.matrix[1][1] / size).min(self.determinant)
    }

    /// The smaller diagonal entry over the size of all: below zero one edge alone becomes unstable, also where nothing turns.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        let size = self.matrix.iter().flatten().fold(0.0_f64, |size, value| size.max(value.abs()));
        self.matrix[0][0].min(self.matrix[1][1]) / size
    }
}
