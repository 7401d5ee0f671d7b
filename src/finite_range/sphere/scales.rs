//! From SI to the reduced units of this module and back.

use super::problem::Creep;
use crate::finite_range::law::Attraction;
use crate::material::PlaneMaterial;
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
    /// The relaxed Tabor number (RΔγ²/(E₀*²h₀³))^{1/3}, without unit.
    pub tabor: f64,
}

impl Scales {
    /// The scales of a tip radius (m), a law in SI (m, J/m²) and a solid in plane moduli E* (Pa).
    ///
    /// # Errors
    /// [`Refusal`] unless the radius is positive and finite and the material is a solid.
    pub fn new(radius: f64, attraction: &Attraction, material: &PlaneMaterial) -> Result<Self, Refusal> {
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
    pub fn of(material: &PlaneMaterial) -> Result<Self, Refusal> {
        material.solid_modulus("the sphere of finite range")?;
        let terms = material.creep_terms();
        let sum: f64 = terms.iter().map(|term| term.compliance).sum();
        let fractions = terms.iter().map(|term| term.compliance / sum).collect();
        let times = terms.iter().map(|term| term.retardation_time).collect();
        Ok(Self { stiffening: material.stiffening_ratio(), fractions, times })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::needless_range_loop)]
mod tests {
    use super::*;
    use crate::finite_range::law::Law;
    use crate::material::CreepTerm;

    #[test]
    fn a_glass_bead_on_soft_rubber() {
        // R 10 um, E0* 1 MPa, E∞* 10 MPa, 50 mJ/m², 1 nm: m = √R Δγ/(E0* h0^{3/2}).
        let terms = [0.3, 0.6].map(|part| CreepTerm { compliance: 1e-6 * part, retardation_time: part });
        let material = PlaneMaterial::from_creep(1e7, &terms, None).unwrap();
        let attraction = Attraction::new(Law::LennardJones, 0.05, 1e-9).unwrap();
        let scales = Scales::new(1e-5, &attraction, &material).unwrap();
        let coupling = 1e-5_f64.sqrt() * 0.05 / (1e6 * 1e-9_f64.powf(1.5));
        assert!((scales.tabor.powf(1.5) / coupling - 1.0).abs() < 1e-12);
        assert!((scales.force / 5e-7 - 1.0).abs() < 1e-12 && (scales.pressure / 5e7 - 1.0).abs() < 1e-12);
        let creep = Creep::of(&material).unwrap();
        assert!((creep.stiffening - 10.0).abs() < 1e-12 && (creep.fractions.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!(creep.times[0] > creep.times[1] && (creep.fractions[0] / creep.fractions[1] - 2.0).abs() < 1e-12);
        assert!(Creep::of(&PlaneMaterial::from_creep(1e7, &terms, Some(1.0)).unwrap()).is_err());
    }
}
