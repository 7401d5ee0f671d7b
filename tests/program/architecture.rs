//! Source: `ARCHITECTURE.md`: the packages and what each may use.
//!
//! Goal: an arrow in the wrong direction is a failure here, not a habit. Between packages the compiler keeps the walls, as long as the manifests are what is written
//! here; within them the text of the sources is read. Oracle: `Cargo.toml` of each package and the sources. Tolerance: none.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::{Path, PathBuf};

fn repository() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// Every Rust file below a folder.
fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    fn walk(folder: &Path, files: &mut Vec<(PathBuf, String)>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, files);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                files.push((path, text));
            }
        }
    }
    let mut files = Vec::new();
    walk(&repository().join(folder), &mut files);
    assert!(!files.is_empty(), "{folder} is gone: update this test");
    files
}

fn assert_free_of(folder: &str, forbidden: &[&str]) {
    for (path, text) in sources(folder) {
        for word in forbidden {
            assert!(!text.contains(word), "{} names {word}", path.display());
        }
    }
}

/// What a package depends on: all that is built with it but for its own tests.
fn dependencies(folder: &str) -> Vec<String> {
    let text = std::fs::read_to_string(repository().join(folder).join("Cargo.toml")).unwrap();
    let manifest: toml::Table = text.parse().unwrap();
    manifest["dependencies"].as_table().unwrap().keys().cloned().collect()
}

#[test]
fn each_package_uses_those_below_it() {
    let ours = |folder: &str| -> Vec<String> { dependencies(folder).into_iter().filter(|name| name.starts_with("viscotack")).collect() };
    assert!(ours(".").is_empty(), "the solver stands by itself");
    assert_eq!(ours("program"), ["viscotack"], "no plan picks a rival, no scene knows a study");
    assert_eq!(ours("verification"), ["viscotack", "viscotack-program"], "studies call no command");
    for folder in [".", "program", "verification", "cli"] {
        let python = dependencies(folder).into_iter().find(|name| name == "pyo3" || name == "viscotack-harness");
        assert!(python.is_none(), "{folder} needs Python: {python:?}");
    }
}

#[test]
fn the_solver_needs_no_command_line_and_no_files() {
    let dependencies = dependencies(".");
    for name in ["clap", "csv", "indicatif", "miette", "png", "serde_json", "tiny-skia", "toml"] {
        assert!(!dependencies.iter().any(|dependency| dependency == name), "the solver depends on {name}");
    }
    assert_free_of("src", &["std::fs", "std::path", "println!", "env!"]);
}

#[test]
fn scenes_know_nothing_of_plans_and_outcomes_nothing_of_scenes() {
    assert_free_of("program/src/scene", &["crate::plan", "crate::outcome"]);
    assert_free_of("program/src/outcome", &["crate::plan", "crate::scene"]);
}

#[test]
fn figures_know_nothing_of_studies_and_neither_picks_a_rival_but_studies() {
    assert_free_of("verification/src/figures", &["crate::studies", "crate::rivals"]);
    assert_free_of("verification/src/rivals", &["crate::studies", "viscotack_program", "std::fs", "std::path", "println!"]);
}
