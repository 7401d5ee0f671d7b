//! From SI to the reduced units of this room and back.

use super::problem::Creep;
use crate::finite_range::law::Attraction;
use crate::material::Material;
use crate::refusal::{Refusal, require_positive};

/// The units of a sphere of radius R, a law of work Δγ and range h₀, and a body of relaxed modulus E₀*.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// h₀, the unit of gaps and penetrations (m).
    pub gap: f64,
    /// √(R h₀), the unit of radii (m).
    pub radius: f64,
    /// Δγ/h₀, the unit of pressures (Pa).
    pub pressure: f64,
    /// RΔγ, the unit of forces (N).
    pub force: f64,
    /// RΔγh₀, the unit of works and energies (J).
    pub work: f64,
    /// (RΔγ²/(E₀*²h₀³))^{1/3}.
    pub tabor: f64,
}

impl Scales {
    /// The scales; `material` carries plane moduli E* = E/(1 − ν²), see [`Material::stiffened`].
    ///
    /// # Errors
    /// [`Refusal`] unless the radius is positive and finite and the material is a solid.
    pub fn new(radius: f64, attraction: &Attraction, material: &Material) -> Result<Self, Refusal> {
        require_positive("radius", radius)?;
        let modulus = material.solid_modulus("the sphere of finite range")?;
        let (gap, work) = (attraction.range, attraction.work_of_adhesion);
        let tabor = (radius * (work / modulus).powi(2)).cbrt() / gap;
        let lateral = (radius * gap).sqrt();
        Ok(Self { gap, radius: lateral, pressure: work / gap, force: radius * work, work: radius * work * gap, tabor })
    }
}

impl Creep {
    /// The creep of a material, relative to its relaxed modulus; times stay in seconds.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material.
    pub fn of(material: &Material) -> Result<Self, Refusal> {
        material.solid_modulus("the sphere of finite range")?;
        let terms = material.creep_terms();
        let sum: f64 = terms.iter().map(|term| term.compliance).sum();
        let fractions = terms.iter().map(|term| term.compliance / sum).collect();
        let times = terms.iter().map(|term| term.retardation_time).collect();
        Ok(Self { stiffening: material.stiffening_ratio(), fractions, times })
    }
}
