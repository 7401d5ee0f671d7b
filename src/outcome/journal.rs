//! The journal of a sweep: finished rows survive a killed run.
//!
//! A text of JSON lines. The first says what the journal belongs to; each further line holds the rows of one state. Numbers are written
//! so that they read back as the same double, so a resumed run ends in the same file. A last line cut short by the kill is dropped.

use super::row::Row;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

/// What a journal belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct JournalHeader {
    /// Version and commit of the program.
    pub program: String,
    /// SHA-256 of the scene.
    pub scene: String,
    /// Number of states of the whole sweep.
    pub states: usize,
}

/// An open journal.
#[derive(Debug)]
pub struct Journal {
    file: BufWriter<File>,
    path: PathBuf,
    states: usize,
}

/// What an existing journal held.
#[derive(Debug)]
pub enum Found {
    /// Nothing: a new run.
    Nothing,
    /// So many of the first states of the same run, complete and in order.
    States(usize),
    /// The journal of another scene or another build.
    Other(JournalHeader),
}

/// Reads a journal, as far as it is whole.
///
/// # Errors
/// A file that exists and cannot be read.
pub fn read(path: &Path, header: &JournalHeader) -> std::io::Result<Found> {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(error),
    };
    let mut file = BufReader::new(file);
    let mut line = Vec::new();
    if !next_line(&mut file, &mut line)? {
        return Ok(Found::Nothing);
    }
    match serde_json::from_slice::<JournalHeader>(&line) {
        Err(_) => return Ok(Found::Nothing),
        Ok(found) if found != *header => return Ok(Found::Other(found)),
        Ok(_) => {}
    }
    let mut states = 0;
    while next_line(&mut file, &mut line)? && rows_of(&line, states).is_some() {
        states += 1;
    }
    Ok(Found::States(states))
}

/// Goes through the states of a journal, one at a time.
///
/// # Errors
/// A file that cannot be read, and what the caller reports.
pub fn each(path: &Path, visit: &mut dyn FnMut(Vec<Row>) -> std::io::Result<()>) -> std::io::Result<()> {
    let mut file = BufReader::new(File::open(path)?);
    let mut line = Vec::new();
    next_line(&mut file, &mut line)?;
    let mut states = 0;
    while next_line(&mut file, &mut line)? {
        let Some(rows) = rows_of(&line, states) else {
            return Err(std::io::Error::other(format!("state {} of the journal cannot be read", states + 1)));
        };
        states += 1;
        visit(rows)?;
    }
    Ok(())
}

/// The next line; it is whole only if its line feed is there.
fn next_line(file: &mut impl BufRead, line: &mut Vec<u8>) -> std::io::Result<bool> {
    line.clear();
    file.read_until(b'\n', line)?;
    Ok(line.pop() == Some(b'\n'))
}

/// The rows of a state, if they are whole and of that state.
fn rows_of(line: &[u8], state: usize) -> Option<Vec<Row>> {
    let rows = serde_json::from_slice::<Vec<Row>>(line).ok()?;
    (!rows.is_empty() && rows.iter().all(|row| row.state == state)).then_some(rows)
}

/// Whether another run is writing this journal now. The system drops the lock of a run that ends or is killed.
#[must_use]
pub fn is_held(path: &Path) -> bool {
    File::open(path).is_ok_and(|file| matches!(file.try_lock(), Err(std::fs::TryLockError::WouldBlock)))
}

impl Journal {
    /// Opens a journal anew with so many states that it holds already.
    ///
    /// The new text replaces the old in one rename, so that a kill at any instant leaves one of the two.
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub fn open(path: &Path, header: &JournalHeader, finished: usize) -> std::io::Result<Self> {
        let fresh = path.with_extension("new");
        let mut file = BufWriter::new(File::create(&fresh)?);
        write_line(&mut file, header)?;
        if finished > 0 {
            let mut before = BufReader::new(File::open(path)?);
            let mut line = Vec::new();
            next_line(&mut before, &mut line)?;
            for _ in 0..finished {
                next_line(&mut before, &mut line)?;
                file.write_all(&line)?;
                file.write_all(b"\n")?;
            }
        }
        file.flush()?;
        std::fs::rename(&fresh, path)?;
        let file = OpenOptions::new().append(true).open(path)?;
        // Held until the run ends; a file system without locks is no reason not to run.
        let _ = file.try_lock();
        let file = BufWriter::new(file);
        Ok(Self { file, path: path.to_owned(), states: finished })
    }

    /// How many states it holds.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.states
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds finished states and hands them to the system.
    ///
    /// # Errors
    /// A disk that is full.
    pub fn append(&mut self, states: &[Vec<Row>]) -> std::io::Result<()> {
        for rows in states {
            write_line(&mut self.file, rows)?;
        }
        self.states += states.len();
        self.file.flush()
    }
}

fn write_line(file: &mut impl Write, value: &impl Serialize) -> std::io::Result<()> {
    serde_json::to_writer(&mut *file, value)?;
    file.write_all(b"\n")
}
