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
use crate::regular_file;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Name of the mark.
pub const MARK: &str = ".viscotack";
/// The mark, or a file, while it is written.
const FRESH: &str = ".viscotack.new";
/// First line of every mark.
const FORMAT: &str = "viscotack folder 1";
/// No mark is larger (bytes).
const LARGEST: u64 = 16 << 20;

/// A folder with its mark.
#[derive(Debug)]
pub struct OwnedFolder {
    path: PathBuf,
    kind: String,
    /// The digest of each file; none while it may change.
    files: BTreeMap<String, Option<String>>,
}

/// SHA-256 of some bytes in hexadecimal digits.
#[must_use]
pub fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::with_capacity(64), |mut text, byte| {
        // Writing to a String cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
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
        let folder = Self { path: path.to_owned(), kind: kind.to_owned(), files };
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
        fs::write(&path, bytes).map_err(io(&path))
    }

    /// Writes a file beside its place, then renames it: a kill leaves the old one or the new one.
    ///
    /// # Errors
    /// As [`OwnedFolder::file`].
    pub fn replace(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let (path, fresh) = (self.file(name)?, self.path.join(FRESH));
        fs::write(&fresh, bytes).and_then(|()| fs::rename(&fresh, &path)).map_err(io(&path))
    }

    /// Marks all its files as finished.
    ///
    /// # Errors
    /// A file that cannot be read, or a mark that cannot be written.
    pub fn seal(&mut self) -> Result<(), FolderError> {
        for (name, sealed) in &mut self.files {
            let path = self.path.join(name);
            *sealed = Some(digest_of(&path).map_err(io(&path))?);
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
                Some((_, Some(sealed))) if digest_of(&path).map_err(io(&path))? != *sealed => {
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
                Some((_, Some(sealed))) => digest_of(&path).is_ok_and(|found| found == *sealed),
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
    Some(OwnedFolder { path: path.to_owned(), kind, files: files.collect::<Option<_>>()? })
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

/// SHA-256 of a file, read piece by piece.
pub(super) fn digest_of(path: &Path) -> std::io::Result<String> {
    if !fs::symlink_metadata(path)?.is_file() {
        return Err(std::io::Error::other("it is no regular file any more"));
    }
    let mut hasher = Sha256::new();
    std::io::copy(&mut File::open(path)?, &mut HashWriter(&mut hasher))?;
    Ok(hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

struct HashWriter<'h>(&'h mut Sha256);

impl std::io::Write for HashWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
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
