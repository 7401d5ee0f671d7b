//! The interface: what it costs to part it, and over what length it parts.
//!
//! | law | length | source |
//! |---|---|---|
//! | [`ProcessZone::Constant`] | a given δ | thesis Sec 5.2, and Eq 5.42 with δ = α a₀ |
//! | [`ProcessZone::Growing`] | δ = α (K/(√(2π)σ_c))² = α a₀ G/Δγ, with the remote K₁ when closing | thesis Eqs 5.25, 5.41 |
//! | [`ProcessZone::Schapery`] | closing only: the δ for which K₁ = ασ₀E0√(2/π) ∫₀^δ J((δ − ζ)/v) ζ^{−1/2} dζ | thesis Eq 5.43, mended (E0 and the sign of its argument) |

use super::body::CrackBody;
use super::curve::Motion;
use crate::material::{PlaneMaterial, WeightedMean};
use crate::refusal::{Refusal, require_positive};
use crate::special::cohesive_kernel::{closing_intensity_kernel, closing_intensity_kernel_slope};

/// How the process-zone length follows from the state of the crack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ProcessZone {
    /// A fixed length (m).
    Constant {
        /// δ (m).
        length: f64,
    },
    /// A length that grows with the square of the stress intensity.
    Growing {
        /// σ_c (Pa).
        cohesive_stress: f64,
        /// α, a number of order one; 1/π makes the theory agree with Persson and Brener's in both limits.
        factor: f64,
    },
    /// Schapery's length of a closing zone under a constant cohesive stress.
    Schapery {
        /// σ₀ (Pa).
        cohesive_stress: f64,
        /// α, a number of order one; 1 is Schapery's own.
        factor: f64,
    },
}

/// A process-zone length as a function of the crossing time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZoneLength {
    /// δ (m).
    pub length: f64,
    /// d ln δ/d ln T.
    pub log_slope: f64,
    /// Bound on the relative error.
    pub relative_error: f64,
    /// Number of kernel evaluations it took, besides those of the drive.
    pub kernel_evaluations: u64,
}

/// What the faces of a crack do to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interface {
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// The law of the process-zone length.
    pub process_zone: ProcessZone,
    /// Which faces deform.
    pub body: CrackBody,
}

impl Interface {
    /// Checks every number of the interface.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not positive and finite.
    pub fn checked(self) -> Result<Self, Refusal> {
        require_positive("work_of_adhesion", self.work_of_adhesion)?;
        match self.process_zone {
            ProcessZone::Constant { length } => {
                require_positive("process_zone", length)?;
            }
            ProcessZone::Growing { cohesive_stress, factor } | ProcessZone::Schapery { cohesive_stress, factor } => {
                require_positive("cohesive_stress", cohesive_stress)?;
                require_positive("process_zone_factor", factor)?;
            }
        }
        Ok(self)
    }

    /// a₀ = E0Δγ/(πσ_c²) per half (m): the zone of [`ProcessZone::Growing`] with α = 1 at rest. None for a constant length.
    #[must_use]
    pub fn relaxed_zone(&self, material: &PlaneMaterial) -> Option<f64> {
        match self.process_zone {
            ProcessZone::Constant { .. } => None,
            ProcessZone::Growing { cohesive_stress, .. } | ProcessZone::Schapery { cohesive_stress, .. } => Some(
                self.body.intensity_squared(self.work_of_adhesion, material.relaxed_modulus())
                    / (std::f64::consts::TAU * cohesive_stress * cohesive_stress),
            ),
        }
    }

    /// The process-zone length where the drive is `drive` and the zone is crossed in `crossing_time`.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a law that has no length in this motion or for this material.
    pub fn zone_length(
        &self,
        material: &PlaneMaterial,
        motion: Motion,
        crossing_time: f64,
        drive: &WeightedMean,
    ) -> Result<ZoneLength, Refusal> {
        let rounding = 6.0 * f64::EPSILON;
        match self.process_zone {
            ProcessZone::Constant { length } => Ok(ZoneLength { length, log_slope: 0.0, relative_error: 0.0, kernel_evaluations: 0 }),
            ProcessZone::Growing { cohesive_stress, factor } => {
                let intensity_squared = match motion {
                    Motion::Opening => self.body.intensity_squared(self.work_of_adhesion, drive.value),
                    Motion::Closing => {
                        let modulus = material.solid_modulus("a closing process zone that grows with the remote stress intensity")?;
                        self.body.intensity_squared(self.work_of_adhesion, drive.value) * modulus * modulus
                    }
                };
                Ok(ZoneLength {
                    length: factor * intensity_squared / (std::f64::consts::TAU * cohesive_stress * cohesive_stress),
                    log_slope: drive.log_slope,
                    relative_error: drive.relative_error + rounding,
                    kernel_evaluations: 0,
                })
            }
            ProcessZone::Schapery { cohesive_stress, factor } => {
                if motion == Motion::Opening {
                    return Err(Refusal::Undefined {
                        quantity: "Schapery's closing zone length (5.43) of an opening crack",
                        reason: "it is the length of a healing zone; name a length or a growing zone instead".into(),
                    });
                }
                // (K₁/E0)² = α²σ₀²(2/π) δ N² with N = ∫₀¹ J(T(1−r)) r^{−1/2} dr: solved for δ.
                let mean = closing_intensity_mean(material, crossing_time);
                let stress = factor * cohesive_stress * mean.value;
                Ok(ZoneLength {
                    length: self.body.intensity_squared(self.work_of_adhesion, drive.value) * std::f64::consts::FRAC_PI_2
                        / (stress * stress),
                    log_slope: drive.log_slope - 2.0 * mean.log_slope,
                    relative_error: drive.relative_error + 2.0 * mean.relative_error + rounding,
                    kernel_evaluations: material.creep_kernel_count(),
                })
            }
        }
    }
}

/// N = ∫₀¹ J(T(1 − r)) r^{−1/2} dr (1/Pa): the mean that a constant closing stress forms of the creep function.
#[must_use]
pub(crate) fn closing_intensity_mean(material: &PlaneMaterial, crossing_time: f64) -> WeightedMean {
    // Flow: ∫ (1 − r) r^{−1/2} dr = 4/3.
    material.creep_mean(crossing_time, 2.0, 4.0 / 3.0, |z| (closing_intensity_kernel(z), closing_intensity_kernel_slope(z)))
}
