//! Cracks that move steadily through a linear viscoelastic solid: how fast for a given load, how tough at a given speed.
//!
//! ```text
//!            opening: the crack runs into the solid          closing: the solid heals over the crack
//!      gap u(s)  ◄─ s │ d ─►  stress K/√(2πd)             stress σ(d)  ◄─ d │ s ─►  gap (K₁/E0)√(8s/π)
//!   ─────────────────●═══════════ v ►                   ═══════════●───────────────  v ► (into the open side)
//! ```
//! | symbol | name here | unit |
//! |---|---|---|
//! | v | `speed` of the tip, ≥ 0 | m/s |
//! | K, K₁ | `stress_intensity`: opening, of the whole field; closing, of the far field | Pa √m |
//! | K₁/E0 | `displacement_intensity` | √m |
//! | G | `energy_release_rate` far away, where the solid is relaxed: K²/(2E0) per deformable half | J/m² |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | δ | `process_zone` length | m |
//! | T = δ/v | `crossing_time` of the process zone | s |
//! | σ_c | `cohesive_stress` | Pa |
//! | a₀ = E0Δγ/(πσ_c²) per half | `relaxed_zone`: K²/(2πσ_c²) at G = Δγ | m |
//!
//! The moduli are those of the plane problem: a [`PlaneMaterial`](crate::material::PlaneMaterial) has E/(1 − ν²) in plane
//! strain, E in plane stress. Everything is per [`CrackBody`]: one deformable half against a rigid one, or two halves.
//!
//! Every theory here is a curve over one parameter, the crossing time T: a drive D(T) and a zone length ℓ(T), with v = ℓ/T
//! ([`SteadyCurve`]). Each model is a file; [`solve`] finds the state at a given speed or load for any of them.

pub mod body;
pub mod cohesive_zone;
pub mod curve;
pub mod delayed;
pub mod near_tip;
pub mod persson_brener;
pub mod process_zone;
pub mod solve;
pub mod steep_closing;
pub mod virtual_work;

pub use body::CrackBody;
pub use curve::{CurvePoint, Motion, SteadyCurve};
pub use process_zone::{Interface, ProcessZone};
pub use solve::{SteadyState, at_drive, at_speed};
