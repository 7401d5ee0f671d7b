//! The journal of a sweep: finished rows survive a killed run.
//!
//! A text of JSON lines. The first says what the journal belongs to; each further line holds the rows of one state. Numbers are written
//! so that they read back as the same double, so a resumed run ends in the same file. A last line cut short by the kill is dropped.

use super::row::Row;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{BufWriter, Read, Write};
use std::path::Path;

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
}

/// What an existing journal held.
#[derive(Debug)]
pub enum Found {
    /// Nothing: a new run.
    Nothing,
    /// Rows of the first states of the same run, complete and in order.
    Rows(Vec<Vec<Row>>),
    /// The journal of another scene or another build.
    Other(JournalHeader),
}

/// Reads a journal, as far as it is whole.
///
/// # Errors
/// A file that exists and cannot be read.
pub fn read(path: &Path, header: &JournalHeader) -> std::io::Result<Found> {
    let mut bytes = Vec::new();
    match File::open(path) {
        Ok(mut file) => file.read_to_end(&mut bytes)?,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(error),
    };
    // A line is whole only if its line feed is there.
    let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(&[][..], |end| bytes.get(..end).unwrap_or(&[]));
    let mut lines = whole.split(|&byte| byte == b'\n');
    match lines.next().and_then(|line| serde_json::from_slice::<JournalHeader>(line).ok()) {
        None => return Ok(Found::Nothing),
        Some(found) if found != *header => return Ok(Found::Other(found)),
        Some(_) => {}
    }
    let states = lines.map_while(|line| serde_json::from_slice::<Vec<Row>>(line).ok());
    Ok(Found::Rows(
        states
            .enumerate()
            .take_while(|(index, rows)| !rows.is_empty() && rows.iter().all(|row| row.state == *index))
            .map(|(_, rows)| rows)
            .collect(),
    ))
}

/// Whether another run is writing this journal now. The system drops the lock of a run that ends or is killed.
#[must_use]
pub fn is_held(path: &Path) -> bool {
    File::open(path).is_ok_and(|file| matches!(file.try_lock(), Err(std::fs::TryLockError::WouldBlock)))
}

impl Journal {
    /// Opens a journal anew with the states that are finished already.
    ///
    /// The new text replaces the old in one rename, so that a kill at any instant leaves one of the two.
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub fn open(path: &Path, header: &JournalHeader, finished: &[Vec<Row>]) -> std::io::Result<Self> {
        let fresh = path.with_extension("new");
        let mut file = BufWriter::new(File::create(&fresh)?);
        write_line(&mut file, header)?;
        for rows in finished {
            write_line(&mut file, rows)?;
        }
        file.flush()?;
        std::fs::rename(&fresh, path)?;
        let file = OpenOptions::new().append(true).open(path)?;
        // Held until the run ends; a file system without locks is no reason not to run.
        let _ = file.try_lock();
        let file = BufWriter::new(file);
        Ok(Self { file })
    }

    /// Adds finished states and hands them to the system.
    ///
    /// # Errors
    /// A disk that is full.
    pub fn append(&mut self, states: &[Vec<Row>]) -> std::io::Result<()> {
        for rows in states {
            write_line(&mut self.file, rows)?;
        }
        self.file.flush()
    }
}

fn write_line(file: &mut impl Write, value: &impl Serialize) -> std::io::Result<()> {
    serde_json::to_writer(&mut *file, value)?;
    file.write_all(b"\n")
}
