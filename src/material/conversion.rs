//! From creep to relaxation and back: the zeros of a secular equation.
//!
//! With the rates l_j = 1/τ_j and r_i = 1/ρ_i, the operational modulus and compliance are reciprocal, so the rates of one series are the
//! zeros of the other:
//! ```text
//! r_i:  1/E∞ + Σ_j J_j l_j/(l_j − r) + (1/η)/(0 − r) = 0,     E_i = 1/(r_i [Σ_j J_j l_j/(l_j − r_i)² + (1/η)/r_i²])
//! l_j:  Σ_i E_i/(r_i − l) + E0/(0 − l) = 0,                    J_j = 1/(l_j Σ_i E_i r_i/(r_i − l_j)²)
//! ```
//! Both are c + Σ_k w_k/(p_k − x) = 0 with weights w_k > 0 and c ≥ 0: increasing between neighbouring poles p_k, one zero in each gap, and
//! for c > 0 one more above the last pole. A viscous material (E0 = 0) has a creep pole at rate zero and no relaxation pole there.
//!
//! # How
//! The unknown is the shift μ from the NEARER pole, never the rate itself: a weak term moves its rate by a small fraction of a pole
//! distance, and a rate would forget that shift. Differences of poles are formed from the times, (τ_k − τ_j)/(τ_kτ_j), exact to
//! rounding even for times that differ in the last digits. Then every factor is known to a few ulp, and so are μ and the strength.
//! Polynomial root finding, by comparison, loses all digits at 20 terms. Source: theory of the LAPACK routine DLAED4 (Li, 1993,
//! LAPACK Working Note 89) for the shift; Gross, *Mathematical Structure of the Theories of Viscoelasticity* (1953) for the pair.

use super::{CreepTerm, RelaxationTerm};
use crate::continuation::root::{LogSlope, increasing_root};
use crate::refusal::Refusal;

/// Bounds on the errors of one converted term, relative to the term itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConversionError {
    /// Relative error of the converted time from arithmetic alone (the given series taken as exact).
    pub time: f64,
    /// Relative error of the converted strength from arithmetic alone.
    pub strength: f64,
    /// Relative change of the strength if every given number moves by half a unit in its last place: what decimal input in double
    /// precision cannot know. Large for nearly equal times, and for a term that shifts its rate by little.
    pub strength_input: f64,
    /// The same for the time, relative too.
    pub time_input: f64,
}

/// A pole of the secular function: its rate, the time 1/rate (infinite for rate zero), its weight.
#[derive(Debug, Clone, Copy)]
struct Pole {
    rate: f64,
    time: f64,
    weight: f64,
}

/// A zero of the secular function as the nearer pole plus a signed shift.
struct Zero {
    /// Index of the nearer pole.
    near: usize,
    /// Zero minus that pole, known to a few ulp of itself.
    shift: f64,
    /// Relative error of the shift.
    shift_error: f64,
}

/// p_k − p_j from the times, to a few ulp even when the two nearly coincide.
fn pole_difference(k: &Pole, j: &Pole) -> f64 {
    if k.rate == 0.0 {
        -j.rate
    } else if j.rate == 0.0 {
        k.rate
    } else {
        // Divided one after the other, so that a product of two small times cannot underflow.
        (j.time - k.time) / j.time / k.time
    }
}

/// Relaxation terms, longest time first, with their errors, from a creep series sorted from the longest time.
///
/// # Errors
/// [`Refusal::NotConverged`] when a zero cannot be closed in on (numbers outside about 1e-150…1e150).
pub(crate) fn relaxation_from_creep(
    glassy_modulus: f64,
    terms: &[CreepTerm],
    steady_viscosity: Option<f64>,
) -> Result<(Vec<RelaxationTerm>, Vec<ConversionError>), Refusal> {
    let flow = steady_viscosity.map(|viscosity| Pole { rate: 0.0, time: f64::INFINITY, weight: 1.0 / viscosity });
    let poles: Vec<Pole> = flow
        .into_iter()
        .chain(terms.iter().map(|term| {
            let rate = 1.0 / term.retardation_time;
            Pole { rate, time: term.retardation_time, weight: term.compliance * rate }
        }))
        .collect();
    let mut converted = Vec::with_capacity(poles.len());
    let mut errors = Vec::with_capacity(poles.len());
    for gap in 0..poles.len() {
        let zero = secular_zero(&poles, gap, 1.0 / glassy_modulus)?;
        let rate = poles[zero.near].rate + zero.shift;
        let (sum, error) = strength_sum(&poles, &zero, rate, |pole| pole.weight);
        converted.push(RelaxationTerm { modulus: 1.0 / (rate * sum), relaxation_time: 1.0 / rate });
        errors.push(error);
    }
    Ok((converted, errors))
}

/// Creep terms, longest time first, with their errors, from a relaxation series sorted from the longest time.
///
/// For `relaxed_modulus` = 0 there is one term fewer than relaxation terms; the flow t/η with η = ΣE_iρ_i is the missing one.
///
/// # Errors
/// [`Refusal::NotConverged`] when a zero cannot be closed in on (numbers outside about 1e-150…1e150).
pub(crate) fn creep_from_relaxation(
    relaxed_modulus: f64,
    terms: &[RelaxationTerm],
) -> Result<(Vec<CreepTerm>, Vec<ConversionError>), Refusal> {
    let rest = (relaxed_modulus > 0.0).then_some(Pole { rate: 0.0, time: f64::INFINITY, weight: relaxed_modulus });
    let poles: Vec<Pole> = rest
        .into_iter()
        .chain(terms.iter().map(|term| Pole { rate: 1.0 / term.relaxation_time, time: term.relaxation_time, weight: term.modulus }))
        .collect();
    let gaps = poles.len().saturating_sub(1);
    let mut converted = Vec::with_capacity(gaps);
    let mut errors = Vec::with_capacity(gaps);
    for gap in 0..gaps {
        let zero = secular_zero(&poles, gap, 0.0)?;
        let rate = poles[zero.near].rate + zero.shift;
        let (sum, error) = strength_sum(&poles, &zero, rate, |pole| pole.weight * pole.rate);
        converted.push(CreepTerm { compliance: 1.0 / (rate * sum), retardation_time: 1.0 / rate });
        errors.push(error);
    }
    Ok((converted, errors))
}

/// A zero −r of A(s) + B(s), two relaxation series whose sum is a solid's: the creep term of 1/(A + B) there, and A(−r).
#[derive(Debug, Clone, Copy)]
pub(super) struct SumZero {
    /// Creep compliance of the sum (1/Pa).
    pub compliance: f64,
    /// 1/r (s).
    pub time: f64,
    /// Bound on the relative errors of compliance and time together.
    pub error: f64,
    /// A(−r) (Pa), of either sign.
    pub value: f64,
    /// Bound on its error (Pa).
    pub value_error: f64,
}

/// The zeros of a sum A + B of two relaxation series. `relaxed` and the terms, sorted from the longest time, hold A and B.
///
/// A(−r) is −B(−r), so it is taken from the one whose sum cancels less.
///
/// # Errors
/// [`Refusal::NotConverged`] when a zero cannot be closed in on (numbers outside about 1e-150…1e150).
pub(super) fn zeros_of_sum(relaxed: [f64; 2], terms: &[(f64, [f64; 2])]) -> Result<Vec<SumZero>, Refusal> {
    let rest = Pole { rate: 0.0, time: f64::INFINITY, weight: relaxed[0] + relaxed[1] };
    let poles: Vec<Pole> =
        std::iter::once(rest).chain(terms.iter().map(|&(time, [a, b])| Pole { rate: 1.0 / time, time, weight: a + b })).collect();
    let parts: Vec<[f64; 2]> = std::iter::once(relaxed).chain(terms.iter().map(|&(_, parts)| parts)).collect();
    let mut zeros = Vec::with_capacity(terms.len());
    for gap in 0..terms.len() {
        let mut zero = secular_zero(&poles, gap, 0.0)?;
        let near = &poles[zero.near];
        let distance = |index: usize, pole: &Pole| if index == zero.near { -zero.shift } else { pole_difference(pole, near) - zero.shift };
        // The weights are rounded sums of three products: what that does to the shift.
        let (mut moved, mut slope) = (0.0, 0.0);
        for (index, pole) in poles.iter().enumerate() {
            let d = distance(index, pole).abs();
            slope += pole.weight / d / d;
            moved += pole.weight / d * (2.0 * f64::EPSILON);
        }
        let shift_error = zero.shift_error + moved / slope / zero.shift.abs();
        let rate = near.rate + zero.shift;
        let (mut values, mut value_errors) = ([0.0; 2], [0.0; 2]);
        for (index, (pole, [a, b])) in poles.iter().zip(&parts).enumerate() {
            let d = distance(index, pole);
            let own = if index == zero.near { shift_error } else { shift_error * (zero.shift / d).abs() + 3.0 * f64::EPSILON };
            let summands = [a, b].map(|part| part * (rate / d));
            values = [values[0] - summands[0], values[1] + summands[1]];
            let each = own + shift_error * (zero.shift / rate).abs() + 4.0 * f64::EPSILON;
            value_errors = [value_errors[0] + summands[0].abs() * each, value_errors[1] + summands[1].abs() * each];
        }
        let (value, value_error) =
            if value_errors[1] < value_errors[0] { (values[1], value_errors[1]) } else { (values[0], value_errors[0]) };
        zero.shift_error = shift_error;
        let (sum, error) = strength_sum(&poles, &zero, rate, |pole| pole.weight * pole.rate);
        let error = error.time + error.strength + 2.0 * f64::EPSILON;
        zeros.push(SumZero { compliance: 1.0 / (rate * sum), time: 1.0 / rate, error, value, value_error });
    }
    Ok(zeros)
}

/// The zero of `constant` + Σ w_k/(p_k − x) above pole number `gap`, and below the next pole if there is one.
fn secular_zero(poles: &[Pole], gap: usize, constant: f64) -> Result<Zero, Refusal> {
    // Near pole n, x = p_n + s·μ with s = ±1 and μ > 0, and the equation reads w_n/μ = s·rest(μ) with rest = constant + Σ' w_k/(p_k − x).
    let rest = |near: usize, sign: f64, shift: f64| -> (f64, f64) {
        let (mut sum, mut derivative) = (constant, 0.0);
        for (index, pole) in poles.iter().enumerate() {
            if index != near {
                let distance = pole_difference(pole, &poles[near]) - sign * shift;
                sum += pole.weight / distance;
                derivative += sign * pole.weight / distance / distance;
            }
        }
        (sign * sum, sign * derivative)
    };
    let total_weight: f64 = poles.iter().map(|pole| pole.weight).sum();
    let (near, sign, upper) = match poles.get(gap + 1) {
        None => (gap, 1.0, total_weight / constant),
        Some(next) => {
            let half = 0.5 * pole_difference(next, &poles[gap]);
            // At the midpoint an increasing function is positive exactly if its zero lies in the left half.
            let (from_left, _) = rest(gap, 1.0, half);
            if from_left >= poles[gap].weight / half { (gap, 1.0, half) } else { (gap + 1, -1.0, half) }
        }
    };
    let weight = poles[near].weight;
    // s·rest rises with μ, so its value at the far end bounds the zero from below: μ ≥ w/(s·rest(upper)).
    let (at_upper, _) = rest(near, sign, upper);
    let lower = (weight / at_upper * 0.5).min(upper);
    let start = (weight / at_upper).min(upper);
    let root = increasing_root(
        "the secular equation of a material's series",
        |shift| {
            let (value, derivative) = rest(near, sign, shift);
            LogSlope { value: shift * value / weight - 1.0, slope: shift * (value + shift * derivative) / weight }
        },
        [lower, upper],
        start,
        f64::EPSILON,
    )?;
    let shift = root.argument;
    // What a few ulp in every summand do to the shift: Σ|terms| / (μ f′).
    let (mut magnitude, mut derivative) = (constant + weight / shift, weight / shift / shift);
    for (index, pole) in poles.iter().enumerate() {
        if index != near {
            let distance = (pole_difference(pole, &poles[near]) - sign * shift).abs();
            magnitude += pole.weight / distance;
            derivative += pole.weight / distance / distance;
        }
    }
    let shift_error = f64::EPSILON * (2.0 + 2.5 * magnitude / (shift * derivative)) + root.relative_error;
    Ok(Zero { near, shift: sign * shift, shift_error })
}

/// Σ v_k/(p_k − x)² at a zero, with the errors that the term made of it inherits.
fn strength_sum(poles: &[Pole], zero: &Zero, rate: f64, numerator: impl Fn(&Pole) -> f64) -> (f64, ConversionError) {
    let near = &poles[zero.near];
    let half_ulp = 0.5 * f64::EPSILON;
    let distance = |index: usize, pole: &Pole| if index == zero.near { -zero.shift } else { pole_difference(pole, near) - zero.shift };
    // How far the zero moves when every rate p_k and every weight moves by half an ulp (relative to the zero's own pole for p_k).
    let (mut moved, mut slope) = (0.0, 0.0);
    for (index, pole) in poles.iter().enumerate() {
        let d = distance(index, pole).abs();
        slope += pole.weight / d / d;
        moved += pole.weight / d / d * (half_ulp * pole.rate) + pole.weight / d * (2.0 * half_ulp);
    }
    let moved = moved / slope;
    let (mut sum, mut arithmetic, mut input) = (0.0, 0.0, 0.0);
    for (index, pole) in poles.iter().enumerate() {
        let d = distance(index, pole);
        let summand = numerator(pole) / d / d;
        sum += summand;
        let own = if index == zero.near { zero.shift_error } else { zero.shift_error * (zero.shift / d).abs() + 3.0 * f64::EPSILON };
        arithmetic += summand * 2.0 * own;
        input += summand * 2.0 * (moved + half_ulp * pole.rate) / d.abs();
    }
    let time = zero.shift_error * (zero.shift / rate).abs() + 2.0 * f64::EPSILON;
    let error = ConversionError {
        time,
        strength: arithmetic / sum + time + 3.0 * f64::EPSILON,
        strength_input: input / sum + moved / rate + half_ulp,
        time_input: moved / rate,
    };
    (sum, error)
}
