//! What several test files share: reference data with its header checked, and materials named in it.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

pub mod indentation;
pub mod physics;
pub mod random;
pub mod sliding;
pub mod theory;

use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::fmt::Write as _;
use std::path::Path;
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};

/// One row of a reference file, by column name.
pub struct Row(HashMap<String, String>);

impl Row {
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).unwrap_or_else(|| panic!("no column {column}"))
    }

    pub fn number(&self, column: &str) -> f64 {
        let text = self.text(column);
        text.parse().unwrap_or_else(|_| panic!("column {column} holds {text:?}"))
    }
}

/// The folder of the repository: the package under test is in it or below it.
fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().find(|folder| folder.join("reference_data").is_dir()).expect("the repository")
}

/// The rows of `reference_data/NAME`, after checking that the content is what its header's hash says.
pub fn reference_rows(name: &str) -> Vec<Row> {
    let path = repository().join("reference_data").join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let header: Vec<&str> = text.lines().take_while(|line| line.starts_with('#')).collect();
    let content = &text[header.iter().map(|line| line.len() + 1).sum::<usize>()..];
    let stated = header.iter().find_map(|line| line.strip_prefix("# sha256: ")).expect("a hash in the header");
    let mut computed = String::new();
    for byte in Sha256::digest(content.as_bytes()) {
        write!(computed, "{byte:02x}").unwrap();
    }
    assert_eq!(stated.trim(), computed, "{name} was changed by hand");
    let mut reader = csv::Reader::from_reader(content.as_bytes());
    let columns = reader.headers().unwrap().clone();
    reader.records().map(|record| Row(columns.iter().map(str::to_owned).zip(record.unwrap().iter().map(str::to_owned)).collect())).collect()
}

/// The materials of `reference_data/steady_crack_materials.csv`.
pub fn reference_materials() -> HashMap<String, PlaneMaterial> {
    #[derive(Default)]
    struct Parts {
        kind: String,
        numbers: HashMap<String, f64>,
        strengths: Vec<f64>,
        times: Vec<f64>,
    }
    let mut parts: HashMap<String, Parts> = HashMap::new();
    for row in reference_rows("steady_crack_materials.csv") {
        let part = parts.entry(row.text("material").to_owned()).or_default();
        match row.text("key") {
            "kind" => part.kind = row.text("value").to_owned(),
            "units" => {}
            "creep_strength" | "relaxation_strength" => part.strengths.push(row.number("value")),
            "retardation_time" | "relaxation_time" => part.times.push(row.number("value")),
            key => {
                part.numbers.insert(key.to_owned(), row.number("value"));
            }
        }
    }
    parts
        .into_iter()
        .map(|(name, part)| {
            let pairs = part.strengths.iter().copied().zip(part.times.iter().copied());
            let material = match part.kind.as_str() {
                "creep" => PlaneMaterial::from_creep(
                    part.numbers["glassy_modulus"],
                    &pairs.map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time }).collect::<Vec<_>>(),
                    part.numbers.get("flow_viscosity").copied(),
                ),
                "relaxation" => PlaneMaterial::from_relaxation(
                    part.numbers["relaxed_modulus"],
                    &pairs.map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time }).collect::<Vec<_>>(),
                ),
                other => panic!("material kind {other}"),
            };
            (name, material.unwrap())
        })
        .collect()
}
