//! No contact of what is held: full contact, or a refusal that names the limit that was passed.

use super::full::full_contact;
use super::limits::{beyond, beyond_a_width, beyond_a_zone, size_of};
use super::prepared::Prepared;
use super::problem::SlidingProblem;
use super::solution::{SlidingOutcome, SlidingWork};
use super::solve::ReachedBy;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::SlidingControl;
use crate::sliding::equilibrium::{Crossing, HeldQuantity};

/// What is known of why.
pub(super) enum Nothing {
    /// Of a load or penetration: what the curve has, and the stable contacts that cannot exist.
    Held { held: (HeldQuantity, f64), found: Vec<Crossing>, refused: Vec<Crossing>, reached_by: ReachedBy },
    /// Of a half-width.
    HalfWidth(f64),
}

impl Nothing {
    /// Full contact, or the limit that was passed.
    pub(super) fn explained(
        self,
        material: &PlaneMaterial,
        problem: &SlidingProblem<'_>,
        prepared: &Prepared,
        work: &mut SlidingWork,
    ) -> Result<SlidingOutcome, Refusal> {
        let size = size_of(problem);
        let curve = prepared.curve(size);
        let unstable = match &self {
            Self::Held { held, found, refused, reached_by } => {
                if let Some(outcome) = beyond(material, problem, &curve, *held, (refused, *reached_by), *work) {
                    return outcome;
                }
                found.len()
            }
            Self::HalfWidth(half_width) => {
                if let Some(refusal) = beyond_a_width(&curve, *half_width) {
                    return Err(refusal);
                }
                0
            }
        };
        if let Some(refusal) = beyond_a_zone(material, problem, size) {
            return Err(refusal);
        }
        if let (0, SlidingControl::MeanPressure(_), Indenter::Wave) = (unstable, problem.control, problem.indenter) {
            // Not even short zones leave a contact: adhesion closes the gap of itself.
            return full_contact(
                material,
                problem,
                "half-widths looked at without a partial contact at this speed",
                curve.rows() as f64,
                *work,
            );
        }
        let (reason, limit_name, limit) = if unstable > 0 {
            ("every contact of what is held is unstable".into(), "unstable contacts", unstable as f64)
        } else {
            let widths = curve.rows();
            let reason = format!("no steady partial contact exists at this speed: none at any of {widths} half-widths, whatever the load");
            (reason, "half-widths looked at", widths as f64)
        };
        Err(Refusal::NoSuchState { reason, limit_name, limit })
    }
}
