//! What a time along a drive does to all points alike.

use super::chain::Chain;
use super::drive::{Drive, Gain, decayed};

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
    /// The drive that it is of, and what slow and fast terms gain along it; none of other terms.
    pub(super) of: Option<Drive>,
    pub(super) series: Vec<Option<Gain>>,
    /// Their sums by what they weigh in S and in what S loses a second.
    pub(super) sums: [Gain; 2],
}

impl Default for Moment {
    fn default() -> Self {
        let [kept, gained, recovered] = [const { Vec::new() }; 3];
        Self { time: 0.0, depth: 0.0, rate: 0.0, kept, gained, recovered, of: None, series: Vec::new(), sums: [Gain::NONE; 2] }
    }
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
        self.recovered.extend(chain.voigt.iter().map(|&(rate, _)| decayed(rate * x)));
    }

    /// What is the same at all times of a drive.
    pub(super) fn prepare(&mut self, chain: &Chain, drive: &Drive) {
        if self.of.as_ref() == Some(drive) {
            return;
        }
        self.of = Some(*drive);
        self.series.clear();
        self.series.extend(chain.maxwell.iter().map(|&(_, rho)| drive.series(rho)));
        self.sums = [Gain::NONE; 2];
        for (&(modulus, rho), series) in chain.maxwell.iter().zip(&self.series) {
            let Some(series) = series else { continue };
            let share = modulus / chain.glassy;
            for (sum, weight) in self.sums.iter_mut().zip([share, share / rho]) {
                sum.add(weight, series);
            }
        }
    }

    /// S of a chain in contact with u_i at the start, and its rate, along the drive it is prepared for.
    pub(super) fn pressing(&self, chain: &Chain, drive: &Drive, height: f64, state: &[f64], x: f64) -> (f64, f64) {
        let y = x / drive.duration;
        let [gained, losing] = self.sums.each_ref().map(|sum| sum.steady(y));
        let mut value = chain.relaxed / chain.glassy * (drive.value(x) - height) + gained;
        let mut slope = drive.rate(x) - losing;
        for ((&(modulus, rho), u), series) in chain.maxwell.iter().zip(state).zip(&self.series) {
            let kept = decayed(x / rho);
            let own = match series {
                Some(series) => (u - series.lag()) * kept,
                None => u * kept + drive.gained(rho, x, kept),
            };
            let share = modulus / chain.glassy * own;
            value += share;
            slope -= share / rho;
        }
        (value, slope)
    }

    /// For points that are in contact until then.
    pub(super) fn set(&mut self, chain: &Chain, drive: &Drive, x: f64) {
        self.prepare(chain, drive);
        self.set_at(chain, drive, x);
    }

    /// The same along the drive it is prepared for.
    pub(super) fn set_at(&mut self, chain: &Chain, drive: &Drive, x: f64) {
        (self.time, self.depth, self.rate) = (x, drive.value(x), drive.rate(x));
        self.kept.clear();
        self.gained.clear();
        let y = x / drive.duration;
        for (&(_, rho), series) in chain.maxwell.iter().zip(&self.series) {
            let kept = decayed(x / rho);
            self.kept.push(kept);
            self.gained.push(match series {
                Some(series) => series.steady(y) - series.lag() * kept,
                None => drive.gained(rho, x, kept),
            });
        }
    }

    /// What u_i, of a chain in contact from another time of the drive on, has become at this moment of it.
    pub(super) fn held(&self, chain: &Chain, drive: &Drive, since: f64, state: &mut [f64]) {
        let (part, time) = (since / drive.duration, self.time - since);
        let whole = self.series.iter().zip(self.kept.iter().zip(&self.gained));
        for ((u, &(_, rho)), (series, (whole_kept, whole))) in state.iter_mut().zip(&chain.maxwell).zip(whole) {
            let kept = decayed(time / rho);
            let before = match series {
                Some(series) => series.steady(part) * kept - series.lag() * whole_kept,
                None => drive.gained(rho, since, decayed(since / rho)) * kept,
            };
            *u = *u * kept + (whole - before);
        }
    }
}
