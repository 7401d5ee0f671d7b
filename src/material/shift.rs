//! Time–temperature superposition: how much slower a material is at a temperature than at its reference temperature.
//!
//! Every time of the material at a temperature T is its time at T_ref multiplied by the shift factor a_T; moduli stay.
//! ```text
//! Williams, Landel and Ferry (1955)   log₁₀ a_T = −c₁ (T − T_ref)/(c₂ + T − T_ref),  T > T_ref − c₂
//! Arrhenius                           ln a_T = (E_a/R)(1/T − 1/T_ref)
//! table                               ln a_T linear in 1/T between given temperatures
//! ```

use super::Material;
use crate::refusal::{Refusal, require_finite, require_positive};

/// The molar gas constant (J/(mol K)), exact since 2019.
const GAS_CONSTANT: f64 = 8.314_462_618_153_24;

/// Shift factors of a material.
#[derive(Debug, Clone, PartialEq)]
pub enum ShiftFactors {
    /// Williams, Landel and Ferry's.
    WilliamsLandelFerry {
        /// c₁ (1), positive.
        c1: f64,
        /// c₂ (K), positive.
        c2: f64,
        /// T_ref (K), where a_T = 1.
        reference: f64,
    },
    /// Arrhenius's.
    Arrhenius {
        /// E_a (J/mol), positive.
        activation_energy: f64,
        /// T_ref (K), where a_T = 1.
        reference: f64,
    },
    /// Given factors, temperatures increasing.
    Table(Vec<(f64, f64)>),
}

impl ShiftFactors {
    /// log₁₀ a_T at a temperature (K).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a temperature that is not positive, at or below the pole of a law, or outside a table.
    pub fn decades(&self, temperature: f64) -> Result<f64, Refusal> {
        let temperature = require_positive("temperature", temperature)?;
        let value = match self {
            Self::WilliamsLandelFerry { c1, c2, reference } => {
                let (c1, c2) = (require_positive("c1", *c1)?, require_positive("c2", *c2)?);
                let above = temperature - require_positive("reference_temperature", *reference)?;
                if c2 + above <= 0.0 {
                    return Err(Refusal::out_of_range("temperature", temperature, "above reference_temperature − c2, where the law ends"));
                }
                -c1 * above / (c2 + above)
            }
            Self::Arrhenius { activation_energy, reference } => {
                let energy = require_positive("activation_energy", *activation_energy)?;
                let reference = require_positive("reference_temperature", *reference)?;
                energy / GAS_CONSTANT * ((reference - temperature) / temperature / reference) / std::f64::consts::LN_10
            }
            Self::Table(points) => interpolated(points, temperature)?,
        };
        require_finite("the shift factor's logarithm", value)
    }

    /// The temperature (K) itself, or the end of a table from which it is no further than a tolerance (K).
    #[must_use]
    pub fn held_within(&self, temperature: f64, tolerance: f64) -> f64 {
        let ends = match self {
            Self::Table(points) => points.first().zip(points.last()),
            _ => None,
        };
        let Some((&(low, _), &(high, _))) = ends else { return temperature };
        let held = temperature.max(low).min(high);
        if (held - temperature).abs() <= tolerance { held } else { temperature }
    }

    /// a_T at a temperature (K).
    ///
    /// # Errors
    /// As [`Self::decades`]; [`Refusal::OutOfRange`] where the factor overflows.
    pub fn factor(&self, temperature: f64) -> Result<f64, Refusal> {
        require_positive("the shift factor", 10f64.powf(self.decades(temperature)?))
    }
}

/// log₁₀ a_T between two temperatures of a table, linear in 1/T; a temperature of the table gives its own factor.
fn interpolated(points: &[(f64, f64)], temperature: f64) -> Result<f64, Refusal> {
    for &(_, factor) in points {
        require_positive("the shift factor", factor)?;
    }
    let outside = || Refusal::out_of_range("temperature", temperature, "within the temperatures of the shift factors");
    // The kelvins of "20 °C" written in two ways differ by rounding.
    let slack = 1e-9 * temperature;
    if let Some(&(_, factor)) = points.iter().find(|point| (point.0 - temperature).abs() <= slack) {
        return Ok(factor.log10());
    }
    let above = points.iter().position(|point| point.0 > temperature).filter(|&index| index > 0).ok_or_else(outside)?;
    let (Some(&(low, slow)), Some(&(high, fast))) = (points.get(above - 1), points.get(above)) else { return Err(outside()) };
    let part = (1.0 / low - 1.0 / temperature) / (1.0 / low - 1.0 / high);
    Ok(slow.log10() + part * (fast.log10() - slow.log10()))
}

impl Material {
    /// The same material with every time (and the viscosity) multiplied by `factor`: what a temperature does.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the factor is positive and finite; [`Refusal::Undefined`] where a time overflows.
    pub fn slowed(&self, factor: f64) -> Result<Self, Refusal> {
        let factor = require_positive("factor", factor)?;
        let mut slowed = self.clone();
        slowed.steady_viscosity = slowed.steady_viscosity.map(|viscosity| viscosity * factor);
        for term in &mut slowed.creep_terms {
            term.retardation_time *= factor;
        }
        for term in &mut slowed.relaxation_terms {
            term.relaxation_time *= factor;
        }
        slowed.representable()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn laws_by_hand() {
        let wlf = ShiftFactors::WilliamsLandelFerry { c1: 17.44, c2: 51.6, reference: 300.0 };
        assert!((wlf.decades(310.0).unwrap() + 174.4 / 61.6).abs() < 1e-14);
        assert!(wlf.decades(248.0).is_err());
        let arrhenius = ShiftFactors::Arrhenius { activation_energy: 1e5, reference: 300.0 };
        assert!((arrhenius.factor(310.0).unwrap() - (1e5 / GAS_CONSTANT * (1.0 / 310.0 - 1.0 / 300.0)).exp()).abs() < 1e-14);
        let table = ShiftFactors::Table(vec![(290.0, 100.0), (300.0, 1.0), (320.0, 1e-3)]);
        assert!((table.factor(290.0).unwrap() - 100.0).abs() < 1e-12 && table.factor(289.0).is_err() && table.factor(321.0).is_err());
        // Between two temperatures a table is Arrhenius's law through both.
        let energy = GAS_CONSTANT * 1e3_f64.ln() / (1.0 / 300.0 - 1.0 / 320.0);
        let law = ShiftFactors::Arrhenius { activation_energy: energy, reference: 300.0 };
        assert!((table.decades(311.0).unwrap() - law.decades(311.0).unwrap()).abs() < 1e-12);
    }
}
