//! Steady cracks whose speed and load are known: the crossing time is drawn, and load and speed follow from the double integrals as printed (5.11, 5.19, 5.30, 5.37).

use super::super::draw::Draw;
use crate::rivals::raw_crack_work::RawCrackWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Relative error of the nested quadratures that is asked for.
const QUADRATURE: f64 = 1e-11;
/// What they keep: each of them errs by its own request at every node of the other, and layers of the inner one are added up.
pub const KNOWN_TO: f64 = 1e-9;

/// A crack that is known.
#[derive(Debug, Clone)]
pub struct KnownCrack {
    /// The plane solid.
    pub material: PlaneMaterial,
    /// Opening or closing.
    pub motion: Motion,
    /// Work of adhesion and zone.
    pub interface: Interface,
    /// v (m/s).
    pub speed: f64,
    /// The drive D ([`viscotack::crack::CurvePoint`]).
    pub drive: f64,
    /// G/Δγ.
    pub release: f64,
}

impl KnownCrack {
    /// In words and numbers.
    #[must_use]
    pub fn described(&self) -> String {
        format!(
            "{:?}, β {:.4e}, {} terms, v {:e} m/s, G/Δγ {:.12}, {:?}",
            self.motion,
            self.material.stiffening_ratio(),
            self.material.creep_terms().len(),
            self.speed,
            self.release,
            self.interface.process_zone
        )
    }
}

/// Draws one.
///
/// # Errors
/// Those of making a material and of the quadrature.
pub fn known_crack(draw: &mut Draw) -> Result<KnownCrack, Refusal> {
    let terms = 1 + draw.below(4);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), 1.0 + draw.log_between(0.05, 1e4));
    let (longest, decades) = (draw.log_between(1e-6, 1e6), draw.between(0.5, 8.0));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let motion = if draw.chance(0.5) { Motion::Opening } else { Motion::Closing };
    let body = if draw.chance(0.5) { CrackBody::AgainstRigid } else { CrackBody::TwoHalves };
    let work_of_adhesion = draw.log_between(1e-3, 1e3);
    let process_zone = if draw.chance(0.5) {
        ProcessZone::Constant { length: draw.log_between(1e-9, 1e-3) }
    } else {
        ProcessZone::Growing { cohesive_stress: relaxed * draw.log_between(1e-2, 1e3), factor: draw.between(0.1, 2.0) }
    };
    let interface = Interface { work_of_adhesion, process_zone, body };
    let time = longest * 10f64.powf(draw.between(-decades - 3.0, 3.0));
    let raw = RawCrackWork::new(&material, motion, interface, QUADRATURE)?;
    let (mean, _, _) = raw.mean(time)?;
    let drive = 1.0 / mean;
    let relaxed = material.relaxed_modulus();
    let (release, intensity_squared) = match motion {
        Motion::Opening => (drive / relaxed, body.intensity_squared(work_of_adhesion, drive)),
        Motion::Closing => (drive * relaxed, body.intensity_squared(work_of_adhesion, drive) * relaxed * relaxed),
    };
    let length = match process_zone {
        ProcessZone::Constant { length } => length,
        // δ = α K²/(2πσ_c²) (5.25, 5.41)
        ProcessZone::Growing { cohesive_stress, factor } | ProcessZone::Schapery { cohesive_stress, factor } => {
            factor * intensity_squared / (std::f64::consts::TAU * cohesive_stress * cohesive_stress)
        }
    };
    let speed = length / time;
    Ok(KnownCrack { material, motion, interface, speed, drive, release })
}
