//! The moduli at both ends of a fitted series, and how far the data reach towards them.
//!
//! A modulus beyond the data is known as far as positive series disagree about it. Its stated error is the largest change for which some positive series, with any
//! strengths and any times that a fit may have, still follows the data as well: the sum of squares grows by at most four times the variance of a datum,
//! two standard deviations of a normal error. The covariance of one series with few terms says less than half of it.

use super::best::grid;
use super::choose::SeriesFit;
use super::observation::Observation;
use super::sample::Sample;
use super::series::{Ends, Series};
use crate::fit::least_squares::{non_negative, product, reduced};

/// A modulus at an end of the spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plateau {
    /// E0 or E∞ (Pa).
    pub modulus: f64,
    /// Its stated error (Pa): about 95 of 100 lie within it, if nothing relaxes beyond the times that a fit may have.
    pub error: f64,
    /// E′ of the series at the last datum towards this end (Pa).
    pub at_last: f64,
    /// The frequency of that datum (rad/s); of a curve against time 1/t.
    pub last: f64,
}

/// The last datum and the plateau differ by more than this part: the modulus is extrapolated.
const REACHED: f64 = 0.1;
/// Times reach this factor beyond the data, as those of a fit do.
const BEYOND: f64 = 3.0;
/// Grid times a decade.
const PER_DECADE: f64 = 10.0;
/// Growth of the sum of squares in variances of a datum.
const GROWTH: f64 = 4.0;
/// Weight of the row that holds a sum of strengths at a value.
const HELD: f64 = 1e3;
/// Halvings of the interval in which the error lies.
const HALVINGS: usize = 14;

impl Plateau {
    /// Whether the modulus lies beyond what was measured.
    #[must_use]
    pub fn is_extrapolated(&self) -> bool {
        (self.at_last - self.modulus).abs() > REACHED * self.at_last
    }
}

/// Least squares of the strengths on a grid, small enough to be solved many times.
struct Profile {
    columns: Vec<Vec<f64>>,
    target: Vec<f64>,
    least: f64,
    allowed: f64,
}

impl Profile {
    fn new(times: &[f64], sample: &Sample, ends: Ends, variance: f64) -> Self {
        let mut whole = Series::unit_columns(times, sample, ends);
        whole.push(sample.targets.clone());
        let mut columns = reduced(&whole, sample.places.len());
        let target = columns.pop().unwrap_or_default();
        let least = misfit(&columns, &target, &non_negative(&columns, &target));
        Self { columns, target, least, allowed: GROWTH * variance }
    }

    /// The value of a sum of strengths where the data are followed best.
    fn best(&self, parts: &[f64]) -> f64 {
        product(parts, &non_negative(&self.columns, &self.target))
    }

    /// Whether the data allow this value of the sum.
    fn allows(&self, parts: &[f64], value: f64) -> bool {
        let mut columns = self.columns.clone();
        for (column, part) in columns.iter_mut().zip(parts) {
            column.push(HELD * part / value);
        }
        let mut target = self.target.clone();
        target.push(HELD);
        misfit(&columns, &target, &non_negative(&columns, &target)) <= self.least + self.allowed
    }

    /// The range of a positive sum that the data allow: the sum of squares is convex in it.
    fn range(&self, parts: &[f64], value: f64) -> [f64; 2] {
        let best = self.best(parts).max(1e-3 * value);
        [0.5, 2.0].map(|factor| {
            // Outwards until the data refuse, then halved; a value that they never refuse is open by a factor of a thousand.
            let (mut inside, mut outside) = (best, best);
            for _ in 0..10 {
                outside *= factor;
                if !self.allows(parts, outside) {
                    break;
                }
                inside = outside;
            }
            if inside.total_cmp(&outside).is_eq() {
                return outside;
            }
            for _ in 0..HALVINGS {
                let middle = (inside * outside).sqrt();
                *(if self.allows(parts, middle) { &mut inside } else { &mut outside }) = middle;
            }
            outside
        })
    }
}

fn misfit(columns: &[Vec<f64>], target: &[f64], strengths: &[f64]) -> f64 {
    let mut rest = target.to_vec();
    for (column, strength) in columns.iter().zip(strengths) {
        rest.iter_mut().zip(column).for_each(|(rest, entry)| *rest -= entry * strength);
    }
    product(&rest, &rest)
}

impl SeriesFit {
    /// E0 and E∞ of a fit to these data.
    #[must_use]
    pub fn plateaus(&self, data: &[Observation]) -> [Plateau; 2] {
        let frequency = |one: &Observation| if one.quantity.by_frequency() { one.at } else { 1.0 / one.at };
        let [low, high] = data.iter().map(frequency).fold([f64::INFINITY, 0.0_f64], |[low, high], at| [low.min(at), high.max(at)]);
        let sample = Sample::combined(std::iter::once(data));
        let creep = sample.is_creep();
        let left = data.len().saturating_sub(self.band.freedom()).max(1) as f64;
        let variance = self.rms_error * self.rms_error * data.len() as f64 / left;
        // The times of the fit are among those of the grid, so that the grid follows the data as well.
        let mut times = grid([1.0 / (BEYOND * high), BEYOND / low], PER_DECADE);
        if creep {
            times.extend(self.material.creep_terms().iter().map(|term| term.retardation_time));
        } else {
            times.extend(self.material.relaxation_terms().iter().map(|term| term.relaxation_time));
        }
        let ends = Ends { constant: true, flow: creep };
        let profile = Profile::new(&times, &sample, ends, variance);
        // The strength of the constant, and of all but the flow.
        let own = 1 + usize::from(creep);
        let part_of = |constant_only: bool| -> Vec<f64> {
            (0..own + times.len()).map(|index| f64::from(u8::from(index == 0 || (!constant_only && index >= own)))).collect()
        };
        let of = |modulus: f64, last: f64, constant_only: bool| {
            let error = if modulus > 0.0 {
                let sum = if creep { 1.0 / modulus } else { modulus };
                let ends = profile.range(&part_of(constant_only), sum).map(|end| if creep { 1.0 / end } else { end });
                ends.into_iter().map(|end| (end - modulus).abs()).fold(0.0, f64::max)
            } else {
                0.0
            };
            let at_last = self.material.complex_modulus(last).map_or(f64::NAN, |modulus| modulus.storage);
            Plateau { modulus, error, at_last, last }
        };
        [of(self.material.relaxed_modulus(), low, !creep), of(self.material.glassy_modulus(), high, creep)]
    }
}
