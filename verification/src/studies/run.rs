//! All studies in one run.

use super::section::{Check, CheckResult, Effort, Progress, Section};
use super::stamp::Stamp;
use super::{STUDIES, Study};
use rayon::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;
use thiserror::Error;
use viscotack_program::outcome::shard::Shard;

/// Why nothing was run.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum StudiesError {
    /// There is no such study.
    #[error("there is no study `{name}`: there are {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// A shard was asked for of a study that is not in pieces.
    #[error("the study `{name}` has no shards: name one or more of {known} with --shard")]
    Whole {
        /// What was asked for.
        name: String,
        /// Those in pieces.
        known: String,
    },
}

/// The sections of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// How much was computed.
    pub effort: Effort,
    /// Of the studies in pieces.
    pub shard: Shard,
    /// Where, when and by what.
    pub stamp: Stamp,
    /// In the order of the page.
    pub sections: Vec<Section>,
    /// Wall time of the whole run (s).
    pub seconds: f64,
}

impl Report {
    /// Number of checks that ended in a way.
    #[must_use]
    pub fn count(&self, result: CheckResult) -> usize {
        self.sections.iter().map(|section| section.count(result)).sum()
    }

    /// Every check that ended in a way, with its section.
    pub fn ended(&self, result: CheckResult) -> impl Iterator<Item = (&Section, &Check)> {
        self.sections
            .iter()
            .flat_map(move |section| section.checks.iter().filter(move |check| check.result == result).map(move |check| (section, check)))
    }

    /// The table on the screen: a line a section, then every check that failed, then the closing line.
    #[must_use]
    pub fn table(&self) -> String {
        let mut text = format!("{:<24} {:>7} {:>7} {:>7} {:>8}\n", "section", "passed", "stated", "failed", "seconds");
        let counts =
            |section: &Section| [CheckResult::Passed, CheckResult::Stated, CheckResult::Failed].map(|result| section.count(result));
        for section in &self.sections {
            let [passed, stated, failed] = counts(section);
            text.push_str(&format!("{:<24} {passed:>7} {stated:>7} {failed:>7} {:>8.1}\n", section.identifier, section.seconds));
        }
        for (section, check) in self.ended(CheckResult::Stated) {
            text.push_str(&format!("stated {}: {} (expected {}; found {})\n", section.identifier, check.name, check.expected, check.found));
        }
        for (section, check) in self.ended(CheckResult::Failed) {
            text.push_str(&format!("FAILED {}: {} (expected {}; found {})\n", section.identifier, check.name, check.expected, check.found));
        }
        text.push_str(&self.closing_line());
        text
    }

    /// How much was computed, in words.
    #[must_use]
    pub fn extent(&self) -> String {
        let effort = self.effort.choose("reduced", "full");
        if self.shard.is_whole() { effort.to_owned() } else { format!("{effort}, shard {}", self.shard) }
    }

    /// What the run comes to, in one line.
    #[must_use]
    pub fn closing_line(&self) -> String {
        format!(
            "verify ({}): {} checks passed, {} stated, {} failed in {} sections, {:.0} s\n",
            self.extent(),
            self.count(CheckResult::Passed),
            self.count(CheckResult::Stated),
            self.count(CheckResult::Failed),
            self.sections.len(),
            self.seconds
        )
    }
}

/// The studies of these names, all of them for no name.
///
/// # Errors
/// [`StudiesError::Unknown`].
pub fn chosen(names: &[String]) -> Result<Vec<Study>, StudiesError> {
    for name in names {
        if !STUDIES.iter().any(|study| study.identifier == name) {
            let known = STUDIES.iter().map(|study| study.identifier).collect::<Vec<_>>().join(", ");
            return Err(StudiesError::Unknown { name: name.clone(), known });
        }
    }
    Ok(STUDIES.iter().filter(|study| names.is_empty() || names.iter().any(|name| name == study.identifier)).copied().collect())
}

/// Whether a shard of all these studies can be run.
///
/// # Errors
/// [`StudiesError::Whole`], with the first that is not in pieces.
pub fn in_shards(studies: &[Study]) -> Result<(), StudiesError> {
    studies.iter().find(|study| !study.in_pieces).map_or(Ok(()), |whole| {
        let known = STUDIES.iter().filter(|study| study.in_pieces).map(|study| study.identifier).collect::<Vec<_>>().join(", ");
        Err(StudiesError::Whole { name: whole.identifier.to_owned(), known })
    })
}

/// Runs studies: first side by side those that measure no times, then the others one by one on one thread.
#[must_use]
pub fn run(studies: &[Study], effort: Effort, progress: &Progress) -> Report {
    let begin = Instant::now();
    let mut sections: Vec<Option<Section>> =
        studies.par_iter().map(|study| (!study.alone).then(|| section(study, effort, progress))).collect();
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    for (place, study) in sections.iter_mut().zip(studies).filter(|(place, _)| place.is_none()) {
        *place = Some(match &alone {
            Ok(pool) => pool.install(|| section(study, effort, progress)),
            Err(_) => section(study, effort, progress),
        });
    }
    Report {
        effort,
        shard: progress.shard(),
        stamp: Stamp::now(),
        sections: sections.into_iter().flatten().collect(),
        seconds: begin.elapsed().as_secs_f64(),
    }
}

/// One section. A panic is a defect of a solver or of the study: it fails the section and leaves the others.
fn section(study: &Study, effort: Effort, progress: &Progress) -> Section {
    let begin = Instant::now();
    let mut section = catch_unwind(AssertUnwindSafe(|| (study.compute)(effort, progress))).unwrap_or_else(|_| {
        let mut section = Section::new(study.identifier, study.identifier);
        section.checks.push(Check::new("the study itself", "it ends", "it panicked: a defect", false));
        section
    });
    section.seconds = begin.elapsed().as_secs_f64();
    progress.ended(study.identifier, section.seconds);
    section
}
