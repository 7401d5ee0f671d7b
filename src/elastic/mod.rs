//! Closed forms of elastic contact and fracture, one a file: the limits that every viscoelastic result must reach.
//!
//! | file | problem | what it gives |
//! |---|---|---|
//! | [`plane_modulus`] | any | E* in plane stress, plane strain, and for two half-spaces |
//! | [`control`] | any | load or penetration held; which of two equilibria |
//! | [`hertz`] | rigid sphere, no adhesion | force, penetration, contact radius from one another |
//! | [`jkr`] | rigid sphere, adhesion of zero range | the same, on both branches and under both controls; pull-off and jump-in |
//! | [`kendall_punch`] | rigid flat cylinder | pull-off |
//! | [`westergaard_wave`] | rigid wave, no adhesion | mean pressure, contact width, penetration from one another |
//! | [`johnson_wave`] | rigid wave, adhesion of zero range | the same on three branches; pull-off, snap-in, spontaneous full contact |
//! | [`tabor`] | sphere | is a zero range of adhesion a fair picture? |
//! | [`strip_energy`] | strip under a stress step | stored and dissipated energy of a creeping strip |
//! | [`pure_shear_strip`] | long crack in a strip | stress intensity from the remote stress |
//!
//! # Conventions
//! Forces and pressures are positive in compression, penetrations positive into the body. E* is the contact modulus of ONE
//! deformable body against a rigid one (or the joint one of two half-spaces, [`plane_modulus::contact_modulus`]), so that an edge with
//! stress intensity K releases G = K²/(2E*). Two equal halves with a crack between them release K²/E*: each file says which.
//! Units are the caller's, any coherent set: nothing here depends on a scale.
//!
//! # How good the numbers are
//! Every closed form is written so that nothing cancels that the data do not make cancel; each file states the relative error that
//! the tests measured. At a fold (pull-off, snap-in) the contact size depends on the load through a square root: an input rounded
//! at 1.1e-16 then moves the contact size by up to 1e-8, whatever the algorithm. The states carry that bound as `relative_error`.

pub mod control;
pub mod hertz;
pub mod jkr;
pub mod johnson_wave;
pub mod kendall_punch;
pub mod plane_modulus;
pub mod pure_shear_strip;
pub mod strip_energy;
pub mod tabor;
pub mod westergaard_wave;

pub use control::{Control, EquilibriumBranch};
pub use hertz::HertzSphere;
pub use jkr::JkrSphere;
pub use johnson_wave::JohnsonWave;
pub use kendall_punch::KendallPunch;
pub use plane_modulus::PlaneState;
pub use pure_shear_strip::PureShearStrip;
pub use strip_energy::CreepingStrip;
pub use tabor::TaborNumber;
pub use westergaard_wave::WestergaardWave;
