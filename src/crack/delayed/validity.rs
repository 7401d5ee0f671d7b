//! Numbers that say where the model's own assumptions end. Nothing here refuses: a scene computes and speaks up.
//!
//! The tip fields are those of a crack in a wide body: the process zone must be short against the strip (δ ≪ h), the remote stress small
//! against the cohesive one (σ∞ ≪ σ_c). With δ = (K/(√(2π)σ_c))² and K = σ∞√h both are one statement, δ/h = (σ∞/σ_c)²/(2π). The parameters
//! printed under thesis Fig 5.7b break it: over the range of the figure σ∞/σ_c runs from 0.95 to 3.0 and δ/h from 0.14 to 1.4.

use crate::refusal::{Refusal, require_non_negative, require_positive};

/// How far a history is from the assumptions of the theory; each number should be well below one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthValidity {
    /// δ/h: process zone over half the height of the strip.
    pub zone_to_half_height: f64,
    /// The greatest remote stress over the cohesive stress; none without a cohesive stress.
    pub remote_to_cohesive_stress: Option<f64>,
}

impl GrowthValidity {
    /// Whether every number is at most `limit`.
    #[must_use]
    pub fn holds(&self, limit: f64) -> bool {
        self.zone_to_half_height <= limit && self.remote_to_cohesive_stress.is_none_or(|ratio| ratio <= limit)
    }
}

/// The numbers for a zone length (m), half the strip's height (m), the greatest remote stress (Pa) and a cohesive stress (Pa) if there is one.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a length or cohesive stress that is not positive and finite, or a negative remote stress.
pub fn growth_validity(
    process_zone: f64,
    half_height: f64,
    remote_stress: f64,
    cohesive_stress: Option<f64>,
) -> Result<GrowthValidity, Refusal> {
    let zone = require_positive("process_zone", process_zone)?;
    let height = require_positive("half_height", half_height)?;
    let stress = require_non_negative("remote_stress", remote_stress)?;
    let ratio = match cohesive_stress {
        Some(cohesive) => Some(stress / require_positive("cohesive_stress", cohesive)?),
        None => None,
    };
    Ok(GrowthValidity { zone_to_half_height: zone / height, remote_to_cohesive_stress: ratio })
}
