//! Source: thesis Eqs 3.26–3.30 (the work at an edge); the integration over the process zone is ours.
//!
//! Goal: the work at both edges of a contact, integrated over the process zone, equals the integral of the two fields taken point by point; each level
//! of resolution is better than the one before, and the error that a level has is bounded by its distance from the next.
//!
//! Parameters: 240 contacts drawn from 1 to 12 terms, β from 2 to 1000, sliding ratios from 1e-6 to 1e4, half-widths from 0.02 to 3.1,
//! process zones from 1e-4 to 0.05 of the smaller arc; wave and parabola.
//!
//! Oracle: `ContactState::pressure` and `gap` (each an integral along the arc of its own, checked against the Fourier symbol elsewhere), put
//! through a trapezoidal rule in the logarithm of the distance to both ends, which shares no node with the integration.
//!
//! Tolerance: 1e-11 of the work's scale ∫|tension·gap|, the accuracy of the oracle's step.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use std::f64::consts::PI;
use std::sync::Arc;
use support::random::Uniform;
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, ContactState, Edge, Indenter, Prescribed, ProcessZone, Resolution, WaveContact};

struct Case {
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    contact: WaveContact,
    pressure: f64,
    zone: f64,
    text: String,
}

fn draw(random: &mut Uniform) -> Case {
    let count = [1, 1, 2, 3, 6, 12][random.between(0.0, 6.0) as usize];
    let beta = random.log_between(2.0, 1000.0);
    let relaxed = 0.7e6;
    let terms: Vec<CreepTerm> = (0..count)
        .map(|_| CreepTerm { compliance: (1.0 - 1.0 / beta) / relaxed / f64::from(count), retardation_time: random.log_between(1e-6, 1e4) })
        .collect();
    let material = PlaneMaterial::from_creep(relaxed * beta, &terms, None).unwrap();
    let indenter = if random.between(0.0, 1.0) < 0.7 { Indenter::Wave } else { Indenter::Parabola };
    let half_width = if indenter == Indenter::Wave { random.between(0.02, 3.1) } else { random.log_between(0.01, 10.0) };
    let arc = if indenter == Indenter::Wave { half_width.min(PI - half_width) } else { half_width };
    let zone = arc * random.log_between(1e-4, 0.05);
    let eccentricity = random.between(-0.5, 0.5) * arc;
    let pressure = random.between(-0.2, 0.2) * (0.5 * half_width).min(1.0);
    let text = format!("{indenter:?} n = {count} β = {beta:.1} a = {half_width:.3} δ/arc = {:.1e}", zone / arc);
    let memory = Arc::new(ContactMemory::new(&material, 1.0).unwrap());
    Case { memory, indenter, contact: WaveContact { half_width, eccentricity }, pressure, zone, text }
}

/// The two contacts of an edge: as it is, and moved out.
fn contacts(case: &Case, edge: Edge, resolution: Resolution) -> (ContactState, ContactState) {
    let state = ContactState::at_resolution(&case.memory, case.indenter, case.contact, Prescribed::MeanPressure(case.pressure), resolution)
        .unwrap();
    let shift = match edge {
        Edge::Trailing => -0.5,
        Edge::Leading => 0.5,
    };
    let edges =
        WaveContact { half_width: case.contact.half_width + 0.5 * case.zone, eccentricity: case.contact.eccentricity + shift * case.zone };
    let moved = ContactState::at_resolution(&case.memory, case.indenter, edges, state.held(), resolution).unwrap();
    (state, moved)
}

/// (1/2δ)∫ tension·gap and (1/2δ)∫|tension·gap| point by point, d/δ = 1/(1 + e^{−τ}).
fn by_points(state: &ContactState, moved: &ContactState, edge: Edge, zone: f64) -> (f64, f64) {
    let step = 0.25;
    let (mut sum, mut size) = (0.0, 0.0);
    for index in -320..=320 {
        let tau = f64::from(index) * step;
        let (inside, outside) = (zone / (1.0 + (-tau).exp()), zone / (1.0 + tau.exp()));
        let (inner, outer) = match edge {
            Edge::Trailing => (moved.inside_trailing(inside).unwrap(), state.behind_trailing(outside).unwrap()),
            Edge::Leading => (moved.inside_leading(inside).unwrap(), state.ahead_of_leading(outside).unwrap()),
        };
        let value = -moved.pressure(inner) * state.gap(outer) * inside * outside / zone * step / (2.0 * zone);
        sum += value;
        size += value.abs();
    }
    (sum, size)
}

#[test]
fn work_integrated_over_the_zone_is_that_of_the_fields_point_by_point() {
    let mut random = Uniform::new();
    let mut worst = 0.0_f64;
    let mut level_errors: [Vec<f64>; 3] = [Vec::new(), Vec::new(), Vec::new()];
    let mut uncovered = 0;
    for _ in 0..240 {
        let case = draw(&mut random);
        for edge in [Edge::Trailing, Edge::Leading] {
            let (state, moved) = contacts(&case, edge, Resolution::Finest);
            let (expected, size) = by_points(&state, &moved, edge, case.zone);
            let at = |resolution: Resolution| {
                let (state, moved) = contacts(&case, edge, resolution);
                let zone = ProcessZone::new(&case.memory, case.indenter, edge, case.zone, resolution);
                zone.work(&state, &zone.tension(&moved)).value
            };
            let work = at(Resolution::Finest);
            let error = (work - expected).abs() / size;
            if error > 1e-11 {
                println!("{} {edge:?}: {work:.15e} against {expected:.15e}, {error:.1e}", case.text);
            }
            worst = worst.max(error);
            let levels = [Resolution::Coarse, Resolution::Medium, Resolution::Fine].map(at);
            for (errors, level) in level_errors.iter_mut().zip(levels) {
                errors.push((level - work).abs() / size);
            }
            uncovered += usize::from((levels[1] - work).abs() > (levels[1] - levels[0]).abs() + 1e-13 * size);
        }
    }
    for (name, errors) in ["coarse", "medium", "fine"].iter().zip(&mut level_errors) {
        errors.sort_by(f64::total_cmp);
        let at = |part: f64| errors[((errors.len() - 1) as f64 * part) as usize];
        println!("{name}: median {:.1e}, 90 % {:.1e}, 99 % {:.1e}, worst {:.1e}", at(0.5), at(0.9), at(0.99), at(1.0));
    }
    println!("finest against points: worst {worst:.1e}; medium outside its distance from coarse: {uncovered} of 480");
    assert!(worst <= 1e-11, "{worst}");
}
