//! The two edge conditions as equations of a curve in three unknowns.

use super::conditions::{BranchPath, BranchProblem};
use crate::continuation::arclength::{CurveEquations, Evaluated};
use crate::continuation::two_unknowns::TwoResiduals;
use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Indenter, Prescribed, Resolution, WaveContact};
use crate::sliding::edge_balance::{EdgeBalance, EdgeStates, SlidingControl};
use crate::sliding::steady::adhesion_at;
use std::sync::Arc;

/// The equations of a branch at one resolution.
pub(super) struct BranchEquations<'a> {
    material: &'a Material,
    problem: &'a BranchProblem<'a>,
    resolution: Resolution,
    /// At the rate and adhesion of the problem; serves every point along loads and adhesions.
    prepared: EdgeBalance,
    memory: Arc<ContactMemory>,
}

impl<'a> BranchEquations<'a> {
    /// Prepares the equations.
    ///
    /// # Errors
    /// Those of the material at that rate.
    pub(super) fn new(material: &'a Material, problem: &'a BranchProblem<'a>, resolution: Resolution) -> Result<Self, Refusal> {
        let rate = if matches!(problem.path, BranchPath::Speeds(_)) { problem.parameters[0] } else { problem.rate };
        let prepared = Self::balance(material, problem, resolution, rate, 0.0)?;
        Ok(Self { material, problem, resolution, prepared, memory: Arc::new(ContactMemory::new(material, rate)?) })
    }

    fn balance(
        material: &Material,
        problem: &BranchProblem<'_>,
        resolution: Resolution,
        rate: f64,
        zones: f64,
    ) -> Result<EdgeBalance, Refusal> {
        let memory = Arc::new(ContactMemory::new(material, rate)?);
        let factor = zones.exp();
        let adhesion = adhesion_at(problem.adhesion, problem.work_by_speed, problem.rate, rate).with_zones_times(factor);
        let control = problem.held().unwrap_or(SlidingControl::MeanPressure(0.0));
        Ok(EdgeBalance::new(memory, problem.indenter, Some(adhesion), control, resolution))
    }

    /// The pressure scale of a contact: what presses, what pulls and what is there, as stiff as the solid is over the contact.
    fn pressure_scale(&self, half_width: f64, pressure: f64) -> f64 {
        let half = (0.5 * half_width).clamp(0.0, 0.5 * std::f64::consts::PI - 1e-9);
        let slope = match self.problem.indenter {
            Indenter::Wave => half.tan(),
            Indenter::Parabola => half,
        };
        let (real, imaginary) = self.memory.kernel().harmonic_compliance(1.0 / half_width.abs().max(1e-12));
        let stiffness = 1.0 / real.hypot(imaginary);
        let size = self.problem.indenter.half_angle_scale(half_width).abs() * stiffness;
        size + pressure.abs() + (self.problem.adhesion.trailing_work.max(self.problem.adhesion.leading_work) * stiffness * slope).sqrt()
    }

    /// The scale of lengths at a half-width: that of contact or gap, whichever is narrower.
    fn length_scale(&self, half_width: f64) -> f64 {
        match self.problem.indenter {
            Indenter::Wave => half_width.sin().abs().max(1e-300),
            Indenter::Parabola => half_width.abs().max(1e-300),
        }
    }
}

impl CurveEquations for BranchEquations<'_> {
    type State = EdgeStates;

    fn evaluate(&self, [first, second, third]: [f64; 3]) -> Result<Evaluated<EdgeStates>, Refusal> {
        let (states, factor) = match self.problem.path {
            BranchPath::Loads => {
                let contact = WaveContact { half_width: first, eccentricity: second };
                (self.prepared.evaluate_at(contact, Prescribed::MeanPressure(third))?, 1.0)
            }
            BranchPath::Speeds(_) => {
                let balance = Self::balance(self.material, self.problem, self.resolution, third.exp(), 0.0)?;
                (balance.evaluate([first, second])?, 1.0)
            }
            // residual + 1 is the root of a work over that of adhesion.
            BranchPath::Adhesions(_) => {
                (self.prepared.evaluate([first, second])?, (self.problem.adhesion.trailing_work / third.exp()).sqrt())
            }
            BranchPath::Zones(_) => {
                let balance = Self::balance(self.material, self.problem, self.resolution, self.problem.rate, third)?;
                (balance.evaluate([first, second])?, 1.0)
            }
        };
        let residual = states.residual().map(|residual| (residual + 1.0) * factor - 1.0);
        let rounding = states.rounding.map(|rounding| rounding * factor * factor);
        Ok(Evaluated { residual, watched: states.state.penetration(), rounding, state: states })
    }

    fn scales(&self, [first, _, third]: [f64; 3]) -> [f64; 3] {
        match self.problem.held() {
            None => {
                let length = self.length_scale(first);
                [length, length, self.pressure_scale(first, third)]
            }
            Some(SlidingControl::HalfWidth(half_width)) => [self.pressure_scale(half_width, first), self.length_scale(half_width), 1.0],
            Some(_) => {
                let length = self.length_scale(first);
                [length, length, 1.0]
            }
        }
    }

    fn admissible(&self, state: &EdgeStates) -> Result<bool, Refusal> {
        Ok(self.prepared.admissibility(state)?.holds())
    }
}
