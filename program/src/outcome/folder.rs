//! The folder of a run: written beside its place, moved there in one step, never half there.
//!
//! `DIR.partial` holds the journal while a run is under way, and at its end the finished files in a folder of their own, which becomes `DIR` by a rename.
//! With `--force` an existing `DIR` steps aside first and is deleted last. Every folder carries the mark of this program ([`super::owned`]): one without it, and every
//! file that is not listed in it, is left alone.

use super::checkpoints::Checkpoints;
use super::csv_table::{Rows, Table};
use super::gather::{Inputs, ShardFile};
use super::journal::{Found, Journal, JournalHeader, read};
use super::known_digests::KnownDigests;
use super::owned::{DigestedFile, OwnedFolder};
use super::place::{beside, is_empty, is_there, may_be_written, put_in_place};
pub use super::place::{writable, write_whole};
use super::report::{self, Shown};
use super::{Outcome, Row, plot, summary};
use crate::terminal_text;
use rayon::prelude::*;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a folder cannot be written.
#[derive(Debug, Error)]
pub enum FolderError {
    /// It is there already.
    #[error("the folder `{0}` exists already: choose another --out, or add --force to replace it")]
    Exists(String),
    /// Other work than that of this program would be lost.
    #[error("`{path}` is not replaced: {why}; move it away, or choose another --out")]
    NotOwned {
        /// The folder, or the file.
        path: String,
        /// What shows that it belongs to somebody else.
        why: String,
    },
    /// The partial folder belongs to another run.
    #[error(
        "`{partial}` holds the unfinished run of another scene or build ({found}): remove it, choose another --out, or add --force to drop it"
    )]
    OtherRun {
        /// The partial folder.
        partial: String,
        /// What it belongs to.
        found: String,
    },
    /// Another run is filling it now.
    #[error("`{0}` is being written by another run: wait for it, or choose another --out")]
    Busy(String),
    /// The machine refuses: a full disk, no permission, a folder that is gone.
    #[error("`{path}` cannot be written: {error}")]
    Io {
        /// The path.
        path: String,
        /// Its words.
        error: String,
    },
}

impl FolderError {
    /// What the system says about a path.
    pub fn io(path: &Path) -> impl Fn(std::io::Error) -> Self + '_ {
        move |error| Self::Io { path: terminal_text::name(path), error: error.to_string() }
    }
}

/// A folder being filled.
#[derive(Debug)]
pub struct RunFolder {
    target: PathBuf,
    partial: OwnedFolder,
    journal: Journal,
    checkpoints: Checkpoints,
    header: JournalHeader,
    force: bool,
    /// Of the files of the folder that is replaced.
    known: KnownDigests,
    /// Keeps other runs out.
    _lock: File,
}

/// Name of the journal inside the partial folder.
pub(super) const JOURNAL: &str = "journal.jsonl";
/// All that a run keeps there while it is under way.
const UNDER_WAY: [&str; 4] = [JOURNAL, "journal.new", "state-*.checkpoint", "state-*.new"];
/// Name of the summary.
const SUMMARY: &str = "summary.json";
/// The finished files inside the partial folder.
const RESULT: &str = "result";
/// What a shard is of, and what its scene was read from.
pub(super) const SHARD_FILE: &str = "shard.json";
/// What marks call a folder of each kind.
const RUN: &str = "run";
pub(super) const SHARD: &str = "shard";
const UNFINISHED: &str = "unfinished run";

fn io(path: &Path) -> impl Fn(std::io::Error) -> FolderError + '_ {
    FolderError::io(path)
}

/// `DIR.partial` of `DIR`, and of `DIR/`, as shells complete it.
#[must_use]
pub fn partial_of(target: &Path) -> PathBuf {
    beside(target, ".partial")
}

impl RunFolder {
    /// Opens the partial folder of a run; gives the states that an earlier, killed run of the same scene finished. The header takes a while, as does the
    /// check of a folder that will be replaced: side by side.
    ///
    /// # Errors
    /// A folder that exists (without `force`) or is not this program's, an unfinished run of something else, or a file system that refuses.
    pub fn open(target: &Path, header: impl FnOnce() -> JournalHeader + Send, force: bool) -> Result<Self, FolderError> {
        let known = KnownDigests::default();
        let (header, free) = rayon::join(header, || may_be_written(target, force, &known));
        free?;
        let header = &header;
        let path = partial_of(target);
        let journal_path = path.join(JOURNAL);
        let mut partial = OwnedFolder::open_or_make(&path, UNFINISHED, &UNDER_WAY)?;
        let busy = || FolderError::Busy(terminal_text::name(&path));
        let mut lock = partial.lock()?.ok_or_else(busy)?;
        let finished = match read(&journal_path, header).map_err(io(&journal_path))? {
            Found::States(states) => states,
            Found::Nothing => 0,
            Found::Other(_) if force => {
                // Nothing of it must end among the files of this run.
                remove_result(&path)?;
                if let Some(why) = partial.foreign()? {
                    return Err(FolderError::NotOwned { path: terminal_text::name(&path), why });
                }
                partial.remove()?;
                partial = OwnedFolder::make(&path, UNFINISHED, &UNDER_WAY)?;
                lock = partial.lock()?.ok_or_else(busy)?;
                0
            }
            Found::Other(found) => {
                let shard = if found.shard.is_whole() { String::new() } else { format!(", shard {}", found.shard) };
                let found = format!("{}, scene {}{shard}", found.program, found.scene.get(..12).unwrap_or(&found.scene));
                return Err(FolderError::OtherRun { partial: terminal_text::name(&path), found: terminal_text::one_line(&found) });
            }
        };
        let journal = Journal::open(&journal_path, header, finished).map_err(io(&journal_path))?;
        let checkpoints = Checkpoints::new(&path, header);
        // A kill may have come between the journal and the end of a checkpoint.
        (0..finished).map(|index| header.shard.state(index)).try_for_each(|state| checkpoints.remove(state)).map_err(io(&path))?;
        Ok(Self { target: target.to_owned(), partial, journal, checkpoints, header: header.clone(), force, known, _lock: lock })
    }

    /// The journal to append finished states to, and where those under way leave checkpoints.
    pub fn journal(&mut self) -> (&mut Journal, Checkpoints) {
        (&mut self.journal, self.checkpoints.clone())
    }

    /// Writes all files and moves the folder to its place; gives the names of the files.
    ///
    /// # Errors
    /// A file system that refuses; the partial folder then stays, with its journal.
    pub fn finish(self, outcome: &Outcome, scene: &str) -> Result<Vec<String>, FolderError> {
        let Self { target, partial, journal, checkpoints: _, header: _, force, known, _lock } = self;
        // What an earlier run left there at its end is made anew.
        let path = remove_result(partial.path())?;
        let mut result = OwnedFolder::make(&path, RUN, &[])?;
        // Pictures, summary and tables each take longer than many states: side by side.
        let wanted = outcome.pictures;
        let draw = |figure: &plot::Figure| -> Result<(Option<String>, Option<Vec<u8>>), plot::PlotError> {
            let svg = wanted.svg.then(|| plot::svg(figure)).transpose()?;
            Ok((svg, wanted.png.then(|| plot::png(figure)).transpose()?))
        };
        let draw_all = || outcome.figures.par_iter().map(|(stem, figure)| (stem, draw(figure))).collect::<Vec<_>>();
        let mut file = result.create(SUMMARY)?;
        let write_summary = || summary::write_short(outcome, &mut file).and_then(|()| file.write_all(b"\n"));
        let write_rows = || rayon::join(write_summary, || write_tables(outcome, &mut result));
        let ((summary, tables), pictures) = rayon::join(write_rows, draw_all);
        summary.map_err(io(&path.join(SUMMARY)))?;
        result.finish(SUMMARY, file)?;
        let mut names = [vec![SUMMARY.to_owned()], tables?].concat();
        let mut write = |name: &str, bytes: &[u8]| -> Result<(), FolderError> {
            result.write(name, bytes)?;
            names.push(name.to_owned());
            Ok(())
        };
        write("scene.toml", scene.as_bytes())?;
        let mut shown = Vec::new();
        for (stem, picture) in pictures {
            match picture {
                Ok((svg, png)) => {
                    shown.push(Shown::new(stem, svg.as_deref()));
                    if let Some(svg) = svg {
                        write(&format!("{stem}.svg"), svg.as_bytes())?;
                    }
                    if let Some(png) = png {
                        write(&format!("{stem}.png"), &png)?;
                    }
                }
                Err(plot::PlotError::NotBuilt) => {}
                Err(error) => return Err(FolderError::Io { path: format!("{stem}.svg"), error: error.to_string() }),
            }
        }
        let page = report::page(outcome, &shown, &names);
        result.write(report::PAGE, page.as_bytes())?;
        names.push(report::PAGE.to_owned());
        result.seal()?;
        // The journal goes last: a kill before the rename leaves a run to resume, a kill after it leaves the result and a journal to spare.
        put_in_place(&result, &target, force, &known, (journal, partial))?;
        Ok(names)
    }
}

impl RunFolder {
    /// Ends the folder of a shard: its journal, and all that its scene was read from.
    ///
    /// # Errors
    /// A file system that refuses; the partial folder then stays, with its journal.
    pub fn finish_shard(self, inputs: &Inputs) -> Result<(), FolderError> {
        let Self { target, partial, journal, checkpoints: _, header, force, known, _lock } = self;
        let path = remove_result(partial.path())?;
        let mut result = OwnedFolder::make(&path, SHARD, &[])?;
        let about = ShardFile { header, inputs: inputs.clone() };
        let text = serde_json::to_vec_pretty(&about).map_err(|error| io(&path)(error.into()))?;
        result.write(SHARD_FILE, &text)?;
        let rows = result.file(JOURNAL)?;
        std::fs::copy(journal.path(), &rows).map_err(io(&rows))?;
        result.seal()?;
        put_in_place(&result, &target, force, &known, (journal, partial))?;
        Ok(())
    }
}

/// Removes the finished files that an earlier run may have left in its partial folder; gives the path where they are written.
fn remove_result(partial: &Path) -> Result<PathBuf, FolderError> {
    let path = partial.join(RESULT);
    if is_there(&path) && !is_empty(&path) {
        OwnedFolder::open(&path, None)?.remove()?;
    }
    Ok(path)
}

/// Writes the tables, part after part, and gives their names.
fn write_tables(outcome: &Outcome, result: &mut OwnedFolder) -> Result<Vec<String>, FolderError> {
    let folder = result.path().to_owned();
    let mut create = |table: Table| {
        let file = result.create(table.file())?;
        Rows::new(outcome, table, file).and_then(Rows::finish).map_err(|error| io(&folder.join(table.file()))(error.into()))
    };
    let kinds: &[Table] =
        if outcome.layout.is_some() { &[Table::States, Table::Path, Table::Fields] } else { &[Table::States, Table::Fields] };
    let mut tables: Vec<(Table, Option<DigestedFile>)> = Vec::new();
    for &table in kinds {
        // Most runs have no fields.
        tables.push((table, if table == Table::Fields { None } else { Some(create(table)?) }));
    }
    let texts = |rows: &[Row]| -> std::io::Result<Vec<Vec<u8>>> {
        let text = |&table: &Table| -> Result<Vec<u8>, csv::Error> {
            let mut text = Rows::further(outcome, table, Vec::new());
            rows.iter().try_for_each(|row| text.write(row))?;
            text.finish()
        };
        kinds.iter().map(|table| text(table).map_err(std::io::Error::from)).collect()
    };
    let mut failed = None;
    let visited = outcome.each_part(texts, |texts| {
        for ((table, file), text) in tables.iter_mut().zip(texts.iter()).filter(|(_, text)| !text.is_empty()) {
            if file.is_none() {
                match create(*table) {
                    Ok(fields) => *file = Some(fields),
                    Err(error) => {
                        failed = Some(error);
                        return Err(std::io::Error::other("a table"));
                    }
                }
            }
            file.as_mut().map_or(Ok(()), |file| file.write_all(text))?;
        }
        Ok(())
    });
    if let Some(error) = failed {
        return Err(error);
    }
    visited.map_err(io(&folder))?;
    let mut names = Vec::new();
    for (table, file) in tables {
        if let Some(file) = file {
            result.finish(table.file(), file)?;
            names.push(table.file().to_owned());
        }
    }
    Ok(names)
}
