//! Source: thesis Sec 5.4, Eqs 5.49, 5.66, 5.68 (delay), 5.54 with 5.67 (trajectory) for a constant load.
//!
//! Goal: the delay to rounding right up to both limits of Eq 5.68; the trajectory of a one-term solid against the exact solution of its
//! linear delay equation; the order of the stepper; the kink on its line; the speed that growth tends to.
//!
//! ```text
//!   ½K²J(t_d) = Δγ          dw/dq = (w(q) − w(q−1))/c,  w = e^{t/τ},  c = (1 − 1/k)/(1 − 1/β)
//! ```
//! Parameters: the creep solids of `steady_crack_materials.csv` (1 to 20 terms, β from 2 to 1e6, one viscous, two unit systems); K² from 1e-12 of its
//! range above the relaxed limit to 1e-11 below the glassy one.
//!
//! Oracle: `reference_data/delayed_fracture.csv` (mpmath: bisection of the creep series; Laplace transform of the delay equation); the steady opening
//! theory, which shares nothing with the stepper but the material.
//!
//! Tolerance: 1e-14 for delays times the condition of the creep sum in its own given doubles; 1e-10 for trajectories at 256 lines, which
//! leave errors of third order; 1e-10 for late speeds. Error bounds must hold throughout.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::support;
use crate::support::physics;

use physics::relative;
use support::{Row, reference_materials, reference_rows};
use viscotack::PlaneMaterial;
use viscotack::crack::delayed::trajectory::tends_to;
use viscotack::crack::delayed::{EventKind, GrowthProblem, LoadHistory, Onset, Regime, Resolution, onset, regime, trajectory};
use viscotack::crack::{CrackBody, Interface, ProcessZone};

const ZONE: f64 = 3.7e-6;

fn problem<'a>(material: &'a PlaneMaterial, row: &Row) -> GrowthProblem<'a> {
    with_work(material, row.number("work_of_adhesion"))
}

fn with_work(material: &PlaneMaterial, work_of_adhesion: f64) -> GrowthProblem<'_> {
    let process_zone = ProcessZone::Constant { length: ZONE };
    GrowthProblem::new(material, Interface { work_of_adhesion, process_zone, body: CrackBody::AgainstRigid }, 0.0).unwrap()
}

#[test]
fn delays_to_rounding_right_up_to_both_limits() {
    let materials = reference_materials();
    let (mut worst, mut count, mut speeds) = (0.0_f64, 0, 0.0_f64);
    for row in reference_rows("delayed_fracture.csv") {
        let quantity = row.text("quantity").to_owned();
        if quantity != "delay" && quantity != "initial_speed" {
            continue;
        }
        let material = &materials[row.text("material")];
        let problem = problem(material, &row);
        let intensity = row.number("intensity");
        let place = format!("{} {quantity}", row.text("case"));
        assert_eq!(regime(&problem, intensity).unwrap().regime, Regime::Delayed, "{place}");
        let Onset::After { delay, initial_speed, .. } = onset(&problem, intensity).unwrap() else { panic!("{place}") };
        let (found, expected) =
            if quantity == "delay" { (delay, row.number("value")) } else { (initial_speed, row.number("value") * ZONE) };
        let error = relative(found.value, expected);
        assert!(error * expected <= found.error + 0.5 * f64::EPSILON * expected, "{place}: {error:e} above {:e}", found.relative_error());
        if quantity == "delay" {
            assert!(error <= 1e-14, "{place}: {:e} instead of {expected:e}, {error:e}", found.value);
            worst = worst.max(error);
        } else {
            speeds = speeds.max(error);
        }
        count += 1;
    }
    println!("{count} values, worst delay {worst:.1e}, worst first speed {speeds:.1e}");
    assert!(count >= 150);
}

#[test]
fn one_term_trajectory_is_the_exact_series_to_1e10() {
    let materials = reference_materials();
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in reference_rows("delayed_fracture.csv").iter().filter(|row| row.text("quantity") == "time_at") {
        let material = &materials[row.text("material")];
        let problem = problem(material, row);
        let (time, expected) = (row.number("value"), row.number("place"));
        let history = LoadHistory::constant(row.number("intensity")).unwrap();
        let resolution = Resolution { lines_per_zone: 256, ..Resolution::default() };
        let found = trajectory(&problem, &history, &[time], resolution).unwrap();
        let growth = found.samples[0].growth.unwrap();
        let error = (growth.value / ZONE - expected).abs() / expected;
        let place = format!("{} at {expected}", row.text("case"));
        // The time itself is known to half an ulp, which moves the tip by v·t·ε.
        let speed = found.samples[0].speed.unwrap();
        let input = 0.5 * f64::EPSILON * time * speed.value;
        assert!(error <= 1e-10, "{place}: off by {error:e}");
        assert!((growth.value - expected * ZONE).abs() <= growth.error + input, "{place}: {error:e} above {:e}", growth.relative_error());
        worst = worst.max(error);
        count += 1;
    }
    println!("{count} places, worst {worst:.1e}");
    assert!(count >= 24);
}

#[test]
fn speeds_along_the_way_are_those_of_the_delay_equation() {
    let materials = reference_materials();
    let rows = reference_rows("delayed_fracture.csv");
    let (mut worst, mut count) = (0.0_f64, 0);
    for pair in rows.windows(2).filter(|pair| pair[0].text("quantity") == "time_at" && pair[1].text("quantity") == "speed_at") {
        if pair[0].text("place") == "1.0" {
            continue;
        }
        let material = &materials[pair[0].text("material")];
        let problem = problem(material, &pair[0]);
        let history = LoadHistory::constant(pair[0].number("intensity")).unwrap();
        let found = trajectory(&problem, &history, &[pair[0].number("value")], Resolution::default()).unwrap();
        let speed = found.samples[0].speed.unwrap();
        let expected = pair[1].number("value") * ZONE;
        let error = relative(speed.value, expected);
        let place = format!("{} at {}", pair[0].text("case"), pair[0].text("place"));
        assert!(error < 3e-7, "{place}: {error:e}");
        worst = worst.max(error);
        count += 1;
    }
    println!("{count} speeds, worst {worst:.1e}");
    assert!(count >= 21);
}

#[test]
fn late_speed_is_the_steady_opening_speed_for_1_2_and_12_terms() {
    let materials = reference_materials();
    let mut worst = 0.0_f64;
    let mut cases = Vec::new();
    for name in ["creep_1_beta2", "creep_1_beta1e6"] {
        if let Some(material) = materials.get(name) {
            cases.push((name.to_owned(), material));
        }
    }
    for (name, material) in &materials {
        let terms = material.creep_terms().len();
        if (terms == 2 || terms == 12) && material.relaxed_modulus() > 0.0 {
            cases.push((name.clone(), material));
        }
    }
    assert!(cases.iter().any(|case| case.1.creep_terms().len() == 12) && cases.iter().any(|case| case.1.creep_terms().len() == 2));
    for (name, material) in cases {
        let problem = with_work(material, 0.17);
        for part in [0.02_f64, 0.4, 0.9] {
            let (low, high) = (problem.relaxed_limit(), problem.glassy_limit());
            let intensity = low * (high / low).powf(part);
            let steady = tends_to(&problem, intensity, 1e-15).unwrap();
            let Onset::After { delay, .. } = onset(&problem, intensity).unwrap() else { panic!("{name}") };
            let until = delay.value + 200.0 * steady.crossing_time;
            let history = LoadHistory::constant(intensity).unwrap();
            let resolution = Resolution { lines_per_zone: 32, ..Resolution::default() };
            let found = trajectory(&problem, &history, &[until], resolution).unwrap();
            let speed = found.samples[0].speed.unwrap();
            let error = relative(speed.value, steady.speed.value);
            println!("{name}, {} terms, part {part}: {error:.1e}, {} steps", material.creep_terms().len(), found.work.steps);
            assert!(error <= 1e-10, "{name} at {part}: {:e} instead of {:e}", speed.value, steady.speed.value);
            worst = worst.max(error);
        }
    }
    println!("worst {worst:.1e}");
}

#[test]
fn kink_is_landed_on_and_both_speeds_are_right() {
    let material = PlaneMaterial::standard_solid(6.5e5, 1.9e7, 0.37).unwrap();
    let problem = with_work(&material, 0.23);
    let intensity = problem.relaxed_limit() * 2.1;
    let history = LoadHistory::constant(intensity).unwrap();
    let Onset::After { delay, initial_speed, .. } = onset(&problem, intensity).unwrap() else { panic!() };
    let resolution = Resolution { lines_per_zone: 128, ..Resolution::default() };
    let found = trajectory(&problem, &history, &[4.0 * delay.value + 3.0], resolution).unwrap();
    let EventKind::GrowthBegins { speed } = found.events[0].kind else { panic!("{:?}", found.events) };
    assert!(relative(speed.value, initial_speed.value) < 1e-14 && relative(found.events[0].time.value, delay.value) < 1e-14);
    let EventKind::Kink { speed_before, speed_after } = found.events[1].kind else { panic!("{:?}", found.events) };
    assert!(relative(found.events[1].growth.value, ZONE) < 1e-14, "{:?}", found.events[1]);
    // w(q) = 1 + (1/c − 1)e^{q/c} up to the kink, where w(q − 1) jumps from 1 to 1/c.
    let k = 2.1 * 2.1;
    let c: f64 = (1.0 - 1.0 / k) / (1.0 - 6.5e5 / 1.9e7);
    let w = 1.0 + (1.0 / c - 1.0) * (1.0 / c).exp();
    let speeds = [1.0, 1.0 / c].map(|before| ZONE * w * c / ((w - before) * 0.37));
    println!("kink: {speed_before:?} {speed_after:?}, exact {speeds:?}");
    assert!(relative(speed_before.value, speeds[0]) < 1e-7 && relative(speed_after.value, speeds[1]) < 1e-7);
    assert!(relative(found.events[1].time.value, 0.37 * w.ln()) < 1e-9);
    assert!(speeds[1] / speeds[0] > 1.2, "the kink is one");
}

#[test]
fn stepper_is_of_third_order() {
    let materials = reference_materials();
    let rows = reference_rows("delayed_fracture.csv");
    for row in rows.iter().filter(|row| row.text("quantity") == "time_at" && ["1.5", "3.0"].contains(&row.text("place"))) {
        let problem = problem(&materials[row.text("material")], row);
        let history = LoadHistory::constant(row.number("intensity")).unwrap();
        let errors = [16, 32, 64].map(|lines_per_zone| {
            let resolution = Resolution { lines_per_zone, ..Resolution::default() };
            let found = trajectory(&problem, &history, &[row.number("value")], resolution).unwrap();
            let growth = found.samples[0].growth.unwrap();
            assert!((growth.value / ZONE - row.number("place")).abs() * ZONE <= growth.error, "{growth:?}");
            (growth.value / ZONE - row.number("place")).abs()
        });
        println!("{} at {}: {errors:?}", row.text("case"), row.text("place"));
        if errors[2] > 1e-12 {
            let orders = [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()];
            assert!(orders[1] > 2.5, "{orders:?} of {errors:?}");
        }
    }
}
