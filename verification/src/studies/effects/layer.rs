//! The thickness of a layer in sliding, made neutral by a very thick one.
//!
//! Contacts on layers are not there, nor is a key of scenes: what a layer adds to sliding is the kernel of its surface, and that is what is compared.
//!
//! | symbol | meaning |
//! |---|---|
//! | 𝒢(x) | displacement by a line load, periodic, without its mean |
//! | kd | wave number times thickness |
//!
//! A layer takes A ≈ 4(kd)²e^{−2kd} from the half-plane: 10⁻⁴⁸ at kd = 60, so that 𝒢 and its integral are those of the half-plane to the bit. Each value then costs one
//! harmonic on top of the half-plane's.

use std::time::Instant;
use viscotack::refusal::Refusal;
use viscotack::sliding::{Backing, HalfPlaneGreen, Layer, LayerGreen, SlidingMemory};

/// kd of a layer that is a half-plane.
pub const THICK: f64 = 60.0;
/// Positions on each side of the load.
const POSITIONS: u32 = 200;
/// Poisson ratio; nothing special.
const POISSON_RATIO: f64 = 0.3;

/// Layer and half-plane beside one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// The largest difference of 𝒢 or of its integral, over the largest value of the same.
    pub difference: f64,
    /// How many values were compared.
    pub values: usize,
    /// Terms added up for them: a half-plane's kernel counts one, each harmonic of a layer one more; with the layer, without.
    pub evaluations: [u64; 2],
    /// Least time of some runs (s); with the layer, without.
    pub seconds: [f64; 2],
}

/// 𝒢 and its integral at all positions.
fn values(of: impl Fn(f64) -> Result<[f64; 2], Refusal>) -> Result<Vec<[f64; 2]>, Refusal> {
    let half = f64::from(POSITIONS);
    let positions = (1..=POSITIONS).flat_map(|index| [1.0, -1.0].map(|side| side * std::f64::consts::PI * (f64::from(index) - 0.5) / half));
    positions.map(of).collect()
}

/// The least time of some runs of a job (s), and what it gave.
fn least<T>(runs: u32, mut job: impl FnMut() -> Result<T, Refusal>) -> Result<(T, f64), Refusal> {
    let mut clock = Instant::now();
    let mut found = job()?;
    let mut best = clock.elapsed().as_secs_f64();
    for _ in 1..runs {
        clock = Instant::now();
        found = job()?;
        best = best.min(clock.elapsed().as_secs_f64());
    }
    Ok((found, best))
}

/// Confined and free layers of a thickness against the half-plane, in one solid.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a thickness that is not positive.
pub fn compared(thickness: f64, runs: u32) -> Result<Compared, Refusal> {
    let half_plane = HalfPlaneGreen::new(SlidingMemory::standard_solid(10.0, 0.6)?)?;
    let mut all = Compared { difference: 0.0, values: 0, evaluations: [0; 2], seconds: [0.0; 2] };
    for backing in [Backing::Confined, Backing::Free] {
        let kind = Layer::new(backing, POISSON_RATIO, thickness)?;
        let (with, seconds_with) = least(runs, || {
            let layer = LayerGreen::new(half_plane.clone(), kind);
            let found = values(|x| Ok([layer.value(x)?.value, layer.antiderivative(x)?.value]))?;
            Ok((found, layer.harmonics()))
        })?;
        let (with, harmonics) = with;
        let (without, seconds_without) = least(runs, || values(|x| Ok([half_plane.value(x)?.value, half_plane.antiderivative(x)?.value])))?;
        for of in [0, 1] {
            let largest = without.iter().map(|pair| pair[of].abs()).fold(f64::MIN_POSITIVE, f64::max);
            for (one, other) in with.iter().zip(&without) {
                let off = (one[of] - other[of]).abs() / largest;
                all.difference = if off.is_nan() { f64::INFINITY } else { all.difference.max(off) };
            }
        }
        let evaluated = 2 * without.len();
        all.values += evaluated;
        all.evaluations[0] += (evaluated * (1 + harmonics)) as u64;
        all.evaluations[1] += evaluated as u64;
        all.seconds[0] += seconds_with;
        all.seconds[1] += seconds_without;
    }
    Ok(all)
}
