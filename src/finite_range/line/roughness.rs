//! Self-affine lines and surfaces with random phases.
//!
//! Every wave between the longest and the shortest has the amplitude of the power spectrum
//! ```text
//! line      C(q) ∝ q^(−1−2H)      amplitude ∝ q^(−1/2−H)
//! surface   C(q) ∝ q^(−2−2H)      amplitude ∝ q^(−1−H)
//! ```
//! and a random phase; the whole is scaled to its root mean square height. The phase of a wave follows from the seed and its wave
//! numbers alone, so a spectrum that reaches further keeps the waves that it had. Source: Jacobs, Junge & Pastewka (2017) for the conventions.

use super::fourier::Transform;
use super::problem::Profile;
use crate::refusal::{Refusal, require_non_negative, require_positive};
use crate::special::split_mix::SplitMix;
use rustfft::num_complex::Complex64;

/// Most nodes of a generated profile.
const MOST_NODES: usize = 1 << 24;

/// A self-affine profile in wave numbers of its period along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// H, the Hurst exponent, 0 to 1.
    pub hurst: f64,
    /// Root mean square height, positive (the unit of the heights).
    pub rms_height: f64,
    /// Least wave number |q|, 1 or more: the period over the longest wave.
    pub lowest: f64,
    /// Largest wave number |q|: the period over the shortest wave.
    pub highest: f64,
    /// Seed of the phases; equal seeds give equal profiles.
    pub seed: u32,
}

/// A line, or a square surface, with that roughness; heights in the unit of `rms_height`. The shortest wave has at least
/// four nodes.
///
/// # Errors
/// [`Refusal::OutOfRange`] for an exponent outside 0…1, a height or wave numbers that are not positive, or more than 2²⁴ nodes;
/// [`Refusal::Undefined`] if no wave fits between the two wave numbers.
pub fn rough(roughness: &Roughness, is_line: bool) -> Result<Profile, Refusal> {
    let Roughness { hurst, rms_height, lowest, highest, seed } = *roughness;
    require_positive("rms_height", rms_height)?;
    require_non_negative("hurst", hurst)?;
    require_positive("lowest wave number", lowest)?;
    if hurst > 1.0 {
        return Err(Refusal::out_of_range("hurst", hurst, "between 0 and 1"));
    }
    let power = if is_line { 1 } else { 2 };
    let most = (MOST_NODES as f64).powf(1.0 / f64::from(power)) / 4.0;
    if !(highest >= lowest && highest <= most) {
        return Err(Refusal::out_of_range(
            "period over shortest wave",
            highest,
            "at least the period over the longest wave, and at most 2²² (surfaces 1024)",
        ));
    }
    let nx = (4 * highest.ceil() as usize).next_power_of_two().max(8);
    let ny = if is_line { 1 } else { nx };
    let mut grid = Transform::new(nx, ny);
    let mut heights = vec![0.0; nx * ny];
    let exponent = -hurst - 0.5 * f64::from(power);
    let numbers: Vec<(usize, isize)> = (0..(nx / 2 + 1) * ny).map(|entry| grid.wave_numbers(entry)).collect();
    // Rounding of a period over a wave must not lose the wave at either end.
    let inside = |q: f64| q >= lowest * (1.0 - 1e-9) && q <= highest * (1.0 + 1e-9);
    let mut sum = 0.0;
    let spectrum = grid.forward(&heights);
    for (entry, &(x, y)) in numbers.iter().enumerate() {
        let q = (x as f64).hypot(y as f64);
        // Along y alone a wave and its mirror image are one.
        if q == 0.0 || !inside(q) || (x == 0 && y < 0) {
            continue;
        }
        let amplitude = q.powf(exponent);
        let wave = Complex64::from_polar(amplitude, phase(seed, x, y));
        spectrum[entry] = wave;
        if x == 0
            && let Some(mirror) = spectrum.get_mut(ny - y.unsigned_abs())
        {
            *mirror = wave.conj();
        }
        sum += 2.0 * amplitude * amplitude;
    }
    if sum == 0.0 {
        return Err(Refusal::Undefined {
            quantity: "the rough profile",
            reason: "no whole wave number lies between its longest and its shortest wave".to_owned(),
        });
    }
    grid.inverse(&mut heights);
    let factor = rms_height / sum.sqrt();
    heights.iter_mut().for_each(|h| *h *= factor);
    Profile::surface(nx, ny, 1.0, heights)
}

fn phase(seed: u32, x: usize, y: isize) -> f64 {
    let wave = ((x as u64) << 32) ^ (y as i64 as u64);
    let bits = SplitMix::of(u64::from(seed), wave).bits();
    std::f64::consts::TAU * ((bits >> 11) as f64 / 9_007_199_254_740_992.0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::float_cmp)]
mod tests {
    use super::*;

    fn mean_square(profile: &Profile) -> f64 {
        profile.heights().iter().map(|h| h * h).sum::<f64>() / profile.heights().len() as f64
    }

    #[test]
    fn the_height_is_as_asked_and_the_spectrum_falls_as_the_exponent_says() {
        for is_line in [true, false] {
            let roughness = Roughness { hurst: 0.8, rms_height: 0.35, lowest: 1.0, highest: 16.0, seed: 3 };
            let profile = rough(&roughness, is_line).unwrap();
            assert!((mean_square(&profile).sqrt() / 0.35 - 1.0).abs() < 1e-12);
            if is_line {
                let amplitudes = profile.amplitudes();
                assert!((amplitudes[7] / amplitudes[1] / 4.0_f64.powf(-1.3) - 1.0).abs() < 1e-12);
                assert!(amplitudes[16] < 1e-14 * amplitudes[0]);
            }
        }
    }

    #[test]
    fn a_longer_spectrum_keeps_its_waves() {
        let short = rough(&Roughness { hurst: 0.5, rms_height: 1.0, lowest: 1.0, highest: 4.0, seed: 9 }, true).unwrap();
        let long = rough(&Roughness { hurst: 0.5, rms_height: 1.0, lowest: 1.0, highest: 8.0, seed: 9 }, true).unwrap();
        let phase_of = |profile: &Profile, number: usize| {
            let n = profile.heights().len() as f64;
            let turn = |i: usize| std::f64::consts::TAU * (number * i) as f64 / n;
            let (c, s) =
                profile.heights().iter().enumerate().fold((0.0, 0.0), |(c, s), (i, h)| (c + h * turn(i).cos(), s + h * turn(i).sin()));
            s.atan2(c)
        };
        for number in 1..=4 {
            assert!((phase_of(&short, number) - phase_of(&long, number)).abs() < 1e-10);
        }
    }

    #[test]
    fn nothing_between_the_waves_is_refused() {
        let roughness = Roughness { hurst: 0.8, rms_height: 1.0, lowest: 1.2, highest: 1.3, seed: 0 };
        assert!(matches!(rough(&roughness, true), Err(Refusal::Undefined { .. })));
        assert!(rough(&Roughness { highest: 1.0, ..roughness }, true).is_err());
    }
}
