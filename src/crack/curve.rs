//! What every theory of a steady crack has in common: a curve over the time in which the tip crosses its process zone.

use super::process_zone::Interface;
use super::steep_closing::Correction;
use crate::material::{PlaneMaterial, WeightedMean};
use crate::refusal::Refusal;
use serde::{Deserialize, Serialize};

/// Which way the tip moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Into the solid: the crack grows, and is tougher the faster it runs (G ≥ Δγ).
    Opening,
    /// Into the open side: the crack heals, and heals under less pull the faster it runs (G ≤ Δγ).
    Closing,
}

/// One point of a steady curve.
///
/// The drive D measures the load without dividing by a modulus that may be zero: halves·K²/(2Δγ) in Pa for an opening crack, so that
/// G/Δγ = D/E0, and halves·(K₁/E0)²/(2Δγ) in 1/Pa for a closing one, so that G/Δγ = D·E0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// D (Pa opening, 1/Pa closing).
    pub drive: f64,
    /// d ln D/d ln T: in [−1, 0] opening, in [0, 1] closing.
    pub drive_log_slope: f64,
    /// Bound on the relative error of D at the given T.
    pub drive_relative_error: f64,
    /// ℓ (m), the length crossed in the time T: the process zone of a zone theory, the cut-off of Persson and Brener's over 2π.
    pub crossing_length: f64,
    /// d ln ℓ/d ln T, less than 1, so that v = ℓ/T falls with T.
    pub length_log_slope: f64,
    /// Bound on the relative error of ℓ at the given T.
    pub length_relative_error: f64,
    /// Number of kernel evaluations (terms times means) spent on this point.
    pub kernel_evaluations: u64,
}

impl CurvePoint {
    /// The point of a theory whose drive is the inverse of a mean of the material's memory, D = 1/mean, with the interface's zone length.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a zone length that does not exist for the material or motion.
    pub fn of_mean(
        mean: &WeightedMean,
        interface: &Interface,
        material: &PlaneMaterial,
        motion: Motion,
        crossing_time: f64,
        kernel_evaluations: u64,
    ) -> Result<Self, Refusal> {
        let drive =
            WeightedMean { value: 1.0 / mean.value, log_slope: -mean.log_slope, relative_error: mean.relative_error + 0.5 * f64::EPSILON };
        let zone = interface.zone_length(material, motion, crossing_time, &drive)?;
        Ok(Self {
            drive: drive.value,
            drive_log_slope: drive.log_slope,
            drive_relative_error: drive.relative_error,
            crossing_length: zone.length,
            length_log_slope: zone.log_slope,
            length_relative_error: zone.relative_error,
            kernel_evaluations: kernel_evaluations + zone.kernel_evaluations,
        })
    }
}

/// A theory of steady cracks.
pub trait SteadyCurve {
    /// The point that belongs to a crossing time T > 0 (s); T = ∞ is the crack at rest, T = 0 the infinitely fast one.
    ///
    /// # Errors
    /// The law of the process zone may not exist for the material ([`Refusal::Undefined`]).
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal>;

    /// The plane material of the deformable half.
    fn material(&self) -> &PlaneMaterial;

    /// Which way the tip moves.
    fn motion(&self) -> Motion;

    /// Whether ℓ(T) stays between its values at T = 0 and T = ∞, so that these bracket a root.
    fn length_is_bounded_by_its_limits(&self) -> bool;

    /// A correction of the crossing time at a given speed from a residual in extended precision, where the theory offers one.
    fn sharpened(&self, speed: f64, crossing_time: f64) -> Option<Correction>;

    /// G/Δγ at this drive; kept inside the limits 1 and β (or 1/β), which the theory never passes and rounding may by an ulp.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material (E0 = 0), which has no energy release rate at a distance.
    fn energy_release_rate_ratio(&self, drive: f64) -> Result<f64, Refusal> {
        let modulus = self.material().solid_modulus("the energy release rate far from the tip")?;
        let beta = self.material().stiffening_ratio();
        Ok(match self.motion() {
            Motion::Opening => (drive / modulus).clamp(1.0, beta),
            Motion::Closing => (drive * modulus).clamp(1.0 / beta, 1.0),
        })
    }
}
