//! The sphere's time integration by panels of the edge's path: beside the time integration of this room until the two agree on 3,000 scenes.
//!
//! Nothing is stepped. The line is a list of segments that hold, as polynomials, when the edge passed a point and in which state it left
//! it; the fields of any later time follow exactly. The unknown is the path of the edge, one polynomial after the other, which obeys the
//! closure at Radau points.
//!
//! | file | what |
//! |---|---|
//! | `chain` | one point of the line: Maxwell ↔ Voigt |
//! | `drive` | the imposed penetration and the memory P_i that all bonded points share |
//! | `line`, `merge` | segments, fields; old segments joined |
//! | `kernel`, `window`, `closure` | C and its derivatives by the instants of passage |
//! | `path`, `newton`, `check` | a panel, its solution, its defect and the test for the first root |
//! | `outset`, `jump`, `events` | directions and speeds from rest, instabilities, cuts of a panel |
//! | `integration`, `course`, `record`, `force`, `start` | the history |
//! | `followed` | force and frame: the penetration as a second unknown |
//! | `prescribed` | a given radius: the penetration as the only unknown |
//! | `at_once` | sudden steps |
//! | `flight` | after the contact, until the surfaces touch again |
//! | `energies`, `turned_over`, `surface` | what is stored and lost; pressure and displacement |
//! | `cycles`, `cycle_sums` | rows of the cycles of an oscillation |
//! | `problem`, `setup`, `solve` | what is asked and given |
//! | `solution` | a history with bounds, from two paths |
//! | `checkpoint` | what a killed run goes on from |
//! | `trail`, `periodic` | the path kept; the periodic state of an oscillation |
//!
//! | symbol | meaning |
//! |---|---|
//! | a, δ, Δ, f(s) | edge, process zone, penetration, line profile; as in [`super`] |
//! | θ | −1…1, parameter of a panel |
//! | T, X | instant and state of passage |
//! | y | place in the window: inside a − y, outside a + δ − y |
//! | λ | part of a panel's times, in the test for the first root |
//!
//! Measured on states of an independent program (`tests/indentation/by_panels.rs`): 1e-8 at degree 5, tolerance 1e-6; 1e-10 at degree 7, 1e-8.
//! Of 4,732 integrations of random scenes at 1e-4 (ramps, approaches, cycles; one to four terms), and of 634 at 1e-5, none ends in a refusal, and the two
//! degrees of each scene agree. The power balance closes to 1e-9 of what is turned over.
//! Tables and power laws agree as well as spheres do (a table of eight points: degrees 5 and 7 differ by 2e-7 at 1e-6).
//! An edge that turns sets out without speed: what the last panel left of ∂C/∂t there fades on the next one, for states left by a path that turns with a speed have a
//! root at the turn that no series holds.
//! Bounds at an accuracy of 1e-3, beside paths a thousand times tighter: of 1,690 values of 59 random scenes none lies outside; bound over error is 3 to 4 in the median
//! and 105 to 194 in the 95th percentile.
//! Sudden steps, surfaces that touch again and rows of cycles agree with time steps within the bounds of both (`tests/indentation/by_panels_histories.rs`); a run
//! goes on from a checkpoint to the same bits (`tests/indentation/by_panels_checkpoints.rs`).
//! Not yet: bounds that cover in thousands of scenes; some turns of a force or frame; rims, edge laws, swept frequencies;
//! a path of many hundreds of cycles keeps all its points.

mod at_once;
mod chain;
mod check;
mod checkpoint;
mod closure;
mod course;
mod cycle_sums;
mod cycles;
mod drive;
mod energies;
mod events;
mod flight;
mod followed;
mod force;
mod gauss;
mod integration;
mod jump;
mod kernel;
mod line;
mod merge;
mod newton;
mod outset;
mod path;
mod periodic;
mod prescribed;
mod problem;
mod record;
mod setup;
mod solution;
mod solve;
mod start;
mod surface;
mod trail;
mod turned_over;
mod window;

pub(in crate::indentation) use checkpoint::PanelsState;
pub use energies::{Energies, TurnedOver};
pub use periodic::{PeriodicState, solve_periodic};
pub use problem::{End, Outcome, Row};
pub use solution::{path_by_panels, solve_by_panels, solve_by_panels_watched};
pub(in crate::indentation) use solution::{solve_from, surface_at};
pub use solve::{PanelOptions, integrate_by_panels};
