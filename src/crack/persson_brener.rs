//! Persson and Brener's theory: bulk dissipation outside a cut-off length.
//!
//! ```text
//! opening   D = 1/[1/E0 − Σ J_j κ(c_j)]         G/Δγ = 1/[1 − Σ J_jE0 κ(c_j)]              κ(c) = c/(1 + √(1 + c²))
//! closing   D = 1/[E0 + Σ E_i κ(c_i)]           G/Δγ = 1/[1 + Σ (E_i/E0) κ(c_i)]           c = 2πvτ/a  (τ_j opening, ρ_i closing)
//! ```
//! a is the cut-off, a₀G/Δγ when it grows (α = 1) or a constant. The crossing time is T = a/(2πv), so c = τ/T. Written with the
//! complement 1 − κ(c) = (1 + √(1+c²) − c)/(1 + √(1+c²)), both denominators are sums of positive terms.
//!
//! Opening: Persson and Brener (2005), DOI 10.1103/PhysRevE.71.036123, here with the loss integral done term by term. It agrees with the
//! virtual-work theory in both limits exactly if α = 1/π there. Closing: not Persson's published adaptation but its energy-consistent
//! counterpart, the same loss integral over the relaxation modulus, which reaches Δγ/β as it must.

use super::curve::{CurvePoint, Motion, SteadyCurve};
use super::process_zone::{Interface, ProcessZone};
use super::steep_closing::Correction;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use std::f64::consts::TAU;

/// Persson and Brener's theory of a steady crack.
#[derive(Debug, Clone, PartialEq)]
pub struct PerssonBrener<'a> {
    material: &'a PlaneMaterial,
    motion: Motion,
    interface: Interface,
}

impl<'a> PerssonBrener<'a> {
    /// A crack in a plane material; the process-zone law of the interface is read as the law of the cut-off length.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an interface with a number that is not positive and finite.
    pub fn new(material: &'a PlaneMaterial, motion: Motion, interface: Interface) -> Result<Self, Refusal> {
        Ok(Self { material, motion, interface: interface.checked()? })
    }
}

/// κ(c) with c = 1/z and dκ/d ln z = −κ/√(1 + c²), for z ≥ 0 (z = 0 gives κ = 1).
fn loss_kernel(z: f64) -> (f64, f64) {
    if z.is_infinite() {
        return (0.0, 0.0);
    }
    // κ = 1/(z + √(z² + 1)): no overflow at z → 0, no cancellation anywhere.
    let root = z.hypot(1.0);
    let kappa = 1.0 / (z + root);
    (kappa, -kappa * (z / root))
}

/// 1 − κ = (1 − κ) with the same argument, as a ratio of positive numbers, and its slope in ln z.
fn loss_kernel_complement(z: f64) -> (f64, f64) {
    if z.is_infinite() {
        return (1.0, 0.0);
    }
    let root = z.hypot(1.0);
    // 1 − κ = (z + root − 1)/(z + root) and root − 1 = z²/(root + 1).
    ((z + z * (z / (root + 1.0))) / (z + root), z / (z + root) / root)
}

impl SteadyCurve for PerssonBrener<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        let (mean, kernels) = match self.motion {
            // Flow: J_j(1 − κ) → (J_j/τ_j) T as τ_j grows at a fixed rate J_j/τ_j = 1/η.
            Motion::Opening => {
                (self.material.creep_mean(crossing_time, 1.0, 1.0, loss_kernel_complement), self.material.creep_kernel_count())
            }
            Motion::Closing => (self.material.relaxation_mean(crossing_time, 1.0, loss_kernel), self.material.relaxation_kernel_count()),
        };
        // The cut-off is crossed in a/v = 2πT, the time that Schapery's length asks for.
        let point = CurvePoint::of_mean(&mean, &self.interface, self.material, self.motion, TAU * crossing_time, kernels)?;
        Ok(CurvePoint {
            crossing_length: point.crossing_length / TAU,
            length_relative_error: point.length_relative_error + f64::EPSILON,
            ..point
        })
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

    fn sharpened(&self, _speed: f64, _crossing_time: f64) -> Option<Correction> {
        None
    }
}
