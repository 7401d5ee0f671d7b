//! Closed forms and short calculations that no scene gives: elastic limits, kernels, the fast retraction of Sec 4.10, release rates of the sphere.

mod complex_modulus;
mod fast_retraction;
mod green;
mod jkr;
mod johnson_wave;
mod line;
mod sphere_oscillation;
mod sphere_release;

use super::table::Table;
use serde::Deserialize;
use viscotack::refusal::Refusal;

/// One of them, with its numbers.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Form {
    Jkr(jkr::Jkr),
    ComplexModulus(complex_modulus::ComplexModulus),
    Green(green::Green),
    JohnsonWave(johnson_wave::JohnsonCurve),
    FastRetraction(fast_retraction::FastRetraction),
    Line(line::Line),
    SphereOscillation(sphere_oscillation::SphereOscillation),
    SphereRelease(sphere_release::SphereRelease),
}

impl Form {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        match self {
            Self::Jkr(form) => form.table(),
            Self::ComplexModulus(form) => form.table(),
            Self::Green(form) => form.table(),
            Self::JohnsonWave(form) => form.table(),
            Self::FastRetraction(form) => form.table(),
            Self::Line(form) => form.table(),
            Self::SphereOscillation(form) => form.table(),
            Self::SphereRelease(form) => form.table(),
        }
    }
}

impl Form {
    /// Why no scene stands for it.
    pub(super) const fn no_scene(&self) -> &'static str {
        match self {
            Self::Jkr(_) => "elastic sphere (JKR), a closed form",
            Self::ComplexModulus(_) => "modulus of the material, a closed form (`viscotack material` draws that of yours)",
            Self::Green(_) => "surface under a line load, a closed form",
            Self::JohnsonWave(_) => "elastic wave (Johnson), a closed form",
            Self::FastRetraction(_) => "retraction faster than the memory, a closed form",
            Self::Line(_) => "power law, a closed form",
            Self::SphereOscillation(_) => {
                "oscillation computed by the library (`scenes/indentation/frequency_sweep.toml` is a scene of this kind)"
            }
            Self::SphereRelease(_) => "energy release rate from the energies of many runs of the library",
        }
    }
}

/// Numbers from `from` to `to` at equal differences, or equal ratios.
fn spaced([from, to]: [f64; 2], points: usize, logarithmic: bool) -> Vec<f64> {
    let last = points.saturating_sub(1).max(1) as f64;
    (0..points)
        .map(|index| {
            let part = index as f64 / last;
            if logarithmic { from * (to / from).powf(part) } else { from + (to - from) * part }
        })
        .collect()
}
