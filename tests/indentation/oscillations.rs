//! Oscillations of an indenter (thesis Sec 4.9 and beyond).
//!
//! Source: a rim that holds the edge makes a flat punch of any linear solid: F = 2aE*(ω)Δ for an oscillation that has settled. For one term the
//! start is known too: F/2a = ∫R(t − t′)dΔ.
//! Goal: work, stiffness, phase and extremes of cycles, sweeps, ramps beneath, stationarity, and the bound on memory.
//! Oracle: E*(ω) from the sums of the relaxation terms, written out here; elementary integrals.
//! Tolerance: 1e-8 of the stiffness asked of the integration (its order is six in the step; a tolerance of 1e-9 takes about 300 steps a cycle).
#![allow(clippy::unwrap_used, clippy::float_cmp, missing_docs)]

use crate::support;

use std::f64::consts::{PI, TAU};
use support::indentation::{SPHERE, WORK, ZONE, rubber};
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, FrequencySweep, History, IndentationProblem, Oscillation, PathPoint, Profile, integrate, run};
use viscotack::material::RelaxationTerm;

fn terms(count: i32) -> PlaneMaterial {
    // Not of unit moduli, and spread over decades about a time of 0.02 s.
    let term = |k: i32| RelaxationTerm { modulus: 3.1e6 / f64::from(count), relaxation_time: 0.02 * 10f64.powi(k - count / 2) };
    PlaneMaterial::from_relaxation(0.7e6, &(0..count).map(term).collect::<Vec<_>>()).unwrap()
}

/// E' and E'' at an angular frequency.
fn complex(material: &PlaneMaterial, omega: f64) -> (f64, f64) {
    material.relaxation_terms().iter().fold((0.7e6, 0.0), |(storage, loss), term| {
        let x = omega * term.relaxation_time;
        (storage + term.modulus * x * x / (1.0 + x * x), loss + term.modulus * x / (1.0 + x * x))
    })
}

fn punch(history: History, accuracy: f64) -> IndentationProblem {
    IndentationProblem { accuracy, ..IndentationProblem::new(Profile::FlatPunch { radius: 2e-3 }, None, history) }.relaxed()
}

/// A punch that stays pressed: complex stiffness 2aE*(ω) after the memory of the start has gone.
#[test]
fn a_punch_has_the_complex_stiffness_of_its_solid() {
    for count in [1, 2, 12] {
        let material = terms(count);
        let longest = material.creep_terms().iter().fold(0.0f64, |most, term| most.max(term.retardation_time));
        for omega in [0.5, 47.0] {
            let frequency = omega / TAU;
            // 12 decades of times never settle at once: what is left of the start decays as the slowest relaxation time goes by.
            let slowest = material.relaxation_terms().iter().fold(0.0f64, |most, term| most.max(term.relaxation_time));
            let cycles = if count == 12 { 6.0 } else { (22.0 * slowest * frequency).ceil().max(2.0) };
            let history = History::penetration(4e-5).oscillate(Oscillation::steady(1e-6, frequency), cycles / frequency);
            let trace = integrate(&material, &punch(history, 1e-6), 1e-9).unwrap();
            let last = trace.cycles.last().unwrap();
            let (storage, loss) = complex(&material, omega);
            let (mut exact_storage, mut exact_loss) = (4e-3 * storage, 4e-3 * loss);
            if count == 12 {
                // The transient of a sinus that starts at rest: −ωρE/(1 + ω²ρ²) e^{−t/ρ}, its share of the last cycle's fundamental added.
                (exact_storage, exact_loss) = with_transient(&material, omega, cycles);
            }
            let size = exact_storage.hypot(exact_loss);
            println!(
                "{count} terms, ω = {omega}: {} steps, {} cycles, storage {:e} off {:.1e}, loss {:e} off {:.1e}; longest τ {longest:e}",
                trace.work.steps,
                trace.cycles.len(),
                last.storage_stiffness,
                (last.storage_stiffness - exact_storage) / size,
                last.loss_stiffness,
                (last.loss_stiffness - exact_loss) / size
            );
            assert!((last.storage_stiffness - exact_storage).abs() < 1e-8 * size);
            assert!((last.loss_stiffness - exact_loss).abs() < 1e-8 * size);
            assert!((last.phase - exact_loss.atan2(exact_storage)).abs() < 1e-8);
            if count < 12 {
                // Loss of a cycle: π times the loss stiffness times the square of the amplitude.
                assert!((last.work / (PI * exact_loss * 1e-12) - 1.0).abs() < 1e-7);
            }
        }
    }
}

/// Stiffness of the last of so many cycles, with the transients of the start and the straight line between both ends taken off as the cycle integrals do.
fn with_transient(material: &PlaneMaterial, omega: f64, cycles: f64) -> (f64, f64) {
    let period = TAU / omega;
    let (start, end) = ((cycles - 1.0) * period, cycles * period);
    let transient = |t: f64| {
        material
            .relaxation_terms()
            .iter()
            .map(|term| {
                let x = omega * term.relaxation_time;
                -term.modulus * x / (1.0 + x * x) * (-t / term.relaxation_time).exp()
            })
            .sum::<f64>()
    };
    // By fine Simpson panels, graded in no way: the last cycle is smooth for terms slower than a hundredth of it, and faster ones are gone.
    let parts = 20_000;
    let width = period / f64::from(parts);
    let mut moments = [0.0, 0.0];
    for k in 0..parts {
        for (x, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
            let t = start + (f64::from(k) + x) * width;
            let phase = omega * t;
            let value = weight / 6.0 * width * omega * transient(t);
            moments[0] += value * phase.sin();
            moments[1] += value * phase.cos();
        }
    }
    let rise = transient(end) - transient(start);
    let (storage, loss) = complex(material, omega);
    (4e-3 * (storage + (moments[0] + rise) / PI), 4e-3 * (loss + moments[1] / PI))
}

/// Sweeps: the frequency of each cycle, and the stiffness at slow sweeps, up and down.
#[test]
fn swept_frequencies_find_the_stiffness_of_each() {
    let material = terms(1);
    for (from, to) in [(0.5, 50.0), (50.0, 0.5)] {
        for sweep in [FrequencySweep::Linear, FrequencySweep::Logarithmic] {
            let oscillation = Oscillation::swept(1e-6, from, to, sweep);
            let history = History::penetration(4e-5).oscillate(oscillation, 20.0);
            let trace = integrate(&material, &punch(history, 1e-6), 1e-5).unwrap();
            let mut worst: f64 = 0.0;
            for cycle in trace.cycles.iter().skip(3) {
                let omega = TAU / (cycle.end - cycle.start);
                let (storage, loss) = complex(&material, omega);
                // A frequency that changes within a cycle is not one frequency: an error of the order of that change.
                let next = |time: f64| oscillation.frequency_at(time, 20.0);
                let change = (next(cycle.end) / next(cycle.start)).ln().abs();
                let off = (cycle.storage_stiffness / 4e-3 - storage).hypot(cycle.loss_stiffness / 4e-3 - loss) / storage.hypot(loss);
                worst = worst.max(off / change.max(1e-3));
            }
            let whole = trace.cycles.last().unwrap().number;
            println!(
                "{from} to {to} {sweep:?}: {whole} cycles, {} steps, error over change of frequency at most {worst:.2}",
                trace.work.steps
            );
            assert!(worst < 1.0);
            assert_eq!(whole, oscillation.cycles_at(20.0, 20.0).floor() as u64);
        }
    }
}

/// On a ramp, under a force, and in a frame: one stiffness.
#[test]
fn ramps_forces_and_frames_tell_one_stiffness() {
    let material = terms(2);
    let omega = 9.0;
    let (storage, loss) = complex(&material, omega);
    let oscillation = Oscillation::steady(1e-6, omega / TAU);
    let force = Oscillation::steady(1e-2, omega / TAU);
    let held = 4e-3 * 0.7e6 * 4e-5;
    let cases = [
        ("ramp", punch(History::penetration(4e-5).ramp_oscillating(5e-5, oscillation, 20.0), 1e-6)),
        // The straight line beneath is another part of sin φ and cos φ where the phase begins at another place.
        (
            "ramp from a phase",
            punch(History::penetration(4e-5).ramp_oscillating(5e-5, Oscillation { phase: 1.1, ..oscillation }, 20.0), 1e-6),
        ),
        ("force", punch(History::force(held).oscillate(force, 20.0), 1e-6)),
        (
            "frame",
            IndentationProblem {
                frame_stiffness: Some(5e3),
                ..punch(History::frame(4e-5 + held / 5e3).oscillate(oscillation, 20.0), 1e-6)
            },
        ),
    ];
    for (name, problem) in cases {
        let trace = integrate(&material, &problem, 1e-7).unwrap();
        let last = trace.cycles.last().unwrap();
        let size = 4e-3 * storage.hypot(loss);
        let off = (last.storage_stiffness - 4e-3 * storage).hypot(last.loss_stiffness - 4e-3 * loss) / size;
        println!("{name}: {} steps, off {off:.1e}", trace.work.steps);
        assert!(off < 1e-6);
    }
}

/// A segment that oscillates until stationary ends early, in both integrations at the same cycle, with what it would have had later.
#[test]
fn stationary_cycles_end_a_segment() {
    let material = terms(1);
    let oscillation = Oscillation { until_stationary: true, ..Oscillation::steady(1e-6, 3.0) };
    let history = History::penetration(4e-5).oscillate(oscillation, 500.0).hold(1.0);
    let found = run(&material, &punch(history, 1e-4)).unwrap();
    let last = found.cycles.last().unwrap();
    let (storage, loss) = complex(&material, TAU * 3.0);
    println!("{} cycles, storage {:?} loss {:?}, drift {:e}", last.number, last.storage_stiffness, last.loss_stiffness, last.drift);
    assert!(last.number < 30 && found.reached);
    assert!((last.storage_stiffness.value - 4e-3 * storage).abs() <= last.storage_stiffness.error.max(1e-4 * 4e-3 * storage));
    assert!((last.loss_stiffness.value - 4e-3 * loss).abs() <= last.loss_stiffness.error.max(1e-4 * 4e-3 * storage));
    let end = found.instants.last().unwrap().time;
    assert!((end - (f64::from(last.number as u32) / 3.0 + 1.0)).abs() < 1e-9);
}

/// An adhesive sphere that oscillates: cycles agree between integrations, the work of a cycle is what is dissipated, and nothing drifts.
#[test]
fn an_adhesive_sphere_oscillates() {
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    let history = History::penetration(0.02).oscillate(Oscillation::steady(0.004, 0.05), 300.0);
    let problem = IndentationProblem { energies: true, ..IndentationProblem::new(SPHERE, adhesion, history) }.relaxed();
    let found = run(&rubber(), &problem).unwrap();
    let last = found.cycles.last().unwrap();
    println!(
        "{} steps, cycle work {:?}, radius {:?}, drift {:e}",
        found.integration.work.steps, last.work, last.contact_radius, last.drift
    );
    let balance = found.balance_defect.unwrap();
    println!("balance {balance:e}");
    assert!(balance < 1e-4);
    // ∮F dΔ over the last cycle against the energies of the path itself: work in = dissipated − tip work, stored energy returns.
    let at = |time: f64| found.integration.path.iter().rfind(|point| point.time <= time * (1.0 + 1e-12)).unwrap().energies.unwrap();
    let (start, end) = (at(last.start), at(last.end));
    let work = end.external_work - start.external_work;
    println!("∮F dΔ {:e} by energies {work:e}", last.work.value);
    assert!((last.work.value / work - 1.0).abs() < 1e-3);
    assert!(last.drift < 1e-2);
    assert!(found.cycles.iter().all(|cycle| cycle.work.error.is_finite()));
}

/// Every extreme and sum of a cycle of a sphere that sticks, and slips in and out: from the points of a tighter integration alone, by straight lines.
#[test]
fn cycles_are_what_the_path_says() {
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    for (oscillation, start) in
        [(Oscillation::steady(0.004, 0.05), 0.02), (Oscillation::swept(0.003, 0.02, 0.2, FrequencySweep::Logarithmic), 0.025)]
    {
        let history = History::penetration(start).oscillate(oscillation, 100.0);
        let problem = IndentationProblem::new(SPHERE, adhesion, history).relaxed();
        let (measured, fine) = (integrate(&rubber(), &problem, 1e-3).unwrap(), integrate(&rubber(), &problem, 1e-5).unwrap());
        assert!(measured.cycles.len() >= 4);
        let mut worst = [0.0_f64; 5];
        for cycle in &measured.cycles {
            let within: Vec<_> =
                fine.path.iter().filter(|point| point.time >= cycle.start - 1e-9 && point.time <= cycle.end + 1e-9).collect();
            let range = |of: &dyn Fn(usize) -> f64| {
                (0..within.len()).map(of).fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
            };
            let depth = range(&|k| within[k].penetration);
            let force = range(&|k| within[k].force);
            let radius = range(&|k| within[k].contact_radius);
            // ∮F dΔ and ∫F e^{−iφ} dφ by the trapezoid, the line between both ends taken off.
            let mut work = 0.0;
            let (mut cosine, mut sine) = ([0.0_f64; 2], [0.0_f64; 2]);
            let phase = |time: f64| TAU * oscillation.cycles_at(time, 100.0);
            for pair in within.windows(2) {
                work += 0.5 * (pair[0].force + pair[1].force) * (pair[1].penetration - pair[0].penetration);
                let (from, to) = (phase(pair[0].time), phase(pair[1].time));
                let quantities: [fn(&PathPoint) -> f64; 2] = [|point| point.penetration, |point| point.force];
                for (sum, of) in quantities.into_iter().enumerate() {
                    let line = |time: f64| {
                        let (first, last) = (within[0], within[within.len() - 1]);
                        of(first) + (of(last) - of(first)) * (phase(time) - phase(first.time)) / (phase(last.time) - phase(first.time))
                    };
                    let (one, two) = (of(pair[0]) - line(pair[0].time), of(pair[1]) - line(pair[1].time));
                    sine[sum] += 0.5 * (to - from) * (one * from.sin() + two * to.sin()) / PI;
                    cosine[sum] += 0.5 * (to - from) * (one * from.cos() + two * to.cos()) / PI;
                }
            }
            // F̂/Δ̂ with x = sine·sin φ + cosine·cos φ as the imaginary part of (sine + i cosine)e^{iφ}.
            let square = sine[0] * sine[0] + cosine[0] * cosine[0];
            let storage = (sine[1] * sine[0] + cosine[1] * cosine[0]) / square;
            let loss = (cosine[1] * sine[0] - sine[1] * cosine[0]) / square;
            let size = storage.hypot(loss);
            let extremes = |found: [f64; 2], seen: [f64; 2]| {
                (found[0] - seen[0]).abs().max((found[1] - seen[1]).abs()) / seen[0].abs().max(seen[1].abs())
            };
            let off = [
                extremes(cycle.penetration, depth),
                extremes(cycle.force, force),
                extremes(cycle.contact_radius, radius),
                (cycle.work - work).abs() / (0.25 * (depth[1] - depth[0]) * (force[1] - force[0])),
                (cycle.storage_stiffness - storage).hypot(cycle.loss_stiffness - loss) / size,
            ];
            for (most, value) in worst.iter_mut().zip(off) {
                *most = most.max(value);
            }
        }
        println!("{} points a cycle; Δ, F, a, work, stiffness off {worst:?}", fine.path.len() / measured.cycles.len());
        // Between points an angle h apart a sinus goes h²/8 of its amplitude beyond them, and a trapezoid misses h²/12 of it; the work is a difference of
        // halves. What the cycles' own integration leaves, at 1e-3 of its path, is below 5e-4.
        let step = fine.path.windows(2).fold(0.0_f64, |most, pair| {
            most.max(TAU * (oscillation.cycles_at(pair[1].time, 100.0) - oscillation.cycles_at(pair[0].time, 100.0)))
        });
        let bound = 5e-4 + 0.25 * step * step;
        println!("  largest step {step:.3} rad, bound {bound:.1e}");
        assert!(bound < 4e-3);
        assert!(worst.iter().enumerate().all(|(which, off)| *off < if which == 3 { 2.0 * bound } else { bound }), "{worst:?}");
    }
}
