//! A series while it is being fitted, and the refinement of its strengths and times together.

use super::least_squares;
use super::observation::Observation;
use faer::Mat;

/// c + Σ s_k·kernel(x_k): strengths and times, sorted from the shortest time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    pub(super) constant: f64,
    /// (strength, time).
    pub(super) terms: Vec<(f64, f64)>,
}

impl Series {
    pub(super) fn value(&self, observation: &Observation) -> f64 {
        let terms: f64 =
            self.terms.iter().map(|&(strength, time)| strength * observation.quantity.kernel(observation.argument(time)).0).sum();
        self.constant * observation.quantity.constant() + terms
    }

    pub(super) fn residuals(&self, data: &[Observation]) -> Vec<f64> {
        data.iter().map(|observation| (self.value(observation) - observation.value) / observation.scale).collect()
    }

    /// Half the sum of squares is what a fit makes small; this is the whole sum.
    pub(super) fn misfit(&self, data: &[Observation]) -> f64 {
        self.residuals(data).iter().map(|residual| residual * residual).sum()
    }

    /// The best strengths for the given times; terms without strength are dropped.
    pub(super) fn at_times(times: &[f64], data: &[Observation]) -> Self {
        let matrix = Mat::from_fn(data.len(), times.len() + 1, |i, j| {
            let observation = &data[i];
            let entry =
                if j == 0 { observation.quantity.constant() } else { observation.quantity.kernel(observation.argument(times[j - 1])).0 };
            entry / observation.scale
        });
        let right: Vec<f64> = data.iter().map(|observation| observation.value / observation.scale).collect();
        let strengths = least_squares::non_negative(&matrix, &right);
        let (constant, terms) = strengths.split_first().map_or((0.0, &[][..]), |(first, rest)| (*first, rest));
        let mut terms: Vec<(f64, f64)> = terms.iter().copied().zip(times.iter().copied()).filter(|&(strength, _)| strength > 0.0).collect();
        terms.sort_by(|left, right| left.1.total_cmp(&right.1));
        Self { constant, terms }
    }

    /// Number of free numbers.
    pub(super) fn freedom(&self) -> usize {
        2 * self.terms.len() + usize::from(self.constant > 0.0)
    }

    /// Derivatives of the residuals by ln c (if c > 0), then by ln s_k and ln ρ_k of each term; frozen times have zero columns.
    pub(super) fn jacobian(&self, data: &[Observation], window: [f64; 2]) -> Mat<f64> {
        let own = usize::from(self.constant > 0.0);
        Mat::from_fn(data.len(), self.freedom(), |i, j| {
            let observation = &data[i];
            let Some(place) = j.checked_sub(own) else {
                return self.constant * observation.quantity.constant() / observation.scale;
            };
            let (strength, time) = self.terms[place / 2];
            let (value, slope) = observation.quantity.kernel(observation.argument(time));
            let derivative = if place % 2 == 0 {
                value
            } else if time <= window[0] || time >= window[1] {
                0.0
            } else {
                slope
            };
            strength * derivative / observation.scale
        })
    }

    /// The series after a step in the logarithms, times kept in the window.
    pub(super) fn moved(&self, step: &[f64], window: [f64; 2]) -> Self {
        // No step changes a number by more than e³: the linear picture ends long before.
        let factor = |value: f64| value.clamp(-3.0, 3.0).exp();
        let own = usize::from(self.constant > 0.0);
        let constant = if own == 1 { self.constant * factor(step[0]) } else { 0.0 };
        let terms = self
            .terms
            .iter()
            .enumerate()
            .map(|(k, &(strength, time))| {
                let place = own + 2 * k;
                (strength * factor(step[place]), (time * factor(step[place + 1])).clamp(window[0], window[1]))
            })
            .collect();
        Self { constant, terms }
    }

    /// Levenberg and Marquardt's descent from here; at most so many steps.
    pub(super) fn refined(mut self, data: &[Observation], window: [f64; 2], steps: usize) -> Self {
        let mut misfit = self.misfit(data);
        let mut damping = 1e-3;
        for _ in 0..steps {
            let jacobian = self.jacobian(data, window);
            let (rows, columns) = (jacobian.nrows(), jacobian.ncols());
            if columns == 0 {
                break;
            }
            let residuals = self.residuals(data);
            let lengths: Vec<f64> = (0..columns).map(|j| (0..rows).map(|i| jacobian[(i, j)].powi(2)).sum::<f64>().sqrt()).collect();
            // [J | r] → R once a step; every damping is then tried on the small triangle.
            let whole = Mat::from_fn(rows, columns + 1, |i, j| if j == columns { residuals[i] } else { jacobian[(i, j)] });
            let factor = whole.qr();
            let triangle = factor.thin_R();
            let small = triangle.nrows();
            let mut better = None;
            for _ in 0..12 {
                let damped = Mat::from_fn(small + columns, columns, |i, j| {
                    if i < small {
                        triangle[(i, j)]
                    } else if i - small == j {
                        // A frozen number has no length: it is held by its own damping.
                        if lengths[j] > 0.0 { damping * lengths[j] } else { 1.0 }
                    } else {
                        0.0
                    }
                });
                let right: Vec<f64> = (0..small + columns).map(|i| if i < small { -triangle[(i, columns)] } else { 0.0 }).collect();
                let Some(step) = least_squares::damped(&damped, &right) else { break };
                let trial = self.moved(&step, window);
                let reached = trial.misfit(data);
                if reached < misfit {
                    better = Some((trial, reached));
                    damping = (damping * 0.1).max(1e-12);
                    break;
                }
                damping *= 10.0;
                if damping > 1e6 {
                    break;
                }
            }
            let Some((trial, reached)) = better else { break };
            let gained = (misfit - reached) / misfit;
            self = trial;
            misfit = reached;
            // A descent this slow is at its end, or in a valley that leads nowhere.
            if gained < 1e-6 {
                break;
            }
        }
        self.terms.sort_by(|left, right| left.1.total_cmp(&right.1));
        self
    }
}
