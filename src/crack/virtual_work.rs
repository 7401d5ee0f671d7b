//! The theory of the thesis: the work of the tip stresses over a process zone equals the work of adhesion.
//!
//! Because ∫₀^x y^{−1/2} (x − y)^{1/2} dy = πx/2 for every x, the double integrals of Eqs 5.19 and 5.37 collapse to a running mean over
//! the crossing time T = δ/v, exactly and for any material (c is the number of deformable halves):
//! ```text
//! opening   ½ c K² ⟨J⟩(T) = Δγ                 D = 1/⟨J⟩          G/Δγ = 1/(E0⟨J⟩)      from 1 (rest) to β (fast)
//! closing   ½ c (K₁/E0)² ⟨R⟩(T) = Δγ           D = 1/⟨R⟩          G/Δγ = E0/⟨R⟩         from 1 (rest) to 1/β (fast)
//! ```
//! ⟨J⟩ and ⟨R⟩ are sums of positive terms, so nothing cancels at any speed. Source: thesis Secs 5.2 and 5.3; Eq 5.40 holds with the
//! remote intensity K₁.

use super::curve::{CurvePoint, Motion, SteadyCurve};
use super::process_zone::{Interface, ProcessZone};
use super::steep_closing::{self, Correction};
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// The virtual-work theory of a steady crack.
#[derive(Debug, Clone, PartialEq)]
pub struct VirtualWork<'a> {
    material: &'a PlaneMaterial,
    motion: Motion,
    interface: Interface,
}

impl<'a> VirtualWork<'a> {
    /// A crack in a plane material with a given interface.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an interface with a number that is not positive and finite.
    pub fn new(material: &'a PlaneMaterial, motion: Motion, interface: Interface) -> Result<Self, Refusal> {
        Ok(Self { material, motion, interface: interface.checked()? })
    }
}

impl SteadyCurve for VirtualWork<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        let (mean, kernels) = match self.motion {
            Motion::Opening => (self.material.mean_creep(crossing_time), self.material.creep_kernel_count()),
            Motion::Closing => (self.material.mean_relaxation(crossing_time), self.material.relaxation_kernel_count()),
        };
        CurvePoint::of_mean(&mean, &self.interface, self.material, self.motion, crossing_time, kernels)
    }

    fn material(&self) -> &PlaneMaterial {
        self.material
    }

    fn motion(&self) -> Motion {
        self.motion
    }

    fn length_is_bounded_by_its_limits(&self) -> bool {
        !matches!(self.interface.process_zone, ProcessZone::Schapery { .. })
    }

    fn sharpened(&self, speed: f64, crossing_time: f64) -> Option<Correction> {
        match self.motion {
            Motion::Opening => None,
            Motion::Closing => steep_closing::correction(self.material, &self.interface, speed, crossing_time),
        }
    }
}
