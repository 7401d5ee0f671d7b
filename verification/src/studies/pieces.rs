//! Finished pieces of long studies: they survive a run that is killed, and the same build goes on behind them.
//!
//! A text of lines `DIGEST ["STUDY",PIECE,VALUE]` in the order in which the pieces were finished, after a first line that names the build.
//! A line that was cut short or altered is not read, and its piece is computed again.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use viscotack_program::outcome::build::identity;
use viscotack_program::outcome::owned::digest;
use viscotack_program::regular_file;

/// No file of pieces is larger (bytes).
const LARGEST: u64 = 1 << 30;

/// The pieces that are known, and the file to which others are added.
pub struct Pieces {
    known: HashMap<(String, u64), Value>,
    added: Mutex<Added>,
}

struct Added {
    file: File,
    failed: Option<std::io::Error>,
}

impl Pieces {
    /// Opens a file; pieces of another build in it are forgotten.
    ///
    /// # Errors
    /// A file that cannot be read or written.
    pub fn open(path: &Path) -> std::io::Result<Self> {
        let text = if path.exists() { regular_file::read(path, LARGEST)? } else { Vec::new() };
        // What a kill cut short may end in half a letter.
        let text = String::from_utf8_lossy(&text);
        let mut lines = text.lines();
        let known = if lines.next() == Some(identity()) { lines.filter_map(piece).collect() } else { HashMap::new() };
        let mut file = if known.is_empty() { File::create(path)? } else { OpenOptions::new().append(true).open(path)? };
        // A last line that was cut short has no end.
        file.write_all(if known.is_empty() { format!("{}\n", identity()) } else { "\n".to_owned() }.as_bytes())?;
        Ok(Self { known, added: Mutex::new(Added { file, failed: None }) })
    }

    /// How many are known.
    #[must_use]
    pub fn count(&self) -> usize {
        self.known.len()
    }

    /// Why pieces could not be kept, if some could not.
    #[must_use]
    pub fn failed(&self) -> Option<String> {
        self.added.lock().unwrap_or_else(PoisonError::into_inner).failed.as_ref().map(ToString::to_string)
    }

    /// A piece that is known.
    pub(super) fn get<T: DeserializeOwned>(&self, study: &str, piece: u64) -> Option<T> {
        self.known.get(&(study.to_owned(), piece)).and_then(|value| T::deserialize(value).ok())
    }

    /// Keeps a piece.
    pub(super) fn put<T: Serialize>(&self, study: &str, piece: u64, value: &T) {
        let mut added = self.added.lock().unwrap_or_else(PoisonError::into_inner);
        let content = serde_json::to_string(&(study, piece, value)).map_err(std::io::Error::other);
        let written = content.and_then(|content| added.file.write_all(format!("{} {content}\n", digest(content.as_bytes())).as_bytes()));
        if let Err(error) = written {
            added.failed.get_or_insert(error);
        }
    }
}

fn piece(line: &str) -> Option<((String, u64), Value)> {
    let (found, content) = line.split_once(' ')?;
    let (study, piece, value) = serde_json::from_str::<(String, u64, Value)>(content).ok()?;
    (found == digest(content.as_bytes())).then_some(((study, piece), value))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn what_was_kept_is_read_back_unless_it_was_altered() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("pieces.txt");
        let first = Pieces::open(&path).unwrap();
        let values = [0.1, -1.0 / 3.0, 1e-300];
        values.iter().zip(0..).for_each(|(value, piece)| first.put("study", piece, value));
        // A last line that a kill has cut short.
        let text = std::fs::read_to_string(&path).unwrap().replace("1e-300]", "2e-300]");
        std::fs::write(&path, format!("{text}0123 [\"study\",7,")).unwrap();
        let second = Pieces::open(&path).unwrap();
        assert_eq!(second.count(), 2);
        assert_eq!([0, 1, 2, 7].map(|piece| second.get::<f64>("study", piece)), [Some(values[0]), Some(values[1]), None, None]);
        second.put("study", 7, &7.0);
        assert_eq!(Pieces::open(&path).unwrap().get::<f64>("study", 7), Some(7.0));
        std::fs::write(&path, text.replacen("viscotack", "another", 1)).unwrap();
        assert_eq!(Pieces::open(&path).unwrap().count(), 0);
    }
}
