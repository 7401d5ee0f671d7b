//! G(v) of a 12-term material on one core, beside the raw double integrals of the thesis, in one run.
//!
//! `cargo bench --bench steady_crack`. Prints medians over repeats, the ratio, and how far the two disagree. Times are printed, never
//! tested; work counters are tested elsewhere.
#![allow(clippy::unwrap_used)]

use std::hint::black_box;
use std::time::{Duration, Instant};
use viscotack::PlaneMaterial;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, at_speed};
use viscotack::material::{CreepTerm, RelaxationTerm};
use viscotack_verification::rivals::raw_crack_work::RawCrackWork;

const SPEEDS: usize = 100_000;
const RAW_SPEEDS: usize = 9;
const REPEATS: usize = 5;

/// Twelve terms over twelve decades, E0 = 1.1 MPa, E∞ = 1.9 GPa.
fn rubber() -> PlaneMaterial {
    let moduli = [0.22, 0.31, 0.45, 0.71, 1.3, 2.9, 8.1, 27.0, 96.0, 310.0, 690.0, 760.0];
    let terms: Vec<RelaxationTerm> =
        (0..12).zip(moduli).map(|(k, modulus)| RelaxationTerm { modulus: modulus * 1e6, relaxation_time: 10f64.powi(2 - k) }).collect();
    let by_relaxation = PlaneMaterial::from_relaxation(1.1e6, &terms).unwrap();
    // The opening crack reads the creep series: give it as exact.
    let creep: Vec<CreepTerm> = by_relaxation.creep_terms().to_vec();
    PlaneMaterial::from_creep(by_relaxation.glassy_modulus(), &creep, None).unwrap()
}

fn speeds(count: usize) -> Vec<f64> {
    (0..count).map(|index| 10f64.powf(-9.0 + 12.0 * index as f64 / (count - 1) as f64)).collect()
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

fn ratios(curve: &impl SteadyCurve, speeds: &[f64], tolerance: f64) -> (Vec<f64>, u64, u64) {
    let (mut points, mut kernels) = (0, 0);
    let values = speeds
        .iter()
        .map(|&speed| {
            let state = at_speed(curve, black_box(speed), tolerance).unwrap();
            points += state.curve_points;
            kernels += state.kernel_evaluations;
            state.energy_release_rate_ratio.unwrap().value
        })
        .collect();
    (values, points, kernels)
}

fn main() {
    let material = rubber();
    let process_zone = ProcessZone::Growing { cohesive_stress: 30e6, factor: std::f64::consts::FRAC_1_PI };
    let interface = Interface { work_of_adhesion: 60.0, process_zone, body: CrackBody::TwoHalves };
    println!("G(v) of a 12-term material, growing process zone, v from 1e-9 to 1e3 m/s, one core");
    println!("{:34} {:>10} {:>14} {:>12} {:>16} {:>14}", "method", "speeds", "per speed", "balances", "kernels/speed", "largest error");
    for (name, motion) in [("opening", Motion::Opening), ("closing", Motion::Closing)] {
        let curve = VirtualWork::new(&material, motion, interface).unwrap();
        let raw = RawCrackWork::new(&material, motion, interface, 1e-10).unwrap();
        let many = speeds(SPEEDS);
        let few = speeds(RAW_SPEEDS);
        let mut times = Vec::new();
        let mut counted = (0, 0);
        for _ in 0..REPEATS {
            let start = Instant::now();
            let (values, points, kernels) = ratios(&curve, &many, 1e-14);
            times.push(start.elapsed());
            black_box(values);
            counted = (points, kernels);
        }
        let ours = median(times) / SPEEDS as u32;
        let start = Instant::now();
        let (raw_values, raw_points, raw_kernels) = ratios(&raw, &few, 1e-9);
        let theirs = start.elapsed() / RAW_SPEEDS as u32;
        let (our_values, ..) = ratios(&curve, &few, 1e-14);
        let worst = raw_values.iter().zip(&our_values).map(|(raw, ours)| (raw / ours - 1.0).abs()).fold(0.0, f64::max);
        let print = |method: String, count: usize, time: Duration, points: u64, kernels: u64, error: String| {
            println!(
                "{method:34} {count:>10} {:>14} {:>12.1} {:>16.1} {error:>14}",
                format!("{time:.2?}"),
                points as f64 / count as f64,
                kernels as f64 / count as f64
            );
        };
        print(format!("{name}: collapsed (this program)"), SPEEDS, ours, counted.0, counted.1, "reference".into());
        print(format!("{name}: raw double integral"), RAW_SPEEDS, theirs, raw_points, raw_kernels, format!("{worst:.1e}"));
        println!("{name}: ratio {:.0}; 100 000 speeds take {:.2?}", theirs.as_secs_f64() / ours.as_secs_f64(), ours * SPEEDS as u32);
    }
}
