//! Steady sliding on a wave: the kernel between pressure and displacement (thesis Sec 2.2.2 and Eq 3.24), and the contacts (chapter 3).
//!
//! # Notation
//! ```text
//!      →  the indenter slides to +x at v; the frame moves with it
//!   ‾‾\__/‾‾‾\__/‾‾    Λ cos kx          w(x) = −∫ 𝒢(x − ξ) p(ξ) dξ      over one period
//!   ////////////////   w > 0 into the body, p > 0 compression
//! ```
//! | symbol | meaning | reduced by |
//! |---|---|---|
//! | x | position in the moving frame | 1/k |
//! | w | displacement of the surface, without its mean | Λ |
//! | p | pressure | E0*kΛ/2 |
//! | ζ_j = kvτ_j | sliding per RETARDATION time τ_j | |
//! | j_j = J_jE0 | relative compliance of a creep term | 1/E0 |
//! | β = E∞/E0 | stiffening ratio; 1/β + Σj_j = 1 | |
//! | Ĉ_m = 1/β + Σj_j/(1 − imζ_j) | compliance seen by the harmonic e^{imx} | 1/E0 |
//! | L(x) = log\|2 sin(x/2)\| | the elastic half-plane, [`crate::special::log_sine`] | |
//! | 𝓛(x; ζ) | its memory, [`crate::special::memory_clausen`] | |
//! | kd, A_m, S_m = 1 − A_m | layer thickness and compliance factors, [`layer`] | |
//!
//! E0* = E0/(1 − ν²). The sign of v is free in the kernel: v < 0 mirrors every field. Contacts slide forward, at a rate kv > 0.
//!
//! # Contacts
//! [`contact`] solves a contact with given edges and gives its fields and the work at its edges; [`edge_balance`] finds the edges, with adhesion and
//! without; [`elastic_reference`] compares with an elastic solid, [`sensitivity`] tells what depends on what; [`steady`] reaches any speed from the slow or the fast
//! contact, whose forms are known, and gives every number with its error.

pub mod branch;
pub mod contact;
pub mod edge_balance;
pub mod elastic_reference;
pub(in crate::sliding) mod equilibrium;
pub mod green;
pub mod layer;
pub mod layer_green;
pub mod memory;
pub mod nonconservative;
pub mod sensitivity;
pub mod steady;
mod thin_layer;

pub use green::HalfPlaneGreen;
pub use layer::{Backing, Layer};
pub use layer_green::LayerGreen;
pub use memory::{MemoryTerm, SlidingMemory};
