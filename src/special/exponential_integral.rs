//! The exponential integral of a logarithm that is averaged with a fading memory.
//!
//! ```text
//! ∫₀^∞ e^{−t} log|z + t| dt = log|z| + W(z)
//! W(z) =  e^z E₁(z)       z > 0      (the logarithm's zero lies behind)        W ≈ 1/z − 1/z² + …  as |z| → ∞
//! W(z) = −e^{−y} Ei(y)    z = −y < 0 (the logarithm's zero lies ahead)         W ≈ −γ − log|z|     as z → 0
//! ```
//! | range | method | work |
//! |---|---|---|
//! | z > 0 | Stieltjes continued fraction from the back | 12 + 90/z divisions |
//! | −40 < z < 0 | γ + log y + Σ y^k/(k k!), positive terms | 40 + 2y terms |
//! | z ≤ −40 | asymptotic series to its smallest term | ≤ 40 terms |
//!
//! Meant for |z| ≥ 1, where its largest relative error is 2e-15 (at z < 0; 5e-16 at z > 0), except within 1e-2 of nothing: W has no
//! zero there. Sources: DLMF 6.2.1, 6.2.5, 6.6.1, 6.9.1, 6.12.1–6.12.2.

/// Euler's constant γ.
pub(crate) const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// From here the smallest term of the asymptotic series is e^{−40} = 4e-18 of the sum.
const ASYMPTOTIC_FROM: f64 = 40.0;

/// W(z) for z ≠ 0; 0 at ±∞, +∞ at 0.
#[must_use]
pub fn memory_of_logarithm(z: f64) -> f64 {
    if z.is_infinite() {
        0.0
    } else if z > 0.0 {
        behind(z)
    } else if z > -ASYMPTOTIC_FROM {
        ahead_near(-z)
    } else {
        ahead_far(-z)
    }
}

/// e^z E₁(z) = 1/(z + 1 − 1/(z + 3 − 4/(z + 5 − …))).
fn behind(z: f64) -> f64 {
    if z == 0.0 {
        return f64::INFINITY;
    }
    // The truncation error falls as e^{−4√(n z)}; 90/z gives e^{−37}.
    let levels = (12.0 + 90.0 / z).min(1e6) as u32;
    let mut tail = 0.0;
    for level in (1..=levels).rev() {
        let k = f64::from(level);
        tail = k * k / (z + (2.0 * k + 1.0) - tail);
    }
    1.0 / (z + 1.0 - tail)
}

fn ahead_near(y: f64) -> f64 {
    let terms = 40 + (2.0 * y) as u32;
    let mut power = 1.0;
    let mut sum = 0.0;
    for index in 1..=terms {
        let k = f64::from(index);
        power *= y / k;
        let term = power / k;
        sum += term;
        if term < 1e-18 * sum {
            break;
        }
    }
    -(-y).exp() * (EULER_GAMMA + y.ln() + sum)
}

fn ahead_far(y: f64) -> f64 {
    let inverse = 1.0 / y;
    let mut term = inverse;
    let mut sum = term;
    for index in 1..=40 {
        let next = term * f64::from(index) * inverse;
        if next >= term || next < 1e-18 * sum {
            break;
        }
        term = next;
        sum += term;
    }
    -sum
}
