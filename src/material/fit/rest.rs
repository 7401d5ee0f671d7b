//! Solid or liquid: what the data say of a load held for ever.

use super::choose::Candidate;
use super::observation::Quantity;
use super::sample::Sample;
use super::series::Series;

/// What the data say of a load held for ever: the best series as a solid and as a liquid (E0 = 0), both with times up to three times the longest of the data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtRest {
    /// Whether the chosen series is a liquid.
    pub liquid: bool,
    /// Root mean square of the relative residuals of the best solid; none if every fit that was tried came out as a liquid.
    pub solid_rms_error: Option<f64>,
    /// The same of the best liquid; none if every fit that was tried came out as a solid.
    pub liquid_rms_error: Option<f64>,
    /// How much lower Schwarz's criterion of the chosen kind is than that of the other, where both were followed to their best number of terms.
    pub preference: Option<f64>,
}

/// Differences of Schwarz's criterion from here on are strong evidence (Kass and Raftery, 1995, *J. Am. Stat. Assoc.* 90, 773).
const STRONG: f64 = 6.0;

impl AtRest {
    /// What the candidates say.
    pub(super) fn of(chosen: &Candidate, candidates: &[Candidate], sample: &Sample) -> Self {
        let is_liquid = |one: &Candidate| if sample.is_creep() { one.series.flow > 0.0 } else { one.series.constant <= 0.0 };
        // Every solid is a liquid of unlimited viscosity, and every liquid a solid with a modulus near zero: such neighbours are no other kind.
        let distinct = |one: &Candidate| !is_general(&one.series, sample) || share(&one.series, sample, &one.shifts) >= SHARE;
        let lowest = |liquid: bool, value: &dyn Fn(&Candidate) -> f64| {
            let of_kind = candidates.iter().filter(|one| is_liquid(one) == liquid && (distinct(one) || *one == chosen));
            of_kind.map(value).min_by(f64::total_cmp)
        };
        let rms = |one: &Candidate| (one.misfit / sample.count as f64).sqrt();
        let liquid = is_liquid(chosen);
        let other = lowest(!liquid, &|one| one.criterion);
        Self {
            liquid,
            solid_rms_error: lowest(false, &rms),
            liquid_rms_error: lowest(true, &rms),
            preference: other.zip(lowest(liquid, &|one| one.criterion)).map(|(other, own)| other - own),
        }
    }

    /// Whether the data prefer one kind strongly; kinds that were not followed to the end fit far worse.
    #[must_use]
    pub fn decided(&self) -> bool {
        self.preference.is_none_or(|preference| preference >= STRONG)
    }
}

/// A flow or a modulus at rest with less than this part of the last datum says nothing about the kind.
const SHARE: f64 = 0.05;
/// The part of the flow in the compliance at the longest time, or of the constant in the modulus at the longest time.
fn share(series: &Series, sample: &Sample, shifts: &[(f64, f64)]) -> f64 {
    let [_, longest] = sample.shifted(shifts).times();
    if sample.is_creep() {
        series.flow * longest / series.value(Quantity::Creep, longest)
    } else {
        series.constant / series.value(Quantity::Storage, 1.0 / longest)
    }
}

/// Whether the series makes use of what only the general form has.
pub(super) fn is_general(series: &Series, sample: &Sample) -> bool {
    if sample.is_creep() { series.flow > 0.0 } else { series.constant > 0.0 }
}
