//! Source: tables of materials as instruments and spreadsheets write them; time–temperature superposition, Ferry, Viscoelastic Properties of Polymers, chapter 11.
//!
//! Goal: units and meanings of columns are read right, or refused with what to type; temperatures that wander are one isotherm; shift factors may be relative to any
//! temperature.
//!
//! Oracle: one Maxwell term beside a spring, tabulated by its closed form in other units, of shear, at other temperatures; every table must give the same solid.
//!
//! Tolerance: 2e-3, the digits of the tables.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Answer, Folder};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// E0 and E of the term (Pa), its time (s) at 20 °C; ten times faster at each 20 K more.
const SOLID: [f64; 3] = [1.5e6, 4e6, 0.5];

fn moduli(frequency: f64, time: f64) -> [f64; 2] {
    let x = TAU * frequency * time;
    [SOLID[0] + SOLID[1] * x * x / (1.0 + x * x), SOLID[1] * x / (1.0 + x * x)]
}

/// A table of E′ and E″ over the header given: places in Hz, times a factor; temperatures written by a function of °C; moduli times a factor.
fn table(header: &str, temperatures: &[f64], written: impl Fn(f64) -> f64, factors: [f64; 2], wander: f64) -> String {
    let mut text = format!("{header}\n");
    for celsius in temperatures {
        let time = SOLID[2] * 10f64.powf((20.0 - celsius) / 20.0);
        for k in 0..25 {
            let frequency = 1e-3 * 10f64.powf(f64::from(k) / 4.0);
            let [storage, loss] = moduli(frequency, time).map(|modulus| modulus * factors[1]);
            let own = written(celsius + wander * f64::from(k % 5 - 2));
            writeln!(text, "{own:.6}, {:.9e}, {storage:.9e}, {loss:.9e}", frequency * factors[0]).unwrap();
        }
    }
    text
}

fn material(folder: &Folder, data: &str, rest: &str) -> Answer {
    folder.write("data.csv", data);
    let shift = "shift = { factors = [{ temperature = \"0 °C\", factor = 10 }, { temperature = \"20 °C\", factor = 1 }, { temperature = \"40 °C\", factor = 0.1 }] }";
    let shift = if rest.contains("shift") { "" } else { shift };
    folder.write(
        "scene.toml",
        format!("[material]\ndata = \"data.csv\"\npoisson_ratio = 0.25\nreference_temperature = \"20 °C\"\n{shift}\n{rest}\n"),
    );
    folder.call(&["material", "scene.toml", "--json"])
}

/// E0, the strength and the time of the only term that counts.
fn solid(answer: Answer) -> [f64; 3] {
    let found = answer.ended(0).json();
    let terms = found["relaxation"].as_array().unwrap_or_else(|| panic!("{found}"));
    let of = |term: &serde_json::Value, key: &str| term[key].as_f64().unwrap_or_else(|| panic!("{found}"));
    let strongest = terms.iter().max_by(|one, other| of(one, "modulus").total_cmp(&of(other, "modulus"))).unwrap();
    [found["relaxed_modulus"].as_f64().unwrap(), of(strongest, "modulus"), of(strongest, "relaxation_time")]
}

fn same(found: [f64; 3], right: [f64; 3], what: &str) {
    for (one, other) in found.iter().zip(right) {
        assert!((one / other - 1.0).abs() < 2e-3, "{what}: {found:?} instead of {right:?}");
    }
}

#[test]
fn units_of_every_column() {
    let folder = Folder::new();
    let celsius = |t: f64| t;
    let three = [0.0, 20.0, 40.0];
    for (header, written, factors) in [
        ("temperature (°C), frequency (Hz), storage modulus (Pa), loss modulus (Pa)", celsius as fn(f64) -> f64, [1.0, 1.0]),
        ("Temp (K), f (mHz), E'/MPa, E''/MPa", |t| t + 273.15, [1e3, 1e-6]),
        ("temperature (°F), omega [rad/s], E′ [psi], E″ [psi]", |t| 1.8 * t + 32.0, [TAU, 1.0 / 6894.757293168361]),
        ("temp (degC), frequency (Hz), storage modulus (dyn/cm2), loss modulus (dyn/cm²)", celsius, [1.0, 10.0]),
        ("temperature (°C), frequency (Hz), E' (N/mm2), E'' (N/mm^2)", celsius, [1.0, 1e-6]),
        // E = 2(1 + ν)G with ν = 1/4.
        ("temperature (°C), frequency (Hz), G' (Pa), G'' (Pa)", celsius, [1.0, 0.4]),
    ] {
        same(solid(material(&folder, &table(header, &three, written, factors, 0.0), "")), SOLID, header);
    }
}

/// A name that is known with a unit that is not is no column to pass over.
#[test]
fn units_that_are_not_known_are_named() {
    let folder = Folder::new();
    for (column, says) in [
        ("Temp (C), frequency (Hz), E' (Pa), E'' (Pa)", "`Temp (C)`"),
        ("temperature (F), frequency (Hz), E' (Pa), E'' (Pa)", "`temperature (F)`"),
        ("temperature (°C), frequency (cps), E' (Pa), E'' (Pa)", "`frequency (cps)`"),
        ("temperature (°C), frequency (Hz), E' (kip), E'' (Pa)", "`E' (kip)`"),
    ] {
        let answer = material(&folder, &table(column, &[20.0], |t| t, [1.0, 1.0], 0.0), "").ended(2);
        assert!(answer.stderr.contains(says) && answer.stderr.contains("must be that of"), "{}", answer.stderr);
    }
}

#[test]
fn shear_has_to_be_said_where_a_scene_names_the_columns() {
    let folder = Folder::new();
    let named = "[material.columns]\nfrequency = \"f in Hz\"\nstorage_modulus = \"G prime in Pa\"\nloss_modulus = \"G double in Pa\"\n";
    let data = table("temperature (°C), f, G prime, G double", &[20.0], |t| t, [1.0, 0.4], 0.0);
    let answer = material(&folder, &data, named).ended(2);
    assert!(answer.stderr.contains("of = \"shear\""), "{}", answer.stderr);
    same(solid(material(&folder, &data, &format!("{named}of = \"shear\"\n"))), SOLID, "shear");
    let [relaxed, strength, time] = SOLID;
    same(solid(material(&folder, &data, &format!("{named}of = \"tension\"\n"))), [0.4 * relaxed, 0.4 * strength, time], "tension");
}

/// Held temperatures wander by some hundredths of a kelvin, also below the first one of the table of factors; each row is shifted from its own.
#[test]
fn temperatures_that_wander_are_one_isotherm() {
    let folder = Folder::new();
    let data = table("temperature (°C), frequency (Hz), E' (Pa), E'' (Pa)", &[0.0, 20.0, 40.0], |t| t, [1.0, 1.0], 0.02);
    let answer = material(&folder, &data, "").ended(0);
    assert!(answer.stdout.contains("3 temperatures wander by up to 0.08 K"), "{}", answer.stdout);
    // 0.04 K of 20 K a decade: 0.5 % of a time at most, half a per cent of a modulus at its steepest.
    let found = solid(answer);
    assert!(found.iter().zip(SOLID).all(|(one, other)| (one / other - 1.0).abs() < 5e-3), "{found:?}");
    let answer = material(&folder, &data, "temperature_tolerance = \"0.01 K\"\n").ended(2);
    assert!(answer.stderr.contains("no shift factor"), "{}", answer.stderr);
}

/// Factors may be relative to any temperature: what holds at the reference temperature is the same.
#[test]
fn factors_relative_to_another_temperature() {
    let folder = Folder::new();
    let data = table("temperature (°C), frequency (Hz), E' (Pa), E'' (Pa)", &[0.0, 20.0, 40.0], |t| t, [1.0, 1.0], 0.0);
    folder.write("shift.csv", "temperature (K), log10_factor\n273.15, 0\n293.15, -1\n313.15, -2\n");
    same(solid(material(&folder, &data, "shift = { table = \"shift.csv\" }\n")), SOLID, "table");
    folder.write("shift.txt", "Temperatur [°C];log aT;Fehler\n0,0;1,0;0,1\n20,0;0,0;0,1\n40,0;-1,0;0,1\n");
    let answer = material(&folder, &data, "shift = { table = \"shift.txt\" }\n");
    assert!(answer.stdout.contains("decimal commas") && answer.stdout.contains("`Fehler`"), "{}", answer.stdout);
    same(solid(answer), SOLID, "decimal commas");
    folder.write("shift.txt", "T/°C\tln(aT)\n0\t2.302585093\n20\t0\n40\t-2.302585093\n");
    same(solid(material(&folder, &data, "shift = { table = \"shift.txt\" }\n")), SOLID, "natural logarithm");
    let factors = "shift = { factors = [{ temperature = \"0 °C\", factor = 4e3 }, { temperature = \"20 °C\", factor = 4e2 }, { temperature = \"40 °C\", factor = 40 }] }\n";
    same(solid(material(&folder, &data, factors)), SOLID, "factors");
    // Warmer by one step: ten times faster.
    let [relaxed, strength, time] = SOLID;
    same(solid(material(&folder, &data, &format!("temperature = \"40 °C\"\n{factors}"))), [relaxed, strength, 0.1 * time], "warm");
}

/// What is no table is refused before it is read: folders, devices, files beyond memory; and what holds no text.
#[test]
fn only_files_of_text_are_read() {
    let folder = Folder::new();
    let says = |data: &str, words: &str| {
        folder.write("scene.toml", format!("[material]\ndata = \"{data}\"\n"));
        let answer = folder.call(&["material", "scene.toml"]).ended(2);
        assert!(answer.stderr.contains(words), "{}", answer.stderr);
    };
    std::fs::create_dir(folder.path("folder.csv")).unwrap();
    says("folder.csv", "it is a folder, not a file");
    #[cfg(unix)]
    says("/dev/zero", "only regular files are read");
    folder.write("zero.csv", b"frequency (Hz), E' (Pa)\n1,\0\n");
    says("zero.csv", "line 2 holds a zero byte");
    // A file with a hole takes no place on the disk.
    std::fs::File::create(folder.path("large.csv")).unwrap().set_len(1 << 32).unwrap();
    says("large.csv", "more than 64 MiB");
}

/// Where two columns or two units stand for one quantity, the table says which, or is refused.
#[test]
fn what_contradicts_itself_is_refused() {
    let folder = Folder::new();
    let right = table("Frequency (Hz), Frequency [rad/s], E' (Pa), E'' (Pa)", &[], |t| t, [1.0, 1.0], 0.0);
    let rows = |factor: f64| -> String {
        (0..8)
            .map(|k| {
                let frequency = 10f64.powf(f64::from(k) / 2.0 - 2.0);
                let [storage, loss] = moduli(frequency, SOLID[2]);
                format!("{frequency:e}, {:e}, {storage:e}, {loss:e}\n", frequency * TAU * factor)
            })
            .collect()
    };
    for (data, says) in [
        (format!("{right}{}", rows(1.02)), "is not 2π times the frequency"),
        (format!("frequency (Hz), x, G' (Pa), E'' (Pa)\n{}", rows(1.0)), "of shear or of tension?"),
        (format!("frequency (Hz), x, E' (Pa), E'' (Pa)\nHz, , MPa, Pa\n{}", rows(1.0)), "has two units"),
        (format!("frequency (Hz), x, E' (Pa), E' (kPa)\n{}", rows(1.0)), "two columns hold the storage modulus"),
        (
            format!("frequency (Hz), x, E' (Pa), E'' (Pa)\n{}frequency (Hz), x, E' (Pa), E'' (Pa)\n{}", rows(1.0), rows(1.0)),
            "of which temperature?",
        ),
    ] {
        let answer = material(&folder, &data, "").ended(2);
        assert!(answer.stderr.contains(says), "{says}: {}", answer.stderr);
    }
    same(solid(material(&folder, &format!("{right}{}", rows(1.0)), "")), SOLID, "both frequencies");
}

/// What an error offers to type is right: the unit that is misspelt, not another one.
#[test]
fn remedies_of_units_work_where_they_are_pasted() {
    let folder = Folder::new();
    for (header, written, factors, key) in [
        (
            "Temp (F), frequency (Hz), E' (Pa), E'' (Pa)",
            (|t| 1.8 * t + 32.0) as fn(f64) -> f64,
            [1.0, 1.0],
            "temperature = \"Temp (F) in °F\"",
        ),
        ("temperature (°C), frequency (HZ), E' (Pa), E'' (Pa)", |t| t, [1.0, 1.0], "frequency = \"frequency (HZ) in Hz\""),
        ("temperature (°C), frequency (Hz), E' (MPA), E'' (MPa)", |t| t, [1.0, 1e-6], "storage_modulus = \"E' (MPA) in MPa\""),
    ] {
        let data = table(header, &[0.0, 20.0, 40.0], written, factors, 0.0);
        let answer = material(&folder, &data, "").ended(2);
        assert!(answer.stderr.contains(key), "{}", answer.stderr);
        same(solid(material(&folder, &data, &format!("[material.columns]\n{key}\n"))), SOLID, header);
    }
}

/// The export of an instrument is known by what it holds, whatever its name.
#[test]
fn the_command_takes_an_export_as_it_is() {
    let folder = Folder::new();
    let data = table("temperature (°C); frequency (Hz); E' (Pa); E'' (Pa)", &[20.0], |t| t, [1.0, 1.0], 0.0).replace(", ", ";");
    for name in ["export.txt", "export.DAT", "export", "export.csv"] {
        folder.write(name, format!("Instrument 7\n{data}"));
        same(solid(folder.call(&["material", name, "--json"])), SOLID, name);
    }
    folder.write("other.txt", "[material]\nrelaxed_modulus = 1e6\n");
    assert_eq!(folder.call(&["material", "other.txt", "--json"]).ended(0).json()["relaxed_modulus"].as_f64(), Some(1e6));
}
