//! The journal of a sweep: finished rows survive a killed run.
//!
//! A text of lines `["DIGEST",CONTENT]`, each JSON. The content of the first says what the journal belongs to; each further line holds the rows of one state.
//! Numbers are written so that they read back as the same double, so a resumed run ends in the same file.
//!
//! A digest is the SHA-256 of the digest of the line before and of the content. From the first line on that was cut short by a kill, or altered in any bit,
//! the journal counts as not written, and these states are solved again.

use super::owned::digest;
use super::row::Row;
use super::shard::Shard;
use crate::in_order::in_order;
use crate::regular_file;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
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
    /// Which of them it holds.
    pub shard: Shard,
}

impl JournalHeader {
    /// How many states the journal holds when it is whole.
    #[must_use]
    pub const fn own_states(&self) -> usize {
        self.shard.states(self.states)
    }
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

/// States that are read ahead of those that are wanted.
const AHEAD: usize = 256;

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
    while lines.next()?.is_some_and(|content| rows_of(content, header.shard.state(states)).is_some()) {
        states += 1;
    }
    Ok(Found::States(states))
}

/// Does work on the rows of each state of a journal, side by side, and hands the results over in the order of the states.
///
/// # Errors
/// A file that cannot be read, and what the caller reports.
pub fn each<R: Send>(
    path: &Path,
    work: impl Fn(Vec<Row>) -> std::io::Result<R> + Sync,
    mut take: impl FnMut(R) -> std::io::Result<()>,
) -> std::io::Result<()> {
    let mut lines = Lines::open(path)?;
    let header = lines.next()?.and_then(|content| serde_json::from_slice::<JournalHeader>(content).ok());
    let shard = header.ok_or_else(|| std::io::Error::other("the head of the journal cannot be read"))?.shard;
    let mut states = 0;
    let cut = |state: usize| std::io::Error::other(format!("state {} of the journal cannot be read", state + 1));
    let contents = std::iter::from_fn(|| {
        let state = shard.state(states);
        states += 1;
        match lines.at_end() {
            Ok(true) => None,
            Ok(false) => Some(lines.next().and_then(|content| Ok((state, content.ok_or_else(|| cut(state))?.to_vec())))),
            Err(error) => Some(Err(error)),
        }
    });
    in_order(
        contents,
        AHEAD,
        |(state, content)| work(rows_of(&content, state).ok_or_else(|| cut(state))?),
        |results| results.into_iter().try_for_each(&mut take),
    )
}

/// The rows of a state as the journal holds them.
///
/// # Errors
/// Rows that no JSON can hold.
pub fn encoded(rows: &[Row]) -> std::io::Result<Vec<u8>> {
    Ok(serde_json::to_vec(rows)?)
}

/// The lines of a journal, one at a time, as long as their digests are right.
pub(super) struct Lines {
    file: BufReader<Box<dyn Read>>,
    line: Vec<u8>,
    /// Of the last line.
    digest: String,
}

impl Lines {
    fn open(path: &Path) -> std::io::Result<Self> {
        Ok(Self::of(BufReader::new(Box::new(regular_file::open(path)?))))
    }

    /// The same of a file that is open only while a piece of so many bytes is read: thousands of them need no more than one at a time.
    pub(super) fn piecewise(path: &Path, bytes: usize) -> std::io::Result<Self> {
        regular_file::open(path)?;
        Ok(Self::of(BufReader::with_capacity(bytes, Box::new(Pieces { path: path.to_owned(), read: 0 }))))
    }

    fn of(file: BufReader<Box<dyn Read>>) -> Self {
        Self { file, line: Vec::new(), digest: FORMAT.to_owned() }
    }

    fn at_end(&mut self) -> std::io::Result<bool> {
        Ok(self.file.fill_buf()?.is_empty())
    }

    /// The content of the next line; none at the end, or where the line is not whole: its line feed is missing, or its digest is wrong.
    pub(super) fn next(&mut self) -> std::io::Result<Option<&[u8]>> {
        self.line.clear();
        self.file.read_until(b'\n', &mut self.line)?;
        let whole = self.line.pop() == Some(b'\n');
        Ok(content(&self.line, &mut self.digest).filter(|_| whole))
    }
}

/// A file that is opened for each piece that is read.
struct Pieces {
    path: PathBuf,
    read: u64,
}

impl Read for Pieces {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let mut file = regular_file::open(&self.path)?;
        file.seek(SeekFrom::Start(self.read))?;
        let count = file.read(bytes)?;
        self.read += count as u64;
        Ok(count)
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
        let lines = states.iter().map(|rows| encoded(rows)).collect::<std::io::Result<Vec<_>>>()?;
        self.append_encoded(lines.iter().map(Vec::as_slice))
    }

    /// The same of states whose rows are [`encoded`] already.
    ///
    /// # Errors
    /// As [`Journal::append`].
    pub fn append_encoded<'l>(&mut self, states: impl IntoIterator<Item = &'l [u8]>) -> std::io::Result<()> {
        let write_all = || {
            for content in states {
                self.states += 1;
                self.write_line(content)?;
            }
            self.file.flush()
        };
        write_all().map_err(|error| super::named(&self.path, error))
    }

    fn write_line(&mut self, content: &[u8]) -> std::io::Result<()> {
        self.digest = chained(&self.digest, content);
        write!(self.file, "[\"{}\",", self.digest)?;
        self.file.write_all(content)?;
        self.file.write_all(b"]\n")
    }
}
