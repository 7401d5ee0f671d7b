//! From coherent units to those of the solver and back.
//!
//! The solver counts the penetration from where the undeformed apex lies one range above the undeformed plane (at the wall, if there is one);
//! a scene counts it from where that gap is the law's own gap of zero stress, so that both edge theory and law of short range have one zero.

use super::super::scale::Scale;
use crate::scene::typed::{HistoryQuantity, Indentation, IndentationShape, SceneAttraction};
use std::sync::Arc;
use viscotack::continuation::bracket::halved;
use viscotack::estimate::Estimate;
use viscotack::finite_range::law::Attraction;
use viscotack::finite_range::sphere::{Creep, Scales, Shape};
use viscotack::indentation::TabulatedShape;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Rounding of the way to the units of the solver and back, relative.
const CONVERSION: f64 = 8.0 * f64::EPSILON;

/// The problem in the units of the solver.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reduced {
    pub(super) scales: Scales,
    pub(super) shape: Shape,
    /// Where the tip ends, in the unit of radii.
    pub(super) rim: Option<f64>,
    pub(super) creep: Creep,
    /// The law in coherent units.
    pub(super) law: Attraction,
    /// Penetration of the solver at penetration zero of the scene, in ranges.
    pub(super) zero: f64,
}

impl Reduced {
    pub(super) fn new(
        indentation: &Indentation,
        attraction: &SceneAttraction,
        material: &PlaneMaterial,
        scale: &Scale,
    ) -> Result<Self, Refusal> {
        let given = &attraction.attraction;
        let law = Attraction::new(given.law.clone(), given.work_of_adhesion * scale.force, given.range)?;
        let (radius, mut rim) = (radius_of_units(&indentation.shape, law.range)?, indentation.rim_radius);
        let scales = Scales::new(radius, &law, material)?;
        let shape = match &indentation.shape {
            IndentationShape::Sphere { .. } => Shape::Paraboloid,
            IndentationShape::Cone { .. } => Shape::Power { coefficient: 1.0, exponent: 1.0 },
            IndentationShape::PowerLaw { exponent, .. } => Shape::Power { coefficient: 1.0 / exponent, exponent: *exponent },
            IndentationShape::FlatPunch { radius } => {
                rim = Some(*radius);
                Shape::Flat
            }
            IndentationShape::Table { points, .. } => {
                let points: Vec<_> = points.iter().map(|(r, z)| (r / scales.radius, z / scales.gap)).collect();
                Shape::Table(Arc::new(TabulatedShape::through(&points)?))
            }
        };
        let zero = law.wall().map_or(1.0, |wall| wall / law.range) - law.equilibrium_gap() / law.range;
        Ok(Self { scales, shape, rim: rim.map(|rim| rim / scales.radius), creep: Creep::of(material)?, law, zero })
    }

    /// A value of a controlled quantity in the units of the solver.
    pub(super) fn imposed(&self, quantity: HistoryQuantity, value: f64) -> f64 {
        match quantity {
            HistoryQuantity::Force => value / self.scales.force,
            _ => value / self.scales.gap + self.zero,
        }
    }

    /// A change of a controlled quantity.
    pub(super) fn change(&self, quantity: HistoryQuantity, change: f64) -> f64 {
        if quantity == HistoryQuantity::Force { change / self.scales.force } else { change / self.scales.gap }
    }

    /// A penetration of the solver, coherent.
    pub(super) fn penetration(&self, value: f64, error: f64) -> Estimate {
        self.unit((value - self.zero) * self.scales.gap, error * self.scales.gap)
    }

    /// A value in a unit, coherent.
    pub(super) fn of(&self, value: f64, error: f64, unit: f64) -> Estimate {
        self.unit(value * unit, error * unit)
    }

    fn unit(&self, value: f64, error: f64) -> Estimate {
        Estimate::new(value + 0.0, error + CONVERSION * value.abs())
    }
}

/// The radius R that makes √(R h₀) the radius at which the shape is one range h₀ high, but for the factor that the solver is given: that of a
/// sphere; of a flat face its own.
fn radius_of_units(shape: &IndentationShape, range: f64) -> Result<f64, Refusal> {
    Ok(match shape {
        IndentationShape::Sphere { radius } | IndentationShape::FlatPunch { radius } => *radius,
        IndentationShape::Cone { slope } => range / (slope * slope),
        // (R^{m−1} h₀)^{2/m}/h₀ without overflow.
        IndentationShape::PowerLaw { radius, exponent } => radius * (radius / range).powf(1.0 - 2.0 / exponent),
        IndentationShape::Table { points, .. } => {
            let shape = TabulatedShape::through(points)?;
            // The parabola that is half a range high where the shape is, or as high as the shape at its end.
            let end = shape.reach();
            if shape.height(end) < 0.5 * range {
                return Ok(end * end / (2.0 * shape.height(end)));
            }
            let [_, place] = halved([0.0, end], |place| shape.height(place) < 0.5 * range);
            place * place / range
        }
    })
}
