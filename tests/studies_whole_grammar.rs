//! survey
#![allow(clippy::unwrap_used, missing_docs)]
use rayon::prelude::*;
use viscotack::studies::whole_grammar::{compared::judged, drawn::Problem, tally::counted};

#[test]
#[ignore]
fn survey() {
    let var = |name: &str, default: &str| std::env::var(name).unwrap_or_else(|_| default.into());
    let seed: u64 = var("SEED", "1").parse().unwrap();
    let count: u64 = var("COUNT", "50").parse().unwrap();
    let from: u64 = var("FROM", "0").parse().unwrap();
    let which: usize = var("PROBLEM", "0").parse().unwrap();
    let only = var("ONLY", "");
    let problem = Problem::ALL[which];
    let started = std::time::Instant::now();
    let scenes: Vec<_> = (from..from + count).into_par_iter().map(|scene| {
        let t = std::time::Instant::now();
        let j = std::panic::catch_unwind(|| judged(seed, problem, scene)).unwrap_or_else(|_| { println!("PANIC {scene}"); judged(seed, problem, scene) });
        if t.elapsed().as_secs_f64() > 2.0 { println!("slow {scene}: {:.1} s accuracy {:e}", t.elapsed().as_secs_f64(), j.drawn.accuracy); }
        j
    }).collect();
    println!("{} scenes in {:.1} s", scenes.len(), started.elapsed().as_secs_f64());
    let mut refused = 0;
    let mut shown = std::collections::BTreeMap::<String, usize>::new();
    for s in &scenes {
        if s.refused.iter().any(Option::is_some) {
            refused += 1;
            let r = s.refused.iter().flatten().next().unwrap();
            let key: String = r.lines().next().unwrap_or("").chars().take(90).collect();
            let n = shown.entry(key.clone()).or_default();
            *n += 1;
            if *n <= 2 { println!("REFUSED {} {r}\n    {}", s.scene, s.drawn.text.replace('\n', "\n    ")); }
        }
    }
    println!("refused {refused} {shown:#?}");
    let mut un = 0;
    for s in &scenes { for u in &s.unmatched { un += 1; if un < 30 { println!("UNMATCHED {} acc {:e} {u}", s.scene, s.drawn.accuracy); } } }
    println!("unmatched {un}");
    println!("{:40} {:>7} {:>7} {:>9} {:>7} {:>7} {:>8} {:>8}", "column", "values", "outside", "worst", "unsure", "exact", "median", "95th");
    let (mut v, mut o) = (0, 0);
    for ((_, column), c) in counted(&scenes) {
        v += c.values; o += c.outside;
        println!("{column:40} {:7} {:7} {:9.2} {:7} {:7} {:8.2} {:8.1}", c.values, c.outside, c.worst, c.unsure, c.exact, c.ratio(0.5).unwrap_or(f64::NAN), c.ratio(0.95).unwrap_or(f64::NAN));
    }
    println!("TOTAL {v} values {o} outside");
    let mut listed = std::collections::BTreeMap::<String, usize>::new();
    for s in &scenes { for x in &s.values { if x.compared.is_missed() && (only.is_empty() || x.column.contains(&only)) {
        let n = listed.entry(x.column.clone()).or_default(); *n += 1;
        if *n <= 4 { println!("OUT {} acc {:e} {} [{}] {:e} ± {:.1e} truth {:e} ± {:.1e} off {:.1e}", s.scene, s.drawn.accuracy, x.column, x.row, x.compared.found.value, x.compared.found.error, x.compared.truth.value, x.compared.truth.error, x.compared.found.value - x.compared.truth.value); }
    } } }
    if let Ok(show) = std::env::var("SHOW") { for s in &scenes { if s.scene.to_string() == show { println!("{}", s.drawn.text); for (n, f) in &s.drawn.files { println!("--- {n}\n{f}"); } } } }
}

#[test]
fn every_key_and_word_is_drawn() {
    let scenes: u64 = std::env::var("COUNT").ok().and_then(|c| c.parse().ok()).unwrap_or(400);
    let coverage = viscotack::studies::whole_grammar::coverage::coverage(1, scenes);
    println!("{} scenes, {} refused, {} pairs, {} words", coverage.scenes, coverage.refused, coverage.pairs, coverage.words);
    assert!(coverage.missing_pairs.is_empty() && coverage.missing_words.is_empty(), "missing pairs:\n{}\nmissing words:\n{}", coverage.missing_pairs.join("\n"), coverage.missing_words.join("\n"));
}
