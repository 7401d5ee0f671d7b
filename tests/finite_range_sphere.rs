//! The sphere with a law of attraction of finite range, in time.
//!
//! Source: `reference_data/finite_sphere.json`, eight histories computed by an independent prototype in another language with the same equations
//! (its own mesh and step errors beside every value); 32 pull-off forces of the public boundary-element runs of Maghami, Wang, Tricarico,
//! Ciavarella, Li & Papangelo (2024), doi 10.1016/j.jmps.2024.105844, table ML4Adh (github.com/alimaghamii/ML4Adh, commit be1b880, MIT licence);
//! Johnson, Kendall & Roberts (1971) and Bradley (1932) for the elastic limits; the energy balance.
//! Goal: pull-off forces, works, forces at instants, jumps and detachment; limits; energy identity; a second integrator; random states.
//! Parameters: Tabor numbers 0.05 to 14, stiffening 1 to 1000, 1 to 24 creep terms, rates over ten decades.
//! Oracle: as under Source; for random states the same run with every tolerance ten times tighter.
//! Tolerance: the stated errors of the source plus the bound of our own result; for the public rows the scatter found in their repeated runs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use serde_json::Value;
use viscotack::Refusal;
use viscotack::finite_range::law::Law;
use viscotack::finite_range::sphere::{
    Accuracy, Control, Creep, Leg, Mesher, Motion, Problem, Run, Shape, Start, assessed, run, run_by_exponentials,
};

const ORDER: usize = 10;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn ramp(to: f64, duration: f64) -> Leg {
    Leg { control: Control::Penetration, motion: Motion::Ramp { to, duration } }
}

fn elastic() -> Creep {
    Creep { stiffening: 1.0, fractions: Vec::new(), times: Vec::new() }
}

fn one_term(stiffening: f64) -> Creep {
    Creep { stiffening, fractions: vec![1.0], times: vec![1.0] }
}

fn pulled(tabor: f64, creep: Creep, depth: f64, to: f64, rate: f64) -> Problem {
    let (law, shape) = (Law::LennardJones, Shape::Paraboloid);
    Problem { law, tabor, shape, creep, start: Start::Relaxed(depth), history: vec![ramp(to, (depth - to) / rate)], instants: Vec::new() }
}

fn problem_of(input: &Value) -> Problem {
    let depth = number(&input["start_penetration"]);
    let mut now = depth;
    let leg = |leg: &Value| match leg["control"].as_str().unwrap() {
        "penetration" => {
            let from = std::mem::replace(&mut now, number(&leg["to"]));
            ramp(now, (now - from).abs() / number(&leg["rate"]))
        }
        "dwell" => Leg { control: Control::Penetration, motion: Motion::Hold(number(&leg["time"])) },
        _ => Leg { control: Control::Force, motion: Motion::Ramp { to: number(&leg["to"]), duration: number(&leg["time"]) } },
    };
    let creep = Creep {
        stiffening: number(&input["beta"]),
        fractions: numbers(&input["creep_fractions"]),
        times: numbers(&input["retardation_times"]),
    };
    Problem {
        law: Law::LennardJones,
        tabor: number(&input["mu"]),
        shape: Shape::Paraboloid,
        creep,
        start: if input["start"] == "relaxed" { Start::Relaxed(depth) } else { Start::Unstrained(depth) },
        history: input["history"].as_array().unwrap().iter().map(leg).collect(),
        instants: numbers(&input["instants"]),
    }
}

#[test]
fn the_eight_visible_states_are_met_within_their_errors() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/reference_data/finite_sphere.json");
    let all: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let mut mesher = Mesher::new(ORDER);
    for state in all["states"].as_array().unwrap() {
        let (problem, result, name) = (problem_of(&state["input"]), &state["result"], &state["input"]["name"]);
        let ours = assessed(&problem, Accuracy { newton: 1e-3, ..Accuracy::new(1e-6) }, &mut mesher).unwrap();
        assert!(ours.consistent);
        let stated = |key: &str| {
            let error = &state["error_estimates"][key];
            number(&error["mesh"]) + number(&error["time"])
        };
        let meets = |key: &str, value: f64, expected: &Value, bound: f64| {
            let (expected, allowed) = (number(expected), stated(key) + bound + 1e-11);
            assert!((value - expected).abs() <= allowed, "{name}: {key} = {value}, expected {expected} within {allowed:e}");
        };
        if result["pull_off_force"].is_number() {
            let (leg, bounds) = (ours.run.legs.last().unwrap(), ours.legs.last().unwrap());
            meets("pull_off_force", ours.run.pull_off_force(), &result["pull_off_force"], bounds.largest_tension);
            meets("time_at_pull_off", leg.largest_tension.time, &result["time_at_pull_off"], bounds.time_of_largest_tension);
            meets("work_of_separation", leg.work_of_separation(), &result["work_of_separation"], bounds.work_of_separation);
            meets("work_to_pull_off", leg.work_to_pull_off(), &result["work_to_pull_off"], bounds.work_to_pull_off);
            let zero = leg.zero_of_force.unwrap_or(leg.begin).penetration;
            meets("penetration_at_zero_force", zero, &result["penetration_at_zero_force"], bounds.penetration_at_zero_force);
        }
        for (k, (theirs, bound)) in result["at_instants"].as_array().unwrap().iter().zip(&ours.instants).enumerate() {
            let row = ours.run.at(number(&theirs["time"])).unwrap();
            meets(&format!("force_{k}"), row.force, &theirs["force"], bound.force);
            meets(&format!("penetration_{k}"), row.penetration, &theirs["penetration"], bound.penetration);
        }
        assert_eq!(ours.run.jumps.len(), result["jumps"].as_array().unwrap().len(), "{name}");
        for (jump, theirs) in ours.run.jumps.iter().zip(result["jumps"].as_array().unwrap()) {
            // The instant is known to a few 1e-5 h0 and the force before it is soft; where the body lands is sharp.
            assert!((jump.penetration - number(&theirs["penetration"])).abs() < 1e-4, "{name}: {jump:?}");
            assert!((jump.force_after / number(&theirs["force_after"]) - 1.0).abs() < 2e-4, "{name}: {jump:?}");
        }
        assert_eq!(ours.run.detachment.is_some(), result["detachment"].is_object(), "{name}");
        if let Some(detachment) = ours.run.detachment {
            let expected = number(&result["detachment"]["time"]);
            assert!((detachment.time - expected).abs() < 4e-6 * expected + ours.detachment_time.unwrap(), "{name}: {detachment:?}");
        }
        let certificate = ours.run.certificate;
        assert!(
            certificate.energy_residual < 10.0 * certificate.accuracy.step * certificate.energy_scale.max(1.0),
            "{name}: {certificate:?}"
        );
    }
}

/// Pull-off over that of Johnson, Kendall & Roberts.
fn over_jkr(run: &Run) -> f64 {
    run.pull_off_force() / (1.5 * std::f64::consts::PI)
}

#[test]
fn elastic_spheres_tend_to_jkr_and_to_bradley() {
    let mut mesher = Mesher::new(ORDER);
    let mut ratio = |tabor: f64, depth: f64, to: f64| {
        over_jkr(&run(&pulled(tabor, elastic(), depth, to, 1.0), Accuracy::new(1e-6), &mut mesher).unwrap())
    };
    let excess = [ratio(2.0, 3.0, -5.0), ratio(4.0, 1.0, -7.0)].map(|ratio| ratio - 1.0);
    assert!(excess[1] > 0.0, "{excess:?}");
    let exponent = (excess[0] / excess[1]).log2();
    assert!((1.2..1.55).contains(&exponent), "the excess over JKR falls like the Tabor number to the power -{exponent}");
    let rigid = [0.05, 0.01].map(|tabor| ratio(tabor, 0.5, -1.0));
    assert!(rigid[0] < rigid[1] && (rigid[1] - 4.0 / 3.0).abs() < 1e-3, "{rigid:?}");
}

#[test]
fn an_infinitely_slow_pull_is_elastic_with_the_relaxed_modulus_and_an_infinitely_fast_one_frozen() {
    let mut mesher = Mesher::new(ORDER);
    let mut pull_off = |problem: &Problem| run(problem, Accuracy::new(1e-6), &mut mesher).unwrap().pull_off_force();
    let soft = pull_off(&pulled(1.0, elastic(), 3.0, -6.0, 1.0));
    let slow = pull_off(&pulled(1.0, one_term(20.0), 3.0, -6.0, 1e-7));
    assert!((slow / soft - 1.0).abs() < 2e-5, "{slow} {soft}");
    let fast = [1e5, 1e7].map(|rate| pull_off(&pulled(1.0, one_term(20.0), 3.0, -6.0, rate)));
    assert!((fast[0] / fast[1] - 1.0).abs() < 1e-4, "{fast:?}");
}

#[test]
fn two_integrators_agree() {
    let mut mesher = Mesher::new(ORDER);
    let mut problem = pulled(1.5, one_term(10.0), 6.0, -6.0, 4.0);
    problem.instants = vec![0.3, 0.9, 1.5, 1.8, 2.1];
    let accuracy = Accuracy::new(1e-6);
    let first = run(&problem, accuracy, &mut mesher).unwrap();
    let [coarse, fine] = [60, 120].map(|pieces| run_by_exponentials(&problem, accuracy, &mut mesher, pieces).unwrap());
    for &time in &problem.instants {
        let [first, coarse, fine] = [&first, &coarse, &fine].map(|run| run.at(time).unwrap().force);
        let change = (coarse - fine).abs();
        // Order two: the finer run is wrong by a third of the change, the extrapolated value by far less.
        let extrapolated = fine + (fine - coarse) / 3.0;
        assert!(change < 2e-2 && (first - extrapolated).abs() < 0.05 * change + 2e-5, "{time}: {first} {extrapolated} {change}");
    }
}

/// Rate, preload, Tabor number, E0/E∞, exponent of the spectrum, largest tension over JKR: theirs, the prototype's, allowed difference to theirs.
const PUBLISHED: [[f64; 8]; 32] = [
    [10000.0, 73.0652467, 3.24, 0.1, 1.6, 10.213323, 10.235516, 0.0025],
    [10000.0, 55.7441499, 3.24, 0.1, 1.6, 9.995673, 10.002837, 0.0025],
    [10000.0, 40.6621006, 3.24, 0.1, 1.6, 9.618572, 9.622358, 0.0025],
    [10000.0, 27.6285755, 3.24, 0.1, 1.6, 8.985412, 8.987392, 0.0025],
    [10000.0, 16.7129729, 3.24, 0.1, 1.6, 7.987319, 7.988695, 0.0025],
    [10000.0, 7.92476435, 3.24, 0.1, 1.6, 6.58996, 6.591673, 0.0025],
    [10000.0, 1.27398095, 3.24, 0.1, 1.6, 4.878787, 4.880116, 0.0025],
    [0.316228, 1.68974, 0.075, 0.316227766, 0.6, 1.373371, 1.370607, 0.003],
    [31622.8, 0.32976, 0.3, 0.316227766, 1.6, 1.596072, 1.597179, 0.003],
    [100.0, 0.17212, 0.05, 0.316227766, 1.6, 1.356028, 1.356722, 0.003],
    [0.215443, 4.3026, 0.1, 0.1, 1.6, 1.444009, 1.444464, 0.003],
    [46415.9, 1.13351, 0.075, 0.1, 0.6, 2.019515, 2.020397, 0.003],
    [1.0, 1.68974, 0.075, 0.1, 1.6, 1.805901, 1.800724, 0.003],
    [10.0, 1.01175, 0.06, 0.1, 0.6, 1.743899, 1.744661, 0.003],
    [681.292, 1.12623, 0.05, 0.316227766, 1.6, 1.804081, 1.804891, 0.003],
    [100000000.0, 32.04056, 3.2, 0.1, 1.6, 9.260964, 9.265079, 0.006],
    [10000000.0, 27.62858, 3.24, 0.1, 1.0, 8.990291, 8.992977, 0.006],
    [10000.0, 1.27398, 3.24, 0.1, 0.6, 4.781341, 4.777223, 0.006],
    [1000.0, 1.01003, 3.21, 0.1, 0.6, 4.37923, 4.383959, 0.006],
    [1000.0, 1.01552, 3.2, 0.1, 1.6, 4.758294, 4.766491, 0.006],
    [10000000.0, 1.27398, 3.24, 0.1, 0.6, 4.875719, 4.879922, 0.006],
    [10000000.0, 16.71297, 3.24, 0.1, 1.0, 7.990404, 7.992672, 0.006],
    [4641.59, 0.96882, 0.9, 0.316227766, 1.6, 2.201596, 2.203134, 0.01],
    [794.328, 3.23321, 1.0, 0.1, 1.6, 4.371932, 4.381864, 0.01],
    [31622.8, 7.51583, 0.5, 0.316227766, 0.6, 3.276723, 3.276952, 0.01],
    [100.0, 16.292, 0.81, 0.1, 1.6, 8.008059, 7.97485, 0.01],
    [1000.0, 8.01923, 0.8, 0.1, 1.6, 6.278693, 6.280693, 0.01],
    [215443.0, 0.75949, 0.7, 0.316227766, 0.6, 2.043542, 2.044708, 0.01],
    [35.9381, 0.55065, 0.5, 0.1, 1.6, 2.130271, 2.131168, 0.01],
    [215443.0, 10.52649, 0.7, 0.316227766, 0.6, 3.387003, 3.390857, 0.01],
    [5.99484, 0.75949, 0.7, 0.1, 0.6, 1.882756, 1.869958, 0.01],
    [100000.0, 5.74299, 2.25, 0.1, 0.6, 5.918932, 5.918966, 0.01],
];

/// The lower incomplete gamma function over Γ, by its series.
fn gamma_part(a: f64, x: f64) -> f64 {
    let (mut term, mut sum) = (1.0 / a, 1.0 / a);
    for k in 1..200 {
        term *= x / (a + f64::from(k));
        sum += term;
    }
    let steps = 200_000;
    // Γ(a + 1) by the midpoint rule in ln t.
    let width = 60.0 / f64::from(steps);
    let gamma: f64 = (0..steps).map(|k| -55.0 + (f64::from(k) + 0.5) * width).map(|l: f64| (l * (a + 1.0) - l.exp()).exp() * width).sum();
    sum * a * (a * x.ln() - x).exp() / gamma
}

/// Retardation times of density τ^{n−1} e^{−τ}, as terms.
fn spectrum(exponent: f64, rate: f64, ratio: f64) -> Creep {
    let (step, least) = (0.6, (1e-3 / rate).ln());
    let count = ((20_f64.ln() - least) / step).ceil() as usize + 1;
    let mut times: Vec<f64> = (0..count).map(|k| (least + step * k as f64).exp()).collect();
    let mut weights: Vec<f64> = times.iter().map(|t| (exponent * t.ln() - t).exp()).collect();
    let below = gamma_part(exponent, times[0] * (-0.5 * step).exp());
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight *= (1.0 - below) / sum);
    weights.insert(0, below);
    times.insert(0, times[0] * (-step).exp());
    let kept: Vec<(f64, f64)> = times.into_iter().zip(weights).filter(|&(_, weight)| weight > 1e-12).collect();
    let sum: f64 = kept.iter().map(|&(_, weight)| weight).sum();
    Creep { stiffening: 1.0 / ratio, fractions: kept.iter().map(|k| k.1 / sum).collect(), times: kept.iter().map(|k| k.0).collect() }
}

#[test]
fn published_boundary_element_runs_agree_where_they_are_converged() {
    let mut mesher = Mesher::new(ORDER);
    for [rate, preload, tabor, ratio, exponent, theirs, prototype, allowed] in PUBLISHED {
        let problem = pulled(tabor, spectrum(exponent, rate, ratio), preload, -(6.0 + 4.0 * tabor), rate);
        let ours = over_jkr(&run(&problem, Accuracy::new(1e-5), &mut mesher).unwrap());
        assert!((ours / theirs - 1.0).abs() < allowed, "rate {rate} preload {preload} Tabor {tabor}: {ours}, published {theirs}");
        assert!((ours / prototype - 1.0).abs() < 1e-4, "rate {rate} preload {preload} Tabor {tabor}: {ours}, prototype {prototype}");
    }
}

/// A small generator with a fixed seed.
struct Dice(u64);

impl Dice {
    /// Evenly distributed in the logarithm.
    fn log(&mut self, low: f64, high: f64) -> f64 {
        for shift in [13_i32, -7, 17] {
            self.0 ^= if shift > 0 { self.0 << shift } else { self.0 >> -shift };
        }
        low * (high / low).powf((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn problem(&mut self) -> Problem {
        let (tabor, stiffening) = (self.log(0.05, 6.0), self.log(2.0, 1000.0));
        let count = [1, 3, 12][(self.log(1.0, 8.0).log2()) as usize];
        let raw: Vec<f64> = (0..count).map(|_| self.log(0.1, 1.0)).collect();
        let sum: f64 = raw.iter().sum();
        let decades = if count == 12 { 0.5 } else { 1.5 };
        let times = (0..count).map(|k| self.log(0.5, 2.0) * 10_f64.powf(decades * (f64::from(k) - f64::from(count - 1) / 2.0))).collect();
        let creep = Creep { stiffening, fractions: raw.iter().map(|f| f / sum).collect(), times };
        let (rate, depth) = (self.log(1e-3, 1e5), self.log(1.0, 40.0));
        let to = -(4.0 + 3.0 * tabor * tabor.max(1.0).sqrt() + 0.3 * depth).min(60.0);
        let mut problem = pulled(tabor, creep, depth, to, rate);
        if self.log(1.0, 4.0) > 2.0 {
            problem.start = Start::Unstrained(-8.0);
            let hold = Leg { control: Control::Penetration, motion: Motion::Hold(self.log(1e-3, 1e3)) };
            problem.history.splice(0..0, [ramp(depth, (depth + 8.0) / self.log(1e-3, 1e5)), hold]);
        }
        problem
    }
}

#[test]
fn sixty_random_states_end_and_agree_with_tighter_ones() {
    let (mut dice, mut mesher) = (Dice(0x9E37_79B9_7F4A_7C15), Mesher::new(ORDER));
    for _ in 0..60 {
        let problem = dice.problem();
        let [loose, tight] = [1e-5, 1e-6].map(|accuracy| run(&problem, Accuracy::new(accuracy), &mut mesher).unwrap());
        let change = loose.pull_off_force() / tight.pull_off_force() - 1.0;
        assert!(change.abs() < 1e-4, "{change:e}: {problem:?}");
        let certificate = loose.certificate;
        assert!(certificate.energy_residual < 1e-4 * certificate.energy_scale.max(10.0), "{certificate:?} {problem:?}");
        assert!(loose.rows.iter().all(|row| row.force.is_finite() && row.contact_radius >= 0.0));
    }
}

/// A random history of penetration, force, frame, holds and oscillations on a random state, tip and law.
fn wild(dice: &mut Dice) -> Problem {
    let mut problem = dice.problem();
    if dice.log(1.0, 4.0) > 3.0 {
        problem.law = Law::Cosine;
    }
    if dice.log(1.0, 4.0) > 3.0 {
        problem.shape = Shape::Power { coefficient: dice.log(0.1, 2.0), exponent: dice.log(1.0, 6.0) };
    }
    problem.history.pop();
    for _ in 0..dice.log(1.0, 5.0) as usize {
        let control = match dice.log(1.0, 16.0).log2() as usize {
            1 => Control::Force,
            2 => Control::Frame(dice.log(1e-2, 1e3)),
            _ => Control::Penetration,
        };
        let sign = if dice.log(1.0, 4.0) > 2.0 { 1.0 } else { -1.0 };
        let motion = match dice.log(1.0, 8.0).log2() as usize {
            0 => Motion::Ramp { to: sign * dice.log(0.3, 30.0), duration: dice.log(1e-4, 1e3) },
            1 => Motion::Hold(dice.log(1e-3, 1e4)),
            _ => Motion::Oscillation { amplitude: dice.log(0.1, 8.0), period: dice.log(1e-3, 1e2), cycles: dice.log(0.3, 3.0) },
        };
        problem.history.push(Leg { control, motion });
    }
    problem
}

#[test]
fn forty_wild_histories_end_and_balance_their_energy() {
    let (mut dice, mut mesher) = (Dice(0x51_7CC1_B727_220B), Mesher::new(ORDER));
    for _ in 0..40 {
        let problem = wild(&mut dice);
        match run(&problem, Accuracy::new(1e-4), &mut mesher) {
            Ok(done) => {
                let certificate = done.certificate;
                assert!(certificate.energy_residual < 1e-3 * certificate.energy_scale.max(10.0), "{certificate:?} {problem:?}");
                assert!(done.rows.iter().all(|row| row.force.is_finite() && row.penetration.is_finite()));
            }
            // The only refusal allowed here: an attraction that a dead load takes away has no equilibrium at any distance.
            Err(refusal) => assert!(matches!(refusal, Refusal::NoSuchState { .. }), "{refusal}: {problem:?}"),
        }
    }
}

#[test]
fn other_controls_laws_and_tips_balance_their_energy() {
    let mut mesher = Mesher::new(ORDER);
    let base = pulled(2.0, one_term(10.0), 10.0, -16.0, 5.0);
    let leg = |control, motion| Leg { control, motion };
    let oscillation = Motion::Oscillation { amplitude: 4.0, period: 1.0, cycles: 3.0 };
    let held = leg(Control::Penetration, Motion::Hold(1e6));
    let soft = leg(Control::Frame(0.3), Motion::Ramp { to: -120.0, duration: 20.0 });
    let problems = [
        Problem { history: vec![soft], ..base.clone() },
        Problem { history: vec![leg(Control::Penetration, oscillation)], ..base.clone() },
        Problem { history: vec![leg(Control::Force, oscillation)], ..base.clone() },
        Problem { history: vec![held, ramp(-20.0, 3.0)], ..base.clone() },
        Problem { law: Law::Cosine, ..base.clone() },
        Problem { shape: Shape::Power { coefficient: 0.25, exponent: 4.0 }, ..base.clone() },
        Problem { start: Start::Relaxed(400.0), ..base.clone() },
    ];
    for problem in problems {
        let done = run(&problem, Accuracy::new(1e-5), &mut mesher).unwrap();
        let certificate = done.certificate;
        assert!(certificate.energy_residual < 1e-4 * certificate.energy_scale, "{certificate:?} {problem:?}");
        let rigid = done.rows.iter().all(|row| row.dissipated > -1e-3 && row.released > -1e-3);
        assert!(rigid, "energy is gained from creep: {problem:?}");
    }
}

#[test]
fn a_soft_frame_gives_the_pull_off_of_a_dead_load() {
    // A very soft frame imposes the force: the surfaces jump apart at the largest tension of the slow elastic contact.
    let mut mesher = Mesher::new(ORDER);
    let mut problem = pulled(1.0, elastic(), 2.0, -6.0, 1.0);
    let stiff = run(&problem, Accuracy::new(1e-6), &mut mesher).unwrap();
    problem.history = vec![Leg { control: Control::Frame(1e-2), motion: Motion::Ramp { to: -1500.0, duration: 10.0 } }];
    let soft = run(&problem, Accuracy::new(1e-6), &mut mesher).unwrap();
    assert_eq!(soft.jumps.len(), 1);
    assert!((-soft.jumps[0].force_before / stiff.pull_off_force() - 1.0).abs() < 1e-4, "{:?} {}", soft.jumps, stiff.pull_off_force());
}

#[test]
fn what_is_not_allowed_is_refused() {
    let mut mesher = Mesher::new(ORDER);
    let good = pulled(1.0, one_term(10.0), 2.0, -6.0, 1.0);
    let bad = [
        Problem { tabor: 0.0, ..good.clone() },
        Problem { tabor: f64::NAN, ..good.clone() },
        Problem { creep: one_term(0.5), ..good.clone() },
        Problem { law: Law::Exponential, ..good.clone() },
        Problem { history: vec![ramp(f64::INFINITY, 1.0)], ..good.clone() },
        Problem { history: vec![ramp(1.0, 0.0)], ..good.clone() },
        // A tip that leaves a force of attraction to the limit zero: the surfaces part without end.
        Problem {
            history: vec![ramp(-6.0, 1.0), Leg { control: Control::Force, motion: Motion::Ramp { to: 10.0, duration: 1.0 } }],
            ..good.clone()
        },
    ];
    for problem in bad {
        assert!(run(&problem, Accuracy::new(1e-5), &mut mesher).is_err(), "{problem:?}");
    }
    let few = Accuracy { budget: 5, ..Accuracy::new(1e-5) };
    assert!(run(&good, few, &mut mesher).is_err());
    assert!(run(&good, Accuracy { order: 8, ..Accuracy::new(1e-5) }, &mut mesher).is_err());
}
