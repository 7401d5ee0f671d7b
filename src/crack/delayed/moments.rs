//! Moments of a fading exponential over a step: what a straight load on a straight path leaves in a memory.
//!
//! ```text
//! n_k(z) = ∫₀¹ e^{−zv} v^k dv,   k = 0, 1, 2, 3          z = step/τ from 0 (any weight counts) to ∞ (only the last instant does)
//! ```
//! n_k = (k n_{k−1} − e^{−z})/z upwards loses digits for z below about k, n_{k−1} = (z n_k + e^{−z})/k downwards has positive terms only and
//! shrinks the error of its start by z/k each time. Relative error below 2e-15 for every z ≥ 0.

/// From here on the upward recursion loses less than a digit.
const UPWARD_FROM: f64 = 3.0;

/// e^{−z} and n_0 to n_3 for z ≥ 0.
#[must_use]
pub fn fading_moments(z: f64) -> (f64, [f64; 4]) {
    let decay = (-z).exp();
    if z >= UPWARD_FROM {
        if z.is_infinite() {
            return (0.0, [0.0; 4]);
        }
        let zeroth = -(-z).exp_m1() / z;
        let first = (zeroth - decay) / z;
        let second = (2.0 * first - decay) / z;
        return (decay, [zeroth, first, second, (3.0 * second - decay) / z]);
    }
    // Start above: n_K ≈ e^{−z}/(K+1)·(1 + z/(K+2)); error z²/K² at the start, times z^{K−3}·6/K! at k = 3.
    let start: i32 = if z < 0.01 {
        7
    } else if z < 0.3 {
        12
    } else {
        24
    };
    let top = f64::from(start);
    let mut moment = decay / (top + 1.0) * (1.0 + z / (top + 2.0));
    let mut third = moment;
    let mut second = moment;
    let mut first = moment;
    let mut k = start;
    while k > 0 {
        moment = (z * moment + decay) / f64::from(k);
        k -= 1;
        if k == 3 {
            third = moment;
        } else if k == 2 {
            second = moment;
        } else if k == 1 {
            first = moment;
        }
    }
    (decay, [moment, first, second, third])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_recursions_agree_at_the_seam_and_the_limits_hold() {
        let (_, at_rest) = fading_moments(0.0);
        for (k, value) in at_rest.iter().enumerate() {
            assert!((value * (k as f64 + 1.0) - 1.0).abs() < 1e-15);
        }
        for z in [0.01, 0.3, UPWARD_FROM] {
            let (_, below) = fading_moments(z * (1.0 - 2e-16));
            let (_, above) = fading_moments(z);
            for k in 0..4 {
                assert!((below[k] / above[k] - 1.0).abs() < 4e-15, "z = {z}, k = {k}: {:e} {:e}", below[k], above[k]);
            }
        }
        for z in [1e-8, 3e-3, 0.1, 1.0, 2.9, 10.0, 500.0, 1e9] {
            // ∫ e^{−zv} v^k by parts ties neighbours: z n_k = k n_{k−1} − e^{−z}.
            let (decay, n) = fading_moments(z);
            for k in 1..4 {
                let rest = z * n[k] - (k as f64 * n[k - 1] - decay);
                assert!(rest.abs() < 4e-16 * n[k - 1].max(decay), "z = {z}, k = {k}: {rest:e}");
            }
        }
    }
}
