//! The edges of a collocated contact: both closures at once, by the Newton's method of [`viscotack::sliding::edge_balance`].

use super::closures::CollocatedClosures;
use super::scheme::SlidingCollocation;
use std::f64::consts::PI;
use viscotack::continuation::two_unknowns::{TwoEquations, TwoResiduals};
use viscotack::refusal::{Refusal, require_positive};
use viscotack::sliding::contact::{Prescribed, WaveContact};
use viscotack::sliding::edge_balance::WaveAdhesion;

/// Longest step of an edge in units of the narrower of contact and gap, and steps of difference quotients, as in ours.
const LONGEST_STEP: f64 = 0.33;
/// See [`LONGEST_STEP`].
const DIFFERENCE: f64 = 1e-6;

/// A collocated contact in equilibrium at both edges.
#[derive(Debug, Clone)]
pub struct CollocatedEquilibrium {
    /// The edges, in 1/k.
    pub edges: WaveContact,
    /// The contacts and the works at the edges.
    pub closures: CollocatedClosures,
    /// G/Δγ of the trailing edge (3.21).
    pub trailing_release: f64,
    /// G/Δγ of the leading edge (3.22).
    pub leading_release: f64,
    /// Largest |√(work/2πΓ) − 1| of the two edges.
    pub residual: f64,
    /// Evaluations of both closures (three dense contacts each).
    pub evaluations: u32,
}

/// The closures at one pair of edges.
struct AtEdges {
    edges: WaveContact,
    closures: CollocatedClosures,
    residual: [f64; 2],
}

impl TwoResiduals for AtEdges {
    fn residual(&self) -> [f64; 2] {
        self.residual
    }
}

impl SlidingCollocation {
    /// Finds the edges near `start`, to a `tolerance` of the residual. The root is not checked for its signs: start near the physical one.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`] if Newton's method does not converge from there, as it may where the closure jumps with an element that enters the
    /// process zone; [`Refusal::OutOfRange`] for an adhesion with a number that is not positive.
    pub fn equilibrium(
        &self,
        adhesion: &WaveAdhesion,
        prescribed: Prescribed,
        start: WaveContact,
        tolerance: f64,
    ) -> Result<CollocatedEquilibrium, Refusal> {
        let trailing = 2.0 * PI * require_positive("reduced_work", adhesion.trailing_work)?;
        let leading = 2.0 * PI * require_positive("reduced_work", adhesion.leading_work)?;
        let defect = |work: f64, target: f64| if work > 0.0 { (work / target).sqrt() - 1.0 } else { -1.0 + work / target };
        let evaluate = |[half_width, eccentricity]: [f64; 2]| -> Result<AtEdges, Refusal> {
            let edges = WaveContact { half_width, eccentricity };
            let closures = self.closures(adhesion, prescribed, edges)?;
            let residual = [defect(closures.trailing_work, trailing), defect(closures.leading_work, leading)];
            Ok(AtEdges { edges, closures, residual })
        };
        let room = |half_width: f64| half_width.min(PI - half_width);
        let limit = |unknowns: [f64; 2], step: [f64; 2]| {
            let part = |step: f64| LONGEST_STEP * room(unknowns[0]) / step.abs().max(f64::MIN_POSITIVE);
            part(step[0]).min(2.0 * part(step[1]))
        };
        let differences = |unknowns: [f64; 2]| [DIFFERENCE * room(unknowns[0]); 2];
        let equations = TwoEquations {
            what: "the edges of a collocated sliding contact",
            evaluate: &evaluate,
            limit: &limit,
            differences: &differences,
        };
        let found = equations.solve([start.half_width, start.eccentricity], None, tolerance)?;
        let (solution, residual, evaluations) = (found.solution, found.residual, found.evaluations);
        let (trailing_release, leading_release) = solution.closures.releases(adhesion);
        let AtEdges { edges, closures, .. } = solution;
        Ok(CollocatedEquilibrium { edges, closures, trailing_release, leading_release, residual, evaluations })
    }
}
