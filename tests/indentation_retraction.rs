//! Source: thesis Secs 4.5 and 4.10.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::f64::consts::PI;
use viscotack::Material;
use viscotack::indentation::{Adhesion, Control, History, IndentationProblem, Profile, Resolution, Start, march};

const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;
const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

#[test]
fn speeds() {
    // beta = 10, E0 = R = rho = 1: retardation time 10.
    let material = Material::standard_solid(1.0, 10.0, 10.0).unwrap();
    let jkr = 1.5 * PI * WORK;
    for speed in [1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1e1] {
        for fineness in [12.0, 25.0, 50.0] {
            let problem = IndentationProblem {
                profile: SPHERE,
                adhesion: Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE }),
                control: Control::Penetration(History::from(0.032).at_speed(-0.3, speed)),
                start: Start::Relaxed,
                instants_per_segment: 4,
                resolution: Resolution { steps_per_zone: fineness, growth: 0.2 * 25.0 / fineness },
            };
            let started = std::time::Instant::now();
            let trace = march(&material, &problem, problem.resolution).unwrap();
            println!(
                "V {speed:e} n {fineness}: F_off/F_JKR {:.6} steps {} closures {} panels {} updates {:e} balance {:e} worst {:e} events {:?} {:.2} s",
                trace.largest_tension().unwrap_or(0.0) / jkr,
                trace.work.steps,
                trace.work.closure_evaluations,
                trace.work.most_panels,
                trace.work.history_updates as f64,
                trace.balance_defect(),
                trace.path.iter().fold(0.0f64, |most, point| most.max(point.residual.abs())),
                trace.events.iter().map(|event| (event.kind, event.time * speed, event.contact_radius, event.force / jkr)).collect::<Vec<_>>(),
                started.elapsed().as_secs_f64()
            );
        }
    }
}
