//! The state of a steady crack at a given speed, or under a given load, for any theory.
//!
//! The unknown is the crossing time T, found as the root of a monotone function in the logarithm of T, inside a bracket that the limits
//! of the theory give. Errors: rounding of the curve and the tolerance of the root, both passed on through the slopes of the curve.

use super::curve::{CurvePoint, Motion, SteadyCurve};
use crate::continuation::root::{LogSlope, increasing_root};
use crate::estimate::Estimate;
use crate::refusal::Refusal;

/// Growth of a bracket that no limit of the theory gives; 60 steps then span 1e290.
const BRACKET_GROWTH: f64 = 65_536.0;
/// A relative residual above this, and above the tolerance that is asked for, is no solution: the root was outside the bracket, or the curve is not a number there.
const LARGEST_RESIDUAL: f64 = 1e-8;
/// Steps of bracket growth before a search is given up.
const MOST_GROWTH_STEPS: u32 = 130;

/// Slopes d ln v/d ln T below this magnify rounding enough to be worth a residual in extended precision.
const STEEP: f64 = 0.3;
/// The first change brings the error from eps over the slope to rounding, the second confirms it.
const SHARPENINGS: u32 = 2;

/// A steady crack, solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyState {
    /// v (m/s).
    pub speed: Estimate,
    /// T (s), the time in which the tip crosses `crossing_length`; infinite at rest.
    pub crossing_time: f64,
    /// Bound on the relative error of T.
    pub crossing_time_error: f64,
    /// ℓ (m), as in [`CurvePoint::crossing_length`].
    pub crossing_length: Estimate,
    /// D (Pa opening, 1/Pa closing), as in [`CurvePoint::drive`].
    pub drive: Estimate,
    /// G/Δγ, or none for a viscous material, which has no energy release rate far from the tip.
    pub energy_release_rate_ratio: Option<Estimate>,
    /// d ln D/d ln v at this state: the local power law of toughness in speed; zero at both limits.
    pub speed_exponent: f64,
    /// Bound on the error of the exponent.
    pub speed_exponent_error: f64,
    /// Relative residual of the equation that was solved: of the speed, or of the drive.
    pub residual: f64,
    /// Points of the curve that were evaluated.
    pub curve_points: u64,
    /// Kernel evaluations (terms times means) in those points.
    pub kernel_evaluations: u64,
}

/// The state at a speed v ≥ 0 (m/s; 0 and ∞ give the exact limits), to a relative `tolerance` of the crossing time.
///
/// # Errors
/// [`Refusal::OutOfRange`] for a negative speed or a NaN; [`Refusal::Undefined`] at rest for a viscous material, or from the curve.
pub fn at_speed(curve: &impl SteadyCurve, speed: f64, tolerance: f64) -> Result<SteadyState, Refusal> {
    if speed.is_nan() || speed < 0.0 {
        return Err(Refusal::out_of_range("speed", speed, "zero or more"));
    }
    let mut count = Count::default();
    if speed == 0.0 || speed.is_infinite() {
        if speed == 0.0 {
            curve.material().solid_modulus("the load on a crack at rest")?;
        }
        let crossing_time = if speed == 0.0 { f64::INFINITY } else { 0.0 };
        let mut point = count.point(curve, crossing_time)?;
        // The limit itself in place of the sum of terms that reaches it up to rounding: E0 or E∞ when opening, their inverses when closing.
        let material = curve.material();
        let modulus = if speed == 0.0 { material.relaxed_modulus() } else { material.glassy_modulus() };
        point.drive = match curve.motion() {
            Motion::Opening => modulus,
            Motion::Closing => 1.0 / modulus,
        };
        let mut state = finished(curve, Estimate::exact(speed), crossing_time, 0.0, &point, 0.0, (tolerance, count))?;
        if let Some(ratio) = &mut state.energy_release_rate_ratio {
            ratio.value = match (speed == 0.0, curve.motion()) {
                (true, _) => 1.0,
                (false, Motion::Opening) => material.stiffening_ratio(),
                (false, Motion::Closing) => 1.0 / material.stiffening_ratio(),
            };
        }
        return Ok(state);
    }
    // F(ln T) = ln(vT/ℓ) rises with T; where ℓ lies between its limits at T = 0 and T = ∞, these bracket the root.
    let lengths = [count.point(curve, 0.0)?.crossing_length, count.point(curve, f64::INFINITY)?.crossing_length];
    let function = |time: f64, count: &mut Count| -> Result<LogSlope, Refusal> {
        let point = count.point(curve, time)?;
        Ok(LogSlope { value: (speed * (time / point.crossing_length)).ln(), slope: 1.0 - point.length_log_slope })
    };
    let limits = bracket_from_limits(lengths, speed);
    let bracket = if curve.length_is_bounded_by_its_limits() {
        limits
    } else {
        grown_bracket(&function, limits[0].sqrt() * limits[1].sqrt(), &mut count)?
    };
    let root = rooted("the crossing time at a given speed", function, bracket, tolerance, &mut count)?;
    let mut crossing_time = root.argument;
    let mut point = count.point(curve, crossing_time)?;
    let mut residual = (speed * (crossing_time / point.crossing_length)).ln().abs();
    // The last Newton step landed closer than its own length; what remains is the residual at the point itself and rounding.
    let mut time_error = (residual + point.length_relative_error + 3.0 * f64::EPSILON) / (1.0 - point.length_log_slope);
    if 1.0 - point.length_log_slope < STEEP {
        // Rounding is magnified by the inverse of this slope: take the residual in extended precision where the theory can.
        for _ in 0..SHARPENINGS {
            let Some(sharper) = curve.sharpened(speed, crossing_time) else { break };
            // A converted series carries its own errors, which more digits of the residual do not mend.
            if sharper.error >= time_error {
                break;
            }
            let next = crossing_time * sharper.change.exp();
            residual = (next / crossing_time).ln().abs() * (1.0 - point.length_log_slope);
            // Half an ulp of T itself, and what the last change may have left.
            time_error = sharper.error + f64::EPSILON + sharper.change * sharper.change;
            crossing_time = next;
            point = count.point(curve, crossing_time)?;
        }
    }
    finished(curve, Estimate::exact(speed), crossing_time, time_error, &point, residual, (tolerance, count))
}

/// The state under a drive D (see [`CurvePoint`]; [`super::CrackBody::drive`] makes it from a stress intensity), to a relative `tolerance`.
///
/// # Errors
/// [`Refusal::NoSuchState`] for a drive at or beyond the limits of the theory, with the limit; [`Refusal::Undefined`] for an elastic
/// material, whose crack is in equilibrium at one drive and at any speed.
pub fn at_drive(curve: &impl SteadyCurve, drive: f64, tolerance: f64) -> Result<SteadyState, Refusal> {
    if !(drive.is_finite() && drive > 0.0) {
        return Err(Refusal::out_of_range("drive", drive, "finite and greater than zero"));
    }
    let material = curve.material();
    if material.is_elastic() {
        return Err(Refusal::Undefined {
            quantity: "the speed of a crack under a given load",
            reason: "the material is elastic: equilibrium holds at G equal to the work of adhesion, and then at any speed".into(),
        });
    }
    let mut count = Count::default();
    let (rest, fast) = match curve.motion() {
        Motion::Opening => (material.relaxed_modulus(), material.glassy_modulus()),
        Motion::Closing => (1.0 / material.relaxed_modulus(), 1.0 / material.glassy_modulus()),
    };
    let sign = if rest < fast { 1.0 } else { -1.0 };
    let ulp = 2.0 * f64::EPSILON;
    if (drive / rest - 1.0).abs() <= ulp {
        return at_speed(curve, 0.0, tolerance);
    }
    refuse_beyond(curve, drive, rest, fast)?;
    // F(ln T) = ±ln(D_wanted/D(T)) rises with T: opening, D falls from E∞ to E0; closing, it rises from 1/E∞ to 1/E0.
    let function = |time: f64, count: &mut Count| -> Result<LogSlope, Refusal> {
        let point = count.point(curve, time)?;
        Ok(LogSlope { value: sign * ((drive - point.drive) / point.drive).ln_1p(), slope: -sign * point.drive_log_slope })
    };
    let middle = match (material.longest_relaxation_time(), material.relaxation_terms().last()) {
        (Some(longest), Some(shortest)) => longest.sqrt() * shortest.relaxation_time.sqrt(),
        _ => 1.0,
    };
    let bracket = grown_bracket(&function, middle, &mut count)?;
    let root = rooted("the crossing time under a given load", function, bracket, tolerance, &mut count)?;
    let point = count.point(curve, root.argument)?;
    let residual = ((drive - point.drive) / point.drive).abs();
    let time_error = (residual + point.drive_relative_error + 2.0 * f64::EPSILON) / point.drive_log_slope.abs().max(f64::MIN_POSITIVE);
    let speed = point.crossing_length / root.argument;
    let speed_error = time_error * (1.0 - point.length_log_slope) + point.length_relative_error + f64::EPSILON;
    let mut state =
        finished(curve, Estimate::relative(speed, speed_error), root.argument, time_error, &point, residual, (tolerance, count))?;
    state.drive = Estimate::exact(drive);
    state.energy_release_rate_ratio =
        state.energy_release_rate_ratio.map(|ratio| Estimate::relative(ratio.value, residual + 2.0 * f64::EPSILON));
    Ok(state)
}

/// A drive at or beyond a limit has no steady state; says which limit, as G/Δγ where that exists.
fn refuse_beyond(curve: &impl SteadyCurve, drive: f64, rest: f64, fast: f64) -> Result<(), Refusal> {
    let (smallest, largest) = (rest.min(fast), rest.max(fast));
    if drive > smallest && drive < largest {
        return Ok(());
    }
    let too_small = drive <= smallest;
    let limit = if too_small { smallest } else { largest };
    let (limit_name, limit) = match (curve.material().relaxed_modulus() > 0.0, curve.motion()) {
        (true, Motion::Opening) => ("G/work_of_adhesion", limit / curve.material().relaxed_modulus()),
        (true, Motion::Closing) => ("G/work_of_adhesion", limit * curve.material().relaxed_modulus()),
        (false, _) => ("drive", limit),
    };
    let reason = match (curve.motion(), too_small) {
        (Motion::Opening, true) => "the load is below the one that opens the crack at vanishing speed",
        (Motion::Opening, false) => "the load is at or above the one that opens the crack at any speed, in the glassy limit",
        (Motion::Closing, true) => "the crack closes under at least the load of the infinitely fast, glassy limit",
        (Motion::Closing, false) => "the load holds the crack open: it closes only below the load of vanishing speed",
    };
    Err(Refusal::NoSuchState { reason: reason.into(), limit_name, limit })
}

/// Work counted while a state is sought.
#[derive(Debug, Clone, Copy, Default)]
struct Count {
    points: u64,
    kernels: u64,
}

impl Count {
    fn point(&mut self, curve: &impl SteadyCurve, time: f64) -> Result<CurvePoint, Refusal> {
        let point = curve.point(time)?;
        self.points += 1;
        self.kernels += point.kernel_evaluations;
        Ok(point)
    }
}

/// Runs the root finder on a function that may refuse.
fn rooted(
    what: &'static str,
    function: impl Fn(f64, &mut Count) -> Result<LogSlope, Refusal>,
    bracket: [f64; 2],
    tolerance: f64,
    count: &mut Count,
) -> Result<crate::continuation::root::Root, Refusal> {
    let mut refusal = None;
    let start = bracket[0].sqrt() * bracket[1].sqrt();
    let root = increasing_root(
        what,
        |time| {
            function(time, count).unwrap_or_else(|reason| {
                refusal.get_or_insert(reason);
                LogSlope { value: f64::NAN, slope: 1.0 }
            })
        },
        bracket,
        start,
        tolerance,
    );
    match refusal {
        Some(reason) => Err(reason),
        None => root,
    }
}

/// T = ℓ/v at the smallest and the largest length, a little widened; a length of zero or infinity leaves that end far out.
fn bracket_from_limits(lengths: [f64; 2], speed: f64) -> [f64; 2] {
    let (small, large) = (lengths[0].min(lengths[1]), lengths[0].max(lengths[1]));
    let lower = small / speed * (1.0 - 1e-12);
    let upper = large / speed * (1.0 + 1e-12);
    [if lower > 0.0 { lower } else { 1e-290 }, if upper.is_finite() && upper > 0.0 { upper } else { 1e290 }]
}

/// A bracket of an increasing function, grown from `middle` by ever larger factors in the direction of the root.
fn grown_bracket(
    function: &impl Fn(f64, &mut Count) -> Result<LogSlope, Refusal>,
    middle: f64,
    count: &mut Count,
) -> Result<[f64; 2], Refusal> {
    let first = function(middle, count)?.value;
    let (mut inner, mut factor) = (middle, 16.0);
    for _ in 0..MOST_GROWTH_STEPS {
        let outer = if first > 0.0 { inner / factor } else { inner * factor };
        if !(outer > 0.0 && outer.is_finite()) {
            break;
        }
        if (function(outer, count)?.value > 0.0) != (first > 0.0) {
            return Ok(if first > 0.0 { [outer, inner] } else { [inner, outer] });
        }
        inner = outer;
        factor = BRACKET_GROWTH.min(factor * 16.0);
    }
    Err(Refusal::NotConverged {
        what: "the bracket of the crossing time",
        detail: "the load is within rounding of a limit of the theory".into(),
    })
}

/// The bound on the error of s/(1 − l) from two slopes of the curve: their own rounding, and how they bend over what is not known of ln T.
fn exponent_error(point: &CurvePoint, exponent: f64, time_error: f64) -> f64 {
    let room = 1.0 - point.length_log_slope;
    let rounding = 8.0 * f64::EPSILON + point.drive_relative_error + point.length_relative_error;
    let of_drive = bend(point.drive_log_slope) * time_error + rounding * point.drive_log_slope.abs();
    let of_length = bend(point.length_log_slope) * time_error + rounding;
    (of_drive + exponent.abs() * of_length) / room
}

/// Bound on |ds/d ln T| of a slope s: of a sum of terms that end exponentially, x e^−x bends by its logarithm times itself.
fn bend(slope: f64) -> f64 {
    let size = slope.abs();
    if size > 0.0 { size * (2.0 + (1.0 / size).ln().max(0.0)) } else { 0.0 }
}

fn finished(
    curve: &impl SteadyCurve,
    speed: Estimate,
    crossing_time: f64,
    time_error: f64,
    point: &CurvePoint,
    residual: f64,
    (tolerance, count): (f64, Count),
) -> Result<SteadyState, Refusal> {
    let drive_error = point.drive_relative_error + point.drive_log_slope.abs() * time_error;
    let length_error = point.length_relative_error + point.length_log_slope.abs() * time_error;
    let ratio = match curve.material().solid_modulus("") {
        Ok(_) => Some(Estimate::relative(curve.energy_release_rate_ratio(point.drive)?, drive_error + f64::EPSILON)),
        Err(_) => None,
    };
    let exponent = -point.drive_log_slope / (1.0 - point.length_log_slope);
    let state = SteadyState {
        speed,
        crossing_time,
        crossing_time_error: time_error,
        crossing_length: Estimate::relative(point.crossing_length, length_error),
        drive: Estimate::relative(point.drive, drive_error),
        energy_release_rate_ratio: ratio,
        speed_exponent: exponent,
        speed_exponent_error: exponent_error(point, exponent, time_error),
        residual,
        curve_points: count.points,
        kernel_evaluations: count.kernels,
    };
    if residual > LARGEST_RESIDUAL.max(tolerance) {
        return Err(Refusal::NotConverged { what: "the steady crack", detail: format!("a residual of {residual:e} remains") });
    }
    // Whatever went wrong, no NaN leaves.
    if state.drive.value.is_nan() || state.drive.error.is_nan() || state.speed.error.is_nan() {
        return Err(Refusal::NotConverged { what: "the steady crack", detail: "the state is not a number".into() });
    }
    Ok(state)
}
