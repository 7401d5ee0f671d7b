//! Indentation: both ends of the speeds, long dwells, vanishing adhesion, zones of every size, punches, loads beyond pull-off.

use super::super::Effort;
use super::super::known_states::sphere::elastic_work;
use super::case::{Expected, Found, HardCase, Kind, near};
use super::material::spread;
use std::f64::consts::PI;
use viscotack::elastic::{JkrSphere, KendallPunch};
use viscotack::estimate::Estimate;
use viscotack::indentation::{
    Adhesion, Controlled, EventKind, History, IndentationProblem, IndentationSolution, Oscillation, Profile, run,
};
use viscotack::material::{PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

const PROBLEM: &str = "indentation";
const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };
/// The thesis's chapter 4: γ̃ = 1.6e-4, with R = E0* = ρ = 1.
const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;

fn adhesion(process_zone: f64) -> Option<Adhesion> {
    Some(Adhesion { work_of_adhesion: WORK, process_zone })
}

/// ρ = 1, E0 = 1.
fn rubber(beta: f64) -> Result<PlaneMaterial, Refusal> {
    if beta > 1.0 { PlaneMaterial::standard_solid(1.0, beta, beta) } else { PlaneMaterial::elastic(1.0) }
}

fn asked(adhesion: Option<Adhesion>, history: History, accuracy: f64) -> IndentationProblem {
    IndentationProblem { accuracy, ..IndentationProblem::new(SPHERE, adhesion, history) }
}

/// What is reported of the last kept instant, and of events.
fn reported(found: &IndentationSolution) -> Found {
    let mut reported = Found::default();
    if let Some(last) = found.instants.last() {
        reported = reported.with("Δ", last.penetration).with("F", last.force).with("a", last.contact_radius);
    }
    if let Some(tension) = found.pull_off_force() {
        reported = reported.with("largest tension", tension);
    }
    if !found.reached {
        reported = reported.is("accuracy not reached");
    }
    let count = |kind: EventKind| found.events.iter().filter(|event| event.kind == kind).count() as f64;
    let opened = found.events.iter().find(|event| matches!(event.kind, EventKind::Detachment | EventKind::ZoneReached));
    if let Some(event) = opened {
        reported = reported.is("came off").with("time of coming off", event.time);
    } else {
        reported = reported.is("held");
    }
    reported.with("jumps into contact", Estimate::exact(count(EventKind::JumpIn)))
}

/// The elastic contact of a depth by textbook fields: a (the larger root) and F.
fn elastic(modulus: f64, zone: f64, depth: f64) -> [f64; 2] {
    // At a given a the work grows as the depth falls; at a given depth it grows with a beyond the fold.
    let work = |a: f64| if depth < a * a { elastic_work(1.0, modulus, a, depth, zone) } else { -1.0 };
    let mut high = 1.0;
    while work(high) > WORK && high > 1e-6 {
        high *= 0.99;
    }
    let (mut low, mut top) = (high, high / 0.99);
    for _ in 0..80 {
        let middle = 0.5 * (low + top);
        if work(middle) < WORK {
            low = middle;
        } else {
            top = middle;
        }
    }
    [low, 2.0 * modulus * low * depth - 2.0 / 3.0 * modulus * low.powi(3)]
}

/// The largest pull of a relaxed contact with the thesis's zone: over all radii, the depth at each by the work over the zone.
fn largest_pull() -> f64 {
    let pull = |a: f64| {
        // The work falls with growing depth: it is nothing where the edge is not pulled.
        let (mut low, mut high) = (-10.0 * a * a - 1.0, a * a);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if elastic_work(1.0, 1.0, a, middle, ZONE) > WORK {
                low = middle;
            } else {
                high = middle;
            }
        }
        2.0 / 3.0 * a.powi(3) - 2.0 * a * low
    };
    // JKR's radius is 0.083: a parabola through three radii about the best of many.
    let best = (0..400).map(|index| 0.04 + 0.0003 * f64::from(index)).max_by(|one, two| pull(*one).total_cmp(&pull(*two))).unwrap_or(0.08);
    let (before, here, after) = (pull(best - 3e-4), pull(best), pull(best + 3e-4));
    here + 0.125 * (after - before).powi(2) / (2.0 * here - before - after)
}

const FIELDS: &str = "an elastic sphere by textbook fields (Sneddon; Johnson 1985), its work over the same zone by quadrature";

/// The cases.
#[must_use]
pub fn cases(effort: Effort) -> Vec<HardCase> {
    let mut cases = both_ends();
    cases.extend(zones());
    cases.extend(without_adhesion());
    cases.extend(forces());
    cases.extend(punches(effort));
    cases
}

/// Relaxed at every instant, glassy at every instant.
fn both_ends() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for (name, beta, history, modulus) in [
        ("β = 1, pressed in over eight decades of speed", 1.0, History::penetration(0.0).at_speed(0.005, 1e4).at_speed(0.02, 1e-4), 1.0),
        ("β = 10, a rate of 1e-10", 10.0, History::penetration(0.0).at_speed(0.02, 1e-10), 1.0),
        ("β = 1000, a rate of 1e-10", 1000.0, History::penetration(0.0).at_speed(0.02, 1e-10), 1.0),
        ("β = 10, a dwell of 1e9 times", 10.0, History::penetration(0.0).at_speed(0.02, 0.1).hold(1e9), 1.0),
        ("β = 1e6, a dwell of 1e12 times", 1e6, History::penetration(0.02).hold(1e12), 1.0),
        ("β = 10, at a rate of 1e10", 10.0, History::penetration(0.0).at_speed(0.02, 1e10), 10.0),
        ("β = 1e6, at a rate of 1e12", 1e6, History::penetration(0.01).at_speed(0.02, 1e12), 1e6),
    ] {
        let [a, force] = elastic(modulus, ZONE, 0.02);
        let accuracy = 1e-3;
        cases.push(HardCase::new(
            PROBLEM,
            name,
            "layers of the edge are ten decades and more thinner, or wider, than the zone",
            FIELDS,
            vec![
                Expected::Is("held"),
                Expected::Value { quantity: "a", value: a, tolerance: 2.0 * accuracy * a },
                // Bounds of forces are parts of the largest force of the history, which may be glassy: 3e-4 of the accuracy at least.
                Expected::Value {
                    quantity: "F",
                    value: force,
                    tolerance: 2.0 * accuracy * modulus * a.powi(3) + 4e-4 * accuracy * beta * 4e-3,
                },
            ],
            move || Ok(reported(&run(&rubber(beta)?, &asked(adhesion(ZONE), history.clone(), accuracy))?)),
        ));
    }
    let [a, force] = elastic(1.0, ZONE, 0.02);
    cases.push(HardCase::new(
        PROBLEM,
        "20 terms over 20 decades, a dwell of 1e14 times",
        "twenty memories at every point of the line",
        FIELDS,
        vec![
            Expected::Value { quantity: "a", value: a, tolerance: 2e-3 * a },
            Expected::Value { quantity: "F", value: force, tolerance: 2e-3 * a.powi(3) },
        ],
        || {
            let material = spread(100.0, 20, 20.0, 1e10)?;
            Ok(reported(&run(&material, &asked(adhesion(ZONE), History::penetration(0.0).at_speed(0.02, 1e-3).hold(1e14), 1e-3))?))
        },
    ));
    cases.push(HardCase::new(
        PROBLEM,
        "a relaxed contact, pulled at once",
        "in the first instant the solid is glassy and the edge has not moved",
        "Sec 4.10: −F stays below β times JKR's and above it by no more than δ/a",
        vec![
            Expected::Is("came off"),
            Expected::Between { quantity: "largest tension", low: 5.0 * 1.5 * PI * WORK, high: 10.5 * 1.5 * PI * WORK },
        ],
        || Ok(reported(&run(&rubber(10.0)?, &asked(adhesion(ZONE), History::penetration(0.08).at_speed(-0.1, 1e6), 1e-3).relaxed())?)),
    ));
    cases
}

/// Zones from a hundred-millionth to 0.3 of the contact; adhesion that vanishes.
fn zones() -> Vec<HardCase> {
    let mut cases = Vec::new();
    for zone in [2e-9, 2e-6, 2e-3, 0.06] {
        let [a, force] = elastic(1.0, zone, 0.02);
        cases.push(HardCase::new(
            PROBLEM,
            format!("a zone of {zone:e} R, {:.0e} of the contact, relaxed and held", zone / a),
            "the window of the closure is a hundred-millionth of the contact, or a third of it",
            FIELDS,
            vec![
                Expected::Value { quantity: "a", value: a, tolerance: 1e-5 * a },
                Expected::Value { quantity: "F", value: force, tolerance: 1e-5 * a.powi(3) },
            ],
            move || Ok(reported(&run(&rubber(10.0)?, &asked(adhesion(zone), History::penetration(0.02).hold(5.0), 1e-5).relaxed())?)),
        ));
    }
    let jkr = JkrSphere::new(1.0, 1.0, WORK).map(|sphere| sphere.pull_off_force()).unwrap_or(f64::NAN);
    cases.push(HardCase::new(
        PROBLEM,
        "elastic pull-off with a zone of a thousandth of the contact",
        "the largest tension is a fold: the edge accelerates unstably",
        "Johnson, Kendall and Roberts: (3/2)πRΔγ, up to δ/a",
        vec![near("largest tension", jkr, 1e-2), Expected::Is("came off")],
        || Ok(reported(&run(&rubber(1.0)?, &asked(adhesion(2e-4), History::penetration(0.02).at_speed(-0.03, 1.0), 1e-3).relaxed())?)),
    ));
    for part in [1e-6_f64, 1e-12, 1e-18] {
        let (a, hertz) = (0.02f64.sqrt(), 4.0 / 3.0 * 0.02f64.powf(1.5));
        // The pull at the rim goes with the root of Δγ: F = F_Hertz − √(8πa³Δγ) to first order.
        let pull = (8.0 * PI * a.powi(3) * part * WORK).sqrt();
        cases.push(HardCase::new(
            PROBLEM,
            format!("Δγ = {part:e} of the thesis's"),
            "the contact of adhesion is ten thousand times smaller than that of the load",
            "Hertz, and a pull that goes with √Δγ",
            vec![Expected::Value { quantity: "F", value: hertz, tolerance: 2.0 * pull + 1e-5 * hertz }],
            move || {
                // Far shorter than the contact that adhesion alone would make.
                let adhesion = Adhesion { work_of_adhesion: part * WORK, process_zone: 1e-3 * part.cbrt() };
                Ok(reported(&run(&rubber(10.0)?, &asked(Some(adhesion), History::penetration(0.02).hold(1.0), 1e-5).relaxed())?))
            },
        ));
    }
    cases
}

/// Lee and Radok, Ting, scales far from one.
fn without_adhesion() -> Vec<HardCase> {
    let hertz = 4.0 / 3.0 * 0.02f64.powf(1.5);
    let mut cases = vec![HardCase::new(
        PROBLEM,
        "without adhesion, pressed in at once and held for 1e9 times",
        "a step of the depth, then nothing for very long",
        "Lee and Radok: F = F_Hertz R(t), relaxed; bounds keep 3e-9 of the largest force, which is β times as large",
        vec![near("F", hertz, 5e-3), Expected::Is("held")],
        || Ok(reported(&run(&rubber(1e6)?, &asked(None, History::penetration(0.0).step(0.02).hold(1e9), 1e-5))?)),
    )];
    for speed in [1.0, 1e3, 1e6, 1e9, 1e15] {
        cases.push(HardCase::new(
            PROBLEM,
            format!("without adhesion, pressed in and drawn back at a rate of {speed:e}"),
            "the contact is lost while the surface is still dented",
            "Ting: the contact ends before the depth does, without a pull",
            vec![Expected::Is("came off"), Expected::Value { quantity: "F", value: 0.0, tolerance: 1e-3 * 10.0 * hertz }],
            move || {
                Ok(reported(&run(
                    &rubber(10.0)?,
                    &asked(None, History::penetration(0.0).at_speed(0.02, speed).at_speed(-0.01, speed), 1e-4),
                )?))
            },
        ));
    }
    for (name, scale) in [("nanometres", 1e-9), ("1e-100", 1e-100), ("1e60", 1e60)] {
        cases.push(HardCase::new(
            PROBLEM,
            format!("without adhesion, lengths of {name}"),
            "squares of lengths far from one",
            "forces go with the square of the length",
            vec![near("F over R²", hertz, 1e-3)],
            move || {
                let problem = IndentationProblem {
                    profile: Profile::Paraboloid { radius: scale },
                    ..asked(None, History::penetration(0.0).ramp(0.02 * scale, 1e7), 1e-4)
                };
                let found = run(&rubber(10.0)?, &problem)?;
                Ok(found
                    .instants
                    .last()
                    .map_or_else(Found::default, |last| Found::default().with("F over R²", last.force.scaled(1.0 / scale / scale))))
            },
        ));
    }
    cases
}

/// Loads about pull-off; starts that do not exist; wrong numbers.
fn forces() -> Vec<HardCase> {
    let jkr = 1.5 * PI * WORK;
    let held = |force: f64, time: f64| asked(adhesion(ZONE), History::force(0.0).step(force).hold(time), 1e-3).relaxed();
    let refused = |name: &'static str, why: &'static str, kind: Kind, problem: IndentationProblem| {
        HardCase::new(PROBLEM, name, why, "refused", vec![Expected::Refused(kind)], move || Ok(reported(&run(&rubber(10.0)?, &problem)?)))
    };
    vec![
        HardCase::new(
            PROBLEM,
            "half of JKR's pull-off force, held for 1e9 times",
            "nothing may drift in 1e9 times",
            "a stable relaxed contact exists under it: it holds",
            vec![Expected::Is("held"), Expected::Value { quantity: "F", value: -0.5 * jkr, tolerance: 1e-3 * jkr }],
            move || Ok(reported(&run(&rubber(10.0)?, &held(-0.5 * jkr, 1e9))?)),
        ),
        HardCase::new(
            PROBLEM,
            "twice JKR's pull-off force, held",
            "the soft contact cannot hold it, the glassy one can: it comes off after a delay",
            "no relaxed contact carries it, and one that recedes slowly is soft",
            vec![Expected::Is("came off"), Expected::Between { quantity: "time of coming off", low: 1e-2, high: 400.0 }],
            move || Ok(reported(&run(&rubber(10.0)?, &held(-2.0 * jkr, 400.0))?)),
        ),
        HardCase::new(
            PROBLEM,
            "twenty times JKR's pull-off force at once",
            "no contact, soft or glassy, holds it",
            "β = 10 times JKR's is the most: it comes off at once",
            vec![Expected::Is("came off"), Expected::Value { quantity: "time of coming off", value: 0.0, tolerance: 1e-9 }],
            move || Ok(reported(&run(&rubber(10.0)?, &held(-20.0 * jkr, 1.0))?)),
        ),
        HardCase::new(
            PROBLEM,
            "a relaxed start under twice JKR's pull-off force",
            "there is no such start",
            "the largest pull of an elastic sphere of textbook fields over the same zone is the witness",
            vec![Expected::NoSuchState { limit: -largest_pull(), tolerance: 1e-6 * jkr }],
            move || Ok(reported(&run(&rubber(10.0)?, &asked(adhesion(ZONE), History::force(-2.0 * jkr).hold(1.0), 1e-3).relaxed())?)),
        ),
        refused(
            "a contact radius of half the process zone",
            "the closure has no meaning for a contact smaller than its zone",
            Kind::OutOfRange,
            asked(adhesion(ZONE), History::contact_radius(0.2).ramp(0.5 * ZONE, 3.0), 1e-3).relaxed(),
        ),
        refused(
            "a frame without stiffness",
            "its place does not determine the contact",
            Kind::Undefined,
            asked(adhesion(ZONE), History::frame(0.0).ramp(0.1, 1.0), 1e-3),
        ),
        refused(
            "a depth that is no number",
            "a NaN passes every comparison",
            Kind::OutOfRange,
            asked(adhesion(ZONE), History::penetration(f64::NAN).hold(1.0), 1e-3),
        ),
        HardCase::new(
            PROBLEM,
            "a viscous material",
            "it has no relaxed contact",
            "a relaxed start does not exist",
            vec![Expected::Refused(Kind::Undefined)],
            || {
                let material = PlaneMaterial::from_relaxation(0.0, &[RelaxationTerm { modulus: 1.0, relaxation_time: 1.0 }])?;
                Ok(reported(&run(&material, &asked(adhesion(ZONE), History::penetration(0.02).hold(1.0), 1e-3).relaxed())?))
            },
        ),
        HardCase::new(
            PROBLEM,
            "touched, pulled off, touched again",
            "the second touch meets the dent of the first",
            "two jumps into contact",
            vec![Expected::Between { quantity: "jumps into contact", low: 2.0, high: 2.0 }, Expected::Is("came off")],
            || {
                let history = History::penetration(0.0).at_speed(0.01, 0.01).at_speed(-0.03, 0.01).hold(3.0).at_speed(0.02, 0.01);
                Ok(reported(&run(&rubber(10.0)?, &asked(adhesion(ZONE), history, 1e-3))?))
            },
        ),
    ]
}

/// Flat punches: Kendall's force; cycles without end.
fn punches(effort: Effort) -> Vec<HardCase> {
    let radius = 0.1;
    let kendall = KendallPunch::new(radius, 1.0, WORK).and_then(|punch| punch.pull_off_force()).unwrap_or(f64::NAN);
    let cycles: u32 = effort.choose(200, 20_000);
    // Stationary: F = 2a|E*(ω)|Δ.
    let (omega, amplitude) = (2.0 * PI * 3.0, 1e-4);
    vec![
        HardCase::new(
            PROBLEM,
            "a punch with a zone of a hundredth of its radius, elastic",
            "the rim holds until the closure is met, then nothing does",
            "Kendall: √(8πE*Δγa³), up to δ/a",
            vec![near("largest tension", kendall, 2e-2), Expected::Is("came off")],
            move || {
                let problem = IndentationProblem {
                    profile: Profile::FlatPunch { radius },
                    ..asked(adhesion(0.01 * radius), History::penetration(0.005).at_speed(-0.2, 1.0), 1e-3)
                };
                Ok(reported(&run(&rubber(1.0)?, &problem.relaxed())?))
            },
        ),
        HardCase::new(
            PROBLEM,
            format!("a punch that swings for {cycles} cycles"),
            "errors of every cycle add up",
            "the rim holds: storage stiffness 2aE′(ω), loss stiffness 2aE″(ω)",
            vec![near("storage stiffness", 2.0 * radius * storage(omega), 2e-3), near("loss stiffness", 2.0 * radius * loss(omega), 2e-2)],
            move || {
                let frequency = omega / (2.0 * PI);
                let swing = Oscillation::steady(amplitude, frequency);
                let history = History::from(Controlled::Penetration, 0.01).oscillate(swing, f64::from(cycles) / frequency);
                let problem = IndentationProblem { profile: Profile::FlatPunch { radius }, ..asked(None, history, 1e-3) };
                let found = run(&rubber(10.0)?, &problem.relaxed())?;
                Ok(found.cycles.last().map_or_else(Found::default, |cycle| {
                    Found::default().with("storage stiffness", cycle.storage_stiffness).with("loss stiffness", cycle.loss_stiffness)
                }))
            },
        ),
    ]
}

/// E′ of E0 = 1, E∞ = 10, ρ = 1.
fn storage(omega: f64) -> f64 {
    1.0 + 9.0 * omega * omega / (1.0 + omega * omega)
}

/// E″.
fn loss(omega: f64) -> f64 {
    9.0 * omega / (1.0 + omega * omega)
}
