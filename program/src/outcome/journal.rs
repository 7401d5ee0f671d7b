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
use std::io::{BufRead, BufReader, BufWriter, Write};
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
    let mut lines = match Lines::open(path) {
        Ok(lines) => lines,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(error),
    };
    match lines.next()?.and_then(|content| serde_json::from_slice::<JournalHeader>(content).ok()) {
        None => return Ok(Found::Nothing),
        Some(found) if found != *header => return Ok(Found::Other(found)),
        Some(_) => {}
    }
    let mut states = 0;
    while lines.next()?.is_some_and(|content| rows_of(content, states).is_some()) {
        states += 1;
    }
    Ok(Found::States(states))
}

/// Goes through the states of a journal, one at a time.
///
/// # Errors
/// A file that cannot be read, and what the caller reports.
pub fn each(path: &Path, visit: &mut dyn FnMut(Vec<Row>) -> std::io::Result<()>) -> std::io::Result<()> {
    let mut lines = Lines::open(path)?;
    lines.next()?;
    let mut states = 0;
    while !lines.at_end()? {
        let Some(rows) = lines.next()?.and_then(|content| rows_of(content, states)) else {
            return Err(std::io::Error::other(format!("state {} of the journal cannot be read", states + 1)));
        };
        states += 1;
        visit(rows)?;
    }
    Ok(())
}

/// The lines of a journal, one at a time, as long as their digests are right.
struct Lines {
    file: BufReader<File>,
    line: Vec<u8>,
    /// Of the last line.
    digest: String,
}

impl Lines {
    fn open(path: &Path) -> std::io::Result<Self> {
        Ok(Self { file: BufReader::new(regular_file::open(path)?), line: Vec::new(), digest: FORMAT.to_owned() })
    }

    fn at_end(&mut self) -> std::io::Result<bool> {
        Ok(self.file.fill_buf()?.is_empty())
    }

    /// The content of the next line; none at the end, or where the line is not whole: its line feed is missing, or its digest is wrong.
    fn next(&mut self) -> std::io::Result<Option<&[u8]>> {
        self.line.clear();
        self.file.read_until(b'\n', &mut self.line)?;
        let whole = self.line.pop() == Some(b'\n');
        Ok(content(&self.line, &mut self.digest).filter(|_| whole))
    }
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

/// The rows of a state, if they are of that state.
fn rows_of(content: &[u8], state: usize) -> Option<Vec<Row>> {
    let rows = serde_json::from_slice::<Vec<Row>>(content).ok()?;
    (!rows.is_empty() && rows.iter().all(|row| row.state == state)).then_some(rows)
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
        let file = BufWriter::new(File::create(&fresh)?);
        let mut journal = Self { path: path.to_owned(), file, digest: FORMAT.to_owned(), states: finished };
        journal.write_line(&serde_json::to_vec(header)?)?;
        if finished > 0 {
            let mut before = Lines::open(path)?;
            before.next()?;
            for _ in 0..finished {
                let Some(content) = before.next()? else { return Err(std::io::Error::other("the journal was altered while it was read")) };
                journal.write_line(content)?;
            }
        }
        journal.file.flush()?;
        std::fs::rename(&fresh, path)?;
        journal.file = BufWriter::new(OpenOptions::new().append(true).open(path)?);
        Ok(journal)
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
    /// A disk that is full; the sentence names the path.
    pub fn append(&mut self, states: &[Vec<Row>]) -> std::io::Result<()> {
        let written = states.iter().try_for_each(|rows| self.write_line(&serde_json::to_vec(rows)?)).and_then(|()| self.file.flush());
        self.states += states.len();
        written.map_err(|error| super::named(&self.path, error))
    }

    fn write_line(&mut self, content: &[u8]) -> std::io::Result<()> {
        self.digest = chained(&self.digest, content);
        write!(self.file, "[\"{}\",", self.digest)?;
        self.file.write_all(content)?;
        self.file.write_all(b"]\n")
    }
}
