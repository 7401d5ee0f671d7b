//! Sinusoidal wave without adhesion.
//!
//! Source: Westergaard, J. Appl. Mech. 6 (1939) A49; Johnson, *Contact Mechanics* (1985), Sec 13.2.
//! Goal: mean pressure, width and penetration from one another, from the first touch to full contact.
//!
//! ```text
//!    ,-.      ,-.
//!   ´   `-..-´   `     contact 2a around each crest, gap 2b
//!        2a
//! ```
//!
//! Parameters: E* = 1.9 MPa, λ = 31 µm, Λ = 0.27 µm.
//! Oracles: (i) mean of the pressure by quadrature; (ii) work: dU/dΔ = p̄λ, U = ½∫pw; (iii) isolated Hertz line contact for a → 0,
//! a² = 4Pr/(πE*) with P = p̄λ and radius of curvature r = 1/(k²Λ); (iv) the small crack for b → 0, Δp = p* − p̄ and
//! (kb/2)² = 1 − p̄/p*; (v) the gap against its own slope: volume of the gap = λ(mean gap), which the
//! zero mean of w fixes to Λ − Δ without the gap formula.
//! Tolerance: quadratures 1e-12; limits by their first neglected term.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::elastic::WestergaardWave;

const MODULUS: f64 = 1.9e6;
const LENGTH: f64 = 31e-6;
const HEIGHT: f64 = 0.27e-6;

fn wave() -> WestergaardWave {
    WestergaardWave::new(MODULUS, LENGTH, HEIGHT).unwrap()
}

/// ∫₋ₐᵃ f dx with x = a sin φ, midpoint rule.
fn over_contact(a: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = 400;
    let step = PI / f64::from(n);
    (0..n).map(|i| -PI / 2.0 + (f64::from(i) + 0.5) * step).map(|phi| f(a * phi.sin()) * a * phi.cos() * step).sum()
}

#[test]
fn pressure_carries_the_load_and_its_work() {
    let wave = wave();
    let k = wave.wavenumber();
    for part in [0.01, 0.2, 0.5, 0.8] {
        let a = part * LENGTH / 2.0;
        let state = wave.state_by_contact_half_width(a).unwrap();
        let load = over_contact(a, |x| wave.pressure(a, x).unwrap());
        assert_relative_eq!(load, state.mean_pressure * LENGTH, epsilon = 0.0, max_relative = 1e-12);
        let energy = |depth: f64| {
            let state = wave.state_by_penetration(depth).unwrap();
            let a = state.contact_half_width;
            let w = |x: f64| depth - 2.0 * HEIGHT * (0.5 * k * x).sin().powi(2);
            0.5 * over_contact(a, |x| wave.pressure(a, x).unwrap() * w(x))
        };
        let h = 1e-3 * state.penetration.min(HEIGHT - state.penetration);
        let force = (8.0 * (energy(state.penetration + h) - energy(state.penetration - h))
            - (energy(state.penetration + 2.0 * h) - energy(state.penetration - 2.0 * h)))
            / (12.0 * h);
        assert_relative_eq!(force, load, epsilon = 0.0, max_relative = 1e-8);
        // Mean gap = mean(w) − mean(w_indenter) = Λ − Δ. Midpoint in φ over the gap, x = λ/2 − b cos φ … smooth at both ends.
        let b = LENGTH / 2.0 - a;
        let volume = over_contact(b, |y| wave.gap(a, LENGTH / 2.0 - y.abs()).unwrap());
        assert_relative_eq!(volume / LENGTH, HEIGHT - state.penetration, epsilon = 0.0, max_relative = 1e-9);
    }
}

#[test]
fn narrow_contacts_are_hertz_lines_and_narrow_gaps_are_cracks() {
    let wave = wave();
    let k = wave.wavenumber();
    for part in [1e-3, 1e-6, 1e-12, 1e-30] {
        let state = wave.state_by_mean_pressure(part * wave.full_contact_pressure()).unwrap();
        let hertz = (4.0 * state.mean_pressure * LENGTH / (PI * MODULUS) / (k * k * HEIGHT)).sqrt();
        assert_relative_eq!(state.contact_half_width, hertz, epsilon = 0.0, max_relative = 0.2 * part + 1e-15);
        let gap = part.sqrt() * LENGTH / 2.0;
        let state = wave.state_by_gap_half_width(gap).unwrap();
        assert_relative_eq!(state.gap_half_width, gap, epsilon = 0.0, max_relative = 1e-15);
        if part > 1e-7 {
            let missing = 1.0 - state.mean_pressure / wave.full_contact_pressure();
            assert_relative_eq!(missing, (0.5 * k * gap).powi(2), epsilon = 0.0, max_relative = part * 4.0 + 1e-15 / part);
        }
    }
}

#[test]
fn inverses_return_and_full_contact_is_reached() {
    let wave = wave();
    let mut worst = 0.0_f64;
    for part in [1e-12, 1e-5, 0.03, 0.25, 0.5, 0.75, 0.99, 0.9999] {
        let state = wave.state_by_contact_half_width(part * LENGTH / 2.0).unwrap();
        for same in [wave.state_by_mean_pressure(state.mean_pressure).unwrap(), wave.state_by_penetration(state.penetration).unwrap()] {
            assert_relative_eq!(same.contact_half_width, state.contact_half_width, epsilon = 0.0, max_relative = same.relative_error);
            assert_relative_eq!(same.gap_half_width, state.gap_half_width, epsilon = 0.0, max_relative = same.relative_error);
            let error = (same.gap_half_width / state.gap_half_width - 1.0).abs() / same.relative_error;
            worst = worst.max(error);
        }
    }
    println!("worst error over its bound {worst:.2}");
    for full in [
        wave.state_by_mean_pressure(wave.full_contact_pressure()).unwrap(),
        wave.state_by_mean_pressure(3.0 * wave.full_contact_pressure()).unwrap(),
        wave.state_by_penetration(HEIGHT).unwrap(),
        wave.state_by_gap_half_width(0.0).unwrap(),
    ] {
        assert!(full.is_full_contact());
        assert_relative_eq!(full.contact_half_width, LENGTH / 2.0, epsilon = 0.0, max_relative = 1e-15);
        assert_relative_eq!(full.penetration, HEIGHT, epsilon = 0.0, max_relative = 1e-15);
    }
    let touch = wave.state_by_penetration(0.0).unwrap();
    assert!(touch.contact_half_width.abs() < f64::MIN_POSITIVE && touch.mean_pressure.abs() < f64::MIN_POSITIVE);
    assert!(wave.state_by_penetration(5e-324).unwrap().contact_half_width.is_finite());
    assert!(wave.state_by_mean_pressure(-1.0).is_err() && wave.state_by_penetration(1.01 * HEIGHT).is_err());
    assert!(wave.state_by_mean_pressure(f64::NAN).is_err() && wave.pressure(LENGTH, 0.0).is_err());
    assert!(wave.state_by_contact_half_width(f64::NAN).is_err() && wave.gap(0.0, f64::NAN).is_err());
}

#[test]
fn units_do_not_matter() {
    let (metres, millimetres) = (wave(), WestergaardWave::new(MODULUS * 1e-6, LENGTH * 1e3, HEIGHT * 1e3).unwrap());
    for part in [1e-4, 0.3, 0.9] {
        let pressure = part * metres.full_contact_pressure();
        let (a, b) = (metres.state_by_mean_pressure(pressure).unwrap(), millimetres.state_by_mean_pressure(pressure * 1e-6).unwrap());
        assert_relative_eq!(a.contact_half_width * 1e3, b.contact_half_width, epsilon = 0.0, max_relative = 1e-14);
        assert_relative_eq!(a.penetration * 1e3, b.penetration, epsilon = 0.0, max_relative = 1e-14);
    }
}
