//! What one cycle of an oscillation turns out to be.

use super::convergence::Compared;
use crate::estimate::Estimate;
use serde::{Deserialize, Serialize};

/// Place of the drift among the quantities.
const DRIFT: usize = 10;

/// One whole cycle of a segment that oscillates; `T` is `f64` in one integration, [`Estimate`] in a solution.
///
/// Amplitudes are of the fundamental, x ≈ mean + in_phase·sin φ + quadrature·cos φ, φ the phase of what is controlled, with the straight line
/// between both ends of the cycle taken off first, so that a ramp beneath does not count.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cycle<T> {
    /// Which segment of the history, from 0.
    pub segment: usize,
    /// Which cycle of it, from 1.
    pub number: u64,
    /// Start and end (s).
    pub start: f64,
    /// End (s).
    pub end: f64,
    /// ∮F dΔ (J).
    pub work: T,
    /// Storage stiffness Re(F̂/Δ̂) (N/m).
    pub storage_stiffness: T,
    /// Loss stiffness Im(F̂/Δ̂) (N/m).
    pub loss_stiffness: T,
    /// Phase by which the force leads the penetration (rad).
    pub phase: T,
    /// Smallest and largest Δ (m).
    pub penetration: [T; 2],
    /// Smallest and largest F (N).
    pub force: [T; 2],
    /// Smallest and largest a (m).
    pub contact_radius: [T; 2],
    /// Largest change of mean, work and extremes against the cycle before, over their scales, carried on for the longest relaxation time: what
    /// the cycles may still drift. Infinite for the first.
    pub drift: f64,
    /// Bound on the error of the drift; of one integration none is known.
    #[serde(default)]
    pub drift_error: f64,
}

impl Cycle<f64> {
    /// With errors by a function of the place of a quantity among eleven, the drift being the last, its value and those of all integrations that are compared.
    pub(super) fn assessed(
        &self,
        compared: Compared<&Self>,
        mut estimate: impl FnMut(usize, f64, Compared<f64>) -> Estimate,
    ) -> Cycle<Estimate> {
        let drift_error = estimate(DRIFT, self.drift, compared.map(|cycle| cycle.map(|cycle| cycle.drift))).error;
        let mut place = 0;
        let mut one = |of: fn(&Self) -> f64| {
            place += 1;
            estimate(place - 1, of(self), compared.map(|cycle| cycle.map(of)))
        };
        Cycle {
            segment: self.segment,
            number: self.number,
            start: self.start,
            end: self.end,
            work: one(|cycle| cycle.work),
            storage_stiffness: one(|cycle| cycle.storage_stiffness),
            loss_stiffness: one(|cycle| cycle.loss_stiffness),
            phase: one(|cycle| cycle.phase),
            penetration: [one(|cycle| cycle.penetration[0]), one(|cycle| cycle.penetration[1])],
            force: [one(|cycle| cycle.force[0]), one(|cycle| cycle.force[1])],
            contact_radius: [one(|cycle| cycle.contact_radius[0]), one(|cycle| cycle.contact_radius[1])],
            drift: self.drift,
            drift_error,
        }
    }
}
