//! How the two edge conditions, the penetration and the friction of a contact follow its unknowns and the parameters, by central differences of fourth order.

use crate::continuation::two_unknowns::TwoResiduals;
use crate::material::{CreepTerm, PlaneMaterial};
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Indenter, Prescribed, Resolution, WaveContact};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::sync::Arc;

/// Evaluations of both edge conditions for one linearization: four along each of three unknowns and three parameters, and one at the contact.
pub(super) const EVALUATIONS: u64 = 25;
/// Positions of the numbers that are differentiated: both conditions, Δ and friction.
pub(super) const QUANTITIES: usize = 4;
/// Rounding of Δ and friction over their sizes.
const ROUNDING: f64 = 40.0 * f64::EPSILON;
/// The weights of (f(−2h) − 8f(−h) + 8f(h) − f(2h))/12.
const WEIGHTS: [(f64, f64); 4] = [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)];

/// A contact of a steady problem with its surroundings: what is differentiated at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) material: &'a PlaneMaterial,
    pub(super) rate: f64,
    pub(super) indenter: Indenter,
    pub(super) adhesion: WaveAdhesion,
    /// a, e, p̄.
    pub(super) unknowns: [f64; 3],
}

/// Derivatives at a place.
#[derive(Debug, Clone)]
pub(super) struct Linearized {
    /// By a, e and p̄ in units of their scales.
    pub(super) by_unknown: [[f64; 3]; QUANTITIES],
    /// By the logarithms of the process zones, the works, β and the times; none of β where the solid is elastic.
    pub(super) by_zone: [f64; QUANTITIES],
    pub(super) by_work: [f64; QUANTITIES],
    pub(super) by_ratio: Option<[f64; QUANTITIES]>,
    pub(super) by_time: [f64; QUANTITIES],
    /// The scales of the unknowns.
    pub(super) scales: [f64; 3],
    /// What is left of both edge conditions at the place.
    pub(super) residual: [f64; 2],
    /// Δ and friction at the place.
    pub(super) values: [f64; 2],
    /// What rounding leaves uncertain of every derivative of a quantity.
    pub(super) rounding: [f64; QUANTITIES],
}

impl Place<'_> {
    fn balance(&self, memory: Arc<ContactMemory>, zones: f64, resolution: Resolution) -> EdgeBalance {
        let adhesion = if zones == 0.0 { self.adhesion } else { self.adhesion.with_zones_times(zones.exp()) };
        EdgeBalance::new(memory, self.indenter, Some(adhesion), SlidingControl::MeanPressure(self.unknowns[2]), resolution)
    }

    /// The derivatives at one resolution, with a `step` in scaled unknowns and in logarithms.
    pub(super) fn linearized(&self, resolution: Resolution, step: f64) -> Result<Linearized, Refusal> {
        let [half_width, eccentricity, pressure] = self.unknowns;
        let quantities = |balance: &EdgeBalance, unknowns: [f64; 3]| -> Result<[f64; QUANTITIES], Refusal> {
            let contact = WaveContact { half_width: unknowns[0], eccentricity: unknowns[1] };
            let found = balance.evaluate_at(contact, Prescribed::MeanPressure(unknowns[2]))?;
            let [trailing, leading] = found.residual();
            Ok([trailing, leading, found.state.penetration(), found.state.friction_stress()])
        };
        let memory = |material: &PlaneMaterial, rate: f64| ContactMemory::new(material, rate).map(Arc::new);
        let balance = self.balance(memory(self.material, self.rate)?, 0.0, resolution);
        let here = balance.evaluate_at(WaveContact { half_width, eccentricity }, Prescribed::MeanPressure(pressure))?;
        let length = half_width.min(self.indenter.widest() - half_width);
        let load = self.indenter.half_angle_scale(half_width) * here.state.stiffness_at_contact() + pressure.abs();
        let scales = [length, length, load];
        let mut by_unknown = [[0.0; 3]; QUANTITIES];
        for index in 0..3 {
            let column = differences(step, |moved| {
                let mut unknowns = self.unknowns;
                unknowns[index] += moved * scales[index];
                quantities(&balance, unknowns)
            })?;
            for (row, value) in by_unknown.iter_mut().zip(column) {
                row[index] = value;
            }
        }
        let by_zone =
            differences(step, |moved| quantities(&self.balance(memory(self.material, self.rate)?, moved, resolution), self.unknowns))?;
        // The solver sees times by kvτ only.
        let by_time = if self.rate > 0.0 && !self.material.is_elastic() {
            differences(step, |moved| {
                quantities(&self.balance(memory(self.material, self.rate * moved.exp())?, 0.0, resolution), self.unknowns)
            })?
        } else {
            [0.0; QUANTITIES]
        };
        let ratio = self.material.stiffening_ratio();
        let by_ratio = if self.material.is_elastic() {
            None
        } else {
            // β must stay above one.
            let share = 1.0 - 1.0 / ratio;
            let by_share = differences(step, |moved| {
                let stiffer = stiffened(self.material, (share * moved).exp())?;
                quantities(&self.balance(memory(&stiffer, self.rate)?, 0.0, resolution), self.unknowns)
            })?;
            Some(by_share.map(|value| value / share))
        };
        // residual + 1 is the root of a work over that of adhesion: exact.
        let [trailing, leading] = here.residual();
        let by_work = [-0.5 * (1.0 + trailing), -0.5 * (1.0 + leading), 0.0, 0.0];
        let (penetration, friction) = (here.state.penetration(), here.state.friction_stress());
        let digits = ROUNDING * (1.0 + here.state.condition().ln());
        let sizes = [penetration.abs() + load, friction.abs() + length.min(1.0) * load];
        let [first, second] = here.rounding;
        let rounding = [first, second, digits * sizes[0], digits * sizes[1]].map(|rounding| 1.5 * rounding / step);
        let residual = [trailing, leading];
        Ok(Linearized { by_unknown, by_zone, by_work, by_ratio, by_time, scales, residual, values: [penetration, friction], rounding })
    }
}

fn differences(step: f64, at: impl Fn(f64) -> Result<[f64; QUANTITIES], Refusal>) -> Result<[f64; QUANTITIES], Refusal> {
    let mut sum = [0.0; QUANTITIES];
    for (times, weight) in WEIGHTS {
        for (sum, value) in sum.iter_mut().zip(at(times * step)?) {
            *sum += weight * value / step;
        }
    }
    Ok(sum)
}

/// The solid with β multiplied: E0 and all retardation times held, the creep compliances all in one ratio.
pub(super) fn stiffened(material: &PlaneMaterial, factor: f64) -> Result<PlaneMaterial, Refusal> {
    let relaxed = material.solid_modulus("a stiffening ratio")?;
    let glassy = relaxed * material.stiffening_ratio() * factor;
    let gained: f64 = material.creep_terms().iter().map(|term| term.compliance).sum();
    let share = (glassy - relaxed) / glassy / relaxed / gained;
    let terms: Vec<CreepTerm> =
        material.creep_terms().iter().map(|term| CreepTerm { compliance: share * term.compliance, ..*term }).collect();
    PlaneMaterial::from_creep(glassy, &terms, None)
}
