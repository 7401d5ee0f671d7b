//! An axisymmetric indenter pressed on, or pulled off, a viscoelastic half-space (thesis chapter 4), by an exact reduction to a line.
//!
//! # Notation
//! ```text
//!            | F, Δ                          every point s of the line is a spring chain of its own:
//!        \   v   /                              s < a(t):  W(s,t) = Δ(t) − f(s)   bonded
//!         \     /  profile                      s > a(t):  Q(s,t) = 0             free
//!   ‾‾‾‾‾‾‾\___/‾‾‾‾‾‾‾  surface                W = ∫ J(t − t′) dQ(s,t′)
//!         |<-a->|
//! ```
//! | symbol | name | unit |
//! |---|---|---|
//! | s | place on the line, as long as a radius | m |
//! | f(s) | line profile of the indenter, s²/R for a sphere ([`Profile`]) | m |
//! | W, Q | line displacement; line load (modulus times length) | m; Pa m |
//! | e_j | Voigt strains of the creep terms, W = Q/E∞* + Σe_j ([`Contact`]) | m |
//! | Δ | penetration | m |
//! | F | force, compression positive, 2∫₀^a Q ds | N |
//! | K_I | stress intensity of the rim, tension positive, −Q(a)/√(πa) | Pa√m |
//! | D(s) | gap factor W − (Δ − f) outside the contact | m |
//! | C | work of the interface stresses in the process zone δ, per area (Eq 4.9) | J/m² |
//!
//! Every modulus is E* = E/(1 − ν²): a [`PlaneMaterial`](crate::material::PlaneMaterial). The surface follows as
//! w(r) = (2/π)∫₀^r W/√(r² − s²) ds and p(r) = (1/π)[Q(a)/√(a² − r²) − ∫_r^a Q′/√(s² − r²) ds], for ANY history of the edge, re-advancing too:
//! no matrix and no integral equation. Any coherent units.
//!
//! # How
//! [`Contact`] carries the state on panels of Gauss nodes; an update is exact for any polynomial motion of edge and penetration, and any number
//! of terms ([`Springs`]). [`zone_work`] is the closure. [`integrate`] goes step by step: the edge goes a given way and the time follows from the
//! closure, or a time goes by and the place of the edge follows, along the polynomial through the last points (up to the sixth order), with
//! steps chosen by the error of the path. [`run`] tightens the integration until the errors of what it reports meet the accuracy.
//!
//! Source: thesis chapter 4 (Eqs 4.1–4.33); Sneddon, Int. J. Engng Sci. 3 (1965) 47, [10.1016/0020-7225(65)90019-4](https://doi.org/10.1016/0020-7225(65)90019-4).

mod adhesiveless;
mod advance;
mod assessment;
mod between;
pub mod by_panels;
mod checkpoint;
mod coarsening;
mod convergence;
mod corners;
mod current_segment;
mod cycle;
mod cycle_integrals;
mod edge;
mod edge_law;
mod elastic_zone;
mod elliptic;
mod energies;
mod fields;
mod folds;
mod history;
mod integrator;
mod jumps;
mod line;
mod motion;
mod node_update;
mod open;
mod oscillation;
mod panel;
mod path_history;
mod prescribed_edge;
mod problem;
mod profile;
mod record;
mod rest;
mod rim;
mod row;
mod run;
pub mod scan;
mod shape;
mod solution;
mod spread;
mod springs;
mod start;
mod step_sizes;
mod stepping;
mod summary;
mod window;
mod zone;
mod zone_work;

pub(crate) use adhesiveless::Sums;
pub use checkpoint::{Checkpoint, Watch};
pub use cycle::Cycle;
pub(crate) use cycle_integrals::{Course, CycleIntegrals, POINTS_BEHIND};
pub use edge_law::EdgeLaw;
pub use elastic_zone::{ElasticContact, elastic_contact, elastic_contact_of_radius};
pub use elliptic::elliptic_k;
pub use fields::SurfaceFields;
pub use history::{Controlled, History, Segment};
pub use integrator::integrate;
pub use line::{Contact, Sweep};
pub use oscillation::{FrequencySweep, Oscillation};
pub use panel::{POINTS, Panel};
pub use problem::{Adhesion, IndentationProblem, Start};
pub use profile::Profile;
pub use run::{run, run_watched, surface_of};
pub use shape::TabulatedShape;
pub use solution::{Energies, Event, EventKind, IndentationSolution, IndentationWork, Instant, PathPoint, Trace};
pub use spread::Spread;
pub use springs::Springs;
pub use summary::Summary;
pub use zone::Zone;
pub use zone_work::zone_work;
