//! The indenter as the line sees it: f(s) = s∫₀^s z′(r)/√(s² − r²) dr = d/ds ∫₀^s r z(r)/√(s² − r²) dr of a shape z(r) with z(0) = 0.
//!
//! z = r²/(2R) gives s²/R, z = r·slope gives (π/2)·slope·s (Sneddon 1965, [10.1016/0020-7225(65)90019-4](https://doi.org/10.1016/0020-7225(65)90019-4)).

use super::row::Row;
use super::shape::TabulatedShape;
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// An axisymmetric indenter.
#[derive(Debug, Clone, PartialEq)]
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
    /// A shape through points, such as a measured one; it ends at its last point, which a contact and its process zone must not reach.
    Table(Arc<TabulatedShape>),
    /// Another shape that ends at a sharp rim, as the round face of a cylinder does: f is its own up to the rim, and the contact grows no further.
    Rimmed {
        /// Of the face within the rim.
        face: Arc<Self>,
        /// The radius of the rim (m).
        rim: f64,
    },
}

impl Profile {
    /// The shape through points (r, z) (m).
    ///
    /// # Errors
    /// As [`TabulatedShape::through`].
    pub fn table(points: &[(f64, f64)]) -> Result<Self, Refusal> {
        Ok(Self::Table(Arc::new(TabulatedShape::through(points)?)))
    }

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
            // Its points were checked when it was made, and cannot be changed.
            Self::Table(shape) => require_positive("radius", shape.reach())?,
            Self::Rimmed { face, rim } => {
                let face = face.as_ref().clone().checked()?;
                if face.rim().is_finite() {
                    return Err(Refusal::out_of_range("rim", *rim, "none of its own: the face within it has a rim already"));
                }
                if matches!(&face, Self::Table(shape) if *rim > shape.reach()) {
                    return Err(Refusal::out_of_range("rim", *rim, "at most the radius of the last point of the shape"));
                }
                require_positive("rim", *rim)?
            }
        };
        Ok(self)
    }

    /// Passes a contact of a radius with a process zone (m) on that the shape is known for.
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] beyond the last point of a table.
    pub(super) fn holds(&self, contact_radius: f64, process_zone: f64) -> Result<(), Refusal> {
        match self {
            Self::Table(shape) if contact_radius > 0.0 && contact_radius + process_zone > shape.reach() => Err(Refusal::NoSuchState {
                reason: format!(
                    "the contact and its process zone reach out to {:e}, where the table has no shape",
                    contact_radius + process_zone
                ),
                limit_name: "the radius of its last point",
                limit: shape.reach(),
            }),
            _ => Ok(()),
        }
    }

    /// The face without its rim; a flat punch is nothing without.
    pub(super) fn face(&self) -> &Self {
        if let Self::Rimmed { face, .. } = self { face } else { self }
    }

    /// Whether the face is flat: it touches all at once, and f is no coordinate.
    pub(super) const fn is_flat(&self) -> bool {
        matches!(self, Self::FlatPunch { .. })
    }

    /// f(s) (m) at s ≥ 0; beyond a rim, f(rim).
    #[must_use]
    pub fn line(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => s / radius * s,
            Self::Cone { slope } => FRAC_PI_2 * slope * s,
            Self::FlatPunch { .. } => 0.0,
            Self::PowerLaw { coefficient, exponent } => coefficient * s.powf(*exponent),
            Self::Table(shape) => shape.line(s),
            Self::Rimmed { face, rim } => face.line(s.min(*rim)),
        }
    }

    /// ∫₀^s f ds′ (m²): half the volume that the shape displaces of a line of springs.
    pub(super) fn volume(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => s / radius * s * s / 3.0,
            Self::Cone { slope } => 0.5 * FRAC_PI_2 * slope * s * s,
            Self::FlatPunch { .. } => 0.0,
            Self::PowerLaw { coefficient, exponent } => coefficient * s.powf(exponent + 1.0) / (exponent + 1.0),
            Self::Table(shape) => shape.volume(s),
            Self::Rimmed { face, rim } => face.volume(s.min(*rim)) + face.line(*rim) * (s - rim).max(0.0),
        }
    }

    /// f at the nodes of a panel, or at eight other places in rising order, as [`Profile::line`].
    pub(super) fn line_row(&self, places: &Row) -> Row {
        match self {
            Self::Table(shape) => shape.line_row(places),
            _ => places.map(|s| self.line(s)),
        }
    }

    /// f′(s).
    #[must_use]
    pub fn line_slope(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => 2.0 * s / radius,
            Self::Cone { slope } => FRAC_PI_2 * slope,
            Self::FlatPunch { .. } => 0.0,
            Self::PowerLaw { coefficient, exponent } => coefficient * exponent * s.powf(exponent - 1.0),
            Self::Table(shape) => shape.line_slope(s),
            Self::Rimmed { face, .. } => face.line_slope(s),
        }
    }

    /// A smooth coordinate of the line that rises with s: f(s), or s where f is constant.
    pub(super) fn coordinate(&self, s: f64) -> f64 {
        if self.is_flat() { s } else { self.line(s) }
    }

    /// Slope of the coordinate.
    pub(super) fn coordinate_slope(&self, s: f64) -> f64 {
        if self.is_flat() { 1.0 } else { self.line_slope(s) }
    }

    /// s (m) of a coordinate between those of two places.
    pub(super) fn inverse_coordinate(&self, coordinate: f64, one: f64, other: f64) -> f64 {
        match self {
            Self::Paraboloid { radius } => (coordinate * radius).max(0.0).sqrt(),
            Self::Cone { slope } => coordinate / (FRAC_PI_2 * slope),
            Self::FlatPunch { .. } => coordinate,
            Self::PowerLaw { coefficient, exponent } => (coordinate / coefficient).max(0.0).powf(1.0 / exponent),
            Self::Table(shape) => shape.inverse(coordinate, one, other),
            Self::Rimmed { face, .. } => face.inverse_coordinate(coordinate, one, other),
        }
        .clamp(one.min(other), one.max(other))
    }

    /// The radius beyond which there is no face to touch (m); infinite for a table, beyond whose last point nothing is known.
    #[must_use]
    pub const fn rim(&self) -> f64 {
        match self {
            Self::FlatPunch { radius } => *radius,
            Self::Rimmed { rim, .. } => *rim,
            _ => f64::INFINITY,
        }
    }

    /// Panel boundaries that make f smooth on 0…end: two numbers, graded towards the axis for a power that is no polynomial, or the points of
    /// a table.
    #[must_use]
    pub fn breaks(&self, end: f64) -> Vec<f64> {
        match self {
            Self::Table(shape) => shape.breaks(end),
            Self::Rimmed { face, .. } => face.breaks(end),
            // Halving 26 times leaves a first panel of 1.5e-8 of the length, with a load of the same order of the whole or less.
            Self::PowerLaw { .. } => std::iter::once(0.0).chain((0..=26).rev().map(|k| end * 0.5f64.powi(k))).collect(),
            _ => vec![0.0, end],
        }
    }
}
