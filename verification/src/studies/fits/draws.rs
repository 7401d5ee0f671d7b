//! Solids with nine terms, their isotherms and their noise, from a seed.

use super::super::draw::Draw;
use viscotack::material::fit::superposition::Isotherm;
use viscotack::material::fit::{Observation, complex_modulus};
use viscotack::material::{Material, RelaxationTerm};
use viscotack::refusal::Refusal;

/// The seed of all solids.
pub const SEED: u64 = 0xf175;
/// Relative noise of each number.
pub const NOISE: f64 = 0.02;
/// Reference temperature (K).
pub const REFERENCE: f64 = 293.15;
/// Temperatures (K).
const TEMPERATURES: [f64; 7] = [263.15, 273.15, 283.15, 293.15, 303.15, 313.15, 323.15];
/// Frequencies of a sweep, over three decades (rad/s).
const FREQUENCIES: usize = 13;

/// A solid that is measured.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The truth, at the reference temperature.
    pub material: Material,
    /// c₁ and c₂ (K) of its shifts.
    pub constants: [f64; 2],
    /// What is measured.
    pub isotherms: Vec<Isotherm>,
}

impl Measured {
    /// ln a_T of the truth.
    #[must_use]
    pub fn shift(&self, temperature: f64) -> f64 {
        let [c1, c2] = self.constants;
        -std::f64::consts::LN_10 * c1 * (temperature - REFERENCE) / (c2 + temperature - REFERENCE)
    }

    /// Reduced angular frequencies (rad/s) that the sweeps reach.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        let end = |temperature: f64, frequency: f64| frequency * self.shift(temperature).exp();
        [end(TEMPERATURES[6], frequency(0)), end(TEMPERATURES[0], frequency(FREQUENCIES - 1))]
    }
}

fn frequency(index: usize) -> f64 {
    10f64.powf(-1.5 + 3.0 * index as f64 / (FREQUENCIES - 1) as f64)
}

/// A standard normal number.
fn normal(draw: &mut Draw) -> f64 {
    (-2.0 * (1.0 - draw.unit()).ln()).sqrt() * (std::f64::consts::TAU * draw.unit()).cos()
}

fn blurred(draw: &mut Draw, value: f64) -> f64 {
    value * (1.0 + NOISE * normal(draw))
}

/// Nine terms about a decade apart, their times and moduli moved at random, and a WLF shift of their own.
///
/// # Errors
/// Those of making a material.
pub fn measured(number: u64) -> Result<Measured, Refusal> {
    let mut draw = Draw::of(SEED, number);
    let terms: Vec<RelaxationTerm> = (0..9)
        .map(|index| RelaxationTerm {
            modulus: 1e6 * 10f64.powf(0.3 * f64::from(8 - index) + draw.between(-0.2, 0.2)),
            relaxation_time: 10f64.powf(f64::from(index) - 4.0 + draw.between(-0.25, 0.25)),
        })
        .collect();
    let material = Material::from_relaxation(1e6, &terms)?;
    let mut solid = Measured { material, constants: [draw.between(8.0, 12.0), draw.between(100.0, 140.0)], isotherms: Vec::new() };
    for temperature in TEMPERATURES {
        let factor = solid.shift(temperature).exp();
        let mut data = Vec::with_capacity(2 * FREQUENCIES);
        for index in 0..FREQUENCIES {
            let modulus = solid.material.complex_modulus(frequency(index) * factor)?;
            data.extend(complex_modulus(frequency(index), blurred(&mut draw, modulus.storage), blurred(&mut draw, modulus.loss)));
        }
        solid.isotherms.push(Isotherm { temperature, data });
    }
    Ok(solid)
}

/// Moduli of twenty terms in many rows.
///
/// # Errors
/// Those of making a material.
pub fn many(rows: usize) -> Result<Vec<Observation>, Refusal> {
    let mut draw = Draw::of(SEED, u64::MAX);
    let term =
        |index: i32| RelaxationTerm { modulus: 1e6 * 10f64.powf(0.15 * f64::from(19 - index)), relaxation_time: 10f64.powi(index - 10) };
    let material = Material::from_relaxation(1e6, &(0..20).map(term).collect::<Vec<_>>())?;
    let mut data = Vec::with_capacity(2 * rows);
    for index in 0..rows {
        let at = 10f64.powf(-9.5 + 20.0 * index as f64 / rows as f64);
        let modulus = material.complex_modulus(at)?;
        data.extend(complex_modulus(at, blurred(&mut draw, modulus.storage), blurred(&mut draw, modulus.loss)));
    }
    Ok(data)
}
