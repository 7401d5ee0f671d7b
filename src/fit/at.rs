//! A point of a fit on its way: coordinates, weighted residuals, differences.

use super::descent::Descent;
use super::problem::{Fineness, Problem};
use rayon::prelude::*;

/// A problem with the standard deviations that hold for now.
#[derive(Clone)]
pub(super) struct Weighted<'p> {
    pub(super) problem: &'p Problem<'p>,
    /// σ of each group.
    pub(super) sigmas: Vec<f64>,
    /// Group of each datum.
    pub(super) group_of: Vec<usize>,
    pub(super) fineness: Fineness,
    /// Steps of the differences, in coordinates.
    pub(super) steps: Vec<f64>,
}

impl<'p> Weighted<'p> {
    pub(super) fn new(problem: &'p Problem<'p>, fineness: Fineness) -> Self {
        Self {
            problem,
            sigmas: problem.groups.iter().map(|group| group.noise.first()).collect(),
            group_of: problem.group_of(),
            fineness,
            steps: vec![FIRST_STEP; problem.parameters.len()],
        }
    }

    /// m − y at coordinates; the reason where the model has none.
    pub(super) fn differences(&self, coordinates: &[f64]) -> Result<Vec<f64>, String> {
        let values = self.problem.values(coordinates);
        let model = (self.problem.model)(&values, self.fineness)?;
        if model.len() != self.problem.data.len() || model.iter().any(|value| !value.is_finite()) {
            return Err("the model gives no finite number for every datum".to_owned());
        }
        Ok(model.iter().zip(&self.problem.data).map(|(model, datum)| model - datum).collect())
    }

    /// Differences over their standard deviations.
    pub(super) fn scaled(&self, differences: &[f64]) -> Vec<f64> {
        let sigma = |group: &usize| self.sigmas.get(*group).copied().unwrap_or(1.0);
        differences.iter().zip(&self.group_of).map(|(difference, group)| difference / sigma(group)).collect()
    }

    /// The residuals whose squares are summed; infinite where there is no model.
    pub(super) fn residuals(&self, coordinates: &[f64]) -> Vec<f64> {
        match self.differences(coordinates) {
            Ok(differences) => self.scaled(&differences).into_iter().map(|residual| self.problem.loss.root(residual)).collect(),
            Err(_) => vec![f64::INFINITY; self.problem.data.len()],
        }
    }

    /// Σr².
    pub(super) fn misfit(&self, coordinates: &[f64]) -> f64 {
        squares(&self.residuals(coordinates))
    }

    /// Derivatives of the residuals, a column each; `central` takes both sides.
    pub(super) fn jacobian(&self, coordinates: &[f64], residuals: &[f64], central: bool) -> Vec<Vec<f64>> {
        let column = |place: usize| {
            let step = self.steps.get(place).copied().unwrap_or(FIRST_STEP);
            let [low, high] = self.problem.parameters.get(place).map_or([0.0, 0.0], super::Parameter::ends);
            let at = coordinates.get(place).copied().unwrap_or(0.0);
            let moved = |to: f64| {
                let mut there = coordinates.to_vec();
                if let Some(coordinate) = there.get_mut(place) {
                    *coordinate = to;
                }
                let found = self.residuals(&there);
                found.iter().all(|residual| residual.is_finite()).then_some((to, found))
            };
            let difference = |(to, one): &(f64, Vec<f64>), (from, other): (f64, &[f64])| -> Vec<f64> {
                one.iter().zip(other).map(|(one, other)| (one - other) / (to - from)).collect()
            };
            let up = if at + step <= high { moved(at + step) } else { None };
            let down = if (central || up.is_none()) && at - step >= low { moved(at - step) } else { None };
            match (up, down) {
                (Some(up), Some((from, other))) => difference(&up, (from, &other)),
                (Some(one), None) | (None, Some(one)) => difference(&one, (at, residuals)),
                (None, None) => vec![0.0; residuals.len()],
            }
        };
        (0..coordinates.len()).into_par_iter().map(column).collect()
    }
}

/// Step of the first differences: of a logarithm 1 %.
pub(super) const FIRST_STEP: f64 = 0.01;

pub(super) fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|residual| residual * residual).sum()
}

/// Coordinates on their way down.
pub(super) struct At<'w> {
    weighted: &'w Weighted<'w>,
    pub(super) coordinates: Vec<f64>,
    residuals: Vec<f64>,
}

impl<'w> At<'w> {
    pub(super) fn new(weighted: &'w Weighted<'w>, coordinates: Vec<f64>) -> Self {
        let residuals = weighted.residuals(&coordinates);
        Self { weighted, coordinates, residuals }
    }

    pub(super) fn misfit(&self) -> f64 {
        squares(&self.residuals)
    }
}

/// Fall of χ² that is worth a step: a thousandth moves no parameter by more than a thirtieth of its standard error.
const LEAST: f64 = 1e-3;
/// The same where descents only find out in which minimum they end, and as part of χ².
const LEAST_COARSE: [f64; 2] = [0.1, 2e-3];
/// Damping that shortens a step noticeably.
const NOTICEABLE: f64 = 0.01;
/// No step moves a logarithm by more: the linear picture ends long before.
const FARTHEST: f64 = 2.0;

impl Descent for At<'_> {
    fn residuals(&self) -> Vec<f64> {
        self.residuals.clone()
    }

    fn rest(&self) -> f64 {
        0.0
    }

    fn least_gain(&self) -> Option<f64> {
        let [least, part] = if self.weighted.fineness == Fineness::Coarse { LEAST_COARSE } else { [LEAST, 1e-6] };
        Some(least.max(part * squares(&self.residuals)))
    }

    fn least_damping_after_refusal(&self) -> f64 {
        NOTICEABLE
    }

    fn jacobian(&self) -> Vec<Vec<f64>> {
        let mut columns = self.weighted.jacobian(&self.coordinates, &self.residuals, false);
        // At a bound that the step would cross, the parameter stays.
        for ((column, parameter), at) in columns.iter_mut().zip(&self.weighted.problem.parameters).zip(&self.coordinates) {
            let slope = super::least_squares::product(column, &self.residuals);
            let [low, high] = parameter.ends();
            if (*at <= low && slope > 0.0) || (*at >= high && slope < 0.0) {
                column.fill(0.0);
            }
        }
        columns
    }

    fn moved(&self, step: &[f64]) -> Self {
        let parameters = &self.weighted.problem.parameters;
        let coordinates = self.coordinates.iter().zip(step).zip(parameters).map(|((at, step), parameter)| {
            let [low, high] = parameter.ends();
            let farthest = FARTHEST.min(high - low);
            (at + step.clamp(-farthest, farthest)).clamp(low, high)
        });
        Self::new(self.weighted, coordinates.collect())
    }
}
