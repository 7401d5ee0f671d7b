//! The sphere of the thesis's chapter 4 and its integrations, printed: γ̃ = 1.6e-4, δ̃ = 0.013, E0* = R = ρ = 1.

use std::f64::consts::PI;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, Start, Trace, integrate};
use viscotack::material::RelaxationTerm;

pub const WORK: f64 = 1.6e-4 * PI;
pub const ZONE: f64 = 0.013;
pub const SPHERE: Profile = Profile::Paraboloid { radius: 1.0 };

pub fn rubber() -> PlaneMaterial {
    PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap()
}

pub fn three_terms() -> PlaneMaterial {
    let term = |modulus, relaxation_time| RelaxationTerm { modulus, relaxation_time };
    PlaneMaterial::from_relaxation(1.0, &[term(3.0, 0.1), term(4.0, 1.0), term(2.0, 20.0)]).unwrap()
}

pub fn integrated(material: &PlaneMaterial, history: History, start: Start, tolerance: f64) -> Trace {
    let instants = if history.segments.len() > 10 { 1 } else { 4 };
    let problem = IndentationProblem {
        start,
        instants_per_segment: instants,
        energies: true,
        ..IndentationProblem::new(SPHERE, Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE }), history)
    };
    let trace = integrate(material, &problem, tolerance).unwrap();
    let worst = trace.path.iter().fold(0.0f64, |most, point| most.max(point.residual.abs()));
    println!(
        "  {tolerance:e}: steps {} closures {} panels {} balance {:e} residual {worst:e} end a {:.9} F {:.9e} events {:?}",
        trace.work.steps,
        trace.work.closure_evaluations,
        trace.work.most_panels,
        trace.balance_defect().unwrap(),
        trace.path.last().unwrap().contact_radius,
        trace.path.last().unwrap().force,
        trace.events.iter().map(|event| (event.kind, event.time, event.contact_radius)).collect::<Vec<_>>()
    );
    assert!(worst < 1e-9);
    trace
}
