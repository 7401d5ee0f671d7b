//! Random lines that slide and attract at a distance: each number against grids eight times finer, another start and the identities of friction.

pub mod compared;
mod scene;

use super::cells::{count, number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use compared::{Compared, compared};

/// The seed of the scenes that are reported.
pub const SEED: u64 = 0x41_11_2e;
/// Scenes of each effort, and the nodes along x that each may take.
const SCENES: [u64; 2] = [24, 2000];
const NODES: [usize; 2] = [1 << 12, 1 << 14];
/// Scenes that are listed.
const LISTED: usize = 200;

/// The study.
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let scenes = effort.choose(SCENES[0], SCENES[1]);
    let nodes = effort.choose(NODES[0], NODES[1]);
    let mut section = Section::new("random_lines", "Random lines that attract at a distance");
    section.paragraphs.push(format!(
        "{scenes} random lines: stiffening 2 to 1000, 1, 2 or 6 terms, speeds over six decades, one to five waves, half-spaces, bonded and free layers, four laws of ranges 0.003 to 0.3, held by a pressure, a gap or a frame. Each state \
         is followed to grids eight times finer, where the same state has its truth, and reached again from a neighbouring load. At most {nodes} nodes are allowed: a shorter range is refused at once."
    ));
    let all: Vec<(u64, Compared)> = progress.each(&format!("random_lines of {nodes} nodes"), scenes, |scene| compared(SEED, scene, nodes));
    let lines = || all.iter().map(|(_, scene)| scene);
    let values: usize = lines().map(|scene| scene.values).sum();
    let outside: Vec<&String> = lines().flat_map(|scene| &scene.outside).collect();
    section.checks.push(Check::new(
        "no value lies outside of its bound",
        "the difference from the finer grids, and from the other start, is at most both bounds together",
        outside.first().map_or_else(
            || format!("{values} values, none outside"),
            |first| format!("{} of {values} outside, the first: {first}", outside.len()),
        ),
        outside.is_empty() && values > 0,
    ));
    let spread = lines().map(|scene| scene.identities).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "the friction by the displaced surface is that by the loss",
        "within 1e-6 of the largest stress",
        format!("at most {spread:.1e} off"),
        spread < 1e-6,
    ));
    let refused = lines().filter(|scene| scene.refused.is_some()).count();
    let too_short = lines().filter(|scene| scene.refused.as_ref().is_some_and(|reason| reason.contains("but at most"))).count();
    section.checks.push(Check::statement(
        "how many scenes are refused",
        "none but those whose range needs more nodes than are allowed",
        format!("{refused} of {}, {too_short} of them for their nodes", all.len()),
        refused == too_short,
    ));
    let full = lines().filter(|scene| scene.full_contact).count();
    let missed: Vec<&String> = lines().filter_map(|scene| scene.missed.as_ref()).collect();
    section.checks.push(Check::statement(
        "whether full contact hides a partial one",
        "held mean gaps from far to near lead to no partial contact under the same load",
        format!(
            "{} of {full} full contacts{}",
            missed.len(),
            missed.first().map_or_else(String::new, |first| format!(", the first: {first}"))
        ),
        missed.is_empty(),
    ));
    let mut ratios: Vec<f64> = lines().flat_map(|scene| scene.ratios.iter().copied()).collect();
    ratios.sort_by(f64::total_cmp);
    let quantile = |part: f64| ratios.get((part * ratios.len() as f64) as usize).copied().unwrap_or(0.0);
    section.checks.push(Check::statement(
        "bound over error",
        "10 in the median, 100 at the 95th percentile",
        format!("{:.0} in the median, {:.0} at the 95th percentile", quantile(0.5), quantile(0.95)),
        quantile(0.5) <= 10.0 && quantile(0.95) <= 100.0,
    ));
    section.tables.push(table(&all));
    section
}

fn table(all: &[(u64, Compared)]) -> Table {
    let columns = vec![
        Column::new("scene", "1"),
        Column::new("values compared", "1"),
        Column::new("outside", "1"),
        Column::new("time", "s"),
        Column::words("what is outside, or why it is refused"),
    ];
    let mut table = Table::new("scenes", "Scenes with something to say, then the others.", columns).folded();
    let mut sorted: Vec<&(u64, Compared)> = all.iter().collect();
    sorted.sort_by_key(|(_, scene)| (scene.outside.is_empty(), scene.refused.is_none()));
    for (number_of_scene, scene) in sorted.into_iter().take(LISTED) {
        let said = scene.outside.first().or(scene.refused.as_ref()).cloned().unwrap_or_default();
        table.rows.push(vec![
            number(*number_of_scene as f64),
            count(scene.values),
            count(scene.outside.len()),
            number(scene.seconds),
            word(said),
        ]);
    }
    table
}
