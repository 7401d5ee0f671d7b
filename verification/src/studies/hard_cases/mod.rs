//! Hard cases of all problems: each with the reason why it is hard and an outcome that theory states beforehand. No outcome was recorded from a run.
//!
//! | file | cases |
//! |---|---|
//! | [`case`] | what a case is, and when it holds |
//! | [`material`] | conversion of series, extreme spectra |
//! | [`crack`] | steady cracks |
//! | [`delayed`] | cracks under load histories |
//! | [`sliding`] | steady sliding contacts of known form |
//! | [`folds`] | sliding contacts on, before and after folds; wrong roots; several contacts |
//! | [`sphere`] | indentation |
//! | [`units`] | one scene in three systems of units |
//!
//! "No such state" needs its witness, the limit that was passed, with the right value. A bound wider than the tolerance is an accuracy that was not reached: a miss.
//! Each expectation is also put to the comparison falsified, and must fail.

pub mod case;
pub mod crack;
pub mod delayed;
pub mod folds;
pub mod material;
pub mod sliding;
pub mod sphere;
pub mod units;

use super::cells::{number, word};
use super::{Check, Column, Effort, Progress, Section, Table};
use case::{Expected, HardCase, falsified, held};
use rayon::prelude::*;
use std::time::Instant;

/// All cases.
#[must_use]
pub fn cases(effort: Effort) -> Vec<HardCase> {
    let mut all = material::cases();
    all.extend(crack::cases());
    all.extend(delayed::cases(effort));
    all.extend(sliding::cases());
    all.extend(folds::cases());
    all.extend(sphere::cases(effort));
    all.extend(units::cases());
    all
}

/// What is wrong with a case after its run; nothing if it holds.
#[must_use]
pub fn failures(expected: &[Expected], found: &case::Found) -> Vec<String> {
    let mut failures: Vec<String> = expected.iter().filter_map(|expected| held(expected, found).err()).collect();
    if expected.is_empty() {
        failures.push("nothing is expected".into());
    }
    if failures.is_empty() {
        let blind = expected.iter().filter(|expected| held(&falsified(expected), found).is_ok());
        failures.extend(blind.map(|expected| format!("the comparison does not see that {expected:?} could be false")));
    }
    failures
}

/// An expectation in words.
fn reported(expected: &Expected) -> String {
    match expected {
        Expected::Value { quantity, value, tolerance } => format!("{quantity} = {value:.12e} within {tolerance:.0e}"),
        Expected::Between { quantity, low, high } => format!("{quantity} between {low:.3e} and {high:.3e}"),
        Expected::Is(word) => (*word).to_owned(),
        Expected::NoSuchState { limit, tolerance } => format!("no such state, the limit being {limit:.9e} within {tolerance:.0e}"),
        Expected::Refused(kind) => format!("refused: {kind:?}"),
    }
}

/// The study.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let cases = cases(effort);
    progress.expect(cases.len() as u64);
    let mut section = Section::new("hard_cases", "Hard cases");
    section.say(format!(
        "{} cases, each with the reason why it is hard and an outcome that theory states before the run. A state that does not exist must be refused with its witness, the \
         limit that was passed. A bound wider than the tolerance counts as a miss. Each expectation is put to the comparison falsified as well, and must fail.",
        cases.len()
    ));
    if effort == Effort::Reduced {
        section.say("Here a million load cycles are a hundred thousand, and the punch swings for fewer cycles; the full run has them all.");
    }
    let results: Vec<(case::Found, f64)> = cases
        .par_iter()
        .map(|case| {
            let clock = Instant::now();
            let found = (case.run)();
            progress.advance(1);
            (found, clock.elapsed().as_secs_f64())
        })
        .collect();
    let mut table = Table::new(
        "cases",
        "What must come out, and what does.",
        vec![
            Column::words("problem"),
            Column::words("case"),
            Column::words("why it is hard"),
            Column::words("by"),
            Column::words("expected"),
            Column::words("found"),
            Column::new("time", "s"),
            Column::words("result"),
        ],
    );
    for (case, (found, seconds)) in cases.iter().zip(results) {
        let failures = failures(&case.expected, &found);
        let expected = case.expected.iter().map(reported).collect::<Vec<_>>().join("; ");
        let result = if failures.is_empty() { "as expected".to_owned() } else { failures.join("; ") };
        let name = format!("{}: {}", case.problem, case.name);
        let stated = format!("{expected} (by {})", case.theory);
        let reported = if failures.is_empty() { found.reported() } else { result.clone() };
        section.checks.push(Check::new(name, stated, reported, failures.is_empty()));
        table.rows.push(vec![
            word(case.problem),
            word(case.name.as_str()),
            word(case.why),
            word(case.theory),
            word(expected),
            word(found.reported()),
            number(seconds),
            word(result),
        ]);
    }
    section.tables.push(table.folded());
    section
}
