//! ln Γ(x) for x > 0, by Stirling's series after a shift of the argument to above 10: absolute error below 1e-14.

/// Coefficients B_{2k}/(2k(2k−1)) of Stirling's series.
const STIRLING: [f64; 7] = [1.0 / 12.0, -1.0 / 360.0, 1.0 / 1260.0, -1.0 / 1680.0, 1.0 / 1188.0, -691.0 / 360_360.0, 1.0 / 156.0];

pub(super) fn ln_gamma(x: f64) -> f64 {
    let mut argument = x;
    let mut product = 1.0;
    while argument < 10.0 {
        product *= argument;
        argument += 1.0;
    }
    let inverse = 1.0 / argument;
    let series: f64 = STIRLING.iter().rev().fold(0.0, |sum, &coefficient| sum * inverse * inverse + coefficient) * inverse;
    (argument - 0.5) * argument.ln() - argument + 0.5 * std::f64::consts::TAU.ln() + series - product.ln()
}
