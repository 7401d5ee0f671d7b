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

use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, Indenter, Prescribed, WaveContact};
use crate::sliding::edge_balance::EdgeBalance;

/// Step of the central differences over contact or gap, whichever is narrower.
const STEP: f64 = 5e-4;
/// Longest step of the eccentricity.
const WIDEST_SHIFT: f64 = 0.05;
/// Rounding of the penetration's differences, over their size.
const DEPTH_ROUNDING: f64 = 1e-12;
/// A sign below this part of the terms that make it up is not resolved.
const UNRESOLVED: f64 = 1e-5;

/// Whether a contact stays where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// Any small move of the edges is undone.
    Stable,
    /// Some small move grows.
    Unstable,
    /// At a fold, or the sign is lost in rounding (very narrow contacts, very narrow gaps).
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
    /// ∂Δ/∂p̄ at fixed edges, in reduced units; positive.
    pub penetration_by_load: f64,
    /// Whether a penetration is defined: not of a parabola, whose fixed penetration is a fixed load.
    pub has_penetration: bool,
    /// The same by width and shift.
    even: Even,
}

/// How both works, their difference and the penetration follow half-width a, eccentricity e and mean pressure.
///
/// ```text
/// S = (work₁ + work₂)/4πΓ      D = (work₂ − work₁)/4πΓ      det M = S_a D_e − D_a S_e
/// ```
/// Near full contact both edges stand at the ends of one narrow gap and M is all but singular: what distinguishes the edges, D_e, is smaller than S_a by the
/// width of the gap squared. Formed of differences of its own it keeps its digits, which the entries of M lose.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Even {
    /// S by a, e, p̄.
    sum: [f64; 3],
    /// D.
    difference: [f64; 3],
    /// Δ.
    penetration: [f64; 3],
    /// What rounding leaves uncertain of S and D each.
    rounding: [f64; 3],
    /// Relative error of the resolution: what it makes of a sum it may make of a difference.
    digits: f64,
}

impl Even {
    /// Derivatives of S and D by a and e at the load, or with contact and frame of a compliance in series.
    fn held(&self, compliance: Option<f64>) -> [[f64; 2]; 2] {
        [self.sum, self.difference].map(|[wider, ahead, loaded]| match compliance {
            Some(compliance) => [wider - loaded * self.penetration[0] / compliance, ahead - loaded * self.penetration[1] / compliance],
            None => [wider, ahead],
        })
    }

    /// M.
    fn matrix(&self, compliance: Option<f64>) -> [[f64; 2]; 2] {
        let [[sum_wider, sum_ahead], [difference_wider, difference_ahead]] = self.held(compliance);
        let entries = |wider: f64, ahead: f64| [0.5 * (wider - ahead), 0.5 * (wider + ahead)];
        [
            entries(sum_wider - difference_wider, sum_ahead - difference_ahead),
            entries(sum_wider + difference_wider, sum_ahead + difference_ahead),
        ]
    }

    /// det M and the size below which its sign is not resolved.
    fn determinant(&self, compliance: Option<f64>) -> (f64, f64) {
        let [[sum_wider, sum_ahead], [difference_wider, difference_ahead]] = self.held(compliance);
        let mut errors = [self.rounding[0], self.rounding[1]];
        if let Some(compliance) = compliance {
            for (error, depth) in errors.iter_mut().zip(self.penetration) {
                *error += (self.rounding[2] + DEPTH_ROUNDING * (self.sum[2].abs() + self.difference[2].abs())) * (depth / compliance).abs();
            }
        }
        // Of a held penetration large terms cancel: the resolution counts by what they were.
        let [wider, ahead] = [0, 1].map(|index: usize| {
            let parts = self.sum.get(index).zip(self.penetration.get(index));
            parts.map_or(f64::NAN, |(sum, depth)| sum.abs() + compliance.map_or(0.0, |compliance| (self.sum[2] * depth / compliance).abs()))
        });
        let by_width = errors[0] + self.digits * wider;
        let by_shift = errors[1] + self.digits * (ahead + difference_ahead.abs());
        let sized = (sum_wider * difference_ahead).abs() + (difference_wider * sum_ahead).abs();
        let unresolved = (sum_wider.abs() + difference_wider.abs()) * by_shift + (sum_ahead.abs() + difference_ahead.abs()) * by_width;
        (sum_wider * difference_ahead - difference_wider * sum_ahead, unresolved.max(UNRESOLVED * sized))
    }
}

impl SecondVariations {
    /// By central differences about an equilibrium; thirteen evaluations.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn new(balance: &EdgeBalance, contact: WaveContact, pressure: f64, indenter: Indenter) -> Result<Self, Refusal> {
        let edges = ContactEdges::new(indenter, contact);
        let width = STEP * edges.narrower();
        // Across a narrow gap the pressure of the wave hardly changes: an eccentricity may be moved further, and has to be (fields are linear in cos e and sin e).
        let aside = match (indenter, balance.adhesion()) {
            (Indenter::Wave, Some(adhesion)) => {
                let tilts = (adhesion.larger_work() / (0.5 * edges.half_gap).tan()).sqrt() / edges.half_gap;
                (f64::EPSILON * tilts).powf(0.2).min(WIDEST_SHIFT)
            }
            _ => 0.0,
        };
        let shift = if edges.half_gap < edges.half_width { width.max(aside) } else { width };
        let here = balance.evaluate_edges(edges, Prescribed::MeanPressure(pressure))?;
        let load = STEP * (indenter.half_angle_scale(edges.half_width) * here.state.stiffness_at_contact() + pressure.abs());
        let at = |wider: f64, ahead: f64, more: f64| {
            let moved = ContactEdges {
                half_width: edges.half_width + wider,
                half_gap: edges.half_gap - wider,
                eccentricity: edges.eccentricity + ahead,
            };
            let found = balance.evaluate_edges(moved, Prescribed::MeanPressure(pressure + more))?;
            // Without adhesion the amplitude falls where a work would grow.
            let [trailing, leading] =
                found.smooth_residual().map(|residual| if balance.adhesion().is_some() { residual } else { -residual });
            // The separation has its own digits near full contact.
            let depth = if indenter == Indenter::Wave { -found.state.mean_separation() } else { found.state.penetration() };
            // The residual is the root of the work: half its change.
            Ok::<_, Refusal>([trailing + leading, leading - trailing, depth])
        };
        // Fourth order: (f(−2h) − 8f(−h) + 8f(h) − f(2h))/12h.
        let slope = |[wider, ahead, more]: [f64; 3], step: f64| -> Result<[f64; 3], Refusal> {
            let mut sum = [0.0; 3];
            for (times, weight) in [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)] {
                let there = at(times * wider, times * ahead, times * more)?;
                for (sum, value) in sum.iter_mut().zip(there) {
                    *sum += weight * value / step;
                }
            }
            Ok(sum)
        };
        let wider = slope([width, 0.0, 0.0], width)?;
        let ahead = slope([0.0, shift, 0.0], shift)?;
        let loaded = slope([0.0, 0.0, load], load)?;
        // The weights of a difference add up to 1.5 in size.
        let rounding = 1.5 * (here.rounding[0] + here.rounding[1]);
        let even = Even {
            sum: [wider[0], ahead[0], loaded[0]],
            difference: [wider[1], ahead[1], loaded[1]],
            penetration: [wider[2], ahead[2], loaded[2]],
            rounding: [rounding / width, rounding / shift, rounding / load],
            digits: balance.resolution().relative_error(),
        };
        // An edge moves out by one: half of it wider, and the middle by half of it to that side.
        let [trailing, leading] = even.matrix(None);
        Ok(Self {
            at_fixed_load: [trailing, leading],
            by_load: [loaded[0] - loaded[1], loaded[0] + loaded[1]],
            penetration_by_edges: [0.5 * (wider[2] - ahead[2]), 0.5 * (wider[2] + ahead[2])],
            penetration_by_load: loaded[2],
            has_penetration: indenter == Indenter::Wave,
            even,
        })
    }

    /// The compliance of contact and frame together; none of a held load.
    fn compliance(&self, frame_stiffness: f64) -> Option<f64> {
        (frame_stiffness > 0.0 && self.has_penetration).then(|| self.penetration_by_load + 1.0 / frame_stiffness)
    }

    /// The matrix in a frame of stiffness k_f (p̄ per Δ, in E0*k/2): zero for a held load, infinite for a held penetration.
    #[must_use]
    pub fn in_frame_matrix(&self, frame_stiffness: f64) -> [[f64; 2]; 2] {
        self.even.matrix(self.compliance(frame_stiffness))
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
        let (determinant, unresolved) = self.even.determinant(self.compliance(frame_stiffness));
        let entries = first.abs().max(second.abs()).max(third.abs()).max(fourth.abs());
        if [determinant, first, fourth].iter().any(|value| value.is_nan()) || determinant.abs() <= unresolved {
            Stability::Marginal
        } else if determinant < 0.0 || first < -UNRESOLVED * entries || fourth < -UNRESOLVED * entries {
            Stability::Unstable
        } else if first > UNRESOLVED * entries && fourth > UNRESOLVED * entries {
            Stability::Stable
        } else {
            Stability::Marginal
        }
    }

    /// Whether both edges taken alone are held, with the other one at rest: at a turn, whether a stable contact is next to it.
    #[must_use]
    pub(crate) fn each_edge_is_held(&self, frame_stiffness: f64) -> bool {
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
        let [at_load, at_penetration] = [0.0, f64::INFINITY].map(|stiffness| self.even.determinant(self.compliance(stiffness)).0);
        let softest = [(at_load, at_penetration), (load[0][0], held[0][0]), (load[1][1], held[1][1])]
            .into_iter()
            .filter(|&(at_load, at_penetration)| at_load < 0.0 && at_penetration > 0.0)
            .map(|(at_load, at_penetration)| -self.penetration_by_load * at_penetration / at_load)
            .fold(f64::INFINITY, f64::min);
        Some(1.0 / softest)
    }
}
