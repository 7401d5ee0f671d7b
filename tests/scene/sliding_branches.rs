//! Source: thesis Secs 3.2 and 3.7 (works and friction at the edges; pull-off, toughness); Johnson, Int. J. Solids Struct. 32 (1995) 423; README.
//!
//! Goal: what stands in the rows of [sliding.branch] and [sliding.strength] is what the columns say: every row of a branch, stable or not, is a contact that a
//! plain scene finds as well, its turns are where the load turns, and an elastic strength is Johnson's as the process zone shrinks.
//!
//! Parameters: moduli, lengths and times that are no units, ν = 0.4, both signs of v; β = 100 in reduced units for folds in speed; a cylinder.
//!
//! Oracle: the identities of a row formed here; plain scenes at the half-width or the speed of a row; the same scene in reduced units; `JohnsonWave` in closed form.
//!
//! Tolerance: 1e-9 for products of one row; the bounds of both between two solutions; 1e-5 for the limit of three process zones.
// Flags and mirrored numbers are equal to the last bit.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::float_cmp, missing_docs)]

use std::collections::HashMap;
use std::f64::consts::PI;
use std::path::Path;
use viscotack::Estimate;
use viscotack::elastic::{Control, JohnsonWave, WestergaardWave};
use viscotack_program::outcome::{Row, Status};
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, Scene, read};

const WAVELENGTH: f64 = 7e-5;
const AMPLITUDE: f64 = 2e-6;
const WORK: f64 = 0.014;
const SPEED: f64 = 1e-4;

type Values = HashMap<&'static str, Estimate>;

fn parsed(text: &str) -> Scene {
    let document = Document::parse("test.toml", text.to_owned(), Path::new(".")).unwrap_or_else(|error| panic!("{}", error.rendered()));
    read::read(&document).unwrap_or_else(|error| panic!("{}\n{text}", error.rendered()))
}

fn solved(text: &str) -> Vec<(Row, Values)> {
    let plan = Plan::new(&parsed(text)).unwrap();
    let columns = plan.columns();
    plan.solve(0, &[])
        .into_iter()
        .map(|row| {
            assert_eq!(row.status, Status::Solved, "{:?} {:?}\n{text}", row.labels, row.reason);
            assert_eq!(row.values.len(), columns.len());
            assert_eq!(row.labels.len(), plan.labels().len());
            let values = columns.iter().zip(&row.values).filter_map(|(column, value)| Some((column.name, (*value)?))).collect();
            (row, values)
        })
        .collect()
}

fn scene(speed: &str, rest: &str) -> String {
    format!(
        "[material]\nrelaxed_modulus = 1.3e6\nglassy_modulus = 1.56e7\npoisson_ratio = 0.4\n\
         creep = [{{ fraction = 0.3, retardation_time = 0.02 }}, {{ fraction = 0.7, retardation_time = 0.002 }}]\n\
         [adhesion]\nwork_of_adhesion = {WORK}\nprocess_zone = {{ length = 1.7e-7 }}\n\
         [sliding]\nwave = {{ wavelength = {WAVELENGTH:e}, amplitude = {AMPLITUDE:e} }}\n{speed}\n{rest}"
    )
}

fn at(speed: f64, rest: &str) -> String {
    scene(&format!("speed = {speed:e}"), rest)
}

const LOADS: &str = "[sliding.branch]\nparameter = \"half_width\"\nfrom = 1.5e-6\nto = 3e-5\npoints = 16\n";

fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found:e} instead of {expected:e}");
}

/// Two solutions of the same contact: within the bounds of both.
fn assert_meets(what: &str, found: &Values, expected: &Values) {
    let mut compared = 0;
    // How many other contacts there are is said of single states alone.
    for (name, expected) in expected.iter().filter(|(name, _)| **name != "other_contacts") {
        let Some(found) = found.get(name) else { panic!("{what}: no {name}") };
        let allowed = found.error + expected.error + 1e-13 * expected.value.abs();
        assert!((found.value - expected.value).abs() <= allowed, "{what}, {name}: {found:?} and {expected:?}");
        compared += 1;
    }
    assert!(compared > 12, "{compared}");
}

#[test]
fn every_row_of_a_branch_obeys_the_identities_of_a_row() {
    let rows = solved(&at(SPEED, LOADS));
    let mut number = 0.0;
    for (row, values) in &rows {
        let value = |name: &str| values[name].value;
        number += 1.0;
        assert_eq!((row.label(0), row.label(1), row.label(2)), ("adhesive", "partial", "whole"));
        assert_eq!((value("point"), value("speed")), (number, SPEED));
        assert_close("edge", value("trailing_edge"), value("eccentricity") - value("half_width"), 1e-12);
        assert_close("edge", value("leading_edge"), value("eccentricity") + value("half_width"), 1e-12);
        let (trailing, leading) = (value("trailing_energy_release_rate"), value("leading_energy_release_rate"));
        assert_close("adhesive part", value("adhesive_friction_stress"), (trailing - leading) / WAVELENGTH, 1e-9);
        assert_close("opening", value("trailing_nonconservative_work"), WORK - trailing, 1e-9);
        assert_close("zone", value("trailing_process_zone"), 1.7e-7, 1e-12);
        assert_close("work of adhesion", value("work_of_adhesion"), WORK, 1e-12);
        if let Some(coefficient) = values.get("friction_coefficient") {
            assert_close("coefficient", coefficient.value, value("friction_stress") / value("mean_pressure"), 1e-9);
        }
        assert!(values.values().all(|estimate| estimate.error >= 0.0 && estimate.error.is_finite()));
    }
    let events: Vec<&str> = rows.iter().map(|(row, _)| row.label(3)).filter(|event| !event.is_empty()).collect();
    for event in ["separation", "pull_off", "zero_load", "snap_in"] {
        assert!(events.contains(&event), "{event} in {events:?}");
    }
    assert_eq!(rows.iter().filter(|(row, _)| row.label(3).is_empty()).count(), 16);
    // Between pull-off and snap-in a held load holds the contact, before and behind it does not.
    let place = |event: &str| rows.iter().position(|(row, _)| row.label(3) == event).unwrap();
    for (index, (row, values)) in rows.iter().enumerate().filter(|(_, (row, _))| row.label(3).is_empty()) {
        let stable = index > place("pull_off") && index < place("snap_in");
        assert_eq!(values["stable_under_load"].value, f64::from(u8::from(stable)), "{:?} at {index}", row.labels);
        if index < place("separation") {
            assert_eq!(values["stable_under_penetration"].value.to_bits(), 0);
        }
    }
    assert!(["pull_off", "snap_in"].iter().all(|event| !rows[place(event)].1.contains_key("stable_under_load")));
    assert!(!rows[place("separation")].1.contains_key("stable_under_penetration"));
    let load = |event: &str| rows[place(event)].1["mean_pressure"].value;
    assert!(rows.iter().all(|(_, values)| values["mean_pressure"].value <= load("snap_in") * (1.0 + 1e-12)));
    assert!(load("pull_off") < 0.0 && load("zero_load").abs() < 1e-6 * load("snap_in"));
}

#[test]
fn a_branch_of_loads_goes_through_the_contacts_of_plain_scenes() {
    let rows = solved(&at(SPEED, LOADS));
    // Beyond snap-in the half-width turns back: there two contacts have one half-width.
    let snap_in = rows.iter().position(|(row, _)| row.label(3) == "snap_in").unwrap();
    for (row, values) in rows.iter().take(snap_in).step_by(2) {
        let plain = solved(&at(SPEED, &format!("half_width = {:e}\n", values["half_width"].value)));
        // At a turn the half-width has a bound, which a plain scene does not know of.
        let mut expected = plain[0].1.clone();
        expected.remove("half_width");
        if row.label(3).is_empty() {
            assert_meets(row.label(3), values, &expected);
        }
        if values.get("stable_under_load").is_some_and(|stable| stable.value > 0.5) {
            let pressed = solved(&at(SPEED, &format!("mean_pressure = {:e}\n", values["mean_pressure"].value)));
            // The load has a bound as well, which a plain scene does not know of.
            for name in ["half_width", "eccentricity", "friction_stress", "penetration", "trailing_energy_release_rate"] {
                assert_close(name, pressed[0].1[name].value, values[name].value, 1e-6);
            }
        }
    }
    // Backward it is the mirrored branch.
    for ((_, there), (_, back)) in rows.iter().zip(solved(&at(-SPEED, LOADS))) {
        for (name, there) in there {
            let mirrored = ["speed", "eccentricity", "trailing_edge", "leading_edge"].contains(name);
            assert_eq!(there.value, if mirrored { -back[name].value } else { back[name].value }, "{name}");
        }
    }
}

#[test]
fn a_branch_of_speeds_goes_through_the_contacts_of_plain_scenes() {
    let branch = "[sliding.branch]\nparameter = \"speed\"\nfrom = 1e-6\nto = 1e-2\npoints = 8\n";
    let rows = solved(&scene("", &format!("mean_pressure = 7e3\n{branch}")));
    assert_eq!(rows.len(), 8);
    for (row, values) in &rows {
        assert_eq!((row.label(2), values["stable_under_load"].value), ("slow", 1.0));
        let plain = solved(&at(values["speed"].value, "mean_pressure = 7e3\n"));
        assert_meets("speed", values, &plain[0].1);
    }
}

#[test]
fn branches_of_adhesion_and_of_zones_go_through_the_contacts_of_plain_scenes() {
    for (parameter, from, to, line) in [
        ("work_of_adhesion", 5e-3, 3e-2, format!("work_of_adhesion = {WORK}")),
        ("process_zone", 1e-7, 5e-7, "process_zone = { length = 1.7e-7 }".to_owned()),
    ] {
        let branch =
            format!("penetration = 5e-7\n[sliding.branch]\nparameter = \"{parameter}\"\nfrom = {from:e}\nto = {to:e}\npoints = 5\n");
        for (_, values) in solved(&at(SPEED, &branch)) {
            let given = match parameter {
                "work_of_adhesion" => format!("work_of_adhesion = {:e}", values["work_of_adhesion"].value),
                _ => format!("process_zone = {{ length = {:e} }}", values["trailing_process_zone"].value),
            };
            let plain = solved(&at(SPEED, "penetration = 5e-7\n").replace(&line, &given));
            assert_meets(parameter, &values, &plain[0].1);
        }
    }
}

#[test]
fn a_range_of_loads_or_depths_is_kept() {
    for (parameter, from, to) in [("mean_pressure", -2e3, 2e4), ("penetration", 0.0, 1e-6)] {
        let branch = format!("[sliding.branch]\nparameter = \"{parameter}\"\nfrom = {from:e}\nto = {to:e}\npoints = 12\n");
        let rows = solved(&at(SPEED, &branch));
        assert!((9..=20).contains(&rows.len()), "{parameter}: {}", rows.len());
        for (_, values) in &rows {
            let found = values[parameter];
            assert!(found.value + found.error >= from && found.value - found.error <= to, "{parameter} {found:?}");
        }
    }
    // From penetrating to pulled, the curve leaves the range and comes back: all of it is there.
    let thin = "[sliding.branch]\nparameter = \"mean_pressure\"\nfrom = -1e3\nto = 1e3\npoints = 12\n";
    let rows = solved(&at(SPEED, thin));
    let unloaded: Vec<&str> = rows.iter().filter(|(row, _)| row.label(3) == "zero_load").map(|(row, _)| row.label(2)).collect();
    assert_eq!(unloaded, ["first", "second"]);
    let beyond = "[sliding.branch]\nparameter = \"mean_pressure\"\nfrom = 1e6\nto = 2e6\n";
    let rows = Plan::new(&parsed(&at(SPEED, beyond))).unwrap().solve(0, &[]);
    assert_eq!((rows.len(), rows[0].status), (1, Status::NoSuchState));
    assert!(rows[0].witness.as_ref().is_some_and(|limit| limit.name == "the largest load" && limit.value > 1e4), "{:?}", rows[0]);
}

#[test]
fn a_soft_frame_is_a_held_load_and_a_stiff_one_a_held_penetration() {
    for (stiffness, equal) in [("1e-3", "stable_under_load"), ("1e25", "stable_under_penetration")] {
        for (row, values) in solved(&at(SPEED, &format!("{LOADS}frame_stiffness = {stiffness}\n"))) {
            if row.label(3).is_empty() {
                assert_eq!(values["stable_in_frame"], values[equal], "{stiffness}");
            }
        }
    }
}

#[test]
fn a_strength_is_the_turns_of_the_branch() {
    let rows = solved(&at(SPEED, LOADS));
    let strength = solved(&at(SPEED, "[sliding.strength]\n"));
    assert_eq!(strength.len(), 1);
    let strength = &strength[0].1;
    let mut compared = 0;
    for (event, name) in [("pull_off", "pull_off"), ("snap_in", "snap_in"), ("separation", "separation"), ("zero_load", "zero_load")] {
        let (_, values) = rows.iter().find(|(row, _)| row.label(3) == event).unwrap();
        for (column, of) in [("mean_pressure", "pressure"), ("half_width", "half_width"), ("penetration", "penetration")] {
            let Some(found) = strength.get(format!("{name}_{of}").as_str()) else { continue };
            let expected = values[column];
            assert!(
                (found.value - expected.value).abs() <= found.error + expected.error + 1e-12 * expected.value.abs(),
                "{name} {of}: {found:?} {expected:?}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 11);
    assert!(strength["toughness"].value > 0.0);
}

#[test]
fn a_reduced_strength_is_the_same() {
    let relaxed = 1.3e6 / (1.0 - 0.16);
    let k = 2.0 * PI / WAVELENGTH;
    let reduced = solved(&format!(
        "units = \"reduced\"\n[material]\nglassy_modulus = 12\ncreep = [{{ fraction = 0.3, retardation_time = 1 }}, {{ fraction = 0.7, retardation_time = 0.1 }}]\n\
         [adhesion]\nwork_of_adhesion = {}\nprocess_zone = {{ length = {} }}\n[sliding]\nwave = {{}}\nspeed = {}\n[sliding.strength]\n",
        WORK / (PI * relaxed * k * AMPLITUDE * AMPLITUDE),
        1.7e-7 * k,
        SPEED * k * 0.02,
    ));
    let si = solved(&at(SPEED, "[sliding.strength]\n"));
    for (name, found) in &si[0].1 {
        let unit = match *name {
            "speed" => 1.0 / (k * 0.02),
            "work_of_adhesion" => PI * relaxed * k * AMPLITUDE * AMPLITUDE,
            "toughness" => 0.5 * relaxed * AMPLITUDE * AMPLITUDE,
            name if name.ends_with("pressure") => 0.5 * relaxed * k * AMPLITUDE,
            name if name.ends_with("penetration") => AMPLITUDE,
            _ => 1.0 / k,
        };
        assert_close(name, reduced[0].1[name].value * unit, found.value, 1e-8);
    }
}

#[test]
fn an_elastic_strength_is_johnsons_as_the_process_zone_shrinks() {
    let plane = 1.3e6 / (1.0 - 0.16);
    let wave = JohnsonWave::new(WestergaardWave::new(plane, WAVELENGTH, AMPLITUDE).unwrap(), WORK).unwrap();
    let zones = [2e-8, 1e-8, 5e-9];
    let strengths: Vec<Values> = zones
        .iter()
        .map(|zone| {
            let text = at(SPEED, "[sliding.strength]\n").replace("1.7e-7", &format!("{zone:e}"));
            let elastic: Vec<&str> = text.lines().filter(|line| !line.starts_with("glassy") && !line.starts_with("creep")).collect();
            solved(&elastic.join("\n"))[0].1.clone()
        })
        .collect();
    // Quadratic extrapolation to no zone: (f₁ − 6f₂ + 8f₃)/3.
    let limit = |name: &str| {
        let [first, second, third] = [0, 1, 2].map(|index: usize| strengths[index][name].value);
        (first - 6.0 * second + 8.0 * third) / 3.0
    };
    let (load, depth) = (wave.pull_off(Control::Load).unwrap(), wave.pull_off(Control::Penetration).unwrap());
    let snap_in = wave.snap_in().unwrap();
    for (name, expected) in [
        ("pull_off_pressure", load.mean_pressure),
        ("snap_in_pressure", snap_in.mean_pressure),
        ("separation_penetration", depth.penetration),
        ("separation_pressure", depth.mean_pressure),
        ("pull_off_half_width", load.contact_half_width),
    ] {
        let far = (strengths[2][name].value / expected - 1.0).abs();
        let error = (limit(name) / expected - 1.0).abs();
        println!("{name}: {far:.1e} at the smallest zone, {error:.1e} extrapolated");
        assert!(far < 0.02 && error < 1e-3 * 0.02f64.max(far) + 1e-5, "{name}: {far:e}, {error:e}");
    }
}

#[test]
fn a_quantity_that_does_not_exist_is_empty_with_its_reason() {
    // So sticky that the gap closes by itself: 2√Γ = 0.63.
    let text = "units = \"reduced\"\n[material]\nrelaxed_modulus = 1\n[adhesion]\nwork_of_adhesion = 0.1\nprocess_zone = { length = 0.01 }\n\
                [sliding]\nwave = {}\nspeed = 0\n[sliding.strength]\n";
    let (row, values) = solved(text).remove(0);
    let reason = row.reason.unwrap();
    assert!(!values.contains_key("toughness") && reason.contains("no toughness"), "{reason}");
    assert!(!values.contains_key("zero_load_half_width") && reason.contains("no zero load"), "{reason}");
    assert!(values.contains_key("pull_off_pressure"), "{reason}");
}

#[test]
fn folds_in_speed_name_the_gap_between_them() {
    let text = "units = \"reduced\"\naccuracy = 1e-3\n[material]\nglassy_modulus = 100\ncreep = [{ fraction = 1, retardation_time = 1 }]\n\
                [adhesion]\nwork_of_adhesion = 0.005\nprocess_zone = { length = 0.01 }\n[sliding]\nwave = {}\nmean_pressure = 0.05\n\
                [sliding.branch]\nparameter = \"speed\"\nfrom = 1e-5\nto = 1e4\npoints = 10\n";
    let rows = solved(text);
    let fold = |branch: &str, event: &str| rows.iter().find(|(row, _)| (row.label(2), row.label(3)) == (branch, event)).unwrap();
    let (slow, fast) = (fold("slow", "largest_speed"), fold("fast", "smallest_speed"));
    assert!(slow.1["speed"].value < fast.1["speed"].value);
    assert!(slow.0.reason.as_ref().unwrap().contains("no steady partial contact"), "{:?}", slow.0.reason);
    // A plain scene in between is in full contact.
    let between = (slow.1["speed"].value * fast.1["speed"].value).sqrt();
    let plain = text.split("[sliding.branch]").next().unwrap().to_owned() + &format!("speed = {between:e}\n");
    assert_eq!(solved(&plain)[0].0.label(1), "full");
    // Both ends are met from either side of the fold.
    for (row, values) in &rows {
        let beyond = if row.label(2) == "slow" {
            values["speed"].value > slow.1["speed"].value * 1.000_001
        } else {
            values["speed"].value < fast.1["speed"].value * 0.999_999
        };
        assert!(!beyond, "{:?}", row.labels);
    }
}

#[test]
fn an_isola_is_a_branch_of_its_own_with_two_folds() {
    let text = |branches: &str, load: f64, more: &str| {
        format!(
            "units = \"reduced\"\naccuracy = 1e-6\n[material]\nglassy_modulus = 10\ncreep = [{{ fraction = 1, retardation_time = 1 }}]\n\
             [adhesion]\nwork_of_adhesion = 0.002\nprocess_zone = {{ length = 0.03 }}\n[sliding]\nwave = {{}}\nmean_pressure = {load}\n\
             [sliding.branch]\nparameter = \"speed\"\nfrom = 0.1\nto = 100\npoints = 12\n{branches}\n{more}"
        )
    };
    // On request, and unasked where neither end carries the load: the same rows.
    let asked = solved(&text("branches = \"every\"", -0.0365, ""));
    let unasked = solved(&text("", -0.0365, ""));
    for rows in [&asked, &unasked] {
        for (event, known) in [("smallest_speed", 1.0263), ("largest_speed", 5.6409)] {
            let folds: Vec<_> = rows.iter().filter(|(row, _)| (row.label(2), row.label(3)) == ("isola", event)).collect();
            assert_eq!(folds.len(), 1, "{event}");
            assert_close(event, folds[0].1["speed"].value, known, 1e-4);
        }
        let isola = || rows.iter().filter(|(row, _)| row.label(2) == "isola");
        let stable = |flag: f64| {
            isola().filter(|(_, values)| values.get("stable_under_load").is_some_and(|reported| reported.value == flag)).count()
        };
        assert!(isola().count() == 14 && stable(1.0) > 3 && stable(0.0) > 3);
        // From the slow end comes the wide contact beyond snap-in alone, which no load holds.
        let from_an_end = rows.iter().filter(|(row, _)| row.label(2) == "slow" || row.label(2) == "fast");
        assert!(from_an_end.into_iter().all(|(_, values)| values["stable_under_load"].value == 0.0 && values["half_width"].value > 2.0));
    }
    assert!(unasked[0].0.reason.as_ref().unwrap().contains("neither end of the speeds has a contact"), "{:?}", unasked[0].0.reason);
    // Each row is a contact: both edges release Δγ against their motion.
    for (row, values) in asked.iter().filter(|(row, _)| row.label(2) == "isola") {
        let pressure = values["mean_pressure"];
        assert!((pressure.value + 0.0365).abs() <= pressure.error + 1e-12, "{:?} {pressure:?}", row.labels);
    }
}

#[test]
fn a_cylinder_has_branches_and_a_strength_without_penetration() {
    let text = |rest: &str| {
        format!(
            "[material]\nrelaxed_modulus = 1.3e6\nglassy_modulus = 1.3e7\npoisson_ratio = 0.4\ncreep = [{{ fraction = 1, retardation_time = 0.02 }}]\n\
             [adhesion]\nwork_of_adhesion = {WORK}\nprocess_zone = {{ length = 5e-7 }}\n[sliding]\ncylinder = {{ radius = 3e-3 }}\nspeed = 1e-5\n{rest}"
        )
    };
    let strength = solved(&text("[sliding.strength]\n"));
    let pull_off = strength[0].1["pull_off_load_per_width"];
    assert!(pull_off.value < 0.0 && strength[0].1.contains_key("zero_load_half_width") && !strength[0].1.contains_key("toughness"));
    let rows = solved(&text("[sliding.branch]\nparameter = \"load_per_width\"\nfrom = -10\nto = 20\npoints = 10\n"));
    let (_, turn) = rows.iter().find(|(row, _)| row.label(3) == "pull_off").unwrap();
    assert_close("pull-off", turn["load_per_width"].value, pull_off.value, 1e-8);
    assert!(!turn.contains_key("stable_under_penetration"));
    let (_, values) =
        rows.iter().rev().find(|(_, values)| values.get("stable_under_load").is_some_and(|stable| stable.value > 0.5)).unwrap();
    let plain = solved(&text(&format!("load_per_width = {:e}\n", values["load_per_width"].value)));
    for name in ["half_width", "eccentricity", "friction_per_width"] {
        assert_close(name, values[name].value, plain[0].1[name].value, 1e-6);
    }
}
