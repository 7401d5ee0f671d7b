//! The published rows, and the spectrum of their material as creep terms.

use crate::studies::reference::{Row, rows};
use spec_math::Gamma;
use viscotack::finite_range::law::Law;
use viscotack::finite_range::sphere::{Control, Creep, Leg, Motion, Problem, Start};

const KEPT: &str = include_str!("../../../../reference_data/published_spheres.csv");
/// The public table, if it is there.
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data/ml4adh_comb_1to9.csv");
/// Retardation times in ln τ lie so far from each other; from this part of the shortest time of the test to the end of the spectrum.
const SPACING: f64 = 0.6;
const SHORTEST: f64 = 1e-3;
const LONGEST: f64 = 20.0;
/// Terms of less weight are left out.
const LEAST_WEIGHT: f64 = 1e-12;

/// A row: one run that was published.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Published {
    /// Rate of unloading, in ranges over the time of the spectrum.
    pub rate: f64,
    /// Relaxed penetration before it, in ranges.
    pub preload: f64,
    /// Relaxed Tabor number.
    pub tabor: f64,
    /// E0/E∞.
    pub modulus_ratio: f64,
    /// n of the spectrum τ^{n−1}e^{−τ} of retardation times.
    pub exponent: f64,
    /// Largest tension over 1.5πRΔγ.
    pub ratio: f64,
    /// The same by an independent prototype of our equations, if it was run.
    pub prototype: Option<f64>,
}

impl Published {
    fn of(row: &Row, names: [&str; 6]) -> Option<Self> {
        let [rate, preload, tabor, modulus_ratio, exponent, ratio] = names.map(|name| row.number(name));
        let prototype = Some(row.number("prototype_ratio")).filter(|value| value.is_finite());
        let sound = [preload, tabor, modulus_ratio, exponent, ratio].iter().all(|value| value.is_finite() && *value > 0.0);
        (sound && rate.is_finite() && rate != 0.0).then(|| Self {
            rate: rate.abs(),
            preload,
            tabor,
            modulus_ratio,
            exponent,
            ratio,
            prototype,
        })
    }

    /// What was asked, by which repeated rows are recognised.
    #[must_use]
    pub fn state(&self) -> [i64; 5] {
        [self.rate, self.preload, self.tabor, self.modulus_ratio, self.exponent].map(|value| (value.ln() * 1e6).round() as i64)
    }

    /// The run, to a penetration at which the tension has fallen.
    #[must_use]
    pub fn problem(&self, to: f64) -> Problem {
        let motion = Motion::Ramp { to, duration: (self.preload - to) / self.rate };
        let leg = Leg { control: Control::Penetration, motion };
        Problem::new(Law::LennardJones, self.tabor, self.creep(), Start::Relaxed(self.preload), vec![leg])
    }

    /// The spectrum by the trapezoidal rule in ln τ; what lies below its first node is one term, the others are scaled to the rest.
    #[must_use]
    pub fn creep(&self) -> Creep {
        let least = (SHORTEST / self.rate).ln();
        let count = ((LONGEST.ln() - least) / SPACING).ceil().max(1.0) as usize + 1;
        let mut terms: Vec<(f64, f64)> = (0..count)
            .map(|k| {
                let ln_time = least + SPACING * k as f64;
                (ln_time.exp(), (self.exponent * ln_time - ln_time.exp()).exp())
            })
            .collect();
        let below = self.exponent.igamma((least - 0.5 * SPACING).exp());
        let sum: f64 = terms.iter().map(|term| term.1).sum();
        terms.iter_mut().for_each(|term| term.1 *= (1.0 - below) / sum);
        terms.insert(0, ((least - SPACING).exp(), below));
        terms.retain(|term| term.1 > LEAST_WEIGHT);
        let sum: f64 = terms.iter().map(|term| term.1).sum();
        Creep {
            stiffening: 1.0 / self.modulus_ratio,
            fractions: terms.iter().map(|term| term.1 / sum).collect(),
            times: terms.iter().map(|term| term.0).collect(),
        }
    }
}

/// The rows that the repository keeps.
#[must_use]
pub fn kept() -> Vec<Published> {
    let names = ["rate", "preload", "tabor", "modulus_ratio", "exponent", "published_ratio"];
    rows(KEPT).iter().filter_map(|row| Published::of(row, names)).collect()
}

/// The whole public table, if it is there.
#[must_use]
pub fn table() -> Option<Vec<Published>> {
    let text = std::fs::read_to_string(TABLE).ok()?;
    let names = ["runload", "alphaload", "mu", "k", "n", "outputAmplification"];
    Some(rows(&text).iter().filter_map(|row| Published::of(row, names)).collect())
}
