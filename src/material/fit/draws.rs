//! Materials that the data leave possible: what a result owes to the scatter of the data is seen by computing it for each of them.

use super::choose::{SeriesFit, material};
use super::normal::Normal;
use crate::material::Material;
use crate::refusal::Refusal;

impl SeriesFit {
    /// Materials at the temperature of the fit, drawn from what the data leave open: the logarithms of strengths and times are normal, with the
    /// covariance of the linearised fit, scaled by the scatter of the data.
    ///
    /// Every strength and every time is positive. The same count and seed give the same materials, and a larger count begins with those of a smaller one.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] where the data do not fix the covariance; what making a material refuses.
    pub fn draws(&self, count: usize, seed: u64) -> Result<Vec<Material>, Refusal> {
        (0..count)
            .map(|draw| {
                let series = self.band.draw(&mut Normal::of(seed, draw as u64)).ok_or_else(|| Refusal::Undefined {
                    quantity: "a draw of a fitted material",
                    reason: "the data do not fix the errors of the fit".into(),
                })?;
                material(&series, self.creep)
            })
            .collect()
    }
}
