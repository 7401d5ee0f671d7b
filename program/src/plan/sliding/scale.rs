//! From the numbers of a scene to the reduced ones of the solver and back: the table of [`Indenter`](viscotack::sliding::steady::Indenter) as factors.

use crate::scene::typed::{Sliding, SlidingIndenter, SlidingLoad, Units};
use std::f64::consts::{PI, TAU};

/// What one reduced unit is in the units of the scene; all are one in a reduced scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    /// 1/k, or L.
    pub(super) length: f64,
    /// Λ, or L²/R.
    pub(super) displacement: f64,
    /// kΛ, or L/R: of friction coefficients.
    pub(super) slope: f64,
    /// E0*kΛ/2, or E0*L/2R.
    pub(super) pressure: f64,
    /// E0*k²Λ²/2 a wave; a cylinder's friction is a force per width, 2πL times E0*L²/2R².
    pub(super) friction: f64,
    /// Mean pressure of a wave; load per width of a cylinder, 2πL times E0*L/2R.
    pub(super) load: f64,
    /// πE0*kΛ², or πE0*L³/R²: Δγ at Γ = 1.
    pub(super) work_of_adhesion: f64,
    /// E0*Λ²/2, or E0*L⁴/2R².
    pub(super) energy_per_width: f64,
}

impl Scale {
    /// The scale of a scene with the combined relaxed plane modulus E0*.
    pub(super) fn new(sliding: &Sliding, relaxed_modulus: f64, units: Units) -> Self {
        if units == Units::Reduced {
            return Self {
                length: 1.0,
                displacement: 1.0,
                slope: 1.0,
                pressure: 1.0,
                friction: 1.0,
                load: 1.0,
                work_of_adhesion: 1.0,
                energy_per_width: 1.0,
            };
        }
        let (length, displacement, width) = match sliding.indenter {
            SlidingIndenter::Wave { wavelength, amplitude } => (wavelength / TAU, amplitude, 1.0),
            SlidingIndenter::Cylinder { radius } => {
                let length = cylinder_length(sliding, radius, relaxed_modulus);
                (length, length * (length / radius), TAU * length)
            }
        };
        let slope = displacement / length;
        let pressure = 0.5 * relaxed_modulus * slope;
        Self {
            length,
            displacement,
            slope,
            pressure,
            friction: width * pressure * slope,
            load: width * pressure,
            work_of_adhesion: PI * relaxed_modulus * slope * displacement,
            energy_per_width: 0.5 * relaxed_modulus * displacement * displacement,
        }
    }
}

/// L of a cylinder: the larger of the adhesion length (ΔγR²/E0*)^{1/3} and Hertz's half-width √(4|F|R/πE0*), or the given half-width.
fn cylinder_length(sliding: &Sliding, radius: f64, relaxed_modulus: f64) -> f64 {
    let adhesion =
        sliding.adhesion.map_or(0.0, |adhesion| (adhesion.works[0].max(adhesion.works[1]) / relaxed_modulus * radius * radius).cbrt());
    let pressed = match sliding.control {
        SlidingLoad::LoadPerWidth(load) => (4.0 * load.abs() / (PI * relaxed_modulus) * radius).sqrt(),
        SlidingLoad::HalfWidth(half_width) => half_width,
        SlidingLoad::MeanPressure(_) | SlidingLoad::Penetration(_) | SlidingLoad::Every => 0.0,
    };
    adhesion.max(pressed)
}
