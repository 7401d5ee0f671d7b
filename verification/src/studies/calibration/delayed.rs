//! Bounds of cracks under load histories.

use super::super::draw::Draw;
use super::super::known_states::delayed::{KnownTime, known_growth};
use super::tally::{Assessed, Compared, Truth};
use super::{ANOTHER_ROUTE, SEED};
use viscotack::crack::delayed::trajectory::tends_to;
use viscotack::crack::delayed::{
    Event, EventKind, GrowthProblem, LoadHistory, LoadSegment, Onset, Resolution, Trajectory, Wave, onset, trajectory,
};
use viscotack::crack::{CrackBody, Interface, ProcessZone};
use viscotack::estimate::Estimate;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;

/// Lines a zone of the coarsest run, in turn: the fewest that a scene takes, and twice as many.
const LINES: [u32; 2] = [64, 128];
/// So many more for the truth: of third order 1/32768 of the error.
const MORE: u32 = 32;
/// Steps of a run at most.
const MOST_STEPS: u64 = 20_000_000;
/// Closed forms lose some hundred ulp in their exponentials.
const CLOSED: f64 = 1e-12;

struct Asked {
    material: PlaneMaterial,
    interface: Interface,
    history: LoadHistory,
    times: Vec<f64>,
}

fn drawn(draw: &mut Draw) -> Result<Asked, Refusal> {
    let terms = 1 + draw.below(4);
    let (relaxed, beta) = (draw.log_between(1e2, 1e9), draw.log_between(1.5, 300.0));
    let (longest, decades) = (draw.log_between(1e-4, 1e4), draw.between(0.3, 3.0));
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let body = if draw.chance(0.5) { CrackBody::AgainstRigid } else { CrackBody::TwoHalves };
    let length = draw.log_between(1e-9, 1e-3);
    let interface = Interface { work_of_adhesion: draw.log_between(1e-3, 1e3), process_zone: ProcessZone::Constant { length }, body };
    let (load, span, segments) = {
        let problem = GrowthProblem::new(&material, interface, 0.0)?;
        let load = problem.relaxed_limit() * (problem.glassy_limit() / problem.relaxed_limit()).powf(draw.between(0.15, 0.75));
        let delay = match onset(&problem, load)? {
            Onset::After { delay, .. } => delay.value,
            Onset::Never | Onset::AtOnce => longest,
        };
        let zones = draw.between(0.5, 3.0);
        let span = delay + zones * length / tends_to(&problem, load, 1e-6)?.speed.value;
        (load, span, draw.below(4))
    };
    let (part, lower) = (draw.between(0.2, 0.9), draw.between(0.3, 0.8) * load);
    let segments = match segments {
        0 => vec![LoadSegment::Step { load }, LoadSegment::Hold { duration: span }],
        1 => vec![LoadSegment::Ramp { duration: part * span, load }, LoadSegment::Hold { duration: span }],
        2 => vec![
            LoadSegment::Step { load },
            LoadSegment::Hold { duration: span },
            LoadSegment::Ramp { duration: 0.1 * part * span, load: lower },
            LoadSegment::Hold { duration: part * span },
            LoadSegment::Ramp { duration: 0.2 * span, load },
            LoadSegment::Hold { duration: 0.3 * span },
        ],
        _ => {
            let wave = if draw.chance(0.5) { Wave::Triangle } else { Wave::Square };
            vec![LoadSegment::Cycles { count: 4, period: 0.4 * span, lower, upper: load, wave }]
        }
    };
    let history = LoadHistory::from_segments(&segments)?;
    let end = history.segments().last().map_or(span, |segment| segment.start).max(span);
    let times = [0.37, 0.71, 1.0].map(|part| part * end).to_vec();
    Ok(Asked { material, interface, history, times })
}

impl Asked {
    fn solved(&self, lines_per_zone: u32) -> Result<Trajectory, Refusal> {
        let problem = GrowthProblem::new(&self.material, self.interface, 0.0)?;
        trajectory(&problem, &self.history, &self.times, Resolution { lines_per_zone, most_steps: MOST_STEPS })
    }
}

fn speeds(event: &Event) -> Vec<(&'static str, Estimate)> {
    match event.kind {
        EventKind::GrowthBegins { speed } => vec![("first speed", speed)],
        EventKind::Restart { speed } => vec![("speed of a restart", speed)],
        EventKind::Arrest { speed_before } => vec![("speed before an arrest", speed_before)],
        EventKind::Jump { distance } => vec![("jump", distance)],
        EventKind::Kink { speed_before, speed_after } => vec![("speed before a kink", speed_before), ("speed after a kink", speed_after)],
        EventKind::Unbounded => Vec::new(),
    }
}

/// A scene, assessed.
#[must_use]
pub fn assessed(scene: u64) -> Assessed {
    assessed_of(SEED, scene)
}

/// A scene of another seed, assessed.
#[must_use]
pub fn assessed_of(seed: u64, scene: u64) -> Assessed {
    let mut draw = Draw::of(seed ^ 4, scene);
    let lines = LINES[(scene / ANOTHER_ROUTE + scene) as usize % LINES.len()];
    let another = scene.is_multiple_of(ANOTHER_ROUTE);
    let truth = if another { Truth::Another } else { Truth::Tighter };
    let accuracy = 1.0 / f64::from(lines);
    let mut assessed = Assessed { scene, accuracy, described: String::new(), compared: Vec::new(), truth, trouble: None };
    let result = if another { against_known(&mut draw, lines, &mut assessed) } else { against_finer(&mut draw, lines, &mut assessed) };
    match result {
        Ok(compared) => assessed.compared = compared,
        Err(refusal) => assessed.trouble = Some(refusal.to_string()),
    }
    assessed
}

fn against_finer(draw: &mut Draw, lines: u32, assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    let asked = drawn(draw)?;
    assessed.described = format!("{lines} lines, {:?}, {:?}, {:?}", asked.material, asked.interface, asked.history);
    let (found, exact) = (asked.solved(lines)?, asked.solved(MORE * lines)?);
    let zone = match asked.interface.process_zone {
        ProcessZone::Constant { length } => length,
        ProcessZone::Growing { .. } | ProcessZone::Schapery { .. } => 0.0,
    };
    let fastest = exact.samples.iter().filter_map(|sample| sample.speed).map(|speed| speed.value).fold(0.0, f64::max);
    let until = asked.times.last().copied().unwrap_or(0.0);
    let mut compared = Vec::new();
    for (one, other) in found.samples.iter().zip(&exact.samples) {
        for (quantity, found, truth, scale) in
            [("place of the tip", one.growth, other.growth, zone), ("speed of the tip", one.speed, other.speed, fastest)]
        {
            match (found, truth) {
                (Some(found), Some(truth)) => compared.push(Compared { quantity, found, truth, scale, floor: 0.0 }),
                (None, None) => {}
                _ => assessed.trouble = Some(format!("{quantity} is there at one resolution and not at the other")),
            }
        }
    }
    for (one, other) in found.events.iter().zip(&exact.events) {
        if std::mem::discriminant(&one.kind) != std::mem::discriminant(&other.kind) {
            // From here on both tell different stories (a short rest that one of them does not see): the bounds of places at times speak for themselves.
            break;
        }
        compared.push(Compared { quantity: "time of an event", found: one.time, truth: other.time, scale: until, floor: 0.0 });
        compared.push(Compared { quantity: "place of an event", found: one.growth, truth: other.growth, scale: zone, floor: 0.0 });
        for ((quantity, found), (_, truth)) in speeds(one).into_iter().zip(speeds(other)) {
            compared.push(Compared { quantity, found, truth, scale: fastest, floor: 0.0 });
        }
    }
    Ok(compared)
}

fn against_known(draw: &mut Draw, lines: u32, assessed: &mut Assessed) -> Result<Vec<Compared>, Refusal> {
    let known = known_growth(draw)?;
    assessed.described = format!("{lines} lines, {}", known.described());
    let problem = GrowthProblem::new(&known.material, known.interface, 0.0)?;
    let found = trajectory(&problem, &known.history, &[known.until], Resolution { lines_per_zone: lines, most_steps: MOST_STEPS })?;
    let mut compared = Vec::new();
    match known.known {
        KnownTime::Start(time) => match found.events.first() {
            Some(Event { kind: EventKind::GrowthBegins { .. }, time: started, .. }) => {
                let truth = Estimate::relative(time, sensitive_to_load(&known.material, time));
                compared.push(Compared { quantity: "start of growth", found: *started, truth, scale: known.until, floor: 0.0 });
            }
            _ => assessed.trouble = Some("no growth".into()),
        },
        KnownTime::Place { growth, speed, .. } => match found.samples.first() {
            Some(sample) => {
                let pairs = [("place of the tip", sample.growth, growth), ("speed of the tip", sample.speed, speed)];
                for (quantity, found, value) in pairs {
                    let Some(found) = found else { continue };
                    // The time is rounded to ε t, in which the tip goes εt·ẋ₀.
                    let rounding = CLOSED * value.abs() + 1e-15 * known.until * speed;
                    compared.push(Compared { quantity, found, truth: Estimate::new(value, rounding), scale: growth, floor: 0.0 });
                }
            }
            None => assessed.trouble = Some("no sample".into()),
        },
    }
    Ok(compared)
}

/// Relative error of a start whose load is rounded: dln t/dln K = 2J/(t dJ/dt), a few ulp of K.
fn sensitive_to_load(material: &PlaneMaterial, time: f64) -> f64 {
    let rate = material.creep_rate(time) * time;
    8.0 * f64::EPSILON * (1.0 + 2.0 * material.creep(time) / rate)
}

/// Evaluations of the closure at accuracies 1e-3 and 1e-9, by the lines that scenes of these accuracies take.
#[must_use]
pub fn work(scene: u64) -> Option<[u64; 2]> {
    let asked = drawn(&mut Draw::of(SEED ^ 4, scene)).ok()?;
    // A scene of accuracy 1e-3 takes 357 lines, one of 1e-7 and more 4096, the most there are; here a fifth of the first and half of the second.
    let counted = |lines: u32| Some(asked.solved(lines).ok()?.work.closure_evaluations);
    Some([counted(64)?, counted(2048)?])
}
