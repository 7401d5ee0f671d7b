//! The folder of the figures: what it shows, and tables that are computed once, kept under the hash of what they depend on.

use super::table::Table;
use std::path::{Path, PathBuf};
use viscotack_program::outcome::folder::FolderError;
use viscotack_program::outcome::owned::{OwnedFolder, digest};
use viscotack_program::regular_file;

/// Where tables are kept, below the folder of the figures.
const FOLDER: &str = ".computed";
/// What the marks of both folders say.
const FIGURES: &str = "figures";
const COMPUTED: &str = "computed tables";
/// No kept table is larger (bytes).
const LARGEST: u64 = 1 << 30;

/// Kept tables.
#[derive(Debug)]
pub(super) struct Store {
    figures: OwnedFolder,
    tables: PathBuf,
}

impl Store {
    /// The store of a folder of figures, made if it is not there. A folder that holds anything else is refused.
    pub(super) fn open(out: &Path) -> Result<Self, FolderError> {
        let tables = out.join(FOLDER);
        let figures = OwnedFolder::open_or_make(out, FIGURES, &[])?;
        Ok(Self { figures, tables: OwnedFolder::open_or_make(&tables, COMPUTED, &["*.json", "*.partial"])?.path().to_owned() })
    }

    /// Where the figures go.
    pub(super) fn into_folder(self) -> OwnedFolder {
        self.figures
    }

    fn path(&self, key: &str) -> PathBuf {
        self.tables.join(format!("{key}.json"))
    }

    /// A table that was computed before; one that was altered, or is another's, counts as none.
    pub(super) fn load(&self, key: &str) -> Option<Table> {
        let bytes = regular_file::read(&self.path(key), LARGEST).ok()?;
        let (found, table) = bytes.split_at_checked(64)?;
        (found == sealed(key, table).as_bytes()).then(|| serde_json::from_slice(table).ok())?
    }

    /// Keeps a table behind its digest: whole or not at all.
    pub(super) fn keep(&self, key: &str, table: &Table) -> Result<(), FolderError> {
        let path = self.path(key);
        let beside = path.with_extension("partial");
        let written = serde_json::to_vec(table).map_err(std::io::Error::from).and_then(|table| {
            std::fs::write(&beside, [sealed(key, &table).as_bytes(), &table].concat())?;
            std::fs::rename(&beside, &path)
        });
        written.map_err(FolderError::io(&path))
    }
}

/// Digest of a table and of what it is the table of.
fn sealed(key: &str, table: &[u8]) -> String {
    digest(&[key.as_bytes(), table].concat())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Every bit flipped, every length, and the file of another table.
    #[test]
    fn an_altered_table_counts_as_none() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::open(&folder.path().join("figures")).unwrap();
        let table = Table::exact(&[("x", vec![0.1, 2.0]), ("y", vec![1e300, -0.25])]);
        let (key, other) = ("ab".repeat(32), "cd".repeat(32));
        store.keep(&key, &table).unwrap();
        assert_eq!(store.load(&key).unwrap(), table);
        let bytes = std::fs::read(store.path(&key)).unwrap();
        std::fs::write(store.path(&other), &bytes).unwrap();
        assert!(store.load(&other).is_none());
        for place in 0..8 * bytes.len() {
            let mut altered = bytes.clone();
            *altered.get_mut(place / 8).unwrap() ^= 1 << (place % 8);
            std::fs::write(store.path(&key), altered).unwrap();
            assert!(store.load(&key).is_none(), "bit {place}");
        }
        for length in 0..bytes.len() {
            std::fs::write(store.path(&key), bytes.get(..length).unwrap()).unwrap();
            assert!(store.load(&key).is_none(), "cut at {length}");
        }
    }
}
