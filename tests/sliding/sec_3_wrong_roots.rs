//! Source: thesis Secs 3.2 and 3.3 (both closures are quadratic in the amplitude of their edge).
//!
//! Goal: each contact has four roots, sometimes two more a few process zones wide, that satisfy both closures to rounding; all but one cannot exist (a pressed edge,
//! interpenetrating faces).
//! All four are listed by brute force. From 1,000 random starts at fixed penetration, with bulk losses, the solver returns the one that can
//! exist or refuses.
//!
//! ```text
//!   pull, press │ press, press      one root for each pair of signs of the amplitudes (trailing, leading)
//!   ────────────┼─────────────      in the plane of the two edges, about the adhesiveless contact of that penetration
//!   pull, pull  │ press, pull
//! ```
//! Parameters: β = 20, ζ = 0.3, Γ = 0.002; β = 10, ζ = 3, Γ = 0.003; δ = 1e-3; Δ of a contact reached along the path in speed.
//!
//! Oracle: a grid of 72 × 80 pairs of edges (half-width 0.005 to 2, eccentricity −1 to 1), each cell in which both closures change sign being the start of
//! a Newton method of this file, on the works themselves and not on their roots; the state reached by continuation; the signs of the
//! edge amplitudes, also in the moved contacts; the gap at 199 points.
//!
//! Tolerance: residuals of the roots 1e-10 of 2πΓ; the same edges to 1e-7 (Newton to 1e-10), 1e-9 for the root that can exist (path to 1e-12);
//! refusals for unphysical roots must occur, or the test would show nothing.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;

use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::Arc;
use support::sliding::{contact_at_rate, contact_near};
use viscotack::continuation::two_unknowns::TwoResiduals;
use viscotack::sliding::contact::{ContactMemory, ContactState, Edge, Indenter, Prescribed, Resolution, WaveContact, edge_work};
use viscotack::sliding::edge_balance::EdgeBalance;
use viscotack::sliding::steady::{SlidingControl, WaveAdhesion};
use viscotack::{PlaneMaterial, Refusal};

const STARTS: u32 = 1000;

#[test]
fn random_starts_never_return_an_unphysical_root() {
    let (time, ratio) = (0.2, 0.3);
    let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * 20.0, time).unwrap();
    let adhesion = WaveAdhesion::even(0.002, 1e-3);
    let on_path = contact_at_rate(&material, ratio / time, Some(adhesion), Prescribed::MeanPressure(0.1), 1e-12).unwrap();
    let prescribed = Prescribed::Penetration(on_path.state.penetration());
    let memory = ContactMemory::new(&material, ratio / time).unwrap();
    // A fixed sequence of pseudo-random numbers (an additive lattice of irrational steps covers the square evenly).
    let solve = |index: u32| {
        let (first, second) = ((f64::from(index) * 0.754_877_666_246_692_7).fract(), (f64::from(index) * 0.569_840_290_998_053_2).fract());
        let start = WaveContact { half_width: 0.02 + 3.0 * first, eccentricity: 1.6 * (second - 0.5) };
        contact_near(&memory, Some(adhesion), prescribed, start, 1e-10)
    };
    let (mut found, mut unphysical, mut lost) = (Vec::new(), 0, 0);
    for result in (1..=STARTS).into_par_iter().map(solve).collect::<Vec<_>>() {
        match result {
            Ok(state) => {
                assert!(state.admissible);
                let (trailing, leading) = state.state.edge_amplitudes();
                assert!(trailing < 0.0 && leading < 0.0);
                found.push(state.state.contact());
            }
            Err(Refusal::NotConverged { detail, .. }) if detail.contains("unphysical") => unphysical += 1,
            Err(_) => lost += 1,
        }
    }
    let path = on_path.state.contact();
    let same = |contact: &&WaveContact| {
        (contact.half_width - path.half_width).abs() < 1e-7 && (contact.eccentricity - path.eccentricity).abs() < 1e-7
    };
    let others: Vec<_> = found.iter().filter(|contact| !same(contact)).collect();
    println!(
        "{STARTS} starts: {} found ({} elsewhere: {:?}), {unphysical} unphysical roots refused, {lost} not converged",
        found.len(),
        others.len(),
        others.first()
    );
    assert!(others.is_empty(), "another state was returned: {:?} besides {path:?}", others.first());
    assert!(found.len() > 100, "the admissible state is found from many starts: {}", found.len());
    // Those that exist are listed by the other test; the residual with the sign of the edge has no zero there.
    assert!(unphysical + lost < STARTS, "{unphysical} {lost}");
}

/// Both closures at one pair of edges: work/2πΓ − 1, signed and not rooted, with the contact and the two moved ones.
fn closures(
    memory: &ContactMemory,
    adhesion: &WaveAdhesion,
    prescribed: Prescribed,
    edges: WaveContact,
) -> Result<([f64; 2], [ContactState; 3]), Refusal> {
    let state = ContactState::new(memory, edges, prescribed)?;
    let moved = |zone: f64, shift: f64| {
        let out = WaveContact { half_width: edges.half_width + 0.5 * zone, eccentricity: edges.eccentricity + shift };
        ContactState::new(memory, out, prescribed)
    };
    let (trailing, leading) = (adhesion.trailing_zone, adhesion.leading_zone);
    let (first, second) = (moved(trailing, -0.5 * trailing)?, moved(leading, 0.5 * leading)?);
    let target = 2.0 * PI * adhesion.trailing_work;
    let values = [
        edge_work(&state, &first, Edge::Trailing, trailing) / target - 1.0,
        edge_work(&state, &second, Edge::Leading, leading) / target - 1.0,
    ];
    Ok((values, [state, first, second]))
}

/// Newton's method of this test: central differences, steps cut but not damped, no look at signs.
fn newton(evaluate: impl Fn(WaveContact) -> Option<[f64; 2]>, start: WaveContact) -> Option<WaveContact> {
    let at = |half_width: f64, eccentricity: f64| evaluate(WaveContact { half_width, eccentricity });
    let (mut a, mut e) = (start.half_width, start.eccentricity);
    for _ in 0..30 {
        let here = at(a, e)?;
        let h = 1e-4 * a;
        let (wide, narrow, ahead, behind) = (at(a + h, e)?, at(a - h, e)?, at(a, e + h)?, at(a, e - h)?);
        let slope = |plus: [f64; 2], minus: [f64; 2], index: usize| (plus[index] - minus[index]) / (2.0 * h);
        let (aa, ae) = (slope(wide, narrow, 0), slope(ahead, behind, 0));
        let (ba, be) = (slope(wide, narrow, 1), slope(ahead, behind, 1));
        let determinant = aa * be - ae * ba;
        let (da, de) = ((here[1] * ae - here[0] * be) / determinant, (ba * here[0] - aa * here[1]) / determinant);
        a += da.clamp(-0.5 * a, 0.2);
        e += de.clamp(-0.2, 0.2);
        if da.abs().max(de.abs()) < 1e-13 {
            break;
        }
    }
    let last = at(a, e)?;
    (last[0].abs() <= 1e-10 && last[1].abs() <= 1e-10).then_some(WaveContact { half_width: a, eccentricity: e })
}

/// All roots of the two closures in a window of the edges, by sign changes on a grid.
fn all_roots(memory: &ContactMemory, adhesion: &WaveAdhesion, prescribed: Prescribed) -> Vec<WaveContact> {
    const ACROSS: usize = 72;
    const ALONG: usize = 80;
    let node = |row: usize, column: usize| WaveContact {
        half_width: (0.07 + 1.35 * row as f64 / ACROSS as f64).powi(2),
        eccentricity: 2.0 * (column as f64 / ALONG as f64 - 0.5),
    };
    let evaluate = |edges| closures(memory, adhesion, prescribed, edges).ok().map(|found| found.0);
    let grid: Vec<Option<[f64; 2]>> =
        (0..(ACROSS + 1) * (ALONG + 1)).into_par_iter().map(|index| evaluate(node(index / (ALONG + 1), index % (ALONG + 1)))).collect();
    let changes = |corners: &[[f64; 2]; 4], index: usize| {
        corners.iter().any(|corner| corner[index] > 0.0) && corners.iter().any(|corner| corner[index] < 0.0)
    };
    let mut starts = Vec::new();
    for row in 0..ACROSS {
        for column in 0..ALONG {
            let at = |down: usize, right: usize| grid[(row + down) * (ALONG + 1) + column + right];
            let (Some(first), Some(second), Some(third), Some(fourth)) = (at(0, 0), at(0, 1), at(1, 0), at(1, 1)) else { continue };
            let corners = [first, second, third, fourth];
            if changes(&corners, 0) && changes(&corners, 1) {
                let (low, high) = (node(row, column), node(row + 1, column + 1));
                starts.push(WaveContact {
                    half_width: 0.5 * (low.half_width + high.half_width),
                    eccentricity: 0.5 * (low.eccentricity + high.eccentricity),
                });
            }
        }
    }
    let found: Vec<WaveContact> = starts.par_iter().filter_map(|&start| newton(evaluate, start)).collect();
    let mut distinct: Vec<WaveContact> = Vec::new();
    for root in found {
        let near = |other: &WaveContact| {
            (other.half_width - root.half_width).abs() < 1e-6 && (other.eccentricity - root.eccentricity).abs() < 1e-6
        };
        if !distinct.iter().any(near) {
            distinct.push(root);
        }
    }
    distinct
}

/// The smallest gap over the largest, at 200 points.
fn smallest_gap(state: &ContactState) -> f64 {
    let width = 2.0 * (PI - state.contact().half_width);
    let gaps: Vec<f64> = (1..200)
        .map(|index| {
            let part = (0.5 * PI * f64::from(index) / 200.0).sin().powi(2);
            state.gap(state.behind_trailing(part * width).unwrap())
        })
        .collect();
    gaps.iter().copied().fold(f64::INFINITY, f64::min) / gaps.iter().map(|gap| gap.abs()).fold(0.0, f64::max)
}

#[test]
fn of_all_roots_of_the_two_closures_one_can_exist() {
    for (beta, ratio, work, pressure) in [(20.0, 0.3, 0.002, 0.1), (10.0, 3.0, 0.003, 0.2)] {
        let time = 0.2;
        let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * beta, time).unwrap();
        let adhesion = WaveAdhesion::even(work, 1e-3);
        let on_path = contact_at_rate(&material, ratio / time, Some(adhesion), Prescribed::MeanPressure(pressure), 1e-12).unwrap();
        let prescribed = Prescribed::Penetration(on_path.state.penetration());
        let memory = ContactMemory::new(&material, ratio / time).unwrap();
        let roots = all_roots(&memory, &adhesion, prescribed);
        println!("β = {beta}, ζ = {ratio}, Γ = {work}, Δ = {:.6}: {} roots", on_path.state.penetration(), roots.len());
        let (mut signs, mut admissible) = (Vec::new(), Vec::new());
        for root in &roots {
            let (residual, contacts) = closures(&memory, &adhesion, prescribed, *root).unwrap();
            let pulled = contacts.iter().all(|contact| contact.edge_amplitudes().0 < 0.0 && contact.edge_amplitudes().1 < 0.0);
            let gap = smallest_gap(&contacts[0]);
            let (trailing, leading) = contacts[0].edge_amplitudes();
            println!(
                "  a = {:.9}, e = {:+.9}: residuals {:+.0e} {:+.0e}, amplitudes {trailing:+.4} {leading:+.4}, smallest gap/largest {gap:+.2e}, {}",
                root.half_width,
                root.eccentricity,
                residual[0],
                residual[1],
                if pulled && gap > 0.0 { "can exist" } else { "cannot exist" }
            );
            signs.push((trailing < 0.0, leading < 0.0));
            if pulled && gap > 0.0 {
                admissible.push(*root);
            }
        }
        for pair in [(false, false), (false, true), (true, false), (true, true)] {
            assert!(signs.contains(&pair), "no root with the edges pulled {pair:?}: {signs:?}");
        }
        assert_eq!(admissible.len(), 1);
        let path = on_path.state.contact();
        assert!((admissible[0].half_width - path.half_width).abs() < 1e-9, "{admissible:?} {path:?}");
        assert!((admissible[0].eccentricity - path.eccentricity).abs() < 1e-9);
        // From each wrong root itself, and from beside it, the solver refuses or finds the one that can exist.
        for root in &roots {
            for (wider, ahead) in [(0.0, 0.0), (1e-3, 0.0), (-1e-3, 1e-3), (0.0, -1e-3)] {
                let start = WaveContact { half_width: root.half_width + wider, eccentricity: root.eccentricity + ahead };
                if let Ok(found) = contact_near(&memory, Some(adhesion), prescribed, start, 1e-10) {
                    assert!((found.state.contact().half_width - path.half_width).abs() < 1e-7, "a wrong root was returned: {root:?}");
                }
            }
        }
    }
}

/// What is said of the edges is the sign of the pressure beside each of the six: the contact and both moved ones, in all four quadrants of the edges.
#[test]
fn edges_are_pulled_where_the_pressure_beside_them_says_so() {
    let (time, ratio) = (0.2, 0.3);
    let material = PlaneMaterial::standard_solid(0.7e6, 0.7e6 * 20.0, time).unwrap();
    let adhesion = WaveAdhesion::even(0.002, 1e-3);
    let on_path = contact_at_rate(&material, ratio / time, Some(adhesion), Prescribed::MeanPressure(0.1), 1e-10).unwrap();
    let penetration = on_path.state.penetration();
    let memory = ContactMemory::new(&material, ratio / time).unwrap();
    let control = SlidingControl::Penetration(penetration);
    let balance = EdgeBalance::new(Arc::new(memory), Indenter::Wave, Some(adhesion), control, Resolution::Finest);
    // Singular as the inverse root of the distance: a millionth of the width is nearer than anything else that the pressure does.
    let tensile = |contact: &ContactState| {
        let near = 2e-6 * contact.contact().half_width;
        let behind = contact.pressure(contact.inside_trailing(near).unwrap());
        let ahead = contact.pressure(contact.inside_leading(near).unwrap());
        [behind < 0.0, ahead < 0.0]
    };
    let mut quadrants = [[0_u32; 2]; 2];
    for row in 0..16 {
        for column in 0..16 {
            let edges = WaveContact { half_width: 0.1 + 0.12 * f64::from(row), eccentricity: 0.08 * (f64::from(column) - 7.5) };
            let Ok(states) = balance.evaluate_at(edges, Prescribed::Penetration(penetration)) else { continue };
            let (trailing, leading) = states.moved.as_ref().unwrap();
            let six = [tensile(&states.state), tensile(trailing), tensile(leading)];
            let said = balance.admissibility(&states).unwrap().edges_pulled;
            assert_eq!(said, six.iter().flatten().all(|pulled| *pulled), "{edges:?}: {six:?}");
            // A pressed edge does the work of a pulled one; its residual has no zero.
            let residual = states.residual();
            for (edge, pulled) in six[0].into_iter().enumerate() {
                assert!(pulled || residual[edge] <= -1.0, "{edges:?}: {residual:?}, pulled {:?}", six[0]);
            }
            quadrants[usize::from(six[0][0])][usize::from(six[0][1])] += 1;
        }
    }
    println!("[trailing][leading] pressed and pulled: {quadrants:?}");
    assert!(quadrants.iter().flatten().all(|count| *count >= 5), "{quadrants:?}");
}
