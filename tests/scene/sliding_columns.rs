//! Source: thesis Eqs 3.21, 3.22, 3.39, 3.40 (works and friction at the edges), theory of the reduced groups; README (columns of a run).
//!
//! Goal: what stands in the table and the fields of a sliding contact is what its column says: the way from reduced numbers to SI, through
//! both bodies, both directions and both kinds of contact, by identities formed here from the scene's own numbers.
//!
//! Parameters: moduli, lengths and times that are no units, ν = 0.4; adhesive and adhesiveless; with a counter body; v of both signs.
//!
//! Oracle: the same contact in reduced units; edges e ∓ a; μ = friction/load; G₁ − G₂ over the wavelength; δ = αE0*Δγ/(πσ_c²); a material whose
//! creep holds the counter body's compliance; −(1/λ)∫p dw and the mean of p over the printed fields; ½k²Λ² Im E*(kv)/2 of full contact.
//!
//! Tolerance: 1e-12 for products of one row; 1e-6 between two solutions (ten times the accuracy asked for); 1e-5 for sums over fields.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;
use viscotack::Estimate;
use viscotack_program::outcome::{Row, Status};
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, Scene, read};

const RELAXED: f64 = 1.3e6;
const GLASSY: f64 = 1.56e7;
const POISSON: f64 = 0.4;
const TIME: f64 = 0.02;
const WAVELENGTH: f64 = 7e-5;
const AMPLITUDE: f64 = 2e-6;
const SPEED: f64 = 3e-4;
const PRESSURE: f64 = 7e3;
const WORK: f64 = 0.014;
const ZONE: f64 = 1.7e-7;

const RELAXED_PLANE: f64 = RELAXED / (1.0 - POISSON * POISSON);

fn parsed(text: &str) -> Scene {
    let document = Document::parse("test.toml", text.to_owned(), Path::new(".")).unwrap_or_else(|error| panic!("{}", error.rendered()));
    read::read(&document).unwrap_or_else(|error| panic!("{}\n{text}", error.rendered()))
}

fn rows(text: &str) -> Vec<Row> {
    Plan::new(&parsed(text)).unwrap().solve(0, &[])
}

/// The columns of each row that has values.
fn columns(text: &str) -> Vec<HashMap<&'static str, Estimate>> {
    let plan = Plan::new(&parsed(text)).unwrap();
    let table = |row: Row| {
        assert_eq!((row.status, row.label(1)), (Status::Solved, "partial"), "{:?}\n{text}", row.reason);
        plan.columns().iter().zip(row.values).filter_map(|(column, value)| Some((column.name, value?))).collect()
    };
    plan.solve(0, &[]).into_iter().map(table).collect()
}

fn scene(speed: f64, rest: &str) -> String {
    format!(
        "[material]\nrelaxed_modulus = {RELAXED:e}\nglassy_modulus = {GLASSY:e}\npoisson_ratio = {POISSON}\n\
         creep = [{{ fraction = 0.3, retardation_time = {TIME} }}, {{ fraction = 0.7, retardation_time = {} }}]\n\
         [adhesion]\nwork_of_adhesion = {WORK}\nprocess_zone = {{ length = {ZONE:e} }}\n\
         [sliding]\nwave = {{ wavelength = {WAVELENGTH:e}, amplitude = {AMPLITUDE:e} }}\ncontacts = [\"adhesive\", \"adhesiveless\"]\n\
         speed = {speed:e}\n{rest}",
        0.1 * TIME
    )
}

fn pressed(speed: f64) -> String {
    scene(speed, &format!("mean_pressure = {PRESSURE:e}\n"))
}

fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found:e} instead of {expected:e}");
}

#[test]
fn columns_obey_the_identities_of_a_row() {
    let found = columns(&pressed(SPEED));
    for (contact, values) in ["adhesive", "adhesiveless"].iter().zip(&found) {
        let value = |name: &str| values[name].value;
        assert_eq!(value("speed").to_bits(), SPEED.to_bits());
        assert_close(contact, value("mean_pressure"), PRESSURE, 1e-7);
        assert_close(contact, value("trailing_edge"), value("eccentricity") - value("half_width"), 1e-12);
        assert_close(contact, value("leading_edge"), value("eccentricity") + value("half_width"), 1e-12);
        assert_close(contact, value("friction_coefficient"), value("friction_stress") / value("mean_pressure"), 1e-12);
        assert!(value("friction_stress") > 0.0 && value("half_width") > 0.0 && value("interface_work") > 0.0);
        assert!(values.values().all(|estimate| estimate.error >= 0.0 && estimate.error.is_finite()));
    }
    let value = |name: &str| found[0][name].value;
    let (trailing, leading) = (value("trailing_energy_release_rate"), value("leading_energy_release_rate"));
    assert!(trailing > 1.2 * WORK, "a speed at which the edges differ: {trailing}");
    assert_close("opening", value("trailing_nonconservative_work"), WORK - trailing, 1e-10);
    assert_close("closing", value("leading_nonconservative_work"), WORK - leading, 1e-10);
    assert_close("adhesive part", value("adhesive_friction_stress"), (trailing - leading) / WAVELENGTH, 1e-10);
    assert_close("zone", value("trailing_process_zone"), ZONE, 1e-12);
    for name in ["trailing_energy_release_rate", "adhesive_friction_stress", "leading_nonconservative_work", "trailing_process_zone"] {
        assert!(!found[1].contains_key(name), "{name} without adhesion");
    }
}

#[test]
fn a_reduced_scene_is_the_same_contact() {
    let k = 2.0 * PI / WAVELENGTH;
    let pressure = 0.5 * RELAXED_PLANE * k * AMPLITUDE;
    let reduced = columns(&format!(
        "units = \"reduced\"\n[material]\nglassy_modulus = {}\n\
         creep = [{{ fraction = 0.3, retardation_time = 1 }}, {{ fraction = 0.7, retardation_time = 0.1 }}]\n\
         [adhesion]\nwork_of_adhesion = {}\nprocess_zone = {{ length = {} }}\n\
         [sliding]\nwave = {{}}\ncontacts = [\"adhesive\", \"adhesiveless\"]\nspeed = {}\nmean_pressure = {}\n",
        GLASSY / RELAXED,
        WORK / (PI * RELAXED_PLANE * k * AMPLITUDE * AMPLITUDE),
        ZONE * k,
        SPEED * k * TIME,
        PRESSURE / pressure,
    ));
    for (si, reduced) in columns(&pressed(SPEED)).iter().zip(&reduced) {
        let mut compared = 0;
        for (names, unit) in [
            (
                &["half_width", "eccentricity", "trailing_edge", "leading_edge", "trailing_process_zone", "leading_process_zone"][..],
                1.0 / k,
            ),
            (&["penetration"], AMPLITUDE),
            (&["mean_pressure"], pressure),
            (&["friction_stress", "adhesive_friction_stress"], pressure * k * AMPLITUDE),
            (&["friction_coefficient"], k * AMPLITUDE),
            (&["trailing_energy_release_rate", "leading_energy_release_rate", "trailing_nonconservative_work"], WORK),
            (&["leading_nonconservative_work"], WORK),
            (&["interface_work"], 0.5 * RELAXED_PLANE * AMPLITUDE * AMPLITUDE),
            (&["speed"], 1.0 / (k * TIME)),
            (&["stable_under_load", "stable_under_penetration", "other_contacts"], 1.0),
        ] {
            for name in names {
                assert_eq!(si.contains_key(name), reduced.contains_key(name), "{name}");
                if let (Some(si), Some(reduced)) = (si.get(name), reduced.get(name)) {
                    // The two solutions stop at different residuals; each bound holds its own, and both are of one size.
                    let difference = (reduced.value * unit - si.value).abs();
                    assert!(
                        difference <= reduced.error * unit + si.error + 1e-14 * si.value.abs(),
                        "{name}: {difference:e}, {:e}",
                        si.error
                    );
                    assert!(si.error <= 1e-5 * si.value.abs().max(unit), "{name}: {:e} of {:e}", si.error, si.value);
                    assert!(si.error == 0.0 || (0.1..10.0).contains(&(reduced.error * unit / si.error)), "{name}: {:e}", si.error);
                    compared += 1;
                }
            }
        }
        assert_eq!(compared, si.len());
    }
}

#[test]
fn a_negative_speed_mirrors_the_contact() {
    let fields = "mean_pressure = 7e3\n[fields]\npoints = 30\n";
    let (forward, backward) = (rows(&scene(SPEED, fields)), rows(&scene(-SPEED, fields)));
    let names: Vec<&str> = Plan::new(&parsed(&pressed(SPEED))).unwrap().columns().iter().map(|column| column.name).collect();
    for (there, back) in forward.iter().zip(&backward) {
        for ((name, there), back) in names.iter().zip(&there.values).zip(&back.values) {
            let mirrored = ["speed", "eccentricity", "trailing_edge", "leading_edge"].contains(name);
            let sign = if mirrored { -1.0 } else { 1.0 };
            assert_eq!(there.map(|estimate| estimate.value), back.map(|estimate| sign * estimate.value), "{name}");
        }
        for (there, back) in there.fields.iter().zip(back.fields.iter().rev()) {
            assert_eq!((there.place, &there.values), (-back.place, &back.values));
        }
    }
}

#[test]
fn every_control_leads_to_the_same_contact() {
    for (place, values) in columns(&pressed(SPEED)).iter().enumerate() {
        let back = columns(&scene(SPEED, &format!("penetration = {:e}\n", values["penetration"].value)));
        for name in ["half_width", "eccentricity", "mean_pressure", "friction_stress"] {
            assert_close(name, back[place][name].value, values[name].value, 1e-6);
        }
    }
}

#[test]
fn a_cohesive_stress_gives_the_zone_of_the_relaxed_body() {
    let (stress, factor) = (2.9e5, 0.6);
    let zone = factor * RELAXED_PLANE * WORK / (PI * stress * stress);
    let by = |way: &str| columns(&pressed(SPEED).replace(&format!("length = {ZONE:e}"), way));
    let cohesive = by(&format!("cohesive_stress = {stress:e}, factor = {factor}, law = \"constant\""));
    assert_close("zone", cohesive[0]["trailing_process_zone"].value, zone, 1e-12);
    assert_close("zone", cohesive[0]["leading_process_zone"].value, zone, 1e-12);
    let lengths = by(&format!("trailing_length = {zone:e}, leading_length = {zone:e}"));
    for (name, value) in &cohesive[0] {
        assert_close(name, value.value, lengths[0][name].value, 1e-6);
    }
    // The default factor is 1/π.
    let default = by(&format!("cohesive_stress = {stress:e}"));
    assert_close("zone", default[0]["trailing_process_zone"].value, zone / factor / PI, 1e-12);
    // A longer zone of the opening edge only: that edge alone gets easier to open.
    let uneven = by(&format!("trailing_length = {:e}, leading_length = {zone:e}", 1.5 * zone));
    assert!(uneven[0]["trailing_energy_release_rate"].value < 0.99 * lengths[0]["trailing_energy_release_rate"].value);
}

#[test]
fn a_counter_body_adds_its_compliance_at_every_time() {
    let (modulus, poisson): (f64, f64) = (4e6, 0.3);
    let added = (1.0 - poisson * poisson) / modulus;
    let with_body = columns(&format!("{}[sliding.counter_body]\nmodulus = {modulus:e}\npoisson_ratio = {poisson}\n", pressed(SPEED)));
    let plane = 1.0 - POISSON * POISSON;
    let gained = plane * (1.0 / RELAXED - 1.0 / GLASSY);
    let together = pressed(SPEED)
        .replace(&format!("relaxed_modulus = {RELAXED:e}\n"), "")
        .replace(&format!("glassy_modulus = {GLASSY:e}"), &format!("glassy_modulus = {:e}", 1.0 / (plane / GLASSY + added)))
        .replace("poisson_ratio = 0.4", "poisson_ratio = 0")
        .replace("fraction = 0.3", &format!("compliance = {:e}", 0.3 * gained))
        .replace("fraction = 0.7", &format!("compliance = {:e}", 0.7 * gained));
    for (found, expected) in with_body.iter().zip(columns(&together)) {
        for (name, value) in found {
            assert_close(name, value.value, expected[name].value, 1e-6);
        }
    }
    // It is softer than the one body.
    assert!(with_body[1]["half_width"].value > 1.05 * columns(&pressed(SPEED))[1]["half_width"].value);
}

#[test]
fn without_adhesion_the_adhesiveless_contact_is_all_there_is() {
    let both = columns(&pressed(SPEED));
    let text = pressed(SPEED);
    let (before, after) = text.split_once("[adhesion]").unwrap();
    let alone = format!("{before}[sliding]{}", after.split_once("[sliding]").unwrap().1)
        .replace("contacts = [\"adhesive\", \"adhesiveless\"]\n", "");
    let alone = columns(&alone);
    assert_eq!(alone.len(), 1);
    assert_eq!(alone[0], both[1]);
    let default = columns(&text.replace("contacts = [\"adhesive\", \"adhesiveless\"]\n", ""));
    assert_eq!((default.len(), &default[0]), (1, &both[0]));
}

#[test]
fn fields_add_up_to_the_columns() {
    let points = 400;
    // The lengths that the surface moves in a relaxation time are not thin here, so that the sums see every layer.
    let text = scene(10.0 * SPEED, &format!("mean_pressure = {PRESSURE:e}\n[fields]\npoints = {points}\n"));
    let plan = Plan::new(&parsed(&text)).unwrap();
    assert_eq!(plan.field_columns().iter().map(|column| column.name).collect::<Vec<_>>(), ["position", "pressure", "gap", "displacement"]);
    let k = 2.0 * PI / WAVELENGTH;
    for (row, values) in rows(&text).iter().zip(columns(&text)) {
        assert_eq!(row.fields.len(), points);
        assert_eq!(row.work.field_evaluations, points as u64);
        assert!(row.fields.windows(2).all(|pair| pair[0].place <= pair[1].place), "in order");
        let (mut load, mut friction, mut count) = (0.0, 0.0, 0);
        let (trailing, leading) = (values["trailing_edge"].value, values["leading_edge"].value);
        for point in &row.fields {
            let [pressure, gap, displacement] = [0, 1, 2].map(|field| point.values[field].value);
            let profile = AMPLITUDE * ((k * point.place).cos() - 1.0) + values["penetration"].value;
            assert!((displacement - profile - gap).abs() < 1e-9 * AMPLITUDE, "w = profile + gap");
            assert!(gap >= 0.0, "faces apart");
            if point.place > trailing && point.place < leading {
                assert_eq!(gap.to_bits(), 0);
                // Places are (leading − trailing) sin²θ from the trailing edge, θ in equal steps.
                let theta = FRAC_PI_2 * (f64::from(count) + 0.5) / 200.0;
                let weight = (leading - trailing) * (2.0 * theta).sin() * FRAC_PI_2 / 200.0;
                load += pressure * weight / WAVELENGTH;
                // The surface has the slope of the wave: force against the motion (1/λ)∫p dw/dx, the body moving to +x.
                friction += pressure * weight * AMPLITUDE * k * (k * point.place).sin() / WAVELENGTH;
                count += 1;
            } else {
                assert_eq!(pressure.to_bits(), 0);
                assert!(gap > 0.0, "open outside the contact");
            }
        }
        assert_eq!(count, 200);
        assert_close(row.label(0), load, values["mean_pressure"].value, 1e-5);
        assert_close(row.label(0), friction, values["friction_stress"].value, 1e-5);
    }
}

#[test]
fn above_the_last_partial_contact_the_contact_is_full() {
    let k = 2.0 * PI / WAVELENGTH;
    let high = 1.3 * 0.5 * RELAXED_PLANE * k * AMPLITUDE;
    // The adhesive one beyond snap-in, the adhesiveless one beyond the pressure of full contact.
    for row in rows(&scene(SPEED, &format!("mean_pressure = {high:e}\n"))) {
        assert_eq!((row.status, row.label(1)), (Status::Solved, "full"), "{:?}", row.reason);
        assert!(row.reason.unwrap().contains("past ") && row.witness.is_some() && row.fields.is_empty());
        let names = Plan::new(&parsed(&pressed(SPEED))).unwrap().columns();
        let value = |name: &str| row.values[names.iter().position(|column| column.name == name).unwrap()].map(|estimate| estimate.value);
        assert_eq!(value("half_width"), None);
        assert_close("load", value("mean_pressure").unwrap(), high, 1e-14);
        // Loss of the first harmonic of both terms: Im E of 1/(1/E∞ + ΣJ/(1 + iωτ)).
        let omega = k * SPEED;
        let gained = 1.0 / RELAXED - 1.0 / GLASSY;
        let (mut real, mut imaginary) = (1.0 / GLASSY, 0.0);
        for (part, time) in [(0.3, TIME), (0.7, 0.1 * TIME)] {
            let squared = 1.0 + (omega * time).powi(2);
            real += gained * part / squared;
            imaginary -= gained * part * omega * time / squared;
        }
        let loss = -imaginary / (real * real + imaginary * imaginary) / (1.0 - POISSON * POISSON);
        let friction = 0.25 * (k * AMPLITUDE).powi(2) * loss;
        assert_close("friction", value("friction_stress").unwrap(), friction, 1e-12);
        assert_close("coefficient", value("friction_coefficient").unwrap(), friction / high, 1e-12);
    }
}

#[test]
fn below_the_last_contact_there_is_no_state() {
    let mut found = rows(&scene(SPEED, "mean_pressure = -4e4\n"));
    for row in &found {
        assert_eq!((row.status, row.label(1)), (Status::NoSuchState, ""), "{row:?}");
        assert!(row.witness.is_some() && row.values.iter().all(Option::is_none));
    }
    // Pulled, but not off: only adhesion holds it.
    found = rows(&scene(SPEED, "mean_pressure = -1e3\n"));
    assert_eq!((found[0].status, found[1].status), (Status::Solved, Status::NoSuchState));
    assert!(found[1].reason.as_ref().unwrap().contains("without adhesion"));
}

#[test]
fn a_cylinder_is_measured_by_the_larger_of_its_two_lengths() {
    let radius = 0.003;
    let groups = |adhesion: &str, load: f64| {
        let text = format!(
            "[material]\nrelaxed_modulus = {RELAXED:e}\npoisson_ratio = {POISSON}\n{adhesion}\
             [sliding]\ncylinder = {{ radius = {radius} }}\nspeed = 1\nload_per_width = {load}\n"
        );
        let groups = Plan::new(&parsed(&text)).unwrap().groups();
        move |name: &str| groups.iter().find(|group| group.name.starts_with(name)).unwrap_or_else(|| panic!("{name}")).value
    };
    let adhesion = format!("[adhesion]\nwork_of_adhesion = {WORK}\nprocess_zone = {{ length = {ZONE:e} }}\n");
    // Pressed hard: Hertz's half-width, so that F = πE0*a²/4R is a quarter of the unit of load.
    let pressed = groups(&adhesion, 40.0);
    assert_close("Hertz", pressed("unit of length"), (4.0 * 40.0 * radius / (PI * RELAXED_PLANE)).sqrt(), 1e-12);
    assert_close("load", pressed("reduced load"), 0.25, 1e-12);
    // Hardly pressed: the adhesion length, so that Γ = ΔγR²/(πE0*L³) is 1/π.
    let held = groups(&adhesion, 1e-3);
    assert_close("adhesion", held("unit of length"), (WORK * radius * radius / RELAXED_PLANE).cbrt(), 1e-12);
    assert_close("Γ", held("adhesion Γ"), 1.0 / PI, 1e-12);
    let length = held("unit of length");
    assert_close("load", held("reduced load"), 1e-3 / (PI * RELAXED_PLANE * length * length / radius), 1e-12);
    assert_close("pressure", held("unit of pressure"), 0.5 * RELAXED_PLANE * length / radius, 1e-12);
    assert_close("alone", groups("", 40.0)("reduced load"), 0.25, 1e-12);
}
