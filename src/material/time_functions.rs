//! The creep and the relaxation function of a material.

use super::Material;

impl Material {
    /// J(t) (1/Pa) at a time t ≥ 0 (s) after a unit stress was applied; 0 before; J(∞) = 1/E0.
    ///
    /// A sum of positive terms: relative error a few ulp for any t.
    #[must_use]
    pub fn creep(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        let terms: f64 = self.creep_terms.iter().rev().map(|term| -term.compliance * (-time / term.retardation_time).exp_m1()).sum();
        1.0 / self.glassy_modulus + terms + self.steady_viscosity.map_or(0.0, |viscosity| time / viscosity)
    }

    /// dJ/dt (1/(Pa s)) at a time t > 0 (s); the jump 1/E∞ at t = 0 is not in it.
    #[must_use]
    pub fn creep_rate(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        let terms: f64 =
            self.creep_terms.iter().map(|term| term.compliance / term.retardation_time * (-time / term.retardation_time).exp()).sum();
        terms + self.steady_viscosity.map_or(0.0, |viscosity| 1.0 / viscosity)
    }

    /// R(t) (Pa) at a time t ≥ 0 (s) after a unit strain was applied; 0 before; R(0) = E∞, R(∞) = E0.
    #[must_use]
    pub fn relaxation(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        self.relaxed_modulus + self.relaxation_terms.iter().map(|term| term.modulus * (-time / term.relaxation_time).exp()).sum::<f64>()
    }

    /// dR/dt (Pa/s), negative, at a time t > 0 (s); the jump E∞ at t = 0 is not in it.
    #[must_use]
    pub fn relaxation_rate(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        -self.relaxation_terms.iter().map(|term| term.modulus / term.relaxation_time * (-time / term.relaxation_time).exp()).sum::<f64>()
    }
}
