//! Bars of spheres under histories.

use super::super::draw::Draw;
use super::super::known_states::sphere::known_sphere;
use super::tally::{Compared, Judged, Truth};
use super::{ANOTHER_ROUTE, SEED};
use crate::estimate::Estimate;
use crate::indentation::{Adhesion, Controlled, History, IndentationProblem, PathPoint, Profile, march, run};
use crate::material::Material;
use crate::refusal::Refusal;
use std::f64::consts::PI;

/// Accuracies asked for, in turn.
const ACCURACIES: [f64; 3] = [1e-2, 1e-3, 1e-4];
/// Tolerance of the truth over that of the finest march: the problem is asked for a hundred times more than the march gave, a thousand times more than its bars say.
const TIGHTER: f64 = 1e-2;
/// No march is tighter.
const TIGHTEST: f64 = 1e-9;
/// What is then not known, over the scale: a thousandth of the accuracy.
const UNKNOWN: f64 = 1e-3;
/// Textbook fields by quadrature, over the scale.
const BY_FIELDS: f64 = 1e-9;

fn drawn(draw: &mut Draw, accuracy: f64) -> Result<(Material, IndentationProblem), Refusal> {
    let (modulus, radius, time) = (draw.log_between(1e-2, 1e7), draw.log_between(1e-4, 1e2), draw.log_between(1e-3, 1e3));
    let (beta, terms) = (draw.log_between(1.5, 300.0), 1 + draw.below(4));
    let material = draw.solid(modulus, beta, time, terms, 1.3 * terms as f64)?;
    let work_of_adhesion = modulus * radius * draw.log_between(1e-5, 3e-3);
    let jkr = (9.0 * PI * work_of_adhesion * radius * radius / (2.0 * modulus)).cbrt();
    let process_zone = jkr * draw.log_between(3e-3, 0.1);
    let depth = jkr * jkr / radius * draw.between(0.1, 1.5);
    let speed = depth / time * 10f64.powf(draw.between(-4.0, 4.0));
    let hold = time * draw.between(0.1, 3.0);
    let kind = draw.below(4);
    let history = match kind {
        0 => History::penetration(0.0).at_speed(depth, speed).hold(hold).at_speed(0.3 * depth, speed),
        1 => History::penetration(depth).at_speed(0.5 * depth, speed).at_speed(0.8 * depth, 0.5 * speed),
        2 => History::force(0.0).ramp(modulus * depth * jkr, depth / speed).ramp(0.0, 2.0 * depth / speed),
        _ => History::frame(0.0).at_speed(2.0 * depth, speed).then(Controlled::Frame, 0.5 * depth, depth / speed),
    };
    let mut problem = IndentationProblem::new(Profile::Paraboloid { radius }, Some(Adhesion { work_of_adhesion, process_zone }), history);
    problem.frame_stiffness = Some(modulus * jkr * draw.log_between(0.3, 30.0));
    problem.instants_per_segment = 2;
    problem.accuracy = accuracy;
    Ok((material, if kind == 1 { problem.relaxed() } else { problem }))
}

/// Material and history of a scene whose truth is a tighter march.
///
/// # Errors
/// A drawn number out of range; none is.
pub fn problem(scene: u64, accuracy: f64) -> Result<(Material, IndentationProblem), Refusal> {
    drawn(&mut Draw::of(SEED ^ 5, scene), accuracy)
}

/// A scene, judged.
#[must_use]
pub fn judged(scene: u64) -> Judged {
    judged_of(Draw::of(SEED ^ 5, scene), scene, &ACCURACIES, drawn)
}

/// A way to draw a scene for an accuracy.
pub(super) type Drawn = fn(&mut Draw, f64) -> Result<(Material, IndentationProblem), Refusal>;

/// A scene from a stream, for one of some accuracies, drawn in a way unless its state is drawn first.
pub(super) fn judged_of(mut draw: Draw, scene: u64, accuracies: &[f64], drawn: Drawn) -> Judged {
    let accuracy = accuracies[(scene / ANOTHER_ROUTE + scene) as usize % accuracies.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let mut judged = Judged { scene, accuracy, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = if another {
        against_known(&mut draw, &mut judged)
    } else {
        drawn(&mut draw, accuracy).and_then(|scene| against_tighter(&scene, &mut judged))
    };
    match result {
        Ok(compared) => judged.compared = compared,
        Err(refusal) => judged.trouble = Some(refusal.to_string()),
    }
    judged
}

fn against_tighter((material, problem): &(Material, IndentationProblem), judged: &mut Judged) -> Result<Vec<Compared>, Refusal> {
    judged.described = format!("{material:?} {problem:?}");
    let found = run(material, problem)?;
    let exact = march(material, problem, (TIGHTER * found.tolerance).max(TIGHTEST))?;
    if !found.reached {
        judged.trouble = Some("accuracy not reached".into());
    }
    let scale = |of: fn(&PathPoint) -> f64| exact.path.iter().fold(0.0_f64, |most, point| most.max(of(point).abs()));
    let scales = [
        scale(|point| point.penetration),
        scale(|point| point.force),
        scale(|point| point.contact_radius),
        scale(|point| point.stress_intensity_factor),
    ];
    let duration: f64 = problem.history.segments.iter().map(|segment| segment.duration).sum();
    let mut compared = Vec::new();
    for (instant, place) in found.instants.iter().zip(&exact.kept).skip(1) {
        let Some(point) = exact.path.get(*place) else { continue };
        let pairs = [
            ("penetration", instant.penetration, point.penetration),
            ("force", instant.force, point.force),
            ("contact radius", instant.contact_radius, point.contact_radius),
            ("stress intensity", instant.stress_intensity_factor, point.stress_intensity_factor),
        ];
        for ((quantity, found, truth), scale) in pairs.into_iter().zip(scales) {
            // What is imposed is exact on both sides.
            if found.value.to_bits() != truth.to_bits() {
                compared.push(Compared { quantity, found, truth: Estimate::new(truth, UNKNOWN * judged.accuracy * scale), scale });
            }
        }
    }
    for (one, other) in found.events.iter().zip(&exact.events).filter(|(one, other)| one.kind == other.kind) {
        let pairs = [
            ("force of an event", one.force, other.force, scales[1]),
            ("radius of an event", one.contact_radius, other.contact_radius, scales[2]),
        ];
        for (quantity, found, truth, scale) in pairs {
            compared.push(Compared { quantity, found, truth: Estimate::new(truth, UNKNOWN * judged.accuracy * scale), scale });
        }
        // Times and depths of an event are known as well as each other: to what the march knows of the path.
        let spans =
            [("depth of an event", one.penetration, other.penetration, scales[0]), ("time of an event", one.time, other.time, duration)];
        for (quantity, found, truth, scale) in spans {
            compared.push(Compared { quantity, found, truth: Estimate::new(truth, UNKNOWN * judged.accuracy * scale), scale });
        }
    }
    if let (Some(one), Some(other)) = (found.largest_tension, exact.largest_tension()) {
        let truth = Estimate::new(other, UNKNOWN * judged.accuracy * scales[1]);
        compared.push(Compared { quantity: "largest tension", found: one, truth, scale: scales[1] });
    }
    Ok(compared)
}

fn against_known(draw: &mut Draw, judged: &mut Judged) -> Result<Vec<Compared>, Refusal> {
    let known = known_sphere(draw)?;
    judged.described = known.described();
    let found = run(&known.material, &IndentationProblem { accuracy: judged.accuracy, ..known.problem.clone() })?;
    let mut compared = Vec::new();
    for (place, values) in &known.instants {
        let Some(instant) = found.instants.get(*place) else {
            judged.trouble = Some("an instant is missing".into());
            continue;
        };
        let estimates = [instant.penetration, instant.force, instant.contact_radius];
        let quantities = ["penetration", "force", "contact radius"].into_iter().zip(estimates);
        for (((quantity, found), value), scale) in quantities.zip(values).zip(known.scales) {
            compared.push(Compared { quantity, found, truth: Estimate::new(*value, BY_FIELDS * scale), scale });
        }
    }
    Ok(compared)
}

/// Evaluations of the edge condition at 1e-3 and at 1e-9.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let counted = |accuracy: f64| {
        let (material, problem) = drawn(&mut Draw::of(SEED ^ 5, scene), accuracy).ok()?;
        Some(run(&material, &problem).ok()?.work.closure_evaluations)
    };
    Some([counted(1e-3)?, counted(1e-9)?])
}
