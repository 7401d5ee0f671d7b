//! The one equation: virtual work at a moving edge.
//!
//! ```text
//!            tension(d)  |  gap(d)                 move the edge outwards by a process zone δ: the tension found inside the
//!      ══════════════╗   |   ___----               moved edge works on the gap found outside the old one,
//!   contact / solid   ╲  |_--                        (1/2δ) ∫₀^δ tension(d) · gap(δ − d) dd = Δγ
//!   ───────────────────●──────────► distance       (thesis Eqs 3.10, 4.9, 5.19–5.21, 5.37, 5.67)
//!                     edge
//! ```
//! | name | meaning | unit |
//! |---|---|---|
//! | tension(d) | −pressure at a distance d > 0 inside the edge, on the bonded side; like 1/√d at the edge | Pa |
//! | gap(d) | opening at a distance d > 0 outside the edge; like √d at the edge | m |
//! | δ | process-zone length | m |
//! | Δγ | work of adhesion | J/m² |
//!
//! Steady and unsteady contacts and cracks differ only in the two fields. Each problem of this crate evaluates its balance by a fast
//! reduced form; this module evaluates it from any two fields by quadrature, and the reduced forms are property-tested against it.

pub mod work_by_speed;

use crate::refusal::{Refusal, require_positive};
use crate::special::log_quadrature::integrate_between_edges;

/// The two fields at an edge that the balance needs.
pub trait EdgeFields {
    /// Tension (Pa, positive pulls the faces together) at a distance (m) inside the edge.
    fn tension(&self, distance_inside: f64) -> f64;
    /// Gap (m, positive is open) at a distance (m) outside the edge.
    fn gap(&self, distance_outside: f64) -> f64;
}

/// The work of the interface stresses per unit area of process zone, with its error and what it took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProcessZoneWork {
    /// (1/2δ) ∫ tension·gap (J/m²); at equilibrium it is the work of adhesion.
    pub value: f64,
    /// Bound on its absolute error from quadrature and rounding; errors of the fields themselves are not in it.
    pub error: f64,
    /// Number of pairs of field evaluations.
    pub evaluations: u64,
}

/// The left-hand side of the balance for two fields and a process zone, to a relative `tolerance` (not below 1e-15).
///
/// Layers in either field at any distance from its edge, down to 1e-30 of the process zone, are resolved: the quadrature is uniform
/// in the logarithm of the distance to each end.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a process zone that is not positive; [`Refusal::NotConverged`] when a field is not finite inside the
/// zone or the tolerance is not reached (a field with a kink or noise).
pub fn process_zone_work(fields: &impl EdgeFields, process_zone: f64, tolerance: f64) -> Result<ProcessZoneWork, Refusal> {
    let length = require_positive("process_zone", process_zone)?;
    let integral =
        integrate_between_edges(|inside, outside| fields.tension(length * inside) * fields.gap(length * outside), tolerance.max(1e-15))?;
    Ok(ProcessZoneWork { value: 0.5 * integral.value, error: 0.5 * integral.error, evaluations: integral.evaluations })
}
