//! The cohesive-zone theory of Dugdale, Schapery and Greenwood: a constant stress σ₀ holds the faces over a length δ.
//!
//! With T = δ/v, c the number of deformable halves, and all means over 0 < r < 1:
//! ```text
//! opening   δ = πK²/(8σ₀²)                               D = 1/∫ J(T(1−r)) artanh√r dr
//! closing   K₁/E0 = σ₀√(2δ/π) N,   N = ∫ J(T(1−r)) r^{−1/2} dr
//!           Δγ = (2cσ₀²δ/π) M,     M = ∫ J(T(1−r)) [2r^{−1/2} − 2 artanh√r] dr          D = N²/(2M)
//! ```
//! Opening: Schapery (1975), DOI 10.1007/BF00034721; closing: Schapery (1989), DOI 10.1007/BF00047448, and Greenwood (2004),
//! DOI 10.1088/0022-3727/37/18/011; thesis Eq 5.43 with J((δ − ζ)/v) and the missing modulus put right. The closing criterion (the work
//! of σ₀ on the closing gap is Δγ) is derived, not printed, in the thesis.

use super::body::CrackBody;
use super::curve::{CurvePoint, Motion, SteadyCurve};
use super::process_zone::closing_intensity_mean;
use super::steep_closing::Correction;
use crate::material::PlaneMaterial;
use crate::refusal::{Refusal, require_positive};
use crate::special::cohesive_kernel::{closing_work_kernel, closing_work_kernel_slope, opening_kernel, opening_kernel_slope};
use std::f64::consts::{FRAC_PI_2, PI};

/// The constant-stress cohesive-zone theory of a steady crack.
#[derive(Debug, Clone, PartialEq)]
pub struct CohesiveZone<'a> {
    material: &'a PlaneMaterial,
    motion: Motion,
    work_of_adhesion: f64,
    cohesive_stress: f64,
    body: CrackBody,
}

impl<'a> CohesiveZone<'a> {
    /// A crack in a plane material whose faces attract with a constant stress (Pa) until the work of adhesion (J/m²) is spent.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not positive and finite.
    pub fn new(
        material: &'a PlaneMaterial,
        motion: Motion,
        work_of_adhesion: f64,
        cohesive_stress: f64,
        body: CrackBody,
    ) -> Result<Self, Refusal> {
        require_positive("work_of_adhesion", work_of_adhesion)?;
        require_positive("cohesive_stress", cohesive_stress)?;
        Ok(Self { material, motion, work_of_adhesion, cohesive_stress, body })
    }
}

impl SteadyCurve for CohesiveZone<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        let stress_squared = self.cohesive_stress * self.cohesive_stress;
        let work_per_half = self.work_of_adhesion / self.body.deformable_halves();
        let rounding = 4.0 * f64::EPSILON;
        Ok(match self.motion {
            Motion::Opening => {
                // ∫ artanh√r dr = 1; flow: ∫ (1 − r) artanh√r dr = 1/3.
                let mean = self.material.creep_mean(crossing_time, 1.0, 1.0 / 3.0, |z| (opening_kernel(z), opening_kernel_slope(z)));
                let drive = 1.0 / mean.value;
                CurvePoint {
                    drive,
                    drive_log_slope: -mean.log_slope,
                    drive_relative_error: mean.relative_error + f64::EPSILON,
                    crossing_length: PI / 8.0 * (2.0 * work_per_half * drive) / stress_squared,
                    length_log_slope: -mean.log_slope,
                    length_relative_error: mean.relative_error + rounding,
                    kernel_evaluations: self.material.creep_kernel_count(),
                }
            }
            Motion::Closing => {
                let intensity = closing_intensity_mean(self.material, crossing_time);
                // ∫ [2r^{−1/2} − 2 artanh√r] dr = 2; flow: 2·4/3 − 2/3 = 2.
                let work = self.material.creep_mean(crossing_time, 2.0, 2.0, |z| (closing_work_kernel(z), closing_work_kernel_slope(z)));
                CurvePoint {
                    drive: intensity.value * intensity.value / (2.0 * work.value),
                    drive_log_slope: 2.0 * intensity.log_slope - work.log_slope,
                    drive_relative_error: 2.0 * intensity.relative_error + work.relative_error + rounding,
                    crossing_length: FRAC_PI_2 * work_per_half / (stress_squared * work.value),
                    length_log_slope: -work.log_slope,
                    length_relative_error: work.relative_error + rounding,
                    kernel_evaluations: 2 * self.material.creep_kernel_count(),
                }
            }
        })
    }

    fn material(&self) -> &PlaneMaterial {
        self.material
    }

    fn motion(&self) -> Motion {
        self.motion
    }

    fn length_is_bounded_by_its_limits(&self) -> bool {
        // The work mean M of a closing zone rises above its relaxed value by up to 6 % before it falls back to it.
        self.motion == Motion::Opening
    }

    fn sharpened(&self, _speed: f64, _crossing_time: f64) -> Option<Correction> {
        None
    }
}
