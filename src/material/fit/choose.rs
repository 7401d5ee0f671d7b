//! The best fit, and the number of terms.

use super::band::Band;
use super::observation::{Observation, Quantity};
use super::series::Series;
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
    /// Root mean square of the relative residuals of the best fit that positive strengths allow, with any number of terms.
    pub best_rms_error: f64,
    /// Terms of that best fit.
    pub best_terms: usize,
    /// Whether the wanted error was met.
    pub met: bool,
    /// Number of data.
    pub observations: usize,
    /// How well the data fix the curves.
    pub band: Band,
    /// Whether the series is one of creep terms.
    pub(super) creep: bool,
}

/// Grid times a decade of the first stage.
const PER_DECADE: f64 = 10.0;
/// Times reach this factor beyond those that the data span: a term further out shows only its tail.
const BEYOND: f64 = 3.0;
/// Fewer data than this are no curve.
const LEAST_DATA: usize = 3;
/// Double precision ends here: smaller residuals say nothing.
const ROUNDING: f64 = 1e-14;
/// A further term is worth its while if it lowers the misfit by this part: of noise, a thousandth is nothing.
const WORTH: f64 = 1e-3;
/// Data over more decades than these are none: each decade is a number of columns.
const MOST_DECADES: f64 = 61.0;
/// Most terms of a series.
const MOST_TERMS: usize = 120;

/// The times between which terms may lie.
fn window(data: &[Observation]) -> [f64; 2] {
    let times = data.iter().map(|observation| if observation.quantity.by_frequency() { 1.0 / observation.at } else { observation.at });
    let (low, high) = times.fold((f64::INFINITY, 0.0_f64), |(low, high), time| (low.min(time), high.max(time)));
    [low / BEYOND, high * BEYOND]
}

/// Fits a series.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a number that is not finite, an argument or a scale that is not positive; [`Refusal::Undefined`] for
/// fewer than three data, moduli and creep mixed, or data that no positive series resembles.
pub fn fit(data: &[Observation], wanted: Wanted) -> Result<SeriesFit, Refusal> {
    check(data, wanted)?;
    let window = window(data);
    let best = best_fit(data, window);
    let chosen = fewest(best.clone(), data, window, wanted);
    let count = data.len() as f64;
    let rms = |series: &Series| (series.misfit(data) / count).sqrt();
    let rms_error = rms(&chosen);
    let largest_error = chosen.residuals(data).iter().fold(0.0_f64, |largest, residual| largest.max(residual.abs()));
    let met = match wanted {
        Wanted::Error(error) => rms_error <= error,
        Wanted::Scatter => true,
    };
    Ok(SeriesFit {
        material: material(&chosen, is_creep(data))?,
        rms_error,
        largest_error,
        best_rms_error: rms(&best),
        best_terms: best.terms.len(),
        met,
        observations: data.len(),
        band: Band::new(chosen, best, data, window),
        creep: is_creep(data),
    })
}

fn is_creep(data: &[Observation]) -> bool {
    data.iter().any(|observation| observation.quantity == Quantity::Creep)
}

fn check(data: &[Observation], wanted: Wanted) -> Result<(), Refusal> {
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
    let [low, high] = window(data);
    if !(high / low).is_finite() || (high / low).log10() > MOST_DECADES {
        return undefined("the data span more than 60 decades of frequency or time: a shift factor or a unit is wrong");
    }
    if is_creep(data) && data.iter().any(|observation| observation.quantity != Quantity::Creep) {
        return undefined("creep and moduli are mixed: they are linear in different series");
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
        Material::from_creep(1.0 / series.constant, &terms, None)
    } else {
        let terms: Vec<RelaxationTerm> =
            series.terms.iter().map(|&(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect();
        Material::from_relaxation(series.constant, &terms)
    }
}

/// Log-spaced times over a window.
fn grid(window: [f64; 2], per_decade: f64) -> Vec<f64> {
    let decades = (window[1] / window[0]).log10();
    let steps = (decades * per_decade).ceil().max(1.0);
    (0..=steps as usize).map(|index| window[0] * 10f64.powf(decades * index as f64 / steps)).collect()
}

/// The best fit that positive strengths allow, whatever its number of terms.
pub(super) fn best_fit(data: &[Observation], window: [f64; 2]) -> Series {
    let on_grid = Series::at_times(&grid(window, PER_DECADE), data);
    let mut series = joined(&on_grid).refined(data, window, 60);
    let fine = grid(window, 4.0 * PER_DECADE);
    let floor = ROUNDING * ROUNDING * data.len() as f64;
    // As long as a new term somewhere lowers the misfit, add it there: at the optimum the gradient is positive nowhere.
    for _ in 0..MOST_TERMS {
        let misfit = series.misfit(data);
        if misfit <= floor || series.terms.len() >= MOST_TERMS {
            break;
        }
        let Some(time) = steepest(&series, data, &fine) else { break };
        let mut times: Vec<f64> = series.terms.iter().map(|term| term.1).collect();
        times.push(time);
        let trial = joined_close(&Series::at_times(&times, data)).refined(data, window, 30);
        let reached = trial.misfit(data);
        if reached < misfit {
            series = trial;
        }
        if reached > misfit * (1.0 - WORTH) {
            break;
        }
    }
    series
}

/// Where a small new term would lower the misfit most, relative to its own reach.
fn steepest(series: &Series, data: &[Observation], times: &[f64]) -> Option<f64> {
    let residuals = series.residuals(data);
    let size = residuals.iter().map(|residual| residual * residual).sum::<f64>().sqrt();
    times
        .iter()
        .map(|&time| {
            let (mut gain, mut length) = (0.0, 0.0);
            for (observation, residual) in data.iter().zip(&residuals) {
                let value = observation.quantity.kernel(observation.argument(time)).0 / observation.scale;
                gain -= value * residual;
                length += value * value;
            }
            (gain / length.sqrt() / size, time)
        })
        .filter(|&(gain, _)| gain > 1e-6)
        .max_by(|left, right| left.0.total_cmp(&right.0))
        .map(|(_, time)| time)
}

/// Neighbours on the grid are one term between two places of it.
fn joined(series: &Series) -> Series {
    join(series, 10f64.powf(1.5 / PER_DECADE))
}

/// Two terms this close are one.
fn joined_close(series: &Series) -> Series {
    join(series, 1.02)
}

fn join(series: &Series, ratio: f64) -> Series {
    let mut terms: Vec<(f64, f64)> = Vec::with_capacity(series.terms.len());
    let mut previous = 0.0;
    for &(strength, time) in &series.terms {
        match terms.last_mut() {
            Some(last) if time <= previous * ratio => *last = one_of_two(*last, (strength, time)),
            _ => terms.push((strength, time)),
        }
        previous = time;
    }
    Series { constant: series.constant, terms }
}

/// One term with the strength of two, at the mean of the logarithms of their times.
pub(super) fn one_of_two(left: (f64, f64), right: (f64, f64)) -> (f64, f64) {
    let strength = left.0 + right.0;
    (strength, left.1 * (right.1 / left.1).powf(right.0 / strength))
}

/// Neighbouring pairs that are tried at each removal, the most promising first.
const TRIED: usize = 3;

/// The series with one term fewer that fits best.
pub(super) fn one_fewer(series: &Series, data: &[Observation], window: [f64; 2], steps: usize) -> Option<Series> {
    let count = series.terms.len();
    if count == 0 {
        return None;
    }
    let merged = |index: usize| {
        let mut terms = series.terms.clone();
        if index + 1 < terms.len() {
            let one = one_of_two(terms[index], terms[index + 1]);
            terms.splice(index..index + 2, [one]);
        } else {
            terms.pop();
        }
        Series { constant: series.constant, terms }
    };
    let mut shorter: Vec<(f64, Series)> = (0..count)
        .map(|index| {
            let times: Vec<f64> = merged(index).terms.iter().map(|term| term.1).collect();
            let trial = Series::at_times(&times, data);
            (trial.misfit(data), trial)
        })
        .collect();
    shorter.sort_by(|left, right| left.0.total_cmp(&right.0));
    shorter
        .into_iter()
        .take(TRIED)
        .map(|(_, trial)| {
            let refined = trial.refined(data, window, steps);
            (refined.misfit(data), refined)
        })
        .min_by(|left, right| left.0.total_cmp(&right.0))
        .map(|(_, refined)| refined)
}

/// The fewest terms for the wanted error.
fn fewest(best: Series, data: &[Observation], window: [f64; 2], wanted: Wanted) -> Series {
    let count = data.len() as f64;
    let floor = ROUNDING * ROUNDING * count;
    // Schwarz's criterion: N ln(misfit/N) + freedom·ln N.
    let criterion = |series: &Series| count * ((series.misfit(data).max(floor)) / count).ln() + series.freedom() as f64 * count.ln();
    let mut chosen = best.clone();
    let mut lowest = criterion(&best);
    let mut current = best;
    while let Some(shorter) = one_fewer(&current, data, window, 40) {
        match wanted {
            Wanted::Error(error) => {
                if (shorter.misfit(data) / count).sqrt() > error {
                    break;
                }
                chosen = shorter.clone();
            }
            Wanted::Scatter => {
                let value = criterion(&shorter);
                if value < lowest {
                    lowest = value;
                    chosen = shorter.clone();
                } else if value > lowest + 20.0 * count.ln() {
                    break;
                }
            }
        }
        current = shorter;
    }
    chosen
}
