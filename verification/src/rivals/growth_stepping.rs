//! Growth of a crack under a constant load by stepping the closure as the thesis prints it (Eqs 5.50–5.54 with 5.67), without the collapse.
//!
//! ```text
//! (c/2δ) ∫₀^δ K/√(2πd) · u(δ − d, t) dd = Δγ,      u(s, t) = √(8/π) K ∫ √(s − x₀(t) + x₀(t₁))₊ (−dJ(t − t₁)/dt₁) dt₁ + √(8s/π) K/E∞
//! ```
//! | symbol | name | unit |
//! |---|---|---|
//! | t_n | equal steps, [`GrowthStepping::steps`] of them up to `end` | s |
//! | θ | d = δ sin²θ, `points` midpoints of equal width: takes both roots away | – |
//! | x₀(t_n) | found by regula falsi (Illinois) at each step, never below the place before | m |
//!
//! Increments of J between steps weigh the mean of √(…)₊ at both ends. Each trial sums all points over all times: the cost is quadratic in the
//! steps. A start between two steps is found to first order only, so let the delay be a whole number of them. Shares nothing with
//! [`viscotack::crack::delayed`], neither the collapse nor the memory; the same in Python is `verification/references/delayed_fracture.py`.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::{Refusal, require_positive};

/// Trials of one place.
const MOST_TRIALS: u32 = 80;
/// Accepted defect of the work, over the work of adhesion.
const TOLERANCE: f64 = 1e-12;

/// The scheme for one constant load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowthStepping {
    /// Δγ (J/m²).
    pub work_of_adhesion: f64,
    /// δ (m).
    pub process_zone: f64,
    /// c: how many halves deform.
    pub deformable_halves: f64,
    /// K (Pa √m) from time zero on.
    pub intensity: f64,
    /// The last time (s).
    pub end: f64,
    /// Steps up to it.
    pub steps: usize,
    /// Points of the process zone.
    pub points: usize,
}

/// The tip at every step, and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct SteppedGrowth {
    /// x₀ at t = 0, end/steps, … (m).
    pub places: Vec<f64>,
    /// Evaluations of the closure.
    pub closure_evaluations: u64,
    /// Roots √(…)₊ taken.
    pub kernel_evaluations: u64,
}

impl GrowthStepping {
    /// Steps the tip to the end.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a number that is not positive; [`Refusal::NotConverged`] where a place is not found, as under a load at the
    /// glassy limit.
    pub fn run(&self, material: &PlaneMaterial) -> Result<SteppedGrowth, Refusal> {
        require_positive("work_of_adhesion", self.work_of_adhesion)?;
        let zone = require_positive("process_zone", self.process_zone)?;
        require_positive("intensity", self.intensity)?;
        let step = require_positive("end", self.end)? / require_positive("steps", self.steps as f64)?;
        let width = FRAC_PI_2 / require_positive("points", self.points as f64)?;
        // s = δ cos²θ and σ dd/K = 2√δ cos θ dθ/√(2π).
        let cosines: Vec<f64> = (0..self.points).map(|index| ((index as f64 + 0.5) * width).cos()).collect();
        let behind: Vec<f64> = cosines.iter().map(|cosine| zone * cosine * cosine).collect();
        let weights: Vec<f64> = cosines.iter().map(|cosine| width * 2.0 * zone.sqrt() * cosine / TAU.sqrt()).collect();
        let scale = 0.5 * self.deformable_halves / zone * self.intensity * self.intensity * (8.0 / PI).sqrt();
        let creep: Vec<f64> = (0..=self.steps).map(|index| material.creep(index as f64 * step)).collect();
        let mut grown = SteppedGrowth { places: vec![0.0], closure_evaluations: 0, kernel_evaluations: 0 };
        for now in 1..=self.steps {
            // J(t_n − t_m) − J(t_n − t_{m+1}), half of it to each end; the present place has J(0) besides.
            let mut shares = vec![0.0; now + 1];
            for (m, pair) in creep.get(..=now).unwrap_or_default().windows(2).enumerate() {
                if let [low, high] = pair {
                    let half = 0.5 * (high - low);
                    // Elapsed m to m + 1 steps ago.
                    shares[now - m] += half;
                    shares[now - m - 1] += half;
                }
            }
            shares[now] += creep.first().copied().unwrap_or(f64::NAN);
            let last = grown.places.last().copied().unwrap_or(0.0);
            let mut trials = 0;
            let mut excess = |place: f64, places: &[f64]| {
                trials += 1;
                let mut work = 0.0;
                for (s, weight) in behind.iter().zip(&weights) {
                    let past: f64 = places.iter().zip(&shares).map(|(then, share)| share * (s - (place - then)).max(0.0).sqrt()).sum();
                    work += weight * (past + shares[now] * s.sqrt());
                }
                scale * work / self.work_of_adhesion - 1.0
            };
            let place = next_place(last, zone, |place| excess(place, &grown.places))?;
            grown.closure_evaluations += trials;
            grown.kernel_evaluations += trials * (self.points * (now + 1)) as u64;
            grown.places.push(place);
        }
        Ok(grown)
    }
}

/// The place at or beyond `last` at which a falling function vanishes; `last` itself where it is not positive there.
fn next_place(last: f64, zone: f64, mut excess: impl FnMut(f64) -> f64) -> Result<f64, Refusal> {
    let failed = || Refusal::NotConverged { what: "a step of growth", detail: "no place was found within one process zone".into() };
    let (mut low, mut high) = (last, last + zone);
    let mut at_low = excess(low);
    if at_low <= 0.0 {
        return Ok(low);
    }
    let mut at_high = excess(high);
    if at_high.is_nan() || at_high > 0.0 {
        return Err(failed());
    }
    for _ in 0..MOST_TRIALS {
        let place = low + (high - low) * at_low / (at_low - at_high);
        let value = excess(place);
        if value.abs() < TOLERANCE || high - low < 1e-13 * zone {
            return Ok(place);
        }
        if value > 0.0 {
            (low, at_low, at_high) = (place, value, 0.5 * at_high);
        } else {
            (high, at_high, at_low) = (place, value, 0.5 * at_low);
        }
    }
    Err(failed())
}
