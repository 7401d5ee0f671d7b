//! A closing crack whose process zone grows with the load: the speed in extended precision, where the toughness falls like a cliff.
//!
//! With δ = α(K₁/(√(2π)σ_c))² the balance reads (c halves)
//! ```text
//! T⟨R⟩(T) = E0T + Σ E_iρ_i (1 − e^{−T/ρ_i}) = P,       P = αΔγE0²/(cπσ_c²v)
//! ```
//! Where every strong term has run its course, T⟨R⟩ hardly depends on T: the condition of ln T in ln v is T⟨R⟩/(TR(T)), up to about β/ln β,
//! and double precision leaves eps times that. But the equation is easy to put right: the large parts P − Σ E_iρ_i are products of given
//! numbers, formed here in double-double numbers, and what remains is small and needs no more than double. So the speed is taken
//! as exactly the double that was given, and the toughness keeps its digits. Source: our own; the balance is thesis Eqs 5.37 and 5.41.

use super::process_zone::{Interface, ProcessZone};
use crate::material::{GivenSeries, PlaneMaterial};
use twofloat::TwoFloat;
use twofloat::consts::PI;

/// A correction of the crossing time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Change of ln T that makes the balance exact to first order.
    pub change: f64,
    /// Bound on the error of that change.
    pub error: f64,
}

/// Terms whose exponent is beyond this are counted as run out, their remainder as a small negative part.
const RUN_OUT: f64 = 1.0;

/// The correction at a speed (m/s) and a crossing time (s), or none for a process zone that does not grow with the load.
#[must_use]
pub fn correction(material: &PlaneMaterial, interface: &Interface, speed: f64, crossing_time: f64) -> Option<Correction> {
    let ProcessZone::Growing { cohesive_stress, factor } = interface.process_zone else {
        return None;
    };
    let exact = TwoFloat::from;
    let relaxed = material.relaxed_modulus();
    let product = exact(factor) * exact(interface.work_of_adhesion) * exact(relaxed) * exact(relaxed);
    let divisor = PI * exact(cohesive_stress) * exact(cohesive_stress) * exact(interface.body.deformable_halves()) * exact(speed);
    // The run-out areas ΣE_iρ_i; multiplied by the divisor instead of dividing by it, as the crate's quotients have only 53 good bits.
    let mut areas = exact(0.0);
    let mut small = relaxed * crossing_time;
    let mut magnitude = small;
    let mut inherited = material.modulus_rounding() * (f64::from(product) / f64::from(divisor)).abs();
    for (index, term) in material.relaxation_terms().iter().enumerate() {
        let area = term.modulus * term.relaxation_time;
        let exponent = crossing_time / term.relaxation_time;
        if exponent > RUN_OUT {
            areas += exact(term.modulus) * exact(term.relaxation_time);
            small -= area * (-exponent).exp();
            magnitude += area * (-exponent).exp() * exponent;
        } else {
            let gained = -area * (-exponent).exp_m1();
            small += gained;
            magnitude += gained;
        }
        if material.given() == GivenSeries::Creep
            && let Some(error) = material.conversion_errors().get(index)
        {
            inherited += area * (error.strength + error.time);
        }
    }
    let slope = crossing_time * material.relaxation(crossing_time);
    let large = f64::from(product - areas * divisor) / f64::from(divisor);
    let change = (large - small) / slope;
    let error = (4.0 * f64::EPSILON * magnitude + inherited) / slope;
    (change.is_finite() && error.is_finite()).then_some(Correction { change, error })
}
