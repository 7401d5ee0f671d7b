//! The two indenters, as far as the fields of a contact differ between them.
//!
//! Everything is written in half arguments. The parabola is the wave of vanishing wave number in lengths of any other unit: of the half sine
//! remains x/2, of the half cosine 1, and the next period is infinitely far away.

use std::f64::consts::PI;

/// The rigid body that slides.
///
/// | reduced quantity | [`Indenter::Wave`] Λcos kx | [`Indenter::Parabola`] x²/2R, lengths in any L |
/// |---|---|---|
/// | lengths along the surface | 1/k | L |
/// | displacements, penetration | Λ | L²/R |
/// | pressures and stresses | E0*kΛ/2 | E0*L/2R |
/// | rate | kv | v/L |
/// | adhesion Γ | Δγ/(πE0*kΛ²) | ΔγR²/(πE0*L³) |
/// | mean pressure | mean over a wavelength | F/2πL for a load F per width, in E0*L/2R |
/// | friction stress | E0*k²Λ²/2, mean over a wavelength | force per width over 2πL, in E0*L²/2R² |
/// | energies per width (U, δL_P) | E0*Λ²/2 | E0*L⁴/2R² |
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Indenter {
    /// A sinusoidal wave on a half-plane.
    Wave,
    /// One parabola (a long cylinder): the wave as k → 0 at fixed 1/R = k²Λ. Penetrations are relative to a datum L away, and a moved edge
    /// keeps the load: at fixed penetration an infinitely compliant half-plane does so by itself.
    Parabola,
}

impl Indenter {
    /// sin(x/2) and cos(x/2).
    pub(super) fn half_sine_cosine(self, x: f64) -> (f64, f64) {
        match self {
            Self::Wave => (0.5 * x).sin_cos(),
            Self::Parabola => (0.5 * x, 1.0),
        }
    }

    /// sin e and cos e of an eccentricity.
    pub(super) fn shift(self, eccentricity: f64) -> (f64, f64) {
        match self {
            Self::Wave => eccentricity.sin_cos(),
            Self::Parabola => (eccentricity, 1.0),
        }
    }

    /// cos of half the sum of two arguments given by their half sines and cosines.
    pub(super) fn cosine_of_sum(self, first: (f64, f64), second: (f64, f64)) -> f64 {
        match self {
            Self::Wave => first.1 * second.1 - first.0 * second.0,
            Self::Parabola => 1.0,
        }
    }

    /// s² cos(a/2), the size of a pressure of the wave or parabola at a half-width a.
    #[must_use]
    pub fn half_angle_scale(self, half_width: f64) -> f64 {
        let (sine, cosine) = self.half_sine_cosine(half_width);
        sine * sine * cosine
    }

    /// The largest half-width, which is that of full contact.
    #[must_use]
    pub const fn widest(self) -> f64 {
        match self {
            Self::Wave => PI,
            Self::Parabola => f64::INFINITY,
        }
    }

    /// H₀, H₁ and cos e W − sin e S from (sin(y/2), cos(y/2)), X and (sin e, cos e).
    pub(super) fn pressures(self, (sine, cosine): (f64, f64), root: f64, (sin_e, cos_e): (f64, f64)) -> [f64; 3] {
        [cosine / root, sine / root, cos_e * cosine * root - sin_e * self.slope((sine, cosine), root)]
    }

    /// S = −W′ from (sin(y/2), cos(y/2)) and X.
    pub(super) fn slope(self, (sine, cosine): (f64, f64), root: f64) -> f64 {
        match self {
            // S = ½ sin(y/2) X + cos(y/2) sin y/X.
            Self::Wave => 0.5 * sine * root + 2.0 * cosine * cosine * sine / root,
            Self::Parabola => 2.0 * sine / root,
        }
    }

    /// Gap of cos e W − sin e S, and depth asinh(|X|/2s) of H₀, outside the contact.
    pub(super) fn gaps(self, (sine, cosine): (f64, f64), root: f64, s: f64, (sin_e, cos_e): (f64, f64)) -> (f64, f64) {
        let depth = inverse_hyperbolic_sine(0.5 * root / s);
        (cos_e * (sine * root - 2.0 * s * s * depth) + sin_e * cosine * root, depth)
    }
}

/// asinh of a number that is not negative, to 2 ulp; the standard one takes a hypotenuse and twice the time.
pub(super) fn inverse_hyperbolic_sine(x: f64) -> f64 {
    (x + x * x / (1.0 + (1.0 + x * x).sqrt())).ln_1p()
}
