//! Ten thousand scenes made of states that are known before they are solved ([`super::known_states`]): a wrong value is wrong, and so is a refusal.
//!
//! A load may have more contacts than the one that was drawn. A solver that returns another one is right if the same other route confirms it; these are counted apart.

use super::cells::{count, number, word};
use super::draw::Draw;
use super::known_states::crack::{KnownCrack, known_crack};
use super::known_states::delayed::{KnownGrowth, KnownTime, known_growth};
use super::known_states::sliding::{KnownContact, known_contact};
use super::known_states::sphere::{KnownSphere, known_sphere};
use super::{Check, Column, Effort, Progress, Section, Table};
use rayon::prelude::*;
use viscotack::crack::delayed::{Event, EventKind, GrowthProblem, Resolution, trajectory};
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{at_drive, at_speed};
use viscotack::indentation::{IndentationProblem, run};
use viscotack::refusal::Refusal;
use viscotack::sliding::steady::{SlidingOutcome, steady_sliding};

/// The seed of all scenes; another one than that of the bounds.
pub const SEED: u64 = 0x10_000_5ce;
/// What a value may be off, over its scale: the accuracy asked for and what is known of the drawn state.
const SLIDING: (f64, f64) = (1e-7, 2e-7);
/// See [`SLIDING`]; times the local power of the curve.
const CRACK: (f64, f64) = (1e-12, 5e-9);
/// See [`SLIDING`]; 64 lines a zone.
const DELAYED: f64 = 1e-5;
/// See [`SLIDING`].
const SPHERE: (f64, f64) = (1e-3, 1e-3);

/// How a scene came out.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepResult {
    /// The drawn state, with the largest error over its scale.
    Right(f64),
    /// Another state of the same scene, confirmed by the other route.
    Another(f64),
    /// A value that is wrong, or a state that is refused: in words.
    Wrong(String),
}

/// The largest |found − known| over scale of pairs (found, known, scale): right within a tolerance.
fn within(pairs: &[(f64, f64, f64)], tolerance: f64) -> SweepResult {
    let worst = pairs.iter().fold(0.0_f64, |worst, (found, known, scale)| {
        let off = (found - known).abs() / scale;
        // A NaN is as wrong as can be.
        if off.is_nan() { f64::INFINITY } else { worst.max(off) }
    });
    if worst <= tolerance {
        SweepResult::Right(worst)
    } else {
        SweepResult::Wrong(format!("off by {worst:.2e} of its scale, {tolerance:.0e} allowed"))
    }
}

/// Solves a sliding contact that is known.
#[must_use]
pub fn sliding(known: &KnownContact) -> SweepResult {
    match steady_sliding(&known.material, &known.problem(SLIDING.0)) {
        Ok(SlidingOutcome::Partial(found)) => {
            let values = &found.values;
            let found = [values.half_width, values.eccentricity, values.mean_pressure, values.penetration, values.friction_stress];
            let pairs: Vec<(f64, f64, f64)> = found
                .iter()
                .zip(known.values())
                .map(|(estimate, (_, value))| (estimate.value, value, value.abs().max(1.0) + estimate.error / SLIDING.1))
                .collect();
            let result = within(&pairs, SLIDING.1);
            let defect = || known.defect_at(values.half_width.value, values.eccentricity.value, values.mean_pressure.value);
            match result {
                SweepResult::Wrong(_) => match defect().filter(|defect| *defect < 1e-5) {
                    Some(defect) => SweepResult::Another(defect),
                    None => result,
                },
                _ => result,
            }
        }
        Ok(SlidingOutcome::Full(full)) => SweepResult::Wrong(format!("full contact, past {} {:e}", full.limit_name, full.limit)),
        Err(refusal) => SweepResult::Wrong(refusal.to_string()),
    }
}

/// Solves a crack that is known, by its speed and by its load.
#[must_use]
pub fn crack(known: &KnownCrack) -> SweepResult {
    let solved = || -> Result<SweepResult, Refusal> {
        let curve = VirtualWork::new(&known.material, known.motion, known.interface)?;
        let by_speed = at_speed(&curve, known.speed, CRACK.0)?;
        let by_drive = at_drive(&curve, known.drive, CRACK.0)?;
        // A speed that is known to the last digit fixes the load to as many more or fewer as the curve is flat or steep, and the other way round; near a limit of the
        // load the speed hardly depends on it, which its bound says.
        let steep = 1.0 + by_speed.speed_exponent.abs();
        let release = by_speed.energy_release_rate_ratio.map_or(known.release, |ratio| ratio.value);
        let speed_scale = known.speed * (1.0 / by_drive.speed_exponent.abs().max(1e-300)).max(1.0);
        Ok(within(
            &[
                (by_speed.drive.value, known.drive, known.drive * steep),
                (release, known.release, known.release * steep),
                (by_drive.speed.value, known.speed, speed_scale),
            ],
            CRACK.1,
        ))
    };
    solved().unwrap_or_else(|refusal| SweepResult::Wrong(refusal.to_string()))
}

/// Solves a history that is known.
#[must_use]
pub fn delayed(known: &KnownGrowth) -> SweepResult {
    let solved = || -> Result<SweepResult, Refusal> {
        let problem = GrowthProblem::new(&known.material, known.interface, 0.0)?;
        let found = trajectory(&problem, &known.history, &[known.until], Resolution::default())?;
        Ok(match known.known {
            KnownTime::Start(time) => match found.events.first() {
                Some(Event { kind: EventKind::GrowthBegins { .. }, time: started, .. }) => {
                    // How a start feels the last digits of its load: 2J/(t dJ/dt).
                    let rate = known.material.creep_rate(time) * time;
                    let steep = 1.0 + 1e-10 * known.material.creep(time) / rate;
                    within(&[(started.value, time, time * steep)], DELAYED)
                }
                _ => SweepResult::Wrong("no growth".into()),
            },
            KnownTime::Place { growth, speed, .. } => match found.samples.first() {
                Some(sample) => {
                    let value = |estimate: Option<viscotack::Estimate>| estimate.map_or(f64::NAN, |estimate| estimate.value);
                    within(
                        &[(value(sample.growth), growth, growth.max(1e-2 * speed * known.until)), (value(sample.speed), speed, speed)],
                        DELAYED,
                    )
                }
                None => SweepResult::Wrong("no sample".into()),
            },
        })
    };
    solved().unwrap_or_else(|refusal| SweepResult::Wrong(refusal.to_string()))
}

/// Solves a sphere that is known.
#[must_use]
pub fn sphere(known: &KnownSphere) -> SweepResult {
    match run(&known.material, &IndentationProblem { accuracy: SPHERE.0, ..known.problem.clone() }) {
        Ok(found) => {
            let mut pairs = Vec::new();
            for (place, values) in &known.instants {
                let Some(instant) = found.instants.get(*place) else { return SweepResult::Wrong("an instant is missing".into()) };
                let estimates = [instant.penetration.value, instant.force.value, instant.contact_radius.value];
                pairs.extend(estimates.into_iter().zip(values).zip(known.scales).map(|((found, value), scale)| (found, *value, scale)));
            }
            within(&pairs, SPHERE.1)
        }
        Err(refusal) => SweepResult::Wrong(refusal.to_string()),
    }
}

/// One scene of a problem: result, kind, and in words.
type Scene = (SweepResult, String);

fn drawn<K>(
    seed: u64,
    scene: u64,
    draw: fn(&mut Draw) -> Result<K, Refusal>,
    solve: fn(&K) -> SweepResult,
    words: fn(&K) -> String,
) -> Scene {
    match draw(&mut Draw::of(SEED ^ seed, scene)) {
        Ok(known) => (solve(&known), words(&known)),
        Err(refusal) => (SweepResult::Wrong(format!("the scene could not be made: {refusal}")), String::new()),
    }
}

/// A problem of the sweep.
struct Problem {
    name: &'static str,
    scene: fn(u64) -> Scene,
    /// Reduced, full.
    scenes: (u64, u64),
    tolerance: &'static str,
}

const PROBLEMS: [Problem; 4] = [
    Problem {
        name: "steady sliding",
        scene: |scene| drawn(1, scene, known_contact, sliding, KnownContact::described),
        scenes: (250, 3000),
        tolerance: "2e-7 of max(|value|, 1) and the bound: 1e-7 is asked for, the drawn state is known to 1e-8",
    },
    Problem {
        name: "steady crack",
        scene: |scene| drawn(2, scene, known_crack, crack, KnownCrack::described),
        scenes: (400, 5000),
        tolerance: "5e-9 of the value times the local power: two nested quadratures of 1e-11, of which 1e-9 is left",
    },
    Problem {
        name: "delayed crack",
        scene: |scene| drawn(3, scene, known_growth, delayed, KnownGrowth::described),
        scenes: (100, 1200),
        tolerance: "1e-5 of the value: 64 lines a zone, four runs, of third order",
    },
    Problem {
        name: "sphere",
        scene: |scene| drawn(4, scene, known_sphere, sphere, KnownSphere::described),
        scenes: (50, 800),
        tolerance: "1e-3 of the scale: the accuracy asked for",
    },
];

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let many = |problem: &Problem| effort.choose(problem.scenes.0, problem.scenes.1);
    progress.expect(PROBLEMS.iter().map(many).sum());
    let mut section = Section::new("seeded_sweep", "Scenes made of known states");
    section.say(
        "Edges, speeds and times are drawn first; the load and the work of adhesion that they take are computed by another route than the solver's, and the scene is made \
         of these. So there is an answer, and refusing is as wrong as a wrong value.",
    );
    let columns = vec![
        Column::words("problem"),
        Column::new("scenes", "1"),
        Column::new("right", "1"),
        Column::new("another state, confirmed", "1"),
        Column::new("wrong", "1"),
        Column::new("largest error over scale", "1"),
        Column::words("tolerance, and why"),
    ];
    let mut table = Table::new("scenes", "How the scenes came out.", columns);
    let mut failures = Table::new(
        "wrong",
        "Scenes that came out wrong: empty if all is well.",
        vec![Column::words("problem"), Column::new("scene", "1"), Column::words("what")],
    );
    for problem in &PROBLEMS {
        let found: Vec<Scene> = (0..many(problem))
            .into_par_iter()
            .map(|scene| {
                let found = (problem.scene)(scene);
                progress.advance(1);
                found
            })
            .collect();
        let right = found.iter().filter(|(result, _)| matches!(result, SweepResult::Right(_))).count();
        let another = found.iter().filter(|(result, _)| matches!(result, SweepResult::Another(_))).count();
        let worst =
            found.iter().fold(0.0_f64, |worst, (result, _)| if let SweepResult::Right(off) = result { worst.max(*off) } else { worst });
        let wrong: Vec<(usize, String)> = found
            .iter()
            .enumerate()
            .filter_map(|(scene, (result, words))| match result {
                SweepResult::Wrong(what) => Some((scene, format!("{what}: {words}"))),
                _ => None,
            })
            .collect();
        table.rows.push(vec![
            word(problem.name),
            count(found.len()),
            count(right),
            count(another),
            count(wrong.len()),
            number(worst),
            word(problem.tolerance),
        ]);
        let first = wrong.first().map_or_else(String::new, |(scene, what)| format!(", the first: scene {scene}, {what}"));
        section.checks.push(Check::new(
            format!("{}: no scene made of a known state is refused or wrong", problem.name),
            "0 wrong",
            format!("{} of {}{first}", wrong.len(), found.len()),
            wrong.is_empty(),
        ));
        // A sweep whose answers are mostly others would prove little.
        section.checks.push(Check::new(
            format!("{}: the drawn state itself comes out", problem.name),
            "at least 95 % of scenes",
            format!("{right} of {}", found.len()),
            100 * right >= 95 * found.len(),
        ));
        failures.rows.extend(wrong.into_iter().map(|(scene, what)| vec![word(problem.name), count(scene), word(what)]));
    }
    section.tables.push(table);
    section.tables.push(failures.folded());
    section
}
