//! The memory of a constant cohesive stress: two weighted means of a creep term over a Dugdale zone.
//!
//! ```text
//! opening  Λ(z) = ∫₀¹ (1 − e^{−z(1−r)}) artanh√r dr            = 1 − (2/z) ∫₀^{√z} D(y) dy,      Λ(0) = 0, Λ(∞) = 1
//! closing  N(z) = ∫₀¹ (1 − e^{−z(1−r)}) r^{−1/2} dr            = 2 (1 − D(√z)/√z),              N(0) = 0, N(∞) = 2
//!          M(z) = ∫₀¹ (1 − e^{−z(1−r)}) [2r^{−1/2} − 2 artanh√r] dr = 2N(z) − 2Λ(z),             M(0) = 0, M(∞) = 2
//! ```
//! z = δ/(vτ) is the time to cross the zone in units of a retardation time. The forms with Dawson's integral D follow by parts:
//! d(z(1 − Λ))/dz = D(√z)/√z. Sources of the integrals: Schapery (1975), DOI 10.1007/BF00034721 (opening);
//! Schapery (1989), DOI 10.1007/BF00047448, and Greenwood (2004), DOI 10.1088/0022-3727/37/18/011 (closing).
//! Relative error over 0 ≤ z ≤ ∞ (checked against mpmath): at most 1e-15 of Λ, N, M and dΛ/d ln z; 1e-14 of dN/d ln z; dM/d ln z, which
//! changes sign near z = 6.4, is good to 1e-14 of the sum of its two parts.

use crate::special::dawson::{dawson, dawson_relative_deficit, dawson_slope};
use crate::special::gauss_legendre::UNIT_RULE;

/// Power series of Λ below this argument (its terms alternate, the first dominates).
const SERIES_BELOW: f64 = 1.0;
/// Asymptotic series of ∫D above this √z.
const ASYMPTOTIC_ABOVE: f64 = 6.5;
/// Euler's constant γ = 0.57721…
const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// Λ(z): the opening kernel, for z ≥ 0.
#[must_use]
pub fn opening_kernel(z: f64) -> f64 {
    if z < SERIES_BELOW {
        // z(1−Λ) = Σ_{k≥0} (−2)^k z^{k+1}/((k+1)(2k+1)!!), so Λ = z/3 − 4z²/45 + …; 26 terms leave 1e-22 at z = 1.
        let mut double_factorial_term = 1.0;
        let mut sum = 0.0;
        for k in 1..26 {
            double_factorial_term *= -2.0 * z / f64::from(2 * k + 1);
            sum -= double_factorial_term / f64::from(k + 1);
        }
        sum
    } else if z.is_infinite() {
        1.0
    } else {
        1.0 - 2.0 / z * dawson_integral(z.sqrt())
    }
}

/// dΛ/d ln z = (1 − Λ) − D(√z)/√z ≥ 0.
#[must_use]
pub fn opening_kernel_slope(z: f64) -> f64 {
    if z.is_infinite() {
        0.0
    } else if z < SERIES_BELOW {
        // (1 − D/√z) − Λ ≈ 2z/3 − z/3.
        dawson_relative_deficit(z.sqrt()) - opening_kernel(z)
    } else {
        // 1 − Λ from its own integral: it falls like ln(4z)/z, which a difference from 1 would forget.
        let y = z.sqrt();
        2.0 / z * dawson_integral(y) - dawson(y) / y
    }
}

/// N(z): the stress-intensity kernel of a closing zone, for z ≥ 0.
#[must_use]
pub fn closing_intensity_kernel(z: f64) -> f64 {
    2.0 * dawson_relative_deficit(z.sqrt())
}

/// dN/d ln z = D(√z)/√z − D′(√z) = (1 − D′) − (1 − D/√z) ≥ 0.
#[must_use]
pub fn closing_intensity_kernel_slope(z: f64) -> f64 {
    if z.is_infinite() {
        return 0.0;
    }
    if z < SERIES_BELOW {
        // −Σ_{k≥1} 2k(−2z)^k/(2k+1)!! = 4z/3 − 16z²/15 + …; 26 terms leave 1e-22 at z = 1.
        let mut term = 1.0;
        let mut sum = 0.0;
        for k in 1..26 {
            term *= -2.0 * z / f64::from(2 * k + 1);
            sum -= term * f64::from(2 * k);
        }
        return sum;
    }
    let y = z.sqrt();
    dawson(y) / y - dawson_slope(y)
}

/// M(z): the work kernel of a closing zone, for z ≥ 0.
#[must_use]
pub fn closing_work_kernel(z: f64) -> f64 {
    2.0 * closing_intensity_kernel(z) - 2.0 * opening_kernel(z)
}

/// dM/d ln z.
#[must_use]
pub fn closing_work_kernel_slope(z: f64) -> f64 {
    2.0 * closing_intensity_kernel_slope(z) - 2.0 * opening_kernel_slope(z)
}

/// ∫₀^x D(y) dy for x ≥ 1: by Gauss–Legendre in half-unit panels up to x = 6.5, by the asymptotic series above.
fn dawson_integral(x: f64) -> f64 {
    if x < ASYMPTOTIC_ABOVE {
        // 16 nodes on a panel of width ≤ 0.5 leave less than 1e-17 (D is entire, with unit scale).
        let panels = (2.0 * x).ceil().max(1.0);
        let width = x / panels;
        let mut sum = 0.0;
        let mut left = 0.0;
        while left < x - 0.5 * width {
            for &(node, weight) in UNIT_RULE.iter() {
                sum += weight * width * dawson(left + width * node);
            }
            left += width;
        }
        return sum;
    }
    // ½ ln(2x) + γ/4 + … : the tail −Σ_{k≥1} (2k−1)!!/(2^{k+2} k x^{2k}), as D ~ Σ (2k−1)!!/(2^{k+1} x^{2k+1}).
    let inverse = 0.5 / (x * x);
    let mut coefficient = 1.0;
    let mut tail = 0.0;
    for k in 1..40 {
        let next = coefficient * f64::from(2 * k - 1) * inverse;
        if next >= coefficient || next < 1e-18 {
            break;
        }
        coefficient = next;
        tail += coefficient / f64::from(4 * k);
    }
    0.5 * (2.0 * x).ln() + 0.25 * EULER_GAMMA - tail
}
