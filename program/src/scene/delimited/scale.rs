//! From the numbers of a column to SI units.

use crate::scene::units::{Dimension, UnitError, parse_quantity};

/// What turns a number of a unit into SI: x·10^power·factor + offset. The power of ten is folded into the digits, so that they are rounded once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    pub(super) power: i32,
    factor: f64,
    offset: f64,
    /// The dimension of the unit.
    pub dimension: Dimension,
}

impl Scale {
    /// A plain number.
    pub const ONE: Self = Self { power: 0, factor: 1.0, offset: 0.0, dimension: Dimension::NUMBER };

    /// The scale of a unit as scenes write it; nothing is a plain number.
    ///
    /// # Errors
    /// A unit that is not known.
    pub fn of(unit: &str) -> Result<Self, UnitError> {
        let one = parse_quantity(&format!("1 {unit}"))?;
        let zero = parse_quantity(&format!("0 {unit}"))?.value;
        let factor = one.value - zero;
        if zero != 0.0 {
            // A temperature: kelvins a degree, from the quotient of large steps, which lose nothing.
            let far = parse_quantity(&format!("1.8e6 {unit}"))?.value;
            let factor = ((far - zero) / 1.8e6 * 9.0).round() / 9.0;
            return Ok(Self { power: 0, factor, offset: zero, dimension: one.dimension });
        }
        let power = factor.abs().log10().round();
        let is_power = power.abs() < 300.0 && format!("1e{power:.0}").parse::<f64>().is_ok_and(|exact| exact.total_cmp(&factor).is_eq());
        Ok(if is_power {
            Self { power: power as i32, factor: 1.0, offset: 0.0, dimension: one.dimension }
        } else {
            Self { power: 0, factor, offset: 0.0, dimension: one.dimension }
        })
    }

    /// The same, times a factor (2π from cycles to radians).
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { factor: self.factor * factor, offset: self.offset * factor, ..self }
    }

    pub(super) fn apply(&self, folded: f64) -> f64 {
        folded * self.factor + self.offset
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn scales_agree_with_quantities() {
        for unit in ["", "MPa", "µm", "°C", "°F", "K", "psi", "dyn/cm²", "min", "1/MPa", "%", "cm²/dyn", "rad/s", "kN/mm"] {
            for number in ["25", "0.7", "-3.25e2", "1e-7"] {
                let right = parse_quantity(&format!("{number} {unit}")).unwrap();
                let scale = Scale::of(unit).unwrap();
                let found = scale.apply(format!("{number}e{}", scale.power).replace("e2e", "e2e").parse().unwrap_or_else(|_| {
                    // The number has an exponent of its own.
                    let (digits, own) = number.split_once('e').unwrap();
                    format!("{digits}e{}", own.parse::<i32>().unwrap() + scale.power).parse().unwrap()
                }));
                assert!((found - right.value).abs() <= 4.0 * f64::EPSILON * right.value.abs(), "{number} {unit}: {found} {}", right.value);
                assert_eq!(scale.dimension, right.dimension);
            }
        }
        assert!(Scale::of("furlong").is_err());
    }
}
