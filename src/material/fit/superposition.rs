//! Isotherms brought onto one curve: shift factors from the data, with errors, and whether time–temperature superposition holds.
//!
//! ```text
//! E(a_T ω; T_ref) = b_T E(ω; T),     J(t/a_T; T_ref) = J(t; T)/b_T
//! neighbours overlap ──► first factors ──► factors, strengths and times refined together
//!                    ──► number of terms ──► errors of all from one covariance
//! ```
//! The master curve is a series with positive strengths, so no curve of another form is put between the data; what the shifts leave open is in the errors of
//! the fit, and the other way round.

use super::best::best_fit;
use super::choose::{Wanted, check, fitted, general, window};
use super::joint::{self, Free};
use super::law::{LawFit, arrhenius, williams_landel_ferry};
use super::observation::Observation;
use super::sample::Sample;
use super::starts;
use super::{SeriesFit, choose};
use crate::material::Material;
use crate::material::shift::ShiftFactors;
use crate::refusal::Refusal;

/// Measurements at one temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Isotherm {
    /// Temperature (K).
    pub temperature: f64,
    /// What was measured there, not shifted.
    pub data: Vec<Observation>,
}

/// The shift of one isotherm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundShift {
    /// Temperature (K).
    pub temperature: f64,
    /// ln a_T.
    pub logarithm: f64,
    /// Stated error of ln a_T, relative to the base isotherm: two standard deviations.
    pub error: f64,
    /// ln b_T.
    pub vertical: f64,
    /// Stated error of ln b_T; 0 where it was not looked for.
    pub vertical_error: f64,
}

/// Isotherms on one curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Superposition {
    /// The series at the reference temperature.
    pub fit: SeriesFit,
    /// Temperatures rising.
    pub shifts: Vec<FoundShift>,
    /// Reference temperature (K): a_T is 1 there.
    pub reference: f64,
    /// Index of the isotherm to which the errors of the shifts are relative.
    pub base: usize,
    /// Scatter about the common series (relative, per degree of freedom).
    pub together: f64,
    /// Scatter of the isotherms, each about a series of its own; none where they are too short to say.
    pub alone: Option<f64>,
    /// Degrees of freedom of the latter.
    pub freedom: usize,
    /// Williams, Landel and Ferry's law through the factors, its reference the base isotherm.
    pub williams_landel_ferry: Option<LawFit<2>>,
    /// Arrhenius's law.
    pub arrhenius: Option<LawFit<1>>,
}

/// Residuals below this part are rounding of printed data.
const PRINTED: f64 = 2e-3;
/// Standard deviations of the scatter's own error that are granted.
const GRANTED: f64 = 4.0;
/// A factor that is known no better than this (in its logarithm) is not known.
const UNKNOWN: f64 = std::f64::consts::LN_10;
/// Times of a single isotherm reach this much further than those of a master curve.
const FAR: f64 = 100.0;
/// Rounds of fitting and shifting.
const ROUNDS: usize = 6;

impl Superposition {
    /// Whether one curve follows all isotherms as well as each follows its own; none where that cannot be said.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        let alone = self.alone?;
        let granted = (1.0 + GRANTED * (2.0 / self.freedom.max(1) as f64).sqrt()).sqrt();
        Some(self.together <= granted * alone + PRINTED)
    }
}

impl Superposition {
    /// The factors as a table, between whose temperatures ln a_T is linear in 1/T.
    #[must_use]
    pub fn factors(&self) -> ShiftFactors {
        ShiftFactors::Table(self.shifts.iter().map(|shift| (shift.temperature, shift.logarithm.exp())).collect())
    }

    /// Materials at a temperature (K) within the measured ones, drawn from what the data leave open of the series and of the factors together.
    ///
    /// # Errors
    /// As [`SeriesFit::draws`]; [`Refusal::Undefined`] where a time overflows.
    pub fn draws_at(&self, temperature: f64, count: usize, seed: u64) -> Result<Vec<Material>, Refusal> {
        let at = |shifts: &[(f64, f64)]| -> Vec<(f64, f64)> {
            self.shifts.iter().zip(shifts).map(|(found, drawn)| (found.temperature, drawn.0)).collect()
        };
        let draws = self.fit.draws_with_shifts(count, seed)?;
        draws.into_iter().map(|(material, shifts)| material.slowed(between(&at(&shifts), temperature).exp())).collect()
    }
}

fn refused(reason: String) -> Refusal {
    Refusal::Undefined { quantity: "a shift factor", reason }
}

/// Finds the shifts of isotherms (temperatures rising) and fits a series at a reference temperature (K), given or that of the middle isotherm.
///
/// # Errors
/// [`Refusal::Undefined`] for fewer than two isotherms, neighbours that do not overlap, a factor that the data do not fix, or a reference temperature outside
/// the measured ones; what [`super::fit`] refuses.
pub fn superpose(isotherms: &[Isotherm], reference: Option<f64>, vertical: bool, wanted: Wanted) -> Result<Superposition, Refusal> {
    let (Some(first), Some(last)) = (isotherms.first(), isotherms.last()) else { return Err(refused("there are no isotherms".into())) };
    if isotherms.len() < 2 {
        return Err(refused(format!("there is one temperature only, {:.2} K", first.temperature)));
    }
    let every: Vec<Observation> = isotherms.iter().flat_map(|isotherm| isotherm.data.iter().copied()).collect();
    check(&every, wanted)?;
    if reference.is_some_and(|reference| reference < first.temperature - 1e-6 || reference > last.temperature + 1e-6) {
        return Err(refused(format!("the reference temperature is outside {:.2} K to {:.2} K", first.temperature, last.temperature)));
    }
    let distance = |isotherm: &Isotherm| reference.map_or(0.0, |reference| (isotherm.temperature - reference).abs());
    let nearest = isotherms.iter().enumerate().min_by(|left, right| distance(left.1).total_cmp(&distance(right.1)));
    let base = if reference.is_some() { nearest.map_or(0, |(index, _)| index) } else { (isotherms.len() - 1) / 2 };
    let free = Free { isotherms: isotherms.len(), base, vertical };
    let sample = Sample::combined(isotherms.iter().map(|isotherm| isotherm.data.as_slice()));
    let mut shifts = first_shifts(isotherms, base, vertical)?;
    for _ in 0..ROUNDS {
        let shifted = sample.shifted(&shifts);
        let window = window(&shifted);
        let series = best_fit(&shifted, window, general(&sample));
        let (_, moved) = joint::refined(series, shifts.clone(), &sample, free, window, 60);
        let change = moved.iter().zip(&shifts).map(|(new, old)| (new.0 - old.0).abs().max((new.1 - old.1).abs())).fold(0.0, f64::max);
        shifts = moved;
        if change < 1e-4 {
            break;
        }
    }
    if let Some(reference) = reference {
        let points: Vec<(f64, f64)> = isotherms.iter().zip(&shifts).map(|(isotherm, shift)| (isotherm.temperature, shift.0)).collect();
        let offset = between(&points, reference);
        shifts.iter_mut().for_each(|shift| shift.0 -= offset);
    }
    let fit = fitted(&sample, &shifts, free, wanted, isotherms.iter().map(|isotherm| isotherm.data.as_slice()))?;
    let found: Vec<FoundShift> = isotherms
        .iter()
        .enumerate()
        .map(|(index, isotherm)| {
            let [(logarithm, error), (vertical, vertical_error)] = fit.band.shift(index);
            FoundShift { temperature: isotherm.temperature, logarithm, error, vertical, vertical_error }
        })
        .collect();
    if let Some(open) = found.iter().find(|shift| shift.error.is_nan() || shift.error > UNKNOWN) {
        return Err(refused(format!(
            "the data at {:.2} K fix it only within {:.1} decades: they and their neighbours hardly change with frequency or time where they overlap",
            open.temperature,
            open.error / std::f64::consts::LN_10
        )));
    }
    let (alone, freedom) = scatter_alone(isotherms);
    let numbers = fit.band.freedom();
    let together = fit.rms_error * (every.len() as f64 / every.len().saturating_sub(numbers).max(1) as f64).sqrt();
    let others: Vec<usize> = (0..isotherms.len()).filter(|&index| index != base).collect();
    let covariance: Vec<Vec<f64>> =
        others.iter().map(|&one| others.iter().map(|&other| fit.band.shift_covariance(one, other)).collect()).collect();
    let origin = found.get(base).map_or(0.0, |shift| shift.logarithm);
    let points: Vec<(f64, f64)> =
        others.iter().filter_map(|&index| found.get(index)).map(|shift| (shift.temperature, shift.logarithm - origin)).collect();
    let at = isotherms.get(base).map_or(first.temperature, |isotherm| isotherm.temperature);
    Ok(Superposition {
        reference: reference.unwrap_or(at),
        williams_landel_ferry: williams_landel_ferry(&points, &covariance, at),
        arrhenius: arrhenius(&points, &covariance, at),
        fit,
        shifts: found,
        base,
        together,
        alone,
        freedom,
    })
}

/// First factors: each isotherm onto its neighbour.
fn first_shifts(isotherms: &[Isotherm], base: usize, vertical: bool) -> Result<Vec<(f64, f64)>, Refusal> {
    let curves: Vec<starts::Isotherm> = isotherms.iter().map(|isotherm| starts::Isotherm::new(&isotherm.data)).collect();
    let mut logarithms = vec![0.0];
    for (pair, neighbours) in curves.windows(2).zip(isotherms.windows(2)) {
        let step = pair[1].onto(&pair[0], vertical).map_err(|common| {
            refused(format!(
                "the curves at {:.2} K and {:.2} K do not overlap: {common} steps of their moduli or compliances lie in values that both reach, and three are needed",
                neighbours[0].temperature, neighbours[1].temperature
            ))
        })?;
        logarithms.push(logarithms.last().copied().unwrap_or(0.0) + step);
    }
    let origin = logarithms.get(base).copied().unwrap_or(0.0);
    Ok(logarithms.into_iter().map(|logarithm| (logarithm - origin, 0.0)).collect())
}

/// ln a_T between measured temperatures, linear in 1/T as in a table.
fn between(points: &[(f64, f64)], temperature: f64) -> f64 {
    if let Some(own) = points.iter().find(|point| (point.0 - temperature).abs() <= 1e-9 * temperature) {
        return own.1;
    }
    let pair = points.windows(2).find(|pair| pair[0].0 <= temperature && temperature <= pair[1].0);
    pair.map_or(0.0, |pair| {
        let part = (1.0 / pair[0].0 - 1.0 / temperature) / (1.0 / pair[0].0 - 1.0 / pair[1].0);
        pair[0].1 + part * (pair[1].1 - pair[0].1)
    })
}

/// Scatter of the isotherms about series of their own, and its degrees of freedom.
fn scatter_alone(isotherms: &[Isotherm]) -> (Option<f64>, usize) {
    let (mut misfit, mut freedom) = (0.0, 0);
    for isotherm in isotherms.iter().filter(|isotherm| isotherm.data.len() >= choose::LEAST_DATA) {
        let sample = Sample::combined(std::iter::once(isotherm.data.as_slice()));
        let [low, high] = window(&sample);
        // A sweep is short: much of its spectrum lies beyond it.
        let own = best_fit(&sample, [low / FAR, high * FAR], general(&sample));
        let left = sample.count.saturating_sub(own.freedom());
        if left > 0 {
            misfit += own.misfit(&sample);
            freedom += left;
        }
    }
    ((freedom > 0).then(|| (misfit / freedom as f64).sqrt()), freedom)
}
