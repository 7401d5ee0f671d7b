//! Checkpoints of states under way, beside the journal: a killed run goes on within a state.
//!
//! One file a state: SHA-256 of what follows, then the header of the run, the state and the checkpoint, in the binary form of postcard, which keeps every
//! double bit for bit, infinities too. A file that is cut, altered, or of another scene or build counts as none: the state then begins anew.

use super::journal::JournalHeader;
use crate::regular_file;
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Length of the digest (bytes).
const DIGEST: usize = 32;
/// What the name of every such file begins with, and ends in.
const BEGINNING: &str = "state-";
const ENDING: &str = "checkpoint";
/// No checkpoint is larger (bytes).
const LARGEST: u64 = 8 << 30;

/// Where the states of a run leave their checkpoints.
#[derive(Debug, Clone)]
pub struct Checkpoints {
    folder: PathBuf,
    header: JournalHeader,
    /// Whether there may be any: most states end before they leave one.
    any: Arc<AtomicBool>,
}

impl Checkpoints {
    /// In a folder that is there, for the run that a header belongs to.
    #[must_use]
    pub fn new(folder: &Path, header: &JournalHeader) -> Self {
        let checkpoints = Self { folder: folder.to_owned(), header: header.clone(), any: Arc::default() };
        checkpoints.any.store(checkpoints.is_any_there(), Ordering::Relaxed);
        checkpoints
    }

    /// Whether a checkpoint is there, or one that was being written.
    fn is_any_there(&self) -> bool {
        let is_one = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.map_or(true, |entry| entry.file_name().to_str().is_some_and(|name| name.starts_with(BEGINNING)))
        };
        std::fs::read_dir(&self.folder).is_ok_and(|mut entries| entries.any(is_one))
    }

    fn path(&self, state: usize) -> PathBuf {
        self.folder.join(format!("{BEGINNING}{state}.{ENDING}"))
    }

    /// The checkpoint of a state, if a whole one of the same run is there.
    #[must_use]
    pub fn load<T: DeserializeOwned>(&self, state: usize) -> Option<T> {
        let bytes = regular_file::read(&self.path(state), LARGEST).ok()?;
        let (digest, content) = bytes.split_at_checked(DIGEST)?;
        if Sha256::digest(content).as_slice() != digest {
            return None;
        }
        let ((header, of_state), rest) = postcard::take_from_bytes::<(JournalHeader, usize)>(content).ok()?;
        if header != self.header || of_state != state {
            return None;
        }
        postcard::from_bytes(rest).ok()
    }

    /// How many states are under way.
    #[must_use]
    pub fn begun(&self) -> usize {
        let state_of = |name: &str| name.strip_prefix(BEGINNING)?.strip_suffix(ENDING)?.strip_suffix('.')?.parse::<usize>().ok();
        let is_begun = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.is_ok_and(|entry| entry.file_name().to_str().and_then(state_of).is_some_and(|state| state < self.header.states))
        };
        std::fs::read_dir(&self.folder).map_or(0, |entries| entries.map(is_begun).filter(|begun| *begun).count())
    }

    /// Leaves a checkpoint of a state; the new file replaces the old in one rename.
    ///
    /// # Errors
    /// A folder that cannot be written; the old checkpoint then stays.
    pub fn save(&self, state: usize, checkpoint: &impl Serialize) -> std::io::Result<()> {
        self.any.store(true, Ordering::Relaxed);
        let content = postcard::to_allocvec(&((&self.header, state), checkpoint)).map_err(std::io::Error::other)?;
        let mut bytes = Sha256::digest(&content).to_vec();
        bytes.extend(content);
        let path = self.path(state);
        let fresh = path.with_extension("new");
        std::fs::write(&fresh, bytes).and_then(|()| std::fs::rename(&fresh, &path)).map_err(|error| super::named(&path, error))
    }

    /// Removes the checkpoint of a state that is finished; that there is none is no error.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub fn remove(&self, state: usize) -> std::io::Result<()> {
        if !self.any.load(Ordering::Relaxed) {
            return Ok(());
        }
        for path in [self.path(state), self.path(state).with_extension("new")] {
            match std::fs::remove_file(path) {
                Err(error) if error.kind() != std::io::ErrorKind::NotFound => return Err(super::named(&self.path(state), error)),
                _ => {}
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn header(scene: &str) -> JournalHeader {
        JournalHeader { program: "viscotack 0".into(), scene: scene.into(), states: 3, shard: super::super::shard::Shard::WHOLE }
    }

    #[test]
    fn every_double_comes_back_and_nothing_else_does() {
        let folder = tempfile::tempdir().unwrap();
        let checkpoints = Checkpoints::new(folder.path(), &header("a"));
        assert_eq!(checkpoints.load::<Vec<f64>>(1), None);
        let values = vec![0.1, f64::INFINITY, -0.0, f64::MIN_POSITIVE / 3.0, 1e308];
        checkpoints.save(1, &values).unwrap();
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&checkpoints.load::<Vec<f64>>(1).unwrap()), bits(&values));
        // Another state, another scene.
        assert_eq!(checkpoints.load::<Vec<f64>>(0), None);
        assert_eq!(Checkpoints::new(folder.path(), &header("b")).load::<Vec<f64>>(1), None);
        std::fs::copy(folder.path().join("state-1.checkpoint"), folder.path().join("state-2.checkpoint")).unwrap();
        assert_eq!(checkpoints.load::<Vec<f64>>(2), None);
        checkpoints.remove(2).unwrap();
        // Cut anywhere, or altered anywhere.
        let path = folder.path().join("state-1.checkpoint");
        let bytes = std::fs::read(&path).unwrap();
        for place in 0..bytes.len() {
            std::fs::write(&path, bytes.get(..place).unwrap()).unwrap();
            assert_eq!(checkpoints.load::<Vec<f64>>(1), None, "cut at {place}");
            let mut altered = bytes.clone();
            *altered.get_mut(place).unwrap() ^= 1;
            std::fs::write(&path, altered).unwrap();
            assert_eq!(checkpoints.load::<Vec<f64>>(1), None, "altered at {place}");
        }
        checkpoints.remove(1).unwrap();
        checkpoints.remove(1).unwrap();
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
