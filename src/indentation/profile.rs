//! The indenter as the line sees it: f(s) = s d/ds ∫₀^s z(r)/√(s² − r²) dr of a shape z(r).

use crate::refusal::{Refusal, require_positive};
use std::f64::consts::FRAC_PI_2;

/// An axisymmetric indenter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Profile {
    /// z = r²/(2R), a sphere of radius R ≫ a (m): f = s²/R.
    Paraboloid {
        /// R (m).
        radius: f64,
    },
    /// z = r·slope: f = (π/2)·slope·s.
    Cone {
        /// dz/dr > 0.
        slope: f64,
    },
    /// A flat face with a sharp rim: f = 0, and the contact grows no further than the rim.
    FlatPunch {
        /// Of the rim (m).
        radius: f64,
    },
    /// A shape z = c·r^m given by its line profile f = coefficient·s^exponent, with the same exponent m.
    PowerLaw {
        /// Of s^exponent (m^{1 − exponent}).
        coefficient: f64,
        /// m > 0.
        exponent: f64,
    },
}

impl Profile {
    /// Passes a sound profile on.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not finite and positive.
    pub fn checked(self) -> Result<Self, Refusal> {
        match &self {
            Self::Paraboloid { radius } | Self::FlatPunch { radius } => require_positive("radius", *radius)?,
            Self::Cone { slope } => require_positive("slope", *slope)?,
            Self::PowerLaw { coefficient, exponent } => {
                require_positive("coefficient", *coefficient)?;
                require_positive("exponent", *exponent)?
            }
        };
        Ok(self)
    }

    /// f(s) (m) at s ≥ 0.
    #[must_use]
    pub fn line(&self, s: f64) -> f64 {
        match *self {
            Self::Paraboloid { radius } => s / radius * s,
            Self::Cone { slope } => FRAC_PI_2 * slope * s,
            Self::FlatPunch { .. } => 0.0,
            Self::PowerLaw { coefficient, exponent } => coefficient * s.powf(exponent),
        }
    }

    /// f′(s).
    #[must_use]
    pub fn line_slope(&self, s: f64) -> f64 {
        match *self {
            Self::Paraboloid { radius } => 2.0 * s / radius,
            Self::Cone { slope } => FRAC_PI_2 * slope,
            Self::FlatPunch { .. } => 0.0,
            Self::PowerLaw { coefficient, exponent } => coefficient * exponent * s.powf(exponent - 1.0),
        }
    }

    /// A smooth coordinate of the line that rises with s: f(s), or s where f is constant.
    pub(super) fn coordinate(&self, s: f64) -> f64 {
        if let Self::FlatPunch { .. } = self { s } else { self.line(s) }
    }

    /// Slope of the coordinate.
    pub(super) fn coordinate_slope(&self, s: f64) -> f64 {
        if let Self::FlatPunch { .. } = self { 1.0 } else { self.line_slope(s) }
    }

    /// s (m) of a coordinate between those of two places.
    pub(super) fn inverse_coordinate(&self, coordinate: f64, one: f64, other: f64) -> f64 {
        match *self {
            Self::Paraboloid { radius } => (coordinate * radius).max(0.0).sqrt(),
            Self::Cone { slope } => coordinate / (FRAC_PI_2 * slope),
            Self::FlatPunch { .. } => coordinate,
            Self::PowerLaw { coefficient, exponent } => (coordinate / coefficient).max(0.0).powf(1.0 / exponent),
        }
        .clamp(one.min(other), one.max(other))
    }

    /// The radius beyond which there is no face to touch (m).
    #[must_use]
    pub const fn rim(&self) -> f64 {
        if let Self::FlatPunch { radius } = self { *radius } else { f64::INFINITY }
    }

    /// Panel boundaries that make f smooth on 0…end: two numbers, or graded towards the axis for a power that is no polynomial.
    #[must_use]
    pub fn breaks(&self, end: f64) -> Vec<f64> {
        match *self {
            // Halving 26 times leaves a first panel of 1.5e-8 of the length, with a load of the same order of the whole or less.
            Self::PowerLaw { .. } => std::iter::once(0.0).chain((0..=26).rev().map(|k| end * 0.5f64.powi(k))).collect(),
            _ => vec![0.0, end],
        }
    }
}
