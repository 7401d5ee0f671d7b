//! The folder of a run: written beside its place, moved there in one step, never half there.
//!
//! `DIR.partial` holds the journal while a run is under way and the finished files at its end; then it becomes `DIR` by a rename. With
//! `--force` an existing `DIR` steps aside first and is deleted last.

use super::checkpoints::Checkpoints;
use super::csv_table::{Rows, Table};
use super::journal::{Found, Journal, JournalHeader, is_held, read};
use super::{Outcome, plot, summary};
use rayon::prelude::*;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a folder cannot be written.
#[derive(Debug, Error)]
pub enum FolderError {
    /// It is there already.
    #[error("the folder `{0}` exists already: choose another --out, or add --force to replace it")]
    Exists(String),
    /// It is there, and no run has written it: other work would be lost.
    #[error("`{0}` is not replaced: it holds no summary.json, so it was not written by a run; choose another --out")]
    NotARun(String),
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
    /// The file system said no.
    #[error("`{path}` cannot be written: {error}")]
    Io {
        /// The path.
        path: String,
        /// Its words.
        error: String,
    },
}

/// A folder being filled.
#[derive(Debug)]
pub struct RunFolder {
    target: PathBuf,
    partial: PathBuf,
    journal: Journal,
    checkpoints: Checkpoints,
    force: bool,
}

/// Name of the journal inside the partial folder.
const JOURNAL: &str = "journal.jsonl";
/// Name of the summary: where it stands, the folder was written by a run.
const SUMMARY: &str = "summary.json";

fn io(path: &Path) -> impl Fn(std::io::Error) -> FolderError + '_ {
    move |error| FolderError::Io { path: path.display().to_string(), error: error.to_string() }
}

/// `DIR.partial` of `DIR`, and of `DIR/`, as shells complete it.
fn partial_of(target: &Path) -> PathBuf {
    beside(target, ".partial")
}

/// A path beside another, its name with an ending.
fn beside(target: &Path, ending: &str) -> PathBuf {
    // Collecting the components drops a stroke at the end.
    let mut name = target.components().collect::<PathBuf>().into_os_string();
    name.push(ending);
    PathBuf::from(name)
}

/// Whether a folder may be replaced by a run: it is empty, or a run has written it.
fn replaceable(target: &Path) -> bool {
    target.join(SUMMARY).is_file() || std::fs::read_dir(target).is_ok_and(|mut entries| entries.next().is_none())
}

impl RunFolder {
    /// Opens the partial folder of a run; gives the states that an earlier, killed run of the same scene finished.
    ///
    /// # Errors
    /// A folder that exists (without `force`), an unfinished run of something else, or a file system that refuses.
    pub fn open(target: &Path, header: &JournalHeader, force: bool) -> Result<Self, FolderError> {
        writable(target, force)?;
        let partial = partial_of(target);
        let journal_path = partial.join(JOURNAL);
        if is_held(&journal_path) {
            return Err(FolderError::Busy(partial.display().to_string()));
        }
        let finished = match read(&journal_path, header).map_err(io(&journal_path))? {
            Found::States(states) => states,
            Found::Nothing => 0,
            Found::Other(_) if force => {
                // Its files must not end among those of this run.
                std::fs::remove_dir_all(&partial).map_err(io(&partial))?;
                0
            }
            Found::Other(found) => {
                let found = format!("{}, scene {}", found.program, found.scene.get(..12).unwrap_or(&found.scene));
                return Err(FolderError::OtherRun { partial: partial.display().to_string(), found });
            }
        };
        std::fs::create_dir_all(&partial).map_err(io(&partial))?;
        let journal = Journal::open(&journal_path, header, finished).map_err(io(&journal_path))?;
        let checkpoints = Checkpoints::new(&partial, header);
        // A kill may have come between the journal and the end of a checkpoint.
        (0..finished).try_for_each(|state| checkpoints.remove(state)).map_err(io(&partial))?;
        Ok(Self { target: target.to_owned(), partial, journal, checkpoints, force })
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
        let Self { target, partial, journal, checkpoints: _, force } = self;
        let mut names = vec![SUMMARY.to_owned()];
        let path = partial.join(SUMMARY);
        let mut file = BufWriter::new(std::fs::File::create(&path).map_err(io(&path))?);
        summary::write_short(outcome, &mut file).and_then(|()| file.write_all(b"\n")).and_then(|()| file.flush()).map_err(io(&path))?;
        names.extend(write_tables(outcome, &partial)?);
        let mut write = |name: &str, bytes: &[u8]| -> Result<(), FolderError> {
            let path = partial.join(name);
            std::fs::write(&path, bytes).map_err(io(&path))?;
            names.push(name.to_owned());
            Ok(())
        };
        write("scene.toml", scene.as_bytes())?;
        // A picture takes longer than many states: side by side.
        let wanted = outcome.pictures;
        let draw = |figure: &plot::Figure| -> Result<(Option<String>, Option<Vec<u8>>), plot::PlotError> {
            let svg = wanted.svg.then(|| plot::svg(figure)).transpose()?;
            Ok((svg, wanted.png.then(|| plot::png(figure)).transpose()?))
        };
        let pictures: Vec<_> = outcome.figures.par_iter().map(|(stem, figure)| (stem, draw(figure))).collect();
        for (stem, picture) in pictures {
            match picture {
                Ok((svg, png)) => {
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
        // The journal goes last: a kill before the rename leaves a run to resume, a kill after it leaves the result and a spare file.
        moved(&partial, &target, force)?;
        drop(journal);
        let spare = target.join(JOURNAL);
        std::fs::remove_file(&spare).map_err(io(&spare))?;
        Ok(names)
    }
}

/// Writes the tables, row after row, and gives their names.
fn write_tables(outcome: &Outcome, partial: &Path) -> Result<Vec<String>, FolderError> {
    let create = |table: Table| {
        let path = partial.join(table.file());
        let file = std::fs::File::create(&path).map_err(io(&path))?;
        Rows::new(outcome, table, file).map_err(|error| io(&path)(error.into()))
    };
    let mut tables = vec![(Table::States, create(Table::States)?)];
    if outcome.layout.is_some() {
        tables.push((Table::Path, create(Table::Path)?));
    }
    let mut failed = None;
    let visited = outcome.each_row(&mut |row| {
        // Most runs have no fields.
        if !row.fields.is_empty() && tables.iter().all(|(table, _)| *table != Table::Fields) {
            match create(Table::Fields) {
                Ok(fields) => tables.push((Table::Fields, fields)),
                Err(error) => {
                    failed = Some(error);
                    return Err(std::io::Error::other("a table"));
                }
            }
        }
        tables.iter_mut().try_for_each(|(_, rows)| rows.write(row)).map_err(std::io::Error::from)
    });
    if let Some(error) = failed {
        return Err(error);
    }
    visited.map_err(io(partial))?;
    let mut names = Vec::new();
    for (table, rows) in tables {
        let path = partial.join(table.file());
        rows.finish().map_err(|error| io(&path)(error.into()))?;
        names.push(table.file().to_owned());
    }
    Ok(names)
}

/// Whether a folder of files may be written there.
///
/// # Errors
/// A folder that exists (without `force`) or was not written by a run.
pub fn writable(target: &Path, force: bool) -> Result<(), FolderError> {
    if target.exists() && !force {
        return Err(FolderError::Exists(target.display().to_string()));
    }
    if target.exists() && !replaceable(target) {
        return Err(FolderError::NotARun(target.display().to_string()));
    }
    Ok(())
}

/// Writes files that are all there already: beside the place of the folder, then moved there in one step.
///
/// # Errors
/// Those of [`writable`], or a file system that refuses.
pub fn write_whole(target: &Path, force: bool, files: &[(String, Vec<u8>)]) -> Result<(), FolderError> {
    writable(target, force)?;
    let partial = beside(target, &format!(".partial-{}", std::process::id()));
    std::fs::create_dir_all(&partial).map_err(io(&partial))?;
    for (name, bytes) in files {
        let path = partial.join(name);
        std::fs::write(&path, bytes).map_err(io(&path))?;
    }
    moved(&partial, target, force)
}

/// Moves a finished folder to its place; one that is there steps aside first and is deleted last.
fn moved(partial: &Path, target: &Path, force: bool) -> Result<(), FolderError> {
    if force && target.exists() {
        let aside = beside(target, &format!(".replaced-{}", std::process::id()));
        std::fs::rename(target, &aside).map_err(io(target))?;
        std::fs::rename(partial, target).map_err(io(target))?;
        std::fs::remove_dir_all(&aside).map_err(io(&aside))
    } else {
        std::fs::rename(partial, target).map_err(io(target))
    }
}
