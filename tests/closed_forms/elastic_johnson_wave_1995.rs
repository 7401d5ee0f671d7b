//! Sinusoidal wave with adhesion of zero range.
//!
//! Source: Johnson, Int. J. Solids Struct. 32 (1995) 423; thesis Ch. 3 (elastic limit of the penetration).
//! Goal: energy balance at both edges, the three branches, both extrema, the fold of the penetration, and the two critical values of α: 0.5699
//! (spontaneous full contact) and 1.0652 (no stable partial contact under load control).
//!
//! ```text
//!   p̄ ^      S
//!     |    ,´ `.
//!     o---/-----\---- ka/2
//!      `.P       |
//! ```
//!
//! Parameters: E* = 2.3 MPa, λ = 19 µm, Λ = 0.31 µm, α = 0.01 … 1.3.
//! Oracles: (i) G at fixed Δ, by central differences in a of U = ½∫pw with the pressure at (a, Δ) out of equilibrium, is Δγ at each of the two edges;
//! (ii) load as the integral of the pressure; (iii) K from the pressure next to the edge; (iv) extrema and folds by scanning; (v) α_c from p̄ = 0
//! at the snap-in, by bisection in α; (vi) reduced relations of theory.md section 3 with m = 1, Γ = α²/4; (vii) mean gap = Λ − Δ.
//! Tolerance: quadratures 1e-11, differences 1e-7, identities 1e-14.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use viscotack::Refusal;
use viscotack::elastic::johnson_wave::{PARTIAL_CONTACT_LIMIT, SPONTANEOUS_FULL_CONTACT, WaveBranch};
use viscotack::elastic::{Control, EquilibriumBranch, JohnsonWave, WestergaardWave};

const MODULUS: f64 = 2.3e6;
const LENGTH: f64 = 19e-6;
const HEIGHT: f64 = 0.31e-6;
const ALPHAS: [f64; 6] = [0.01, 0.2, 0.5, 0.65, 0.9, 1.05];

fn plain() -> WestergaardWave {
    WestergaardWave::new(MODULUS, LENGTH, HEIGHT).unwrap()
}

/// Δγ of a given α: Δγ = α²p*²λ/(2E*).
fn work(alpha: f64) -> f64 {
    (alpha * plain().full_contact_pressure()).powi(2) * LENGTH / (2.0 * MODULUS)
}

fn wave(alpha: f64) -> JohnsonWave {
    JohnsonWave::new(plain(), work(alpha)).unwrap()
}

fn over_contact(a: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = 400;
    let step = PI / f64::from(n);
    (0..n).map(|i| -PI / 2.0 + (f64::from(i) + 0.5) * step).map(|phi| f(a * phi.sin()) * a * phi.cos() * step).sum()
}

fn slope(f: impl Fn(f64) -> f64, x: f64, h: f64) -> f64 {
    (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h)
}

#[test]
fn each_edge_releases_the_work_of_adhesion() {
    for alpha in ALPHAS {
        let wave = wave(alpha);
        for part in [0.05, 0.3, 0.6, 0.85] {
            let a = part * LENGTH / 2.0;
            let state = wave.state_by_contact_half_width(a).unwrap();
            let load = over_contact(a, |x| wave.pressure(a, x).unwrap());
            let scale = wave.without_adhesion().full_contact_pressure() * LENGTH;
            assert!((load - state.mean_pressure * LENGTH).abs() < 1e-11 * scale);
            // U(a, Δ) away from equilibrium: Westergaard's pressure plus the multiple of the edge solution that gives this Δ.
            let k = wave.without_adhesion().wavenumber();
            let energy = |a: f64| {
                let (hertz, half) = (plain().state_by_contact_half_width(a).unwrap(), 0.5 * k * a);
                let strength = (hertz.penetration - state.penetration) / HEIGHT / (-2.0 * half.sin().ln());
                let p = |x: f64| {
                    let chord = ((half - 0.5 * k * x).sin() * (half + 0.5 * k * x).sin()).sqrt();
                    plain().pressure(a, x).unwrap() - plain().full_contact_pressure() * strength * (0.5 * k * x).cos() / chord
                };
                0.5 * over_contact(a, |x| p(x) * (state.penetration - 2.0 * HEIGHT * (0.5 * k * x).sin().powi(2)))
            };
            let release = 0.5 * slope(energy, a, 1e-3 * a.min(LENGTH / 2.0 - a));
            assert!((release - work(alpha)).abs() < 1e-7 * work(alpha) + 1e-9 * work(1.0), "{alpha} {part} {release:e}");
            let factor = wave.stress_intensity_factor(a, state.mean_pressure).unwrap();
            assert!(factor > 0.0);
            assert_relative_eq!(factor * factor / (2.0 * MODULUS), work(alpha), epsilon = 0.0, max_relative = 1e-11 + 1e-13 / alpha);
            let near = 1e-7 * a.min(LENGTH / 2.0 - a);
            let seen = -wave.pressure(a, a - near).unwrap() * (2.0 * PI * near).sqrt();
            assert_relative_eq!(seen, factor, epsilon = 0.0, max_relative = 1e-5 / alpha);
        }
    }
}

#[test]
fn penetration_is_the_reduced_relation_and_fixes_the_mean_gap() {
    for alpha in ALPHAS {
        let wave = wave(alpha);
        for part in [0.02, 0.4, 0.9] {
            let a = part * LENGTH / 2.0;
            let (half, state) = (PI * a / LENGTH, wave.state_by_contact_half_width(a).unwrap());
            let (s, gamma) = (half.sin(), alpha * alpha / 4.0);
            let depth = s * s * (1.0 - 2.0 * s.ln()) + 4.0 * (gamma * half.tan()).sqrt() * s.ln();
            assert!((state.penetration / HEIGHT - depth).abs() < 1e-14);
            let pressure = s * s - 2.0 * (gamma * half.tan()).sqrt();
            assert!((state.mean_pressure / plain().full_contact_pressure() - pressure).abs() < 1e-14);
            let b = LENGTH / 2.0 - a;
            // The gap opens as a square root at both ends of x ∈ (a, λ − a): smooth in φ, the corner at the middle has zero slope.
            let volume = over_contact(b, |y| wave.gap(a, LENGTH / 2.0 - y.abs()).unwrap());
            assert_relative_eq!(volume / LENGTH, HEIGHT - state.penetration, epsilon = 0.0, max_relative = 2e-5);
        }
    }
}

#[test]
fn extrema_and_folds_stand_where_the_branch_turns() {
    for alpha in ALPHAS {
        let wave = wave(alpha);
        let (pull, snap) = (wave.pull_off(Control::Load).unwrap(), wave.snap_in().unwrap());
        assert!(pull.contact_half_width < snap.contact_half_width);
        assert_eq!(snap.mean_pressure <= 0.0, wave.closes_spontaneously());
        let fold = wave.pull_off(Control::Penetration).unwrap();
        assert!(fold.contact_half_width < 0.05 * LENGTH && fold.contact_half_width < pull.contact_half_width);
        for state in [pull, snap, fold] {
            let again = wave.state_by_contact_half_width(state.contact_half_width).unwrap();
            let unit = plain().full_contact_pressure();
            assert!((again.mean_pressure - state.mean_pressure).abs() < 2e-15 * unit);
            assert!((again.penetration - state.penetration).abs() < 4e-15 * HEIGHT);
        }
        // A dense scan: p̄ falls, rises, falls; Δ falls, rises; both turning points in the right cell.
        let n = 20_000;
        let scan: Vec<_> = (1..n).map(|i| wave.state_by_contact_half_width(f64::from(i) / f64::from(n) * LENGTH / 2.0).unwrap()).collect();
        let cell = LENGTH / 2.0 / f64::from(n);
        for pair in scan.windows(2) {
            let middle = 0.5 * (pair[0].contact_half_width + pair[1].contact_half_width);
            if [pull, snap, fold].iter().any(|state| (state.contact_half_width - middle).abs() <= cell) {
                continue;
            }
            let state = wave.state_by_contact_half_width(middle).unwrap();
            assert_eq!(pair[1].mean_pressure > pair[0].mean_pressure, wave.is_stable(&state, Control::Load).unwrap());
            let rise = pair[1].penetration - pair[0].penetration;
            assert!(rise.abs() < 4e-16 * HEIGHT || (rise > 0.0) == wave.is_stable(&state, Control::Penetration).unwrap());
        }
    }
}

/// α_c = 3/(4·3^{1/4}) at ka/2 = π/3, found here from p̄ = 0 at the snap-in; and the merger of the extrema from a scan of p̄.
#[test]
fn critical_adhesion_parameters() {
    let (mut low, mut high) = (0.1, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if wave(middle).snap_in().unwrap().mean_pressure > 0.0 { low = middle } else { high = middle }
    }
    assert_relative_eq!(low, 3.0 / (4.0 * 3.0_f64.sqrt().sqrt()), epsilon = 0.0, max_relative = 3e-15);
    assert_relative_eq!(low, SPONTANEOUS_FULL_CONTACT, epsilon = 0.0, max_relative = 3e-15);
    assert_relative_eq!(wave(low).snap_in().unwrap().contact_half_width, LENGTH / 3.0, epsilon = 0.0, max_relative = 1e-14);
    // Between the two critical values a partial contact is stable, in tension only; above the second none is.
    let rises = |alpha: f64| {
        let p = |i: i32| wave(alpha).state_by_contact_half_width(f64::from(i) / 4000.0 * LENGTH / 2.0).unwrap().mean_pressure;
        (1..3999).any(|i| p(i + 1) > p(i))
    };
    assert!(rises(PARTIAL_CONTACT_LIMIT - 1e-5) && !rises(PARTIAL_CONTACT_LIMIT + 1e-5));
    assert_relative_eq!(PARTIAL_CONTACT_LIMIT, 4.0 * 0.6_f64.powf(0.75) / 2.56, epsilon = 0.0, max_relative = 1e-15);
    let between = wave(0.8);
    let pull = between.pull_off(Control::Load).unwrap();
    let snap = between.snap_in().unwrap();
    assert!(snap.mean_pressure < 0.0 && pull.mean_pressure < snap.mean_pressure);
    let middle = between.state_by_mean_pressure(0.5 * (pull.mean_pressure + snap.mean_pressure), WaveBranch::Stable).unwrap();
    assert!(between.is_stable(&middle, Control::Load).unwrap());
    assert!(matches!(
        between.state_by_mean_pressure(0.0, WaveBranch::Stable),
        Err(Refusal::NoSuchState { limit, .. }) if (limit / snap.mean_pressure - 1.0).abs() < 1e-14
    ));
    let strong = wave(1.3);
    assert!(matches!(strong.snap_in(), Err(Refusal::NoSuchState { .. })) && strong.pull_off(Control::Load).is_err());
    assert!(strong.state_by_mean_pressure(-1e3, WaveBranch::Stable).is_err());
    let wide = strong.state_by_mean_pressure(-0.5 * plain().full_contact_pressure(), WaveBranch::Wide).unwrap();
    assert!(!strong.is_stable(&wide, Control::Load).unwrap());
    // Under penetration control even this one has its stable range.
    let held = strong.state_by_penetration(0.5 * HEIGHT, EquilibriumBranch::Stable).unwrap();
    assert!(strong.is_stable(&held, Control::Penetration).unwrap());
}

#[test]
fn inverses_return_to_the_state_they_came_from() {
    for alpha in [1e-6, 1e-3, 0.01, 0.2, 0.5, 0.65, 0.9, 1.05, 1.0652, 1.3, 40.0] {
        let wave = wave(alpha);
        for part in [1e-9, 1e-4, 0.01, 0.2, 0.5, 0.7, 0.95, 0.999] {
            let state = wave.state_by_contact_half_width(part * LENGTH / 2.0).unwrap();
            let branch = if wave.is_stable(&state, Control::Load).unwrap() {
                WaveBranch::Stable
            } else if alpha < PARTIAL_CONTACT_LIMIT && state.contact_half_width < wave.pull_off(Control::Load).unwrap().contact_half_width {
                WaveBranch::Narrow
            } else {
                WaveBranch::Wide
            };
            let same = wave.state_by_mean_pressure(state.mean_pressure, branch).unwrap();
            assert_relative_eq!(same.contact_half_width, state.contact_half_width, epsilon = 0.0, max_relative = 2.0 * same.relative_error);
            assert_relative_eq!(same.gap_half_width, state.gap_half_width, epsilon = 0.0, max_relative = 2.0 * same.relative_error);
            let stable = wave.is_stable(&state, Control::Penetration).unwrap();
            let branch = if stable { EquilibriumBranch::Stable } else { EquilibriumBranch::Unstable };
            let same = wave.state_by_penetration(state.penetration, branch).unwrap();
            assert_relative_eq!(same.contact_half_width, state.contact_half_width, epsilon = 0.0, max_relative = 2.0 * same.relative_error);
            assert_relative_eq!(same.gap_half_width, state.gap_half_width, epsilon = 0.0, max_relative = 2.0 * same.relative_error);
        }
        // The folds are answered, beyond them the limit is the witness.
        let fold = wave.pull_off(Control::Penetration).unwrap();
        assert!(wave.state_by_penetration(fold.penetration, EquilibriumBranch::Stable).is_ok());
        assert!(wave.state_by_penetration(fold.penetration * (1.0 + 1e-12), EquilibriumBranch::Stable).is_err());
        if alpha < PARTIAL_CONTACT_LIMIT {
            let (pull, snap) = (wave.pull_off(Control::Load).unwrap(), wave.snap_in().unwrap());
            for (state, branch) in
                [(pull, WaveBranch::Stable), (pull, WaveBranch::Narrow), (snap, WaveBranch::Stable), (snap, WaveBranch::Wide)]
            {
                let same = wave.state_by_mean_pressure(state.mean_pressure, branch).unwrap();
                assert_relative_eq!(
                    same.contact_half_width,
                    state.contact_half_width,
                    epsilon = 0.0,
                    max_relative = same.relative_error.max(1e-12)
                );
            }
            assert!(wave.state_by_mean_pressure(pull.mean_pressure * (1.0 + 1e-12), WaveBranch::Stable).is_err());
            assert!(wave.state_by_mean_pressure(snap.mean_pressure + 1e-12 * snap.mean_pressure.abs(), WaveBranch::Wide).is_err());
        }
    }
}

#[test]
fn without_much_adhesion_it_is_westergaard_and_units_do_not_matter() {
    let weak = wave(1e-9);
    for part in [0.1, 0.5, 0.9] {
        let pressure = part * plain().full_contact_pressure();
        let (a, b) =
            (weak.state_by_mean_pressure(pressure, WaveBranch::Stable).unwrap(), plain().state_by_mean_pressure(pressure).unwrap());
        assert_relative_eq!(a.contact_half_width, b.contact_half_width, epsilon = 0.0, max_relative = 1e-8);
        assert!(a.contact_half_width > b.contact_half_width);
        let metres = wave(0.3);
        let millimetres =
            JohnsonWave::new(WestergaardWave::new(MODULUS * 1e-6, LENGTH * 1e3, HEIGHT * 1e3).unwrap(), work(0.3) * 1e-3).unwrap();
        assert_relative_eq!(metres.adhesion_parameter(), 0.3, epsilon = 0.0, max_relative = 2e-15);
        let printed = 2.0_f64.sqrt() / PI * (LENGTH / HEIGHT) * (work(0.3) / (MODULUS * LENGTH)).sqrt();
        assert_relative_eq!(metres.adhesion_parameter(), printed, epsilon = 0.0, max_relative = 2e-15);
        let depth = part * HEIGHT;
        let (c, d) = (
            metres.state_by_penetration(depth, EquilibriumBranch::Stable).unwrap(),
            millimetres.state_by_penetration(depth * 1e3, EquilibriumBranch::Stable).unwrap(),
        );
        assert_relative_eq!(c.contact_half_width * 1e3, d.contact_half_width, epsilon = 0.0, max_relative = 1e-13);
        assert_relative_eq!(c.mean_pressure * 1e-6, d.mean_pressure, epsilon = 0.0, max_relative = 1e-12);
    }
    assert!(JohnsonWave::new(plain(), 0.0).is_err() && JohnsonWave::new(plain(), f64::NAN).is_err());
    assert!(weak.state_by_mean_pressure(f64::NAN, WaveBranch::Stable).is_err());
    assert!(weak.state_by_penetration(HEIGHT, EquilibriumBranch::Stable).is_err());
    assert!(weak.state_by_contact_half_width(LENGTH / 2.0).is_err() && weak.state_by_contact_half_width(0.0).is_err());
    assert!(weak.pressure(LENGTH / 4.0, LENGTH / 4.0).is_err());
}
