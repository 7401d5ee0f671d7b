//! Source: `ARCHITECTURE.md`: physics knows nothing of files, scenes or plots, and no plan ever picks a rival.
//!
//! Goal: an arrow in the wrong direction is a failure here, not a habit. Oracle: the text of `src/`. Tolerance: none.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::path::{Path, PathBuf};

/// Every Rust file below a folder of `src`.
fn sources(room: &str) -> Vec<(PathBuf, String)> {
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
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(room), &mut files);
    assert!(!files.is_empty(), "the room {room} is gone: update this test");
    files
}

fn assert_free_of(rooms: &[&str], forbidden: &[&str]) {
    for room in rooms {
        for (path, text) in sources(room) {
            for word in forbidden {
                assert!(!text.contains(word), "{} names {word}", path.display());
            }
        }
    }
}

const PHYSICS: [&str; 11] =
    ["special", "fit", "material", "elastic", "closure", "continuation", "crack", "sliding", "indentation", "finite_range", "rivals"];

#[test]
fn physics_knows_nothing_of_files_scenes_or_plots() {
    assert_free_of(
        &PHYSICS,
        &["crate::studies", "crate::scene", "crate::plan", "crate::outcome", "crate::cli", "std::fs", "std::path", "println!"],
    );
}

#[test]
fn scenes_know_nothing_of_plans_and_outcomes_nothing_of_commands() {
    assert_free_of(&["scene"], &["crate::plan", "crate::outcome", "crate::cli"]);
    assert_free_of(&["outcome"], &["crate::plan", "crate::cli", "crate::scene"]);
    assert_free_of(&["plan"], &["crate::cli"]);
    assert_free_of(&["scene", "plan", "outcome"], &["crate::figures", "crate::studies"]);
    assert_free_of(&["figures"], &["crate::cli", "crate::studies"]);
    assert_free_of(&["studies"], &["crate::cli"]);
}

#[test]
fn no_plan_picks_a_rival() {
    assert_free_of(
        &[
            "special",
            "fit",
            "material",
            "elastic",
            "closure",
            "continuation",
            "crack",
            "sliding",
            "indentation",
            "finite_range",
            "scene",
            "plan",
            "outcome",
            "figures",
            "cli",
        ],
        &["crate::rivals"],
    );
}

#[test]
fn the_solver_needs_no_python() {
    let manifest = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).unwrap();
    assert!(manifest.contains("default-members = [\".\"]"), "the harness is built by name only");
    assert!(!manifest.contains("pyo3") && !manifest.contains("viscotack-harness ="), "nothing depends on the harness or on Python");
}
