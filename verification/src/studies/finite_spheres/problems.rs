//! A random problem, and its runs against each other.

use crate::studies::draw::Draw;
use serde::{Deserialize, Serialize};
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::sphere::{Accuracy, Control, Creep, Leg, Margins, Mesher, Motion, Problem, Run, Shape, Start, run};
use viscotack::refusal::Refusal;

/// Tolerance of the first of both runs that give bounds, for smooth and for kinked laws; the second, and the one that they are compared with, are
/// tightened from it as a scene does.
const TOLERANCES: [f64; 2] = [1e-4, 1e-3];
/// What the energy balance may leave over the largest energy of the history, over that tolerance.
const BALANCE: f64 = 10.0;
/// Attempted steps of the first run; the others may take more.
pub const MOST_STEPS: usize = 3000;
const MORE: [usize; 3] = [1, 4, 12];
/// A bound is at least this part of the force of reference, 5RΔγ, or of the value.
const FLOOR: f64 = 1e-8;

/// What a problem came to.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Compared {
    /// Values that were compared.
    pub values: usize,
    /// Those that differ by more than their bound, in words.
    pub outside: Vec<String>,
    /// Why it was not solved.
    pub failed: Option<String>,
    /// Why it was not compared: it takes too many steps, or more nodes than a mesh may have.
    pub left_out: Option<String>,
    /// What the energy balance leaves, over the largest energy.
    pub defect: f64,
    /// The same over what it may leave.
    pub defect_over_allowed: f64,
    /// Steps of the tighter of both runs.
    pub steps: usize,
}

/// A problem of a seed.
#[must_use]
pub fn problem(seed: u64, number: u64) -> Problem {
    let mut draw = Draw::of(seed, number);
    let (tabor, stiffening) = (draw.log_between(0.05, 6.0), draw.log_between(2.0, 1000.0));
    let terms = [1, 3, 12][draw.below(3)];
    let weights: Vec<f64> = (0..terms).map(|_| draw.log_between(0.1, 1.0)).collect();
    let total: f64 = weights.iter().sum();
    let decades = if terms == 12 { 0.5 } else { 1.5 };
    let times = (0..terms).map(|k| draw.log_between(0.5, 2.0) * 10_f64.powf(decades * (k as f64 - 0.5 * (terms - 1) as f64))).collect();
    let creep = Creep { stiffening, fractions: weights.iter().map(|weight| weight / total).collect(), times };
    let shape = match draw.below(5) {
        0 => Shape::Power { coefficient: draw.log_between(0.5, 2.0), exponent: 1.0 },
        1 => Shape::Power { coefficient: draw.log_between(0.1, 1.0), exponent: draw.between(1.3, 4.0) },
        _ => Shape::Paraboloid,
    };
    let law = match draw.below(8) {
        0 => Law::Exponential,
        1 => Law::Dugdale { ramp: draw.between(0.05, 0.5) },
        2 => Law::Cosine,
        _ => Law::LennardJones,
    };
    let control = match draw.below(6) {
        0 => Control::Frame(draw.log_between(0.3, 1e3)),
        1 => Control::Force,
        _ => Control::Penetration,
    };
    let depth = draw.log_between(1.0, 30.0);
    let end = -(4.0 + 3.0 * tabor * tabor.max(1.0).sqrt() + 0.3 * depth).min(60.0);
    // A frame is pulled farther, by what it stretches; a force that is imposed pulls up to as many RΔγ.
    let end = if let Control::Frame(stiffness) = control { end - 40.0 / stiffness } else { end };
    let leg = |motion| Leg { control, motion };
    let (approach, retreat) = (draw.log_between(1e-3, 1e5), draw.log_between(1e-3, 1e5));
    let mut history = Vec::new();
    let (relaxed, held) = (draw.chance(0.5), control == Control::Force);
    // An imposed force has no equilibrium far from contact.
    let value = if relaxed || held { depth } else { -8.0 };
    let start = match control {
        Control::Penetration if relaxed => Start::Relaxed(value),
        Control::Penetration => Start::Unstrained(value),
        _ => Start::Held { control, value, relaxed },
    };
    if !relaxed && !held {
        history.push(leg(Motion::Ramp { to: depth, duration: (depth + 8.0) / approach }));
    }
    match draw.below(4) {
        0 => history.push(leg(Motion::Hold(draw.log_between(1e-3, 1e3)))),
        1 => history.push(leg(Motion::Ramp { to: depth * draw.between(0.5, 1.2), duration: 0.0 })),
        2 => history.push(leg(Motion::Oscillation {
            amplitude: draw.log_between(0.1, 4.0),
            period: draw.log_between(1e-2, 1e2),
            cycles: draw.between(0.5, 3.0),
        })),
        _ => {}
    }
    let before: f64 = history.iter().map(|leg| leg.motion.duration()).sum();
    let pull = (depth - end) / retreat;
    history.push(leg(Motion::Ramp { to: end, duration: pull }));
    let instants = (1..8).map(|k| before + pull * f64::from(k) / 8.0).collect();
    Problem { law, tabor, shape, creep, start, history, instants, rim: None, surfaces: Vec::new() }
}

/// Draws a problem and compares its runs.
#[must_use]
pub fn compared(seed: u64, number: u64) -> Compared {
    let problem = problem(seed, number);
    let law = match Attraction::new(problem.law.clone(), 1.0, 1.0) {
        Ok(law) => law,
        Err(refusal) => return Compared { failed: Some(format!("problem {number}: {refusal}")), ..Compared::default() },
    };
    let kinked = law.is_kinked();
    let mut accuracy = Accuracy::of_law(TOLERANCES[usize::from(kinked)], &law);
    let margins = Margins::of_law(&law);
    let mut mesher = Mesher::new(accuracy.order);
    let mut runs: Vec<Run> = Vec::new();
    for (index, more) in MORE.into_iter().enumerate() {
        if index > 0 {
            accuracy = accuracy.tightened();
        }
        accuracy.budget = more * MOST_STEPS;
        match run(&problem, accuracy, &mut mesher) {
            Ok(run) => runs.push(run),
            Err(refusal) => {
                let what = match &refusal {
                    Refusal::NotConverged { what, .. } => *what,
                    _ => "",
                };
                let said = format!("problem {number}: {refusal}");
                let not_compared = what == "the integration in time" || what == "the mesh";
                let (left_out, failed) = if not_compared { (Some(said), None) } else { (None, Some(said)) };
                return Compared { left_out, failed, ..Compared::default() };
            }
        }
    }
    let mut compared = Compared::default();
    let [loose, tight, truth] = runs.as_slice() else { return compared };
    compared.steps = tight.certificate.steps;
    compared.defect = tight.certificate.energy_residual / tight.certificate.energy_scale.max(1.0);
    compared.defect_over_allowed = compared.defect / (BALANCE * TOLERANCES[usize::from(kinked)]);
    // What is not imposed.
    let held = problem.history.iter().any(|leg| leg.control == Control::Force);
    let forces = |run: &Run| -> Vec<Option<f64>> {
        let at = |time: &f64| run.at(*time).map(|row| if held { row.penetration } else { row.force });
        let last = if held {
            run.detachment.map(|row| row.time / problem.instants.last().copied().unwrap_or(1.0))
        } else {
            Some(-run.pull_off_force())
        };
        problem.instants.iter().map(at).chain([last]).collect()
    };
    let all: Vec<[f64; 3]> =
        forces(loose).into_iter().zip(forces(tight)).zip(forces(truth)).filter_map(|((a, b), c)| Some([a?, b?, c?])).collect();
    // As the plan of a scene does: a bound is at least a part of the largest one, and those beside it.
    let by_chance = margins.by_chance * tight.certificate.accuracy.step;
    let change = |index: usize| all.get(index).map_or(0.0, |[a, b, _]| margins.of_change * (a - b).abs() + by_chance * b.abs());
    let largest = (0..all.len()).map(change).fold(0.0, f64::max);
    for (index, [_, b, c]) in all.iter().enumerate() {
        let beside = change(index).max(change(index + 1)).max(index.checked_sub(1).map_or(0.0, change));
        let bound = beside.max(0.05 * largest).max(FLOOR * b.abs().max(5.0));
        compared.values += 1;
        if (b - c).abs() > bound {
            compared.outside.push(format!("problem {number}, value {index}: {b} ± {bound:.1e}, {c}"));
        }
    }
    compared
}
