//! Source: the key catalogue (`program/src/scene/catalogue`) and `studies::whole_grammar`.
//!
//! Goal: a scene is the same in whatever units it is written. The drawn scenes hold every key in every problem that has it, and every word of every choice. Their bounds
//! are compared by `viscotack verify grammar`.
//!
//! Oracle: the key catalogue.
//!
//! Tolerance: none.
#![allow(missing_docs)]

use viscotack_verification::studies::whole_grammar::coverage::coverage;
use viscotack_verification::studies::whole_grammar::drawn::{Problem, drawn};
use viscotack_verification::studies::whole_grammar::{COVERED, SEED_OF_ASSESSMENT, SEED_OF_MENDING};

#[test]
fn other_units_are_the_same_scene() {
    for problem in Problem::ALL {
        for scene in 0..COVERED {
            let [one, other] = [0, 1].map(|units| drawn(SEED_OF_ASSESSMENT, problem, scene, units));
            let keys = |text: &str| text.lines().map(|line| line.split(" = ").next().map(str::to_owned)).collect::<Vec<_>>();
            assert_eq!(keys(&one.text), keys(&other.text), "{} {scene}", problem.name());
            assert_eq!((one.accuracy, one.tight), (other.accuracy, other.tight), "{} {scene}", problem.name());
        }
    }
}

#[test]
fn every_key_and_every_word_is_drawn() {
    let coverage = coverage(SEED_OF_MENDING, COVERED);
    println!("{} scenes, {} refused, {} pairs, {} words", coverage.scenes, coverage.refused, coverage.pairs, coverage.words);
    let missing: Vec<String> = coverage.missing_pairs.into_iter().chain(coverage.missing_words).collect();
    assert!(missing.is_empty(), "not drawn:\n{}", missing.join("\n"));
    assert!(10 * coverage.refused as u64 <= coverage.scenes, "{} of {} scenes are refused", coverage.refused, coverage.scenes);
}
