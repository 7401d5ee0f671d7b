//! Indenters that attract at a distance: random problems against far tighter runs, and what accuracy costs.

pub mod cost;
mod hard;
pub mod problems;

use super::cells::{count, number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use problems::{Compared, compared};

/// The seed of the problems that are reported.
pub const SEED: u64 = 0x42_5f17_e5ca;
/// Problems of each effort.
const PROBLEMS: [u64; 2] = [16, 1000];
/// Problems that are listed.
const LISTED: usize = 200;

/// The study.
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let problems = effort.choose(PROBLEMS[0], PROBLEMS[1]);
    let mut section = Section::new("finite_spheres", "Random problems with attraction at a distance");
    section.paragraphs.push(format!(
        "{problems} random problems: Tabor numbers 0.05 to 6, stiffening 2 to 1000, 1, 3 or 12 terms, speeds over eight decades, spheres, cones and power laws, starts in contact and far from it, rests, oscillations and steps at \
         once, every law, a penetration, a force or a frame. Each is solved by two runs that give bounds, at 1e-4 (1e-3 where the law has a kink or a hard wall) and with every tolerance tightened, and by one that is tightened once more, which the second is compared with. A problem that needs more than {} steps in the first run, or more nodes than are allowed, is left out, and counted.",
        problems::MOST_STEPS
    ));
    let all: Vec<(u64, Compared)> = progress.each("finite_spheres", problems, |problem| compared(SEED, problem));
    let problems = || all.iter().map(|(_, problem)| problem);
    let values: usize = problems().map(|problem| problem.values).sum();
    let outside: usize = problems().map(|problem| problem.outside.len()).sum();
    let wrong = problems().find_map(|problem| problem.outside.first());
    let (name, wanted) = ("no value lies outside of its bound", "the difference from the tightest run is at most the bound");
    let found = wrong
        .map_or_else(|| format!("{values} values, none outside"), |first| format!("{outside} of {values} outside, the first: {first}"));
    section.checks.push(Check::new(name, wanted, found, outside == 0 && values > 0));
    let failed: Vec<&String> = problems().filter_map(|problem| problem.failed.as_ref()).collect();
    section.checks.push(Check::new(
        "every problem ends with a state",
        "none fails",
        failed.first().map_or_else(|| "none failed".to_owned(), |first| format!("{} failed, the first: {first}", failed.len())),
        failed.is_empty(),
    ));
    let defect = problems().map(|problem| problem.defect_over_allowed).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "energy is balanced",
        "within ten tolerances of the largest energy",
        format!("at most {defect:.2} of that"),
        defect < 1.0,
    ));
    let left_out = problems().filter(|problem| problem.left_out.is_some()).count();
    section.checks.push(Check::statement(
        "how many problems are not compared",
        "none: each step takes as long as the surface needs, and each mesh as many nodes",
        format!("{left_out} of {} left out", all.len()),
        left_out == 0,
    ));
    section.tables.push(table(&all));
    hard::add_to(&mut section);
    section
}

fn table(all: &[(u64, Compared)]) -> Table {
    let columns = vec![
        Column::new("problem", "1"),
        Column::new("values compared", "1"),
        Column::new("outside", "1"),
        Column::new("energy defect", "1"),
        Column::new("steps", "1"),
        Column::words("what is wrong, or left out"),
    ];
    let mut table = Table::new("problems", "Problems with something to say, then the others.", columns).folded();
    let mut sorted: Vec<&(u64, Compared)> = all.iter().collect();
    sorted.sort_by_key(|(_, problem)| (problem.outside.is_empty() && problem.failed.is_none(), problem.left_out.is_none()));
    for (number_of_problem, problem) in sorted.into_iter().take(LISTED) {
        let said = problem.failed.clone().or_else(|| problem.outside.first().cloned());
        let said = said.or_else(|| problem.left_out.as_ref().map(|reason| format!("left out: {reason}"))).unwrap_or_default();
        table.rows.push(vec![
            number(*number_of_problem as f64),
            count(problem.values),
            count(problem.outside.len()),
            number(problem.defect),
            count(problem.steps),
            word(said),
        ]);
    }
    table
}
