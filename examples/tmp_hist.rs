//! Temporary: numbers of sliding surfaces by grid.
#![allow(missing_docs, clippy::unwrap_used)]
use viscotack_verification::studies::whole_grammar::drawn::{Problem, drawn};

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let seed: u64 = args[1].parse().unwrap();
    let (from, to): (u64, u64) = (args[2].parse().unwrap(), args[3].parse().unwrap());
    for scene in from..to {
        let first = drawn(seed, Problem::Surface, scene, 0);
        let text = &first.text;
        if text.contains("loop") || text.contains("branch") || text.contains("reached_by") { continue; }
        let line = text.contains("4096");
        let law = text.split("adhesion.law = ").nth(1).map_or(if text.contains("adhesion.table") { "table" } else { "none" }, |t| t.lines().next().unwrap());
        let grids: Vec<u32> = if line { vec![512, 1024, 2048, 4096, 8192, 16384, 32768, 65536] } else { vec![64, 128, 256, 512] };
        for n in grids {
            let mut one = drawn(seed, Problem::Surface, scene, 0);
            one.text = one.text.replace("most_nodes = 4096", &format!("most_nodes = {n}")).replace("most_nodes = 256", &format!("most_nodes = {n}")).replace("fields.points = 16", "");
            let accuracy = if line { 1e-9 } else { 1e-7 };
            if let Ok(outcome) = one.solved(accuracy) {
                for row in &outcome.rows {
                    if !row.status.has_values() { continue; }
                    let at = |name: &str| row.values[outcome.columns.iter().position(|c| c.name == name).unwrap()];
                    let kinds = ["nodes", "friction_stress", "friction_by_loss", "mean_pressure", "mean_gap", "contact_fraction", "adhesive_pressure", "repulsive_pressure", "interface_energy"];
                    let values: Vec<String> = kinds.iter().map(|k| at(k).map_or("nan nan".to_owned(), |e| format!("{:e} {:e}", e.value, e.error))).collect();
                    println!("{seed} {scene} {} {law} {} {}", if line { "line" } else { "surface" }, row.labels.join("/"), values.join(" "));
                }
            }
        }
    }
}
