//! The elastic contact of a wave whose edges take different works: hysteresis of the interface alone.
//!
//! With the modulus m (1 or β) in units of E0, half-width a and eccentricity e, s = sin(a/2), c = cos(a/2), Γ₁ trailing, Γ₂ leading, δ → 0:
//! ```text
//! p = m[cos e W − sin e S + D H₀]             k = −√(8mΓ sin a) at each edge, k₁ − k₂ = 4m c²s sin e, k₁ + k₂ = 2m c D
//! sin e = (√Γ₂ − √Γ₁)/√(m s c³)               the contact lags behind the crest where opening takes more
//! p̄ = m cos e s² − (√Γ₁ + √Γ₂)√(m tan(a/2))
//! Δ = 1 − cos e (1 − s² + 2s² ln s) + 2(√Γ₁ + √Γ₂)√(tan(a/2)/m) ln s
//! ```
//! Equal works give Johnson's wave. No contact holds where |sin e| would be above one. Source: our own, from the amplitudes of theory section 3.

use super::problem::SlidingProblem;
use crate::refusal::Refusal;
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use std::f64::consts::PI;

/// Half-widths that are looked at for the turns of load and penetration.
const SAMPLES: u32 = 600;
/// Halvings of a bracket.
const HALVINGS: u32 = 60;

/// The elastic contact of given works at one modulus.
struct UnevenWave {
    modulus: f64,
    adhesion: WaveAdhesion,
}

impl UnevenWave {
    /// sin e, if there is one.
    fn sine(&self, half_width: f64) -> Option<f64> {
        let (sine, cosine) = (0.5 * half_width).sin_cos();
        let difference = self.adhesion.leading_work.sqrt() - self.adhesion.trailing_work.sqrt();
        let shift = difference / (self.modulus * sine * cosine.powi(3)).sqrt();
        (shift.abs() < 1.0).then_some(shift)
    }

    fn pull(&self) -> f64 {
        self.adhesion.leading_work.sqrt() + self.adhesion.trailing_work.sqrt()
    }

    /// cos e, a multiple of which the contact carries.
    fn cosine(&self, half_width: f64) -> Option<f64> {
        self.sine(half_width).map(|sine| (1.0 - sine * sine).sqrt())
    }

    fn mean_pressure(&self, half_width: f64) -> Option<f64> {
        let half = 0.5 * half_width;
        Some(self.modulus * self.cosine(half_width)? * half.sin().powi(2) - self.pull() * (self.modulus * half.tan()).sqrt())
    }

    fn penetration(&self, half_width: f64) -> Option<f64> {
        let half = 0.5 * half_width;
        let (square, logarithm) = (half.sin().powi(2), half.sin().ln());
        let profile = self.cosine(half_width)? * (1.0 - square + 2.0 * square * logarithm);
        Some(1.0 - profile + 2.0 * self.pull() * (half.tan() / self.modulus).sqrt() * logarithm)
    }
}

/// Half-width (at a prescribed one the mean pressure) and eccentricity of the elastic contact of a wave with uneven works.
///
/// # Errors
/// [`Refusal::NoSuchState`] above snap-in, below pull-off, and where the difference of the works is more than a wave can hold.
pub(super) fn uneven_unknowns(problem: &SlidingProblem<'_>, adhesion: WaveAdhesion, modulus: f64) -> Result<[f64; 2], Refusal> {
    let wave = UnevenWave { modulus, adhesion };
    let too_much = || Refusal::NoSuchState {
        reason: "the works of both edges differ by more than an elastic wave at rest can hold".into(),
        // The largest s c³ is at a = π/3.
        limit_name: "largest difference of √Γ",
        limit: (modulus * 0.5 * (0.75_f64.sqrt()).powi(3)).sqrt(),
    };
    type Value = fn(&UnevenWave, f64) -> Option<f64>;
    let (asked, value, names): (f64, Value, [&'static str; 2]) = match problem.control {
        SlidingControl::HalfWidth(half_width) => {
            let sine = wave.sine(half_width).ok_or_else(too_much)?;
            return Ok([wave.mean_pressure(half_width).ok_or_else(too_much)?, sine.asin()]);
        }
        SlidingControl::MeanPressure(pressure) => {
            (pressure, UnevenWave::mean_pressure, ["pull-off mean pressure", "snap-in mean pressure"])
        }
        SlidingControl::Penetration(depth) => (depth, UnevenWave::penetration, ["smallest penetration", "largest penetration"]),
    };
    // Dense at both ends.
    let place = |index: u32| PI * (0.5 * PI * f64::from(index) / f64::from(SAMPLES)).sin().powi(2);
    let samples: Vec<(f64, f64)> = (1..SAMPLES).filter_map(|index| Some((place(index), value(&wave, place(index))?))).collect();
    // The longest rise is the part between pull-off and snap-in; what falls at a wide contact snaps in by itself.
    let (mut rise, mut from) = (None, 0);
    for index in 1..=samples.len() {
        let falls = samples.get(index).is_none_or(|here| here.1 <= samples[index - 1].1);
        if falls {
            let gained = samples[index - 1].1 - samples[from].1;
            if index - from > 1 && rise.is_none_or(|(_, _, most)| gained > most) {
                rise = Some((from, index - 1, gained));
            }
            from = index;
        }
    }
    let Some((low, high, _)) = rise else { return Err(too_much()) };
    let (mut narrow, mut wide) = (samples[low], samples[high]);
    for (outside, limit, name) in [(asked <= narrow.1, narrow.1, names[0]), (asked >= wide.1, wide.1, names[1])] {
        if outside {
            return Err(Refusal::NoSuchState {
                reason: "an elastic contact at rest has no equilibrium there".into(),
                limit_name: name,
                limit,
            });
        }
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (narrow.0 + wide.0);
        match value(&wave, middle) {
            Some(found) if found > asked => wide = (middle, found),
            Some(found) => narrow = (middle, found),
            None => break,
        }
    }
    let half_width = 0.5 * (narrow.0 + wide.0);
    Ok([half_width, wave.sine(half_width).ok_or_else(too_much)?.asin()])
}

/// The eccentricity of an elastic parabola with uneven works at a half-width a: (√Γ₂ − √Γ₁)/√(ma/2), the wave's for narrow contacts. Its load is that of equal
/// works with the same mean root.
pub(super) fn uneven_parabola_shift(adhesion: WaveAdhesion, half_width: f64, modulus: f64) -> f64 {
    (adhesion.leading_work.sqrt() - adhesion.trailing_work.sqrt()) / (0.5 * modulus * half_width).sqrt()
}

/// The work with the mean root of both.
pub(super) fn mean_work(adhesion: WaveAdhesion) -> f64 {
    if adhesion.is_even() {
        return adhesion.trailing_work;
    }
    (0.5 * (adhesion.leading_work.sqrt() + adhesion.trailing_work.sqrt())).powi(2)
}

/// Whether the uneven form applies.
pub(super) fn is_uneven_wave(problem: &SlidingProblem<'_>, adhesion: Option<WaveAdhesion>) -> Option<WaveAdhesion> {
    adhesion.filter(|adhesion| !adhesion.is_even() && problem.indenter == Indenter::Wave)
}
