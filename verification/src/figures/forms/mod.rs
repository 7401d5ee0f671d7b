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
