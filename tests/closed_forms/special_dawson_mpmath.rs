//! Source: NIST Digital Library of Mathematical Functions, Secs 7.2(ii) and 7.5; the kernels of Schapery (1975, 1989) and Greenwood (2004).
//!
//! Goal: every special function of the crack theories keeps its digits over its whole range, also where the obvious formula loses them.
//!
//! ```text
//!   D(y) = e^{−y²} ∫₀^y e^{t²} dt      y − D       D′ = 1 − 2yD       φ(z) = (1 − e^{−z})/z      1 − φ      −zφ′
//!   Λ(z) = ∫₀¹ (1 − e^{−z(1−r)}) artanh√r dr,  N with r^{−1/2},  M with 2r^{−1/2} − 2 artanh√r,  and d/d ln z of each
//! ```
//! Parameters: y from 1e-10 to 1e10, z from 1e-300 to 1e300, dense around the seams of the series used.
//!
//! Oracle: `reference_data/{dawson,exponential_mean,cohesive_kernel}.csv`, mpmath with 60 to 90 digits by two routes each.
//!
//! Tolerance: relative, per function, as its documentation states: about ten ulp, so that a lost digit fails. Functions with a change of sign
//! (D′ below y = 6.3, dM/d ln z) are held to an absolute figure there, and to a relative one beyond.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;
use crate::support::physics;

use physics::relative;
use support::reference_rows;
use viscotack::special::cohesive_kernel::{
    closing_intensity_kernel, closing_intensity_kernel_slope, closing_work_kernel, closing_work_kernel_slope, opening_kernel,
    opening_kernel_slope,
};
use viscotack::special::dawson::{dawson, dawson_deficit, dawson_relative_deficit, dawson_slope};
use viscotack::special::exponential_mean::{exponential_mean, exponential_mean_complement, exponential_mean_decline};

/// The largest error of a function over the rows of a table and where it is, after checking it against a tolerance.
fn worst(file: &str, column: &str, tolerance: f64, function: impl Fn(f64) -> f64, error_of: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let (mut worst, mut place, mut count) = (0.0, 0.0, 0);
    for row in reference_rows(file) {
        let (argument, expected) = (row.number("argument"), row.number(column));
        let error = error_of(argument, function(argument), expected);
        assert!(!error.is_nan(), "{column} at {argument:e} is not a number");
        if error > worst {
            (worst, place) = (error, argument);
        }
        count += 1;
    }
    println!("{column}: worst error {worst:.1e} at {place:e} of {count}");
    assert!(count > 50, "{column}: only {count} points");
    assert!(worst <= tolerance, "{column}: {worst:e} at {place:e}");
    worst
}

fn relative_error(_argument: f64, value: f64, expected: f64) -> f64 {
    relative(value, expected)
}

#[test]
fn dawson_and_its_deficits_are_relative_to_2e15() {
    worst("dawson.csv", "dawson", 1e-15, dawson, relative_error);
    worst("dawson.csv", "argument_minus_dawson", 2e-15, dawson_deficit, relative_error);
    worst("dawson.csv", "argument_minus_dawson", 2e-15, |y| y * dawson_relative_deficit(y), relative_error);
}

#[test]
fn slope_of_dawson_is_absolute_to_5e16_before_its_series_and_relative_beyond() {
    // D′ changes sign at 0.924: only an absolute figure holds below 6.3, where |D′| ≤ 1 and, beyond y = 1, falls like 1/(2y²).
    worst("dawson.csv", "slope", 5e-16, dawson_slope, |y, value, expected| if y < 6.3 { (value - expected).abs() } else { 0.0 });
    worst("dawson.csv", "slope", 1e-15, dawson_slope, |y, value, expected| if y < 6.3 { 0.0 } else { relative(value, expected) });
    // Where nothing cancels it is relative as well.
    worst("dawson.csv", "slope", 2e-15, dawson_slope, |y, value, expected| if y < 0.7 { relative(value, expected) } else { 0.0 });
}

#[test]
fn exponential_means_are_relative_to_1e15() {
    worst("exponential_mean.csv", "mean", 1e-15, exponential_mean, relative_error);
    worst("exponential_mean.csv", "complement", 1e-15, exponential_mean_complement, relative_error);
    worst("exponential_mean.csv", "decline", 1e-15, exponential_mean_decline, relative_error);
}

#[test]
fn cohesive_kernels_are_relative_to_1e15() {
    worst("cohesive_kernel.csv", "opening", 1e-15, opening_kernel, relative_error);
    worst("cohesive_kernel.csv", "intensity", 1e-15, closing_intensity_kernel, relative_error);
    worst("cohesive_kernel.csv", "work", 1e-15, closing_work_kernel, relative_error);
}

#[test]
fn slopes_of_the_cohesive_kernels() {
    worst("cohesive_kernel.csv", "opening_slope", 2e-15, opening_kernel_slope, relative_error);
    // D/y − D′ with D′ = 1 − 2yD below y = 6.3: its absolute 5e-16 is 1e-14 of the slope at z = 40.
    worst("cohesive_kernel.csv", "intensity_slope", 1e-14, closing_intensity_kernel_slope, relative_error);
    worst("cohesive_kernel.csv", "intensity_slope", 2e-15, closing_intensity_kernel_slope, |z, value, expected| {
        if (3.0..=45.0).contains(&z) { 0.0 } else { relative(value, expected) }
    });
    // dM/d ln z = 2 dN/d ln z − 2 dΛ/d ln z changes sign near z = 6.4: relative to the two parts.
    worst("cohesive_kernel.csv", "work_slope", 1e-14, closing_work_kernel_slope, |z, value, expected| {
        (value - expected).abs() / (2.0 * (closing_intensity_kernel_slope(z) + opening_kernel_slope(z)))
    });
}

#[test]
fn obvious_formulas_lose_digits_where_these_do_not() {
    let (mut deficit, mut complement, mut slope, mut opening) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for row in reference_rows("dawson.csv") {
        let y = row.number("argument");
        deficit = deficit.max(relative(y - dawson(y), row.number("argument_minus_dawson")));
        if y > 6.3 {
            slope = slope.max(relative(1.0 - 2.0 * y * dawson(y), row.number("slope")));
        }
    }
    for row in reference_rows("exponential_mean.csv") {
        let z = row.number("argument");
        complement = complement.max(relative(1.0 - exponential_mean(z), row.number("complement")));
    }
    for row in reference_rows("cohesive_kernel.csv") {
        let z = row.number("argument");
        opening = opening.max(relative(dawson_relative_deficit(z.sqrt()) - opening_kernel(z), row.number("opening_slope")));
    }
    println!("lost by the obvious forms: y − D {deficit:.0e}, 1 − φ {complement:.0e}, 1 − 2yD {slope:.0e}, dΛ/d ln z {opening:.0e}");
    assert!(deficit > 0.1 && complement > 0.1 && slope > 0.1 && opening > 0.1);
}

#[test]
fn limits_are_exact() {
    let exact = |value: f64, expected: f64| assert_eq!(value.to_bits(), expected.to_bits(), "{value:e} is not {expected:e}");
    exact(dawson(0.0), 0.0);
    exact(dawson(f64::INFINITY), 0.0);
    exact(dawson_relative_deficit(0.0), 0.0);
    exact(dawson_relative_deficit(f64::INFINITY), 1.0);
    exact(dawson_slope(0.0), 1.0);
    exact(dawson_slope(f64::INFINITY).abs(), 0.0);
    exact(opening_kernel(f64::INFINITY), 1.0);
    exact(closing_intensity_kernel(f64::INFINITY), 2.0);
    exact(closing_work_kernel(f64::INFINITY), 2.0);
    for kernel in [opening_kernel, closing_intensity_kernel, closing_work_kernel, exponential_mean_complement, exponential_mean_decline] {
        exact(kernel(0.0).abs(), 0.0);
    }
    for slope in [opening_kernel_slope, closing_intensity_kernel_slope, closing_work_kernel_slope, exponential_mean_decline] {
        exact(slope(0.0).abs(), 0.0);
        exact(slope(f64::INFINITY).abs(), 0.0);
    }
}

#[test]
fn dawson_obeys_its_differential_equation_and_is_odd() {
    for k in -40..=40 {
        let y = 10f64.powf(f64::from(k) / 8.0);
        let identity = dawson_slope(y) + 2.0 * y * dawson(y);
        // Below the seam this is the definition; above it, two independent series.
        assert!((identity - 1.0).abs() <= 4e-16, "y = {y:e}: {identity:e}");
        assert_eq!(dawson(-y).to_bits(), (-dawson(y)).to_bits());
    }
}
