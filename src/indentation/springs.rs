//! One point of the line: a glassy spring in series with n Voigt elements, updated exactly for any number of terms.
//!
//! ```text
//! free     Q = 0:          ė_j = −e_j/τ_j                                  each strain on its own
//! bonded   W given:        v̇_i = (W − v_i)/ρ_i                              each dashpot of the RELAXATION series on its own
//! between  e = T v,  T_ji = J_jE_iρ_i/(τ_j − ρ_i);      v = S e,  S_ij = τ_j/(τ_j − ρ_i)      T = S⁻¹
//! ```
//! v_i are the strains of the dashpots of the equivalent Maxwell branches, Q = E∞W − ΣE_iv_i. The maps are partial fractions of the two
//! transfer functions; the times interlace, so no denominator vanishes, and for well separated times S is a triangle of ones.
//! Both states are continuous when the edge passes; only Q and W jump. Increments are mapped, never states, so that T·S need not be
//! the unit matrix to the last bit.

use crate::material::Material;
use crate::refusal::Refusal;
use crate::special::exponential_mean::exponential_mean_complement;

/// The chain of springs and dashpots of a material, in moduli E*.
#[derive(Debug, Clone, PartialEq)]
pub struct Springs {
    /// E∞*.
    pub glassy: f64,
    /// E0*.
    pub relaxed: f64,
    /// J_j and τ_j.
    pub creep: Vec<(f64, f64)>,
    /// E_i and ρ_i.
    pub relaxation: Vec<(f64, f64)>,
    to_voigt: Vec<f64>,
    to_maxwell: Vec<f64>,
}

/// What a time does to every point alike.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Lapse {
    /// 1 − e^{−t/τ_j}.
    freed: Vec<f64>,
    /// 1 − e^{−t/ρ_i}.
    relaxed: Vec<f64>,
    /// 1 − φ(t/ρ_i), the part of a linear increment of W that a dashpot follows.
    followed: Vec<f64>,
    scratch: Vec<f64>,
}

impl Springs {
    /// The chain of a solid.
    ///
    /// # Errors
    /// [`Refusal::Undefined`] for a viscous material (relaxed modulus 0).
    pub fn new(material: &Material) -> Result<Self, Refusal> {
        let relaxed = material.solid_modulus("the relaxed contact")?;
        let creep: Vec<_> = material.creep_terms().iter().map(|term| (term.compliance, term.retardation_time)).collect();
        let relaxation: Vec<_> = material.relaxation_terms().iter().map(|term| (term.modulus, term.relaxation_time)).collect();
        let to_voigt =
            creep.iter().flat_map(|&(j, tau)| relaxation.iter().map(move |&(e, rho)| j * e * (rho / (tau - rho)))).collect::<Vec<f64>>();
        let to_maxwell = relaxation.iter().flat_map(|&(_, rho)| creep.iter().map(move |&(_, tau)| tau / (tau - rho))).collect::<Vec<f64>>();
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
    pub fn shortest_time(&self) -> f64 {
        self.relaxation.iter().fold(f64::INFINITY, |least, &(_, rho)| least.min(rho))
    }

    pub(super) fn lapse(&self, time: f64, lapse: &mut Lapse) {
        lapse.freed.clear();
        lapse.freed.extend(self.creep.iter().map(|&(_, tau)| -(-time / tau).exp_m1()));
        lapse.relaxed.clear();
        lapse.relaxed.extend(self.relaxation.iter().map(|&(_, rho)| -(-time / rho).exp_m1()));
        lapse.followed.clear();
        lapse.followed.extend(self.relaxation.iter().map(|&(_, rho)| exponential_mean_complement(time / rho)));
        lapse.scratch.resize(self.terms(), 0.0);
    }

    /// The strains after a time without load.
    pub(super) fn free(strains: &mut [f64], lapse: &Lapse) {
        for (strain, freed) in strains.iter_mut().zip(&lapse.freed) {
            *strain -= *strain * freed;
        }
    }

    /// The strains after a time in which W rose linearly from `displacement` by `increment`.
    pub(super) fn bonded(&self, strains: &mut [f64], displacement: f64, increment: f64, lapse: &mut Lapse) {
        let n = strains.len();
        for (i, change) in lapse.scratch.iter_mut().enumerate() {
            let dashpot: f64 = self.to_maxwell.iter().skip(i * n).zip(strains.iter()).map(|(map, strain)| map * strain).sum();
            *change = (displacement - dashpot) * lapse.relaxed.get(i).unwrap_or(&0.0) + increment * lapse.followed.get(i).unwrap_or(&0.0);
        }
        for (j, strain) in strains.iter_mut().enumerate() {
            *strain += self.to_voigt.iter().skip(j * n).zip(&lapse.scratch).map(|(map, change)| map * change).sum::<f64>();
        }
    }
}
