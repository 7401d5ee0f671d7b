//! The memory integrals of Clausen's function and of the periodic logarithm against mpmath and against their own equations.
//!
//! Source: `reference_data/memory_clausen.csv`, written by `verification/references/memory_clausen.py`: every value by at least two of five routes
//! (definition, one period, ₂F₁, images, polylogarithms), ζ from 1e-8 to 1e8, angles from 1e-10 to 2π − 1e-3.
//! Goal: theory 6, first item. Oracle: the file; the differential equation I − ζI′ = Cl₂; limits in ζ.
//! Tolerance: 1e-13 absolute is required; the bounds below are what is reached, scaled by the largest |I| there is, min(1, 1/ζ).
#![allow(clippy::unwrap_used, clippy::panic)]

use crate::support;

use std::f64::consts::PI;
use support::reference_rows;
use viscotack::special::angle::Angle;
use viscotack::special::clausen::clausen;
use viscotack::special::dilogarithm_circle::dilogarithm_on_circle;
use viscotack::special::log_sine::log_sine;
use viscotack::special::memory_clausen::MemoryClausen;

fn angle(x: f64) -> Angle {
    Angle::new(x).unwrap()
}

/// Angles of both signs and all magnitudes.
fn angles() -> impl Iterator<Item = f64> {
    (0..60).flat_map(|index| {
        let size = PI * 10f64.powf(-f64::from(index) / 6.0);
        [size, -size]
    })
}

const RATIOS: [f64; 15] = [1e-8, 1e-5, 1e-3, 0.02, 0.0785, 0.1, 0.24, 0.5, 0.8, 0.9999, 1.0, 1.7, 10.0, 1e3, 1e8];

#[test]
fn every_value_of_the_file() {
    let rows = reference_rows("memory_clausen.csv");
    assert!(rows.len() >= 60);
    let mut worst = [0.0_f64; 4];
    for row in &rows {
        assert!(row.number("confirmed_digits") >= 18.0);
        let (x, ratio) = (row.number("angle"), row.number("ratio"));
        let memory = MemoryClausen::new(ratio).unwrap();
        let scale = 1.0_f64.min(1.0 / ratio);
        let integral_error = (memory.integral(angle(x)) - row.number("integral")).abs();
        let increment_error = (memory.increment(angle(x)) / row.number("increment") - 1.0).abs();
        let reference = row.number("memory_logarithm");
        let logarithm_error = (memory.logarithm(angle(x)) - reference).abs() / (scale + reference.abs());
        for (slot, error) in worst.iter_mut().zip([integral_error, integral_error / scale, increment_error, logarithm_error]) {
            *slot = slot.max(error);
        }
    }
    println!(
        "{} values: I {:.1e} absolute, {:.1e} scaled; I - I(0) {:.1e} relative; L {:.1e}",
        rows.len(),
        worst[0],
        worst[1],
        worst[2],
        worst[3]
    );
    assert!(worst[0] < 1e-14 && worst[1] < 1e-14 && worst[2] < 1e-14 && worst[3] < 5e-15, "{worst:?}");
}

#[test]
fn equation_holds_across_every_seam() {
    // I − ζI′ = Cl₂ with I′ = −𝓛, both from their own expansions near the load (away from it I is made from 𝓛); then I′ itself by a fourth-order difference.
    for ratio in RATIOS {
        let memory = MemoryClausen::new(ratio).unwrap();
        for x in angles() {
            let defect = memory.integral(angle(x)) + ratio * memory.logarithm(angle(x)) - clausen(angle(x));
            assert!(defect.abs() < 2e-14, "ζ = {ratio:e}, x = {x:e}: {defect:e}");
        }
    }
    for ratio in [0.3, 0.95, 1.0, 3.0, 40.0] {
        let memory = MemoryClausen::new(ratio).unwrap();
        for x in [-3.0, -2.0, -1.0, -0.4, 0.4, 0.7, 1.4, 2.3, 3.1] {
            let step = 2e-3;
            let at = |shift: f64| memory.integral(angle(x + shift * step));
            let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
            assert!((at(0.0) - ratio * slope - clausen(angle(x))).abs() < 2e-9 * (1.0 + ratio), "ζ = {ratio}, x = {x}");
        }
    }
}

#[test]
fn fast_and_slow_expansions_meet_at_one() {
    // Two expansions with nothing in common: power series about the load, and exponential integrals of thirteen loads.
    let (slow, fast) = (MemoryClausen::new(1.0_f64.next_down()).unwrap(), MemoryClausen::new(1.0).unwrap());
    let mut worst = [0.0_f64; 3];
    for index in 0..=20_000 {
        let here = angle(-PI + 2.0 * PI * f64::from(index) / 20_000.0);
        worst[0] = worst[0].max((slow.integral(here) - fast.integral(here)).abs());
        worst[1] = worst[1].max((slow.increment(here) - fast.increment(here)).abs());
        worst[2] = worst[2].max((slow.logarithm(here) - fast.logarithm(here)).abs());
    }
    println!("seam at one: I {:.1e}, I - I(0) {:.1e}, L {:.1e}", worst[0], worst[1], worst[2]);
    assert!(worst.iter().all(|&error| error < 1.5e-14), "{worst:?}");
}

#[test]
fn increment_and_value_are_one_function() {
    for ratio in RATIOS {
        let memory = MemoryClausen::new(ratio).unwrap();
        let at_load = memory.integral(angle(0.0));
        for x in angles() {
            let gap = memory.integral(angle(x)) - at_load - memory.increment(angle(x));
            assert!(gap.abs() < 5e-15, "ζ = {ratio:e}, x = {x:e}: {gap:e}");
        }
    }
}

#[test]
fn rotations_add_up() {
    // Σ_{j<n} f(x + 2πj/n) keeps every n-th harmonic: Σ_j I(x + 2πj/n; ζ) = I(nx; nζ)/n, Σ_j 𝓛(x + 2πj/n; ζ) = 𝓛(nx; nζ).
    for ratio in [1e-6, 0.01, 0.13, 0.4, 0.9, 1.3, 20.0, 1e4] {
        for n in [2_u32, 3, 5] {
            let count = f64::from(n);
            let (memory, faster) = (MemoryClausen::new(ratio).unwrap(), MemoryClausen::new(ratio * count).unwrap());
            for x in [0.003, 0.2, 0.55] {
                let turned = |j: u32| angle(x + 2.0 * PI * f64::from(j) / count);
                let integral: f64 = (0..n).map(|j| memory.integral(turned(j))).sum();
                let logarithm: f64 = (0..n).map(|j| memory.logarithm(turned(j))).sum();
                assert!((integral - faster.integral(angle(count * x)) / count).abs() < 2e-14, "I, ζ = {ratio:e}, n = {n}");
                assert!((logarithm - faster.logarithm(angle(count * x))).abs() < 4e-14, "L, ζ = {ratio:e}, n = {n}");
            }
        }
    }
}

#[test]
fn limits_period_and_mirror() {
    let frozen = MemoryClausen::new(f64::INFINITY).unwrap();
    let instant = MemoryClausen::new(0.0).unwrap();
    let tiny = MemoryClausen::new(1e-300).unwrap();
    let denormal = MemoryClausen::new(1e-310).unwrap();
    let fast = MemoryClausen::new(1e12).unwrap();
    for x in angles() {
        let here = angle(x);
        assert_eq!(instant.integral(here).to_bits(), clausen(here).to_bits());
        assert_eq!(instant.logarithm(here).to_bits(), log_sine(here).to_bits());
        assert_eq!(frozen.integral(here).to_bits(), 0.0_f64.to_bits());
        assert!((tiny.integral(here) - clausen(here)).abs() < 1e-15 && (tiny.logarithm(here) - log_sine(here)).abs() < 1e-13);
        assert!((denormal.integral(here) - clausen(here)).abs() < 1e-15);
        // ζI → Σcos(mx)/m³ and ζ𝓛 → Cl₂: the derivative of the first is −Cl₂.
        assert!((1e12 * fast.logarithm(here) - clausen(here)).abs() < 1e-11);
        for ratio in [1e-3, 0.4, 1.0, 30.0] {
            let (forward, backward) = (MemoryClausen::new(ratio).unwrap(), MemoryClausen::new(-ratio).unwrap());
            assert_eq!(backward.integral(angle(-x)).to_bits(), (-forward.integral(here)).to_bits());
            assert_eq!(backward.logarithm(angle(-x)).to_bits(), forward.logarithm(here).to_bits());
        }
    }
    let memory = MemoryClausen::new(0.7).unwrap();
    for turns in 1..20 {
        let x = 1.1 + 2.0 * PI * f64::from(turns);
        assert!((memory.integral(angle(x)) - memory.integral(angle(1.1))).abs() < 1e-14 * f64::from(turns));
    }
    // ζI(0; ζ) → ζ(3) for fast sliding, and the value at the load is never zero.
    assert!((1e8 * MemoryClausen::new(1e8).unwrap().integral(angle(0.0)) - 1.202_056_903_159_594_2).abs() < 1e-14);
    assert!(MemoryClausen::new(f64::NAN).is_err());
}

#[test]
fn finite_at_every_load_and_ratio() {
    for exponent in -308..=308 {
        let memory = MemoryClausen::new(1.7 * 10f64.powi(exponent)).unwrap();
        for x in [0.0, 5e-324, 1e-300, 1e-100, 1e-17, 1e-3, 1.0, PI, -1e-200, -1e-9, -2.0] {
            let here = angle(x);
            assert!(
                memory.integral(here).is_finite() && memory.increment(here).is_finite() && memory.logarithm(here).is_finite(),
                "{exponent} {x:e}"
            );
        }
    }
}

/// Erratum: in the closed form below thesis (3.36) the third parameter of ₂F₁ is printed (1 + ζ)/ζ; it is 1 + i/ζ.
#[test]
fn erratum_7_third_parameter_of_the_hypergeometric_form_in_thesis_sec_3_3() {
    let (ratio, x): (f64, f64) = (2.0, 0.9);
    // ₂F₁(1, ib; c; z) on the circle by its series, (1)_m/m! = 1, averaged twice (Cesàro) to converge: terms fall only as m^{Re(ib − c)}.
    let b = 1.0 / ratio;
    let closed_form = |third: (f64, f64)| {
        let (mut term, mut sum, mut mean, mut mean_of_means) = ((1.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0));
        let terms = 400_000;
        for index in 0..terms {
            let m = f64::from(index);
            sum = (sum.0 + term.0, sum.1 + term.1);
            mean = (mean.0 + (sum.0 - mean.0) / (m + 1.0), mean.1 + (sum.1 - mean.1) / (m + 1.0));
            mean_of_means =
                (mean_of_means.0 + (mean.0 - mean_of_means.0) / (m + 1.0), mean_of_means.1 + (mean.1 - mean_of_means.1) / (m + 1.0));
            // term·(ib + m)/(c + m)·e^{ix}
            let (numerator, denominator) = ((m, b), (third.0 + m, third.1));
            let size = denominator.0 * denominator.0 + denominator.1 * denominator.1;
            let quotient = (
                (numerator.0 * denominator.0 + numerator.1 * denominator.1) / size,
                (numerator.1 * denominator.0 - numerator.0 * denominator.1) / size,
            );
            let turned = (quotient.0 * x.cos() - quotient.1 * x.sin(), quotient.0 * x.sin() + quotient.1 * x.cos());
            term = (term.0 * turned.0 - term.1 * turned.1, term.0 * turned.1 + term.1 * turned.0);
        }
        // Im[−ζ²F + ζ(ζ − i log(1 − e^{ix})) + Li₂(e^{ix})], Re log(1 − e^{ix}) = L.
        -ratio * ratio * mean_of_means.1 - ratio * log_sine(angle(x)) + dilogarithm_on_circle(angle(x)).imaginary
    };
    let ours = MemoryClausen::new(ratio).unwrap().integral(angle(x));
    assert!((closed_form((1.0, b)) - ours).abs() < 1e-4, "mended: {} against {ours}", closed_form((1.0, b)));
    assert!((closed_form((1.0 + b, 0.0)) - ours).abs() > 0.05, "printed: {} against {ours}", closed_form((1.0 + b, 0.0)));
}
