//! An isotropic solid by its shear series G(t) and its bulk series K(t), and the series that contacts and cracks see.
//!
//! | modulus | with s the Laplace variable | where |
//! |---|---|---|
//! | Young's | E(s) = 9KG/(3K + G) | plane stress: a thin sheet |
//! | plane | E*(s) = E/(1 − ν²) = 4G(3K + G)/(3K + 4G) | plane strain, and every half-space without friction |
//!
//! Here G(s) = G0 + Σ g_i s/(s + 1/ρ_i), likewise K(s). A constant K, the usual card of a finite-element program, has no terms. Poisson's ratio
//! follows and changes with time, so a constant one would be wrong: see [`IsotropicSolid::poisson_ratios`].
//!
//! # How
//! Both moduli are rational functions of s, hence series of exponentials themselves, without any fit. With m = 1 for E and m = 4 for E*, the
//! poles are the zeros −r_j of 3K + mG, which [`conversion`] finds between the poles of the sum. Partial fractions there:
//! ```text
//! at a zero −r_j of 3K + mG     (27/m) K(−r_j)² J_j,   J_j: creep compliance of the sum 3K + mG at the time 1/r_j
//! at a time ρ of G and K both   E: 9kg/(3k + g)        E*: 4g(3k + g)/(3k + 4g), which is g where K has no term
//! ```
//! Every strength is a square or a product of positive numbers: the solid is passive. Source: Lee, Q. Appl. Math. 13 (1955) 183 for the
//! correspondence of elastic and viscoelastic problems; Gross (1953) for the poles and zeros. Errors: a few ulp, and those of the zeros, bounded.

use super::conversion::{self, SumZero};
use super::{Material, PlaneMaterial, RelaxationTerm};
use crate::refusal::{Refusal, require_positive};

/// An isotropic solid that relaxes in shear and, if its bulk series has terms, in volume.
#[derive(Debug, Clone, PartialEq)]
pub struct IsotropicSolid {
    shear: Material,
    bulk: Material,
    youngs: Material,
    plane_strain: PlaneMaterial,
}

impl IsotropicSolid {
    /// A solid from the shear modulus's and the bulk modulus's series (Pa).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a bulk modulus that relaxes to zero; [`Refusal::NotConverged`] or [`Refusal::Undefined`] for numbers
    /// outside about 1e-150…1e150.
    pub fn new(shear: Material, bulk: Material) -> Result<Self, Refusal> {
        require_positive("the relaxed bulk modulus", bulk.relaxed_modulus())?;
        let times = joined(&shear, &bulk);
        let youngs = combined(&shear, &bulk, &times, 1.0)?;
        let plane_strain = PlaneMaterial::of_plane_moduli(combined(&shear, &bulk, &times, 4.0)?);
        Ok(Self { shear, bulk, youngs, plane_strain })
    }

    /// G(t).
    #[must_use]
    pub const fn shear(&self) -> &Material {
        &self.shear
    }

    /// K(t).
    #[must_use]
    pub const fn bulk(&self) -> &Material {
        &self.bulk
    }

    /// The series of E = 9KG/(3K + G).
    #[must_use]
    pub const fn youngs(&self) -> &Material {
        &self.youngs
    }

    /// The series of E* = 4G(3K + G)/(3K + 4G).
    #[must_use]
    pub const fn plane_strain(&self) -> &PlaneMaterial {
        &self.plane_strain
    }

    /// ν = (3K − 2G)/(2(3K + G)) of an instantaneous load and of one held for ever.
    #[must_use]
    pub fn poisson_ratios(&self) -> [f64; 2] {
        let ratio = |shear: f64, bulk: f64| (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
        [ratio(self.shear.glassy_modulus(), self.bulk.glassy_modulus()), ratio(self.shear.relaxed_modulus(), self.bulk.relaxed_modulus())]
    }

    /// The same solid with every time multiplied by `factor`, in shear and in volume alike: what a temperature does.
    ///
    /// # Errors
    /// As [`Material::slowed`].
    pub fn slowed(&self, factor: f64) -> Result<Self, Refusal> {
        Ok(Self {
            shear: self.shear.slowed(factor)?,
            bulk: self.bulk.slowed(factor)?,
            youngs: self.youngs.slowed(factor)?,
            plane_strain: self.plane_strain.slowed(factor)?,
        })
    }
}

/// A time with the strengths of both series there.
struct Joint {
    time: f64,
    shear: f64,
    bulk: f64,
}

/// The times of both series, longest first; equal ones once.
fn joined(shear: &Material, bulk: &Material) -> Vec<Joint> {
    let of_shear = shear.relaxation_terms().iter().map(|term| Joint { time: term.relaxation_time, shear: term.modulus, bulk: 0.0 });
    let of_bulk = bulk.relaxation_terms().iter().map(|term| Joint { time: term.relaxation_time, shear: 0.0, bulk: term.modulus });
    let mut sorted: Vec<Joint> = of_shear.chain(of_bulk).collect();
    sorted.sort_by(|left, right| right.time.total_cmp(&left.time));
    let mut joint: Vec<Joint> = Vec::with_capacity(sorted.len());
    for one in sorted {
        match joint.last_mut() {
            Some(last) if last.time.to_bits() == one.time.to_bits() => {
                last.shear += one.shear;
                last.bulk += one.bulk;
            }
            _ => joint.push(one),
        }
    }
    joint
}

/// 9KG/(3K + G) for `multiple` 1, and 4G(3K + G)/(3K + 4G) for 4, of two elastic numbers.
fn elastic(shear: f64, bulk: f64, multiple: f64) -> f64 {
    // Ratios, so that no product of two moduli can overflow.
    if multiple > 1.0 {
        4.0 * shear * ((3.0 * bulk + shear) / (3.0 * bulk + 4.0 * shear))
    } else {
        9.0 * bulk * (shear / (3.0 * bulk + shear))
    }
}

/// Rounding of a product of a few numbers.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

fn combined(shear: &Material, bulk: &Material, times: &[Joint], multiple: f64) -> Result<Material, Refusal> {
    // 3K and mG, whose values at a zero are opposite.
    let parts = |shear: f64, bulk: f64| [3.0 * bulk, multiple * shear];
    let weights: Vec<(f64, [f64; 2])> = times.iter().map(|joint| (joint.time, parts(joint.shear, joint.bulk))).collect();
    let (relaxed_shear, relaxed_bulk) = (shear.relaxed_modulus(), bulk.relaxed_modulus());
    let zeros = conversion::zeros_of_sum(parts(relaxed_shear, relaxed_bulk), &weights)?;
    // (term, bound on its relative error)
    let mut terms: Vec<(RelaxationTerm, f64)> = Vec::with_capacity(zeros.len() + times.len());
    for joint in times.iter().filter(|joint| joint.shear > 0.0 && (joint.bulk > 0.0 || multiple > 1.0)) {
        let modulus = if joint.bulk > 0.0 { elastic(joint.shear, joint.bulk, multiple) } else { joint.shear };
        terms.push((RelaxationTerm { modulus, relaxation_time: joint.time }, ROUNDING));
    }
    for SumZero { compliance, time, error, value, value_error } in zeros {
        // `value` is 3K. Where K and G vanish together there is no pole: it is zero within its rounding.
        if value.abs() > value_error {
            let modulus = 3.0 / multiple * (value * compliance) * value;
            terms.push((RelaxationTerm { modulus, relaxation_time: time }, error + 2.0 * value_error / value.abs() + ROUNDING));
        }
    }
    let relaxed = elastic(relaxed_shear, relaxed_bulk, multiple);
    let given: Vec<RelaxationTerm> = terms.iter().map(|&(term, _)| term).collect();
    let mut material = Material::from_relaxation(relaxed, &given)?;
    material.modulus_rounding = ROUNDING + shared_error(&terms, relaxed);
    Ok(material)
}

/// A bound on the relative error of the whole modulus at any time or frequency.
///
/// A term decays faster than any of longer time, so its error is compared with itself, all of longer time, and the relaxed modulus. All parts of a
/// complex modulus lie in one quadrant: the magnitude of their sum is at least 1/√2 of the sum of their magnitudes.
fn shared_error(terms: &[(RelaxationTerm, f64)], relaxed: f64) -> f64 {
    let mut sorted: Vec<&(RelaxationTerm, f64)> = terms.iter().collect();
    sorted.sort_by(|left, right| right.0.relaxation_time.total_cmp(&left.0.relaxation_time));
    let (mut longer, mut bound) = (relaxed, 0.0);
    for (term, error) in sorted {
        longer += term.modulus;
        bound += term.modulus * error / longer;
    }
    std::f64::consts::SQRT_2 * bound
}
