//! Source: thesis Sec 2.2.2, the kernel of a layer; the integral over its harmonics is ours.
//!
//! Goal: the kernel of a layer of any thickness, down to 1e-12 of the wavelength, where 25/kd harmonics cannot be summed.
//!
//! Parameters: kd from 1e-3 to 1e-12; confined and free; ν from 0 to 0.5; elastic, one and three terms, both directions; positions from the load to π.
//!
//! Oracle: the Fourier series itself, harmonic by harmonic with Kahan's sum, where it ends (kd ≥ 1e-5); for thinner layers the limits: a confined compressible
//! layer is a row of springs, whose displacement is that of ζdw/dx chains (closed form); a free one is a plate, Σ cos mx/m⁴ (a polynomial); an
//! incompressible confined one nowhere, but for the load itself, where all are half-planes.
//!
//! Tolerance: the error bounds, and these below 1e-12 of the kernel's size; limits at their own order in kd; 1e-11 for sums that end, whose rounding is 1/kd times that
//! of a double.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::sliding::memory::MemoryTerm;
use viscotack::sliding::{Backing, HalfPlaneGreen, Layer, LayerGreen, SlidingMemory};

fn memories() -> Vec<SlidingMemory> {
    let three = [(0.3, 2.0), (0.4, 0.01), (0.2, 1e-5)].map(|(compliance, ratio)| MemoryTerm { compliance, ratio });
    vec![
        SlidingMemory::new(1.0, &[]).unwrap(),
        SlidingMemory::standard_solid(20.0, 0.3).unwrap(),
        SlidingMemory::new(0.1, &three).unwrap(),
        SlidingMemory::new(0.1, &three).unwrap().reversed(),
    ]
}

/// Σ A_mĈ_m e^{imx}/m to m = 30/kd, compensated.
fn series(memory: &SlidingMemory, layer: &Layer, x: f64) -> f64 {
    let last = (30.0 / layer.thickness_times_wave_number()) as u64;
    let (mut sum, mut lost) = (0.0, 0.0);
    for index in (1..=last).rev() {
        let m = index as f64;
        let (real, imaginary) = memory.harmonic_compliance(m);
        let angle = (m * x) % (2.0 * PI);
        let term = layer.correction(m) / m * (real * angle.cos() - imaginary * angle.sin()) - lost;
        let next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    sum / PI
}

#[test]
fn the_integral_is_the_series_where_the_series_ends() {
    let mut worst = 0.0_f64;
    for memory in memories() {
        for (backing, poisson_ratio) in [(Backing::Confined, 0.0), (Backing::Confined, 0.5), (Backing::Free, 0.3)] {
            for thickness in [9e-4, 1e-4] {
                let layer = Layer::new(backing, poisson_ratio, thickness).unwrap();
                let green = LayerGreen::new(HalfPlaneGreen::new(memory.clone()).unwrap(), layer);
                assert_eq!(green.harmonics(), 0);
                let scale = layer.correction(1.0).abs().max(1.0);
                for x in [0.0, 0.3 * thickness, 20.0 * thickness, 59.0 * thickness, 61.0 * thickness, 0.2, -0.2, 1.7, -3.1, PI] {
                    let found = green.correction(x).unwrap();
                    let expected = series(&memory, &layer, x);
                    // The angle mx itself carries m ulp of x in the series.
                    let tolerance = found.error + 1e-12 * scale * (1.0 + x.abs());
                    let error = (found.value - expected).abs();
                    assert!(error < tolerance, "{backing:?} ν = {poisson_ratio} kd = {thickness} x = {x}: {} {expected}", found.value);
                    assert!(found.error < 1e-12 * scale * 20.0, "{:e}", found.error);
                    worst = worst.max(error / scale);
                    // Far from the load S is summed instead of A: the same kernel.
                    if x != 0.0 {
                        let whole = green.value(x).unwrap();
                        let other = green.half_plane().value(x).unwrap().value + expected;
                        assert!((whole.value - other).abs() < tolerance + 1e-13 * scale, "{backing:?} x = {x}: {} {other}", whole.value);
                    }
                }
            }
        }
    }
    println!("against the series: worst {worst:.1e} of the first harmonic");
}

/// Where harmonics are summed one by one nothing that counts is left out: the series goes on to 30/kd here, and its terms fall as e^{−2mkd}.
#[test]
fn a_sum_that_ends_has_left_out_nothing() {
    for memory in memories() {
        for (backing, poisson_ratio) in [(Backing::Confined, 0.0), (Backing::Confined, 0.5), (Backing::Free, 0.3)] {
            for thickness in [1e-3, 2e-2, 0.3, 2.0] {
                let layer = Layer::new(backing, poisson_ratio, thickness).unwrap();
                let green = LayerGreen::new(HalfPlaneGreen::new(memory.clone()).unwrap(), layer);
                assert!(green.harmonics() > 0);
                let scale = layer.correction(1.0).abs().max(1.0);
                for x in [0.0, 0.3 * thickness, 0.2, -0.2, 1.7, PI] {
                    let (found, expected) = (green.correction(x).unwrap(), series(&memory, &layer, x));
                    let error = (found.value - expected).abs();
                    assert!(error < 1e-11 * scale, "{backing:?} ν = {poisson_ratio} kd = {thickness} x = {x}: {} {expected}", found.value);
                    assert!(found.error < 1e-11 * scale, "{:e}", found.error);
                }
            }
        }
    }
}

/// A plate of stiffness d³/6 in units of the half-plane: 𝒢 → −(6/(π(kd)³)) Σ cos mx/m⁴ = −(6/(π(kd)³))(π⁴/90 − π²x²/12 + πx³/12 − x⁴/48), to order (kd)².
#[test]
fn a_thin_free_layer_is_a_plate() {
    for thickness in [1e-5, 1e-8, 1e-12] {
        let layer = Layer::new(Backing::Free, 0.3, thickness).unwrap();
        let green = LayerGreen::new(HalfPlaneGreen::new(SlidingMemory::new(1.0, &[]).unwrap()).unwrap(), layer);
        for x in [1e-3_f64, 0.4, 2.0, PI] {
            let bernoulli = PI.powi(4) / 90.0 - PI.powi(2) * x * x / 12.0 + PI * x.powi(3) / 12.0 - x.powi(4) / 48.0;
            let expected = -6.0 / (PI * thickness.powi(3)) * bernoulli;
            let found = green.value(x).unwrap();
            let scale = 6.0 / (PI * thickness.powi(3));
            assert!(
                (found.value - expected).abs() < (2e-13 + thickness * thickness) * scale + found.error,
                "kd = {thickness} x = {x}: {} {expected}",
                found.value
            );
            assert!(found.error < 1e-12 * scale);
        }
    }
}

/// S → c q, c = (1 − 2ν)/(2(1 − ν)²): each point is a spring. Away from the load the elastic displacement is that of the removed mean, and a term of memory
/// leaves −j c kd [π e^{−s/ζ}/(πζ(1 − e^{−2π/ζ})) − ½]/π·… at the distance s behind it; to order (kd)².
#[test]
fn a_thin_compressible_confined_layer_is_a_row_of_springs() {
    let nu: f64 = 0.3;
    let spring = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu).powi(2));
    for thickness in [1e-5, 1e-8, 1e-12] {
        for (beta, ratio) in [(1.0, 1.0), (10.0, 0.4), (300.0, 0.02)] {
            let memory = SlidingMemory::standard_solid(beta, ratio).unwrap();
            let layer = Layer::new(Backing::Confined, nu, thickness).unwrap();
            let green = LayerGreen::new(HalfPlaneGreen::new(memory).unwrap(), layer);
            for x in [0.05_f64, 0.4, 2.0, PI, -2.0, -0.05] {
                // Σ e^{imx}/(1 − imζ) over all m ≠ 0 is (2π/ζ) e^{−s/ζ}/(1 − e^{−2π/ζ}) − 1 with s the distance from x to the load ahead of it.
                let ahead = if x > 0.0 { 2.0 * PI - x } else { -x };
                let remembered = PI / ratio * (-ahead / ratio).exp() / -(-2.0 * PI / ratio).exp_m1() - 0.5;
                let elastic = -0.5;
                let gained = (beta - 1.0) / beta;
                let expected = -spring * thickness / PI * (elastic / beta + gained * remembered);
                let found = green.value(x).unwrap();
                let scale = spring * thickness * (1.0 + PI / ratio) / PI;
                assert!(
                    (found.value - expected).abs() < scale * (1e-11 + 30.0 * thickness / ratio),
                    "kd = {thickness} β = {beta} x = {x}: {:e} {expected:e}",
                    found.value
                );
                assert!(found.error < 1e-11 * scale, "{:e} of {scale:e}", found.error);
            }
        }
    }
}

#[test]
fn antiderivatives_return_after_a_period_and_match_their_kernel() {
    for memory in memories() {
        for thickness in [5e-4, 1e-7] {
            let layer = Layer::new(Backing::Confined, 0.4, thickness).unwrap();
            let green = LayerGreen::new(HalfPlaneGreen::new(memory.clone()).unwrap(), layer);
            let at = |x: f64| green.antiderivative(x).unwrap().value;
            assert!((at(0.3 + 2.0 * PI) - at(0.3)).abs() < 1e-12);
            for x in [0.4_f64, -1.3, 3.0] {
                let h = 1e-3;
                let slope = (8.0 * (at(x + h) - at(x - h)) - (at(x + 2.0 * h) - at(x - 2.0 * h))) / (12.0 * h);
                let value = green.value(x).unwrap().value;
                assert!((slope - value).abs() < 1e-9, "kd = {thickness} x = {x}: {slope} {value}");
            }
        }
    }
}
