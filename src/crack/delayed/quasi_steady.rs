//! Growth under a load that changes little while the tip crosses its zone: steady motion at the present load, corrected to first order.
//!
//! Over the time T in which the zone z is crossed let κ(t − s) = κ − κ̇s and x(t) − x(t − s) = vs − ½as². The closure is then, to first order
//! in κ̇ and a, with T = z/v, z_j = l_jT and the moments n_k(z_j) of [`super::moments`],
//! ```text
//! 1 = κ² + κ Σ g_jT { κ(n₀ − n₁) + κ (aT²/2z) n₂ − κ̇T (n₁ − n₂) }        a = κ̇ d(z/T₀)/dκ
//! ```
//! T₀ solves it without κ̇ and a. What is left out is of second order: the square of the correction, while (a step of the load every so many
//! zones) each e-fold of the speed takes about 1/correction zones.

use super::memory::Term;
use super::moments::fading_moments;
use super::zone::RelativeZone;
use crate::continuation::root::{LogSlope, increasing_root};
use serde::{Deserialize, Serialize};

/// When motion counts as quasi-steady.
pub(super) struct Steadiness;

impl Steadiness {
    /// The greatest difference between the cubic of a panel and its quadrature, over the way in it.
    pub(super) const PANEL: f64 = 1e-10;

    /// The greatest squared correction. It falls with the lines as the error of stepping does, so that the runs show the error of both, down
    /// to where as many zones would have to be stepped as pass in a change of the speed by 1 in 2000.
    pub(super) fn tolerance(lines_per_zone: u32) -> f64 {
        let lines = f64::from(lines_per_zone);
        (4e-3 / (lines * lines)).max(2.5e-7)
    }

    /// Rounding of the speed near the glassy limit, relative to it.
    pub(super) fn noise(load: f64) -> f64 {
        32.0 * f64::EPSILON / (1.0 - load).max(f64::EPSILON)
    }
}

/// The solver of quasi-steady motion.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct QuasiSteady {
    terms: Vec<Term>,
    zone: RelativeZone,
    /// The last crossing time: where the next is looked for.
    last: f64,
    /// Evaluations of the closure.
    pub(super) evaluations: u64,
}

/// Quasi-steady motion at a load: speed and acceleration in greatest zones.
#[derive(Debug, Clone, Copy)]
pub(super) struct QuasiSteadyMotion {
    pub(super) speed: f64,
    pub(super) acceleration: f64,
    pub(super) crossing_time: f64,
    /// The first-order part of the speed, relative to it.
    pub(super) correction: f64,
    /// d(w/Δγ)/d ln T.
    pub(super) sensitivity: f64,
    /// Rounding of the speed, relative to it.
    rounding: f64,
}

impl QuasiSteady {
    pub(super) const fn new(terms: Vec<Term>, zone: RelativeZone) -> Self {
        Self { terms, zone, last: 0.0, evaluations: 0 }
    }

    /// Σ g_jT(n₀ − n₁) and its slope T d/dT = Σ g_jT n₁, and the two sums of the correction.
    fn sums(&self, time: f64) -> [f64; 4] {
        let mut sums = [0.0; 4];
        for term in &self.terms {
            let (_, [n0, n1, n2, _]) = fading_moments(term.rate * time);
            let gain = term.gain * time;
            for (sum, part) in sums.iter_mut().zip([n0 - n1, n1, n2, n1 - n2]) {
                *sum += gain * part;
            }
        }
        sums
    }

    /// The motion at a load that rises by `slope` a second; none where no steady motion exists.
    pub(super) fn motion(&mut self, load: f64, slope: f64) -> Option<QuasiSteadyMotion> {
        let wanted = 1.0 / (load * load) - 1.0;
        let gains: f64 = self.terms.iter().map(|term| term.gain).sum();
        // n₀ − n₁ ≤ ½.
        let lower = 2.0 * wanted / gains * (1.0 - 1e-15);
        if !(wanted > 0.0 && lower > 0.0 && lower.is_finite()) {
            return None;
        }
        let start = self.last.max(lower);
        let mut upper = 2.0 * start;
        let mut evaluations = 1;
        while self.sums(upper)[0] <= wanted {
            evaluations += 1;
            upper *= 8.0;
            if !upper.is_finite() || evaluations > 60 {
                self.evaluations += evaluations;
                return None;
            }
        }
        let function = |time: f64| {
            evaluations += 1;
            let [sum, slope, ..] = self.sums(time);
            LogSlope { value: (sum / wanted).ln(), slope: slope / sum }
        };
        let root = increasing_root("the crossing time of quasi-steady growth", function, [lower, upper], start, 4.0 * f64::EPSILON);
        self.evaluations += evaluations;
        let time = root.ok()?.argument;
        self.last = time;
        let [sum, first, second, third] = self.sums(time);
        let (zone, zone_rate) = (self.zone.at(load), self.zone.rate(load, slope));
        // κ²(1 + S(T)) = 1 along the ramp: Ṫ = −2κ̇(1 + S)/(κS′), and T S′ = `first`.
        let time_rate = -2.0 * slope * (1.0 + sum) / (load * first) * time;
        let speed = zone / time;
        let acceleration = zone_rate / time - speed * time_rate / time;
        let gained = load * (0.5 * acceleration * time * time / zone) * second - slope * time * third;
        // κ² T S′ δT/T = −κ·gained
        let correction = gained / (load * first);
        // An ulp of κ², over how much the sum feels the time.
        let rounding = 1e-14 + 8.0 * f64::EPSILON * (1.0 + sum) / first;
        let sensitivity = load * load * first;
        let speed = speed * (1.0 + correction);
        let motion = QuasiSteadyMotion { speed, acceleration, crossing_time: time, correction, sensitivity, rounding };
        (motion.speed.is_finite() && motion.speed > 0.0 && acceleration.is_finite()).then_some(motion)
    }
}

/// What is left out of the speed is taken as so many squares of the correction: a bound that holds against stepping every zone, on ramps up
/// and down (tests/crack/sec_5_4_slow_loads.rs), not a proven one.
const LEFT_OUT: f64 = 8.0;

impl QuasiSteadyMotion {
    /// What is not known of the speed, relative to it.
    pub(super) fn uncertainty(&self) -> f64 {
        LEFT_OUT * self.correction * self.correction + self.rounding
    }

    /// The way to here, as distances behind, times before and loads: finely over the present zone, coarsely over the rest of the greatest one.
    /// All times are multiplied by a factor.
    pub(super) fn way(&self, load: f64, slope: f64, zone: f64, lines: u32, factor: f64) -> Vec<[f64; 3]> {
        let point = |distance: f64| {
            // d = vs − ½as²
            let root = (self.speed * self.speed - 2.0 * self.acceleration * distance).max(0.0).sqrt();
            let time = factor * (2.0 * distance / (self.speed + root));
            [distance, time, (load - slope * time).max(0.0)]
        };
        let near = (0..=lines).rev().map(|line| zone * f64::from(line) / f64::from(lines));
        let far = (1..=32_u32).rev().map(|line| zone + (1.0 - zone) * f64::from(line) / 32.0).filter(|distance| *distance > zone);
        far.chain(near).map(point).collect()
    }
}
