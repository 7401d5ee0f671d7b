//! Source: `material/fit/consistency`: whether measured moduli can be those of one passive solid.
//!
//! Goal: noisy moduli of a passive solid are accepted whatever its spectrum, rows and noise; a loss or a storage modulus that a fault of the measurement has
//! changed is found.
//! Oracle: series with random terms, and the fault that was put on them.
//! Tolerances: shares of draws that were not used to set any number of the check.
#![allow(clippy::unwrap_used, missing_docs)]

use crate::support::random::Uniform;
use viscotack::material::fit::consistency::check;
use viscotack::material::fit::{Observation, complex_modulus};
use viscotack::material::{ComplexModulus, Material, RelaxationTerm};

/// What is wrong with a measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    None,
    LossScaled,
    LossShifted,
    StorageShifted,
    MagnitudeSoftened,
}

struct Draw {
    material: Material,
    places: Vec<f64>,
    noise: f64,
    by_tangent: bool,
}

fn normal(uniform: &mut Uniform) -> f64 {
    (-2.0 * uniform.between(1e-300, 1.0).ln()).sqrt() * (std::f64::consts::TAU * uniform.between(0.0, 1.0)).cos()
}

/// A solid with a spectrum of one to forty terms, and where it is measured.
fn drawn(uniform: &mut Uniform, rows: [f64; 2], noises: &[f64]) -> Draw {
    let pick = |uniform: &mut Uniform, count: usize| (uniform.between(0.0, count as f64) as usize).min(count - 1);
    let noise = noises[pick(uniform, noises.len())];
    let rows = uniform.log_between(rows[0], rows[1] + 1.0) as usize;
    let decades = uniform.between(1.5, 9.0);
    let low = uniform.log_between(1e-4, 10.0);
    let high = low * 10f64.powf(decades);
    let places: Vec<f64> = (0..rows).map(|index| low * (high / low).powf(index as f64 / (rows - 1) as f64)).collect();
    // Narrow: one to three terms; broad: a smooth spectrum with a peak and a tail.
    let mut terms = Vec::new();
    let relaxed = 1e6;
    let rise = uniform.log_between(3.0, 1e3);
    if uniform.between(0.0, 1.0) < 0.3 {
        for _ in 0..=pick(uniform, 3) {
            terms.push(RelaxationTerm {
                modulus: relaxed * rise * uniform.log_between(0.1, 1.0),
                relaxation_time: 1.0 / uniform.log_between(low, high),
            });
        }
    } else {
        let (centre, width) = (uniform.between(low.ln(), high.ln()), uniform.between(0.5, 2.5) * 2.3);
        let tail = uniform.log_between(1e-3, 0.3);
        for index in -20..=20 {
            let place = f64::from(index) * 0.2;
            let weight = (-place * place).exp() + tail * (-0.1 * place * place).exp() / (1.0 + place.exp());
            terms.push(RelaxationTerm { modulus: relaxed * rise * weight * 0.11, relaxation_time: (-(centre + width * place)).exp() });
        }
    }
    terms.sort_by(|left, right| right.relaxation_time.total_cmp(&left.relaxation_time));
    terms.dedup_by(|left, right| (left.relaxation_time / right.relaxation_time - 1.0).abs() < 1e-6);
    let material = Material::from_relaxation(relaxed, &terms).unwrap();
    Draw { material, places, noise, by_tangent: uniform.between(0.0, 1.0) < 0.5 }
}

fn measured(draw: &Draw, fault: Fault, uniform: &mut Uniform) -> Vec<Observation> {
    let at = |frequency: f64| draw.material.complex_modulus(frequency).unwrap();
    let highest = at(*draw.places.last().unwrap()).magnitude();
    draw.places
        .iter()
        .flat_map(|&frequency| {
            let ComplexModulus { mut storage, mut loss } = at(frequency);
            match fault {
                Fault::None => {}
                Fault::LossScaled => loss *= 1.3,
                Fault::LossShifted => loss = at(frequency * 10f64.sqrt()).loss,
                Fault::StorageShifted => storage = at(frequency * 10f64.sqrt()).storage,
                // The frame yields: the magnitude is too small, and the phase was read as if it did not.
                Fault::MagnitudeSoftened => {
                    let magnitude = storage.hypot(loss);
                    let factor = 1.0 / (1.0 + magnitude / highest);
                    (storage, loss) = (storage * factor, loss * factor);
                }
            }
            let mut blurred = |value: f64| value * (1.0 + draw.noise * normal(uniform));
            let (storage, other) = if draw.by_tangent {
                let tangent = blurred(loss / storage);
                let storage = blurred(storage);
                (storage, storage * tangent)
            } else {
                (blurred(storage), blurred(loss))
            };
            complex_modulus(frequency, storage, other)
        })
        .collect()
}

/// How many of so many draws fail the check.
fn failing(uniform: &mut Uniform, count: usize, fault: Fault, rows: [f64; 2], noises: &[f64]) -> usize {
    let tables: Vec<Vec<Observation>> = (0..count)
        .map(|_| {
            let draw = drawn(uniform, rows, noises);
            measured(&draw, fault, uniform)
        })
        .collect();
    let failing = tables.iter().filter(|table| !check(table).unwrap().holds()).count();
    println!("{fault:?}, {} to {} rows: {failing} of {count} fail", rows[0], rows[1]);
    failing
}

#[test]
fn noisy_moduli_of_passive_solids_belong_together() {
    let mut uniform = Uniform::new();
    let failing = failing(&mut uniform, 240, Fault::None, [5.0, 60.0], &[0.0, 0.005, 0.01, 0.02, 0.03]);
    assert!(failing * 100 <= 3 * 240, "{failing}");
}

#[test]
fn faults_of_one_modulus_are_found() {
    let mut uniform = Uniform::new();
    for fault in [Fault::LossScaled, Fault::LossShifted, Fault::StorageShifted, Fault::MagnitudeSoftened] {
        let found = failing(&mut uniform, 60, fault, [10.0, 60.0], &[0.0, 0.005, 0.01, 0.02]);
        assert!(found * 10 >= 9 * 60, "{fault:?}: {found}");
    }
}

#[test]
fn a_scaled_loss_gives_its_factor() {
    let mut uniform = Uniform::new();
    let draw = Draw { noise: 0.01, ..drawn(&mut uniform, [40.0, 41.0], &[0.01]) };
    let check = check(&measured(&draw, Fault::LossScaled, &mut uniform)).unwrap();
    println!("{check:?}");
    assert!(!check.holds() && check.factor[0] > 1.2 && check.factor[1] < 1.4);
}
