//! Steady sliding on a wave by collocation with piecewise-constant pressure: the thesis's own scheme (Sec 3.3), and one with shared nodes.
//!
//! # What it does
//! The pressure is constant on each of N elements of a non-uniform mesh, and w(x) = −∫ 𝒢(x − ξ) p(ξ) dξ is the indenter at every midpoint ([`mesh`],
//! [`influence`], [`contact`]). For the closure each edge is moved out by δ at fixed penetration, the contact solved again, and the tension of
//! the new elements put on the old gap ([`closures`]); Newton's method then finds both edges ([`equilibrium`]), by the same code and with the
//! same start as [`viscotack::sliding::edge_balance`].
//!
//! | scheme | meshes of the three contacts | what it is worth |
//! |---|---|---|
//! | [`Layout::Mapped`] | each its own mapped mesh (3.26–3.34) | the thesis; the old edge is no node of a moved mesh: erratic closure |
//! | [`Layout::WindowAligned`] | moved mesh = old mesh + a graded mesh of the process zone | ours; monotone, can be extrapolated ([`richardson`]) |
//!
//! # Measured orders in 1/N (zones of 1e-3, β from 1 to 1000, ζ from 0.01 to 30)
//! | density exponent n of (3.32) | p̄, friction, U | pressure at a point | works, aligned | error of the works, mapped, N = 400 |
//! |---|---|---|---|---|
//! | 1/2 | 1.5 | – | – | 3 % and erratic |
//! | 1 | 2.0 | – | – | 0.3 to 1 % and erratic |
//! | 2 | 2.7 to 2.9, a logarithm below 3 | 2.0 | 2.6 to 2.7 | 0.6 % and erratic |
//! | 3 | 2.9 to 3.0 | 2.0 | 2.8 to 2.9 | 0.6 % and erratic |
//!
//! Release rates are differences of U over δ: on mapped meshes the errors of U cancel and they come out better than the works, on aligned ones
//! they have the order of the works. Stronger grading costs digits: at n = 3, β = 1000, ζ = 1, N = 400 rounding leaves 1e-3 of the pressures next to
//! an edge.
//!
//! Units and symbols: those of [`viscotack::sliding`] and [`viscotack::sliding::contact`]; lengths in 1/k, displacements in Λ, pressures in E0*kΛ/2.
//! It serves any kernel with an antiderivative, where the exact reduction does not, at a cost of N² kernels and N³/3 multiplications per contact.
//!
//! A collocated contact is compared with the solver's own in `tests/sliding/sec_3_rivals.rs`, and timed in `benches/steady_sliding.rs`.

pub mod closures;
pub mod contact;
pub mod equilibrium;
pub mod influence;
pub mod mesh;
pub mod richardson;
pub mod scheme;

pub use closures::CollocatedClosures;
pub use contact::CollocatedContact;
pub use equilibrium::CollocatedEquilibrium;
pub use scheme::{Layout, SlidingCollocation};
