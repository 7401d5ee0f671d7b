//! A number together with a bound on its error: what every solver of this crate returns.

use serde::{Deserialize, Serialize};

/// A value and a bound on the absolute error made in solving the stated equations.
///
/// The bound covers rounding, truncation and the tolerance of iterations; it says nothing about how well the equations model a
/// real material (the validity block of an outcome does that). Both members carry the same unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The computed value, in the unit of its quantity.
    pub value: f64,
    /// |value − exact solution of the stated equations| is at most this, in the same unit; infinite where none is known.
    pub error: f64,
}

impl Estimate {
    /// A value with an absolute error bound.
    #[must_use]
    pub const fn new(value: f64, error: f64) -> Self {
        Self { value, error }
    }

    /// A value with a relative error bound.
    #[must_use]
    pub fn relative(value: f64, relative_error: f64) -> Self {
        Self { value, error: (value * relative_error).abs() }
    }

    /// An input or a defined constant: exact to its last bit.
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The error bound divided by the magnitude of the value; zero for an exact zero.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.value.abs() }
    }

    /// The same estimate in a unit `factor` times smaller (both members are multiplied; half an ulp is added for the product).
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let value = self.value * factor;
        Self { value, error: (self.error * factor).abs() + 0.5 * f64::EPSILON * value.abs() }
    }

    /// `self` raised to `power`, the error propagated to first order.
    #[must_use]
    pub fn powf(&self, power: f64) -> Self {
        let value = self.value.powf(power);
        Self { value, error: value.abs() * (power.abs() * self.relative_error() + f64::EPSILON) }
    }
}
