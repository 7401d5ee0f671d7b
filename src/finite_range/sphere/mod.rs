//! An axisymmetric tip on a viscoelastic half-space that attract each other at a distance, in time.
//!
//! ```text
//! gap        g = g₀(x) − Δ + m A(p/β + Σ v_j)        m = μ^{3/2}, μ the relaxed Tabor number
//! creep      τ_j v̇_j = J_j p − v_j                   Voigt strains, carried as pressures
//! law        p = s(g)                                 positive in compression
//! control    a Δ + b F = c(t)                         penetration, force, or a frame in between
//! ```
//! A is the influence of a ring of pressure on a half-space of unit modulus. No edge is tracked: a mesh follows the front.
//!
//! | file | what |
//! |---|---|
//! | `problem`, `scales` | what is asked, in which units |
//! | `tip`, `surface` | the undeformed tip; the law on it |
//! | `kernel`, `mesh`, `refine` | the influence of a ring; elements with kept blocks; where they are too long or too short |
//! | `chain`, `drive`, `step` | creep, control, one implicit step and its errors |
//! | `newton` | one elastic adhesive contact |
//! | `start`, `zero_range`, `jump`, `search` | first state, from the contact of zero range; what comes behind a fold; largest tension and zero force |
//! | `integration`, `book`, `kept_surface`, `result`, `assess` | the run, its record, its error bounds |
//! | `cycles` | stiffness, loss and extremes of every cycle of an oscillation, from the record |
//! | `exponential` | a second integrator, as a check |
//!
//! Sources: Greenwood (1997) and Feng (2000) for the elastic sphere; Maghami, Wang, Tricarico, Ciavarella, Li & Papangelo (2024) for the
//! viscoelastic one; Kennedy & Carpenter (2003) for the step.
//!
//! Laws with a hard wall take elements of low order (6): the pressure has a kink at the edge of the contact.
//!
//! Not yet here: inertia, contacts whose range is far below the zone (elastic Tabor numbers above about
//! 10 take thousands of steps), the tip that is not axisymmetric.

mod assess;
mod book;
mod chain;
mod cycles;
mod drive;
mod exponential;
mod integration;
mod jump;
mod kept_surface;
mod kernel;
mod mesh;
mod newton;
mod problem;
mod refine;
mod result;
mod scales;
mod search;
mod start;
mod state;
mod step;
mod surface;
mod tip;
mod zero_range;

pub use assess::{Assessed, Bounds, InstantBounds, Margins, assessed};
pub use cycles::cycles;
pub use exponential::run_by_exponentials;
pub use integration::{run, run_watched};
pub use kept_surface::{Place, Surface};
pub use mesh::Mesher;
pub use problem::{Accuracy, Control, Creep, Leg, Motion, Problem, Start};
pub use result::{Certificate, Jump, LegSummary, Record, Run, SUM_OF_DURATIONS, row_at};
pub use scales::Scales;
pub use state::Energies;
pub use tip::Shape;
