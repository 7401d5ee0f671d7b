//! Source: the thesis's figures, `verification/figures.toml`.
//!
//! Goal: every panel is there and every feature holds; features notice changed data and changed physics; numbers do not drift; what was computed is kept.
//! Sketch: manifest ──► sources ──► curves ──► features, beside `verification/baselines/figures.csv`.
//! Oracle: what the thesis states, closed forms and laws, as the manifest says feature by feature; the baseline guards against drift and is no evidence.
//! Tolerance: that of each feature; drift by figure, 1e-6 for the steady problems (accuracy 1e-6), 2e-3 to 2e-2 for integrations (accuracy 1e-3).
//! `VISCOTACK_WRITE_BASELINES=1` writes the baseline anew, of all figures.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use viscotack_program::outcome::Row;
use viscotack_program::outcome::owned::digest;
use viscotack_program::plan;
use viscotack_program::scene::{Document, read};
use viscotack_verification::figures::{FeatureResult, Manifest, Options, Report, run, write_scenes};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn manifest_text() -> String {
    std::fs::read_to_string(root().join("verification/figures.toml")).unwrap()
}

fn made(manifest: &Manifest, ids: &[&str], out: Option<PathBuf>, reduced: bool) -> Report {
    let options = Options { ids: ids.iter().map(|id| (*id).to_owned()).collect(), out, reduced };
    run(manifest, &options, &|_, _| ()).unwrap()
}

#[test]
fn every_panel_is_in_the_manifest_with_enough_features() {
    let panels = "1.2bcd 2.2ab 2.4 3.2abcd 3.3ab 3.4abc 3.5ab 3.6ab 3.7ab 3.8ab 3.9 3.10 3.12ab 3.13 3.14abcd 3.15abc 3.16ab 3.17 \
                  4.3abc 4.4abcdef 4.5abc 4.6abc 4.7ab 4.8ab 4.9abcd 4.10ab 4.11abc 5.2ab 5.3 5.4abc 5.5ab 5.7ab";
    let manifest = Manifest::embedded().unwrap();
    let there = manifest.panel_ids();
    let mut count = 0;
    for group in panels.split_whitespace() {
        let (figure, letters) = group.split_at(group.find(|letter: char| letter.is_ascii_lowercase()).unwrap_or(group.len()));
        let wanted: Vec<String> =
            if letters.is_empty() { vec![figure.to_owned()] } else { letters.chars().map(|letter| format!("{figure}{letter}")).collect() };
        for panel in wanted {
            assert!(there.contains(&panel), "panel {panel} is missing");
            count += 1;
        }
    }
    assert_eq!(count, there.len());
    let features = manifest.features();
    assert!(features.iter().map(|(_, count)| count).sum::<usize>() >= 150);
    for (id, count) in features {
        assert!(count >= 3, "figure {id} has {count} features");
    }
    assert!(manifest.not_reproduced().iter().any(|(id, _)| *id == "3.11"));
}

/// The measured numbers of a baseline or a report, by panel and claim.
type Numbers = BTreeMap<(String, String), Vec<f64>>;

fn numbers(report: &Report) -> Numbers {
    let panels = report.figures.iter().flat_map(|figure| &figure.panels);
    panels
        .flat_map(|panel| panel.features.iter().map(|feature| ((panel.id.clone(), feature.claim.clone()), feature.measured.clone())))
        .collect()
}

fn baseline_path() -> PathBuf {
    root().join("verification/baselines/figures.csv")
}

fn write_baseline(report: &Report) {
    let mut writer = csv::Writer::from_path(baseline_path()).unwrap();
    writer.write_record(["panel", "claim", "measured"]).unwrap();
    for figure in &report.figures {
        for panel in &figure.panels {
            for feature in &panel.features {
                let measured: Vec<String> = feature.measured.iter().map(|number| format!("{number:e}")).collect();
                writer.write_record([panel.id.as_str(), &feature.claim, &measured.join(" ")]).unwrap();
            }
        }
    }
    writer.flush().unwrap();
}

fn baseline() -> Numbers {
    let mut reader = csv::Reader::from_path(baseline_path()).unwrap();
    reader
        .records()
        .map(|record| {
            let record = record.unwrap();
            let measured = record[2].split_whitespace().map(|number| number.parse().unwrap()).collect();
            ((record[0].to_owned(), record[1].to_owned()), measured)
        })
        .collect()
}

#[test]
fn the_reduced_set_passes_and_has_not_drifted() {
    let manifest = Manifest::embedded().unwrap();
    if std::env::var_os("VISCOTACK_WRITE_BASELINES").is_some() {
        write_baseline(&made(&manifest, &[], None, false));
    }
    let report = made(&manifest, &[], None, true);
    assert_eq!(report.count(FeatureResult::Failed), 0, "{}", report.table());
    assert!(report.figures.len() >= 15);
    let known = baseline();
    for figure in &report.figures {
        let drift = manifest.drift(&figure.id).unwrap();
        for panel in &figure.panels {
            for feature in &panel.features {
                assert!(!feature.broken_by.is_empty(), "{}: nothing breaks \"{}\"", panel.id, feature.claim);
                let key = (panel.id.clone(), feature.claim.clone());
                let before = known.get(&key).unwrap_or_else(|| panic!("{}: \"{}\" is not in the baseline", panel.id, feature.claim));
                assert_eq!(before.len(), feature.measured.len());
                for (before, now) in before.iter().zip(&feature.measured) {
                    let moved = (now - before).abs() / before.abs().max(1.0);
                    assert!(moved <= drift, "{}: \"{}\" drifted from {before} to {now}", panel.id, feature.claim);
                }
            }
        }
    }
}

#[test]
fn the_baseline_is_of_all_features() {
    let manifest = Manifest::embedded().unwrap();
    let features: usize = manifest.features().iter().map(|(_, count)| count).sum();
    assert_eq!(baseline().len(), features, "write it anew: VISCOTACK_WRITE_BASELINES=1");
}

/// Other physics under the same features: each change must be noticed by the figure it is made in.
#[test]
fn features_notice_changed_physics() {
    let text = manifest_text();
    let changed = |figure: &str, from: &str, to: &str| {
        let at = text.find(&format!("id = \"{figure}\"\ntitle")).unwrap();
        let place = at + text[at..].find(from).unwrap_or_else(|| panic!("figure {figure} has no {from}"));
        let mut mutated = text.clone();
        mutated.replace_range(place..place + from.len(), to);
        let report = made(&Manifest::parse(&mutated).unwrap(), &[figure], None, false);
        assert!(report.count(FeatureResult::Failed) > 0, "figure {figure} does not notice {from} -> {to}");
    };
    changed("1.2", "work_of_adhesion = 1.6e-4", "work_of_adhesion = 1.1e-4");
    changed("2.2", "stiffening_ratio = 10", "stiffening_ratio = 8");
    changed("2.4", "stiffening_ratio = 10", "stiffening_ratio = 20");
    changed("3.2", "work_of_adhesion = 0.008", "work_of_adhesion = 0.006");
    changed("3.10", "process_zone = { length = 0.001 }", "process_zone = { length = 0.03 }");
    changed("3.17", "penetration = 0.4", "penetration = 0.9");
    changed("4.7", "rate = 0.1", "rate = 1e-4");
    changed("5.3", "process_zone = { factor = 1 }", "process_zone = { factor = 1, law = \"constant\" }");
    changed("5.5", "factor = 2, law = \"schapery\"", "factor = 0.5, law = \"schapery\"");
    changed("5.7", "retardation_time = \"1 ms\"", "retardation_time = \"2 ms\"");
}

#[test]
fn what_was_computed_is_kept_and_what_changed_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("figures");
    let manifest = Manifest::embedded().unwrap();
    let first = made(&manifest, &["5.3", "1.2b"], Some(out.clone()), false);
    assert!(first.figures.iter().all(|figure| figure.fresh));
    let csv = std::fs::read(out.join("5.3.csv")).unwrap();
    let again = made(&manifest, &["5.3"], Some(out.clone()), false);
    assert!(again.figures.iter().all(|figure| !figure.fresh));
    assert_eq!(csv, std::fs::read(out.join("5.3.csv")).unwrap());
    assert_eq!(
        numbers(&first).get(&("5.3".to_owned(), "slow: G = Δγ".to_owned())),
        numbers(&again).get(&("5.3".to_owned(), "slow: G = Δγ".to_owned()))
    );
    let page = std::fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("5.3.csv") && out.join("features.csv").exists());
    if cfg!(feature = "plots") {
        assert!(std::fs::read_to_string(out.join("5.3.svg")).unwrap().starts_with("<svg"));
    }
    let other = Manifest::parse(
        &manifest_text().replace("values = [0.3, 0.3183098861837907, 1, 2.5]", "values = [0.3, 0.3183098861837907, 1, 2.4]"),
    )
    .unwrap();
    let options = Options { ids: vec!["5.3".to_owned()], out: Some(out.clone()), reduced: false };
    assert!(run(&other, &options, &|_, _| ()).is_err(), "the curve `a 2.5` is gone, and a feature names it");
    // A half-written table counts as none.
    for entry in std::fs::read_dir(out.join(".computed")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "json") {
            std::fs::write(path, b"{\"rows\":").unwrap();
        }
    }
    let healed = made(&manifest, &["5.3"], Some(out.clone()), false);
    assert!(healed.figures.iter().all(|figure| figure.fresh));
    assert_eq!(csv, std::fs::read(out.join("5.3.csv")).unwrap());
    // A folder that holds something else is left alone.
    let strange = folder.path().join("strange");
    std::fs::create_dir(&strange).unwrap();
    std::fs::write(strange.join("thesis.txt"), b"mine").unwrap();
    let options = Options { ids: vec!["1.2".to_owned()], out: Some(strange), reduced: false };
    assert!(run(&manifest, &options, &|_, _| ()).is_err());
}

#[test]
fn the_command_names_what_is_not_there_and_fails_with_a_feature() {
    let command = |arguments: &[&str]| {
        let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_viscotack")).args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr))
    };
    let (code, text) = command(&["figures", "3.99"]);
    assert!(code == Some(2) && text.contains("3.10"), "{text}");
    let (code, text) = command(&["figures", "3.11"]);
    assert!(code == Some(2) && text.contains("Grosch"), "{text}");
    let (code, text) = command(&["figures", "1.2", "2.2b"]);
    assert!(code == Some(0) && text.contains("not confirmed"), "{text}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("figures.toml");
    std::fs::write(&path, manifest_text().replace("equals = 1.4230249", "equals = 1.5")).unwrap();
    let (code, text) = command(&["figures", "2.2b", "--manifest", path.to_str().unwrap()]);
    assert!(code == Some(1) && text.contains("FAILED 2.2b"), "{text}");
    std::fs::write(&path, "figure = 3").unwrap();
    let (code, _) = command(&["figures", "--manifest", path.to_str().unwrap()]);
    assert_eq!(code, Some(2));
}

/// Points of a panel's table by curve.
fn points_of(path: &Path) -> Vec<(String, f64, f64)> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let number = |text: &str| text.parse().unwrap_or(f64::NAN);
    let records = reader.records().map(|record| record.unwrap());
    records.map(|record| (record[0].to_owned(), number(&record[1]), number(&record[3]))).collect()
}

/// A scene as written, read and solved: the pairs of two columns, or swept values, of its rows.
fn solved_pairs(path: &Path, x: &str, y: &str) -> Vec<(f64, f64)> {
    let document = Document::load(path).unwrap();
    let scene = read::read(&document).unwrap();
    let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| ()).unwrap();
    let of = |row: &Row, name: &str| {
        let swept = outcome.swept.iter().position(|swept| swept.key == name).and_then(|place| row.swept.get(place).copied());
        let column = || outcome.columns.iter().position(|column| column.name == name);
        swept.or_else(|| row.values.get(column()?).copied().flatten().map(|estimate| estimate.value))
    };
    outcome.rows.iter().filter_map(|row| Some((of(row, x)?, of(row, y)?))).collect()
}

#[test]
fn a_scene_of_a_panel_gives_its_curve() {
    let folder = tempfile::tempdir().unwrap();
    let (out, scenes) = (folder.path().join("figures"), folder.path().join("scenes"));
    let manifest = Manifest::embedded().unwrap();
    let ids = ["3.2a", "3.9", "5.7a"];
    made(&manifest, &ids, Some(out.clone()), false);
    let options = Options { ids: ids.map(str::to_owned).to_vec(), ..Options::default() };
    let panels = write_scenes(&manifest, &options, &scenes).unwrap();
    assert_eq!(panels.iter().map(|panel| panel.id.as_str()).collect::<Vec<_>>(), ids);
    let line = panels[0].line();
    assert!(line.starts_with("3.2a") && line.contains("3.2_loads.toml") && line.contains("no scene for E0, Einf: elastic wave"), "{line}");
    let compared = [
        // Panel, scene, column of x with the factor that the panel draws it with, column of y, curves of the scene, points that there must be.
        ("3.2a", "3.2_loads.toml", ("speed", 1.0), "half_width", "p ", 150),
        ("5.7a", "5.7_delay.toml", ("energy_release_rate_ratio", 1.0), "delay_time", "delay", 20),
        // The glassy modulus of this one is set, not written in the beginning of its scene.
        ("3.9", "3.9_crack.toml", ("speed", 0.001), "energy_release_rate_ratio", "crack", 80),
    ];
    for (panel, scene, (x, factor), y, curves, least) in compared {
        let pairs = solved_pairs(&scenes.join(scene), x, y);
        let points = points_of(&out.join(format!("{panel}.csv")));
        let mut count = 0;
        for (curve, x, y) in points.iter().filter(|(curve, x, y)| curve.starts_with(curves) && x.is_finite() && y.is_finite()) {
            let near = |one: f64, other: f64| (one - other).abs() <= 1e-9 * one.abs().max(other.abs());
            assert!(
                pairs.iter().any(|pair| near(factor * pair.0, *x) && near(pair.1, *y)),
                "{panel}: {scene} has not ({x}, {y}) of `{curve}`"
            );
            count += 1;
        }
        assert!(count >= least, "{panel}: {count} points");
    }
}

#[test]
fn every_panel_has_scenes_that_can_be_read_or_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let manifest = Manifest::embedded().unwrap();
    let panels = write_scenes(&manifest, &Options::default(), folder.path()).unwrap();
    assert_eq!(panels.iter().map(|panel| panel.id.clone()).collect::<Vec<_>>(), manifest.panel_ids());
    assert!(panels.iter().all(|panel| !panel.files.is_empty() || !panel.no_scene.is_empty()));
    assert!(panels.iter().filter(|panel| !panel.files.is_empty()).count() >= 60);
    for entry in std::fs::read_dir(folder.path()).unwrap() {
        let path = entry.unwrap().path();
        let scene = read::read(&Document::load(&path).unwrap()).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        plan::Plan::new(&scene).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    // What is written is not written again; what somebody changed is not replaced.
    write_scenes(&manifest, &Options::default(), folder.path()).unwrap();
    let changed = folder.path().join("3.2_loads.toml");
    std::fs::write(&changed, "title = \"mine\"\n").unwrap();
    let error = write_scenes(&manifest, &Options::default(), folder.path()).unwrap_err().to_string();
    assert!(error.contains("3.2_loads.toml") && error.contains("--scenes"), "{error}");
    assert_eq!(std::fs::read_to_string(&changed).unwrap(), "title = \"mine\"\n");
}

#[test]
fn the_index_keeps_panels_of_earlier_runs() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("figures");
    let manifest = Manifest::embedded().unwrap();
    let page = || std::fs::read_to_string(out.join("index.html")).unwrap();
    made(&manifest, &["2.2a", "1.2b"], Some(out.clone()), false);
    assert!(!page().contains("earlier run"));
    made(&manifest, &["2.2b"], Some(out.clone()), false);
    let now = page();
    for panel in ["1.2b", "2.2a", "2.2b"] {
        assert!(now.contains(&format!("src=\"{panel}.svg\"")), "{panel} is not in the index");
    }
    let digits = &digest(&std::fs::read(out.join("1.2b.csv")).unwrap())[..12];
    assert!(now.contains("2 panels are of earlier runs") && now.contains(digits) && !now.contains("altered since"));
    // In the order of the figures; the features of all panels are in the table.
    let at = |panel: &str| now.find(&format!("src=\"{panel}.svg\"")).unwrap();
    assert!(at("1.2b") < at("2.2a") && at("2.2a") < at("2.2b"));
    let features = std::fs::read_to_string(out.join("features.csv")).unwrap();
    assert!(["1.2,1.2b,", "2.2,2.2a,", "2.2,2.2b,"].iter().all(|start| features.contains(start)));
    // A table that was changed is reported, one that is gone is left out, one that is made again is of this run.
    std::fs::write(out.join("1.2b.csv"), "mine").unwrap();
    std::fs::remove_file(out.join("2.2a.csv")).unwrap();
    made(&manifest, &["2.2b"], Some(out.clone()), false);
    assert!(page().contains("One panel is of an earlier run") && page().contains("altered since") && !page().contains("2.2a.svg"));
    made(&manifest, &["1.2b", "2.2a", "2.2b"], Some(out.clone()), false);
    assert!(!page().contains("earlier run") && page().contains("2.2a.svg"));
    // An index that cannot be read counts as none.
    std::fs::write(out.join("panels.json"), "[{").unwrap();
    made(&manifest, &["1.2b"], Some(out.clone()), false);
    assert!(!page().contains("earlier run") && page().contains("1.2b.svg"));
}
