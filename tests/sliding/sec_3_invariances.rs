//! Source: thesis Secs 2.2.2 and 3.2 (the groups of a sliding contact); invariances that any solution must have.
//!
//! Goal: units, the bookkeeping of the spectrum and the direction of sliding change nothing but what they must.
//!
//! ```text
//! units        Pa, s → MPa, ms                      same reduced contact
//! splitting    J (1 − e^{−t/τ}) = two halves         same contact; at τ(1 ± h) a contact that differs by O(h²)
//! vanishing    a term of strength 1e-30 … 1e-6       a change in proportion, none below rounding
//! v → −v       𝒢(x; −v) = 𝒢(−x; v)                   mirrored pressure makes the mirrored surface
//! ```
//! Parameters: 40 random solids of up to 12 terms (β up to 100, moduli and times nothing like one); one- and three-term solids for the rest.
//!
//! Oracle: the contact itself in other words; for the mirror, the convolution of the pressure with the Green's function (its own tests), which
//! knows nothing of memory loads.
//!
//! Tolerance: with each test.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support::physics;

use crate::support;

use physics::{Random, in_mpa_ms, random_solid};
use std::f64::consts::PI;
use support::sliding::contact_at_rate;
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, ContactState, Prescribed, WaveContact};
use viscotack::sliding::steady::WaveAdhesion;
use viscotack::sliding::{HalfPlaneGreen, SlidingMemory};

/// Totals, amplitudes, pressures and gaps of a contact, with the scale of each.
fn numbers(material: &PlaneMaterial, rate: f64, contact: WaveContact, mean_pressure: f64) -> Vec<(f64, f64)> {
    let state = ContactState::new(&ContactMemory::new(material, rate).unwrap(), contact, Prescribed::MeanPressure(mean_pressure)).unwrap();
    let (trailing, leading) = state.edge_amplitudes();
    let edge = trailing.abs().max(leading.abs()).max(1.0);
    let mut values =
        vec![(state.penetration(), 1.0), (state.friction_stress(), 1.0), (state.interface_work(), 1.0), (trailing, edge), (leading, edge)];
    for part in [0.01, 0.3, 0.8] {
        let distance = part * 2.0 * contact.half_width;
        for point in [state.inside_trailing(distance), state.inside_leading(distance)] {
            values.push((state.pressure(point.unwrap()), edge / part.sqrt()));
        }
        values.push((state.gap(state.behind_trailing(part * 2.0 * (PI - contact.half_width)).unwrap()), 1.0));
    }
    values
}

/// The largest difference over its scale.
fn difference(left: &[(f64, f64)], right: &[(f64, f64)]) -> f64 {
    left.iter().zip(right).map(|(a, b)| (a.0 - b.0).abs() / a.1).fold(0.0, f64::max)
}

/// Tolerance: 1e-13 of the scale of each number for solids given by their creep terms, whose groups differ by rounding alone; the conversion of
/// relaxation terms has its own rounding in other units. Found edges, to the tolerance of the search.
#[test]
fn two_unit_systems_give_one_reduced_contact() {
    let mut random = Random(2025);
    let mut worst = 0.0_f64;
    for _ in 0..40 {
        let material = random_solid(&mut random, 12, 9.0, 100.0);
        let rate = random.decade(0.01, 100.0) / material.longest_retardation_time().unwrap();
        let contact = WaveContact { half_width: random.between(0.2, 2.8), eccentricity: random.between(-0.3, 0.3) };
        let pressure = random.between(-0.2, 0.5);
        let (pascal, mega) = (numbers(&material, rate, contact, pressure), numbers(&in_mpa_ms(&material), rate * 1e-3, contact, pressure));
        let error = difference(&pascal, &mega);
        assert!(error < 1e-13, "{} terms, β = {:.1}, {contact:?}: {error:e}", material.creep_terms().len(), material.stiffening_ratio());
        worst = worst.max(error);
    }
    println!("units, given edges: {worst:.1e}");
    let material = PlaneMaterial::from_creep(
        3.3e7,
        &[CreepTerm { compliance: 5e-7, retardation_time: 2.0 }, CreepTerm { compliance: 1e-6, retardation_time: 0.03 }],
        None,
    )
    .unwrap();
    let adhesion = WaveAdhesion { trailing_zone: 1e-3, ..WaveAdhesion::even(0.002, 2e-3) };
    let prescribed = Prescribed::MeanPressure(0.05);
    let edges = |material: &PlaneMaterial, rate: f64| {
        let adhesive = contact_at_rate(material, rate, Some(adhesion), prescribed, 1e-12).unwrap();
        let plain = contact_at_rate(material, rate, None, prescribed, 1e-12).unwrap();
        let (adhesive_edges, plain_edges) = (adhesive.state.contact(), plain.state.contact());
        [
            adhesive_edges.half_width,
            adhesive_edges.eccentricity,
            plain_edges.half_width,
            plain_edges.eccentricity,
            adhesive.trailing_release,
            adhesive.leading_release,
        ]
    };
    let (pascal, mega) = (edges(&material, 0.4), edges(&in_mpa_ms(&material), 0.4e-3));
    println!("units, found edges: {pascal:?} {mega:?}");
    for (left, right) in pascal.iter().zip(&mega) {
        assert!((left - right).abs() < 1e-9, "{left} {right}");
    }
}

fn solid(terms: &[(f64, f64)]) -> PlaneMaterial {
    let terms: Vec<CreepTerm> = terms.iter().map(|&(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect();
    PlaneMaterial::from_creep(6.6e7, &terms, None).unwrap()
}

/// Tolerance: equal halves are one term, to the last bit (the material merges them). Halves at τ(1 ± h) make a contact that differs by h² times a
/// number below 20 (9.4 is met); below rounding, by rounding alone, 1e-13, however close the times.
#[test]
fn splitting_a_term_changes_nothing() {
    let contact = WaveContact { half_width: 1.3, eccentricity: 0.04 };
    for (name, others) in [("alone", vec![]), ("among three", vec![(4e-7, 20.0), (2e-7, 0.004)])] {
        for time in [0.003, 0.3, 30.0] {
            let with = |split: &[(f64, f64)]| {
                let terms: Vec<(f64, f64)> = others.iter().chain(split).copied().collect();
                numbers(&solid(&terms), 1.7, contact, 0.1)
            };
            let one = with(&[(1.4e-6, time)]);
            assert_eq!(difference(&one, &with(&[(0.7e-6, time), (0.7e-6, time)])).to_bits(), 0);
            for h in [1e-3, 1e-6, 1e-9, 1e-12] {
                let change = difference(&one, &with(&[(0.7e-6, time * (1.0 - h)), (0.7e-6, time * (1.0 + h))]));
                println!("{name}, τ = {time}: halves at τ(1 ± {h:e}): {change:.1e}");
                assert!(change < 20.0 * h * h + 1e-13, "{name}, τ = {time}, h = {h:e}: {change:e}");
            }
        }
    }
}

/// Tolerance: the change is in proportion to the strength to 1 %, and below 100 times it.
#[test]
fn a_vanishing_term_vanishes_in_proportion() {
    for time in VANISHING_TIMES {
        let (small, tiny) = (vanishing(1e-6, time), vanishing(1e-9, time));
        println!("a term at {time:e} s of strength 1e-6, 1e-9: {small:.2e} {tiny:.2e}, 1e-12: {:.1e}", vanishing(1e-12, time));
        assert!(tiny < 1e-7 && (small / tiny / 1e3 - 1.0).abs() < 1e-2, "{time}: {tiny:e} {small:e}");
        assert!(vanishing(1e-12, time) < 1e-10 + 1e-13);
    }
}

/// Tolerance: rounding. The relaxation time of such a term is its retardation time to the last digit.
#[test]
fn a_term_below_rounding_is_no_term() {
    for time in VANISHING_TIMES {
        for strength in [1e-15, 1e-16, 1e-17, 1e-18, 1e-30] {
            let change = vanishing(strength, time);
            println!("a term at {time:e} s of strength {strength:e}: {change:.1e}");
            assert!(change < 1e-12, "{time}, {strength:e}: {change:e}");
        }
    }
}

const VANISHING_TIMES: [f64; 6] = [1e-5, 0.01, 0.1, 0.31, 5.0, 1e6];

/// What a term of this strength over 1/E0 changes in a contact of a solid with two others.
fn vanishing(strength: f64, time: f64) -> f64 {
    let contact = WaveContact { half_width: 1.3, eccentricity: 0.04 };
    let terms = [(9e-7, 0.3), (3e-7, 0.02)];
    let relaxed = solid(&terms).relaxed_modulus();
    let with = [terms[0], terms[1], (strength / relaxed, time)];
    difference(&numbers(&solid(&terms), 1.7, contact, 0.1), &numbers(&solid(&with), 1.7, contact, 0.1))
}

/// Nodes of the convolution (and twice as many).
const NODES: usize = 1500;

/// −∫𝒢(x − ξ)p(ξ)dξ by Gauss–Chebyshev sums at x = e − a cos θ, θ = jπ/NODES, or outside; `mirrored` puts the mirrored pressure in. The logarithm costs
/// an error in 1/N exactly between two nodes, which two counts take out.
fn surface(green: &HalfPlaneGreen, state: &ContactState, position: f64, mirrored: bool) -> f64 {
    let WaveContact { half_width: a, eccentricity } = state.contact();
    let sum = |nodes: usize| -> f64 {
        let step = PI / nodes as f64;
        (0..nodes)
            .map(|index| {
                let theta = (index as f64 + 0.5) * step;
                let (near, far) = (2.0 * a * (0.5 * theta).sin().powi(2), 2.0 * a * (0.5 * theta).cos().powi(2));
                let point = if near < far { state.inside_trailing(near) } else { state.inside_leading(far) };
                let x = eccentricity - a * theta.cos();
                let source = if mirrored { -x } else { x };
                -green.value(position - source).unwrap().value * state.pressure(point.unwrap()) * a * theta.sin() * step
            })
            .sum()
    };
    2.0 * sum(2 * NODES) - sum(NODES)
}

/// Tolerance: the kernel mirrors to the last bit, the convolution to rounding, 1e-12; it meets the wave and the gap within 1e-8 (Romberg's
/// remainder at this N; 7e-10 is reached).
#[test]
fn reversed_sliding_mirrors_the_contact() {
    for (material, rate) in [(solid(&[(1.4e-6, 0.3)]), 1.7), (solid(&[(9e-7, 0.3), (3e-7, 1.0), (2e-7, 4.0)]), 2.0)] {
        let edges = WaveContact { half_width: 1.1, eccentricity: -0.1 };
        let state = ContactState::new(&ContactMemory::new(&material, rate).unwrap(), edges, Prescribed::MeanPressure(0.1)).unwrap();
        let WaveContact { half_width: a, eccentricity } = state.contact();
        let forward = SlidingMemory::of_material(&material, 1.0, rate).unwrap();
        let backward = SlidingMemory::of_material(&material, 1.0, -rate).unwrap();
        assert_eq!(backward, forward.reversed());
        let (forward, backward) = (HalfPlaneGreen::new(forward).unwrap(), HalfPlaneGreen::new(backward).unwrap());
        for x in [0.01, 0.4, 2.0, -1.0, -3.0] {
            assert_eq!(forward.value(x).unwrap().value.to_bits(), backward.value(-x).unwrap().value.to_bits());
        }
        let inside = [0.2, 0.5, 0.9].map(|part| eccentricity - a * (PI * part).cos());
        let behind = [0.1, 0.6].map(|part| part * 2.0 * (PI - a));
        let mut worst = [0.0_f64; 2];
        let mut check = |x: f64, expected: f64| {
            let (straight, mirror) = (surface(&forward, &state, x, false), surface(&backward, &state, -x, true));
            worst[0] = worst[0].max((straight - mirror).abs());
            worst[1] = worst[1].max((straight - expected).abs());
            // Not mirrored together, the surface is another one.
            let wrong = surface(&forward, &state, -x, true);
            assert!((wrong - expected).abs() > 1e-4, "x = {x}: the direction is not felt");
        };
        for x in inside {
            check(x, x.cos() - 1.0 + state.penetration());
        }
        for distance in behind {
            let x = eccentricity - a - distance;
            check(x, x.cos() - 1.0 + state.penetration() + state.gap(state.behind_trailing(distance).unwrap()));
        }
        println!("mirrored surface: {:.1e} from the straight one, which is {:.1e} from wave and gap", worst[0], worst[1]);
        assert!(worst[0] < 1e-12 && worst[1] < 1e-8, "{worst:?}");
    }
}
