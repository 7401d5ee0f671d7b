//! Branches of adhesive sliding contacts: one of 200 points to 1e-8 with its turns and stability, one of twelve times, a hundred on one and on two threads, a scan of
//! every contact; and what the rival pays for as many contacts.
//!
//! `cargo bench --bench sliding_branches`. The rival is collocation with piecewise-constant pressure (the thesis's scheme at 100 elements, a few percent; it has no
//! branches: the time is that of its contacts alone). Times are printed, never tested.
#![allow(clippy::unwrap_used)]

use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;
use viscotack::PlaneMaterial;
use viscotack::material::CreepTerm;
use viscotack::sliding::branch::{BranchProblem, BranchStart, Scan, every_branch, trace};
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::steady::{SlidingControl, WaveAdhesion};
use viscotack_verification::rivals::sliding_collocation::{Layout, SlidingCollocation};

const ADHESION: WaveAdhesion = WaveAdhesion::even(0.003, 0.01);
const RATE: f64 = 0.03;
const REPEATS: usize = 5;

/// Seconds of the fastest of some runs, and its result.
fn timed<T>(repeats: usize, mut run: impl FnMut() -> T) -> (f64, T) {
    let mut best: Option<(f64, T)> = None;
    for _ in 0..repeats {
        let begin = Instant::now();
        let result = black_box(run());
        let spent = begin.elapsed().as_secs_f64();
        if best.as_ref().is_none_or(|(least, _)| spent < *least) {
            best = Some((spent, result));
        }
    }
    best.unwrap()
}

fn main() {
    let material = PlaneMaterial::standard_solid(1.0, 10.0, 1.0).unwrap();
    let problem = BranchProblem { points: 200, ..BranchProblem::loads(RATE, ADHESION, 1e-8) };
    let (seconds, branch) = timed(REPEATS, || trace(&material, &problem).unwrap());
    println!("one time, 200 points to 1e-8, turns and stability: {:.0} ms, {:?}", 1e3 * seconds, branch.work);
    let (bare, _) = timed(REPEATS, || trace(&material, &BranchProblem { points: 0, ..problem }).unwrap());
    println!("    the curve and its turns alone: {:.0} ms", 1e3 * bare);
    rival(&material, &branch.outline(), seconds);

    let terms: Vec<CreepTerm> =
        (0..12).map(|index| CreepTerm { compliance: (1.0 - 1.0 / 100.0) / 12.0, retardation_time: 10f64.powi(-index) }).collect();
    let twelve = PlaneMaterial::from_creep(100.0, &terms, None).unwrap();
    for points in [0, 200] {
        let problem = BranchProblem { points, ..BranchProblem::loads(1.0, ADHESION, 1e-8) };
        let (seconds, branch) = timed(1, || trace(&twelve, &problem).unwrap());
        println!("twelve times, {points} points: {seconds:.2} s, {:?}", branch.work);
    }

    let hundred: Vec<BranchProblem> = (0..100)
        .map(|index| BranchProblem { points: 20, ..BranchProblem::loads(10f64.powf(-3.0 + 0.06 * f64::from(index)), ADHESION, 1e-8) })
        .collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let before = processor_seconds();
        let (seconds, done) = timed(1, || pool.install(|| hundred.par_iter().filter(|problem| trace(&material, problem).is_ok()).count()));
        (seconds, processor_seconds().zip(before).map(|(after, before)| after - before), done)
    };
    let ((one, of_one, done), (two, of_two, _)) = (on(1), on(2));
    println!("{done} of 100 branches of 20 points: {one:.2} s on one thread, {two:.2} s on two: {:.2} times as fast", one / two);
    if let Some((of_one, of_two)) = of_one.zip(of_two) {
        println!(
            "    processor time {of_one:.2} s and {of_two:.2} s: two idle cores would make them {:.2} times as fast",
            2.0 * of_one / of_two
        );
    }

    let speeds =
        BranchProblem::speeds(SlidingControl::MeanPressure(-0.0365), [1e-4, 1e4], BranchStart::Slow, WaveAdhesion::even(0.002, 0.03), 1e-8);
    let (seconds, found) = timed(1, || every_branch(&material, &speeds, Scan { half_widths: 60, parameters: 60 }).unwrap());
    println!(
        "every branch of a held load over eight decades of speed, 3600 half-widths and speeds: {seconds:.2} s, {} branches",
        found.branches.len()
    );
}

/// Processor time of this process where the system tells it: on a busy machine the only fair comparison.
fn processor_seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = text.rsplit(')').next()?.split_whitespace().collect();
    let ticks: f64 = [11, 12].into_iter().filter_map(|index| fields.get(index)?.parse::<f64>().ok()).sum();
    Some(ticks / 100.0)
}

/// The rival's time for contacts along the same branch.
fn rival(material: &PlaneMaterial, outline: &[[f64; 4]], ours: f64) {
    let memory = ContactMemory::new(material, RATE).unwrap();
    let scheme = SlidingCollocation::new(memory.kernel(), Layout::Mapped, 100, 2.0).unwrap();
    let begin = Instant::now();
    let (mut solved, mut asked) = (0, 0);
    for &[half_width, eccentricity, pressure, _] in outline.iter().filter(|point| point[0] > 0.1 && point[0] < 2.0).step_by(6) {
        asked += 1;
        let start = WaveContact { half_width: 0.99 * half_width, eccentricity: eccentricity + 0.005 };
        solved += usize::from(scheme.equilibrium(&ADHESION, Prescribed::MeanPressure(pressure), start, 1e-8).is_ok());
    }
    let each = begin.elapsed().as_secs_f64() / f64::from(asked.max(1));
    println!(
        "    the rival at 100 elements: {:.0} ms a contact ({solved} of {asked} found), {:.1} s for 200 of them, {:.0} times ours",
        1e3 * each,
        200.0 * each,
        200.0 * each / ours
    );
}
