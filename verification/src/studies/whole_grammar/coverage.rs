//! What the drawn scenes hold of the catalogue: every pair of a key and a problem that it belongs to, and every word of every choice.

use super::drawn::{Problem, drawn};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;
use viscotack_program::scene::catalogue::{Kind, key, keys};
use viscotack_program::scene::document::{Node, Value};
use viscotack_program::scene::{Document, read};

/// Keys, with all that lies below them, that do not belong to a problem.
const FOREIGN: &[(&str, &[Problem])] = &[
    ("crack", &[Problem::Sliding, Problem::Surface, Problem::Indentation]),
    ("sliding", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Indentation]),
    ("indentation", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Sliding, Problem::Surface]),
    ("history", &[Problem::SteadyCrack, Problem::Sliding, Problem::Surface]),
    ("test", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Sliding, Problem::Surface]),
    ("history[].until", &[Problem::DelayedFracture]),
    // A contact has edges, or acts at a distance.
    ("sliding.profile", &[Problem::Sliding]),
    ("sliding.surface", &[Problem::Sliding]),
    ("sliding.layer", &[Problem::Sliding]),
    ("sliding.loop", &[Problem::Sliding]),
    ("sliding.mean_gap", &[Problem::Sliding]),
    ("sliding.most_nodes", &[Problem::Sliding]),
    ("sliding.wave", &[Problem::Surface]),
    ("sliding.cylinder", &[Problem::Surface]),
    ("sliding.load_per_width", &[Problem::Surface]),
    ("sliding.penetration", &[Problem::Surface]),
    ("sliding.half_width", &[Problem::Surface]),
    ("sliding.columns", &[Problem::Surface]),
    ("sliding.strength", &[Problem::Surface]),
    ("sliding.branch.from", &[Problem::Surface]),
    ("sliding.branch.to", &[Problem::Surface]),
    ("sliding.branch.branches", &[Problem::Surface]),
    ("sliding.branch.frame_stiffness", &[Problem::Surface]),
    ("adhesion.process_zone", &[Problem::Surface]),
    // A liquid has no relaxed modulus to measure a surface by.
    ("material.viscosity", &[Problem::Surface]),
    ("adhesion.process_zone.peak_stress", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Indentation]),
    ("adhesion.law", OF_EDGES),
    ("adhesion.range", OF_EDGES),
    ("adhesion.peak_stress", OF_EDGES),
    ("adhesion.ramp", OF_EDGES),
    ("adhesion.table", OF_EDGES),
    ("adhesion.columns", OF_EDGES),
    ("sweep", &[Problem::Surface]),
    ("latin_hypercube", &[Problem::Surface]),
    // A history takes the place of what holds a steady crack.
    ("crack.theories", &[Problem::DelayedFracture]),
    ("crack.speed", &[Problem::DelayedFracture]),
    ("crack.energy_release_rate", &[Problem::DelayedFracture]),
    ("crack.stress_intensity", &[Problem::DelayedFracture]),
    ("crack.strip.strain", &[Problem::DelayedFracture]),
    ("crack.strip.stress", &[Problem::DelayedFracture]),
    ("crack.points", &[Problem::SteadyCrack]),
    ("crack.spacing", &[Problem::SteadyCrack]),
    ("crack.first_time", &[Problem::SteadyCrack]),
    // Of one edge there is one work, and one zone.
    ("adhesion.trailing_work_of_adhesion", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Surface]),
    ("adhesion.leading_work_of_adhesion", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Surface]),
    ("adhesion.process_zone.trailing_length", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Indentation]),
    ("adhesion.process_zone.leading_length", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Indentation]),
    ("adhesion.by_speed", &[Problem::DelayedFracture, Problem::Surface]),
    ("adhesion.interaction_range", &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Sliding, Problem::Surface]),
    // An indenter has its own table of fields, a crack under a history none.
    ("fields", &[Problem::DelayedFracture, Problem::Indentation]),
    ("fields.from", &[Problem::Sliding, Problem::Surface]),
    ("fields.to", &[Problem::Sliding, Problem::Surface]),
    ("history[].penetration", &[Problem::DelayedFracture]),
    ("history[].force", &[Problem::DelayedFracture]),
    ("history[].contact_radius", &[Problem::DelayedFracture]),
    ("history[].frame", &[Problem::DelayedFracture]),
    ("history[].oscillation", &[Problem::DelayedFracture]),
    // Takes minutes with many relaxation times: compared in tests/indentation/periodic.rs (named gaps).
    ("history[].oscillation.periodic", &[Problem::Indentation]),
    ("history[].columns.penetration", &[Problem::DelayedFracture]),
    ("history[].columns.force", &[Problem::DelayedFracture]),
    ("history[].columns.contact_radius", &[Problem::DelayedFracture]),
    ("history[].columns.frame", &[Problem::DelayedFracture]),
    ("history[].stress_intensity", &[Problem::Indentation]),
    ("history[].stress", &[Problem::Indentation]),
    ("history[].columns.stress_intensity", &[Problem::Indentation]),
    ("history[].columns.stress", &[Problem::Indentation]),
    ("history[].columns.growth", &[Problem::Indentation]),
];

/// Problems whose adhesion is an edge with a process zone.
const OF_EDGES: &[Problem] = &[Problem::SteadyCrack, Problem::DelayedFracture, Problem::Sliding];

/// Whether a key may stand in scenes of a problem.
#[must_use]
pub fn belongs(path: &str, problem: Problem) -> bool {
    let below = |whole: &str| path.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']));
    !FOREIGN.iter().any(|(foreign, problems)| problems.contains(&problem) && below(foreign))
}

/// What was drawn, and what was not.
#[derive(Debug, Clone, Default)]
pub struct Coverage {
    /// Pairs of a key and a problem that were drawn.
    pub pairs: usize,
    /// Those that were not.
    pub missing_pairs: Vec<String>,
    /// Words of choices that were drawn.
    pub words: usize,
    /// Those that were not.
    pub missing_words: Vec<String>,
    /// Scenes that the reader refuses.
    pub refused: usize,
    /// Scenes.
    pub scenes: u64,
}

/// A key of a scene and, of a choice, its word.
type Held = (String, Option<String>);

fn held(node: &Node, path: &str, into: &mut Vec<Held>) {
    if !path.is_empty() {
        let word = match &node.value {
            Value::Text(text) => Some(text.clone()),
            _ => None,
        };
        into.push((path.to_owned(), word));
    }
    match &node.value {
        Value::Table(entries) => entries.iter().for_each(|entry| {
            let below = if path.is_empty() { entry.key.clone() } else { format!("{path}.{}", entry.key) };
            held(&entry.node, &below, into);
        }),
        Value::List(items) => items.iter().for_each(|item| match &item.value {
            Value::Table(_) => held(item, &format!("{path}[]"), into),
            Value::Text(word) => into.push((path.to_owned(), Some(word.clone()))),
            _ => {}
        }),
        _ => {}
    }
}

fn words_of(kind: Kind) -> Vec<&'static str> {
    match kind {
        Kind::Choice(words) | Kind::Choices(words) | Kind::TableOrWord(words) => words.iter().map(|word| word.word).collect(),
        _ => Vec::new(),
    }
}

/// The coverage of so many scenes of each problem.
#[must_use]
pub fn coverage(seed: u64, scenes: u64) -> Coverage {
    let mut pairs: BTreeSet<(Problem, String)> = BTreeSet::new();
    let mut words: BTreeSet<(String, String)> = BTreeSet::new();
    let mut refused = 0;
    for problem in Problem::ALL {
        let read_scenes: Vec<Option<Vec<Held>>> = (0..scenes)
            .into_par_iter()
            .map(|scene| {
                let drawn = drawn(seed, problem, scene, 0);
                // What the text holds, before files are put in place of their names.
                let plain = Document::parse("scene.toml", drawn.text.clone(), Path::new("/nowhere")).ok()?;
                read::read(&drawn.document(drawn.accuracy).ok()?).ok()?;
                let mut list = vec![("accuracy".to_owned(), None)];
                held(&plain.root, "", &mut list);
                Some(list)
            })
            .collect();
        refused += read_scenes.iter().filter(|scene| scene.is_none()).count();
        for (path, word) in read_scenes.into_iter().flatten().flatten() {
            if let (Some(key), Some(word)) = (key(&path), word)
                && words_of(key.kind).contains(&word.as_str())
            {
                words.insert((path.clone(), word));
            }
            pairs.insert((problem, path));
        }
    }
    let mut coverage = Coverage { refused, scenes: scenes * Problem::ALL.len() as u64, ..Coverage::default() };
    // Keys of [fit] are for `viscotack fit`: its study is `fit_coverage`.
    for key in keys().filter(|key| key.path != "fit" && !key.path.starts_with("fit.")) {
        for problem in Problem::ALL.into_iter().filter(|problem| belongs(key.path, *problem)) {
            if pairs.contains(&(problem, key.path.to_owned())) {
                coverage.pairs += 1;
            } else {
                coverage.missing_pairs.push(format!("{} of {}", key.path, problem.name()));
            }
        }
        for word in words_of(key.kind) {
            if words.contains(&(key.path.to_owned(), word.to_owned())) {
                coverage.words += 1;
            } else {
                coverage.missing_words.push(format!("{} = {word:?}", key.path));
            }
        }
    }
    coverage
}
