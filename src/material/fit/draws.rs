//! Materials that the data leave possible: what a result owes to the scatter of the data is seen by computing it for each of them.

use super::choose::SeriesFit;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::special::normal::Normal;

/// A material that the data leave possible, and ln a_T and ln b_T of every isotherm that was fitted.
pub type Drawn = (Material, Vec<(f64, f64)>);

impl SeriesFit {
    /// Materials at the temperature of the fit, drawn from what the data leave open: the number of terms by the weight of each candidate, then the
    /// logarithms of strengths and times, normal with the covariance of its linearised fit, scaled by the scatter of the data.
    ///
    /// Every strength and every time is positive. The same count and seed give the same materials, and a larger count begins with those of a smaller one.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] where the data do not fix the covariance.
    pub fn draws(&self, count: usize, seed: u64) -> Result<Vec<Material>, Refusal> {
        Ok(self.draws_with_shifts(count, seed)?.into_iter().map(|(material, _)| material).collect())
    }

    /// The same materials, each with ln a and ln b of every isotherm that was fitted: a material at another temperature is drawn with its shift.
    ///
    /// # Errors
    /// As [`Self::draws`].
    pub fn draws_with_shifts(&self, count: usize, seed: u64) -> Result<Vec<Drawn>, Refusal> {
        (0..count)
            .map(|draw| {
                self.band.draw(&mut Normal::of(seed, draw as u64)).ok_or_else(|| Refusal::Undefined {
                    quantity: "a draw of a fitted material",
                    reason: "the data do not fix the errors of the fit".into(),
                })
            })
            .collect()
    }
}
