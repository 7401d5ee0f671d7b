//! A rigid sinusoidal wave pressed against an elastic half-plane without adhesion.
//!
//! ```text
//!                  p̄ ↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓↓
//!      rigid wave  Λ cos kx                          (crest down)
//!   ´`.          ,-----.          ,-----.
//!      `-.    ,-´       `-.    ,-´
//!    _____`--´_____   _____`--´_____   half-plane
//!        |<-2a->|
//!        |<------- λ ------>|          2b = λ − 2a: the gap
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | E* | `contact_modulus`: E/(1 − ν²) in plane strain, E in plane stress ([`super::plane_modulus`]) | Pa |
//! | λ, k | `wavelength`, wavenumber 2π/λ | m, 1/m |
//! | Λ | `amplitude`: half the height between trough and crest | m |
//! | a | `contact_half_width`, 0 … λ/2 | m |
//! | b | `gap_half_width` = λ/2 − a | m |
//! | p̄ | `mean_pressure` over a whole wavelength | Pa |
//! | p* | `full_contact_pressure` = E*kΛ/2 | Pa |
//! | Δ | `penetration`: of the crest below the mean plane of the deformed surface | m |
//! | s, T | sin(ka/2), tan(ka/2) | – |
//!
//! Equations: p̄/p* = s², Δ/Λ = s²(1 − 2 ln s), in contact p(x) = 2p* cos(kx/2)√(s² − sin²(kx/2)) and w = Λ(cos kx − 1) + Δ,
//! outside a gap Λs²(sinh 2η − 2η) with sinh η = √(sin²(kx/2)/s² − 1).
//! Source: Westergaard, J. Appl. Mech. 6 (1939) A49; Johnson, *Contact Mechanics* (1985), Sec 13.2.
//!
//! The half-plane has no depth scale, so its uniform compression is unbounded and left out: w has zero mean, Δ = Λ is full contact,
//! and beyond p* the contact stays full and Δ stays Λ.
//!
//! # How good
//! T is the working variable and both half-widths come from it, 2·atan(T)/k and 2·atan(1/T)/k: relative error below 1e-15 in a as s → 0 and in
//! b as a → λ/2, for a given mean pressure as far as p* − p̄ is known (an ulp of p̄ is 1e-16·p*/(p* − p̄) of b²). Given Δ close to Λ, an ulp of Δ moves
//! b² by 1e-16/(1 − Δ/Λ)^{1/2} of Λ-units: use the pressure or the width there. Each state carries its bound.
//!
//! Range: kΛ ≪ 1, frictionless (or incompressible) contact.

use crate::continuation::signed_root::signed_root;
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use std::f64::consts::PI;

/// A rigid wave on an elastic half-plane, no adhesion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WestergaardWave {
    contact_modulus: f64,
    wavelength: f64,
    amplitude: f64,
}

/// One equilibrium of a wave, adhesive or not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveState {
    /// Half the width of each contact; half a wavelength in full contact.
    pub contact_half_width: f64,
    /// Half the width of each gap; zero in full contact.
    pub gap_half_width: f64,
    /// Mean pressure over a wavelength, compression positive.
    pub mean_pressure: f64,
    /// Depth of the crest below the mean plane of the deformed surface; the amplitude in full contact.
    pub penetration: f64,
    /// Bound on the relative error of the two half-widths from rounding, the last bit of the imposed value included.
    pub relative_error: f64,
}

impl WaveState {
    /// Whether no gap is left.
    #[must_use]
    pub fn is_full_contact(&self) -> bool {
        self.gap_half_width <= 0.0
    }
}

impl WestergaardWave {
    /// A wave of the given length and amplitude (m; half the height from trough to crest).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an argument that is not finite and positive.
    pub fn new(contact_modulus: f64, wavelength: f64, amplitude: f64) -> Result<Self, Refusal> {
        Ok(Self {
            contact_modulus: require_positive("contact_modulus", contact_modulus)?,
            wavelength: require_positive("wavelength", wavelength)?,
            amplitude: require_positive("amplitude", amplitude)?,
        })
    }

    /// The contact modulus E* (Pa).
    #[must_use]
    pub const fn contact_modulus(&self) -> f64 {
        self.contact_modulus
    }

    /// The wavelength λ (m).
    #[must_use]
    pub const fn wavelength(&self) -> f64 {
        self.wavelength
    }

    /// The amplitude Λ (m).
    #[must_use]
    pub const fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// The wavenumber k = 2π/λ.
    #[must_use]
    pub fn wavenumber(&self) -> f64 {
        2.0 * PI / self.wavelength
    }

    /// The mean pressure (Pa) that closes the gap without adhesion: p* = E*kΛ/2 = πE*Λ/λ.
    #[must_use]
    pub fn full_contact_pressure(&self) -> f64 {
        PI * self.contact_modulus * (self.amplitude / self.wavelength)
    }

    /// The state with a given contact half-width (m).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside 0 ≤ a ≤ λ/2.
    pub fn state_by_contact_half_width(&self, contact_half_width: f64) -> Result<WaveState, Refusal> {
        self.checked_half_width("contact_half_width", contact_half_width)?;
        let edge = self.edge(contact_half_width);
        Ok(WaveState { contact_half_width, ..self.state(edge, f64::EPSILON) })
    }

    /// The state with a given gap half-width b = λ/2 − a (m): the way in when the contact is almost full.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside 0 ≤ b ≤ λ/2.
    pub fn state_by_gap_half_width(&self, gap_half_width: f64) -> Result<WaveState, Refusal> {
        self.checked_half_width("gap_half_width", gap_half_width)?;
        let edge = self.edge(gap_half_width).turned();
        Ok(WaveState { gap_half_width, ..self.state(edge, f64::EPSILON) })
    }

    /// The state under a given mean pressure (Pa); full contact from p* on.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative pressure: without adhesion nothing pulls back.
    pub fn state_by_mean_pressure(&self, mean_pressure: f64) -> Result<WaveState, Refusal> {
        let pressure = require_non_negative("mean_pressure", mean_pressure)?;
        let full = self.full_contact_pressure();
        let left = full - pressure;
        let edge = if left > 0.0 { Edge { tangent: (pressure / left).sqrt() } } else { Edge::FULL };
        // p* carries three roundings, which the difference magnifies by p*/(p* − p̄).
        let error = if left > 0.0 { 2.0 * f64::EPSILON * (1.0 + full / left) } else { 0.0 };
        Ok(WaveState { mean_pressure: pressure, ..self.state(edge, error) })
    }

    /// The state at a given penetration, 0 … Λ.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside 0 ≤ Δ ≤ Λ.
    pub fn state_by_penetration(&self, penetration: f64) -> Result<WaveState, Refusal> {
        if !(0.0..=self.amplitude).contains(&penetration) {
            return Err(Refusal::out_of_range("penetration", penetration, "between zero and the amplitude"));
        }
        let fraction = penetration / self.amplitude;
        let missing = (self.amplitude - penetration) / self.amplitude;
        if fraction <= 0.0 || missing <= 0.0 {
            let edge = if missing <= 0.0 { Edge::FULL } else { Edge { tangent: 0.0 } };
            return Ok(WaveState { penetration, ..self.state(edge, 0.0) });
        }
        // (1 + x)e^{−x} = Δ/Λ with x = −2 ln s; the far end follows from (2L + 5)e^{−4} < e^{L}, L = −ln(Δ/Λ).
        let far = 4.0 - 2.0 * fraction.ln();
        let start = if missing < 0.5 { (2.0 * missing).sqrt() } else { 1.0 - fraction.ln() };
        let x = signed_root("the contact width of a wave at a given penetration", far, 0.0, start.min(0.5 * far), |x| {
            let value = if missing < 0.5 { missing - missing_penetration(x) } else { (1.0 + x) * (-x).exp() - fraction };
            (value, -x * (-x).exp())
        })?;
        // T² = s²/c² = 1/(eˣ − 1). An error e of Δ/Λ moves x by e·eˣ/x and ln T by half of that over 1 − e^{−x}; the last bit of x moves ln T by half.
        let tangent = 1.0 / x.exp_m1().sqrt();
        let error = f64::EPSILON * (2.0 * (1.0 + x) / (x * -(-x).exp_m1()) + x);
        Ok(WaveState { penetration, ..self.state(Edge { tangent }, error) })
    }

    /// The pressure (Pa) at a distance `position` (m) from the middle of a contact of a given half-width; zero in the gap.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a half-width outside 0 … λ/2 or a position that is not within half a wavelength of the middle.
    pub fn pressure(&self, contact_half_width: f64, position: f64) -> Result<f64, Refusal> {
        self.checked_half_width("contact_half_width", contact_half_width)?;
        let distance = self.checked_half_width("position", position.abs())?;
        if distance >= contact_half_width {
            return Ok(0.0);
        }
        let half = 0.5 * self.wavenumber() * distance;
        require_finite("pressure", 2.0 * self.full_contact_pressure() * half.cos() * self.chord(contact_half_width, distance))
    }

    /// The gap (m) at a distance `position` (m) from the middle of a contact of a given half-width; zero in the contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a half-width outside 0 … λ/2 or a position that is not within half a wavelength of the middle.
    pub fn gap(&self, contact_half_width: f64, position: f64) -> Result<f64, Refusal> {
        let (opening, _) = self.gap_parts(contact_half_width, position)?;
        require_finite("gap", self.amplitude * opening)
    }

    /// (s²(sinh 2η − 2η), η) outside the contact, zeros inside: the Westergaard gap and the shape that adhesion adds to it.
    pub(super) fn gap_parts(&self, contact_half_width: f64, position: f64) -> Result<(f64, f64), Refusal> {
        self.checked_half_width("contact_half_width", contact_half_width)?;
        let distance = self.checked_half_width("position", position.abs())?;
        if distance <= contact_half_width {
            return Ok((0.0, 0.0));
        }
        let rise = self.chord(contact_half_width, distance);
        let sine = (0.5 * self.wavenumber() * contact_half_width).sin();
        let eta = (rise / sine).asinh();
        let opening = if eta < 0.5 {
            // s²Σ_{k≥1}(2η)^{2k+1}/(2k+1)!: nine terms leave 1e-18 of the first at 2η = 1.
            let square = 4.0 * eta * eta;
            let (mut term, mut sum) = (2.0 * eta, 0.0);
            for k in 1..=9_u32 {
                let n = 2.0 * f64::from(k);
                term *= square / (n * (n + 1.0));
                sum += term;
            }
            sine * sine * sum
        } else {
            2.0 * rise * (0.5 * self.wavenumber() * distance).sin() - if sine > 0.0 { 2.0 * sine * sine * eta } else { 0.0 }
        };
        Ok((opening, eta))
    }

    /// √|s² − sin²(kx/2)| as a product of sines, so that nothing cancels next to the edge.
    pub(super) fn chord(&self, contact_half_width: f64, distance: f64) -> f64 {
        let quarter = 0.5 * self.wavenumber();
        let difference = (quarter * (contact_half_width - distance).abs()).sin();
        // sin(k(a + |x|)/2) through the complement when both are near λ/2, where the angle passes π/2 on its way to π.
        let sum = contact_half_width + distance;
        let rest = (0.5 * self.wavelength - contact_half_width) + (0.5 * self.wavelength - distance);
        let total = if sum < rest { (quarter * sum).sin() } else { (quarter * rest).sin() };
        (difference * total).max(0.0).sqrt()
    }

    /// Refuses a length outside 0 … λ/2.
    pub(super) fn checked_half_width(&self, quantity: &'static str, value: f64) -> Result<f64, Refusal> {
        if (0.0..=0.5 * self.wavelength).contains(&value) {
            Ok(value)
        } else {
            Err(Refusal::out_of_range(quantity, value, "between zero and half a wavelength"))
        }
    }

    /// The edge of a contact of half-width a, the complement taken for the wider half of the range.
    pub(super) fn edge(&self, contact_half_width: f64) -> Edge {
        let quarter = 0.25 * self.wavelength;
        if contact_half_width <= quarter {
            Edge { tangent: (0.5 * self.wavenumber() * contact_half_width).tan() }
        } else {
            Edge { tangent: 1.0 / (0.5 * self.wavenumber() * (0.5 * self.wavelength - contact_half_width)).tan() }
        }
    }

    /// The adhesionless state of an edge.
    fn state(&self, edge: Edge, relative_error: f64) -> WaveState {
        WaveState {
            contact_half_width: edge.contact_half_width(self.wavelength),
            gap_half_width: edge.turned().contact_half_width(self.wavelength),
            mean_pressure: self.full_contact_pressure() * edge.sine_squared(),
            penetration: self.amplitude * edge.penetration_fraction(),
            relative_error: relative_error + 2.0 * f64::EPSILON,
        }
    }
}

/// The place of a contact edge, as T = tan(ka/2) in 0 … ∞: relative accuracy in T is relative accuracy in a and in the gap.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) tangent: f64,
}

impl Edge {
    pub(super) const FULL: Self = Self { tangent: f64::INFINITY };

    /// Contact and gap exchanged.
    pub(super) fn turned(self) -> Self {
        Self { tangent: 1.0 / self.tangent }
    }

    /// s² = T²/(1 + T²).
    pub(super) fn sine_squared(self) -> f64 {
        if self.tangent < 1.0 {
            self.tangent * self.tangent * self.turned().sine_squared()
        } else {
            1.0 / (1.0 + (1.0 / self.tangent).powi(2))
        }
    }

    /// 1 − s² = 1/(1 + T²).
    pub(super) fn cosine_squared(self) -> f64 {
        self.turned().sine_squared()
    }

    /// x = −2 ln s = ln(1 + 1/T²).
    pub(super) fn depth(self) -> f64 {
        if self.tangent < 1.0 {
            (self.tangent * self.tangent).ln_1p() - 2.0 * self.tangent.ln()
        } else {
            (1.0 / self.tangent).powi(2).ln_1p()
        }
    }

    /// s²(1 − 2 ln s).
    pub(super) fn penetration_fraction(self) -> f64 {
        if self.tangent > 0.0 { self.sine_squared() * (1.0 + self.depth()) } else { 0.0 }
    }

    pub(super) fn contact_half_width(self, wavelength: f64) -> f64 {
        wavelength / PI * self.tangent.atan()
    }
}

/// 1 − (1 + x)e^{−x}, the part of the amplitude still missing to full contact, to full relative accuracy for x ≥ 0.
pub(super) fn missing_penetration(x: f64) -> f64 {
    if x > 0.5 {
        // The result is at least 0.09: less than one digit lost.
        return 1.0 - (1.0 + x) * (-x).exp();
    }
    // Σ_{n≥2} (−1)^n (n − 1)xⁿ/n!: fifteen terms leave 1e-17 of the first at x = 0.5.
    let (mut power, mut sum) = (-x, 0.0);
    for n in 2..=16_u32 {
        let n = f64::from(n);
        power *= -x / n;
        sum += (n - 1.0) * power;
    }
    sum
}
