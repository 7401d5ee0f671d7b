//! From coherent units to those of the solver and back.
//!
//! The solver counts the penetration from where the undeformed apex lies one range above the undeformed plane (at the wall, if there is one);
//! a scene counts it from where that gap is the law's own gap of zero stress, so that both edge theory and law of short range have one zero.

use super::super::scale::Scale;
use crate::scene::typed::{HistoryQuantity, Indentation, IndentationShape, SceneAttraction};
use viscotack::estimate::Estimate;
use viscotack::finite_range::law::Attraction;
use viscotack::finite_range::sphere::{Creep, Scales, Shape};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Rounding of the way to the units of the solver and back, relative.
const CONVERSION: f64 = 8.0 * f64::EPSILON;

/// The problem in the units of the solver.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reduced {
    pub(super) scales: Scales,
    pub(super) shape: Shape,
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
        // The radius R that makes √(R h₀) the radius at which the shape is one range high, but for the factor that the solver is given.
        let (radius, shape) = match indentation.shape {
            IndentationShape::Sphere { radius } => (radius, Shape::Paraboloid),
            IndentationShape::Cone { slope } => (law.range / (slope * slope), Shape::Power { coefficient: 1.0, exponent: 1.0 }),
            IndentationShape::PowerLaw { radius, exponent } => {
                // (R^{m−1} h₀)^{2/m}/h₀ without overflow.
                let effective = radius * (radius / law.range).powf(1.0 - 2.0 / exponent);
                (effective, Shape::Power { coefficient: 1.0 / exponent, exponent })
            }
            IndentationShape::FlatPunch { .. } | IndentationShape::Table { .. } => {
                return Err(Refusal::Undefined {
                    quantity: "a contact with attraction of finite range",
                    reason: "only spheres, cones and power laws are solved; give process_zone in place of law for other shapes".into(),
                });
            }
        };
        let zero = law.wall().map_or(1.0, |wall| wall / law.range) - law.equilibrium_gap() / law.range;
        Ok(Self { scales: Scales::new(radius, &law, material)?, shape, creep: Creep::of(material)?, law, zero })
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
