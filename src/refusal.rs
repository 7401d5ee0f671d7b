//! Why a number is not given: one typed refusal for the whole physics.
//!
//! Nothing in the solver panics on an argument, and no NaN leaves it: an argument outside the range where an equation means
//! something, a state that does not exist, a limit that is infinite, each comes back as a [`Refusal`] that says so in a sentence.

use thiserror::Error;

/// The reason for which a quantity is not computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Refusal {
    /// An argument lies outside the range in which the equation has a meaning.
    #[error("{quantity} = {value:e} is not allowed here: it must be {allowed}")]
    OutOfRange {
        /// The name of the argument, as in the public signature.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// What would have been allowed, in words.
        allowed: &'static str,
    },
    /// The equations are fine and have no admissible solution for what was asked; `limit` is the witness.
    #[error("no such state exists: {reason} ({limit_name} = {limit:e})")]
    NoSuchState {
        /// A full sentence without its full stop.
        reason: String,
        /// The name of the limit that was passed.
        limit_name: &'static str,
        /// The value of that limit, in the units of the call.
        limit: f64,
    },
    /// The quantity does not exist for this material or model, whatever the arguments.
    #[error("{quantity} does not exist: {reason}")]
    Undefined {
        /// The quantity that was asked for.
        quantity: &'static str,
        /// A full sentence without its full stop.
        reason: String,
    },
    /// An iteration ended without reaching its tolerance: nothing is returned rather than something unchecked.
    #[error("{what} did not converge: {detail}")]
    NotConverged {
        /// The iteration.
        what: &'static str,
        /// What was reached.
        detail: String,
    },
}

impl Refusal {
    /// A refused argument.
    #[must_use]
    pub fn out_of_range(quantity: &'static str, value: f64, allowed: &'static str) -> Self {
        Self::OutOfRange { quantity, value, allowed }
    }
}

/// Passes a finite, strictly positive number on.
///
/// # Errors
/// [`Refusal::OutOfRange`] for zero, a negative number, an infinity or a NaN.
pub fn require_positive(quantity: &'static str, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Refusal::out_of_range(quantity, value, "finite and greater than zero")) }
}

/// Passes a finite number that is zero or more on.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative number, an infinity or a NaN.
pub fn require_non_negative(quantity: &'static str, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err(Refusal::out_of_range(quantity, value, "finite and zero or more")) }
}

/// Passes a finite number on.
///
/// # Errors
/// [`Refusal::OutOfRange`] for an infinity or a NaN.
pub fn require_finite(quantity: &'static str, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() { Ok(value) } else { Err(Refusal::out_of_range(quantity, value, "finite")) }
}

/// Passes a Poisson ratio on.
///
/// # Errors
/// [`Refusal::OutOfRange`] outside −1 < ν ≤ 0.5 (the bounds of an isotropic elastic solid).
pub(crate) fn require_poisson_ratio(value: f64) -> Result<f64, Refusal> {
    if value > -1.0 && value <= 0.5 {
        Ok(value)
    } else {
        Err(Refusal::out_of_range("poisson_ratio", value, "greater than -1 and at most 0.5"))
    }
}
