//! Source: thesis Secs 4.2 (Eqs 4.12–4.18), 4.4 and 4.5.
//!
//! Goal: the exact line reduction and the thesis's dense annulus scheme tell one story.
//!
//! ```text
//!   line      C by a quadrature on the line, edge anywhere, time found for each place of the edge
//!   annuli    C by sums of pressure × gap, edge on nodes λ apart, edge found for each time        difference ~ λ, with scatter
//! ```
//! Parameters: γ̃ = 1.6e-4, δ̃ = 0.013, β = 10, relaxed at Δ̃_B = 0.032 (Fig 4.5), speeds over three decades; approach and return (Fig 4.3).
//!
//! Oracle: [`viscotack_verification::rivals::annulus_indentation`], which shares no line of code with the core.
//!
//! Tolerance: the rival's own error: at its finest (16 annuli per process zone) 1e-2 of the largest force and of the first radius, at each
//! instant; the largest difference of a history falls with the annuli.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, Start, integrate};
use viscotack_verification::rivals::annulus_indentation::{AnnulusPath, AnnulusScheme, AnnulusStart};

const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;
const INSTANTS: u32 = 6;

fn scheme(elements_per_zone: usize, time_step: f64) -> AnnulusScheme {
    AnnulusScheme {
        sphere_radius: 1.0,
        relaxed_modulus: 1.0,
        glassy_modulus: 10.0,
        retardation_time: 10.0,
        work_of_adhesion: WORK,
        process_zone: ZONE,
        elements_per_zone,
        time_step,
        keep_factors: true,
    }
}

/// (t, Δ, F, a) of the core at equally spaced instants of each leg.
fn core(start: Start, corners: &[(f64, f64)]) -> Vec<[f64; 4]> {
    let mut history = History::penetration(corners[0].1);
    for leg in corners.windows(2) {
        history = history.ramp(leg[1].1, leg[1].0 - leg[0].0);
    }
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    let problem = IndentationProblem {
        start,
        instants_per_segment: INSTANTS,
        ..IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history)
    };
    let material = PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    let trace = integrate(&material, &problem, 1e-6).unwrap();
    let instants = trace.kept.iter().map(|&kept| trace.path[kept]);
    instants.map(|point| [point.time, point.penetration, point.force, point.contact_radius]).collect()
}

fn at(path: &AnnulusPath, time: f64) -> Option<(f64, f64)> {
    path.points.iter().find(|point| (point.time - time).abs() <= 1e-9 * (1.0 + time)).map(|point| (point.force, point.contact_radius))
}

/// The largest difference of force and of radius, over their scales, and how many values were compared.
fn differences(exact: &[[f64; 4]], path: &AnnulusPath, print: bool) -> ([f64; 2], usize) {
    let force_scale = exact.iter().fold(0.0_f64, |most, point| most.max(point[2].abs()));
    let radius_scale = exact.iter().fold(0.0_f64, |most, point| most.max(point[3]));
    let (mut worst, mut count) = ([0.0_f64; 2], 0);
    for &[time, depth, force, radius] in exact {
        let Some((rival_force, rival_radius)) = at(path, time) else { continue };
        let found = [(rival_force - force).abs() / force_scale, (rival_radius - radius).abs() / radius_scale];
        if print {
            println!(
                "    t {time:9.4} Δ {depth:8.5}  F {force:12.5e} rival {rival_force:12.5e} ({:.1e})  a {radius:.5} rival {rival_radius:.5} ({:.1e})",
                found[0], found[1]
            );
        }
        worst = [worst[0].max(found[0]), worst[1].max(found[1])];
        count += 2;
    }
    (worst, count)
}

/// Three meshes, the time step with the mesh; returns how many values the finest compared.
fn compare(name: &str, start: (Start, AnnulusStart), corners: &[(f64, f64)], steps: f64) -> usize {
    let exact = core(start.0, corners);
    let duration = corners.windows(2).map(|leg| leg[1].0 - leg[0].0).fold(f64::INFINITY, f64::min);
    let mut all = Vec::new();
    let mut compared = 0;
    for elements in [4, 8, 16] {
        // The instants of the core are steps of the rival: each leg has a multiple of INSTANTS of them.
        let per_leg = (steps * f64::from(elements) / 16.0 / f64::from(INSTANTS)).ceil() * f64::from(INSTANTS);
        let path = scheme(elements as usize, duration / per_leg * (1.0 + 1e-12)).run(start.1, corners).unwrap();
        println!(
            "{name}: δ/λ = {elements}, {per_leg} steps a leg, {} annuli, {} solutions, {} factors",
            path.annuli, path.solutions, path.factorizations
        );
        let (worst, count) = differences(&exact, &path, elements == 16);
        println!("  worst difference: F {:.2e}, a {:.2e}", worst[0], worst[1]);
        all.push(worst);
        compared = count;
    }
    for quantity in 0..2 {
        let of = |mesh: usize| all[mesh][quantity];
        assert!(of(2) < 1e-2, "{name}: {all:?}");
        assert!(of(2) < 0.7 * of(0), "{name}: {all:?}");
    }
    compared
}

#[test]
fn retraction_from_relaxed_contacts() {
    let relaxed = (Start::Relaxed, AnnulusStart::Relaxed);
    let mut compared = 0;
    for (speed, end) in [(2e-4, 0.005), (2e-3, 0.002), (2e-2, 0.022), (2e-1, 0.025)] {
        compared += compare(&format!("retraction at {speed:e}"), relaxed, &[(0.0, 0.032), ((0.032 - end) / speed, end)], 600.0);
    }
    println!("{compared} values");
    assert!(compared >= 40);
}

#[test]
fn approach_and_return() {
    let untouched = (Start::Untouched, AnnulusStart::Untouched);
    let (top, speed) = (0.02, 2e-3);
    let turn = top / speed;
    let compared = compare("approach and return", untouched, &[(0.0, 0.0), (turn, top), (2.0 * turn, 0.0)], 600.0);
    println!("{compared} values");
    assert!(compared >= 20);
}
