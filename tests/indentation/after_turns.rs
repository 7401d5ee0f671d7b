//! Source: theory of the line contact: a point of the line that was entered at t₁ and has been in contact since carries
//! Q = E∞*(…) = E*(t − t₁)(Δ(t₁) − f(s)) + ∫ E*(t − t′) Δ′(t′) dt′, and K = −Q(a)/√(πa).
//!
//! Goal: what is known of an edge just after it turned, where all that it meets was left a moment ago; and folds so flat that rounding, or what joining
//! panels changes, could move the edge to and fro.
//!
//! Parameters: spheres under a force that falls before the edge turns: two solids of two terms, in Pa, m, s, moduli and sizes a thousandfold apart; quick
//! retractions of soft solids (β = 9 and 20) from long contact.
//!
//! Oracle: K by the integral above over Δ(t) of the integration's own path, from the time at which the edge passed the same place on its way out: it holds no
//! state of the line and no panel. Events: a contact that is pulled off quickly is lost once.
//!
//! Tolerance: K to 1e-6 (the integral interpolates a path of tolerance 1e-7 by cubics; 7e-8 is the largest difference seen); before panels were graded towards a turn it
//! was 3e-3 off.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, EventKind, History, IndentationProblem, PathPoint, Profile, Trace, integrate};
use viscotack::material::RelaxationTerm;

/// The cubic through four points around the piece `index..index + 1`, at `x`.
fn cubic(points: &[(f64, f64)], index: usize, x: f64) -> f64 {
    let first = index.saturating_sub(1).min(points.len().saturating_sub(4));
    let four = &points[first..(first + 4).min(points.len())];
    four.iter()
        .enumerate()
        .map(|(k, (own, value))| {
            value * four.iter().enumerate().filter(|(l, _)| *l != k).map(|(_, (other, _))| (x - other) / (own - other)).product::<f64>()
        })
        .sum()
}

/// K at the end of a path that went out to a turn and came back, all after the last corner of the history.
fn by_residence(material: &PlaneMaterial, radius: f64, path: &[PathPoint]) -> Option<f64> {
    let last = path.last()?;
    let places: Vec<(f64, f64)> = path.iter().map(|point| (point.time, point.contact_radius)).collect();
    let depths: Vec<(f64, f64)> = path.iter().map(|point| (point.time, point.penetration)).collect();
    let entered = places.windows(2).position(|pair| pair[0].1 <= last.contact_radius && pair[1].1 > last.contact_radius)?;
    let (mut low, mut high) = (places[entered].0, places[entered + 1].0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if cubic(&places, entered, middle) < last.contact_radius { low = middle } else { high = middle }
    }
    let modulus = |time: f64| {
        let terms = material.relaxation_terms().iter();
        material.relaxed_modulus() + terms.map(|term| term.modulus * (-time / term.relaxation_time).exp()).sum::<f64>()
    };
    let start = cubic(&depths, entered, low) - last.contact_radius.powi(2) / radius;
    let mut load = modulus(last.time - low) * start;
    for index in entered..depths.len() - 1 {
        let (from, to) = (depths[index].0.max(low), depths[index + 1].0);
        // Midpoints of a hundred parts, with the rise of each part.
        let parts = 100;
        let place = |k: usize| from + (to - from) * k as f64 / f64::from(parts);
        for k in 0..parts as usize {
            let rise = cubic(&depths, index, place(k + 1)) - cubic(&depths, index, place(k));
            load += modulus(last.time - 0.5 * (place(k) + place(k + 1))) * rise;
        }
    }
    Some(-load / (std::f64::consts::PI * last.contact_radius).sqrt())
}

/// Instants of the way back, each against its integral; how many there were.
fn way_back(name: &str, material: &PlaneMaterial, problem: &IndentationProblem, radius: f64) -> usize {
    let trace = integrate(material, problem, 1e-7).unwrap();
    let corner = problem.history.segments[0].duration;
    let mut seen = 0;
    for &kept in &trace.kept {
        let point = trace.path[kept];
        let first = trace.path.iter().rposition(|point| point.time <= corner).unwrap();
        let Some(found) = trace.path.get(first..=kept) else { continue };
        let widest = found.iter().fold(0.0f64, |most, point| most.max(point.contact_radius));
        if point.contact_radius >= widest {
            continue;
        }
        let Some(exact) = by_residence(material, radius, found) else { continue };
        let off = point.stress_intensity_factor / exact - 1.0;
        println!(
            "{name}: t = {:e}, 1 − a/a_turn = {:.1e}, K {:e}, off by {off:.1e}",
            point.time,
            1.0 - point.contact_radius / widest,
            exact
        );
        assert!(off.abs() < 1e-6, "{name} at {:e}", point.time);
        seen += 1;
    }
    seen
}

fn two_terms(relaxed: f64, moduli: [f64; 2], times: [f64; 2]) -> PlaneMaterial {
    let term = |k: usize| RelaxationTerm { modulus: moduli[k], relaxation_time: times[k] };
    PlaneMaterial::from_relaxation(relaxed, &[term(0), term(1)]).unwrap()
}

#[test]
fn edge_intensity_just_after_a_turn() {
    let material = two_terms(5.97e6, [1.47e7, 6.36e8], [1.5e-3, 3.4e-6]);
    let history = History::force(0.0).ramp(38.0, 2.164e-6).ramp(0.0, 4.329e-6);
    let adhesion = Some(Adhesion { work_of_adhesion: 76.0, process_zone: 2.25e-4 });
    let problem = IndentationProblem {
        instants_per_segment: 400,
        ..IndentationProblem::new(Profile::Paraboloid { radius: 0.0276 }, adhesion, history)
    };
    let mut seen = way_back("solid of steel's stiffness", &material, &problem, 0.0276);
    // The same shape of solid, a thousand times softer and larger, and slower.
    let material = two_terms(4.0e3, [1.1e4, 2.2e5], [0.9, 2.0e-3]);
    let history = History::force(0.0).ramp(0.9e3, 1.3e-3).ramp(0.0, 2.5e-3);
    let adhesion = Some(Adhesion { work_of_adhesion: 12.0, process_zone: 0.011 });
    let problem =
        IndentationProblem { instants_per_segment: 100, ..IndentationProblem::new(Profile::Paraboloid { radius: 1.7 }, adhesion, history) };
    seen += way_back("soft solid", &material, &problem, 1.7);
    assert!(seen >= 6, "{seen}");
}

fn lost_once(name: &str, trace: &Trace, most: u64) {
    let events: Vec<EventKind> = trace.events.iter().map(|event| event.kind).filter(|kind| *kind != EventKind::JumpIn).collect();
    println!("{name}: {} steps, {events:?}", trace.work.steps);
    assert_eq!(events, [EventKind::Detachment], "{name}");
    assert!(trace.work.steps < most, "{name}: {}", trace.work.steps);
}

#[test]
fn quick_retractions_are_lost_once_at_any_tolerance() {
    let material =
        PlaneMaterial::from_relaxation(85.759_463_522_668_8, &[RelaxationTerm { modulus: 689.516_886, relaxation_time: 0.034_291_548 }])
            .unwrap();
    let history = History::penetration(4.892_439_62e-7).ramp(2.446_219_81e-7, 1.400_003_81e-5);
    let adhesion = Some(Adhesion { work_of_adhesion: 1.457_923_95e-7, process_zone: 2.722_195_95e-8 });
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.535_268_49e-4 }, adhesion, history).relaxed();
    for tolerance in [0.03, 3e-3, 3e-4, 3e-5, 3e-7, 3e-9] {
        let trace = integrate(&material, &problem, tolerance).unwrap();
        lost_once(&format!("relaxed, tolerance {tolerance:e}"), &trace, 12_000);
    }
    let material =
        PlaneMaterial::from_relaxation(0.013_422_5, &[RelaxationTerm { modulus: 0.120_955_304_454, relaxation_time: 1.355_295_035_16 }])
            .unwrap();
    let history = History::penetration(0.0)
        .ramp(0.220_428_762_782_517_77, 0.011_708_218_046_759_741)
        .hold(3.448_963_237_643_414_7)
        .ramp(0.066_128_628_834_755_33, 0.008_195_752_632_731_819);
    let adhesion = Some(Adhesion { work_of_adhesion: 7.036_031_643_717_781e-5, process_zone: 0.016_084_778_045_700_285 });
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 43.635_136_983_429_11 }, adhesion, history);
    for tolerance in [0.03, 3e-3, 3e-4, 3e-5, 3e-6, 3e-7, 1e-8] {
        let trace = integrate(&material, &problem, tolerance).unwrap();
        lost_once(&format!("after a dwell, tolerance {tolerance:e}"), &trace, 12_000);
    }
}
