//! The journal of a sweep: finished rows survive a killed run.
//!
//! A text of lines `["DIGEST",CONTENT]`, each JSON. The content of the first says what the journal belongs to; each further line holds the rows of one state.
//! Numbers are written so that they read back as the same double, so a resumed run ends in the same file.
//!
//! A digest is the SHA-256 of the digest of the line before and of the content. From the first line on that was cut short by a kill, or altered in any bit,
//! the journal counts as not written, and these states are solved again.

use super::owned::digest;
use super::row::Row;
use crate::regular_file;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// What the digest of the first line starts from.
const FORMAT: &str = "viscotack journal 1";

/// What a journal belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct JournalHeader {
    /// Version, commit and build of the program ([`super::build::identity`]).
    pub program: String,
    /// SHA-256 of the scene.
    pub scene: String,
    /// Number of states of the whole sweep.
    pub states: usize,
}

/// An open journal.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: BufWriter<File>,
    /// Of the last line.
    digest: String,
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
    let bytes = match regular_file::read(path, u64::MAX) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(error),
    };
    // A line is whole only if its line feed is there.
    let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(&[][..], |end| bytes.get(..end).unwrap_or(&[]));
    let mut before = FORMAT.to_owned();
    let mut contents = whole.split(|&byte| byte == b'\n').map_while(|line| content(line, &mut before));
    match contents.next().and_then(|line| serde_json::from_slice::<JournalHeader>(line).ok()) {
        None => return Ok(Found::Nothing),
        Some(found) if found != *header => return Ok(Found::Other(found)),
        Some(_) => {}
    }
    let states = contents.map_while(|line| serde_json::from_slice::<Vec<Row>>(line).ok());
    Ok(Found::Rows(
        states
            .enumerate()
            .take_while(|(index, rows)| !rows.is_empty() && rows.iter().all(|row| row.state == *index))
            .map(|(_, rows)| rows)
            .collect(),
    ))
}

/// The content of a line with the right digest, which then is the one before.
fn content<'l>(line: &'l [u8], before: &mut String) -> Option<&'l [u8]> {
    let (found, content) = line.strip_prefix(b"[\"")?.strip_suffix(b"]")?.split_at_checked(64)?;
    let content = content.strip_prefix(b"\",")?;
    let expected = chained(before, content);
    (found == expected.as_bytes()).then(|| {
        *before = expected;
        content
    })
}

fn chained(before: &str, content: &[u8]) -> String {
    digest(&[before.as_bytes(), content].concat())
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
        let mut journal = Self { path: fresh.clone(), file: BufWriter::new(File::create(&fresh)?), digest: FORMAT.to_owned() };
        journal.write_line(header)?;
        for rows in finished {
            journal.write_line(rows)?;
        }
        journal.file.flush()?;
        std::fs::rename(&fresh, path)?;
        journal.file = BufWriter::new(OpenOptions::new().append(true).open(path)?);
        journal.path = path.to_owned();
        Ok(journal)
    }

    /// Adds finished states and hands them to the system.
    ///
    /// # Errors
    /// A disk that is full; the sentence names the path.
    pub fn append(&mut self, states: &[Vec<Row>]) -> std::io::Result<()> {
        let written = states.iter().try_for_each(|rows| self.write_line(rows)).and_then(|()| self.file.flush());
        written.map_err(|error| super::named(&self.path, error))
    }

    fn write_line(&mut self, value: &impl Serialize) -> std::io::Result<()> {
        let content = serde_json::to_vec(value)?;
        self.digest = chained(&self.digest, &content);
        write!(self.file, "[\"{}\",", self.digest)?;
        self.file.write_all(&content)?;
        self.file.write_all(b"]\n")
    }
}
