//! What is fitted: parameters, data in groups of one noise each, and the model as a closure.

use super::parameter::Parameter;
use std::ops::Range;

/// How carefully the model is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fineness {
    /// To find the region of the minimum.
    Coarse,
    /// So that its error is small beside what the noise leaves of the parameters.
    Fine,
}

/// What is known of the noise of a group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Noise {
    /// Nothing but a guess of its standard deviation: it is estimated from the residuals.
    Guess(f64),
    /// Its standard deviation.
    Known(f64),
}

impl Noise {
    /// The standard deviation to begin with.
    #[must_use]
    pub const fn first(self) -> f64 {
        match self {
            Self::Guess(sigma) | Self::Known(sigma) => sigma,
        }
    }
}

/// Data of one noise.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// What it is called.
    pub name: String,
    /// Its places among the data.
    pub places: Range<usize>,
    /// Its noise.
    pub noise: Noise,
}

/// How a residual counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loss {
    /// Squared.
    Squares,
    /// Squared up to 1.345 standard deviations and by its size beyond: a few outliers change little (Huber; 95 % efficiency for normal noise).
    Huber,
}

/// Where Huber's loss turns from squares to sizes, in standard deviations.
const TURN: f64 = 1.345;

impl Loss {
    /// The number whose square is the loss of a residual in standard deviations.
    #[must_use]
    pub fn root(self, residual: f64) -> f64 {
        let size = residual.abs();
        if self == Self::Squares || size <= TURN { residual } else { (TURN * (2.0 * size - TURN)).sqrt().copysign(residual) }
    }

    /// What the covariance of a fit with this loss is of that by squares of the same noise: ⟨ψ²⟩/⟨ψ′⟩², and what a rise of the loss is of a χ², ⟨ψ²⟩/⟨ψ′⟩.
    pub(super) fn factors(self, residuals: &[f64]) -> [f64; 2] {
        if self == Self::Squares || residuals.is_empty() {
            return [1.0, 1.0];
        }
        let count = residuals.len() as f64;
        let psi = residuals.iter().map(|residual| residual.abs().min(TURN).powi(2)).sum::<f64>() / count;
        let within = residuals.iter().filter(|residual| residual.abs() <= TURN).count().max(1) as f64 / count;
        [psi / (within * within), psi / within]
    }
}

/// The model at parameters: as many numbers as data, or the reason why there are none.
pub type Model<'m> = &'m (dyn Fn(&[f64], Fineness) -> Result<Vec<f64>, String> + Sync);

/// A fit to be made.
#[derive(Clone)]
pub struct Problem<'m> {
    /// What is free.
    pub parameters: Vec<Parameter>,
    /// The data.
    pub data: Vec<f64>,
    /// Which of them have one noise; together all of them.
    pub groups: Vec<Group>,
    /// The model.
    pub model: Model<'m>,
    /// How residuals count.
    pub loss: Loss,
    /// Descents, each from another start.
    pub starts: usize,
}

impl<'m> Problem<'m> {
    /// Least squares by one descent. Other fits by struct update of it.
    #[must_use]
    pub const fn squares(parameters: Vec<Parameter>, data: Vec<f64>, groups: Vec<Group>, model: Model<'m>) -> Self {
        Self { parameters, data, groups, model, loss: Loss::Squares, starts: 1 }
    }

    /// Values at coordinates.
    pub(super) fn values(&self, coordinates: &[f64]) -> Vec<f64> {
        self.parameters.iter().zip(coordinates).map(|(parameter, &coordinate)| parameter.value(coordinate)).collect()
    }

    /// The group of each datum, by its number.
    pub(super) fn group_of(&self) -> Vec<usize> {
        let mut of = vec![0; self.data.len()];
        for (number, group) in self.groups.iter().enumerate() {
            for place in of.get_mut(group.places.clone()).into_iter().flatten() {
                *place = number;
            }
        }
        of
    }
}

#[cfg(test)]
mod tests {
    use super::Loss;

    #[test]
    fn hubers_loss_is_smooth_and_normal_noise_costs_it_little() {
        let loss = |residual: f64| Loss::Huber.root(residual).powi(2);
        assert!((loss(1.344_999) - loss(1.345_001)).abs() < 1e-5);
        assert!((loss(-9.0) - 1.345 * (18.0 - 1.345)).abs() < 1e-12);
        // Normal quantiles: 95 % efficiency (Huber).
        let normal: Vec<f64> = (0..2000).map(|k| spec_math::NormDist::norm_cdf_inv(&((f64::from(k) + 0.5) / 2000.0))).collect();
        let [covariance, _] = Loss::Huber.factors(&normal);
        assert!((covariance - 1.0 / 0.95).abs() < 2e-3, "{covariance}");
    }
}
