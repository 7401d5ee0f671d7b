//! Levenberg and Marquardt's descent of a sum of squares.

use super::least_squares::{self, matrix, product};
use faer::Mat;

/// Numbers whose residuals are to be made small.
pub trait Descent: Sized {
    /// The residuals.
    fn residuals(&self) -> Vec<f64>;
    /// A part of the sum of squares that no step changes.
    fn rest(&self) -> f64;
    /// Derivatives of the residuals by the numbers, a column each.
    fn jacobian(&self) -> Vec<Vec<f64>>;
    /// A fall of the sum below which a step is not tried; none tries every step.
    fn least_gain(&self) -> Option<f64> {
        None
    }
    /// The damping of the step after one that led up, at least: far below one it would be the same step.
    fn least_damping_after_refusal(&self) -> f64 {
        0.0
    }
    /// The same after a step.
    fn moved(&self, step: &[f64]) -> Self;
}

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|residual| residual * residual).sum()
}

/// The descent from here; at most so many steps.
pub fn descended<M: Descent>(mut model: M, steps: usize) -> M {
    let mut residuals = model.residuals();
    let mut misfit = squares(&residuals);
    let mut damping = 1e-3;
    for _ in 0..steps {
        let jacobian = model.jacobian();
        let (rows, columns) = (residuals.len(), jacobian.len());
        if columns == 0 {
            break;
        }
        let lengths: Vec<f64> = jacobian.iter().map(|column| product(column, column).sqrt()).collect();
        // [J | r] → R once a step; every damping is then tried on the small triangle.
        let whole =
            matrix(jacobian.iter().map(Vec::as_slice).chain(std::iter::once(residuals.as_slice())).collect::<Vec<_>>().into_iter(), rows);
        let factor = whole.qr();
        let triangle = factor.thin_R();
        let small = triangle.nrows();
        let mut better = None;
        let mut at_the_end = false;
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
            // What the linear picture promises; a step that is damped more promises less.
            let promised: f64 = (0..small)
                .map(|i| {
                    let along: f64 = step.iter().enumerate().skip(i).map(|(j, step)| triangle[(i, j)] * step).sum();
                    let before = triangle[(i, columns)];
                    before * before - (before + along) * (before + along)
                })
                .sum();
            if model.least_gain().is_some_and(|least| promised < least) {
                at_the_end = true;
                break;
            }
            let trial = model.moved(&step);
            let new = trial.residuals();
            let reached = squares(&new);
            if reached < misfit {
                better = Some((trial, new, reached));
                damping = (damping * 0.1).max(1e-12);
                break;
            }
            damping = (damping * 10.0).max(model.least_damping_after_refusal());
            if damping > 1e6 {
                break;
            }
        }
        let Some((trial, new, reached)) = better.filter(|_| !at_the_end) else { break };
        let gained = (misfit - reached) / (misfit + model.rest());
        (model, residuals, misfit) = (trial, new, reached);
        // A descent this slow is at its end, or in a valley that leads nowhere.
        if gained < 1e-6 {
            break;
        }
    }
    model
}
