//! What is asked of a steady sliding contact, in reduced units.

use crate::closure::work_by_speed::WorkBySpeed;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use crate::sliding::contact::Indenter;
use crate::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use std::f64::consts::PI;

/// A steady sliding contact: everything but the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingProblem<'a> {
    /// kv (1/s), zero or more; at zero the solid is relaxed.
    pub rate: f64,
    /// The indenter.
    pub indenter: Indenter,
    /// Adhesion at that rate; none for the adhesiveless contact.
    pub adhesion: Option<WaveAdhesion>,
    /// How the works of adhesion follow the rate kv (1/s), if they do.
    pub work_by_speed: Option<&'a WorkBySpeed>,
    /// What is prescribed.
    pub control: SlidingControl,
    /// Wanted |error| ≤ accuracy·max(|value|, scale) of every output, scale one in reduced units.
    pub accuracy: f64,
}

impl SlidingProblem<'_> {
    /// A wave with works of adhesion that do not follow the speed: kv (1/s), adhesion, what is prescribed, accuracy. Other problems by struct update of it.
    #[must_use]
    pub const fn wave(rate: f64, adhesion: Option<WaveAdhesion>, control: SlidingControl, accuracy: f64) -> Self {
        Self { rate, indenter: Indenter::Wave, adhesion, work_by_speed: None, control, accuracy }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] or, for a penetration of a parabola, [`Refusal::Undefined`].
    pub fn checked(&self) -> Result<(), Refusal> {
        require_non_negative("rate", self.rate)?;
        require_positive("accuracy", self.accuracy)?;
        match self.control {
            SlidingControl::MeanPressure(pressure) => require_finite("mean_pressure", pressure)?,
            SlidingControl::Penetration(penetration) => require_finite("penetration", penetration)?,
            SlidingControl::HalfWidth(half_width) => require_positive("half_width", half_width)?,
        };
        match (self.indenter, self.control) {
            (Indenter::Wave, SlidingControl::HalfWidth(half_width)) if half_width >= PI => {
                return Err(Refusal::out_of_range("half_width", half_width, "below π (in 1/k): full contact has no edge"));
            }
            (Indenter::Parabola, SlidingControl::Penetration(_)) => {
                return Err(Refusal::Undefined {
                    quantity: "the penetration of a cylinder",
                    reason: "a line load sinks into a half-plane without bound; prescribe the load or the contact width".into(),
                });
            }
            _ => {}
        }
        match (self.adhesion, self.control) {
            (Some(adhesion), _) => {
                require_positive("reduced_work", adhesion.trailing_work)?;
                require_positive("reduced_work", adhesion.leading_work)?;
                require_positive("trailing_zone", adhesion.trailing_zone)?;
                require_positive("leading_zone", adhesion.leading_zone)?;
            }
            (None, SlidingControl::MeanPressure(pressure)) if pressure <= 0.0 => {
                return Err(Refusal::out_of_range("mean_pressure", pressure, "greater than 0: nothing pulls without adhesion"));
            }
            (None, SlidingControl::Penetration(penetration)) if penetration <= 0.0 => {
                return Err(Refusal::out_of_range("penetration", penetration, "greater than 0: nothing pulls without adhesion"));
            }
            (None, _) => {}
        }
        Ok(())
    }
}

/// Adhesion that is given at one rate, at another one.
pub(in crate::sliding) fn adhesion_at(adhesion: WaveAdhesion, law: Option<&WorkBySpeed>, given: f64, rate: f64) -> WaveAdhesion {
    let Some(law) = law else { return adhesion };
    let (there, here) = (law.factors(rate), law.factors(given));
    adhesion.with_works_times([there[0] / here[0], there[1] / here[1]])
}
