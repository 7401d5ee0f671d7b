//! The periodic state of a contact under an oscillating penetration, without the transient that leads to it.
//!
//! The unknown is the path of the edge over one cycle. Given it, every chain of the line has one periodic state, closed exactly whatever its relaxation times
//! (`closed_chains`). From that line the panels of this room integrate one cycle (`cycle_map`), which gives another path; the periodic path is the one that
//! gives itself. Plain repetition converges slowly: the edge takes many cycles to settle. Anderson's acceleration of the path takes five to ten (`anderson`).
//! Two cycles integrated from the state that was found say how far it still changes, and two paths, of degrees p and p + 2, how well it is known (`solution`).
//!
//! | file | what |
//! |---|---|
//! | `sinus` | Δ and the memory P_i of a sinus without end |
//! | `closed_path` | a path that ends where it starts; its two turns |
//! | `closed_chains` | the line of a closed path |
//! | `cycle_map` | one cycle from that line; its path and its rows |
//! | `anderson` | the next path from the last ones |
//! | `settled` | the periodic path of one degree and tolerance |
//! | `integrals` | stiffness, work, means and extremes of a cycle |
//! | `solution` | values with bounds |

mod anderson;
mod closed_chains;
mod closed_path;
mod cycle_map;
mod integrals;
mod settled;
mod sinus;
mod solution;

pub use solution::{PeriodicState, solve_periodic};
