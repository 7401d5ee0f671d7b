//! The complex modulus of a harmonic strain e^{+iωt}.

use super::Material;
use crate::refusal::{Refusal, require_non_negative};

/// E(ω) = E′ + iE″ at one angular frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplexModulus {
    /// E′(ω) (Pa), the part in phase with the strain.
    pub storage: f64,
    /// E″(ω) ≥ 0 (Pa), the part a quarter period ahead of the strain.
    pub loss: f64,
}

impl ComplexModulus {
    /// |E(ω)| (Pa).
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.storage.hypot(self.loss)
    }

    /// tan δ = E″/E′; infinite only for a viscous material at rest, whose moduli both vanish there.
    #[must_use]
    pub fn loss_tangent(&self) -> f64 {
        if self.loss == 0.0 && self.storage > 0.0 { 0.0 } else { self.loss / self.storage }
    }
}

impl Material {
    /// The complex modulus E0 + Σ E_i iωρ_i/(1 + iωρ_i) at an angular frequency ω ≥ 0 (rad/s).
    ///
    /// Both parts are sums of positive terms: relative error a few ulp, besides the conversion error of a material given by creep.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite frequency; [`Refusal::Undefined`] for a viscous material at ω = 0,
    /// where both parts vanish and no loss tangent exists.
    pub fn complex_modulus(&self, angular_frequency: f64) -> Result<ComplexModulus, Refusal> {
        let frequency = require_non_negative("angular_frequency", angular_frequency)?;
        if frequency == 0.0 {
            self.solid_modulus("the complex modulus at rest")?;
        }
        let mut storage = self.relaxed_modulus;
        let mut loss = 0.0;
        for term in &self.relaxation_terms {
            let x = frequency * term.relaxation_time;
            // x²/(1+x²) and x/(1+x²) by the smaller of x and 1/x: no overflow at either end.
            let (in_phase, out_of_phase) = if x <= 1.0 {
                let denominator = 1.0 + x * x;
                (x * x / denominator, x / denominator)
            } else {
                let inverse = 1.0 / x;
                let denominator = 1.0 + inverse * inverse;
                (1.0 / denominator, inverse / denominator)
            };
            storage += term.modulus * in_phase;
            loss += term.modulus * out_of_phase;
        }
        Ok(ComplexModulus { storage, loss })
    }
}
