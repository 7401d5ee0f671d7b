//! The edges of an adhesive sliding contact: both closures at once.
//!
//! ```text
//! work_i(l₁, l₂) = (1/2δ_i) ∫ tension₊ gap₋ = 2πΓ at the trailing (i = 1) and at the leading edge (i = 2)
//! ```
//! Each work is quadratic in the amplitude of its edge, so √(work_i/2πΓ) − 1 is nearly linear in the edges: Newton's method on it, with a Jacobian
//! by differences, damped so that no edge crosses the other. Every contact has four roots, three of them unphysical with residuals of 1e-15:
//! after each solve the signs of the amplitudes, also in the moved contacts, and the gap are checked ([`Admissibility`]).
//!
//! Under load control the moved contacts keep the penetration of the contact as it is, not its load. Source: thesis Secs 3.2 and 3.3.

use super::contact::{ContactMemory, ContactState, Edge, Prescribed, WaveContact, edge_work};
use super::edge_newton::{EdgeResidual, Edges, solve_edges};
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

pub use super::edge_balance::{Admissibility, WaveAdhesion};

/// An adhesive sliding contact in equilibrium at both edges.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// The contact.
    pub state: ContactState,
    /// G/Δγ of the trailing edge: [U(edge moved) − U]/(2πΓδ) at fixed penetration.
    pub trailing_release: f64,
    /// G/Δγ of the leading edge.
    pub leading_release: f64,
    /// Largest |√(work/2πΓ) − 1| of the two edges.
    pub residual: f64,
    /// Evaluations of both closures (three contacts and two windows each).
    pub evaluations: u32,
    /// What was checked.
    pub admissibility: Admissibility,
}

/// Points at which the gap is looked at.
const GAP_POINTS: u32 = 48;

/// The closures at one pair of edges.
struct Closures {
    state: ContactState,
    trailing_moved: ContactState,
    leading_moved: ContactState,
    residual: [f64; 2],
}

/// Finds the edges near `start`, to a `tolerance` of the residual.
///
/// # Errors
/// [`Refusal::NotConverged`] if Newton's method does not converge to an admissible state from there; [`Refusal::OutOfRange`] for an adhesion
/// with a number that is not positive.
pub fn equilibrium(
    memory: &ContactMemory,
    adhesion: &WaveAdhesion,
    prescribed: Prescribed,
    start: WaveContact,
    tolerance: f64,
) -> Result<Equilibrium, Refusal> {
    require_positive("reduced_work", adhesion.reduced_work)?;
    require_positive("trailing_zone", adhesion.trailing_zone)?;
    require_positive("leading_zone", adhesion.leading_zone)?;
    let evaluate = |contact| closures(memory, adhesion, prescribed, contact);
    let Edges { solution, residual, evaluations } = solve_edges("the edges of an adhesive sliding contact", evaluate, start, tolerance)?;
    accepted(solution, adhesion, residual, evaluations)
}

impl EdgeResidual for Closures {
    fn residual(&self) -> [f64; 2] {
        self.residual
    }
}

fn closures(memory: &ContactMemory, adhesion: &WaveAdhesion, prescribed: Prescribed, contact: WaveContact) -> Result<Closures, Refusal> {
    let state = ContactState::new(memory, contact, prescribed)?;
    let held = Prescribed::Penetration(state.penetration());
    let (trailing, leading) = (adhesion.trailing_zone, adhesion.leading_zone);
    let moved = |out: f64, shift: f64| {
        let edges = WaveContact { half_width: contact.half_width + 0.5 * out, eccentricity: contact.eccentricity + shift };
        ContactState::new(memory, edges, held)
    };
    let trailing_moved = moved(trailing, -0.5 * trailing)?;
    let leading_moved = moved(leading, 0.5 * leading)?;
    let target = 2.0 * PI * adhesion.reduced_work;
    let defect = |work: f64| if work > 0.0 { (work / target).sqrt() - 1.0 } else { -1.0 + work / target };
    let residual = [
        defect(edge_work(&state, &trailing_moved, Edge::Trailing, trailing)),
        defect(edge_work(&state, &leading_moved, Edge::Leading, leading)),
    ];
    if residual.iter().any(|value| value.is_nan()) {
        return Err(Refusal::NotConverged { what: "the closure of a sliding edge", detail: "the work is not a number".into() });
    }
    Ok(Closures { state, trailing_moved, leading_moved, residual })
}

fn accepted(closures: Closures, adhesion: &WaveAdhesion, residual: f64, evaluations: u32) -> Result<Equilibrium, Refusal> {
    let Closures { state, trailing_moved, leading_moved, .. } = closures;
    let pulled = |contact: &ContactState| contact.edge_amplitudes().0 < 0.0 && contact.edge_amplitudes().1 < 0.0;
    let edges_pulled = pulled(&state) && pulled(&trailing_moved) && pulled(&leading_moved);
    let width = 2.0 * (PI - state.contact().half_width);
    let (mut smallest, mut largest_gap) = (f64::INFINITY, 0.0_f64);
    for index in 1..GAP_POINTS {
        // Dense at both edges, where interpenetration begins.
        let part = (0.5 * PI * f64::from(index) / f64::from(GAP_POINTS)).sin().powi(2);
        let gap = state.gap(state.behind_trailing(part * width)?);
        smallest = smallest.min(gap);
        largest_gap = largest_gap.max(gap);
    }
    let admissibility = Admissibility { edges_pulled, smallest_gap: smallest / largest_gap };
    if !admissibility.holds() {
        return Err(Refusal::NotConverged {
            what: "the edges of a sliding contact",
            detail: "the root found is unphysical (a pressed edge or interpenetrating faces)".into(),
        });
    }
    let release =
        |moved: &ContactState, zone: f64| (moved.interface_work() - state.interface_work()) / (2.0 * PI * adhesion.reduced_work * zone);
    Ok(Equilibrium {
        trailing_release: release(&trailing_moved, adhesion.trailing_zone),
        leading_release: release(&leading_moved, adhesion.leading_zone),
        residual,
        evaluations,
        admissibility,
        state,
    })
}
