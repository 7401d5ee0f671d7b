//! Two bodies in an indentation: a viscoelastic one and an elastic one, flat or round.
//!
//! Source: Johnson, *Contact Mechanics* (1985), section 4.2 (Hertz: 1/E* = Σ(1 − ν²)/E, 1/R* = 1/R1 + 1/R2);
//! Johnson, Kendall and Roberts (1971); Lee and Radok (1960).
//! Goal: `indentation.counter_body` adds the compliance of an elastic body and the curvature of a round one; what is not exact is refused.
//! Oracle: the closed forms of Hertz and JKR, in SI and in mm–MPa units of the input; of Lee and Radok F = (4/(3R*)) ∫ R*(t − s) d(a³), whose relaxation of
//! the pair is known for one term: G(t) in series with a spring is again one term, by hand below. JKR with a process zone far shorter than the contact.
//! Tolerance: what each scene states; JKR 1 %, as a zone of 1 nm is not zero.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use std::f64::consts::PI;

/// The value of a column in the row of an event, or in the last row.
fn value(folder: &Folder, column: &str, event: Option<&str>) -> f64 {
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    let rows = json["results"].as_array().unwrap();
    let row = match event {
        Some(event) => rows.iter().find(|row| row["event"] == event).unwrap_or_else(|| panic!("no event {event}")),
        None => rows.last().unwrap(),
    };
    row["values"][column]["value"].as_f64().unwrap_or_else(|| panic!("no {column} in {row}"))
}

fn close(found: f64, right: f64, tolerance: f64, what: &str) {
    assert!((found / right - 1.0).abs() <= tolerance, "{what}: {found:e} instead of {right:e}");
}

/// Plane modulus of two bodies.
fn pair(one: (f64, f64), two: (f64, f64)) -> f64 {
    1.0 / ((1.0 - one.1 * one.1) / one.0 + (1.0 - two.1 * two.1) / two.0)
}

#[test]
fn two_elastic_spheres_are_those_of_hertz_in_two_unit_systems() {
    let (soft, hard) = ((3.1e6, 0.47), (7.7e6, 0.31));
    let (r1, r2, depth) = (2.3e-3_f64, 5.9e-3_f64, 1.7e-5_f64);
    let radius = r1 * r2 / (r1 + r2);
    let force = 4.0 / 3.0 * pair(soft, hard) * radius.sqrt() * depth.powf(1.5);
    let si = "[material]\nrelaxed_modulus = 3.1e6\npoisson_ratio = 0.47\n[indentation]\nsphere = { radius = 2.3e-3 }\ncounter_body = { modulus = 7.7e6, poisson_ratio = 0.31, radius = 5.9e-3 }\ninstants = 1\n[[history]]\npenetration = 1.7e-5\nduration = 1\n";
    let workshop = "[material]\nrelaxed_modulus = \"3.1 N/mm2\"\npoisson_ratio = 0.47\n[indentation]\nsphere = { radius = \"2.3 mm\" }\ncounter_body = { modulus = \"7.7 N/mm2\", poisson_ratio = 0.31, radius = \"5.9 mm\" }\ninstants = 1\n[[history]]\npenetration = \"17 micron\"\nduration = \"1 s\"\n";
    for text in [si, workshop] {
        let folder = Folder::with(text);
        close(value(&folder, "force", None), force, 1e-6, "Hertz");
        close(value(&folder, "contact_radius", None), (radius * depth).sqrt(), 1e-6, "Hertz");
    }
    // Which of both is the material does not matter.
    let swapped = si
        .replace("3.1e6", "@")
        .replace("7.7e6", "3.1e6")
        .replace('@', "7.7e6")
        .replace("0.47", "@")
        .replace("0.31", "0.47")
        .replace('@', "0.31");
    close(value(&Folder::with(&swapped), "force", None), force, 1e-6, "the other way round");
    // A rigid second sphere only changes the radius.
    let rigid = si.replace("modulus = 7.7e6, poisson_ratio = 0.31, ", "");
    let alone = 4.0 / 3.0 * soft.0 / (1.0 - soft.1 * soft.1) * radius.sqrt() * depth.powf(1.5);
    close(value(&Folder::with(&rigid), "force", None), alone, 1e-6, "a rigid sphere on a sphere");
    // A flat second body only changes the modulus.
    let flat = si.replace(", radius = 5.9e-3", "");
    close(value(&Folder::with(&flat), "force", None), 4.0 / 3.0 * pair(soft, hard) * r1.sqrt() * depth.powf(1.5), 1e-6, "flat");
}

#[test]
fn two_elastic_spheres_are_those_of_jkr() {
    let (one, two) = ((240e6, 0.2), (480e6, 0.35));
    let (r1, r2, work) = (150e-6_f64, 75e-6_f64, 0.1);
    let (modulus, radius) = (pair(one, two), r1 * r2 / (r1 + r2));
    let folder = Folder::with(
        "accuracy = 1e-3\n[material]\nrelaxed_modulus = \"240 MPa\"\npoisson_ratio = 0.2\n[adhesion]\nwork_of_adhesion = \"100 mJ/m2\"\nprocess_zone = { length = \"0.3 nm\" }\n[indentation]\nsphere = { radius = \"150 µm\" }\ncounter_body = { modulus = \"480 MPa\", poisson_ratio = 0.35, radius = \"75 µm\" }\nstart = \"relaxed\"\nforce = \"0 N\"\ninstants = 2\n[[history]]\npenetration = \"-2 µm\"\nduration = \"1 s\"\n",
    );
    close(value(&folder, "force", Some("largest_tension")), -1.5 * PI * work * radius, 0.01, "pull-off");
    let json = folder.call(&["run", "scene.toml", "--json"]).ended(0).json();
    let first = json["results"].as_array().unwrap().iter().find(|row| row["values"]["time"]["value"] == 0.0).unwrap()["values"]["contact_radius"]["value"].as_f64().unwrap();
    // a³ = (3R/4E*)·6πwR at no load.
    close(first, (4.5 * PI * work * radius * radius / modulus).cbrt(), 0.01, "radius at no load");
}

#[test]
fn a_viscoelastic_sphere_on_an_elastic_one_is_that_of_lee_and_radok() {
    // J(t) = 1/E∞ + J1(1 − e^{−t/θ}); the elastic body adds C: E∞' = 1/(1/E∞ + C), E0' = 1/(1/E0 + C), relaxation time ρ' = θ E0'/E∞'.
    let (relaxed, glassy, theta, nu) = (1.3e6_f64, 8.9e6_f64, 0.7_f64, 0.45_f64);
    let compliance = (1.0 - 0.3 * 0.3) / 4.1e6;
    let plane = |modulus: f64| 1.0 / ((1.0 - nu * nu) / modulus + compliance);
    let (soft, stiff) = (plane(relaxed), plane(glassy));
    let time = theta * soft / stiff;
    let (r1, r2, end, depth) = (4e-3_f64, 9e-3_f64, 1.9_f64, 3e-5_f64);
    let radius = r1 * r2 / (r1 + r2);
    // F = (4/3)√R* ∫ E'(T − s) d(δ^{3/2}), δ = depth s/T; by Simpson's rule in s^{1/2}, where the integrand is smooth.
    let steps = 4000;
    let relaxation = |t: f64| soft + (stiff - soft) * (-t / time).exp();
    let integrand = |x: f64| relaxation(end * (1.0 - x * x)) * 3.0 * x * x;
    let simpson: f64 = (0..=steps)
        .map(|index| {
            let weight = if index == 0 || index == steps {
                1.0
            } else if index % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * integrand(f64::from(index) / f64::from(steps))
        })
        .sum::<f64>()
        / (3.0 * f64::from(steps));
    let force = 4.0 / 3.0 * radius.sqrt() * depth.powf(1.5) * simpson;
    let folder = Folder::with(
        "accuracy = 1e-6\n[material]\nrelaxed_modulus = \"1.3 MPa\"\nglassy_modulus = \"8.9 MPa\"\npoisson_ratio = 0.45\ncreep = [{ fraction = 1, retardation_time = \"0.7 s\" }]\n[indentation]\nsphere = { radius = \"4 mm\" }\ncounter_body = { modulus = \"4.1 MPa\", poisson_ratio = 0.3, radius = \"9 mm\" }\ninstants = 1\n[[history]]\npenetration = \"30 µm\"\nduration = \"1.9 s\"\n",
    );
    close(value(&folder, "force", None), force, 1e-6, "Lee and Radok");
    // A liquid in series with a spring is a liquid: a Maxwell one with 1/E + C and the same viscosity. F → 0 after long.
    let (modulus, eta) = (2.2e6_f64, 3.1e6_f64);
    let stiff = 1.0 / ((1.0 - nu * nu) / modulus + compliance);
    let time = eta / (1.0 - nu * nu) / stiff;
    let integrand = |x: f64| stiff * (-(end * (1.0 - x * x)) / time).exp() * 3.0 * x * x;
    let simpson: f64 = (0..=steps)
        .map(|index| {
            let weight = if index == 0 || index == steps {
                1.0
            } else if index % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * integrand(f64::from(index) / f64::from(steps))
        })
        .sum::<f64>()
        / (3.0 * f64::from(steps));
    let folder = Folder::with(&format!(
        "accuracy = 1e-6\n[material]\nrelaxed_modulus = 0\npoisson_ratio = 0.45\nrelaxation = [{{ modulus = {modulus}, relaxation_time = {} }}]\n[indentation]\nsphere = {{ radius = \"4 mm\" }}\ncounter_body = {{ modulus = \"4.1 MPa\", poisson_ratio = 0.3, radius = \"9 mm\" }}\ninstants = 1\n[[history]]\npenetration = \"30 µm\"\nduration = \"1.9 s\"\n",
        eta / modulus
    ));
    close(value(&folder, "force", None), 4.0 / 3.0 * radius.sqrt() * depth.powf(1.5) * simpson, 1e-6, "a liquid");
}

#[test]
fn what_is_not_exact_is_refused() {
    let scene = |shape: &str, body: &str| {
        Folder::with(&format!(
            "[material]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.4\n[indentation]\n{shape}\ncounter_body = {body}\n[[history]]\npenetration = 1e-6\nduration = 1\n"
        ))
    };
    let elastic = "{ modulus = 1e7, poisson_ratio = 0.3 }";
    for (shape, body, says) in [
        ("flat_punch = { radius = 1e-3 }", elastic, "no half-space"),
        ("sphere = { radius = 1e-3 }\nrim_radius = 1e-4", elastic, "no half-space"),
        ("cone = { slope = 0.1 }", "{ modulus = 1e7, poisson_ratio = 0.3, radius = 1e-3 }", "belongs to two spheres"),
        ("sphere = { radius = 1e-3 }", "{ modulus = 1e7 }", "poisson_ratio"),
        ("sphere = { radius = 1e-3 }", "{}", "modulus"),
        ("sphere = { radius = 1e-3 }", "{ modulus = 1e7, poisson_ratio = 0.3, radius = 0 }", "greater than 0"),
    ] {
        let answer = scene(shape, body).call(&["run", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains(says), "{shape} {body}: {}", answer.stderr);
    }
    let reduced = Folder::with(
        "units = \"reduced\"\n[material]\n[indentation]\nsphere = {}\ncounter_body = { modulus = 1, poisson_ratio = 0.3 }\n[[history]]\npenetration = 0.1\nduration = 1\n",
    );
    assert!(reduced.call(&["run", "scene.toml"]).ended(2).stderr.contains("of both bodies together"));
    // A cone on an elastic half-space is exact: F = 2E*δ²/(π slope).
    let cone = scene("cone = { slope = 0.1 }", elastic);
    close(value(&cone, "force", None), 2.0 * pair((1e6, 0.4), (1e7, 0.3)) * 1e-12 / (PI * 0.1), 1e-6, "a cone");
}
