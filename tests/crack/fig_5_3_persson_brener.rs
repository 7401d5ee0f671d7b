//! Source: thesis Figs 5.3 and 5.5a; Persson and Brener (2005), DOI 10.1103/PhysRevE.71.036123.
//!
//! Goal: Persson and Brener's theory is what its loss integral gives, and the theory of the thesis is close to it in a sense that is stated
//! in numbers: the same in both limits for α = 1/π and no other α, and between them apart by so much and no more.
//!
//! ```text
//!   virtual work   Δγ/G = 1 − Σ J_jE0 φ(δ/vτ_j),  δ = αa₀G/Δγ          loss   Δγ/G = 1 − Σ J_jE0 κ(2πvτ_j/a),  a = a₀G/Δγ
//!   slow           (G/Δγ − 1)/v → Σ J_jE0τ_j/(αa₀)                             → π Σ J_jE0τ_j/a₀
//!   fast           Δγ/G − 1/β → (αa₀β/2v) Σ J_jE0/τ_j                            → (a₀β/2πv) Σ J_jE0/τ_j
//! ```
//! Parameters: both motions; materials of 1 to 20 terms; β = 10, 1e2, 1e3, 1e6 for the figures.
//!
//! Oracle: `reference_data/steady_crack.csv` (mpmath, the frequency integrals themselves); the two expansions above.
//!
//! Tolerance: 1e-13 for the reference times the local condition of a speed rounded to a double; the error bounds must hold. Figures of the
//! comparison are pinned to the digits printed.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, missing_docs)]

use crate::support;
use crate::support::physics;
use crate::support::theory;

use physics::{Random, random_solid, relative};
use std::f64::consts::{FRAC_1_PI, PI};
use support::{reference_materials, reference_rows};
use theory::{STRESS, WORK, growing, interface};
use viscotack::PlaneMaterial;
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, at_drive, at_speed};
use viscotack::special::gauss_legendre::UNIT_RULE;

#[test]
fn reference_values_are_reached_to_1e13() {
    let materials = reference_materials();
    let (mut worst, mut steep, mut count) = (0.0_f64, 0.0_f64, [0; 2]);
    for row in reference_rows("steady_crack.csv").iter().filter(|row| row.text("model") == "persson_brener") {
        let material = &materials[row.text("material")];
        let motion = if row.text("motion") == "opening" { Motion::Opening } else { Motion::Closing };
        let process_zone = match row.text("process_zone") {
            "constant" => ProcessZone::Constant { length: row.number("process_zone_length") },
            "growing" => ProcessZone::Growing { cohesive_stress: row.number("cohesive_stress"), factor: row.number("alpha") },
            other => panic!("{other}"),
        };
        let cut_off = Interface { work_of_adhesion: row.number("work_of_adhesion"), process_zone, body: CrackBody::AgainstRigid };
        let curve = PerssonBrener::new(material, motion, cut_off).unwrap();
        let state = at_speed(&curve, row.number("speed"), 1e-15).unwrap();
        let (ratio, expected) = (state.energy_release_rate_ratio.unwrap(), row.number("value"));
        let condition = state.speed_exponent.abs();
        let input = 0.5 * f64::EPSILON * (1.0 + condition) * expected;
        let error = relative(ratio.value, expected);
        let place = format!("{} {}: {:e} instead of {expected:e}", row.text("case"), row.text("process_zone"), ratio.value);
        assert!((ratio.value - expected).abs() <= ratio.error + input, "{place}: above its bound {:e}", ratio.error);
        if condition <= 20.0 {
            assert!(error <= 1e-13, "{place}: {error:e}");
            worst = worst.max(error);
        } else {
            assert!(error <= 4.0 * f64::EPSILON * condition, "{place}: {error:e}");
            steep = steep.max(error);
        }
        // The condition of the reference is advice of three digits, and agrees with the exponent found here.
        if condition > 1e-6 {
            assert!(relative(condition, row.number("condition")) < 2e-2, "{place}: {condition:e}");
        }
        // The point itself, free of the solution of an equation: T = a/(2πv).
        let point = curve.point(row.number("transit_time") / (2.0 * PI)).unwrap();
        assert!(relative(curve.energy_release_rate_ratio(point.drive).unwrap(), expected) <= 1e-14, "{place}");
        assert!(relative(2.0 * PI * point.crossing_length, row.number("process_zone_length")) <= 1e-14, "{place}");
        count[usize::from(motion == Motion::Closing)] += 1;
    }
    println!("{count:?} opening and closing values, worst {worst:.1e}, worst where steeper than v^20 {steep:.1e}");
    assert!(count[0] >= 19 && count[1] >= 38);
}

/// G/Δγ of both theories at one speed: virtual work with α, loss with a = a₀G/Δγ.
fn pair(material: &PlaneMaterial, motion: Motion, alpha: f64, speed: f64) -> [f64; 2] {
    let work = VirtualWork::new(material, motion, interface(growing(alpha))).unwrap();
    let loss = PerssonBrener::new(material, motion, interface(growing(1.0))).unwrap();
    [at_speed(&work, speed, 1e-15).unwrap(), at_speed(&loss, speed, 1e-15).unwrap()]
        .map(|state| state.energy_release_rate_ratio.unwrap().value)
}

/// a₀ = E0Δγ/(πσ_c²).
fn relaxed_zone(material: &PlaneMaterial) -> f64 {
    material.relaxed_modulus() * WORK / (PI * STRESS * STRESS)
}

#[test]
fn both_limits_agree_for_alpha_1_over_pi_and_for_no_other() {
    let mut random = Random(61);
    let mut worst = [0.0_f64; 2];
    for _ in 0..30 {
        let material = random_solid(&mut random, 8, 6.0, 1e4);
        let beta = material.stiffening_ratio();
        if beta < 1.5 {
            continue;
        }
        let zone = relaxed_zone(&material);
        for motion in [Motion::Opening, Motion::Closing] {
            // (first moment of the slow limit, first moment of the fast limit) of the series that this motion uses
            let (slow, fast): (f64, f64) = match motion {
                Motion::Opening => (
                    material.creep_terms().iter().map(|term| term.compliance * material.relaxed_modulus() * term.retardation_time).sum(),
                    material.creep_terms().iter().map(|term| term.compliance * material.relaxed_modulus() / term.retardation_time).sum(),
                ),
                Motion::Closing => (
                    material.relaxation_terms().iter().map(|term| term.modulus / material.relaxed_modulus() * term.relaxation_time).sum(),
                    material.relaxation_terms().iter().map(|term| term.modulus / material.relaxed_modulus() / term.relaxation_time).sum(),
                ),
            };
            // What is left of the limit: |Δγ/G − 1| slow; |Δγ/G − 1/β| or |Δγ/G − β| fast.
            let limit = if motion == Motion::Opening { 1.0 / beta } else { beta };
            let growth = if motion == Motion::Opening { beta } else { 1.0 / beta };
            for alpha in [0.25, 0.3, FRAC_1_PI, 0.35, 0.5, 1.0] {
                let slow_speed = 1e-6 * zone / slow;
                let [work, loss] = pair(&material, motion, alpha, slow_speed).map(|ratio| (1.0 / ratio - 1.0).abs());
                let slow_ratio = work / loss;
                // The leading term itself, not only its ratio.
                assert!(relative(loss, PI * 1e-6) < 1e-4, "{motion:?} slow: {loss:e}");
                let fast_speed = 1e5 * zone * growth * fast / limit;
                let [work, loss] = pair(&material, motion, alpha, fast_speed).map(|ratio| (1.0 / ratio - limit).abs());
                let fast_ratio = work / loss;
                assert!(relative(loss, limit * 1e-5 / (2.0 * PI)) < 1e-4, "{motion:?} fast: {loss:e}");
                // Slow the loss of the thesis's theory is 1/(πα) of Persson and Brener's; fast it is πα.
                assert!(relative(slow_ratio, 1.0 / (PI * alpha)) < 3e-4, "{motion:?} α = {alpha}: slow {slow_ratio}");
                assert!(relative(fast_ratio, PI * alpha) < 3e-4, "{motion:?} α = {alpha}: fast {fast_ratio}");
                if alpha == FRAC_1_PI {
                    worst[0] = worst[0].max((slow_ratio - 1.0).abs());
                    worst[1] = worst[1].max((fast_ratio - 1.0).abs());
                } else {
                    assert!((slow_ratio - 1.0).abs() > 0.05 && (fast_ratio - 1.0).abs() > 0.05, "α = {alpha}");
                }
            }
        }
    }
    println!("α = 1/π: departures of the leading terms, slow {:.1e} (at 1e-6), fast {:.1e} (at 1e-5)", worst[0], worst[1]);
}

/// The largest |G_work/G_loss − 1| at equal speed, with the speed (in a₀/τ), and the largest |log10 of v_work/v_loss| at equal G, with G.
fn largest_deviations(material: &PlaneMaterial, motion: Motion, alpha: f64) -> [(f64, f64); 2] {
    let unit = relaxed_zone(material) / material.longest_retardation_time().unwrap();
    let beta = material.stiffening_ratio();
    let (mut in_ratio, mut in_speed) = ((0.0_f64, 0.0), (0.0_f64, 0.0));
    let last = (400.0 * (2.0 + 2.0 * beta.log10())) as i32;
    for index in -800..=last {
        let speed = unit * 10f64.powf(f64::from(index) / 400.0);
        let [work, loss] = pair(material, motion, alpha, speed);
        let deviation = work / loss - 1.0;
        if deviation.abs() > in_ratio.0.abs() {
            in_ratio = (deviation, speed / unit);
        }
    }
    let work = VirtualWork::new(material, motion, interface(growing(alpha))).unwrap();
    let loss = PerssonBrener::new(material, motion, interface(growing(1.0))).unwrap();
    for index in 1..2000 {
        // Dense towards both limits: β^x with x from a logistic map.
        let place = 1.0 / (1.0 + (-(f64::from(index) / 2000.0 * 24.0 - 12.0)).exp());
        let ratio = beta.powf(place);
        let drive = if motion == Motion::Opening { ratio * material.relaxed_modulus() } else { 1.0 / (ratio * material.relaxed_modulus()) };
        let shift = (at_drive(&work, drive, 1e-15).unwrap().speed.value / at_drive(&loss, drive, 1e-15).unwrap().speed.value).log10();
        if shift.abs() > in_speed.0.abs() {
            in_speed = (shift, ratio);
        }
    }
    [in_ratio, in_speed]
}

#[test]
fn deviations_between_the_limits_are_these() {
    // β, then opening and closing: largest relative deviation of G at equal v, largest shift of log10 v at equal G; pinned to 3 digits.
    // For one term both theories are functions of δ/vτ alone, so the shift is one number for every β and both motions: 6 % in v. G itself
    // differs by 2.3 % at most when opening; when closing, the curve is so steep that those 6 % in v are a factor in G.
    let pinned = [
        (10.0, [[0.020_15, -0.026_74], [-0.083_42, -0.026_74]]),
        (1e2, [[0.022_81, -0.026_74], [-0.257_07, -0.026_74]]),
        (1e3, [[0.023_09, -0.026_74], [-0.472_59, -0.026_74]]),
        (1e6, [[0.023_12, -0.026_74], [-0.624_51, -0.026_74]]),
    ];
    let mut wrong = Vec::new();
    for (beta, expected) in pinned {
        let material = PlaneMaterial::standard_solid(1.9e6, 1.9e6 * beta, 4.7e-3).unwrap();
        for (motion, expected) in [Motion::Opening, Motion::Closing].into_iter().zip(expected) {
            let [(ratio, at_speed), (shift, at_ratio)] = largest_deviations(&material, motion, FRAC_1_PI);
            println!(
                "β = {beta:e} {motion:?}: G deviates by {ratio:+.5} at v = {at_speed:.3e} a₀/τ, log10 v by {shift:+.5} at a load ratio of {at_ratio:.3e}"
            );
            if (ratio - expected[0]).abs() > 5e-4 * expected[0].abs() || (shift - expected[1]).abs() > 5e-4 * expected[1].abs() {
                wrong.push((beta, motion, [ratio, shift], expected));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn constant_cut_off_is_the_other_law_of_fig_5_5a() {
    // With a constant cut-off a and δ = a/π the two closing theories agree in both limits as well.
    let material = PlaneMaterial::standard_solid(7.3e5, 7.3e7, 0.037).unwrap();
    let length = 3.1e-7;
    for (speed, tolerance) in [(1e-12, 1e-6), (1e6, 1e-6), (length / 0.037, 0.2)] {
        let theory = |factor: f64| interface(ProcessZone::Constant { length: length * factor });
        let work = at_speed(&VirtualWork::new(&material, Motion::Closing, theory(FRAC_1_PI)).unwrap(), speed, 1e-15).unwrap();
        let loss = at_speed(&PerssonBrener::new(&material, Motion::Closing, theory(1.0)).unwrap(), speed, 1e-15).unwrap();
        let (work, loss) = (work.energy_release_rate_ratio.unwrap().value, loss.energy_release_rate_ratio.unwrap().value);
        assert!(relative(work, loss) < tolerance, "v = {speed:e}: {work:e} {loss:e}");
    }
}

/// A cut-off a of Schapery's length (5.43), whose creep is that of the time a/v = 2πT in which it is crossed: by quadrature in q = √(ζ/a).
#[test]
fn schaperys_length_is_crossed_in_two_pi_of_the_time() {
    let material = PlaneMaterial::standard_solid(7.3e5, 7.3e7, 0.037).unwrap();
    for alpha in [0.5, 1.0, 1.3] {
        let law = interface(ProcessZone::Schapery { cohesive_stress: STRESS, factor: alpha });
        let curve = PerssonBrener::new(&material, Motion::Closing, law).unwrap();
        for time in [1e-4, 3e-3, 0.1] {
            let point = curve.point(time).unwrap();
            let (length, crossing) = (2.0 * PI * point.crossing_length, 2.0 * PI * time);
            let panels = 400;
            let mean: f64 = (0..panels)
                .flat_map(|panel| {
                    UNIT_RULE.iter().map(move |&(node, weight)| ((f64::from(panel) + node) / f64::from(panels), weight / f64::from(panels)))
                })
                .map(|(q, weight)| 2.0 * weight * material.creep((1.0 - q * q) * crossing))
                .sum();
            // As (5.43) is built: K₁ is ασ₀E0√(2a/π) times the mean of creep over the root; K₁ here from the energy.
            let remote = 7.3e5 * CrackBody::AgainstRigid.intensity_squared(WORK, point.drive).sqrt();
            let cohesive = alpha * STRESS * 7.3e5 * (2.0 * length / PI).sqrt() * mean;
            assert!(relative(cohesive, remote) <= 1e-11, "α = {alpha}, T = {time}: {cohesive:e} {remote:e}");
        }
    }
}
