//! Sliding contacts with given edges: Gauss points of ours, elements of the rivals.

use super::Panel;
use crate::rivals::sliding_collocation::{Layout, SlidingCollocation};
use crate::studies::order::{Convergence, Expectation, FINEST};
use crate::studies::section::{Check, Effort, Progress, Section};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactMemory, ContactState, Edge, Indenter, Prescribed, ProcessZone, Resolution, WaveContact};
use viscotack::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};

/// A state of equilibrium: β, ζ_j of equal terms, Γ, δ, p̄, edges near it.
struct State {
    beta: f64,
    ratios: &'static [f64],
    work: f64,
    zone: f64,
    pressure: f64,
    near: [f64; 2],
}

const STATES: [State; 6] = [
    State { beta: 10.0, ratios: &[0.1], work: 0.01, zone: 1e-3, pressure: 0.05, near: [1.382, -0.5] },
    State { beta: 50.0, ratios: &[0.02, 3.0], work: 0.005, zone: 1e-3, pressure: 0.1, near: [1.076, -0.32] },
    State { beta: 10.0, ratios: &[0.01], work: 0.01, zone: 2e-3, pressure: -0.05, near: [0.737, -0.349] },
    State { beta: 5.0, ratios: &[1.0], work: 0.02, zone: 5e-4, pressure: 0.1, near: [1.01, -0.055] },
    State { beta: 10.0, ratios: &[30.0], work: 0.03, zone: 1e-3, pressure: 0.2, near: [0.572, 0.016] },
    State { beta: 100.0, ratios: &[0.003, 0.03, 0.3, 3.0, 30.0, 300.0], work: 0.005, zone: 1e-3, pressure: -0.1, near: [0.402, -0.359] },
];

/// Mean pressure and the works of both edges over 2πΓ.
type Numbers = [f64; 3];

/// A state with its edges found and then held.
struct Held {
    memory: Arc<ContactMemory>,
    adhesion: WaveAdhesion,
    contact: WaveContact,
    penetration: f64,
}

/// A solid of E0 = 1.1 MPa with equal creep terms, ζ_j = τ_j at the rate one.
pub(in crate::studies) fn equal_terms(beta: f64, ratios: &[f64]) -> Result<PlaneMaterial, Refusal> {
    let relaxed = 1.1e6;
    let compliance = (1.0 - 1.0 / beta) / relaxed / ratios.len() as f64;
    let terms: Vec<CreepTerm> = ratios.iter().map(|&retardation_time| CreepTerm { compliance, retardation_time }).collect();
    PlaneMaterial::from_creep(relaxed * beta, &terms, None)
}

fn held(state: &State) -> Result<Held, Refusal> {
    let memory = Arc::new(ContactMemory::new(&equal_terms(state.beta, state.ratios)?, 1.0)?);
    let adhesion = WaveAdhesion::even(state.work, state.zone);
    let control = SlidingControl::MeanPressure(state.pressure);
    let balance = EdgeBalance::new(Arc::clone(&memory), Indenter::Wave, Some(adhesion), control, Resolution::Finest);
    let (found, _) = balance.solve_admissible(state.near, None, 1e-11)?;
    let (contact, penetration) = (found.solution.state.contact(), found.solution.state.penetration());
    Ok(Held { memory, adhesion, contact, penetration })
}

impl Held {
    fn target(&self) -> f64 {
        2.0 * PI * self.adhesion.trailing_work
    }

    fn ours(&self, resolution: Resolution) -> Result<Numbers, Refusal> {
        let WaveContact { half_width, eccentricity } = self.contact;
        let solve = |half_width: f64, eccentricity: f64, prescribed: Prescribed| {
            let edges = WaveContact { half_width, eccentricity };
            ContactState::at_resolution(&self.memory, Indenter::Wave, edges, prescribed, resolution)
        };
        let zone = self.adhesion.trailing_zone;
        let state = solve(half_width, eccentricity, Prescribed::Penetration(self.penetration))?;
        let work = |edge: Edge, shift: f64| -> Result<f64, Refusal> {
            let moved = solve(half_width + 0.5 * zone, eccentricity + shift * zone, state.held())?;
            let process_zone = ProcessZone::new(&self.memory, Indenter::Wave, edge, zone, resolution);
            Ok(process_zone.work(&state, &process_zone.tension(&moved)).value / self.target())
        };
        Ok([state.mean_pressure(), work(Edge::Trailing, -0.5)?, work(Edge::Leading, 0.5)?])
    }

    fn collocated(&self, layout: Layout, elements: usize, density: f64) -> Result<Numbers, Refusal> {
        let scheme = SlidingCollocation::new(self.memory.kernel(), layout, elements, density)?;
        let found = scheme.closures(&self.adhesion, Prescribed::Penetration(self.penetration), self.contact)?;
        Ok([found.contact.mean_pressure(), found.trailing_work / self.target(), found.leading_work / self.target()])
    }
}

/// How errors of several states become one.
#[derive(Clone, Copy)]
enum Over {
    Mean,
    Worst,
}

/// Errors of p̄, and of the worse of both works, at one fineness: the geometric mean over the states, or the worst.
fn errors(
    over: Over,
    states: &[Held],
    truths: &[Numbers],
    of: impl Fn(&Held) -> Result<Numbers, Refusal> + Sync,
) -> Result<[f64; 2], Refusal> {
    let each: Vec<[f64; 2]> = states
        .par_iter()
        .zip(truths)
        .map(|(state, truth)| {
            let found = of(state)?;
            let error = |index: usize| (found[index] - truth[index]).abs();
            Ok([error(0), error(1).max(error(2))])
        })
        .collect::<Result<_, Refusal>>()?;
    let one = |quantity: usize| match over {
        Over::Mean => (each.iter().map(|errors| errors[quantity].max(1e-18).ln()).sum::<f64>() / each.len() as f64).exp(),
        Over::Worst => each.iter().map(|errors| errors[quantity]).fold(0.0, f64::max),
    };
    Ok([one(0), one(1)])
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("convergence_sliding", "Convergence: sliding contacts");
    progress.expect(2);
    section.say(
        "Edges and penetration are held; the mean pressure and the works of both edges over 2πΓ are computed on ever more nodes. This program integrates \
         smooth functions by Gauss points, so each point brings digits. The thesis's collocation (mapped mesh, n = 1) converges in pressure and not in the works, \
         as the old edge is no node of the moved contact; with a mesh of its own for each process zone it does. Errors are geometric means over the states, of this program the worst; \
         the truth is this program at its finest, which shares nothing but the kernel with the collocation and meets the stored Chebyshev collocation to their digits.",
    );
    match computed(effort) {
        Ok((panels, levels)) => {
            panels.into_iter().for_each(|panel| panel.into_section(&mut section));
            section.checks.push(levels);
        }
        Err(refusal) => section.checks.push(Check::new("contacts with given edges", "every contact is solved", refusal.to_string(), false)),
    }
    progress.advance(1);
    section.checks.push(super::stored_sliding::against_reference());
    progress.advance(1);
    section
}

fn computed(effort: Effort) -> Result<([Panel; 2], Check), Refusal> {
    let states: Vec<Held> = STATES.iter().take(effort.choose(4, 6)).map(held).collect::<Result<_, _>>()?;
    let truths: Vec<Numbers> = states.iter().map(|state| state.ours(Resolution::Finest)).collect::<Result<_, _>>()?;
    let mut ours = [Vec::new(), Vec::new()];
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for (points, resolution) in [(8.0, Resolution::Coarse), (12.0, Resolution::Medium), (16.0, Resolution::Fine)] {
        let found = errors(Over::Worst, &states, &truths, |state| state.ours(resolution))?;
        kept.push((found[0].max(found[1]), resolution.relative_error()));
        ours.iter_mut().zip(found).for_each(|(column, error)| column.push((points, error)));
    }
    let meshes = effort.choose(vec![25, 50, 100, 200, 400], vec![25, 50, 100, 200, 400, 800]);
    let (mut printed, mut aligned) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
    for elements in meshes {
        let found = errors(Over::Mean, &states, &truths, |state| state.collocated(Layout::Mapped, elements, 1.0))?;
        printed.iter_mut().zip(found).for_each(|(column, error)| column.push((elements as f64, error)));
        let layout = Layout::WindowAligned { window_elements: (elements / 3).max(4) };
        let found = errors(Over::Mean, &states, &truths, |state| state.collocated(layout, elements, 2.0))?;
        aligned.iter_mut().zip(found).for_each(|(column, error)| column.push((elements as f64, error)));
    }
    let [our_pressure, our_works] = ours;
    let [printed_pressure, printed_works] = printed;
    let [aligned_pressure, aligned_works] = aligned;
    let gauss = Expectation::Digits {
        least: 0.4,
        reason: "Gauss rules of analytic integrands converge geometrically; levels are made for three digits each four points, of which at least half must show",
    };
    let graded = |reason: &'static str| Expectation::Order { order: 3.0, least: 2.4, most: 3.5, reason };
    let own = |name: &str, points: Vec<(f64, f64)>| {
        (Convergence { name: name.into(), points, floor: 1e-14, fitted: FINEST, expected: gauss }, true)
    };
    let other = |name: &str, points: Vec<(f64, f64)>, expected: Expectation| {
        (Convergence { name: name.into(), points, floor: 1e-12, fitted: FINEST, expected }, false)
    };
    let second = Expectation::Order {
        order: 2.0,
        least: 1.8,
        most: 2.2,
        reason: "midpoint collocation, elements that shrink to the edges like l² (n = 1): the root of the edge leaves N⁻² (thesis Sec 3.3; theory notes, section 3)",
    };
    let none = Expectation::Erratic {
        least_error: 1e-3,
        reason: "the old edge is no node of the moved contact: elements enter the process zone one by one",
    };
    let pressure = Panel {
        identifier: "pressure",
        caption: "Error of the mean pressure at given edges and penetration against Gauss points of a panel (this program) and elements (collocation).",
        fineness: ("nodes", "Gauss points of a panel, elements of the contact"),
        error: r"error of $\bar{p}$",
        curves: vec![
            own("this program", our_pressure),
            other("thesis, n = 1", printed_pressure, second),
            other("window-aligned, n = 2", aligned_pressure, graded("elements shrink like l³ (n = 2): N⁻³ with a logarithm")),
        ],
        headline: false,
    };
    let works = Panel {
        identifier: "works",
        caption: "Error of the works of both edges, over 2πΓ, against the same nodes: what an equilibrium is made of.",
        fineness: ("nodes", "Gauss points of a panel, elements of the contact"),
        error: r"error of work$/2\pi\Gamma$",
        curves: vec![
            own("this program (works)", our_works),
            other("thesis, n = 1 (works)", printed_works, none),
            other("window-aligned, n = 2 (works)", aligned_works, graded("windows meshed like the contact: N⁻³ with a logarithm")),
        ],
        headline: true,
    };
    let levels = Check::new(
        "levels of resolution are as good as they say",
        "at most 1e-4, 1e-7, 1e-10 for coarse, medium, fine: error bounds and stopping rest on it",
        kept.iter().map(|(found, _)| format!("{found:.1e}")).collect::<Vec<_>>().join(", "),
        kept.iter().all(|(found, promised)| found <= promised),
    );
    Ok(([pressure, works], levels))
}
