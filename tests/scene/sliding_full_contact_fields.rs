//! The fields of a full contact of a wave.
//!
//! Source: a half-plane under the displacement Λ cos kx that moves at v: each term of the creep is a first-order lag at ω = kv, J(iω) in closed form.
//! Goal: a scene in full contact that asks for fields has them: the wave of the pressure, its lag behind the sliding, the surface.
//! Parameters: both directions of sliding, one and two terms, reduced and SI units with a modulus that is not one.
//! Oracle: 1/J(iω), written here; the partial contact that is almost full, solved by the edges.
//! Tolerance: the stated bounds and rounding; the almost full contact within the width of its gap.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::path::Path;
use viscotack::Estimate;
use viscotack_program::outcome::{Outcome, Row};
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};

fn solved(text: &str) -> Outcome {
    let document = Document::parse("scene.toml", text.to_owned(), Path::new(".")).unwrap();
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    plan::run(&document, &scene, Vec::new(), None, &|_| {}).unwrap()
}

/// E'/E0 and E''/E0 of creep fractions f_j and times τ_j.
fn modulus(stiffening: f64, terms: &[(f64, f64)], omega: f64) -> (f64, f64) {
    let (mut real, mut imaginary) = (1.0 / stiffening, 0.0);
    for (fraction, time) in terms {
        let part = fraction * (1.0 - 1.0 / stiffening) / (1.0 + (omega * time).powi(2));
        real += part;
        imaginary -= part * omega * time;
    }
    let square = real * real + imaginary * imaginary;
    (real / square, -imaginary / square)
}

fn points(row: &Row) -> Vec<(f64, [Estimate; 3])> {
    row.fields.iter().map(|point| (point.place, [0, 1, 2].map(|k| point.values[k]))).collect()
}

fn reduced(speed: f64, mean: f64, points: u32) -> Outcome {
    solved(&format!(
        "units = \"reduced\"\n[material]\nglassy_modulus = 10\ncreep = [{{ fraction = 1, retardation_time = 1 }}]\n[sliding]\ncontacts = [\"adhesiveless\"]\nspeed = {speed}\nmean_pressure = {mean}\n[sliding.wave]\n[fields]\npoints = {points}\n"
    ))
}

#[test]
fn the_pressure_is_the_complex_modulus_times_the_wave() {
    for speed in [0.3, -0.3, 4.0] {
        let outcome = reduced(speed, 12.0, 37);
        let row = &outcome.rows[0];
        let (storage, loss) = modulus(10.0, &[(1.0, 1.0)], speed.abs());
        let found = points(row);
        assert_eq!(found.len(), 37);
        let mut friction = 0.0;
        for (x, [pressure, gap, displacement]) in &found {
            // What lies ahead of a crest, in the direction of sliding, is pressed harder.
            let expected = 12.0 + storage * x.cos() + loss * speed.signum() * x.sin();
            assert!((pressure.value - expected).abs() <= pressure.error + 1e-13, "{speed} {x}: {pressure:?} {expected}");
            assert!((displacement.value - x.cos()).abs() <= displacement.error + 1e-15, "{x}: {displacement:?}");
            assert!(gap.value == 0.0 && pressure.error > 0.0 && pressure.error < 1e-12);
            friction += pressure.value * x.sin() * speed.signum() / 37.0;
        }
        let column = outcome.columns.iter().position(|column| column.name == "friction_stress").unwrap();
        let stated = row.values[column].unwrap().value;
        assert!((friction - stated).abs() < 1e-13, "{friction} {stated}");
    }
}

#[test]
fn an_almost_full_contact_has_almost_the_same_fields() {
    let (storage, loss) = modulus(10.0, &[(1.0, 1.0)], 0.3);
    let limit = storage.hypot(loss);
    for speed in [0.3, -0.3] {
        let outcome = reduced(speed, limit * (1.0 - 1e-5), 200);
        assert_eq!(outcome.rows[0].label(1), "partial");
        let full = points(&reduced(speed, limit * (1.0 + 1e-5), 20_000).rows[0]);
        for (x, [pressure, _, displacement]) in points(&outcome.rows[0]) {
            let nearest = full.iter().min_by(|a, b| (a.0 - x).abs().total_cmp(&(b.0 - x).abs())).unwrap();
            assert!((nearest.1[0].value - pressure.value).abs() < 2e-3, "{speed} {x}: {pressure:?} {:?}", nearest.1[0]);
            assert!((nearest.1[2].value - displacement.value).abs() < 1e-3, "{speed} {x}: {displacement:?}");
        }
    }
}

#[test]
fn in_si_units_it_is_the_same_contact() {
    let (wavelength, amplitude, relaxed, poisson) = (1e-4, 2e-6, 0.8e6, 0.4);
    let (k, plane) = (2.0 * std::f64::consts::PI / wavelength, relaxed / (1.0 - poisson * poisson));
    let outcome = solved(&format!(
        "[material]\nrelaxed_modulus = {relaxed}\nglassy_modulus = {}\npoisson_ratio = {poisson}\ncreep = [{{ fraction = 0.6, retardation_time = 1 }}, {{ fraction = 0.4, retardation_time = 0.1 }}]\n[sliding]\ncontacts = [\"adhesiveless\"]\nspeed = 1e-5\nmean_pressure = 5e6\n[sliding.wave]\nwavelength = {wavelength}\namplitude = {amplitude}\n[fields]\npoints = 12\n",
        7.0 * relaxed
    ));
    let (storage, loss) = modulus(7.0, &[(0.6, 1.0), (0.4, 0.1)], k * 1e-5);
    for (x, [pressure, _, displacement]) in points(&outcome.rows[0]) {
        let expected = 5e6 + 0.5 * plane * k * amplitude * (storage * (k * x).cos() + loss * (k * x).sin());
        assert!((pressure.value - expected).abs() <= pressure.error + 1e-9 * 5e6, "{x}: {pressure:?} {expected}");
        assert!((displacement.value - amplitude * (k * x).cos()).abs() <= displacement.error + 1e-18);
    }
}
