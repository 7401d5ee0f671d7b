//! Source: inputs as people have them, after public decks, threads and records, and inputs that once gave a wrong answer (`tests/inputs`).
//!
//! Goal: right, or refused with a reason; never a wrong number.
//!
//! Oracle: the value and the tolerance of each quantity in `tests/inputs/expected*.json`, with where it comes from: closed forms, quadratures, published values.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Answer, Folder};
use rayon::prelude::*;
use serde_json::Value;
use std::path::Path;

/// A table of results: names without units, and rows of words.
struct States {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl States {
    fn read(text: &str) -> Self {
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let names = lines.next().unwrap().split(',').map(|name| name.split(' ').next().unwrap().to_owned()).collect();
        Self { names, rows: lines.map(|line| line.split(',').map(str::to_owned).collect()).collect() }
    }

    fn cell(&self, row: &[String], name: &str) -> Option<f64> {
        row.get(self.names.iter().position(|one| one == name)?)?.parse().ok()
    }

    /// The value of a column in the row of a time or an event, or in the last row.
    fn value(&self, column: &str, of: &Value) -> Option<f64> {
        let event = self.names.iter().position(|name| name == "event");
        let row = match (&of["time"], &of["event"]) {
            (Value::Number(time), _) => {
                let time = time.as_f64().unwrap();
                self.rows.iter().rev().find(|row| self.cell(row, "time").is_some_and(|at| (at - time).abs() <= 1e-9 * time))
            }
            (_, Value::String(name)) => self.rows.iter().find(|row| event.and_then(|place| row.get(place)) == Some(name)),
            _ => self.rows.iter().rev().find(|row| self.cell(row, column).is_some()),
        };
        self.cell(row?, column)
    }
}

/// A folder with one scene of the inputs and the files that it may name.
fn folder(input: &str) -> Folder {
    let folder = Folder::new();
    for entry in std::fs::read_dir(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/inputs")).unwrap() {
        let path = entry.unwrap().path();
        let (name, stem) = (path.file_name().unwrap().to_str().unwrap(), path.file_stem().unwrap().to_str().unwrap());
        // What a scene names has its own name, or is a table.
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
        if stem == input || !["toml", "json"].contains(&extension) {
            std::fs::write(folder.path(name), std::fs::read(&path).unwrap()).unwrap();
        }
    }
    folder
}

/// Quantities of a material, by the word that names them and where they are taken.
const OF_MATERIAL: [&str; 5] = ["slowest_time", "storage_at", "loss_at", "relaxation_at", "creep_at"];

/// E′, E″ at an angular frequency, or R, J at a time, of the terms that `viscotack material` gives.
fn of_terms(found: &Value, word: &str, at: f64) -> f64 {
    let number = |value: &Value| value.as_f64().unwrap_or(0.0);
    let terms = |list: &str, strength: &str, time: &str| -> Vec<(f64, f64)> {
        found[list].as_array().into_iter().flatten().map(|term| (number(&term[strength]), number(&term[time]))).collect()
    };
    let relaxation = terms("relaxation", "modulus", "relaxation_time");
    let relaxed = number(&found["relaxed_modulus"]);
    let sum = |of: &dyn Fn(f64, f64) -> f64| relaxation.iter().map(|(modulus, time)| of(*modulus, *time)).sum::<f64>();
    match word {
        "storage_at" => relaxed + sum(&|modulus, time| modulus * (at * time).powi(2) / (1.0 + (at * time).powi(2))),
        "loss_at" => sum(&|modulus, time| modulus * at * time / (1.0 + (at * time).powi(2))),
        "relaxation_at" => relaxed + sum(&|modulus, time| modulus * (-at / time).exp()),
        "creep_at" => {
            let creep = terms("creep", "compliance", "retardation_time");
            let flow = found["steady_viscosity"].as_f64().map_or(0.0, |viscosity| at / viscosity);
            let delayed: f64 = creep.iter().map(|(compliance, time)| -compliance * (-at / time).exp_m1()).sum();
            1.0 / number(&found["glassy_modulus"]) + delayed + flow
        }
        _ => relaxation.iter().map(|(_, time)| *time).fold(0.0, f64::max),
    }
}

/// Types the remedy of a refusal into the scene or the table.
fn mended(folder: &Folder, input: &str, remedy: &Value) {
    let extension = remedy["in"].as_str().unwrap();
    let name = format!("{input}.{extension}");
    let old = folder.read(&name);
    let new = match remedy["replace"].as_array() {
        Some(pair) => old.replacen(pair[0].as_str().unwrap(), pair[1].as_str().unwrap(), 1),
        None => format!("{old}{}", remedy["add"].as_str().unwrap()),
    };
    assert_ne!(old, new, "{input}: the remedy changes nothing");
    folder.write(&name, new);
}

/// What is wrong with the answer to an input; of a refused one with a remedy, also what is wrong once the remedy is typed.
fn failures(case: &Value) -> Vec<String> {
    let input = case["input"].as_str().unwrap();
    let folder = folder(input);
    let mut found = answered(case, &folder);
    if found.is_empty() && !case["remedy"].is_null() {
        mended(&folder, input, &case["remedy"]);
        let mut solved = case.clone();
        solved["outcome"] = "solved".into();
        solved["says"] = Value::Null;
        found = answered(&solved, &folder);
    }
    found
}

fn answered(case: &Value, folder: &Folder) -> Vec<String> {
    let input = case["input"].as_str().unwrap();
    let values = case["values"].as_array().unwrap();
    let of_material = case["command"] == "material" || values.iter().any(|value| OF_MATERIAL.iter().any(|word| !value[word].is_null()));
    let scene = format!("{input}.toml");
    let answer: Answer =
        if of_material { folder.call(&["material", &scene, "--json"]) } else { folder.call(&["run", &scene, "--out", "out"]) };
    let refused = answer.code != 0;
    if refused != (case["outcome"] == "refused") {
        return vec![format!("{input}: exit {}, but expected: {}\n{}", answer.code, case["outcome"], answer.stderr)];
    }
    if refused {
        let silent = answer.stderr.trim().is_empty() && !answer.stdout.contains("not_converged");
        // Words of the reason and of the remedy.
        let unsaid = case["says"].as_array().into_iter().flatten().find(|word| !answer.stderr.contains(word.as_str().unwrap()));
        if let Some(word) = unsaid {
            return vec![format!("{input}: refused without the words {word}\n{}", answer.stderr)];
        }
        return if silent { vec![format!("{input}: refused without a reason")] } else { Vec::new() };
    }
    let text = |name: &str| std::fs::read_to_string(folder.path("out").join(name)).unwrap();
    if let Some(word) = case["says"].as_array().into_iter().flatten().find(|word| !answer.stdout.contains(word.as_str().unwrap())) {
        return vec![format!("{input}: solved without the words {word}\n{}", answer.stdout)];
    }
    let terms = if of_material { answer.json() } else { Value::Null };
    values
        .iter()
        .filter_map(|wanted| {
            let pointed = wanted["pointer"].as_str().map(|pointer| terms.pointer(pointer).cloned().unwrap_or_default());
            if let Some(right) = wanted["is"].as_bool() {
                return (pointed != Some(Value::Bool(right))).then(|| format!("{input}: {pointed:?} instead of {right}, {wanted}"));
            }
            let right = wanted["value"].as_f64().unwrap();
            let found = if let Some(number) = pointed {
                number.as_f64().unwrap_or(f64::NAN)
            } else if of_material {
                let word = OF_MATERIAL.iter().find(|word| !wanted[*word].is_null()).unwrap();
                of_terms(&terms, word, wanted[word].as_f64().unwrap_or(0.0))
            } else {
                // What lies on the way of a history has a table of its own.
                let way = folder.path("out/path.csv").is_file().then(|| States::read(&text("path.csv")));
                let answers = States::read(&text("states.csv"));
                let states = way.as_ref().unwrap_or(&answers);
                if wanted["slope"].is_null() {
                    let (column, row) = (wanted["column"].as_str().unwrap(), &wanted["row"]);
                    states.value(column, row).or_else(|| answers.value(column, row)).unwrap_or(f64::NAN)
                } else {
                    // Of the unloading, which the last instants hold.
                    let of =
                        |name: &str| -> Vec<f64> { states.rows.iter().rev().take(2).map(|row| states.cell(row, name).unwrap()).collect() };
                    let (force, depth) = (of("force"), of("penetration"));
                    (force[0] - force[1]) / (depth[0] - depth[1])
                }
            };
            // Of zero the tolerance is absolute.
            let scale = if right.abs() > 0.0 { right.abs() } else { 1.0 };
            let fits = (found - right).abs() <= wanted["tolerance"].as_f64().unwrap() * scale;
            println!("{input}: {found:e}, right: {right:e} ({})", wanted["why"].as_str().unwrap());
            (!fits).then(|| format!("{input}: {found:e} instead of {right:e}, {wanted}"))
        })
        .collect()
}

/// The cases of every `expected*.json`, in the order of their names.
fn cases() -> Vec<Value> {
    let mut files: Vec<std::path::PathBuf> = std::fs::read_dir(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/inputs"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.retain(|path| {
        path.file_name().unwrap().to_str().unwrap().starts_with("expected") && path.extension().is_some_and(|one| one == "json")
    });
    files.sort();
    files.iter().flat_map(|path| serde_json::from_str::<Vec<Value>>(&std::fs::read_to_string(path).unwrap()).unwrap()).collect()
}

fn right(cases: &[Value]) {
    let wrong: Vec<String> = cases.par_iter().flat_map_iter(failures).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn right_or_refused() {
    let cases: Vec<Value> = cases().into_iter().filter(|case| !is_table(case)).collect();
    assert!(cases.len() >= 33, "{}", cases.len());
    right(&cases);
}

/// Tables of materials, as `tests/inputs/make_tables.py` writes them: at most three are refused, each with a remedy that works.
#[test]
fn tables_of_materials_are_read_right() {
    let cases: Vec<Value> = cases().into_iter().filter(is_table).collect();
    let refused: Vec<&Value> = cases.iter().filter(|case| case["outcome"] == "refused").collect();
    assert!(cases.len() >= 30 && refused.len() <= 3 && refused.iter().all(|case| !case["remedy"].is_null()));
    right(&cases);
}

fn is_table(case: &Value) -> bool {
    case["input"].as_str().unwrap().starts_with("table_")
}

/// A crack that does not grow says by how much more load it would: a little less leaves it, a little more does not, whatever the load is.
#[test]
fn a_crack_that_does_not_grow_says_which_load_would_make_it() {
    let material = "[material]\nrelaxed_modulus = 2.3e6\npoisson_ratio = 0.45\nrelaxation = [{ modulus = 7e6, relaxation_time = 0.3 }]\n";
    let adhesion = "[adhesion]\nwork_of_adhesion = 37.0\nprocess_zone = { length = 2e-6 }\n";
    let bodies = [
        ("[crack]\nbody = \"two_halves\"\nplane = \"strain\"\n", "stress_intensity", 6e3),
        ("[crack]\nbody = \"two_halves\"\nplane = \"strain\"\n[crack.strip]\nhalf_height = 5e-3\n", "stress", 3e4),
    ];
    for (crack, quantity, load) in bodies {
        let answer = |load: f64| {
            let text = format!("{material}{adhesion}{crack}[[history]]\n{quantity} = {load:e}\n[[history]]\nhold = 1.0\n");
            let found = Folder::with(&text).call(&["run", "scene.toml", "--json"]).json();
            let row = found["results"][0].clone();
            (row["state"].as_str().unwrap().to_owned(), row["reason"].as_str().unwrap_or_default().to_owned())
        };
        let (state, reason) = answer(load);
        assert_eq!(state, "no_growth", "{reason}");
        let factor: f64 = reason.split("a load more than ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        assert!(factor > 1.0, "{reason}");
        assert_eq!(answer(load * factor * (1.0 - 1e-4)).0, "no_growth", "{quantity}");
        assert_eq!(answer(load * factor * (1.0 + 1e-4)).0, "delayed", "{quantity}");
    }
}
