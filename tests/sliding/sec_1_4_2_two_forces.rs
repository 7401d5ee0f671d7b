//! Source: thesis Sec 1.4.2, Eqs 1.42–1.46 and Figs 1.5, 1.6.
//!
//! Goal: the work around a closed path is that of the odd part of the stiffness alone, −2Kᴼ₁₂ times the area; the two loading paths of Fig 1.6 differ by
//! u₁₂F₁ − u₂₁F₂; work = change of energy + non-conservative work along any path.
//!
//! Parameters: 2,000 random stiffnesses with entries of either sign over six decades, polygons of 3 to 9 corners.
//!
//! Oracle: Gauss's area formula of a polygon; (1.45) with displacements by the inverse of the matrix; sums over 1,000 small steps.
//!
//! Tolerance: 1e-13 of the sum of the magnitudes that were added up.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use physics::Random;
use viscotack::sliding::nonconservative::TwoForces;

fn random_body(random: &mut Random) -> TwoForces {
    let mut entry = || random.decade(1e-3, 1e3) * if random.unit() < 0.5 { -1.0 } else { 1.0 };
    TwoForces { stiffness: [[entry(), entry()], [entry(), entry()]] }
}

/// The largest product that enters a work along a path through these corners.
fn scale(body: &TwoForces, corners: &[[f64; 2]]) -> f64 {
    let stiffest = body.stiffness.iter().flatten().map(|entry| entry.abs()).fold(0.0, f64::max);
    let largest = corners.iter().flatten().map(|value| value.abs()).fold(0.0, f64::max);
    stiffest * largest * largest * corners.len() as f64
}

#[test]
fn work_around_a_loop_is_the_odd_stiffness_times_the_area() {
    let mut random = Random(142);
    for _ in 0..2000 {
        let body = random_body(&mut random);
        let corners: Vec<[f64; 2]> = (0..2 + random.count(7)).map(|_| [random.between(-3.0, 5.0), random.between(-3.0, 5.0)]).collect();
        let twice_area: f64 = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(from, to)| from[0] * to[1] - from[1] * to[0]).sum();
        let (work, expected) = (body.work_around(&corners), -body.odd_stiffness() * twice_area);
        assert!((work - expected).abs() < 1e-13 * scale(&body, &corners), "{work:e} {expected:e}");
        // The symmetric part of the same body does no work.
        let mean = 0.5 * (body.stiffness[0][1] + body.stiffness[1][0]);
        let symmetric = TwoForces { stiffness: [[body.stiffness[0][0], mean], [mean, body.stiffness[1][1]]] };
        assert!(symmetric.work_around(&corners).abs() < 1e-13 * scale(&body, &corners));
        // and holds the whole energy.
        let energy = body.energy(corners[0]) - symmetric.energy(corners[0]);
        assert!(energy.abs() < 1e-14 * scale(&body, &corners));
    }
}

#[test]
fn the_order_of_loading_matters_as_in_1_45() {
    let mut random = Random(145);
    for _ in 0..2000 {
        let body = random_body(&mut random);
        let [[k11, k12], [k21, k22]] = body.stiffness;
        let determinant = k11 * k22 - k12 * k21;
        if determinant.abs() < 1e-2 * (k11 * k22).abs().max((k12 * k21).abs()) {
            continue;
        }
        let forces = [random.between(-2.0, 2.0), random.between(-2.0, 2.0)];
        let under = |first: f64, second: f64| [(k22 * first - k12 * second) / determinant, (k11 * second - k21 * first) / determinant];
        let (only_first, only_second, both) = (under(forces[0], 0.0), under(0.0, forces[1]), under(forces[0], forces[1]));
        let rest = [0.0, 0.0];
        let path = |middle: [f64; 2]| body.work_along(rest, middle) + body.work_along(middle, both);
        let difference = path(only_first) - path(only_second);
        // (1.45): L_I − L_II = u₁₂F₁ − u₂₁F₂.
        let expected = only_second[0] * forces[0] - only_first[1] * forces[1];
        let size = scale(&body, &[only_first, only_second, both]);
        assert!((difference - expected).abs() < 1e-13 * size, "{difference:e} {expected:e} of {size:e}");
    }
}

#[test]
fn work_is_change_of_energy_and_nonconservative_work() {
    let body = TwoForces { stiffness: [[2.3e5, -7.0e4], [1.9e5, 4.0e5]] };
    // A quarter of an ellipse in small steps; δL_P = Kᴼ_ij u_j δu_i at the middle of each.
    let at = |step: u32| {
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(step) / 1000.0;
        [3e-3 * angle.cos() + 1e-3, 2e-3 * angle.sin()]
    };
    let (mut work, mut nonconservative) = (0.0, 0.0);
    for step in 0..1000 {
        let (from, to) = (at(step), at(step + 1));
        work += body.work_along(from, to);
        let (middle, change) = ([0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])], [to[0] - from[0], to[1] - from[1]]);
        nonconservative += body.odd_stiffness() * (middle[1] * change[0] - middle[0] * change[1]);
    }
    let stored = body.energy(at(1000)) - body.energy(at(0));
    assert!((work - stored - nonconservative).abs() < 1e-13 * (work.abs() + stored.abs() + nonconservative.abs()));
    assert!(nonconservative.abs() > 0.1 * stored.abs(), "the example shows something: {nonconservative:e} {stored:e}");
}
