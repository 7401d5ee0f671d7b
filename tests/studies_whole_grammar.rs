//! Source: the key catalogue (`src/scene/catalogue`) and `studies::whole_grammar`.
//!
//! Goal: the drawn scenes hold every key in every problem that has it, and every word of every choice; the error bound of every number of their rows covers its error.
//!
//! Parameters: scenes of the seed by which mechanisms were mended; `viscotack verify grammar` assesses those of another seed.
//!
//! Oracle: the same scene at a thousandth of its accuracy, written in other units.
//!
//! Tolerance: none; a number may be off by the bounds of both.
#![allow(clippy::unwrap_used, missing_docs)]

use rayon::prelude::*;
use viscotack::studies::whole_grammar::SEED_OF_MENDING;
use viscotack::studies::whole_grammar::compared::{Judged, judged};
use viscotack::studies::whole_grammar::coverage::coverage;
use viscotack::studies::whole_grammar::drawn::Problem;
use viscotack::studies::whole_grammar::tally::counted;

/// A number of the environment, for surveys by hand: `PROBLEM=2 FROM=0 COUNT=1000 cargo test --test studies_whole_grammar survey -- --ignored --nocapture`.
fn given(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

fn scenes(problem: Problem, seed: u64, from: u64, count: u64) -> Vec<Judged> {
    (from..from + count).into_par_iter().map(|scene| judged(seed, problem, scene)).collect()
}

#[test]
fn every_key_and_every_word_is_drawn() {
    let coverage = coverage(SEED_OF_MENDING, given("COVERED", 1500));
    println!("{} scenes, {} refused, {} pairs, {} words", coverage.scenes, coverage.refused, coverage.pairs, coverage.words);
    let missing: Vec<String> = coverage.missing_pairs.into_iter().chain(coverage.missing_words).collect();
    assert!(missing.is_empty(), "not drawn:\n{}", missing.join("\n"));
    assert!(10 * coverage.refused as u64 <= coverage.scenes, "{} of {} scenes are refused", coverage.refused, coverage.scenes);
}

/// A column by column account of a problem, with what is outside.
#[test]
#[ignore = "a survey by hand"]
fn survey() {
    let problem = Problem::ALL[given("PROBLEM", 0) as usize];
    let found = scenes(problem, given("SEED", SEED_OF_MENDING), given("FROM", 0), given("COUNT", 100));
    for scene in &found {
        let accuracy = scene.drawn.accuracy;
        let refused = scene.refused.iter().flatten().map(|reason| format!("REFUSED {reason}"));
        let outside = scene.values.iter().filter(|value| value.compared.is_missed()).map(|value| format!("OUT {}", value.described()));
        let unmatched = scene.unmatched.iter().map(|what| format!("UNMATCHED {what}"));
        refused.chain(outside).chain(unmatched).for_each(|line| println!("{} acc {accuracy:e} {line}", scene.scene));
        if given("SHOW", u64::MAX) == scene.scene {
            println!("{}", scene.drawn.text);
            scene.drawn.files.iter().for_each(|(name, text)| println!("--- {name}\n{text}"));
        }
    }
    println!("{:42} {:>7} {:>7} {:>9} {:>7} {:>8} {:>8}", "column", "values", "outside", "worst", "exact", "median", "95th");
    let (mut values, mut outside) = (0, 0);
    for ((_, column), count) in counted(&found) {
        let ratio = |part: f64| count.ratio(part).unwrap_or(f64::NAN);
        println!(
            "{column:42} {:7} {:7} {:9.2} {:7} {:8.2} {:8.1}",
            count.values,
            count.outside,
            count.worst,
            count.exact,
            ratio(0.5),
            ratio(0.95)
        );
        values += count.values;
        outside += count.outside;
    }
    println!("TOTAL {values} values, {outside} outside, {} scenes", found.len());
}
