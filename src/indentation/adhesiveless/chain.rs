//! One point of the line, of a solid or of a liquid: what a time does to its strains, and the passage from one description to the other.
//!
//! ```text
//! in contact   W = Δ − f given:   u_i = W − (strain of dashpot i),   u̇_i = Δ̇ − u_i/ρ_i,   Q = E0 W + ΣE_i u_i
//! free         Q = 0:             e_j,   ė_j = −e_j/τ_j,   W = Σe_j       (a liquid has one more, 1/τ = 0: what has flowed)
//! between      e = T (W − u),  T_ji = φ_jE_iρ_i/(1 − ρ_i/τ_j),      W − u = S e,  S_ij = 1/(1 − ρ_i/τ_j);   φ_j = J_j/τ_j, of the flow 1/η
//! ```

use crate::material::Material;
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
}

impl Chain {
    pub(super) fn new(material: &Material) -> Result<Self, Refusal> {
        let maxwell: Vec<(f64, f64)> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
        let mut voigt: Vec<(f64, f64)> = material
            .creep_terms()
            .iter()
            .map(|term| (term.retardation_time.recip(), term.compliance / term.retardation_time))
            .collect();
        voigt.extend(material.steady_viscosity().map(|viscosity| (0.0, viscosity.recip())));
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
        Ok(Self { glassy: material.glassy_modulus(), relaxed: material.relaxed_modulus(), maxwell, voigt, to_voigt, to_dashpots })
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

    fn mapped(&self, columns: &[f64], from: &[f64], to: &mut [f64]) {
        to.fill(0.0);
        for (column, state) in columns.chunks_exact(self.terms().max(1)).zip(from) {
            for (value, entry) in to.iter_mut().zip(column) {
                *value += entry * state;
            }
        }
    }
}
