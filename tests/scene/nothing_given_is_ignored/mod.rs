//! Source: the key catalogue (`program/src/scene/catalogue`); style.md: "nothing asked for is silently ignored".
//!
//! Goal: every key of every problem, and of every variant of its shape, control and start, changes the result when it is changed or added, or is refused, or
//! stands in [`NO_EFFECT`] with the reason. A new key fails until a scene below holds it.
//!
//! Parameters: the scenes of [`scenes`], small ones that together hold every key.
//!
//! Oracle: none is needed; the result is the rows (values, bounds, status, fields), the columns, the validity block and the title. What a plan says of a
//! scene (effects, groups, predicted work) and its hash do not count: a key that only changes those is ignored.
//!
//! Tolerance: none, bytes.
#![allow(clippy::type_complexity, clippy::unwrap_used, clippy::panic, clippy::expect_used, clippy::indexing_slicing, missing_docs)]

mod exceptions;
mod files;
mod scenes;

use crate::command_support::shipped_scenes;
use exceptions::{NO_EFFECT, SAMPLES};
use files::FILES;
use rayon::prelude::*;
use scenes::scenes;
use std::collections::BTreeSet;
use viscotack::Estimate;
use viscotack_program::outcome::csv_table::{self, Table};
use viscotack_program::outcome::summary::summary;
use viscotack_program::outcome::{FieldPoint, Row};
use viscotack_program::plan;
use viscotack_program::scene::catalogue::{Key, Kind, generic_path, keys};
use viscotack_program::scene::document::{Document, Node, Value};
use viscotack_program::scene::read;

/// A folder with the files that scenes name.
fn folder() -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("viscotack-keys-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for (name, text) in FILES {
        std::fs::write(folder.join(name), text).unwrap();
    }
    folder
}

/// What came out, or why the scene is refused.
fn result(text: &str, folder: &std::path::Path, set: Option<&str>) -> Result<Vec<u8>, String> {
    let mut document = Document::parse("scene.toml", text.to_owned(), folder).map_err(|error| error.to_string())?;
    let is_file = set.is_some_and(|set| set.starts_with("material.file=") || set.starts_with("material.data="));
    if let Some(set) = set.filter(|_| is_file) {
        document.set(set).map_err(|error| error.to_string())?;
    }
    read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
    if let Some(set) = set.filter(|_| !is_file) {
        document.set(set).map_err(|error| error.to_string())?;
        read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
    }
    let scene = read::read(&document).map_err(|error| error.to_string())?;
    let outcome = plan::run(&document, &scene, Vec::new(), None, &|_| ()).map_err(|error| error.to_string())?;
    let whole = summary(&outcome);
    let mut bytes = Vec::new();
    for table in [Table::States, Table::Path, Table::Fields] {
        bytes.extend(csv_table::table(&outcome, table).unwrap().unwrap_or_default());
    }
    bytes.extend(format!("{:?}", outcome.pictures).bytes());
    for part in ["title", "accuracy", "validity", "columns", "swept"] {
        bytes.extend(whole[part].to_string().bytes());
    }
    let mut rows = whole["results"].clone();
    for row in rows.as_array_mut().unwrap() {
        row.as_object_mut().unwrap().remove("work");
    }
    bytes.extend(rows.to_string().bytes());
    Ok(bytes)
}

/// The real paths at which a key stands, or would stand, in a scene; and the node there.
fn places<'a>(root: &'a Node, path: &str) -> Vec<(String, Option<&'a Node>)> {
    let mut found: Vec<(String, Option<&Node>)> = vec![(String::new(), Some(root))];
    for part in path.split('.') {
        let (name, list) = part.strip_suffix("[]").map_or((part, false), |name| (name, true));
        let mut next = Vec::new();
        for (before, node) in found {
            let full = if before.is_empty() { name.to_owned() } else { format!("{before}.{name}") };
            let child = node.and_then(|node| node.get(name));
            match (list, child.map(|child| &child.value)) {
                (false, _) => next.push((full, child)),
                (true, Some(Value::List(items))) => {
                    next.extend(items.iter().enumerate().map(|(index, item)| (format!("{full}.{index}"), Some(item))));
                }
                // A sweep that is one table, or a list that is not there.
                (true, _) => {}
            }
        }
        found = next;
    }
    found
}

/// Keys of scenes that `run` takes: those of [fit] are for `viscotack fit`, and tests/fit_of_scenes.rs changes them.
fn of_runs() -> impl Iterator<Item = &'static Key> {
    keys().filter(|key| key.path != "fit" && !key.path.starts_with("fit."))
}

/// Values to try in place of what is there, as TOML.
fn trials(key: &Key, present: Option<&Node>) -> Vec<String> {
    if let Some((_, samples)) = SAMPLES.iter().find(|(path, _)| *path == key.path) {
        return samples.iter().map(|sample| (*sample).to_owned()).collect();
    }
    let words = |words: &[viscotack_program::scene::catalogue::Word]| words.iter().map(|word| word.word.to_owned()).collect::<Vec<_>>();
    let written = present.map_or("", Node::written).trim_matches('"').to_owned();
    match key.kind {
        Kind::Number { .. } | Kind::NumberOfSweptKey => match present.map(|node| &node.value) {
            Some(Value::Number(value)) => {
                [1.03, 0.97, 1.3, 0.7, 2.0].iter().map(|factor| format!("{:e}", value * factor)).chain(["0.37".into()]).collect()
            }
            Some(Value::Text(text)) => {
                let (number, unit) = text.split_once(' ').unwrap();
                vec![format!("\"{} {unit}\"", number.parse::<f64>().unwrap() * 1.03)]
            }
            _ => ["0.5", "3.7e-6", "1.3e3", "2.9e5", "290.0", "1.1e-3", "-0.5"].map(str::to_owned).to_vec(),
        },
        Kind::NumbersOfSweptKey => vec!["[0.25, 0.75]".into(), "[2e-6, 3e-6]".into()],
        Kind::Count { least, .. } => match present.map(|node| &node.value) {
            Some(Value::Number(value)) => vec![format!("{}", value + 1.0), format!("{}", value + 4.0)],
            _ => vec![format!("{}", least.max(1) + 2), "3".into(), "7".into()],
        },
        Kind::Choice(list) => words(list).into_iter().filter(|word| *word != written).map(|word| format!("{word:?}")).collect(),
        Kind::Choices(list) => words(list).into_iter().map(|word| format!("[{word:?}]")).collect(),
        Kind::Flag => ["true", "false"].into_iter().filter(|flag| *flag != written).map(str::to_owned).collect(),
        Kind::Text | Kind::Texts => vec!["\"another one\"".into()],
        // Tables are tested by their members; one without members by its being there.
        Kind::TableOrWord(list) if present.is_none_or(|node| matches!(node.value, Value::Text(_))) => {
            words(list).into_iter().filter(|word| *word != written).map(|word| format!("{word:?}")).collect()
        }
        Kind::Table | Kind::Tables | Kind::TableOrTables | Kind::TableOrWord(_) => match present {
            None if !keys().any(|other| other.path.strip_prefix(key.path).is_some_and(|rest| rest.starts_with(['.', '[']))) => {
                vec!["{}".into()]
            }
            _ => Vec::new(),
        },
    }
}

/// Whether a word is the default: the one trial of a choice that may change nothing.
const fn has_default(kind: Kind) -> bool {
    matches!(kind, Kind::Choice(_) | Kind::Choices(_) | Kind::Flag)
}

/// Of every problem and option of the catalogue, and of every shipped scene: a reader by name finds each column.
#[test]
fn no_table_has_two_equal_headers() {
    let folder = folder();
    let mut documents: Vec<(String, Document)> =
        scenes().into_iter().map(|(name, text)| (name.to_owned(), Document::parse("scene.toml", text, &folder).unwrap())).collect();
    documents.extend(shipped_scenes().into_iter().map(|path| (path.display().to_string(), Document::load(&path).unwrap())));
    let wrong: Vec<String> = documents
        .into_par_iter()
        .flat_map_iter(|(name, mut document)| {
            read::resolve_includes(&mut document).unwrap();
            let scene = read::read(&document).unwrap_or_else(|error| panic!("{name}: {error}"));
            let mut outcome = plan::unsolved(&plan::Plan::new(&scene).unwrap(), &document, &scene);
            // A state with a field, so that each table has its header.
            let mut row = Row::new(0, &vec![0.0; outcome.swept.len()], Vec::new(), outcome.columns.len());
            row.fields.push(FieldPoint { place: 0.0, values: vec![Estimate::exact(0.0); outcome.field_columns.len().saturating_sub(1)] });
            outcome.rows.push(row);
            [Table::States, Table::Path, Table::Fields].into_iter().filter_map(move |table| {
                let text = String::from_utf8(csv_table::table(&outcome, table).unwrap()?).unwrap();
                let headers: Vec<&str> = text.lines().next().unwrap().split(',').collect();
                let twice = headers.iter().find(|header| headers.iter().filter(|other| other == header).count() > 1)?;
                Some(format!("{name}: {} has {twice:?} twice", table.file()))
            })
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_key_changes_the_result_or_is_refused_or_is_listed() {
    let folder = folder();
    let scenes = scenes();
    let bases: Vec<(&str, &String, Document, Vec<u8>)> = scenes
        .par_iter()
        .map(|(name, text)| {
            let base = result(text, &folder, None).unwrap_or_else(|error| format!("REFUSED {error}").into_bytes());
            (*name, text, Document::parse("scene.toml", text.clone(), &folder).unwrap(), base)
        })
        .collect();
    // A scene whose state does not exist would show nothing.
    let wrong: Vec<String> = bases
        .iter()
        .map(|(name, .., base)| (name, String::from_utf8_lossy(base)))
        .filter(|(_, base)| base.starts_with("REFUSED") || !(base.contains("solved") || base.contains("inaccurate")))
        .map(|(name, base)| format!("{name}: {base}"))
        .collect();
    assert!(wrong.is_empty(), "scenes of this test are wrong\n{}", wrong.join("\n"));
    let jobs: Vec<(&Key, &(&str, &String, Document, Vec<u8>))> =
        of_runs().flat_map(|key| bases.iter().map(move |base| (key, base))).collect();
    let found: Vec<(&Key, bool, Vec<String>)> = jobs
        .par_iter()
        .map(|(key, (name, text, document, base))| {
            let mut failures = Vec::new();
            let mut felt = false;
            for (path, present) in places(&document.root, key.path) {
                assert!(!generic_path(&path).is_empty());
                let (mut changed, mut same) = (0, Vec::new());
                let written = present.map_or("", Node::written);
                for trial in trials(key, present).into_iter().filter(|trial| trial != written) {
                    let set = format!("{path}={trial}");
                    let Ok(tried) = std::panic::catch_unwind(|| result(text, &folder, Some(&set))) else {
                        failures.push(format!("{set} panics in {name:?}"));
                        continue;
                    };
                    match tried {
                        Ok(other) if other == *base => same.push(trial),
                        Ok(_) => changed += 1,
                        Err(_) => {}
                    }
                    // One change is proof for a number; every word of a choice is tried.
                    if changed > 0 && !has_default(key.kind) {
                        break;
                    }
                }
                // A key that is there, and every other value of which is refused, is not ignored; of a table without members, its being there tells.
                felt |= present.is_some() && (changed > 0 || same.is_empty());
                let allowed = usize::from(has_default(key.kind) && present.is_none());
                let ignored = if has_default(key.kind) { same.len() > allowed } else { changed == 0 && !same.is_empty() };
                let listed = NO_EFFECT.iter().any(|(listed, scene, _)| *listed == key.path && name.contains(scene));
                if ignored && !listed {
                    failures.push(format!("{path} = {same:?} changes nothing in {name:?}, and is not refused"));
                }
            }
            (*key, felt, failures)
        })
        .collect();
    let mut failures: Vec<String> = found.iter().flat_map(|(_, _, failures)| failures.clone()).collect();
    let felt: BTreeSet<&str> = found.iter().filter(|(_, felt, _)| *felt).map(|(key, ..)| key.path).collect();
    for key in of_runs() {
        let is_leaf = !trials(key, None).is_empty();
        let listed = NO_EFFECT.iter().any(|(listed, ..)| *listed == key.path);
        if is_leaf && !listed && !felt.contains(key.path) {
            failures.push(format!("{}: no scene of this test holds it and shows what it changes", key.path));
        }
    }
    println!("{} keys, {} scenes", keys().count(), bases.len());
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
}
