//! Bars of spheres under histories.

use super::super::draw::Draw;
use super::super::known_states::sphere::known_sphere;
use super::tally::{Compared, Judged, Truth};
use super::{ANOTHER_ROUTE, SEED};
use crate::estimate::Estimate;
use crate::indentation::{Adhesion, Controlled, History, IndentationProblem, PathPoint, Profile, Trace, march, run};
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
/// Tolerance of a second march over that of the truth: √10.
const LOOSER: f64 = 3.162_277_660_168_379_5;
/// What two tight marches have alike, over the scale: what the edge condition is solved to.
const ALIKE: f64 = 1e-11;
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
    judged_of(Draw::of(SEED ^ 5, scene), scene, &ACCURACIES, drawn, Known::ToTheAccuracy)
}

/// The same scene, judged by a truth that is known to what a second tight march differs by.
#[must_use]
pub fn judged_by_two(scene: u64) -> Judged {
    judged_of(Draw::of(SEED ^ 5, scene), scene, &ACCURACIES, drawn, Known::ToItsChange)
}

/// How well a tighter march is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Known {
    /// To a thousandth of the accuracy, whatever it says of itself.
    ToTheAccuracy,
    /// To what a second one, √10 looser, differs by.
    ToItsChange,
}

/// A way to draw a scene for an accuracy.
pub(super) type Drawn = fn(&mut Draw, f64) -> Result<(Material, IndentationProblem), Refusal>;

/// A scene from a stream, for one of some accuracies, drawn in a way unless its state is drawn first.
pub(super) fn judged_of(mut draw: Draw, scene: u64, accuracies: &[f64], drawn: Drawn, known: Known) -> Judged {
    let accuracy = accuracies[(scene / ANOTHER_ROUTE + scene) as usize % accuracies.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let mut judged = Judged { scene, accuracy, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = if another {
        against_known(&mut draw, &mut judged)
    } else {
        drawn(&mut draw, accuracy).and_then(|scene| against_tighter(&scene, known, &mut judged))
    };
    match result {
        Ok(compared) => judged.compared = compared,
        Err(refusal) => judged.trouble = Some(refusal.to_string()),
    }
    judged
}

fn against_tighter(
    (material, problem): &(Material, IndentationProblem),
    known: Known,
    judged: &mut Judged,
) -> Result<Vec<Compared>, Refusal> {
    judged.described = format!("{material:?} {problem:?}");
    let found = run(material, problem)?;
    let tolerance = (TIGHTER * found.tolerance).max(TIGHTEST);
    let exact = march(material, problem, tolerance)?;
    let second = match known {
        Known::ToTheAccuracy => None,
        Known::ToItsChange => Some(march(material, problem, LOOSER * tolerance)?),
    };
    if !found.reached {
        judged.trouble = Some("accuracy not reached".into());
    }
    let accuracy = judged.accuracy;
    let truth = |value: f64, second: Option<f64>, scale: f64| {
        Estimate::new(value, second.map_or(UNKNOWN * accuracy * scale, |second| (value - second).abs() + ALIKE * scale))
    };
    let scale = |of: fn(&PathPoint) -> f64| exact.path.iter().fold(0.0_f64, |most, point| most.max(of(point).abs()));
    let scales = [
        scale(|point| point.penetration),
        scale(|point| point.force),
        scale(|point| point.contact_radius),
        scale(|point| point.stress_intensity_factor),
    ];
    let duration: f64 = problem.history.segments.iter().map(|segment| segment.duration).sum();
    let mut compared = Vec::new();
    let quantities = ["penetration", "force", "contact radius", "stress intensity"];
    for (index, instant) in found.instants.iter().enumerate().skip(1) {
        let values = |trace: &Trace| {
            let point = trace.kept.get(index).and_then(|place| trace.path.get(*place))?;
            Some([point.penetration, point.force, point.contact_radius, point.stress_intensity_factor])
        };
        let estimates = [instant.penetration, instant.force, instant.contact_radius, instant.stress_intensity_factor];
        let Some(exact) = values(&exact) else { continue };
        let second = second.as_ref().and_then(values);
        for (k, ((quantity, found), scale)) in quantities.into_iter().zip(estimates).zip(scales).enumerate() {
            // What is imposed is exact on both sides.
            if found.value.to_bits() != exact[k].to_bits() {
                compared.push(Compared { quantity, found, truth: truth(exact[k], second.map(|second| second[k]), scale), scale });
            }
        }
    }
    // Times and depths of an event are known as well as each other: to what the march knows of the path.
    let quantities = ["force of an event", "radius of an event", "depth of an event", "time of an event"];
    let scales_of_events = [scales[1], scales[2], scales[0], duration];
    for (index, event) in found.events.iter().enumerate() {
        let values = |trace: &Trace| {
            let other = trace.events.get(index).filter(|other| other.kind == event.kind)?;
            Some([other.force, other.contact_radius, other.penetration, other.time])
        };
        let estimates = [event.force, event.contact_radius, event.penetration, event.time];
        let Some(exact) = values(&exact) else { continue };
        let second = second.as_ref().and_then(values);
        for (k, ((quantity, found), scale)) in quantities.into_iter().zip(estimates).zip(scales_of_events).enumerate() {
            compared.push(Compared { quantity, found, truth: truth(exact[k], second.map(|second| second[k]), scale), scale });
        }
    }
    if let (Some(found), Some(value)) = (found.largest_tension, exact.largest_tension()) {
        let second = second.as_ref().and_then(Trace::largest_tension);
        compared.push(Compared { quantity: "largest tension", found, truth: truth(value, second, scales[1]), scale: scales[1] });
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
