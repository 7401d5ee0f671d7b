//! The number of terms, and whether the material is a solid or a liquid.

use super::band::Band;
use super::best::{ROUNDING, best_fit, one_fewer};
use super::joint::{self, Free};
use super::observation::{Observation, Quantity};
use super::rest::{AtRest, is_general};
use super::sample::Sample;
use super::series::{Ends, Series};
use crate::material::{CreepTerm, Material, RelaxationTerm};
use crate::refusal::{Refusal, require_positive};

/// How good a fit has to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// Root mean square of the relative residuals at most this; or the best fit, if the data scatter more.
    Error(f64),
    /// As many terms as the scatter of the data justifies (Schwarz's criterion).
    Scatter,
}

/// A fitted series.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesFit {
    /// The material.
    pub material: Material,
    /// Root mean square of the relative residuals.
    pub rms_error: f64,
    /// The largest relative residual.
    pub largest_error: f64,
    /// Root mean square of the relative residuals of the best fit that was found with positive strengths and any number of terms.
    pub best_rms_error: f64,
    /// Terms of that best fit.
    pub best_terms: usize,
    /// Whether the wanted error was met.
    pub met: bool,
    /// Number of data.
    pub observations: usize,
    /// How well the data fix the curves.
    pub band: Band,
    /// Solid or liquid.
    pub rest: AtRest,
}

/// One series of those that may be the right one, with the shifts of its isotherms.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Candidate {
    pub(super) series: Series,
    pub(super) shifts: Vec<(f64, f64)>,
    pub(super) misfit: f64,
    /// Schwarz's criterion.
    pub(super) criterion: f64,
}

/// Times reach this factor beyond those that the data span: a term further out shows only its tail.
const BEYOND: f64 = 3.0;
/// Fewer data than this are no curve.
pub(super) const LEAST_DATA: usize = 3;
/// Data over more decades than these are none: each decade is a number of columns.
const MOST_DECADES: f64 = 61.0;
/// A kind whose best fit is worse by this much of the criterion is not followed to its best number of terms.
const HOPELESS: f64 = 60.0;
/// Candidates this far above the lowest criterion weigh nothing.
const WEIGHTLESS: f64 = 16.0;

/// The times between which terms may lie.
pub(super) fn window(sample: &Sample) -> [f64; 2] {
    let [low, high] = sample.times();
    // Of creep, what is over before the first datum is the instantaneous compliance: a term in its place would leave none.
    [low / if sample.is_creep() { 1.0 } else { BEYOND }, high * BEYOND]
}

/// Fits a series.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a number that is not finite, an argument or a scale that is not positive; [`Refusal::Undefined`] for
/// fewer than three data, moduli and creep mixed, or data that no positive series resembles.
pub fn fit(data: &[Observation], wanted: Wanted) -> Result<SeriesFit, Refusal> {
    check(data, wanted)?;
    fitted(&Sample::combined(std::iter::once(data)), &[(0.0, 0.0)], Free::NONE, wanted, std::iter::once(data))
}

/// What may be the right series, and the one that is wanted.
pub(super) struct Chosen {
    pub(super) best: Candidate,
    pub(super) chosen: Candidate,
    candidates: Vec<Candidate>,
}

/// Chooses a series for isotherms whose shifts are nearly known.
pub(super) fn chosen(sample: &Sample, shifts: &[(f64, f64)], free: Free, wanted: Wanted) -> Chosen {
    let shifted = sample.shifted(shifts);
    let window = window(&shifted);
    let count = sample.count as f64;
    let floor = ROUNDING * ROUNDING * count;
    let candidate = |series: Series, shifts: Vec<(f64, f64)>, misfit: f64| {
        let freedom = (series.freedom() + free.count()) as f64;
        // N ln(misfit/N) + freedom·ln N.
        let criterion = count * (misfit.max(floor) / count).ln() + freedom * count.ln();
        Candidate { series, shifts, misfit, criterion }
    };
    let of = |series: Series| {
        let misfit = series.misfit(&shifted);
        candidate(series, shifts.to_vec(), misfit)
    };
    let general = general(sample);
    let restricted = if sample.is_creep() { Ends { flow: false, ..general } } else { Ends { constant: false, ..general } };
    let best = of(best_fit(&shifted, window, general));
    let mut candidates = path(best.clone(), &shifted, window, wanted, &of);
    // The same without what only the general form has, unless it is far worse.
    if candidates.iter().any(|one| is_general(&one.series, sample)) {
        let times: Vec<f64> = best.series.terms.iter().map(|term| term.1).collect();
        let other = of(Series::at_times(&times, &shifted, restricted).refined(&shifted, window, 20));
        let far = |other: &Candidate, border: f64| count * (other.misfit.max(floor) / best.misfit.max(floor)).ln() > border;
        let other = if far(&other, 5.0 * HOPELESS) { other } else { of(best_fit(&shifted, window, restricted)) };
        if far(&other, HOPELESS) {
            candidates.push(other);
        } else {
            candidates.extend(path(other, &shifted, window, wanted, &of));
        }
    }
    let border = candidates.iter().map(|one| one.criterion).fold(f64::INFINITY, f64::min) + WEIGHTLESS;
    let meets = |one: &Candidate| matches!(wanted, Wanted::Error(error) if (one.misfit / count).sqrt() <= error);
    let fewest = candidates.iter().filter(|one| meets(one)).map(|one| one.series.freedom()).min();
    // The lightest of each kind stays, so that both kinds can be compared.
    let kinds = [false, true].map(|kind| {
        candidates.iter().filter(|one| is_general(&one.series, sample) == kind).map(|one| one.criterion).fold(f64::INFINITY, f64::min)
    });
    candidates.retain(|one| {
        let lightest = kinds.iter().any(|lowest| one.criterion <= *lowest);
        one.criterion <= border || lightest || (meets(one) && Some(one.series.freedom()) == fewest)
    });
    if free.count() > 0 {
        for one in &mut candidates {
            let (series, shifts) = joint::refined(one.series.clone(), one.shifts.clone(), sample, free, window, 100);
            let misfit = series.misfit(&sample.shifted(&shifts));
            *one = candidate(series, shifts, misfit);
        }
    }
    let wanted_one = match wanted {
        Wanted::Error(_) => candidates.iter().filter(|one| meets(one)).min_by_key(|one| one.series.freedom()).or(Some(&best)),
        Wanted::Scatter => candidates.iter().min_by(|left, right| left.criterion.total_cmp(&right.criterion)),
    };
    Chosen { chosen: wanted_one.unwrap_or(&best).clone(), best, candidates }
}

/// All that a series may have besides its terms.
pub(super) fn general(sample: &Sample) -> Ends {
    Ends { constant: true, flow: sample.is_creep() }
}

/// Fits a series to isotherms whose shifts are nearly known.
pub(super) fn fitted<'a>(
    sample: &Sample,
    shifts: &[(f64, f64)],
    free: Free,
    wanted: Wanted,
    isotherms: impl Iterator<Item = &'a [Observation]>,
) -> Result<SeriesFit, Refusal> {
    let Chosen { best, chosen, candidates } = chosen(sample, shifts, free, wanted);
    let count = sample.count as f64;
    let rest = AtRest::of(&chosen, &candidates, sample);
    let rms_error = (chosen.misfit / count).sqrt();
    let closest = if best.misfit <= chosen.misfit { &best } else { &chosen };
    Ok(SeriesFit {
        material: material(&chosen.series, sample.is_creep())?,
        rms_error,
        largest_error: largest(&chosen, isotherms),
        best_rms_error: (closest.misfit / count).sqrt(),
        best_terms: closest.series.terms.len(),
        met: match wanted {
            Wanted::Error(error) => rms_error <= error,
            Wanted::Scatter => true,
        },
        observations: sample.count,
        band: Band::new(chosen, candidates, sample, free, window(&sample.shifted(shifts))),
        rest,
    })
}

/// The largest relative residual of the data themselves.
fn largest<'a>(chosen: &Candidate, isotherms: impl Iterator<Item = &'a [Observation]>) -> f64 {
    let mut largest = 0.0_f64;
    for (group, data) in isotherms.enumerate() {
        let (a, b) = chosen.shifts.get(group).copied().unwrap_or((0.0, 0.0));
        for one in data {
            let at = one.at * if one.quantity.by_frequency() { a } else { -a }.exp();
            let value = chosen.series.value(one.quantity, at) * if one.quantity == Quantity::Creep { b } else { -b }.exp();
            largest = largest.max(((value - one.value) / one.scale).abs());
        }
    }
    largest
}

pub(super) fn check(data: &[Observation], wanted: Wanted) -> Result<(), Refusal> {
    for observation in data {
        require_positive("the frequency or time of an observation", observation.at)?;
        require_positive("the scale of an observation", observation.scale)?;
        if !observation.value.is_finite() {
            return Err(Refusal::out_of_range("the value of an observation", observation.value, "finite"));
        }
    }
    if let Wanted::Error(error) = wanted {
        require_positive("the wanted error of a fit", error)?;
    }
    let undefined = |reason: &str| Err(Refusal::Undefined { quantity: "a fitted series", reason: reason.to_owned() });
    if data.len() < LEAST_DATA {
        return undefined("there are fewer than three data");
    }
    let is_creep = data.iter().any(|observation| observation.quantity == Quantity::Creep);
    if is_creep && data.iter().any(|observation| observation.quantity != Quantity::Creep) {
        return undefined("creep and moduli are mixed: they are linear in different series");
    }
    let [low, high] = window(&Sample::plain(data));
    if !(high / low).is_finite() || (high / low).log10() > MOST_DECADES {
        return undefined("the data span more than 60 decades of frequency or time: a shift factor or a unit is wrong");
    }
    Ok(())
}

/// The series as a material.
pub(super) fn material(series: &Series, creep: bool) -> Result<Material, Refusal> {
    if creep {
        if series.constant <= 0.0 {
            return Err(Refusal::Undefined {
                quantity: "the glassy modulus",
                reason: "the creep data leave no instantaneous compliance: shorter times are needed".into(),
            });
        }
        let terms: Vec<CreepTerm> =
            series.terms.iter().map(|&(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect();
        Material::from_creep(1.0 / series.constant, &terms, (series.flow > 0.0).then(|| 1.0 / series.flow))
    } else {
        let terms: Vec<RelaxationTerm> =
            series.terms.iter().map(|&(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
        Material::from_relaxation(series.constant, &terms)
    }
}

/// The best series of each number of terms, from a best fit down, as far as the wanted error or the criterion may want it.
fn path(best: Candidate, shifted: &Sample, window: [f64; 2], wanted: Wanted, of: &dyn Fn(Series) -> Candidate) -> Vec<Candidate> {
    let count = shifted.count as f64;
    let mut lowest = best.criterion;
    let mut all = vec![best.clone()];
    let mut current = best;
    while let Some(shorter) = one_fewer(&current.series, shifted, window, 40) {
        let shorter = of(shorter);
        lowest = lowest.min(shorter.criterion);
        let meets = matches!(wanted, Wanted::Error(error) if (shorter.misfit / count).sqrt() <= error);
        // Two terms fewer may still be better than one.
        let over = shorter.criterion > lowest + 2.0 * WEIGHTLESS + 4.0 * count.ln();
        all.push(shorter.clone());
        if over && !meets {
            break;
        }
        current = shorter;
    }
    all
}
