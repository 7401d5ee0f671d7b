//! What a study hands over: plain data that the report turns into a page and tables.

use super::pieces::Pieces;
use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::atomic::{AtomicU64, Ordering};
pub use viscotack_program::outcome::csv_table::Cell;
use viscotack_program::outcome::plot::{Curve, Figure, Line, Marker};
use viscotack_program::outcome::shard::Shard;

/// How much is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// About three minutes on two cores for all studies together: part of the continuous tests.
    Reduced,
    /// Within an hour.
    Full,
}

impl Effort {
    /// One of two values: `reduced` or `full`.
    #[must_use]
    pub fn choose<T>(self, reduced: T, full: T) -> T {
        match self {
            Self::Reduced => reduced,
            Self::Full => full,
        }
    }
}

/// How a check ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CheckResult {
    /// It holds.
    Passed,
    /// It does not hold, and the page says so with numbers: a rival wins here, a time is long. Never a failure of the command.
    Stated,
    /// It should hold and does not: the command fails.
    Failed,
}

impl CheckResult {
    /// The word on the page and in the tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Stated => "stated",
            Self::Failed => "FAILED",
        }
    }
}

/// Something expected beforehand, and what was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// What is checked.
    pub name: String,
    /// What was expected before the run, with its reason.
    pub expected: String,
    /// What was found.
    pub found: String,
    /// How it ended.
    pub result: CheckResult,
}

impl Check {
    /// A check that passes or fails.
    #[must_use]
    pub fn new(name: impl Into<String>, expected: impl Into<String>, found: impl Into<String>, passed: bool) -> Self {
        let result = if passed { CheckResult::Passed } else { CheckResult::Failed };
        Self { name: name.into(), expected: expected.into(), found: found.into(), result }
    }

    /// A statement that passes or else is only stated: times, and who wins where.
    #[must_use]
    pub fn statement(name: impl Into<String>, expected: impl Into<String>, found: impl Into<String>, holds: bool) -> Self {
        let result = if holds { CheckResult::Passed } else { CheckResult::Stated };
        Self { name: name.into(), expected: expected.into(), found: found.into(), result }
    }
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// What it holds; `$...$` as in the labels of plots is not understood here: plain text.
    pub name: String,
    /// Its unit, `1` for pure numbers, empty for words.
    pub unit: String,
}

impl Column {
    /// A column of numbers.
    #[must_use]
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { name: name.into(), unit: unit.into() }
    }

    /// A column of words.
    #[must_use]
    pub fn words(name: impl Into<String>) -> Self {
        Self::new(name, "")
    }
}

/// A table: a CSV file, and on the page a table that scrolls sideways and shows numbers to four digits.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Short name, unique in its section: names the CSV file.
    pub identifier: String,
    /// One sentence above it.
    pub caption: String,
    /// The columns.
    pub columns: Vec<Column>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
    /// Longer than a person reads: folded away on the page (the CSV has all of it).
    pub folded: bool,
}

impl Table {
    /// A table without rows, shown open.
    #[must_use]
    pub fn new(identifier: impl Into<String>, caption: impl Into<String>, columns: Vec<Column>) -> Self {
        Self { identifier: identifier.into(), caption: caption.into(), columns, rows: Vec::new(), folded: false }
    }

    /// Folded away on the page.
    #[must_use]
    pub fn folded(mut self) -> Self {
        self.folded = true;
        self
    }
}

/// A plot in the one style of the project: an SVG on the page and a CSV of its points.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Short name, unique in its section: names the CSV file.
    pub identifier: String,
    /// One sentence below it.
    pub caption: String,
    /// Axes and curves; build curves with [`ours`], [`rival`], [`stored`], [`failures`].
    pub figure: Figure,
    /// Shown at the top of the page, too (three in all are enough).
    pub headline: bool,
}

impl Plot {
    /// A plot that stays in its section.
    #[must_use]
    pub fn new(identifier: impl Into<String>, caption: impl Into<String>, figure: Figure) -> Self {
        Self { identifier: identifier.into(), caption: caption.into(), figure, headline: false }
    }

    /// Also at the top of the page.
    #[must_use]
    pub fn headline(mut self) -> Self {
        self.headline = true;
        self
    }
}

/// Our solver: a full line through filled discs.
#[must_use]
pub fn ours(label: impl Into<String>, points: Vec<(f64, f64)>) -> Curve {
    Curve::new(label, points).with_line(Line::Solid).with_marker(Marker::Circle)
}

/// A rival that ran beside it: dashes through filled squares.
#[must_use]
pub fn rival(label: impl Into<String>, points: Vec<(f64, f64)>) -> Curve {
    Curve::new(label, points).with_line(Line::Dashed).with_marker(Marker::Square)
}

/// A rival's stored run: dots through hollow squares.
#[must_use]
pub fn stored(label: impl Into<String>, points: Vec<(f64, f64)>) -> Curve {
    Curve::new(label, points).with_line(Line::Dotted).with_marker(Marker::OpenSquare)
}

/// Failures: crosses; the label names what failed.
#[must_use]
pub fn failures(label: impl Into<String>, points: Vec<(f64, f64)>) -> Curve {
    Curve::new(label, points).with_line(Line::None).with_marker(Marker::Cross)
}

/// One part of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The identifier of its study.
    pub identifier: String,
    /// Its heading.
    pub title: String,
    /// Plain sentences, one paragraph each.
    pub paragraphs: Vec<String>,
    /// Its tables.
    pub tables: Vec<Table>,
    /// Its plots.
    pub plots: Vec<Plot>,
    /// Its checks.
    pub checks: Vec<Check>,
    /// What it took (s); filled in by whoever runs it.
    pub seconds: f64,
}

impl Section {
    /// An empty section.
    #[must_use]
    pub fn new(identifier: impl Into<String>, title: impl Into<String>) -> Self {
        Self {
            identifier: identifier.into(),
            title: title.into(),
            paragraphs: Vec::new(),
            tables: Vec::new(),
            plots: Vec::new(),
            checks: Vec::new(),
            seconds: 0.0,
        }
    }

    /// Adds a paragraph.
    pub fn say(&mut self, paragraph: impl Into<String>) {
        self.paragraphs.push(paragraph.into());
    }

    /// Number of checks that ended in a way.
    #[must_use]
    pub fn count(&self, result: CheckResult) -> usize {
        self.checks.iter().filter(|check| check.result == result).count()
    }
}

/// Whoever watches: pieces of work done, pieces expected so far.
type Watcher = dyn Fn(u64, u64) + Send + Sync;

/// Whoever waits for sections: the identifier of one that has ended, and what it took (s).
type SectionWatcher = dyn Fn(&str, f64) + Send + Sync;

/// How far all studies together are: each announces its pieces of work once and reports each when done.
pub struct Progress {
    done: AtomicU64,
    expected: AtomicU64,
    watcher: Box<Watcher>,
    sections: Box<SectionWatcher>,
    pieces: Option<Pieces>,
    shard: Shard,
}

impl Progress {
    /// Calls `watcher(done, expected)` after each change.
    #[must_use]
    pub fn new(watcher: impl Fn(u64, u64) + Send + Sync + 'static) -> Self {
        Self {
            done: AtomicU64::new(0),
            expected: AtomicU64::new(0),
            watcher: Box::new(watcher),
            sections: Box::new(|_, _| {}),
            pieces: None,
            shard: Shard::WHOLE,
        }
    }

    /// Keeps the pieces of long studies, and takes those that are known.
    #[must_use]
    pub fn with_pieces(mut self, pieces: Pieces) -> Self {
        self.pieces = Some(pieces);
        self
    }

    /// Only this shard of the pieces of studies.
    #[must_use]
    pub const fn with_shard(mut self, shard: Shard) -> Self {
        self.shard = shard;
        self
    }

    /// What is computed of the studies in pieces.
    pub(super) const fn shard(&self) -> Shard {
        self.shard
    }

    /// The pieces of a study that are to be computed, of so many; they are announced.
    pub(super) fn pieces_of(&self, count: u64) -> Vec<u64> {
        let pieces: Vec<u64> = (0..self.shard.states(count as usize)).map(|index| self.shard.state(index) as u64).collect();
        self.expect(pieces.len() as u64);
        pieces
    }

    /// Why pieces could not be kept, if some could not.
    #[must_use]
    pub fn not_kept(&self) -> Option<String> {
        self.pieces.as_ref().and_then(Pieces::failed)
    }

    /// The pieces of a long study, or of a shard of it, with their numbers, side by side: each computed unless an earlier run of the same build has kept it.
    pub(super) fn each<T: Serialize + DeserializeOwned + Send>(
        &self,
        study: &str,
        count: u64,
        compute: impl Fn(u64) -> T + Sync,
    ) -> Vec<(u64, T)> {
        let one = |piece: u64| {
            let known = self.pieces.as_ref().and_then(|pieces| pieces.get(study, piece));
            let value = known.unwrap_or_else(|| {
                let value = compute(piece);
                if let Some(pieces) = &self.pieces {
                    pieces.put(study, piece, &value);
                }
                value
            });
            self.advance(1);
            (piece, value)
        };
        self.pieces_of(count).into_par_iter().map(one).collect()
    }

    /// Also calls `sections(identifier, seconds)` as each section ends, in the order in which they do.
    #[must_use]
    pub fn with_sections(mut self, sections: impl Fn(&str, f64) + Send + Sync + 'static) -> Self {
        self.sections = Box::new(sections);
        self
    }

    /// Nobody watches: for tests.
    #[must_use]
    pub fn silent() -> Self {
        Self::new(|_, _| {})
    }

    /// A study announces this many pieces of work.
    pub fn expect(&self, pieces: u64) {
        let expected = self.expected.fetch_add(pieces, Ordering::Relaxed) + pieces;
        (self.watcher)(self.done.load(Ordering::Relaxed), expected);
    }

    /// A section has ended.
    pub(super) fn ended(&self, identifier: &str, seconds: f64) {
        (self.sections)(identifier, seconds);
    }

    /// This many pieces are done.
    pub fn advance(&self, pieces: u64) {
        let done = self.done.fetch_add(pieces, Ordering::Relaxed) + pieces;
        (self.watcher)(done, self.expected.load(Ordering::Relaxed));
    }
}
