//! A rigid sphere on an elastic half-space, with adhesion of zero range.
//!
//! ```text
//!                 | F                       F ^            ,
//!             ,---v---.                       |           /  stable under load
//!            /    R    \                    0 +--o-------J---- Δ     J: F = 0
//!      _____ \         / _____                |   \     /
//!           `-\_     _/-´     surface         |    `. ,´ A: pull-off under load, F = −(3/2)πRΔγ
//!               `---´  Δ                      |  B:( `
//!              |<-a->|                            fold of Δ: pull-off under penetration
//! ```
//!
//! | symbol | name | unit |
//! |---|---|---|
//! | R | `sphere_radius` | m |
//! | E* | `contact_modulus`, E/(1 − ν²) | Pa |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | a | `contact_radius` | m |
//! | Δ | `penetration` | m |
//! | F | `force`, compression positive | N |
//! | K | `stress_intensity_factor` of the rim, tension positive | Pa√m |
//!
//! Equations at any (a, Δ): F = 2E*aΔ − (2/3)E*a³/R, K = E*(a²/R − Δ)/√(πa), stored energy
//! U = E*[a(Δ − a²/(3R))² + (4/45)a⁵/R²] (the thesis's Eq 1.31 as a sum of squares). Equilibrium is K²/(2E*) = Δγ, hence
//! Δ = a²/R − √(2πaΔγ/E*).
//! Source: Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301, [10.1098/rspa.1971.0141](https://doi.org/10.1098/rspa.1971.0141);
//! thesis Sec 1.3.
//!
//! # Inverses, in closed form
//! With a_A³ = 9πR²Δγ/(8E*), the contact at the pull-off under load, and q = (a/a_A)^{3/2}:
//! - F/F_A = q(q − 2) with F_A = (3/2)πRΔγ, so q = 1 ± √(1 + F/F_A).
//! - With a_B³ = a_A³/9 (the contact at the fold of Δ), y = √(a/a_B) and t = ΔR/(3a_B²): y⁴ − 4y = 3t. Ferrari's factors of this quartic,
//!   y² ∓ 2√v·y + …, need the one positive root of 4v³ + 3tv = 1, which is a sum of two cube roots; then y = √v(1 ± √(v^{−3/2} − 1)).
//!   Two identities keep every digit: 1 − v = 3v(1 + t)/(1 + 2v)² close to the fold t = −1, and for t > 0 the sum of cubes turned into a quotient
//!   without differences. The smaller root follows from the product of the two, −3t/(2v + 1/√v).
//!
//! # How good
//! Relative error below 2e-15 in a, away from the folds (measured against 50 digits). At a relative distance η from a fold an input
//! that is only known to its last bit moves a by about 1e-16/√η, at worst 1e-8: [`JkrState::relative_error`] carries it. Where a force
//! or penetration passes through zero its error is relative to F_A or a_A²/R.
//!
//! Range: a ≪ R; frictionless; range of adhesion short against the neck, see [`crate::elastic::tabor`].

use super::control::{Control, EquilibriumBranch};
use crate::refusal::{Refusal, require_finite, require_non_negative, require_positive};
use std::f64::consts::PI;

/// A rigid sphere adhering to an elastic half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JkrSphere {
    sphere_radius: f64,
    contact_modulus: f64,
    work_of_adhesion: f64,
}

/// One equilibrium of [`JkrSphere`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JkrState {
    /// Radius of the contact circle (m).
    pub contact_radius: f64,
    /// Displacement of the sphere into the half-space (m); negative when it is held above the undeformed surface.
    pub penetration: f64,
    /// Compressive force (N); negative when pulled.
    pub force: f64,
    /// Bound on the relative error of `contact_radius` from rounding, the last bit of the imposed value included.
    pub relative_error: f64,
}

impl JkrSphere {
    /// A sphere of radius `sphere_radius` (m), contact modulus E* (Pa) and work of adhesion (J/m²).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for an argument that is not finite and positive; without adhesion use [`super::HertzSphere`].
    pub fn new(sphere_radius: f64, contact_modulus: f64, work_of_adhesion: f64) -> Result<Self, Refusal> {
        Ok(Self {
            sphere_radius: require_positive("sphere_radius", sphere_radius)?,
            contact_modulus: require_positive("contact_modulus", contact_modulus)?,
            work_of_adhesion: require_positive("work_of_adhesion", work_of_adhesion)?,
        })
    }

    /// The pull-off force under load control, (3/2)πRΔγ, as a positive number.
    #[must_use]
    pub fn pull_off_force(&self) -> f64 {
        1.5 * PI * self.sphere_radius * self.work_of_adhesion
    }

    /// The state at which the contact is lost: the largest tension under load control, the lowest penetration under penetration control.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] when a member leaves the range of doubles.
    pub fn pull_off(&self, control: Control) -> Result<JkrState, Refusal> {
        match control {
            Control::Load => self.state_by_neck(1.0, 4.0 * f64::EPSILON),
            Control::Penetration => {
                Ok(JkrState { penetration: -self.deepest_neck(), ..self.state_by_neck(1.0 / 3.0, 4.0 * f64::EPSILON)? })
            }
        }
    }

    /// The state without load, on the stable branch: a³ = 9πR²Δγ/(2E*).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] when a member leaves the range of doubles.
    pub fn unloaded(&self) -> Result<JkrState, Refusal> {
        self.state_by_neck(2.0, 4.0 * f64::EPSILON)
    }

    /// The state right after the first touch of an approaching sphere.
    ///
    /// Under load control it is the unloaded state; under penetration control it is the one with Δ = 0, where
    /// a³ = 2πR²Δγ/E* and F = −(4/3)πRΔγ.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] when a member leaves the range of doubles.
    pub fn jump_in(&self, control: Control) -> Result<JkrState, Refusal> {
        match control {
            Control::Load => self.unloaded(),
            Control::Penetration => Ok(JkrState { penetration: 0.0, ..self.state_by_neck(4.0 / 3.0, 4.0 * f64::EPSILON)? }),
        }
    }

    /// The equilibrium with a given contact radius (m): always one, stable or not (see [`JkrSphere::is_stable`]).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius, or one so large that the force leaves the range of doubles.
    pub fn state_by_contact_radius(&self, contact_radius: f64) -> Result<JkrState, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let ratio = a / self.radius_at(1.0);
        Ok(JkrState { contact_radius: a, ..self.state_by_neck(ratio * ratio.sqrt(), 0.0)? })
    }

    /// The equilibrium under a given force (N, compression positive).
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] for a tension above the pull-off force, and for the unstable branch under `force >= 0`;
    /// [`Refusal::OutOfRange`] for a force that is not finite.
    pub fn state_by_force(&self, force: f64, branch: EquilibriumBranch) -> Result<JkrState, Refusal> {
        let force = require_finite("force", force)?;
        let f = force / self.pull_off_force();
        let above = 1.0 + f;
        if above < 0.0 {
            return Err(Refusal::NoSuchState {
                reason: format!("the force {force:e} pulls more than the contact can hold"),
                limit_name: "the pull-off force under load control",
                limit: -self.pull_off_force(),
            });
        }
        let root = above.sqrt();
        // 1 + f carries the rounding of f; its root carries half of it relative to itself, or its square root at the fold.
        let blur = f64::EPSILON * (1.0 + 4.0 * f.abs());
        let root_blur = (blur / (2.0 * root)).min(blur.sqrt());
        let (q, q_blur) = match branch {
            EquilibriumBranch::Stable => (1.0 + root, root_blur / (1.0 + root)),
            EquilibriumBranch::Unstable if f < 0.0 => (-f / (1.0 + root), root_blur / (1.0 + root)),
            EquilibriumBranch::Unstable => {
                return Err(Refusal::NoSuchState {
                    reason: format!("under the force {force:e} the only equilibrium is the stable one"),
                    limit_name: "the force at which the unstable contact shrinks to a point",
                    limit: 0.0,
                });
            }
        };
        Ok(JkrState { force, ..self.state_by_neck(q, 4.0 * f64::EPSILON + 2.0 / 3.0 * q_blur)? })
    }

    /// The equilibrium at a given penetration.
    ///
    /// # Errors
    /// [`Refusal::NoSuchState`] below the fold of the penetration, and for the unstable branch at `penetration >= 0`;
    /// [`Refusal::OutOfRange`] for a penetration that is not finite.
    pub fn state_by_penetration(&self, penetration: f64, branch: EquilibriumBranch) -> Result<JkrState, Refusal> {
        let penetration = require_finite("penetration", penetration)?;
        let fold_radius = self.radius_at(1.0 / 3.0);
        let lowest = self.deepest_neck();
        let t = penetration / lowest;
        let above = 1.0 + t;
        if above < 0.0 {
            return Err(Refusal::NoSuchState {
                reason: format!("at the penetration {penetration:e} the neck has already snapped"),
                limit_name: "the pull-off penetration under penetration control",
                limit: -lowest,
            });
        }
        if branch == EquilibriumBranch::Unstable && t >= 0.0 {
            return Err(Refusal::NoSuchState {
                reason: format!("at the penetration {penetration:e} the only equilibrium is the stable one"),
                limit_name: "the penetration at which the unstable contact shrinks to a point",
                limit: 0.0,
            });
        }
        // 4v³ + 3tv = 1: v = (A + B)/2 with A³ = 1 + √(1 + t³), AB = −t, A³ + B³ = 2. For t > 0 B is negative: use 2/(A² − AB + B²).
        let cube = (1.0 + above.sqrt() * (1.0 - t + t * t).sqrt()).cbrt();
        let v = if t <= 0.0 { 0.5 * (cube - t / cube) } else { 1.0 / (cube * cube + t + (t / cube) * (t / cube)) };
        // v^{−3/2} − 1 = (1 − v³)/(v^{3/2}(1 + v^{3/2})), with 1 − v from the cubic itself.
        let one_minus_v = 3.0 * v * above / ((1.0 + 2.0 * v) * (1.0 + 2.0 * v));
        let v32 = v * v.sqrt();
        let split = (one_minus_v * (1.0 + v + v * v) / (v32 * (1.0 + v32))).sqrt();
        let larger = v.sqrt() * (1.0 + split);
        // split grows as √(1 + t), so its relative error is half that of 1 + t, and never more than the square root of the rounding.
        let blur = f64::EPSILON * (1.0 + 6.0 * t.abs());
        let split_blur = (split * blur / (2.0 * above)).min(blur.sqrt());
        let (y, y_blur) = match branch {
            EquilibriumBranch::Stable => (larger, split_blur / (1.0 + split)),
            EquilibriumBranch::Unstable => (-3.0 * t / ((2.0 * v + 1.0 / v.sqrt()) * larger), split_blur / (1.0 + split)),
        };
        let state = self.state_by_neck(y * y * y / 3.0, 8.0 * f64::EPSILON + 2.0 * y_blur)?;
        Ok(JkrState { contact_radius: fold_radius * y * y, penetration, ..state })
    }

    /// Whether a state stays where it is under a control. At the fold itself it does not.
    #[must_use]
    pub fn is_stable(&self, state: &JkrState, control: Control) -> bool {
        state.contact_radius
            > match control {
                Control::Load => self.radius_at(1.0),
                Control::Penetration => self.radius_at(1.0 / 3.0),
            }
    }

    /// The force at any contact radius and penetration, in equilibrium or not.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or a penetration that is not finite.
    pub fn force(&self, contact_radius: f64, penetration: f64) -> Result<f64, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let depth = require_finite("penetration", penetration)?;
        require_finite("force", 2.0 * self.contact_modulus * a * (depth - a / self.sphere_radius * a / 3.0))
    }

    /// The stress intensity factor of the rim at any contact radius and penetration; negative when the rim is pressed.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a radius that is not positive or a penetration that is not finite.
    pub fn stress_intensity_factor(&self, contact_radius: f64, penetration: f64) -> Result<f64, Refusal> {
        let a = require_positive("contact_radius", contact_radius)?;
        let depth = require_finite("penetration", penetration)?;
        require_finite("stress_intensity_factor", self.contact_modulus * (a / self.sphere_radius * a - depth) / (PI * a).sqrt())
    }

    /// The elastic energy stored at any contact radius and penetration, in equilibrium or not.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius or a penetration that is not finite.
    pub fn strain_energy(&self, contact_radius: f64, penetration: f64) -> Result<f64, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let depth = require_finite("penetration", penetration)?;
        let height = a / self.sphere_radius * a;
        let offset = depth - height / 3.0;
        require_finite("strain_energy", self.contact_modulus * a * (offset * offset + 4.0 / 45.0 * height * height))
    }

    /// The pressure (Pa) at a distance `radius` (m) from the axis, at equilibrium: compression inside, tension towards the rim.
    /// Zero outside the contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] at the rim itself, where the tension is infinite, and for negative arguments.
    pub fn pressure(&self, contact_radius: f64, radius: f64) -> Result<f64, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let r = require_non_negative("radius", radius)?;
        if r < a {
            let chord = (a - r).sqrt() * (a + r).sqrt();
            require_finite("pressure", self.contact_modulus / PI * (2.0 * chord / self.sphere_radius - self.lift(a) / chord))
        } else if r > a {
            Ok(0.0)
        } else {
            Err(Refusal::out_of_range("radius", r, "other than the contact radius, where the tension is infinite"))
        }
    }

    /// The gap between sphere and half-space at a distance `radius` from the axis, at equilibrium; zero inside the contact.
    ///
    /// No cancellation: both parts are positive, and the Hertzian one, which opens with the power 3/2 of the distance, is summed as
    /// a series where it is small. The error left is that of the distance itself, `radius − contact_radius`.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for negative arguments.
    pub fn gap(&self, contact_radius: f64, radius: f64) -> Result<f64, Refusal> {
        let a = require_non_negative("contact_radius", contact_radius)?;
        let r = require_non_negative("radius", radius)?;
        if r <= a {
            return Ok(0.0);
        }
        let angle = ((r - a).sqrt() * (r + a).sqrt()).atan2(a);
        let hertz = r / self.sphere_radius * r * sine_minus_chord(2.0 * angle) / 4.0;
        require_finite("gap", 2.0 / PI * (hertz + self.lift(a) * angle))
    }

    /// a_A·q^{2/3}, the contact radius with (a/a_A)^{3/2} = q.
    fn radius_at(&self, q: f64) -> f64 {
        (9.0 * PI / 8.0 * (self.work_of_adhesion / self.contact_modulus) * q * q * self.sphere_radius * self.sphere_radius).cbrt()
    }

    /// 3a_B²/R: how far the sphere can be drawn above the undeformed surface.
    fn deepest_neck(&self) -> f64 {
        let fold_radius = self.radius_at(1.0 / 3.0);
        3.0 * fold_radius * (fold_radius / self.sphere_radius)
    }

    /// √(2πaΔγ/E*): how far below the Hertzian penetration adhesion holds the sphere.
    fn lift(&self, contact_radius: f64) -> f64 {
        (2.0 * PI * contact_radius).sqrt() * (self.work_of_adhesion / self.contact_modulus).sqrt()
    }

    /// The equilibrium with (a/a_A)^{3/2} = q: F = F_A·q(q − 2), Δ = (a²/R)(1 − 4/(3q)).
    fn state_by_neck(&self, q: f64, relative_error: f64) -> Result<JkrState, Refusal> {
        let contact_radius = require_finite("contact_radius", self.radius_at(q))?;
        let unit = self.radius_at(1.0);
        let penetration = require_finite("penetration", unit / self.sphere_radius * unit * q.cbrt() * (q - 4.0 / 3.0))?;
        let force = require_finite("force", self.pull_off_force() * q * (q - 2.0))?;
        Ok(JkrState { contact_radius, penetration, force, relative_error })
    }
}

/// sin φ − φ cos φ for 0 ≤ φ ≤ π, to full relative accuracy.
fn sine_minus_chord(angle: f64) -> f64 {
    if angle > 0.5 {
        // The two terms differ by at least 8 % of the first here: one digit lost at most.
        return angle.sin() - angle * angle.cos();
    }
    // Σ_k (−1)^{k+1} 2k φ^{2k+1}/(2k+1)!: eight terms leave 1e-20 of the first at φ = 0.5.
    let square = angle * angle;
    let (mut power, mut sum) = (angle, 0.0);
    for k in 1..=8_u32 {
        let n = 2.0 * f64::from(k);
        power *= -square / (n * (n + 1.0));
        sum -= n * power;
    }
    sum
}
