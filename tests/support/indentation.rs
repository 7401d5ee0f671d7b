//! The sphere of the thesis's chapter 4 and its marches, printed: γ̃ = 1.6e-4, δ̃ = 0.013, E0* = R = ρ = 1.

use std::f64::consts::PI;
use viscotack::Material;
use viscotack::indentation::{Adhesion, Control, IndentationProblem, Profile, Resolution, Start, Trace, march};
use viscotack::material::RelaxationTerm;

pub const WORK: f64 = 1.6e-4 * PI;
pub const ZONE: f64 = 0.013;
pub const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

pub fn rubber() -> Material {
    Material::standard_solid(1.0, 10.0, 10.0).unwrap()
}

pub fn three_terms() -> Material {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    Material::from_relaxation(1.0, &[term(3.0, 0.1), term(4.0, 1.0), term(2.0, 20.0)]).unwrap()
}

pub fn history_is_long(control: &Control) -> bool {
    match control {
        Control::Penetration(history) | Control::Force(history) | Control::ContactRadius(history) => history.segments.len() > 10,
    }
}

pub fn marched(material: &Material, control: Control, start: Start, fineness: f64) -> Trace {
    let problem = IndentationProblem {
        profile: SPHERE,
        adhesion: Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE }),
        start,
        instants_per_segment: if history_is_long(&control) { 1 } else { 4 },
        resolution: Resolution { steps_per_zone: fineness, growth: 2.0 / fineness },
        control,
    };
    let trace = march(material, &problem, problem.resolution).unwrap();
    let worst = trace.path.iter().fold(0.0f64, |most, point| most.max(point.residual.abs()));
    println!(
        "  {fineness}: steps {} closures {} panels {} balance {:e} residual {worst:e} end a {:.6} F {:.6e} events {:?}",
        trace.work.steps,
        trace.work.closure_evaluations,
        trace.work.most_panels,
        trace.balance_defect(),
        trace.path.last().unwrap().contact_radius,
        trace.path.last().unwrap().force,
        trace.events.iter().map(|event| (event.kind, event.time, event.contact_radius)).collect::<Vec<_>>()
    );
    assert!(worst < 1e-9);
    trace
}
