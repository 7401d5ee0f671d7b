//! Clausen's integral and the periodic logarithm as a sliding surface remembers them.
//!
//! # Notation
//! ```text
//! 𝓜f(x) = ∫₀^∞ f(x + ζz) e^{−z} dz         the mean over the past of a surface that slides by ζ per retardation time
//! I(x; ζ) = 𝓜Cl₂         I − ζI′ = Cl₂,   e^{imx} ↦ e^{imx}/(1 − imζ),   I → Cl₂ (ζ → 0),  I → Σ cos(mx)/m³/ζ (ζ → ∞)
//! 𝓛(x; ζ) = 𝓜L = −I′     𝓛 − ζ𝓛′ = L = log|2 sin(x/2)|,   I = Cl₂ − ζ𝓛
//! ```
//! | symbol | meaning | range |
//! |---|---|---|
//! | ζ = kvτ | sliding per retardation time, reduced by the wave number; its sign is that of the velocity | −∞ … ∞ |
//! | b = 1/\|ζ\| | decay of the memory per radian | 0 … ∞ |
//! | r | the angle in \[−π, π\] | |
//! | h(b) | Re ψ(1 + ib) + γ, [`super::harmonic_imaginary`] | ≥ 0 |
//!
//! # What it does
//! A negative ζ is the mirror image: I(x; −ζ) = −I(−x; ζ), 𝓛(x; −ζ) = 𝓛(−x; ζ). ζ = 0 gives Cl₂ and L, ζ = ±∞ gives zero. I is finite
//! and not zero at the load: I(0; ζ) = ζ h(1/ζ); it falls from x = 0 as −h x, so relative accuracy as x → 0 is a matter of
//! [`MemoryClausen::increment`] = I(x) − I(0), which is formed without subtraction.
//!
//! # How
//! **Near the load** (|r| ≤ 1.5|ζ|; everywhere if |ζ| ≥ 1): split off the logarithm exactly,
//! ```text
//! 𝓛 = (1 − e^{bx}) log|x| + Σ U_k x^k,          U₀ = −h,  (k+1) U_{k+1} = b(U_k − r_k) + b^{k+1}/(k+1)!
//! I = ζ(e^{bx} − 1 − bx) log|x| + Σ P_k x^k,    P₀ = ζh,  (k+1) P_{k+1} = −U_k − [k ≥ 1] b^k/(k+1)!
//! ```
//! with r_k the Taylor coefficients of log(sin(x/2)/(x/2)). All sums converge within 2π and every part is of the order of the result (as 1/ζ
//! for fast sliding), so nothing cancels but the growth e^{b|x|} ≤ e^π at ζ = 1.
//!
//! **Away from it** (|ζ| < 1): the singular logarithms of the 2N+1 nearest loads have an exact memory W(z), the scaled exponential integral
//! of [`super::exponential_integral`]; what remains is smooth enough for its own expansion in ζ,
//! ```text
//! 𝓛 = L + Σ_{|n|≤N} W(b(x − 2πn)) + Σ_{i≥1} ζ^i d^i/dx^i [ L − Σ_{|n|≤N} log|x − 2πn| ]
//! ```
//! whose smallest term is e^{−(2N+1)π/ζ}: N is chosen to keep that below e^{−40}. The polynomials depend on ζ alone and are made once.
//!
//! # Accuracy (measured on the 176 values of `memory_clausen.csv`, ζ from 1e-8 to 1e8)
//! I: 6e-15 absolute, and relative to the largest |I| of fast sliding, 1.2/ζ. 𝓛: 3e-15 relative to min(1, 1/ζ) + |𝓛|. I(x) − I(0): 6e-15 relative
//! (besides its second zero in the period). The worst is the growth e^{b|x|} at ζ = 1, x → π, where
//! the two expansions differ by 1.2e-14 (I) and 1.4e-14 (𝓛); elsewhere it is 1e-15 to 2e-15.
//! Condition: dI/dx = −𝓛, at most log(1/ζ) + γ in magnitude, so an error of one ulp in x is no loss.
//!
//! Source: derived here. The closed form with ₂F₁(1, i/ζ; 1 + i/ζ; e^{ix}) in thesis Sec 3.3 (third parameter mended) is the same function; it
//! loses 3 log₁₀ζ digits.

use super::angle::Angle;
use super::clausen::clausen;
use super::even_zeta::{EVEN_ZETA, zeta_tail};
use super::exponential_integral::memory_of_logarithm;
use super::harmonic_imaginary::harmonic_on_imaginary_axis;
use super::log_sine::log_sine;
use crate::refusal::Refusal;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Degree of the expansion about a load: at |x| = π the terms halve, and 2^{−56}/56 is 2e-19.
const NEAR_DEGREE: usize = 56;
/// The same for |ζ| < 1, where |x| ≤ 1.5: 0.239^28 = 4e-18, 1.5^28/28! = 3e-25.
const NARROW_DEGREE: usize = 28;
/// Largest b|x| of the expansion about a load when the sliding is slow: e^{1.5} = 4.5 is all it can lose.
const NARROW_REACH: f64 = 1.5;
/// Degree of the smooth remainder; the largest term left out is 48!/(2π·7)^48 = 2e-18, at ζ = 1.
const SMOOTH_DEGREE: usize = 48;
/// Smallest term allowed in an expansion in ζ: e^{−40} = 4e-18.
const SMALLEST_EXPONENT: f64 = 40.0;
/// Loads on each side whose logarithm is averaged exactly: (2N+1)π ≥ 40ζ gives 1 for ζ ≤ 0.23 and 6 for ζ = 1.
const MOST_IMAGES: usize = 6;

/// 2ζ_N(2k)/(2k) (2π)^{−2k} at [N − 1][k − 1]: minus the even Taylor coefficients of L without its 2N+1 nearest logarithms.
static SMOOTH: LazyLock<[[f64; SMOOTH_DEGREE / 2]; MOST_IMAGES]> = LazyLock::new(|| {
    std::array::from_fn(|images| {
        std::array::from_fn(|index| {
            let k = index as u32 + 1;
            zeta_tail(2 * k, images as u32 + 1) / f64::from(k) * (2.0 * PI).powi(-2 * k as i32)
        })
    })
});

/// I(x; ζ) and 𝓛(x; ζ) for one ζ: made once, evaluated at many angles.
#[derive(Debug, Clone, PartialEq)]
pub struct MemoryClausen {
    ratio: f64,
    /// −h(b), the value of 𝓛 at the load.
    at_load: f64,
    regime: Regime,
}

#[derive(Debug, Clone, PartialEq)]
enum Regime {
    /// ζ = 0: no memory.
    Instantaneous,
    /// |ζ| = ∞: the mean over infinitely many periods, which is zero.
    Frozen,
    /// |ζ| ≥ 1.
    Fast(NearLoad),
    /// 0 < |ζ| < 1.
    Slow { near: NearLoad, away: AwayFromLoad },
}

/// The expansion about a load, in the variable x/σ.
#[derive(Debug, Clone, PartialEq)]
struct NearLoad {
    /// |ζ|.
    ratio: f64,
    /// σ = min(1, |ζ|): no power of it overflows.
    scale: f64,
    /// U_k σ^k.
    logarithm: Vec<f64>,
    /// P_k σ^k.
    integral: Vec<f64>,
}

/// The expansion away from the load.
#[derive(Debug, Clone, PartialEq)]
struct AwayFromLoad {
    /// |ζ|.
    ratio: f64,
    /// N.
    images: u32,
    /// Coefficients of the smooth remainder's memory, less the remainder.
    smooth: Vec<f64>,
}

impl MemoryClausen {
    /// Prepares the functions for one sliding ratio ζ = kvτ; zero, negative and infinite ratios are allowed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a NaN.
    pub fn new(ratio: f64) -> Result<Self, Refusal> {
        if ratio.is_nan() {
            return Err(Refusal::out_of_range("ratio", ratio, "a number: the sliding per retardation time"));
        }
        let size = ratio.abs();
        if size == 0.0 {
            return Ok(Self { ratio, at_load: f64::NEG_INFINITY, regime: Regime::Instantaneous });
        }
        if size.is_infinite() {
            return Ok(Self { ratio, at_load: 0.0, regime: Regime::Frozen });
        }
        // A ratio below 1/f64::MAX has no finite inverse; h grows only as its logarithm.
        let at_load =
            if size >= 1e-300 { -harmonic_on_imaginary_axis(1.0 / size) } else { size.ln() - super::exponential_integral::EULER_GAMMA };
        let regime = if size >= 1.0 {
            Regime::Fast(NearLoad::new(size, at_load, NEAR_DEGREE))
        } else {
            Regime::Slow { near: NearLoad::new(size, at_load, NARROW_DEGREE), away: AwayFromLoad::new(size) }
        };
        Ok(Self { ratio, at_load, regime })
    }

    /// ζ, as it was given.
    #[must_use]
    pub const fn ratio(&self) -> f64 {
        self.ratio
    }

    /// I(x; ζ).
    #[must_use]
    pub fn integral(&self, angle: Angle) -> f64 {
        if self.ratio < 0.0 { -self.forward_integral(angle.mirrored()) } else { self.forward_integral(angle) }
    }

    /// I(x; ζ) − I(0; ζ), relative accuracy also as x → 0.
    #[must_use]
    pub fn increment(&self, angle: Angle) -> f64 {
        if self.ratio < 0.0 { -self.forward_increment(angle.mirrored()) } else { self.forward_increment(angle) }
    }

    /// 𝓛(x; ζ); −∞ (never a NaN) at a multiple of 2π if ζ = 0, finite otherwise.
    #[must_use]
    pub fn logarithm(&self, angle: Angle) -> f64 {
        let angle = if self.ratio < 0.0 { angle.mirrored() } else { angle };
        let x = angle.signed();
        match &self.regime {
            Regime::Instantaneous => log_sine(angle),
            Regime::Frozen => 0.0,
            Regime::Fast(near) => near.logarithm(x),
            Regime::Slow { near, away } => {
                if near.reaches(x) {
                    near.logarithm(x)
                } else {
                    log_sine(angle) + away.memory(x)
                }
            }
        }
    }

    /// I(0; |ζ|) = |ζ|h.
    fn integral_at_load(&self) -> f64 {
        match self.regime {
            Regime::Instantaneous | Regime::Frozen => 0.0,
            Regime::Fast(_) | Regime::Slow { .. } => -self.ratio.abs() * self.at_load,
        }
    }

    fn forward_integral(&self, angle: Angle) -> f64 {
        match &self.regime {
            // I − I(0) is added to I(0) only where neither is larger than the sum by more than a small factor.
            Regime::Slow { near, away } if !near.reaches(angle.signed()) => {
                clausen(angle) - near.ratio * (log_sine(angle) + away.memory(angle.signed()))
            }
            _ => self.integral_at_load() + self.forward_increment(angle),
        }
    }

    fn forward_increment(&self, angle: Angle) -> f64 {
        let x = angle.signed();
        match &self.regime {
            Regime::Instantaneous => clausen(angle),
            Regime::Frozen => 0.0,
            Regime::Fast(near) => near.increment(x),
            Regime::Slow { near, away } => {
                if near.reaches(x) {
                    near.increment(x)
                } else {
                    clausen(angle) - near.ratio * (log_sine(angle) + away.memory(x) - self.at_load)
                }
            }
        }
    }
}

impl NearLoad {
    fn new(ratio: f64, at_load: f64, degree: usize) -> Self {
        let scale = ratio.min(1.0);
        // σb and b of the scaled recursion; for slow sliding σb = 1.
        let step = if ratio < 1.0 { 1.0 } else { 1.0 / ratio };
        let mut logarithm = Vec::with_capacity(degree + 1);
        let mut integral = Vec::with_capacity(degree + 1);
        let mut value = at_load;
        // (σb)^k/k! of the exponential, and (σ/2π)^k of the smooth part.
        let (mut exponential, mut power) = (1.0, 1.0);
        integral.push(-ratio * at_load);
        for k in 0..=degree {
            logarithm.push(value);
            let next = (k + 1) as f64;
            // −r_k σ^k = 2ζ(k)/k (σ/2π)^k for even k ≥ 2.
            let smooth = if k >= 2 && k % 2 == 0 { 2.0 * EVEN_ZETA[k / 2 - 1] / k as f64 * power } else { 0.0 };
            let shared = exponential / next;
            let logarithmic_part = if k >= 1 { shared } else { 0.0 };
            integral.push(-scale * (value + logarithmic_part) / next);
            value = step * (value + smooth + shared) / next;
            exponential *= step / next;
            power *= scale / (2.0 * PI);
        }
        integral.truncate(degree + 1);
        Self { ratio, scale, logarithm, integral }
    }

    /// Whether a slow sliding ratio uses this expansion at x.
    fn reaches(&self, x: f64) -> bool {
        x.abs() <= NARROW_REACH * self.ratio
    }

    fn logarithm(&self, x: f64) -> f64 {
        let smooth = horner(&self.logarithm, x / self.scale);
        if x == 0.0 { smooth } else { smooth - (x / self.ratio).exp_m1() * x.abs().ln() }
    }

    fn increment(&self, x: f64) -> f64 {
        if x == 0.0 {
            return 0.0;
        }
        let scaled = x / self.scale;
        scaled * horner(self.integral.get(1..).unwrap_or_default(), scaled)
            + self.ratio * exponential_beyond_line(x / self.ratio) * x.abs().ln()
    }
}

impl AwayFromLoad {
    fn new(ratio: f64) -> Self {
        let images = ((0.5 * (SMALLEST_EXPONENT * ratio / PI - 1.0)).ceil().max(1.0) as usize).min(MOST_IMAGES);
        let table = &SMOOTH[images - 1];
        // q − ζq′ = r for polynomials, less r: d_j = ζ(j+1)(r_{j+1} + d_{j+1}).
        let mut smooth = vec![0.0; SMOOTH_DEGREE];
        let mut above = 0.0;
        for j in (0..SMOOTH_DEGREE).rev() {
            let next = j + 1;
            let remainder = if next % 2 == 0 { -table[next / 2 - 1] } else { 0.0 };
            above = ratio * next as f64 * (remainder + above);
            smooth[j] = above;
        }
        Self { ratio, images: images as u32, smooth }
    }

    /// 𝓛 − L.
    fn memory(&self, x: f64) -> f64 {
        let mut sum = horner(&self.smooth, x);
        for image in (1..=self.images).rev() {
            let turns = 2.0 * PI * f64::from(image);
            sum += memory_of_logarithm((x - turns) / self.ratio) + memory_of_logarithm((x + turns) / self.ratio);
        }
        sum + memory_of_logarithm(x / self.ratio)
    }
}

/// Σ c_k t^k.
fn horner(coefficients: &[f64], t: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient)
}

/// e^z − 1 − z with relative accuracy.
fn exponential_beyond_line(z: f64) -> f64 {
    if z.abs() > 0.7 {
        return z.exp_m1() - z;
    }
    // Σ_{k≥2} z^k/k!: 0.7^16/18! is 5e-19 of the first term.
    let mut term = 0.5 * z * z;
    let mut sum = term;
    for k in 3..18 {
        term *= z / f64::from(k);
        sum += term;
    }
    sum
}
