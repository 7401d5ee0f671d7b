//! Why the work at a sliding edge is not the change of an energy: two forces on a body whose response is not symmetric (thesis Sec 1.4.2).
//!
//! ```text
//!     F₁ ↓      ↓ F₂          F_i = K_ij u_j,   K = Kᴱ + Kᴼ,   Kᴱ = ½(K + Kᵀ),   Kᴼ = ½(K − Kᵀ)
//!   ‾‾‾‾‾╲_____╱‾‾‾‾‾
//!   u₁ into the body, u₂       U = ½ F_i u_i = ½ Kᴱ_ij u_i u_j        δL = F_i δu_i = δU + δL_P,   δL_P = Kᴼ_ij u_j δu_i
//! ```
//! The energy U feels Kᴱ alone, and returns to its value around any closed path; the work does not. With κ = Kᴼ₁₂ = ½(K₁₂ − K₂₁),
//! δL_P = κ(u₂δu₁ − u₁δu₂): around a loop that runs from u₁ towards u₂, the work is −2κ times the area enclosed, whatever its form. In steady sliding
//! the two points are two places in the frame that moves with the indenter: the one that the material has passed remembers the force on the other, so
//! that K₁₂ ≠ K₂₁, and δL_P is the term that separates G from Δγ at each edge (3.13).
//!
//! Units: any consistent ones; stiffness = force/displacement. Exact, but for rounding of the order of the largest product.
//!
//! # Example
//! The loop 0 → (u₁, 0) → (u₁, u₂) → (0, u₂) → 0 of a body that is stiffer for one than for the other:
//! ```
//! use viscotack::sliding::nonconservative::TwoForces;
//!
//! let body = TwoForces { stiffness: [[3.0, 1.5], [0.5, 2.0]] };
//! let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 4.0], [0.0, 4.0]];
//! // The energy comes back, the work is −2·½(1.5 − 0.5)·(2·4).
//! assert_eq!(body.work_around(&corners), -8.0);
//! // The other way round it is gained.
//! let reversed = [[0.0, 0.0], [0.0, 4.0], [2.0, 4.0], [2.0, 0.0]];
//! assert_eq!(body.work_around(&reversed), 8.0);
//! // A symmetric body gives nothing and takes nothing.
//! let elastic = TwoForces { stiffness: [[3.0, 1.0], [1.0, 2.0]] };
//! assert_eq!(elastic.work_around(&corners), 0.0);
//! ```

/// A body that two forces press, by its stiffness K: F_i = K_ij u_j.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoForces {
    /// K, row by row.
    pub stiffness: [[f64; 2]; 2],
}

impl TwoForces {
    /// The two forces under two displacements.
    #[must_use]
    pub fn forces(&self, displacements: [f64; 2]) -> [f64; 2] {
        self.stiffness.map(|row| row[0] * displacements[0] + row[1] * displacements[1])
    }

    /// Kᴼ₁₂ = ½(K₁₂ − K₂₁): what is not symmetric in K.
    #[must_use]
    pub fn odd_stiffness(&self) -> f64 {
        0.5 * (self.stiffness[0][1] - self.stiffness[1][0])
    }

    /// U = ½ F_i u_i.
    #[must_use]
    pub fn energy(&self, displacements: [f64; 2]) -> f64 {
        let forces = self.forces(displacements);
        0.5 * (forces[0] * displacements[0] + forces[1] * displacements[1])
    }

    /// The work of both forces along a straight path: the mean of the forces at its ends on the displacement, which is exact as they are linear.
    #[must_use]
    pub fn work_along(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let (first, last) = (self.forces(from), self.forces(to));
        0.5 * ((first[0] + last[0]) * (to[0] - from[0]) + (first[1] + last[1]) * (to[1] - from[1]))
    }

    /// The work around a closed path through the corners, in their order and back to the first.
    #[must_use]
    pub fn work_around(&self, corners: &[[f64; 2]]) -> f64 {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&from, &to)| self.work_along(from, to)).sum()
    }
}
