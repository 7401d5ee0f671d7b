//! The two edge conditions as equations of a curve in three unknowns.
//!
//! ```text
//! unknowns     ξ = ln tan(a/2) (parabola: ln(a/2)), e, p̄ | ln kv | ln Γ | ln zones;     of a held half-width p̄ in place of ξ
//! residuals    (r₁ + r₂)/2 and (r₂ − r₁)/q,      r_i = √(work_i/2πΓ) − 1
//! watched      −ln(1 − Δ), of a parabola Δ
//! ```
//! Width and gap have all their digits in ξ, Δ and 1 − Δ in its logarithm. An eccentricity tilts the load between the edges by e·sin a over the pressure scale of
//! the contact; near full contact that is little, and q is its size: where it is 1e-6, only the difference of the two conditions knows of e.

use super::conditions::{BranchPath, BranchProblem};
use crate::continuation::curve::{CurveEquations, Evaluated};
use crate::continuation::two_unknowns::TwoResiduals;
use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactMemory, Indenter, Prescribed, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, EdgeStates, SlidingControl};
use crate::sliding::steady::adhesion_at;
use std::cell::{Cell, RefCell};
use std::sync::Arc;

/// Values of the third unknown whose conditions are kept: here, and moved.
const RECENT: usize = 2;
/// Size of a residual's rounding, for the choice of difference steps.
const ROUNDING: f64 = 1e-15;

/// The equations of a branch at one resolution.
pub(super) struct BranchEquations<'a> {
    material: &'a PlaneMaterial,
    problem: &'a BranchProblem<'a>,
    resolution: Resolution,
    /// At the rate and adhesion of the problem; serves every point along loads and adhesions.
    prepared: EdgeBalance,
    memory: Arc<ContactMemory>,
    evaluations: Cell<u64>,
    /// Those of the last values of the third unknown, along speeds and zones.
    recent: RefCell<Vec<(f64, EdgeBalance)>>,
}

impl<'a> BranchEquations<'a> {
    /// Prepares the equations.
    ///
    /// # Errors
    /// Those of the material at that rate.
    pub(super) fn new(material: &'a PlaneMaterial, problem: &'a BranchProblem<'a>, resolution: Resolution) -> Result<Self, Refusal> {
        let rate = if matches!(problem.path, BranchPath::Speeds(_)) { problem.parameters[0] } else { problem.rate };
        let prepared = Self::balance(material, problem, resolution, rate, 0.0)?;
        Ok(Self {
            material,
            problem,
            resolution,
            prepared,
            memory: Arc::new(ContactMemory::new(material, rate)?),
            evaluations: Cell::new(0),
            recent: RefCell::new(Vec::new()),
        })
    }

    fn balance(
        material: &PlaneMaterial,
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

    /// How often the conditions were evaluated, whether that led to anything or not.
    pub(super) fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    /// Uses the conditions at a value of the third unknown, which differences in the others share.
    fn with_balance<R>(&self, third: f64, run: impl FnOnce(&EdgeBalance) -> Result<R, Refusal>) -> Result<R, Refusal> {
        let mut recent = self.recent.borrow_mut();
        if let Some((_, balance)) = recent.iter().find(|(value, _)| value.to_bits() == third.to_bits()) {
            return run(balance);
        }
        let (rate, zones) = if matches!(self.problem.path, BranchPath::Zones(_)) { (self.problem.rate, third) } else { (third.exp(), 0.0) };
        let balance = Self::balance(self.material, self.problem, self.resolution, rate, zones)?;
        let found = run(&balance);
        recent.truncate(RECENT - 1);
        recent.insert(0, (third, balance));
        found
    }

    /// The conditions at the rate and adhesion of the problem.
    pub(super) const fn prepared(&self) -> &EdgeBalance {
        &self.prepared
    }

    /// The edges that the unknowns stand for.
    pub(super) fn edges(&self, [first, eccentricity, _]: [f64; 3]) -> ContactEdges {
        edges_at(self.problem, first, eccentricity)
    }

    /// The sizes of a contact.
    fn sizes(&self, unknowns: [f64; 3]) -> Sizes {
        let edges = self.edges(unknowns);
        let pressure = match self.problem.held() {
            None => unknowns[2],
            Some(SlidingControl::HalfWidth(_)) => unknowns[0],
            Some(SlidingControl::MeanPressure(pressure)) => pressure,
            Some(SlidingControl::Penetration(_)) => 0.0,
        };
        let slope = match self.problem.indenter {
            Indenter::Wave => 1.0 / (0.5 * edges.half_gap).tan().max(1e-12),
            Indenter::Parabola => 0.5 * edges.half_width,
        };
        let compliance = |memory: &ContactMemory| memory.kernel().harmonic_compliance(1.0 / edges.narrower().max(1e-12));
        let (real, imaginary) = match self.problem.path {
            BranchPath::Speeds(_) => {
                ContactMemory::new(self.material, unknowns[2].exp()).map_or_else(|_| compliance(&self.memory), |memory| compliance(&memory))
            }
            _ => compliance(&self.memory),
        };
        let stiffness = 1.0 / real.hypot(imaginary);
        let size = self.problem.indenter.half_angle_scale(edges.half_width).abs() * stiffness;
        let pull = (self.problem.adhesion.larger_work() * stiffness * slope).sqrt();
        let scale = size + pressure.abs() + pull;
        // Of a contact without adhesion p̄ = a²/4, and e is a part of a.
        let tilt = 4.0 / (stiffness * edges.width_by_place());
        Sizes { pressure: scale, press: size, pull, eccentricity: tilt * scale, tilt }
    }
}

/// The sizes of a contact.
struct Sizes {
    /// What presses, what pulls and what is there, as stiff as the solid is over the contact.
    pressure: f64,
    /// What presses.
    press: f64,
    /// What pulls.
    pull: f64,
    /// The eccentricity that changes the balance of the edges by as much as the pressure.
    eccentricity: f64,
    /// Eccentricity over pressure.
    tilt: f64,
}

/// The edges that a first unknown and an eccentricity stand for.
pub(super) fn edges_at(problem: &BranchProblem, first: f64, eccentricity: f64) -> ContactEdges {
    match problem.held() {
        Some(SlidingControl::HalfWidth(half_width)) => {
            ContactEdges::new(problem.indenter, crate::sliding::contact::WaveContact { half_width, eccentricity })
        }
        _ => ContactEdges::at_place(problem.indenter, first, eccentricity),
    }
}

impl CurveEquations for BranchEquations<'_> {
    type State = EdgeStates;

    fn evaluate(&self, unknowns: [f64; 3]) -> Result<Evaluated<EdgeStates>, Refusal> {
        self.evaluations.set(self.evaluations.get() + 1);
        let third = unknowns[2];
        let edges = self.edges(unknowns);
        let prescribed = match self.problem.held() {
            None => Prescribed::MeanPressure(third),
            Some(SlidingControl::MeanPressure(pressure)) => Prescribed::MeanPressure(pressure),
            Some(SlidingControl::Penetration(penetration)) => Prescribed::Penetration(penetration),
            Some(SlidingControl::HalfWidth(_)) => Prescribed::MeanPressure(unknowns[0]),
        };
        let here = |balance: &EdgeBalance| balance.evaluate_edges(edges, prescribed);
        let (states, factor) = match self.problem.path {
            BranchPath::Loads => (here(&self.prepared)?, 1.0),
            BranchPath::Speeds(_) | BranchPath::Zones(_) => (self.with_balance(third, here)?, 1.0),
            // residual + 1 is the root of a work over that of adhesion.
            BranchPath::Adhesions(_) => (here(&self.prepared)?, (self.problem.adhesion.trailing_work / third.exp()).sqrt()),
        };
        let [trailing, leading] = states.residual().map(|residual| (residual + 1.0) * factor - 1.0);
        let rounding = states.rounding.map(|rounding| rounding * factor * factor);
        let tilt = 1.0 / self.sizes(unknowns).eccentricity.max(1.0);
        let watched = match self.problem.indenter {
            Indenter::Wave if states.state.penetration() > 0.5 => -states.state.mean_separation().max(f64::MIN_POSITIVE).ln(),
            Indenter::Wave => -(-states.state.penetration()).ln_1p(),
            Indenter::Parabola => states.state.penetration(),
        };
        Ok(Evaluated {
            residual: [0.5 * (trailing + leading), (leading - trailing) / tilt],
            watched,
            rounding: [0.5 * (rounding[0] + rounding[1]), (rounding[0] + rounding[1]) / tilt],
            state: states,
        })
    }

    fn scales(&self, unknowns: [f64; 3]) -> [f64; 3] {
        let Sizes { pressure, eccentricity, .. } = self.sizes(unknowns);
        let eccentricity = if self.problem.indenter == Indenter::Wave { eccentricity.min(1.0) } else { eccentricity };
        match self.problem.held() {
            None => [1.0, eccentricity, pressure],
            Some(SlidingControl::HalfWidth(_)) => [pressure, eccentricity, 1.0],
            Some(_) => [1.0, eccentricity, 1.0],
        }
    }

    fn differences(&self, unknowns: [f64; 3]) -> [f64; 3] {
        // Between rounding over the step and curvature times it.
        [(ROUNDING * self.sizes(unknowns).eccentricity).sqrt().clamp(1e-6, 1e-3); 3]
    }

    fn natural(&self, unknowns: [f64; 3]) -> [f64; 3] {
        let scales = self.scales(unknowns);
        let Sizes { press, pull, tilt, .. } = self.sizes(unknowns);
        let eccentricity = scales[1].min(tilt * pull);
        match self.problem.held() {
            None => [scales[0].min(pull / press), eccentricity, scales[2].min(pull)],
            Some(SlidingControl::HalfWidth(_)) => [scales[0].min(pull), eccentricity, scales[2]],
            Some(_) => [scales[0].min(pull / press), eccentricity, scales[2]],
        }
    }

    fn admissible(&self, state: &EdgeStates) -> Result<bool, Refusal> {
        Ok(self.prepared.admissibility(state)?.holds())
    }
}
