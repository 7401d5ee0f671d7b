//! The undeformed tip: its face, and where it ends.

use spec_math::Gamma;
use std::f64::consts::PI;
use std::sync::Arc;

use crate::indentation::TabulatedShape;
use crate::refusal::{Refusal, require_positive};

/// The face of the tip: its height f(x) over the apex, in h₀, at radius x.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// f = x²/2, the paraboloid that stands for a sphere.
    Paraboloid,
    /// f = coefficient·x^exponent (R is then any length that scales the radii).
    Power {
        /// The height (h₀) at x = 1, > 0.
        coefficient: f64,
        /// Above ½ and up to 20; 1 is a cone.
        exponent: f64,
    },
    /// f = 0: the flat face of a punch, which needs a rim.
    Flat,
    /// Through points (x, f) in these units; beyond the last one it goes on with the slope that it has there.
    Table(Arc<TabulatedShape>),
}

impl Shape {
    /// The height f(x) over the apex (h₀, zero or more) at a radius x ≥ 0 (√(R h₀)).
    #[must_use]
    pub fn height(&self, x: f64) -> f64 {
        match self {
            Self::Paraboloid => 0.5 * x * x,
            Self::Power { coefficient, exponent } => coefficient * x.powf(*exponent),
            Self::Flat => 0.0,
            Self::Table(table) => table.height(x) + table.slope(x) * (x - table.reach()).max(0.0),
        }
    }

    /// Whether the slope has no bound at the apex: then the pressure has none without attraction.
    pub(super) fn is_sharp(&self) -> bool {
        matches!(self, Self::Power { exponent, .. } if *exponent < 1.0)
    }

    /// The line profile, s∫₀^s f′/√(s² − x²) dx.
    pub(super) fn line(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid => s * s,
            Self::Power { coefficient, exponent } => coefficient * line_factor(*exponent) * s.powf(*exponent),
            Self::Flat => 0.0,
            Self::Table(table) => table.line(s),
        }
    }

    /// Its slope.
    pub(super) fn line_slope(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid => 2.0 * s,
            Self::Power { exponent, .. } => exponent * self.line(s) / s,
            Self::Flat => 0.0,
            Self::Table(table) => table.line_slope(s),
        }
    }

    /// Its integral from the axis.
    pub(super) fn volume(&self, s: f64) -> f64 {
        match self {
            Self::Paraboloid => s.powi(3) / 3.0,
            Self::Power { exponent, .. } => s * self.line(s) / (exponent + 1.0),
            Self::Flat => 0.0,
            Self::Table(table) => table.volume(s),
        }
    }

    /// Radii in rising order between which the height is smooth, beyond one.
    pub(super) fn kinks_beyond(&self, x: f64) -> Vec<f64> {
        match self {
            Self::Table(table) => table.knots(x, table.reach()).into_iter().chain([table.reach()]).filter(|knot| *knot > x).collect(),
            _ => Vec::new(),
        }
    }

    /// Checks every number, with the radius at which the tip ends.
    pub(super) fn check(&self, rim: Option<f64>) -> Result<(), Refusal> {
        if let Some(rim) = rim {
            require_positive("rim", rim)?;
        }
        match self {
            Self::Power { coefficient, exponent } => {
                require_positive("coefficient", *coefficient)?;
                if !(*exponent > 0.5 && *exponent <= 20.0) {
                    return Err(Refusal::out_of_range("exponent", *exponent, "above 0.5 and at most 20"));
                }
            }
            Self::Flat if rim.is_none() => return Err(Refusal::out_of_range("rim", f64::INFINITY, "finite: a flat face ends somewhere")),
            Self::Table(table) if rim.is_some_and(|rim| rim > table.reach()) => {
                return Err(Refusal::out_of_range("rim", rim.unwrap_or(0.0), "at most the radius of the last point of the shape"));
            }
            _ => {}
        }
        Ok(())
    }
}

/// Line profile over height of a power law: √π Γ(n/2 + 1)/Γ(n/2 + 1/2), Sneddon (1965).
fn line_factor(exponent: f64) -> f64 {
    PI.sqrt() * Gamma::gamma(&(0.5 * exponent + 1.0)) / Gamma::gamma(&(0.5 * exponent + 0.5))
}
