//! Every steady contact of one speed and adhesion, without a start: the equilibrium curve.
//!
//! ```text
//!   p̄ ^            S                    at one half-width a every contact is known in closed form but for one root search in e
//!     |          ,´ `.                  ([`width`]); along the half-widths the contacts are a curve ([`curve`]), and a held load or
//!     |        ,´     \                 penetration is where the curve crosses it ([`held`])
//!   0 o------,´--------\--- a
//!     |`.   /           \   S: snap-in, the largest load of a stable contact
//!     |  `.P                P: pull-off, the smallest
//! ```
//! The curve answers which contacts a load has, which of them are stable, and where the loads end that a contact can carry.
//!
//! Source: our own; the problem is thesis Eqs 3.16–3.30.

mod curve;
mod existence;
mod formed;
mod forms;
mod held;
mod point;
mod table;
mod width;
mod without_adhesion;
mod works;

pub(in crate::sliding) use curve::{EquilibriumCurve, half_widths};
pub(in crate::sliding) use existence::{Place, WhyNot};
pub(in crate::sliding) use held::{Crossing, End, SegmentEnd, StableSegment};
pub(in crate::sliding) use point::HeldQuantity;
pub use width::ContactAt;
pub(in crate::sliding) use width::ContactsOfWidth;
