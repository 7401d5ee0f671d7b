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
use crate::refusal::{Refusal, require_positive};
use std::f64::consts::PI;

/// Adhesion of a wave contact in reduced units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveAdhesion {
    /// Γ = Δγ/(πE0*kΛ²).
    pub reduced_work: f64,
    /// δ of the trailing edge, in 1/k.
    pub trailing_zone: f64,
    /// δ of the leading edge, in 1/k.
    pub leading_zone: f64,
}

/// What was checked of an accepted state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Admissibility {
    /// Both edges are pulled, in the contact and in both moved ones.
    pub edges_pulled: bool,
    /// The smallest gap found outside the contact, over the largest.
    pub smallest_gap: f64,
}

impl Admissibility {
    /// Whether the state can exist.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.edges_pulled && self.smallest_gap > 0.0
    }
}

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

/// Newton steps before giving up.
const MOST_STEPS: u32 = 40;
/// Step of the difference quotients, relative to the smaller of a and π − a.
const DIFFERENCE: f64 = 1e-6;
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
    let what = "the edges of a sliding contact";
    let mut contact = start;
    let mut evaluations = 1;
    let mut here = closures(memory, adhesion, prescribed, contact)?;
    for _ in 0..MOST_STEPS {
        let size = largest(&here.residual);
        if size <= tolerance {
            return accepted(here, adhesion, evaluations);
        }
        let step = newton_step(memory, adhesion, prescribed, contact, &here)?;
        evaluations += 2;
        // Halve the step until the residual falls; a step that would close the contact or the gap is cut to a third of what is left.
        let room = 0.33 * contact.half_width.min(PI - contact.half_width);
        let mut scale = 1.0_f64.min(room / step.0.abs().max(f64::MIN_POSITIVE)).min(0.5 / step.1.abs().max(f64::MIN_POSITIVE));
        let mut improved = false;
        for _ in 0..12 {
            let tried =
                WaveContact { half_width: contact.half_width + scale * step.0, eccentricity: contact.eccentricity + scale * step.1 };
            evaluations += 1;
            match closures(memory, adhesion, prescribed, tried) {
                Ok(there) if largest(&there.residual) < size => {
                    contact = tried;
                    here = there;
                    improved = true;
                    break;
                }
                _ => scale *= 0.5,
            }
        }
        if !improved {
            // Rounding: accept what cannot be improved if it is small, otherwise say so.
            if size <= tolerance.max(1e-9) {
                return accepted(here, adhesion, evaluations);
            }
            return Err(Refusal::NotConverged { what, detail: format!("a residual of {size:.1e} does not fall any more") });
        }
    }
    Err(Refusal::NotConverged { what, detail: format!("{MOST_STEPS} Newton steps were not enough") })
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

/// The Newton step in (half-width, eccentricity).
fn newton_step(
    memory: &ContactMemory,
    adhesion: &WaveAdhesion,
    prescribed: Prescribed,
    contact: WaveContact,
    here: &Closures,
) -> Result<(f64, f64), Refusal> {
    let small = DIFFERENCE * contact.half_width.min(PI - contact.half_width);
    let wider = WaveContact { half_width: contact.half_width + small, ..contact };
    let ahead = WaveContact { eccentricity: contact.eccentricity + small, ..contact };
    let column = |moved: WaveContact| -> Result<[f64; 2], Refusal> {
        let there = closures(memory, adhesion, prescribed, moved)?;
        Ok([(there.residual[0] - here.residual[0]) / small, (there.residual[1] - here.residual[1]) / small])
    };
    let (width, shift) = (column(wider)?, column(ahead)?);
    let determinant = width[0] * shift[1] - width[1] * shift[0];
    let step = (
        -(here.residual[0] * shift[1] - here.residual[1] * shift[0]) / determinant,
        -(width[0] * here.residual[1] - width[1] * here.residual[0]) / determinant,
    );
    if step.0.is_finite() && step.1.is_finite() {
        Ok(step)
    } else {
        Err(Refusal::NotConverged { what: "the edges of a sliding contact", detail: "the Jacobian is singular: a fold is near".into() })
    }
}

fn accepted(closures: Closures, adhesion: &WaveAdhesion, evaluations: u32) -> Result<Equilibrium, Refusal> {
    let Closures { state, trailing_moved, leading_moved, residual } = closures;
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
        residual: largest(&residual),
        evaluations,
        admissibility,
        state,
    })
}

fn largest(residual: &[f64; 2]) -> f64 {
    residual[0].abs().max(residual[1].abs())
}
