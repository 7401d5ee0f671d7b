//! A folder that this program owns. A mark file in it lists what the program writes there; nothing else is ever replaced or deleted.
//!
//! The mark is a text: a line that names the format, the kind of the folder, a line for each file, and a digest of all lines before it:
//! ```text
//! viscotack folder 1
//! kind run
//! open journal.jsonl
//! 5f3c…  states.csv
//! digest 91ab…
//! ```
//! A file is `open` while it may change; a finished folder has the SHA-256 of each file, so that what somebody altered later is not deleted either.
//! In the name of an open file `*` stands for hexadecimal digits.

use super::folder::FolderError;
use super::known_digests::KnownDigests;
use crate::regular_file;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// Name of the mark.
pub const MARK: &str = ".viscotack";
/// The mark, or a file, while it is written.
const FRESH: &str = ".viscotack.new";
/// First line of every mark.
const FORMAT: &str = "viscotack folder 1";
/// No mark is larger (bytes).
const LARGEST: u64 = 16 << 20;
/// What is written, and read, at once (bytes): a piece that is read stays in the cache of a core.
const BUFFER: usize = 256 << 10;
const READ: usize = 64 << 10;

/// A folder with its mark.
#[derive(Debug)]
pub struct OwnedFolder {
    path: PathBuf,
    kind: String,
    /// The digest of each file; none while it may change.
    files: BTreeMap<String, Option<String>>,
    /// Digests of files that were taken while the files were written: they need not be read again.
    written: BTreeMap<String, String>,
    /// Of files that were read before.
    known: KnownDigests,
}

/// SHA-256 of some bytes in hexadecimal digits.
#[must_use]
pub fn digest(bytes: &[u8]) -> String {
    digest_of_parts(&[bytes])
}

/// The same of bytes that lie in several places.
pub(super) fn digest_of_parts(parts: &[&[u8]]) -> String {
    digits_of_parts(parts).into_iter().map(char::from).collect()
}

/// The hexadecimal digits of a SHA-256.
pub(super) type Digits = [u8; 64];

/// The same where a string would take longer than the digest of a short text.
pub(super) fn digits_of_parts(parts: &[&[u8]]) -> Digits {
    digits(parts.iter().fold(Sha256::new(), |hasher, part| hasher.chain_update(part)))
}

/// Digit by digit: the formatting machinery would take longer than the digest of a short text.
fn digits(hasher: Sha256) -> Digits {
    let digit = |value: u8| if value < 10 { b'0' + value } else { b'a' + value - 10 };
    let mut digits = [0; 64];
    for (pair, byte) in digits.chunks_exact_mut(2).zip(hasher.finalize()) {
        pair.copy_from_slice(&[digit(byte >> 4), digit(byte & 0xf)]);
    }
    digits
}

fn hexadecimal(hasher: Sha256) -> String {
    digits(hasher).into_iter().map(char::from).collect()
}

fn io(path: &Path) -> impl Fn(std::io::Error) -> FolderError + '_ {
    FolderError::io(path)
}

impl OwnedFolder {
    /// Makes a folder, where none or an empty one is, of a kind and with the names of its open files.
    ///
    /// # Errors
    /// A folder that holds anything, or a file system that refuses.
    pub fn make(path: &Path, kind: &str, open: &[&str]) -> Result<Self, FolderError> {
        fs::create_dir_all(path).map_err(io(path))?;
        // A mark that a kill or a full disk cut short is none.
        if let Some(entry) = entries(path)?.into_iter().find(|name| name != FRESH) {
            return Err(FolderError::NotOwned { path: shown(path), why: holds(&entry) });
        }
        let files = open.iter().map(|name| ((*name).to_owned(), None)).collect();
        let folder = Self { path: path.to_owned(), kind: kind.to_owned(), files, written: BTreeMap::new(), known: KnownDigests::default() };
        if let Err(error) = folder.write_mark() {
            // Nothing of it is of use to anybody; the reason is the one before.
            drop(fs::remove_file(path.join(FRESH)).and_then(|()| fs::remove_dir(path)));
            return Err(error);
        }
        Ok(folder)
    }

    /// The folder that carries a mark, or a new one where nothing is.
    ///
    /// # Errors
    /// Those of [`OwnedFolder::open`] and [`OwnedFolder::make`].
    pub fn open_or_make(path: &Path, kind: &str, open: &[&str]) -> Result<Self, FolderError> {
        if path.is_symlink() || fs::symlink_metadata(path.join(MARK)).is_ok() {
            Self::open(path, Some(kind))
        } else {
            Self::make(path, kind, open)
        }
    }

    /// The folder that is there, if it carries a mark of that kind, or of any.
    ///
    /// # Errors
    /// A sentence on why this program does not own it.
    pub fn open(path: &Path, kind: Option<&str>) -> Result<Self, FolderError> {
        let not = |why: String| FolderError::NotOwned { path: shown(path), why };
        // Without the stroke that shells put behind it, which follows a link.
        if path.components().collect::<PathBuf>().is_symlink() {
            return Err(not("it is a symbolic link".to_owned()));
        }
        if !path.is_dir() {
            return Err(not("it is no folder".to_owned()));
        }
        let Ok(bytes) = regular_file::read(&path.join(MARK), LARGEST) else {
            let first = entries(path)?.into_iter().next();
            return Err(not(first.map_or_else(|| "it carries no mark of this program".to_owned(), |entry| holds(&entry))));
        };
        let Some(found) = parsed(path, &bytes) else { return Err(not(format!("its mark, {MARK}, was altered"))) };
        match kind {
            Some(kind) if kind != found.kind => {
                Err(not(format!("its mark says that it is a folder of another kind, `{}`", shown_text(&found.kind))))
            }
            _ => Ok(found),
        }
    }

    /// The same with digests of files that were read before, and for further ones.
    pub(super) fn with_known(self, known: &KnownDigests) -> Self {
        Self { known: known.clone(), ..self }
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The path of a file that is about to be written: it belongs to the program from now on.
    ///
    /// # Errors
    /// A file of that name that somebody else has put there, or a file system that refuses.
    pub fn file(&mut self, name: &str) -> Result<PathBuf, FolderError> {
        let path = self.path.join(name);
        if !self.files.contains_key(name) {
            if fs::symlink_metadata(&path).is_ok() {
                let why = "it is there already, and this program has not written it".to_owned();
                return Err(FolderError::NotOwned { path: shown(&path), why });
            }
            self.files.insert(name.to_owned(), None);
            self.write_mark()?;
        }
        Ok(path)
    }

    /// Writes a file.
    ///
    /// # Errors
    /// As [`OwnedFolder::file`].
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let path = self.file(name)?;
        fs::write(&path, bytes).map_err(io(&path))?;
        self.written.insert(name.to_owned(), digest(bytes));
        Ok(())
    }

    /// A file that was [created](OwnedFolder::create) is written to its end.
    ///
    /// # Errors
    /// A full disk.
    pub fn finish(&mut self, name: &str, file: DigestedFile) -> Result<(), FolderError> {
        let digest = file.finish().map_err(io(&self.path.join(name)))?;
        self.written.insert(name.to_owned(), digest);
        Ok(())
    }

    /// Begins a file that is written piece by piece.
    ///
    /// # Errors
    /// As [`OwnedFolder::file`].
    pub fn create(&mut self, name: &str) -> Result<DigestedFile, FolderError> {
        let path = self.file(name)?;
        let file = BufWriter::with_capacity(BUFFER, File::create(&path).map_err(io(&path))?);
        Ok(DigestedFile { file, hasher: Sha256::new() })
    }

    /// Writes a file beside its place, then renames it: a kill leaves the old one or the new one.
    ///
    /// # Errors
    /// As [`OwnedFolder::file`].
    pub fn replace(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let (path, fresh) = (self.file(name)?, self.path.join(FRESH));
        self.written.remove(name);
        fs::write(&fresh, bytes).and_then(|()| fs::rename(&fresh, &path)).map_err(io(&path))
    }

    /// Marks all its files as finished.
    ///
    /// # Errors
    /// A file that cannot be read, or a mark that cannot be written.
    pub fn seal(&mut self) -> Result<(), FolderError> {
        for (name, sealed) in &mut self.files {
            let path = self.path.join(name);
            *sealed = Some(match self.written.remove(name) {
                Some(digest) => digest,
                None => digest_of(&path).map_err(io(&path))?,
            });
        }
        self.write_mark()
    }

    /// Why it may not be deleted: the first thing in it that the program has not written, or that was altered.
    ///
    /// # Errors
    /// A folder that cannot be read.
    pub fn foreign(&self) -> Result<Option<String>, FolderError> {
        for name in entries(&self.path)? {
            if name == MARK || name == FRESH {
                continue;
            }
            let path = self.path.join(&name);
            if !fs::symlink_metadata(&path).is_ok_and(|about| about.is_file()) {
                return Ok(Some(holds(&name)));
            }
            match self.files.iter().find(|(own, _)| matches(own, &name)) {
                None => return Ok(Some(holds(&name))),
                Some((_, Some(sealed))) if self.known.of(&path).map_err(io(&path))? != *sealed => {
                    return Ok(Some(format!("`{}` in it was altered", shown_text(&name))));
                }
                Some(_) => {}
            }
        }
        Ok(None)
    }

    /// Whether every file is finished.
    #[must_use]
    pub fn is_sealed(&self) -> bool {
        self.files.values().all(Option::is_some)
    }

    /// Whether a finished file still has these bytes.
    pub(super) fn is_sealed_as(&self, name: &str, bytes: &[u8]) -> bool {
        self.files.get(name).is_some_and(|sealed| sealed.as_deref() == Some(digest(bytes).as_str()))
    }

    /// Deletes its own files, its mark, and the folder, unless it holds anything else; gives whether it is gone.
    ///
    /// # Errors
    /// A file system that refuses.
    pub fn remove(self) -> Result<bool, FolderError> {
        if !self.path.exists() {
            return Ok(true);
        }
        for name in entries(&self.path)? {
            let path = self.path.join(&name);
            let own = self.files.iter().find(|(own, _)| matches(own, &name));
            let is_own = match own {
                Some((_, Some(sealed))) => self.known.of(&path).is_ok_and(|found| found == *sealed),
                Some((_, None)) => fs::symlink_metadata(&path).is_ok_and(|about| about.is_file()),
                None => name == FRESH,
            };
            if is_own {
                fs::remove_file(&path).map_err(io(&path))?;
            }
        }
        let mark = self.path.join(MARK);
        match fs::remove_file(&mark) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => return Err(io(&mark)(error)),
            _ => {}
        }
        // Fails where somebody else's files are left.
        Ok(fs::remove_dir(&self.path).is_ok())
    }

    /// Keeps every other run out until the file is dropped; none where another run is in.
    ///
    /// # Errors
    /// A mark that cannot be opened.
    pub fn lock(&self) -> Result<Option<File>, FolderError> {
        let path = self.path.join(MARK);
        let file = File::open(&path).map_err(io(&path))?;
        // A file system without locks is no reason not to run.
        Ok((!matches!(file.try_lock(), Err(fs::TryLockError::WouldBlock))).then_some(file))
    }

    fn write_mark(&self) -> Result<(), FolderError> {
        let mut text = format!("{FORMAT}\nkind {}\n", self.kind);
        for (name, sealed) in &self.files {
            let _ = match sealed {
                Some(digest) => writeln!(text, "{digest}  {name}"),
                None => writeln!(text, "open {name}"),
            };
        }
        let _ = writeln!(text, "digest {}", digest(text.as_bytes()));
        let (fresh, mark) = (self.path.join(FRESH), self.path.join(MARK));
        fs::write(&fresh, text).map_err(io(&fresh))?;
        fs::rename(&fresh, &mark).map_err(io(&mark))
    }
}

/// What a mark says; none if any byte of it was altered.
fn parsed(path: &Path, bytes: &[u8]) -> Option<OwnedFolder> {
    let text = std::str::from_utf8(bytes).ok()?;
    let (content, last) = text.strip_suffix('\n')?.rsplit_once("\ndigest ")?;
    let content = format!("{content}\n");
    if digest(content.as_bytes()) != last {
        return None;
    }
    let mut lines = content.lines();
    if lines.next()? != FORMAT {
        return None;
    }
    let kind = lines.next()?.strip_prefix("kind ")?.to_owned();
    let files = lines.map(|line| match line.strip_prefix("open ") {
        Some(name) => Some((name.to_owned(), None)),
        None => line.split_once("  ").map(|(digest, name)| (name.to_owned(), Some(digest.to_owned()))),
    });
    Some(OwnedFolder {
        path: path.to_owned(),
        kind,
        files: files.collect::<Option<_>>()?,
        written: BTreeMap::new(),
        known: KnownDigests::default(),
    })
}

/// Whether a listed name, in which `*` stands for hexadecimal digits, is this one.
fn matches(listed: &str, name: &str) -> bool {
    match listed.split_once('*') {
        None => listed == name,
        Some((before, after)) => name
            .strip_prefix(before)
            .and_then(|rest| rest.strip_suffix(after))
            .is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit())),
    }
}

/// SHA-256 of a file.
pub(super) fn digest_of(path: &Path) -> std::io::Result<String> {
    if !fs::symlink_metadata(path)?.is_file() {
        return Err(std::io::Error::other("it is no regular file any more"));
    }
    digest_of_read(File::open(path)?)
}

/// SHA-256 of all that can be read, piece by piece.
pub(super) fn digest_of_read(mut file: impl Read) -> std::io::Result<String> {
    let (mut hasher, mut bytes) = (Sha256::new(), vec![0; READ]);
    loop {
        match file.read(&mut bytes) {
            Ok(0) => return Ok(hexadecimal(hasher)),
            Ok(count) => hasher.update(bytes.get(..count).unwrap_or(&[])),
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// A file whose digest is taken while it is written.
#[derive(Debug)]
pub struct DigestedFile {
    file: BufWriter<File>,
    hasher: Sha256,
}

impl DigestedFile {
    fn finish(mut self) -> std::io::Result<String> {
        self.file.flush()?;
        Ok(hexadecimal(self.hasher))
    }
}

impl Write for DigestedFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        // All of it is taken, or the file is at an end.
        self.file.write_all(bytes)?;
        self.hasher.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

/// The names in a folder, in order.
fn entries(path: &Path) -> Result<Vec<String>, FolderError> {
    let read = fs::read_dir(path).map_err(io(path))?;
    let mut names = read
        .map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()))
        .collect::<std::io::Result<Vec<_>>>()
        .map_err(io(path))?;
    names.sort();
    Ok(names)
}

fn holds(name: &str) -> String {
    format!("it holds `{}`, which this program has not written", shown_text(name))
}

fn shown(path: &Path) -> String {
    crate::terminal_text::name(path)
}

fn shown_text(name: &str) -> String {
    crate::terminal_text::one_line(name)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn any_altered_byte_of_a_mark_disowns_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("DIR");
        let mut owned = OwnedFolder::make(&path, "run", &[]).unwrap();
        owned.write("states.csv", b"1,2\n").unwrap();
        owned.seal().unwrap();
        let mark = fs::read(path.join(MARK)).unwrap();
        for place in 0..8 * mark.len() {
            let mut altered = mark.clone();
            *altered.get_mut(place / 8).unwrap() ^= 1 << (place % 8);
            fs::write(path.join(MARK), altered).unwrap();
            assert!(OwnedFolder::open(&path, None).is_err(), "bit {place}");
        }
        for length in 0..mark.len() {
            fs::write(path.join(MARK), mark.get(..length).unwrap()).unwrap();
            assert!(OwnedFolder::open(&path, None).is_err(), "cut at {length}");
        }
        fs::write(path.join(MARK), mark).unwrap();
        assert!(OwnedFolder::open(&path, Some("run")).unwrap().remove().unwrap());
        assert!(!path.exists());
    }

    /// The digest is taken while a file is written, whole or piece by piece: sealing reads no file again, and what somebody alters before it is found.
    #[test]
    fn a_file_altered_before_the_seal_counts_as_altered() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("DIR");
        let mut owned = OwnedFolder::make(&path, "run", &[]).unwrap();
        owned.write("scene.toml", b"a scene").unwrap();
        let mut table = owned.create("states.csv").unwrap();
        (0..3).for_each(|row| writeln!(table, "{row},{row}").unwrap());
        owned.finish("states.csv", table).unwrap();
        owned.seal().unwrap();
        assert_eq!(owned.foreign().unwrap(), None);
        let sealed = |name: &str| owned.files.get(name).cloned().flatten();
        assert_eq!(sealed("states.csv"), Some(digest(b"0,0\n1,1\n2,2\n")));
        assert_eq!(sealed("scene.toml"), Some(digest_of(&path.join("scene.toml")).unwrap()));
        let mut again = OwnedFolder::open(&path, None).unwrap();
        again.write("scene.toml", b"a scene").unwrap();
        fs::write(path.join("scene.toml"), "another").unwrap();
        again.seal().unwrap();
        assert!(again.foreign().unwrap().is_some_and(|why| why.contains("scene.toml")));
    }

    #[test]
    fn a_digest_is_that_of_the_standard() {
        // FIPS 180-2, example B.1.
        assert_eq!(digest(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert_eq!(digest_of_parts(&[b"a", b"", b"bc"]), digest(b"abc"));
    }

    #[test]
    fn only_listed_and_unaltered_files_are_deleted() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("DIR");
        let mut owned = OwnedFolder::make(&path, "run", &["state-*.checkpoint"]).unwrap();
        owned.write("a.csv", b"a").unwrap();
        for (name, own) in [("state-12.checkpoint", true), ("state-.checkpoint", false), ("state-my.checkpoint", false)] {
            fs::write(path.join(name), "x").unwrap();
            assert_eq!(owned.foreign().unwrap().is_none(), own, "{name}");
        }
        assert!(!owned.remove().unwrap());
        assert_eq!(entries(&path).unwrap(), ["state-.checkpoint", "state-my.checkpoint"]);
        assert!(OwnedFolder::make(&path, "run", &[]).is_err());
    }
}
