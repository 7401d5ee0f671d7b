//! Dawson's integral and the two combinations in which steady crack fields need it without cancellation.
//!
//! ```text
//! D(y)  = e^{−y²} ∫₀^y e^{t²} dt        D ≈ y − (2/3)y³ (small y),  D ≈ 1/(2y) + 1/(4y³) (large y)
//! y − D(y)        the trumpet of an opening crack: positive, (2/3)y³ for small y
//! D′(y) = 1 − 2yD(y)   the stress of a closing crack: 1 at y = 0, zero at y = 0.92414, −1/(2y²) for large y
//! ```
//! Source: NIST Digital Library of Mathematical Functions, Secs 7.2(ii), 7.5 and 7.12(ii). D itself is the `spec_math` crate's
//! (measured: 3e-16 relative).

use spec_math::Dawson;

/// Power series below this argument; it loses no digit up to here.
const SERIES_BELOW: f64 = 1.0;
/// Asymptotic series above this argument: its smallest term is of order e^{−y²} < 1e-17 there.
const ASYMPTOTIC_ABOVE: f64 = 6.3;

/// Dawson's integral D(y) for any real y; odd; D(±∞) = 0.
#[must_use]
pub fn dawson(y: f64) -> f64 {
    if y.is_infinite() { 0.0 } else { y.dawson() }
}

/// y − D(y) for y ≥ 0, relative error at most 2e-15 (infinite for y = ∞).
#[must_use]
pub fn dawson_deficit(y: f64) -> f64 {
    if y < SERIES_BELOW {
        // D = Σ (−2y²)^k y/(2k+1)!!, so the k-th term is −2y²/(2k+1) times the one before; 24 terms leave 1e-20 at y = 1.
        let square = y * y;
        let mut term = 2.0 / 3.0 * square * y;
        let mut sum = term;
        for k in 2..26 {
            term *= -2.0 * square / f64::from(2 * k + 1);
            sum += term;
        }
        sum
    } else {
        y - dawson(y)
    }
}

/// 1 − D(y)/y for y ≥ 0, relative error at most 2e-15: (2/3)y² for small y, 1 for y = ∞.
#[must_use]
pub fn dawson_relative_deficit(y: f64) -> f64 {
    if y == 0.0 {
        0.0
    } else if y < 1e-90 {
        // y³ would underflow.
        2.0 / 3.0 * y * y
    } else if y.is_infinite() {
        1.0
    } else {
        dawson_deficit(y) / y
    }
}

/// The derivative D′(y) = 1 − 2yD(y) for y ≥ 0; absolute error at most 5e-16 below y = 6.3, relative error at most 1e-15 above.
#[must_use]
pub fn dawson_slope(y: f64) -> f64 {
    if y < ASYMPTOTIC_ABOVE {
        return 1.0 - 2.0 * y * dawson(y);
    }
    // −Σ_{k≥1} (2k−1)!!/(2y²)^k, stopped at the smallest term or at rounding.
    let inverse = 0.5 / (y * y);
    let mut term = inverse;
    let mut sum = term;
    for k in 2..60 {
        let next = term * f64::from(2 * k - 1) * inverse;
        if next >= term || next < 1e-17 * sum {
            break;
        }
        term = next;
        sum += term;
    }
    -sum
}
