//! An angle reduced to one turn once, so that every periodic function of it keeps its relative accuracy.
//!
//! ```text
//!            −π ........ 0 ........ π          signed      r ∈ [−π, π], r ≡ x (mod 2π)
//!             |<- to_half_turn  ->|            to_half_turn  π − |r| ≥ 0
//! ```
//! Both members carry full RELATIVE accuracy (3e-16) of the double that was given, also next to a multiple of π: outside [−π, π] they
//! are arc tangents of the sine and cosine, whose argument reduction is exact in every mathematical library in use (Payne and Hanek,
//! *ACM SIGNUM Newsletter* 18 (1983), 19–24). What is lost is
//! what the double does not hold: one ulp of x = 2πn is an error of 1.4e-15·n in r.

use crate::refusal::{Refusal, require_finite};
use std::f64::consts::PI;

/// π minus the double nearest to it.
const PI_REMAINDER: f64 = 1.224_646_799_147_353_2e-16;

/// An angle modulo one turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Angle {
    signed: f64,
    to_half_turn: f64,
}

impl Angle {
    /// Reduces a finite angle (rad).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an infinity or a NaN, which name no point of the circle.
    pub fn new(radians: f64) -> Result<Self, Refusal> {
        let x = require_finite("angle", radians)?;
        if x.abs() <= PI {
            return Ok(Self { signed: x, to_half_turn: (PI - x.abs()) + PI_REMAINDER });
        }
        let (sine, cosine) = x.sin_cos();
        Ok(Self { signed: sine.atan2(cosine), to_half_turn: sine.abs().atan2(-cosine) })
    }

    /// The angle in [−π, π] (rad).
    #[must_use]
    pub const fn signed(self) -> f64 {
        self.signed
    }

    /// The distance π − |angle| to the half turn (rad), not negative.
    #[must_use]
    pub(crate) const fn to_half_turn(self) -> f64 {
        self.to_half_turn
    }

    /// The mirrored angle −x.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        Self { signed: -self.signed, to_half_turn: self.to_half_turn }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn one_ulp_from_the_half_turn_and_from_a_turn() {
        // π − fl(π) and fl(2π) − 2π, whose leading digits are those of PI_REMAINDER.
        assert!((Angle::new(PI).unwrap().to_half_turn() / PI_REMAINDER - 1.0).abs() < 4e-16);
        assert!((Angle::new(2.0 * PI).unwrap().signed() / (-2.0 * PI_REMAINDER) - 1.0).abs() < 4e-16);
        assert!((Angle::new(3.0 * PI).unwrap().to_half_turn() / 3.673_940_397_442_059_4e-16 - 1.0).abs() < 1e-15);
        assert!(Angle::new(f64::NAN).is_err() && Angle::new(f64::INFINITY).is_err());
        assert!(Angle::new(1e300).unwrap().signed().abs() <= PI);
    }
}
