//! Source: the key catalogue (`program/src/scene/catalogue`) and `studies::whole_grammar`.
//!
//! Goal: the drawn scenes hold every key in every problem that has it, and every word of every choice. Their bounds are compared by `viscotack verify grammar`.
//!
//! Oracle: the key catalogue.
//!
//! Tolerance: none.
#![allow(missing_docs)]

use viscotack_verification::studies::whole_grammar::coverage::coverage;
use viscotack_verification::studies::whole_grammar::{COVERED, SEED_OF_MENDING};

#[test]
fn every_key_and_every_word_is_drawn() {
    let coverage = coverage(SEED_OF_MENDING, COVERED);
    println!("{} scenes, {} refused, {} pairs, {} words", coverage.scenes, coverage.refused, coverage.pairs, coverage.words);
    let missing: Vec<String> = coverage.missing_pairs.into_iter().chain(coverage.missing_words).collect();
    assert!(missing.is_empty(), "not drawn:\n{}", missing.join("\n"));
    assert!(10 * coverage.refused as u64 <= coverage.scenes, "{} of {} scenes are refused", coverage.refused, coverage.scenes);
}
