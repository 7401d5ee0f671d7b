//! Source: thesis Eqs 5.13, 5.16, 5.18, 5.34, 5.36 (intensities, radii), 5.25 (zone), Rivlin and Thomas (strip); README (columns of a run).
//!
//! Goal: what stands in a table is what its column says: the way from the solver's drive to K, G, δ, radii and the speed exponent, through
//! bodies, plane states, motions and unit systems, by identities formed here from the scene's own numbers.
//!
//! Parameters: moduli that are no units, ν = 0.4, one and two halves, plane stress and strain, opening and closing, SI and reduced.
//!
//! Oracle: G = cK²/(2E*), r = (4/π)(K/E*)², δ = α(K/(√(2π)σ_c))², K_tip = βK₁, a strip's G = hσ²(1 − ν²)/E; a difference quotient.
//!
//! Tolerance: 1e-12 relative (a dozen roundings); the difference quotient of d ln G/d ln v, 1e-6.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use viscotack::Estimate;
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, read};

const RELAXED: f64 = 1.3e6;
const GLASSY: f64 = 5.2e8;
const POISSON: f64 = 0.4;
const WORK: f64 = 0.37;
const STRESS: f64 = 2.9e6;
const FACTOR: f64 = 0.6;

/// The columns of a scene's first state and first theory.
fn columns(text: &str) -> HashMap<&'static str, Estimate> {
    let document = Document::parse("test.toml", text.to_owned(), Path::new(".")).unwrap_or_else(|error| panic!("{}", error.rendered()));
    let scene = read::read(&document).unwrap_or_else(|error| panic!("{}", error.rendered()));
    let plan = Plan::new(&scene).unwrap();
    let row = plan.solve(0, &[]).remove(0);
    assert!(row.status.has_values(), "{:?}", row.reason);
    plan.columns().iter().zip(row.values).filter_map(|(column, value)| Some((column.name, value?))).collect()
}

fn scene(motion: &str, body: &str, plane: &str, control: &str) -> String {
    format!(
        "[material]\nrelaxed_modulus = {RELAXED:e}\nglassy_modulus = {GLASSY:e}\npoisson_ratio = {POISSON}\n\
         creep = [{{ fraction = 0.3, retardation_time = 2.0 }}, {{ fraction = 0.7, retardation_time = 0.01 }}]\n\
         [adhesion]\nwork_of_adhesion = {WORK}\nprocess_zone = {{ cohesive_stress = {STRESS:e}, factor = {FACTOR} }}\n\
         [crack]\nmotion = \"{motion}\"\nbody = \"{body}\"\nplane = \"{plane}\"\n{control}\n"
    )
}

fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found:e} instead of {expected:e}");
}

#[test]
fn columns_obey_the_identities_of_fracture_mechanics() {
    for motion in ["opening", "closing"] {
        for (body, halves) in [("against_rigid", 1.0), ("two_halves", 2.0)] {
            for (plane, stiffening) in [("stress", 1.0), ("strain", 1.0 / (1.0 - POISSON * POISSON))] {
                let name = format!("{motion} {body} {plane}");
                let values = columns(&scene(motion, body, plane, "speed = \"3 µm/s\""));
                let value = |column: &str| values[column].value;
                let (relaxed, glassy) = (RELAXED * stiffening, GLASSY * stiffening);
                let (rate, intensity) = (value("energy_release_rate"), value("stress_intensity"));
                assert_close(&name, rate, halves * intensity * intensity / (2.0 * relaxed), 1e-12);
                assert_close(&name, value("energy_release_rate_ratio"), rate / WORK, 1e-12);
                assert_close(&name, value("process_zone"), FACTOR * intensity * intensity / (TAU * STRESS * STRESS), 1e-12);
                assert_close(&name, value("crossing_time"), value("process_zone") / 3e-6, 1e-12);
                if motion == "opening" {
                    assert!(value("energy_release_rate_ratio") > 1.5, "{name}: a speed at which the material loses energy");
                    assert_close(&name, value("tip_stress_intensity"), intensity, 1e-12);
                    assert_close(&name, value("glassy_tip_radius"), 4.0 / PI * (intensity / glassy).powi(2), 1e-12);
                    assert_close(&name, value("relaxed_tip_radius"), 4.0 / PI * (intensity / relaxed).powi(2), 1e-12);
                } else {
                    assert!(value("energy_release_rate_ratio") < 0.7, "{name}: a speed at which the material loses energy");
                    assert_close(&name, value("tip_stress_intensity"), intensity * glassy / relaxed, 1e-12);
                    assert_close(&name, value("displacement_intensity"), intensity / relaxed, 1e-12);
                    assert_close(&name, value("glassy_tip_radius"), 4.0 / PI * (intensity / relaxed).powi(2), 1e-12);
                }
                // The exponent against a central difference of its own G.
                let step: f64 = 1e-4;
                let at = |speed: f64| columns(&scene(motion, body, plane, &format!("speed = {speed:e}")))["energy_release_rate"].value;
                let quotient = (at(3e-6 * step.exp()) / at(3e-6 * (-step).exp())).ln() / (2.0 * step);
                assert_close(&name, value("speed_exponent"), quotient, 1e-6);
                // Back from each kind of load to the speed.
                for control in [format!("energy_release_rate = {rate:e}"), format!("stress_intensity = {intensity:e}")] {
                    let back = columns(&scene(motion, body, plane, &control));
                    assert_close(&name, back["speed"].value, 3e-6, 1e-11);
                }
            }
        }
    }
}

#[test]
fn a_strip_releases_the_energy_stored_ahead() {
    let strip = |lateral: &str, load: &str| {
        let control = format!("[crack.strip]\nhalf_height = 0.02\nlateral = \"{lateral}\"\n{load}\n");
        columns(&scene("opening", "two_halves", "stress", &control))["energy_release_rate"].value
    };
    // 2h·W with W = ½σ²(1 − ν²)/E = ½ε²E/(1 − ν²) if clamped along the strip, W = ½σ²/E = ½ε²E if free.
    let clamped = 1.0 - POISSON * POISSON;
    assert_close("clamped, stress", strip("clamped", "stress = 8e3"), 0.02 * 8e3 * 8e3 * clamped / RELAXED, 1e-12);
    assert_close("clamped, strain", strip("clamped", "strain = 0.006"), 0.02 * 0.006 * 0.006 * RELAXED / clamped, 1e-12);
    assert_close("free, stress", strip("uniaxial", "stress = 8e3"), 0.02 * 8e3 * 8e3 / RELAXED, 1e-12);
    assert_close("free, strain", strip("uniaxial", "strain = 0.006"), 0.02 * 0.006 * 0.006 * RELAXED, 1e-12);
}

#[test]
fn a_reduced_scene_is_the_same_crack() {
    let beta = GLASSY / RELAXED;
    for (motion, body, halves) in [("opening", "against_rigid", 1.0), ("closing", "two_halves", 2.0)] {
        let zone = RELAXED * WORK / (halves * PI * STRESS * STRESS);
        let si = columns(&scene(motion, body, "stress", &format!("speed = {:e}", 0.8 * zone / 2.0)));
        let reduced = columns(&format!(
            "units = \"reduced\"\n[material]\nglassy_modulus = {beta}\n\
             creep = [{{ fraction = 0.3, retardation_time = 1 }}, {{ fraction = 0.7, retardation_time = 0.005 }}]\n\
             [adhesion]\nprocess_zone = {{ factor = {FACTOR} }}\n[crack]\nmotion = \"{motion}\"\nbody = \"{body}\"\nspeed = 0.8\n"
        ));
        let ratio =
            |column: &str, unit: f64| assert_close(&format!("{motion} {column}"), reduced[column].value * unit, si[column].value, 1e-11);
        ratio("energy_release_rate", WORK);
        ratio("process_zone", zone);
        ratio("crossing_time", 2.0);
        ratio("speed_exponent", 1.0);
        // Radii go with Δγ/E0, which is another length than a₀.
        ratio("glassy_tip_radius", WORK / RELAXED);
        // √(2E0Δγ), whatever the body.
        ratio("stress_intensity", (2.0 * RELAXED * WORK).sqrt());
    }
}

#[test]
fn fields_are_square_roots_at_both_ends_and_change_units_with_the_scene() {
    let fields = |text: &str| {
        let document = Document::parse("test.toml", text.to_owned(), Path::new(".")).unwrap();
        Plan::new(&read::read(&document).unwrap()).unwrap().solve(0, &[]).remove(0).fields
    };
    let zone = RELAXED * WORK / (PI * STRESS * STRESS);
    let (near, far) = (1e-12 * zone, 1e12 * zone);
    let control = format!("speed = {:e}\n[fields]\nfrom = {near:e}\nto = {far:e}\npoints = 3", 0.8 * zone / 2.0);
    let si = fields(&scene("opening", "against_rigid", "stress", &control));
    let intensity = columns(&scene("opening", "against_rigid", "stress", &control))["stress_intensity"].value;
    // u = K√(8s/π)/E, glassy at the tip, relaxed far away; σ = K/√(2πd).
    assert_close("glassy opening", si[0].values[0].value, intensity * (8.0 * near / PI).sqrt() / GLASSY, 1e-6);
    assert_close("relaxed opening", si[2].values[0].value, intensity * (8.0 * far / PI).sqrt() / RELAXED, 1e-6);
    assert_close("stress", si[0].values[1].value, intensity / (TAU * near).sqrt(), 1e-12);
    let reduced = fields(&format!(
        "units = \"reduced\"\n[material]\nglassy_modulus = {}\n\
         creep = [{{ fraction = 0.3, retardation_time = 1 }}, {{ fraction = 0.7, retardation_time = 0.005 }}]\n\
         [adhesion]\nprocess_zone = {{ factor = {FACTOR} }}\n[crack]\nspeed = 0.8\n[fields]\nfrom = 1e-12\nto = 1e12\npoints = 3\n",
        GLASSY / RELAXED
    ));
    for (point, other) in si.iter().zip(&reduced) {
        assert_close("displacement", other.values[0].value * (zone * WORK / RELAXED).sqrt(), point.values[0].value, 1e-11);
        assert_close("stress", other.values[1].value * (RELAXED * WORK / zone).sqrt(), point.values[1].value, 1e-11);
    }
}
