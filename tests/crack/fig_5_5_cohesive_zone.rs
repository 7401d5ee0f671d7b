//! Source: thesis Figs 5.3–5.5, Eqs 5.25, 5.40–5.43; Schapery (1975, 1989), Greenwood (2004).
//!
//! Goal: the cohesive-zone theory in both motions, how close the virtual-work theory comes to it, and the errata of these equations.
//!
//! ```text
//!        σ₀ ┌──────┐                  opening   δ = πK²/(8σ₀²)
//!           │ zone │ δ                closing   K₁ = E0σ₀√(2/π) ∫₀^δ J((δ − ζ)/v) ζ^{−1/2} dζ          (5.43), put right
//!   ────────┴──────┴───────           Δγ = σ₀ × gap at the rear end of the zone
//! ```
//! Parameters: materials of 1 to 12 terms and a fluid for the references; one term, β = 100, v̂ = vτσ₀²/(E0Δγ) for the figure.
//!
//! Oracle: `reference_data/steady_crack.csv` (mpmath, displacement from the logarithmic kernel of the half-plane, no artanh form).
//! For an erratum: that the mended form holds AND that the printed one fails.
//!
//! Tolerance: 1e-13 for the references; figures of the comparison pinned to the digits printed.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;
use crate::support::physics;
use crate::support::theory;

use physics::relative;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};
use support::{reference_materials, reference_rows};
use theory::{STRESS, WORK, growing, interface};
use viscotack::PlaneMaterial;
use viscotack::closure::process_zone_work;
use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::near_tip::ClosingTip;
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, at_drive, at_speed};
use viscotack::special::gauss_legendre::UNIT_RULE;

const RIGID: CrackBody = CrackBody::AgainstRigid;

#[test]
fn cohesive_zone_references_are_reached_to_1e13() {
    let materials = reference_materials();
    let (mut worst, mut count) = ([0.0_f64; 2], [0; 2]);
    for row in reference_rows("steady_crack.csv").iter().filter(|row| row.text("model") == "dugdale_schapery") {
        let material = &materials[row.text("material")];
        let (motion, index) = if row.text("motion") == "opening" { (Motion::Opening, 0) } else { (Motion::Closing, 1) };
        let (work, stress) = (row.number("work_of_adhesion"), row.number("cohesive_stress"));
        let curve = CohesiveZone::new(material, motion, work, stress, RIGID).unwrap();
        let state = at_speed(&curve, row.number("speed"), 1e-15).unwrap();
        let expected = row.number("value");
        let (value, bar) = match row.text("quantity") {
            "energy_release_rate_ratio" => {
                let ratio = state.energy_release_rate_ratio.unwrap();
                (ratio.value, ratio.error)
            }
            "stress_intensity_factor" => {
                let intensity = RIGID.intensity_squared(work, state.drive.value).sqrt();
                (intensity, intensity * state.drive.relative_error())
            }
            other => panic!("{other}"),
        };
        let condition = state.speed_exponent.abs();
        let place = format!("{}: {value:e} instead of {expected:e}", row.text("case"));
        let error = (value - expected).abs();
        assert!(error <= bar + 0.5 * f64::EPSILON * (1.0 + condition) * expected, "{place}: above its bound {bar:e}");
        assert!(error <= 1e-13 * (1.0 + condition) * expected, "{place}: {:e}", error / expected);
        assert!(relative(state.crossing_length.value, row.number("process_zone_length")) <= 1e-13 * (1.0 + condition), "{place}");
        worst[index] = worst[index].max(error / expected / (1.0 + condition));
        count[index] += 1;
    }
    println!("{count:?} opening and closing values, worst {:.1e} and {:.1e}", worst[0], worst[1]);
    assert!(count[0] >= 20 && count[1] >= 15);
}

#[test]
fn schaperys_length_references_are_reached_to_1e13() {
    let materials = reference_materials();
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in reference_rows("steady_crack.csv").iter().filter(|row| row.text("process_zone") == "schapery") {
        let law = ProcessZone::Schapery { cohesive_stress: row.number("cohesive_stress"), factor: row.number("alpha") };
        let closing = Interface { work_of_adhesion: row.number("work_of_adhesion"), process_zone: law, body: RIGID };
        let curve = VirtualWork::new(&materials[row.text("material")], Motion::Closing, closing).unwrap();
        let state = at_speed(&curve, row.number("speed"), 1e-15).unwrap();
        let error = relative(state.energy_release_rate_ratio.unwrap().value, row.number("value")) / (1.0 + state.speed_exponent.abs());
        assert!(error <= 1e-13, "{}: {error:e}", row.text("case"));
        assert!(relative(state.crossing_length.value, row.number("process_zone_length")) <= 1e-13 * (1.0 + state.speed_exponent.abs()));
        worst = worst.max(error);
        count += 1;
    }
    println!("{count} values, worst {worst:.1e}");
    assert!(count >= 10);
}

// ------------------------------------------------------------------------------------------------ Fig 5.5b

/// The material of Figs 5.4 and 5.5: one term, β = 100.
fn fig_5_5() -> PlaneMaterial {
    PlaneMaterial::standard_solid(7.3e5, 7.3e7, 0.037).unwrap()
}

/// v with v̂ = vτσ₀²/(E0Δγ).
fn speed_of(reduced: f64) -> f64 {
    reduced * 7.3e5 * WORK / (0.037 * STRESS * STRESS)
}

fn ratio_at(curve: &impl SteadyCurve, speed: f64) -> f64 {
    at_speed(curve, speed, 1e-15).unwrap().energy_release_rate_ratio.unwrap().value
}

fn schapery(material: &PlaneMaterial, factor: f64) -> VirtualWork<'_> {
    VirtualWork::new(material, Motion::Closing, interface(ProcessZone::Schapery { cohesive_stress: STRESS, factor })).unwrap()
}

/// The largest |ln(G/G_zone)| over v̂ = 1e-4…1e6, with v̂ there, and both values.
fn largest_log_deviation(alpha: f64) -> (f64, f64) {
    let material = fig_5_5();
    let (zone, work) = (CohesiveZone::new(&material, Motion::Closing, WORK, STRESS, RIGID).unwrap(), schapery(&material, alpha));
    let mut worst = (0.0_f64, 0.0);
    for index in -400..=600 {
        let reduced = 10f64.powf(f64::from(index) / 100.0);
        let deviation = (ratio_at(&work, speed_of(reduced)) / ratio_at(&zone, speed_of(reduced))).ln();
        if deviation.abs() > worst.0.abs() {
            worst = (deviation, reduced);
        }
    }
    worst
}

/// The range of log10(v_work/v_zone) at equal G, over 1/β < G < 1, for α = 1.
fn range_of_shift() -> [f64; 2] {
    let material = fig_5_5();
    let (zone, work) = (CohesiveZone::new(&material, Motion::Closing, WORK, STRESS, RIGID).unwrap(), schapery(&material, 1.0));
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for index in 1..400 {
        let place = 1.0 / (1.0 + (-(f64::from(index) / 400.0 * 24.0 - 12.0)).exp());
        let drive = 100f64.powf(-place) / 7.3e5;
        let shift = (at_drive(&work, drive, 1e-15).unwrap().speed.value / at_drive(&zone, drive, 1e-15).unwrap().speed.value).log10();
        range = [range[0].min(shift), range[1].max(shift)];
    }
    range
}

#[test]
fn fig_5_5b_energy_closure_with_schaperys_length_against_greenwood() {
    let (one, half, inverse) = (largest_log_deviation(1.0), largest_log_deviation(0.5), largest_log_deviation(2.0));
    let [low, high] = range_of_shift();
    // α is a shift by −2 log10 α: the best one centres the range of the shift.
    let best = 10f64.powf(0.25 * (low + high));
    let centred = largest_log_deviation(best);
    println!(
        "ln(G/G_zone): α = 1 {:+.4} at v̂ = {:.3e}; α = 0.5 {:+.4} at {:.3e}; α = {best:.4} {:+.4} at {:.3e}",
        one.0, one.1, half.0, half.1, centred.0, centred.1
    );
    // The α with the smallest largest deviation of ln G, by golden section.
    let (mut left, mut right) = (1.2, 3.5);
    for _ in 0..14 {
        let (a, b) = (right - 0.618 * (right - left), left + 0.618 * (right - left));
        if largest_log_deviation(a).0.abs() < largest_log_deviation(b).0.abs() {
            right = b;
        } else {
            left = a;
        }
    }
    let closest = 0.5 * (left + right);
    let smallest = largest_log_deviation(closest).0.abs();
    println!("smallest of the largest |ln(G/G_zone)|: {smallest:.4} at α = {closest:.3}, 1/α = {:.3}", 1.0 / closest);
    println!("α = 0.5 as a factor of K₁ instead of its integral: {:+.4} at v̂ = {:.3e}", inverse.0, inverse.1);
    println!("log10 v at equal G, α = 1: from {low:+.4} to {high:+.4}; the best α leaves ±{:.4}", 0.5 * (high - low));
    // The overlap that the figure shows at α = 0.5 is not that of (5.43) as printed, which α = 0.5 takes further away (a factor 4.4 in G);
    // with α = 0.5 in front of K₁ it is near the best there is: a factor 1.30, and 1.24 at α = 0.474.
    let pinned = [
        (one.0, 0.8863),
        (half.0, 1.4841),
        (inverse.0, 0.2637),
        (best, 1.8108),
        (centred.0, 0.3539),
        (low, 0.1761),
        (high, 0.8554),
        (smallest, 0.2150),
    ];
    for (value, expected) in pinned {
        assert!((value - expected).abs() <= 5e-4_f64.max(5e-4 * expected.abs()), "{pinned:?}");
    }
}

#[test]
fn greenwoods_limits_of_fig_5_5b() {
    // Both axes of the figure from the integrals alone: G/Δγ = N²/(2M), v̂ = π/(2zM) (theory notes, section 5), by direct quadrature.
    let material = fig_5_5();
    let curve = CohesiveZone::new(&material, Motion::Closing, WORK, STRESS, RIGID).unwrap();
    for z in [1e-3, 0.1, 1.0, 7.0, 300.0] {
        let (mut intensity, mut work) = (0.0, 0.0);
        // r = q²; panels halve towards q = 1, where artanh has its logarithm.
        let (mut left, mut width) = (0.0, 0.5);
        for _ in 0..50 {
            for &(node, weight) in UNIT_RULE.iter() {
                let q = left + width * node;
                let rest = (1.0 - left) - width * node;
                let compliance = 7.3e5 * material.creep(0.037 * z * rest * (1.0 + q));
                intensity += weight * width * 2.0 * compliance;
                work += weight * width * 2.0 * q * compliance * (2.0 / q - ((1.0 + q) / rest).ln());
            }
            left += width;
            width *= 0.5;
        }
        let (ratio, reduced) = (intensity * intensity / (2.0 * work), PI / (2.0 * z * work));
        let state = at_speed(&curve, speed_of(reduced), 1e-15).unwrap();
        assert!(relative(state.energy_release_rate_ratio.unwrap().value, ratio) <= 1e-11, "z = {z}");
        assert!(relative(state.crossing_time, 0.037 * z) <= 1e-11, "z = {z}");
    }
}

// ------------------------------------------------------------------------------------------------ errata

#[test]
fn erratum_14_eq_5_42_a0_carries_the_relaxed_modulus() {
    let material = fig_5_5();
    let law = interface(growing(1.0));
    let printed = |work: f64, stress: f64| 2.0 * work / (TAU.sqrt() * stress).powi(2);
    let mended = |modulus: f64, work: f64, stress: f64| 2.0 * modulus * work / (TAU.sqrt() * stress).powi(2);
    let zone = law.relaxed_zone(&material).unwrap();
    assert!(relative(zone, mended(7.3e5, WORK, STRESS)) <= 4.0 * f64::EPSILON);
    // It is the length of (5.25) at G = Δγ …
    let rest = at_speed(&VirtualWork::new(&material, Motion::Opening, law).unwrap(), 0.0, 1e-15).unwrap();
    assert!(relative(rest.crossing_length.value, zone) <= 1e-14);
    // … and it is a length: metres to millimetres is a factor 1000, which the printed form misses.
    let millimetres = mended(7.3e-1, WORK * 1e-3, STRESS * 1e-6);
    assert!(relative(millimetres / zone, 1e3) <= 1e-14);
    let printed_ratio = printed(WORK * 1e-3, STRESS * 1e-6) / printed(WORK, STRESS);
    assert!(relative(printed_ratio, 1e9) <= 1e-12, "the printed a₀ scales like a length over a stress: {printed_ratio:e}");
}

#[test]
fn erratum_15_eq_5_43_creep_since_the_material_entered_the_zone_and_alpha_of_k1() {
    let material = fig_5_5();
    for (reduced, alpha) in [(0.03, 1.0), (2.0, 0.5), (70.0, 1.3)] {
        let state = at_speed(&schapery(&material, alpha), speed_of(reduced), 1e-15).unwrap();
        let (length, speed) = (state.crossing_length.value, speed_of(reduced));
        // K₁ from the energy: (K₁/E0)² = 2ΔγD.
        let intensity = 7.3e5 * RIGID.intensity_squared(WORK, state.drive.value).sqrt();
        // (5.43) by quadrature in q = √(ζ/δ).
        let integral = |argument: &dyn Fn(f64) -> f64| -> f64 {
            let panels = 400;
            (0..panels)
                .flat_map(|panel| {
                    UNIT_RULE.iter().map(move |&(node, weight)| ((f64::from(panel) + node) / f64::from(panels), weight / f64::from(panels)))
                })
                .map(|(q, weight)| 2.0 * length.sqrt() * weight * material.creep(argument(length * q * q)))
                .sum()
        };
        let factor = STRESS * 7.3e5 * (2.0 / PI).sqrt();
        let mended = alpha * factor * integral(&|zeta| (length - zeta) / speed);
        assert!(relative(mended, intensity) <= 1e-11, "v̂ = {reduced}: {mended:e} {intensity:e}");
        // As printed, J((ζ − δ)/v) looks at times before the stress: no creep at all, K₁ = 0.
        let printed = alpha * factor * integral(&|zeta| (zeta - length) / speed);
        assert!(printed.abs() < 1e-12 * intensity, "{printed:e}");
        // Nor is it J(ζ/v), the time since the other end.
        let mirrored = alpha * factor * integral(&|zeta| zeta / speed);
        assert!(relative(mirrored, intensity) > 0.05 || reduced > 50.0, "{mirrored:e} {intensity:e}");
        // α multiplies K₁: the length at equal K₁ and T falls like 1/α², where that of (5.25) rises like α.
        let twice = schapery(&material, 2.0 * alpha).point(state.crossing_time).unwrap();
        assert!(relative(twice.crossing_length, 0.25 * length) <= 1e-13);
        let law = |factor: f64| {
            VirtualWork::new(&material, Motion::Closing, interface(growing(factor))).unwrap().point(state.crossing_time).unwrap()
        };
        assert!(relative(law(2.0 * alpha).crossing_length, 2.0 * law(alpha).crossing_length) <= 1e-13);
    }
    // At rest (5.43) with α = 1 is Dugdale's length πK²/(8σ₀²), the same as the opening one.
    let rest = at_speed(&schapery(&material, 1.0), 0.0, 1e-15).unwrap();
    assert!(relative(rest.crossing_length.value, PI / 8.0 * 2.0 * 7.3e5 * WORK / (STRESS * STRESS)) <= 1e-14);
}

#[test]
fn erratum_16_fig_5_5b_axis_needs_the_square_of_the_cohesive_stress() {
    // The curve is one in v̂ = vτσ₀²/(E0Δγ): other numbers, the same G. The printed axis vτσ₀/(E0Δγ) gives another curve for each.
    let one = fig_5_5();
    let two = PlaneMaterial::standard_solid(3.1e4, 3.1e6, 11.3).unwrap();
    let (other_work, other_stress) = (2.9, 4.3e4);
    let mended_speed = |reduced: f64| reduced * 3.1e4 * other_work / (11.3 * other_stress * other_stress);
    let printed = |speed: f64, time: f64, stress: f64, modulus: f64, work: f64| speed * time * stress / (modulus * work);
    let first = CohesiveZone::new(&one, Motion::Closing, WORK, STRESS, RIGID).unwrap();
    let second = CohesiveZone::new(&two, Motion::Closing, other_work, other_stress, RIGID).unwrap();
    for reduced in [0.1, 3.0, 40.0] {
        let (left, right) = (ratio_at(&first, speed_of(reduced)), ratio_at(&second, mended_speed(reduced)));
        assert!(relative(left, right) <= 1e-13, "v̂ = {reduced}: {left:e} {right:e}");
        // At the same printed abscissa the two solids have different G.
        let abscissa = printed(speed_of(reduced), 0.037, STRESS, 7.3e5, WORK);
        let speed = abscissa * 3.1e4 * other_work / (11.3 * other_stress);
        assert!(relative(ratio_at(&second, speed), left) > 0.05, "v̂ = {reduced}");
    }
}

#[test]
fn erratum_17_eq_5_40_holds_with_the_remote_intensity() {
    let material = fig_5_5();
    let remote_over_modulus = 3.3e-4;
    let remote = remote_over_modulus * 7.3e5;
    // Slow: the zone is 1e9 vτ long.
    let length = 2.3e-7;
    let tip = ClosingTip::new(&material, RIGID, remote_over_modulus, length / (0.037 * 1e9)).unwrap();
    let work = process_zone_work(&tip, length, 1e-12).unwrap().value;
    let mended = remote * remote / (2.0 * 7.3e5);
    assert!(relative(work, mended) <= 1e-8, "{work:e} {mended:e}");
    // As printed, with the local K_I = βK₁ of (5.34), it is too large by β² = 1e4.
    let local = 100.0 * remote;
    let printed = local * local / (2.0 * 7.3e5);
    assert!(relative(printed / work, 1e4) <= 1e-8);
    // K_I is right in (5.38), at the other end: K_I²/(2E∞).
    let tip = ClosingTip::new(&material, RIGID, remote_over_modulus, length / (0.037 * 1e-11)).unwrap();
    let work = process_zone_work(&tip, length, 1e-12).unwrap().value;
    assert!(relative(work, local * local / (2.0 * 7.3e7)) <= 1e-6, "{work:e}");
}

/// The distance of the largest compression from the tip, over vρ, by golden section.
fn compressive_peak(beta: f64) -> f64 {
    let material = PlaneMaterial::standard_solid(7.3e5, 7.3e5 * beta, 0.037).unwrap();
    let (speed, time) = (1.7e-3, material.relaxation_terms()[0].relaxation_time);
    let tip = ClosingTip::new(&material, RIGID, 1e-4, speed).unwrap();
    let stress = |distance: f64| tip.stress(distance * speed * time).unwrap().value;
    let (mut low, mut high) = (0.9, 4.0);
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..60 {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if stress(left) < stress(right) {
            high = right;
        } else {
            low = left;
        }
    }
    assert!(stress(low) < 0.0, "no compression at β = {beta}");
    low
}

#[test]
fn erratum_20_fig_5_4_the_compressive_peak_is_at_relaxation_not_retardation_distance() {
    let (at_100, limit) = (compressive_peak(100.0), compressive_peak(1e12));
    println!("largest compression at {at_100:.5} vρ for β = 100 ({:.6} vτ), at {limit:.5} vρ for β → ∞", at_100 / 100.0);
    assert!((at_100 - 1.86).abs() < 5e-3 && (limit - 1.844).abs() < 5e-4, "{at_100} {limit}");
    // "At distance of order vτ" would not depend on β: it is 0.0186 vτ at β = 100 and vanishes with 1/β.
    assert!(at_100 / 100.0 < 0.02);
}

#[test]
fn erratum_20_fig_5_5a_overlap_of_the_closing_theories_is_at_1_over_pi_not_at_one_half() {
    // Persson's adaptation itself was not at hand: the energy-consistent dual of the opening theory is, with a = a₀G/Δγ and with a = a₀.
    let material = fig_5_5();
    let zone = interface(growing(1.0)).relaxed_zone(&material).unwrap();
    let growing_pair = |alpha: f64, speed: f64| {
        let work = VirtualWork::new(&material, Motion::Closing, interface(growing(alpha))).unwrap();
        let loss = PerssonBrener::new(&material, Motion::Closing, interface(growing(1.0))).unwrap();
        (ratio_at(&work, speed) / ratio_at(&loss, speed)).ln()
    };
    let constant_pair = |alpha: f64, speed: f64| {
        let law = |length: f64| interface(ProcessZone::Constant { length });
        let work = VirtualWork::new(&material, Motion::Closing, law(alpha * zone)).unwrap();
        let loss = PerssonBrener::new(&material, Motion::Closing, law(zone)).unwrap();
        (ratio_at(&work, speed) / ratio_at(&loss, speed)).ln()
    };
    let unit = zone / 0.037;
    let largest = |pair: &dyn Fn(f64, f64) -> f64, alpha: f64| -> f64 {
        (-300..=500).map(|index| pair(alpha, unit * 10f64.powf(f64::from(index) / 100.0)).abs()).fold(0.0, f64::max)
    };
    let figures =
        [largest(&growing_pair, FRAC_1_PI), largest(&growing_pair, 0.5), largest(&constant_pair, FRAC_1_PI), largest(&constant_pair, 0.5)];
    println!(
        "largest |ln G/G_loss|: growing α = 1/π {:.4}, α = 0.5 {:.4}; constant {:.4}, {:.4}",
        figures[0], figures[1], figures[2], figures[3]
    );
    assert!(figures[1] > 3.0 * figures[0] && figures[3] > 3.0 * figures[2], "{figures:?}");
    // The printed α ≈ 0.5 fails in the slow limit, where both are lines in v: by 2/π.
    let slow = 1e-7 * unit;
    let loss = |alpha: f64| {
        let work = VirtualWork::new(&material, Motion::Closing, interface(growing(alpha))).unwrap();
        1.0 / ratio_at(&work, slow) - 1.0
    };
    let persson = 1.0 / ratio_at(&PerssonBrener::new(&material, Motion::Closing, interface(growing(1.0))).unwrap(), slow) - 1.0;
    assert!(relative(loss(FRAC_1_PI), persson) < 1e-6 && relative(loss(0.5) / persson, 2.0 / PI) < 1e-6, "{} {persson}", loss(0.5));
}

#[test]
fn opening_zone_of_fig_5_3_is_alpha_2_5() {
    // δ = πK²/(8σ₀²) against αK²/(2πσ_c²) at σ_c = σ₀: α = π²/4 = 2.47; with σ₀ = 3σ_c, α = 0.274.
    let material = PlaneMaterial::standard_solid(1.9e6, 1.9e9, 4.7e-3).unwrap();
    let rest = at_speed(&CohesiveZone::new(&material, Motion::Opening, WORK, STRESS, RIGID).unwrap(), 0.0, 1e-15).unwrap();
    let zone = interface(growing(1.0)).relaxed_zone(&material).unwrap();
    assert!(relative(rest.crossing_length.value / zone, FRAC_PI_2 * FRAC_PI_2) <= 1e-14);
}
