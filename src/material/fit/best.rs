//! The best fit that positive strengths allow with any number of terms, as far as this search finds it, and one term fewer.

use super::sample::Sample;
use super::series::{Ends, Series};
use crate::fit::least_squares;

/// Grid times a decade of the first stage.
const PER_DECADE: f64 = 10.0;
/// Double precision ends here: smaller residuals say nothing.
pub(super) const ROUNDING: f64 = 1e-14;
/// A further term is worth its while if it lowers the misfit by this part: of noise, a thousandth is nothing.
const WORTH: f64 = 1e-3;
/// Most terms of a series.
const MOST_TERMS: usize = 120;

/// Log-spaced times over a window.
pub(super) fn grid(window: [f64; 2], per_decade: f64) -> Vec<f64> {
    let decades = (window[1] / window[0]).log10();
    let steps = (decades * per_decade).ceil().max(1.0);
    (0..=steps as usize).map(|index| window[0] * 10f64.powf(decades * index as f64 / steps)).collect()
}

/// The best fit that positive strengths allow, whatever its number of terms.
pub(super) fn best_fit(sample: &Sample, window: [f64; 2], ends: Ends) -> Series {
    let on_grid = Series::at_times(&grid(window, PER_DECADE), sample, ends);
    let mut series = joined(&on_grid).refined(sample, window, 60);
    let fine = grid(window, 4.0 * PER_DECADE);
    let floor = ROUNDING * ROUNDING * sample.count as f64;
    // As long as a new term somewhere lowers the misfit, add it there: at the optimum the gradient is positive nowhere.
    for _ in 0..MOST_TERMS {
        let misfit = series.misfit(sample);
        if misfit <= floor || series.terms.len() >= MOST_TERMS {
            break;
        }
        let Some(time) = steepest(&series, sample, &fine) else { break };
        let mut times: Vec<f64> = series.terms.iter().map(|term| term.1).collect();
        times.push(time);
        let trial = joined_close(&Series::at_times(&times, sample, ends)).refined(sample, window, 30);
        let reached = trial.misfit(sample);
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
fn steepest(series: &Series, sample: &Sample, times: &[f64]) -> Option<f64> {
    let residuals = series.residuals(sample);
    let size = residuals.iter().map(|residual| residual * residual).sum::<f64>().sqrt();
    times
        .iter()
        .map(|&time| {
            let values = sample.places.iter().map(|place| place.quantity.kernel(place.quantity.argument(place.at, time)).0).collect();
            let (mut gain, mut length) = (0.0, 0.0);
            for (value, residual) in sample.rows(values).into_iter().zip(&residuals) {
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
    Series { terms, ..series.clone() }
}

/// One term with the strength of two, at the mean of the logarithms of their times.
pub(super) fn one_of_two(left: (f64, f64), right: (f64, f64)) -> (f64, f64) {
    let strength = left.0 + right.0;
    (strength, left.1 * (right.1 / left.1).powf(right.0 / strength))
}

/// Neighbouring pairs that are tried at each removal, the most promising first.
const TRIED: usize = 3;

/// The series with one term fewer that fits best.
pub(super) fn one_fewer(series: &Series, sample: &Sample, window: [f64; 2], steps: usize) -> Option<Series> {
    let count = series.terms.len();
    if count == 0 {
        return None;
    }
    // The columns of all terms, of the neighbours in one, and of the data, reduced to a triangle once.
    let times: Vec<f64> = series.terms.iter().map(|term| term.1).collect();
    let joined: Vec<f64> = series.terms.windows(2).map(|pair| one_of_two(pair[0], pair[1]).1).collect();
    let every: Vec<f64> = times.iter().chain(&joined).copied().collect();
    let mut columns = Series::unit_columns(&every, sample, series.ends);
    let own = columns.len() - every.len();
    columns.push(sample.targets.clone());
    let mut small = least_squares::reduced(&columns, sample.places.len());
    let target = small.pop()?;
    let mut shorter: Vec<(f64, Series)> = (0..count)
        .map(|index| {
            let kept = (0..index).chain(joined.get(index).map(|_| count + index)).chain(index + 2..count);
            let places: Vec<usize> = kept.collect();
            let part: Vec<Vec<f64>> =
                (0..own).chain(places.iter().map(|place| own + place)).filter_map(|j| small.get(j).cloned()).collect();
            let strengths = least_squares::non_negative(&part, &target);
            let mut residual = target.clone();
            for (column, strength) in part.iter().zip(&strengths) {
                residual.iter_mut().zip(column).for_each(|(rest, entry)| *rest -= entry * strength);
            }
            let chosen: Vec<f64> = places.iter().filter_map(|&place| every.get(place).copied()).collect();
            (least_squares::product(&residual, &residual), Series::with_strengths(&strengths, &chosen, series.ends))
        })
        .collect();
    shorter.sort_by(|left, right| left.0.total_cmp(&right.0));
    shorter
        .into_iter()
        .take(TRIED)
        .map(|(_, trial)| {
            let refined = trial.refined(sample, window, steps);
            (refined.misfit(sample), refined)
        })
        .min_by(|left, right| left.0.total_cmp(&right.0))
        .map(|(_, refined)| refined)
}
