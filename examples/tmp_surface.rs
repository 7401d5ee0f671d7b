//! Temporary: scenes of sliding surfaces at both accuracies, and at many nodes.
#![allow(missing_docs, clippy::unwrap_used)]
use std::time::Instant;
use viscotack_verification::studies::whole_grammar::compared::compared_with;
use viscotack_verification::studies::whole_grammar::drawn::{Problem, drawn};

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let seed: u64 = args[1].parse().unwrap();
    let (from, to): (u64, u64) = (args[2].parse().unwrap(), args[3].parse().unwrap());
    let mode = args.get(4).map_or("study", String::as_str);
    for scene in from..to {
        let first = drawn(seed, Problem::Surface, scene, 0);
        let mut second = drawn(seed, Problem::Surface, scene, 1);
        if mode == "text" {
            println!("{}\n{:?}", first.text, first.accuracy);
            continue;
        }
        let mut tight = second.tight;
        if mode == "fine" {
            second.text = second.text.replace("most_nodes = 4096", "most_nodes = 65536").replace("most_nodes = 256", "most_nodes = 512");
            tight = 1e-4;
        }
        let start = Instant::now();
        let found = first.solved(first.accuracy);
        let one = start.elapsed().as_secs_f64();
        let exact = if mode == "fine" { second.solved(tight) } else { second.solved_tightly() };
        let two = start.elapsed().as_secs_f64() - one;
        let judged = compared_with(first, scene, found, exact);
        println!("SCENE {seed} {scene} accuracy {} seconds {one:.2} {two:.2} values {} refused {:?}", judged.drawn.accuracy, judged.values.len(), judged.refused);
        for line in &judged.unmatched { println!("U {scene} {line}"); }
        for value in &judged.values {
            let c = value.compared;
            let mark = if c.is_missed() { "M" } else { "V" };
            println!("{mark} {scene} {} | {} | {:e} {:e} {:e} {:e} {:e} {:?}", value.column, value.row, c.found.value, c.found.error, c.truth.value, c.truth.error, c.scale, c.width());
        }
    }
}
