//! Work counters held against what they were: `verification/study_counters.csv`.
//!
//! Counters are of this program and do not depend on the machine but in the last bits of a step. One that has grown by more than a tenth is a
//! regression and fails; one that has fallen by more than a tenth is good news, and the page says that the file wants it:
//! `verification/update_study_counters.py` takes a report over.
//!
//! The file holds both efforts. A run of the same name is the same run in both: what its work depends on is in the name, the number of loads or speeds as well.

use super::reference::rows;
use super::section::{Cell, Check, Column, Table};

const FILE: &str = include_str!("../../study_counters.csv");
/// Growth that is let pass: last bits may add a step.
const ALLOWED: f64 = 1.1;

/// A counter of one run of this program.
#[derive(Debug, Clone, PartialEq)]
pub struct Counter {
    /// Identifier of the diagram.
    pub problem: String,
    /// Method and setting, with all that the count depends on.
    pub run: String,
    /// What is counted.
    pub counted: &'static str,
    /// How many.
    pub count: f64,
}

/// Every counter against its stored value.
#[must_use]
pub fn checked(counters: &[Counter]) -> (Table, Check) {
    against(FILE, counters)
}

/// The same against the text of a file with the columns `problem, run, counted, count`.
#[must_use]
pub fn against(file: &str, counters: &[Counter]) -> (Table, Check) {
    let stored = rows(file);
    let columns = vec![
        Column::words("problem"),
        Column::words("run"),
        Column::words("counted"),
        Column::new("count", "1"),
        Column::new("stored", "1"),
        Column::words("change"),
    ];
    let mut table = Table::new("counters", "Work counters against the stored ones; times are never compared.", columns).folded();
    let (mut grown, mut fallen, mut new) = (Vec::new(), 0, 0);
    for counter in counters {
        let before = stored
            .iter()
            .find(|row| row.text("problem") == counter.problem && row.text("run") == counter.run && row.text("counted") == counter.counted)
            .map(|row| row.number("count"));
        let change = match before {
            None => {
                new += 1;
                "not stored yet".to_owned()
            }
            Some(before) if counter.count > ALLOWED * before => {
                grown.push(format!("{}: {} {} instead of {before}", counter.run, counter.count, counter.counted));
                format!("GREW by {:.0} %", 100.0 * (counter.count / before - 1.0))
            }
            Some(before) if ALLOWED * counter.count < before => {
                fallen += 1;
                format!("fell by {:.0} %: update the file", 100.0 * (1.0 - counter.count / before))
            }
            Some(_) => "same".to_owned(),
        };
        table.rows.push(vec![
            Cell::Word(counter.problem.clone()),
            Cell::Word(counter.run.clone()),
            Cell::Word(counter.counted.to_owned()),
            Cell::Number(Some(counter.count)),
            Cell::Number(before),
            Cell::Word(change),
        ]);
    }
    let found = if grown.is_empty() {
        format!("{} counters, none grew by more; {fallen} fell, {new} are not stored yet", counters.len())
    } else {
        grown.join("; ")
    };
    let expected =
        "none has grown by more than a tenth over verification/study_counters.csv: work depends on the algorithm, not on the machine";
    // A run that the file does not know cannot have a regression; without any known run nothing was checked.
    let passed = grown.is_empty() && new < counters.len();
    (table, Check::new("work counters", expected, found, passed))
}
