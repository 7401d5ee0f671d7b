//! A random line.

use crate::studies::draw::Draw;
use std::f64::consts::TAU;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::line::{Control, Harmonic, Problem, Profile, modulus_of};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;
use viscotack::sliding::layer::{Backing, Layer};

/// Terms of a body, and accuracies that are asked for.
const TERMS: [usize; 3] = [1, 2, 6];
const ACCURACIES: [f64; 4] = [2e-2, 1e-2, 3e-3, 1e-3];

/// The scene of a seed, and its accuracy.
///
/// # Errors
/// Those of making a material, a law, a layer or a profile.
pub(super) fn drawn(seed: u64, number: u64) -> Result<(Problem, f64), Refusal> {
    let mut draw = Draw::of(seed, number);
    let beta = draw.log_between(2.0, 1000.0);
    let terms = TERMS[draw.below(TERMS.len())];
    let weights: Vec<f64> = (0..terms).map(|_| draw.log_between(0.2, 5.0)).collect();
    let total: f64 = weights.iter().sum();
    let mut time = 1.0;
    let creep: Vec<CreepTerm> = weights
        .iter()
        .map(|weight| {
            let term = CreepTerm { compliance: (1.0 - 1.0 / beta) * weight / total, retardation_time: time };
            time = draw.log_between(1e-3, 1.0);
            term
        })
        .collect();
    let modulus = modulus_of(&PlaneMaterial::from_creep(beta, &creep, None)?)?;
    let speed = draw.log_between(1e-3, 1e3);
    let law = match draw.below(6) {
        0..=2 => Law::Exponential,
        3 => Law::Dugdale { ramp: draw.between(0.1, 0.4) },
        4 => Law::Cosine,
        _ => Law::LennardJones,
    };
    let attraction = Attraction::new(law, TAU * draw.log_between(0.002, 0.02), draw.log_between(0.003, 0.3))?;
    let layer = match draw.below(4) {
        0 => Some(Layer::new(Backing::Confined, draw.between(0.3, 0.5), draw.log_between(0.3, 10.0))?),
        1 => Some(Layer::new(Backing::Free, 0.5, draw.log_between(0.3, 10.0))?),
        _ => None,
    };
    let wave = |(index, draw): (u32, &mut Draw)| Harmonic {
        number: index,
        amplitude: if index == 1 { 1.0 } else { draw.unit() / f64::from(index) },
        phase: TAU * draw.unit(),
    };
    let count = 1 + draw.below(5) as u32;
    let waves: Vec<Harmonic> = (1..=count).map(|index| wave((index, &mut draw))).collect();
    let control = match draw.below(4) {
        0 => Control::MeanGap(draw.between(0.1, 1.1)),
        1 => Control::Frame { stiffness: draw.log_between(0.1, 10.0), position: draw.between(0.3, 1.5) },
        _ => Control::MeanPressure(draw.between(-0.02, 0.48)),
    };
    let accuracy = ACCURACIES[draw.below(ACCURACIES.len())];
    Ok((Problem { profile: Profile::harmonics(&waves)?, modulus, speed, attraction, layer, control }, accuracy))
}
