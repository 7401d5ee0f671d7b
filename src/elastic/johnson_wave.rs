//! A rigid sinusoidal wave on an elastic half-plane, with adhesion of zero range.
//!
//! ```text
//!   p̄/p* ^
//!      1 |- - - - - - - - - - - -
//!        |            S               S: snap-in into full contact (load held)
//!        |          ,´ `.             P: pull-off (load held)
//!        |        ,´     \            narrow: left of P, unstable
//!      0 o------,´--------\----->     stable: P to S
//!        | \  ,´           \   ka/2   wide:   right of S, unstable; falls to −∞
//!        |  `P              |
//!        0        π/4      π/2
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | E*, λ, k, Λ, p*, a, b, p̄, Δ, s, T | as in [`super::westergaard_wave`] | |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | α | `adhesion_parameter` = (√2/π)(λ/Λ)√(Δγ/(E*λ)) = √(2E*Δγ/λ)/p* | – |
//! | K | `stress_intensity_factor` of an edge | Pa√m |
//! | ξ | ln T | – |
//! | x | −2 ln s | – |
//!
//! Equations: p̄/p* = s² − α√T, Δ/Λ = s²(1 − 2 ln s) + 2α√T ln s (in the groups of the sliding problem α = 2√Γ);
//! in contact p/p* = 2cos(kx/2)√(s² − sin²(kx/2)) − α√T cos(kx/2)/√(s² − sin²(kx/2)); outside the gap of Westergaard plus 2Λα√T·η;
//! K = (p*s² − p̄)√(λ/T), and G = K²/(2E*) at each of the two edges.
//! Source: Johnson, Int. J. Solids Struct. 32 (1995) 423, [10.1016/0020-7683(94)00111-9](https://doi.org/10.1016/0020-7683(94)00111-9);
//! the penetration is thesis Ch. 3 in its elastic limit.
//!
//! # Extrema of the mean pressure
//! dp̄/da = 0 reads α = 4T^{3/2}/(1 + T²)². The right side has one maximum, 4(3/5)^{3/4}/(8/5)² = 1.0652 at T² = 3/5
//! ([`PARTIAL_CONTACT_LIMIT`]): below it there are two extrema, P (minimum) with T² < 3/5 and S (maximum) with T² > 3/5, where
//! p̄/p* = T²(T² − 3)/(1 + T²)². S lies at p̄ = 0 when T = √3, ka/2 = π/3, so
//! at α = 3/(4·3^{1/4}) = 0.5699 ([`SPONTANEOUS_FULL_CONTACT`]): from there on an unloaded wave closes by itself. Between the two values
//! a stable partial contact still exists, but only under tension; above the second none does. Under
//! penetration control dp̄ is replaced by dΔ: there is one fold, always with T < 0.15 (a below 5 % of λ), and every wider contact is stable, for any α.
//!
//! # How good
//! The extrema solve ¾h = ln(1 + ⅜(e^{2h} − 1)) + ½ln(α/1.0652) for the distance h from ln√(3/5), Newton from outside, monotone: relative error of T below
//! 2e-15 for α < 0.9, and 1e-16/√(1 − α/1.0652) at the merger. The inverses solve for ln T in a bracket, with the residual formed from the
//! complements 1 − p̄/p* or 1 − Δ/Λ and 1 − s² when T > 1, so that narrow contacts and narrow gaps keep their digits (below 1e-14 in a and b,
//! measured against 50 digits) as far as the input has them. Each state carries its bound; at P, S and the fold it grows to 1e-8.
//!
//! Range: kΛ ≪ 1; range of adhesion small against the height of the gap; no trapped air. Full contact holds any tension in this
//! picture: nothing here says when it fails, for it has no edge (Johnson 1995 needs a flaw).

use super::control::{Control, EquilibriumBranch};
use super::westergaard_wave::{Edge, WaveState, WestergaardWave, missing_penetration};
use crate::continuation::signed_root::signed_root;
use crate::refusal::{Refusal, require_finite, require_positive};

/// The adhesion parameter from which an unloaded wave closes by itself: 3/(4·3^{1/4}), reached at ka/2 = π/3.
pub const SPONTANEOUS_FULL_CONTACT: f64 = 0.569_876_764_238_694;

/// The adhesion parameter from which no partial contact is stable under load control, not even in tension: 4(3/5)^{3/4}/(8/5)².
pub const PARTIAL_CONTACT_LIMIT: f64 = 1.065_205_656_063_280_7;

/// Which of the three equilibria at one mean pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WaveBranch {
    /// Narrower than at pull-off: unstable, between pull-off and zero pressure.
    Narrow,
    /// Between pull-off and snap-in: stable under load control.
    Stable,
    /// Wider than at snap-in: unstable, exists at any pressure below snap-in; its gap is the one full contact must open to fail.
    Wide,
}

/// A rigid wave adhering to an elastic half-plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JohnsonWave {
    wave: WestergaardWave,
    work_of_adhesion: f64,
    adhesion_parameter: f64,
}

impl JohnsonWave {
    /// Adds a work of adhesion (J/m²) to a wave.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a work of adhesion that is not finite and positive; without adhesion use the wave itself.
    pub fn new(wave: WestergaardWave, work_of_adhesion: f64) -> Result<Self, Refusal> {
        let work_of_adhesion = require_positive("work_of_adhesion", work_of_adhesion)?;
        let toughness = (2.0 * wave.contact_modulus()).sqrt() * work_of_adhesion.sqrt();
        let parameter = toughness / wave.wavelength().sqrt() / wave.full_contact_pressure();
        Ok(Self { wave, work_of_adhesion, adhesion_parameter: require_positive("adhesion_parameter", parameter)? })
    }

    /// The same wave without adhesion.
    #[must_use]
    pub const fn without_adhesion(&self) -> &WestergaardWave {
        &self.wave
    }

    /// The work of adhesion Δγ.
    #[must_use]
    pub const fn work_of_adhesion(&self) -> f64 {
        self.work_of_adhesion
    }

    /// Johnson's α, a number.
    #[must_use]
    pub const fn adhesion_parameter(&self) -> f64 {
        self.adhesion_parameter
    }

    /// Whether an unloaded wave closes by itself: α at or above [`SPONTANEOUS_FULL_CONTACT`].
    #[must_use]
    pub fn closes_spontaneously(&self) -> bool {
        self.adhesion_parameter >= SPONTANEOUS_FULL_CONTACT
    }

    /// The equilibrium with a given contact half-width, stable or not.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside 0 < a < λ/2: full contact has no edge.
    pub fn state_by_contact_half_width(&self, contact_half_width: f64) -> Result<WaveState, Refusal> {
        require_positive("contact_half_width", contact_half_width)?;
        self.wave.checked_half_width("contact_half_width", contact_half_width)?;
        let edge = self.wave.edge(contact_half_width);
        if edge.tangent.is_infinite() {
            return Err(Refusal::out_of_range(
                "contact_half_width",
                contact_half_width,
                "below half a wavelength: full contact has no edge",
            ));
        }
        Ok(WaveState { contact_half_width, ..self.state(edge.tangent.ln(), f64::EPSILON)? })
    }

    /// The state of largest tension on the stable branch under load control, or of lowest penetration under penetration control:
    /// where the contact is lost.
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] under load control when α ≥ [`PARTIAL_CONTACT_LIMIT`].
    pub fn pull_off(&self, control: Control) -> Result<WaveState, Refusal> {
        match control {
            Control::Load => self.extremum(-1.0),
            Control::Penetration => self.state(self.penetration_fold()?, 8.0 * f64::EPSILON),
        }
    }

    /// The state of largest mean pressure in partial contact: beyond it the gap closes.
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] when α ≥ [`PARTIAL_CONTACT_LIMIT`].
    pub fn snap_in(&self) -> Result<WaveState, Refusal> {
        self.extremum(1.0)
    }

    /// The equilibrium under a given mean pressure (Pa, compression positive).
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] outside the range of the branch, with the limit; [`Refusal::OutOfRange`] for a pressure that is not
    /// finite.
    pub fn state_by_mean_pressure(&self, mean_pressure: f64, branch: WaveBranch) -> Result<WaveState, Refusal> {
        let pressure = require_finite("mean_pressure", mean_pressure)?;
        let full = self.wave.full_contact_pressure();
        let fraction = pressure / full;
        let missing = (full - pressure) / full;
        let alpha = self.adhesion_parameter;
        let refuse = |reason: &str, limit_name: &'static str, limit: f64| {
            Err(Refusal::NoSuchState { reason: format!("at this mean pressure {reason}"), limit_name, limit })
        };
        // Each branch as (ξ where the residual p̄(ξ) − p̄ is negative, ξ where it is positive). The outer ends come from dropping one term:
        // p̄(T) > p̄ at √T = −p̄/α for p̄ < 0, and p̄(T) < p̄ at √T = (1 − p̄)/α.
        let (below, above) = if alpha >= PARTIAL_CONTACT_LIMIT {
            if branch != WaveBranch::Wide {
                return refuse(
                    "adhesion is so strong that every partial contact is unstable",
                    "the adhesion parameter above which that holds",
                    PARTIAL_CONTACT_LIMIT,
                );
            }
            if fraction >= 0.0 {
                return refuse("the wave is in full contact", "the pressure of the last partial contact", 0.0);
            }
            (2.0 * (missing / alpha).ln(), 2.0 * (-fraction / alpha).ln())
        } else {
            let (pull_off, snap_in) = (self.extremum_place(-1.0), self.extremum_place(1.0));
            let (lowest, highest) = (extremal_fraction(pull_off), extremal_fraction(snap_in));
            if branch != WaveBranch::Narrow && pressure > full * highest {
                return refuse("the gap has closed", "the mean pressure of snap-in", full * highest);
            }
            if branch != WaveBranch::Wide && pressure < full * lowest {
                return refuse("the contact has come off", "the mean pressure of pull-off", full * lowest);
            }
            match branch {
                WaveBranch::Narrow if fraction >= 0.0 => {
                    return refuse("no narrow unstable contact exists", "the pressure at which it shrinks to a line", 0.0);
                }
                WaveBranch::Narrow => (pull_off, 2.0 * (-fraction / alpha).ln()),
                WaveBranch::Stable => (pull_off, snap_in),
                WaveBranch::Wide => (2.0 * (missing / alpha).ln(), snap_in),
            }
        };
        let place = signed_root("the contact width of an adhesive wave", below, above, 0.5 * (below + above), |place| {
            let value = if place > 0.0 {
                missing - (Edge { tangent: place.exp() }.cosine_squared() + alpha * (0.5 * place).exp())
            } else {
                Edge { tangent: place.exp() }.sine_squared() - alpha * (0.5 * place).exp() - fraction
            };
            (value, self.pressure_slopes(place).0)
        })?;
        // Rounding of the residual, then divided by its slope, or by the root of its curvature at a fold, or the cube root at the merger.
        let suction = alpha * (0.5 * place).exp();
        let size = if place > 0.0 { missing.abs() + suction } else { fraction.abs() + suction };
        let error = newton_error(4.0 * f64::EPSILON * (size + fraction.abs()), self.pressure_slopes(place));
        Ok(WaveState { mean_pressure: pressure, ..self.state(place, error)? })
    }

    /// The equilibrium at a given penetration.
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] below the fold, on the unstable branch from zero on, and from the amplitude on (full contact).
    pub fn state_by_penetration(&self, penetration: f64, branch: EquilibriumBranch) -> Result<WaveState, Refusal> {
        let penetration = require_finite("penetration", penetration)?;
        let amplitude = self.wave.amplitude();
        let alpha = self.adhesion_parameter;
        let fraction = penetration / amplitude;
        let missing = (amplitude - penetration) / amplitude;
        let refuse = |reason: &str, limit_name: &'static str, limit: f64| {
            Err(Refusal::NoSuchState { reason: format!("at this penetration {reason}"), limit_name, limit })
        };
        if missing <= 0.0 {
            return refuse("the wave is in full contact", "the penetration of full contact", amplitude);
        }
        let fold = self.penetration_fold()?;
        let lowest = self.penetration_fraction(fold);
        if penetration < amplitude * lowest {
            return refuse("the contact has come off", "the lowest penetration in contact", amplitude * lowest);
        }
        let (below, above) = match branch {
            // Δ/Λ ≥ 1 − 1/(2T⁴) − α/T^{3/2}: each of the two below half of what is missing.
            EquilibriumBranch::Stable => (fold, (-0.25 * missing.ln()).max(2.0 / 3.0 * (2.0 * alpha / missing).ln()).max(fold)),
            EquilibriumBranch::Unstable if fraction >= 0.0 => {
                return refuse(
                    "the only equilibrium is the stable one",
                    "the penetration at which the unstable contact shrinks to a line",
                    0.0,
                );
            }
            // α√T·x < 4αT^{1/4} for small T, because √T·ln(1/T²) peaks against T^{1/4} at 8/e.
            EquilibriumBranch::Unstable => (fold, (4.0 * (-fraction / (4.0 * alpha)).ln()).min(fold)),
        };
        let place =
            signed_root("the contact width of an adhesive wave at a given penetration", below, above, 0.5 * (below + above), |place| {
                let value = if place > 0.0 { missing - self.missing_fraction(place) } else { self.penetration_fraction(place) - fraction };
                (value, self.penetration_slope(place))
            })?;
        let edge = Edge { tangent: place.exp() };
        let pull = alpha * (0.5 * place).exp() * edge.depth();
        let size = if place > 0.0 { missing + pull } else { 2.0 * edge.penetration_fraction() + pull };
        // Near the fold, deep inside the narrow contacts, the second derivative is about a quarter of α√T·x.
        let error = newton_error(4.0 * f64::EPSILON * (size + fraction.abs()), (self.penetration_slope(place), 0.25 * pull, 0.0));
        Ok(WaveState { penetration, ..self.state(place, error)? })
    }

    /// Whether a state stays where it is under a control. At an extremum it does not. Full contact always does.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] if the fold of the penetration is not found.
    pub fn is_stable(&self, state: &WaveState, control: Control) -> Result<bool, Refusal> {
        if state.is_full_contact() {
            return Ok(true);
        }
        let place = self.wave.edge(state.contact_half_width).tangent.ln();
        Ok(match control {
            Control::Load if self.adhesion_parameter >= PARTIAL_CONTACT_LIMIT => false,
            Control::Load => place > self.extremum_place(-1.0) && place < self.extremum_place(1.0),
            Control::Penetration => place > self.penetration_fold()?,
        })
    }

    /// The stress intensity factor of each edge at any contact half-width and mean pressure, in equilibrium or not; negative when
    /// the edge is pressed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] outside 0 < a < λ/2, or for a pressure that is not finite.
    pub fn stress_intensity_factor(&self, contact_half_width: f64, mean_pressure: f64) -> Result<f64, Refusal> {
        require_positive("contact_half_width", contact_half_width)?;
        self.wave.checked_half_width("contact_half_width", contact_half_width)?;
        let edge = self.wave.edge(contact_half_width);
        let excess = self.wave.full_contact_pressure() * edge.sine_squared() - require_finite("mean_pressure", mean_pressure)?;
        require_finite("stress_intensity_factor", excess * (self.wave.wavelength() / edge.tangent).sqrt())
    }

    /// The pressure (Pa) at a distance `position` (m) from the middle of a contact, at equilibrium; zero in the gap.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] at the edge itself, where the tension is infinite, and for lengths outside 0 … λ/2.
    pub fn pressure(&self, contact_half_width: f64, position: f64) -> Result<f64, Refusal> {
        let repulsion = self.wave.pressure(contact_half_width, position)?;
        let distance = position.abs();
        if distance < contact_half_width {
            let suction = self.adhesion_parameter * self.wave.edge(contact_half_width).tangent.sqrt();
            let cosine = (0.5 * self.wave.wavenumber() * distance).cos();
            let chord = self.wave.chord(contact_half_width, distance);
            require_finite("pressure", repulsion - self.wave.full_contact_pressure() * suction * cosine / chord)
        } else if distance > contact_half_width {
            Ok(0.0)
        } else {
            Err(Refusal::out_of_range("position", position, "other than the edge, where the tension is infinite"))
        }
    }

    /// The gap (m) at a distance `position` (m) from the middle of a contact, at equilibrium; zero in the contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for lengths outside 0 … λ/2.
    pub fn gap(&self, contact_half_width: f64, position: f64) -> Result<f64, Refusal> {
        require_positive("contact_half_width", contact_half_width)?;
        let (opening, eta) = self.wave.gap_parts(contact_half_width, position)?;
        if eta <= 0.0 {
            return Ok(0.0);
        }
        let suction = self.adhesion_parameter * self.wave.edge(contact_half_width).tangent.sqrt();
        require_finite("gap", self.wave.amplitude() * (opening + 2.0 * suction * eta))
    }

    /// The equilibrium at ξ = ln T.
    fn state(&self, place: f64, relative_error: f64) -> Result<WaveState, Refusal> {
        let edge = Edge { tangent: place.exp() };
        let suction = self.adhesion_parameter * (0.5 * place).exp();
        Ok(WaveState {
            contact_half_width: edge.contact_half_width(self.wave.wavelength()),
            gap_half_width: edge.turned().contact_half_width(self.wave.wavelength()),
            mean_pressure: require_finite("mean_pressure", self.wave.full_contact_pressure() * (edge.sine_squared() - suction))?,
            penetration: require_finite("penetration", self.wave.amplitude() * self.penetration_fraction(place))?,
            // e^ξ turns the last bit of ξ into |ξ| units of the last place.
            relative_error: relative_error + f64::EPSILON * (2.0 + place.abs()),
        })
    }

    /// Δ/Λ at ξ.
    fn penetration_fraction(&self, place: f64) -> f64 {
        let edge = Edge { tangent: place.exp() };
        if place > 0.0 {
            1.0 - self.missing_fraction(place)
        } else {
            edge.penetration_fraction() - self.adhesion_parameter * (0.5 * place).exp() * edge.depth()
        }
    }

    /// 1 − Δ/Λ at ξ, both parts positive.
    fn missing_fraction(&self, place: f64) -> f64 {
        let depth = Edge { tangent: place.exp() }.depth();
        missing_penetration(depth) + self.adhesion_parameter * (0.5 * place).exp() * depth
    }

    /// d(Δ/Λ)/dξ = 2c²[x s² + α√T] − ½α√T·x, by dx/dξ = −2c².
    fn penetration_slope(&self, place: f64) -> f64 {
        let edge = Edge { tangent: place.exp() };
        let (depth, suction) = (edge.depth(), self.adhesion_parameter * (0.5 * place).exp());
        2.0 * edge.cosine_squared() * (depth * edge.sine_squared() + suction) - 0.5 * suction * depth
    }

    /// First, second and third derivative of p̄/p* in ξ: s² has 2s²c², and each further one multiplies s²c² by 2(c² − s²) or so.
    fn pressure_slopes(&self, place: f64) -> (f64, f64, f64) {
        let edge = Edge { tangent: place.exp() };
        let (sine, cosine) = (edge.sine_squared(), edge.cosine_squared());
        let suction = self.adhesion_parameter * (0.5 * place).exp();
        let product = 2.0 * sine * cosine;
        let turn = cosine - sine;
        (product - 0.5 * suction, 2.0 * product * turn - 0.25 * suction, product * (4.0 * turn * turn - 4.0 * product) - 0.125 * suction)
    }

    /// ξ of the pressure extremum on the side `side` of √(3/5): −1 for pull-off, +1 for snap-in; the merger itself from the limit on.
    ///
    /// With g(h) = ¾h − ln(1 + ⅜(e^{2h} − 1)), strictly concave with its maximum 0 at h = 0, solves g = ½ln(α/limit). The start drops one
    /// of the two terms of 1 + T² and lies outside the root, from where Newton's steps on a concave function never overshoot.
    fn extremum_place(&self, side: f64) -> f64 {
        let merger = 0.5 * 0.6_f64.ln();
        let level = 0.5 * (self.adhesion_parameter / PARTIAL_CONTACT_LIMIT).ln();
        if level >= 0.0 {
            return merger;
        }
        let root_alpha = 0.5 * self.adhesion_parameter.ln() - std::f64::consts::LN_2;
        let mut h = if side < 0.0 { 4.0 / 3.0 * root_alpha } else { -0.8 * root_alpha } - merger;
        // Quadratic after a few steps; next to the merger it halves the distance, so 60 steps reach the last bit of 1e-8.
        for _ in 0..60 {
            let growth = (2.0 * h).exp_m1();
            let value = 0.75 * h - (0.375 * growth).ln_1p() - level;
            let slope = -0.468_75 * growth / (1.0 + 0.375 * growth);
            let step = value / slope;
            // Outside the root the value is negative and the step points inwards; anything else is rounding, and the end.
            if value >= 0.0 || step * side < 0.0 || step.abs() <= 0.5 * f64::EPSILON * h.abs() {
                break;
            }
            h -= step;
        }
        merger + h
    }

    /// The pressure extremum as a state.
    fn extremum(&self, side: f64) -> Result<WaveState, Refusal> {
        let room = 1.0 - self.adhesion_parameter / PARTIAL_CONTACT_LIMIT;
        if room <= 0.0 {
            return Err(Refusal::NoSuchState {
                reason: format!(
                    "at the adhesion parameter {:e} every partial contact is unstable under load control",
                    self.adhesion_parameter
                ),
                limit_name: "the adhesion parameter from which that holds",
                limit: PARTIAL_CONTACT_LIMIT,
            });
        }
        let place = self.extremum_place(side);
        let state = self.state(place, 4.0 * f64::EPSILON * (1.0 + 1.0 / room.sqrt()))?;
        Ok(WaveState { mean_pressure: self.wave.full_contact_pressure() * extremal_fraction(place), ..state })
    }

    /// ξ of the one fold of Δ: the root of 2xT^{3/2}c² + α(2 − ½x/c²), which grows with T below T = 0.15 and is positive there.
    fn penetration_fold(&self) -> Result<f64, Refusal> {
        let alpha = self.adhesion_parameter;
        // At T < e⁻⁴ and T^{3/2} < α/8 the bracket's second term wins: x > 8, so α(½x − 2) > ¼αx > 2xT^{3/2}.
        let below = (2.0 / 3.0 * (alpha / 8.0).ln()).min(-4.0);
        let above = 0.15_f64.ln();
        signed_root("the fold of the penetration of an adhesive wave", below, above, 0.5 * (below + above), |place| {
            let edge = Edge { tangent: place.exp() };
            let (depth, cosine, sine) = (edge.depth(), edge.cosine_squared(), edge.sine_squared());
            let closing = 2.0 * (1.5 * place).exp() * cosine;
            // dx/dξ = −2c², d ln c²/dξ = −2s².
            let slope = closing * (depth * (1.5 - 2.0 * sine) - 2.0 * cosine) + alpha * (1.0 - depth * sine / cosine);
            (closing * depth + alpha * (2.0 - 0.5 * depth / cosine), slope)
        })
    }
}

/// p̄/p* of an extremum at ξ, where α = 4T^{3/2}/(1 + T²)² turns s² − α√T into s²(1 − 4c²) = s²(s² − 3c²).
fn extremal_fraction(place: f64) -> f64 {
    let edge = Edge { tangent: place.exp() };
    let (sine, cosine) = (edge.sine_squared(), edge.cosine_squared());
    sine * (sine - 3.0 * cosine)
}

/// How far a root moves when its residual is off by `residual`. Each Taylor term alone would move it by e/f′, √(2e/f″), ∛(6e/f‴); the sum of the
/// denominators takes the least of the three, and the factors keep it a bound when two are alike and the derivatives are taken at the moved root.
fn newton_error(residual: f64, (first, second, third): (f64, f64, f64)) -> f64 {
    residual / (0.25 * first.abs() + 0.25 * (residual * second.abs()).sqrt() + 0.2 * (residual * residual * third.abs()).cbrt())
}
