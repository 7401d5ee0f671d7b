//! Surfaces that attract at a distance: contact with a law of finite range instead of an edge.
//!
//! The edge of the other modules (one energy balance over a process zone) is the limit of a law whose range goes to zero. Here the
//! law itself is solved: the stress between the surfaces is a function of their gap, everywhere.
//! ```text
//! gap       g = w − h + S           w displacement into the body, h profile, S mean gap
//! pressure  p = s(g), or g at the hard wall with p − s ≥ 0
//! body      w from p by the linear viscoelastic body
//! ```
//! | module | what |
//! |---|---|
//! | [`law`] | laws of attraction: stress, slope, work left, kinks, wall |
//! | [`mod@line`] | steady sliding of periodic lines and surfaces on a half-space or a layer |
//! | [`sphere`] | an axisymmetric tip on a half-space, in time |
//!
//! Sources: Greenwood (1997) and Feng (2000) for spheres of finite range; Hintermüller, Ito & Kunisch (2002) for the active set; theory
//! notes, sections 0, 3 and 6, for the half-space, the layer and the reduced groups.
//!
//! Not yet here: stability of a sphere's states (only its jumps are found), a law that differs between closing and opening, sliding that is not steady.

pub mod law;
pub mod line;
pub mod sphere;
