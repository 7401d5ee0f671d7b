//! The complete elliptic integral of the first kind, in the PARAMETER m = k².

use std::f64::consts::FRAC_PI_2;

/// K(m) for m < 1, by the arithmetic-geometric mean: π/(2·agm(1, √(1 − m))); relative error below 1e-15 at the seven values of 40 digits that its test holds.
///
/// Six means suffice for 0 ≤ m ≤ 1 − 1e-10: the number of digits doubles with each. A NaN for m ≥ 1.
#[must_use]
pub fn elliptic_k(m: f64) -> f64 {
    let (mut arithmetic, mut geometric) = (1.0, (1.0 - m).sqrt());
    for _ in 0..12 {
        let gap: f64 = arithmetic - geometric;
        if gap.abs() <= 2e-16 * arithmetic {
            break;
        }
        (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
    }
    if m < 1.0 { FRAC_PI_2 / arithmetic } else { f64::NAN }
}
