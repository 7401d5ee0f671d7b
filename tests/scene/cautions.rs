//! Source: `scene/plausible`, `material.cautions`, the headers of material tables.
//!
//! Goal: what may be wrong with a material stays with it in its file; numbers a thousand times off are asked about and never refused; tables with usual headers are
//! read, and others get the lines to type for all columns at once.
//! Oracle: the words that must be said, and the same moduli from every way to say the units.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use crate::command_support;
use crate::material::SPHERE;

use command_support::Folder;
use viscotack::material::{Material, RelaxationTerm};

/// A table of a solid over four decades, with other headers and in another unit (Pa).
fn table(header: &str, unit: f64) -> String {
    let terms = [0.1, 0.01, 1e-3].map(|relaxation_time| RelaxationTerm { modulus: 2e6, relaxation_time });
    let solid = Material::from_relaxation(1e6, &terms).unwrap();
    let mut text = format!("{header}\n");
    for index in 0..=24 {
        let frequency = 0.1 * 10f64.powf(f64::from(index) / 6.0);
        let modulus = solid.complex_modulus(std::f64::consts::TAU * frequency).unwrap();
        text += &format!("{frequency:.17e},{:.17e},{:.17e}\n", modulus.storage / unit, modulus.loss / unit);
    }
    text
}

const SOLID: &str = "[material]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.49\n";

#[test]
fn usual_headers_are_read() {
    let folder = Folder::new();
    for header in [
        "freq (Hz),Storage Mod (MPa),Loss Mod (MPa)",
        "freq_Hz,storage_MPa,loss_MPa",
        "f_Hz,E'_MPa,E''_MPa",
        "Frequency Hz,Storage Modulus MPa,Loss Modulus MPa",
    ] {
        folder.write("dma.csv", table(header, 1e6));
        let answer = folder.call(&["material", "dma.csv", "--json"]).ended(0).json();
        let glassy = answer["glassy_modulus"].as_f64().unwrap();
        assert!((glassy / 7e6 - 1.0).abs() < 1e-6, "{header}: {glassy}");
    }
    // The unit stands in the header that the scene names as a whole.
    folder.write("dma.csv", table("f (Hz),Modul A (MPa),Modul B (MPa)", 1e6));
    let sets = ["material.columns.storage_modulus=\"Modul A (MPa)\"", "material.columns.loss_modulus=\"Modul B (MPa)\""];
    let answer = folder.call(&["material", "dma.csv", "--json", "--set", sets[0], "--set", sets[1]]).ended(0).json();
    assert!((answer["glassy_modulus"].as_f64().unwrap() / 7e6 - 1.0).abs() < 1e-6);
}

#[test]
fn all_columns_that_lack_a_unit_are_named_at_once_as_they_are_typed() {
    let folder = Folder::new();
    for header in ["f,E',E''", "f,Modul 1,Modul 2", "f (Hz),storage modulus (Mpa),loss modulus (Mpa)"] {
        folder.write("dma.csv", table(header, 1e6));
        let answer = folder.call(&["material", "dma.csv"]).ended(2);
        let lines: Vec<String> = answer
            .stderr
            .lines()
            .map(str::trim)
            .filter(|line| line.split(" = ").next().is_some_and(|key| ["frequency", "storage_modulus", "loss_modulus"].contains(&key)))
            .map(str::to_owned)
            .collect();
        assert!(lines.len() >= 2 && answer.stderr.contains("--set "), "{}", answer.stderr);
        // What is printed works when typed.
        folder.write("mat.toml", format!("[material]\ndata = \"dma.csv\"\n[material.columns]\n{}\n", lines.join("\n")));
        let glassy = folder.call(&["material", "mat.toml", "--json"]).ended(0).json()["glassy_modulus"].as_f64().unwrap();
        assert!((glassy / 7e6 - 1.0).abs() < 1e-6, "{header}: {glassy}");
        let sets: Vec<String> = lines.iter().map(|line| format!("material.columns.{}", line.replacen(" = ", "=", 1))).collect();
        let mut arguments = vec!["material", "dma.csv", "--json"];
        sets.iter().for_each(|set| arguments.extend(["--set", set]));
        folder.call(&arguments).ended(0);
    }
}

#[test]
fn cautions_of_a_fit_stay_with_its_file() {
    let folder = Folder::new();
    folder.write("dma.csv", table("f (Hz),storage modulus (Pa),loss modulus (Pa)", 1e6));
    let fitted = folder.call(&["material", "dma.csv", "--out", "fitted"]).ended(0);
    assert!(fitted.stdout.contains("softer than 1 kPa"), "{}", fitted.stdout);
    folder.write("scene.toml", format!("[material]\nfile = \"fitted/material.toml\"\npoisson_ratio = 0.49\n{SPHERE}"));
    let explained = folder.call(&["explain", "scene.toml"]).ended(0).stdout;
    assert!(explained.contains("CAUTION") && explained.contains("softer than 1 kPa"), "{explained}");
    // Words that only the fit can know.
    let file = std::fs::read_to_string(folder.path("fitted").join("material.toml")).unwrap();
    folder.write("fitted/own.toml", file.replace("cautions = [", "cautions = [\n  \"the sample was wet\","));
    folder.write("scene.toml", format!("[material]\nfile = \"fitted/own.toml\"\npoisson_ratio = 0.49\n{SPHERE}").replace("2 µm", "2 nm"));
    let ran = folder.call(&["run", "scene.toml", "--json"]).json();
    let meanings: Vec<&str> = ran["validity"].as_array().unwrap().iter().filter_map(|entry| entry["meaning"].as_str()).collect();
    assert!(meanings.contains(&"the sample was wet"), "{meanings:?}");
    // The file of a material that was read from such a file has each of them once.
    folder.call(&["material", "fitted/own.toml", "--out", "again"]).ended(0);
    let again = std::fs::read_to_string(folder.path("again").join("material.toml")).unwrap();
    assert_eq!(again.matches("softer than 1 kPa").count(), 1, "{again}");
    assert!(again.contains("the sample was wet"));
}

#[test]
fn unusual_numbers_are_asked_about_and_not_refused() {
    let folder = Folder::new();
    let asks = |text: String| -> Vec<String> {
        folder.write("scene.toml", text);
        let answer = folder.call(&["explain", "scene.toml", "--json"]).ended(0).json();
        answer["cautions"].as_array().unwrap().iter().map(|one| one.as_str().unwrap().to_owned()).collect()
    };
    let good = format!("{SOLID}{SPHERE}");
    assert!(asks(good.clone()).is_empty());
    for (from, to, says) in [
        ("work_of_adhesion = \"50 mJ/m²\"", "work_of_adhesion = 80", "`adhesion.work_of_adhesion` is 8.000e1 J/m²"),
        ("radius = \"2 mm\"", "radius = 2", "`indentation.sphere.radius` is 2.000e0 m"),
        ("length = \"2 µm\"", "length = 0.02", "`adhesion.process_zone.length` is 2.000e-2 m"),
        ("relaxed_modulus = \"1 MPa\"", "relaxed_modulus = 1", "softer than 1 kPa"),
        ("relaxed_modulus = \"1 MPa\"", "relaxed_modulus = \"5 TPa\"", "stiffer than 1 TPa"),
    ] {
        let said = asks(good.replace(from, to));
        assert!(said.len() == 1 && said[0].contains(says) && said[0].contains("unit"), "{to}: {said:?}");
    }
    let swept = format!("{good}\n[sweep]\nkey = \"adhesion.work_of_adhesion\"\nvalues = [0.05, 50]\n");
    assert!(asks(swept).iter().any(|said| said.contains("5.000e1 J/m²")));
}

#[test]
fn a_folder_in_the_way_is_refused_before_anything_is_printed() {
    let folder = Folder::new();
    folder.write("dma.csv", table("f (Hz),storage modulus (MPa),loss modulus (MPa)", 1e6));
    folder.call(&["material", "dma.csv", "--out", "fitted"]).ended(0);
    let again = folder.call(&["material", "dma.csv", "--out", "fitted"]).ended(2);
    assert!(again.stdout.is_empty() && again.stderr.contains("exists already"), "{}", again.stdout);
}

#[test]
fn a_table_of_a_scene_taken_for_an_option_gets_its_set() {
    let folder = Folder::with(&format!("{SOLID}{SPHERE}"));
    let answer = folder.call(&["run", "scene.toml", "--sweep", "speed"]).ended(2);
    assert!(answer.stderr.contains("--set 'sweep.key="), "{}", answer.stderr);
}

#[test]
fn moduli_beyond_the_data_are_printed_with_their_errors() {
    let folder = Folder::new();
    let whole = table("f (Hz),storage modulus (MPa),loss modulus (MPa)", 1e6);
    // Only the fast half: the slow plateau is not measured.
    let half: Vec<&str> = whole.lines().enumerate().filter(|(index, _)| *index == 0 || *index > 10).map(|(_, line)| line).collect();
    folder.write("dma.csv", half.join("\n"));
    let said = folder.call(&["material", "dma.csv"]).ended(0).stdout;
    let line = said.lines().find(|line| line.starts_with("relaxed modulus E0")).unwrap();
    assert!(line.contains(" ± ") && line.contains("extrapolated below 4.642e0 Hz"), "{line}");
    folder.write("dma.csv", whole);
    let answer = folder.call(&["material", "dma.csv", "--json"]).ended(0).json();
    assert_eq!(answer["glassy_modulus_is_extrapolated"], false);
    assert!(answer["glassy_modulus_error"].as_f64().unwrap() < 1e4);
}
