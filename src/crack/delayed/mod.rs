//! Delayed fracture, and cracks under any load history: when a crack starts, where its tip is, when it stops and starts again.
//!
//! ```text
//!      K │      ┌────────────┐              x₀ │                  ╱      rest: the solid creeps and the work of the tip stresses rises
//!        │   ╱──┘            │                 │          ______╱        growth: it stays equal to Δγ
//!        │  ╱                └────             │        ╱  arrest        kink: the place of the start leaves the process zone
//!        └──────────────────────── t           └───────┴──────────── t
//!                                                     t_d
//! ```
//! | symbol | name here | unit |
//! |---|---|---|
//! | K(t) ≥ 0 | `intensity` of the stress, opening | Pa √m |
//! | x₀(t) | `growth`: how far the tip has run since the start of the history, never decreasing | m |
//! | δ | `process_zone`: one length for a whole history, or δ(t) at the current load | m |
//! | Δγ | `work_of_adhesion` | J/m² |
//! | t_d | `delay`: the time from loading to first growth | s |
//! | c | deformable halves, [`CrackBody`](crate::crack::CrackBody) | – |
//! | κ = K/√(2ΔγE∞/c) | inside: load over the glassy limit | – |
//!
//! The tip fields at time t are K(t)/√(2πd) ahead and, behind, the gap that J makes of the tip fields of all earlier times. As in the
//! steady theory the closure integral collapses exactly, now for any K(t) and x₀(t) (thesis Eqs 5.50–5.67, roots mended):
//! ```text
//! w(x,t) = ½cK(t) { K(t)/E∞ + ∫₋∞ᵗ J′(t − t₁) K(t₁) [1 − (x − x₀(t₁))/δ]₊ dt₁ }        w ≤ Δγ,  and = Δγ while the tip runs
//! ```
//! The bracket is the part of the process zone that was already open at t₁; so only the time spent in the last δ counts. The crack never
//! heals (thesis Sec 5.4). w falls with x, so a load step up that would make it exceed Δγ moves the tip at once by a finite jump, and a load
//! at the glassy limit κ = 1 moves it without bound.
//!
//! | file | one idea |
//! |---|---|
//! | [`load`] | K(t) from steps, holds, ramps, tables, cycles; from the stress on a strip |
//! | [`problem`] | material, interface and zone length |
//! | [`mod@regime`] | no growth, delayed, immediate: which inequality of Eq 5.68 decides |
//! | [`mod@onset`] | delay and first speed under a constant load, Eq 5.66 |
//! | [`moments`] | an exponential against a cubic, for any ratio of step to time |
//! | [`memory`] | the memory of a moving window, term by term |
//! | [`first_crossing`] | the first time at which a resting tip starts, proved to be the first |
//! | [`quasi_steady`] | growth over very many zones under a slow load |
//! | [`zone`] | the process zone over the greatest one |
//! | [`stepper`] | one run at one step size |
//! | [`mod@trajectory`] | four runs, with an error for every number |
//! | [`FinishedRuns`] | what a killed history goes on from |
//! | [`validity`] | numbers that say where the model's assumptions end |
//!
//! # A zone that follows the load
//! [`GrowthProblem::following`] takes δ(t) = α(K(t)/(√(2π)σ_c))² at the current load. The closure is virtual work at one frozen instant (thesis
//! Sec 4.3: nothing is re-solved while the edge is moved by δ): stress and gap are the fields of the time t, and neither of them knows δ, as both are
//! those of a sharp tip, stress K(t)/√(2πd), gap a superposition of the tip fields of all earlier times. So only two things see δ(t): the
//! length of the virtual move, and how much of the stress and the gap lies within it,
//! ```text
//! (c/2δ) ∫₀^δ K(t)/√(2πd) · u(δ − d, t) dd,    u(s, t) = √(8/π) ∫ J(t − t₁) d[K(t₁) √(s − (x − x₀(t₁)))₊]
//! ∫₀^δ d^{−1/2} (δ − (x − x₁) − d)₊^{1/2} dd = (π/2)(δ − (x − x₁))₊        ⇒  the formula above with δ = δ(t)
//! ```
//! No term in dδ/dt appears: the zone has no state of its own, so lengthening it at a resting tip costs and gives nothing, and the balance stays
//! closed. What follows: the delay is untouched (at rest x = x₁, the bracket is 1 for any δ); the first speed takes δ(t_d); w still falls with x and now rises
//! with K twice, through K and through δ, so growth is as well posed as before; a growing zone takes places back in that had left it, a
//! shrinking one lets them go without motion; under a constant load nothing changes, so the late speed is the steady one with δ(K). A cohesive zone with
//! a traction law would store and release work as it lengthens; this theory has none (see `docs/src/verification/named_gaps.md`).
//!
//! **Choices.** [`GrowthProblem::new`] keeps one length for a history: the thesis's (5.69) with its constant K, or that at a stated intensity. Moduli are
//! those of the plane problem, as in [`crate::crack`].

mod finished_runs;
pub mod first_crossing;
pub mod load;
pub mod memory;
pub mod moments;
pub mod onset;
pub mod problem;
pub mod quasi_steady;
pub mod regime;
pub mod stepper;
pub mod trajectory;
pub mod validity;
pub mod zone;

pub use finished_runs::{FinishedRuns, GrowthWatch, Unwatched};
pub use load::{LoadHistory, LoadSegment, Wave};
pub use onset::{Onset, onset};
pub use problem::GrowthProblem;
pub use regime::{Regime, RegimeReport, regime};
pub use trajectory::{Event, EventKind, Resolution, Sample, TipState, Trajectory, refined_from, refined_until, trajectory};
