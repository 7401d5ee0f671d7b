//! One point of the line: a glassy spring in series with n Voigt elements, updated exactly for any number of terms.
//!
//! ```text
//! free     Q = 0:          ė_j = −e_j/τ_j                                  each Voigt strain on its own
//! bonded   W given:        v̇_i = (W − v_i)/ρ_i                              each dashpot of the RELAXATION series on its own
//! between  e = T v,  T_ji = J_jE_iρ_i/(τ_j − ρ_i);      v = S e,  S_ij = τ_j/(τ_j − ρ_i)      T = S⁻¹
//! ```
//! v_i are the strains of the dashpots of the equivalent Maxwell branches, Q = E0*W + ΣE_i(W − v_i). A point carries v while it is bonded and e
//! while it is free, so that each update costs n, and only a point that the edge passes is mapped (n²). The maps are partial fractions of the
//! two transfer functions; the times interlace, so no denominator vanishes. Both states are continuous when the edge passes; only Q and W jump.

use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::special::exponential_mean::exponential_mean_complement_with;

/// Highest power of the time in which Δ may go within a step.
pub(super) const DEGREE: usize = 5;

/// The chain of springs and dashpots of a material, in moduli E*.
#[derive(Debug, Clone, PartialEq)]
pub struct Springs {
    /// E∞* (Pa).
    pub glassy: f64,
    /// E0* (Pa).
    pub relaxed: f64,
    /// J_j and τ_j.
    pub creep: Vec<(f64, f64)>,
    /// E_i and ρ_i.
    pub relaxation: Vec<(f64, f64)>,
    /// The columns of T, then of S.
    to_voigt: Vec<f64>,
    to_maxwell: Vec<f64>,
}

/// What a time does to every bonded point alike.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Following {
    /// 1 − e^{−t/ρ_i}.
    pub(super) relaxed: Vec<f64>,
    /// Σ_k w_k ψ_k(t/ρ_i), what each dashpot follows of W = W₀ + Σ w_k u^k.
    pub(super) followed: Vec<f64>,
}

impl Springs {
    /// The chain of a solid.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material (relaxed modulus 0).
    pub fn new(material: &PlaneMaterial) -> Result<Self, Refusal> {
        let relaxed = material.solid_modulus("the relaxed contact")?;
        let creep: Vec<_> = material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect();
        let relaxation: Vec<_> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
        let to_voigt =
            relaxation.iter().flat_map(|&(e, rho)| creep.iter().map(move |&(j, tau)| j * e * (rho / (tau - rho)))).collect::<Vec<f64>>();
        let to_maxwell = creep.iter().flat_map(|&(_, tau)| relaxation.iter().map(move |&(_, rho)| tau / (tau - rho))).collect::<Vec<f64>>();
        if to_voigt.iter().chain(&to_maxwell).any(|entry| !entry.is_finite()) {
            return Err(Refusal::Undefined {
                quantity: "the spring chain of the material",
                reason: "a relaxation term is so weak that its two times coincide in double precision; leave it out".into(),
            });
        }
        Ok(Self { glassy: material.glassy_modulus(), relaxed, creep, relaxation, to_voigt, to_maxwell })
    }

    /// n.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.creep.len()
    }

    /// The shortest relaxation time, infinite for an elastic material.
    #[must_use]
    pub(crate) fn shortest_time(&self) -> f64 {
        self.relaxation.iter().fold(f64::INFINITY, |least, &(_, rho)| least.min(rho))
    }

    /// The longest retardation time (s), 0 for an elastic material.
    #[must_use]
    pub fn longest_retardation_time(&self) -> f64 {
        self.creep.iter().fold(0.0, |most, &(_, tau)| most.max(tau))
    }

    /// e_j of given v_i.
    pub(super) fn voigt(&self, maxwell: &[f64], voigt: &mut [f64]) {
        map(&self.to_voigt, maxwell, voigt);
    }

    /// v_i of given e_j.
    pub(super) fn maxwell(&self, voigt: &[f64], maxwell: &mut [f64]) {
        map(&self.to_maxwell, voigt, maxwell);
    }

    /// Q at W of a bonded point.
    pub(super) fn load(&self, displacement: f64, maxwell: impl Iterator<Item = f64>) -> f64 {
        let branches = self.relaxation.iter().zip(maxwell);
        self.relaxed * displacement + branches.map(|(&(modulus, _), dashpot)| modulus * (displacement - dashpot)).sum::<f64>()
    }

    /// e^{−t/τ_j}.
    pub(super) fn kept(&self, time: f64, kept: &mut Vec<f64>) {
        kept.clear();
        kept.extend(self.creep.iter().map(|&(_, tau)| (-time / tau).exp()));
    }

    /// How dashpots follow W = W₀ + Σ w_k u^k, u the part of a time, w_k = `powers[k − 1]`.
    pub(super) fn following(&self, time: f64, powers: &[f64], following: &mut Following) {
        following.relaxed.clear();
        following.followed.clear();
        let mut used = powers.len();
        while used > 1 && powers.get(used - 1).is_none_or(|power| *power == 0.0) {
            used -= 1;
        }
        for &(_, rho) in &self.relaxation {
            let x = time / rho;
            let fallen = (-x).exp_m1();
            following.relaxed.push(-fallen);
            following.followed.push(match powers.get(..used) {
                Some([rise]) => rise * exponential_mean_complement_with(x, fallen),
                Some(powers) => {
                    let weights = responses(x, fallen);
                    powers.iter().zip(weights).map(|(power, weight)| power * weight).sum()
                }
                None => 0.0,
            });
        }
    }
}

impl Following {
    /// The dashpots after that time, from W₀.
    pub(super) fn advance(&self, maxwell: &mut [f64], displacement: f64) {
        for ((dashpot, relaxed), followed) in maxwell.iter_mut().zip(&self.relaxed).zip(&self.followed) {
            *dashpot = after(*dashpot, displacement, *relaxed, *followed);
        }
    }

    /// The same of dashpots that stay as they are.
    pub(super) fn advanced(&self, maxwell: &[f64], displacement: f64) -> impl Iterator<Item = f64> {
        let branches = maxwell.iter().zip(&self.relaxed).zip(&self.followed);
        branches.map(move |((dashpot, relaxed), followed)| after(*dashpot, displacement, *relaxed, *followed))
    }
}

/// A dashpot after a time.
fn after(dashpot: f64, displacement: f64, relaxed: f64, followed: f64) -> f64 {
    dashpot + ((displacement - dashpot) * relaxed + followed)
}

/// The sum of the columns of a matrix, each times its state: column by column, all rows side by side.
fn map(columns: &[f64], from: &[f64], to: &mut [f64]) {
    to.fill(0.0);
    for (column, state) in columns.chunks_exact(from.len().max(1)).zip(from) {
        for (value, entry) in to.iter_mut().zip(column) {
            *value += entry * state;
        }
    }
}

/// ψ_k(x) = x∫₀¹ e^{−x(1−u)} u^k du for k = 1…: ψ_k = 1 − (k/x)ψ_{k−1}, upwards for large x and downwards from a series for small x.
/// `fallen`: e^{−x} − 1.
fn responses(x: f64, fallen: f64) -> [f64; DEGREE] {
    let mut values = [0.0; DEGREE];
    let top = DEGREE as f64;
    if x > top {
        let mut last = -fallen;
        for (k, value) in values.iter_mut().enumerate() {
            last = 1.0 - (k as f64 + 1.0) / x * last;
            *value = last;
        }
        return values;
    }
    // Alternating and, for x ≤ DEGREE, falling from the first term on: 40 terms reach rounding, and a term that no longer counts is followed by smaller ones.
    let (mut term, mut sum) = (x / (top + 1.0), 0.0);
    for m in 1..40 {
        let next = sum + term;
        if next.to_bits() == sum.to_bits() {
            break;
        }
        sum = next;
        term *= -x / (top + 1.0 + f64::from(m));
    }
    for k in (0..DEGREE).rev() {
        values[k] = sum;
        sum = x * (1.0 - sum) / (k as f64 + 1.0);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::gauss_legendre::UNIT_RULE_20;

    /// ψ_k against quadrature with graded panels.
    #[test]
    fn responses_are_integrals() {
        for x in [1e-12, 1e-3, 0.3, 1.0, 4.0, 4.9, 5.1, 8.0, 60.0, 1e4] {
            for (k, value) in responses(x, (-x).exp_m1()).into_iter().enumerate() {
                let mut exact = 0.0;
                let (mut high, mut low) = (1.0, 0.5);
                for _ in 0..60 {
                    for &(node, weight) in UNIT_RULE_20.iter() {
                        let y = low + (high - low) * node;
                        exact += weight * (high - low) * x * (-x * y).exp() * (1.0 - y).powi(k as i32 + 1);
                    }
                    (high, low) = (low, 0.5 * low);
                }
                assert!((value / exact - 1.0).abs() < 1e-13, "{x} {k} {value} {exact}");
            }
        }
    }
}
