//! How well data fix a curve: from the covariance of the fitted numbers and the distance to the best fit of any length.

use super::normal::Normal;
use super::observation::{Observation, Quantity};
use super::series::Series;
use faer::Mat;

/// Errors of curves that a fitted series gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    series: Series,
    best: Series,
    window: [f64; 2],
    /// Inverse triangular factor of the scaled derivatives, times the scatter: its rows' lengths are standard deviations.
    spread: Option<Mat<f64>>,
}

/// Standard deviations of the stated error: 95 of 100 for a normal error.
const DEVIATIONS: f64 = 2.0;

impl Band {
    pub(super) fn new(series: Series, best: Series, data: &[Observation], window: [f64; 2]) -> Self {
        let jacobian = series.jacobian(data, window);
        let freedom = jacobian.ncols();
        let scatter = (series.misfit(data) / (data.len().saturating_sub(freedom).max(1)) as f64).sqrt();
        Self { spread: spread(&jacobian, scatter), series, best, window }
    }

    /// The stated error of a curve at a frequency or time (Pa or 1/Pa): about 95 of 100 fits to data with this scatter lie within it.
    #[must_use]
    pub fn error(&self, quantity: Quantity, at: f64) -> f64 {
        let place = [Observation { quantity, at, value: 0.0, scale: 1.0 }];
        let gradient = self.series.jacobian(&place, self.window);
        let scatter = self.spread.as_ref().map_or(f64::INFINITY, |spread| {
            let columns = gradient.ncols();
            (0..columns).map(|j| (0..=j).map(|k| gradient[(0, k)] * spread[(k, j)]).sum::<f64>().powi(2)).sum::<f64>().sqrt()
        });
        let [observation] = &place;
        let bias = self.series.value(observation) - self.best.value(observation);
        DEVIATIONS * scatter.hypot(bias)
    }

    /// A series that the data leave possible: the fitted one moved by normal numbers with the covariance of the fit; none where it is unknown.
    pub(super) fn draw(&self, stream: &mut Normal) -> Option<Series> {
        let spread = self.spread.as_ref()?;
        let normal: Vec<f64> = (0..spread.ncols()).map(|_| stream.next()).collect();
        let step: Vec<f64> = (0..spread.nrows()).map(|k| (k..spread.ncols()).map(|j| spread[(k, j)] * normal[j]).sum()).collect();
        Some(self.series.moved(&step, self.window))
    }
}

/// σ·R⁻¹ of J = QR, with a little damping of directions that the data do not fix.
fn spread(jacobian: &Mat<f64>, scatter: f64) -> Option<Mat<f64>> {
    let (rows, columns) = (jacobian.nrows(), jacobian.ncols());
    if columns == 0 {
        return Some(Mat::zeros(0, 0));
    }
    // A number (a logarithm) that the data leave free is granted a factor e.
    let damped = Mat::from_fn(rows + columns, columns, |i, j| {
        if i < rows {
            jacobian[(i, j)]
        } else if i - rows == j {
            scatter.max(f64::MIN_POSITIVE)
        } else {
            0.0
        }
    });
    let factor = damped.qr();
    let triangle = factor.thin_R();
    let mut inverse = Mat::<f64>::zeros(columns, columns);
    for j in 0..columns {
        for i in (0..=j).rev() {
            let unit = if i == j { 1.0 } else { 0.0 };
            let sum: f64 = ((i + 1)..=j).map(|k| triangle[(i, k)] * inverse[(k, j)]).sum();
            inverse[(i, j)] = (unit - sum) / triangle[(i, i)];
        }
    }
    let spread = Mat::from_fn(columns, columns, |i, j| scatter * inverse[(i, j)]);
    (0..columns).all(|j| (0..columns).all(|i| spread[(i, j)].is_finite())).then_some(spread)
}
