//! Steady adhesive sliding on a wave: this program beside collocation with piecewise-constant pressure, on one core, in one run.
//!
//! `cargo bench --bench steady_sliding`; `FINEST=200 cargo bench …` leaves the finer meshes out (all of them take some fifteen minutes).
//! Every method finds both edges of the same states from the same start with the same Newton's method, and gives the same eight numbers:
//! a, e, Δ, p̄, friction stress, U, G₁, G₂. Error of a state: the largest |difference| from the reference over max(|value|, 1). The reference is
//! this program's `steady_sliding` at 1e-10, which the extrapolated collocation confirms in `tests/sliding/sec_3_rivals.rs`.
//! Times are printed, never tested.
#![allow(clippy::unwrap_used)]

use std::hint::black_box;
use std::time::{Duration, Instant};
use viscotack::material::CreepTerm;
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::steady::{
    Indenter, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, Start, WaveAdhesion, steady_sliding, steady_sliding_near,
};
use viscotack::{PlaneMaterial, Refusal};
use viscotack_verification::rivals::sliding_collocation::richardson::extrapolated;
use viscotack_verification::rivals::sliding_collocation::{Layout, SlidingCollocation};

const ADHESION: WaveAdhesion = WaveAdhesion::even(0.002, 1e-3);
const BETAS: [f64; 2] = [5.0, 25.0];
const RATIOS: [f64; 5] = [0.003, 0.01, 0.03, 0.1, 0.3];
const PRESSURES: [f64; 2] = [0.0, 0.05];
const MESHES: [usize; 4] = [100, 200, 400, 800];
const TOLERANCE: f64 = 1e-8;
const REPEATS: usize = 5;

/// a, e, Δ, p̄, friction stress, U, G₁, G₂.
type Numbers = [f64; 8];

struct State {
    material: PlaneMaterial,
    memory: ContactMemory,
    problem: SlidingProblem<'static>,
    prescribed: Prescribed,
    start: WaveContact,
    reference: Numbers,
}

/// ζ = τ at the rate one.
fn state(beta: f64, ratio: f64, pressure: f64) -> Option<State> {
    let material = PlaneMaterial::standard_solid(1.1e6, 1.1e6 * beta, ratio).unwrap();
    let problem = SlidingProblem {
        rate: 1.0,
        indenter: Indenter::Wave,
        adhesion: Some(ADHESION),
        work_by_speed: None,
        control: SlidingControl::MeanPressure(pressure),
        accuracy: 1e-10,
    };
    let Ok(SlidingOutcome::Partial(found)) = steady_sliding(&material, &problem) else {
        println!("left out, no partial contact: β = {beta}, ζ = {ratio}, p̄ = {pressure}");
        return None;
    };
    let reference = numbers(&found.values)?;
    // One percent off: the warm start of a sweep.
    let start = WaveContact { half_width: 0.99 * reference[0], eccentricity: reference[1] + 0.005 };
    let memory = ContactMemory::new(&material, 1.0).unwrap();
    Some(State { material, memory, problem, prescribed: Prescribed::MeanPressure(pressure), start, reference })
}

fn numbers(values: &PartialValues) -> Option<Numbers> {
    let adhesive = values.adhesion?;
    Some([
        values.half_width.value,
        values.eccentricity.value,
        values.penetration.value,
        values.mean_pressure.value,
        values.friction_stress.value,
        values.interface_work.value,
        adhesive.trailing_release.value,
        adhesive.leading_release.value,
    ])
}

/// From the start of the rivals, with error bounds and a check of admissibility; the accuracy asked for is `TOLERANCE`.
fn ours(state: &State) -> Option<Numbers> {
    let problem = SlidingProblem { accuracy: TOLERANCE, ..state.problem };
    let start = Start::at(state.start.half_width, state.start.eccentricity);
    numbers(&steady_sliding_near(&state.material, &problem, &start).ok()?.values)
}

fn collocated(state: &State, layout: Layout, elements: usize, density: f64) -> Result<Numbers, Refusal> {
    let scheme = SlidingCollocation::new(state.memory.kernel(), layout, elements, density)?;
    let found = scheme.equilibrium(&ADHESION, state.prescribed, state.start, TOLERANCE)?;
    let contact = &found.closures.contact;
    Ok([
        found.edges.half_width,
        found.edges.eccentricity,
        contact.penetration(),
        contact.mean_pressure(),
        contact.friction_stress(),
        contact.interface_work(),
        found.trailing_release,
        found.leading_release,
    ])
}

fn error(numbers: &Numbers, reference: &Numbers) -> f64 {
    numbers.iter().zip(reference).map(|(value, exact)| (value - exact).abs() / exact.abs().max(1.0)).fold(0.0, f64::max)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Seconds and result of the fastest of `repeats`.
fn timed<T>(repeats: usize, mut run: impl FnMut() -> T) -> (f64, T) {
    let mut best = (Duration::MAX, None);
    for _ in 0..repeats {
        let begin = Instant::now();
        let result = black_box(run());
        let spent = begin.elapsed();
        if spent < best.0 {
            best = (spent, Some(result));
        }
    }
    (best.0.as_secs_f64(), best.1.unwrap())
}

struct Row {
    name: String,
    seconds: f64,
    error: f64,
}

/// Prints and returns the medians of one method; states without a result count as failures, not as errors.
fn row(name: String, results: &[(f64, Option<f64>)]) -> Row {
    let failures = results.iter().filter(|(_, error)| error.is_none()).count();
    let seconds = median(results.iter().map(|&(seconds, _)| seconds).collect());
    let error = median(results.iter().filter_map(|&(_, error)| error).collect());
    let worst = results.iter().filter_map(|&(_, error)| error).fold(0.0, f64::max);
    println!("{name:44} {:>12.3} ms {error:>12.1e} {worst:>12.1e} {failures:>9}", 1e3 * seconds);
    Row { name, seconds, error }
}

/// A solid with twelve terms over twelve decades, at speeds where four, six and eight of them are slower than the passage.
fn twelve_terms() -> PlaneMaterial {
    let terms: Vec<CreepTerm> =
        (0..12).map(|index| CreepTerm { compliance: (1.0 - 1.0 / 30.0) / 1.1e6 / 12.0, retardation_time: 10f64.powi(-index) }).collect();
    PlaneMaterial::from_creep(1.1e6 * 30.0, &terms, None).unwrap()
}

/// Warm states of one and of twelve terms: from the solution at a speed 2 % lower.
fn many_terms() {
    println!("warm states, from the solution at a speed 2 % lower, and cold ones; accuracy {TOLERANCE:e}");
    let one = PlaneMaterial::standard_solid(1.1e6, 1.1e6 * 30.0, 1.0).unwrap();
    for (name, material, speeds) in [("one term", one, [1e-3, 0.1, 3.0]), ("twelve terms", twelve_terms(), [1e4, 1e6, 1e8])] {
        for rate in speeds {
            let problem = SlidingProblem {
                rate,
                indenter: Indenter::Wave,
                adhesion: Some(ADHESION),
                work_by_speed: None,
                control: SlidingControl::MeanPressure(0.1),
                accuracy: TOLERANCE,
            };
            let (cold, found) = timed(REPEATS, || steady_sliding(&material, &problem));
            let Ok(SlidingOutcome::Partial(found)) = found else {
                println!("{name:14} kv = {rate:e}: no partial contact");
                continue;
            };
            let next = SlidingProblem { rate: 1.02 * rate, ..problem };
            let (warm, near) = timed(20, || steady_sliding_near(&material, &next, &found.start));
            let near = near.unwrap();
            println!(
                "{name:14} kv = {rate:7.0e}: warm {:>8.3} ms ({} balances, error {:.0e}), cold {:>8.3} ms ({} balances)",
                1e3 * warm,
                near.work.closure_evaluations,
                near.certificate.accuracy,
                1e3 * cold,
                found.work.closure_evaluations
            );
        }
    }
}

/// Sweeps over eight decades of speed, state by state, as a scene runs them.
fn sweeps() {
    let material = PlaneMaterial::standard_solid(1.1e6, 1.1e7, 1.0).unwrap();
    for points in [100, 200, 400] {
        let (seconds, solved) = timed(1, || {
            (0..points)
                .filter(|&index| {
                    let problem = SlidingProblem {
                        rate: 10f64.powf(-4.0 + 8.0 * f64::from(index) / f64::from(points - 1)),
                        indenter: Indenter::Wave,
                        adhesion: Some(ADHESION),
                        work_by_speed: None,
                        control: SlidingControl::MeanPressure(0.05),
                        accuracy: TOLERANCE,
                    };
                    matches!(steady_sliding(&material, &problem), Ok(SlidingOutcome::Partial(_)))
                })
                .count()
        });
        println!(
            "sweep of {points} speeds over eight decades: {:.3} s, {:.3} ms a state, {solved} partial contacts",
            seconds,
            1e3 * seconds / f64::from(points)
        );
    }
}

fn main() {
    let finest = std::env::var("FINEST").ok().and_then(|text| text.parse().ok()).unwrap_or(800);
    let meshes: Vec<usize> = MESHES.into_iter().filter(|&elements| elements <= finest).collect();
    let mut states = Vec::new();
    for beta in BETAS {
        for ratio in RATIOS {
            states.extend(PRESSURES.into_iter().filter_map(|pressure| state(beta, ratio, pressure)));
        }
    }
    println!(
        "{} states: β = {BETAS:?}, ζ = {RATIOS:?}, p̄ = {PRESSURES:?}, Γ = 0.002, δ = 0.001; one core, Newton to {TOLERANCE:e}",
        states.len()
    );
    println!("{:44} {:>15} {:>12} {:>12} {:>9}", "method", "median time", "median error", "worst error", "failures");
    let warm: Vec<(f64, Option<f64>)> = states
        .iter()
        .map(|state| {
            let (seconds, found) = timed(REPEATS, || ours(state));
            (seconds, found.map(|numbers| error(&numbers, &state.reference)))
        })
        .collect();
    let cold: Vec<(f64, Option<f64>)> =
        states.iter().map(|state| (timed(1, || steady_sliding(&state.material, &state.problem)).0, Some(0.0))).collect();
    let us = row("this program, from the start".into(), &warm);
    let us_cold = row("this program, steady_sliding (the reference)".into(), &cold);
    many_terms();
    sweeps();
    let mut rivals = Vec::new();
    for (name, density, aligned) in [("thesis, n = 1", 1.0, false), ("thesis, n = 3", 3.0, false), ("window-aligned, n = 3", 3.0, true)] {
        let mut table: Vec<Vec<(f64, Option<Numbers>)>> = Vec::new();
        for &elements in &meshes {
            let layout = if aligned { Layout::WindowAligned { window_elements: elements / 4 } } else { Layout::Mapped };
            let found: Vec<(f64, Option<Numbers>)> = states
                .iter()
                .map(|state| {
                    let (seconds, found) = timed(1, || collocated(state, layout, elements, density));
                    (seconds, found.ok())
                })
                .collect();
            let results: Vec<(f64, Option<f64>)> = found
                .iter()
                .zip(&states)
                .map(|((seconds, numbers), state)| (*seconds, numbers.map(|numbers| error(&numbers, &state.reference))))
                .collect();
            rivals.push(row(format!("{name}, N = {elements}"), &results));
            table.push(found);
        }
        if aligned && table.len() > 1 {
            let results: Vec<(f64, Option<f64>)> = states
                .iter()
                .enumerate()
                .map(|(index, state)| {
                    let levels: Vec<&(f64, Option<Numbers>)> = table.iter().filter_map(|level| level.get(index)).collect();
                    let seconds = levels.iter().map(|level| level.0).sum();
                    let numbers: Option<Vec<Numbers>> = levels.iter().map(|level| level.1).collect();
                    let best = numbers.map(|rows| {
                        let at = |column: usize| extrapolated(&rows.iter().map(|row| row[column]).collect::<Vec<f64>>(), &[3.0, 3.0, 4.0]);
                        error(&std::array::from_fn(at), &state.reference)
                    });
                    (seconds, best)
                })
                .collect();
            rivals.push(row(format!("{name}, extrapolated from all of these"), &results));
        }
    }
    for (prefix, what) in [("thesis", "the thesis's scheme"), ("window", "any collocation")] {
        let best = rivals.iter().filter(|rival| rival.name.starts_with(prefix)).min_by(|one, other| one.error.total_cmp(&other.error));
        if let Some(best) = best {
            println!(
                "best median error of {what}: {:.1e} ({}), {:.1} times our time from the same start, {:.1} times that of a cold start",
                best.error,
                best.name,
                best.seconds / us.seconds,
                best.seconds / us_cold.seconds
            );
        }
    }
}
