//! How well a model meets a group of data: root mean square, coefficient of determination, runs of the signs.

use spec_math::NormDist;

/// Of a group of data.
#[derive(Debug, Clone, PartialEq)]
pub struct Quality {
    /// Root mean square of m − y.
    pub root_mean_square: f64,
    /// 1 − Σ(m − y)²/Σ(y − ȳ)²; none of data that do not vary.
    pub determination: Option<f64>,
    /// Probability of so few runs of equal sign among independent residuals; none of fewer than ten.
    pub runs: Option<f64>,
}

impl Quality {
    /// Of differences m − y, in order, and the data.
    #[must_use]
    pub fn of(differences: &[f64], data: &[f64]) -> Self {
        let count = data.len().max(1) as f64;
        let sum = differences.iter().map(|difference| difference * difference).sum::<f64>();
        let mean = data.iter().sum::<f64>() / count;
        let spread = data.iter().map(|datum| (datum - mean).powi(2)).sum::<f64>();
        Self {
            root_mean_square: (sum / count).sqrt(),
            determination: (spread > 0.0).then(|| 1.0 - sum / spread),
            runs: runs_test(differences),
        }
    }
}

/// Probability of at most as many runs of equal sign as these residuals have, if they were independent (Wald and Wolfowitz, normal approximation with
/// a correction of half a run); none of fewer than ten, or if all have one sign.
#[must_use]
pub fn runs_test(residuals: &[f64]) -> Option<f64> {
    let signs: Vec<bool> = residuals.iter().filter(|residual| **residual != 0.0).map(|residual| *residual > 0.0).collect();
    let positive = signs.iter().filter(|sign| **sign).count() as f64;
    let negative = signs.len() as f64 - positive;
    if signs.len() < 10 || positive.min(negative) < 1.0 {
        return None;
    }
    let runs = 1.0 + signs.windows(2).filter(|pair| pair.first() != pair.last()).count() as f64;
    let both = 2.0 * positive * negative;
    let all = positive + negative;
    let mean = both / all + 1.0;
    let variance = both * (both - all) / (all * all * (all - 1.0));
    (variance > 0.0).then(|| ((runs + 0.5 - mean) / variance.sqrt()).norm_cdf())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_runs_are_found_improbable_and_many_are_not() {
        let slow: Vec<f64> = (0..60).map(|k| (f64::from(k) * 0.1).sin() + 1e-3).collect();
        let quick: Vec<f64> = (0..60).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert!(runs_test(&slow).is_some_and(|probability| probability < 1e-6));
        assert!(runs_test(&quick).is_some_and(|probability| probability > 0.999));
        assert_eq!(runs_test(&[1.0; 30]), None);
    }

    #[test]
    fn a_model_that_is_the_mean_determines_nothing() {
        let data = [1.0, 2.0, 3.0, 4.0];
        let quality = Quality::of(&data.map(|datum| 2.5 - datum), &data);
        assert!(quality.determination.is_some_and(|part| part.abs() < 1e-15));
        assert!((quality.root_mean_square - 1.25_f64.sqrt()).abs() < 1e-15);
    }
}
