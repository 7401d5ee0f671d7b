//! Spheres, cones and power laws that attract at a distance: random scenes against far tighter ones, and what accuracy costs.

pub mod cost;
pub mod scenes;

use super::cells::{count, number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use rayon::prelude::*;
use scenes::{Compared, compared};

/// The seed of the scenes that are reported.
pub const SEED: u64 = 0x42_5f17_e5ca;
/// Scenes of each effort.
const SCENES: [u64; 2] = [14, 1000];
/// What the energy balance may leave, over the largest energy of the history.
const BALANCE: f64 = 1e-3;
/// Scenes that are listed.
const LISTED: usize = 200;

/// The study.
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let scenes = effort.choose(SCENES[0], SCENES[1]);
    let mut section = Section::new("finite_spheres", "Random scenes with attraction at a distance");
    section.paragraphs.push(format!(
        "{scenes} random scenes: Tabor numbers 0.05 to 6, stiffening 2 to 1000, 1, 3 or 12 terms, speeds over eight decades, spheres, cones and power laws, two laws, starts in contact and far from it, \
         histories of penetration, force, frame, rest, oscillation and steps at once. Each is solved at accuracy 1e-3 and again at 1e-5; every value of both is compared with the sum of both bounds."
    ));
    progress.expect(scenes);
    let all: Vec<Compared> = (0..scenes)
        .into_par_iter()
        .map(|scene| {
            let compared = compared(SEED, scene);
            progress.advance(1);
            compared
        })
        .collect();
    let values: usize = all.iter().map(|scene| scene.values).sum();
    let outside: usize = all.iter().map(|scene| scene.outside.len()).sum();
    let wrong = all.iter().find_map(|scene| scene.outside.first());
    section.checks.push(Check::new(
        "no value lies outside of its bound",
        "every difference is at most the sum of both bounds",
        wrong
            .map_or_else(|| format!("{values} values, none outside"), |first| format!("{outside} of {values} outside, the first: {first}")),
        outside == 0,
    ));
    let failed: Vec<&Compared> = all.iter().filter(|scene| scene.failed.is_some()).collect();
    section.checks.push(Check::new(
        "every scene ends with a state or with a reason that physics has",
        "refused only where a dead load leaves no equilibrium",
        failed.first().map_or_else(
            || "none failed".to_owned(),
            |first| format!("{} failed, the first: {}", failed.len(), first.failed.clone().unwrap_or_default()),
        ),
        failed.is_empty(),
    ));
    let defect = all.iter().filter_map(|scene| scene.defect).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "energy is balanced",
        format!("within {BALANCE:e} of the largest energy"),
        format!("at most {defect:.1e} off"),
        defect < BALANCE,
    ));
    let inaccurate = all.iter().filter(|scene| scene.inaccurate).count();
    section.checks.push(Check::statement(
        "the wanted accuracy is reached",
        "in every scene; where it is not, the scene says so",
        format!("missed by {inaccurate} of {scenes} scenes"),
        inaccurate == 0,
    ));
    section.tables.push(table(&all));
    section
}

fn table(all: &[Compared]) -> Table {
    let columns = vec![
        Column::new("scene", "1"),
        Column::words("how it ended"),
        Column::new("values compared", "1"),
        Column::new("outside", "1"),
        Column::new("energy defect", "1"),
        Column::new("steps", "1"),
        Column::words("what is wrong, or why it was refused"),
    ];
    let mut table = Table::new("scenes", "Scenes with something to say, then the others.", columns).folded();
    let mut sorted: Vec<(usize, &Compared)> = all.iter().enumerate().collect();
    sorted.sort_by_key(|(_, scene)| (scene.outside.is_empty() && scene.failed.is_none(), !scene.inaccurate));
    for (index, scene) in sorted.into_iter().take(LISTED) {
        let ended = match (&scene.failed, &scene.refused, scene.inaccurate) {
            (Some(_), ..) => "failed",
            (_, Some(_), _) => "refused",
            (.., true) => "inaccurate",
            _ => "solved",
        };
        let said = scene.failed.clone().or_else(|| scene.outside.first().cloned()).or_else(|| scene.refused.clone()).unwrap_or_default();
        table.rows.push(vec![
            count(index),
            word(ended),
            count(scene.values),
            count(scene.outside.len()),
            number(scene.defect.unwrap_or(f64::NAN)),
            number(scene.steps),
            word(said),
        ]);
    }
    table
}
