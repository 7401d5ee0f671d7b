//! Lines and surfaces of the solver against two other programs.
//!
//! Source: `verification/references/line_panels.py`; `verification/peers/adhesive_range.py`.
//!
//! Goal: every number of every row is met; a rough surface takes as little work as it did.
//!
//! Oracle: `line_panels.csv`, 37 steady states by panels in real space (a logarithmic kernel and memory integrals, no Fourier transform); `peers_adhesive_range.csv`,
//! elastic adhesive lines and surfaces by Tamaas.
//!
//! Tolerance: the bound that comes with each number plus the oracle's own error; that sum may not be wide.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, missing_docs)]

use crate::line::assert_within;
use crate::support::{Row, reference_rows};
use nalgebra::Complex;
use std::collections::BTreeMap;
use std::sync::Arc;
use viscotack::finite_range::law::{Attraction, Law};
use viscotack::finite_range::line::{
    Control, Harmonic, Modulus, Numbers, Problem, Profile, Request, Roughness, Scales, SteadyState, every, modulus_of, rough, solve,
};
use viscotack::material::{CreepTerm, PlaneMaterial};
use viscotack::sliding::layer::{Backing, Layer};

fn list(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|v| v.parse().unwrap()).collect()
}

fn of_quantity(numbers: &Numbers, quantity: &str) -> f64 {
    match quantity {
        "mean_pressure" => numbers.mean_pressure,
        "mean_gap" => numbers.mean_gap,
        "friction_stress" => numbers.friction_stress,
        "contact_fraction" => numbers.contact_fraction,
        "adhesive_pressure" => numbers.adhesive_pressure,
        "interface_energy" => numbers.interface_energy,
        other => panic!("{other}"),
    }
}

/// Rows of one state together, in the order of the file.
fn by_state(name: &str, key: &str) -> Vec<Vec<Row>> {
    let mut states: BTreeMap<String, usize> = BTreeMap::new();
    let mut all: Vec<Vec<Row>> = Vec::new();
    for row in reference_rows(name) {
        let index = *states.entry(row.text(key).to_owned()).or_insert(all.len());
        if index == all.len() {
            all.push(Vec::new());
        }
        all[index].push(row);
    }
    all
}

/// The problem of a row, with its units: the solver reduces moduli, lengths and times itself.
fn sliding_line(row: &Row) -> (Problem, Scales) {
    let relaxed = row.number("modulus");
    let scales = Scales::new(relaxed, row.number("wavelength"), row.number("height")).unwrap();
    let law = match row.text("law") {
        "exponential" => Law::Exponential,
        "dugdale" => Law::Dugdale { ramp: row.number("ramp") },
        "lennard_jones" => Law::LennardJones,
        "cosine" => Law::Cosine,
        other => panic!("{other}"),
    };
    let attraction =
        Attraction::new(law, row.number("work"), row.number("range")).unwrap().in_units(scales.height, scales.pressure).unwrap();
    let (beta, weights) = (row.number("beta"), list(row.text("weights")));
    let total: f64 = weights.iter().sum();
    let terms: Vec<CreepTerm> = weights
        .iter()
        .zip(list(row.text("times")))
        .map(|(weight, retardation_time)| CreepTerm { compliance: (1.0 - 1.0 / beta) * weight / total / relaxed, retardation_time })
        .collect();
    let harmonics: Vec<Harmonic> = row
        .text("harmonics")
        .split(';')
        .map(list)
        .map(|wave| Harmonic { number: wave[0] as u32, amplitude: wave[1], phase: wave[2] })
        .collect();
    let layer = row.text("layer").split_once(' ').map(|(backing, rest)| {
        let (numbers, backing) = (list(rest), if backing == "bonded" { Backing::Confined } else { Backing::Free });
        Layer::new(backing, numbers[1], numbers[0] / scales.length).unwrap()
    });
    let control = match row.text("control") {
        "mean_pressure" => Control::MeanPressure(row.number("held") / scales.pressure),
        _ => Control::MeanGap(row.number("held") / scales.height),
    };
    let modulus = modulus_of(&PlaneMaterial::from_creep(beta * relaxed, &terms, None).unwrap()).unwrap();
    let profile = Profile::harmonics(&harmonics).unwrap();
    (Problem { profile, modulus, speed: scales.frequency(row.number("speed")), attraction, layer, control }, scales)
}

#[test]
fn steady_states_by_panels_in_real_space_are_met_within_both_errors() {
    let states = by_state("line_panels.csv", "state");
    assert!(states.len() >= 30, "{} states", states.len());
    for rows in states {
        let (problem, scales) = sliding_line(&rows[0]);
        let request = Request { accuracy: 1e-4, least_nodes: 1 << 12, most_nodes: 1 << 14 };
        let first = &rows[0];
        let is_wanted =
            |state: &SteadyState| (state.numbers.friction_stress / (first.number("value") / scales.friction) - 1.0).abs() < 1e-2;
        // Of several states at one input the panels may have reached another one than the solver: it must be among those of the search.
        let found = solve(&problem, &request).ok().filter(is_wanted);
        let found = found.or_else(|| every(&problem, &request).unwrap().into_iter().find(is_wanted));
        let state = found.unwrap_or_else(|| panic!("{}: no state of that friction", first.text("state")));
        assert_eq!(first.text("quantity"), "friction_stress");
        for row in &rows {
            let quantity = row.text("quantity");
            let unit = match quantity {
                "friction_stress" => scales.friction,
                "mean_gap" => scales.height,
                "contact_fraction" => 1.0,
                _ => scales.pressure,
            };
            let (value, bound) = (of_quantity(&state.numbers, quantity), of_quantity(&state.errors, quantity));
            let (want, error) = (row.number("value") / unit, row.number("error") / unit);
            assert_within(&format!("{}, {quantity}", row.text("state")), value, want, bound + error);
            // Edges of the contact lie between nodes.
            let widest = if quantity == "contact_fraction" { 2e-3 } else { 1e-3 * want.abs() };
            assert!(bound + error <= widest, "{}, {quantity}: {bound:e} and {error:e} are too wide to mean anything", row.text("state"));
        }
    }
}

#[test]
fn elastic_lines_and_surfaces_by_tamaas_are_met_within_both_errors() {
    let elastic: Modulus = Arc::new(|_| Complex::new(1.0, 0.0));
    for rows in by_state("peers_adhesive_range.csv", "case") {
        let row = &rows[0];
        let waves: Vec<Vec<f64>> = row.text("waves").split(';').map(list).collect();
        let surface = waves.iter().any(|wave| wave[1] != 0.0);
        let (nodes, ny) = (16, if surface { 16 } else { 1 });
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / nodes as f64;
        let height = |x: usize, y: usize| waves.iter().map(|w| w[2] * (w[0] * angle(x) + w[1] * angle(y) + w[3]).cos()).sum();
        let heights = (0..ny).flat_map(|y| (0..nodes).map(move |x| (x, y))).map(|(x, y)| height(x, y)).collect();
        let attraction = Attraction::new(Law::Exponential, row.number("work"), row.number("range")).unwrap();
        let profile = Profile::surface(nodes, ny, 1.0, heights).unwrap();
        let problem = Problem::new(profile, Arc::clone(&elastic), 1.0, attraction, Control::MeanGap(row.number("mean_gap")));
        let finest = if surface { 512 } else { 8192 };
        let state = solve(&problem, &Request { accuracy: 1e-4, least_nodes: finest, most_nodes: finest }).unwrap();
        assert_within("friction of an elastic body", state.numbers.friction_stress, 0.0, 1e-12);
        for row in &rows {
            let quantity = row.text("quantity");
            let (value, bound) = (of_quantity(&state.numbers, quantity), of_quantity(&state.errors, quantity));
            let (want, error) = (row.number("value"), row.number("error"));
            assert_within(&format!("{}, {quantity}", row.text("case")), value, want, bound + error);
            let widest = if quantity == "contact_fraction" { 2e-2 } else { 3e-3 * want.abs().max(0.01) };
            assert!(bound + error <= widest, "{}, {quantity}: {bound:e} and {error:e} are too wide to mean anything", row.text("case"));
        }
    }
}

/// The search, the coarser grids and the answer together, in products on the grid of the answer: most of its time.
#[test]
fn a_rough_surface_takes_few_products() {
    let roughness = Roughness { hurst: 0.8, rms_height: 0.35, lowest: 1.0, highest: 8.0, seed: 1 };
    let terms = [CreepTerm { compliance: 0.9, retardation_time: 1.0 }];
    let modulus = modulus_of(&PlaneMaterial::from_creep(10.0, &terms, None).unwrap()).unwrap();
    let attraction = Attraction::new(Law::Exponential, std::f64::consts::TAU * 0.008, 0.1).unwrap();
    let problem = Problem::new(rough(&roughness, false).unwrap(), modulus, 1.0, attraction, Control::MeanPressure(0.2));
    let state = solve(&problem, &Request { accuracy: 1e-4, least_nodes: 512, most_nodes: 512 }).unwrap();
    let products = state.node_products as f64 / (512.0 * 512.0);
    assert!(products < 160.0, "{products} products");
}
