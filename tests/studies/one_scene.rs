//! Source: `studies::whole_grammar`.
//!
//! Goal: by hand, the numbers of single scenes whose bounds do not cover their errors, and how long they take:
//! `SCENES=3,80 cargo test --test studies one_scene -- --ignored --nocapture` (`SEED` and `PROBLEM`, the name in tables, may be given too).
//!
//! Oracle: the same scene at a thousandth of its accuracy.
//!
//! Tolerance: the bounds.
#![allow(missing_docs)]

use viscotack_verification::studies::whole_grammar::SEED_OF_ASSESSMENT;
use viscotack_verification::studies::whole_grammar::compared::{Judged, Value};
use viscotack_verification::studies::whole_grammar::drawn::{Problem, drawn};

#[test]
#[ignore = "by hand, for scenes that are named"]
fn one_scene() {
    let given = |name: &str| std::env::var(name).ok();
    let seed = given("SEED").and_then(|seed| seed.parse().ok()).unwrap_or(SEED_OF_ASSESSMENT);
    let problem = given("PROBLEM").and_then(|name| Problem::ALL.into_iter().find(|problem| problem.name() == name));
    let problem = problem.unwrap_or(Problem::Indentation);
    let mut outside = 0;
    for scene in given("SCENES").unwrap_or_default().split(',').filter_map(|number| number.parse().ok()) {
        let start = std::time::Instant::now();
        let Judged { drawn, values, unmatched, refused, .. } =
            viscotack_verification::studies::whole_grammar::compared::judged(seed, problem, scene);
        let seconds = start.elapsed().as_secs_f64();
        let missed: Vec<&Value> = values.iter().filter(|value| value.compared.is_missed()).collect();
        println!("scene {scene}: {seconds:.1} s, accuracy {:e}, {} of {} outside", drawn.accuracy, missed.len(), values.len());
        missed.iter().for_each(|value| println!("  {}", value.described()));
        unmatched.iter().chain(refused.iter().flatten()).for_each(|line| println!("  {line}"));
        outside += missed.len();
        if given("TEXT").is_some() {
            println!("{}", drawn_text(seed, problem, scene));
        }
    }
    assert_eq!(outside, 0);
}

fn drawn_text(seed: u64, problem: Problem, scene: u64) -> String {
    let drawn = drawn(seed, problem, scene, 0);
    let files = drawn.files.iter().map(|(name, text)| format!("# {name}\n{text}")).collect::<String>();
    format!("accuracy = {:e}\n{}\n{files}", drawn.accuracy, drawn.text)
}
