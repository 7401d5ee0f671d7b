//! How much a sliding contact, or what it carries, depends on numbers that users know badly: ∂ln(output)/∂ln(parameter).
//!
//! | parameter | what varies | what is held |
//! |---|---|---|
//! | [`Parameter::ProcessZone`] δ | both process zones, in a fixed ratio | all else |
//! | [`Parameter::WorkOfAdhesion`] Δγ | both works, in a fixed ratio | all else, the process zones too |
//! | [`Parameter::RelaxedModulus`] E0 | E0, and E∞ with it | β, all times, the load in its own unit |
//! | [`Parameter::StiffeningRatio`] β | E∞ = βE0: all creep compliances in a fixed ratio, Σ J_j = (1 − 1/β)/E0 | E0, the retardation times τ_j (relaxation times then change) |
//! | [`Parameter::Time`] τ | all times in a fixed ratio | all else; the works of adhesion at the given speed |
//!
//! The speed, the size of the indenter and what is prescribed (load, penetration or half-width) are held. Derivatives are the implicit ones of the solved equations,
//! no differences of solutions: with the conditions r = 0 and the prescription c = 0 in u = (a, e, p̄),
//! ```text
//! contact     dY/dθ = Y_θ − λ·(r, c)_θ        (r, c)_uᵀ λ = Y_u
//! turn of Q   dQ/dθ = Q_θ − λ·r_θ             r_uᵀ λ = Q_u, which has a solution where Q turns along the branch
//! toughness   dT/dθ = 2π[∫(p̄_θ Δ_a − Δ_θ p̄_a) da + p̄ Δ_θ at Δ_out]       at fixed a; p̄ = 0 at the other end
//! ```
//! Only the partial derivatives are differences, of fourth order, at two resolutions and steps; what these differ by, with rounding, is the error bound.

mod linearized;
mod state;
mod strength;

pub use state::{StateSensitivities, state_sensitivities};
pub use strength::{StrengthSensitivities, strength_sensitivities};

use crate::estimate::Estimate;

/// What may be known badly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// δ of both edges.
    ProcessZone,
    /// Δγ of both edges.
    WorkOfAdhesion,
    /// E0, at fixed β.
    RelaxedModulus,
    /// β = E∞/E0, at fixed E0.
    StiffeningRatio,
    /// All times of the solid.
    Time,
}

impl Parameter {
    /// All of them, in the order of every list.
    pub const ALL: [Self; 5] = [Self::ProcessZone, Self::WorkOfAdhesion, Self::RelaxedModulus, Self::StiffeningRatio, Self::Time];
}

/// ∂ln|Y|/∂ln θ for each of [`Parameter::ALL`]; none where Y vanishes within its bound, or where there is nothing to vary (β of an elastic solid).
pub type Sensitivity = [Option<Estimate>; 5];

/// The logarithmic derivative from dY/dln θ and its bound.
fn logarithmic(derivative: Estimate, value: Estimate) -> Option<Estimate> {
    if value.value.abs() <= value.error || value.value == 0.0 {
        return None;
    }
    let slope = derivative.value / value.value;
    Some(Estimate::new(slope, (derivative.error + slope.abs() * value.error) / value.value.abs() + 2.0 * f64::EPSILON * slope.abs()))
}

/// From two sets, of the coarser and the finer resolution.
fn compared(rough: Estimate, best: Estimate) -> Estimate {
    Estimate::new(best.value, (best.value - rough.value).abs() + best.error)
}
