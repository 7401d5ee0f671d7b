//! Adhesive sphere and adhesive wave against values of 50 digits.
//!
//! Source: `reference_data/elastic.csv`, written by `verification/references/elastic.py` (mpmath, every value computed at 42 and at 60 digits).
//! Goal: the inverses (contact size for a given force, pressure or penetration), the extrema and the folds, close to the folds, at
//! narrow contacts and at thin gaps, in two unit scales.
//! Parameters: 2 spheres, 4 waves (α = 0.003, 0.13, 0.74, 0.83); see the columns.
//! Oracle: for the sphere the stationarity of the energy, with no equilibrium equation; for the wave bisection of the printed relation and of
//! its numerical derivative; for the fields quadrature of the logarithmic kernel.
//! Tolerance: the state's own `relative_error` (which must therefore be honest), and that bound itself must be close to 1e-15 wherever
//! the distance from the folds allows it. Worst figures are printed with `--nocapture`.
#![allow(clippy::unwrap_used, clippy::panic)]

use sha2::{Digest, Sha256};
use std::path::Path;
use viscotack::elastic::johnson_wave::WaveBranch;
use viscotack::elastic::westergaard_wave::WaveState;
use viscotack::elastic::{Control, EquilibriumBranch, JkrSphere, JohnsonWave, WestergaardWave};

struct Row {
    problem: String,
    asked: String,
    branch: String,
    input: Vec<f64>,
    value: f64,
}

fn rows() -> Vec<Row> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("reference_data/elastic.csv")).unwrap();
    let body_start = text.find("problem,").unwrap();
    let (header, body) = text.split_at(body_start);
    let hash: String = Sha256::digest(body.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
    assert!(header.contains(&format!("# sha256: {hash}")), "the reference file was edited by hand");
    csv::Reader::from_reader(body.as_bytes())
        .records()
        .map(|record| {
            let record = record.unwrap();
            assert!(record[10].parse::<u32>().unwrap() >= 30, "a reference value has fewer than 30 confirmed digits");
            Row {
                problem: record[0].into(),
                asked: record[1].into(),
                branch: record[2].into(),
                input: (3..8).filter_map(|i| record[i].parse().ok()).collect(),
                value: record[8].parse().unwrap(),
            }
        })
        .collect()
}

/// Checks one value against its own bound; returns (error, bound), both relative.
fn assess(row: &Row, computed: f64, bound: f64) -> (f64, f64) {
    let error = ((computed - row.value) / row.value).abs();
    assert!(
        error <= bound,
        "{} {} {} {:?}: {computed:e} against {:e}, error {error:e} above its bound {bound:e}",
        row.problem,
        row.asked,
        row.branch,
        row.input,
        row.value
    );
    (error, bound)
}

#[test]
fn sphere_inverses_agree_with_the_stationary_energy() {
    let (mut worst_far, mut worst_near, mut count) = (0.0_f64, 0.0_f64, 0);
    for row in rows().iter().filter(|row| row.problem == "jkr") {
        let sphere = JkrSphere::new(row.input[0], row.input[1], row.input[2]).unwrap();
        let branch = if row.branch == "stable" { EquilibriumBranch::Stable } else { EquilibriumBranch::Unstable };
        let (state, fold) = if row.asked == "contact_radius_by_force" {
            (sphere.state_by_force(row.input[3], branch).unwrap(), sphere.pull_off(Control::Load).unwrap().force)
        } else {
            (sphere.state_by_penetration(row.input[3], branch).unwrap(), sphere.pull_off(Control::Penetration).unwrap().penetration)
        };
        let (error, bound) = assess(row, state.contact_radius, state.relative_error);
        let distance = (1.0 - row.input[3] / fold).abs();
        // The bound may not be a blanket: within a factor of the conditioning 1e-16/√distance of the fold.
        assert!(bound < 4e-15 + 2e-15 / distance.sqrt(), "bound {bound:e} at a distance {distance:e} from the fold");
        if distance > 0.2 {
            worst_far = worst_far.max(error);
        } else {
            worst_near = worst_near.max(error * distance.sqrt());
        }
        count += 1;
    }
    println!("sphere, {count} values: worst error {worst_far:.1e} away from folds, {worst_near:.1e}/sqrt(distance) near them");
    assert_eq!(count, 64);
    assert!(worst_far < 2e-15 && worst_near < 1e-15);
}

#[test]
fn wave_inverses_agree_with_bisection() {
    let (mut worst, mut worst_ratio, mut count) = (0.0_f64, 0.0_f64, 0);
    for row in rows().iter().filter(|row| row.problem == "wave" && row.asked.contains("_by_")) {
        let wave = adhesive_wave(row);
        let imposed = row.input[4];
        let state: WaveState = match (row.asked.ends_with("penetration"), row.branch.as_str()) {
            (true, "stable") => wave.state_by_penetration(imposed, EquilibriumBranch::Stable),
            (true, "unstable") => wave.state_by_penetration(imposed, EquilibriumBranch::Unstable),
            (false, "stable") => wave.state_by_mean_pressure(imposed, WaveBranch::Stable),
            (false, "narrow") => wave.state_by_mean_pressure(imposed, WaveBranch::Narrow),
            (false, "wide") => wave.state_by_mean_pressure(imposed, WaveBranch::Wide),
            _ => panic!("unknown branch {}", row.branch),
        }
        .unwrap();
        let width = if row.asked.starts_with("gap") { state.gap_half_width } else { state.contact_half_width };
        let (error, bound) = assess(row, width, state.relative_error);
        assert!(bound < 1e-7, "{} {:?}: bound {bound:e}", row.asked, row.input);
        if bound < 1e-13 {
            worst = worst.max(error);
        }
        worst_ratio = worst_ratio.max(error / bound);
        count += 1;
    }
    println!("wave, {count} values: worst error {worst:.1e} where the bound is below 1e-13; error/bound up to {worst_ratio:.2}");
    assert_eq!(count, 132);
    assert!(worst < 2e-14);
    // At least one case comes within a factor 100 of its bound: the bound is not a blanket.
    assert!(worst_ratio > 0.01);
}

#[test]
fn wave_extrema_agree_with_bisection_of_the_derivative() {
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in rows().iter().filter(|row| row.problem == "wave" && row.asked.contains("_at_")) {
        let wave = adhesive_wave(row);
        let state = if row.asked.ends_with("pull_off") {
            wave.pull_off(Control::Load)
        } else if row.asked.ends_with("snap_in") {
            wave.snap_in()
        } else {
            wave.pull_off(Control::Penetration)
        }
        .unwrap();
        let value = match row.asked.split("_at_").next().unwrap() {
            "pressure" => state.mean_pressure,
            "penetration" => state.penetration,
            _ => state.contact_half_width,
        };
        worst = worst.max(assess(row, value, 3e-15).0);
        count += 1;
    }
    println!("extrema, {count} values: worst error {worst:.1e}");
    assert_eq!(count, 24);
}

#[test]
fn wave_displacement_and_gap_agree_with_the_kernel() {
    let (mut worst, mut count) = (0.0_f64, 0);
    for row in rows().iter().filter(|row| row.problem == "field") {
        let wave = adhesive_wave(row);
        let (half_width, position) = (row.input[1] / 5.0, row.input[4]);
        let penetration = wave.state_by_contact_half_width(half_width).unwrap().penetration;
        let plain = wave.without_adhesion();
        let profile = -2.0 * plain.amplitude() * (0.5 * plain.wavenumber() * position).sin().powi(2) + penetration;
        let surface = profile + wave.gap(half_width, position).unwrap();
        let error = ((surface - row.value) / plain.amplitude()).abs();
        assert!(error < 2e-15, "{:?}: surface {surface:e} against {:e}", row.input, row.value);
        assert_eq!(row.branch == "gap", wave.gap(half_width, position).unwrap() > 0.0);
        worst = worst.max(error);
        count += 1;
    }
    println!("fields, {count} values: worst error {worst:.1e} of the amplitude");
    assert_eq!(count, 21);
}

fn adhesive_wave(row: &Row) -> JohnsonWave {
    JohnsonWave::new(WestergaardWave::new(row.input[0], row.input[1], row.input[2]).unwrap(), row.input[3]).unwrap()
}
