//! The journal of a sweep: finished rows survive a killed run.
//!
//! A text of lines `["DIGEST",CONTENT]`, each JSON. The content of the first says what the journal belongs to; each further line holds the rows of one state.
//! Numbers are written so that they read back as the same double, so a resumed run ends in the same file.
//!
//! A digest is the SHA-256 of the digest of the line before and of the content. From the first line on that was cut short by a kill, or altered in any bit,
//! the journal counts as not written, and these states are solved again.

use super::owned::{Digits, digits_of_parts};
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
    digest: Digits,
    states: usize,
}

/// Text that a thread reads at once (bytes; at least one state), and such parts that are read ahead of those that are wanted.
const PART: usize = 64 << 10;
const AHEAD: usize = 16;
/// Text that is handed to the system, or asked from it, at once (bytes).
const BUFFER: usize = 256 << 10;

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

/// Does work on parts of a journal, each the rows of some states, side by side, and hands the results over in the order of the states.
///
/// # Errors
/// A file that cannot be read, and what the caller reports.
pub fn each<R: Send>(
    path: &Path,
    work: impl Fn(Vec<Vec<Row>>) -> std::io::Result<R> + Sync,
    mut take: impl FnMut(&mut R) -> std::io::Result<()> + Send,
) -> std::io::Result<()> {
    let mut lines = Lines::open(path)?;
    let header = lines.next()?.and_then(|content| serde_json::from_slice::<JournalHeader>(content).ok());
    let shard = header.ok_or_else(|| std::io::Error::other("the head of the journal cannot be read"))?.shard;
    let mut read = 0;
    let cut = |index: usize| std::io::Error::other(format!("state {} of the journal cannot be read", shard.state(index) + 1));
    let mut next = |index: usize| -> std::io::Result<Option<Vec<u8>>> {
        if lines.at_end()? {
            return Ok(None);
        }
        Ok(Some(lines.next()?.ok_or_else(|| cut(index))?.to_vec()))
    };
    let mut failed = None;
    let parts = std::iter::from_fn(|| {
        let (first, mut contents, mut bytes) = (read, Vec::new(), 0);
        while bytes < PART && failed.is_none() {
            match next(first + contents.len()) {
                Ok(Some(content)) => {
                    bytes += content.len();
                    contents.push(content);
                }
                Ok(None) => break,
                Err(error) => failed = Some(error),
            }
        }
        read += contents.len();
        // What comes before an error is handed over.
        if contents.is_empty() { failed.take().map(Err) } else { Some(Ok((first, contents))) }
    });
    let rows = |(first, contents): (usize, Vec<Vec<u8>>)| -> std::io::Result<R> {
        let states = (first..).zip(&contents).map(|(index, content)| rows_of(content, shard.state(index)).ok_or_else(|| cut(index)));
        work(states.collect::<std::io::Result<_>>()?)
    };
    in_order(parts, AHEAD, rows, |results| results.iter_mut().try_for_each(&mut take))
}

/// States as the journal holds them, in one text: a thread that appends it has little memory of another thread to give back.
#[derive(Debug, Default)]
pub struct Encoded {
    text: Vec<u8>,
    /// Where each state ends.
    ends: Vec<usize>,
}

impl Encoded {
    /// Adds the rows of a state.
    ///
    /// # Errors
    /// Rows that no JSON can hold.
    pub fn push(&mut self, rows: &[Row]) -> std::io::Result<()> {
        serde_json::to_writer(&mut self.text, rows)?;
        self.ends.push(self.text.len());
        Ok(())
    }

    /// State after state.
    pub fn states(&self) -> impl Iterator<Item = &[u8]> {
        self.ends.iter().scan(0, |begin, &end| self.text.get(std::mem::replace(begin, end)..end))
    }
}

/// The lines of a journal, one at a time, as long as their digests are right.
pub(super) struct Lines {
    file: BufReader<Box<dyn Read + Send>>,
    line: Vec<u8>,
    /// Of the last line.
    digest: Option<Digits>,
}

impl Lines {
    fn open(path: &Path) -> std::io::Result<Self> {
        Ok(Self::of(BufReader::with_capacity(BUFFER, Box::new(regular_file::open(path)?))))
    }

    /// The same of a file that is open only while a piece of so many bytes is read: thousands of them need no more than one at a time.
    pub(super) fn piecewise(path: &Path, bytes: usize) -> std::io::Result<Self> {
        regular_file::open(path)?;
        Ok(Self::of(BufReader::with_capacity(bytes, Box::new(Pieces { path: path.to_owned(), read: 0 }))))
    }

    fn of(file: BufReader<Box<dyn Read + Send>>) -> Self {
        Self { file, line: Vec::new(), digest: None }
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
fn content<'l>(line: &'l [u8], before: &mut Option<Digits>) -> Option<&'l [u8]> {
    let (found, content) = line.strip_prefix(b"[\"")?.strip_suffix(b"]")?.split_at_checked(64)?;
    let content = content.strip_prefix(b"\",")?;
    let expected = chained(before.as_ref(), content);
    (found == expected).then(|| {
        *before = Some(expected);
        content
    })
}

/// The digest of a line, from that of the line before.
fn chained(before: Option<&Digits>, content: &[u8]) -> Digits {
    digits_of_parts(&[before.map_or(FORMAT.as_bytes(), |digits| digits), content])
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
        let file = BufWriter::with_capacity(BUFFER, File::create(&fresh)?);
        let head = serde_json::to_vec(header)?;
        let mut journal = Self { path: path.to_owned(), file, digest: chained(None, &head), states: finished };
        journal.put(&head)?;
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
        journal.file = BufWriter::with_capacity(BUFFER, OpenOptions::new().append(true).open(path)?);
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
        let mut encoded = Encoded::default();
        states.iter().try_for_each(|rows| encoded.push(rows))?;
        self.append_encoded(encoded.states())
    }

    /// The same of states that are [`Encoded`] already.
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
        self.digest = chained(Some(&self.digest), content);
        self.put(content)
    }

    /// A line whose digest has been taken.
    fn put(&mut self, content: &[u8]) -> std::io::Result<()> {
        for text in [b"[\"", self.digest.as_slice(), b"\",", content, b"]\n"] {
            self.file.write_all(text)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Short rows are handed to the threads many at a time, long ones one by one; all come in order, also where the journal was opened again.
    #[test]
    fn a_journal_is_read_in_parts() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal.jsonl");
        let states = 3000;
        let shard = Shard::new(1, 2).unwrap();
        let header = JournalHeader { program: "viscotack 0".into(), scene: "a".into(), states: 2 * states, shard };
        let rows = |index: usize| {
            let mut row = Row::new(shard.state(index), &[index as f64], vec!["x".repeat(if index < 5 { 2 * PART } else { 1 })], 2);
            row.reason = index.is_multiple_of(7).then(|| "why".to_owned());
            vec![row.clone(), row]
        };
        let mut journal = Journal::open(&path, &header, 0).unwrap();
        (0..1000).for_each(|index| journal.append(&[rows(index)]).unwrap());
        let mut journal = Journal::open(&path, &header, 1000).unwrap();
        journal.append(&(1000..states).map(rows).collect::<Vec<_>>()).unwrap();
        assert!(matches!(read(&path, &header).unwrap(), Found::States(found) if found == states));
        let (parts, mut found) = (AtomicUsize::new(0), Vec::new());
        let work = |states: Vec<Vec<Row>>| {
            parts.fetch_add(1, Ordering::Relaxed);
            Ok(states)
        };
        each(&path, work, |states| {
            found.append(states);
            Ok(())
        })
        .unwrap();
        assert!(found.len() == states && found.iter().enumerate().all(|(index, state)| *state == rows(index)));
        // Five long ones, and the bytes of the others by those of a part.
        let mut encoded = Encoded::default();
        (5..states).for_each(|index| encoded.push(&rows(index)).unwrap());
        let bytes: usize = encoded.states().map(<[u8]>::len).sum();
        let parts = parts.into_inner();
        assert!(parts > 5 && parts <= 6 + bytes.div_ceil(PART), "{parts} parts");
    }

    #[test]
    fn a_journal_that_is_cut_or_altered_is_not_read_further() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal.jsonl");
        let header = JournalHeader { program: "viscotack 0".into(), scene: "a".into(), states: 3, shard: Shard::WHOLE };
        let mut journal = Journal::open(&path, &header, 0).unwrap();
        journal.append(&[0, 1, 2].map(|state| vec![Row::new(state, &[], Vec::new(), 1)])).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, text.replacen("\"state\":1", "\"state\":2", 1)).unwrap();
        assert!(matches!(read(&path, &header).unwrap(), Found::States(1)));
        let mut found = 0;
        let error = each(&path, Ok, |states| {
            found += states.len();
            Ok(())
        });
        let error = error.unwrap_err();
        assert_eq!(found, 1);
        assert_eq!(error.to_string(), "state 2 of the journal cannot be read");
    }
}
