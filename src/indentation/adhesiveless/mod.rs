//! An indenter without adhesion: Lee and Radok's, Ting's and Graham's contact, for any shape, history and number of terms, solids and liquids alike.
//!
//! # Notation
//! | symbol | name | unit |
//! |---|---|---|
//! | s, f(s) | place on the line and line profile, as in [`crate::indentation`] | m |
//! | Δ, F, a | penetration, force, contact radius | m, N, m |
//! | W, Q | displacement and load of the chain at s; W = Δ − f inside, Q = 0 outside | m; Pa m |
//! | S(s) | Δ − f − Σe_j: Q/E∞* inside, minus the gap factor outside | m |
//! | u_i, E_i, ρ_i | spring strain, modulus and time of a Maxwell branch | m, Pa, s |
//! | e_j, J_j, τ_j | strain, compliance and time of a Voigt element | m, 1/Pa, s |
//!
//! Without adhesion nothing but S ≥ 0 decides what is in contact, chain by chain, and S falls along s ([`line`]): given Δ(t), no chain waits for another.
//! Each knows the instants at which the edge passes it, as roots of its own S(t), and what it is between them in closed form; the strains are kept as
//! Chebyshev series between the places where the edge turned. There are no steps in time: one segment of the history is one move ([`edge`]). Where a force,
//! a frame or a radius is given, Δ is a polynomial on each panel of time that meets it at Chebyshev's nodes ([`imposed`], [`law`]).
//!
//! Errors come from the series: two courses of different fineness tell.
//!
//! Sources: Lee & Radok, J. Appl. Mech. 27 (1960) 438; Ting, J. Appl. Mech. 33 (1966) 845 and 35 (1968) 248; Graham, Int. J. Eng. Sci. 5 (1967) 495.

mod chain;
mod course;
mod cycles;
mod drive;
mod edge;
mod fresh;
mod grid;
mod imposed;
mod law;
mod law_edge;
mod ledger;
mod line;
mod linear;
mod moment;
mod motions;
mod path_history;
mod points;
mod rising;
mod series;
mod settle;
mod solve;
mod state;
mod times;
mod walk;

pub(crate) use ledger::Sums;
pub(super) use solve::{course, solve, surface_at};
