//! Stress and opening around the tip: the trumpet of an opening crack, the stress of a closing one, and the two tip radii.
//!
//! ```text
//! opening   σ(d) = K/√(2πd)                                    u(s) = K√(8s/π) [1/E∞ + Σ J_j (1 − D(y_j)/y_j)],   y_j = √(s/(vτ_j))
//! closing   σ(d) = (K₁/E0)/√(2πd) [E0 + Σ E_i D′(y_i)]          u(s) = (K₁/E0)√(8s/π),                            y_i = √(d/(vρ_i))
//! ```
//! D is Dawson's integral, D′ = 1 − 2yD its derivative, u the displacement of ONE half. Written in this way the opening has positive
//! terms only and keeps its relative accuracy from the glassy tip (s ≪ vτ, u ∝ K/E∞) to the relaxed far field (u ∝ K/E0), over any
//! number of decades. The closing stress changes sign where the material that was just healed is still stiff: for one term it is
//! compressive between the tip and the far field if and only if β > 4.512 (= 1 − 1/min D′), with a peak at 1.86 vρ for β = 100. Of terms
//! many decades apart each counts by itself, against the modulus that is left after it: a broad spectrum may have no compression at any β.
//! The stress in excess of K₁/√(2πd) carries no net force. Source: thesis Eqs 5.11–5.18, 5.30–5.36.

use super::body::CrackBody;
use super::process_zone::closing_intensity_mean;
use crate::closure::EdgeFields;
use crate::estimate::Estimate;
use crate::material::{GivenSeries, PlaneMaterial};
use crate::refusal::{Refusal, require_non_negative};
use crate::special::dawson::{dawson, dawson_slope};
use std::f64::consts::{PI, TAU};

/// Two quotients and the root, and the distance and the speed to an ulp each.
const DIGITS_OF_Z: f64 = 4.0 * f64::EPSILON;

/// The fields at the tip of a steadily opening crack.
#[derive(Debug, Clone, PartialEq)]
pub struct OpeningTip<'a> {
    material: &'a PlaneMaterial,
    body: CrackBody,
    stress_intensity: f64,
    speed: f64,
}

/// The fields at the tip of a steadily closing crack.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosingTip<'a> {
    material: &'a PlaneMaterial,
    body: CrackBody,
    displacement_intensity: f64,
    speed: f64,
}

/// √(8/π), the crack-opening factor of a unit compliance.
fn opening_factor() -> f64 {
    (8.0 / PI).sqrt()
}

fn checked_speed(speed: f64) -> Result<f64, Refusal> {
    if speed >= 0.0 { Ok(speed) } else { Err(Refusal::out_of_range("speed", speed, "zero or more")) }
}

impl<'a> OpeningTip<'a> {
    /// The tip of a crack with stress intensity K (Pa √m) running at v ≥ 0 (m/s) in a plane material.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite intensity, or a negative speed.
    pub fn new(material: &'a PlaneMaterial, body: CrackBody, stress_intensity: f64, speed: f64) -> Result<Self, Refusal> {
        require_non_negative("stress_intensity", stress_intensity)?;
        Ok(Self { material, body, stress_intensity, speed: checked_speed(speed)? })
    }

    /// u(s) (m): displacement of one face at a distance s ≥ 0 (m) behind the tip; a viscous material at rest opens without limit.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite distance; [`Refusal::Undefined`] for a viscous material at rest.
    pub fn displacement(&self, distance: f64) -> Result<Estimate, Refusal> {
        let distance = require_non_negative("distance", distance)?;
        if self.speed == 0.0 {
            self.material.solid_modulus("the opening of a crack at rest")?;
        }
        if distance == 0.0 {
            return Ok(Estimate::exact(0.0));
        }
        let mean = closing_intensity_mean(self.material, distance / self.speed);
        let value = self.stress_intensity * opening_factor() * distance.sqrt() * (0.5 * mean.value);
        Ok(Estimate::relative(value, mean.relative_error + 3.0 * f64::EPSILON))
    }

    /// ρ₁ = (4/π)(K/E∞)² (m): radius of the tip seen from s ≪ vτ (thesis Eq 5.16).
    #[must_use]
    pub fn glassy_radius(&self) -> f64 {
        4.0 / PI * (self.stress_intensity / self.material.glassy_modulus()).powi(2)
    }

    /// ρ₂ = (4/π)(K/E0)² (m): radius seen from s ≫ vτ (thesis Eq 5.18).
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material.
    pub fn relaxed_radius(&self) -> Result<f64, Refusal> {
        Ok(4.0 / PI * (self.stress_intensity / self.material.solid_modulus("the relaxed tip radius")?).powi(2))
    }
}

impl<'a> ClosingTip<'a> {
    /// The tip of a crack with displacement intensity K₁/E0 (√m) healing at v ≥ 0 (m/s) in a plane material.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite intensity, or a negative speed.
    pub fn new(material: &'a PlaneMaterial, body: CrackBody, displacement_intensity: f64, speed: f64) -> Result<Self, Refusal> {
        require_non_negative("displacement_intensity", displacement_intensity)?;
        Ok(Self { material, body, displacement_intensity, speed: checked_speed(speed)? })
    }

    /// σ(d) (Pa, tension positive) at a distance d > 0 (m) inside the healed side.
    ///
    /// The error is relative to the sum of the magnitudes of its parts: near a change of sign the relative error grows accordingly.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] unless the distance is positive and finite.
    pub fn stress(&self, distance: f64) -> Result<Estimate, Refusal> {
        let distance = crate::refusal::require_positive("distance", distance)?;
        let relaxed = self.material.relaxed_modulus();
        let (mut sum, mut magnitude, mut conversion) = (relaxed, relaxed, 0.0);
        for (index, term) in self.material.relaxation_terms().iter().enumerate() {
            let y = (distance / self.speed / term.relaxation_time).sqrt();
            let slope = dawson_slope(y);
            sum += term.modulus * slope;
            // The slope itself is 1 − 2yD below the seam of its asymptotic series: its error is that of a number of order one.
            magnitude += term.modulus * if y < 6.3 { 1.0 } else { slope.abs() };
            // dD′/d ln z = −yD − y²D′ with z = y²: of a converted series, and of the last digits of z.
            let time_slope = if y.is_finite() { (y * dawson(y) + y * y * slope).abs() } else { 0.0 };
            conversion += term.modulus * time_slope * DIGITS_OF_Z;
            if self.material.given() == GivenSeries::Creep
                && let Some(error) = self.material.conversion_errors().get(index)
            {
                conversion += term.modulus * (slope.abs() * error.strength + time_slope * error.time);
            }
        }
        let amplitude = self.displacement_intensity / (TAU * distance).sqrt();
        let terms = self.material.relaxation_terms().len() as f64;
        let error = conversion + magnitude * (6.0 + 0.5 * terms) * 0.5 * f64::EPSILON;
        Ok(Estimate::new(amplitude * sum, amplitude * error + 2.0 * f64::EPSILON * (amplitude * sum).abs()))
    }

    /// u(s) (m): displacement of one face at a distance s ≥ 0 (m) on the open side, the elastic shape at any speed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative or non-finite distance.
    pub fn displacement(&self, distance: f64) -> Result<Estimate, Refusal> {
        let distance = require_non_negative("distance", distance)?;
        Ok(Estimate::relative(self.displacement_intensity * opening_factor() * distance.sqrt(), 3.0 * f64::EPSILON))
    }

    /// (4/π)(K₁/E0)² (m): the one tip radius of a closing crack; it has no trumpet (thesis Sec 5.3).
    #[must_use]
    pub fn radius(&self) -> f64 {
        4.0 / PI * self.displacement_intensity.powi(2)
    }
}

impl EdgeFields for OpeningTip<'_> {
    fn tension(&self, distance_inside: f64) -> f64 {
        self.stress_intensity / (TAU * distance_inside).sqrt()
    }

    fn gap(&self, distance_outside: f64) -> f64 {
        self.displacement(distance_outside).map_or(f64::NAN, |estimate| self.body.deformable_halves() * estimate.value)
    }
}

impl EdgeFields for ClosingTip<'_> {
    fn tension(&self, distance_inside: f64) -> f64 {
        self.stress(distance_inside).map_or(f64::NAN, |estimate| estimate.value)
    }

    fn gap(&self, distance_outside: f64) -> f64 {
        self.displacement(distance_outside).map_or(f64::NAN, |estimate| self.body.deformable_halves() * estimate.value)
    }
}
