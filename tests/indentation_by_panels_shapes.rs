//! Source: thesis chapter 4 by two methods of this crate: panels of the edge's path, and the time integration with its error bounds.
//!
//! Goal: what a scene may ask for in shape, material and edge agrees within the bounds of both: tables of many points, elastic solids.
//!
//! Parameters: drawn from fixed seeds, in units of any size; `VISCOTACK_SCENES` draws more scenes of each kind than a usual run.
//!
//! Oracle: [`viscotack::indentation::run`] at 1e-4, which shares no code of the time integration; JKR for elastic spheres.
//!
//! Tolerance: its bound plus that of the panels.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout, missing_docs)]

use std::time::Instant;
use viscotack::indentation::by_panels::{PanelOptions, march_by_panels, solve_by_panels};
use viscotack::indentation::{Adhesion, Controlled, History, IndentationProblem, Oscillation, Profile, run};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack::{Material, Refusal};

/// Uniform numbers of a linear congruential generator (Knuth's MMIX constants).
struct Draw(u64);

impl Draw {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn ratio(&mut self, low: f64, high: f64) -> f64 {
        (self.between(low.ln(), high.ln())).exp()
    }
}

/// Units of a scene: moduli, lengths and times in them.
struct Units {
    modulus: f64,
    length: f64,
    time: f64,
}

fn units(draw: &mut Draw) -> Units {
    Units { modulus: draw.ratio(0.3, 3e6), length: draw.ratio(1e-4, 3.0), time: draw.ratio(1e-3, 1e3) }
}

/// One to twelve terms.
fn solid(draw: &mut Draw, units: &Units) -> Material {
    let count = 1 + (draw.unit() * draw.between(1.0, 12.0)) as usize;
    let weights: Vec<f64> = (0..count).map(|_| draw.between(0.2, 1.0)).collect();
    let total: f64 = weights.iter().sum();
    let stiffening = draw.ratio(3.0, 100.0);
    let term = |(k, weight): (usize, &f64)| CreepTerm {
        compliance: weight / total * (1.0 - 1.0 / stiffening) / units.modulus,
        retardation_time: units.time * 10.0_f64.powf(-0.7 * k as f64),
    };
    Material::from_creep(stiffening * units.modulus, &weights.iter().enumerate().map(term).collect::<Vec<_>>(), None).unwrap()
}

fn adhesion(draw: &mut Draw, units: &Units) -> Adhesion {
    Adhesion {
        work_of_adhesion: draw.ratio(1e-4, 8e-4) * units.modulus * units.length,
        process_zone: draw.ratio(2e-3, 2e-2) * units.length,
    }
}

/// A history of the penetration about 0.02 lengths, or of a force.
fn history(draw: &mut Draw, units: &Units, work: f64) -> (History, bool) {
    let depth = draw.between(0.015, 0.03) * units.length;
    let duration = draw.ratio(0.03, 30.0) * units.time;
    match (draw.unit() * 4.0) as usize {
        0 => (History::penetration(depth).ramp(-0.6 * depth, duration), true),
        1 => (History::penetration(0.0).ramp(depth, duration).hold(draw.unit() * units.time).ramp(-0.6 * depth, duration), false),
        2 => {
            let frequency = draw.ratio(0.1, 3.0) / units.time;
            (History::penetration(depth).oscillate(Oscillation::steady(draw.between(0.02, 0.1) * depth, frequency), 2.0 / frequency), true)
        }
        _ => {
            let pull = std::f64::consts::PI * work * units.length;
            (History::force(draw.unit() * pull).then(Controlled::Force, -1.2 * pull, duration), true)
        }
    }
}

fn problem(draw: &mut Draw, units: &Units, profile: Profile) -> IndentationProblem {
    let adhesion = adhesion(draw, units);
    let (history, relaxed) = history(draw, units, adhesion.work_of_adhesion);
    let problem = IndentationProblem { instants_per_segment: 4, ..IndentationProblem::new(profile, Some(adhesion), history) };
    if relaxed { problem.relaxed() } else { problem }
}

/// A worn sphere: a flatter face, a shoulder, and waves of it; its heights rounded as a scan rounds them.
fn many_points(draw: &mut Draw, units: &Units) -> Profile {
    let count = draw.between(20.0, 90.0) as u32;
    let (face, waves, wave) = (draw.between(0.03, 0.12), draw.between(4.0, 12.0), draw.between(0.0, 0.05));
    let digits = draw.ratio(1e-7, 1e-5);
    let at = |radius: f64| {
        let beyond = (radius * radius + 1e-3).sqrt();
        let worn = 0.5 * radius * radius * (1.0 - 0.5 * (-(radius / face).powi(4)).exp() * beyond / (beyond + 0.1));
        worn * (1.0 + wave * (waves * radius).sin())
    };
    let point = |k: u32| {
        let radius = f64::from(k) / f64::from(count) * 0.9;
        (radius * units.length, ((at(radius) / digits).round() + f64::from(k) * 1e-3) * digits * units.length)
    };
    Profile::table(&(0..=count).map(point).collect::<Vec<_>>()).unwrap_or(Profile::Paraboloid { radius: units.length })
}

fn any_shape(draw: &mut Draw, units: &Units) -> Profile {
    match (draw.unit() * 4.0) as usize {
        0 => Profile::Cone { slope: draw.between(0.08, 0.12) },
        1 => {
            let exponent = draw.between(1.3, 4.0);
            Profile::PowerLaw { coefficient: 0.02 * units.length / (0.14 * units.length).powf(exponent), exponent }
        }
        2 => many_points(draw, units),
        _ => Profile::Paraboloid { radius: units.length },
    }
}

#[test]
fn tables_of_many_points() {
    compared("tables", 6, &mut Draw(371_001), |draw| {
        let units = units(draw);
        let (material, profile) = (solid(draw, &units), many_points(draw, &units));
        (material, problem(draw, &units, profile))
    });
}

#[test]
fn elastic_solids() {
    compared("elastic", 20, &mut Draw(371_002), |draw| {
        let units = units(draw);
        let profile = any_shape(draw, &units);
        (Material::elastic(units.modulus).unwrap(), problem(draw, &units, profile))
    });
}

/// Scenes of a kind by both methods; at least nine of ten are compared.
fn compared(kind: &str, usual: usize, draw: &mut Draw, scene: impl Fn(&mut Draw) -> (Material, IndentationProblem)) {
    let scenes: usize = std::env::var("VISCOTACK_SCENES").ok().and_then(|count| count.parse().ok()).unwrap_or(usual);
    let skipped: usize = std::env::var("VISCOTACK_SKIP").ok().and_then(|count| count.parse().ok()).unwrap_or(0);
    let (mut failures, mut values, mut refused, mut times) = (Vec::new(), 0_u32, 0, [0.0; 2]);
    let mut furthest = (0.0_f64, String::new());
    for number in 0..scenes {
        let (material, problem) = scene(draw);
        if number < skipped {
            continue;
        }
        let clock = Instant::now();
        let rival = run(&material, &problem);
        let old = clock.elapsed().as_secs_f64();
        let clock = Instant::now();
        let panels = solve_by_panels(&material, &problem);
        let new = clock.elapsed().as_secs_f64();
        println!("{kind} {number}: {old:.3} s, by panels {new:.3} s");
        let (rival, panels) = match (rival, panels) {
            (Ok(rival), Ok(panels)) => (rival, panels),
            (rival, panels) => {
                refused += 1;
                if let (Ok(_), Err(refusal)) = (&rival, &panels) {
                    let text = format!("{kind} {number}: the panels refuse: {refusal}");
                    println!("{text}");
                    if !matches!(refusal, Refusal::Undefined { .. }) {
                        failures.push(text);
                    }
                } else {
                    println!("{kind} {number}: {:?} {:?}", rival.err(), panels.err());
                }
                continue;
            }
        };
        times[0] += old;
        times[1] += new;
        let scale = rival.instants.iter().map(|instant| instant.force.value.abs()).fold(0.0, f64::max);
        let [depth, ..] = rival.march.summary.scales;
        for (row, instant) in panels.instants.iter().zip(&rival.instants) {
            if instant.contact_radius.value <= 0.0 || row.contact_radius.value <= 0.0 {
                break;
            }
            let pairs = [
                (row.contact_radius, instant.contact_radius, instant.contact_radius.value),
                (row.force, instant.force, scale),
                (row.penetration, instant.penetration, depth),
            ];
            for (one, other, scale) in pairs {
                values += 1;
                let excess = (one.value - other.value).abs() / (one.error + other.error + 1e-9 * scale);
                if excess > furthest.0 {
                    furthest = (excess, format!("{number} at {:e}", instant.time));
                }
                if excess > 1.0 {
                    failures.push(format!("{kind} {number}, t = {:e}: {one:?} {other:?} {excess:.2}", instant.time));
                }
            }
        }
        if let (Some(one), Some(other)) = (&panels.largest_tension, &rival.largest_tension) {
            let excess = (one.value - other.value).abs() / (one.error + other.error + 1e-9 * scale);
            if excess > furthest.0 {
                furthest = (excess, format!("{number}, pull-off"));
            }
            if excess > 1.0 {
                failures.push(format!("{kind} {number}, pull-off: {one:?} {other:?} {excess:.2}"));
            }
        }
    }
    println!("{kind}: {} of {scenes} compared, {values} values, furthest {:.2} of both bounds ({}); {:.2} s and by panels {:.2} s", scenes - skipped - refused, furthest.0, furthest.1, times[0], times[1]);
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
    assert!(refused * 10 <= scenes, "nearly all scenes are compared");
}

fn rubber() -> Material {
    let c = 1.0 / (1.0 - 0.49_f64.powi(2));
    let terms = [0.22e6, 0.31e6, 0.45e6, 0.71e6, 1.3e6, 2.9e6, 8.1e6, 27e6, 96e6, 310e6, 690e6, 760e6];
    let term = |(k, modulus): (i32, &f64)| RelaxationTerm { modulus: modulus * c, relaxation_time: 10.0_f64.powi(2 - k) };
    Material::from_relaxation(1.1e6 * c, &(0..).zip(&terms).map(term).collect::<Vec<_>>()).unwrap()
}

fn worn() -> Profile {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/indentation/worn_sphere.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let number = |text: &str| text.trim().parse::<f64>().unwrap();
    let points = text.lines().filter(|line| !line.starts_with(['#', 'r'])).map(|line| {
        let (radius, height) = line.split_once(',').unwrap();
        (number(radius) * 1e-6, number(height) * 1e-9)
    });
    Profile::table(&points.collect::<Vec<_>>()).unwrap()
}

#[test]
#[ignore = "work"]
fn worn_sphere() {
    let zone = 60e-3 / 0.1e6;
    for speed in [1e-6, 1e-7, 1e-5] {
        let history = History::penetration(0.0).at_speed(6e-6, speed).at_speed(-12e-6, speed);
        let problem = IndentationProblem::new(worn(), Some(Adhesion { work_of_adhesion: 60e-3, process_zone: zone }), history);
        let problem = IndentationProblem { instants_per_segment: 20, accuracy: 1e-4, ..problem };
        let material = rubber();
        for (degree, tolerance) in [(5, 1e-3), (5, 3e-5), (7, 3e-6)] {
            let clock = Instant::now();
            match march_by_panels(&material, &problem, PanelOptions { degree, tolerance }, &[]) {
                Ok(o) => println!("{speed:e} {degree} {tolerance:e}: {:.2} s, {:?} panels {} refused {} closures {} nodes {} segments {} F {:e}", clock.elapsed().as_secs_f64(), o.end, o.panels, o.refused, o.closures, o.kernel_nodes, o.most_segments, o.least_force.force),
                Err(e) => println!("{e}"),
            }
        }
        if std::env::var("WHOLE").is_ok() {
            let clock = Instant::now();
            let one = solve_by_panels(&material, &problem).map(|s| s.largest_tension.unwrap());
            println!("panels {:.2} s {one:?}", clock.elapsed().as_secs_f64());
            let clock = Instant::now();
            let one = run(&material, &problem).map(|s| s.largest_tension.unwrap());
            println!("old {:.2} s {one:?}", clock.elapsed().as_secs_f64());
        }
    }
}
