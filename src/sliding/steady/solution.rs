//! What a steady sliding contact turns out to be, every number with its error; reduced units as in [`Indenter`](super::Indenter).

use super::start::Start;
use crate::estimate::Estimate;
use crate::sliding::branch::{SecondVariations, Stability};
use crate::sliding::contact::ContactState;

/// How the contact ends up.
#[derive(Debug, Clone, PartialEq)]
pub enum SlidingOutcome {
    /// A contact with two edges.
    Partial(Box<PartialContact>),
    /// Full contact, as no partial contact exists.
    Full(FullContact),
}

/// A contact with two edges.
#[derive(Debug, Clone, PartialEq)]
pub struct PartialContact {
    /// The numbers.
    pub values: PartialValues,
    /// The solved contact, from which pressure and gap follow at any point.
    pub state: ContactState,
    /// The evidence.
    pub certificate: SlidingCertificate,
    /// What it took.
    pub work: SlidingWork,
    /// From here a contact under nearly the same conditions is found without a curve.
    pub start: Start,
    /// Whether it stays where it is; none where the second variations are not known, or were not asked for.
    pub stability: Option<ContactStability>,
    /// How many other contacts there are: of a load or penetration stable ones, of a half-width any.
    pub others: usize,
}

/// Whether a contact stays where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStability {
    /// How the works at the edges change when they move.
    pub variations: SecondVariations,
}

impl ContactStability {
    /// Under a held load.
    #[must_use]
    pub fn under_load(&self) -> Stability {
        self.variations.under_load()
    }

    /// Under a held penetration.
    #[must_use]
    pub fn under_penetration(&self) -> Stability {
        self.variations.under_penetration()
    }

    /// In a frame of stiffness k_f (p̄ per Δ, in E0*k/2).
    #[must_use]
    pub fn in_frame(&self, frame_stiffness: f64) -> Stability {
        self.variations.in_frame(frame_stiffness)
    }
}

/// The numbers of a contact with two edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartialValues {
    /// a: half the contact width (1/k).
    pub half_width: Estimate,
    /// e: the middle of the contact ahead of the crest (1/k).
    pub eccentricity: Estimate,
    /// x of the trailing edge, −l₁ = e − a (1/k).
    pub trailing_edge: Estimate,
    /// x of the leading edge, l₂ = e + a (1/k).
    pub leading_edge: Estimate,
    /// Δ (Λ).
    pub penetration: Estimate,
    /// p̄ (E0*kΛ/2).
    pub mean_pressure: Estimate,
    /// Friction stress (E0*k²Λ²/2), positive against the motion.
    pub friction_stress: Estimate,
    /// μ/(kΛ), of a parabola μR/L: friction stress over mean pressure; none unless the mean pressure is positive beyond its error.
    pub friction_coefficient: Option<Estimate>,
    /// U = ½∫p w, in reduced units.
    pub interface_work: Estimate,
    /// What adhesion adds; none without it, and where it is so weak that no digit of the load feels it: the other numbers are then those without it, with bounds that
    /// hold what it would change.
    pub adhesion: Option<AdhesiveValues>,
}

/// The numbers that only an adhesive contact has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesiveValues {
    /// G₁/Δγ of the trailing edge, over its own work of adhesion.
    pub trailing_release: Estimate,
    /// G₂/Δγ of the leading edge, over its own work of adhesion.
    pub leading_release: Estimate,
    /// δL_P of the trailing edge over Δγδ: the work of the interface that is not stored, 1 − G₁/Δγ (3.21).
    pub trailing_nonconservative: Estimate,
    /// δL_P of the leading edge over Δγδ, 1 − G₂/Δγ (3.22).
    pub leading_nonconservative: Estimate,
    /// Γ₁G₁/Δγ₁ − Γ₂G₂/Δγ₂, the adhesive part of the friction stress (3.40 times the mean pressure).
    pub adhesive_friction_stress: Estimate,
}

/// The evidence for a partial contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingCertificate {
    /// Largest relative defect of the two edge conditions.
    pub residual: f64,
    /// Largest condition number of the linear systems of its contacts.
    pub condition: f64,
    /// Signs of the edges and of the gap were checked.
    pub admissible: bool,
    /// Largest error over max(|value|, 1) of all outputs.
    pub accuracy: f64,
}

/// Work counters.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct SlidingWork {
    /// Contacts solved: each one small linear system.
    pub contacts: u64,
    /// Evaluations of both edge conditions.
    pub closure_evaluations: u64,
    /// Half-widths at which every contact was looked for.
    pub half_widths: u64,
}

/// Full contact.
#[derive(Debug, Clone, PartialEq)]
pub struct FullContact {
    /// p̄, if prescribed (E0*kΛ/2).
    pub mean_pressure: Option<f64>,
    /// Friction stress, ½Im E(kv)/E0.
    pub friction_stress: Estimate,
    /// Friction stress over mean pressure, if that is positive.
    pub friction_coefficient: Option<Estimate>,
    /// a and b of the pressure p̄ + a cos kx + b sin kx under the surface Λ cos kx (E0*kΛ/2): storage and loss modulus at ω = kv over E0.
    pub pressure_waves: [Estimate; 2],
    /// The limit that partial contact has passed.
    pub limit_name: &'static str,
    /// Its value.
    pub limit: f64,
    /// What it took to know that.
    pub work: SlidingWork,
}
