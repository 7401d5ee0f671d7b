//! Source: theory of the sliding closures (thesis Secs 3.2, 3.3): both closures are quadratic in the amplitude of their edge.
//!
//! Goal: each contact has roots that satisfy the equations to rounding and cannot exist (a pressed edge, interpenetrating faces). From
//! 1,000 random starts at fixed penetration, with bulk losses, every state that is returned is admissible and is the same one.
//!
//! Parameters: β = 20, ζ = 0.3, Γ = 0.002, δ = 1e-3, Δ of a contact reached along the path in speed.
//!
//! Oracle: the state reached by continuation from the elastic contact; the signs of the edge amplitudes; the gap.
//!
//! Tolerance: the same edges to 1e-7 (Newton to 1e-10); refusals for unphysical roots must occur, or the test would show nothing.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use rayon::prelude::*;
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::equilibrium::{WaveAdhesion, equilibrium};
use viscotack::sliding::speed_path::adhesive_contact;
use viscotack::{Material, Refusal};

const STARTS: u32 = 1000;

#[test]
fn random_starts_never_return_an_unphysical_root() {
    let (time, ratio) = (0.2, 0.3);
    let material = Material::standard_solid(0.7e6, 0.7e6 * 20.0, time).unwrap();
    let adhesion = WaveAdhesion { reduced_work: 0.002, trailing_zone: 1e-3, leading_zone: 1e-3 };
    let on_path = adhesive_contact(&material, ratio / time, &adhesion, Prescribed::MeanPressure(0.1), 1e-12).unwrap().contact;
    let prescribed = Prescribed::Penetration(on_path.state.penetration());
    let memory = ContactMemory::new(&material, ratio / time).unwrap();
    // A fixed sequence of pseudo-random numbers (an additive lattice of irrational steps covers the square evenly).
    let solve = |index: u32| {
        let (first, second) = ((f64::from(index) * 0.754_877_666_246_692_7).fract(), (f64::from(index) * 0.569_840_290_998_053_2).fract());
        let start = WaveContact { half_width: 0.02 + 3.0 * first, eccentricity: 1.6 * (second - 0.5) };
        equilibrium(&memory, &adhesion, prescribed, start, 1e-10)
    };
    let (mut found, mut unphysical, mut lost) = (Vec::new(), 0, 0);
    for result in (1..=STARTS).into_par_iter().map(solve).collect::<Vec<_>>() {
        match result {
            Ok(state) => {
                assert!(state.admissibility.holds());
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
    assert!(unphysical > 0, "no unphysical root was met: the test shows nothing");
}
