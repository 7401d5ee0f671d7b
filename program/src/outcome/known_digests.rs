//! Digests of files that this process has read, for as long as the file system says that the files are unchanged: a large table is not read a second time
//! only to be deleted.

use super::owned::digest_of;
use std::collections::BTreeMap;
use std::fs::{Metadata, symlink_metadata};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// What a file system says of a file: which it is, how long, and when it was last altered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Stamp {
    device: u64,
    file: u64,
    length: u64,
    /// Seconds and nanoseconds of the last change of the content, and of anything about the file, which no program can set back.
    modified: (i64, i64),
    changed: (i64, i64),
}

/// What is known; its clones share it.
#[derive(Debug, Clone, Default)]
pub(super) struct KnownDigests(Arc<Mutex<Known>>);

/// By device and file.
type Known = BTreeMap<(u64, u64), (Stamp, String)>;

impl KnownDigests {
    /// SHA-256 of a file.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub(super) fn of(&self, path: &Path) -> std::io::Result<String> {
        let before = symlink_metadata(path).ok().and_then(|about| Stamp::of(&about));
        let Some(stamp) = before else { return digest_of(path) };
        let key = (stamp.device, stamp.file);
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if let Some((_, digest)) = known.filter(|(known, _)| *known == stamp) {
            return Ok(digest);
        }
        let is_settled = stamp.is_settled();
        let digest = digest_of(path)?;
        if is_settled {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(key, (stamp, digest.clone()));
        }
        Ok(digest)
    }
}

#[cfg(unix)]
impl Stamp {
    fn of(about: &Metadata) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        Some(Self {
            device: about.dev(),
            file: about.ino(),
            length: about.len(),
            modified: (about.mtime(), about.mtime_nsec()),
            changed: (about.ctime(), about.ctime_nsec()),
        })
    }

    /// Whether a later change must show in the times: they are fine enough, and older than the steps of the clock of a file system, at most 0.01 s.
    fn is_settled(&self) -> bool {
        const STEPS: i128 = 20_000_000;
        let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |since| since.as_nanos() as i128);
        let nanoseconds = |(seconds, rest): (i64, i64)| i128::from(seconds) * 1_000_000_000 + i128::from(rest);
        self.changed.1 != 0 && now - nanoseconds(self.changed).max(nanoseconds(self.modified)) > STEPS
    }
}

#[cfg(not(unix))]
impl Stamp {
    fn of(_: &Metadata) -> Option<Self> {
        None
    }

    fn is_settled(&self) -> bool {
        false
    }
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::outcome::owned::digest;
    use std::fs;
    use std::time::Duration;

    #[test]
    fn a_file_is_read_once_and_again_after_any_change() {
        let folder = tempfile::tempdir().unwrap();
        let (path, moved) = (folder.path().join("a"), folder.path().join("b"));
        let known = KnownDigests::default();
        let entries = || known.0.lock().unwrap().len();
        fs::write(&path, "one").unwrap();
        let written = fs::metadata(&path).unwrap().modified().unwrap();
        // Just written: another change might carry the same time.
        assert_eq!((known.of(&path).unwrap(), entries()), (digest(b"one"), 0));
        std::thread::sleep(Duration::from_millis(50));
        assert_eq!((known.of(&path).unwrap(), entries()), (digest(b"one"), 1));
        // What is known is used: a wrong digest put in its place comes back.
        known.0.lock().unwrap().values_mut().for_each(|(_, digest)| *digest = "known".to_owned());
        assert_eq!(known.of(&path).unwrap(), "known");
        // The same length and the same time of the content, which anybody can set.
        fs::write(&path, "two").unwrap();
        fs::File::options().write(true).open(&path).unwrap().set_modified(written).unwrap();
        assert_eq!(known.of(&path).unwrap(), digest(b"two"));
        // Another file in its place.
        fs::write(&moved, "six").unwrap();
        fs::rename(&moved, &path).unwrap();
        assert_eq!(known.of(&path).unwrap(), digest(b"six"));
        fs::remove_file(&path).unwrap();
        assert!(known.of(&path).is_err());
    }
}
