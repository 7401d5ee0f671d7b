//! Bounds of spheres under histories.

use super::super::draw::Draw;
use super::super::known_states::sphere::known_sphere;
use super::tally::{Assessed, Compared, Truth};
use super::{ANOTHER_ROUTE, SEED};
use std::f64::consts::PI;
use viscotack::estimate::Estimate;
use viscotack::indentation::{
    Adhesion, Controlled, Energies, Event, EventKind, History, IndentationProblem, Instant, PathPoint, Profile, Trace, integrate, run,
};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Accuracies asked for, in turn.
const ACCURACIES: [f64; 3] = [1e-2, 1e-3, 1e-4];
/// Tolerance of the truth over that of the integration whose numbers are reported: what would be reported at a thousandth of the accuracy.
const TIGHTER: f64 = 1e-3;
/// The truth of the tightest accuracies: half of what the solver's own integrations go down to, so that it is none of them.
const TIGHTEST: f64 = 5e-10;
/// Tolerance of a second integration over that of the truth: √10. What they differ by is not known of the truth.
const LOOSER: f64 = 3.162_277_660_168_379_5;
/// What two tight integrations have alike, over the scale: what the edge condition is solved to.
const ALIKE: f64 = 1e-11;
/// Part of the scenes whose energies are added up and assessed too.
pub(super) const WITH_ENERGIES: f64 = 0.25;
/// Textbook fields by quadrature, over the scale.
const BY_FIELDS: f64 = 1e-9;

fn drawn(draw: &mut Draw, accuracy: f64) -> Result<(PlaneMaterial, IndentationProblem), Refusal> {
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
    problem.energies = draw.chance(WITH_ENERGIES);
    Ok((material, if kind == 1 { problem.relaxed() } else { problem }))
}

/// Material and history of a scene whose truth is a tighter integration.
///
/// # Errors
/// A drawn number out of range; none is.
pub fn problem(scene: u64, accuracy: f64) -> Result<(PlaneMaterial, IndentationProblem), Refusal> {
    drawn(&mut Draw::of(SEED ^ 5, scene), accuracy)
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    assessed_of(Draw::of(SEED ^ 5, scene), scene, &ACCURACIES, drawn)
}

/// A way to draw a scene for an accuracy.
pub(super) type Drawn = fn(&mut Draw, f64) -> Result<(PlaneMaterial, IndentationProblem), Refusal>;

/// A scene from a stream, for one of some accuracies, drawn in a way unless its state is drawn first.
pub(super) fn assessed_of(mut draw: Draw, scene: u64, accuracies: &[f64], drawn: Drawn) -> Assessed {
    let accuracy = accuracies[(scene / ANOTHER_ROUTE + scene) as usize % accuracies.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let mut assessed = Assessed { scene, accuracy, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = if another {
        against_known(&mut draw, &mut assessed)
    } else {
        drawn(&mut draw, accuracy).and_then(|scene| against_tighter(&scene, &mut assessed))
    };
    match result {
        Ok(compared) => assessed.compared = compared,
        Err(refusal) => assessed.trouble = Some(refusal.to_string()),
    }
    assessed
}

/// A number of an instant: in an integration, as reported, and what no integration tells of it.
struct OfInstants {
    quantity: &'static str,
    integrated: fn(&PathPoint) -> Option<f64>,
    reported: fn(&Instant) -> Option<Estimate>,
    floor: fn(&PathPoint) -> f64,
}

const fn of_instants(
    quantity: &'static str,
    integrated: fn(&PathPoint) -> Option<f64>,
    reported: fn(&Instant) -> Option<Estimate>,
) -> OfInstants {
    OfInstants { quantity, integrated, reported, floor: |_| 0.0 }
}

const INSTANTS: [OfInstants; 10] = [
    of_instants("penetration", |point| Some(point.penetration), |reported| Some(reported.penetration)),
    of_instants("force", |point| Some(point.force), |reported| Some(reported.force)),
    of_instants("contact radius", |point| Some(point.contact_radius), |reported| Some(reported.contact_radius)),
    OfInstants {
        floor: PathPoint::intensity_floor,
        ..of_instants("stress intensity", |point| Some(point.stress_intensity_factor), |reported| Some(reported.stress_intensity_factor))
    },
    of_instants("stored energy", |point| Some(point.energies?.stored), |reported| Some(reported.energies?[0])),
    of_instants("dissipated power", |point| Some(point.energies?.dissipated_power), |reported| Some(reported.energies?[1])),
    of_instants("external work", |point| Some(point.energies?.external_work), |reported| Some(reported.energies?[2])),
    of_instants("dissipated energy", |point| Some(point.energies?.dissipated), |reported| Some(reported.energies?[3])),
    OfInstants {
        floor: PathPoint::tip_release_rate_floor,
        ..of_instants("tip release rate", |point| Some(point.energies?.tip_release_rate), |reported| reported.tip_release_rate)
    },
    OfInstants {
        floor: PathPoint::tip_release_rate_floor,
        ..of_instants("energy release rate", |point| point.energies?.energy_release_rate, |reported| reported.energy_release_rate)
    },
];

/// The same of an event or of the largest tension, and the scale that it is seen against: of the largest on the path, or of time.
struct OfEvents {
    quantity: &'static str,
    of_peak: &'static str,
    integrated: fn(&Event<f64>) -> Option<f64>,
    reported: fn(&Event<Estimate>) -> Option<Estimate>,
    scale: fn(&PathPoint) -> f64,
}

macro_rules! of_events {
    ($name:literal, $event:ident => $value:expr, $point:ident => $scale:expr) => {
        OfEvents {
            quantity: concat!($name, " of an event"),
            of_peak: concat!($name, " of the largest tension"),
            integrated: |$event| $value,
            reported: |$event| $value,
            scale: |$point| $scale,
        }
    };
}

fn energies(point: &PathPoint) -> Energies {
    point.energies.unwrap_or_default()
}

const EVENTS: [OfEvents; 11] = [
    of_events!("depth", event => Some(event.penetration), point => point.penetration),
    of_events!("force", event => Some(event.force), point => point.force),
    of_events!("radius", event => Some(event.contact_radius), point => point.contact_radius),
    of_events!("time", event => Some(event.time), point => point.time),
    of_events!("stress intensity", event => Some(event.stress_intensity_factor), point => point.stress_intensity_factor),
    of_events!("stored energy", event => Some(event.energies?[0]), point => energies(point).stored),
    of_events!("dissipated power", event => Some(event.energies?[1]), point => energies(point).dissipated_power),
    of_events!("external work", event => Some(event.energies?[2]), point => energies(point).external_work),
    of_events!("dissipated energy", event => Some(event.energies?[3]), point => energies(point).dissipated),
    of_events!("tip release rate", event => event.tip_release_rate, point => energies(point).tip_release_rate),
    of_events!("energy release rate", event => event.energy_release_rate, point => energies(point).tip_release_rate),
];

fn against_tighter((material, problem): &(PlaneMaterial, IndentationProblem), assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    assessed.described = format!("{material:?} {problem:?}");
    let found = run(material, problem)?;
    let tolerance = (TIGHTER * found.integration.tolerance).max(TIGHTEST);
    let (exact, second) = (integrate(material, problem, tolerance)?, integrate(material, problem, LOOSER * tolerance)?);
    if !found.reached {
        assessed.trouble = Some("accuracy not reached".into());
    }
    let truth = |exact: f64, second: Option<f64>, scale: f64| {
        Estimate::new(exact, second.map_or(0.0, |second| (exact - second).abs()) + ALIKE * scale)
    };
    let kept = |trace: &Trace, index: usize| trace.kept.get(index).and_then(|place| trace.path.get(*place)).copied();
    let of_path = &exact.path;
    let mut compared = Vec::new();
    for OfInstants { quantity, integrated, reported, floor } in INSTANTS {
        let scale = exact.path.iter().filter_map(integrated).fold(0.0_f64, |most, value| most.max(value.abs()));
        for (index, instant) in found.instants.iter().enumerate().skip(1) {
            let Some((point, exact)) = kept(&found.integration, index).zip(kept(&exact, index)) else { continue };
            let Some((found, exact)) = reported(instant).zip(integrated(&exact)) else { continue };
            // What is imposed is exact on both sides.
            if found.value.to_bits() != exact.to_bits() {
                let truth = truth(exact, kept(&second, index).and_then(|point| integrated(&point)), scale);
                compared.push(Compared { quantity, found, truth, scale, floor: floor(&point) });
            }
        }
    }
    let mut compare = |found: &Event<Estimate>, floor: f64, [exact, second]: [Option<Event<f64>>; 2]| {
        for OfEvents { quantity, of_peak, integrated, reported, scale } in EVENTS {
            let Some((found_value, value)) = reported(found).zip(exact.as_ref().and_then(integrated)) else { continue };
            let scale = of_path.iter().map(|point| scale(point).abs()).fold(0.0_f64, f64::max);
            let truth = truth(value, second.as_ref().and_then(integrated), scale);
            let quantity = if found.kind == EventKind::LargestTension { of_peak } else { quantity };
            // What panels beside the edge leave unknown of K, and of what goes with K².
            let floor = match quantity {
                _ if quantity.starts_with("stress intensity") => floor,
                _ if quantity.contains("release rate") => 2.0 * found_value.value.abs() * floor / found.stress_intensity_factor.value.abs(),
                _ => 0.0,
            };
            compared.push(Compared { quantity, found: found_value, truth, scale, floor });
        }
    };
    for (index, event) in found.events.iter().enumerate() {
        let same = |trace: &Trace| trace.events.get(index).filter(|other| other.kind == event.kind).copied();
        let Some(exact) = same(&exact) else {
            assessed.trouble = Some(format!("{:?} is not there in a tighter integration", event.kind));
            continue;
        };
        let floor = found.integration.unknown_of_events.get(index).map_or(0.0, |unknown| unknown[4]);
        compare(event, floor, [Some(exact), same(&second)]);
    }
    if let Some(tension) = &found.largest_tension {
        compare(tension, found.integration.summary.intensity_floor_of_peak(), [exact.summary.peak(), second.summary.peak()]);
    }
    Ok(compared)
}

fn against_known(draw: &mut Draw, assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    let known = known_sphere(draw)?;
    assessed.described = known.described();
    let found = run(&known.material, &IndentationProblem { accuracy: assessed.accuracy, ..known.problem.clone() })?;
    let mut compared = Vec::new();
    for (place, values) in &known.instants {
        let Some(instant) = found.instants.get(*place) else {
            assessed.trouble = Some("an instant is missing".into());
            continue;
        };
        let estimates = [instant.penetration, instant.force, instant.contact_radius];
        let quantities = ["penetration", "force", "contact radius"].into_iter().zip(estimates);
        for (((quantity, found), value), scale) in quantities.zip(values).zip(known.scales) {
            compared.push(Compared { quantity, found, truth: Estimate::new(*value, BY_FIELDS * scale), scale, floor: 0.0 });
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
