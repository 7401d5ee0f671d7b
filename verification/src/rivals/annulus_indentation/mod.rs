//! A sphere on a one-term half-space by the thesis's own scheme (Eqs 4.12–4.18): dense, on annuli of constant pressure, in small steps of time.
//!
//! ```text
//!   p_q constant on annulus q        (1 + ε/τ) u_h^k = (1/E∞ + ε/(τE0)) Σ_q G_hq p_q^k + A_h^{k−1}                (4.17)
//!    ┌───┬──┬──┬──┬ … ┬──┐            A_h^k = u_h^k − (1/E∞) Σ_q G_hq p_q^k                                        (4.18)
//!    0   λ  2λ 3λ       nλ = a
//! ```
//! | symbol | name | unit |
//! |---|---|---|
//! | λ | width of an annulus, δ over [`AnnulusScheme::elements_per_zone`] | m |
//! | ε | step of time | s |
//! | τ | RETARDATION time (the thesis prints τ for it and for the relaxation time of 4.19) | s |
//! | p, u | pressure, displacement into the body (the thesis has −p and −u) | Pa, m |
//! | G_hq | displacement at r_h of a half-space of unit modulus E* under unit pressure on annulus q (4.15, 4.16) | m/Pa |
//! | C | (1/2δ) Σ tension(a − d)·gap(a + δ − d)·λ, the closure (4.9) on the mesh | J/m² |
//!
//! # How
//! The edge sits on a node, a = nλ, and δ is a whole number of annuli, so that the old and the moved edge share the mesh. At each step n goes,
//! one annulus at a time, to where C(n) ≤ Δγ < C(n+1); a and F are read between the two by linear interpolation in C, and the memory keeps
//! the nearer of the two. Pressures of a trial edge come from a dense solution of (4.17) over its annuli; factors may be kept from step to
//! step, which the thesis does not say ([`AnnulusScheme::keep_factors`]).
//!
//! # How good
//! Against the line reduction at 4, 8 and 16 annuli per process zone, over four speeds: F off by 8e-3, 4e-3, 1.4e-3 of the largest, a by 7e-3, 1.4e-3,
//! 9e-4, with a scatter of a fraction of λ, as the edge of the memory sits on nodes (an approach and return: F 1.7e-2, 9e-3, 5e-3). Measured in
//! `tests/indentation/sec_4_3_rival.rs`, timed in `benches/indentation.rs`. Shares nothing with [`viscotack::indentation`].

mod elliptic;
mod influence;
mod scheme;

pub use elliptic::complete_elliptic;
pub use influence::{disk_displacement, influence_matrix};
pub use scheme::{AnnulusPath, AnnulusPoint, AnnulusScheme, AnnulusStart};
