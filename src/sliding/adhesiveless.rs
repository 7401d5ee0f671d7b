//! A sliding contact without adhesion: both edges without a stress singularity.
//!
//! The closure is not an energy balance then, but k = 0 at both edges: two equations for the two edges, as in the thesis's adhesiveless twin
//! (Sec 3.3). It is the limit Γ → 0 of the adhesive contact.

use super::contact::{ContactMemory, ContactState, Prescribed, WaveContact};
use super::edge_newton::{EdgeResidual, Edges, solve_edges};
use crate::refusal::Refusal;

/// An adhesiveless sliding contact.
#[derive(Debug, Clone, PartialEq)]
pub struct AdhesivelessContact {
    /// The contact.
    pub state: ContactState,
    /// Largest |k|/β of the two edges.
    pub residual: f64,
    /// Contacts solved.
    pub evaluations: u32,
}

struct Smooth(ContactState, f64);

impl EdgeResidual for Smooth {
    fn residual(&self) -> [f64; 2] {
        let (trailing, leading) = self.0.edge_amplitudes();
        [trailing / self.1, leading / self.1]
    }
}

/// Finds the edges near `start` at which neither is singular.
///
/// # Errors
/// [`Refusal::NotConverged`] if Newton's method does not converge from there; [`Refusal::OutOfRange`] for a mean pressure that is not positive.
pub fn adhesiveless(
    memory: &ContactMemory,
    prescribed: Prescribed,
    start: WaveContact,
    tolerance: f64,
) -> Result<AdhesivelessContact, Refusal> {
    if let Prescribed::MeanPressure(pressure) = prescribed
        && pressure.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater)
    {
        return Err(Refusal::out_of_range("mean_pressure", pressure, "greater than 0: nothing pulls without adhesion"));
    }
    let beta = memory.stiffening_ratio();
    let evaluate = |contact| Ok(Smooth(ContactState::new(memory, contact, prescribed)?, beta));
    let Edges { solution, residual, evaluations } =
        solve_edges("the edges of an adhesiveless sliding contact", evaluate, start, tolerance)?;
    Ok(AdhesivelessContact { state: solution.0, residual, evaluations })
}
