//! Whether measured moduli can be those of a passive causal solid: Kramers and Kronig's relations held against the data.
//!
//! Two checks that share nothing but the data:
//! - E′ and E″ are fitted together by a positive series, which obeys the relations exactly, and once more with a factor on E″ that changes slowly with frequency
//!   (`distortion`). The sums of squares S₀ and S of both are compared as nested models are: with d coefficients of the factor and ν numbers of the data that
//!   the fit leaves, scatter alone makes q = S/S₀ as small as this with the chance
//!   ```text
//!   d = 2:  q^(ν/2)          d = 4:  q^(ν/2)·(1 + ν/2·(1 − q))          (F distribution, Abramowitz and Stegun 26.6.4)
//!   ```
//!   A positive term counts as two numbers. Where hardly a number is left, the fit follows the scatter, too: what is known of such measurements stands in for it.
//! - The local relation E″ ≈ (π/2) dE′/d ln ω (Booij and Thoone, 1982, *Rheol. Acta* 21, 15), good to some ten per cent on broad spectra.

use super::best::best_fit;
use super::distortion::{Distorted, distorted};
use super::observation::{Observation, Quantity};
use super::sample::Sample;
use super::series::Ends;

/// What the checks gave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Consistency {
    /// Root mean square relative residual of the best positive series for E′ and E″ together.
    pub together: f64,
    /// The same where E″ is that of the series times a factor that changes slowly with frequency.
    pub with_factor: f64,
    /// The smallest and the largest value of that factor over the data.
    pub factor: [f64; 2],
    /// The chance that scatter alone makes the factor help as much.
    pub chance: f64,
    /// Median of |E″ − (π/2) dE′/d ln ω|/E″ over the data, where three neighbouring frequencies give a slope; none without such places.
    pub local: Option<f64>,
}

/// Below this chance the two moduli do not belong together.
const CHANCE: f64 = 0.01;
/// Residuals below this part are rounding of printed data, and ends of searches.
const PRINTED: f64 = 2e-3;
/// What is known before: dynamic tests scatter by about this part, and that counts as so many numbers.
const SCATTER: f64 = 0.02;
const NUMBERS: f64 = 6.0;

impl Consistency {
    /// Whether one passive solid can have both moduli: scatter explains what a factor on one of them would.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.chance >= CHANCE
    }
}

/// The chance that scatter alone makes two or four further numbers lower the sum of squares to this part, with so many numbers left.
fn chance(part: f64, further: usize, left: f64) -> f64 {
    if part >= 1.0 {
        return 1.0;
    }
    let power = part.powf(0.5 * left);
    if further == 2 { power } else { power * (1.0 + 0.5 * left * (1.0 - part)) }
}

/// Checks complex moduli; none if the data hold no pair of both.
#[must_use]
pub fn check(data: &[Observation]) -> Option<Consistency> {
    let of = |quantity: Quantity| data.iter().copied().filter(|observation| observation.quantity == quantity).collect::<Vec<_>>();
    let (storage, loss) = (of(Quantity::Storage), of(Quantity::Loss));
    if storage.len() < 3 || loss.len() < 3 {
        return None;
    }
    let both: Vec<Observation> = storage.iter().chain(&loss).copied().collect();
    let (low, high) = both.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), one| (low.min(one.at), high.max(one.at)));
    let sample = Sample::combined(std::iter::once(both.as_slice()));
    // Spectra reach beyond the measured range.
    let window = [0.1 / high, 10.0 / low];
    let joint = best_fit(&sample, window, Ends { constant: true, flow: false });
    let (two, four) = rayon::join(|| distorted(&joint, 2, &sample, window), || distorted(&joint, 4, &sample, window));
    // The search for a factor may have met a better series.
    let others = [&two, &four].map(|other| other.series.clone().refined(&sample, window, REFINED).misfit(&sample));
    let together = others.into_iter().fold(joint.misfit(&sample), f64::min);
    let count = sample.count as f64;
    let known = NUMBERS * SCATTER * SCATTER + count * PRINTED * PRINTED;
    let tried = [(2, two), (4, four)].map(|(further, one): (usize, Distorted)| {
        let left = (count - (one.series.freedom() + further) as f64).max(0.0) + NUMBERS;
        (chance((one.misfit + known) / (together + known), further, left), one)
    });
    // The smaller of two chances.
    let [two, four] = tried;
    let (smaller, best) = if two.0 <= four.0 { two } else { four };
    let rms = |misfit: f64| (misfit / count).sqrt();
    Some(Consistency {
        together: rms(together),
        with_factor: rms(best.misfit.min(together)),
        factor: best.range,
        chance: (2.0 * smaller).min(1.0),
        local: local(&storage, &loss),
    })
}

/// Steps of a descent from the series of a fit with a factor.
const REFINED: usize = 60;

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
