//! Which contacts stay where they are: the second variations of the work at both edges.
//!
//! An edge that does more closure work than adhesion takes recedes, one that does less advances. So a contact stays if the work of each edge
//! grows as that edge advances, and no advance of both together escapes:
//! ```text
//! M_ij = ∂(work_i/2πΓ)/∂l_j      stable if M₁₁ > 0, M₂₂ > 0 and M₁₁M₂₂ − M₁₂M₂₁ > 0      i, j = trailing, leading
//! ```
//! (the matrix is not symmetric when sliding; these signs keep it stable whatever the mobilities of the two edges are). The determinant changes
//! sign exactly at the folds of what is held. A frame of stiffness k_f, p̄ per length, holds Δ + p̄/k_f:
//! ```text
//! M(k_f) = ∂W/∂l at fixed p̄ − ∂W/∂p̄ · ∂Δ/∂l / (∂Δ/∂p̄ + 1/k_f)          k_f → 0: load control, k_f → ∞: penetration control
//! ```
//! The works are those of steady sliding, so this is stability against moves that are slow on the scale of the passage over the contact.
//!
//! Source: thesis Sec 1.4 and 3.7 (signs of the second variation at both edges); the frame and the joint sign are our own.

use crate::continuation::two_unknowns::TwoResiduals;
use crate::refusal::Refusal;
use crate::sliding::contact::{Indenter, Prescribed, WaveContact};
use crate::sliding::edge_balance::EdgeBalance;

/// Step of the central differences over contact or gap, whichever is narrower.
const STEP: f64 = 5e-4;
/// A sign below this part of the terms that make it up is not told.
const UNTOLD: f64 = 1e-5;

/// Whether a contact stays where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// Any small move of the edges is undone.
    Stable,
    /// Some small move grows.
    Unstable,
    /// At a fold, to rounding.
    Marginal,
}

/// How the closure works of both edges follow the edges and the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondVariations {
    /// ∂(work_i/2πΓ)/∂l_j at fixed mean pressure (k), i, j = trailing, leading; lengths count outward from the crest.
    pub at_fixed_load: [[f64; 2]; 2],
    /// ∂(work_i/2πΓ)/∂p̄ at fixed edges.
    pub by_load: [f64; 2],
    /// ∂Δ/∂l_j at fixed mean pressure.
    pub penetration_by_edges: [f64; 2],
    /// ∂Δ/∂p̄ at fixed edges; positive.
    pub penetration_by_load: f64,
    /// Whether a penetration is defined: not of a parabola, whose fixed penetration is a fixed load.
    pub has_penetration: bool,
}

impl SecondVariations {
    /// By central differences about an equilibrium; twelve evaluations.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn new(balance: &EdgeBalance, contact: WaveContact, pressure: f64, indenter: Indenter) -> Result<Self, Refusal> {
        let WaveContact { half_width, eccentricity } = contact;
        let length = STEP * half_width.min(indenter.widest() - half_width);
        let load = STEP * (indenter.half_angle_scale(half_width) + pressure.abs());
        let at = |wider: f64, ahead: f64, more: f64| {
            let moved = WaveContact { half_width: half_width + wider, eccentricity: eccentricity + ahead };
            let found = balance.evaluate_at(moved, Prescribed::MeanPressure(pressure + more))?;
            let [trailing, leading] = found.residual();
            Ok::<_, Refusal>([trailing, leading, found.state.penetration()])
        };
        // Fourth order: (f(−2h) − 8f(−h) + 8f(h) − f(2h))/12h.
        let slope = |edges: [f64; 2], more: f64, step: f64| -> Result<[f64; 3], Refusal> {
            let mut sum = [0.0; 3];
            for (times, weight) in [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)] {
                let there = at(times * edges[0], times * edges[1], times * more)?;
                for (sum, value) in sum.iter_mut().zip(there) {
                    *sum += weight * value / step;
                }
            }
            Ok(sum)
        };
        // An edge moves out by h: half of it wider, and the middle by half of it to that side.
        let trailing = slope([0.5 * length, -0.5 * length], 0.0, length)?;
        let leading = slope([0.5 * length, 0.5 * length], 0.0, length)?;
        let loaded = slope([0.0, 0.0], load, load)?;
        // The residual is the root of the work: half its change.
        Ok(Self {
            at_fixed_load: [[2.0 * trailing[0], 2.0 * leading[0]], [2.0 * trailing[1], 2.0 * leading[1]]],
            by_load: [2.0 * loaded[0], 2.0 * loaded[1]],
            penetration_by_edges: [trailing[2], leading[2]],
            penetration_by_load: loaded[2],
            has_penetration: indenter == Indenter::Wave,
        })
    }

    /// The matrix in a frame of stiffness k_f (p̄ per Δ, in E0*k/2): zero for a held load, infinite for a held penetration.
    #[must_use]
    pub fn in_frame_matrix(&self, frame_stiffness: f64) -> [[f64; 2]; 2] {
        let mut matrix = self.at_fixed_load;
        if frame_stiffness > 0.0 && self.has_penetration {
            let compliance = self.penetration_by_load + 1.0 / frame_stiffness;
            for (row, by_load) in matrix.iter_mut().zip(self.by_load) {
                for (entry, by_edge) in row.iter_mut().zip(self.penetration_by_edges) {
                    *entry -= by_load * by_edge / compliance;
                }
            }
        }
        matrix
    }

    /// Under a held load.
    #[must_use]
    pub fn under_load(&self) -> Stability {
        self.in_frame(0.0)
    }

    /// Under a held penetration.
    #[must_use]
    pub fn under_penetration(&self) -> Stability {
        self.in_frame(f64::INFINITY)
    }

    /// In a frame of stiffness k_f (p̄ per Δ, in E0*k/2) that holds Δ + p̄/k_f.
    #[must_use]
    pub fn in_frame(&self, frame_stiffness: f64) -> Stability {
        let [[first, second], [third, fourth]] = self.in_frame_matrix(frame_stiffness);
        let determinant = first * fourth - second * third;
        let size = (first * fourth).abs() + (second * third).abs();
        let entries = first.abs().max(second.abs()).max(third.abs()).max(fourth.abs());
        if [determinant, first, fourth].iter().any(|value| value.is_nan()) || determinant.abs() <= UNTOLD * size {
            Stability::Marginal
        } else if determinant < 0.0 || first < -UNTOLD * entries || fourth < -UNTOLD * entries {
            Stability::Unstable
        } else if first > UNTOLD * entries && fourth > UNTOLD * entries {
            Stability::Stable
        } else {
            Stability::Marginal
        }
    }

    /// Whether both edges taken alone are held, with the other one at rest: at a turn, whether a stable contact is next to it.
    #[must_use]
    pub fn each_edge_is_held(&self, frame_stiffness: f64) -> bool {
        let [[first, _], [_, fourth]] = self.in_frame_matrix(frame_stiffness);
        first > 0.0 && fourth > 0.0
    }

    /// The softest frame (p̄ per Δ, in E0*k/2) that holds the contact: zero if a held load does; none if not even a held penetration does.
    ///
    /// A sliding contact that a load holds need not be held by a stiff frame: there is no energy that would order the two.
    #[must_use]
    pub fn softest_frame(&self) -> Option<f64> {
        if self.under_load() == Stability::Stable {
            return Some(0.0);
        }
        if !self.has_penetration || self.under_penetration() != Stability::Stable {
            return None;
        }
        // (∂Δ/∂p̄ + c)·det is linear in the compliance c of the frame; the diagonal entries times the same are as well.
        let load = self.at_fixed_load;
        let held = self.in_frame_matrix(f64::INFINITY);
        let determinant = |matrix: [[f64; 2]; 2]| matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
        let softest = [(determinant(load), determinant(held)), (load[0][0], held[0][0]), (load[1][1], held[1][1])]
            .into_iter()
            .filter(|&(at_load, at_penetration)| at_load < 0.0 && at_penetration > 0.0)
            .map(|(at_load, at_penetration)| -self.penetration_by_load * at_penetration / at_load)
            .fold(f64::INFINITY, f64::min);
        Some(1.0 / softest)
    }
}
