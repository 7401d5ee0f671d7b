//! One point of the line, of a solid or of a liquid: what a time does to its strains, and the passage from one description to the other.
//!
//! ```text
//! in contact   W = Δ − f given:   u_i = W − (strain of dashpot i),   u̇_i = Δ̇ − u_i/ρ_i,   Q = E0 W + ΣE_i u_i
//! free         Q = 0:             e_j,   ė_j = −e_j/τ_j,   W = Σe_j       (a liquid has one more, 1/τ = 0: what has flowed)
//! between      e = T (W − u),  T_ji = φ_jE_iρ_i/(1 − ρ_i/τ_j),      W − u = S e,  S_ij = 1/(1 − ρ_i/τ_j);   φ_j = J_j/τ_j, of the flow 1/η
//! ```

use crate::material::PlaneMaterial;
use crate::refusal::Refusal;

/// The springs and dashpots of a material, in moduli E*.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub(super) glassy: f64,
    pub(super) relaxed: f64,
    /// E_i and ρ_i.
    pub(super) maxwell: Vec<(f64, f64)>,
    /// 1/τ_j and φ_j.
    pub(super) voigt: Vec<(f64, f64)>,
    /// The columns of T and of S.
    to_voigt: Vec<f64>,
    to_dashpots: Vec<f64>,
    /// What rounding leaves of a strain after a passage, over the depth and as it weighs in S: of each u_i, and of each e_j.
    pub(super) noise: [Vec<f64>; 2],
}

/// Rates nearer than this, relative, are one: a mean of them is exact to the square of it.
const SAME: f64 = 3e-8;
/// Rounding of a sum of a few terms.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl Chain {
    pub(super) fn new(material: &PlaneMaterial) -> Result<Self, Refusal> {
        let maxwell: Vec<(f64, f64)> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
        let mut voigt: Vec<(f64, f64)> =
            material.creep_terms().iter().map(|term| (term.retardation_time.recip(), term.compliance / term.retardation_time)).collect();
        voigt.extend(material.steady_viscosity().map(|viscosity| (0.0, viscosity.recip())));
        let maxwell = distinct(maxwell, &mut voigt);
        if voigt.len() != maxwell.len() {
            return Err(Refusal::Undefined {
                quantity: "the spring chain of the material",
                reason: "its creep and relaxation series have different numbers of terms".into(),
            });
        }
        let gap = |rho: f64, rate: f64| 1.0 - rho * rate;
        let to_voigt: Vec<f64> = maxwell
            .iter()
            .flat_map(|&(modulus, rho)| voigt.iter().map(move |&(rate, flow)| flow * modulus * rho / gap(rho, rate)))
            .collect();
        let to_dashpots: Vec<f64> =
            voigt.iter().flat_map(|&(rate, _)| maxwell.iter().map(move |&(_, rho)| gap(rho, rate).recip())).collect();
        if to_voigt.iter().chain(&to_dashpots).any(|entry| !entry.is_finite()) {
            return Err(Refusal::Undefined {
                quantity: "the spring chain of the material",
                reason: "a relaxation term is so weak that its two times coincide in double precision; leave it out".into(),
            });
        }
        let glassy = material.glassy_modulus();
        let terms = maxwell.len();
        let sum_of_row = |columns: &[f64], row: usize| columns.iter().skip(row).step_by(terms.max(1)).map(|entry| entry.abs()).sum::<f64>();
        let noise = [
            (0..terms).map(|i| ROUNDING * maxwell[i].0 / glassy * sum_of_row(&to_dashpots, i)).collect(),
            (0..terms).map(|j| ROUNDING * sum_of_row(&to_voigt, j)).collect(),
        ];
        Ok(Self { glassy, relaxed: material.relaxed_modulus(), maxwell, voigt, to_voigt, to_dashpots, noise })
    }

    /// n.
    pub(super) fn terms(&self) -> usize {
        self.maxwell.len()
    }

    /// The shortest relaxation time, infinite for an elastic material.
    pub(super) fn shortest_time(&self) -> f64 {
        self.maxwell.iter().fold(f64::INFINITY, |least, &(_, rho)| least.min(rho))
    }

    /// The longest retardation time that ends, at least the longest relaxation time; 0 for an elastic material.
    pub(super) fn longest_time(&self) -> f64 {
        let relaxation = self.maxwell.iter().fold(0.0, |most: f64, &(_, rho)| most.max(rho));
        self.voigt.iter().filter(|(rate, _)| *rate > 0.0).fold(relaxation, |most, &(rate, _)| most.max(rate.recip()))
    }

    /// How long a difference is remembered: the longest time, for ever where something flows.
    pub(super) fn memory(&self) -> f64 {
        if self.voigt.iter().any(|(rate, _)| *rate == 0.0) { f64::INFINITY } else { self.longest_time() }
    }

    /// What leaves contact at W: u becomes e, in place.
    pub(super) fn released(&self, displacement: f64, state: &mut [f64], scratch: &mut Vec<f64>) {
        scratch.clear();
        scratch.extend(state.iter().map(|u| displacement - u));
        self.mapped(&self.to_voigt, scratch, state);
    }

    /// What comes into contact at W: e becomes u, in place.
    pub(super) fn touched(&self, displacement: f64, state: &mut [f64], scratch: &mut Vec<f64>) {
        scratch.clear();
        scratch.extend_from_slice(state);
        self.mapped(&self.to_dashpots, scratch, state);
        for u in state {
            *u = displacement - *u;
        }
    }

    /// What a difference of the u_i becomes of the e_j once the chain is free, or of the e_j of what the u_i make of S once it is in contact: the largest part.
    pub(super) fn beyond(&self, in_contact: bool, difference: &[f64], scratch: &mut Vec<f64>) -> f64 {
        scratch.resize(difference.len(), 0.0);
        if in_contact {
            self.mapped(&self.to_voigt, difference, scratch);
            return scratch.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        }
        self.mapped(&self.to_dashpots, difference, scratch);
        let parts = scratch.iter().zip(&self.maxwell);
        parts.fold(0.0, |most: f64, (part, (modulus, _))| most.max((part * modulus / self.glassy).abs()))
    }

    fn mapped(&self, columns: &[f64], from: &[f64], to: &mut [f64]) {
        to.fill(0.0);
        for (column, state) in columns.chunks_exact(self.terms().max(1)).zip(from) {
            for (value, entry) in to.iter_mut().zip(column) {
                *value += entry * state;
            }
        }
    }
}

/// Relaxation terms without two that double precision cannot keep apart, and without the retardation rates between those.
fn distinct(terms: Vec<(f64, f64)>, voigt: &mut Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::with_capacity(terms.len());
    for (modulus, rho) in terms {
        match kept.last_mut() {
            Some((other, time)) if (*time - rho).abs() <= SAME * rho => {
                let (first, second) = (*time, rho);
                let rate = (*other / first + modulus / second) / (*other + modulus);
                *other += modulus;
                *time = rate.recip();
                let between = voigt.iter().position(|(slowness, _)| {
                    let tau = slowness.recip();
                    tau <= first.max(second) * (1.0 + 4.0 * f64::EPSILON) && tau >= first.min(second) * (1.0 - 4.0 * f64::EPSILON)
                });
                if let Some(place) = between {
                    voigt.remove(place);
                }
            }
            _ => kept.push((modulus, rho)),
        }
    }
    kept
}
