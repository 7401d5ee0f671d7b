//! Whether measured moduli can be those of a passive causal solid: Kramers and Kronig's relations held against the data.
//!
//! Two checks that share nothing but the data:
//! - E′ and E″ are each fitted alone and both together by positive series, which obey the relations exactly. If both follow well alone and
//!   badly together, the two belong to different spectra.
//! - The local relation E″ ≈ (π/2) dE′/d ln ω (Booij and Thoone, 1982, *Rheol. Acta* 21, 15), good to some ten per cent on broad spectra.

use super::best::best_fit;
use super::observation::{Observation, Quantity};
use super::sample::Sample;
use super::series::Ends;

/// What the checks gave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Consistency {
    /// Root mean square relative residual of the best positive series for E′ alone.
    pub storage_alone: f64,
    /// The same for E″ alone.
    pub loss_alone: f64,
    /// The same for both together.
    pub together: f64,
    /// Median of |E″ − (π/2) dE′/d ln ω|/E″ over the data, where three neighbouring frequencies give a slope; none without such places.
    pub local: Option<f64>,
}

/// Data that agree alone within this need not agree better together: fits of few noisy data differ by it.
const GRANTED: f64 = 2.0;
/// Residuals below this part are rounding of printed data.
const PRINTED: f64 = 2e-3;

impl Consistency {
    /// Whether one passive solid can have both moduli: the common fit is not much worse than the two apart.
    #[must_use]
    pub fn holds(&self) -> bool {
        let apart = (0.5 * (self.storage_alone.powi(2) + self.loss_alone.powi(2))).sqrt();
        self.together <= GRANTED * apart + PRINTED
    }
}

/// Checks complex moduli; none if the data hold no pair of both.
#[must_use]
pub fn check(data: &[Observation]) -> Option<Consistency> {
    let of = |quantity: Quantity| data.iter().copied().filter(|observation| observation.quantity == quantity).collect::<Vec<_>>();
    let (storage, loss) = (of(Quantity::Storage), of(Quantity::Loss));
    if storage.len() < 3 || loss.len() < 3 {
        return None;
    }
    let rms = |part: &[Observation]| {
        let (low, high) = part.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), one| (low.min(one.at), high.max(one.at)));
        // Spectra reach beyond the measured range; each part alone is helped by terms out there as the common fit is.
        let sample = Sample::combined(std::iter::once(part));
        let best = best_fit(&sample, [0.1 / high, 10.0 / low], Ends { constant: true, flow: false });
        (best.misfit(&sample) / part.len() as f64).sqrt()
    };
    let both: Vec<Observation> = storage.iter().chain(&loss).copied().collect();
    let (together, (storage_alone, loss_alone)) = rayon::join(|| rms(&both), || rayon::join(|| rms(&storage), || rms(&loss)));
    Some(Consistency { storage_alone, loss_alone, together, local: local(&storage, &loss) })
}

/// A median needs no more places than this.
const PLACES: usize = 1000;

/// The local relation at measured losses that lie inside the measured storage moduli: at all of them, or evenly at a thousand.
fn local(storage: &[Observation], loss: &[Observation]) -> Option<f64> {
    let mut points: Vec<(f64, f64)> = storage.iter().map(|one| (one.at.ln(), one.value)).collect();
    points.sort_by(|left, right| left.0.total_cmp(&right.0));
    let mut deviations: Vec<f64> = loss
        .iter()
        .step_by(loss.len().div_ceil(PLACES).max(1))
        .filter(|one| one.value > 0.0)
        .filter_map(|one| {
            let slope = slope(&points, one.at.ln())?;
            Some((one.value - std::f64::consts::FRAC_PI_2 * slope).abs() / one.value)
        })
        .collect();
    deviations.sort_by(f64::total_cmp);
    deviations.get(deviations.len() / 2).copied()
}

/// dE′/d ln ω by a straight line through the points within half a decade: at least three on both sides.
fn slope(points: &[(f64, f64)], at: f64) -> Option<f64> {
    let reach = 0.5 * std::f64::consts::LN_10;
    let first = points.partition_point(|point| point.0 < at - reach);
    let last = points.partition_point(|point| point.0 <= at + reach);
    let near = points.get(first..last)?;
    let sides = |sign: f64| near.iter().any(|point| (point.0 - at) * sign > 0.0);
    if near.len() < 3 || !sides(1.0) || !sides(-1.0) {
        return None;
    }
    let count = near.len() as f64;
    let mean = near.iter().map(|point| point.0).sum::<f64>() / count;
    let height = near.iter().map(|point| point.1).sum::<f64>() / count;
    let across: f64 = near.iter().map(|point| (point.0 - mean) * (point.1 - height)).sum();
    let along: f64 = near.iter().map(|point| (point.0 - mean).powi(2)).sum();
    (along > 0.0).then(|| across / along)
}

/// Whether the steps of a frequency table leave a gap wider than a decade; gives its two ends (rad/s or s).
#[must_use]
pub fn widest_gap(data: &[Observation]) -> Option<[f64; 2]> {
    let mut places: Vec<f64> = data.iter().map(|one| one.at).collect();
    places.sort_by(f64::total_cmp);
    let widest = places
        .windows(2)
        .filter_map(|pair| <[f64; 2]>::try_from(pair).ok())
        .max_by(|left, right| (left[1] / left[0]).total_cmp(&(right[1] / right[0])))?;
    (widest[1] / widest[0] > 10.0).then_some(widest)
}
