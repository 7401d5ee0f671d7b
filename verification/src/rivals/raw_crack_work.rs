//! Steady cracks by the double integrals as the thesis prints them (Eqs 5.11 with 5.19, and 5.30 with 5.37), without the collapse.
//!
//! ```text
//! opening   (1/2δ) ∫₀^δ σ(x) [u(x − δ) − u₀] dx,     u(−s) − u₀ = J(0) u₁(s) + ∫₀^{s/v} J′(t) u₁(s − vt) dt,   u₁(s) = K√(8s/π)
//! closing   (1/2δ) ∫₀^δ σ(−x) [u(δ − x) − u₀] dx,    σ(d) = R(0) σ₁(d) + ∫₀^{d/v} R′(t) σ₁(d − vt) dt,         σ₁(d) = (K₁/E0)/√(2πd)
//! ```
//! Both integrals by the same quadrature as the closure, one inside the other: some 10⁵ exponentials per term and point, where the
//! collapsed form takes one. Slow, and right: it is the rival that shows what the collapse is worth.

use std::cell::Cell;
use std::f64::consts::{PI, TAU};
use viscotack::crack::curve::{CurvePoint, Motion, SteadyCurve};
use viscotack::crack::process_zone::Interface;
use viscotack::crack::steep_closing::Correction;
use viscotack::material::{PlaneMaterial, WeightedMean};
use viscotack::refusal::Refusal;
use viscotack::special::log_quadrature::integrate_between_edges;

/// Step of the numerical derivative that Newton's method needs: third root of the rounding.
const DERIVATIVE_STEP: f64 = 6e-6;

/// The raw double integral as a theory of steady cracks.
#[derive(Debug, Clone)]
pub struct RawCrackWork<'a> {
    material: &'a PlaneMaterial,
    motion: Motion,
    interface: Interface,
    tolerance: f64,
}

impl<'a> RawCrackWork<'a> {
    /// A crack in a plane material; both quadratures run to a relative `tolerance`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an interface with a number that is not positive and finite.
    pub fn new(material: &'a PlaneMaterial, motion: Motion, interface: Interface, tolerance: f64) -> Result<Self, Refusal> {
        Ok(Self { material, motion, interface: interface.checked()?, tolerance })
    }

    /// 2/K² times the work (opening) or 2/(K₁/E0)² times it (closing) for a crossing time T, with the number of integrand evaluations.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] if a quadrature misses its tolerance.
    pub fn mean(&self, crossing_time: f64) -> Result<(f64, f64, u64), Refusal> {
        if crossing_time == 0.0 || crossing_time.is_infinite() {
            let at_rest = crossing_time.is_infinite();
            let value = match (self.motion, at_rest) {
                (Motion::Opening, true) => 1.0 / self.material.relaxed_modulus(),
                (Motion::Opening, false) => 1.0 / self.material.glassy_modulus(),
                (Motion::Closing, true) => self.material.relaxed_modulus(),
                (Motion::Closing, false) => self.material.glassy_modulus(),
            };
            return Ok((value, 0.0, 1));
        }
        // Lengths in units of δ and times in units of T, so that v = 1.
        let evaluations = Cell::new(0);
        let refusal = Cell::new(None);
        let integral = integrate_between_edges(
            |inside, outside| {
                let field = match self.motion {
                    Motion::Opening => {
                        self.unit_opening(outside, crossing_time, &evaluations).map(|opening| opening / (TAU * inside).sqrt())
                    }
                    Motion::Closing => {
                        self.unit_stress(inside, crossing_time, &evaluations).map(|stress| stress * (8.0 * outside / PI).sqrt())
                    }
                };
                field.unwrap_or_else(|reason| {
                    refusal.set(Some(reason));
                    f64::NAN
                })
            },
            self.tolerance,
        );
        if let Some(reason) = refusal.into_inner() {
            return Err(reason);
        }
        let integral = integral?;
        Ok((integral.value, integral.error / integral.value, evaluations.get()))
    }

    /// (u − u₀)/K at a distance s behind the tip, both in units of the process zone (5.11).
    fn unit_opening(&self, distance: f64, crossing_time: f64, evaluations: &Cell<u64>) -> Result<f64, Refusal> {
        let elastic = (8.0 * distance / PI).sqrt();
        if self.material.is_elastic() {
            return Ok(elastic / self.material.glassy_modulus());
        }
        let duration = distance * crossing_time;
        let memory = integrate_between_edges(|past, rest| self.material.creep_rate(past * duration) * rest.sqrt(), self.tolerance)?;
        evaluations.set(evaluations.get() + memory.evaluations);
        Ok(elastic * (1.0 / self.material.glassy_modulus() + duration * memory.value))
    }

    /// σ/(K₁/E0) at a distance d inside the healed side, lengths in units of the process zone (5.30).
    fn unit_stress(&self, distance: f64, crossing_time: f64, evaluations: &Cell<u64>) -> Result<f64, Refusal> {
        let elastic = 1.0 / (TAU * distance).sqrt();
        if self.material.is_elastic() {
            return Ok(elastic * self.material.glassy_modulus());
        }
        let duration = distance * crossing_time;
        let memory = integrate_between_edges(|past, rest| self.material.relaxation_rate(past * duration) / rest.sqrt(), self.tolerance)?;
        evaluations.set(evaluations.get() + memory.evaluations);
        Ok(elastic * (self.material.glassy_modulus() + duration * memory.value))
    }
}

impl SteadyCurve for RawCrackWork<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        let (mean, error, mut evaluations) = self.mean(crossing_time)?;
        let mut slope = 0.0;
        if crossing_time > 0.0 && crossing_time.is_finite() {
            let (above, _, more) = self.mean(crossing_time * (1.0 + DERIVATIVE_STEP))?;
            slope = (above / mean).ln() / DERIVATIVE_STEP;
            evaluations += more;
        }
        let mean = WeightedMean { value: mean, log_slope: slope, relative_error: error };
        CurvePoint::of_mean(&mean, &self.interface, self.material, self.motion, crossing_time, evaluations)
    }

    fn material(&self) -> &PlaneMaterial {
        self.material
    }

    fn motion(&self) -> Motion {
        self.motion
    }

    fn length_is_bounded_by_its_limits(&self) -> bool {
        true
    }

    fn sharpened(&self, _speed: f64, _crossing_time: f64) -> Option<Correction> {
        None
    }
}
