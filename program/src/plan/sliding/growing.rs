//! Process zones that grow with the energy release rate of their edge: δ = α a₀ G/Δγ where the contact opens, α a₀ Δγ/G where it closes.
//!
//! With a short zone a cohesive law acts on the far field as an edge does whose zone has this length: α = 2∫ tension · gap dx/(Δγ a₀) over
//! the zone, π²/6 for a constant tension and 6.497 for an exponential one; a₀ = E0*Δγ/(π peak²) is the relaxed zone. G is that of one edge
//! far from the other, whose balance over δ reads, with φ(z) = (1 − e^−z)/z,
//! ```text
//! opens    Δγ/G = 1 − Σ jφ(δ/vτ)      j, τ: creep terms over the relaxed compliance, retardation times
//! closes   Δγ/G = 1 + Σ rφ(δ/vρ)      r, ρ: relaxation terms over E0, relaxation times
//! ```
//! so that both lengths follow from the material and the speed alone. The error of the friction falls linearly in a₀ (measured against
//! `finite_range`: `tests/scene/surfaces.rs`, `docs/src/guides/surfaces.md`).

use viscotack::continuation::bracket::halved;
use viscotack::material::PlaneMaterial;

/// Both lengths of a law whose relaxed edge has the zone α a₀, at a rate v in the unit of lengths over time: where it opens, and where it closes.
pub(super) fn grown(material: &PlaneMaterial, rate: f64, [opening, closing]: [f64; 2]) -> [f64; 2] {
    let relaxed = material.relaxed_modulus();
    let open = |length: f64| {
        let sum: f64 =
            material.creep_terms().iter().map(|term| term.compliance * relaxed * mean_decay(length, rate * term.retardation_time)).sum();
        // Never below the glassy limit, which rounding might cross.
        1.0 / (1.0 - sum).max(1.0 / material.stiffening_ratio())
    };
    let close = |length: f64| {
        1.0 + material
            .relaxation_terms()
            .iter()
            .map(|term| term.modulus / relaxed * mean_decay(length, rate * term.relaxation_time))
            .sum::<f64>()
    };
    let most = material.stiffening_ratio();
    [fixed_point(opening, most, open), fixed_point(closing, most, close)]
}

/// φ(length/way), zero at rest.
fn mean_decay(length: f64, way: f64) -> f64 {
    if way > 0.0 { -(-length / way).exp_m1() * (way / length) } else { 0.0 }
}

/// The length that is `relaxed` times its own growth, which falls from `most` to 1 as the length rises: one root.
fn fixed_point(relaxed: f64, most: f64, growth: impl Fn(f64) -> f64) -> f64 {
    halved([relaxed.ln(), (relaxed * most).ln()], |log| relaxed * growth(log.exp()) > log.exp())[0].exp()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use viscotack::material::CreepTerm;

    /// Table of `law_to_zone.md`, section 1 gives G/Δγ of the exact Dugdale zone; the rule itself is checked by its own balance and its limits.
    #[test]
    fn a_zone_is_its_own_growth_and_meets_both_limits() {
        let material = PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.9, retardation_time: 1.0 }], None).unwrap();
        let relaxed = 1e-3;
        for rate in [1e-3, 0.1, 10.0] {
            let [opening, closing] = grown(&material, rate, [relaxed; 2]);
            let phi = |z: f64| (1.0 - (-z).exp()) / z;
            assert!((opening * (1.0 - 0.9 * phi(opening / rate)) / relaxed - 1.0).abs() < 1e-10);
            assert!((closing / (1.0 + 9.0 * phi(10.0 * closing / rate)) / relaxed - 1.0).abs() < 1e-10);
        }
        let [slow, fast] = [0.0, 1e9].map(|rate| grown(&material, rate, [relaxed; 2]));
        for edge in 0..2 {
            assert!((slow[edge] / relaxed - 1.0).abs() < 1e-12 && (fast[edge] / relaxed - 10.0).abs() < 1e-6);
        }
    }
}
