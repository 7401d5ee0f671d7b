//! What a fit found.

use super::intervals::Interval;
use super::quality::Quality;

/// Another minimum that a descent ended in.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherMinimum {
    /// The parameters there.
    pub values: Vec<f64>,
    /// χ² there, of the coarse model, above that of the best minimum.
    pub rise: f64,
}

/// A fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// The parameters.
    pub values: Vec<f64>,
    /// Standard errors of the coordinates: of a logarithm relative ones. Infinite where the data do not fix a parameter.
    pub standard_errors: Vec<f64>,
    /// 95 % by the covariance.
    pub by_covariance: Vec<Interval>,
    /// 95 % by the profile likelihood.
    pub by_profile: Vec<Interval>,
    /// Correlation of each pair.
    pub correlations: Vec<Vec<f64>>,
    /// The worst known direction in coordinates, of length one, and its standard error: a combination of parameters that the data fix worst.
    pub weakest: (Vec<f64>, f64),
    /// The model at the parameters.
    pub model: Vec<f64>,
    /// σ of each group.
    pub sigmas: Vec<f64>,
    /// How well each group is met.
    pub quality: Vec<Quality>,
    /// χ².
    pub misfit: f64,
    /// Data minus parameters.
    pub freedom: f64,
    /// Derivatives of the residuals by the coordinates, a column each.
    pub jacobian: Vec<Vec<f64>>,
    /// Descents that ended in this minimum, and all.
    pub reached_by: (usize, usize),
    /// Where other descents ended.
    pub others: Vec<OtherMinimum>,
    /// Evaluations of the model.
    pub evaluations: usize,
}
