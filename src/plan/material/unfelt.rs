//! Terms of the material that a scene cannot feel, and what leaving them out saves.

use crate::estimate::Estimate;
use crate::material::felt::{Felt, felt};
use crate::outcome::{Effect, Row, Work};
use crate::refusal::Refusal;
use crate::scene::typed::{MaterialOrigin, Scene};

/// Part of the wanted accuracy that leaving terms out may take, where the terms were made by a fit or an expansion.
const OF_ACCURACY: f64 = 0.05;

/// What was asked, and found.
#[derive(Debug, Clone)]
pub(in crate::plan) struct Unfelt {
    visited: Option<[f64; 2]>,
    terms: usize,
    felt: Option<Felt>,
}

impl Unfelt {
    /// Looks for terms that times from the first to the second cannot feel; none if the scene asks for all terms.
    ///
    /// # Errors
    /// Only those of making a material.
    pub(in crate::plan) fn new(scene: &Scene, visited: Option<[f64; 2]>) -> Result<Option<Self>, Refusal> {
        let made = !matches!(scene.material.origin, MaterialOrigin::Terms);
        let granted = scene.material.leave_out.unwrap_or(if made { OF_ACCURACY * scene.accuracy } else { 0.0 });
        let series = &scene.material.series;
        let terms = series.relaxation_terms().len();
        if granted <= 0.0 || terms < 3 {
            return Ok(None);
        }
        let felt = visited.map_or(Ok(None), |visited| felt(series, visited, granted))?;
        Ok(Some(Self { visited, terms, felt }))
    }

    /// The scene without the unfelt terms, if there are some.
    pub(in crate::plan) fn shorter(&self, scene: &Scene) -> Option<Scene> {
        let felt = self.felt.as_ref()?;
        let mut shorter = scene.clone();
        shorter.material.series = felt.material.clone();
        Some(shorter)
    }

    /// What the plan says of it.
    pub(in crate::plan) fn effect(&self, saved: Option<[Work; 2]>) -> Effect {
        let over = self.visited.map_or_else(String::new, |[from, to]| match (from > 0.0, to.is_finite()) {
            (true, true) => format!("times from {from:.1e} to {to:.1e} are visited"),
            (false, true) => format!("times up to {to:.1e} are visited"),
            (true, false) => format!("times from {from:.1e} are visited"),
            (false, false) => "all times are visited".to_owned(),
        });
        let why = match (&self.felt, self.visited) {
            (_, None) => "kept: which times are visited is only known when the scene is solved".to_owned(),
            (None, Some(_)) => format!("none: {over}, and all {} terms are felt there", self.terms),
            (Some(felt), Some(_)) => {
                let parts = [(felt.slow, "slow"), (felt.fast, "fast")];
                let left: Vec<String> = parts.iter().filter(|part| part.0 > 0).map(|(count, which)| format!("{count} {which}")).collect();
                let carried = self.terms.saturating_sub(felt.slow + felt.fast);
                let saving = match saved {
                    Some([all, fewer]) if all.linear_solves == 0 => {
                        format!("; predicted {} kernel evaluations instead of {}", fewer.kernel_evaluations, all.kernel_evaluations)
                    }
                    // A contact with given edges has two unknowns a term, and two.
                    Some(_) => format!("; each linear system has {} unknowns instead of {}", 2 * carried + 2, 2 * self.terms + 2),
                    None => String::new(),
                };
                format!(
                    "{over}: {} of {} terms left out, their sums kept; a result changes by less than {:.0e} of itself{saving}",
                    left.join(" and "),
                    self.terms,
                    felt.bound
                )
            }
        };
        Effect { name: "unfelt terms", on: self.felt.is_none() && self.visited.is_none(), why }
    }

    /// Adds the bound to the errors of solved values.
    pub(in crate::plan) fn widen(&self, rows: &mut [Row]) {
        let Some(felt) = &self.felt else { return };
        for estimate in rows.iter_mut().flat_map(|row| row.values.iter_mut().flatten()) {
            if estimate.error > 0.0 {
                *estimate = Estimate::new(estimate.value, estimate.error + felt.bound * estimate.value.abs());
            }
        }
    }
}
