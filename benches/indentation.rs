//! Time of indentations: an approach and retraction at two accuracies beside the thesis's dense scheme, steps and terms: `cargo bench --bench indentation`.
//!
//! The case is the thesis's Fig 4.3 (γ̃ = 1.6e-4, δ̃ = 0.013, β = 10, V·ρ/R = 2e-3, Δ̃ up to 0.032), one thread. The rival is run to 1e-2 of the largest force
//! against the core, as printed (each trial edge its own dense system) and with factors kept. Wall-clock of the best of three runs (rivals: of one).
#![allow(clippy::unwrap_used, clippy::print_stdout)]

use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;
use viscotack::PlaneMaterial;
use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, Trace, integrate, run};
use viscotack::material::RelaxationTerm;
use viscotack_verification::rivals::annulus_indentation::{AnnulusScheme, AnnulusStart};

const WORK: f64 = 1.6e-4 * PI;
const ZONE: f64 = 0.013;
const SPEED: f64 = 2e-3;
const TOP: f64 = 0.032;
const END: f64 = -0.02;

/// The best of several runs (ms).
fn best<T>(times: u32, mut job: impl FnMut() -> T) -> (f64, T) {
    let mut least = f64::INFINITY;
    let mut last = None;
    for _ in 0..times {
        let start = Instant::now();
        let found = black_box(job());
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
        last = Some(found);
    }
    (least, last.unwrap())
}

/// Largest difference of force and radius at the instants that both keep, over their largest values.
fn difference(trace: &Trace, truth: &Trace) -> f64 {
    let [_, force, radius, _] = truth.summary.scales;
    let difference = |(&one, &other): (&usize, &usize)| {
        let (one, other) = (trace.path[one], truth.path[other]);
        ((one.force - other.force).abs() / force).max((one.contact_radius - other.contact_radius).abs() / radius)
    };
    assert_eq!(trace.kept.len(), truth.kept.len());
    trace.kept.iter().zip(&truth.kept).map(difference).fold(0.0, f64::max)
}

fn cycle(accuracy: f64) -> IndentationProblem {
    let history = History::penetration(0.0).at_speed(TOP, SPEED).at_speed(END, SPEED);
    let adhesion = Some(Adhesion { work_of_adhesion: WORK, process_zone: ZONE });
    let problem = IndentationProblem::new(Profile::Paraboloid { radius: 1.0 }, adhesion, history);
    IndentationProblem { accuracy, instants_per_segment: 4, ..problem }
}

/// n terms, a decade apart, that stiffen tenfold together; one of them at the reference time.
fn terms(count: i32) -> PlaneMaterial {
    let term =
        |index: i32| RelaxationTerm { modulus: 9.0 / f64::from(count), relaxation_time: 10.0_f64.powf(0.5 * f64::from(count / 2 - index)) };
    PlaneMaterial::from_relaxation(1.0, &(0..count).map(term).collect::<Vec<_>>()).unwrap()
}

fn main() {
    let rubber = PlaneMaterial::standard_solid(1.0, 10.0, 10.0).unwrap();
    println!("approach and retraction at V·ρ/R = {SPEED:e}");
    let mut core = Vec::new();
    let mut exact = f64::NAN;
    for accuracy in [1e-2, 1e-4, 1e-6] {
        let (time, solution) = best(3, || run(&rubber, &cycle(accuracy)).unwrap());
        let tension = solution.pull_off_force().unwrap();
        println!(
            "  core at {accuracy:e}: {time:.2} ms, {} steps, {} balances, {} updates, F_off {:.8e} ± {:.1e}, reached: {}",
            solution.work.steps,
            solution.work.closure_evaluations,
            solution.work.history_updates,
            tension.value,
            tension.error,
            solution.reached
        );
        exact = tension.value;
        core.push(time);
    }
    let truth = integrate(&rubber, &cycle(1e-8), 1e-8).unwrap();
    for tolerance in [1e-1, 1e-2, 1e-4, 1e-6] {
        let (time, trace) = best(3, || integrate(&rubber, &cycle(tolerance), tolerance).unwrap());
        println!(
            "  one integration without bounds at {tolerance:e}: {time:.2} ms, {} steps, {} balances; force and radius off by {:.1e} of the largest",
            trace.work.steps,
            trace.work.closure_evaluations,
            difference(&trace, &truth)
        );
    }
    let leg = TOP / SPEED;
    let corners = [(0.0, 0.0), (leg, TOP), (leg + (TOP - END) / SPEED, END)];
    for keep_factors in [true, false] {
        for elements_per_zone in [4, 8] {
            let scheme = AnnulusScheme {
                sphere_radius: 1.0,
                relaxed_modulus: 1.0,
                glassy_modulus: 10.0,
                retardation_time: 10.0,
                work_of_adhesion: WORK,
                process_zone: ZONE,
                elements_per_zone,
                time_step: leg / (75.0 * elements_per_zone as f64),
                keep_factors,
            };
            let (time, path) = best(1, || scheme.run(AnnulusStart::Untouched, &corners).unwrap());
            let tension = path.points.iter().map(|point| -point.force).fold(0.0, f64::max);
            let error = (tension / exact - 1.0).abs();
            let way = if keep_factors { "factors kept" } else { "as printed" };
            let ratio = |index: usize| core.get(index).map_or(f64::NAN, |core| time / core);
            println!(
                "  dense annuli, {way}, {elements_per_zone} a zone: {time:.0} ms, {} systems, F_off off by {error:.1e}; over the core at 1e-2, 1e-4, 1e-6: {:.0}, {:.0}, {:.1}",
                path.solutions,
                ratio(0),
                ratio(1),
                ratio(2)
            );
        }
    }
    println!("terms, at 1e-4: time over steps and terms");
    for count in [1, 2, 4, 8, 16] {
        let material = terms(count);
        let (time, solution) = best(3, || run(&material, &cycle(1e-4)).unwrap());
        let steps = solution.work.steps as f64;
        println!(
            "  {count:2} terms: {time:8.2} ms, {steps:5.0} steps, {:.1} µs a step, {:.2} µs a step and term",
            1e3 * time / steps,
            1e3 * time / steps / f64::from(count)
        );
    }
    println!("steps, one term: time against the length of the history (cycles in a row)");
    for cycles in [1_i32, 2, 4, 8] {
        let mut problem = cycle(1e-4);
        problem.history = (0..cycles).fold(History::penetration(0.0), |history, _| history.at_speed(TOP, SPEED).at_speed(0.015, SPEED));
        let (time, solution) = best(3, || run(&rubber, &problem).unwrap());
        println!(
            "  {cycles} cycles: {time:8.2} ms, {} steps, {:.1} µs a step",
            solution.work.steps,
            1e3 * time / solution.work.steps as f64
        );
    }
}
