//! The creep of the body as a chain of Voigt elements, and the implicit step that advances it.
//!
//! The strains are carried as pressures v_j: τ_j v̇_j = J_j p − v_j, displacement m·A(p/β + Σ v_j). They vanish where no pressure ever was.
//! ESDIRK4(3)6L[2]SA of Kennedy & Carpenter (2003): five implicit stages with one diagonal ¼, so that one effective compliance
//! C = 1/β + Σ J_j z_j/(1 + z_j), z_j = h/(4τ_j), serves all of them, and each stage is one elastic adhesive contact.

use std::ops::Range;

/// The diagonal of the tableau.
pub(super) const DIAGONAL: f64 = 0.25;
/// The stages.
pub(super) const STAGES: usize = 6;
/// Their times.
pub(super) const TIMES: [f64; STAGES] = [0.0, 0.5, 83.0 / 250.0, 0.62, 0.85, 1.0];
/// The rows below the diagonal.
pub(super) const ROWS: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 5],
    [0.25, 0.0, 0.0, 0.0, 0.0],
    [8611.0 / 62500.0, -1743.0 / 31250.0, 0.0, 0.0, 0.0],
    [5012029.0 / 34652500.0, -654441.0 / 2922500.0, 174375.0 / 388108.0, 0.0, 0.0],
    [15267082809.0 / 155376265600.0, -71443401.0 / 120774400.0, 730878875.0 / 902184768.0, 2285395.0 / 8070912.0, 0.0],
    [WEIGHTS[0], WEIGHTS[1], WEIGHTS[2], WEIGHTS[3], WEIGHTS[4]],
];
/// The weights of order four; also the last row (the method is stiffly accurate).
pub(super) const WEIGHTS: [f64; STAGES] = [82889.0 / 524892.0, 0.0, 15625.0 / 83664.0, 69875.0 / 102672.0, -2260.0 / 8211.0, DIAGONAL];
/// The weights of order three.
const EMBEDDED: [f64; STAGES] =
    [4586570599.0 / 29645900160.0, 0.0, 178811875.0 / 945068544.0, 814220225.0 / 1159782912.0, -3700637.0 / 11593932.0, 61727.0 / 225920.0];

/// The weights of the error estimate.
pub(super) fn error_weights() -> [f64; STAGES] {
    std::array::from_fn(|i| WEIGHTS[i] - EMBEDDED[i])
}

/// Σ weights·values.
pub(super) fn dot(weights: &[f64; STAGES], values: &[f64; STAGES]) -> f64 {
    weights.iter().zip(values).map(|(w, v)| w * v).sum()
}

/// Σ_k weights_k of the polynomial through values at some of the stages' times, at another time.
pub(super) fn extrapolation(known: Range<usize>, at: f64) -> [f64; STAGES] {
    std::array::from_fn(|i| {
        if !known.contains(&i) {
            return 0.0;
        }
        known.clone().filter(|&k| k != i).map(|k| (at - TIMES[k]) / (TIMES[i] - TIMES[k])).product()
    })
}

/// J_j, τ_j and the instant compliance 1/β of the chain.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    pub(super) instant: f64,
    /// (J_j, τ_j).
    pub(super) terms: Vec<(f64, f64)>,
}

impl Chain {
    pub(super) fn new(creep: &super::problem::Creep) -> Self {
        let instant = 1.0 / creep.stiffening;
        let terms = if creep.stiffening > 1.0 {
            creep.fractions.iter().zip(&creep.times).map(|(f, &t)| (f * (1.0 - instant), t)).collect()
        } else {
            Vec::new()
        };
        Self { instant, terms }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::needless_range_loop)]
mod tests {
    use super::*;

    #[test]
    fn the_tableau_fulfils_the_conditions_of_order_four() {
        let row = |i: usize, k: usize| {
            if k == i && i > 0 {
                DIAGONAL
            } else if k < i {
                ROWS[i][k]
            } else {
                0.0
            }
        };
        let sum = |f: &dyn Fn(usize) -> f64| (0..STAGES).map(|i| WEIGHTS[i] * f(i)).sum::<f64>();
        let inner = |i: usize, f: &dyn Fn(usize) -> f64| (0..STAGES).map(|k| row(i, k) * f(k)).sum::<f64>();
        for i in 0..STAGES {
            assert!((inner(i, &|_| 1.0) - TIMES[i]).abs() < 1e-15);
        }
        for power in 0..4 {
            assert!((sum(&|i| TIMES[i].powi(power)) - 1.0 / f64::from(power + 1)).abs() < 1e-15);
        }
        assert!((sum(&|i| TIMES[i] * inner(i, &|k| TIMES[k])) - 1.0 / 8.0).abs() < 1e-15);
        assert!((sum(&|i| inner(i, &|k| TIMES[k].powi(2))) - 1.0 / 12.0).abs() < 1e-15);
        assert!((sum(&|i| inner(i, &|k| inner(k, &|l| TIMES[l]))) - 1.0 / 24.0).abs() < 1e-15);
        assert!(error_weights().iter().sum::<f64>().abs() < 1e-15);
    }
}
