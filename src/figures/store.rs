//! Tables that are computed once: kept in the folder under the hash of what they depend on.

use super::table::Table;
use std::io;
use std::path::{Path, PathBuf};

/// Where they are kept, below the folder of the figures.
const FOLDER: &str = ".computed";

/// Kept tables.
#[derive(Debug, Clone)]
pub(super) struct Store {
    folder: PathBuf,
}

impl Store {
    /// The store of a folder of figures, made if it is not there. A folder that holds anything else is refused.
    pub(super) fn open(out: &Path) -> io::Result<Self> {
        let folder = out.join(FOLDER);
        if !folder.is_dir() && std::fs::read_dir(out).is_ok_and(|mut entries| entries.next().is_some()) {
            let reason = format!("`{}` exists and is not a folder of figures: name another one", out.display());
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, reason));
        }
        std::fs::create_dir_all(&folder)?;
        Ok(Self { folder })
    }

    fn path(&self, key: &str) -> PathBuf {
        self.folder.join(format!("{key}.json"))
    }

    /// A table that was computed before; one that cannot be read counts as none.
    pub(super) fn load(&self, key: &str) -> Option<Table> {
        serde_json::from_slice(&std::fs::read(self.path(key)).ok()?).ok()
    }

    /// Keeps a table: whole or not at all.
    pub(super) fn keep(&self, key: &str, table: &Table) -> io::Result<()> {
        write_whole(&self.path(key), &serde_json::to_vec(table)?)
    }
}

/// Writes beside the file, then renames: a kill leaves nothing half-written under its name.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let beside = path.with_extension("partial");
    std::fs::write(&beside, bytes)?;
    std::fs::rename(&beside, path)
}
