//! Fits of a model to measured curves: numbers and closures only.
//!
//! # Notation
//! | symbol | name |
//! |---|---|
//! | θ | free parameters, each between two bounds; inside the fit as ln θ, or as θ over its range where it may be zero or negative |
//! | y, m(θ) | data, and the model at the same places |
//! | σ_g | standard deviation of the noise of a group of data; estimated from the residuals unless it is known |
//! | r | residuals (m − y)/σ_g, of a robust fit with Huber's loss |
//! | χ² | Σr² |
//!
//! # How
//! ```text
//! coarse model at many starts ──► Levenberg–Marquardt from the best few ──► fine model from the best ──► σ_g from its residuals, and again
//!      └─► covariance from the Jacobian; profile likelihood: χ² minimised over all other parameters rises by t² at the ends of the interval
//! ```
//! Jacobians are differences whose steps are a few standard errors, in parallel. A profile that finds a lower χ² than the minimum starts the fit anew there.
//!
//! Sources: Levenberg, Quart. Appl. Math. 2 (1944) 164; Marquardt, J. SIAM 11 (1963) 431; Huber, *Robust Statistics* (1981), chapter 7; Venzon and
//! Moolgavkar, Appl. Stat. 37 (1988) 87 (profiles); Wald and Wolfowitz, Ann. Math. Stat. 11 (1940) 147 (runs).

mod at;
mod covariance;
mod criteria;
mod descent;
mod fitted;
mod intervals;
pub(crate) mod least_squares;
mod parameter;
mod problem;
mod profile;
mod quality;
mod search;
mod student;

pub use descent::{Descent, descended};

pub use criteria::akaike;
pub use fitted::{Fitted, OtherMinimum};
pub use intervals::{End, Interval};
pub use parameter::Parameter;
pub use problem::{Fineness, Group, Loss, Model, Noise, Problem};
pub use quality::{Quality, runs_test};
pub use search::fit;
pub use student::two_sided;

/// The step of the coordinates that makes linear residuals, columns times step, nearest to others.
#[must_use]
pub fn linear_step(jacobian: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    least_squares::free(&least_squares::matrix(jacobian.iter().map(Vec::as_slice), right.len()), right)
}

/// Standard errors of the coordinates by the Jacobian of residuals of unit noise; infinite where the data do not fix one.
#[must_use]
pub fn standard_errors(jacobian: &[Vec<f64>]) -> Vec<f64> {
    let covariance = covariance::Covariance::of(jacobian, 1.0);
    (0..jacobian.len()).map(|place| covariance.standard_error(place)).collect()
}
