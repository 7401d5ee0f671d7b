//! Widening the bounds of a contact by what is uncertain of the parameters it was solved at.

use crate::estimate::Estimate;
use crate::sliding::steady::{AdhesiveValues, PartialValues};

/// Each value of `here` with the bound wider by what it may change: `times`, an error of a parameter over its difference, times the change to `there`.
/// That change is known as
/// well as both values: where a contact beside is accepted before a small value of it has moved, its bound holds the change.
pub(super) fn widened(here: &PartialValues, there: &PartialValues, times: f64) -> PartialValues {
    let wide = |first: Estimate, second: Estimate| {
        let moved = (second.value - first.value).abs() + first.error + second.error;
        Estimate::new(first.value, first.error + times * moved)
    };
    PartialValues {
        half_width: wide(here.half_width, there.half_width),
        eccentricity: wide(here.eccentricity, there.eccentricity),
        trailing_edge: wide(here.trailing_edge, there.trailing_edge),
        leading_edge: wide(here.leading_edge, there.leading_edge),
        penetration: wide(here.penetration, there.penetration),
        mean_pressure: wide(here.mean_pressure, there.mean_pressure),
        friction_stress: wide(here.friction_stress, there.friction_stress),
        friction_coefficient: here.friction_coefficient.zip(there.friction_coefficient).map(|(first, second)| wide(first, second)),
        interface_work: wide(here.interface_work, there.interface_work),
        adhesion: here.adhesion.zip(there.adhesion).map(|(first, second)| AdhesiveValues {
            trailing_release: wide(first.trailing_release, second.trailing_release),
            leading_release: wide(first.leading_release, second.leading_release),
            trailing_nonconservative: wide(first.trailing_nonconservative, second.trailing_nonconservative),
            leading_nonconservative: wide(first.leading_nonconservative, second.leading_nonconservative),
            adhesive_friction_stress: wide(first.adhesive_friction_stress, second.adhesive_friction_stress),
        }),
    }
}
