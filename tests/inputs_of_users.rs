//! Source: inputs as people have them, after public decks, threads and records, and inputs that once gave a wrong answer (`tests/inputs`).
//!
//! Goal: right, or refused with a reason; never a wrong number.
//!
//! Oracle: the value and the tolerance of each quantity in `tests/inputs/expected*.json`, with where it comes from: closed forms, quadratures, published values.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod command_support;

use command_support::{Answer, Folder};
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
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/inputs")).unwrap() {
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

/// What is wrong with the answer to an input.
fn complaints(case: &Value) -> Vec<String> {
    let input = case["input"].as_str().unwrap();
    let folder = folder(input);
    let values = case["values"].as_array().unwrap();
    let of_material = values.iter().any(|value| !value["slowest_time"].is_null());
    let answer: Answer = folder.call(&[if of_material { "material" } else { "run" }, &format!("{input}.toml"), "--out", "out"]);
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
    values
        .iter()
        .filter_map(|wanted| {
            let right = wanted["value"].as_f64().unwrap();
            let found = if of_material {
                let words = text("material.toml");
                words
                    .split("_time = ")
                    .skip(1)
                    .filter_map(|rest| rest.split([' ', ',', '}', '\n']).next()?.parse().ok())
                    .fold(0.0, f64::max)
            } else {
                let states = States::read(&text("states.csv"));
                if wanted["slope"].is_null() {
                    states.value(wanted["column"].as_str().unwrap(), &wanted["row"]).unwrap_or(f64::NAN)
                } else {
                    // Of the unloading, which the last instants hold.
                    let of =
                        |name: &str| -> Vec<f64> { states.rows.iter().rev().take(2).map(|row| states.cell(row, name).unwrap()).collect() };
                    let (force, depth) = (of("force"), of("penetration"));
                    (force[0] - force[1]) / (depth[0] - depth[1])
                }
            };
            let fits = (found / right - 1.0).abs() <= wanted["tolerance"].as_f64().unwrap();
            println!("{input}: {found:e}, right: {right:e} ({})", wanted["why"].as_str().unwrap());
            (!fits).then(|| format!("{input}: {found:e} instead of {right:e}, {wanted}"))
        })
        .collect()
}

/// The cases of every `expected*.json`, in the order of their names.
fn cases() -> Vec<Value> {
    let mut files: Vec<std::path::PathBuf> =
        std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/inputs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| {
        path.file_name().unwrap().to_str().unwrap().starts_with("expected") && path.extension().is_some_and(|one| one == "json")
    });
    files.sort();
    files.iter().flat_map(|path| serde_json::from_str::<Vec<Value>>(&std::fs::read_to_string(path).unwrap()).unwrap()).collect()
}

#[test]
fn right_or_refused() {
    let cases = cases();
    assert!(cases.len() >= 67, "{}", cases.len());
    let wrong: Vec<String> = cases.iter().flat_map(complaints).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
