//! Lines and surfaces that attract at a distance: error of the friction against a much finer grid, by time and by transforms.

use super::{Diagram, Method, Sample};
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use std::f64::consts::TAU;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::line::{
    Control, Harmonic, Problem, Profile, Request, Roughness, SteadyState, follow, modulus_of, rough, solve,
};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;

/// The stiffening of the solid.
const STIFFENING: f64 = 10.0;

fn problem(profile: Profile, law: Law, gamma: f64, range: f64, pressure: f64) -> Result<Problem, Refusal> {
    let term = CreepTerm { compliance: 1.0 - 1.0 / STIFFENING, retardation_time: 1.0 };
    let modulus = modulus_of(&PlaneMaterial::from_creep(STIFFENING, &[term], None)?)?;
    Ok(Problem::new(profile, modulus, 1.0, Attraction::new(law, TAU * gamma, range)?, Control::MeanPressure(pressure)))
}

/// A grid of so many nodes along x, whatever its error.
const fn grid(nodes: usize) -> Request {
    Request { accuracy: 1e-12, least_nodes: nodes, most_nodes: nodes }
}

fn samples(problem: &Problem, grids: &[usize], truth: &SteadyState) -> Method {
    let run = |&nodes: &usize| {
        let Timed { seconds, runs, result: found } = timed(|| solve(problem, &grid(nodes)));
        let setting = format!("N = {nodes}");
        match found {
            Ok(state) => {
                let size = (state.fields.nx * state.fields.ny) as f64;
                let counted = vec![("products with the stiffness on the finest grid", state.node_products as f64 / size)];
                let error = (state.numbers.friction_stress / truth.numbers.friction_stress - 1.0).abs();
                Sample { setting, seconds, runs, counted, error: Ok(error) }
            }
            Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
        }
    };
    Method { name: "this program".into(), own: true, samples: grids.iter().map(run).collect() }
}

/// `finer`: nodes along x of the truth.
fn diagram(identifier: &str, what: &str, problem: &Problem, grids: &[usize], finer: usize) -> Result<Diagram, Refusal> {
    let finest = grids.iter().copied().max().unwrap_or(finer);
    let near = solve(problem, &grid(finest))?;
    let truth = follow(problem, &near, &grid(finer))?;
    let bound = truth.errors.friction_stress / truth.numbers.friction_stress;
    Ok(Diagram {
        identifier: identifier.to_owned(),
        caption: format!(
            "{what} Each run starts from nothing. Truth: a grid of {finer} nodes along x, whose friction is known to {bound:.0e}."
        ),
        error: "relative error of the friction",
        counted: "products with the stiffness on the finest grid",
        methods: vec![samples(problem, grids, &truth)],
        headline: false,
    })
}

fn line(effort: Effort) -> Result<Diagram, Refusal> {
    let wave = Profile::harmonics(&[Harmonic { number: 1, amplitude: 1.0, phase: 0.0 }])?;
    let powers = effort.choose(9..13, 9..16);
    let finer = 1 << (powers.end + 1);
    let grids: Vec<usize> = powers.map(|power| 1 << power).collect();
    let what = "A wave slides over a solid that stiffens tenfold, with a cosine law of range 0.1 Λ (Γ = 0.01, mean pressure 0.3, kvτ = 1). \
                contMech's stored run is its extrapolated friction of four digits.";
    diagram("line_at_a_distance", what, &problem(wave, Law::Cosine, 0.01, 0.1, 0.3)?, &grids, finer)
}

fn surface() -> Result<Diagram, Refusal> {
    let roughness = Roughness { hurst: 0.8, rms_height: 0.35, lowest: 1.0, highest: 8.0, seed: 1 };
    let what = "A self-affine surface of wave numbers 1 to 8 slides over the same solid, with an exponential law of range 0.1 Λ (Γ = 0.008, mean pressure 0.2, kvτ = 1).";
    diagram("surface_at_a_distance", what, &problem(rough(&roughness, false)?, Law::Exponential, 0.008, 0.1, 0.2)?, &[256, 512], 1024)
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_lines", "Work and precision: lines and surfaces that attract at a distance");
    section.say(
        "A run on N nodes along x includes the search for the state and the coarser grids that give its error bound. A product with the stiffness is two fast Fourier \
         transforms; those on coarser grids count by their nodes. Edges of contact and kinks of the law lie between nodes: the error changes its sign from grid to grid, and falls like N^−1.5 to N^−2.",
    );
    progress.expect(2);
    for (name, found) in [("line_at_a_distance", line(effort)), ("surface_at_a_distance", surface())] {
        match found {
            Ok(diagram) => diagram.into_section(&mut section),
            Err(refusal) => section.checks.push(Check::new(name, "the truth is found", refusal.to_string(), false)),
        }
        progress.advance(1);
    }
    section
}
