//! Branches of steady sliding contacts: how contact follows load, speed and adhesion, where it turns, and which of it is stable.
//!
//! ```text
//!   p̄ ^            S                       rate ^
//!     |          ,´ `.                          |     fast contact  ___________
//!     |        ,´     \   S: snap-in            |        F₂ (-------- unstable
//!   0 o------,´--------\--- a                   |   · · · · · · · · · · · · ·   no steady partial contact between
//!     |`.   /Z          \   P: pull-off         |        F₁ )-------- unstable
//!     |  O P                O: fold of Δ        |     slow contact ‾‾‾‾‾‾‾‾‾‾‾‾ a
//! ```
//! Each contact is a point of a curve of two edge conditions in three unknowns ([`crate::continuation::arclength`]):
//!
//! | path | what varies | unknowns | turns of interest |
//! |---|---|---|---|
//! | [`BranchPath::Loads`] | mean pressure and penetration | ln tan(a/2), e, p̄ | p̄: pull-off, snap-in; Δ: Δ_out; a |
//! | [`BranchPath::Speeds`] | speed | ln tan(a/2), e, ln kv (held half-width: p̄, e, ln kv) | ln kv |
//! | [`BranchPath::Adhesions`] | work of adhesion | …, ln Γ | ln Γ |
//! | [`BranchPath::Zones`] | process zones, in a fixed ratio | …, ln of their factor | the factor |
//!
//! Units are the reduced ones of [`Indenter`](super::contact::Indenter); rates kv in 1/s. Curves are followed coarsely; points that are kept, folds, states without load
//! and the toughness are then solved to the accuracy asked for, each with its error bound. Source: thesis Sec 3.7 and Figs 3.14, 3.15.

mod conditions;
mod end;
mod equations;
mod events;
mod fold;
mod load;
mod no_contact;
mod point;
mod scan;
mod stability;
mod start;
mod strength;
mod toughness;
mod trace;
mod values;

pub use super::equilibrium::ContactAt;
pub use conditions::{BranchPath, BranchProblem, BranchStart};
pub use end::{BranchEnd, Impossible};
pub(super) use fold::turn_near;
pub use fold::{Fold, FoldQuantity, Turn};
pub use load::{LoadSlopes, load_slopes};
pub use no_contact::{Everywhere, NoContactBetween, SpeedFolds, beyond_both_ends, speed_folds};
pub use point::BranchPoint;
pub use scan::{EveryBranch, Scan, contacts_of_width, every_branch};
pub use stability::{SecondVariations, Stability};
pub use strength::{Strength, StrengthAt, strength, strengths};
pub use toughness::{Toughness, toughness};
pub use trace::{Branch, BranchWork, trace};
