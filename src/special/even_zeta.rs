//! Riemann's ζ at the even integers, which every expansion of log|2 sin(x/2)| and of its integrals about 0 or π needs.
//!
//! ```text
//! log( sin(x/2) / (x/2) ) = −Σ_{k≥1} ζ(2k)/k (x/2π)^{2k},   |x| < 2π
//! tail after N:  ζ_N(s) = Σ_{n>N} n^{−s}
//! ```
//! Source: DLMF 25.6.1–25.6.2 (the first three in powers of π), 25.2.1 for the rest, summed from the smallest term; 25.11.1 (the tail).
//! Relative error at most 4e-16.

use spec_math::Zeta;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// How many are tabulated: up to ζ(64) = 1 + 5e-20.
pub const COUNT: usize = 32;

/// ζ(2k) at index k − 1.
pub(crate) static EVEN_ZETA: LazyLock<[f64; COUNT]> = LazyLock::new(|| {
    std::array::from_fn(|index| match index {
        0 => PI * PI / 6.0,
        1 => (PI * PI) * (PI * PI) / 90.0,
        2 => (PI * PI) * (PI * PI) * (PI * PI) / 945.0,
        _ => {
            let exponent = 2 * (index as i32 + 1);
            // What follows the last term is below 199^{−7}/7 = 1e-17.
            1.0 + (2..200).rev().map(|n| f64::from(n).powi(-exponent)).sum::<f64>()
        }
    })
});

/// ζ_N(s) = Σ_{n>N} n^{−s} for an integer s ≥ 2: Hurwitz's ζ(s, N+1), from the `spec_math` crate.
#[must_use]
pub fn zeta_tail(exponent: u32, last_left_out: u32) -> f64 {
    f64::from(exponent).hzeta(f64::from(last_left_out) + 1.0)
}
