//! What a time along a drive does to all points alike.

use super::chain::Chain;
use super::drive::{Drive, LONGEST_SERIES, Series};

/// Everything that a time since the start of a drive does, to all points alike.
#[derive(Debug, Clone)]
pub(super) struct Moment {
    pub(super) time: f64,
    /// Δ and Δ̇.
    pub(super) depth: f64,
    pub(super) rate: f64,
    /// e^{−x/ρ_i} and what u_i gains.
    pub(super) kept: Vec<f64>,
    pub(super) gained: Vec<f64>,
    /// e^{−x/τ_j}.
    pub(super) recovered: Vec<f64>,
    /// The drive that it is of, and what slow terms gain along it as powers of the time; none of other terms.
    pub(super) of: Option<Drive>,
    pub(super) series: Vec<Option<Series>>,
    /// Their sums by what they weigh in S and in what S loses a second.
    pub(super) sums: [Series; 2],
}

impl Default for Moment {
    fn default() -> Self {
        let [kept, gained, recovered] = [const { Vec::new() }; 3];
        Self {
            time: 0.0,
            depth: 0.0,
            rate: 0.0,
            kept,
            gained,
            recovered,
            of: None,
            series: Vec::new(),
            sums: [([0.0; LONGEST_SERIES], 0); 2],
        }
    }
}

fn of_series((powers, used): &Series, y: f64) -> f64 {
    powers.iter().take(*used).rev().fold(0.0, |sum, power| (sum + power) * y)
}

impl Moment {
    pub(super) fn new(chain: &Chain, drive: &Drive, x: f64) -> Self {
        let mut moment = Self::default();
        moment.set(chain, drive, x);
        moment.set_free(chain, drive, x);
        moment
    }

    /// For points that are free until then.
    pub(super) fn set_free(&mut self, chain: &Chain, drive: &Drive, x: f64) {
        (self.time, self.depth, self.rate) = (x, drive.value(x), drive.rate(x));
        self.recovered.clear();
        self.recovered.extend(chain.voigt.iter().map(|&(rate, _)| (-rate * x).exp()));
    }

    /// What is the same at all times of a drive.
    fn prepare(&mut self, chain: &Chain, drive: &Drive) {
        if self.of.as_ref() == Some(drive) {
            return;
        }
        self.of = Some(*drive);
        self.series.clear();
        self.series.extend(chain.maxwell.iter().map(|&(_, rho)| drive.series(rho)));
        self.sums = [([0.0; LONGEST_SERIES], 0); 2];
        for (&(modulus, rho), series) in chain.maxwell.iter().zip(&self.series) {
            let Some((powers, used)) = series else { continue };
            let share = modulus / chain.glassy;
            for ((sum, longest), weight) in self.sums.iter_mut().zip([share, share / rho]) {
                *longest = (*longest).max(*used);
                for (sum, power) in sum.iter_mut().zip(powers).take(*used) {
                    *sum += weight * power;
                }
            }
        }
    }

    /// S of a chain in contact with u_i at the start, and its rate.
    pub(super) fn pressing(&mut self, chain: &Chain, drive: &Drive, height: f64, state: &[f64], x: f64) -> (f64, f64) {
        self.prepare(chain, drive);
        let y = x / drive.duration;
        let [gained, losing] = self.sums.map(|series| of_series(&series, y));
        let mut value = chain.relaxed / chain.glassy * (drive.value(x) - height) + gained;
        let mut slope = drive.rate(x) - losing;
        for ((&(modulus, rho), u), series) in chain.maxwell.iter().zip(state).zip(&self.series) {
            let kept = (-x / rho).exp();
            let own = if series.is_some() { 0.0 } else { drive.gained(rho, x, kept) };
            let share = modulus / chain.glassy * (u * kept + own);
            value += share;
            slope -= share / rho;
        }
        (value, slope)
    }

    /// For points that are in contact until then.
    pub(super) fn set(&mut self, chain: &Chain, drive: &Drive, x: f64) {
        (self.time, self.depth, self.rate) = (x, drive.value(x), drive.rate(x));
        self.prepare(chain, drive);
        self.kept.clear();
        self.gained.clear();
        let y = x / drive.duration;
        for (&(_, rho), series) in chain.maxwell.iter().zip(&self.series) {
            let kept = (-x / rho).exp();
            self.kept.push(kept);
            self.gained.push(match series {
                Some(series) => of_series(series, y),
                None => drive.gained(rho, x, kept),
            });
        }
    }
}
