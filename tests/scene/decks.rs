//! Source: material cards as finite-element programs have them, and the keys beside them; theory in `src/material/isotropic.rs`.
//!
//! Goal: every problem sees the modulus that theory asks for; a material file holds the solid exactly; a deck is known by what it holds; every
//! remedy that a message offers works when pasted; nothing given is ignored.
//!
//! Oracle: closed forms (limits of the plane modulus, A²k² Im E*/4 of a full contact, Young's modulus in plane stress), and the same solid given in
//! another way. The force of each deck on a sphere is in `tests/inputs/expected_decks.json`.
//!
//! Tolerance: 1e-9 where a solver is involved, 1e-12 else.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::{Answer, Folder};
use serde_json::Value;

const CARD: &str =
    "*MATERIAL, NAME=EPDM\n*ELASTIC, MODULI=INSTANTANEOUS\n 8.0, 0.4\n*VISCOELASTIC, TIME=PRONY\n 0.3, 0.0, 0.1\n 0.4, 0.0, 10.0\n";
const UNITS: &str = "material.deck_units={ pressure = \"MPa\", time = \"s\" }";
/// The solid of [`CARD`] by keys: G = E/(2(1 + ν)), K = E/(3(1 − 2ν)).
const KEYS: &str = "[material]\nshear_modulus = 2857142.857142857\nbulk_modulus = 13333333.333333334\nmoduli = \"instantaneous\"\nshear_relaxation = [{ fraction = 0.3, relaxation_time = 0.1 }, { fraction = 0.4, decay_rate = 0.1 }]\n";

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number.as_f64().unwrap()],
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        Value::Object(entries) => entries.values().flat_map(numbers).collect(),
        _ => Vec::new(),
    }
}

/// `viscotack material --json` of a text, or of a deck with its units.
fn material(name: &str, text: &str, sets: &[&str]) -> Value {
    let answer = try_material(name, text, sets);
    assert_eq!(answer.code, 0, "{}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

fn try_material(name: &str, text: &str, sets: &[&str]) -> Answer {
    let folder = Folder::new();
    folder.write(name, text);
    let mut words = vec!["material", name, "--json"];
    words.extend(sets.iter().flat_map(|set| ["--set", set]));
    folder.call(&words)
}

fn close(left: &[f64], right: &[f64], tolerance: f64) {
    assert_eq!(left.len(), right.len());
    for (one, other) in left.iter().zip(right) {
        assert!((one - other).abs() <= tolerance * other.abs(), "{one:e} for {other:e}");
    }
}

/// The last row of a run's table.
fn last_row(scene: &str) -> std::collections::HashMap<String, f64> {
    let folder = Folder::new();
    folder.write("scene.toml", scene);
    let answer = folder.call(&["run", "scene.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{scene}\n{}", answer.stderr);
    // Of a history the end of the way.
    let text =
        std::fs::read_to_string(folder.path("out/path.csv")).or_else(|_| std::fs::read_to_string(folder.path("out/states.csv"))).unwrap();
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<String> = lines.next().unwrap().split(',').map(|name| name.split(' ').next().unwrap().to_owned()).collect();
    names.into_iter().zip(lines.next_back().unwrap().split(',')).filter_map(|(name, word)| Some((name, word.parse().ok()?))).collect()
}

#[test]
fn a_deck_and_keys_are_the_same_solid_and_a_material_file_holds_it() {
    let deck = material("card.inp", CARD, &[UNITS]);
    let keys = material("solid.toml", KEYS, &[]);
    close(&numbers(&deck["solid"]), &numbers(&keys["solid"]), 1e-12);
    close(&numbers(&deck["relaxation"]), &numbers(&keys["relaxation"]), 1e-12);
    assert_eq!(deck["origin"]["program"], "Abaqus");
    // By what it holds, whatever it is called.
    for name in ["card", "card.txt", "card.toml.bak", "CARD.K"] {
        assert_eq!(material(name, CARD, &[UNITS])["solid"], deck["solid"]);
    }
    let folder = Folder::new();
    folder.write("card.inp", CARD);
    let answer = folder.call(&["material", "card.inp", "--set", UNITS, "--out", "out"]);
    assert_eq!(answer.code, 0, "{}", answer.stderr);
    let file = std::fs::read_to_string(folder.path("out").join("material.toml")).unwrap();
    let again = material("again.toml", &file, &[]);
    close(&numbers(&again["solid"]), &numbers(&deck["solid"]), 1e-15);
    // Closed forms of both ends.
    let (g, k) = (8e6 / 2.8, 8e6 / 0.6);
    let plane = |g: f64| 4.0 * g * (3.0 * k + g) / (3.0 * k + 4.0 * g);
    close(&numbers(&deck["solid"]["plane_strain"]["instantaneous"]), &[plane(g)], 1e-14);
    close(&numbers(&deck["solid"]["plane_strain"]["long_term"]), &[plane(0.3 * g)], 1e-14);
    close(&numbers(&deck["glassy_modulus"]), &[8e6], 1e-14);
    let ratio = |g: f64| (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g));
    close(&numbers(&deck["solid"]["poisson_ratio"]), &[ratio(g), ratio(0.3 * g)], 1e-14);
}

#[test]
fn long_term_and_instantaneous_moduli_are_one_solid() {
    let long = "[material]\nshear_modulus = \"0.9 MPa\"\nbulk_modulus = \"2 MPa\"\nmoduli = \"long_term\"\nshear_relaxation = [{ fraction = 0.7, relaxation_time = \"3 ms\" }]\nbulk_relaxation = [{ fraction = 0.2, relaxation_time = \"3 ms\" }]\n";
    let short = "[material]\nshear_modulus = \"3 MPa\"\nbulk_modulus = \"2.5 MPa\"\nmoduli = \"instantaneous\"\nshear_relaxation = [{ modulus = \"2.1 MPa\", decay_rate = \"0.333333333333333333 1/ms\" }]\nbulk_relaxation = [{ modulus = \"0.5 MPa\", relaxation_time = \"3 ms\" }]\n";
    let solids = [long, short].map(|text| material("solid.toml", text, &[]));
    close(
        &numbers(&solids[0]["solid"]["plane_strain"]["instantaneous"]),
        &numbers(&solids[1]["solid"]["plane_strain"]["instantaneous"]),
        1e-13,
    );
    close(&numbers(&solids[0]["solid"]["plane_strain"]["long_term"]), &numbers(&solids[1]["solid"]["plane_strain"]["long_term"]), 1e-13);
    // A constant Poisson ratio scales the shear series.
    let constant = material("solid.toml", &KEYS.replace("bulk_modulus = 13333333.333333334", "poisson_ratio = 0.4"), &[]);
    close(&numbers(&constant["glassy_modulus"]), &[8e6], 1e-12);
    assert!(constant["solid"].is_null());
}

/// The moduli of [`KEYS`]: shear, bulk, plane and Young's at the ends.
fn ends() -> [[f64; 2]; 2] {
    let (g, k) = (8e6 / 2.8, 8e6 / 0.6);
    let of = |g: f64| [9.0 * k * g / (3.0 * k + g), 4.0 * g * (3.0 * k + g) / (3.0 * k + 4.0 * g)];
    [of(0.3 * g), of(g)]
}

#[test]
fn every_problem_sees_its_own_modulus() {
    let [relaxed, glassy] = ends();
    // The balance of an opening crack is K²⟨J⟩ = work: K²/work is the glassy modulus of its plane state when fast, the relaxed one when slow.
    for (plane, index) in [("stress", 0), ("strain", 1)] {
        for (speed, modulus) in [("1e9 m/s", glassy[index]), ("1e-17 m/s", relaxed[index])] {
            let scene = format!(
                "accuracy = 1e-10\n{KEYS}[adhesion]\nwork_of_adhesion = 0.05\nprocess_zone = {{ length = 1e-7 }}\n[crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"{plane}\"\ntheories = [\"virtual_work\"]\nspeed = \"{speed}\"\n"
            );
            let opening = last_row(&scene);
            let factor = opening["stress_intensity"].powi(2) / 0.05;
            assert!((factor / modulus - 1.0).abs() < 1e-6, "{plane} {speed}: {factor:e} for {modulus:e}");
        }
    }
    // A rigid wave in full contact: friction A²k² Im E*(kv)/4.
    let (length, amplitude, speed) = (1e-3, 1e-6, 2e-4);
    let scene = format!(
        "accuracy = 1e-9\n{KEYS}[sliding]\nwave = {{ wavelength = {length}, amplitude = {amplitude} }}\nspeed = {speed}\nmean_pressure = 1e6\ncontacts = [\"adhesiveless\"]\n"
    );
    {
        let row = last_row(&scene);
        let wave = std::f64::consts::TAU / length;
        let (g, k) = (8e6 / 2.8, 8e6 / 0.6);
        let frequency = wave * speed;
        let shear = [(0.3, 0.1), (0.4, 10.0)].into_iter().fold((0.3 * g, 0.0), |(storage, loss), (part, time)| {
            let x = frequency * time;
            (storage + part * g * x * x / (1.0 + x * x), loss + part * g * x / (1.0 + x * x))
        });
        // E* = 4G(3K + G)/(3K + 4G) of complex numbers.
        let (a, b) = shear;
        let (numerator, denominator) =
            ((4.0 * (a * (3.0 * k + a) - b * b), 4.0 * (b * (3.0 * k + a) + a * b)), (3.0 * k + 4.0 * a, 4.0 * b));
        let loss = (numerator.1 * denominator.0 - numerator.0 * denominator.1) / (denominator.0.powi(2) + denominator.1.powi(2));
        let right = (amplitude * wave).powi(2) * loss / 4.0;
        assert!((row["friction_stress"] / right - 1.0).abs() < 1e-8, "{:e} for {right:e}", row["friction_stress"]);
    }
}

#[test]
fn a_strip_needs_a_constant_poisson_ratio_and_its_remedies_work() {
    let scene = |material: &str, lateral: &str, plane: &str| {
        format!(
            "{material}[adhesion]\nwork_of_adhesion = 100.0\nprocess_zone = {{ length = 1e-6 }}\n[crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"{plane}\"\ntheories = [\"virtual_work\"]\nstrip = {{ half_height = 0.01, strain = 0.1{lateral} }}\n"
        )
    };
    let call = |text: String| {
        let folder = Folder::new();
        folder.write("scene.toml", text);
        folder.call(&["run", "scene.toml", "--out", "out"])
    };
    let refused = call(scene(KEYS, "", "stress"));
    assert_eq!(refused.code, 2, "{}", refused.stdout);
    assert!(refused.stderr.contains("lateral = \"uniaxial\"") && refused.stderr.contains("material.poisson_ratio"), "{}", refused.stderr);
    assert_eq!(call(scene(KEYS, ", lateral = \"uniaxial\"", "strain")).code, 2);
    let mended = call(scene(KEYS, ", lateral = \"uniaxial\"", "stress"));
    assert_eq!(mended.code, 0, "{}", mended.stderr);
    let constant = KEYS.replace("bulk_modulus = 13333333.333333334", "poisson_ratio = 0.4");
    assert_eq!(call(scene(&constant, "", "stress")).code, 0);
}

/// Fractions of Young's modulus, with one modulus or both.
#[test]
fn fractions_of_the_instantaneous_modulus() {
    let text = |moduli: &str, first: f64| {
        format!(
            "[material]\n{moduli}\nrelaxation = [{{ fraction = {first}, relaxation_time = 1.0 }}, {{ fraction = 0.5, decay_rate = 0.01 }}]\n"
        )
    };
    let value = |moduli: &str| {
        let made = material("m.toml", &text(moduli, 0.4), &[]);
        [numbers(&made["relaxed_modulus"])[0], numbers(&made["glassy_modulus"])[0]]
    };
    close(&value("glassy_modulus = \"10 MPa\""), &[1e6, 1e7], 1e-12);
    close(&value("relaxed_modulus = \"1 MPa\""), &[1e6, 1e7], 1e-12);
    // Both moduli and fractions that do not sum to one: which is meant is not guessed, and the remedy is to delete one line.
    let both = try_material("m.toml", &text("relaxed_modulus = \"1 MPa\"\nglassy_modulus = \"10 MPa\"", 0.4), &[]);
    assert!(both.code == 2 && both.stderr.contains("delete the line relaxed_modulus"), "{}", both.stderr);
    // Fractions that sum to one need both: a solid or a liquid, as the reader says.
    let whole = try_material("m.toml", &text("glassy_modulus = \"10 MPa\"", 0.5), &[]);
    assert!(whole.code == 2 && whole.stderr.contains("relaxed_modulus = 0"), "{}", whole.stderr);
    let liquid = material("m.toml", &text("glassy_modulus = \"10 MPa\"\nrelaxed_modulus = 0", 0.5), &[]);
    close(&numbers(&liquid["steady_viscosity"]), &[5e6 + 5e8], 1e-12);
    let solid = material("m.toml", &text("glassy_modulus = \"10 MPa\"\nrelaxed_modulus = \"1 MPa\"", 0.5), &[]);
    close(&numbers(&solid["relaxation"]), &[4.5e6, 100.0, 4.5e6, 1.0], 1e-12);
    for (moduli, first) in [("glassy_modulus = 1e7", 0.9), ("relaxed_modulus = 1e6", 0.5), ("relaxed_modulus = 0", 0.4), ("", 0.4)] {
        assert_eq!(try_material("m.toml", &text(moduli, first), &[]).code, 2, "{moduli}");
    }
}

/// A wrong text, the words of its message, and what to do: replace one text by another, or add a `--set`.
#[test]
fn remedies_work_when_pasted() {
    let ansys = "MP,EX,1,2700\nMP,NUXY,1,0.37\nTB,PRONY,1,,2,SHEAR\nTBDATA,1,0.3,0.01,0.2,1\n";
    let dyna = "*MAT_076\n1,1e-9,1500.\n\n0.8,20.\n0.25,0.\n";
    let comsol = "E 3[MPa]\nnu 0.45\nG1 0.9[MPa]\ntau1 30[ms]\n";
    let moose = "[Materials]\n[m]\ntype = GeneralizedMaxwellModel\nyoung_modulus = 10\npoisson_ratio = 0.2\ncreep_modulus = '3 2'\ncreep_viscosity = '1 10'\n[]\n[]\n";
    let keys = KEYS;
    let cases: &[(&str, String, &str, &str, &str)] = &[
        (
            UNITS,
            CARD.replace("*ELASTIC, MODULI=INSTANTANEOUS\n 8.0, 0.4\n", "*HYPERELASTIC, NEO HOOKE\n 1., 0.1\n"),
            "*ELASTIC, MODULI=LONG TERM",
            "*HYPERELASTIC",
            "*ELASTIC, MODULI=LONG TERM\n 3.0, 0.49\n*HYPERELASTIC",
        ),
        (UNITS, CARD.replace("INSTANTANEOUS", "SHORT"), "MODULI=LONG TERM", "SHORT", "LONG TERM"),
        (UNITS, CARD.replace(" 8.0, 0.4\n", " 8.0, 0.4\n 7.0, 0.4, 50.\n"), "keep one line", " 7.0, 0.4, 50.\n", ""),
        (UNITS, CARD.replace("0.3, 0.0, 0.1", "0.3, 0.1"), "for a constant bulk modulus k is 0", "0.3, 0.1", "0.3, 0, 0.1"),
        (UNITS, CARD.replace("0.3, 0.0", "-0.3, 0.0"), "must be 0 or more", "-0.3", "0.3"),
        (UNITS, CARD.replace("8.0, 0.4", "8.0, 0.51"), "at most 0.5", "0.51", "0.49"),
        (UNITS, ansys.replace("MP,NUXY,1,0.37\n", ""), "MP,NUXY,1,0.49", "TB,PRONY", "MP,NUXY,1,0.49\nTB,PRONY"),
        (UNITS, ansys.replace("MP,EX,1,2700\n", ""), "MP,EX,1,3.0", "TB,PRONY", "MP,EX,1,3.0\nTB,PRONY"),
        (UNITS, ansys.replace(",SHEAR", ",ELASTIC"), "SHEAR or BULK", ",ELASTIC", ",SHEAR"),
        (UNITS, ansys.replace(",,2,", ",,3,"), "make both agree", ",,3,", ",,2,"),
        (UNITS, dyna.replace("\n\n", "\n"), "put an empty line above it", "0.8,20.", "\n0.8,20."),
        (UNITS, dyna.replace("1500.", "0."), "must be greater than 0", "0.\n\n", "1500.\n\n"),
        (
            UNITS,
            dyna.replace("1500.", "").replace("0.8,20.", "0.8,20.,900.,3."),
            "0.0,0.0,900.0,0.0",
            "0.25,0.",
            "0.25,0.\n0.0,0.0,900.0,0.0",
        ),
        (UNITS, dyna.replace("0.8,20.", "0.8,20.,900.,3.").replace("0.25,0.", "0.25,0.,600.,0."), "set BULK to 0", "1500.", "0."),
        (UNITS, dyna.replace("1,1e-9,1500.", "1 1e-9 1500."), "write commas", "1 1e-9 1500.", "1,1e-9,1500."),
        ("accuracy=1e-3", comsol.replace("tau1 30[ms]\n", ""), "add a line: tau1 1[s]", "G1 0.9[MPa]\n", "G1 0.9[MPa]\ntau1 1[s]\n"),
        ("accuracy=1e-3", comsol.replace("[MPa]\nnu", "[s]\nnu"), "[Pa] or [MPa]", "3[s]", "3[MPa]"),
        (
            UNITS,
            moose.replace("poisson_ratio = 0.2\n", ""),
            "write poisson_ratio = 0.3",
            "creep_modulus",
            "poisson_ratio = 0.3\ncreep_modulus",
        ),
        (UNITS, moose.replace("'1 10'", "'1'"), "both must have as many", "'1'", "'1 10'"),
        (
            "accuracy=1e-3",
            keys.replace("moduli = \"instantaneous\"\n", ""),
            "moduli = \"instantaneous\"",
            "shear_relaxation",
            "moduli = \"instantaneous\"\nshear_relaxation",
        ),
        (
            "accuracy=1e-3",
            keys.replace("bulk_modulus = 13333333.333333334\n", ""),
            "poisson_ratio = 0.5",
            "moduli",
            "poisson_ratio = 0.5\nmoduli",
        ),
        (
            "accuracy=1e-3",
            keys.replace("moduli = \"inst", "poisson_ratio = 0.4\nmoduli = \"inst"),
            "leave one of the two out",
            "poisson_ratio = 0.4\n",
            "",
        ),
        ("accuracy=1e-3", keys.replace("0.1 }]", "\"0.1 Hz\" }]"), "write it in 1/s", "0.1 Hz", "0.1 1/s"),
        ("accuracy=1e-3", keys.replace("[material]\n", "[material]\nglassy_modulus = 1e6\n"), "leave it out", "glassy_modulus = 1e6\n", ""),
    ];
    for (set, wrong, words, from, to) in cases {
        let name = if wrong.starts_with("[material]") { "m.toml" } else { "card" };
        let sets: Vec<&str> = if set.starts_with("material") { vec![set] } else { Vec::new() };
        let refused = try_material(name, wrong, &sets);
        assert_eq!(refused.code, 2, "{wrong}\n{}", refused.stdout);
        assert!(refused.stderr.contains(words), "{words} is not in:\n{}", refused.stderr);
        assert!(wrong.contains(from), "{from}");
        let mended = try_material(name, &wrong.replacen(from, to, 1), &sets);
        assert_eq!(mended.code, 0, "{wrong}\nmended: {from} -> {to}\n{}", mended.stderr);
    }
    // The line that a missing unit asks for, as the message prints it.
    let refused = try_material("card.inp", CARD, &[]);
    let line = refused.stderr.split("--set '").nth(1).and_then(|rest| rest.split('\'').next()).expect("a line to type").to_owned();
    assert_eq!(try_material("card.inp", CARD, &[&line]).code, 0, "{line}");
}

/// Whatever is cut off or repeated, a deck is read or refused with a reason.
#[test]
fn decks_cut_short_are_refused_or_read() {
    let decks = [
        CARD.to_owned(),
        "MP,EX,1,2700\nMP,NUXY,1,0.37\nTB,PRONY,1,,2,SHEAR\nTBDATA,1,0.3,0.01,0.2,1\n".to_owned(),
        "*MAT_076_TITLE\nname\n1,1e-9,1500.\n\n0.8,20.\n0.25,0.\n".to_owned(),
    ];
    for deck in decks {
        for end in (0..deck.len()).step_by(5) {
            let answer = try_material("card", deck.get(..end).unwrap(), &[UNITS]);
            assert!(answer.code == 0 || (answer.code == 2 && answer.stderr.contains('×')), "{end}: {} {}", answer.code, answer.stderr);
        }
    }
}
