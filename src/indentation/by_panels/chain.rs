//! One point of the line: a glassy spring in series with n Voigt elements, or the same as n Maxwell branches beside a spring.
//!
//! ```text
//! free     Q = 0:       e_j(t) = e^{−(t−T)/τ_j} e_j(T),                       W = Σ e_j
//! bonded   W = Δ − f:   q_i(t) = e^{−(t−T)/ρ_i} [q_i(T) − P_i(T)] + P_i(t),    Q = E0 W + Σ q_i
//! between  e = T x,  T_ji = J_jE_iρ_i/(τ_j − ρ_i);     x = S e,  S_ij = τ_j/(τ_j − ρ_i);     x_i = W − q_i/E_i
//! ```
//! P_i(t) = E_i∫₀ᵗ e^{−(t−t′)/ρ_i} dΔ(t′) is the same for every point ([`super::drive`]).

/// The springs and dashpots of a solid, in moduli E*.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    /// E∞*.
    pub(super) glassy: f64,
    /// E0*.
    pub(super) relaxed: f64,
    /// J_j and 1/τ_j.
    pub(super) creep: Vec<(f64, f64)>,
    /// E_i and 1/ρ_i.
    pub(super) relaxation: Vec<(f64, f64)>,
    pub(super) to_voigt: Vec<f64>,
    pub(super) to_dashpots: Vec<f64>,
}

impl Chain {
    /// From moduli, (J_j, τ_j) and (E_i, ρ_i) of one solid.
    pub(super) fn new(glassy: f64, relaxed: f64, creep: &[(f64, f64)], relaxation: &[(f64, f64)]) -> Self {
        let to_voigt = creep.iter().flat_map(|&(j, tau)| relaxation.iter().map(move |&(e, rho)| j * e * (rho / (tau - rho)))).collect();
        let to_dashpots = relaxation.iter().flat_map(|&(_, rho)| creep.iter().map(move |&(_, tau)| tau / (tau - rho))).collect();
        let rates = |terms: &[(f64, f64)]| terms.iter().map(|&(weight, time)| (weight, time.recip())).collect();
        Self { glassy, relaxed, creep: rates(creep), relaxation: rates(relaxation), to_voigt, to_dashpots }
    }

    /// n.
    pub(super) fn terms(&self) -> usize {
        self.creep.len()
    }

    /// e of x.
    pub(super) fn voigt(&self, dashpots: &[f64], voigt: &mut [f64]) {
        map(&self.to_voigt, dashpots, voigt);
    }

    /// x of e.
    pub(super) fn dashpots(&self, voigt: &[f64], dashpots: &mut [f64]) {
        map(&self.to_dashpots, voigt, dashpots);
    }

    /// The shortest and the longest time of the bonded (ρ) or of the free (τ) chains.
    pub(super) fn times(&self, bonded: bool) -> [f64; 2] {
        let terms = if bonded { &self.relaxation } else { &self.creep };
        if terms.is_empty() {
            // An elastic solid has none: any will do.
            return [1.0; 2];
        }
        let rates = terms.iter().map(|&(_, rate)| rate);
        [rates.clone().fold(0.0, f64::max).recip(), rates.fold(f64::INFINITY, f64::min).recip()]
    }
}

pub(super) fn map(rows: &[f64], from: &[f64], to: &mut [f64]) {
    for (row, value) in rows.chunks_exact(from.len().max(1)).zip(to) {
        *value = row.iter().zip(from).map(|(entry, state)| entry * state).sum();
    }
}
