//! The materials that measured data leave possible, for results that are to show it.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{Climate, MaterialOrigin};
use std::sync::Arc;
use viscotack::material::Material;

/// How many: the standard deviation of so many is known within 1/√62, 13 %.
const DRAWS: usize = 32;
/// The same draws in every run.
const SEED: u64 = 39;

/// The draws of `material.uncertainty = "propagate"`, at the temperature of the material.
pub(super) fn draws(
    table: &Section<'_>,
    origin: &MaterialOrigin,
    climate: Option<&Climate>,
) -> Result<Option<Arc<[Material]>>, SceneError> {
    if table.text("uncertainty") != Some("propagate") {
        return Ok(None);
    }
    let wrong = |message: String, label: &str| table.wrong("uncertainty", message, label);
    let given = match origin {
        MaterialOrigin::Data(fitted) => {
            let refused = |refusal| wrong(format!("the fit's error cannot be propagated: {refusal}"), "leave it out");
            // Factors that were found from the data are drawn with the series; given ones are exact.
            if let (Some(superposition), Some(climate)) = (&fitted.superposition, climate) {
                return superposition.draws_at(climate.temperature, DRAWS, SEED).map(|all| Some(all.into())).map_err(refused);
            }
            let factor = climate.map_or(1.0, |climate| climate.factor);
            let drawn = fitted.fit.draws(DRAWS, SEED).map_err(refused)?;
            return drawn
                .iter()
                .map(|series| series.slowed(factor))
                .collect::<Result<Vec<_>, _>>()
                .map(|all| Some(all.into()))
                .map_err(refused);
        }
        MaterialOrigin::Terms => "its moduli and terms",
        MaterialOrigin::Law(_) => "a law",
        MaterialOrigin::Deck(_) => "a deck",
    };
    let message = format!(
        "`material.uncertainty` = \"propagate\" needs measured data: this material is given by {given}, which have no stated error"
    );
    Err(wrong(message, "leave it out, or give material.data"))
}
