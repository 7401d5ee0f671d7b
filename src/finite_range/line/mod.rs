//! Steady sliding of a periodic line or surface on a viscoelastic body that it attracts at a distance.
//!
//! In the frame of the profile everything is steady, so each wave of the pressure meets the body's modulus at one frequency:
//! ```text
//! A(n) = |n| conj(E(n_x kv)/E0)/S(|n|kd)        pressure over displacement of the wave n; S: compliance factor of a layer, 1 without one
//! p = A(g + h) + P                               A removes the mean; P is the mean pressure
//! friction stress = −⟨p h′⟩ = −⟨p w′⟩ = Σ n_x Im A⁻¹ |p_n|²
//! ```
//! One state costs some ten to a hundred products with A, each two fast Fourier transforms, whatever the material.
//!
//! [`solve`] gives one state with error bounds from three grids or more, [`follow`] the next one of a sweep, [`every`] the states that a search finds,
//! [`full_contact`] the closed form, [`trace`] a branch through its folds, [`locate`] a fold with its error, [`pull_off`] the one of a pulled contact.
//! Units: [`Problem`]. Several states may exist at one input; [`ReachedBy`] says from where one came, [`SteadyState::stability`] whether it stays.
//!
//! | file | idea |
//! |---|---|
//! | `problem` | profile, modulus, layer, control; units |
//! | `fourier`, `gmres` | transforms; linear solver |
//! | `grid`, `newton` | the equations on one grid; contact set and Newton |
//! | `reach` | from nothing to the state: range, modulus, grid |
//! | `solution`, `steady`, `full` | numbers and identities; states; full contact |
//! | `bounds` | errors from the differences between grids |
//! | `stability` | whether a state stays under a held load, gap or frame |
//! | `branch`, `fold` | pseudo-arclength; place of a fold |
//! | `roughness`, `measured` | self-affine surfaces; levelling and periodic ends of measured ones |

mod bounds;
mod branch;
mod fold;
mod fourier;
mod full;
mod gmres;
mod grid;
mod measured;
mod newton;
mod problem;
mod reach;
mod roughness;
mod solution;
mod stability;
mod steady;

pub use branch::{Branch, Direction, End, FoldKind, Refined, RoughFold, pull_off, trace, trace_refined};
pub use fold::{Fold, locate};
pub use full::full_contact;
pub use measured::{Ends, Levelling, level, periodic};
pub use problem::{Control, Harmonic, Modulus, Problem, Profile, Scales, modulus_of};
pub use reach::Path;
pub use roughness::{Roughness, rough};
pub use solution::{Certificate, Fields, Numbers};
pub use stability::StateStability;
pub use steady::{ReachedBy, Request, SteadyState, every, follow, solve};
