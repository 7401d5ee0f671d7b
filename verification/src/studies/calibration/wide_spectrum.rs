//! Bounds of spheres of solids with up to twenty times over up to twelve decades, at accuracies of 1e-3 to 1e-6.
//!
//! An edge that lets go of such a solid accelerates through all of its times, and one that creeps has layers behind it that no panel resolves.

use super::super::draw::Draw;
use super::tally::Assessed;
use super::{SEED, sphere};
use std::f64::consts::PI;
use viscotack::indentation::{Adhesion, Controlled, History, IndentationProblem, Profile, run};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Accuracies asked for, in turn.
const ACCURACIES: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// Terms at most.
const MOST_TERMS: usize = 20;
/// Decades between the times at most.
const DECADES: f64 = 12.0;

fn drawn(draw: &mut Draw, accuracy: f64) -> Result<(PlaneMaterial, IndentationProblem), Refusal> {
    let (modulus, radius, time) = (draw.log_between(1e-2, 1e7), draw.log_between(1e-4, 1e2), draw.log_between(1e-3, 1e3));
    let (beta, terms) = (1.0 + draw.log_between(0.25, 1e3), 1 + draw.below(MOST_TERMS));
    // More wide ones than narrow.
    let decades = if terms == 1 { 0.0 } else { DECADES * draw.unit().sqrt() };
    let material = draw.solid(modulus, beta, time * 10f64.powf(0.5 * decades), terms, decades)?;
    let work_of_adhesion = modulus * radius * draw.log_between(3e-5, 1e-2);
    let jkr = (9.0 * PI * work_of_adhesion * radius * radius / (2.0 * modulus)).cbrt();
    let process_zone = jkr * draw.log_between(3e-3, 0.1);
    let depth = jkr * jkr / radius * draw.between(0.1, 1.5);
    let speed = depth / time * 10f64.powf(draw.between(-4.0, 4.0));
    let (hold, kind) = (time * 10f64.powf(draw.between(-3.0, 3.0)), draw.below(5));
    let force = modulus * depth * jkr;
    let history = match kind {
        0 => History::penetration(0.0).at_speed(depth, speed).at_speed(-2.0 * depth, speed),
        1 => History::penetration(0.0).at_speed(depth, speed).hold(hold).at_speed(-depth, speed).at_speed(0.5 * depth, speed),
        2 => History::force(0.0).ramp(force, depth / speed).ramp(-0.5 * force, 2.0 * depth / speed),
        3 => History::frame(0.0).at_speed(2.0 * depth, speed).hold(hold).then(Controlled::Frame, -2.0 * depth, 4.0 * depth / speed),
        _ => History::penetration(depth).at_speed(-2.0 * depth, speed),
    };
    let mut problem = IndentationProblem::new(Profile::Paraboloid { radius }, Some(Adhesion { work_of_adhesion, process_zone }), history);
    problem.frame_stiffness = Some(modulus * jkr * draw.log_between(0.3, 30.0));
    problem.instants_per_segment = 3;
    problem.accuracy = accuracy;
    problem.energies = draw.chance(sphere::WITH_ENERGIES);
    Ok((material, if kind == 4 { problem.relaxed() } else { problem }))
}

/// Material and history of a scene whose truth is a tighter integration.
///
/// # Errors
/// A drawn number out of range; none is.
pub fn problem(scene: u64, accuracy: f64) -> Result<(PlaneMaterial, IndentationProblem), Refusal> {
    drawn(&mut Draw::of(SEED ^ 6, scene), accuracy)
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    sphere::assessed_of(Draw::of(SEED ^ 6, scene), scene, &ACCURACIES, drawn)
}

/// Evaluations of the edge condition at 1e-3 and at 1e-9.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let counted = |accuracy: f64| {
        let (material, problem) = drawn(&mut Draw::of(SEED ^ 6, scene), accuracy).ok()?;
        Some(run(&material, &problem).ok()?.work.closure_evaluations)
    };
    Some([counted(1e-3)?, counted(1e-9)?])
}
