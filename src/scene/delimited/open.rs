//! The file of a table, opened with care and decoded.

use super::decode::decode;
use crate::scene::diagnostic::SourceText;
use std::fs::{File, metadata};
use std::io::Read;
use std::path::Path;

/// The largest table (bytes): it is held in memory as a whole, beside a few words for each cell.
const LARGEST_TABLE: u64 = 64 * 1024 * 1024;

/// Reads a file that a scene names as a table; `name` is what the scene calls it.
///
/// # Errors
/// A sentence that says why it cannot be read: no regular file, too large, no text.
pub fn open(path: &Path, name: &str) -> Result<SourceText, String> {
    let about = metadata(path).map_err(|error| error.to_string())?;
    if !about.is_file() {
        return Err("it is no regular file".to_owned());
    }
    let mut bytes = Vec::new();
    if about.len() <= LARGEST_TABLE {
        // It may grow while it is read.
        File::open(path).and_then(|file| file.take(LARGEST_TABLE + 1).read_to_end(&mut bytes)).map_err(|error| error.to_string())?;
    }
    if about.len().max(bytes.len() as u64) > LARGEST_TABLE {
        return Err(format!("it has more than {} MiB", LARGEST_TABLE / (1024 * 1024)));
    }
    let (text, encoding) = decode(bytes)?;
    Ok(SourceText::decoded(name, text, encoding))
}
