//! Source: thesis Sec 3.3 (Eqs 3.26–3.36), the collocation scheme; theory of the memory loads in `sliding::contact`.
//!
//! Goal: our contact and the collocated one, which share nothing but the kernel's definition, are the same contact: mean pressure, pressures,
//! friction and interface work at given edges; works at the edges and release rates with each edge moved out; the edges themselves.
//!
//! Parameters: 1, 2 and 6 terms, β from 3 to 1000, ζ from 0.01 to 30, Γ from 0.002 to 0.03, positive, zero and negative load, moduli of 0.7 Pa to
//! 3 GPa. Edges, penetration: those of our equilibrium, then fixed. N = 100, 200, 400, 800 elements and N/3 in each process zone, n = 2.
//!
//! Oracle: `rivals::sliding_collocation`, window-aligned, extrapolated from its measured orders: integrals 3 (with its logarithm, so 3 twice),
//! then 4; pressures at points 2, then 4. The thesis's own scheme beside it: its mean pressure has order 2, its works have none.
//!
//! Tolerance, relative to max(|value|, 1), with the worst seen: mean pressure, friction and U 1e-8 (2.5e-10); pressures 1e-6 (4e-7, β = 1000); works
//! 1e-5 (8e-8; against 2πΓ itself 1.3e-6 of it, β = 1000); release rates, which carry the rounding of U divided by δ, 1e-4 (2.3e-6); edges 1e-5
//! (3e-6). The thesis's scheme is off by more than a percent in its works at one of N = 100, 200, 400, or the aligned one would not be needed.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use support::sliding::contact_near;
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ArcPoint, ContactMemory, ContactState, Edge, Prescribed, WaveContact, edge_work};
use viscotack::sliding::steady::WaveAdhesion;
use viscotack_verification::rivals::sliding_collocation::richardson::{extrapolated, observed_order};
use viscotack_verification::rivals::sliding_collocation::{Layout, SlidingCollocation};

const COARSEST: usize = 100;
const LEVELS: u32 = 4;
const DENSITY: f64 = 2.0;
/// Orders of integrals and of pressures at points.
const INTEGRAL: [f64; 3] = [3.0, 3.0, 4.0];
const POINTWISE: [f64; 2] = [2.0, 4.0];
/// Parts of the contact width at which pressures are compared.
const PARTS: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

struct State {
    name: &'static str,
    relaxed: f64,
    beta: f64,
    /// ζ_j of equal terms.
    ratios: &'static [f64],
    reduced_work: f64,
    zone: f64,
    mean_pressure: f64,
    /// Half-width and eccentricity near the equilibrium: some states have another one.
    near: (f64, f64),
}

#[rustfmt::skip]
const STATES: [State; 10] = [
    State { name: "soft, slow", relaxed: 1.0, beta: 3.0, ratios: &[0.01], reduced_work: 0.005, zone: 1e-3, mean_pressure: 0.0, near: (0.608, -0.142) },
    State { name: "one term", relaxed: 7e5, beta: 10.0, ratios: &[0.1], reduced_work: 0.01, zone: 1e-3, mean_pressure: 0.05, near: (1.382, -0.5) },
    State { name: "pulled", relaxed: 0.7, beta: 10.0, ratios: &[0.01], reduced_work: 0.01, zone: 2e-3, mean_pressure: -0.05, near: (0.737, -0.349) },
    State { name: "fast", relaxed: 1.1e6, beta: 10.0, ratios: &[30.0], reduced_work: 0.03, zone: 1e-3, mean_pressure: 0.2, near: (0.572, 0.016) },
    State { name: "lossy", relaxed: 1.1e6, beta: 20.0, ratios: &[0.3], reduced_work: 2e-3, zone: 1e-3, mean_pressure: 0.1, near: (0.946, -0.187) },
    State { name: "stiff, slow", relaxed: 3e6, beta: 1000.0, ratios: &[0.01], reduced_work: 2e-3, zone: 1e-3, mean_pressure: 0.05, near: (0.967, -0.332) },
    State { name: "stiff, fast", relaxed: 3e6, beta: 1000.0, ratios: &[30.0], reduced_work: 0.03, zone: 1e-3, mean_pressure: 1.0, near: (0.419, 0.105) },
    State { name: "sticky", relaxed: 3e9, beta: 5.0, ratios: &[1.0], reduced_work: 0.02, zone: 5e-4, mean_pressure: 0.1, near: (1.01, -0.055) },
    State { name: "two terms", relaxed: 7e5, beta: 50.0, ratios: &[0.02, 3.0], reduced_work: 0.005, zone: 1e-3, mean_pressure: 0.1, near: (1.076, -0.32) },
    State { name: "six terms", relaxed: 1.1e6, beta: 100.0, ratios: &[0.003, 0.03, 0.3, 3.0, 30.0, 300.0], reduced_work: 0.005, zone: 1e-3, mean_pressure: -0.1, near: (0.402, -0.359) },
];

/// Equal creep terms with ζ_j = τ_j at the rate one.
fn material(state: &State) -> PlaneMaterial {
    let compliance = (1.0 - 1.0 / state.beta) / state.relaxed / state.ratios.len() as f64;
    let terms: Vec<CreepTerm> = state.ratios.iter().map(|&retardation_time| CreepTerm { compliance, retardation_time }).collect();
    PlaneMaterial::from_creep(state.relaxed * state.beta, &terms, None).unwrap()
}

fn adhesion(state: &State) -> WaveAdhesion {
    WaveAdhesion::even(state.reduced_work, state.zone)
}

fn our_edges(state: &State) -> (WaveContact, f64) {
    let memory = ContactMemory::new(&material(state), 1.0).unwrap();
    let start = WaveContact { half_width: state.near.0, eccentricity: state.near.1 };
    let found = contact_near(&memory, Some(adhesion(state)), Prescribed::MeanPressure(state.mean_pressure), start, 1e-10).unwrap().state;
    (found.contact(), found.penetration())
}

/// p̄, friction stress, U | works, releases of both edges | pressures at the parts of the width.
fn our_values(state: &State, contact: WaveContact, penetration: f64) -> Vec<f64> {
    let memory = ContactMemory::new(&material(state), 1.0).unwrap();
    let at = |half_width: f64, eccentricity: f64| {
        ContactState::new(&memory, WaveContact { half_width, eccentricity }, Prescribed::Penetration(penetration)).unwrap()
    };
    let (a, e, half) = (contact.half_width, contact.eccentricity, 0.5 * state.zone);
    let (old, trailing, leading) = (at(a, e), at(a + half, e - half), at(a + half, e + half));
    let release = |moved: &ContactState| (moved.interface_work() - old.interface_work()) / (2.0 * PI * state.reduced_work * state.zone);
    let mut values = vec![
        old.mean_pressure(),
        old.friction_stress(),
        old.interface_work(),
        edge_work(&old, &trailing, Edge::Trailing, state.zone),
        edge_work(&old, &leading, Edge::Leading, state.zone),
        release(&trailing),
        release(&leading),
    ];
    values.extend(PARTS.map(|part| old.pressure(old.inside_trailing(part * 2.0 * a).unwrap())));
    values
}

fn rival_values(state: &State, contact: WaveContact, penetration: f64, layout: Layout, elements: usize) -> Vec<f64> {
    let memory = ContactMemory::new(&material(state), 1.0).unwrap();
    let density = if layout == Layout::Mapped { 1.0 } else { DENSITY };
    let scheme = SlidingCollocation::new(memory.kernel(), layout, elements, density).unwrap();
    let found = scheme.closures(&adhesion(state), Prescribed::Penetration(penetration), contact).unwrap();
    let (trailing, leading) = found.releases(&adhesion(state));
    let old = &found.contact;
    let mut values =
        vec![old.mean_pressure(), old.friction_stress(), old.interface_work(), found.trailing_work, found.leading_work, trailing, leading];
    let width = 2.0 * contact.half_width;
    values.extend(PARTS.map(|part| {
        let point = ArcPoint { from_trailing: part * width, from_leading: width - part * width };
        old.pressure(point)
    }));
    values
}

const NAMES: [&str; 12] = ["p̄", "friction", "U", "W₁", "W₂", "G₁", "G₂", "p(0.1)", "p(0.3)", "p(0.5)", "p(0.7)", "p(0.9)"];

fn difference(value: f64, reference: f64) -> f64 {
    (value - reference).abs() / reference.abs().max(1.0)
}

#[test]
fn collocation_extrapolates_to_the_same_contact_works_and_releases() {
    let mut worst = [0.0_f64; 12];
    for state in &STATES {
        let (contact, penetration) = our_edges(state);
        let ours = our_values(state, contact, penetration);
        let levels: Vec<Vec<f64>> = (0..LEVELS)
            .map(|level| {
                let elements = COARSEST << level;
                rival_values(state, contact, penetration, Layout::WindowAligned { window_elements: elements / 3 }, elements)
            })
            .collect();
        println!(
            "{}: β = {}, ζ = {:?}, Γ = {}, p̄ = {}: a = {:.4}, e = {:.4}, Δ = {penetration:.4}",
            state.name, state.beta, state.ratios, state.reduced_work, state.mean_pressure, contact.half_width, contact.eccentricity
        );
        for (index, name) in NAMES.iter().enumerate() {
            let values: Vec<f64> = levels.iter().map(|row| row[index]).collect();
            let orders: &[f64] = if index < 7 { &INTEGRAL } else { &POINTWISE };
            let (found, reference) = (extrapolated(&values, orders), ours[index]);
            let order = observed_order(values[1], values[2], values[3]);
            let (off, finest) = (difference(found, reference), difference(values[3], reference));
            println!("  {name:9} {reference:15.8e}   N = 800 off by {finest:.1e}, extrapolated by {off:.1e}, order {order:.2}");
            worst[index] = worst[index].max(off);
            let tolerance = match index {
                0..3 => 1e-8,
                3..5 => 1e-5,
                5..7 => 1e-4,
                _ => 1e-6,
            };
            assert!(off < tolerance, "{}: {name} is {found} by collocation and {reference} by us", state.name);
        }
        for index in [3, 4] {
            let values: Vec<f64> = levels.iter().map(|row| row[index]).collect();
            let work = extrapolated(&values, &INTEGRAL);
            let target = 2.0 * PI * state.reduced_work;
            assert!((work / target - 1.0).abs() < 1e-5, "{}: {} = {work} against 2πΓ = {target}", state.name, NAMES[index]);
        }
    }
    println!("worst after extrapolation: {:?}", NAMES.iter().zip(worst.map(|value| format!("{value:.1e}"))).collect::<Vec<_>>());
}

/// The source's scheme, as it is: its mean pressure converges at order 2 (n = 1); its closure is erratic, within a few percent.
#[test]
fn the_thesis_scheme_converges_in_pressure_but_not_in_the_closure() {
    for state in &STATES[..3] {
        let (contact, penetration) = our_edges(state);
        let ours = our_values(state, contact, penetration);
        let levels: Vec<Vec<f64>> =
            (1..LEVELS).map(|level| rival_values(state, contact, penetration, Layout::Mapped, COARSEST << (level - 1))).collect();
        let column = |index: usize| -> Vec<f64> { levels.iter().map(|row| row[index]).collect() };
        let mean = column(0);
        let order = observed_order(mean[0], mean[1], mean[2]);
        let off =
            |index: usize| -> Vec<String> { column(index).iter().map(|value| format!("{:+.1e}", value / ours[index] - 1.0)).collect() };
        println!("{}: order of p̄ {order:.3}; relative errors of W₁ {:?}, W₂ {:?}", state.name, off(3), off(4));
        assert!((order - 2.0).abs() < 0.1, "{}: order {order}", state.name);
        let worst = [3, 4].into_iter().flat_map(|index| column(index).into_iter().map(move |value| (index, value)));
        let worst = worst.map(|(index, value)| (value / ours[index] - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst > 0.01, "{}: the works are off by no more than {worst:.1e}", state.name);
    }
}

#[test]
fn newton_on_the_collocated_closures_finds_the_same_edges() {
    for state in [&STATES[1], &STATES[8]] {
        let (contact, _) = our_edges(state);
        let memory = ContactMemory::new(&material(state), 1.0).unwrap();
        let start = WaveContact { half_width: 1.02 * contact.half_width, eccentricity: contact.eccentricity - 0.01 };
        let levels: Vec<[f64; 2]> = [50, 100, 200, 400]
            .into_iter()
            .map(|elements| {
                let layout = Layout::WindowAligned { window_elements: elements / 3 };
                let scheme = SlidingCollocation::new(memory.kernel(), layout, elements, DENSITY).unwrap();
                let found = scheme.equilibrium(&adhesion(state), Prescribed::MeanPressure(state.mean_pressure), start, 1e-9).unwrap();
                [found.edges.half_width, found.edges.eccentricity]
            })
            .collect();
        for (index, (name, ours)) in [("a", contact.half_width), ("e", contact.eccentricity)].into_iter().enumerate() {
            let values: Vec<f64> = levels.iter().map(|row| row[index]).collect();
            let off = (extrapolated(&values, &INTEGRAL) - ours).abs();
            println!("{}: {name} = {ours:.8}, collocated {values:?}, extrapolated off by {off:.1e}", state.name);
            assert!(off < 1e-5, "{}: {name}", state.name);
        }
    }
}
