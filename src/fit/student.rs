//! Quantiles of Student's distribution.

use spec_math::Beta;

/// t such that |T| ≤ t with the probability `inside`, for so many degrees of freedom (at least 1).
///
/// From I_x(ν/2, 1/2) = 1 − `inside` with x = ν/(ν + t²) (Abramowitz and Stegun 26.7.1), good to 1e-9.
#[must_use]
pub fn two_sided(inside: f64, freedom: f64) -> f64 {
    let freedom = freedom.max(1.0);
    let x = (1.0 - inside).ibeta_inv(0.5 * freedom, 0.5);
    (freedom * (1.0 - x) / x).sqrt()
}

#[cfg(test)]
mod tests {
    use super::two_sided;

    #[test]
    fn quantiles_are_those_of_printed_tables() {
        // Abramowitz and Stegun, Table 26.10.
        for (freedom, t) in [(1.0, 12.706), (4.0, 2.776), (10.0, 2.228), (60.0, 2.000), (1e6, 1.960)] {
            assert!((two_sided(0.95, freedom) - t).abs() < 6e-4, "{freedom}");
        }
    }
}
